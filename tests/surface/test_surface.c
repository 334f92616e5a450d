/* labels: unit oracle
   Surfaces against shapes with a closed form, and the loft against the sheets its sections were taken from. */
#include <stdio.h>
#include <wirecut/surface.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

TEST(mixed_derivatives_to_third_order_are_the_spheres) {
    wcut_surface *s = shape_octant();
    for (int a = 0; a <= 20; a++)
        for (int b = 0; b <= 20; b++) {
            const double u = a / 20.0, v = b / 20.0;
            wcut_vec3 d[16];
            ck_assert_int_eq(wcut_surface_eval(s, u, v, 3, d), WCUT_OK);
            for (int k = 0; k <= 3; k++)
                for (int l = 0; l <= 3; l++) {
                    const double complex around = circle_derivative(u, k), up = circle_derivative(v, l);
                    wcut_vec3 want = vec3(creal(around) * creal(up), cimag(around) * creal(up), k ? 0 : cimag(up));
                    if (k + l > 3) want = vec3(0, 0, 0);
                    ck_assert_double_le(apart(d[4 * k + l], want), 5e-12);
                }
        }
    wcut_surface_destroy(s);
}

TEST(sphere_cylinder_and_torus_are_exact) {
    wcut_surface *sphere = shape_sphere(50), *cylinder = shape_cylinder(50, 80), *torus = shape_torus(50, 20);
    wcut_random random = wcut_random_seed(7);
    for (int k = 0; k < 20000; k++) {
        const double u = wcut_random_uniform(&random), v = wcut_random_uniform(&random);
        wcut_vec3 p;
        ck_assert_int_eq(wcut_surface_eval(sphere, u, v, 0, &p), WCUT_OK);
        ck_assert_double_le(fabs(vec3_length(p) / 50 - 1), 1e-12);
        ck_assert_int_eq(wcut_surface_eval(cylinder, u, v, 0, &p), WCUT_OK);
        ck_assert_double_le(fabs(hypot(p.x, p.y) / 50 - 1), 1e-12);
        ck_assert_double_le(fabs(p.z - 80 * v), 1e-12);
        ck_assert_int_eq(wcut_surface_eval(torus, u, v, 0, &p), WCUT_OK);
        ck_assert_double_le(fabs(hypot(hypot(p.x, p.y) - 50, p.z) / 20 - 1), 1e-12);
    }
    wcut_surface_destroy(sphere);
    wcut_surface_destroy(cylinder);
    wcut_surface_destroy(torus);
}

TEST(a_grid_gives_what_single_points_give) {
    enum { U = 37, V = 23 };
    static wcut_vec3 grid[U * V];
    double u[U], v[V];
    for (int i = 0; i < U; i++) u[i] = -0.1 + 1.2 * i / (U - 1);
    for (int j = 0; j < V; j++) v[j] = 1 - (double)j / (V - 1);
    wcut_surface *s = shape_torus(50, 20);
    ck_assert_int_eq(wcut_surface_eval_grid(s, U, u, V, v, grid), WCUT_OK);
    for (int j = 0; j < V; j++)
        for (int i = 0; i < U; i++) {
            wcut_vec3 p;
            ck_assert_int_eq(wcut_surface_eval(s, u[i], v[j], 0, &p), WCUT_OK);
            ck_assert_double_le(apart(p, grid[j * U + i]), 1e-13 * 100);
        }
    wcut_surface_destroy(s);
}

TEST(what_is_no_surface_is_refused_and_nothing_is_written) {
    const double knots[4] = {0, 0, 1, 1}, bad_knots[4] = {0, 0, 0, 0}, weights[4] = {1, 1, -1, 1};
    wcut_vec3 p[4] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    wcut_surface *const mark = (wcut_surface *)&knots, *s = mark;
    ck_assert_int_eq(wcut_surface_create(0, 1, 2, 2, knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 8, 2, 2, knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 1, 2, knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, -2, knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 1 << 20, 1 << 20, knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, bad_knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, bad_knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, knots, NULL, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, knots, p, weights, &s), WCUT_BAD_ARGUMENT);
    p[3].z = NAN;
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, knots, p, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_eq(s, mark);
}

TEST(evaluation_refuses_what_it_does_not_know) {
    wcut_surface *s = shape_octant();
    wcut_vec3 d[16] = {{999, 999, 999}};
    const double u[2] = {0, NAN};
    ck_assert_int_eq(wcut_surface_eval(NULL, 0, 0, 0, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval(s, 0, INFINITY, 0, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval(s, NAN, 0, 0, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval(s, 0, 0, 4, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval(s, 0, 0, -1, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval(s, 0, 0, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval_grid(s, 2, u, 1, u, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval_grid(s, 1, u, 2, u, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval_grid(s, 0, u, 1, u, d), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_eval_grid(NULL, 1, u, 1, u, d), WCUT_BAD_ARGUMENT);
    ck_assert(d[0].x == 999);
    wcut_surface_destroy(s);
}

/* worst distance of a loft's nodes from where they were */
static double nodes_back(int stations, int nodes, const wcut_vec3 *x, double merge) {
    double *v = malloc((size_t)stations * sizeof *v), worst = 0;
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(stations, nodes, x, merge, &s, v, NULL), WCUT_OK);
    ck_assert(v[0] == 0 && v[stations - 1] == 1);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) {
            wcut_vec3 p;
            ck_assert_int_eq(wcut_surface_eval(s, (double)i / (nodes - 1), v[j], 0, &p), WCUT_OK);
            worst = fmax(worst, vec3_distance(p, x[j * nodes + i]));
        }
    wcut_surface_destroy(s);
    free(v);
    return worst;
}

TEST(a_loft_of_any_size_gives_its_nodes_back) {
    enum { MAX = 41 };
    static wcut_vec3 x[MAX * MAX];
    wcut_random random = wcut_random_seed(11);
    for (int stations = 2; stations <= MAX; stations += stations < 6 ? 1 : 7)
        for (int nodes = 2; nodes <= MAX; nodes += nodes < 6 ? 1 : 7) {
            double y = 0;
            for (int j = 0; j < stations; j++) {
                y += j % 5 == 1 ? 0.05 : 0.2 + 30 * wcut_random_uniform(&random);
                for (int i = 0; i < nodes; i++)
                    x[j * nodes + i] = vec3(400.0 * i / (nodes - 1) + wcut_random_normal(&random), y,
                                            150 + 10 * wcut_random_normal(&random));
            }
            ck_assert_double_lt(nodes_back(stations, nodes, x, 0), 1e-9);
        }
}

TEST(sections_that_share_a_mount_or_close_upon_themselves_are_lofted) {
    enum { STATIONS = 30, NODES = 20 };
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) { /* a fan about the first node, all the way round */
            const double r = 10.0 * i, a = 2 * WCUT_PI * j / (STATIONS - 1);
            x[j * NODES + i] = vec3(r * cos(a), r * sin(a), i);
        }
    for (int i = 0; i < NODES; i++) x[(STATIONS - 1) * NODES + i] = x[i];
    ck_assert_double_lt(nodes_back(STATIONS, NODES, x, 1e-6), 1e-9);
}

TEST(a_loft_through_a_plane_lies_in_it) {
    enum { STATIONS = 25, NODES = 17 };
    static wcut_vec3 x[STATIONS * NODES];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) {
            const double a = 20 * i + 3 * sin(j), b = 7 * j + 2 * cos(2 * i + j);
            x[j * NODES + i] = vec3(a, b, 10 + 0.3 * a - 0.7 * b);
        }
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, x, 0, &s, NULL, NULL), WCUT_OK);
    for (int a = 0; a <= 100; a++)
        for (int b = 0; b <= 100; b++) {
            wcut_vec3 p;
            ck_assert_int_eq(wcut_surface_eval(s, a / 100.0, b / 100.0, 0, &p), WCUT_OK);
            ck_assert_double_le(fabs(p.z - (10 + 0.3 * p.x - 0.7 * p.y)), 1e-10);
        }
    wcut_surface_destroy(s);
}

/* worst distance between the sheet and the loft through sections of it at t[] */
static double loft_error(int stations, int nodes, const double *t) {
    wcut_vec3 *x = malloc((size_t)stations * (size_t)nodes * sizeof *x);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) x[j * nodes + i] = sheet_point((double)i / (nodes - 1), t[j]);
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(stations, nodes, x, 0, &s, NULL, NULL), WCUT_OK);
    double worst = 0;
    for (int a = 0; a <= 400; a++)
        for (int b = 0; b <= 400; b++) {
            wcut_vec3 p;
            ck_assert_int_eq(wcut_surface_eval(s, a / 400.0, b / 400.0, 0, &p), WCUT_OK);
            worst = fmax(worst, sheet_distance(p));
        }
    wcut_surface_destroy(s);
    free(x);
    return worst;
}

/* 0 even, 1 jittered by up to 45 % of a step, 2 alternating long and short 20 : 1, 3 growing smoothly 1 : 20 */
static void place_stations(int stations, int how, double *t) {
    wcut_random random = wcut_random_seed(13);
    t[0] = 0;
    for (int j = 1; j < stations; j++) {
        double step = 1;
        if (how == 2) step = j % 2 ? 1 : 20;
        if (how == 3) step = pow(20, (double)j / stations);
        t[j] = t[j - 1] + step;
    }
    for (int j = 0; j < stations; j++) {
        t[j] /= t[stations - 1];
        if (how == 1 && j > 0 && j < stations - 1)
            t[j] += 0.45 * (2 * wcut_random_uniform(&random) - 1) / (stations - 1);
    }
}

TEST(a_loft_follows_its_sheet_however_its_sections_are_spaced) {
    static const char *const name[4] = {"even", "jittered", "alternating 20:1", "growing 1:20"};
    const double max[4] = {0.004, 0.004, 0.004, 0.04};
    for (int how = 0; how < 4; how++) {
        double t[60];
        place_stations(60, how, t);
        const double error = loft_error(60, 25, t);
        printf("loft of 60 sections of 25 nodes, %s: %.4f mm\n", name[how], error);
        ck_assert_msg(error < max[how], "%s: %g mm", name[how], error);
    }
}

TEST(a_loft_converges_with_the_fourth_order) {
    double t[121];
    place_stations(61, 0, t);
    const double coarse = loft_error(61, 26, t);
    place_stations(121, 0, t);
    const double order = log2(coarse / loft_error(121, 51, t));
    ck_assert_msg(order > 3.6, "order %.2f from %g mm", order, coarse);
}

enum { STATIONS = 12, NODES = 9 };
static wcut_vec3 sections[STATIONS * NODES];

static void given_sections(void) {
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) sections[j * NODES + i] = sheet_point(i / (NODES - 1.0), j / (STATIONS - 1.0));
}

/* make section j that of the one before, moved by so much */
static void repeat_section(int j, double by) {
    for (int i = 0; i < NODES; i++) {
        sections[j * NODES + i] = sections[(j - 1) * NODES + i];
        sections[j * NODES + i].y += by;
    }
}

TEST(repeated_and_nearly_coincident_sections_are_dropped_and_counted) {
    given_sections();
    repeat_section(3, 0);
    repeat_section(7, 1e-4);
    repeat_section(8, 1e-4);
    repeat_section(11, 1e-15);
    double v[STATIONS];
    wcut_loft_report report = {999, 999};
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 1e-3, &s, v, &report), WCUT_OK);
    ck_assert(report.used == STATIONS - 4 && report.dropped == 4 && s->count_v == STATIONS - 4);
    ck_assert(v[3] == v[2] && v[7] == v[6] && v[8] == v[6] && v[11] == v[10] && v[10] == 1);
    wcut_surface_destroy(s);
    /* without a distance to merge at, only what rounding cannot tell apart is dropped */
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 0, &s, v, &report), WCUT_OK);
    ck_assert(report.used == STATIONS - 2 && report.dropped == 2 && v[7] > v[6] && v[8] > v[7]);
    wcut_surface_destroy(s);
}

TEST(a_slow_drift_is_not_dropped_whole) {
    given_sections();
    for (int j = 1; j < STATIONS; j++) repeat_section(j, 0.4);
    wcut_loft_report report = {999, 999};
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 1, &s, NULL, &report), WCUT_OK);
    ck_assert(report.used == 4 && report.dropped == 8); /* stations 0, 3, 6, 9 */
    wcut_surface_destroy(s);
}

TEST(what_cannot_be_lofted_is_refused_and_nothing_is_written) {
    wcut_surface *const mark = (wcut_surface *)&sections, *s = mark;
    double v[STATIONS];
    wcut_loft_report report = {999, 999};
    for (int j = 0; j < STATIONS; j++) v[j] = 999;
    given_sections();
    ck_assert_int_eq(wcut_surface_loft(1, NODES, sections, 0, &s, v, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft(STATIONS, 1, sections, 0, &s, v, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft(1 << 20, 1 << 20, sections, 0, &s, v, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, NULL, 0, &s, v, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 0, NULL, v, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, -1, &s, v, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, NAN, &s, v, &report), WCUT_BAD_ARGUMENT);
    sections[50].y = NAN;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 0, &s, v, &report), WCUT_BAD_ARGUMENT);
    sections[50].y = 1.7e308, sections[60].y = -1.7e308; /* the way between them overflows */
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 0, &s, v, &report), WCUT_DEGENERATE);
    given_sections();
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 1e4, &s, v, &report), WCUT_DEGENERATE);
    for (int j = 1; j < STATIONS; j++) repeat_section(j, 0);
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, sections, 0, &s, v, &report), WCUT_DEGENERATE);
    ck_assert(s == mark && v[0] == 999 && v[STATIONS - 1] == 999 && report.used == 999 && report.dropped == 999);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    given_sections();
    const double knots[4] = {0, 0, 1, 1}, weights[4] = {1, 2, 1, 1};
    wcut_surface *const mark = (wcut_surface *)&sections, *octant = shape_octant();
    wcut_surface *s = mark;
    wcut_loft_report report = {999, 999};
    double v[STATIONS] = {999};
    wcut_vec3 grid[4] = {{999, 0, 0}};
    EACH_FAILED_ALLOCATION(wcut_surface_loft(STATIONS, NODES, sections, 0, &s, v, &report),
                           s == mark && report.used == 999 && v[0] == 999);
    wcut_surface_destroy(s);
    s = mark;
    EACH_FAILED_ALLOCATION(wcut_surface_create(1, 1, 2, 2, knots, knots, sections, weights, &s), s == mark);
    wcut_surface_destroy(s);
    EACH_FAILED_ALLOCATION(wcut_surface_eval_grid(octant, 2, knots + 1, 2, knots + 1, grid), grid[0].x == 999);
    wcut_surface_destroy(octant);
}
