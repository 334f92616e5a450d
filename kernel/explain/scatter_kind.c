/* Kinds of scatter: how wide each usually is, and how wide it may be. */
#include "explain/scatter_kind.h"

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"

/* Widths: ordinary EPS varies by 5 % in density from block to block; a wire is cut by hand to 1 or 2 mm; load cells return
   to zero within 0.02 N, encoders within 0.05 deg; joints hold back by some tenths of a degree. */
static const wcut_scatter_info table[WCUT_SCATTER_COUNT] = {
    [WCUT_SCATTER_LEVEL] = {0.05, 0.15},        [WCUT_SCATTER_LEVEL_B] = {0.005, 0.015},
    [WCUT_SCATTER_LENGTH] = {1.0, 3.0},         [WCUT_SCATTER_TENSION_ZERO] = {0.015, 0.045},
    [WCUT_SCATTER_ENCODER_ZERO] = {0.05, 0.15}, [WCUT_SCATTER_FRICTION] = {0.25, 0.75},
    [WCUT_SCATTER_FACE] = {0.2, 0.6},           [WCUT_SCATTER_SCAN_SHIFT] = {0.3, 2.5},
    [WCUT_SCATTER_SCAN_TURN] = {0.015, 0.1},
};

const wcut_scatter_info *wcut_scatter_view(const wcut_variances *v, wcut_scatter_kind kind) {
    return v->known ? &v->known[kind] : &table[kind];
}

wcut_status wcut_scatter_check(const wcut_rig_prior *prior, wcut_error *error) {
    if (!prior) return WCUT_OK;
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++)
        if (!is_positive(prior->scatter[k]))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig: %s: found %g, expected more than 0",
                             wcut_scatter_name((wcut_scatter_kind)k), prior->scatter[k]);
    if (!is_positive(prior->tension_delay) || !is_positive(prior->angle_delay))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rig: found delays of %g and %g s, expected more than 0",
                         prior->tension_delay, prior->angle_delay);
    return WCUT_OK;
}

void wcut_scatter_know(const wcut_rig_prior *prior, wcut_scatter_info known[WCUT_SCATTER_COUNT]) {
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++) {
        known[k].width = prior->scatter[k];
        known[k].max = table[k].max * prior->scatter[k] / table[k].width;
    }
}

wcut_rig_prior wcut_rig_prior_default(void) {
    wcut_rig_prior prior = {.tension_delay = WCUT_DELAY_SPREAD, .angle_delay = WCUT_DELAY_SPREAD};
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++) prior.scatter[k] = table[k].width;
    return prior;
}

int wcut_noise_group(int signal) { return signal < 2 ? 0 : signal % 2 ? 2 : 1; }

void wcut_scatter_destroy(wcut_scatter *s) {
    wcut_free(s->column);
    wcut_free(s->white);
    *s = (wcut_scatter){0};
}
