/* The table of effects: names, parameters, ranges, and what is neutral. */
#include <wirecut/effects.h>

#include <string.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "foam/empirical.h"

#define ENDLESS ((double)INFINITY)
#define END \
    { NULL, 0, 0, false, 0, 0, 0, 0, 0 }

typedef wcut_effect_parameter parameter;

/* key, place, size, required, initial, accepted range, plausible range */
static const parameter thermal_lag[] = {{"time_constant_s", 0, 1, true, 0, 0, 60, 0.1, 3},
                                        {"v_ref_mm_s", 1, 1, false, 10, 0.01, 1000, 5, 40},
                                        {"H0_W_per_mK", 2, 1, false, 0.059, 1e-6, 10, 0.03, 0.1},
                                        {"H1_W_s_per_mm_mK", 3, 1, false, 0.0079, 0, 10, 0.004, 0.016},
                                        END};
static const parameter air_overheating[] = {{"air_to_foam_ratio", 0, 1, true, 1, 0.1, 10, 1.1, 2.5},
                                            {"time_constant_s", 1, 1, true, 1, 1e-3, 1000, 0.2, 5},
                                            END};
static const parameter end_cooling[] = {
    {"amplitude", 0, 1, true, 0, -5, 0.49, 0.05, 0.4}, {"length_mm", 1, 1, true, 100, 0.01, 1e6, 20, 200}, END};
static const parameter gradient[] = {{"relative_change_across_block", 0, 1, true, 0, -1.9, 1.9, -0.8, 0.8},
                                     {"step_at_share", 1, 1, false, 0.5, 0, 1, 0.1, 0.9},
                                     END};
static const parameter inclusion[] = {{"amplitude", 0, 1, true, 0, -0.99, 20, -0.6, 1},
                                      {"radius_mm", 1, 1, true, 50, 0.1, 1e5, 15, 100},
                                      {"position_mm", 2, 3, true, 0, -1e6, 1e6, 0, 1500},
                                      END};
static const parameter kerf[] = {
    {"k1_mm_per_J_m2", 0, 1, false, 0, -1, 1, 0, 3e-4}, {"k2_mm", 1, 1, false, 0, -100, 100, 0, 1}, END};
static const parameter drag[] = {
    {"mu", 0, 1, true, 0, 0, 10, 0.02, 0.7}, {"v_smooth_mm_s", 1, 1, false, 0.3, 1e-3, 1000, 0.1, 1}, END};
static const parameter elongation[] = {{"strain_at_60W_2N", 0, 1, true, 0, 0, 0.05, 5e-4, 6e-3},
                                       {"thermal_share", 1, 1, false, 0.8, 0, 1, 0.7, 0.9},
                                       {"air_factor", 2, 1, false, 1.4, 0, 10, 1, 2.5},
                                       END};
static const parameter compliance[] = {{"stiffness_N_per_mm", 0, 1, true, ENDLESS, 0.05, ENDLESS, 0.5, 50},
                                       {"settling_s", 1, 1, false, 0.3, 0, 60, 0.05, 1},
                                       END};
static const parameter rate[] = {
    {"exponent", 0, 1, true, 0, -5, 5, -0.5, 0.5}, {"v_ref_mm_s", 1, 1, false, 10, 0.01, 1000, 5, 40}, END};
static const parameter fouling[] = {{"relative_change", 0, 1, true, 0, -0.95, 10, -0.4, 0.4},
                                    {"length_mm", 1, 1, true, 1000, 0.1, 1e7, 200, 5000},
                                    {"start_mm", 2, 1, false, 0, 0, 1e9, 0, 5000},
                                    END};
static const parameter springback[] = {{"amplitude_mm", 0, 1, true, 0, -100, 100, -5, 5}, END};
static const parameter angle[] = {{"offset_deg", 0, 1, true, 0, -90, 90, -5, 5}, END};
static const parameter gain[] = {{"gain_error", 0, 1, true, 0, -0.95, 10, -0.15, 0.15}, END};
static const parameter drift[] = {
    {"drift_N", 0, 1, true, 0, -100, 100, -0.5, 0.5}, {"tau_s", 1, 1, false, 0, 0, 1e6, 0, 60}, END};
static const parameter reading[] = {{"offset", 0, 1, true, 0, -1e3, 1e3, -5, 5},
                                    {"slope_per_100_s", 1, 1, false, 0, -1e3, 1e3, -5, 5},
                                    {"from_s", 2, 1, false, -1e6, -1e6, 1e6, 0, 200},
                                    {"to_s", 3, 1, false, 1e6, -1e6, 1e6, 0, 200},
                                    END};
static const parameter clock[] = {{"delay_s", 0, 1, true, 0, -60, 60, -0.3, 0.3}, END};
static const parameter tension_delay[] = {{"delay_s", 0, 1, true, 0, -60, 60, -0.3, 0.3}, END};
static const parameter zero[] = {{"offset_N", 0, 1, true, 0, -100, 100, -0.5, 0.5}, END};
static const parameter angle_gain[] = {{"gain_error", 0, 1, true, 0, -0.95, 10, -0.15, 0.15}, END};
static const parameter friction[] = {{"half_width_deg", 0, 1, true, 0, 0, 45, 0, 1}, END};
static const parameter offset[] = {{"shift_mm", 0, 3, true, 0, -1000, 1000, -5, 5}, END};
static const parameter scale[] = {{"scale", 0, 1, true, 1, 0.5, 2, 0.98, 1.02}, END};

static const char *const profiles[] = {"x",           "y",      "z",      "x_quadratic", "y_quadratic",
                                       "z_quadratic", "x_step", "y_step", "z_step",      NULL};
static const char *const coefficients[] = {"a", "b", NULL};
static const char *const kerf_laws[] = {"linear", "log", NULL};
static const char *const shapes[] = {"saddle", "cylinder_x", "cylinder_y", "bowl", "twist", NULL};
static const char *const angles[] = {"alpha_a_deg", "beta_a_deg", "alpha_b_deg", "beta_b_deg", NULL};
static const char *const readings[] = {"tension_a_N", "tension_b_N", "alpha_a_deg", "beta_a_deg",
                                       "alpha_b_deg", "beta_b_deg",  NULL};
static const char *const sensors[] = {"a", "b", "both", NULL};

/* choice, strengths, neutral, repeats, needs mounts, parameters */
#define INFO_WIRE_THERMAL_LAG NULL, NULL, 1, 0, false, false, thermal_lag
#define INFO_AIR_OVERHEATING NULL, NULL, 1, 1, false, false, air_overheating
#define INFO_END_COOLING NULL, NULL, 1, 0, false, true, end_cooling
#define INFO_FOAM_DENSITY_GRADIENT "axis", profiles, 1, 0, true, false, gradient
#define INFO_FOAM_INCLUSION NULL, NULL, 1, 0, true, false, inclusion
#define INFO_TANGENTIAL_DRAG NULL, NULL, 1, 0, false, false, drag
#define INFO_WIRE_ELONGATION NULL, NULL, 1, 0, false, true, elongation
#define INFO_MOUNT_COMPLIANCE NULL, NULL, 1, ENDLESS, false, true, compliance
#define INFO_RATE_DEPENDENCE NULL, NULL, 1, 0, false, false, rate
#define INFO_WIRE_FOULING "on", coefficients, 1, 0, true, false, fouling
#define INFO_EMPIRICAL_FORCE "term", wcut_term_name, 2, 0, true, false, wcut_term_first
#define INFO_KERF_GROWTH "law", kerf_laws, 2, 0, false, false, kerf
#define INFO_BLOCK_SPRINGBACK "shape", shapes, 1, 0, true, false, springback
#define INFO_ANGLE_OFFSET "channel", angles, 1, 0, true, false, angle
#define INFO_TENSION_GAIN "sensor", sensors, 1, 0, true, false, gain
#define INFO_TENSION_DRIFT "sensor", sensors, 1, 0, true, false, drift
#define INFO_EMPIRICAL_READING "channel", readings, 2, 0, true, false, reading
#define INFO_CLOCK_OFFSET NULL, NULL, 1, 0, false, false, clock
#define INFO_TENSION_DELAY NULL, NULL, 1, 0, false, false, tension_delay
#define INFO_TENSION_ZERO "sensor", sensors, 1, 0, true, false, zero
#define INFO_ANGLE_GAIN "channel", angles, 1, 0, true, false, angle_gain
#define INFO_ENCODER_FRICTION NULL, NULL, 1, 0, false, false, friction
#define INFO_SCAN_OFFSET NULL, NULL, 3, 0, false, false, offset
#define INFO_SCAN_SCALE NULL, NULL, 1, 1, false, false, scale

#define INFO(name, text, acts) [WCUT_EFFECT_##name] = {text, WCUT_EFFECT_PLACE_##acts, INFO_##name},
static const wcut_effect_info table[] = {WCUT_EFFECT_LIST(INFO)};

const wcut_effect_info *wcut_effect_view(wcut_effect_kind kind) {
    return (unsigned)kind < WCUT_EFFECT_COUNT ? &table[kind] : NULL;
}

wcut_status wcut_effect_locate(const char *name, wcut_effect_kind *kind) {
    if (!name || !kind) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++)
        if (strcmp(name, table[k].name) == 0) {
            *kind = (wcut_effect_kind)k;
            return WCUT_OK;
        }
    return WCUT_NOT_FOUND;
}

static int choices_of(const wcut_effect_info *info) {
    int count = 1;
    while (info->choice && info->choice[count]) count++;
    return count;
}

const wcut_effect_parameter *wcut_effect_parameters(const wcut_effect *effect) {
    const wcut_effect_info *info = wcut_effect_view(effect->kind);
    if (!info || effect->choice < 0 || effect->choice >= choices_of(info)) return NULL;
    return effect->kind == WCUT_EFFECT_EMPIRICAL_FORCE ? wcut_term_parameters(effect->choice) : info->parameter;
}

wcut_effect wcut_effect_choose(wcut_effect_kind kind, int choice) {
    wcut_effect effect = {.kind = kind, .choice = choice};
    for (const parameter *p = wcut_effect_parameters(&effect); p && p->key; p++)
        for (int k = 0; k < p->size; k++) effect.value[p->at + k] = p->initial;
    return effect;
}

wcut_effect wcut_effect_default(wcut_effect_kind kind) { return wcut_effect_choose(kind, 0); }

bool wcut_effect_is_neutral(const wcut_effect *effect) {
    const wcut_effect_info *info = wcut_effect_view(effect->kind);
    for (int k = 0; info && k < info->strengths; k++)
        if (effect->value[k] != info->neutral) return false;
    return true;
}

static wcut_status check_values(int place, const wcut_effect *effect, wcut_error *error) {
    const wcut_effect_info *info = &table[effect->kind];
    for (const parameter *p = wcut_effect_parameters(effect); p->key; p++)
        for (int k = 0; k < p->size; k++) {
            const double value = effect->value[p->at + k];
            if (value >= p->min && value <= p->max) continue;
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "effects[%d].%s (%s): found %g, expected %g to %g", place,
                             p->key, info->name, value, p->min, p->max);
        }
    return WCUT_OK;
}

wcut_status wcut_effects_check(int count, const wcut_effect *effect, wcut_error *error) {
    if (count < 0 || (count > 0 && !effect))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "effects: expected %d of them", count);

    /* each effect: known, in range, and not twice where it does not repeat */
    int memories = 0;
    for (int e = 0; e < count; e++) {
        const wcut_effect_info *info = wcut_effect_view(effect[e].kind);
        if (!info || effect[e].choice < 0 || effect[e].choice >= choices_of(info))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "effects[%d]: expected a known effect and choice", e);
        const wcut_status status = check_values(e, &effect[e], error);
        if (status != WCUT_OK) return status;
        memories += effect[e].kind == WCUT_EFFECT_EMPIRICAL_FORCE && wcut_term_remembers(effect[e].choice);
        if (memories > WCUT_TERM_MEMORIES)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "effects[%d].term: found another term with a memory, expected %d of them at most", e,
                             WCUT_TERM_MEMORIES);
        for (int k = 0; k < e; k++)
            if (effect[k].kind == effect[e].kind && !info->repeats)
                return wcut_fail(error, WCUT_BAD_ARGUMENT, "effects[%d]: found a second %s, expected one at most", e,
                                 info->name);
    }

    return WCUT_OK;
}
