/* Sorting numbers and order statistics of sorted ones. Values are not NaN. */
#ifndef WCUT_BASE_SORT_H
#define WCUT_BASE_SORT_H

#include <assert.h>

/* into ascending order */
void wcut_sort(int n, double *x);

/* the middle value, or the mean of the middle two, of n >= 1 sorted values */
static inline double sorted_median(int n, const double *x) {
    assert(n >= 1);
    return n % 2 ? x[n / 2] : (x[n / 2 - 1] + x[n / 2]) / 2;
}

/* the value that a share of n >= 1 sorted values does not exceed, without interpolation: rank floor(share (n - 1)) */
static inline double sorted_quantile(int n, const double *x, double share) {
    assert(n >= 1 && share >= 0 && share <= 1);
    return x[(int)(share * (n - 1))];
}

#endif
