/* The scans of a comparison: cleaned and held in memory, or, beyond what is to be held, read a second time. */
#ifndef APP_COMPARE_SCAN_H
#define APP_COMPARE_SCAN_H

#include <stdbool.h>
#include <wirecut/wirecut.h>

/* what is wanted of the scans */
typedef struct app_scan_options {
    wcut_length_unit unit;
    const char *columns; /* of text; NULL: told by the header */
    bool cleaned;        /* `clean` removes something */
    wcut_clean_options clean;
    int hold;    /* points held in memory; more are held only to be cleaned */
    double plan; /* [mm^2] of the face seen from above: sets how a sample is thinned */
    int threads;
} app_scan_options;

typedef struct app_scans {
    app_scan_options options;
    int files;
    const char **path;
    wcut_compared_scan *scan;        /* files */
    char (*hash)[WCUT_SHA256_TEXT];  /* files */
    int removed[WCUT_REMOVAL_COUNT]; /* removed[WCUT_REMOVAL_KEPT] are compared */
    wcut_vec3 low, high;             /* [mm] of what was read */
    bool held;                       /* point is all that is compared; else an even sample of it */
    int count;
    wcut_vec3 *point;
    double spacing; /* [mm] cubes of which the sample has a point each; 0 where everything is held */
} app_scans;

/* Read and clean. Gives an exit code, after a line that says why. */
int app_scans_read(app_scans *scans, const app_scan_options *options, int files, const char **path);
void app_scans_clear(app_scans *scans);

enum { APP_SCAN_PIECE = 65536 };

/* takes a piece of the scan, from the first-th point on; gives an exit code */
typedef int app_scan_visitor(void *context, int first, int count, const wcut_vec3 *point);

/* Hand out all that is compared, piece by piece, in order. Gives an exit code. */
int app_scans_pass(const app_scans *scans, app_scan_visitor *visit, void *context);

#endif
