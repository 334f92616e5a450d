/* labels: unit oracle
   B-spline curves against the circle's closed form, polynomials they must reproduce, and at their edges. */
#include <wirecut/curve.h>

#include "base/alloc.h"
#include "surface/interpolate.h"
#include "surface/shapes.h"
#include "test.h"

static const wcut_vec3 line[2] = {{1, 2, 3}, {5, 2, 3}};
static const double line_knots[4] = {0, 0, 1, 1};

static wcut_curve *quarter(void) {
    wcut_vec3 control[3];
    for (int i = 0; i < 3; i++) control[i] = vec3(quarter_x[i], quarter_y[i], 7);
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(2, 3, quarter_knots, control, quarter_weight, &c), WCUT_OK);
    return c;
}

TEST(a_rational_arc_and_three_derivatives_are_the_circles) {
    wcut_curve *c = quarter();
    for (int i = 0; i <= 100; i++) {
        const double t = i / 100.0;
        wcut_vec3 d[4];
        ck_assert_int_eq(wcut_curve_eval(c, t, 3, d), WCUT_OK);
        for (int k = 0; k <= 3; k++) {
            const double complex z = circle_derivative(t, k);
            ck_assert_double_le(apart(d[k], vec3(creal(z), cimag(z), k == 0 ? 7 : 0)), 1e-13 * (k + 1) * 10);
        }
    }
    wcut_curve_destroy(c);
}

/* knots 0, 1, .. without clamping: t^p is reproduced by control points symmetric in the knots (Marsden's identity) */
TEST(every_degree_reproduces_its_own_power_and_its_derivatives) {
    enum { COUNT = 12 };
    for (int p = 1; p <= WCUT_DEGREE_MAX; p++) {
        double knots[COUNT + WCUT_DEGREE_MAX + 1];
        wcut_vec3 control[COUNT];
        for (int i = 0; i < COUNT + p + 1; i++) knots[i] = i - p - 2.5 + 0.3 * sin(i);
        for (int i = 0; i < COUNT; i++) {
            double product = 1, sum = 0;
            for (int k = 1; k <= p; k++) product *= knots[i + k], sum += knots[i + k];
            control[i] = vec3(product, sum / p, 1);
        }
        wcut_curve *c = NULL;
        ck_assert_int_eq(wcut_curve_create(p, COUNT, knots, control, NULL, &c), WCUT_OK);
        double first, last;
        wcut_curve_domain(c, &first, &last);
        ck_assert(first == knots[p] && last == knots[COUNT]);
        for (int i = 0; i <= 50; i++) {
            const double t = first + (last - first) * i / 50, scale = pow(fabs(t) + 1, p);
            wcut_vec3 d[4];
            ck_assert_int_eq(wcut_curve_eval(c, t, 3, d), WCUT_OK);
            double power = 1;
            for (int k = 0; k <= 3; k++) {
                const double want = k <= p ? power * pow(t, p - k) : 0;
                ck_assert_double_le(fabs(d[k].x - want), 2e-12 * scale * fmax(power, 1));
                ck_assert_double_le(fabs(d[k].y - (k == 0 ? t : k == 1)), 1e-12);
                ck_assert_double_le(fabs(d[k].z - (k == 0)), 1e-13);
                power *= p - k;
            }
        }
        wcut_curve_destroy(c);
    }
}

TEST(outside_the_domain_the_end_is_given) {
    wcut_curve *c = quarter();
    wcut_vec3 before, after;
    ck_assert_int_eq(wcut_curve_eval(c, -5, 0, &before), WCUT_OK);
    ck_assert_int_eq(wcut_curve_eval(c, 5, 0, &after), WCUT_OK);
    ck_assert_double_le(apart(before, vec3(1, 0, 7)), 1e-15);
    ck_assert_double_le(apart(after, vec3(0, 1, 7)), 1e-15);
    wcut_curve_destroy(c);
}

TEST(what_is_no_curve_is_refused_and_nothing_is_written) {
    wcut_curve *const mark = (wcut_curve *)&line_knots, *c = mark;
    const wcut_vec3 p[4] = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 0, 0}}, bad[2] = {{0, 0, 0}, {0, NAN, 0}};
    const double falling[4] = {0, 1, 0, 1}, endless[4] = {0, 0, INFINITY, INFINITY}, empty[4] = {1, 1, 1, 1};
    const double torn[7] = {0, 0, 0.5, 0.5, 1, 1, 1}, weight[2] = {1, 0}, wild[4] = {-1e308, -1e308, 1e308, 1e308};
    ck_assert_int_eq(wcut_curve_create(0, 2, line_knots, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(8, 2, line_knots, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 1, line_knots, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, NULL, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, line_knots, NULL, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, line_knots, line, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, falling, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, endless, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, empty, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, wild, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 5, torn, p, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, line_knots, bad, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, 2, line_knots, line, weight, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_create(1, INT32_MAX / 2, line_knots, line, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(c, mark);
}

TEST(evaluation_refuses_what_it_does_not_know) {
    wcut_curve *c = quarter();
    wcut_vec3 d[4] = {{999, 999, 999}};
    ck_assert_int_eq(wcut_curve_eval(NULL, 0, 0, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_eval(c, NAN, 0, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_eval(c, 0, -1, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_eval(c, 0, 4, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_eval(c, 0, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(d[0].x == 999);
    wcut_curve_destroy(c);
}

/* the chord-length parameter of point k */
static double chord_parameter(int count, const wcut_vec3 *p, int k) {
    double sum = 0, before = 0;
    for (int i = 1; i < count; i++) {
        sum += vec3_distance(p[i - 1], p[i]);
        if (i == k) before = sum;
    }
    return before / sum;
}

TEST(an_interpolating_curve_passes_through_its_points) {
    enum { MAX = 300 };
    wcut_vec3 p[MAX];
    srand(3);
    for (int count = 2; count <= MAX; count += count < 8 ? 1 : 73) {
        for (int i = 0; i < count; i++)
            p[i] = vec3(i + 0.8 * rand() / RAND_MAX, 50 * sin(0.3 * i), 1000 + 5.0 * rand() / RAND_MAX);
        wcut_curve *c = NULL;
        ck_assert_int_eq(wcut_curve_interpolate(count, p, &c), WCUT_OK);
        ck_assert_int_eq(c->degree, count > 3 ? 3 : count - 1);
        for (int i = 0; i < count; i++) {
            wcut_vec3 q;
            ck_assert_int_eq(wcut_curve_eval(c, chord_parameter(count, p, i), 0, &q), WCUT_OK);
            ck_assert_double_le(apart(q, p[i]), 1e-10);
        }
        wcut_curve_destroy(c);
    }
}

TEST(a_cubic_comes_back_whatever_the_parameters) {
    enum { COUNT = 40 };
    double u[COUNT], knots[COUNT + 4];
    wcut_vec3 p[COUNT];
    srand(5);
    for (int i = 0; i < COUNT; i++) {
        u[i] = i == 0 ? 0 : u[i - 1] + (i % 7 == 0 ? 0.01 : 1) * (0.2 + rand() / (double)RAND_MAX);
        p[i] = vec3(u[i] * u[i] * u[i], u[i] * (u[i] - 3), 5 - u[i]);
    }
    wcut_knots_average(3, COUNT, u, knots);
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_interpolate_rows(3, COUNT, knots, u, 1, p), WCUT_OK);
    ck_assert_int_eq(wcut_curve_create(3, COUNT, knots, p, NULL, &c), WCUT_OK);
    for (int i = 0; i <= 1000; i++) {
        const double t = u[COUNT - 1] * i / 1000;
        wcut_vec3 q;
        ck_assert_int_eq(wcut_curve_eval(c, t, 0, &q), WCUT_OK);
        ck_assert_double_le(apart(q, vec3(t * t * t, t * (t - 3), 5 - t)), 1e-13 * (1 + t * t * t) * 100);
    }
    wcut_curve_destroy(c);
}

TEST(interpolation_converges_with_the_fourth_order) {
    double error[2];
    for (int k = 0; k < 2; k++) {
        enum { MAX = 81 };
        const int count = k ? 81 : 41;
        wcut_vec3 p[MAX];
        for (int i = 0; i < count; i++) { /* uneven steps along a circle */
            const double t = 2 * (double)i / (count - 1), a = t + 0.2 * sin(3 * t);
            p[i] = vec3(100 * cos(a), 100 * sin(a), 0);
        }
        wcut_curve *c = NULL;
        ck_assert_int_eq(wcut_curve_interpolate(count, p, &c), WCUT_OK);
        error[k] = 0;
        for (int i = 0; i <= 5000; i++) {
            wcut_vec3 q;
            ck_assert_int_eq(wcut_curve_eval(c, i / 5000.0, 0, &q), WCUT_OK);
            error[k] = fmax(error[k], fabs(vec3_length(q) - 100));
        }
        wcut_curve_destroy(c);
    }
    const double order = log2(error[0] / error[1]);
    ck_assert_msg(order > 3.7, "errors %g and %g mm, order %.2f", error[0], error[1], order);
}

TEST(points_that_coincide_or_are_no_numbers_are_refused) {
    wcut_curve *const mark = (wcut_curve *)&line_knots, *c = mark;
    wcut_vec3 p[4] = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    ck_assert_int_eq(wcut_curve_interpolate(4, p, &c), WCUT_DEGENERATE);
    p[2].x = 1 + 1e-17;
    ck_assert_int_eq(wcut_curve_interpolate(4, p, &c), WCUT_DEGENERATE);
    p[2].x = INFINITY;
    ck_assert_int_eq(wcut_curve_interpolate(4, p, &c), WCUT_BAD_ARGUMENT);
    p[2].x = 1e308, p[3].x = -1e308; /* their distance overflows */
    ck_assert_int_eq(wcut_curve_interpolate(4, p, &c), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_curve_interpolate(1, p, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate(2, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate(2, p, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(c, mark);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    const wcut_vec3 p[5] = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {3, 1, 1}, {4, 0, 0}};
    for (int which = 0; which < 2; which++) {
        wcut_curve *const mark = (wcut_curve *)&line_knots, *c = mark;
        EACH_FAILED_ALLOCATION(
            which ? wcut_curve_interpolate(5, p, &c) : wcut_curve_create(2, 3, quarter_knots, p, quarter_weight, &c),
            c == mark);
        wcut_curve_destroy(c);
    }
}
