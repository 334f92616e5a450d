/* The force on a blade (Atkins, Xu, Jeronimidis 2004, for sliding): F = a e L, and how it builds up, dF/ds = (a e L - F) / lambda. */
#include "explain/blade_model.h"

#include <math.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "explain/library.h"
#include "foam/force_law.h"

#define BUILD_UP 20.0   /* [mm] where a fit begins */
#define SPEED_MIN 0.05  /* [mm/s] across the edge: below, ratios and rates have no meaning */
#define FACTOR_MIN 0.02 /* [1] of a force that an effect changes */
#define RATIO_MAX 20.0  /* [1] of sliding over advance */

int wcut_blade_unknowns(const wcut_blade_model *m) { return m->named ? WCUT_BLADE_UNKNOWNS : WCUT_BLADE_BASE; }

wcut_blade_model wcut_blade_model_begin(double a) {
    wcut_blade_model m = {.named = false};
    m.x[WCUT_BLADE_LAW] = log(a);
    m.x[WCUT_BLADE_BUILD_UP] = log(BUILD_UP);
    return m;
}

/* ---- the effect at a bin, as a factor of the force ---- */

static double gradient(const wcut_blade_cut *c, int choice, double change, wcut_vec3 at) {
    const wcut_vec3 size = c->job->block_size;
    const double u = choice == 0 ? at.x / size.x : choice == 1 ? at.y / size.y : at.z / size.z;
    return fmax(1 + change * (u - 0.5), FACTOR_MIN);
}

static double effect_factor(const wcut_blade_cut *c, const wcut_blade_model *m, int b, double cut_way) {
    if (!m->named) return 1;
    const double value = wcut_scale_out(m->coordinate.scale, m->x[WCUT_BLADE_BASE]);
    const double advance = fmax(c->advance[b], SPEED_MIN), xi = fmin(c->slide[b] / advance, RATIO_MAX);
    switch (m->effect.kind) {
        case WCUT_EFFECT_SLICE_SOFTENING: {
            const double exponent = m->effect.value[WCUT_SLICE_SOFTENING_EXPONENT], r = xi * m->x[WCUT_BLADE_BASE];
            return pow(1 + r * r, -exponent);
        }
        case WCUT_EFFECT_RATE_DEPENDENCE:
            return pow(advance / m->effect.value[WCUT_RATE_DEPENDENCE_SPEED_REF], value);
        case WCUT_EFFECT_FOAM_DENSITY_GRADIENT:
            return gradient(c, m->effect.choice, value, c->place[b]);
        case WCUT_EFFECT_WIRE_FOULING:
            return fmax(1 + value * (1 - exp(-cut_way / m->effect.value[WCUT_WIRE_FOULING_LENGTH])), FACTOR_MIN);
        default:
            return 1; /* no other kind is put into a model */
    }
}

/* ---- the force ---- */

static double law_of(const wcut_blade_cut *c, double a, int b) {
    const double q = c->job->heat > 0 ? c->job->heat * 1000 / fmax(c->advance[b], SPEED_MIN) : 0;
    return a * exp(-c->job->force_law.b * q);
}

static wcut_status predict_force(const wcut_blade_cut *c, const wcut_blade_model *m, double build_up, double *force) {
    const wcut_vec3 place = vec3(0, m->x[WCUT_BLADE_FEED], m->x[WCUT_BLADE_UP]);
    double *engaged = wcut_alloc((size_t)c->bins, sizeof *engaged);
    if (!engaged) return WCUT_NO_MEMORY;
    const wcut_status status = wcut_blade_engaged(&c->line, place, vec3_add(place, c->job->block_size), engaged);

    /* the force follows law times length over a way; every pass begins without one */
    double before = 0, cut_way = 0;
    for (int b = 0; status == WCUT_OK && b < c->bins; b++) {
        if (b > 0 && c->pass[b] != c->pass[b - 1]) before = 0;
        const double full = law_of(c, exp(m->x[WCUT_BLADE_LAW]), b) * engaged[b] * effect_factor(c, m, b, cut_way);
        const double kept = build_up > 0 ? exp(-c->way[b] / build_up) : 0;
        before = force[b] = full + (before - full) * kept;
        if (engaged[b] > 0) cut_way += c->way[b];
    }

    wcut_free(engaged);
    return status;
}

wcut_status wcut_blade_predict(const wcut_blade_cut *cut, const wcut_blade_model *model, double *force) {
    return predict_force(cut, model, exp(model->x[WCUT_BLADE_BUILD_UP]), force);
}

wcut_status wcut_blade_predict_job(const wcut_blade_cut *cut, double *force) {
    const wcut_blade_model m = wcut_blade_model_begin(cut->job->force_law.a);
    return predict_force(cut, &m, 0, force);
}
