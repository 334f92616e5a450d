/* labels: unit property
   Surfaces fitted to grids: the tolerance held at and between nodes, few control points, noise, kinks, too few nodes. */
#include <stdio.h>
#include <wirecut/surface_fit.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

typedef struct grid {
    int stations, nodes;
    wcut_vec3 *x;
} grid;

/* sections of the sheet, `jitter` of a step out of place, with noise [mm] across */
static grid sheet(int stations, int nodes, double jitter, double noise) {
    wcut_random random = wcut_random_seed(51);
    grid g = {stations, nodes, malloc((size_t)stations * (size_t)nodes * sizeof(wcut_vec3))};
    for (int j = 0; j < stations; j++) {
        const bool inner = j > 0 && j < stations - 1;
        const double t = (j + (inner ? jitter * (wcut_random_uniform(&random) - 0.5) : 0)) / (stations - 1);
        for (int i = 0; i < nodes; i++) {
            g.x[j * nodes + i] = sheet_point(i / (nodes - 1.0), t);
            g.x[j * nodes + i].z += noise * (wcut_random_uniform(&random) - 0.5);
        }
    }
    return g;
}

/* the largest distance of the nodes from a surface at equal steps of u and given v */
static double node_error(const grid *g, const wcut_surface *s, const double *v) {
    double max = 0;
    for (int j = 0; j < g->stations; j++)
        for (int i = 0; i < g->nodes; i++) {
            wcut_vec3 p;
            wcut_surface_eval(s, i / (g->nodes - 1.0), v[j], 0, &p);
            max = fmax(max, vec3_distance(p, g->x[j * g->nodes + i]));
        }
    return max;
}

TEST(the_tolerance_is_held_with_few_control_points) {
    grid g = sheet(2000, 200, 0.3, 0);
    double *v = malloc(2000 * sizeof *v);
    const double max_share[3] = {0.0005, 0.001, 0.004};
    double tolerance = 0.1;
    for (int k = 0; k < 3; k++, tolerance /= 10) {
        wcut_surface *s = NULL;
        wcut_surface_fit_report r = {.node_error = 999};
        ck_assert_int_eq(wcut_surface_fit(2000, 200, g.x, 0, tolerance, &s, v, &r), WCUT_OK);
        const double error = node_error(&g, s, v);
        printf("2000 x 200 nodes within %g mm: %d x %d control points, %.3f %%, worst node %.4g mm\n", tolerance,
               s->count_v, s->count_u, 100.0 * r.control_count / r.node_count, error);
        ck_assert_double_eq_tol(error, r.node_error, 1e-9);
        ck_assert(r.node_error <= tolerance && r.between_error <= tolerance && r.used == 2000 && r.dropped == 0);
        ck_assert(r.control_count == s->count_u * s->count_v && r.node_count == 400000);
        ck_assert(r.control_count < max_share[k] * r.node_count);
        ck_assert_double_le(apart(s->control[0], g.x[0]), 1e-12);
        ck_assert_double_le(apart(s->control[r.control_count - 1], g.x[399999]), 1e-12);
        wcut_surface_destroy(s);
    }
    free(v);
    free(g.x);
}

TEST(between_the_nodes_it_stays_beside_the_loft) {
    grid g = sheet(90, 40, 0.6, 0);
    wcut_surface *loft = NULL, *s = NULL;
    wcut_surface_fit_report r = {.node_error = 999};
    ck_assert_int_eq(wcut_surface_loft(90, 40, g.x, 0, &loft, NULL, NULL), WCUT_OK);
    for (double tolerance = 0.1; tolerance > 1e-4; tolerance /= 10) {
        ck_assert_int_eq(wcut_surface_fit(90, 40, g.x, 0, tolerance, &s, NULL, &r), WCUT_OK);
        double max = 0;
        wcut_random random = wcut_random_seed(52);
        for (int k = 0; k < 100000; k++) {
            const double u = wcut_random_uniform(&random), v = wcut_random_uniform(&random);
            wcut_vec3 p, q;
            wcut_surface_eval(s, u, v, 0, &p);
            wcut_surface_eval(loft, u, v, 0, &q);
            max = fmax(max, vec3_distance(p, q));
        }
        ck_assert_msg(max <= 1.1 * tolerance, "%g of %g mm", max, tolerance);
        wcut_surface_destroy(s);
    }
    wcut_surface_destroy(loft);
    free(g.x);
}

TEST(noise_below_the_tolerance_costs_few_and_above_it_every_node) {
    grid g = sheet(300, 80, 0, 0.002);
    wcut_surface *s = NULL;
    wcut_surface_fit_report r = {.node_error = 999};
    ck_assert_int_eq(wcut_surface_fit(300, 80, g.x, 0, 0.01, &s, NULL, &r), WCUT_OK);
    ck_assert(r.node_error <= 0.01 && r.control_count < 0.05 * r.node_count);
    wcut_surface_destroy(s);
    ck_assert_int_eq(wcut_surface_fit(300, 80, g.x, 0, 0.0002, &s, NULL, &r), WCUT_OK);
    ck_assert(r.node_error <= 0.0002 && r.between_error <= 0.0002);
    wcut_surface_destroy(s);
    free(g.x);
}

TEST(a_kink_and_repeated_sections_are_followed) {
    grid g = sheet(400, 60, 0, 0);
    for (int j = 0; j < 400; j++)
        for (int i = 0; i < 60; i++) {
            g.x[j * 60 + i].z += 20 * fabs(j / 399.0 - 0.4); /* the wire turns */
            if (j == 100 || j == 101) g.x[j * 60 + i] = g.x[99 * 60 + i];
        }
    double v[400];
    wcut_surface *s = NULL;
    wcut_surface_fit_report r = {.node_error = 999};
    ck_assert_int_eq(wcut_surface_fit(400, 60, g.x, 1e-6, 0.01, &s, v, &r), WCUT_OK);
    ck_assert(r.node_error <= 0.01 && r.between_error <= 0.01 && r.dropped == 2 && r.used == 398);
    ck_assert(v[100] == v[99] && v[101] == v[99] && node_error(&g, s, v) <= 0.01 + 1e-9);
    printf("a kink: %d x %d control points\n", s->count_v, s->count_u);
    ck_assert_double_lt(r.control_count, 0.2 * r.node_count);
    wcut_surface_destroy(s);
    free(g.x);
}

TEST(a_plane_needs_next_to_nothing_and_few_nodes_are_lofted) {
    wcut_vec3 x[30 * 20];
    for (int k = 0; k < 600; k++) x[k] = vec3(10 * (k % 20), 7 * (k / 20.0 - k % 20 / 20.0), 3);
    wcut_surface *s = NULL;
    wcut_surface_fit_report r = {.node_error = 999};
    ck_assert_int_eq(wcut_surface_fit(30, 20, x, 0, 1e-6, &s, NULL, &r), WCUT_OK);
    ck_assert(r.control_count <= 64 && r.node_error <= 1e-6);
    wcut_surface_destroy(s);
    for (int stations = 2; stations < 8; stations++)
        for (int nodes = 2; nodes < 8; nodes++) {
            grid g = sheet(stations, nodes, 0, 0);
            double v[8];
            ck_assert_int_eq(wcut_surface_fit(stations, nodes, g.x, 0, 1e-3, &s, v, &r), WCUT_OK);
            ck_assert_double_le(node_error(&g, s, v), 1e-3);
            wcut_surface_destroy(s);
            free(g.x);
        }
}

TEST(what_cannot_be_fitted_is_refused_and_nothing_is_written) {
    grid g = sheet(30, 20, 0, 0);
    double v[30] = {999};
    wcut_surface *const mark = (wcut_surface *)&g, *s = mark;
    wcut_surface_fit_report r = {.node_error = 999};
    ck_assert_int_eq(wcut_surface_fit(1, 20, g.x, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_fit(30, 1, g.x, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_fit(30, 20, NULL, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_fit(30, 20, g.x, -1, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_fit(30, 20, g.x, 0, 0, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_fit(30, 20, g.x, 0, 1, NULL, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_fit(30, 20, g.x, 1e9, 1, &s, v, &r), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_surface_fit(30, 20, g.x, 0, 1e-200, &s, v, &r), WCUT_NOT_CONVERGED);
    EACH_FAILED_ALLOCATION(wcut_surface_fit(30, 20, g.x, 0, 0.1, &s, v, &r),
                           s == mark && v[0] == 999 && r.node_error == 999);
    wcut_surface_destroy(s);
    g.x[77].y = INFINITY;
    s = mark;
    ck_assert_int_eq(wcut_surface_fit(30, 20, g.x, 0, 1, &s, v, &r), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(s, mark);
    free(g.x);
}
