/* Sorting numbers. */
#include "base/sort.h"

#include <stdlib.h>

static int compare_doubles(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void wcut_sort(int n, double *x) {
    if (n > 1) qsort(x, (size_t)n, sizeof *x, compare_doubles);
}
