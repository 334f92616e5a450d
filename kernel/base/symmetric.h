/* Eigenvalues and eigenvectors of a small symmetric matrix, and its inverse. */
#ifndef WCUT_BASE_SYMMETRIC_H
#define WCUT_BASE_SYMMETRIC_H

enum { WCUT_SYMMETRIC_MAX = 6 }; /* unknowns of wcut_symmetric_solve */

/* a: n x n, finite, destroyed. value: n, the greatest first. vector: n x n, orthonormal,
   vector[i * n + k] is the i-th coordinate of the k-th. */
void wcut_symmetric_eigen(int n, double *a, double *value, double *vector);

/* x = A^-1 b for a symmetric positive definite matrix (Cholesky); false where it is not, x is untouched then. inverse:
   n x n, or NULL */
int wcut_symmetric_solve(int n, const double *a, const double *b, double *x, double *inverse);

#endif
