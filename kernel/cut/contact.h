/* The wire that the foam does not load, and how it comes to be loaded: hanging, leaning on a face, taut. */
#ifndef WCUT_CUT_CONTACT_H
#define WCUT_CUT_CONTACT_H

#include "cut/run.h"

typedef enum wcut_carriage {
    WCUT_NO_SHAPE, /* no equilibrium of the wire was found */
    WCUT_FREE,     /* nothing loads it; cut->hung is its shape */
    WCUT_SLACK,    /* it hung loose so far but is taut on its contact now; cut->hung and the pattern are a guess */
    WCUT_LOADED    /* the foam loads it as before; cut->hung and the pattern are a guess */
} wcut_carriage;

/* Hang the wire between the target's ends under `load` into cut->hung and cut->hung_s. A wire no longer than its chord
   is straight, without tension. False where there is no such shape. */
bool wcut_cut_hang(wcut_cut *cut, const wcut_target *target, const wcut_vec3 *load);

/* sum of the loads' sizes over the free nodes [N] */
double wcut_load_sum(int n, const wcut_vec3 *load);

/* whether any part of a wire is in the block; in design mode all of it is */
bool wcut_cut_touches(const wcut_cut *cut, const wcut_vec3 *x);

/* Whether the foam loads the wire at the target, coming from cut->was. The pattern from before is left in cut->kept. */
wcut_carriage wcut_contact_find(wcut_cut *cut, const wcut_target *target);

/* the hung wire becomes the wire, without load: fed at v_max or in the given time; reach: way of the faster end [mm] */
void wcut_cut_feed_free(wcut_cut *cut, const wcut_target *target, double reach, double *elapsed);

#endif
