/* Cholesky's factor against matrices whose factor or answer is known. */

#include "base/dense.h"
#include "base/numbers.h"
#include "base/random.h"
#include "test.h"

enum { MAX = 40 };

TEST(the_factor_of_a_product_is_the_factor_it_was_made_of) {
    /* L with whole entries: every sum and root is exact */
    const double l[9] = {2, 0, 0, -1, 3, 0, 4, 5, 6};
    double a[9] = {0};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            for (int k = 0; k < 3; k++) a[3 * i + j] += l[3 * i + k] * l[3 * j + k];
    const double upper = a[1];
    ck_assert(wcut_cholesky_factor(3, a, 0));
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) ck_assert(a[3 * i + j] == l[3 * i + j]);
    ck_assert(a[1] == upper); /* the upper triangle was not written */
}

TEST(a_solution_satisfies_its_system) {
    wcut_random random = wcut_random_seed(7);
    for (int n = 1; n <= MAX; n += 3) {
        double a[MAX * MAX] = {0}, l[MAX * MAX], x[MAX], b[MAX];

        /* a diagonal above the sum of its row: positive definite, well conditioned */
        for (int i = 0; i < n; i++)
            for (int j = 0; j <= i; j++)
                a[i * n + j] = a[j * n + i] = i == j ? n + 1 : 2 * wcut_random_uniform(&random) - 1;
        for (int i = 0; i < n * n; i++) l[i] = a[i];
        for (int i = 0; i < n; i++) x[i] = b[i] = 2 * wcut_random_uniform(&random) - 1;
        ck_assert(wcut_cholesky_factor(n, l, 0));
        wcut_cholesky_solve(n, l, x);
        for (int i = 0; i < n; i++) {
            double sum = -b[i];
            for (int j = 0; j < n; j++) sum += a[i * n + j] * x[j];
            ck_assert_double_le(fabs(sum), 1e-14 * n);
        }
    }
}

TEST(what_is_not_positive_definite_is_refused) {
    double indefinite[4] = {1, 2, 2, 1}, singular[4] = {1, 1, 1, 1}, bad[1] = {NAN}, small[1] = {1e-12};
    ck_assert(!wcut_cholesky_factor(2, indefinite, 0));
    ck_assert(!wcut_cholesky_factor(2, singular, 0));
    ck_assert(!wcut_cholesky_factor(1, bad, 0));
    ck_assert(!wcut_cholesky_factor(1, small, 1e-11));
}
