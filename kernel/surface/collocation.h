/* The banded, totally positive system of spline interpolation: one factorisation, all right-hand sides together. */
#ifndef WCUT_SURFACE_COLLOCATION_H
#define WCUT_SURFACE_COLLOCATION_H

#include <wirecut/status.h>

/* LU of the matrix N_j(u_i): row i holds the columns i-below .. i+above */
typedef struct wcut_collocation {
    int count, below, above;
    double *entry; /* count x (below + above + 1) */
} wcut_collocation;

enum { WCUT_SLOPE_FIRST = 1, WCUT_SLOPE_LAST = 2 };

/* Factor for `count` parameters, increasing, and as many control points. `slopes`: the second row and the last but one
   may ask for the derivative at that end instead of a value (its parameter is then the end's).
   WCUT_SINGULAR where a parameter lies outside its function's support (Schoenberg, Whitney 1953); WCUT_NO_MEMORY.
   The caller frees `entry`. */
wcut_status wcut_collocation_factor(int degree, int count, const double *knots, const double *parameter, int slopes,
                                    wcut_collocation *system);

/* factor a filled matrix in place, without pivoting. WCUT_SINGULAR: it is spoilt. */
wcut_status wcut_collocation_eliminate(wcut_collocation *system);

/* solve in place for `columns` right-hand sides: b is count x columns */
void wcut_collocation_solve(const wcut_collocation *system, int columns, double *b);

#endif
