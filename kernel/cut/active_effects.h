/* The effects of a run: made ready for a sub-step, remembered after it. A run without them passes all of it by. */
#ifndef WCUT_CUT_ACTIVE_EFFECTS_H
#define WCUT_CUT_ACTIVE_EFFECTS_H

#include "cut/run.h"

typedef struct wcut_extension { /* what foam and step refer to while a sub-step is being solved */
    wcut_locality local;
    wcut_compliance compliance;
} wcut_extension;

/* Lengths of the edges at the target: cut->rest without tension, warm where the wire gets longer by heat, by the
   engagement it comes with (its temperature follows the foam, it does not jump at a face), and cut->edge stretched by
   the tension it comes with. Where its ends are with their mounts as they were. The sum of cut->edge [mm]. */
double wcut_cut_fit(wcut_cut *cut, const wcut_target *target, wcut_vec3 *end_a, wcut_vec3 *end_b);

/* let foam and step know the run's effects; they refer to `out` from now on */
void wcut_extension_apply(wcut_cut *cut, const wcut_target *target, wcut_extension *out, wcut_foam *foam,
                          wcut_step *step);

/* the time [s] that effects of time take the run to be at, before its first step: that of a recording, which does not
   begin at 0 */
void wcut_cut_set_clock(wcut_cut *cut, double time);

/* cut->next has become the wire at the target, 1/rate after cut->was: keep what effects must remember of that */
void wcut_cut_remember(wcut_cut *cut, const wcut_target *target, double rate);

#endif
