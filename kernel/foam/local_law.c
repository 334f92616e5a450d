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

/* [1] width of a step of density over the block's length */
#define STEP_WIDTH 0.02

/* density along an axis: linear, quadratic about the middle, or a step; choice is the form times 3 and the axis */
static void add_gradient(const wcut_effect *e, const wcut_block *block, wcut_vec3 x, factors *f) {
    const double at[3] = {x.x, x.y, x.z}, size[3] = {block->size.x, block->size.y, block->size.z};
    const int axis = e->choice % 3, form = e->choice / 3;
    const double g = e->value[WCUT_FOAM_DENSITY_GRADIENT_CHANGE], u = at[axis] / size[axis];
    double shape = u - 0.5, by_u = 1;
    if (form == 1) {
        /* from the middle to the faces by g, the same mean */
        shape = (2 * u - 1) * (2 * u - 1) - 1.0 / 3, by_u = 4 * (2 * u - 1);
    } else if (form == 2) {
        const double side = tanh((u - e->value[WCUT_FOAM_DENSITY_GRADIENT_STEP_AT]) / STEP_WIDTH);
        shape = side / 2, by_u = (1 - side * side) / (2 * STEP_WIDTH);
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

/* fouling: as far as the node has cut before the step */
static factors coefficients(const wcut_locality *at, const wcut_block *block, wcut_vec3 x, int i) {
    factors f = {1, 1, {0, 0, 0}};
    for (int k = 0; k < at->count; k++) {
        const wcut_effect *e = &at->effect[k];
        if (e->kind == WCUT_EFFECT_FOAM_DENSITY_GRADIENT) add_gradient(e, block, x, &f);
        if (e->kind == WCUT_EFFECT_FOAM_INCLUSION) add_inclusion(e, x, &f);
        if (e->kind == WCUT_EFFECT_WIRE_FOULING) {
            const double change =
                e->value[WCUT_WIRE_FOULING_CHANGE] *
                -expm1(-(e->value[WCUT_WIRE_FOULING_START] + at->state[i].way) / e->value[WCUT_WIRE_FOULING_LENGTH]);
            *(e->choice == 0 ? &f.a : &f.b) *= 1 + change;
        }
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

/* Temperatures of a node with C dtheta/dt = Q - H(v) theta over a step. */
typedef struct thermal {
    double loss, loss_by_speed;       /* H [W/mK] */
    double steady, theta;             /* [K] at the end */
    double decay, hold;               /* E = exp(-z), G = (1 - E)/z */
    double theta_by_z, z, z_by_speed; /* z: the step over the time constant */
} thermal;

/* Exact for a steady temperature that changes evenly over the step (first-order hold) and the mean of both losses:
   theta = steady_1 + (theta_0 - steady_0) E - (steady_1 - steady_0) G. */
static thermal cool(const wcut_effect *e, const wcut_node_state *s, double heat, double rate, double speed) {
    const double loss = e->value[WCUT_WIRE_THERMAL_LAG_LOSS], by_speed = e->value[WCUT_WIRE_THERMAL_LAG_LOSS_BY_SPEED];
    const double capacity = e->value[WCUT_WIRE_THERMAL_LAG_TIME_CONSTANT] *
                            (loss + by_speed * e->value[WCUT_WIRE_THERMAL_LAG_SPEED_REF]); /* [J/mK] */
    thermal t = {.loss = loss + by_speed * speed, .loss_by_speed = by_speed};
    t.steady = t.theta = heat / t.loss;
    if (!s->set) return t;
    t.z = (s->loss + t.loss) / (2 * capacity * rate);
    t.z_by_speed = t.loss_by_speed / (2 * capacity * rate);
    t.decay = exp(-t.z);
    t.hold = -expm1(-t.z) / t.z;
    const double ahead = s->theta - s->steady, change = t.steady - s->steady;
    t.theta += ahead * t.decay - change * t.hold;
    t.theta_by_z = -ahead * t.decay - change * (t.decay - t.hold) / t.z;
    return t;
}

/* q = H(v) theta reaches the foam, not Q */
static void delay_power(const wcut_effect *e, const wcut_node_state *s, double rate, double speed, power *q) {
    const thermal t = cool(e, s, q->value, rate, speed);
    const double follows = 1 - t.hold; /* d theta / d steady */
    const double steady_by_speed = q->by_speed / t.loss - t.steady * t.loss_by_speed / t.loss;
    q->by_speed = t.loss_by_speed * t.theta + t.loss * (follows * steady_by_speed + t.theta_by_z * t.z_by_speed);
    q->by_log_rate = follows * q->by_log_rate - t.loss * t.theta_by_z * t.z;
    q->by_position = vec3_scale(follows, q->by_position);
    q->value = t.loss * t.theta;
}

/* 1 - A (exp(-s_A/l) + exp(-s_B/l)), s the way along the wire to either mount: a rod whose ends are cold */
static double cooled_ends(const wcut_effect *e, double edge, int n, int i) {
    const double length = e->value[WCUT_END_COOLING_LENGTH];
    return 1 - e->value[WCUT_END_COOLING_AMPLITUDE] * (exp(-edge * i / length) + exp(-edge * (n - 1 - i) / length));
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
    delay_power(lag, &at->state[i], rate, speed, &q);
    wcut_term_remember(at, rate, speed, q.value, i, state.held);
    state.theta = t.theta, state.steady = t.steady, state.loss = t.loss;
    return state;
}

bool wcut_locality_drag(const wcut_locality *at, double *mu, double *smooth) {
    const wcut_effect *drag = find_local_effect(at, WCUT_EFFECT_TANGENTIAL_DRAG);
    if (!drag) return false;
    *mu = drag->value[WCUT_TANGENTIAL_DRAG_FRICTION], *smooth = drag->value[WCUT_TANGENTIAL_DRAG_SPEED_SMOOTH];
    return true;
}
