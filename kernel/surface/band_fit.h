/* Linear least squares against B-splines: banded normal equations, all right-hand sides together, the ends kept. */
#ifndef WCUT_SURFACE_BAND_FIT_H
#define WCUT_SURFACE_BAND_FIT_H

#include <wirecut/status.h>

/* row i of the matrix has `width` entries from column first[i] on; the first row picks the first unknown alone, the last
   row the last one */
typedef struct wcut_band_rows {
    int rows, width;
    const int *first;    /* rows, not decreasing */
    const double *value; /* rows x width */
} wcut_band_rows;

/* min |A x - b| with x_0 = b_0 and x_{count-1} = b_{rows-1}: b is rows x columns, x count x columns.
   WCUT_SINGULAR where an unknown has no row, WCUT_NO_MEMORY: x is not written. */
wcut_status wcut_band_fit(const wcut_band_rows *a, int count, int columns, const double *b, double *x);

#endif
