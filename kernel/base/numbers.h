/* Checks and small arithmetic on doubles. */
#ifndef WCUT_BASE_NUMBERS_H
#define WCUT_BASE_NUMBERS_H

#include <math.h>
#include <stdbool.h>

#define WCUT_PI 3.14159265358979323846

static inline double clamp(double x, double low, double high) { return x < low ? low : x > high ? high : x; }

static inline bool is_positive(double x) { return isfinite(x) && x > 0; }

static inline bool all_positive(int n, const double *x) {
    for (int i = 0; i < n; i++)
        if (!is_positive(x[i])) return false;
    return true;
}

static inline bool all_finite(int n, const double *x) {
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i])) return false;
    return true;
}

#endif
