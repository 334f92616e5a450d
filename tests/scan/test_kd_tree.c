/* The k-d tree against counting by hand: nearest points, points within a radius, every shape of cloud. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/random.h"
#include "base/vec3.h"
#include "scan/kd_tree.h"
#include "test.h"

enum { MAX = 700 };

static wcut_vec3 point[MAX];
static wcut_kd_tree tree;

/* 0: a cube, 1: a sheet, 2: a line, 3: few places many times, 4: one place, 5: a sheet and a far outlier */
static void given_points(int shape, int count, uint64_t seed) {
    wcut_random r = wcut_random_seed(seed);
    for (int k = 0; k < count; k++) {
        const double x = wcut_random_uniform(&r), y = wcut_random_uniform(&r), z = wcut_random_uniform(&r);
        point[k] = shape == 0   ? vec3(x, y, z)
                   : shape == 1 ? vec3(100 * x, 300 * y, x * y)
                   : shape == 2 ? vec3(x, 2 * x, -x)
                   : shape == 3 ? vec3(floor(3 * x), floor(2 * y), 0)
                   : shape == 4 ? vec3(7, 8, 9)
                                : vec3(x, y, k == count / 2 ? 1e9 : 0);
    }
}

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* squared distances of all other points, from near to far */
static void all_squares(int place, double *square) {
    int n = 0;
    for (int k = 0; k < tree.count; k++) {
        const wcut_vec3 d = vec3_sub(tree.point[k], tree.point[place]);
        if (k != place) square[n++] = vec3_dot(d, d);
    }
    qsort(square, (size_t)n, sizeof *square, compare);
}

TEST(every_point_is_in_the_tree_once) {
    for (int shape = 0; shape < 6; shape++) {
        char seen[MAX] = "";
        given_points(shape, MAX, 3);
        ck_assert_int_eq(wcut_kd_tree_build(MAX, point, 1, &tree), WCUT_OK);
        for (int k = 0; k < MAX; k++) {
            ck_assert_int_eq(seen[tree.index[k]]++, 0);
            ck_assert(memcmp(&tree.point[k], &point[tree.index[k]], sizeof *point) == 0);
        }
        wcut_kd_tree_clear(&tree);
    }
}

TEST(the_nearest_points_are_those_of_a_full_search) {
    static double square[MAX];
    const int counts[] = {1, 2, 3, 16, 17, 33, 100, MAX}, ks[] = {1, 2, 16, WCUT_KD_NEAREST_MAX};
    for (int t = 0; t < 6 * 8 * 4; t++) {
        const int shape = t / 32, count = counts[t / 4 % 8], k = ks[t % 4];
        given_points(shape, count, (uint64_t)t);
        ck_assert_int_eq(wcut_kd_tree_build(count, point, 1, &tree), WCUT_OK);
        for (int place = 0; place < count; place += 1 + count / 20) {
            wcut_kd_nearest nearest;
            wcut_kd_tree_nearest(&tree, place, k, &nearest);
            all_squares(place, square);
            ck_assert_int_eq(nearest.count, k < count - 1 ? k : count - 1);
            for (int j = 0; j < nearest.count; j++) {
                const wcut_vec3 d = vec3_sub(tree.point[nearest.place[j]], tree.point[place]);
                ck_assert(nearest.square[j] == square[j] && vec3_dot(d, d) == square[j] && nearest.place[j] != place);
                bool twice = false;
                for (int i = 0; i < j; i++) twice |= nearest.place[i] == nearest.place[j];
                ck_assert(!twice);
            }
        }
        wcut_kd_tree_clear(&tree);
    }
}

TEST(points_within_a_radius_are_counted_its_border_among_them) {
    static double square[MAX];
    for (int shape = 0; shape < 6; shape++) {
        given_points(shape, MAX, 5);
        ck_assert_int_eq(wcut_kd_tree_build(MAX, point, 1, &tree), WCUT_OK);
        for (int place = 0; place < MAX; place += 31) {
            all_squares(place, square);
            const double radius[] = {1e-9, 0.1, 0.5, 1, 50, 1e10};
            for (int r = 0; r < 6; r++) {
                int expected = 0;
                while (expected < MAX - 1 && square[expected] <= radius[r] * radius[r]) expected++;
                ck_assert_int_eq(wcut_kd_tree_within(&tree, place, radius[r], MAX), expected);
                ck_assert_int_eq(wcut_kd_tree_within(&tree, place, radius[r], 3), expected < 3 ? expected : 3);
            }
        }
        wcut_kd_tree_clear(&tree);
    }
}

TEST(two_threads_build_the_same_tree) {
    wcut_kd_tree other;
    given_points(1, MAX, 9);
    ck_assert_int_eq(wcut_kd_tree_build(MAX, point, 1, &tree), WCUT_OK);
    ck_assert_int_eq(wcut_kd_tree_build(MAX, point, 2, &other), WCUT_OK);
    ck_assert(memcmp(tree.index, other.index, MAX * sizeof *tree.index) == 0 && tree.levels == other.levels);
    wcut_kd_tree_clear(&tree);
    wcut_kd_tree_clear(&other);
}

TEST(without_memory_there_is_no_tree) {
    given_points(1, MAX, 9);
    wcut_kd_tree none = {.count = 999};
    FIRST_FAILED_ALLOCATIONS(4, wcut_kd_tree_build(MAX, point, 1, &none), none.count == 999 && none.point == NULL);
}
