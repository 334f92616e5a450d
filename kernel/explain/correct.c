/* The correction of jobs that a fit asks for. */
#include "explain/correct.h"

#include <math.h>

static bool is_kerf(const wcut_effect *e) {
    return e->kind == WCUT_EFFECT_KERF_GROWTH && e->choice == 0 && e->value[WCUT_KERF_GROWTH_PER_Q] >= 0;
}

wcut_correction wcut_fitted_correction(const wcut_fitted *f) {
    wcut_correction c = {.a = f->model.a,
                         .b = f->model.b,
                         .length_change = f->model.length_change,
                         .kerf = isfinite(f->kerf) ? fmax(f->kerf, 0) : (double)NAN};
    for (int e = 0; e < f->model.effects; e++) {
        const wcut_effect *effect = &f->model.effect[e];
        if (is_kerf(effect) && isfinite(c.kerf))
            c.kerf_per_q = effect->value[WCUT_KERF_GROWTH_PER_Q];
        else if (c.effects < WCUT_CORRECTION_EFFECTS)
            c.effect[c.effects++] = *effect;
    }
    return c;
}
