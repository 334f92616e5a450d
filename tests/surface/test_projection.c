/* labels: unit oracle plain
   Projection: closed forms, planted feet, a brute search as the judge, borders, poles, ties and threads. */
#include <stdio.h>
#include <string.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/random.h"
#include "surface/shapes.h"
#include "test.h"

enum { MANY = 5000 };
static wcut_vec3 query[MANY];
static wcut_foot foot[MANY];

static wcut_projection *projection_of(const wcut_surface *s) {
    wcut_projection *m = NULL;
    ck_assert_int_eq(wcut_projection_create(s, &m), WCUT_OK);
    return m;
}

/* Random queries in a box of half side `reach`, located. Most must be certified; the rest are near centres of curvature
   or over a pole, and their gap is small. */
static void locate_random(const wcut_surface *s, double reach, unsigned seed) {
    int certified = 0;
    double worst = 0;
    wcut_random random = wcut_random_seed(seed);
    for (int k = 0; k < MANY; k++)
        query[k] = vec3(reach * (2 * wcut_random_uniform(&random) - 1), reach * (2 * wcut_random_uniform(&random) - 1),
                        reach * (2 * wcut_random_uniform(&random) - 1));
    wcut_projection *m = projection_of(s);
    ck_assert_int_eq(wcut_projection_locate(m, MANY, query, 2, foot), WCUT_OK);
    wcut_projection_destroy(m);
    for (int k = 0; k < MANY; k++) { /* what holds for every foot */
        wcut_vec3 p;
        ck_assert_int_eq(wcut_surface_eval(s, foot[k].u, foot[k].v, 0, &p), WCUT_OK);
        ck_assert_double_le(vec3_distance(p, foot[k].point), 1e-11 * reach);
        ck_assert_double_le(fabs(vec3_distance(query[k], foot[k].point) - foot[k].distance), 1e-13 * reach);
        certified += foot[k].gap <= 1e-9;
        worst = fmax(worst, foot[k].gap);
    }
    printf("%d of %d certified, largest gap %.2g mm\n", certified, MANY, worst);
    ck_assert(certified > 0.9 * MANY && worst < 1);
}

TEST(the_distance_to_sphere_cylinder_and_torus_is_the_closed_form) {
    wcut_surface *s = shape_sphere(50);
    locate_random(s, 90, 23);
    for (int k = 0; k < MANY; k++) {
        const double height = vec3_length(query[k]) - 50;
        ck_assert_double_le(fabs(foot[k].distance - fabs(height)), 1e-10);
        ck_assert_double_le(fabs(foot[k].height - height), 1e-7 * 50);
        ck_assert_int_eq(foot[k].beyond, 0);
    }
    wcut_surface_destroy(s);

    s = shape_torus(50, 20);
    locate_random(s, 90, 29);
    for (int k = 0; k < MANY; k++) {
        const double height = hypot(hypot(query[k].x, query[k].y) - 50, query[k].z) - 20;
        ck_assert_double_le(fabs(foot[k].distance - fabs(height)), 1e-10);
        ck_assert_double_le(fabs(foot[k].height - height), 1e-7 * 50);
    }
    wcut_surface_destroy(s);

    s = shape_cylinder(50, 80);
    locate_random(s, 90, 31);
    for (int k = 0; k < MANY; k++) {
        const double height = hypot(query[k].x, query[k].y) - 50, z = query[k].z;
        const double over = fmax(0, fmax(-z, z - 80));
        ck_assert_double_le(fabs(foot[k].distance - hypot(height, over)), 1e-10);
        ck_assert_double_le(fabs(foot[k].height - height), 1e-7 * 50);
        ck_assert_int_eq(foot[k].beyond, over > 1e-6);
    }
    wcut_surface_destroy(s);
}

static wcut_surface *loft_sheet(int stations, int nodes) {
    wcut_vec3 *x = malloc((size_t)stations * (size_t)nodes * sizeof *x);
    for (int j = 0; j < stations; j++)
        for (int i = 0; i < nodes; i++) x[j * nodes + i] = sheet_point(i / (nodes - 1.0), j / (stations - 1.0));
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(stations, nodes, x, 0, &s, NULL, NULL), WCUT_OK);
    free(x);
    return s;
}

TEST(planted_feet_are_found_again) {
    wcut_surface *s = loft_sheet(200, 60);
    wcut_projection *m = projection_of(s);
    wcut_random random = wcut_random_seed(37);
    static double u[MANY], v[MANY], height[MANY];
    for (int k = 0; k < MANY; k++) { /* the sheet's radii of curvature are above 300 mm */
        wcut_vec3 d[4];
        u[k] = wcut_random_uniform(&random), v[k] = wcut_random_uniform(&random);
        if (k % 10 == 0) u[k] = k % 20 ? 0 : 1;
        if (k % 15 == 0) v[k] = k % 2;
        height[k] = k % 7 == 0 ? 0 : 30 * (2 * wcut_random_uniform(&random) - 1);
        ck_assert_int_eq(wcut_surface_eval(s, u[k], v[k], 1, d), WCUT_OK);
        query[k] = vec3_add_scaled(d[0], height[k], vec3_unit(vec3_cross(d[2], d[1])));
    }
    ck_assert_int_eq(wcut_projection_locate(m, MANY, query, 1, foot), WCUT_OK);
    for (int k = 0; k < MANY; k++) {
        ck_assert_double_le(fabs(foot[k].distance - fabs(height[k])), 1e-9);
        ck_assert_double_le(fabs(foot[k].height - height[k]), 1e-9);
        ck_assert_double_le(fabs(foot[k].u - u[k]) + fabs(foot[k].v - v[k]), 1e-9);
        ck_assert(foot[k].gap == 0 && foot[k].beyond == 0);
    }
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}

/* a sheet that folds and rolls up: many local minima */
static wcut_surface *crumpled(void) {
    enum { SIDE = 30 };
    static wcut_vec3 x[SIDE * SIDE];
    wcut_random random = wcut_random_seed(41);
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            const double a = 9.0 * j / SIDE, r = 40 + 6 * a;
            x[j * SIDE + i] = vec3(r * cos(a), r * sin(a) + 0.7 * wcut_random_normal(&random),
                                   i * 5.0 + 0.7 * wcut_random_normal(&random));
        }
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(SIDE, SIDE, x, 0, &s, NULL, NULL), WCUT_OK);
    return s;
}

TEST(no_point_of_a_crumpled_sheet_is_closer_than_its_foot) {
    enum { SIDE = 601, QUERIES = 200 };
    wcut_surface *s = crumpled();
    locate_random(s, 120, 43);
    double at[SIDE];
    wcut_vec3 *grid = malloc(sizeof *grid * SIDE * SIDE);
    for (int i = 0; i < SIDE; i++) at[i] = i / (SIDE - 1.0);
    ck_assert_int_eq(wcut_surface_eval_grid(s, SIDE, at, SIDE, at, grid), WCUT_OK);
    for (int k = 0; k < QUERIES; k++) {
        double min = INFINITY;
        for (int n = 0; n < SIDE * SIDE; n++) min = fmin(min, vec3_distance(query[k], grid[n]));
        ck_assert_msg(foot[k].distance <= min + 1e-10 && foot[k].distance >= min - 2, "query %d: %.12g, grid %.12g", k,
                      foot[k].distance, min);
    }
    free(grid);
    wcut_surface_destroy(s);
}

TEST(beyond_the_border_is_told_from_above_it) {
    const double knots[4] = {0, 0, 1, 1};
    const wcut_vec3 corner[4] = {{0, 0, 0}, {10, 0, 0}, {0, 20, 0}, {10, 20, 0}};
    const wcut_vec3 p[7] = {{5, 5, 3}, {0, 5, -3}, {-1, 5, 3}, {10, 20, 4}, {11, 22, 2}, {5, 21, 0}, {10 + 1e-6, 4, 0}};
    const int beyond[7] = {0, 0, 1, 0, 1, 1, 1};
    const double distance[7] = {3, 3, sqrt(10), 4, 3, 1, 1e-6}, height[7] = {3, -3, 3, 4, 2, 0, 0};
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_create(1, 1, 2, 2, knots, knots, corner, NULL, &s), WCUT_OK);
    wcut_projection *m = projection_of(s);
    ck_assert_int_eq(wcut_projection_locate(m, 7, p, 1, foot), WCUT_OK);
    for (int k = 0; k < 7; k++) {
        ck_assert_int_eq(foot[k].beyond, beyond[k]);
        ck_assert_double_le(fabs(foot[k].distance - distance[k]), 1e-12);
        ck_assert_double_le(fabs(foot[k].height - height[k]), 1e-12);
    }
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}

TEST(poles_and_tips_are_found) {
    wcut_surface *s = shape_sphere(50);
    wcut_projection *m = projection_of(s);
    const wcut_vec3 p[4] = {{0, 0, 70}, {0, 0, -30}, {0, 0, 50}, {1e-7, 0, 70}};
    const double height[4] = {20, -20, 0, 20};
    ck_assert_int_eq(wcut_projection_locate(m, 4, p, 1, foot), WCUT_OK);
    for (int k = 0; k < 4; k++) {
        ck_assert_double_le(fabs(foot[k].distance - fabs(height[k])), 1e-10);
        ck_assert_double_le(fabs(foot[k].height - height[k]), 1e-4);
        ck_assert_int_eq(foot[k].beyond, 0);
    }
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);

    const double knots[4] = {0, 0, 1, 1}, x[2] = {0, 30}, z[2] = {0, 30}, w[2] = {1, 1};
    s = shape_revolve(1, 2, knots, x, z, w);
    m = projection_of(s);
    const wcut_vec3 q[3] = {{0, 0, -5}, {0, 0, 10}, {3, 4, 0}};
    const double distance[3] = {5, 10 / sqrt(2), 5 / sqrt(2)};
    ck_assert_int_eq(wcut_projection_locate(m, 3, q, 1, foot), WCUT_OK);
    for (int k = 0; k < 3; k++) ck_assert_double_le(fabs(foot[k].distance - distance[k]), 1e-8);
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}

TEST(where_everything_ties_the_gap_says_how_far_it_is_proven) {
    wcut_surface *s = shape_sphere(50);
    wcut_projection *m = projection_of(s);
    const wcut_vec3 centre = {0, 0, 0};
    ck_assert_int_eq(wcut_projection_locate(m, 1, &centre, 1, foot), WCUT_OK);
    ck_assert_double_le(fabs(foot[0].distance - 50), 1e-12);
    printf("centre of a sphere of 50 mm: gap %.2g mm\n", foot[0].gap);
    ck_assert(foot[0].gap > 0 && foot[0].gap < 5);
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}

TEST(threads_change_no_byte) {
    static wcut_foot again[MANY];
    wcut_surface *s = crumpled();
    locate_random(s, 120, 47);
    wcut_projection *m = projection_of(s);
    for (int threads = 1; threads <= 4; threads += 3) {
        memset(again, 0x55, sizeof again);
        ck_assert_int_eq(wcut_projection_locate(m, MANY, query, threads, again), WCUT_OK);
        for (int k = 0; k < MANY; k++)
            ck_assert(again[k].u == foot[k].u && again[k].v == foot[k].v && again[k].distance == foot[k].distance &&
                      again[k].height == foot[k].height && again[k].gap == foot[k].gap &&
                      apart(again[k].point, foot[k].point) == 0 && again[k].beyond == foot[k].beyond);
    }
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}

TEST(what_cannot_be_located_is_refused_and_nothing_is_written) {
    wcut_surface *s = shape_octant();
    wcut_projection *m = projection_of(s), *const mark = m, *other = m;
    wcut_vec3 p[2] = {{0, 0, 0}, {0, NAN, 0}};
    foot[0].distance = 999;
    ck_assert_int_eq(wcut_projection_create(NULL, &other), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_create(s, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(NULL, 1, p, 1, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(m, -1, p, 1, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(m, 1, NULL, 1, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(m, 1, p, 0, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(m, 1, p, 1, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(m, 2, p, 1, foot), WCUT_BAD_ARGUMENT);
    p[1].y = 1e101;
    ck_assert_int_eq(wcut_projection_locate(m, 2, p, 1, foot), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_projection_locate(m, 0, NULL, 1, NULL), WCUT_OK);
    s->control[4].x = 1e200;
    ck_assert_int_eq(wcut_projection_create(s, &other), WCUT_DEGENERATE);
    ck_assert(other == mark && foot[0].distance == 999);
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    wcut_surface *s = crumpled();
    wcut_projection *m = NULL;
    EACH_FAILED_ALLOCATION(wcut_projection_create(s, &m), !m);
    const wcut_vec3 p = {1, 2, 3};
    foot[0].distance = 999;
    EACH_FAILED_ALLOCATION(wcut_projection_locate(m, 1, &p, 1, foot), foot[0].distance == 999);
    wcut_projection_destroy(m);
    wcut_surface_destroy(s);
}
