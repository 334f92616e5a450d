/* The scan of a comparison: cleaned and held in memory, or, beyond what is to be held, read a second time. */
#ifndef WCUT_IO_SCAN_COMPARE_CLOUD_H
#define WCUT_IO_SCAN_COMPARE_CLOUD_H

#include <stdbool.h>
#include <wirecut/compare.h>
#include <wirecut/report.h>

typedef struct wcut_compare_cloud {
    const wcut_compare_options *options;
    const wcut_compare_watch *watch;
    int parts, hold;
    bool cleaned;                    /* options->clean removes something */
    const wcut_compare_scan *part;   /* parts, borrowed */
    wcut_compared_scan *scan;        /* parts */
    char (*hash)[WCUT_SHA256_TEXT];  /* parts */
    double plan;                     /* [mm^2] of the face seen from above: sets how a sample is thinned */
    int removed[WCUT_REMOVAL_COUNT]; /* removed[WCUT_REMOVAL_KEPT] are compared */
    wcut_vec3 low, high;             /* [mm] of what was read */
    bool held;                       /* point is all that is compared; else an even sample of it */
    int count;
    wcut_vec3 *point;
    double spacing; /* [mm] cubes of which the sample has a point each; 0 where everything is held */
} wcut_compare_cloud;

/* whether cleaning removes anything */
bool wcut_compare_cleans(const wcut_clean_options *clean);

/* Read and clean; plan, hold and what is borrowed are set. The statuses of wcut_compare_run; the cloud is to be cleared
   whatever they are. */
wcut_status wcut_compare_cloud_read(wcut_compare_cloud *cloud, wcut_error *error);
void wcut_compare_cloud_clear(wcut_compare_cloud *cloud);

enum { WCUT_COMPARE_PIECE = 65536 };

/* takes a piece of the scan, from the first-th point on */
typedef wcut_status wcut_compare_visitor(void *context, int first, int count, const wcut_vec3 *point,
                                         wcut_error *error);

/* Hand out all that is compared, piece by piece, in order. */
wcut_status wcut_compare_cloud_pass(const wcut_compare_cloud *cloud, wcut_compare_visitor *visit, void *context,
                                    wcut_error *error);

#endif
