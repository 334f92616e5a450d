/* Eigenvalues and eigenvectors of a small symmetric matrix: cyclic rotations (Jacobi 1846); its inverse by Cholesky. */
#include "base/symmetric.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/dense.h"

enum { SWEEPS = 60 }; /* quadratic convergence: ten are many */

/* turn rows and columns p, q so that a[p][q] becomes 0 */
static void rotate_pair(int n, double *a, double *vector, int p, int q) {
    const double tau = (a[q * n + q] - a[p * n + p]) / (2 * a[p * n + q]);
    const double t = (tau < 0 ? -1 : 1) / (fabs(tau) + hypot(1, tau)), c = 1 / hypot(1, t), s = t * c;
    for (int k = 0; k < n; k++) {
        const double x = a[k * n + p], y = a[k * n + q];
        a[k * n + p] = c * x - s * y, a[k * n + q] = s * x + c * y;
    }
    for (int k = 0; k < n; k++) {
        const double x = a[p * n + k], y = a[q * n + k];
        a[p * n + k] = c * x - s * y, a[q * n + k] = s * x + c * y;
    }
    for (int k = 0; k < n; k++) {
        const double x = vector[k * n + p], y = vector[k * n + q];
        vector[k * n + p] = c * x - s * y, vector[k * n + q] = s * x + c * y;
    }
    a[p * n + q] = a[q * n + p] = 0;
}

/* one pass over all pairs; false where nothing was left to turn */
static bool sweep_pairs(int n, double *a, double *vector) {
    bool turned = false;
    for (int p = 0; p < n; p++)
        for (int q = p + 1; q < n; q++)
            if (fabs(a[p * n + q]) > 1e-17 * sqrt(fabs(a[p * n + p] * a[q * n + q])) && fabs(a[p * n + q]) > 1e-300) {
                rotate_pair(n, a, vector, p, q);
                turned = true;
            }
    return turned;
}

static void order_values(int n, double *value, double *vector) {
    for (int k = 0; k < n; k++) {
        int max = k;
        for (int j = k + 1; j < n; j++)
            if (value[j] > value[max]) max = j;
        const double keep = value[k];
        value[k] = value[max], value[max] = keep;
        for (int i = 0; i < n; i++) {
            const double x = vector[i * n + k];
            vector[i * n + k] = vector[i * n + max], vector[i * n + max] = x;
        }
    }
}

void wcut_symmetric_eigen(int n, double *a, double *value, double *vector) {
    for (int i = 0; i < n * n; i++) vector[i] = i % (n + 1) == 0;
    for (int k = 0; k < SWEEPS && sweep_pairs(n, a, vector); k++) continue;
    for (int i = 0; i < n; i++) value[i] = a[i * n + i];
    order_values(n, value, vector);
}

int wcut_symmetric_solve(int n, const double *a, const double *b, double *x, double *inverse) {
    double l[WCUT_SYMMETRIC_MAX * WCUT_SYMMETRIC_MAX], column[WCUT_SYMMETRIC_MAX];
    memcpy(l, a, (size_t)(n * n) * sizeof *l);
    if (!wcut_cholesky_factor(n, l, 0)) return 0;
    memmove(x, b, (size_t)n * sizeof *x);
    wcut_cholesky_solve(n, l, x);
    for (int j = 0; inverse && j < n; j++) {
        for (int i = 0; i < n; i++) column[i] = i == j;
        wcut_cholesky_solve(n, l, column);
        for (int i = 0; i < n; i++) inverse[i * n + j] = column[i];
    }
    return 1;
}
