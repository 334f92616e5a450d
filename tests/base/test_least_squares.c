/* Linear and nonlinear least squares: exact answers, invariance, certified values, and refusals. */
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/least_squares.h"
#include "base/random.h"
#include "test.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof(array)[0]))

TEST(a_polynomial_comes_back_exactly_and_so_does_its_inverse) {
    enum { M = 7, N = 3 };
    const double truth[N] = {2, -3e4, 5e-5};
    double a[M * N], b[M], x[N], inverse[N * N], normal[N * N] = {0};
    for (int i = 0; i < M; i++) {
        const double row[N] = {1, i * 1e-4, i * i * 1e5};
        b[i] = 0;
        for (int j = 0; j < N; j++) a[i * N + j] = row[j], b[i] += row[j] * truth[j];
        for (int j = 0; j < N; j++)
            for (int k = 0; k < N; k++) normal[j * N + k] += row[j] * row[k];
    }
    ck_assert_int_eq(wcut_qr_solve(M, N, a, b, x, inverse), WCUT_OK);
    for (int j = 0; j < N; j++) ck_assert_double_eq_tol(x[j] / truth[j], 1, 1e-12);
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            double sum = 0, size = 0;
            for (int k = 0; k < N; k++) sum += inverse[i * N + k] * normal[k * N + j];
            for (int k = 0; k < N; k++) size += fabs(inverse[i * N + k] * normal[k * N + j]);
            ck_assert_double_eq_tol(sum, i == j, 1e-13 * (1 + size));
        }
    }
}

TEST(dependent_columns_are_singular_whatever_their_units) {
    double a[] = {1, 2e-9, 2, 4e-9, 3, 6e-9}, b[] = {1, 2, 4}, x[] = {999, 999}, inverse[] = {999, 999, 999, 999};
    ck_assert_int_eq(wcut_qr_solve(3, 2, a, b, x, inverse), WCUT_SINGULAR);
    double zero[] = {1, 0, 2, 0, 3, 0};
    ck_assert_int_eq(wcut_qr_solve(3, 2, zero, b, x, inverse), WCUT_SINGULAR);
    ck_assert(x[0] == 999 && x[1] == 999 && inverse[0] == 999 && inverse[3] == 999);
    ck_assert_int_eq(wcut_qr_solve(1, 2, a, b, x, NULL), WCUT_BAD_ARGUMENT);
}

/* NIST StRD Misra1a (Misra 1978): y = b1 (1 - exp(-b2 x)), certified to 11 digits */
static const double misra_x[] = {77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                 378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
static const double misra_y[] = {10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                 44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};

static bool misra(void *data, const double *x, double *r, double *jacobian) {
    const double *y = data;
    for (int i = 0; i < COUNT(misra_x); i++) {
        double e = exp(-x[1] * misra_x[i]);
        r[i] = x[0] * (1 - e) - y[i];
        if (jacobian) jacobian[2 * i] = 1 - e, jacobian[2 * i + 1] = x[0] * misra_x[i] * e;
    }
    return x[1] > 0;
}

TEST(misra1a_is_found_to_its_certified_digits_from_both_starts) {
    const double start[2][2] = {{500, 1e-4}, {250, 5e-4}};
    for (int k = 0; k < 2; k++) {
        double x[2], covariance[4];
        wcut_lsq_report report;
        memcpy(x, start[k], sizeof x);
        wcut_lsq_problem p = {COUNT(misra_x), 2, misra, (void *)misra_y, NULL};
        ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, covariance, NULL, &report), WCUT_OK);
        ck_assert_double_eq_tol(x[0] / 2.3894212918e+02, 1, 1e-10);
        ck_assert_double_eq_tol(x[1] / 5.5015643181e-04, 1, 1e-10);
        ck_assert_double_eq_tol(sqrt(covariance[0]) / 2.7070075241e+00, 1, 1e-9);
        ck_assert_double_eq_tol(sqrt(covariance[3]) / 7.2668688436e-06, 1, 1e-9);
        ck_assert_double_eq_tol(report.scale / 1.0187876330e-01, 1, 1e-9);
        ck_assert_int_eq(report.degrees, 12);
        ck_assert_int_lt(report.iterations, 60);
    }
}

/* a straight line through (i, y_i) */
static bool line(void *data, const double *x, double *r, double *jacobian) {
    const double *y = data;
    for (int i = 0; i < 12; i++) {
        r[i] = x[0] + x[1] * i - y[i];
        if (jacobian) jacobian[2 * i] = 1, jacobian[2 * i + 1] = i;
    }
    return true;
}

static wcut_lsq_problem noisy_line(double y[12], const double *weight) {
    wcut_random random = wcut_random_seed(4);
    for (int i = 0; i < 12; i++) y[i] = 3 - 2 * i + 0.1 * wcut_random_normal(&random);
    return (wcut_lsq_problem){12, 2, line, y, weight};
}

TEST(a_weight_of_zero_is_the_same_as_leaving_the_sample_out) {
    double y[12], weight[12], x[2] = {0, 0}, z[2] = {0, 0}, covariance[4], other[4];
    for (int i = 0; i < 12; i++) weight[i] = i != 5;
    wcut_lsq_problem p = noisy_line(y, weight);
    wcut_lsq_report report;
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, covariance, NULL, &report), WCUT_OK);
    y[5] = 1e6;
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, z, other, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(report.degrees, 9);
    for (int k = 0; k < 2; k++) ck_assert_double_eq_tol(x[k], z[k], 1e-10);
    for (int k = 0; k < 4; k++) ck_assert_double_eq_tol(covariance[k] / other[k], 1, 1e-9);
}

TEST(a_weight_of_two_counts_a_sample_twice) {
    double y[12], weight[12], x[2] = {0, 0}, z[2] = {0, 0};
    for (int i = 0; i < 12; i++) weight[i] = 1;
    weight[3] = 2;
    wcut_lsq_problem p = noisy_line(y, weight);
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, NULL, NULL, NULL), WCUT_OK);
    double a[26], b[13];
    for (int i = 0; i < 13; i++) a[2 * i] = 1, a[2 * i + 1] = i < 12 ? i : 3, b[i] = y[i < 12 ? i : 3];
    ck_assert_int_eq(wcut_qr_solve(13, 2, a, b, z, NULL), WCUT_OK);
    for (int k = 0; k < 2; k++) ck_assert_double_eq_tol(x[k], z[k], 1e-10);
}

TEST(an_outlier_pulls_least_squares_huber_less_and_tukey_not_at_all) {
    double off[3], y[12], clean[2] = {0, 0};
    wcut_lsq_problem p = noisy_line(y, NULL);
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, clean, NULL, NULL, NULL), WCUT_OK);
    for (int loss = 0; loss < 3; loss++) {
        double x[2] = {0, 0}, left[12];
        wcut_lsq_options o = wcut_lsq_options_default();
        o.loss = (wcut_loss)loss;
        p = noisy_line(y, NULL);
        y[11] += 20;
        ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, NULL, left, NULL), WCUT_OK);
        off[loss] = fabs(x[1] - clean[1]);
        if (loss == WCUT_LOSS_SQUARE) ck_assert(left[11] == 1);
        if (loss == WCUT_LOSS_TUKEY) ck_assert(left[11] == 0);
    }
    ck_assert_double_gt(off[0], 0.5);
    ck_assert_double_lt(off[1], off[0] / 5);
    ck_assert_double_lt(off[2], 0.03);
}

TEST(robust_fits_are_stationary_points_of_their_loss) {
    for (int loss = WCUT_LOSS_HUBER; loss <= WCUT_LOSS_TUKEY; loss++) {
        double y[12], x[2] = {0, 0}, left[12], r[12];
        wcut_lsq_report report;
        wcut_lsq_options o = wcut_lsq_options_default();
        o.loss = (wcut_loss)loss;
        wcut_lsq_problem p = noisy_line(y, NULL);
        y[7] -= 0.4;
        ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, NULL, left, &report), WCUT_OK);
        line(y, x, r, NULL);
        double sum = 0, moment = 0;
        for (int i = 0; i < 12; i++) {
            double u = r[i] / report.scale, v = u / 4.685;
            double psi = loss == WCUT_LOSS_HUBER ? fmax(-1.345, fmin(1.345, u))
                                                 : (fabs(v) < 1 ? u * (1 - v * v) * (1 - v * v) : 0);
            ck_assert_double_eq_tol(left[i] * u, psi, 1e-8);
            sum += psi;
            moment += i * psi;
        }
        ck_assert_double_eq_tol(sum, 0, 1e-8);
        ck_assert_double_eq_tol(moment, 0, 1e-7);
    }
}

TEST(a_scale_that_is_given_is_kept) {
    double y[12], x[2] = {0, 0}, left[12];
    wcut_lsq_report report;
    wcut_lsq_options o = wcut_lsq_options_default();
    o.loss = WCUT_LOSS_HUBER;
    o.scale = 1e6; /* so wide that nothing is an outlier: least squares */
    wcut_lsq_problem p = noisy_line(y, NULL);
    y[7] -= 4;
    ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, NULL, left, &report), WCUT_OK);
    double square[2] = {0, 0};
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, square, NULL, NULL, NULL), WCUT_OK);
    ck_assert(report.scale == 1e6 && left[7] == 1);
    ck_assert_double_eq_tol(x[1], square[1], 1e-10);
    o.scale = -1;
    ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, NULL, left, &report), WCUT_BAD_ARGUMENT);
}

TEST(data_on_the_curve_give_zero_errors_and_no_endless_loop) {
    for (int loss = 0; loss < 3; loss++) {
        double y[COUNT(misra_x)], x[2] = {250, 5e-4}, covariance[4];
        const double truth[2] = {240, 5.5e-4};
        double zero[COUNT(misra_x)] = {0};
        misra(zero, truth, y, NULL);
        wcut_lsq_options o = wcut_lsq_options_default();
        o.loss = (wcut_loss)loss;
        wcut_lsq_problem p = {COUNT(misra_x), 2, misra, y, NULL};
        ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, covariance, NULL, NULL), WCUT_OK);
        ck_assert_double_eq_tol(x[0], 240, 1e-9);
        ck_assert_double_lt(sqrt(covariance[0]), 1e-8);
    }
}

TEST(what_cannot_be_solved_is_refused_and_nothing_is_written) {
    double y[12], x[2] = {999, 999}, covariance[4] = {999}, left[12] = {999}, weight[12] = {0};
    wcut_lsq_report report = {.degrees = 999};
    wcut_lsq_problem p = noisy_line(y, weight), bad = p;
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, covariance, left, &report), WCUT_SINGULAR);
    weight[0] = -1;
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, covariance, left, &report), WCUT_BAD_ARGUMENT);
    weight[0] = NAN;
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, covariance, left, &report), WCUT_BAD_ARGUMENT);
    bad.m = 1;
    ck_assert_int_eq(wcut_lsq_solve(&bad, NULL, x, covariance, left, &report), WCUT_BAD_ARGUMENT);
    p.weight = NULL;
    wcut_lsq_options o = wcut_lsq_options_default();
    o.tolerance = 0;
    ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, covariance, left, &report), WCUT_BAD_ARGUMENT);
    y[3] = INFINITY;
    ck_assert_int_eq(wcut_lsq_solve(&p, NULL, x, covariance, left, &report), WCUT_BAD_ARGUMENT);
    ck_assert(x[0] == 999 && covariance[0] == 999 && left[0] == 999 && report.degrees == 999);
}

TEST(too_few_iterations_hand_out_the_last_iterate) {
    double x[2] = {500, 1e-4};
    wcut_lsq_report report = {.iterations = 999};
    wcut_lsq_options o = wcut_lsq_options_default();
    o.max_iterations = 3;
    wcut_lsq_problem p = {COUNT(misra_x), 2, misra, (void *)misra_y, NULL};
    ck_assert_int_eq(wcut_lsq_solve(&p, &o, x, NULL, NULL, &report), WCUT_NOT_CONVERGED);
    ck_assert_int_eq(report.iterations, 3);
    ck_assert(x[0] != 500);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    double x[2] = {500, 1e-4}, covariance[4] = {999};
    wcut_lsq_problem p = {COUNT(misra_x), 2, misra, (void *)misra_y, NULL};
    EACH_FAILED_ALLOCATION(wcut_lsq_solve(&p, NULL, x, covariance, NULL, NULL), x[0] == 500 && covariance[0] == 999);
}
