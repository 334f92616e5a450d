/* Reconstruction against faces whose deviation is known, and what it says of where there was no scan.
   labels: unit plain */
#include <string.h>
#include <wirecut/reconstruction.h>

#include "base/alloc.h"
#include "scan/faces.h"
#include "scan/kd_tree.h"
#include "scan/sheets.h"
#include "test.h"

enum { N = 60000 };
static wcut_vec3 scan[N];
static wcut_foot foot[N];
static wcut_surface *surface;
static wcut_projection *projection;
static wcut_reconstruction_options options;
static wcut_reconstruction *made;

/* a part of the face, 100 mm wide and 150 mm long, is scanned: 2 mm lower, with a bump of 1 mm and a slope */
static const double WIDE = 100, LONG = 150;

static double deviation(double x, double y) {
    return -2 + exp(-((x - 60) * (x - 60) + (y - 80) * (y - 80)) / (2 * 15 * 15)) + 0.005 * x - 0.003 * y;
}

static void given(double (*height)(double, double)) {
    surface = given_face(height);
    projection = given_projection(surface);
    options = wcut_reconstruction_options_default();
    made = NULL;
}

static void end(void) {
    wcut_reconstruction_destroy(made);
    wcut_projection_destroy(projection);
    wcut_surface_destroy(surface);
}

/* the first of `count` random points that are not within `radius` of the middle of the scan; how many */
static int given_points(int count, double radius, double noise, double (*height)(double, double)) {
    wcut_random r = wcut_random_seed(3);
    int kept = 0;
    for (int k = 0; k < count; k++) {
        const double x = WIDE * wcut_random_uniform(&r), y = LONG * wcut_random_uniform(&r);
        const double h = height(x, y) + noise * wcut_random_normal(&r);
        if (hypot(x - WIDE / 2, y - LONG / 2) >= radius) scan[kept++] = above(surface, x / 400, y / 600, h);
    }
    ck_assert_int_eq(wcut_projection_locate(projection, kept, scan, 1, foot), WCUT_OK);
    return kept;
}

static wcut_status reconstruct(int count, wcut_error *error) {
    return wcut_reconstruction_create(surface, count, scan, foot, &options, 1, &made, error);
}

/* RMS of the deviation of the vertices less the truth; the largest in `max` */
static double error_of(double (*truth)(double, double), double *max) {
    const wcut_mesh *m = made->mesh;
    double sum = 0;
    *max = 0;
    for (int k = 0; k < m->vertex_count; k++) {
        const double e = m->scalar[k] - truth(400 * m->uv[2 * k], 600 * m->uv[2 * k + 1]);
        sum += e * e;
        *max = fmax(*max, fabs(e));
    }
    return sqrt(sum / m->vertex_count);
}

static double mesh_area(const wcut_mesh *m, const wcut_vec3 *vertex) {
    double area = 0;
    for (int k = 0; k < m->triangle_count; k++) {
        const int *t = m->triangle + 3 * k;
        area += vec3_length(vec3_cross(vec3_sub(vertex[t[1]], vertex[t[0]]), vec3_sub(vertex[t[2]], vertex[t[0]]))) / 2;
    }
    return area;
}

TEST(a_known_deviation_comes_back) {
    double max;
    given(wavy_height);
    const int count = given_points(N, 0, 0, deviation);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    ck_assert_double_lt(error_of(deviation, &max), 0.002);
    ck_assert_double_lt(max, 0.02);
    ck_assert(made->used + made->beyond == count);
    ck_assert_double_eq_tol(made->point_spacing, sqrt(WIDE * LONG / N), 0.05 * made->point_spacing);
    ck_assert_double_lt(made->lost, 0.01);
    end();
}

TEST(noise_is_smoothed_and_told) {
    double max;
    given(wavy_height);
    const int count = given_points(N, 0, 0.1, deviation);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    ck_assert_double_lt(error_of(deviation, &max), 0.1 / 6);
    ck_assert_double_eq_tol(made->rms, 0.1, 0.004);
    end();
}

static double slope(double x, double y) { return 3 + 0.02 * x - 0.01 * y; }

TEST(a_plane_does_not_bend_not_even_at_its_border) {
    double max;
    given(flat_height);
    const int count = given_points(20000, 20, 0, slope);
    options.smoothing = 6;
    options.spacing = 2;
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    error_of(slope, &max);
    ck_assert_double_lt(max, 1e-4);
    ck_assert_double_lt(made->rms, 1e-5);
    end();
}

TEST(no_vertex_is_further_from_the_scan_than_the_support) {
    given(wavy_height);
    wcut_kd_tree tree;
    const int count = given_points(4000, 15, 0.05, deviation);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_kd_tree_build(count, scan, 1, &tree), WCUT_OK);
    double max = 0;
    for (int k = 0; k < made->mesh->vertex_count; k++)
        max = fmax(max, wcut_kd_tree_distance(&tree, made->mesh->vertex[k], 100));
    ck_assert_double_le(max, 1.5);
    ck_assert_double_eq_tol(max, made->farthest, 1e-12);
    wcut_kd_tree_clear(&tree);
    end();
}

TEST(distance_to_a_cloud_is_that_of_brute_force) {
    given(wavy_height);
    wcut_kd_tree tree;
    const int count = given_points(500, 15, 0.05, deviation);
    ck_assert_int_eq(wcut_kd_tree_build(count, scan, 1, &tree), WCUT_OK);
    wcut_random r = wcut_random_seed(4);
    for (int trial = 0; trial < 300; trial++) {
        const wcut_vec3 p = {WIDE * wcut_random_uniform(&r), LONG * wcut_random_uniform(&r), 170};
        double min = INFINITY;
        for (int k = 0; k < count; k++) min = fmin(min, vec3_distance(scan[k], p));
        ck_assert_double_eq_tol(wcut_kd_tree_distance(&tree, p, 1000), min, 1e-12);
        ck_assert_double_eq_tol(wcut_kd_tree_distance(&tree, p, 0.5 * min), 0.5 * min, 1e-12);
    }
    wcut_kd_tree_clear(&tree);
    end();
}

TEST(a_hole_stays_a_hole_and_is_told) {
    given(flat_height);
    const int count = given_points(N, 20, 0, deviation);
    options.block = vec3(WIDE, LONG, 300);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    ck_assert_int_eq(made->hole_count, 1);
    const double radius = 20 - options.support;
    ck_assert_double_eq_tol(made->hole[0].area, WCUT_PI * radius * radius, 0.1 * WCUT_PI * radius * radius);
    ck_assert_double_eq_tol(made->hole[0].centre.x, WIDE / 2, 0.3);
    ck_assert_double_eq_tol(made->hole[0].centre.y, LONG / 2, 0.3);
    ck_assert_int_eq(made->hole[0].open, 0);
    ck_assert_double_eq_tol(made->unmeasured_area, made->hole[0].area, 10);
    for (int k = 0; k < made->mesh->vertex_count; k++)
        ck_assert_double_gt(hypot(made->mesh->vertex[k].x - WIDE / 2, made->mesh->vertex[k].y - LONG / 2),
                            radius - 0.1);
    end();
}

TEST(mesh_and_unmeasured_make_up_the_face) {
    given(flat_height);
    const int count = given_points(N, 20, 0, deviation);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    wcut_vec3 *on_face = malloc((size_t)made->mesh->vertex_count * sizeof *on_face);
    for (int k = 0; k < made->mesh->vertex_count; k++)
        ck_assert_int_eq(wcut_surface_eval(surface, made->mesh->uv[2 * k], made->mesh->uv[2 * k + 1], 0, &on_face[k]),
                         WCUT_OK);
    const double measured = mesh_area(made->mesh, on_face),
                 open = mesh_area(made->unmeasured, made->unmeasured->vertex);
    ck_assert_double_eq_tol(open, made->unmeasured_area, 1e-3);
    ck_assert_double_eq_tol(measured + open, 400 * 600, 1e-3);
    ck_assert_double_eq_tol(made->supported_area * (1 - made->lost), measured, 1e-3);
    ck_assert_double_eq_tol(mesh_area(made->mesh, made->mesh->vertex), made->area, 1e-3);
    /* the rest of the face, and the hole; the rest is larger and reaches the border */
    ck_assert_int_eq(made->hole_count, 2);
    ck_assert(made->hole[0].area > made->hole[1].area && made->hole[0].open && !made->hole[1].open);
    free(on_face);
    end();
}

TEST(what_is_outside_the_block_is_not_missed) {
    given(flat_height);
    const int count = given_points(N, 0, 0, deviation);
    options.block = vec3(WIDE, LONG + 50, 300);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    ck_assert_double_eq_tol(made->unmeasured_area, WIDE * (50 - options.support), 0.03 * WIDE * 50);
    ck_assert_int_eq(made->hole_count, 1);
    ck_assert_int_eq(made->hole[0].open, 1);
    end();
}

TEST(normals_point_to_the_side_of_the_face) {
    given(wavy_height);
    const int count = given_points(20000, 0, 0.02, deviation);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    const wcut_mesh *m = made->mesh;
    for (int k = 0; k < m->vertex_count; k++) {
        ck_assert_double_eq_tol(vec3_length(m->normal[k]), 1, 1e-9);
        ck_assert_double_gt(m->normal[k].z, 0.5);
    }
    for (int k = 0; k < m->triangle_count; k++) {
        const int *t = m->triangle + 3 * k;
        const wcut_vec3 n =
            vec3_cross(vec3_sub(m->vertex[t[1]], m->vertex[t[0]]), vec3_sub(m->vertex[t[2]], m->vertex[t[0]]));
        ck_assert_double_gt(n.z, 0);
    }
    end();
}

TEST(points_beyond_the_border_are_left_out) {
    given(flat_height);
    const int count = given_points(20000, 0, 0, slope);
    for (int k = 0; k < 100; k++) scan[k] = vec3(-1 - 0.1 * k, 10 + k, 150);
    ck_assert_int_eq(wcut_projection_locate(projection, count, scan, 1, foot), WCUT_OK);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    ck_assert_int_eq(made->beyond, 100);
    ck_assert_int_eq(made->used, count - 100);
    double max;
    error_of(slope, &max);
    ck_assert_double_lt(max, 1e-4);
    end();
}

static void assert_same_mesh(const wcut_mesh *a, const wcut_mesh *b) {
    ck_assert_int_eq(a->vertex_count, b->vertex_count);
    ck_assert_int_eq(a->triangle_count, b->triangle_count);
    ck_assert_mem_eq(a->vertex, b->vertex, (size_t)a->vertex_count * sizeof *a->vertex);
    ck_assert_mem_eq(a->triangle, b->triangle, 3 * (size_t)a->triangle_count * sizeof *a->triangle);
}

TEST(the_result_does_not_depend_on_threads) {
    given(wavy_height);
    const int count = given_points(20000, 10, 0.05, deviation);
    ck_assert_int_eq(reconstruct(count, NULL), WCUT_OK);
    wcut_reconstruction *other = NULL;
    ck_assert_int_eq(wcut_reconstruction_create(surface, count, scan, foot, &options, 3, &other, NULL), WCUT_OK);
    assert_same_mesh(made->mesh, other->mesh);
    assert_same_mesh(made->unmeasured, other->unmeasured);
    ck_assert(made->rms == other->rms && made->lost == other->lost);
    wcut_reconstruction_destroy(other);
    end();
}

/* 1500 points, the two ways */
static void given_few(void) {
    given(flat_height);
    given_points(1500, 0, 0, slope);
}

static void assert_refused(wcut_status status, int count) {
    wcut_error error = {.status = WCUT_OK};
    ck_assert_int_eq(reconstruct(count, &error), status);
    ck_assert_int_eq(error.status, status);
    ck_assert(error.text[0]);
    ck_assert_ptr_null(made);
}

TEST(bad_arguments_are_refused) {
    given_few();
    assert_refused(WCUT_BAD_ARGUMENT, 9);
    assert_refused(WCUT_BAD_ARGUMENT, 0);
    ck_assert_int_eq(wcut_reconstruction_create(NULL, 1500, scan, foot, NULL, 1, &made, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_reconstruction_create(surface, 1500, NULL, foot, NULL, 1, &made, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_reconstruction_create(surface, 1500, scan, NULL, NULL, 1, &made, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_reconstruction_create(surface, 1500, scan, foot, NULL, 0, &made, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_reconstruction_create(surface, 1500, scan, foot, NULL, 1, NULL, NULL), WCUT_BAD_ARGUMENT);
    const wcut_reconstruction_options good = options;
    for (int k = 1; k < 8; k++) {
        options = good;
        if (k == 1) options.support = 0;
        if (k == 2) options.support = NAN;
        if (k == 3) options.spacing = -1;
        if (k == 4) options.smoothing = INFINITY;
        if (k == 5) options.block = vec3(400, 0, 300);
        if (k == 6) options.hole_min = -1;
        if (k == 7) options.spacing = 0.1; /* 24 million vertices */
        assert_refused(WCUT_BAD_ARGUMENT, 1500);
    }
    options = good;
    scan[77].z = NAN;
    assert_refused(WCUT_BAD_ARGUMENT, 1500);
    scan[77].z = 150;
    foot[88].u = 1.5;
    assert_refused(WCUT_BAD_ARGUMENT, 1500);
    foot[88].u = 0.1, foot[88].height = INFINITY;
    assert_refused(WCUT_BAD_ARGUMENT, 1500);
    end();
}

TEST(scans_that_span_nothing_are_degenerate) {
    given_few();
    for (int k = 0; k < 1500; k++) scan[k] = vec3(50, 50, 150); /* in one place */
    assert_refused(WCUT_DEGENERATE, 1500);
    for (int k = 0; k < 1500; k++) scan[k] = vec3(0.2 * k, 0.1 * k, 150); /* on one line */
    assert_refused(WCUT_DEGENERATE, 1500);
    for (int k = 0; k < 1500; k++) scan[k] = vec3(10 * (k % 3), 10 * (k / 3 % 3), 150); /* nine places */
    assert_refused(WCUT_DEGENERATE, 1500);
    given_points(1500, 0, 0, slope);
    for (int k = 5; k < 1500; k++) foot[k].beyond = 1; /* five over the face */
    assert_refused(WCUT_DEGENERATE, 1500);
    end();
}

TEST(a_grid_too_wide_for_the_support_has_no_triangle) {
    given_few();
    options.spacing = 30;
    options.support = 0.3;
    assert_refused(WCUT_DEGENERATE, 1500);
    end();
}

TEST(a_stiffness_beyond_the_solver_is_told) {
    given(wavy_height);
    const int count = given_points(20000, 0, 0.1, deviation);
    options.smoothing = 1e5;
    assert_refused(WCUT_NOT_CONVERGED, count);
    end();
}

TEST(no_memory_is_told_at_every_allocation) {
    given_few();
    options.spacing = 3;
    options.support = 6;
    EACH_FAILED_ALLOCATION(reconstruct(1500, NULL), !made);
    end();
    wcut_reconstruction_destroy(NULL);
}
