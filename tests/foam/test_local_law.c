/* The force law with effects at one node: closed forms, and every derivative against central differences.
   labels: unit property */

#include "base/numbers.h"
#include "base/random.h"
#include "foam/empirical.h"
#include "foam/local_law.h"
#include "foam/resistance.h"
#include "test.h"

enum { N = 5 };

static const wcut_force_law law = {0.1, 8.6e-4};
static const wcut_block block = {.size = {400, 600, 300}, .depth = 0.15};
static const double heat = 65, edge = 5;

static wcut_node_state state[N];
static wcut_vec3 x[N], was[N];

static wcut_effect effect_of(wcut_effect_kind kind, double a, double b, int choice) {
    wcut_effect e = wcut_effect_default(kind);
    e.value[0] = a, e.choice = choice;
    if (b > 0) e.value[1] = b;
    return e;
}

static wcut_locality locality(int count, const wcut_effect *e) {
    return (wcut_locality){
        .count = count, .effect = e, .state = state, .edge = edge, .age = 0.3, .clock = 12, .was = was};
}

static double plain_law(double q, double v) { return law.a * exp(-law.b * q * 1000 / v); }

static double law_of(wcut_effect e, double speed, wcut_vec3 at, int i) {
    const wcut_locality l = locality(1, &e);
    return wcut_local_law_eval(&l, &block, &law, heat, 5, speed, N, at, i).force;
}

TEST(without_memory_every_effect_is_its_formula) {
    const wcut_vec3 at = vec3(100, 450, 30);
    const double f = plain_law(heat, 20);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.4, 0, 0), 20, at, 2) / f, 0.9, 1e-15);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.4, 0, 1), 20, at, 2) / f, 1.1, 1e-15);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.4, 0, 2), 20, at, 2) / f, 0.84,
                            1e-15);
    wcut_effect e = effect_of(WCUT_EFFECT_FOAM_INCLUSION, 0.5, 40, 0);
    e.value[2] = 100, e.value[3] = 450, e.value[4] = 70; /* one radius away */
    ck_assert_double_eq_tol(law_of(e, 20, at, 2) / f, 1 + 0.5 * exp(-0.5), 1e-15);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_RATE_DEPENDENCE, 0.3, 10, 0), 20, at, 2) / f, pow(2, 0.3),
                            1e-15);
    e = effect_of(WCUT_EFFECT_WIRE_FOULING, 0.2, 500, 0);
    state[2].way = 300;
    ck_assert_double_eq_tol(law_of(e, 20, at, 2) / f, 1 + 0.2 * (1 - exp(-0.6)), 1e-15);
    e.value[2] = 200; /* it had cut 200 mm before */
    ck_assert_double_eq_tol(law_of(e, 20, at, 2) / f, 1 + 0.2 * (1 - exp(-1)), 1e-15);
    e.choice = 1;
    const double b = law.b * (1 + 0.2 * (1 - exp(-1)));
    ck_assert_double_eq_tol(law_of(e, 20, at, 2), law.a * exp(-b * heat * 50), 1e-16);
    e = effect_of(WCUT_EFFECT_END_COOLING, 0.3, 8, 0);
    for (int i = 0; i < N; i++) {
        const double q = heat * (1 - 0.3 * (exp(-i * edge / 8) + exp(-(N - 1 - i) * edge / 8)));
        ck_assert_double_eq_tol(law_of(e, 20, at, i), plain_law(q, 20), 1e-16);
    }
}

TEST(every_form_of_a_family_is_its_formula) {
    const wcut_vec3 at = vec3(100, 450, 30);
    const double f = plain_law(heat, 20);

    // a band half of 0.2 to either side of 0.75 of the length: the node lies in its middle; and at its side
    wcut_effect e = effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.4, 0.75, 10);
    e.value[WCUT_FOAM_DENSITY_GRADIENT_BAND] = 0.2;
    ck_assert_double_eq_tol(law_of(e, 20, at, 2) / f, 1 + 0.4 * tanh(0.1 / 0.02), 1e-12);
    e.value[1] = 0.65;
    ck_assert_double_eq_tol(law_of(e, 20, at, 2) / f, 1 + 0.2 * tanh(0.2 / 0.02), 1e-12);
    e.value[1] = 0.2;
    ck_assert_double_eq_tol(law_of(e, 20, at, 2) / f, 1, 1e-12);

    // residue after 300 mm: even, by the root, and even until it falls off
    state[2] = (wcut_node_state){.way = 300};
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_WIRE_FOULING, 0.2, 500, 2), 20, at, 2) / f, 1.12, 1e-14);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_WIRE_FOULING, 0.2, 500, 4), 20, at, 2) / f,
                            1 + 0.2 * sqrt(0.6), 1e-14);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_WIRE_FOULING, 0.2, 120, 6), 20, at, 2) / f, 1.1, 1e-14);
    ck_assert_double_eq_tol(law_of(effect_of(WCUT_EFFECT_WIRE_FOULING, -0.9, 100, 2), 20, at, 2) / f, 0.05, 1e-14);
    e = effect_of(WCUT_EFFECT_WIRE_FOULING, 0.2, 500, 3);
    ck_assert_double_eq_tol(law_of(e, 20, at, 2), law.a * exp(-law.b * 1.12 * heat * 50), 1e-16);

    // gaussian ends
    e = effect_of(WCUT_EFFECT_END_COOLING, 0.3, 8, 1);
    for (int i = 0; i < N; i++) {
        const double a = i * edge / 8, b = (N - 1 - i) * edge / 8;
        ck_assert_double_eq_tol(law_of(e, 20, at, i), plain_law(heat * (1 - 0.3 * (exp(-a * a) + exp(-b * b))), 20),
                                1e-16);
    }
}

TEST(overheated_wire_cools_with_its_time_in_the_foam) {
    const wcut_effect e = effect_of(WCUT_EFFECT_AIR_OVERHEATING, 1.6, 0.8, 0);
    const wcut_locality l = locality(1, &e);
    const wcut_local_law at = wcut_local_law_eval(&l, &block, &law, heat, 5, 20, N, vec3(9, 9, 9), 1);
    ck_assert_double_eq_tol(at.heat, heat * (1 + 0.6 * exp(-0.5 / 0.8)), 1e-12);
    ck_assert_double_eq_tol(at.force, plain_law(at.heat, 20), 1e-16);
}

TEST(a_node_has_cut_as_far_as_it_moved_in_the_foam) {
    const wcut_effect e = effect_of(WCUT_EFFECT_WIRE_FOULING, 0.2, 500, 0);
    const wcut_locality l = locality(1, &e);
    state[1] = (wcut_node_state){.set = true, .way = 7};
    ck_assert_double_eq_tol(wcut_node_state_after(&l, heat, 5, 20, 0.25, N, 1).way, 8, 1e-15);
    ck_assert_double_eq_tol(wcut_node_state_after(&l, heat, 5, 20, 0, N, 1).way, 7, 1e-15);
}

/* heat that reaches the foam after `time` in so many steps at a given speed, from the steady state of another */
static double lagged(const wcut_effect *e, double from, double to, double time, int steps) {
    const wcut_vec3 zero = {0, 0, 0};
    wcut_locality l = locality(1, e);
    state[1] = (wcut_node_state){0};
    state[1] = wcut_node_state_after(&l, heat, 10, from, 1, N, 1);
    double q = 0;
    for (int k = 0; k < steps; k++) {
        const double rate = steps / time;
        q = wcut_local_law_eval(&l, &block, &law, heat, rate, to, N, zero, 1).heat;
        wcut_node_state next = wcut_node_state_after(&l, heat, rate, to, 1, N, 1);
        if (k == 0) { /* the speed jumps before the first step, not along it: no first-order hold across it */
            const double loss = e->value[2] + e->value[3] * to,
                         tau = e->value[0] * (e->value[2] + e->value[3] * e->value[1]) / loss;
            next.theta = heat / loss + (state[1].theta - heat / loss) * exp(-1 / (rate * tau));
            q = loss * next.theta;
        }
        state[1] = next;
    }
    return q;
}

TEST(a_held_speed_lets_the_lag_run_out_as_one_exponential_however_it_is_stepped) {
    const wcut_effect e = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.4, 0, 0);
    const double h0 = e.value[2], h1 = e.value[3], slow = h0 + 10 * h1, fast = h0 + 25 * h1;
    const double tau = 0.4 * slow / fast; /* C / H(25), tau being C / H(10) */
    for (int steps = 1; steps <= 64; steps *= 4) {
        const double q = lagged(&e, 10, 25, 0.3, steps);
        /* theta from Q/H(10) to Q/H(25); the foam gets H(25) theta: more than Q at first */
        ck_assert_double_eq_tol(q, heat * (1 + (fast / slow - 1) * exp(-0.3 / tau)), 1e-10);
    }
    ck_assert_double_eq_tol(lagged(&e, 10, 25, 30, 8), heat, 1e-10);
}

/* heat jumps at one speed and is held: what reaches the foam after `time`, in so many steps */
static double after_a_jump(const wcut_effect *e, double from, double to, double time, int steps) {
    const wcut_locality l = locality(1, e);
    const double rate = steps / time;
    state[1] = (wcut_node_state){0};
    state[1] = wcut_node_state_after(&l, from, 10, 10, 1, N, 1);

    // the jump itself takes no time
    state[1] = wcut_node_state_after(&l, to, 1e12, 10, 1, N, 1);
    for (int k = 1; k < steps; k++) state[1] = wcut_node_state_after(&l, to, rate, 10, 1, N, 1);
    return wcut_local_law_eval(&l, &block, &law, to, rate, 10, N, x[1], 1).heat;
}

TEST(two_time_constants_are_two_exponentials_and_the_melt_is_one_at_any_speed) {
    wcut_effect e = wcut_effect_choose(WCUT_EFFECT_WIRE_THERMAL_LAG, 1);
    e.value[0] = 0.2, e.value[WCUT_WIRE_THERMAL_LAG_SLOW_SHARE] = 0.38;
    e.value[WCUT_WIRE_THERMAL_LAG_SLOW_TIME_CONSTANT] = 7.2;
    for (int steps = 1; steps <= 64; steps *= 4)
        ck_assert_double_eq_tol(after_a_jump(&e, 60, 80, 1.5, steps),
                                80 - 20 * (0.62 * exp(-1.5 / 0.2) + 0.38 * exp(-1.5 / 7.2)), 1e-9);

    // without a slow share it is the wire's own lag
    e.value[WCUT_WIRE_THERMAL_LAG_SLOW_SHARE] = 0;
    const wcut_effect one = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.2, 0, 0);
    ck_assert_double_eq_tol(after_a_jump(&e, 60, 80, 0.3, 4), after_a_jump(&one, 60, 80, 0.3, 4), 1e-12);

    // the melt: Q / v follows with the time constant, at twice the speed as well
    const wcut_effect melt = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.5, 0, 2);
    const wcut_locality l = locality(1, &melt);
    ck_assert_double_eq_tol(after_a_jump(&melt, 60, 80, 0.9, 4), 80 - 20 * exp(-0.9 / 0.5), 1e-9);
    state[1] = (wcut_node_state){0};
    state[1] = wcut_node_state_after(&l, heat, 10, 10, 1, N, 1);
    state[1] = wcut_node_state_after(&l, heat, 1e12, 20, 1, N, 1);
    for (int k = 0; k < 3; k++) state[1] = wcut_node_state_after(&l, heat, 10, 20, 1, N, 1);
    const double q = wcut_local_law_eval(&l, &block, &law, heat, 10, 20, N, x[1], 1).heat;
    ck_assert_double_eq_tol(q, heat * (1 + exp(-0.4 / 0.5)), 1e-9); /* Q / v halves: v (Q/v) from 2 Q to Q */
}

TEST(an_even_change_of_heat_is_followed_exactly_behind_by_the_time_constant) {
    /* at one speed, theta obeys C theta' = Q - H theta: for Q = Q0 + p t it trails by tau p / H once settled */
    const wcut_effect e = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.5, 0, 0);
    const wcut_vec3 zero = {0, 0, 0};
    const wcut_locality l = locality(1, &e);
    for (double step = 0.05; step < 1; step *= 3) {
        state[1] = (wcut_node_state){0};
        double q = 60, reached = 0;
        state[1] = wcut_node_state_after(&l, q, 1 / step, 10, 1, N, 1);
        for (double t = 0; t < 8; t += step) {
            q += 3 * step;
            reached = wcut_local_law_eval(&l, &block, &law, q, 1 / step, 10, N, zero, 1).heat;
            state[1] = wcut_node_state_after(&l, q, 1 / step, 10, 1, N, 1);
        }
        ck_assert_double_eq_tol(reached, q - 3 * 0.5, 1e-5);
    }
}

TEST(drag_pulls_back_along_the_wire_by_mu_times_what_presses) {
    const wcut_effect e = effect_of(WCUT_EFFECT_TANGENTIAL_DRAG, 0.25, 0, 0);
    const wcut_locality l = locality(1, &e);
    const wcut_foam plain = {.law = law, .block = block}, dragging = {.law = law, .block = block, .local = &l};
    for (int i = 0; i < N; i++) x[i] = vec3(100 + 5 * i, 50, 150), was[i] = vec3(100 + 5 * i - 1, 46, 150);
    wcut_resistance a, b;
    wcut_resistance_eval(&plain, heat, edge, 5, N, x, was, 2, false, &a);
    wcut_resistance_eval(&dragging, heat, edge, 5, N, x, was, 2, false, &b);
    const wcut_vec3 drag = vec3_sub(b.force, a.force);
    ck_assert_double_eq_tol(drag.x, -0.25 * fabs(a.force.y) * tanh(5 / 0.3), 1e-15); /* y is across the wire */
    ck_assert(fabs(drag.y) < 1e-17 && fabs(drag.z) < 1e-17);

    // of a film: as much as the speed along the wire, 5 mm/s, is of 4
    const wcut_effect film = effect_of(WCUT_EFFECT_TANGENTIAL_DRAG, 0.25, 4, 1);
    const wcut_locality thin = locality(1, &film);
    const wcut_foam smeared = {.law = law, .block = block, .local = &thin};
    wcut_resistance_eval(&smeared, heat, edge, 5, N, x, was, 2, false, &b);
    ck_assert_double_eq_tol(b.force.x - a.force.x, -0.25 * fabs(a.force.y) * 5 / 4, 1e-15);
    ck_assert_double_eq(a.line, b.line);
}

TEST(sliding_along_the_wire_softens_the_force_by_its_ratio_to_the_advance) {
    /* 1 mm along and 4 mm across: xi = 1/4, F / (1 + (xi / xi_0)^2)^m */
    const wcut_effect e = effect_of(WCUT_EFFECT_SLICE_SOFTENING, 0.5, 2, 0);
    const wcut_locality l = locality(1, &e);
    const wcut_foam plain = {.law = law, .block = block}, soft = {.law = law, .block = block, .local = &l};
    for (int i = 0; i < N; i++) x[i] = vec3(100 + 5 * i, 50, 150), was[i] = vec3(100 + 5 * i - 1, 46, 150);
    wcut_resistance a, b;
    wcut_resistance_eval(&plain, heat, edge, 5, N, x, was, 2, false, &a);
    wcut_resistance_eval(&soft, heat, edge, 5, N, x, was, 2, false, &b);
    const double expected = pow(1.25, -2);
    ck_assert_double_eq_tol(b.force.y / a.force.y, expected, 1e-14);
    ck_assert_double_eq_tol(b.force.x / a.force.x, expected, 1e-14);
    ck_assert_double_eq_tol(b.line / a.line, expected, 1e-14);

    /* across alone nothing changes */
    for (int i = 0; i < N; i++) was[i].x = x[i].x;
    wcut_resistance_eval(&plain, heat, edge, 5, N, x, was, 2, false, &a);
    wcut_resistance_eval(&soft, heat, edge, 5, N, x, was, 2, false, &b);
    ck_assert(a.force.y == b.force.y);
}

/* ---- derivatives ---- */

static void given_a_moving_wire(wcut_random *random) {
    for (int i = 0; i < N; i++) {
        x[i] = vec3(200 + (i - 2) * 4.6 + wcut_random_uniform(random), 1 + 2 * wcut_random_uniform(random),
                    150 + 2 * wcut_random_uniform(random));
        was[i] = vec3_sub(x[i], vec3(wcut_random_uniform(random) - 0.5, 3 + 2 * wcut_random_uniform(random),
                                     wcut_random_uniform(random) - 0.5));
        state[i] = (wcut_node_state){.set = true, .way = 40, .slow = 300, .loss = 0.2, .held = {2.2, 4}};
        state[i].theta = 280 + 60 * wcut_random_uniform(random);
        state[i].steady = 280 + 60 * wcut_random_uniform(random);
    }
}

static wcut_vec3 force_at(const wcut_foam *foam, double log_rate, int i) {
    wcut_resistance r;
    wcut_resistance_eval(foam, heat, edge, exp(log_rate), N, x, was, i, false, &r);
    return r.force;
}

static double difference(wcut_vec3 high, wcut_vec3 low, double h, mat3 given, int c) {
    const wcut_vec3 d = vec3_scale(1 / (2 * h), vec3_sub(high, low));
    const double column[3] = {c == 0   ? given.x.x
                              : c == 1 ? given.x.y
                                       : given.x.z,
                              c == 0   ? given.y.x
                              : c == 1 ? given.y.y
                                       : given.y.z,
                              c == 0   ? given.z.x
                              : c == 1 ? given.z.y
                                       : given.z.z};
    return vec3_distance(d, vec3(column[0], column[1], column[2]));
}

/* largest error of the force's derivatives under some effects, over random short wires */
static double worst_derivative(int count, const wcut_effect *e, unsigned seed) {
    const wcut_locality l = locality(count, e);
    const wcut_foam foam = {.law = law, .block = {.size = {400, 600, 300}, .depth = 3}, .local = &l};
    wcut_random random = wcut_random_seed(seed);
    double worst = 0;
    for (int trial = 0; trial < 60; trial++) {
        given_a_moving_wire(&random);
        for (int i = 0; i < N; i++) {
            const double log_rate = 1.5, h = 1e-5;
            wcut_resistance r;
            wcut_resistance_eval(&foam, heat, edge, exp(log_rate), N, x, was, i, true, &r);
            const wcut_vec3 rate =
                vec3_scale(1 / (2 * h), vec3_sub(force_at(&foam, log_rate + h, i), force_at(&foam, log_rate - h, i)));
            worst = fmax(worst, vec3_distance(rate, r.by_log_rate));
            for (int k = i > 0 ? i - 1 : i; k <= i + 1 && k < N; k++)
                for (int c = 0; c < 3; c++) {
                    double *component = &x[k].x + c, at = *component;
                    *component = at + h;
                    const wcut_vec3 high = force_at(&foam, log_rate, i);
                    *component = at - h;
                    const wcut_vec3 low = force_at(&foam, log_rate, i);
                    *component = at;
                    const mat3 given = k < i ? r.by_before : k > i ? r.by_after : r.by_here;
                    worst = fmax(worst, difference(high, low, h, given, c));
                }
        }
    }
    return worst;
}

TEST(all_effects_at_once_have_exact_derivatives) {
    const wcut_effect e[10] = {
        effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.8, 0, 1),  effect_of(WCUT_EFFECT_FOAM_INCLUSION, 0.7, 20, 0),
        effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, -0.8, 0, 2), effect_of(WCUT_EFFECT_RATE_DEPENDENCE, -0.3, 0, 0),
        effect_of(WCUT_EFFECT_WIRE_FOULING, 0.3, 0, 1),           effect_of(WCUT_EFFECT_END_COOLING, 0.4, 9, 0),
        effect_of(WCUT_EFFECT_AIR_OVERHEATING, 1.5, 0.7, 0),      effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3, 0, 0),
        effect_of(WCUT_EFFECT_TANGENTIAL_DRAG, 0.5, 2, 0),        effect_of(WCUT_EFFECT_SLICE_SOFTENING, 0.4, 1.3, 0)};
    wcut_effect given[10];
    for (int k = 0; k < 10; k++) given[k] = e[k];
    given[1].value[2] = 195, given[1].value[3] = 10, given[1].value[4] = 140;
    ck_assert_double_lt(worst_derivative(10, given, 3), 1e-7);
}

TEST(every_form_has_exact_derivatives) {
    wcut_effect e[4] = {
        effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.8, 0.5, 9), effect_of(WCUT_EFFECT_TANGENTIAL_DRAG, 0.3, 20, 1),
        effect_of(WCUT_EFFECT_END_COOLING, 0.4, 9, 1), wcut_effect_choose(WCUT_EFFECT_WIRE_THERMAL_LAG, 1)};
    e[0].value[WCUT_FOAM_DENSITY_GRADIENT_BAND] = 0.02;
    e[3].value[0] = 0.3, e[3].value[WCUT_WIRE_THERMAL_LAG_SLOW_TIME_CONSTANT] = 2;
    ck_assert_double_lt(worst_derivative(4, e, 3), 1e-7);
    e[3] = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3, 0, 2);
    ck_assert_double_lt(worst_derivative(4, e, 4), 1e-7);
}

/* ---- empirical terms ---- */

static wcut_effect term_of(wcut_term term, double c, double shape0, double shape1, double shape2) {
    wcut_effect e = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, term);
    const double shape[3] = {shape0, shape1, shape2};
    e.value[0] = c;
    for (int k = 0; k < 3; k++)
        if (shape[k] != 0) e.value[WCUT_EMPIRICAL_FORCE_SHAPE + k] = shape[k];
    return e;
}

static double factor_of(wcut_effect e, double speed, wcut_vec3 at, int i) {
    return law_of(e, speed, at, i) / plain_law(heat, speed);
}

TEST(every_empirical_term_is_its_formula) {
    const wcut_vec3 at = vec3(100, 450, 30);
    for (int i = 0; i < N; i++) was[i] = vec3(100 + 5 * i, 447, 26), state[i] = (wcut_node_state){0};
    was[2] = vec3(100, 447, 26); /* moved by (0, 3, 4) */
    const double q = 1000 * heat / 20;
    const struct {
        wcut_effect effect;
        double phi;
    } given[] = {{term_of(WCUT_TERM_POSITION_X, 0.2, 1, 0, 0), -0.5},
                 {term_of(WCUT_TERM_POSITION_Y, 0.2, 2, 0, 0), (3 * 0.25 - 1) / 2},
                 {term_of(WCUT_TERM_POSITION_Z, 0.2, 3, 0, 0), (5 * -0.512 + 3 * 0.8) / 2},
                 {term_of(WCUT_TERM_POSITION_Y, 0.2, 4, 0, 0), (35 * 0.0625 - 30 * 0.25 + 3) / 8},
                 {term_of(WCUT_TERM_WAVE_Y, 0.2, 72, 0, 0), sin(2 * WCUT_PI * 450 / 72)},
                 {term_of(WCUT_TERM_BAND_Y, 0.2, 400, 500, 5), 1},
                 {term_of(WCUT_TERM_BAND_X, 0.2, 100, 500, 5), 0.5},
                 {term_of(WCUT_TERM_DIRECTION_Z, 0.2, 1, 0, 0), 0.8},
                 {term_of(WCUT_TERM_DIRECTION_Z, 0.2, 2, 0, 0), 2 * 0.64 - 1},
                 {term_of(WCUT_TERM_HEAT_STEP, 0.2, q, 200, 0), 0.5},
                 {term_of(WCUT_TERM_HEAT_HINGE, 0.2, q / 2, 10, 0), 1},
                 {term_of(WCUT_TERM_HEAT_INVERSE, 0.2, 2 * q, 0, 0), 1},
                 {term_of(WCUT_TERM_LOG_SPEED, 0.2, 10, 0, 0), log(2)},
                 {term_of(WCUT_TERM_ENTRY, 0.2, 2, 0, 0), exp(-0.25)},
                 {term_of(WCUT_TERM_CLOCK, 0.2, 30, 0, 0), 0.422},
                 {term_of(WCUT_TERM_ORDER, 0.2, 3, 0, 0), 3},
                 {term_of(WCUT_TERM_ORDER, 0.2, 3, 2, 4), 1},
                 {term_of(WCUT_TERM_ORDER, 0.2, 3, 4, 5), 0},
                 {term_of(WCUT_TERM_WINDOW, 0.2, 12.2, 40, 0.2), 0.5},
                 {term_of(WCUT_TERM_WINDOW, 0.2, 20, 40, 0.2), 0}};
    for (size_t k = 0; k < sizeof given / sizeof *given; k++) {
        const double factor = factor_of(given[k].effect, 20, at, 2);
        const char *name = wcut_term_name[given[k].effect.choice];
        const double s = 0.2 * given[k].phi, expected = s > -0.5 ? 1 + s : exp(2 * s + 1) / 2;
        ck_assert_msg(fabs(factor - expected) < 1e-8, "%s: %.15g for %.15g", name, factor, expected);
    }
    wcut_effect wave = term_of(WCUT_TERM_WAVE_Z, 0, 72, 0, 0);
    wave.value[WCUT_EMPIRICAL_FORCE_COSINE] = 0.3;
    ck_assert_double_eq_tol(factor_of(wave, 20, at, 2), 1 + 0.3 * cos(2 * WCUT_PI * 30 / 72), 1e-12);
    state[2].way = 300;
    ck_assert_double_eq_tol(factor_of(term_of(WCUT_TERM_WAY, 0.2, 1000, 200, 0), 20, at, 2), 1.1, 1e-12);
    /* three nodes on a circle of radius 50 */
    for (int i = 0; i < N; i++) was[i] = vec3(50 * cos(0.1 * i), 50 * sin(0.1 * i), 0);
    ck_assert_double_eq_tol(factor_of(term_of(WCUT_TERM_CURVATURE, 0.2, 100, 0, 0), 20, at, 2), 1.4, 1e-10);
    /* however large, a force does not pull */
    const double deep = factor_of(term_of(WCUT_TERM_POSITION_X, 10, 1, 0, 0), 20, at, 2);
    ck_assert(deep > 0 && deep < 1e-3);
}

TEST(a_memory_runs_out_as_one_exponential_however_it_is_stepped) {
    const wcut_effect e = term_of(WCUT_TERM_SPEED_MEMORY, 0.2, 1.5, 0, 0);
    wcut_locality l = locality(1, &e);
    for (int steps = 1; steps <= 64; steps *= 4) {
        state[1] = (wcut_node_state){0};
        state[1] = wcut_node_state_after(&l, heat, 10, 10, 1, N, 1);
        double factor = 1;
        for (int k = 0; k < steps; k++) {
            factor =
                wcut_local_law_eval(&l, &block, &law, heat, steps / 0.9, 20, N, x[1], 1).force / plain_law(heat, 20);
            state[1] = wcut_node_state_after(&l, heat, steps / 0.9, 20, 1, N, 1);
        }
        ck_assert_double_eq_tol(factor, 1 + 0.2 * log(0.5) * exp(-0.6), 1e-12);
    }
}

TEST(every_empirical_term_has_exact_derivatives) {
    const wcut_effect lag = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3, 0, 0);
    for (int term = 0; term < WCUT_TERM_COUNT; term++) {
        wcut_effect e[2] = {wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, term), lag};
        e[0].value[0] = 0.4;
        if (term >= WCUT_TERM_WAVE_X && term <= WCUT_TERM_WAVE_Z) e[0].value[1] = -0.3, e[0].value[2] = 20;
        if (term >= WCUT_TERM_BAND_X && term <= WCUT_TERM_BAND_Z)
            e[0].value[2] = term == WCUT_TERM_BAND_X ? 198 : term == WCUT_TERM_BAND_Y ? 2 : 151, e[0].value[3] = 300;
        if (term == WCUT_TERM_HEAT_STEP || term == WCUT_TERM_HEAT_HINGE) e[0].value[2] = 3000, e[0].value[3] = 2000;
        if (term == WCUT_TERM_WINDOW) e[0].value[2] = 12.1, e[0].value[3] = 14;
        for (int with_lag = 0; with_lag < 2; with_lag++) {
            const double worst = worst_derivative(1 + with_lag, e, 5);
            ck_assert_msg(worst < 1e-7, "%s: %g", wcut_term_name[term], worst);
        }
    }
    const wcut_effect deep[3] = {term_of(WCUT_TERM_LOG_SPEED, -1, 10, 0, 0),
                                 term_of(WCUT_TERM_DIRECTION_Y, -0.4, 2, 0, 0),
                                 term_of(WCUT_TERM_HEAT_MEMORY, 2, 1.5, 0, 0)};
    ck_assert_double_lt(worst_derivative(3, deep, 7), 1e-7);
}
