/* Deviations from the part of a surface that its loops bound. */
#include <math.h>
#include <wirecut/deviation.h>

#include <math.h>

#include "base/alloc.h"
#include "surface/trimmed.h"

/* a foot on a polygon's side may lie outside by the chord's error */
static const double BORDER_MIN = 0.01; /* [mm] */

/* Where a foot is relative to the loops. The place by the surface's own border stays where it is beyond or ambiguous. */
static void judge_place(const wcut_trimmed *t, double border, wcut_deviation *d) {
    if (t->loops == 0 || d->place == WCUT_PLACE_AMBIGUOUS) return;
    const double away = wcut_trimmed_border_within(t, d->foot, 1 + fmax(border, BORDER_MIN));
    const int inside = wcut_trimmed_inside(t, d->u, d->v);
    if (!inside && away > BORDER_MIN)
        d->place = WCUT_PLACE_BEYOND;
    else if (d->place == WCUT_PLACE_INSIDE && away <= border)
        d->place = WCUT_PLACE_BORDER;
}

wcut_status wcut_deviation_from_trimmed(const wcut_trimmed *t, const wcut_projection *projection, int count,
                                        const wcut_vec3 *point, const wcut_deviation_options *options, int threads,
                                        wcut_deviation *deviation, wcut_foot *foot) {
    const wcut_deviation_options o = options ? *options : wcut_deviation_options_default();
    if (!t) return WCUT_BAD_ARGUMENT;
    const wcut_status status = wcut_deviation_from_surface(projection, count, point, &o, threads, deviation, foot);
    for (int k = 0; k < count && status == WCUT_OK; k++) judge_place(t, o.border, &deviation[k]);
    return status;
}
