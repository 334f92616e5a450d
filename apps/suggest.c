/* The name that a misspelt one was meant to be: smallest edit distance (Damerau 1964, adjacent swaps). */
#include <string.h>

#include "command.h"

enum { LONGEST = 40 };

static int min(int a, int b) { return a < b ? a : b; }

/* Insertions, deletions, replacements and swaps that turn one word into the other. */
static int option_distance(const char *from, const char *to) {
    int n = (int)strlen(from), m = (int)strlen(to), d[LONGEST + 1][LONGEST + 1];
    for (int i = 0; i <= n; i++) d[i][0] = i;
    for (int j = 0; j <= m; j++) d[0][j] = j;
    for (int i = 1; i <= n; i++)
        for (int j = 1; j <= m; j++) {
            int best = d[i - 1][j - 1] + (from[i - 1] != to[j - 1]);
            best = min(best, 1 + min(d[i - 1][j], d[i][j - 1]));
            if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1])
                best = min(best, d[i - 2][j - 2] + 1);
            d[i][j] = best;
        }
    return d[n][m];
}

const char *app_suggest(const char *typed, const char *const *name) {
    size_t length = strlen(typed);
    if (length == 0 || length > LONGEST) return NULL;
    const char *nearest = NULL;
    int best = 1 + (int)length / 3; /* a third of the letters may be wrong */
    for (; *name; name++) {
        if (strlen(*name) > LONGEST) continue;
        int d = option_distance(typed, *name);
        if (d <= best && (!nearest || d < best)) nearest = *name, best = d;
    }
    return nearest;
}
