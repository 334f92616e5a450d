/* Both ways to a chain's equilibrium, the fixed point (7)-(8) and Newton on the convex dual, against closed forms: the
   catenary, the circular arc, the parabola; against each other; and against scipy. labels: unit oracle */
#include <stdlib.h>
#include <wirecut/equilibrium.h>
#include <wirecut/force_density.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"
#include "wire/equilibrium_table.h"

enum { MAX = 3201 };
static wcut_vec3 force[MAX], x[MAX], other[MAX];
static double length[MAX], q[MAX], other_q[MAX];

/* n nodes between (0,0,0) and (chord,0,0) on equal edges that sum to `total`; no load yet */
static void given_a_chain(int n, double chord, double total) {
    for (int i = 0; i < MAX; i++) {
        x[i] = other[i] = vec3(999, 999, 999);
        force[i] = vec3(0, 0, 0);
        q[i] = other_q[i] = 999;
    }
    for (int e = 0; e < n - 1; e++) length[e] = total / (n - 1), other_q[e] = 1;
    x[0] = other[0] = vec3(0, 0, 0);
    x[n - 1] = other[n - 1] = vec3(chord, 0, 0);
}

static void load_evenly(int n, double total) {
    for (int i = 0; i < n; i++) force[i] = vec3(0, total / (n - 1), 0);
}

static double strain_of(int n, const wcut_vec3 *shape) {
    double worst = 0;
    for (int e = 0; e < n - 1; e++) worst = fmax(worst, fabs(vec3_distance(shape[e], shape[e + 1]) / length[e] - 1));
    return worst;
}

/* largest distance of equal nodes, over the chain's length */
static double difference_of(int n, const wcut_vec3 *a, const wcut_vec3 *b) {
    double worst = 0, total = 0;
    for (int i = 0; i < n; i++) worst = fmax(worst, vec3_distance(a[i], b[i]));
    for (int e = 0; e < n - 1; e++) total += length[e];
    return worst / total;
}

static int solve_by_newton(int n) {
    wcut_equilibrium_report report;
    ck_assert_int_eq(wcut_equilibrium_solve(n, force, length, NULL, x, q, &report), WCUT_OK);
    ck_assert_double_lt(strain_of(n, x), 1e-9);
    ck_assert_double_le(report.unbalance, 1e-12);
    return report.iterations;
}

/* rounds to 1e-9; then on to 1e-11, for a nearly straight wire sags wrong by far more than it is strained */
static int solve_by_fixed_point(int n) {
    wcut_fdm_report report, polished;
    wcut_fdm_options options = {.tolerance = 1e-9, .max_rounds = 100000};
    ck_assert_int_eq(wcut_fdm_solve(n, force, length, &options, other_q, other, &report), WCUT_OK);
    ck_assert_double_lt(strain_of(n, other), 1e-9);
    options.tolerance = 1e-11;
    ck_assert_int_eq(wcut_fdm_solve(n, force, length, &options, other_q, other, &polished), WCUT_OK);
    return report.rounds;
}

/* x with f(x) = 0 for an f that rises from `low` to `high` */
static double root_of(double (*f)(double, double, double), double a, double b, double low, double high) {
    for (int k = 0; k < 200; k++) {
        const double middle = (low + high) / 2;
        if (f(middle, a, b) > 0)
            high = middle;
        else
            low = middle;
    }
    return low;
}

/* the catenary y = p cosh(x / p): its arc over a chord, less a length, over 1/p */
static double catenary_excess(double inverse, double chord, double total) {
    return 2 / inverse * sinh(chord * inverse / 2) - total;
}

/* the parabola y = c x^2 / 2: its arc over a chord, less a length */
static double parabola_excess(double c, double chord, double total) {
    const double p = c * chord / 2;
    return (p * hypot(1, p) + asinh(p)) / c - total;
}

TEST(an_even_load_per_arc_length_hangs_a_catenary_with_order_two) {
    const double inverse = root_of(catenary_excess, 400, 450, 1e-6, 1);
    const double sag = (cosh(200 * inverse) - 1) / inverse;
    double before = 0;
    for (int n = 21; n <= 641; n = 2 * n - 1) {
        given_a_chain(n, 400, 450);
        load_evenly(n, 2);
        solve_by_newton(n);
        const double error = fabs(x[n / 2].y - sag);
        if (before > 0) ck_assert_double_eq_tol(log2(before / error), 2, 0.05);
        before = error;
    }
    ck_assert_double_lt(before, 1e-3);
}

/* Nodes on a circle, edges 2 R sin(phi / 2): radial forces 2 T sin(phi / 2) balance an even tension T exactly. */
TEST(an_even_load_across_the_wire_hangs_the_circular_arc_that_it_was_computed_from) {
    const int n = 61;
    const double opening[] = {0.2, 1.5, 3, 5}; /* rad: from nearly straight to far around */
    for (int k = 0; k < 4; k++) {
        const double chord = 400, radius = chord / 2 / sin(opening[k] / 2), phi = opening[k] / (n - 1), tension = 2;
        given_a_chain(n, chord, (n - 1) * 2 * radius * sin(phi / 2));
        const wcut_vec3 centre = vec3(chord / 2, -radius * cos(opening[k] / 2), 0);
        static wcut_vec3 circle[MAX];
        for (int i = 0; i < n; i++) {
            const double angle = -opening[k] / 2 + i * phi;
            const wcut_vec3 radial = vec3(sin(angle), cos(angle), 0);
            circle[i] = vec3_add_scaled(centre, radius, radial);
            force[i] = vec3_scale(2 * tension * sin(phi / 2), radial);
        }
        solve_by_newton(n);
        ck_assert_double_lt(difference_of(n, x, circle), 1e-10);
        for (int e = 0; e < n - 1; e++) ck_assert_double_eq_tol(q[e] * length[e], tension, 1e-9);
        for (int e = 0; e < n - 1; e++) other_q[e] = 0.9 * tension / length[e];
        solve_by_fixed_point(n);
        ck_assert_double_lt(difference_of(n, other, circle), 1e-9);
    }
}

/* On y = c x^2 / 2 the slopes of two edges differ by c times half the span beside their node: any polygon in a parabola
   balances a load even over the span, and edges need not be alike. */
TEST(an_even_load_over_the_span_hangs_the_parabola_that_it_was_computed_from) {
    const int n = 31;
    const double c = 0.004, horizontal = 1.5;
    given_a_chain(n, 400, 450);
    static wcut_vec3 parabola[MAX];
    for (int i = 0; i < n; i++) {
        const double t = (double)i / (n - 1), at = 400 * (t + 0.1 * t * (1 - t));
        parabola[i] = vec3(at, c / 2 * at * (400 - at), 0);
    }
    for (int e = 0; e < n - 1; e++) length[e] = vec3_distance(parabola[e], parabola[e + 1]);
    for (int i = 1; i < n - 1; i++) force[i] = vec3(0, horizontal * c * (parabola[i + 1].x - parabola[i - 1].x) / 2, 0);
    solve_by_newton(n);
    ck_assert_double_lt(difference_of(n, x, parabola), 1e-11);
    for (int e = 0; e < n - 1; e++)
        ck_assert_double_eq_tol(q[e] * (parabola[e + 1].x - parabola[e].x), horizontal, 1e-9);
    for (int e = 0; e < n - 1; e++) other_q[e] = 1 / length[e];
    solve_by_fixed_point(n);
    ck_assert_double_lt(difference_of(n, other, parabola), 1e-8);
}

TEST(an_even_load_over_the_span_of_equal_edges_tends_to_the_parabola_with_order_two) {
    const double c = root_of(parabola_excess, 400, 450, 1e-6, 1), sag = c * 400 * 400 / 8;
    ck_assert_double_eq_tol(sag, 91.1828, 5e-5);
    double before = 0;
    for (int n = 21; n <= 641; n = 2 * n - 1) {
        given_a_chain(n, 400, 450);
        load_evenly(n, 2);
        for (int round = 0; round < 60; round++) { /* the load follows the span that each node has */
            solve_by_newton(n);
            for (int i = 1; i < n - 1; i++) force[i] = vec3(0, (x[i + 1].x - x[i - 1].x) / 2 / 400, 0);
        }
        const double error = fabs(x[n / 2].y - sag);
        if (before > 0) ck_assert_double_eq_tol(log2(before / error), 2, 0.05);
        before = error;
    }
}

TEST(from_however_straight_a_wire_newton_needs_ten_steps_where_the_fixed_point_needs_thousands) {
    const struct {
        double slack;
        int rounds; /* of the fixed point, 8 over the slack where that is small */
    } row[] = {{1.5, 39}, {1.125, 93}, {1.02, 420}, {1.005, 1546}, {1.0005, 13126}};
    const int n = 41;
    for (int k = 0; k < 5; k++) {
        given_a_chain(n, 400, 400 * row[k].slack);
        load_evenly(n, 2);
        for (int e = 0; e < n - 1; e++) other_q[e] = 0.1;
        const int steps = solve_by_newton(n), rounds = solve_by_fixed_point(n);
        ck_assert_msg(steps <= 10, "length over chord %g: %d Newton steps", row[k].slack, steps);
        ck_assert_msg(abs(rounds - row[k].rounds) <= row[k].rounds / 4, "length over chord %g: %d rounds, expected %d",
                      row[k].slack, rounds, row[k].rounds);
        ck_assert_double_lt(difference_of(n, x, other), 1e-8);
    }
}

TEST(a_chain_of_thousands_of_nodes_takes_no_more_steps_than_a_short_one) {
    const double slack[] = {1.125, 1.02, 1.0005};
    for (int k = 0; k < 3; k++)
        for (int n = 201; n <= MAX; n = 2 * n - 1)
            for (int uneven = 0; uneven < 2; uneven++) { /* all of it loaded, or the middle two thirds, as in a block */
                given_a_chain(n, 400, 400 * slack[k]);
                for (int i = 0; i < n; i++)
                    if (!uneven || (6 * i > n && 6 * i < 5 * n)) force[i] = vec3(0, 2.0 / n, 0);
                ck_assert_int_le(solve_by_newton(n), 12);
            }
}

TEST(chains_in_space_have_the_shapes_and_tensions_that_scipy_finds) {
    for (int k = 0; k < TABLE_CHAINS; k++) {
        const int n = TABLE_NODES;
        given_a_chain(n, 1, 1);
        static wcut_vec3 expected[MAX];
        double largest = 0;
        for (int i = 0; i < n; i++) {
            expected[i] = vec3(table[k].x[i][0], table[k].x[i][1], table[k].x[i][2]);
            force[i] = vec3(table[k].force[i][0], table[k].force[i][1], table[k].force[i][2]);
        }
        for (int e = 0; e < n - 1; e++) {
            length[e] = table[k].length[e];
            largest = fmax(largest, table[k].tension[e]);
        }
        x[n - 1] = other[n - 1] = vec3(table[k].end[0], table[k].end[1], table[k].end[2]);
        ck_assert_int_le(solve_by_newton(n), 12);
        ck_assert_double_lt(difference_of(n, x, expected), 1e-9);
        for (int e = 0; e < n - 1; e++) ck_assert_double_eq_tol(q[e] * length[e], table[k].tension[e], 1e-7 * largest);
        solve_by_fixed_point(n);
        ck_assert_double_lt(difference_of(n, other, expected), 1e-8);
    }
}

TEST(turning_chain_and_load_turns_the_shape) {
    const int n = 41;
    given_a_chain(n, 400, 450);
    for (int i = 0; i < n; i++) force[i] = vec3(0.01 * sin(i), 0.1, 0.03 * cos(2 * i));
    solve_by_newton(n);
    for (int i = 0; i < n; i++)
        other[i] = vec3(x[i].z, x[i].x, x[i].y), force[i] = vec3(force[i].z, force[i].x, force[i].y);
    const wcut_vec3 end = other[n - 1];
    for (int i = 1; i < n; i++) x[i] = vec3(999, 999, 999);
    x[n - 1] = end;
    solve_by_newton(n);
    ck_assert_double_lt(difference_of(n, x, other), 1e-11);
}

TEST(a_wire_no_longer_than_its_chord_or_without_load_is_degenerate_and_nothing_is_written) {
    for (int k = 0; k < 2; k++) {
        given_a_chain(11, 400, k == 0 ? 400 : 450);
        if (k == 0) load_evenly(11, 2);
        wcut_equilibrium_report report = {.iterations = 999};
        ck_assert_int_eq(wcut_equilibrium_solve(11, force, length, NULL, x, q, &report), WCUT_DEGENERATE);
        ck_assert(x[5].x == 999 && q[5] == 999 && report.iterations == 999);
    }
}

TEST(bad_arguments_are_refused_and_nothing_is_written) {
    for (int k = 0; k < 10; k++) {
        given_a_chain(11, 400, 450);
        load_evenly(11, 2);
        wcut_equilibrium_options options = wcut_equilibrium_options_default();
        if (k == 0) options.tolerance = 0;
        if (k == 1) options.tolerance = NAN;
        if (k == 2) options.max_iterations = 0;
        if (k == 3) force[5].z = NAN;
        if (k == 4) length[3] = 0;
        if (k == 5) length[3] = (double)INFINITY;
        if (k == 6) x[0].x = NAN;
        const wcut_status status = wcut_equilibrium_solve(k == 7 ? 2 : 11, k == 8 ? NULL : force, length, &options, x,
                                                          k == 9 ? NULL : q, NULL);
        ck_assert_msg(status == WCUT_BAD_ARGUMENT, "case %d: %s", k, wcut_status_text(status));
        ck_assert(x[5].x == 999 && q[5] == 999);
    }
}

TEST(stopped_early_it_says_so_and_hands_out_the_last_iterate) {
    given_a_chain(41, 400, 600);
    for (int i = 0; i < 41; i++) force[i] = vec3(0.05 * sin(7 * i), 0.1, 0.05 * cos(3 * i));
    const wcut_equilibrium_options options = {.tolerance = 1e-12, .max_iterations = 1};
    wcut_equilibrium_report report;
    ck_assert_int_eq(wcut_equilibrium_solve(41, force, length, &options, x, q, &report), WCUT_NOT_CONVERGED);
    ck_assert_int_eq(report.iterations, 1);
    ck_assert(vec3_all_finite(41, x) && all_finite(40, q));
    ck_assert_double_gt(fmax(report.strain, report.unbalance), 1e-12);
}
