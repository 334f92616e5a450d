/* B-spline basis functions and their derivatives (de Boor 1972, Cox 1972). */
#ifndef WCUT_SURFACE_BASIS_H
#define WCUT_SURFACE_BASIS_H

#include <stdbool.h>
#include <wirecut/curve.h>

enum { WCUT_ORDER_MAX = 3, WCUT_BASIS_SIZE = WCUT_DEGREE_MAX + 1 };

/* the degree + 1 functions that are not zero at a parameter: N_{span-degree+r} and its derivatives */
typedef struct wcut_basis {
    int span; /* knots[span] <= u < knots[span+1], at the end of the domain the last such span */
    double value[WCUT_ORDER_MAX + 1][WCUT_BASIS_SIZE]; /* [k][r] = d^k N / du^k */
} wcut_basis;

/* finite, not decreasing, every basis function with a support, the curve continuous, the domain not empty */
bool wcut_knots_are_valid(int degree, int count, const double *knots);

/* the span of u, which lies in the domain */
int wcut_basis_span(int degree, int count, const double *knots, double u);

/* values and derivatives up to `order` (0 .. WCUT_ORDER_MAX) at u, which is clamped to the domain */
void wcut_basis_eval(int degree, int count, const double *knots, double u, int order, wcut_basis *basis);

/* the values alone of the four cubic functions at u; returns the span. The same numbers, without a table. */
int wcut_basis_cubic(int count, const double *knots, double u, double value[4]);

#endif
