/* The library of explanations: what of each effect is fitted, on which scale, and which variants are tried first. */
#include "explain/library.h"

#include "base/numbers.h"
#include "explain/dictionary.h"

/*
 * One row per effect: class, gate, how it is said, coordinates (value, scale, prior centre and width, step, bounds, on the
 * fitted scale) and where the screen begins. A kind without a row does not compile.
 *
 * Gates: a change that a caliper, a datasheet or the next cut would show, within what the discretisation of recording and
 * simulation is good for (a lag of a sample, 0.05 s).
 */
#define PHYSICS false, true, false
#define INSTRUMENT true, true, false
#define DELAY true, false, true
#define UNSEARCHED false, false, false
#define UNSEARCHED_INSTRUMENT true, false, false
#define LINEAR WCUT_COORDINATE_SCALE_LINEAR
#define LOG WCUT_COORDINATE_SCALE_LOG
#define RECIPROCAL WCUT_COORDINATE_SCALE_RECIPROCAL

#define ROW_WIRE_THERMAL_LAG /* one time constant; two of them have a share and a slow one beside it */ \
    PHYSICS, 0.12, "the wire follows heat and speed with a delay", "time constant %.2f s", 1, 1,        \
        {{WCUT_WIRE_THERMAL_LAG_TIME_CONSTANT, LINEAR, 0, 2, 0.05, 0, 20},                              \
         {WCUT_WIRE_THERMAL_LAG_SLOW_SHARE, LINEAR, 0.3, 0.3, 0.02, 0.02, 0.95},                        \
         {WCUT_WIRE_THERMAL_LAG_SLOW_TIME_CONSTANT, LOG, 1.6, 0.8, 0.1, -0.7, 3.9}},                    \
        3, {                                                                                            \
        {.value = {0.3}}, {.value = {0.8}}, {                                                           \
            .value = { 2 }                                                                              \
        }                                                                                               \
    }
#define ROW_AIR_OVERHEATING                                                                                \
    PHYSICS, 0.1, "the wire enters the foam overheated by the air", "%.2f times its power at first", 1, 2, \
        {{WCUT_AIR_OVERHEATING_RATIO, LINEAR, 1, 1.5, 0.05, 1, 6},                                         \
         {WCUT_AIR_OVERHEATING_TIME_CONSTANT, LOG, 0.3, 0.8, 0.1, -2.3, 3}},                               \
        2, {                                                                                               \
        {.value = {1.3, 0.7}}, {                                                                           \
            .value = { 1.3, 2.5 }                                                                          \
        }                                                                                                  \
    }
#define ROW_END_COOLING                                                        \
    PHYSICS, 0.03, "the wire is cooler near its mounts", "by %.0f %%", 100, 2, \
        {{WCUT_END_COOLING_AMPLITUDE, LINEAR, 0, 0.5, 0.03, -0.2, 0.499},      \
         {WCUT_END_COOLING_LENGTH, LOG, 4.5, 0.7, 0.08, 2.3, 6.2}},            \
        4, {                                                                   \
        {.value = {0.1, 30}}, {.value = {0.1, 60}}, {.value = {0.1, 100}}, {   \
            .value = { 0.1, 150 }                                              \
        }                                                                      \
    }
#define ROW_FOAM_DENSITY_GRADIENT /* choices: 4 forms of 3 axes; a step has a place, a band a width beside it */ \
    PHYSICS, 0.04, "the foam gets denser across the block", "by %+.0f %%", 100, 1,                               \
        {{WCUT_FOAM_DENSITY_GRADIENT_CHANGE, LINEAR, 0, 0.8, 0.05, -1.8, 1.8},                                   \
         {WCUT_FOAM_DENSITY_GRADIENT_STEP_AT, LINEAR, 0.5, 0.5, 0.03, 0.02, 0.98},                               \
         {WCUT_FOAM_DENSITY_GRADIENT_BAND, LINEAR, 0.2, 0.2, 0.02, 0.02, 0.9}},                                  \
        10, {                                                                                                    \
        {0, {0.1}, false}, {1, {0.1}, false}, {2, {0.1}, false}, {3, {0.1}, false}, {4, {0.1}, false},           \
            {6, {0.1, 0.3}, false}, {6, {0.1, 0.5}, false}, {6, {0.1, 0.7}, false}, {7, {0.1, 0.35}, false}, {   \
            7, {0.1, 0.65}, false                                                                                \
        }                                                                                                        \
    }
#define ROW_FOAM_INCLUSION /* its columns are those of places: explain/inclusions.c */  \
    PHYSICS, 0.06, "there is a spot of other density in the block", "%+.0f %%", 100, 5, \
        {{WCUT_FOAM_INCLUSION_AMPLITUDE, LINEAR, 0, 0.8, 0.05, -0.95, 5},               \
         {WCUT_FOAM_INCLUSION_RADIUS, LOG, 3.9, 0.6, 0.06, 2.3, 5.3},                   \
         {WCUT_FOAM_INCLUSION_POSITION, LINEAR, 0, 1e4, 5, -100, 2000},                 \
         {WCUT_FOAM_INCLUSION_POSITION + 1, LINEAR, 0, 1e4, 5, -100, 5000},             \
         {WCUT_FOAM_INCLUSION_POSITION + 2, LINEAR, 150, 40, 5, -500, 2000}},           \
        0, {                                                                            \
        { 0 }                                                                           \
    }
#define ROW_TANGENTIAL_DRAG                                                \
    PHYSICS, 0.02, "the foam drags along the wire", "friction %.2f", 1, 1, \
        {{WCUT_TANGENTIAL_DRAG_FRICTION, LINEAR, 0, 1, 0.03, 0, 3}}, 1, {  \
        {                                                                  \
            .value = { 0.1 }                                               \
        }                                                                  \
    }
#define ROW_WIRE_ELONGATION                                                          \
    PHYSICS, 4e-4, "the hot wire is longer than the cold one", "by %.2f %%", 100, 1, \
        {{WCUT_WIRE_ELONGATION_STRAIN, LINEAR, 0, 0.006, 3e-4, 0, 0.04}}, 1, {       \
        {                                                                            \
            .value = { 0.002 }                                                       \
        }                                                                            \
    }
#define ROW_MOUNT_COMPLIANCE                                                      \
    PHYSICS, 0.025, "the mounts give way", "%.1f N/mm", 1, 1,                     \
        {{WCUT_MOUNT_COMPLIANCE_STIFFNESS, RECIPROCAL, 0, 1.5, 0.02, 0, 5}}, 4, { \
        {0, {10}, false}, {1, {10}, false}, {2, {10}, false}, { 3, {10}, false }  \
    }
#define ROW_RATE_DEPENDENCE                                                             \
    PHYSICS, 0.05, "the foam's force follows the speed itself", "exponent %+.2f", 1, 1, \
        {{WCUT_RATE_DEPENDENCE_EXPONENT, LINEAR, 0, 0.6, 0.03, -2, 2}}, 1, {            \
        {                                                                               \
            .value = { 0.1 }                                                            \
        }                                                                               \
    }
#define ROW_SLICE_SOFTENING /* of two arms it is not searched: their wire slides along itself only by its sag */ \
    UNSEARCHED, 0.2, "the force falls where the edge slides along itself", "half at a ratio of %.2f", 1, 1,      \
        {{WCUT_SLICE_SOFTENING_RATIO, RECIPROCAL, 0, 2, 0.1, 0, 20}}, 0, {                                       \
        { 0 }                                                                                                    \
    }
#define ROW_WIRE_FOULING                                                                                  \
    PHYSICS, 0.03, "residue on the wire changes the force as it cuts", "by %+.0f %%", 100, 2,             \
        {{WCUT_WIRE_FOULING_CHANGE, LINEAR, 0, 0.5, 0.03, -0.8, 3},                                       \
         {WCUT_WIRE_FOULING_LENGTH, LOG, 6.8, 0.9, 0.1, 3.5, 9.5}},                                       \
        8, {                                                                                              \
        {0, {0.1, 300}, false}, {0, {0.1, 1000}, false}, {0, {0.1, 3000}, false}, {0, {0.1, 3000}, true}, \
            {1, {0.1, 300}, false}, {1, {0.1, 1000}, false}, {1, {0.1, 3000}, false}, {                   \
            1, {0.1, 3000}, true                                                                          \
        }                                                                                                 \
    }
#define ROW_EMPIRICAL_FORCE                                                      \
    UNSEARCHED, HUGE_VAL, "the force follows a term", "%+.3f", 1, 0, {{0}}, 0, { \
        { 0 }                                                                    \
    }
#define ROW_EMPIRICAL_READING                                                                          \
    UNSEARCHED_INSTRUMENT, HUGE_VAL, "a channel reads more than it should", "%+.3f", 1, 0, {{0}}, 0, { \
        { 0 }                                                                                          \
    }
#define ROW_WIRE_LENGTH                                                                               \
    UNSEARCHED_INSTRUMENT, 3, "the wire has another length than its job states", "by %+.1f mm", 1, 1, \
        {{WCUT_WIRE_LENGTH_CHANGE, LINEAR, 0, 4, 0.1, -50, 50}}, 0, {                                 \
        { 0 }                                                                                         \
    }
#define ROW_BLOCK_SHIFT /* beside a displaced scan: explain/search.c */              \
    UNSEARCHED_INSTRUMENT, 0.5, "the block lies displaced", "%.2f mm along x", 1, 3, \
        {{WCUT_BLOCK_SHIFT_SHIFT, LINEAR, 0, 4, 0.1, -100, 100},                     \
         {WCUT_BLOCK_SHIFT_SHIFT + 1, LINEAR, 0, 4, 0.1, -100, 100},                 \
         {WCUT_BLOCK_SHIFT_SHIFT + 2, LINEAR, 0, 4, 0.1, -100, 100}},                \
        0, {                                                                         \
        { 0 }                                                                        \
    }
#define ROW_KERF_GROWTH                                                          \
    PHYSICS, 5e-5, "the kerf grows with the heat", "%.2f mm per kJ/m2", 1000, 1, \
        {{WCUT_KERF_GROWTH_PER_Q, LINEAR, 0, 4e-4, 2e-5, -2e-3, 2e-3}}, 2, {     \
        {.value = {1e-4}}, {                                                     \
            .choice = 1, .value = { 0, 0.5 }                                     \
        }                                                                        \
    }
#define ROW_BLOCK_SPRINGBACK                                                                                    \
    PHYSICS, 0.4, "the block changed shape after the cut", "%+.1f mm", 1, 1,                                    \
        {{WCUT_BLOCK_SPRINGBACK_AMPLITUDE, LINEAR, 0, 6, 0.1, -50, 50}}, 7, {                                   \
        {0, {1}, false}, {1, {1}, false}, {2, {1}, false}, {3, {1}, false}, {4, {1}, false}, {5, {1}, false}, { \
            6, {1}, false                                                                                       \
        }                                                                                                       \
    }
#define ROW_ANGLE_OFFSET                                                     \
    INSTRUMENT, 0.1, "an angle encoder is offset", "by %+.2f deg", 1, 1,     \
        {{WCUT_ANGLE_OFFSET_OFFSET, LINEAR, 0, 5, 0.1, -60, 60}}, 4, {       \
        {0, {1}, false}, {1, {1}, false}, {2, {1}, false}, { 3, {1}, false } \
    }
#define ROW_TENSION_GAIN                                                                          \
    INSTRUMENT, 0.01, "a tension sensor has another gain than it should", "%+.1f %% off", 100, 1, \
        {{WCUT_TENSION_GAIN_GAIN, LINEAR, 0, 0.2, 0.02, -0.8, 4}}, 2, {                           \
        {0, {0.05}, false}, { 1, {0.05}, false }                                                  \
    }
#define ROW_TENSION_DRIFT                                                  \
    INSTRUMENT, 0.04, "a tension sensor drifts", "%+.2f N in 100 s", 1, 1, \
        {{WCUT_TENSION_DRIFT_DRIFT, LINEAR, 0, 0.6, 0.02, -20, 20}}, 3, {  \
        {0, {0.1}, false}, {1, {0.1}, false}, { 2, {0.1}, false }          \
    }
#define ROW_CLOCK_OFFSET                                               \
    DELAY, 0.05, "sensors are recorded late", "by %.2f s", 1, 1,       \
        {{WCUT_CLOCK_OFFSET_DELAY, LINEAR, 0, 0.4, 0.02, -5, 5}}, 1, { \
        {                                                              \
            .value = { 0.05 }                                          \
        }                                                              \
    }
#define ROW_TENSION_DELAY                                                    \
    DELAY, 0.05, "the tension sensors are recorded late", "by %.2f s", 1, 1, \
        {{WCUT_TENSION_DELAY_DELAY, LINEAR, 0, 0.4, 0.02, -5, 5}}, 1, {      \
        {                                                                    \
            .value = { 0.05 }                                                \
        }                                                                    \
    }
#define ROW_TENSION_ZERO                                                                       \
    INSTRUMENT, 0.04, "a tension sensor does not read zero without load", "but %+.3f N", 1, 1, \
        {{WCUT_TENSION_ZERO_OFFSET, LINEAR, 0, 0.3, 0.02, -5, 5}}, 2, {                        \
        {0, {0.1}, false}, { 1, {0.1}, false }                                                 \
    }
#define ROW_ANGLE_GAIN                                                                            \
    INSTRUMENT, 0.02, "an angle encoder has another gain than it should", "%+.1f %% off", 100, 1, \
        {{WCUT_ANGLE_GAIN_GAIN, LINEAR, 0, 0.2, 0.02, -0.8, 4}}, 4, {                             \
        {0, {0.05}, false}, {1, {0.05}, false}, {2, {0.05}, false}, { 3, {0.05}, false }          \
    }
#define ROW_ENCODER_FRICTION                                                              \
    INSTRUMENT, 0.5, "the joints of the encoders hold back", "half width %.2f deg", 1, 1, \
        {{WCUT_ENCODER_FRICTION_HALF_WIDTH, LINEAR, 0, 0.5, 0.05, 0, 5}}, 1, {            \
        { 0, {0.2}, false }                                                               \
    }
#define ROW_SCAN_OFFSET /* three strengths: its columns are taken one by one */ \
    INSTRUMENT, 0.5, "the scan is displaced", "%.2f mm along x", 1, 3,          \
        {{WCUT_SCAN_OFFSET_SHIFT, LINEAR, 0, 4, 0.1, -100, 100},                \
         {WCUT_SCAN_OFFSET_SHIFT + 1, LINEAR, 0, 4, 0.1, -100, 100},            \
         {WCUT_SCAN_OFFSET_SHIFT + 2, LINEAR, 0, 4, 0.1, -100, 100}},           \
        1, {                                                                    \
        { 0 }                                                                   \
    }
#define ROW_SCAN_SCALE                                                   \
    INSTRUMENT, 6e-4, "the scan has another scale", "factor %.4f", 1, 1, \
        {{WCUT_SCAN_SCALE_SCALE, LINEAR, 1, 0.02, 1e-3, 0.8, 1.2}}, 1, { \
        {                                                                \
            .value = { 1.002 }                                           \
        }                                                                \
    }

#define ROW(name, text, acts) [WCUT_EFFECT_##name] = {WCUT_EFFECT_##name, ROW_##name},
static const wcut_explanation table[] = {WCUT_EFFECT_LIST(ROW)};
_Static_assert(sizeof table / sizeof *table == WCUT_EFFECT_COUNT, "a row for every effect");

const wcut_explanation *wcut_explanation_view(wcut_effect_kind kind) { return &table[kind]; }

wcut_coordinate wcut_effect_coordinate(const wcut_effect *effect, int k) {
    if (effect->kind == WCUT_EFFECT_EMPIRICAL_FORCE) return wcut_term_coordinate(effect, k);
    if (effect->kind == WCUT_EFFECT_KERF_GROWTH && effect->choice == 1)
        return (wcut_coordinate){WCUT_KERF_GROWTH_PER_LOG, WCUT_COORDINATE_SCALE_LINEAR, 0, 1, 0.1, -5, 5};
    return table[effect->kind].coordinate[k];
}

/* how many choices of a kind are no forms but places: choice = form times this and the place; 0: it has one form */
static int bases_of(wcut_effect_kind kind) {
    switch (kind) {
        case WCUT_EFFECT_FOAM_DENSITY_GRADIENT:
            return 3; /* axes */
        case WCUT_EFFECT_WIRE_FOULING:
            return 2; /* coefficients */
        case WCUT_EFFECT_WIRE_THERMAL_LAG:
        case WCUT_EFFECT_END_COOLING:
        case WCUT_EFFECT_TANGENTIAL_DRAG:
        case WCUT_EFFECT_MOUNT_COMPLIANCE:
            return 1;
        default:
            return 0;
    }
}

int wcut_effect_coordinates(const wcut_effect *effect) {
    if (effect->kind == WCUT_EFFECT_EMPIRICAL_FORCE) return wcut_term_coordinates(effect);
    const int form = effect->choice / (bases_of(effect->kind) > 0 ? bases_of(effect->kind) : 1);

    /* a step has a place, a band a width, too; what grows without end has no length of its own */
    if (effect->kind == WCUT_EFFECT_FOAM_DENSITY_GRADIENT) return form < 2 ? 1 : form;
    if (effect->kind == WCUT_EFFECT_WIRE_THERMAL_LAG) return form == 1 ? 3 : 1;
    if (effect->kind == WCUT_EFFECT_WIRE_FOULING) return form == 1 || form == 2 ? 1 : 2;
    return table[effect->kind].count;
}

/* [mm] way, [mm/s] speed at which forms without a scale of their own have the value that is fitted */
#define FOULING_WAY 1000.0
#define FILM_SPEED 3.0
/* where a second time constant, a wider draught and a band begin, against what the first form has */
#define FAST_SHARE 0.5
#define GAUSSIAN_WIDER 1.5

bool wcut_effect_form(const wcut_effect *effect, int nth, wcut_effect *form) {
    const int bases = bases_of(effect->kind);
    if (bases == 0) return false;
    const int choice = effect->choice % bases + nth * bases;
    wcut_effect next = wcut_effect_choose(effect->kind, choice);
    if (!wcut_effect_parameters(&next)) return false;
    *form = *effect;
    if (choice == effect->choice) return true;

    /* the same strength, and what else the two forms have in common */
    const double *v = effect->value;
    next.value[0] = v[0];
    switch (effect->kind) {
        case WCUT_EFFECT_WIRE_THERMAL_LAG:
            if (nth == 1) next.value[0] = FAST_SHARE * v[0], next.value[WCUT_WIRE_THERMAL_LAG_SLOW_SHARE] = 0.3;
            break;
        case WCUT_EFFECT_END_COOLING:
            next.value[1] = v[1] * (nth == 1 ? GAUSSIAN_WIDER : 1 / GAUSSIAN_WIDER);
            break;
        case WCUT_EFFECT_TANGENTIAL_DRAG:
            if (nth == 1) next.value[1] = FILM_SPEED;
            break;
        case WCUT_EFFECT_WIRE_FOULING:
            next.value[1] = FOULING_WAY;
            if (effect->choice < bases) next.value[0] = -v[0] * expm1(-FOULING_WAY / v[1]);
            break;
        case WCUT_EFFECT_MOUNT_COMPLIANCE:
            next.value[1] = v[1];
            break;
        default:
            break;
    }
    *form = next;

    return true;
}

double wcut_scale_in(wcut_coordinate_scale scale, double value) {
    return scale == WCUT_COORDINATE_SCALE_LOG          ? log(value)
           : scale == WCUT_COORDINATE_SCALE_RECIPROCAL ? 1 / value
                                                       : value;
}

double wcut_scale_out(wcut_coordinate_scale scale, double x) {
    return scale == WCUT_COORDINATE_SCALE_LOG ? exp(x) : scale == WCUT_COORDINATE_SCALE_RECIPROCAL ? 1 / x : x;
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
        return fabs(effect->value[WCUT_KERF_GROWTH_PER_LOG]) / 0.15;
    }
    return sqrt(square) / x->gate;
}

int wcut_library_variants(const bool without[WCUT_EFFECT_COUNT], bool several, bool scans, wcut_variant *out) {
    int count = 0;
    for (int kind = 0; kind < WCUT_EFFECT_COUNT; kind++) {
        const wcut_explanation *x = &table[kind];
        const wcut_effect_place place = wcut_effect_view((wcut_effect_kind)kind)->place;
        const bool of_scans = place == WCUT_EFFECT_PLACE_FACE || place == WCUT_EFFECT_PLACE_SCAN;
        for (int k = 0; k < x->starts && x->searched && !without[kind] && (scans || !of_scans); k++) {
            const wcut_start *from = &x->start[k];
            if ((from->carried && !several) || count == WCUT_VARIANTS) continue;
            wcut_variant v = {.effect = wcut_effect_choose((wcut_effect_kind)kind, from->choice),
                              .carried = from->carried};
            v.effect.value[0] = from->value[0];
            if (from->value[1] != 0) v.effect.value[1] = from->value[1];
            out[count++] = v;
        }
    }
    return count;
}
