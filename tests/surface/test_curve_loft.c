/* labels: unit property
   Lofts through curves of unlike degree, knots and weights: each is a section of the surface; what is odd is counted. */
#include <stdio.h>
#include <wirecut/curve_loft.h>
#include <wirecut/curve_measure.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

static wcut_curve *circle(double radius, double z, bool backwards) {
    wcut_vec3 control[CIRCLE_COUNT];
    double weight[CIRCLE_COUNT];
    for (int i = 0; i < CIRCLE_COUNT; i++) {
        control[i] = vec3(radius * circle_x[i], radius * circle_y[i] * (backwards ? -1 : 1), z);
        weight[i] = circle_weight(i);
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(2, CIRCLE_COUNT, circle_knots, control, weight, &c), WCUT_OK);
    return c;
}

static wcut_curve *line(wcut_vec3 a, wcut_vec3 b) {
    const double knots[4] = {-1, -1, 5, 5};
    const wcut_vec3 p[2] = {a, b};
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(1, 2, knots, p, NULL, &c), WCUT_OK);
    return c;
}

/* a wave over x in [0, 300], through unevenly spaced points */
static wcut_curve *wave(wcut_random *random, int points, double y) {
    wcut_vec3 p[400];
    double x = 0;
    for (int i = 0; i < points; i++) {
        p[i] = vec3(x, y, 20 * sin(0.02 * x + 0.01 * y));
        x += 300.0 / (points - 1) * (i % 2 ? 0.5 : 1.5) * (0.8 + 0.4 * wcut_random_uniform(random));
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_interpolate(points, p, &c), WCUT_OK);
    return c;
}

/* the largest distance between a curve at shares of its length and a section of the surface */
static double section_apart(const wcut_surface *s, double v, const wcut_curve *c) {
    double whole = 0, max = 0;
    ck_assert_int_eq(wcut_curve_length(c, -1e9, 1e9, &whole), WCUT_OK);
    for (int i = 0; i <= 25; i++) {
        double u = 0;
        wcut_vec3 p, q;
        if (whole > 0) ck_assert_int_eq(wcut_curve_locate_length(c, whole * i / 25, &u), WCUT_OK);
        wcut_curve_eval(c, u, 0, &p);
        wcut_surface_eval(s, i / 25.0, v, 0, &q);
        max = fmax(max, vec3_distance(p, q));
    }
    return max;
}

TEST(unlike_curves_are_sections_of_their_loft) {
    enum { COUNT = 7 };
    wcut_random random = wcut_random_seed(71);
    wcut_curve *c[COUNT];
    for (int k = 0; k < COUNT; k++) c[k] = wave(&random, 4 + 57 * k, 50 * k);
    wcut_curve_destroy(c[3]);
    c[3] = line(vec3(0, 150, 0), vec3(290, 150, 10));
    for (double tolerance = 0.1; tolerance > 1e-5; tolerance /= 30) {
        wcut_surface *s = NULL;
        double v[COUNT];
        wcut_curve_loft_report r = {.used = 999};
        ck_assert_int_eq(wcut_surface_loft_curves(COUNT, (const wcut_curve *const *)c, 0, tolerance, &s, v, &r),
                         WCUT_OK);
        double max = 0;
        for (int k = 0; k < COUNT; k++) max = fmax(max, section_apart(s, v[k], c[k]));
        printf("%d unlike curves at %g mm: %d x %d control points, measured %.2g, sampled %.2g mm\n", COUNT, tolerance,
               s->count_v, s->count_u, r.section_error, max);
        ck_assert(r.section_error <= tolerance && max <= 1.1 * tolerance && r.nodes == s->count_u);
        ck_assert(r.used == COUNT && r.dropped == 0 && r.closed == 0 && r.turned == 0 && r.first_turned == -1);
        wcut_surface_destroy(s);
    }
    for (int k = 0; k < COUNT; k++) wcut_curve_destroy(c[k]);
}

TEST(a_thousand_sections_do_not_multiply_their_knots) {
    enum { COUNT = 1000 };
    wcut_random random = wcut_random_seed(72);
    static wcut_curve *c[COUNT];
    for (int k = 0; k < COUNT; k++) c[k] = wave(&random, 20 + k % 30, k);
    wcut_surface *s = NULL;
    wcut_curve_loft_report r = {.used = 999};
    ck_assert_int_eq(wcut_surface_loft_curves(COUNT, (const wcut_curve *const *)c, 0, 0.01, &s, NULL, &r), WCUT_OK);
    printf("%d sections: %d x %d control points\n", COUNT, s->count_v, s->count_u);
    ck_assert(s->count_v == COUNT && s->count_u <= 129);
    wcut_surface_destroy(s);
    for (int k = 0; k < COUNT; k++) wcut_curve_destroy(c[k]);
}

TEST(circles_that_shrink_to_a_point_make_a_cone) {
    wcut_curve *c[5];
    for (int k = 0; k < 4; k++) c[k] = circle(40 - 10 * k, 25 * k, false);
    c[4] = line(vec3(0, 0, 100), vec3(0, 0, 100));
    wcut_surface *s = NULL;
    wcut_curve_loft_report r = {.used = 999};
    ck_assert_int_eq(wcut_surface_loft_curves(5, (const wcut_curve *const *)c, 0, 1e-4, &s, NULL, &r), WCUT_OK);
    ck_assert(r.closed == 4 && r.used == 5 && r.turned == 0);
    double max = 0;
    for (int i = 0; i <= 200; i++)
        for (int j = 0; j <= 50; j++) {
            wcut_vec3 p;
            wcut_surface_eval(s, i / 200.0, j / 50.0, 0, &p);
            max = fmax(max, fabs(hypot(p.x, p.y) - (40 - 0.4 * p.z)));
        }
    ck_assert_double_le(max, 2e-4);
    wcut_surface_destroy(s);
    /* one that runs the other way round, and one all but the same as the one before */
    wcut_curve_destroy(c[1]);
    wcut_curve_destroy(c[4]);
    c[1] = circle(40, 1e-5, false);
    c[4] = circle(10, 80, true);
    double v[5];
    ck_assert_int_eq(wcut_surface_loft_curves(5, (const wcut_curve *const *)c, 1e-3, 1e-2, &s, v, &r), WCUT_OK);
    ck_assert(r.dropped == 1 && r.used == 4 && v[1] == v[0] && r.turned == 1 && r.first_turned == 4 && r.closed == 5);
    wcut_surface_destroy(s);
    for (int k = 0; k < 5; k++) wcut_curve_destroy(c[k]);
}

TEST(what_cannot_be_lofted_is_refused_and_nothing_is_written) {
    wcut_curve *a = line(vec3(0, 0, 0), vec3(9, 0, 0)), *b = line(vec3(0, 5, 0), vec3(9, 5, 0));
    const wcut_curve *pair[2] = {a, b}, *none[2] = {a, NULL}, *same[2] = {a, a};
    wcut_surface *const mark = (wcut_surface *)&pair, *s = mark;
    double v[2] = {999, 999};
    wcut_curve_loft_report r = {.used = 999};
    ck_assert_int_eq(wcut_surface_loft_curves(1, pair, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft_curves(2, NULL, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft_curves(2, none, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft_curves(2, pair, -1, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft_curves(2, pair, 0, 0, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft_curves(2, pair, 0, 1, NULL, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft_curves(2, same, 0, 1, &s, v, &r), WCUT_DEGENERATE);
    const double knots[5] = {0, 0, 0.37, 1, 1};
    const wcut_vec3 corner[3] = {{0, 0, 0}, {5, 5, 0}, {9, 0, 0}};
    wcut_curve *kinked = NULL;
    ck_assert_int_eq(wcut_curve_create(1, 3, knots, corner, NULL, &kinked), WCUT_OK);
    kinked->control[1].y = 4;
    const wcut_curve *kinks[2] = {kinked, b};
    ck_assert_int_eq(wcut_surface_loft_curves(2, kinks, 0, 1e-6, &s, v, &r), WCUT_NOT_CONVERGED);
    ck_assert(s == mark && v[0] == 999 && r.used == 999);
    ck_assert_int_eq(wcut_surface_loft_curves(2, kinks, 0, 0.02, &s, v, &r), WCUT_OK);
    wcut_surface_destroy(s);
    s = mark, r.used = 999;
    kinked->control[1].y = 1e200, kinked->control[0].y = -1e200;
    ck_assert_int_eq(wcut_surface_loft_curves(2, kinks, 0, 1, &s, v, &r), WCUT_DEGENERATE);
    EACH_FAILED_ALLOCATION(wcut_surface_loft_curves(2, pair, 0, 1, &s, NULL, &r), s == mark && r.used == 999);
    wcut_surface_destroy(s);
    wcut_curve_destroy(kinked);
    wcut_curve_destroy(a);
    wcut_curve_destroy(b);
}
