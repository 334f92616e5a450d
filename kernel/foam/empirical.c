/* The empirical terms of the force: F times 1 + sum c_k phi_k, phi_k from a dictionary (NOTATION.md, Effects). A term
   claims no mechanism. It makes what was found in recordings predict, until somebody names the cause. */
#include "foam/empirical.h"

#include <math.h>
#include <stddef.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "foam/force_law.h"

#define END \
    { NULL, 0, 0, false, 0, 0, 0, 0, 0 }
#define COEFFICIENT \
    { "coefficient", WCUT_EMPIRICAL_FORCE_COEFFICIENT, 1, true, 0, -20, 20, -0.6, 0.6 }

/* key, place, size, required, initial, accepted range, plausible range */
typedef wcut_effect_parameter parameter;
const wcut_effect_parameter wcut_term_first[] = {
    COEFFICIENT, {"degree", WCUT_EMPIRICAL_FORCE_DEGREE, 1, false, 1, 1, 4, 1, 3}, END};
static const parameter wave[] = {COEFFICIENT,
                                 {"cosine", WCUT_EMPIRICAL_FORCE_COSINE, 1, false, 0, -20, 20, -0.6, 0.6},
                                 {"wavelength_mm", WCUT_EMPIRICAL_FORCE_WAVELENGTH, 1, true, 100, 1, 1e6, 30, 500},
                                 END};
static const parameter band[] = {COEFFICIENT,
                                 {"from_mm", WCUT_EMPIRICAL_FORCE_FROM, 1, true, 0, -1e6, 1e6, 0, 1500},
                                 {"to_mm", WCUT_EMPIRICAL_FORCE_TO, 1, true, 100, -1e6, 1e6, 0, 1500},
                                 {"edge_mm", WCUT_EMPIRICAL_FORCE_EDGE, 1, false, 5, 0.1, 1e5, 2, 20},
                                 END};
static const parameter direction[] = {COEFFICIENT, {"order", WCUT_EMPIRICAL_FORCE_ORDER, 1, false, 1, 1, 2, 1, 2}, END};
static const parameter heat_step[] = {COEFFICIENT,
                                      {"at_J_per_m2", WCUT_EMPIRICAL_FORCE_AT, 1, true, 5000, 1, 1e7, 1000, 1e5},
                                      {"width_J_per_m2", WCUT_EMPIRICAL_FORCE_WIDTH, 1, false, 300, 1, 1e6, 50, 5000},
                                      END};
static const parameter heat_unit[] = {
    COEFFICIENT, {"q_ref_J_per_m2", WCUT_EMPIRICAL_FORCE_Q_REF, 1, false, 5000, 1, 1e7, 1000, 1e5}, END};
static const parameter speed_unit[] = {
    COEFFICIENT, {"v_ref_mm_s", WCUT_EMPIRICAL_FORCE_SPEED_REF, 1, false, 10, 0.01, 1000, 5, 40}, END};
static const parameter radius[] = {
    COEFFICIENT, {"radius_mm", WCUT_EMPIRICAL_FORCE_RADIUS, 1, false, 100, 0.1, 1e6, 50, 500}, END};
static const parameter constant[] = {
    COEFFICIENT, {"time_constant_s", WCUT_EMPIRICAL_FORCE_TIME_CONSTANT, 1, true, 1, 1e-3, 1e4, 0.2, 20}, END};
static const parameter way[] = {COEFFICIENT,
                                {"length_mm", WCUT_EMPIRICAL_FORCE_LENGTH, 1, false, 1000, 0.1, 1e7, 200, 5000},
                                {"start_mm", WCUT_EMPIRICAL_FORCE_START, 1, false, 0, 0, 1e9, 0, 5000},
                                END};
static const parameter start[] = {
    COEFFICIENT, {"start_s", WCUT_EMPIRICAL_FORCE_START_TIME, 1, false, 0, -1e9, 1e9, 0, 1e4}, END};
static const parameter order[] = {COEFFICIENT,
                                  {"number", WCUT_EMPIRICAL_FORCE_NUMBER, 1, true, 0, 0, 1e6, 0, 20},
                                  {"from", WCUT_EMPIRICAL_FORCE_FIRST, 1, false, -1, -1, 1e6, 0, 20},
                                  {"to", WCUT_EMPIRICAL_FORCE_LAST, 1, false, 1e6, -1, 1e6, 0, 20},
                                  END};
static const parameter window[] = {COEFFICIENT,
                                   {"from_s", WCUT_EMPIRICAL_FORCE_FROM, 1, true, 0, -1e6, 1e6, 0, 200},
                                   {"to_s", WCUT_EMPIRICAL_FORCE_TO, 1, true, 1, -1e6, 1e6, 0, 200},
                                   {"edge_s", WCUT_EMPIRICAL_FORCE_EDGE, 1, false, 0.2, 0.01, 100, 0.05, 1},
                                   END};

#define NAME(name, text, list) text,
#define PARAMETERS(name, text, list) list,
const char *const wcut_term_name[WCUT_TERM_COUNT + 1] = {WCUT_TERM_LIST(NAME) NULL};
static const parameter *const parameters[WCUT_TERM_COUNT] = {WCUT_TERM_LIST(PARAMETERS)};

const wcut_effect_parameter *wcut_term_parameters(int term) { return parameters[term]; }

bool wcut_term_remembers(int term) { return term == WCUT_TERM_SPEED_MEMORY || term == WCUT_TERM_HEAT_MEMORY; }

/* speed [mm/s] below which its logarithm is held: a node that stands has no force */
#define SLOWEST 1e-3

static double ln_speed(double speed) { return log(fmax(speed, SLOWEST)); }

/* c phi of a term, and how it changes */
typedef struct part {
    double value, by_speed, by_log_rate;
    double by_heat; /* per W/m, through what the heat itself follows */
    wcut_vec3 by_position;
} part;

/* ---- of the place ---- */

static double component(wcut_vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

static wcut_vec3 along(int axis, double size) {
    return vec3(axis == 0 ? size : 0, axis == 1 ? size : 0, axis == 2 ? size : 0);
}

/* P_n of s and its derivative: Legendre's polynomials, each free of the ones before it over the block */
static double legendre(int n, double s, double *slope) {
    const double s2 = s * s;
    switch (n) {
        case 1:
            *slope = 1;
            return s;
        case 2:
            *slope = 3 * s;
            return (3 * s2 - 1) / 2;
        case 3:
            *slope = (15 * s2 - 3) / 2;
            return (5 * s2 - 3) * s / 2;
        default:
            *slope = (35 * s2 - 15) * s / 2;
            return (35 * s2 * s2 - 30 * s2 + 3) / 8;
    }
}

static part of_position(const double *v, int axis, const wcut_term_node *node) {
    const double size = component(node->block->size, axis);
    double slope;
    const double value =
        legendre((int)lround(v[WCUT_EMPIRICAL_FORCE_DEGREE]), 2 * component(node->x, axis) / size - 1, &slope);
    return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * value,
                  .by_position = along(axis, v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * slope * 2 / size)};
}

static part of_wave(const double *v, int axis, const wcut_term_node *node) {
    const double sine = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT], cosine = v[WCUT_EMPIRICAL_FORCE_COSINE];
    const double k = 2 * WCUT_PI / v[WCUT_EMPIRICAL_FORCE_WAVELENGTH], turn = k * component(node->x, axis);
    return (part){.value = sine * sin(turn) + cosine * cos(turn),
                  .by_position = along(axis, k * (sine * cos(turn) - cosine * sin(turn)))};
}

/* 1 between two places, with soft edges */
static double soft_window(double at, double from, double to, double edge, double *slope) {
    const double low = tanh((at - from) / edge), high = tanh((at - to) / edge);
    *slope = ((1 - low * low) - (1 - high * high)) / (2 * edge);
    return (low - high) / 2;
}

static part of_band(const double *v, int axis, const wcut_term_node *node) {
    double slope;
    const double value = soft_window(component(node->x, axis), v[WCUT_EMPIRICAL_FORCE_FROM], v[WCUT_EMPIRICAL_FORCE_TO],
                                     v[WCUT_EMPIRICAL_FORCE_EDGE], &slope);
    return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * value,
                  .by_position = along(axis, v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * slope)};
}

/* cos and cos 2 of the angle between the node's motion and an axis */
static part of_direction(const wcut_locality *at, const double *v, int axis, const wcut_term_node *node) {
    const wcut_vec3 move = at->was ? vec3_sub(node->x, at->was[node->i]) : vec3(0, 0, 0);
    const double distance = vec3_length(move);
    if (!(distance > 0)) return (part){.value = 0};
    const wcut_vec3 d = vec3_scale(1 / distance, move);
    const double c = component(d, axis);
    const bool twice = v[WCUT_EMPIRICAL_FORCE_ORDER] > 1.5;
    const double slope = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * (twice ? 4 * c : 1) / distance;
    return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * (twice ? 2 * c * c - 1 : c),
                  .by_position = vec3_add_scaled(along(axis, slope), -slope * c, d)};
}

/* [1/mm] of the wire at a node where the step begins: 2 |(b - a) x (c - b)| / |..|, Menger's */
static double curvature(const wcut_locality *at, const wcut_term_node *node) {
    if (!at->was || node->n < 3) return 0;
    const int i = node->i < 1 ? 1 : node->i > node->n - 2 ? node->n - 2 : node->i;
    const wcut_vec3 back = vec3_sub(at->was[i], at->was[i - 1]), front = vec3_sub(at->was[i + 1], at->was[i]);
    const double span = vec3_length(vec3_add(back, front));
    return 2 * vec3_length(vec3_cross(back, front)) / fmax(vec3_length(back) * vec3_length(front) * span, 1e-300);
}

/* ---- of heat and speed ---- */

/* phi of Q_eff = 1000 q / v and d phi / d Q_eff */
static double of_q_eff(int term, const double *v, double q_eff, double *slope) {
    if (term == WCUT_TERM_HEAT_INVERSE) {
        *slope = -v[WCUT_EMPIRICAL_FORCE_Q_REF] / (q_eff * q_eff);
        return v[WCUT_EMPIRICAL_FORCE_Q_REF] / q_eff - 1;
    }
    const double at = v[WCUT_EMPIRICAL_FORCE_AT], width = v[WCUT_EMPIRICAL_FORCE_WIDTH];
    const double z = (q_eff - at) / width, step = (1 + tanh(z)) / 2;
    if (term == WCUT_TERM_HEAT_STEP) {
        *slope = 2 * step * (1 - step) / width;
        return step;
    }
    /* a corner rounded over the width: its slope is the step */
    const double corner = z > 0 ? z + log1p(exp(-2 * z)) / 2 : log1p(exp(2 * z)) / 2;
    *slope = step / at;
    return corner * width / at;
}

static part of_heat(int term, const double *v, const wcut_term_node *node) {
    const double q_eff = MM_PER_M * node->heat / node->speed;
    double slope;
    const double value = of_q_eff(term, v, q_eff, &slope);
    return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * value,
                  .by_speed = -v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * slope * q_eff / node->speed,
                  .by_heat = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * slope * MM_PER_M / node->speed};
}

/* ---- of time ---- */

/* held less present, the held one at the end of the step: h_1 = y + (h_0 - y) exp(-dt / tau) */
static part of_memory(const wcut_locality *at, int term, const double *v, int memory, const wcut_term_node *node) {
    const wcut_node_state *s = &at->state[node->i];
    if (!s->set || memory >= WCUT_TERM_MEMORIES) return (part){.value = 0};
    const double step = 1 / (node->rate * v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]), keep = exp(-step);
    const bool speed = term == WCUT_TERM_SPEED_MEMORY;
    const double ahead = s->held[memory] - (speed ? ln_speed(node->speed) : log(node->heat));
    part p = {.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * keep * ahead,
              .by_log_rate = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * keep * step * ahead};
    if (speed && node->speed > SLOWEST) p.by_speed = -v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * keep / node->speed;
    if (!speed) p.by_heat = -v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * keep / node->heat;
    return p;
}

/* since the wire entered the foam, at the end of the step */
static part of_entry(const wcut_locality *at, const double *v, const wcut_term_node *node) {
    const double step = 1 / node->rate, value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] *
                                                exp(-(at->age + step) / v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]);
    return (part){.value = value, .by_log_rate = value * step / v[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]};
}

static part of_clock(const wcut_locality *at, int term, const double *v, const wcut_term_node *node) {
    const double step = 1 / node->rate, now = at->clock + step;
    double slope = 0.01, value = (v[WCUT_EMPIRICAL_FORCE_START_TIME] + now) / 100;
    if (term == WCUT_TERM_WINDOW)
        value = soft_window(now, v[WCUT_EMPIRICAL_FORCE_FROM], v[WCUT_EMPIRICAL_FORCE_TO], v[WCUT_EMPIRICAL_FORCE_EDGE],
                            &slope);
    return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * value,
                  .by_log_rate = -v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * slope * step};
}

/* ---- all of them ---- */

static part part_of(const wcut_locality *at, const wcut_effect *e, int memory, const wcut_term_node *node) {
    /* terms of place, direction and heat are groups of consecutive enumerators */
    const double *v = e->value;
    const wcut_term term = (wcut_term)e->choice;
    if (term <= WCUT_TERM_POSITION_Z) return of_position(v, term - WCUT_TERM_POSITION_X, node);
    if (term <= WCUT_TERM_WAVE_Z) return of_wave(v, term - WCUT_TERM_WAVE_X, node);
    if (term <= WCUT_TERM_BAND_Z) return of_band(v, term - WCUT_TERM_BAND_X, node);
    if (term <= WCUT_TERM_DIRECTION_Z) return of_direction(at, v, term - WCUT_TERM_DIRECTION_X, node);
    if (term <= WCUT_TERM_HEAT_INVERSE) return of_heat(term, v, node);

    /* single terms */
    switch (term) {
        case WCUT_TERM_LOG_SPEED:
            return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] *
                                   (ln_speed(node->speed) - log(v[WCUT_EMPIRICAL_FORCE_SPEED_REF])),
                          .by_speed = node->speed > SLOWEST ? v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] / node->speed : 0};
        case WCUT_TERM_CURVATURE:
            return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] * v[WCUT_EMPIRICAL_FORCE_RADIUS] *
                                   curvature(at, node)};
        case WCUT_TERM_ENTRY:
            return of_entry(at, v, node);
        case WCUT_TERM_WAY:
            return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] *
                                   (v[WCUT_EMPIRICAL_FORCE_START] + at->state[node->i].way) /
                                   v[WCUT_EMPIRICAL_FORCE_LENGTH]};
        case WCUT_TERM_ORDER:
            return (part){.value = v[WCUT_EMPIRICAL_FORCE_COEFFICIENT] *
                                   (v[WCUT_EMPIRICAL_FORCE_FIRST] < 0
                                        ? v[WCUT_EMPIRICAL_FORCE_NUMBER]
                                        : v[WCUT_EMPIRICAL_FORCE_NUMBER] >= v[WCUT_EMPIRICAL_FORCE_FIRST] &&
                                              v[WCUT_EMPIRICAL_FORCE_NUMBER] <= v[WCUT_EMPIRICAL_FORCE_LAST])};
        case WCUT_TERM_CLOCK:
        case WCUT_TERM_WINDOW:
            return of_clock(at, term, v, node);
        default:
            return of_memory(at, term, v, memory, node);
    }
}

bool wcut_term_factor_eval(const wcut_locality *at, const wcut_term_node *node, wcut_term_factor *out) {
    /* sum of all terms c phi and its derivatives */
    int terms = 0, memories = 0;
    part sum = {.value = 0};
    for (int k = 0; k < at->count; k++) {
        if (at->effect[k].kind != WCUT_EFFECT_EMPIRICAL_FORCE) continue;
        const part p = part_of(at, &at->effect[k], memories, node);
        memories += wcut_term_remembers(at->effect[k].choice);
        sum.value += p.value, sum.by_speed += p.by_speed, sum.by_log_rate += p.by_log_rate, sum.by_heat += p.by_heat;
        sum.by_position = vec3_add(sum.by_position, p.by_position);
        terms++;
    }
    if (terms == 0) return false;

    /* heat that a lag makes follow speed and time */
    sum.by_speed += sum.by_heat * node->heat_by_speed;
    sum.by_log_rate += sum.by_heat * node->heat_by_log_rate;
    sum.by_position = vec3_add_scaled(sum.by_position, sum.by_heat, node->heat_by_position);

    /* below one half the line goes over into exp(2 s + 1) / 2, which has its value and slope there: a force pushes */
    double slope = 1;
    out->value = 1 + sum.value;
    if (sum.value < -0.5) slope = exp(2 * sum.value + 1), out->value = slope / 2;
    out->by_speed = slope * sum.by_speed, out->by_log_rate = slope * sum.by_log_rate;
    out->by_position = vec3_scale(slope, sum.by_position);

    return true;
}

void wcut_term_remember(const wcut_locality *at, double rate, double speed, double heat, int i, double *held) {
    const wcut_node_state *s = &at->state[i];
    int memories = 0;
    for (int k = 0; k < at->count && memories < WCUT_TERM_MEMORIES; k++) {
        const wcut_effect *e = &at->effect[k];
        if (e->kind != WCUT_EFFECT_EMPIRICAL_FORCE || !wcut_term_remembers(e->choice)) continue;
        const double now = e->choice == WCUT_TERM_SPEED_MEMORY ? ln_speed(speed) : log(heat);
        held[memories] =
            s->set ? now + (s->held[memories] - now) * exp(-1 / (rate * e->value[WCUT_EMPIRICAL_FORCE_TIME_CONSTANT]))
                   : now;
        memories++;
    }
}
