/* The library of explanations: what of each effect is fitted, on which scale, and which variants are tried first. */
#include "explain/library.h"

#include "base/numbers.h"
#include "explain/dictionary.h"

#define LN(x) x /* marks a logarithm of what the comment says */

/* Gates: a change that a caliper, a datasheet or the next cut would show; below them it is in nobody's interest, and
   within what the discretisation of recording and simulation is good for (a lag of a sample, 0.05 s). */
static const wcut_explanation table[WCUT_EFFECT_COUNT] = {
    [WCUT_EFFECT_WIRE_THERMAL_LAG] =
        {WCUT_EFFECT_WIRE_THERMAL_LAG, false, 0.12, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 2, 0.05, 0, 20}}},
    [WCUT_EFFECT_AIR_OVERHEATING] = {WCUT_EFFECT_AIR_OVERHEATING,
                                     false,
                                     0.1,
                                     2,
                                     {{0, WCUT_FIT_SCALE_LINEAR, 1, 1.5, 0.05, 1, 6},
                                      {1, WCUT_FIT_SCALE_LOG, LN(0.3) /* 1.35 s */, 0.8, 0.1, -2.3, 3}}},
    [WCUT_EFFECT_END_COOLING] = {WCUT_EFFECT_END_COOLING,
                                 false,
                                 0.03,
                                 2,
                                 {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.5, 0.03, 0, 0.47},
                                  {1, WCUT_FIT_SCALE_LOG, LN(4.5) /* 90 mm */, 0.7, 0.08, 2.3, 6.2}}},
    [WCUT_EFFECT_FOAM_DENSITY_GRADIENT] =
        {WCUT_EFFECT_FOAM_DENSITY_GRADIENT, false, 0.04, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.8, 0.05, -1.8, 1.8}}},
    [WCUT_EFFECT_FOAM_INCLUSION] = {WCUT_EFFECT_FOAM_INCLUSION,
                                    false,
                                    0.06,
                                    5,
                                    {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.8, 0.05, -0.95, 5},
                                     {1, WCUT_FIT_SCALE_LOG, LN(3.9) /* 50 mm */, 0.6, 0.06, 2.3, 5.3},
                                     {2, WCUT_FIT_SCALE_LINEAR, 0, 1e4, 5, -100, 2000},
                                     {3, WCUT_FIT_SCALE_LINEAR, 0, 1e4, 5, -100, 5000},
                                     {4, WCUT_FIT_SCALE_LINEAR, 150, 40, 5, -500, 2000}}},
    [WCUT_EFFECT_TANGENTIAL_DRAG] =
        {WCUT_EFFECT_TANGENTIAL_DRAG, false, 0.02, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 1, 0.03, 0, 3}}},
    [WCUT_EFFECT_WIRE_ELONGATION] =
        {WCUT_EFFECT_WIRE_ELONGATION, false, 4e-4, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.006, 3e-4, 0, 0.04}}},
    [WCUT_EFFECT_MOUNT_COMPLIANCE] =
        {WCUT_EFFECT_MOUNT_COMPLIANCE, false, 0.025, 1, {{0, WCUT_FIT_SCALE_RECIPROCAL, 0, 1.5, 0.02, 0, 5}}},
    [WCUT_EFFECT_RATE_DEPENDENCE] =
        {WCUT_EFFECT_RATE_DEPENDENCE, false, 0.05, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.6, 0.03, -2, 2}}},
    [WCUT_EFFECT_WIRE_FOULING] = {WCUT_EFFECT_WIRE_FOULING,
                                  false,
                                  0.03,
                                  2,
                                  {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.5, 0.03, -0.8, 3},
                                   {1, WCUT_FIT_SCALE_LOG, LN(6.8) /* 900 mm */, 0.9, 0.1, 3.5, 9.5}}},
    [WCUT_EFFECT_KERF_GROWTH] =
        {WCUT_EFFECT_KERF_GROWTH, false, 5e-5, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 4e-4, 2e-5, -2e-3, 2e-3}}},
    [WCUT_EFFECT_BLOCK_SPRINGBACK] =
        {WCUT_EFFECT_BLOCK_SPRINGBACK, false, 0.4, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 6, 0.1, -50, 50}}},
    [WCUT_EFFECT_ANGLE_OFFSET] =
        {WCUT_EFFECT_ANGLE_OFFSET, true, 0.1, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 5, 0.1, -60, 60}}},
    [WCUT_EFFECT_TENSION_GAIN] =
        {WCUT_EFFECT_TENSION_GAIN, true, 0.01, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.2, 0.02, -0.8, 4}}},
    [WCUT_EFFECT_TENSION_DRIFT] =
        {WCUT_EFFECT_TENSION_DRIFT, true, 0.04, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.6, 0.02, -20, 20}}},
    [WCUT_EFFECT_CLOCK_OFFSET] =
        {WCUT_EFFECT_CLOCK_OFFSET, true, 0.04, 1, {{0, WCUT_FIT_SCALE_LINEAR, 0, 0.4, 0.02, -5, 5}}},
    [WCUT_EFFECT_SCAN_OFFSET] = {WCUT_EFFECT_SCAN_OFFSET,
                                 true,
                                 0.5,
                                 3,
                                 {{0, WCUT_FIT_SCALE_LINEAR, 0, 4, 0.1, -100, 100},
                                  {1, WCUT_FIT_SCALE_LINEAR, 0, 4, 0.1, -100, 100},
                                  {2, WCUT_FIT_SCALE_LINEAR, 0, 4, 0.1, -100, 100}}},
    [WCUT_EFFECT_SCAN_SCALE] =
        {WCUT_EFFECT_SCAN_SCALE, true, 6e-4, 1, {{0, WCUT_FIT_SCALE_LINEAR, 1, 0.02, 1e-3, 0.8, 1.2}}},
};

const wcut_explanation *wcut_explanation_view(wcut_effect_kind kind) { return &table[kind]; }

int wcut_effect_coordinates(const wcut_effect *effect) {
    return effect->kind == WCUT_EFFECT_EMPIRICAL_FORCE ? wcut_term_coordinates(effect) : table[effect->kind].count;
}

wcut_coordinate wcut_effect_coordinate(const wcut_effect *effect, int k) {
    if (effect->kind == WCUT_EFFECT_EMPIRICAL_FORCE) return wcut_term_coordinate(effect, k);
    if (effect->kind == WCUT_EFFECT_KERF_GROWTH && effect->choice == 1)
        return (wcut_coordinate){1, WCUT_FIT_SCALE_LINEAR, 0, 1, 0.1, -5, 5};
    return table[effect->kind].coordinate[k];
}

double wcut_scale_in(wcut_fit_scale scale, double value) {
    return scale == WCUT_FIT_SCALE_LOG ? log(value) : scale == WCUT_FIT_SCALE_RECIPROCAL ? 1 / value : value;
}

double wcut_scale_out(wcut_fit_scale scale, double x) {
    return scale == WCUT_FIT_SCALE_LOG ? exp(x) : scale == WCUT_FIT_SCALE_RECIPROCAL ? 1 / x : x;
}

double wcut_explanation_neutral(wcut_effect_kind kind) {
    return wcut_scale_in(table[kind].coordinate[0].scale, wcut_effect_view(kind)->neutral);
}

double wcut_effect_size(const wcut_effect *effect) {
    const wcut_explanation *x = &table[effect->kind];
    const wcut_effect_info *info = wcut_effect_view(effect->kind);
    double square = 0;
    for (int k = 0; k < info->strengths; k++) {
        const double off =
            wcut_scale_in(x->coordinate[0].scale, effect->value[k]) - wcut_explanation_neutral(effect->kind);
        square += off * off;
    }
    if (effect->kind == WCUT_EFFECT_KERF_GROWTH &&
        effect->choice == 1) { /* [mm] per e-fold: a range of heats is about one */
        return fabs(effect->value[1]) / 0.15;
    }
    return sqrt(square) / x->gate;
}

typedef struct list {
    const bool *without;
    wcut_variant *out;
    int count;
} list;

static void add(list *l, wcut_effect_kind kind, int choice, double v0, double v1, bool carried) {
    if (l->without[kind] || l->count == WCUT_VARIANTS) return;
    wcut_variant v = {.effect = wcut_effect_default(kind), .carried = carried};
    v.effect.choice = choice;
    v.effect.value[0] = v0;
    if (table[kind].count == 2) v.effect.value[1] = v1;
    l->out[l->count++] = v;
}

static void add_physics(list *l, bool several) {
    static const double lag[] = {0.3, 0.8, 2}, end[] = {30, 60, 100, 150}, way[] = {300, 1000, 3000};
    for (int k = 0; k < 3; k++) add(l, WCUT_EFFECT_WIRE_THERMAL_LAG, 0, lag[k], 0, false);
    add(l, WCUT_EFFECT_AIR_OVERHEATING, 0, 1.3, 0.7, false);
    add(l, WCUT_EFFECT_AIR_OVERHEATING, 0, 1.3, 2.5, false);
    for (int k = 0; k < 4; k++) add(l, WCUT_EFFECT_END_COOLING, 0, 0.1, end[k], false);
    for (int k = 0; k < 3; k++) add(l, WCUT_EFFECT_FOAM_DENSITY_GRADIENT, k, 0.1, 0, false);
    add(l, WCUT_EFFECT_TANGENTIAL_DRAG, 0, 0.1, 0, false);
    add(l, WCUT_EFFECT_WIRE_ELONGATION, 0, 0.002, 0, false);
    add(l, WCUT_EFFECT_MOUNT_COMPLIANCE, 0, 10, 0, false);
    add(l, WCUT_EFFECT_RATE_DEPENDENCE, 0, 0.1, 0, false);
    for (int on = 0; on < 2; on++) {
        for (int k = 0; k < 3; k++) add(l, WCUT_EFFECT_WIRE_FOULING, on, 0.1, way[k], false);
        if (several) add(l, WCUT_EFFECT_WIRE_FOULING, on, 0.1, 3000, true);
    }
}

int wcut_library_variants(const bool without[WCUT_EFFECT_COUNT], bool several, bool scans, wcut_variant *out) {
    list l = {.without = without, .out = out};
    add_physics(&l, several);
    for (int k = 0; k < 4; k++) add(&l, WCUT_EFFECT_ANGLE_OFFSET, k, 1, 0, false);
    for (int k = 0; k < 2; k++) add(&l, WCUT_EFFECT_TENSION_GAIN, k, 0.05, 0, false);
    for (int k = 0; k < 3; k++) add(&l, WCUT_EFFECT_TENSION_DRIFT, k, 0.1, 0, false);
    add(&l, WCUT_EFFECT_CLOCK_OFFSET, 0, 0.05, 0, false);
    if (!scans) return l.count;
    add(&l, WCUT_EFFECT_KERF_GROWTH, 0, 1e-4, 0, false);
    add(&l, WCUT_EFFECT_KERF_GROWTH, 1, 0, 0, false);
    if (!without[WCUT_EFFECT_KERF_GROWTH]) out[l.count - 1].effect.value[1] = 0.5;
    for (int k = 0; k < 5; k++) add(&l, WCUT_EFFECT_BLOCK_SPRINGBACK, k, 1, 0, false);
    add(&l, WCUT_EFFECT_SCAN_OFFSET, 0, 0, 0, false); /* three strengths: its columns are taken one by one */
    add(&l, WCUT_EFFECT_SCAN_SCALE, 0, 1.002, 0, false);
    return l.count;
}
