/* The generator against its published sequence and the moments of its distributions. */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>

#include "base/distribution.h"
#include "base/random.h"
#include "test.h"

TEST(the_bits_are_those_of_the_published_algorithm) {
    /* xoshiro256** from the state 1, 2, 3, 4: worked by hand from the paper's recurrence */
    wcut_random random = {.state = {1, 2, 3, 4}};
    const uint64_t expected[] = {11520u, 0u, 1509978240u, 1215971899390074240u};
    for (int i = 0; i < 4; i++) ck_assert_uint_eq(wcut_random_bits(&random), expected[i]);
}

TEST(the_same_seed_gives_the_same_numbers_and_another_seed_others) {
    wcut_random a = wcut_random_seed(7), b = wcut_random_seed(7), c = wcut_random_seed(8);
    int alike = 0;
    for (int i = 0; i < 100; i++) {
        double x = wcut_random_normal(&a);
        ck_assert(x == wcut_random_normal(&b));
        alike += x == wcut_random_normal(&c);
    }
    ck_assert_int_eq(alike, 0);
}

TEST(normal_deviates_fill_the_normal_quantiles_evenly) {
    enum { CELLS = 50, N = 200000 };
    wcut_random random = wcut_random_seed(0);
    int count[CELLS] = {0};
    for (int i = 0; i < N; i++) count[(int)(CELLS * (1 - wcut_gaussian_tail(wcut_random_normal(&random))))]++;
    double chi_square = 0, expected = (double)N / CELLS;
    for (int k = 0; k < CELLS; k++) chi_square += (count[k] - expected) * (count[k] - expected) / expected;
    double p = wcut_chi_square_tail(chi_square, CELLS - 1);
    ck_assert_msg(p > 0.001 && p < 0.999, "chi-square %g, p %g", chi_square, p);
}

TEST(uniform_numbers_stay_in_the_half_open_interval_and_fill_it) {
    wcut_random random = wcut_random_seed(3);
    double sum = 0, min = 1, max = 0;
    for (int i = 0; i < 100000; i++) {
        double u = wcut_random_uniform(&random);
        sum += u;
        min = fmin(min, u);
        max = fmax(max, u);
    }
    ck_assert(min >= 0 && min < 1e-3 && max < 1 && max > 0.999);
    ck_assert_double_eq_tol(sum / 100000, 0.5, 0.004);
}

TEST(below_n_every_number_is_as_likely) {
    wcut_random random = wcut_random_seed(5);
    int count[3] = {0};
    for (int i = 0; i < 30000; i++) count[wcut_random_below(&random, 3)]++;
    for (int k = 0; k < 3; k++) ck_assert(abs(count[k] - 10000) < 400);
    ck_assert_int_eq(wcut_random_below(&random, 1), 0);
}
