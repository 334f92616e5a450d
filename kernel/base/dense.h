/* Small dense symmetric systems: Cholesky's factor, row-major, in place. */
#ifndef WCUT_BASE_DENSE_H
#define WCUT_BASE_DENSE_H

#include <stdbool.h>

/* L L^T = a: the lower triangle of a (n x n) becomes L, the upper one is neither read nor written. False where a pivot
   is not above pivot_min (not negative), then a is of no use. */
bool wcut_cholesky_factor(int n, double *a, double pivot_min);

/* L L^T x = b: x in the place of b */
void wcut_cholesky_solve(int n, const double *l, double *b);

#endif
