/* labels: unit property
   Turns that are never wrong, and triangles that fill plane regions with holes. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/random.h"
#include "solid/polygon.h"
#include "test.h"

enum { POINTS_MAX = 600 };

static double sign(double x) { return (x > 0) - (x < 0); }

TEST(a_turn_has_the_sign_of_exact_arithmetic_where_rounding_has_not) {
    /* points on the line p = q but for a few units in the last place (Kettner et al. 2008): integers times 2^-53 */
    int wrong = 0;
    for (int i = -8; i <= 8; i++)
        for (int j = -8; j <= 8; j++) {
            const double unit = ldexp(1, -53);
            const wcut_point2d a = {0.5 + i * unit, 0.5 + j * unit}, b = {12, 12}, c = {24, 24};
            /* det = (b - a) x (c - a) = 12 (a.q - a.p) for these b and c */
            const double exact = 12.0 * (j - i);
            ck_assert_double_eq(sign(wcut_orient2d(a, b, c)), sign(exact));
            const double rounded = (b.p - a.p) * (c.q - a.q) - (b.q - a.q) * (c.p - a.p);
            wrong += sign(rounded) != sign(exact);
        }
    printf("turns: %d of 289 wrong by rounding, none by wcut_orient2d\n", wrong);
    ck_assert_int_gt(wrong, 0); /* else this test would prove nothing */
}

TEST(a_turn_changes_sign_with_two_points_exchanged_and_not_with_three_turned) {
    wcut_random random = wcut_random_seed(5);
    for (int k = 0; k < 20000; k++) {
        wcut_point2d x[3];
        for (int i = 0; i < 3; i++) {
            const double t = wcut_random_uniform(&random);
            x[i] = (wcut_point2d){100 * t, 100 * t * 3 + (k % 2 ? 0 : 1e-14 * wcut_random_uniform(&random))};
        }
        const double turn = sign(wcut_orient2d(x[0], x[1], x[2]));
        ck_assert_double_eq(turn, sign(wcut_orient2d(x[1], x[2], x[0])));
        ck_assert_double_eq(turn, -sign(wcut_orient2d(x[1], x[0], x[2])));
        ck_assert_double_eq(wcut_orient2d(x[0], x[0], x[2]), 0);
    }
}

static double area_of(int count, const wcut_point2d *x) {
    double sum = 0;
    for (int k = 0; k < count; k++) {
        const wcut_point2d a = x[k], b = x[(k + 1) % count];
        sum += (a.p * b.q - b.p * a.q) / 2;
    }
    return sum;
}

/* the triangles turn left, have the region's area, and every side of the runs once, no inner edge more than twice */
static void check_fill(int loops, const int *size, const wcut_point2d *x) {
    static int triangle[3 * 2 * POINTS_MAX];
    static int used[POINTS_MAX * POINTS_MAX];
    int points = 0;
    double wanted = 0, sum = 0;
    for (int l = 0; l < loops; l++) {
        wanted += area_of(size[l], x + points);
        points += size[l];
    }
    ck_assert_int_le(points, POINTS_MAX);
    ck_assert_int_eq(wcut_polygon_triangulate(loops, size, x, triangle), WCUT_OK);
    const int triangles = points + 2 * loops - 4;
    for (int k = 0; k < points * points; k++) used[k] = 0;
    for (int t = 0; t < triangles; t++) {
        wcut_point2d f[3];
        for (int i = 0; i < 3; i++) {
            const int from = triangle[3 * t + i], to = triangle[3 * t + (i + 1) % 3];
            ck_assert(from >= 0 && from < points);
            ck_assert_int_eq(used[from * points + to]++, 0);
            f[i] = x[from];
        }
        ck_assert_double_gt(wcut_orient2d(f[0], f[1], f[2]), 0);
        sum += area_of(3, f);
    }
    ck_assert_double_le(fabs(sum - wanted), 1e-12 * fabs(wanted));
    for (int l = 0, at = 0; l < loops; at += size[l++])
        for (int k = 0; k < size[l]; k++) {
            const int from = at + k, to = at + (k + 1) % size[l];
            ck_assert(used[from * points + to] == 1 && used[to * points + from] == 0);
        }
    for (int a = 0; a < points; a++)
        for (int b = 0; b < points; b++) { /* an edge that is no side has a triangle on either side */
            if (used[a * points + b] && !used[b * points + a]) {
                bool side = false;
                for (int l = 0, at = 0; l < loops; at += size[l++])
                    side = side || (a >= at && a < at + size[l] && b == at + (a - at + 1) % size[l]);
                ck_assert(side);
            }
        }
}

TEST(a_box_under_a_straight_border_of_many_points_is_filled_without_flat_triangles) {
    wcut_point2d x[POINTS_MAX] = {{0, 0}, {900, 0}};
    const int size = 402;
    for (int k = 0; k < 400; k++) x[2 + k] = (wcut_point2d){900 - 900.0 * k / 399, 140};
    check_fill(1, &size, x);
    for (int k = 0; k < 400; k++) x[2 + k].q = 140 + 60 * sin(0.05 * k) + 10 * cos(0.9 * k);
    check_fill(1, &size, x);
    for (int k = 0; k < 400; k++) x[2 + k].q = 140 + 0.3 * k;
    for (int k = 1; k < 399; k++) x[2 + k].p = 450 + 300 * sin(0.03 * k); /* overhanging */
    check_fill(1, &size, x);
}

/* least height of a triangle over its longest side, when its corners are rounded to single precision */
static double min_height(int triangles, const int *triangle, const wcut_point2d *x) {
    double min = INFINITY;
    for (int t = 0; t < triangles; t++) {
        double p[3], q[3], longest = 0;
        for (int k = 0; k < 3; k++) p[k] = (float)x[triangle[3 * t + k]].p, q[k] = (float)x[triangle[3 * t + k]].q;
        for (int k = 0; k < 3; k++) longest = fmax(longest, hypot(p[k] - p[(k + 1) % 3], q[k] - q[(k + 1) % 3]));
        min = fmin(min, ((p[1] - p[0]) * (q[2] - q[0]) - (p[2] - p[0]) * (q[1] - q[0])) / longest);
    }
    return min;
}

TEST(a_border_that_is_straight_but_for_rounding_makes_no_needles) {
    static int triangle[3 * POINTS_MAX];
    wcut_point2d x[402] = {{0, 0}, {1200, 0}};
    const int size = 402;
    wcut_random random = wcut_random_seed(3);
    for (int noise = -14; noise <= -7; noise++) {
        for (int k = 0; k < 400; k++)
            x[2 + k] =
                (wcut_point2d){1200 - 1200.0 * k / 399, 150 + pow(10, noise) * (wcut_random_uniform(&random) - 0.5)};
        check_fill(1, &size, x);
        ck_assert_int_eq(wcut_polygon_triangulate(1, &size, x, triangle), WCUT_OK);
        ck_assert_double_gt(min_height(size - 2, triangle, x), 1e-2);
    }
}

TEST(holes_are_left_free_wherever_they_are) {
    static wcut_point2d x[POINTS_MAX];
    wcut_random random = wcut_random_seed(9);
    for (int round = 0; round < 60; round++) {
        int size[8] = {4}, loops = 1, points = 4;
        double centre[8][3];
        const wcut_point2d corner[4] = {{0, 0}, {400, 0}, {400, 900}, {0, 900}};
        for (int k = 0; k < 4; k++) x[k] = corner[k];
        for (int tries = 0; tries < 200 && loops < 7; tries++) {
            const double r = 5 + 60 * wcut_random_uniform(&random);
            const double p = r + 1 + (398 - 2 * r) * wcut_random_uniform(&random);
            const double q = round % 3 ? r + 1 + (898 - 2 * r) * wcut_random_uniform(&random) : 450; /* in a row, too */
            bool apart = true;
            for (int l = 1; l < loops; l++)
                apart = apart && hypot(p - centre[l][0], q - centre[l][1]) > r + centre[l][2] + 0.5;
            if (!apart) continue;
            centre[loops][0] = p, centre[loops][1] = q, centre[loops][2] = r;
            size[loops] = 16 + 4 * wcut_random_below(&random, 12);
            for (int k = 0; k < size[loops]; k++) {
                const double turn = -2 * WCUT_PI * k / size[loops];
                x[points++] = (wcut_point2d){p + r * cos(turn), q + r * sin(turn)};
            }
            loops++;
        }
        ck_assert_int_gt(loops, 3);
        check_fill(loops, size, x);
    }
}

TEST(what_is_no_region_is_degenerate) {
    int triangle[60] = {999};
    const int two = 2, four = 4, square_and_hole[2] = {4, 4};
    const wcut_point2d flat[4] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}}, clockwise[4] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    const wcut_point2d apart[8] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {3, 3}, {3, 4}, {4, 4}, {4, 3}};
    ck_assert_int_eq(wcut_polygon_triangulate(1, &two, flat, triangle), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_polygon_triangulate(1, &four, flat, triangle), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_polygon_triangulate(1, &four, clockwise, triangle), WCUT_DEGENERATE);
    ck_assert_int_eq(wcut_polygon_triangulate(2, square_and_hole, apart, triangle), WCUT_DEGENERATE);
    FIRST_FAILED_ALLOCATIONS(2, wcut_polygon_triangulate(1, &four, apart, triangle), triangle[0] == 999);
}
