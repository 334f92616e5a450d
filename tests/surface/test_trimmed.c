/* A surface bounded by loops: what is inside, how far the border is, its triangles; deviations of what lies over it. */
#include <stdio.h>
#include <wirecut/deviation.h>
#include <wirecut/trimmed.h>

#include "base/alloc.h"
#include "surface/shapes.h"
#include "test.h"

static wcut_error error;

/* z = 0 over [0, width] x [0, length] */
static wcut_surface *plate(double width, double length) {
    static const double knot[4] = {0, 0, 1, 1};
    const wcut_vec3 corner[4] = {{0, 0, 0}, {width, 0, 0}, {0, length, 0}, {width, length, 0}};
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knot, knot, corner, NULL, &s), WCUT_OK);
    return s;
}

static wcut_curve *line(wcut_vec3 a, wcut_vec3 b) {
    static const double knot[4] = {0, 0, 1, 1};
    const wcut_vec3 end[2] = {a, b};
    wcut_curve *c = NULL;
    ck_assert_int_eq(wcut_curve_create(1, 2, knot, end, NULL, &c), WCUT_OK);
    return c;
}

static wcut_curve *circle(double x, double y, double z, double radius) {
    wcut_vec3 pole[CIRCLE_COUNT];
    double weight[CIRCLE_COUNT];
    wcut_curve *c = NULL;
    for (int i = 0; i < CIRCLE_COUNT; i++) {
        pole[i] = vec3(x + radius * circle_x[i], y + radius * circle_y[i], z);
        weight[i] = circle_weight(i);
    }
    ck_assert_int_eq(wcut_curve_create(2, CIRCLE_COUNT, circle_knots, pole, weight, &c), WCUT_OK);
    return c;
}

/* [10, 90] x [10, 70] of a plate of 100 x 80, with a hole of 20 mm about its middle (50, 40) */
enum { LOOPS = 2, CURVES = 5 };
static const int curves[LOOPS] = {4, 1};

static void make_loops(wcut_curve *curve[CURVES]) {
    static const wcut_vec3 corner[4] = {{10, 10, 0}, {90, 10, 0}, {90, 70, 0}, {10, 70, 0}};
    for (int k = 0; k < 4; k++) curve[k] = line(corner[k], corner[(k + 1) % 4]);
    curve[4] = circle(50, 40, 0, 20);
}

static void forget(wcut_curve *curve[CURVES]) {
    for (int k = 0; k < CURVES; k++) wcut_curve_destroy(curve[k]);
}

static wcut_trimmed *holed_plate(void) {
    wcut_curve *curve[CURVES];
    wcut_trimmed *t = NULL;
    make_loops(curve);
    ck_assert_msg(wcut_trimmed_create(plate(100, 80), LOOPS, curves, (const wcut_curve *const *)curve, 1e-3, &t,
                                      &error) == WCUT_OK,
                  "%s", error.text);
    forget(curve);
    return t;
}

static double area_of(const wcut_mesh *m) {
    double area = 0;
    for (int k = 0; k < m->triangle_count; k++) {
        const int *c = &m->triangle[3 * k];
        const wcut_vec3 a = m->vertex[c[0]], b = m->vertex[c[1]], d = m->vertex[c[2]];
        const double one = ((b.x - a.x) * (d.y - a.y) - (b.y - a.y) * (d.x - a.x)) / 2;
        ck_assert(one > 0);
        area += one;
    }
    return area;
}

TEST(a_plate_with_a_hole_counts_between_its_loops) {
    wcut_trimmed *t = holed_plate();
    static const struct {
        double x, y;
        int inside;
    } place[] = {{15, 15, 1}, {5, 40, 0}, {95, 40, 0}, {50, 40, 0}, {50, 59, 0}, {50, 61, 1}, {50, 75, 0}, {89, 69, 1}};
    for (size_t k = 0; k < sizeof place / sizeof *place; k++)
        ck_assert_msg(wcut_trimmed_inside(t, place[k].x / 100, place[k].y / 80) == place[k].inside, "%g %g", place[k].x,
                      place[k].y);
    ck_assert_double_eq_tol(wcut_trimmed_border(t, (wcut_vec3){50, 40, 0}), 20, 0.005);
    ck_assert_double_eq_tol(wcut_trimmed_border(t, (wcut_vec3){13, 40, 4}), 5, 1e-9);
    ck_assert_int_eq(wcut_trimmed_inside(NULL, 0, 0), 0);
    ck_assert(wcut_trimmed_border(NULL, (wcut_vec3){0, 0, 0}) == -1);

    /* triangles: the area in closed form, to the width of the cells along the border */
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_trimmed_mesh(t, 0.01, &m), WCUT_OK);
    ck_assert_double_eq_tol(area_of(m), 80 * 60 - WCUT_PI * 400, 40);
    for (int k = 0; k < m->vertex_count; k++) ck_assert(fabs(m->normal[k].z - 1) < 1e-12 && m->vertex[k].z == 0);
    wcut_mesh_destroy(m);
    wcut_trimmed_destroy(t);
}

TEST(without_loops_the_whole_surface_counts) {
    wcut_trimmed *t = NULL;
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_trimmed_create(plate(100, 80), 0, NULL, NULL, 1e-3, &t, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_trimmed_inside(t, 0.5, 0.5), 1);
    ck_assert(wcut_trimmed_border(t, (wcut_vec3){50, 40, 0}) == -1);
    ck_assert_int_eq(wcut_trimmed_mesh(t, 0.01, &m), WCUT_OK);
    ck_assert_double_eq_tol(area_of(m), 8000, 1e-9);
    wcut_mesh_destroy(m);
    wcut_trimmed_destroy(t);
}

TEST(loops_that_bound_nothing_are_refused_and_the_surface_stays_the_callers) {
    wcut_curve *curve[CURVES];
    wcut_trimmed *t = (wcut_trimmed *)&error;
    wcut_surface *s = plate(100, 80);
    make_loops(curve);
    const wcut_curve *const *all = (const wcut_curve *const *)curve;

    /* a gap, a curve off the surface, a closed surface */
    curve[2]->control[0].x += 0.5;
    ck_assert_int_eq(wcut_trimmed_create(s, LOOPS, curves, all, 1e-2, &t, &error), WCUT_DEGENERATE);
    ck_assert_ptr_nonnull(strstr(error.text, "two curves of a loop are 0.5 mm apart"));
    curve[2]->control[0].x -= 0.5;
    for (int k = 0; k < CIRCLE_COUNT; k++) curve[4]->control[k].z = 3;
    ck_assert_int_eq(wcut_trimmed_create(s, LOOPS, curves, all, 1e-2, &t, &error), WCUT_DEGENERATE);
    ck_assert_ptr_nonnull(strstr(error.text, "a curve of a loop is 3 mm off the surface"));
    wcut_surface *closed = shape_cylinder(20, 50);
    ck_assert_int_eq(wcut_trimmed_create(closed, 1, &curves[1], &all[4], 1e9, &t, &error), WCUT_DEGENERATE);
    ck_assert_ptr_nonnull(strstr(error.text, "the surface is closed"));
    wcut_surface_destroy(closed);

    /* arguments */
    static const int none[1] = {0};
    ck_assert_int_eq(wcut_trimmed_create(NULL, LOOPS, curves, all, 1e-2, &t, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_create(s, 1, none, all, 1e-2, &t, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_create(s, -1, curves, all, 1e-2, &t, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_create(s, LOOPS, curves, all, 0, &t, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_create(s, LOOPS, curves, NULL, 1e-2, &t, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_create(s, LOOPS, curves, all, 1e-2, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_trimmed_mesh(NULL, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(t, (wcut_trimmed *)&error);

    /* memory */
    for (int k = 0; k < CIRCLE_COUNT; k++) curve[4]->control[k].z = 0;
    EACH_FAILED_ALLOCATION(wcut_trimmed_create(s, LOOPS, curves, all, 1e-2, &t, &error), t == (wcut_trimmed *)&error);
    wcut_mesh *m = NULL;
    EACH_FAILED_ALLOCATION(wcut_trimmed_mesh(t, 1, &m), m == NULL);
    wcut_mesh_destroy(m);
    wcut_trimmed_destroy(t);
    forget(curve);
}

TEST(deviations_are_exact_inside_the_loops_and_beyond_outside) {
    wcut_trimmed *t = holed_plate();
    wcut_projection *p = NULL;
    static const wcut_vec3 point[] = {{20, 20, 0.3},    {50, 40, 0.3},   {5, 40, 0.3},
                                      {10.5, 40, -0.2}, {30.5, 40, 0.1}, {69, 40, 0.1}};
    static const wcut_place place[] = {WCUT_PLACE_INSIDE, WCUT_PLACE_BEYOND, WCUT_PLACE_BEYOND,
                                       WCUT_PLACE_BORDER, WCUT_PLACE_BEYOND, WCUT_PLACE_BEYOND};
    enum { POINTS = sizeof point / sizeof *point };
    wcut_deviation d[POINTS];
    ck_assert_int_eq(wcut_projection_create(t->surface, &p), WCUT_OK);
    ck_assert_int_eq(wcut_deviation_from_trimmed(t, p, POINTS, point, NULL, 1, d, NULL), WCUT_OK);
    for (int k = 0; k < POINTS; k++) {
        ck_assert_msg(d[k].place == place[k], "point %d: %s", k, wcut_place_name(d[k].place));
        ck_assert_double_eq_tol(d[k].distance, point[k].z, 1e-12);
    }

    /* the other side, and what is refused */
    wcut_deviation_options o = wcut_deviation_options_default();
    o.flip = 1;
    ck_assert_int_eq(wcut_deviation_from_trimmed(t, p, 1, point, &o, 1, d, NULL), WCUT_OK);
    ck_assert_double_eq_tol(d[0].distance, -0.3, 1e-12);
    ck_assert_int_eq(wcut_deviation_from_trimmed(NULL, p, 1, point, &o, 1, d, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_trimmed(t, NULL, 1, point, &o, 1, d, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_trimmed(t, p, 1, NULL, &o, 1, d, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_from_trimmed(t, p, 1, point, &o, 0, d, NULL), WCUT_BAD_ARGUMENT);
    d[0].distance = 999;
    EACH_FAILED_ALLOCATION(wcut_deviation_from_trimmed(t, p, 1, point, NULL, 1, d, NULL), d[0].distance == 999);
    wcut_projection_destroy(p);
    wcut_trimmed_destroy(t);
}
