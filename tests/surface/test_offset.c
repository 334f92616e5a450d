/* labels: unit property
   Offsets against spheres, tori and their own definition; folds, crossings and creases found where they were made. */
#include <stdio.h>
#include <wirecut/crossing.h>
#include <wirecut/curvature.h>
#include <wirecut/offset.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

/* the largest distance of a surface from S + distance n at random parameters */
static double offset_error(const wcut_surface *s, const wcut_surface *o, double distance, int points) {
    wcut_random random = wcut_random_seed(31);
    double first[2], last[2], max = 0;
    wcut_surface_domain(s, first, last);
    for (int k = 0; k < points; k++) {
        const double u = first[0] + (last[0] - first[0]) * wcut_random_uniform(&random);
        const double v = first[1] + (last[1] - first[1]) * wcut_random_uniform(&random);
        wcut_vec3 p, q, n;
        ck_assert_int_eq(wcut_surface_eval(s, u, v, 0, &p), WCUT_OK);
        ck_assert_int_eq(wcut_surface_eval(o, u, v, 0, &q), WCUT_OK);
        ck_assert_int_eq(wcut_surface_normal(s, u, v, &n), WCUT_OK);
        max = fmax(max, vec3_distance(q, vec3_add_scaled(p, distance, n)));
    }
    return max;
}

static wcut_surface *lofted_sheet(int stations, int nodes) {
    wcut_vec3 *x = malloc((size_t)stations * (size_t)nodes * sizeof *x);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) x[j * nodes + i] = sheet_point(i / (nodes - 1.0), j / (stations - 1.0));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(stations, nodes, x, 0, &s, NULL, NULL), WCUT_OK);
    free(x);
    return s;
}

TEST(the_offset_of_a_sphere_and_a_torus_is_another) {
    for (int which = 0; which < 2; which++)
        for (double tolerance = 1e-2; tolerance > 1e-6; tolerance /= 30) {
            wcut_surface *s = which ? shape_torus(50, 20) : shape_sphere(40), *o = NULL;
            wcut_offset_report report = {.error = 999};
            ck_assert_int_eq(wcut_surface_offset(s, 3, tolerance, &o, &report), WCUT_OK);
            ck_assert(report.error <= tolerance && report.folds == 0 && report.crossings == 0);
            double max = 0;
            for (int i = 0; i <= 200; i++)
                for (int j = 0; j <= 200; j++) {
                    wcut_vec3 p;
                    ck_assert_int_eq(wcut_surface_eval(o, i / 200.0, j / 200.0, 0, &p), WCUT_OK);
                    const double off = which ? hypot(hypot(p.x, p.y) - 50, p.z) - 23 : vec3_length(p) - 43;
                    max = fmax(max, fabs(off));
                }
            ck_assert_msg(max <= 1.1 * tolerance, "%d: %g of %g mm", which, max, tolerance);
            wcut_surface_destroy(o);
            wcut_surface_destroy(s);
        }
}

TEST(the_offset_of_a_loft_is_where_its_definition_says) {
    for (int fine = 0; fine < 2; fine++) {
        wcut_surface *s = fine ? lofted_sheet(200, 60) : lofted_sheet(25, 17), *o = NULL;
        wcut_offset_report report = {.error = 999};
        ck_assert_int_eq(wcut_surface_offset(s, -1.5, 1e-3, &o, &report), WCUT_OK);
        const double error = offset_error(s, o, -1.5, 100000);
        printf("offset of %d x %d: %d x %d control points, measured %.2g, sampled %.2g mm\n", s->count_v, s->count_u,
               o->count_v, o->count_u, report.error, error);
        ck_assert(report.error <= 1e-3 && error <= 1.1e-3 && report.folds == 0 && report.crossings == 0);
        wcut_surface_destroy(o);
        wcut_surface_destroy(s);
    }
}

/* a trough z = a x^2, curvature 2 a at its bottom */
static wcut_surface *trough(double a) {
    const double knots_u[6] = {0, 0, 0, 1, 1, 1}, knots_v[4] = {0, 0, 1, 1};
    wcut_vec3 control[6];
    for (int j = 0; j < 2; j++)
        for (int i = 0; i < 3; i++) control[3 * j + i] = vec3(40 * (i - 1), 100 * j, 1600 * a * (i == 1 ? -1 : 1));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(2, 1, 3, 2, knots_u, knots_v, control, NULL, &s), WCUT_OK);
    return s;
}

TEST(an_offset_beyond_the_radius_folds_and_crosses_and_says_where) {
    wcut_surface *s = trough(0.05), *o = NULL; /* bends towards +z with a radius of 10 mm */
    wcut_offset_report report = {.error = 999};
    ck_assert_int_eq(wcut_surface_offset(s, 5, 1e-3, &o, &report), WCUT_OK);
    ck_assert(report.folds == 0 && report.crossings == 0);
    ck_assert_double_eq_tol(report.curvature, 0.1, 1e-9);
    ck_assert_double_eq_tol(report.tight_u, 0.5, 1e-9);
    wcut_surface_destroy(o);
    ck_assert_int_eq(wcut_surface_offset(s, 15, 1e-2, &o, &report), WCUT_OK);
    ck_assert(report.folds > 0 && report.crossings > 0);
    /* one side crosses the other */
    ck_assert((report.crossing_u[0] - 0.5) * (report.crossing_u[1] - 0.5) < 0);
    wcut_surface_destroy(o);
    ck_assert_int_eq(wcut_surface_offset(s, -15, 1e-2, &o, &report), WCUT_OK);
    ck_assert(report.folds == 0 && report.crossings == 0 && report.curvature <= 1e-12);
    wcut_surface_destroy(o);
    wcut_surface_destroy(s);
}

TEST(necks_narrower_than_two_offsets_cross_without_a_fold) {
    /* a meander: direction 2.1 cos s, its tightest radius 20 / 2.1 = 9.5 mm, its necks 9.1 mm wide */
    enum { STATIONS = 161, NODES = 5, FINE = 50 };
    static wcut_vec3 x[STATIONS * NODES];
    double along = 0, up = 0;
    for (int j = 0; j < STATIONS; j++) {
        for (int i = 0; i < NODES; i++) x[j * NODES + i] = vec3(along, up, 10 * i);
        for (int k = 0; k < FINE; k++) {
            const double step = 2 * WCUT_PI / ((STATIONS - 1) * FINE), s = -WCUT_PI + (j * FINE + k + 0.5) * step;
            along += 20 * step * cos(2.1 * cos(s)), up += 20 * step * sin(2.1 * cos(s));
        }
    }
    wcut_surface *s = NULL, *o = NULL;
    wcut_offset_report report = {.error = 999};
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    for (int side = -1; side <= 1; side += 2) {
        ck_assert_int_eq(wcut_surface_offset(s, 2 * side, 1e-3, &o, &report), WCUT_OK);
        ck_assert(report.crossings == 0 && report.folds == 0);
        ck_assert_double_eq_tol(report.curvature, 0.105, 1e-3);
        wcut_surface_destroy(o);
    }
    int crossings = 0;
    for (int side = -1; side <= 1; side += 2) {
        ck_assert_int_eq(wcut_surface_offset(s, 8 * side, 1e-3, &o, &report), WCUT_OK);
        ck_assert_int_eq(report.folds, 0);
        crossings += report.crossings;
        wcut_surface_destroy(o);
    }
    ck_assert_int_gt(crossings, 0);
    wcut_surface_destroy(s);
}

TEST(a_crease_has_no_offset) {
    const double knots[5] = {0, 0, 0.5, 1, 1}, across[4] = {0, 0, 1, 1};
    const wcut_vec3 control[6] = {{0, 0, 0}, {10, 0, 5}, {20, 0, 0}, {0, 9, 0}, {10, 9, 5}, {20, 9, 0}};
    wcut_surface *s = NULL, *const mark = (wcut_surface *)&knots, *o = mark;
    wcut_offset_report report = {.error = 999};
    ck_assert_int_eq(wcut_surface_create(1, 1, 3, 2, knots, across, control, NULL, &s), WCUT_OK);
    ck_assert_int_eq(wcut_surface_offset(s, 1, 1e-3, &o, &report), WCUT_DEGENERATE);
    for (int k = 0; k < 6; k++) s->control[k].z = 0; /* a plane with the same knots has one */
    ck_assert(o == mark && report.error == 999);
    ck_assert_int_eq(wcut_surface_offset(s, 1, 1e-3, &o, &report), WCUT_OK);
    ck_assert_double_le(offset_error(s, o, 1, 100), 1e-12);
    wcut_surface_destroy(o);
    for (int k = 0; k < 6; k++) s->control[k].x = 0; /* no area */
    o = mark;
    ck_assert_int_eq(wcut_surface_offset(s, 1, 1e-3, &o, NULL), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_surface_offset(s, NAN, 1e-3, &o, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_offset(s, 1, 0, &o, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_offset(NULL, 1, 1, &o, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_offset(s, 1, 1, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(o, mark);
    wcut_surface_destroy(s);
}

TEST(a_tolerance_out_of_reach_is_not_converged) {
    wcut_surface *s = shape_torus(50, 20), *o = s;
    ck_assert_int_eq(wcut_surface_offset(s, 3, 1e-16, &o, NULL), WCUT_NOT_CONVERGED);
    ck_assert_ptr_eq(o, s);
    wcut_surface_destroy(s);
}

/* sections of 9 nodes along x, each turned about x by more: at 1 the far half is upside down */
static wcut_surface *turning(bool pass) {
    enum { STATIONS = 13, NODES = 9 };
    wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) {
            const double s = 2.0 * i / (NODES - 1) - 1, t = j / (STATIONS - 1.0);
            /* the ends of the wire pass one another: a bow tie seen from above */
            x[j * NODES + i] = vec3(100 * s, pass ? 60 * t * s + 5 * s * s : 60 * t + 5 * s * s, 3 * sin(2 * t) * s);
        }
    wcut_surface *surface = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &surface, NULL, NULL), WCUT_OK);
    return surface;
}

TEST(a_loft_whose_sections_pass_one_another_is_told_to_fold_and_where) {
    wcut_surface_report report = {.folds = 999};
    wcut_surface *s = turning(false);
    ck_assert_int_eq(wcut_surface_inspect(s, 0.05, &report), WCUT_OK);
    ck_assert(report.folds == 0 && report.crossings == 0 && report.poles == 0 && !report.closed_u && !report.closed_v);
    wcut_surface_destroy(s);
    s = turning(true);
    ck_assert_int_eq(wcut_surface_inspect(s, 0.05, &report), WCUT_OK);
    ck_assert(report.folds > 0 && fabs(report.fold_u - 0.5) < 0.2);
    wcut_surface_destroy(s);
}

TEST(closed_surfaces_and_poles_are_known_and_nothing_is_found_wrong_with_them) {
    wcut_surface *const shape[4] = {shape_sphere(30), shape_torus(50, 20), shape_cylinder(20, 50), shape_octant()};
    const int closed_u[4] = {1, 1, 1, 0}, closed_v[4] = {0, 1, 0, 0}, poles[4] = {2, 0, 0, 1};
    for (int k = 0; k < 4; k++) {
        wcut_surface_report r = {.folds = 999};
        for (double tolerance = 10; tolerance > 0.01; tolerance /= 7) {
            if (k == 3 && tolerance > 0.1) continue;
            ck_assert_int_eq(wcut_surface_inspect(shape[k], tolerance, &r), WCUT_OK);
            ck_assert_msg(r.closed_u == closed_u[k] && r.closed_v == closed_v[k] && r.poles == poles[k] &&
                              r.folds == 0 && r.crossings == 0,
                          "shape %d at %g: %d %d, %d poles, %d folds, %d crossings", k, tolerance, r.closed_u,
                          r.closed_v, r.poles, r.folds, r.crossings);
        }
        wcut_surface_destroy(shape[k]);
    }
}

TEST(triangles_that_cross_are_all_found) {
    enum { COUNT = 60 };
    wcut_random random = wcut_random_seed(32);
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_mesh_create(3 * COUNT, COUNT, 0, &m), WCUT_OK);
    for (int k = 0; k < 3 * COUNT; k++) {
        m->vertex[k] = vec3(wcut_random_uniform(&random), wcut_random_uniform(&random), wcut_random_uniform(&random));
        m->triangle[k] = k;
    }
    /* each pair alone is a mesh, too: no tree to speak of */
    int expected = 0;
    for (int a = 0; a < COUNT; a++)
        for (int b = a + 1; b < COUNT; b++) {
            wcut_vec3 corner[6];
            int index[6] = {0, 1, 2, 3, 4, 5}, found = 999;
            for (int k = 0; k < 3; k++) corner[k] = m->vertex[3 * a + k], corner[3 + k] = m->vertex[3 * b + k];
            const wcut_mesh pair = {.vertex_count = 6, .triangle_count = 2, .vertex = corner, .triangle = index};
            ck_assert_int_eq(wcut_mesh_crossings(&pair, 0, NULL, &found), WCUT_OK);
            expected += found;
        }
    wcut_crossing first[7], all[COUNT * COUNT];
    int count = 999, again = 999;
    ck_assert_int_eq(wcut_mesh_crossings(m, COUNT * COUNT, all, &count), WCUT_OK);
    ck_assert_int_eq(wcut_mesh_crossings(m, 7, first, &again), WCUT_OK);
    ck_assert(count == expected && again == expected && expected > 100);
    for (int k = 0; k < count; k++) {
        ck_assert(all[k].first < all[k].second);
        if (k < 7) ck_assert(first[k].first == all[k].first && first[k].second == all[k].second);
        if (k > 0)
            ck_assert(all[k].first > all[k - 1].first ||
                      (all[k].first == all[k - 1].first && all[k].second > all[k - 1].second));
    }
    /* two that cross at a known place */
    const wcut_vec3 known[6] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 3}, {9, 9, 9}};
    for (int k = 0; k < 6; k++) m->vertex[k] = known[k];
    m->triangle_count = 2;
    ck_assert_int_eq(wcut_mesh_crossings(m, 1, first, &count), WCUT_OK);
    ck_assert(count == 1 && apart(first[0].point, vec3(1, 1, 0)) < 1e-12);
    count = 999;
    ck_assert_int_eq(wcut_mesh_crossings(NULL, 1, first, &count), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_crossings(m, -1, first, &count), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_crossings(m, 1, NULL, &count), WCUT_BAD_ARGUMENT);
    m->vertex[0].x = NAN;
    ck_assert_int_eq(wcut_mesh_crossings(m, 1, first, &count), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(count, 999);
    wcut_mesh_destroy(m);
}

TEST(what_cannot_be_inspected_is_refused) {
    wcut_surface *s = shape_torus(50, 20);
    wcut_surface_report r = {.folds = 999};
    ck_assert_int_eq(wcut_surface_inspect(NULL, 1, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_inspect(s, 0, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_inspect(s, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_inspect(s, 1e-12, &r), WCUT_NOT_CONVERGED);
    for (int k = 0; k < s->count_u * s->count_v; k++) s->control[k].y = s->control[k].z = 0;
    ck_assert_int_eq(wcut_surface_inspect(s, 0.1, &r), WCUT_DEGENERATE);
    ck_assert_int_eq(r.folds, 999);
    wcut_surface_destroy(s);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    wcut_surface *s = trough(0.001), *const mark = (wcut_surface *)&s;
    for (int which = 0; which < 2; which++) {
        wcut_surface *o = mark;
        wcut_offset_report report = {.error = 999};
        wcut_surface_report looked = {.chord_error = 999};
        EACH_FAILED_ALLOCATION(which ? wcut_surface_inspect(s, 1, &looked) : wcut_surface_offset(s, 2, 1, &o, &report),
                               o == mark && report.error == 999 && looked.chord_error == 999);
        if (o != mark) wcut_surface_destroy(o);
    }
    wcut_surface_destroy(s);
}
