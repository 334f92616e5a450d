/* Banded LU against systems whose answer is known, and against elimination of the whole matrix. */

#include "base/banded.h"
#include "base/numbers.h"
#include "base/random.h"
#include "test.h"

enum { MAX = 60 };

static double entry[MAX * MAX], dense[MAX][MAX], b[MAX], x[MAX];
static int pivot[MAX];

static wcut_banded given_a_band(int n, int kl, int ku) {
    wcut_banded m = {.n = n, .kl = kl, .ku = ku, .width = 2 * kl + ku + 1, .entry = entry, .pivot = pivot};
    ck_assert_uint_le(banded_size(n, kl, ku), sizeof entry / sizeof *entry);
    for (size_t k = 0; k < sizeof entry / sizeof *entry; k++) entry[k] = 999;
    wcut_banded_clear(&m);
    return m;
}

/* random entries within the band, into both forms of the matrix */
static wcut_banded given_a_random_band(wcut_random *random, int n, int kl, int ku) {
    const wcut_banded m = given_a_band(n, kl, ku);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            dense[i][j] = j >= i - kl && j <= i + ku ? 2 * wcut_random_uniform(random) - 1 : 0;
            if (dense[i][j] != 0) *banded_at(&m, i, j) = dense[i][j];
        }
    return m;
}

/* max|A x - b| / max|b|, A as it was before it was factored */
static double residual_of(int n, const double *solution, const double *right) {
    double worst = 0, scale = 0;
    for (int i = 0; i < n; i++) {
        double sum = -right[i];
        for (int j = 0; j < n; j++) sum += dense[i][j] * solution[j];
        worst = fmax(worst, fabs(sum));
        scale = fmax(scale, fabs(right[i]));
    }
    return worst / scale;
}

TEST(second_differences_of_a_parabola_give_the_parabola_back) {
    enum { N = 50 };
    wcut_banded m = given_a_band(N, 1, 1);
    for (int i = 0; i < N; i++) {
        *banded_at(&m, i, i) = -2;
        if (i > 0) *banded_at(&m, i, i - 1) = 1;
        if (i < N - 1) *banded_at(&m, i, i + 1) = 1;
        b[i] = 2;
    }
    ck_assert(wcut_banded_factor(&m));
    wcut_banded_solve(&m, b);
    for (int i = 0; i < N; i++) ck_assert_double_eq_tol(b[i], (i + 1.0) * (i - N), 1e-10);
}

TEST(random_bands_of_every_width_are_solved_to_rounding) {
    wcut_random random = wcut_random_seed(7);
    for (int kl = 0; kl <= 6; kl++)
        for (int ku = 0; ku <= 6; ku++)
            for (int n = 1; n <= MAX / 2; n += 7) {
                wcut_banded m = given_a_random_band(&random, n, kl, ku);
                /* a strong diagonal keeps the condition number small; pivoting is the next test's */
                for (int i = 0; i < n; i++) *banded_at(&m, i, i) += 8, dense[i][i] += 8;
                for (int i = 0; i < n; i++) x[i] = b[i] = wcut_random_uniform(&random) - 0.5;
                ck_assert(wcut_banded_factor(&m));
                wcut_banded_solve(&m, x);
                ck_assert_double_lt(residual_of(n, x, b), 1e-14);
            }
}

TEST(a_permutation_is_solved_exactly_though_its_diagonal_is_zero) {
    enum { N = 12 };
    wcut_banded m = given_a_band(N, 1, 1);
    for (int i = 0; i < N; i += 2) *banded_at(&m, i, i + 1) = *banded_at(&m, i + 1, i) = 1;
    for (int i = 0; i < N; i++) b[i] = i;
    ck_assert(wcut_banded_factor(&m));
    wcut_banded_solve(&m, b);
    for (int i = 0; i < N; i++) ck_assert_double_eq(b[i], i % 2 == 0 ? i + 1 : i - 1);
}

TEST(a_tiny_diagonal_does_not_spoil_the_answer) {
    wcut_random random = wcut_random_seed(11);
    wcut_banded m = given_a_random_band(&random, MAX / 2, 3, 2);
    for (int i = 0; i < MAX / 2; i++) *banded_at(&m, i, i) = dense[i][i] = 1e-18;
    for (int i = 0; i < MAX / 2; i++) x[i] = b[i] = wcut_random_uniform(&random) - 0.5;
    ck_assert(wcut_banded_factor(&m));
    wcut_banded_solve(&m, x);
    /* without interchanges the factors grow to 1e18 and no digit is left */
    ck_assert_double_lt(residual_of(MAX / 2, x, b), 1e-11);
}

TEST(one_factorisation_serves_any_number_of_right_hand_sides) {
    wcut_random random = wcut_random_seed(3);
    wcut_banded m = given_a_random_band(&random, 20, 2, 4);
    ck_assert(wcut_banded_factor(&m));
    for (int column = 0; column < 20; column++) { /* the columns of A itself: the answers are unit vectors */
        for (int i = 0; i < 20; i++) b[i] = dense[i][column];
        wcut_banded_solve(&m, b);
        for (int i = 0; i < 20; i++) ck_assert_double_eq_tol(b[i], i == column, 1e-10);
    }
}

TEST(a_singular_matrix_is_called_singular) {
    wcut_banded m = given_a_band(3, 1, 1); /* the middle row is zero */
    *banded_at(&m, 0, 0) = *banded_at(&m, 2, 2) = 1;
    ck_assert(!wcut_banded_factor(&m));

    m = given_a_band(4, 1, 1); /* a chain of springs without a support: rows sum to zero, in exact numbers */
    for (int i = 0; i < 4; i++) {
        *banded_at(&m, i, i) = i == 0 || i == 3 ? 1 : 2;
        if (i > 0) *banded_at(&m, i, i - 1) = -1;
        if (i < 3) *banded_at(&m, i, i + 1) = -1;
    }
    ck_assert(!wcut_banded_factor(&m));
}

TEST(a_matrix_that_is_not_finite_is_called_singular) {
    const double bad[] = {NAN, (double)INFINITY};
    for (int k = 0; k < 2; k++) {
        wcut_banded m = given_a_band(3, 1, 1);
        for (int i = 0; i < 3; i++) *banded_at(&m, i, i) = 1;
        *banded_at(&m, 1, 1) = bad[k];
        ck_assert(!wcut_banded_factor(&m));
    }
}
