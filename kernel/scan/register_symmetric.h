/* Eigenvalues and eigenvectors of a small symmetric matrix. */
#ifndef WCUT_SCAN_REGISTER_SYMMETRIC_H
#define WCUT_SCAN_REGISTER_SYMMETRIC_H

enum { WCUT_SYMMETRIC_MAX = 6 };

/* a: n x n, finite, destroyed; n at most WCUT_SYMMETRIC_MAX. value: n, the greatest first. vector: n x n, orthonormal,
   vector[i * n + k] is the i-th coordinate of the k-th. */
void wcut_symmetric_eigen(int n, double *a, double *value, double *vector);

/* x = A^-1 b for a symmetric positive definite matrix (Cholesky); false where it is not, x is untouched then. inverse:
   n x n, or NULL */
int wcut_symmetric_solve(int n, const double *a, const double *b, double *x, double *inverse);

#endif
