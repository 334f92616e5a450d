/* The banded, totally positive system of spline interpolation: one factorisation, all right-hand sides together.

   A totally positive matrix needs no pivoting: elimination without it is as exact as it gets (de Boor, Pinkus 1977).
   The rows that ask for a slope at an end hold (-a, a) and keep that: nothing is ever subtracted from their pivot. */
#include "surface/collocation.h"

#include <stddef.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "surface/basis.h"

static double *collocation_at(const wcut_collocation *s, int i, int j) {
    return s->entry + (ptrdiff_t)i * (s->below + s->above + 1) + (j - i + s->below);
}

/* which derivative row i asks for */
static int order_of(int i, int count, int slopes) {
    return ((slopes & WCUT_SLOPE_FIRST) && i == 1) || ((slopes & WCUT_SLOPE_LAST) && i == count - 2);
}

static void measure_band(int degree, const double *knots, const double *parameter, wcut_collocation *s) {
    s->below = s->above = 0;
    for (int i = 0; i < s->count; i++) {
        const double u = clamp(parameter[i], knots[degree], knots[s->count]);
        const int span = wcut_basis_span(degree, s->count, knots, u);
        if (i - (span - degree) > s->below) s->below = i - (span - degree);
        if (span - i > s->above) s->above = span - i;
    }
}

wcut_status wcut_collocation_eliminate(wcut_collocation *s) {
    for (int k = 0; k < s->count; k++) {
        const double pivot = *collocation_at(s, k, k);
        if (!(fabs(pivot) > 0) || !isfinite(pivot)) return WCUT_SINGULAR;
        for (int i = k + 1; i <= k + s->below && i < s->count; i++) {
            const double factor = *collocation_at(s, i, k) /= pivot;
            if (factor == 0) continue;
            for (int j = k + 1; j <= k + s->above && j < s->count; j++)
                *collocation_at(s, i, j) -= factor * *collocation_at(s, k, j);
        }
    }
    return WCUT_OK;
}

wcut_status wcut_collocation_factor(int degree, int count, const double *knots, const double *parameter, int slopes,
                                    wcut_collocation *system) {
    /* the width of the band follows from the parameters */
    wcut_collocation s = {.count = count};
    measure_band(degree, knots, parameter, &s);
    /* a parameter that far from its function's support has a zero on the diagonal, and no band to speak of */
    if (s.below > degree + 1 || s.above > degree + 1) return WCUT_SINGULAR;

    s.entry = wcut_alloc((size_t)count, (size_t)(s.below + s.above + 1) * sizeof(double));
    if (!s.entry) return WCUT_NO_MEMORY;

    /* a row for each parameter: basis functions, or their derivatives for an end slope */
    for (int i = 0; i < count; i++) {
        wcut_basis basis;
        const int order = order_of(i, count, slopes);
        wcut_basis_eval(degree, count, knots, parameter[i], order, &basis);
        for (int r = 0; r <= degree; r++) *collocation_at(&s, i, basis.span - degree + r) = basis.value[order][r];
    }

    const wcut_status status = wcut_collocation_eliminate(&s);
    if (status == WCUT_OK) {
        *system = s;
    } else {
        wcut_free(s.entry);
    }

    return status;
}

/* to -= factor * from */
static void subtract_row(int columns, double factor, const double *restrict from, double *restrict to) {
#pragma omp simd
    for (int c = 0; c < columns; c++) to[c] -= factor * from[c];
}

void wcut_collocation_solve(const wcut_collocation *s, int columns, double *b) {
    const ptrdiff_t m = columns;
    for (int i = 0; i < s->count; i++)
        for (int j = i < s->below ? 0 : i - s->below; j < i; j++)
            if (*collocation_at(s, i, j) != 0) subtract_row(columns, *collocation_at(s, i, j), b + j * m, b + i * m);
    for (int i = s->count - 1; i >= 0; i--) {
        for (int j = i + 1; j <= i + s->above && j < s->count; j++)
            if (*collocation_at(s, i, j) != 0) subtract_row(columns, *collocation_at(s, i, j), b + j * m, b + i * m);
        const double scale = 1 / *collocation_at(s, i, i);
        double *restrict row = b + i * m;
#pragma omp simd
        for (int c = 0; c < columns; c++) row[c] *= scale;
    }
}
