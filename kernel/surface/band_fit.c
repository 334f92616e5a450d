/* Linear least squares against B-splines: banded normal equations, all right-hand sides together, the ends kept.

   B-splines are so well conditioned (de Boor 1978, XI) that the normal equations lose few digits up to degree 7, and
   every caller measures what it got. */
#include "surface/band_fit.h"

#include <stddef.h>
#include <string.h>

#include "base/alloc.h"
#include "surface/collocation.h"

/* A pivot below this share of the diagonal it began as is rounding. */
static const double PIVOT_MIN = 1e-13;

static double *band_fit_at(const wcut_collocation *s, int i, int j) {
    return s->entry + (ptrdiff_t)i * (s->below + s->above + 1) + (j - i + s->below);
}

/* A^T A, its first and last row those of the identity */
static void fill_normal(const wcut_band_rows *a, wcut_collocation *s) {
    for (int i = 0; i < a->rows; i++) {
        const double *value = a->value + (ptrdiff_t)i * a->width;
        for (int p = 0; p < a->width; p++)
            for (int q = 0; q < a->width; q++)
                if (value[p] != 0 && value[q] != 0)
                    *band_fit_at(s, a->first[i] + p, a->first[i] + q) += value[p] * value[q];
    }
    const int band = s->below + s->above + 1, ends[2] = {0, s->count - 1};
    for (int k = 0; k < 2; k++) {
        memset(s->entry + (ptrdiff_t)ends[k] * band, 0, (size_t)band * sizeof *s->entry);
        *band_fit_at(s, ends[k], ends[k]) = 1;
    }
}

/* A^T b, row by row */
static void fill_right(const wcut_band_rows *a, int count, int columns, const double *b, double *x) {
    const ptrdiff_t m = columns;
    for (int i = 1; i < a->rows - 1; i++)
        for (int p = 0; p < a->width; p++) {
            const double share = a->value[(ptrdiff_t)i * a->width + p];
            const int to = a->first[i] + p;
            if (share == 0 || to == 0 || to == count - 1) continue;
            double *restrict sum = x + to * m;
            const double *restrict from = b + i * m;
#pragma omp simd
            for (int c = 0; c < columns; c++) sum[c] += share * from[c];
        }
    memcpy(x, b, (size_t)columns * sizeof *x);
    memcpy(x + (count - 1) * m, b + (a->rows - 1) * m, (size_t)columns * sizeof *x);
}

wcut_status wcut_band_fit(const wcut_band_rows *a, int count, int columns, const double *b, double *x) {
    /* the band of the normal equations is twice as wide as that of the rows */
    wcut_collocation s = {.count = count, .below = a->width - 1, .above = a->width - 1};
    const size_t band = (size_t)s.below + (size_t)s.above + 1;
    s.entry = wcut_alloc((size_t)count, band * sizeof *s.entry);
    double *diagonal = wcut_alloc((size_t)count, sizeof *diagonal);
    double *sum = wcut_alloc((size_t)count, (size_t)columns * sizeof *sum);
    wcut_status status = s.entry && diagonal && sum ? WCUT_OK : WCUT_NO_MEMORY;

    /* factor; the diagonal before elimination is the scale of the pivots */
    if (status == WCUT_OK) {
        fill_normal(a, &s);
        for (int i = 0; i < count; i++) diagonal[i] = *band_fit_at(&s, i, i);
        status = wcut_collocation_eliminate(&s);
    }

    /* a pivot lost to rounding: the data do not determine this coefficient */
    for (int i = 0; status == WCUT_OK && i < count; i++)
        if (!(*band_fit_at(&s, i, i) > PIVOT_MIN * diagonal[i])) status = WCUT_SINGULAR;

    /* right sides, all columns together */
    if (status == WCUT_OK) {
        fill_right(a, count, columns, b, sum);
        wcut_collocation_solve(&s, columns, sum);
        memcpy(x, sum, (size_t)count * (size_t)columns * sizeof *x);
    }

    wcut_free(sum);
    wcut_free(diagonal);
    wcut_free(s.entry);
    return status;
}
