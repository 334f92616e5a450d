/* Seventy-five first contacts of slack, tilted wires: nearly all are solved, and one path gives one surface.
   labels: property plain slow */
#include "cut/random_paths.h"
#include "test.h"

enum { PATHS = 25 };

static int compare_numbers(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

TEST(random_slack_paths_find_their_equilibrium_and_converge_in_stations) {
    double coarse[PATHS], fine[PATHS];
    int failed = 0;
    for (int p = 0; p < PATHS; p++) {
        double apart[RANDOM_LEVELS - 1];
        const int here = run_random_path(p + 1, apart);
        printf("path %2d: %d of 3 failed, %.3f and %.3f mm apart\n", p + 1, here, apart[0], apart[1]);
        failed += here;
        coarse[p] = apart[0], fine[p] = apart[1];
    }
    ck_assert_int_le(failed, 1);

    /* first order: half the step, half the distance; at the median, as single paths may graze an edge of the block */
    qsort(coarse, PATHS, sizeof *coarse, compare_numbers);
    qsort(fine, PATHS, sizeof *fine, compare_numbers);
    printf("apart: median %.3f and %.3f mm, at most %.3f and %.3f mm; order %.2f\n", coarse[PATHS / 2], fine[PATHS / 2],
           coarse[PATHS - 1], fine[PATHS - 1], log2(coarse[PATHS / 2] / fine[PATHS / 2]));
    ck_assert_double_lt(fine[PATHS - 2], 1);
    ck_assert_double_gt(log2(coarse[PATHS / 2] / fine[PATHS / 2]), 0.7);
}
