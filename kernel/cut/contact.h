/* The wire that the foam does not load, and the transition to the wire that it loads.

   State of a run = contact x weighted x condition.

   Contact, found anew for every sub-step by wcut_contact_find from the wire before it:

        +---------+   touches, but not on its contact alone: leans    +---------+
        |  FREE   |<---------------------------------------------+    | NO_SHAPE|  the sub-step is halved
        +---------+                                              |    +---------+  (wcut_implicit_advance)
          |     ^                                                |         ^
          |     | nothing touches, or no tension: feed_free      |         | hang_slack fails
          |     |                                                |         |
          |     +------------------------------------+           |         |
          | touches: lean                            |           |   from any state
          v                                          |           |
        +---------+   Newton converges with      +---------+     |
        |  SLACK  |----- tension: accept ------->| LOADED  |     |
        +---------+                              +---------+     |
          |                                          |   ^       |
          |  no solution, and hangs_loose            |   |       |
          +------------------------------------------+---|-------+
                                                     +---+  it still touches: accept

        transition             function                 what it leaves in cut->next
        FREE   -> FREE         wcut_cut_feed_free       the hanging shape, no force, loaded = false
        FREE   -> SLACK        lean                     nothing yet: the step decides
        SLACK  -> LOADED       accept                   shape, tensions and forces of Newton, loaded = true
        SLACK  -> FREE         feed_free                the pattern from before the foam was tried (cut->kept)
        LOADED -> LOADED       accept
        LOADED -> FREE         feed_free

   Weighted (cut->weighted): the loose wire has a weight and a drag (implicit.c). Then lean is never used, every
   touching wire is LOADED, and a solution without tension is accepted too. Which run gets there, and when, is its rule:

        contact_rule     at station 0   what a wire does that touches without tension         used by
        BY_WEIGHT        not weighted   weighted from then on (accept), the sub-step again    the first run
        HEAVY            weighted       LOADED from the first touch on                        the run after that,
                                                                                              where it ended early

   A run keeps its rule (wcut_contact_rule_set before its first step); wcut_setup_run keeps the run that came furthest.

   Condition (cut->next.condition), set by solve_complementary: SPEED_MAX while FREE; when LOADED one of SPEED_MAX,
   TENSION, SPEED_MIN, the one that held last tried first. Time-driven steps have TIME throughout.

   Scratch arrays of wcut_cut, and when each is valid:

        was                    from the start of try_substep to its end: nodes before the sub-step
        edge, rest             after wcut_cut_fit (called by wcut_cut_hang): lengths for the target of this sub-step
        hanging_shape,         after wcut_cut_hang: shape under the last load; while Newton runs: its iterate;
        hanging_tension          after it: the solution that accept copies
        kept                   after wcut_contact_find: the pattern before the foam was tried on it
        contact                inside lean: load of the foam on what touches
        dead_load              after find_dead_load, in a weighted run, while the wire is loose
        softer, softer_tension inside harden: the last solution, at a softer face; heun: its accumulated force
*/
#ifndef WCUT_CUT_CONTACT_H
#define WCUT_CUT_CONTACT_H

#include "cut/run.h"

typedef enum wcut_contact_state {
    WCUT_CONTACT_NO_SHAPE, /* no equilibrium of the wire was found */
    WCUT_CONTACT_FREE,     /* nothing loads it; cut->hanging_shape is its shape */
    WCUT_CONTACT_SLACK,    /* loose before, taut on its contact now; hanging_shape and the pattern are a guess */
    WCUT_CONTACT_LOADED    /* the foam loads it as before; hanging_shape and the pattern are a guess */
} wcut_contact_state;

/* the weight of each node, that of the half edges beside it: n [N]; zeros where the job gives none */
void wcut_cut_weigh(const wcut_cut *cut, wcut_vec3 *load);

/* Hang the wire between the target's ends under `load` into cut->hanging_shape and cut->hanging_tension. A wire no
   longer than its chord is straight, without tension; a bow's taut one with its own (cut->taut). False where there is no
   such shape. */
bool wcut_cut_hang(wcut_cut *cut, const wcut_target *target, const wcut_vec3 *load);

/* sum of the loads' sizes over the free nodes [N] */
double wcut_load_sum(int n, const wcut_vec3 *load);

/* whether any part of a wire is in the block; in design mode all of it is */
bool wcut_cut_touches(const wcut_cut *cut, const wcut_vec3 *x);

/* Whether the foam loads the wire at the target, coming from cut->was. The pattern from before is left in cut->kept. */
wcut_contact_state wcut_contact_find(wcut_cut *cut, const wcut_target *target);

/* the hanging shape becomes the wire, without load: fed at v_max or in the given time; reach: way of the faster end
   [mm] */
void wcut_cut_feed_free(wcut_cut *cut, const wcut_target *target, double reach, double *elapsed);

#endif
