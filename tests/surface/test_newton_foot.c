/* The newton way to a foot beside the slow one, which is proven elsewhere: the same feet, on tame and on wild surfaces.
   labels: unit plain */
#include <math.h>
#include <string.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/random.h"
#include "base/vec3.h"
#include "surface/foot_search.h"
#include "test.h"

enum { ROWS = 60, COLUMNS = 50, QUERIES = 4000 };

static wcut_surface *surface;
static wcut_projection *slow, *newton;
static wcut_vec3 node[ROWS * COLUMNS], query[QUERIES];
static wcut_foot expected[QUERIES], found[QUERIES];

/* 0 waves, 1 a tube all but closed, 2 a sheet folded back on itself, 3 a cone with its tip, 4 rows that crowd and pause */
static wcut_vec3 at(int shape, double s, double t) {
    const double angle = 6.2 * s;
    switch (shape) {
        case 0:
            return vec3(400 * s, 900 * t, 30 * sin(5 * s) + 20 * cos(7 * t));
        case 1:
            return vec3(20 * cos(angle), 300 * t, 20 * sin(angle));
        case 2:
            return vec3(100 * sin(3 * s), 300 * t, 12 * s + 3 * sin(9 * t));
        case 3:
            return vec3(80 * t * cos(angle), 80 * t * sin(angle), 100 * t);
        default:
            return vec3(400 * s, 900 * t * t * t, 40 * sin(4 * s) * t);
    }
}

static void given_shape(int shape) {
    for (int k = 0; k < ROWS * COLUMNS; k++)
        node[k] = at(shape, (k % COLUMNS) / (COLUMNS - 1.0), (k / COLUMNS) / (ROWS - 1.0));
    ck_assert_int_eq(wcut_surface_loft(ROWS, COLUMNS, node, 0, &surface, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(surface, &slow), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(surface, &newton), WCUT_OK);
    ck_assert_int_eq(wcut_projection_prepare_many(newton), WCUT_OK);
    ck_assert_int_eq(wcut_projection_prepare_many(newton), WCUT_OK); /* once is enough */
}

static void forget(void) {
    wcut_projection_destroy(newton);
    wcut_projection_destroy(slow);
    wcut_surface_destroy(surface);
}

/* near the surface, off it by up to `away`, at its border and beyond it too */
static void given_queries(int shape, double away, uint64_t seed) {
    wcut_random r = wcut_random_seed(seed);
    for (int k = 0; k < QUERIES; k++) {
        const double s = 1.02 * wcut_random_uniform(&r) - 0.01, t = 1.02 * wcut_random_uniform(&r) - 0.01;
        query[k] = at(shape, s, t);
        query[k].x += away * wcut_random_normal(&r), query[k].y += away * wcut_random_normal(&r);
        query[k].z += away * wcut_random_normal(&r);
    }
}

TEST(quick_feet_are_the_slow_ones) {
    const double away[] = {0.01, 0.5, 5, 60};
    for (int shape = 0; shape < 5; shape++) {
        given_shape(shape);
        for (int a = 0; a < 4; a++) {
            given_queries(shape, away[a], (uint64_t)a + 1);
            ck_assert_int_eq(wcut_projection_locate(slow, QUERIES, query, 1, expected), WCUT_OK);
            ck_assert_int_eq(wcut_projection_locate(newton, QUERIES, query, 1, found), WCUT_OK);
            for (int k = 0; k < QUERIES; k++) {
                const wcut_foot *e = &expected[k], *f = &found[k];
                ck_assert_msg(fabs(f->distance - e->distance) < 1e-9, "shape %d, query %d: %.12g, expected %.12g",
                              shape, k, f->distance, e->distance);
                if (e->gap > 0) continue; /* several feet tie */
                ck_assert_int_eq(f->beyond, e->beyond);
                if (e->distance > 1e-6 && vec3_distance(e->point, f->point) < 1e-6)
                    ck_assert_double_eq_tol(f->height, e->height, 1e-6);
            }
        }
        forget();
    }
}

static bool is_at_border(const wcut_foot *f) { return f->u <= 0 || f->u >= 1 || f->v <= 0 || f->v >= 1; }

TEST(most_feet_near_a_tame_surface_are_found_quickly) {
    enum { BLOCK = WCUT_NEWTON_FOOT_BATCH };
    given_shape(0);
    given_queries(0, 1, 9);
    ck_assert_ptr_nonnull(newton->newton);
    ck_assert_int_eq(wcut_projection_locate(slow, QUERIES, query, 1, expected), WCUT_OK);
    static wcut_foot foot[BLOCK];
    static wcut_span_place start[BLOCK];
    unsigned char done[BLOCK];
    memset(foot, 0, sizeof foot), memset(done, 9, sizeof done);
    const wcut_span_place from = wcut_span_place_at(newton->newton, expected[0].u, expected[0].v);
    wcut_newton_foot_batch(newton->newton, BLOCK, query, from, NULL, foot, done, start);
    int taken = 0, inside = 0, slid = 0, border = 0;
    for (int k = 0; k < BLOCK; k++) {
        wcut_foot_jet spot;
        const bool follows = wcut_newton_foot_slide(newton->newton, query[k], start[k], &spot);
        ck_assert_int_le(done[k], 1);
        if (done[k]) ck_assert_double_lt(vec3_distance(foot[k].point, expected[k].point), 1e-9);
        if (follows) ck_assert_double_lt(vec3_distance(spot.point, expected[k].point), 1e-9);
        if (is_at_border(&expected[k])) {
            ck_assert(!done[k]);
            border++, slid += follows;
        } else {
            inside++, taken += done[k];
        }
    }
    ck_assert_int_gt(border, 20);
    ck_assert_int_gt(taken, inside * 9 / 10);
    ck_assert_int_gt(slid, border * 9 / 10);
    forget();
}

TEST(feet_are_the_same_for_any_number_of_threads) {
    enum { MANY = 30000 };
    static wcut_vec3 many[MANY];
    static wcut_foot one[MANY], other[MANY];
    wcut_random r = wcut_random_seed(5);
    given_shape(0);
    for (int k = 0; k < MANY; k++) {
        many[k] = at(0, 1.01 * wcut_random_uniform(&r), 1.01 * wcut_random_uniform(&r));
        many[k].z += wcut_random_normal(&r);
    }
    ck_assert_int_eq(wcut_projection_locate(newton, MANY, many, 1, one), WCUT_OK);
    const int threads[] = {2, 3, 7, 100};
    for (int k = 0; k < 4; k++) {
        memset(other, 9, sizeof other);
        ck_assert_int_eq(wcut_projection_locate(newton, MANY, many, threads[k], other), WCUT_OK);
        ck_assert_mem_eq(one, other, sizeof one);
    }
    forget();
}

TEST(surfaces_without_a_quick_way_stay_as_they_were) {
    wcut_vec3 corner[4] = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {10, 10, 1}};
    ck_assert_int_eq(wcut_surface_loft(2, 2, corner, 0, &surface, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_projection_create(surface, &newton), WCUT_OK);
    ck_assert_int_eq(wcut_projection_prepare_many(newton), WCUT_OK);
    ck_assert_ptr_null(newton->newton);
    query[0] = vec3(5, 5, 3);
    ck_assert_int_eq(wcut_projection_locate(newton, 1, query, 1, found), WCUT_OK);
    wcut_projection_destroy(newton);
    wcut_surface_destroy(surface);
    ck_assert_int_eq(wcut_projection_prepare_many(NULL), WCUT_BAD_ARGUMENT);
}

TEST(without_memory_a_projection_is_as_it_was) {
    given_shape(0);
    EACH_FAILED_ALLOCATION_BY(2, wcut_projection_prepare_many(slow), !slow->newton);
    forget();
}
