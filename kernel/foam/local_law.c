/* The force law at one node of the wire, with what effects make of coefficient, heat and rate there:
   F = a c_a exp(-b c_b q / v) (v / v_0)^m, every factor 1 where its effect is absent (NOTATION.md, Effects). */
#include "foam/local_law.h"

#include <stddef.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "foam/empirical.h"
#include "foam/force_law.h"

static const wcut_effect *find_local_effect(const wcut_locality *at, wcut_effect_kind kind) {
    for (int e = 0; e < at->count; e++)
        if (at->effect[e].kind == kind) return &at->effect[e];
    return NULL;
}

/* ---- coefficients ---- */

typedef struct factors { /* on a and b, with the gradient of ln c_a */
    double a, b;
    wcut_vec3 by_position;
} factors;

/* [1] residue takes no more than this of a coefficient, however far it grows */
#define FOULING_MIN (-0.95)
/* [1] width of a step of density over the block's length */
#define STEP_WIDTH 0.02

/* a side that turns from -1 to 1 at s, and its slope */
static double side_of(double u, double s, double *slope) {
    const double side = tanh((u - s) / STEP_WIDTH);
    *slope = (1 - side * side) / STEP_WIDTH;
    return side;
}

/* density along an axis: linear, quadratic about the middle, a step or a band; choice is the form times 3 and the axis */
static void add_gradient(const wcut_effect *e, const wcut_block *block, wcut_vec3 x, factors *f) {
    const double at[3] = {x.x, x.y, x.z}, size[3] = {block->size.x, block->size.y, block->size.z};
    const int axis = e->choice % 3, form = e->choice / 3;
    const double g = e->value[WCUT_FOAM_DENSITY_GRADIENT_CHANGE], u = at[axis] / size[axis];
    const double s = e->value[WCUT_FOAM_DENSITY_GRADIENT_STEP_AT];
    const double half = e->value[WCUT_FOAM_DENSITY_GRADIENT_BAND] / 2;
    double shape = u - 0.5, by_u = 1, first, second;

    /* quadratic: from the middle to the faces by g, the same mean; a band lies about s, half of it to either side */
    if (form == 1) {
        shape = (2 * u - 1) * (2 * u - 1) - 1.0 / 3, by_u = 4 * (2 * u - 1);
    } else if (form == 2) {
        shape = side_of(u, s, &first) / 2, by_u = first / 2;
    } else if (form == 3) {
        shape = (side_of(u, s - half, &first) - side_of(u, s + half, &second)) / 2, by_u = (first - second) / 2;
    }
    const double c = 1 + g * shape, slope = g * by_u / size[axis] / c;
    f->a *= c;
    if (axis == 0) f->by_position.x += slope;
    if (axis == 1) f->by_position.y += slope;
    if (axis == 2) f->by_position.z += slope;
}

static void add_inclusion(const wcut_effect *e, wcut_vec3 x, factors *f) {
    const double *at = &e->value[WCUT_FOAM_INCLUSION_POSITION], radius = e->value[WCUT_FOAM_INCLUSION_RADIUS];
    const wcut_vec3 r = vec3_sub(x, vec3(at[0], at[1], at[2]));
    const double square = radius * radius,
                 bump = e->value[WCUT_FOAM_INCLUSION_AMPLITUDE] * exp(-vec3_dot(r, r) / (2 * square));
    f->a *= 1 + bump;
    f->by_position = vec3_add_scaled(f->by_position, -bump / (1 + bump) / square, r);
}

/* growth of residue by the way w of a node over the length l: exponential to a limit, even, by the root, or even until it
   falls off after every l; choice is the form times 2 and the coefficient */
static double fouling_change(const wcut_effect *e, double way) {
    const double share = way / e->value[WCUT_WIRE_FOULING_LENGTH];
    const int form = e->choice / 2;
    const double grown = form == 0   ? -expm1(-share)
                         : form == 1 ? share
                         : form == 2 ? sqrt(share)
                                     : share - floor(share);
    return fmax(e->value[WCUT_WIRE_FOULING_CHANGE] * grown, FOULING_MIN);
}

/* fouling: as far as the node has cut before the step */
static factors coefficients(const wcut_locality *at, const wcut_block *block, wcut_vec3 x, int i) {
    factors f = {1, 1, {0, 0, 0}};
    for (int k = 0; k < at->count; k++) {
        const wcut_effect *e = &at->effect[k];
        if (e->kind == WCUT_EFFECT_FOAM_DENSITY_GRADIENT) add_gradient(e, block, x, &f);
        if (e->kind == WCUT_EFFECT_FOAM_INCLUSION) add_inclusion(e, x, &f);
        if (e->kind == WCUT_EFFECT_WIRE_FOULING)
            *(e->choice % 2 == 0 ? &f.a : &f.b) *=
                1 + fouling_change(e, e->value[WCUT_WIRE_FOULING_START] + at->state[i].way);
    }
    return f;
}

/* ---- heat ---- */

typedef struct power { /* [W/m] and how it changes */
    double value, by_speed, by_log_rate;
    wcut_vec3 by_position;
} power;

static void scale_power(power *q, double factor) {
    q->value *= factor, q->by_speed *= factor, q->by_log_rate *= factor;
    q->by_position = vec3_scale(factor, q->by_position);
}

/* Q (1 + (ratio - 1) exp(-t/tau)), t the wire's time in the foam at the end of the step */
static void overheat(const wcut_effect *e, double age, double rate, power *q) {
    const double tau = e->value[WCUT_AIR_OVERHEATING_TIME_CONSTANT],
                 excess = (e->value[WCUT_AIR_OVERHEATING_RATIO] - 1) * exp(-(age + 1 / rate) / tau);
    const double by_log_rate = excess / tau / rate * q->value;
    scale_power(q, 1 + excess);
    q->by_log_rate += by_log_rate;
}

/* forms of wire_thermal_lag: the wire, the wire with a slower part, the melt */
enum { WCUT_LAG_WIRE, WCUT_LAG_TWO, WCUT_LAG_MELT };

/* [mm/s] a melt is no hotter than at this speed */
#define MELT_SPEED_MIN 1.0

/* Temperatures of a node with C dtheta/dt = Q - H(v) theta over a step. */
typedef struct thermal {
    double loss, loss_by_speed;       /* H [W/mK] */
    double steady, theta;             /* [K] at the end */
    double decay, hold;               /* E = exp(-z), G = (1 - E)/z */
    double theta_by_z, z, z_by_speed; /* z: the step over the time constant */
} thermal;

/* Exact for a steady temperature that changes evenly over the step (first-order hold) and the mean of both losses:
   theta = steady_1 + (theta_0 - steady_0) E - (steady_1 - steady_0) G. tau, from: of the part that is meant. */
static thermal cool_part(const wcut_effect *e, const wcut_node_state *s, double tau, double from, double heat,
                         double rate, double speed) {
    const bool melt = e->choice == WCUT_LAG_MELT;
    const double loss = e->value[WCUT_WIRE_THERMAL_LAG_LOSS], by_speed = e->value[WCUT_WIRE_THERMAL_LAG_LOSS_BY_SPEED];
    const double capacity = tau * (loss + by_speed * e->value[WCUT_WIRE_THERMAL_LAG_SPEED_REF]); /* [J/mK] */
    thermal t = {.loss = loss + by_speed * speed, .loss_by_speed = by_speed};

    /* the melt follows Q / v at one time constant, whatever the speed: H is v itself */
    if (melt) t.loss = fmax(speed, MELT_SPEED_MIN), t.loss_by_speed = speed > MELT_SPEED_MIN;
    t.steady = t.theta = heat / t.loss;
    if (!s->set) return t;
    t.z = melt ? 1 / (tau * rate) : (s->loss + t.loss) / (2 * capacity * rate);
    t.z_by_speed = melt ? 0 : t.loss_by_speed / (2 * capacity * rate);
    t.decay = exp(-t.z);
    t.hold = -expm1(-t.z) / t.z;
    const double ahead = from - s->steady, change = t.steady - s->steady;
    t.theta += ahead * t.decay - change * t.hold;
    t.theta_by_z = -ahead * t.decay - change * (t.decay - t.hold) / t.z;
    return t;
}

static thermal cool(const wcut_effect *e, const wcut_node_state *s, double heat, double rate, double speed) {
    return cool_part(e, s, e->value[WCUT_WIRE_THERMAL_LAG_TIME_CONSTANT], s->theta, heat, rate, speed);
}

static thermal cool_slow(const wcut_effect *e, const wcut_node_state *s, double heat, double rate, double speed) {
    return cool_part(e, s, e->value[WCUT_WIRE_THERMAL_LAG_SLOW_TIME_CONSTANT], s->slow, heat, rate, speed);
}

/* q = H(v) theta of one part reaches the foam, not Q */
static power lagged_power(const thermal *t, const power *q) {
    const double follows = 1 - t->hold; /* d theta / d steady */
    const double steady_by_speed = q->by_speed / t->loss - t->steady * t->loss_by_speed / t->loss;
    return (power){
        .value = t->loss * t->theta,
        .by_speed = t->loss_by_speed * t->theta + t->loss * (follows * steady_by_speed + t->theta_by_z * t->z_by_speed),
        .by_log_rate = follows * q->by_log_rate - t->loss * t->theta_by_z * t->z,
        .by_position = vec3_scale(follows, q->by_position)};
}

/* of two parts: the share of the slow one beside the other */
static void delay_power(const wcut_effect *e, const wcut_node_state *s, double rate, double speed, power *q) {
    const thermal t = cool(e, s, q->value, rate, speed);
    power fast = lagged_power(&t, q);
    if (e->choice == WCUT_LAG_TWO) {
        const thermal u = cool_slow(e, s, q->value, rate, speed);
        power slow = lagged_power(&u, q);
        const double share = e->value[WCUT_WIRE_THERMAL_LAG_SLOW_SHARE];
        scale_power(&fast, 1 - share);
        scale_power(&slow, share);
        fast.value += slow.value, fast.by_speed += slow.by_speed, fast.by_log_rate += slow.by_log_rate;
        fast.by_position = vec3_add(fast.by_position, slow.by_position);
    }
    *q = fast;
}

/* 1 - A (exp(-s_A/l) + exp(-s_B/l)), s the way along the wire to either mount: a rod whose ends are cold; the same of the
   squares of s/l: a draught of air about each mount */
static double cooled_ends(const wcut_effect *e, double edge, int n, int i) {
    double a = edge * i / e->value[WCUT_END_COOLING_LENGTH], b = edge * (n - 1 - i) / e->value[WCUT_END_COOLING_LENGTH];
    if (e->choice == 1) a *= a, b *= b;
    return 1 - e->value[WCUT_END_COOLING_AMPLITUDE] * (exp(-a) + exp(-b));
}

static power supply(const wcut_locality *at, double heat, double rate, int n, int i) {
    power q = {.value = heat};
    const wcut_effect *end = find_local_effect(at, WCUT_EFFECT_END_COOLING),
                      *air = find_local_effect(at, WCUT_EFFECT_AIR_OVERHEATING);
    if (end) scale_power(&q, cooled_ends(end, at->edge, n, i));
    if (air) overheat(air, at->age, rate, &q);
    return q;
}

/* ---- the law ---- */

wcut_local_law wcut_local_law_eval(const wcut_locality *at, const wcut_block *block, const wcut_force_law *law,
                                   double heat, double rate, double speed, int n, wcut_vec3 x, int i) {
    /* coefficients at this place, and the heat that arrives at this node */
    const factors f = coefficients(at, block, x, i);
    power q = supply(at, heat, rate, n, i);
    const wcut_effect *lag = find_local_effect(at, WCUT_EFFECT_WIRE_THERMAL_LAG),
                      *faster = find_local_effect(at, WCUT_EFFECT_RATE_DEPENDENCE);
    if (lag) delay_power(lag, &at->state[i], rate, speed, &q);
    wcut_local_law out = {.heat = q.value};

    /* a node at rest has no force */
    if (!(speed > 0)) return out;

    /* beyond exp(-700) the force is below every double */
    const double b = law->b * f.b * MM_PER_M / speed, exponent = b * q.value;
    if (exponent > 700) return out;
    const double m = faster ? faster->value[WCUT_RATE_DEPENDENCE_EXPONENT] : 0;

    /* (2) with the effects' factors, and its logarithmic derivatives */
    out.force =
        law->a * f.a * exp(-exponent) * (faster ? pow(speed / faster->value[WCUT_RATE_DEPENDENCE_SPEED_REF], m) : 1);
    out.by_speed = out.force * ((exponent + m) / speed - b * q.by_speed);
    out.by_log_rate = -out.force * b * q.by_log_rate;
    out.by_position = vec3_scale(out.force, vec3_add_scaled(f.by_position, -b, q.by_position));

    /* what the dictionary multiplies it by */
    wcut_term_factor term;
    const wcut_term_node node = {block, x, n, i, rate, speed, q.value, q.by_speed, q.by_log_rate, q.by_position};
    if (!wcut_term_factor_eval(at, &node, &term)) return out;

    /* product rule: force times the factor of the terms */
    const double plain = out.force;
    out.force *= term.value;
    out.by_speed = out.by_speed * term.value + plain * term.by_speed;
    out.by_log_rate = out.by_log_rate * term.value + plain * term.by_log_rate;
    out.by_position = vec3_add_scaled(vec3_scale(term.value, out.by_position), plain, term.by_position);

    return out;
}

wcut_node_state wcut_node_state_after(const wcut_locality *at, double heat, double rate, double speed, double inside,
                                      int n, int i) {
    wcut_node_state state = {.set = true, .way = at->state[i].way + inside * speed / rate};
    const wcut_effect *lag = find_local_effect(at, WCUT_EFFECT_WIRE_THERMAL_LAG);
    power q = supply(at, heat, rate, n, i);
    if (!lag) {
        wcut_term_remember(at, rate, speed, q.value, i, state.held);
        return state;
    }
    const thermal t = cool(lag, &at->state[i], q.value, rate, speed);
    if (lag->choice == WCUT_LAG_TWO) state.slow = cool_slow(lag, &at->state[i], q.value, rate, speed).theta;
    delay_power(lag, &at->state[i], rate, speed, &q);
    wcut_term_remember(at, rate, speed, q.value, i, state.held);
    state.theta = t.theta, state.steady = t.steady, state.loss = t.loss;
    return state;
}

bool wcut_locality_slice(const wcut_locality *at, double *ratio, double *exponent) {
    const wcut_effect *slice = find_local_effect(at, WCUT_EFFECT_SLICE_SOFTENING);
    if (!slice) return false;
    *ratio = slice->value[WCUT_SLICE_SOFTENING_RATIO], *exponent = slice->value[WCUT_SLICE_SOFTENING_EXPONENT];
    return true;
}

bool wcut_locality_drag(const wcut_locality *at, wcut_drag *drag) {
    const wcut_effect *e = find_local_effect(at, WCUT_EFFECT_TANGENTIAL_DRAG);
    if (!e) return false;
    *drag = (wcut_drag){(wcut_drag_law)e->choice, e->value[WCUT_TANGENTIAL_DRAG_FRICTION],
                        e->value[WCUT_TANGENTIAL_DRAG_SPEED_SMOOTH]};
    return true;
}
