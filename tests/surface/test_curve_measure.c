/* labels: unit oracle
   Frames and arc lengths against the circle, the twisted cubic and the parabola. */
#include <wirecut/curve_measure.h>

#include "surface/shapes.h"
#include "test.h"

static wcut_curve *circle(double radius) {
    wcut_vec3 control[CIRCLE_COUNT];
    double weight[CIRCLE_COUNT];
    for (int i = 0; i < CIRCLE_COUNT; i++) {
        control[i] = vec3(radius * circle_x[i], radius * circle_y[i], 3);
        weight[i] = circle_weight(i);
    }
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(2, CIRCLE_COUNT, circle_knots, control, weight, &c), WCUT_OK);
    return c;
}

/* (t, t^2, t^3) over [0, 1] as a Bezier curve */
static wcut_curve *twisted_cubic(void) {
    const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    const wcut_vec3 control[4] = {{0, 0, 0}, {1 / 3.0, 0, 0}, {2 / 3.0, 1 / 3.0, 0}, {1, 1, 1}};
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(3, 4, knots, control, NULL, &c), WCUT_OK);
    return c;
}

TEST(a_circle_has_its_radius_its_centre_and_no_torsion) {
    wcut_curve *c = circle(40);
    for (int i = 0; i <= 100; i++) {
        wcut_frame f;
        ck_assert_int_eq(wcut_curve_frame(c, i / 100.0, &f), WCUT_OK);
        ck_assert_double_le(fabs(f.curvature * 40 - 1), 1e-12);
        ck_assert_double_le(fabs(f.torsion), 1e-12);
        ck_assert_double_le(apart(vec3_add_scaled(f.point, 40, f.normal), vec3(0, 0, 3)), 1e-11);
        ck_assert_double_le(apart(f.binormal, vec3(0, 0, 1)), 1e-13);
        ck_assert_double_le(fabs(vec3_length(f.tangent) - 1), 1e-14);
    }
    double length = 999;
    ck_assert_int_eq(wcut_curve_length(c, 0, 1, &length), WCUT_OK);
    ck_assert_double_le(fabs(length / (80 * WCUT_PI) - 1), 1e-12);
    ck_assert_int_eq(wcut_curve_length(c, 0.75, 0.25, &length), WCUT_OK);
    ck_assert_double_le(fabs(length / (-40 * WCUT_PI) - 1), 1e-12);
    for (int i = 0; i <= 50; i++) { /* an angle of the circle from its length */
        const double angle = 2 * WCUT_PI * i / 50;
        double u = 999;
        wcut_vec3 p;
        ck_assert_int_eq(wcut_curve_locate_length(c, 40 * angle, &u), WCUT_OK);
        ck_assert_int_eq(wcut_curve_eval(c, u, 0, &p), WCUT_OK);
        ck_assert_double_le(apart(p, vec3(40 * cos(angle), 40 * sin(angle), 3)), 1e-8);
    }
    wcut_curve_destroy(c);
}

TEST(the_twisted_cubic_bends_and_twists_as_its_formula_says) {
    wcut_curve *c = twisted_cubic();
    for (int i = 0; i <= 100; i++) {
        const double t = i / 100.0, t2 = t * t, t4 = t2 * t2;
        const double speed = sqrt(1 + 4 * t2 + 9 * t4), area = 2 * sqrt(9 * t4 + 9 * t2 + 1);
        wcut_frame f;
        ck_assert_int_eq(wcut_curve_frame(c, t, &f), WCUT_OK);
        ck_assert_double_le(fabs(f.curvature - area / (speed * speed * speed)), 1e-12);
        ck_assert_double_le(fabs(f.torsion - 3 / (9 * t4 + 9 * t2 + 1)), 1e-11);
        ck_assert_double_le(apart(f.normal, vec3_cross(f.binormal, f.tangent)), 1e-14);
    }
    wcut_curve_destroy(c);
}

TEST(a_parabola_has_its_length_and_gives_its_parameters_back) {
    const double knots[6] = {0, 0, 0, 1, 1, 1};
    const wcut_vec3 control[3] = {{0, 0, 0}, {50, 0, 0}, {100, 100, 0}}; /* y = x^2 / 100 */
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(2, 3, knots, control, NULL, &c), WCUT_OK);
    for (int i = 0; i <= 20; i++) {
        const double u = i / 20.0, s = 2 * u, want = 25 * (s * sqrt(1 + s * s) + asinh(s));
        double length = 999, back = 999;
        ck_assert_int_eq(wcut_curve_length(c, -1, u, &length), WCUT_OK);
        ck_assert_double_le(fabs(length - want), 1e-10);
        ck_assert_int_eq(wcut_curve_locate_length(c, length, &back), WCUT_OK);
        ck_assert_double_le(fabs(back - u), 1e-11);
    }
    wcut_curve_destroy(c);
}

TEST(beyond_the_ends_the_ends_are_given_and_a_line_is_straight) {
    const double knots[4] = {2, 2, 5, 5};
    const wcut_vec3 control[2] = {{0, 0, 0}, {3, 4, 0}};
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(1, 2, knots, control, NULL, &c), WCUT_OK);
    double u = 999;
    ck_assert_int_eq(wcut_curve_locate_length(c, -1, &u), WCUT_OK);
    ck_assert(u == 2);
    ck_assert_int_eq(wcut_curve_locate_length(c, 6, &u), WCUT_OK);
    ck_assert(u == 5);
    ck_assert_int_eq(wcut_curve_locate_length(c, 2.5, &u), WCUT_OK);
    ck_assert_double_le(fabs(u - 3.5), 1e-14);
    wcut_frame f;
    ck_assert_int_eq(wcut_curve_frame(c, 3, &f), WCUT_OK);
    ck_assert(f.curvature == 0 && f.torsion == 0 && vec3_length(f.normal) == 0 && vec3_length(f.binormal) == 0);
    ck_assert_double_le(apart(f.tangent, vec3(0.6, 0.8, 0)), 1e-15);
    wcut_curve_destroy(c);
}

TEST(what_cannot_be_measured_is_refused_and_nothing_is_written) {
    const double knots[4] = {0, 0, 1, 1};
    const wcut_vec3 point[2] = {{1, 1, 1}, {1, 1, 1}};
    wcut_curve *c = NULL;
    wcut_frame f = {.curvature = 999};
    double x = 999;
    ck_assert_int_eq(wcut_curve_create(1, 2, knots, point, NULL, &c), WCUT_OK);
    ck_assert_int_eq(wcut_curve_frame(c, 0.5, &f), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_curve_locate_length(c, 0.5, &x), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_curve_frame(c, NAN, &f), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_frame(NULL, 0, &f), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_frame(c, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_length(NULL, 0, 1, &x), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_length(c, NAN, 1, &x), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_length(c, 0, INFINITY, &x), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_length(c, 0, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate_length(NULL, 0, &x), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate_length(c, NAN, &x), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_curve_locate_length(c, 0, NULL), WCUT_BAD_ARGUMENT);
    c->control[1].x = 1e300;
    ck_assert_int_eq(wcut_curve_length(c, 0, 1, &x), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_curve_locate_length(c, 1, &x), WCUT_DEGENERATE);
    ck_assert(x == 999 && f.curvature == 999);
    wcut_curve_destroy(c);
}
