/* labels: unit property
   The closest point of a curve against closed forms, planted feet and dense samples. */
#include <stdio.h>
#include <string.h>
#include <wirecut/curve_measure.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

static wcut_curve *circle(double radius) {
    wcut_vec3 control[CIRCLE_COUNT];
    double weight[CIRCLE_COUNT];
    for (int i = 0; i < CIRCLE_COUNT; i++) {
        control[i] = vec3(radius * circle_x[i], radius * circle_y[i], 0);
        weight[i] = circle_weight(i);
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(2, CIRCLE_COUNT, circle_knots, control, weight, &c), WCUT_OK);
    return c;
}

static wcut_curve *crumpled(wcut_random *random, int count) {
    wcut_vec3 *p = malloc((size_t)count * sizeof *p);
    for (int k = 0; k < count; k++)
        p[k] = vec3(100 * wcut_random_uniform(random), 100 * wcut_random_uniform(random),
                    100 * wcut_random_uniform(random));
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_interpolate(count, p, &c), WCUT_OK);
    free(p);
    return c;
}

TEST(the_distance_to_a_circle_is_the_closed_form) {
    enum { COUNT = 2000 };
    static wcut_vec3 p[COUNT];
    static wcut_curve_foot foot[COUNT];
    wcut_random random = wcut_random_seed(41);
    wcut_curve *c = circle(30);
    for (int k = 0; k < COUNT; k++)
        p[k] = vec3(100 * wcut_random_uniform(&random) - 50, 100 * wcut_random_uniform(&random) - 50,
                    100 * wcut_random_uniform(&random) - 50);
    p[0] = vec3(0, 0, 0), p[1] = vec3(0, 0, 7); /* everything ties */
    ck_assert_int_eq(wcut_curve_locate(c, COUNT, p, 1, foot), WCUT_OK);
    for (int k = 0; k < COUNT; k++) {
        const double want = hypot(hypot(p[k].x, p[k].y) - 30, p[k].z);
        ck_assert_double_eq_tol(foot[k].distance, want, 1e-11);
        if (k > 1) ck_assert(foot[k].gap == 0 && foot[k].beyond == 0);
        ck_assert(foot[k].distance - foot[k].gap <= want + 1e-11);
    }
    wcut_curve_destroy(c);
}

TEST(planted_feet_are_found_again) {
    enum { COUNT = 20000 };
    static wcut_vec3 p[COUNT];
    static wcut_curve_foot foot[COUNT];
    wcut_random random = wcut_random_seed(42);
    enum { POINTS = 400 };
    wcut_vec3 x[POINTS]; /* a helix: planted within its pitch */
    for (int k = 0; k < POINTS; k++) x[k] = vec3(80 * cos(0.1 * k), 80 * sin(0.1 * k), 0.8 * k);
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_interpolate(POINTS, x, &c), WCUT_OK);
    double u[COUNT], height[COUNT], worst = 0;
    for (int k = 0; k < COUNT; k++) {
        wcut_frame f;
        u[k] = wcut_random_uniform(&random), height[k] = 20 * wcut_random_uniform(&random);
        ck_assert_int_eq(wcut_curve_frame(c, u[k], &f), WCUT_OK);
        const double a = 2 * WCUT_PI * wcut_random_uniform(&random);
        p[k] = vec3_add_scaled(vec3_add_scaled(f.point, height[k] * cos(a), f.normal), height[k] * sin(a), f.binormal);
    }
    ck_assert_int_eq(wcut_curve_locate(c, COUNT, p, 2, foot), WCUT_OK);
    for (int k = 0; k < COUNT; k++) {
        worst = fmax(worst, fabs(foot[k].distance - height[k]));
        ck_assert(foot[k].gap == 0 && !foot[k].beyond);
        ck_assert_double_eq_tol(foot[k].u, u[k], 1e-7);
    }
    printf("%d planted points, worst %.2g mm\n", COUNT, worst);
    ck_assert_double_le(worst, 1e-9);
    wcut_curve_destroy(c);
}

TEST(no_point_of_a_crumpled_curve_is_closer_than_its_foot) {
    wcut_random random = wcut_random_seed(43);
    for (int trial = 0; trial < 20; trial++) {
        wcut_curve *c = crumpled(&random, 2 + 3 * trial);
        for (int k = 0; k < 30; k++) {
            const wcut_vec3 p = vec3(140 * wcut_random_uniform(&random) - 20, 140 * wcut_random_uniform(&random) - 20,
                                     140 * wcut_random_uniform(&random) - 20);
            wcut_curve_foot foot;
            ck_assert_int_eq(wcut_curve_locate(c, 1, &p, 1, &foot), WCUT_OK);
            ck_assert(foot.gap == 0);
            wcut_vec3 q;
            ck_assert_int_eq(wcut_curve_eval(c, foot.u, 0, &q), WCUT_OK);
            ck_assert_double_le(apart(q, foot.point), 1e-12);
            double nearest = INFINITY;
            for (int i = 0; i <= 3000; i++) {
                wcut_curve_eval(c, i / 3000.0, 0, &q);
                nearest = fmin(nearest, vec3_distance(p, q));
            }
            ck_assert(nearest >= foot.distance - 1e-10 && nearest < foot.distance + 5);
        }
        wcut_curve_destroy(c);
    }
}

TEST(beyond_an_end_is_told_from_beside_it) {
    const double knots[4] = {2, 2, 3, 3};
    const wcut_vec3 line[2] = {{0, 0, 0}, {10, 0, 0}}, p[4] = {{-1, 2, 0}, {0, 2, 0}, {10.5, 0, 0}, {5, 0, 0}};
    wcut_curve *c = NULL;
    wcut_curve_foot foot[4];
    ck_assert_int_eq(wcut_curve_create(1, 2, knots, line, NULL, &c), WCUT_OK);
    ck_assert_int_eq(wcut_curve_locate(c, 4, p, 1, foot), WCUT_OK);
    ck_assert(foot[0].beyond == 1 && foot[1].beyond == 0 && foot[2].beyond == 1 && foot[3].beyond == 0);
    ck_assert(foot[0].u == 2 && foot[2].u == 3 && fabs(foot[3].u - 2.5) < 1e-12 && foot[3].distance < 1e-12);
    wcut_curve_destroy(c);
}

TEST(threads_change_no_byte) {
    enum { COUNT = 500 };
    static wcut_vec3 p[COUNT];
    static wcut_curve_foot one[COUNT], four[COUNT];
    memset(one, 1, sizeof one);
    memset(four, 1, sizeof four);
    wcut_random random = wcut_random_seed(44);
    wcut_curve *c = crumpled(&random, 50);
    for (int k = 0; k < COUNT; k++)
        p[k] = vec3(100 * wcut_random_uniform(&random), 100 * wcut_random_uniform(&random), 50);
    ck_assert_int_eq(wcut_curve_locate(c, COUNT, p, 1, one), WCUT_OK);
    ck_assert_int_eq(wcut_curve_locate(c, COUNT, p, 4, four), WCUT_OK);
    for (int k = 0; k < COUNT; k++)
        ck_assert(one[k].u == four[k].u && one[k].distance == four[k].distance && one[k].gap == four[k].gap);
    wcut_curve_destroy(c);
}

TEST(what_cannot_be_located_is_refused_and_nothing_is_written) {
    wcut_curve *c = circle(5);
    const wcut_vec3 good = {1, 2, 3}, bad = {NAN, 0, 0};
    wcut_curve_foot foot = {.u = 999};
    ck_assert_int_eq(wcut_curve_locate(NULL, 1, &good, 1, &foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate(c, -1, &good, 1, &foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate(c, 1, NULL, 1, &foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate(c, 1, &good, 0, &foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate(c, 1, &good, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate(c, 1, &bad, 1, &foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate(c, 0, NULL, 1, NULL), WCUT_OK);
    EACH_FAILED_ALLOCATION(wcut_curve_locate(c, 1, &good, 1, &foot), foot.u == 999);
    foot.u = 999;
    c->control[0].x = 1e200;
    ck_assert_int_eq(wcut_curve_locate(c, 1, &good, 1, &foot), WCUT_DEGENERATE);
    ck_assert(foot.u == 999);
    wcut_curve_destroy(c);
}

/* ---- interpolation with given parameters and derivatives ---------------------------------------------------------- */

TEST(parameters_and_end_derivatives_are_kept) {
    enum { MAX = 60 };
    wcut_random random = wcut_random_seed(45);
    for (int count = 2; count < MAX; count += count < 7 ? 1 : 11)
        for (int which = 0; which < 4; which++) {
            wcut_vec3 p[MAX], first = {200, -30, 5}, last = {0, 150, -60}, d[2];
            double u[MAX], at = -3;
            for (int k = 0; k < count; k++) {
                p[k] = vec3(10 * k, 20 * wcut_random_uniform(&random), 20 * wcut_random_uniform(&random));
                u[k] = at += 0.05 + wcut_random_uniform(&random);
            }
            wcut_curve *c = NULL;
            ck_assert_int_eq(
                wcut_curve_interpolate_at(count, p, u, which & 1 ? &first : NULL, which & 2 ? &last : NULL, &c),
                WCUT_OK);
            for (int k = 0; k < count; k++) {
                ck_assert_int_eq(wcut_curve_eval(c, u[k], 1, d), WCUT_OK);
                ck_assert_double_le(apart(d[0], p[k]), 1e-10);
                if (k == 0 && which & 1) ck_assert_double_le(apart(d[1], first), 1e-9);
                if (k == count - 1 && which & 2) ck_assert_double_le(apart(d[1], last), 1e-9);
            }
            wcut_curve_destroy(c);
        }
}

TEST(with_its_own_end_derivatives_a_cubic_comes_back) {
    enum { COUNT = 12 };
    wcut_vec3 p[COUNT];
    double u[COUNT];
    for (int k = 0; k < COUNT; k++) {
        u[k] = k + 0.4 * sin(3 * k);
        p[k] = vec3(u[k] * u[k] * u[k], u[k] * u[k], u[k]);
    }
    const wcut_vec3 first = {3 * u[0] * u[0], 2 * u[0], 1},
                    last = {3 * u[COUNT - 1] * u[COUNT - 1], 2 * u[COUNT - 1], 1};
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_interpolate_at(COUNT, p, u, &first, &last, &c), WCUT_OK);
    ck_assert_int_eq(c->control_count, COUNT + 2);
    for (int i = 0; i <= 500; i++) {
        const double t = u[0] + (u[COUNT - 1] - u[0]) * i / 500;
        wcut_vec3 q;
        ck_assert_int_eq(wcut_curve_eval(c, t, 0, &q), WCUT_OK);
        ck_assert_double_le(apart(q, vec3(t * t * t, t * t, t)), 1e-9);
    }
    wcut_curve_destroy(c);
    const double falling[3] = {0, 2, 1}, near[3] = {1, 1 + 1e-16, 2};
    const wcut_vec3 bad = {NAN, 0, 0}, twice[3] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    wcut_curve *const mark = (wcut_curve *)&falling;
    c = mark;
    ck_assert_int_eq(wcut_curve_interpolate_at(3, p, falling, NULL, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate_at(3, p, near, NULL, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate_at(3, p, u, &bad, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate_at(3, p, u, NULL, &bad, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate_at(1, p, u, NULL, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate_at(3, NULL, u, NULL, NULL, &c), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_interpolate_at(3, twice, NULL, NULL, NULL, &c), WCUT_DEGENERATE);
    ck_assert_ptr_eq(c, mark);
    EACH_FAILED_ALLOCATION(wcut_curve_interpolate_at(3, p, u, &first, NULL, &c), c == mark);
    wcut_curve_destroy(c);
}
