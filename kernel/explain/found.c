/* What a fit says of an effect: values with intervals, and what it moves. */
#include "explain/found.h"

#include "base/numbers.h"

double wcut_found_widen(double error, double value, double slow) {
    return hypot(1.2 * error * sqrt(fmax(slow, 1)), 0.04 * value);
}

/* a profile's half width, widened alike */
static double widened_95(double half, double value, double slow) {
    return 1.96 * wcut_found_widen(half / 1.96, value, slow);
}

static void estimate(const wcut_fitted *f, int k, double slow, wcut_estimate *out) {
    const wcut_coordinate *c = &f->coordinate[k];
    const double x = f->x[WCUT_BASE + k], own = c->scale == WCUT_COORDINATE_SCALE_LOG ? 1 : x;
    const double below = widened_95(f->below[WCUT_BASE + k], own, slow);
    const double above = widened_95(f->above[WCUT_BASE + k], own, slow);
    const double ends[2] = {fmax(x - below, c->low), fmin(x + above, c->high)};
    out->value = wcut_scale_out(c->scale, x);
    out->low = wcut_scale_out(c->scale, ends[0]), out->high = wcut_scale_out(c->scale, ends[1]);
    if (c->scale == WCUT_COORDINATE_SCALE_RECIPROCAL) {
        const double swap = out->low;
        out->low = out->high, out->high = swap;
    }
}

void wcut_found_effect_fill(const wcut_fitted *fit, int e, double slow, wcut_found_effect *f) {
    *f = (wcut_found_effect){.effect = fit->model.effect[e]};
    for (int k = 0; k < WCUT_EFFECT_VALUES; k++)
        f->parameter[k] = (wcut_estimate){f->effect.value[k], f->effect.value[k], f->effect.value[k]};
    for (int k = 0; k < fit->count; k++) {
        if (fit->effect_of[k] != e) continue;
        const int at = fit->coordinate[k].at;
        estimate(fit, k, slow, &f->parameter[at]);
        f->effect.value[at] = f->parameter[at].value;
        f->estimated[at] = true;
    }
}

void wcut_small_effect_measure(const wcut_evidence *e, const wcut_fitted *f, wcut_small_effect *out) {
    const int last = f->model.effects - 1;
    const double neutral = wcut_explanation_neutral(f->model.effect[last].kind);
    out->tension = 0, out->face = (double)NAN;
    for (int cut = 0; cut < e->cuts; cut++) {
        const wcut_evidence_cut *c = &e->cut[cut];
        for (int i = 0; i < WCUT_SIGNALS * c->bins + c->patch.count; i++) {
            const bool face = i >= WCUT_SIGNALS * c->bins;
            if (!face && i >= 2 * c->bins) continue; /* angles */

            /* strengths alone: without them a shape moves nothing */
            double moved = 0;
            for (int k = 0, nth = 0; k < f->count; k++) {
                if (f->effect_of[k] != last || nth++ >= wcut_effect_view(f->model.effect[last].kind)->strengths)
                    continue;
                const double off = f->x[WCUT_BASE + k] - (f->coordinate[k].at == 0 ? neutral : 0);
                moved += off * f->column[(size_t)k * (size_t)e->rows + (size_t)(c->row + i)];
            }
            if (!isfinite(moved)) continue;
            if (face)
                out->face = fmax(isnan(out->face) ? 0 : out->face, fabs(moved));
            else
                out->tension = fmax(out->tension, fabs(moved));
        }
    }
}
