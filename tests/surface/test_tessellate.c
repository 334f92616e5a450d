/* labels: unit oracle plain
   Tessellation: the tolerance held where nobody looked before, sides, poles and creases; fields on the mesh. */
#include <stdio.h>
#include <wirecut/mesh.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/chord_error.h"
#include "surface/shapes.h"
#include "test.h"

enum { SIZE = 40 };

/* a loft of SIZE x SIZE nodes (x(s, t)) */
static wcut_surface *loft_of(wcut_vec3 (*at)(double s, double t)) {
    static wcut_vec3 x[SIZE * SIZE];
    for (int j = 0; j < SIZE; j++)
        for (int i = 0; i < SIZE; i++) x[j * SIZE + i] = at(i / (SIZE - 1.0), j / (SIZE - 1.0));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(SIZE, SIZE, x, 0, &s, NULL, NULL), WCUT_OK);
    return s;
}

static wcut_vec3 twisted_plane(double s, double t) { return vec3(400 * s, 900 * t, 100 * s * t); }
static wcut_vec3 ridge(double s, double t) { return vec3(400 * s, 900 * t, 80 / (1 + 900 * (s - 0.3) * (s - 0.3))); }
static wcut_vec3 helicoid(double s, double t) { return vec3(200 * s * cos(5 * t), 200 * s * sin(5 * t), 300 * t); }

/* the index of the grid line at or before a parameter */
static int line_before(int lines, const double *uv, int stride, double at) {
    int low = 0, high = lines - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (uv[2 * (ptrdiff_t)middle * stride] <= at) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

/* the largest distance of random points of the surface from the two triangles of their cell */
static double sampled_error(const wcut_surface *s, const wcut_mesh *m, const wcut_tessellation_report *r) {
    wcut_random random = wcut_random_seed(17);
    double worst = 0, first[2], last[2];
    wcut_surface_domain(s, first, last);
    for (int k = 0; k < 50000; k++) {
        const double u = first[0] + (last[0] - first[0]) * wcut_random_uniform(&random);
        const double v = first[1] + (last[1] - first[1]) * wcut_random_uniform(&random);
        const int i = line_before(r->columns, m->uv, 1, u), j = line_before(r->rows, m->uv + 1, r->columns, v);
        const wcut_vec3 *low = m->vertex + j * r->columns + i, *high = low + r->columns;
        wcut_vec3 p;
        ck_assert_int_eq(wcut_surface_eval(s, u, v, 0, &p), WCUT_OK);
        worst = fmax(worst, fmin(wcut_triangle_distance(p, low[0], low[1], high[1]),
                                 wcut_triangle_distance(p, low[0], high[1], high[0])));
    }
    return worst;
}

/* indices in range, unit normals, triangles that turn with the normals of their corners */
static void check_mesh(const wcut_mesh *m) {
    for (int k = 0; k < m->vertex_count; k++) ck_assert_double_le(fabs(vec3_length(m->normal[k]) - 1), 1e-12);
    for (int t = 0; t < m->triangle_count; t++) {
        const int *c = m->triangle + 3 * t;
        for (int k = 0; k < 3; k++) ck_assert(c[k] >= 0 && c[k] < m->vertex_count);
        const wcut_vec3 a = m->vertex[c[0]], b = m->vertex[c[1]], d = m->vertex[c[2]];
        const wcut_vec3 up = vec3_cross(vec3_sub(b, a), vec3_sub(d, a));
        const wcut_vec3 n = vec3_add(m->normal[c[0]], vec3_add(m->normal[c[1]], m->normal[c[2]]));
        ck_assert_double_gt(vec3_dot(up, n), 0);
    }
}

static void check_held(const char *name, wcut_surface *s) {
    for (double tolerance = 1; tolerance > 0.005; tolerance /= 10) {
        wcut_mesh *m = NULL;
        wcut_tessellation_report r = {999, 999, 999};
        ck_assert_int_eq(wcut_surface_tessellate(s, tolerance, &m, &r), WCUT_OK);
        ck_assert_int_eq(m->vertex_count, r.rows * r.columns);
        const double seen = sampled_error(s, m, &r);
        printf("%-9s asked %-5g measured %.5f sampled again %.5f mm, %d x %d\n", name, tolerance, r.chord_error, seen,
               r.rows, r.columns);
        ck_assert_msg(r.chord_error <= tolerance && seen <= tolerance, "%s: %g mm at %g", name, seen, tolerance);
        ck_assert_double_le(seen, 1.07 * r.chord_error + 1e-12);
        check_mesh(m);
        wcut_mesh_destroy(m);
    }
    wcut_surface_destroy(s);
}

TEST(the_tolerance_is_held_where_nobody_looked_before) {
    check_held("sheet", loft_of(sheet_point));
    check_held("twisted", loft_of(twisted_plane));
    check_held("ridge", loft_of(ridge));
    check_held("helicoid", loft_of(helicoid));
    check_held("sphere", shape_sphere(100));
    check_held("cylinder", shape_cylinder(100, 300));
    check_held("torus", shape_torus(100, 30));
}

TEST(the_inscribed_polyhedron_of_a_sphere_lies_within_the_tolerance) {
    wcut_surface *s = shape_sphere(100);
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_surface_tessellate(s, 0.1, &m, NULL), WCUT_OK);
    double area = 0;
    for (int t = 0; t < m->triangle_count; t++) {
        const int *c = m->triangle + 3 * t;
        const wcut_vec3 a = m->vertex[c[0]], b = m->vertex[c[1]], d = m->vertex[c[2]];
        ck_assert_double_ge(wcut_triangle_distance(vec3(0, 0, 0), a, b, d), 100 - 0.1);
        area += vec3_length(vec3_cross(vec3_sub(b, a), vec3_sub(d, a))) / 2;
    }
    ck_assert_double_le(fabs(area / (4 * WCUT_PI * 1e4) - 1), 2e-3);
    for (int k = 0; k < m->vertex_count; k++) { /* poles too, where the parameters have no normal */
        const wcut_vec3 n = vec3_unit(m->vertex[k]);
        ck_assert_double_ge(vec3_dot(n, m->normal[k]), fabs(n.z) > 0.999999 ? 0.999 : 1 - 1e-9);
    }
    wcut_mesh_destroy(m);
    wcut_surface_destroy(s);
}

TEST(a_plane_is_two_triangles_and_a_crease_is_a_line_of_the_grid) {
    const double knots[5] = {0, 0, 0.3, 1, 1}, straight[4] = {0, 0, 1, 1};
    wcut_vec3 p[6] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    wcut_surface *s = NULL;
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, straight, straight, p + 1, NULL, &s), WCUT_OK);
    wcut_surface_destroy(s);
    const wcut_vec3 square[4] = {{0, 0, 5}, {2, 0, 5}, {0, 3, 5}, {2, 3, 5}};
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, straight, straight, square, NULL, &s), WCUT_OK);
    ck_assert_int_eq(wcut_surface_tessellate(s, 0.01, &m, NULL), WCUT_OK);
    ck_assert(m->vertex_count == 4 && m->triangle_count == 2 && m->normal[3].z == 1);
    wcut_mesh_destroy(m);
    wcut_surface_destroy(s);
    p[1].z = p[4].z = 1; /* a roof */
    ck_assert_int_eq(wcut_surface_create(1, 1, 3, 2, knots, straight, p, NULL, &s), WCUT_OK);
    wcut_tessellation_report r = {999, 999, 999};
    ck_assert_int_eq(wcut_surface_tessellate(s, 0.01, &m, &r), WCUT_OK);
    ck_assert(r.columns == 3 && r.rows == 2 && r.chord_error < 1e-15);
    ck_assert(m->uv[2] == 0.3 && apart(m->vertex[1], p[1]) == 0 && apart(m->vertex[4], p[4]) == 0);
    wcut_mesh_destroy(m);
    wcut_surface_destroy(s);
}

/* a flat surface, one control point of which is lifted: no coarse sample comes near it */
TEST(a_narrow_bump_is_not_missed) {
    enum { COUNT = 200 };
    static wcut_vec3 x[COUNT * COUNT];
    double knots[COUNT + 4];
    for (int k = 0; k < COUNT + 4; k++) knots[k] = clamp(k - 3, 0, COUNT - 3);
    for (int j = 0; j < COUNT; j++)
        for (int i = 0; i < COUNT; i++) x[j * COUNT + i] = vec3(i, j, i == 77 && j == 131 ? 3 : 0);
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(3, 3, COUNT, COUNT, knots, knots, x, NULL, &s), WCUT_OK);
    check_held("bump", s);
}

TEST(a_surface_without_area_is_degenerate) {
    const double knots[4] = {0, 0, 1, 1};
    const wcut_vec3 point[4] = {{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}};
    const wcut_vec3 line[4] = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    const wcut_vec3 *const flat[2] = {point, line};
    for (int k = 0; k < 2; k++) {
        wcut_mesh *const mark = (wcut_mesh *)&knots, *m = mark;
        wcut_tessellation_report r = {999, 999, 999};
        wcut_surface *s = NULL;
        ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, knots, flat[k], NULL, &s), WCUT_OK);
        ck_assert_int_eq(wcut_surface_tessellate(s, 0.1, &m, &r), WCUT_DEGENERATE);
        ck_assert(m == mark && r.rows == 999);
        wcut_surface_destroy(s);
    }
}

TEST(a_cone_keeps_no_triangle_at_its_tip) {
    const double knots[4] = {0, 0, 1, 1}, x[2] = {0, 30}, z[2] = {0, 30}, w[2] = {1, 1};
    wcut_surface *s = shape_revolve(1, 2, knots, x, z, w);
    wcut_mesh *m = NULL;
    wcut_tessellation_report r;
    ck_assert_int_eq(wcut_surface_tessellate(s, 0.01, &m, &r), WCUT_OK);
    ck_assert_int_eq(m->triangle_count, (r.columns - 1) * (2 * r.rows - 3));
    check_mesh(m);
    wcut_mesh_destroy(m);
    wcut_surface_destroy(s);
}

TEST(a_tolerance_out_of_reach_or_out_of_range_is_refused) {
    wcut_surface *s = shape_sphere(100);
    wcut_mesh *const mark = (wcut_mesh *)&circle_knots, *m = mark;
    wcut_tessellation_report r = {999, 999, 999};
    ck_assert_int_eq(wcut_surface_tessellate(s, 1e-9, &m, &r), WCUT_NOT_CONVERGED);
    ck_assert_int_eq(wcut_surface_tessellate(s, 1e-300, &m, &r), WCUT_NOT_CONVERGED);
    ck_assert_int_eq(wcut_surface_tessellate(s, 0, &m, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_tessellate(s, -1, &m, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_tessellate(s, NAN, &m, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_tessellate(NULL, 1, &m, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_tessellate(s, 1, NULL, &r), WCUT_BAD_ARGUMENT);
    ck_assert(m == mark && r.rows == 999);
    wcut_surface_destroy(s);
}

TEST(a_point_finds_its_distance_to_a_triangle) {
    wcut_random random = wcut_random_seed(19);
    for (int k = 0; k < 300; k++) {
        wcut_vec3 c[4];
        for (int i = 0; i < 4; i++)
            c[i] = vec3(wcut_random_normal(&random), wcut_random_normal(&random), wcut_random_normal(&random));
        if (k % 10 == 0) c[2] = vec3_mix(c[0], c[1], k % 20 ? 0.3 : 1); /* no area, sometimes no third corner */
        enum { STEPS = 200 };
        double min = 1e9;
        for (int i = 0; i <= STEPS; i++)
            for (int j = 0; j <= STEPS - i; j++) {
                const wcut_vec3 side = vec3_add_scaled(vec3_scale((double)i / STEPS, c[0]), (double)j / STEPS, c[1]);
                min = fmin(min, vec3_distance(c[3], vec3_add_scaled(side, (double)(STEPS - i - j) / STEPS, c[2])));
            }
        const double distance = wcut_triangle_distance(c[3], c[0], c[1], c[2]);
        ck_assert(distance <= min + 1e-12 && distance >= min - 0.05);
    }
}

TEST(a_nodal_field_is_carried_over_bilinearly) {
    enum { STATIONS = 8, NODES = 5 };
    wcut_vec3 x[STATIONS * NODES];
    double field[STATIONS * NODES], v[STATIONS];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) x[j * NODES + i] = sheet_point(i / (NODES - 1.0), j * j / 49.0);
    for (int i = 0; i < NODES; i++) x[4 * NODES + i] = x[3 * NODES + i]; /* a station that is dropped */
    wcut_surface *s = NULL;
    wcut_mesh *m = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 1e-6, &s, v, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_surface_tessellate(s, 0.05, &m, NULL), WCUT_OK);
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) field[j * NODES + i] = 2 + 3.0 * i / (NODES - 1) - 5 * v[j];
    for (int again = 0; again < 2; again++) {
        ck_assert_int_eq(wcut_mesh_sample(m, STATIONS, NODES, v, field), WCUT_OK);
        for (int k = 0; k < m->vertex_count; k++)
            ck_assert_double_le(fabs(m->scalar[k] - (2 + 3 * m->uv[2 * k] - 5 * m->uv[2 * k + 1])), 1e-12);
    }
    wcut_surface_destroy(s);
    wcut_mesh_destroy(m);
}

TEST(a_field_that_does_not_fit_is_refused_and_the_mesh_stays) {
    double v[3] = {0, 0.5, 1}, field[6] = {1, 2, 3, 4, 5, 6}, uv[2] = {0.5, 0.5};
    wcut_mesh m = {.vertex_count = 1, .uv = uv};
    const double back[3] = {0, 1, 0.5}, none[3] = {0, NAN, 1};
    ck_assert_int_eq(wcut_mesh_sample(NULL, 3, 2, v, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_sample(&m, 1, 2, v, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 1, v, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, NULL, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, v, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, back, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, none, field), WCUT_BAD_ARGUMENT);
    field[4] = INFINITY;
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, v, field), WCUT_BAD_ARGUMENT);
    field[4] = 5;
    m.uv = NULL;
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, v, field), WCUT_BAD_ARGUMENT);
    m.uv = uv;
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_mesh_sample(&m, 3, 2, v, field), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    ck_assert_ptr_null(m.scalar);
}

TEST(a_mesh_is_made_to_measure) {
    wcut_mesh *const mark = (wcut_mesh *)&circle_knots, *m = mark;
    ck_assert_int_eq(wcut_mesh_create(-1, 0, 0, &m), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_create(0, -1, 0, &m), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_create(0, INT32_MAX / 2, 0, &m), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_create(3, 1, 8, &m), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mesh_create(3, 1, 0, NULL), WCUT_BAD_ARGUMENT);
    EACH_FAILED_ALLOCATION(wcut_mesh_create(3, 1, WCUT_MESH_NORMAL | WCUT_MESH_UV | WCUT_MESH_SCALAR, &m), m == mark);
    ck_assert(m->vertex[2].z == 0 && m->normal && m->uv && m->scalar && m->triangle[2] == 0);
    wcut_mesh_destroy(m);
    ck_assert_int_eq(wcut_mesh_create(0, 0, 0, &m), WCUT_OK);
    ck_assert(!m->normal && !m->uv && !m->scalar);
    wcut_mesh_destroy(m);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    wcut_surface *s = loft_of(sheet_point);
    wcut_mesh *const mark = (wcut_mesh *)&circle_knots, *m = mark;
    wcut_tessellation_report r = {999, 999, 999};
    EACH_FAILED_ALLOCATION(wcut_surface_tessellate(s, 1, &m, &r), m == mark && r.rows == 999);
    wcut_mesh_destroy(m);
    wcut_surface_destroy(s);
}
