/* Shapes with a closed form, as rational surfaces, for the tests of the surface room. */
#ifndef WCUT_TESTS_SHAPES_H
#define WCUT_TESTS_SHAPES_H

#include <complex.h>
#include <math.h>
#include <wirecut/curve.h>
#include <wirecut/surface.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"

/* a full circle of four quadratic arcs: corners of the square around it, weighted by cos 45 deg */
enum { CIRCLE_COUNT = 9 };
static const double circle_knots[12] = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
static const double circle_x[9] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
static const double circle_y[9] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
static inline double circle_weight(int i) { return i % 2 ? sqrt(0.5) : 1; }

/* (x, z) profile of `count` weighted points turned about the z axis: u around, v along the profile */
static inline wcut_surface *shape_revolve(int degree, int count, const double *knots, const double *x, const double *z,
                                          const double *w) {
    wcut_vec3 control[CIRCLE_COUNT * CIRCLE_COUNT];
    double weight[CIRCLE_COUNT * CIRCLE_COUNT];
    for (int j = 0; j < count; j++)
        for (int i = 0; i < CIRCLE_COUNT; i++) {
            control[j * CIRCLE_COUNT + i] = vec3(x[j] * circle_x[i], x[j] * circle_y[i], z[j]);
            weight[j * CIRCLE_COUNT + i] = circle_weight(i) * w[j];
        }
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(2, degree, CIRCLE_COUNT, count, circle_knots, knots, control, weight, &s),
                     WCUT_OK);
    return s;
}

static inline wcut_surface *shape_sphere(double radius) {
    const double knots[8] = {0, 0, 0, 0.5, 0.5, 1, 1, 1}, h = sqrt(0.5), w[5] = {1, h, 1, h, 1};
    const double x[5] = {0, radius, radius, radius, 0}, z[5] = {-radius, -radius, 0, radius, radius};
    return shape_revolve(2, 5, knots, x, z, w);
}

static inline wcut_surface *shape_cylinder(double radius, double height) {
    const double knots[4] = {0, 0, 1, 1}, x[2] = {radius, radius}, z[2] = {0, height}, w[2] = {1, 1};
    return shape_revolve(1, 2, knots, x, z, w);
}

static inline wcut_surface *shape_torus(double large, double small) {
    double x[9], z[9], w[9];
    for (int i = 0; i < 9; i++) x[i] = large + small * circle_x[i], z[i] = small * circle_y[i], w[i] = circle_weight(i);
    return shape_revolve(2, 9, circle_knots, x, z, w);
}

/* exp(2 i atan t) = -1 + 2 / (1 - i t), the unit circle as a rational quadratic; its k-th derivative */
static inline double complex circle_derivative(double t, int k) {
    const double complex turn = 1 - I * t;
    double complex d = 2 / turn;
    for (int m = 1; m <= k; m++) d *= (double)m * I / turn;
    return k == 0 ? d - 1 : d;
}

/* the quarter circle whose parameter is that t in [0, 1] */
static const double quarter_knots[6] = {0, 0, 0, 1, 1, 1}, quarter_weight[3] = {1, 1, 2};
static const double quarter_x[3] = {1, 1, 0}, quarter_y[3] = {0, 1, 1};

/* an eighth of the unit sphere, both directions parameterised so */
static inline wcut_surface *shape_octant(void) {
    wcut_vec3 control[9];
    double weight[9];
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++) {
            control[3 * j + i] = vec3(quarter_x[i] * quarter_x[j], quarter_y[i] * quarter_x[j], quarter_y[j]);
            weight[3 * j + i] = quarter_weight[i] * quarter_weight[j];
        }
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(2, 2, 3, 3, quarter_knots, quarter_knots, control, weight, &s), WCUT_OK);
    return s;
}

/* a cut as a wire leaves it, 400 x 900 mm: the graph z = sheet_height(x, y), sections sagging backwards */
static inline double sheet_height(double x, double y) {
    return 150 + 40 * sin(0.007 * y + 0.004 * x) + 25 * cos(0.011 * x - 0.002 * y);
}

static inline wcut_vec3 sheet_point(double s, double t) {
    const double x = 400 * s, y = 900 * t - 240 * s * (1 - s);
    return vec3(x, y, sheet_height(x, y));
}

/* distance of a point to the sheet, to first order in it */
static inline double sheet_distance(wcut_vec3 p) {
    const double a = 0.007 * p.y + 0.004 * p.x, b = 0.011 * p.x - 0.002 * p.y;
    const double fx = 40 * 0.004 * cos(a) - 25 * 0.011 * sin(b), fy = 40 * 0.007 * cos(a) + 25 * 0.002 * sin(b);
    return fabs(p.z - sheet_height(p.x, p.y)) / sqrt(1 + fx * fx + fy * fy);
}

/* the largest |a - b| of coordinates */
static inline double apart(wcut_vec3 a, wcut_vec3 b) {
    return fmax(fabs(a.x - b.x), fmax(fabs(a.y - b.y), fabs(a.z - b.z)));
}

#endif
