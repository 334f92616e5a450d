/* Small dense least squares: linear by Householder QR, nonlinear by Levenberg-Marquardt, robust by reweighting. */
#ifndef WCUT_BASE_LEAST_SQUARES_H
#define WCUT_BASE_LEAST_SQUARES_H

#include <stdbool.h>
#include <wirecut/loss.h>
#include <wirecut/status.h>

/*
 * min |A x - b| by Householder QR with column scaling and pivoting.
 *
 * m, n: rows and columns, m >= n >= 1; a: m x n row-major, destroyed; b: m, destroyed;
 * x: n, out; inverse: n x n (A^T A)^-1, out, or NULL.
 * WCUT_OK; WCUT_SINGULAR: the columns are dependent to 1e-13 of their lengths, x and inverse are untouched;
 * WCUT_NO_MEMORY.
 */
wcut_status wcut_qr_solve(int m, int n, double *a, double *b, double *x, double *inverse);

/*
 * The residuals of a model: r_i(x), m of them, each in units of its own standard deviation up to one common factor;
 * jacobian: m x n row-major dr_i/dx_j, or NULL where it is not wanted. False where x is outside the model's domain
 * (or a residual is not finite): a step that leads there is shortened.
 */
typedef bool (*wcut_lsq_model)(void *data, const double *x, double *r, double *jacobian);

typedef struct wcut_lsq_problem {
    int m, n; /* residuals, parameters; m >= n >= 1 */
    wcut_lsq_model model;
    void *data;           /* handed to the model */
    const double *weight; /* m, not negative (0 leaves a residual out), or NULL for all 1 */
} wcut_lsq_problem;

typedef struct wcut_lsq_options {
    wcut_loss loss;     /* default WCUT_LOSS_SQUARE */
    double tolerance;   /* [1] cosine between the residual and every column of the Jacobian; default 1e-11 */
    int max_iterations; /* Levenberg-Marquardt steps of each reweighting round; default 200 */
    int max_rounds;     /* reweighting rounds of a robust loss; default 500 */
    double scale;       /* of a robust loss; default 0: 1.4826 MAD of the residuals */
} wcut_lsq_options;

typedef struct wcut_lsq_report {
    double cost;    /* sum of weight r^2 at x, without the loss's weights */
    double scale;   /* standard deviation of a residual of weight 1; for a robust loss 1.4826 MAD */
    int degrees;    /* residuals of positive weight less n */
    int iterations; /* steps tried in all */
    int rounds;     /* reweighting rounds */
} wcut_lsq_report;

wcut_lsq_options wcut_lsq_options_default(void);

/*
 * min sum weight_i loss(r_i(x)) (Levenberg 1944, Marquardt 1963; damping after Nielsen 1999; iterated reweighting for
 * the robust losses, Holland, Welsch 1977).
 *
 * x: n, a start inside the domain in, the minimum out. covariance: n x n, scale^2 (J^T W J)^-1, for a robust loss with
 * Huber's (1981, 7.6) correction; all 0 where degrees is 0; or NULL. loss_weight: m, what the loss left of each
 * residual's weight, in [0, 1]; or NULL. report: or NULL.
 * WCUT_OK; WCUT_NOT_CONVERGED: the last iterate is handed out; WCUT_SINGULAR: the residuals do not determine x, or
 * fewer than n have a weight; WCUT_BAD_ARGUMENT: outside the ranges above, or x outside the model's domain;
 * WCUT_NO_MEMORY. On the last three nothing was written.
 */
wcut_status wcut_lsq_solve(const wcut_lsq_problem *problem, const wcut_lsq_options *options, double *x,
                           double *covariance, double *loss_weight, wcut_lsq_report *report);

#endif
