/* How near a misspelt word is to a known one. */
#include "io/file/nearest.h"

#include <stdbool.h>
#include <string.h>

static int min_of(int a, int b, int c) { return a < b ? (a < c ? a : c) : (b < c ? b : c); }

int wcut_edit_distance(const char *a, const char *b) {
    if (strlen(a) > WCUT_NEAREST_MAX || strlen(b) > WCUT_NEAREST_MAX) return WCUT_NEAREST_MAX;
    const int n = (int)strlen(a), m = (int)strlen(b);
    int d[WCUT_NEAREST_MAX + 1][WCUT_NEAREST_MAX + 1];

    /* from nothing to either word: a letter at a time */
    for (int i = 0; i <= n; i++) d[i][0] = i;
    for (int j = 0; j <= m; j++) d[0][j] = j;

    /* the cheapest way to each pair of beginnings */
    for (int i = 1; i <= n; i++)
        for (int j = 1; j <= m; j++) {
            d[i][j] = min_of(d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1]));
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped && d[i - 2][j - 2] + 1 < d[i][j]) d[i][j] = d[i - 2][j - 2] + 1;
        }
    return d[n][m];
}
