/* Candidate wires laid on a target, and the best of them for every place of the feed. */
#ifndef WCUT_INVERSE_SCAN_H
#define WCUT_INVERSE_SCAN_H

#include "inverse/target.h"

enum { WCUT_SCAN_SAMPLES = 17 }; /* of a wire */

/* the wire of one row: y = middle + lag (1/2 - x/W) - 4 sag x/W (1 - x/W) */
typedef struct wcut_scan_row {
    double middle, lag, sag;       /* [mm] */
    double rise_a, rise_b;         /* [mm] of its ends over the target */
    double bow[WCUT_SCAN_SAMPLES]; /* [mm] of the wire over the target at x = W k / (samples - 1) */
} wcut_scan_row;

typedef struct wcut_scan {
    int rows;
    wcut_scan_row *row; /* along the feed, evenly apart, from before the block to behind it */
    double rms, max;    /* [mm] of the bow inside the block */
} wcut_scan;

/* The wires of a target that is fed along +y. Along a wire in steady foam the normal curvature is 0; what the target has
   instead, integrated twice, is the bow of the wire out of it. The sum of its squares is made least by dynamic programming
   (Bellman 1957) over lag and sag, which change from row to row no faster than a cut can. free_edges: the ends are where
   the squares are least, else on the target. angle_max: [rad] of the ends against x. */
wcut_status wcut_scan_create(const wcut_design_target *target, bool free_edges, double angle_max, wcut_scan *out);
void wcut_scan_clear(wcut_scan *scan);

/* y of a candidate wire at x = share W */
double wcut_scan_y(const wcut_scan_row *row, double share);

#endif
