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
static const parameter thermal_lag[] = {
    {"time_constant_s", WCUT_WIRE_THERMAL_LAG_TIME_CONSTANT, 1, true, 0, 0, 60, 0.1, 3},
    {"v_ref_mm_s", WCUT_WIRE_THERMAL_LAG_SPEED_REF, 1, false, 10, 0.01, 1000, 5, 40},
    {"H0_W_per_mK", WCUT_WIRE_THERMAL_LAG_LOSS, 1, false, 0.059, 1e-6, 10, 0.03, 0.1},
    {"H1_W_s_per_mm_mK", WCUT_WIRE_THERMAL_LAG_LOSS_BY_SPEED, 1, false, 0.0079, 0, 10, 0.004, 0.016},
    END};
static const parameter thermal_lag_two[] = {
    {"time_constant_s", WCUT_WIRE_THERMAL_LAG_TIME_CONSTANT, 1, true, 0, 0, 60, 0.1, 3},
    {"v_ref_mm_s", WCUT_WIRE_THERMAL_LAG_SPEED_REF, 1, false, 10, 0.01, 1000, 5, 40},
    {"H0_W_per_mK", WCUT_WIRE_THERMAL_LAG_LOSS, 1, false, 0.059, 1e-6, 10, 0.03, 0.1},
    {"H1_W_s_per_mm_mK", WCUT_WIRE_THERMAL_LAG_LOSS_BY_SPEED, 1, false, 0.0079, 0, 10, 0.004, 0.016},
    {"slow_share", WCUT_WIRE_THERMAL_LAG_SLOW_SHARE, 1, false, 0.3, 0, 1, 0.1, 0.6},
    {"slow_time_constant_s", WCUT_WIRE_THERMAL_LAG_SLOW_TIME_CONSTANT, 1, false, 5, 1e-3, 1000, 1, 20},
    END};
static const parameter air_overheating[] = {
    {"air_to_foam_ratio", WCUT_AIR_OVERHEATING_RATIO, 1, true, 1, 0.1, 10, 1.1, 2.5},
    {"time_constant_s", WCUT_AIR_OVERHEATING_TIME_CONSTANT, 1, true, 1, 1e-3, 1000, 0.2, 5},
    END};
static const parameter end_cooling[] = {{"amplitude", WCUT_END_COOLING_AMPLITUDE, 1, true, 0, -5, 0.499, 0.05, 0.4},
                                        {"length_mm", WCUT_END_COOLING_LENGTH, 1, true, 100, 0.01, 1e6, 20, 200},
                                        END};
static const parameter gradient[] = {
    {"relative_change_across_block", WCUT_FOAM_DENSITY_GRADIENT_CHANGE, 1, true, 0, -1.9, 1.9, -0.8, 0.8},
    {"step_at_share", WCUT_FOAM_DENSITY_GRADIENT_STEP_AT, 1, false, 0.5, 0, 1, 0.1, 0.9},
    END};
static const parameter gradient_band[] = {
    {"relative_change_across_block", WCUT_FOAM_DENSITY_GRADIENT_CHANGE, 1, true, 0, -0.99, 1.9, -0.8, 0.8},
    {"step_at_share", WCUT_FOAM_DENSITY_GRADIENT_STEP_AT, 1, false, 0.5, 0, 1, 0.1, 0.9},
    {"band_share", WCUT_FOAM_DENSITY_GRADIENT_BAND, 1, false, 0.2, 1e-3, 1, 0.05, 0.5},
    END};
static const parameter inclusion[] = {{"amplitude", WCUT_FOAM_INCLUSION_AMPLITUDE, 1, true, 0, -0.99, 20, -0.6, 1},
                                      {"radius_mm", WCUT_FOAM_INCLUSION_RADIUS, 1, true, 50, 0.1, 1e5, 15, 100},
                                      {"position_mm", WCUT_FOAM_INCLUSION_POSITION, 3, true, 0, -1e6, 1e6, 0, 1500},
                                      END};
static const parameter kerf[] = {{"k1_mm_per_J_m2", WCUT_KERF_GROWTH_PER_Q, 1, false, 0, -1, 1, 0, 3e-4},
                                 {"k2_mm", WCUT_KERF_GROWTH_PER_LOG, 1, false, 0, -100, 100, 0, 1},
                                 END};
static const parameter drag[] = {
    {"mu", WCUT_TANGENTIAL_DRAG_FRICTION, 1, true, 0, 0, 10, 0.02, 0.7},
    {"v_smooth_mm_s", WCUT_TANGENTIAL_DRAG_SPEED_SMOOTH, 1, false, 0.3, 1e-3, 1000, 0.1, 1},
    END};
static const parameter elongation[] = {
    {"strain_at_60W_2N", WCUT_WIRE_ELONGATION_STRAIN, 1, true, 0, 0, 0.05, 5e-4, 6e-3},
    {"thermal_share", WCUT_WIRE_ELONGATION_THERMAL_SHARE, 1, false, 0.8, 0, 1, 0.7, 0.9},
    {"air_factor", WCUT_WIRE_ELONGATION_AIR_FACTOR, 1, false, 1.4, 0, 10, 1, 2.5},
    END};
static const parameter compliance[] = {
    {"stiffness_N_per_mm", WCUT_MOUNT_COMPLIANCE_STIFFNESS, 1, true, ENDLESS, 0.05, ENDLESS, 0.5, 50},
    {"settling_s", WCUT_MOUNT_COMPLIANCE_SETTLING, 1, false, 0.3, 0, 60, 0.05, 1},
    END};
static const parameter slice[] = {
    {"sliding_ratio", WCUT_SLICE_SOFTENING_RATIO, 1, true, ENDLESS, 0.01, ENDLESS, 0.1, 20},
    {"exponent", WCUT_SLICE_SOFTENING_EXPONENT, 1, false, 1, 0.05, 10, 0.5, 2},
    END};
static const parameter rate[] = {{"exponent", WCUT_RATE_DEPENDENCE_EXPONENT, 1, true, 0, -5, 5, -0.5, 0.5},
                                 {"v_ref_mm_s", WCUT_RATE_DEPENDENCE_SPEED_REF, 1, false, 10, 0.01, 1000, 5, 40},
                                 END};
static const parameter fouling[] = {{"relative_change", WCUT_WIRE_FOULING_CHANGE, 1, true, 0, -0.95, 10, -0.4, 0.4},
                                    {"length_mm", WCUT_WIRE_FOULING_LENGTH, 1, true, 1000, 0.1, 1e7, 200, 5000},
                                    {"start_mm", WCUT_WIRE_FOULING_START, 1, false, 0, 0, 1e9, 0, 5000},
                                    END};
static const parameter wire_length[] = {{"change_mm", WCUT_WIRE_LENGTH_CHANGE, 1, true, 0, -1e4, 1e4, -5, 5}, END};
static const parameter block_shift[] = {{"shift_mm", WCUT_BLOCK_SHIFT_SHIFT, 3, true, 0, -1e4, 1e4, -5, 5}, END};
static const parameter springback[] = {{"amplitude_mm", WCUT_BLOCK_SPRINGBACK_AMPLITUDE, 1, true, 0, -100, 100, -5, 5},
                                       END};
static const parameter angle[] = {{"offset_deg", WCUT_ANGLE_OFFSET_OFFSET, 1, true, 0, -90, 90, -5, 5}, END};
static const parameter gain[] = {{"gain_error", WCUT_TENSION_GAIN_GAIN, 1, true, 0, -0.95, 10, -0.15, 0.15}, END};
static const parameter drift[] = {{"drift_N", WCUT_TENSION_DRIFT_DRIFT, 1, true, 0, -100, 100, -0.5, 0.5},
                                  {"tau_s", WCUT_TENSION_DRIFT_TIME_CONSTANT, 1, false, 0, 0, 1e6, 0, 60},
                                  END};
static const parameter reading[] = {{"offset", WCUT_EMPIRICAL_READING_OFFSET, 1, true, 0, -1e3, 1e3, -5, 5},
                                    {"slope_per_100_s", WCUT_EMPIRICAL_READING_SLOPE, 1, false, 0, -1e3, 1e3, -5, 5},
                                    {"from_s", WCUT_EMPIRICAL_READING_FROM, 1, false, -1e6, -1e6, 1e6, 0, 200},
                                    {"to_s", WCUT_EMPIRICAL_READING_TO, 1, false, 1e6, -1e6, 1e6, 0, 200},
                                    END};
static const parameter clock[] = {{"delay_s", WCUT_CLOCK_OFFSET_DELAY, 1, true, 0, -60, 60, -0.3, 0.3}, END};
static const parameter tension_delay[] = {{"delay_s", WCUT_TENSION_DELAY_DELAY, 1, true, 0, -60, 60, -0.3, 0.3}, END};
static const parameter zero[] = {{"offset_N", WCUT_TENSION_ZERO_OFFSET, 1, true, 0, -100, 100, -0.5, 0.5}, END};
static const parameter angle_gain[] = {{"gain_error", WCUT_ANGLE_GAIN_GAIN, 1, true, 0, -0.95, 10, -0.15, 0.15}, END};
static const parameter friction[] = {{"half_width_deg", WCUT_ENCODER_FRICTION_HALF_WIDTH, 1, true, 0, 0, 45, 0, 1},
                                     END};
static const parameter offset[] = {{"shift_mm", WCUT_SCAN_OFFSET_SHIFT, 3, true, 0, -1000, 1000, -5, 5}, END};
static const parameter scale[] = {{"scale", WCUT_SCAN_SCALE_SCALE, 1, true, 1, 0.5, 2, 0.98, 1.02}, END};

static const char *const lags[] = {"wire", "two", "melt", NULL};
static const char *const coolings[] = {"exponential", "gaussian", NULL};
static const char *const drags[] = {"coulomb", "speed", NULL};
static const char *const profiles[] = {"x",           "y",      "z",      "x_quadratic", "y_quadratic",
                                       "z_quadratic", "x_step", "y_step", "z_step",      "x_band",
                                       "y_band",      "z_band", NULL};
static const char *const mounts[] = {"both", "a", "b", "feed", NULL};
static const char *const residues[] = {"a",      "b",         "a_linear",  "b_linear", "a_root",
                                       "b_root", "a_falling", "b_falling", NULL};
static const char *const kerf_laws[] = {"linear", "log", NULL};
static const char *const shapes[] = {"saddle", "cylinder_x", "cylinder_y", "bowl", "twist", "cubic_x", "cubic_y", NULL};
static const char *const angles[] = {"alpha_a_deg", "beta_a_deg", "alpha_b_deg", "beta_b_deg", NULL};
static const char *const readings[] = {"tension_a_N", "tension_b_N", "alpha_a_deg", "beta_a_deg",
                                       "alpha_b_deg", "beta_b_deg",  NULL};
static const char *const sensors[] = {"a", "b", "both", NULL};

/* choice and whether a job must choose, strengths, neutral, repeats, needs mounts, parameters; equation; what is plausible
   and by which source; where the physics is */
#define INFO_WIRE_THERMAL_LAG                                                                                      \
    "form", false, lags, 1, 0, false, false, thermal_lag,                                                          \
        "C theta' = Q_i - H(v) theta, H = H_0 + H_1 v, C = tau (H_0 + H_1 v_0), H_0 = 0.059 W/mK, H_1 = 0.0079 W " \
        "s/(mm m K); two: q = H ((1 - s) theta + s theta_2), theta_2 with tau_2; melt: q / v follows Q_i / v "     \
        "with tau",                                                                                                \
        "tau 0.1 to 3 s; 0.058 J/mK of Kanthal A 0.15 mm over 0.14 W/mK: 0.4 s", "kernel/foam/local_law.c:delay_power"
#define INFO_AIR_OVERHEATING                                                                                \
    NULL, false, NULL, 1, 1, false, false, air_overheating,                                                 \
        "o = 1 + (rho - 1) exp(-t / tau), t since the wire entered the foam",                               \
        "rho 1.1 to 2.5: 2.1 by 650 degC in air and 320 in foam at 65 W/m, less behind a short way in air", \
        "kernel/foam/local_law.c:overheat"
#define INFO_END_COOLING                                                                                               \
    "form", false, coolings, 1, 0, false, true, end_cooling,                                                           \
        "e_i = 1 - A (exp(-s_A / l) + exp(-s_B / l)), s the way along the wire to each mount; gaussian: of (s / l)^2", \
        "A 0.05 to 0.4, l 20 to 200 mm (judged; laboratory 0.13 to 0.35, 116 to 127 mm): conduction along 11 W/mK "    \
        "alone reaches 1 mm, a cooled mount and its draught farther",                                                  \
        "kernel/foam/local_law.c:cooled_ends"
#define INFO_FOAM_DENSITY_GRADIENT                                                                                 \
    "axis", true, profiles, 1, 0, true, false, gradient,                                                           \
        "c_a = 1 + g (u - 1/2), u = x / W, y / L or z / H; quadratic: 1 + g ((2u - 1)^2 - 1/3); step at s: 1 + g " \
        "tanh((u - s) / 0.02) / 2; band of width w about s: a step at s - w / 2 less one at s + w / 2",            \
        "0.1 to 0.3 within a moulded EPS block (judged), 0.8 across a bad one (laboratory)",                       \
        "kernel/foam/local_law.c:add_gradient"
#define INFO_FOAM_INCLUSION                                                                                 \
    NULL, false, NULL, 1, 0, true, false, inclusion, "c_a = 1 + A exp(-abs(X - P)^2 / 2 R^2)",              \
        "A -0.6 to 1, R 15 to 100 mm: a void, a fused lump (judged; laboratory A -0.5 to 0.3, R 39 to 64)", \
        "kernel/foam/local_law.c:add_inclusion"
#define INFO_TANGENTIAL_DRAG                                                                                  \
    "law", false, drags, 1, 0, false, false, drag,                                                            \
        "f_i - mu abs(f_i - (f_i t_i) t_i) tanh(v_t / v_s) t_i: Coulomb friction under the force across the " \
        "wire; v_t speed along it, v_s = 0.3 mm/s; speed: v_t / v_s in place of tanh",                        \
        "0.02 to 0.7, a melt film to dry rubbing (judged; laboratory 0.06 to 0.66)",                          \
        "kernel/foam/resistance.c:add_drag"
#define INFO_WIRE_ELONGATION                                                                                          \
    NULL, false, NULL, 1, 0, false, true, elongation,                                                                 \
        "l_e = l (1 + eps_T (Q_I / 60) (e + 1.4 (1 - e)) + S_e / EA); strain = eps_T + 2 N / EA, eps_T = 0.8 strain", \
        "0.003 to 0.005: 13e-6 1/K and 320 K in foam; EA 2650 to 3900 N (150 to 220 GPa)",                            \
        "kernel/cut/active_effects.c:wcut_extension_apply"
#define INFO_MOUNT_COMPLIANCE                                                                                         \
    "mount", true, mounts, 1, ENDLESS, false, true, compliance,                                                       \
        "tau u' = S / k - u, the end of the wire at mount + u; mount `a`, `b` or `both`, `feed`: both along y alone", \
        "0.5 to 50 N/mm, tau 0.05 to 1 s: a tool head on a long arm to a spindle (judged; laboratory 1 to 17 N/mm)",  \
        "kernel/cut/compliance.c:wcut_compliance_end"
#define INFO_RATE_DEPENDENCE                                                         \
    NULL, false, NULL, 1, 0, false, false, rate, "(v / v_0)^m, v_0 = 10 mm/s",       \
        "-0.5 to 0.5, the melt is shear-thinning (judged; laboratory 0.26 to 0.38)", \
        "kernel/foam/local_law.c:wcut_local_law_eval"
#define INFO_SLICE_SOFTENING                                                                                           \
    NULL, false, NULL, 1, ENDLESS, false, false, slice,                                                                \
        "f_i / (1 + (xi / xi_0)^2)^m, xi = abs(d t) / abs(d x t): sliding along the edge over advance across it, m = " \
        "1",                                                                                                           \
        "xi_0 0.3 to 3: 1 where cutting takes all work (Atkins, Xu, Jeronimidis 2004)",                                \
        "kernel/foam/resistance.c:soften"
#define INFO_WIRE_FOULING                                                                                            \
    "on", true, residues, 1, 0, true, false, fouling,                                                                \
        "c_a or c_b = 1 + c (1 - exp(-(w_0 + w_i) / l)), w_i way of the node in the foam before the step, w_0 that " \
        "way "                                                                                                       \
        "before the run; linear c w / l, root c sqrt(w / l), falling c times the part of w / l behind the point",    \
        "c 0.1 to 0.4, l 200 to 5000 mm, a tenth of a cut to ten cuts (judged; laboratory 0.12, 650 to 790 mm)",     \
        "kernel/foam/local_law.c:coefficients"
#define INFO_EMPIRICAL_FORCE                                                                             \
    "term", true, wcut_term_name, 2, 0, true, false, wcut_term_first,                                    \
        "F (1 + sum c phi), the sum over all such terms; below 1/2 it is continued by exp(2 s + 1) / 2", \
        "c -0.6 to 0.6: what has no name yet", "kernel/foam/empirical.c:wcut_term_factor_eval"
#define INFO_WIRE_LENGTH                                                                                  \
    NULL, false, NULL, 1, 0, false, true, wire_length, "l + d, the wire longer than wire.length_mm by d", \
        "5 mm: a wire cut by hand is off by 2 mm (judged; second laboratory 2 mm)", "kernel/cut/setup.c:take_mounts"
#define INFO_BLOCK_SHIFT                                                                 \
    NULL, false, NULL, 3, 0, false, true, block_shift,                                   \
        "mounts at X - d in the frame of a block that lies d from where the job has it", \
        "5 mm (judged; second laboratory 1 to 2 mm)", "kernel/cut/setup.c:take_mounts"
#define INFO_KERF_GROWTH                                                                    \
    "law", true, kerf_laws, 2, 0, false, false, kerf,                                       \
        "face moved by -(k_1 Q_eff) / 2, or -(k_2 ln(Q_eff / 1000)) / 2, along its normal", \
        "1.6e-4 mm m^2/J (a kerf of 0.16 mm per kJ/m^2)", "kernel/scan/face.c:more_kerf"
#define INFO_BLOCK_SPRINGBACK                                                                                          \
    "shape", true, shapes, 1, 0, true, false, springback,                                                              \
        "face raised by A (u^2 - v^2) saddle, A u^2 cylinder_x, A v^2 cylinder_y, A (u^2 + v^2) bowl, A u v twist, A " \
        "u^3 cubic_x, A v^3 cubic_y; u = 2x/W - 1, v = 2y/L - 1",                                                      \
        "1 to 5 mm on a block of 600 mm (laboratory)", "kernel/scan/face.c:shape_of"
#define INFO_ANGLE_OFFSET                                                \
    "channel", true, angles, 1, 0, true, false, angle, "angle + offset", \
        "5 deg: an encoder mounted one tooth of 72 off", "kernel/cut/sensors.c:offset_angle"
#define INFO_TENSION_GAIN                                                                          \
    "sensor", true, sensors, 1, 0, true, false, gain, "tension (1 + gain) of sensor a, b or both", \
        "0.15: a bridge badly calibrated (judged; laboratory 0.02 to 0.05)", "kernel/cut/sensors.c:spoil_tension"
#define INFO_TENSION_DRIFT                                                                                \
    "sensor", true, sensors, 1, 0, true, false, drift, "tension + d t / 100 s, or d (1 - exp(-t / tau))", \
        "0.5 N: a quarter of the working tension (judged; laboratory 0.16)", "kernel/cut/sensors.c:drift_at"
#define INFO_EMPIRICAL_READING                                                           \
    "channel", true, readings, 2, 0, true, false, reading,                               \
        "channel + o + s (t - t_1) / 100 s from t_1 to t_2, in the unit of the channel", \
        "a burst, a reading that jumps", "kernel/cut/sensors.c:add_reading"
#define INFO_CLOCK_OFFSET                                                                                 \
    NULL, false, NULL, 1, 0, false, false, clock, "tensions and angles at t - delay, speeds as they are", \
        "0.3 s: two loggers that are started by hand (judged; laboratory 0.12)", "kernel/cut/sensors.c:delay_clock"
#define INFO_TENSION_DELAY                                                                 \
    NULL, false, NULL, 1, 0, false, false, tension_delay, "tensions at t - delay",         \
        "0.2 s: a load cell's filter and its bus (judged; second laboratory 0.04 to 0.2)", \
        "kernel/cut/sensors.c:delay_clock"
#define INFO_TENSION_ZERO                                            \
    "sensor", true, sensors, 1, 0, true, false, zero, "tension + z", \
        "0.5 N: a quarter of the working tension (judged)", "kernel/cut/sensors.c:spoil_tension"
#define INFO_ANGLE_GAIN                                                                                            \
    "channel", true, angles, 1, 0, true, false, angle_gain, "angle (1 + g)", "0.15: as a tension's gain (judged)", \
        "kernel/cut/sensors.c:scale_angle"
#define INFO_ENCODER_FRICTION                                                                \
    NULL, false, NULL, 1, 0, false, false, friction,                                         \
        "the joint follows once the angle has left its play of half width h (Prandtl 1928)", \
        "1 deg (judged; second laboratory 0.1 to 0.5)", "kernel/cut/sensors.c:hold_angles"
#define INFO_SCAN_OFFSET                                                                        \
    NULL, false, NULL, 3, 0, false, false, offset, "X + shift",                                 \
        "5 mm (judged: beyond, a registration by eye would show it; laboratory 0.9 to 4.8 mm)", \
        "kernel/scan/face.c:misplace_scan"
#define INFO_SCAN_SCALE                                                                       \
    NULL, false, NULL, 1, 1, false, false, scale, "middle of the block + scale (X - middle)", \
        "2 % (judged: beyond, a registration by eye would show it; laboratory 0.25 %)",       \
        "kernel/scan/face.c:misplace_scan"

#define INFO(name, text, acts) [WCUT_EFFECT_##name] = {text, WCUT_EFFECT_PLACE_##acts, INFO_##name},
static const wcut_effect_info table[] = {WCUT_EFFECT_LIST(INFO)};
_Static_assert(sizeof table / sizeof *table == WCUT_EFFECT_COUNT, "a row for every effect");

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
    if (effect->kind == WCUT_EFFECT_EMPIRICAL_FORCE) return wcut_term_parameters(effect->choice);

    /* forms that have more to tell than the first of their kind */
    if (effect->kind == WCUT_EFFECT_WIRE_THERMAL_LAG && effect->choice == 1) return thermal_lag_two;
    if (effect->kind == WCUT_EFFECT_FOAM_DENSITY_GRADIENT && effect->choice >= 9) return gradient_band;
    return info->parameter;
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
