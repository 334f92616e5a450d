/* Sorted numbers and their order statistics, by hand and against counting. */

#include "base/numbers.h"
#include "base/random.h"
#include "base/sort.h"
#include "test.h"

enum { COUNT = 1001 };

TEST(sorting_keeps_every_value_and_leaves_them_in_order) {
    wcut_random random = wcut_random_seed(1);
    for (int n = 0; n <= COUNT; n += 77) {
        double x[COUNT], sum = 0, sorted_sum = 0;

        /* whole numbers, so that the sums are exact and some values are equal */
        for (int i = 0; i < n; i++) sum += x[i] = wcut_random_below(&random, 500) - 250;
        wcut_sort(n, x);
        for (int i = 0; i < n; i++) sorted_sum += x[i];
        for (int i = 1; i < n; i++) ck_assert(x[i - 1] <= x[i]);
        ck_assert(sum == sorted_sum);
    }
}

TEST(infinities_are_sorted_to_the_ends) {
    double x[] = {1, (double)INFINITY, -2, -(double)INFINITY};
    wcut_sort(4, x);
    ck_assert(x[0] == -(double)INFINITY && x[1] == -2 && x[2] == 1 && x[3] == (double)INFINITY);
}

TEST(a_median_is_the_middle_value_or_the_mean_of_two) {
    const double x[] = {-3, 1, 2, 10};
    ck_assert(sorted_median(1, x) == -3);
    ck_assert(sorted_median(2, x) == -1);
    ck_assert(sorted_median(3, x) == 1);
    ck_assert(sorted_median(4, x) == 1.5);
}

TEST(a_quantile_is_a_value_of_the_list) {
    double x[101];
    for (int i = 0; i < 101; i++) x[i] = i;
    ck_assert(sorted_quantile(101, x, 0) == 0 && sorted_quantile(101, x, 1) == 100);
    ck_assert(sorted_quantile(101, x, 0.5) == 50 && sorted_quantile(101, x, 0.955) == 95);
    ck_assert(sorted_quantile(1, x, 0.7) == 0);
}
