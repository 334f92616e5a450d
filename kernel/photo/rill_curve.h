/* The wire that fits the rills, beside the simulated one. */
#ifndef WCUT_PHOTO_RILL_CURVE_H
#define WCUT_PHOTO_RILL_CURVE_H

#include <wirecut/overlay.h>

/* patches over the block: where the first begins, and their side */
typedef struct wcut_patch_grid {
    int columns, rows;
    double side, x0, y0; /* [mm] */
    const wcut_rill_patch *patch;
} wcut_patch_grid;

/* the wires to measure, evenly chosen among those that touch foam. WCUT_OK; WCUT_NO_MEMORY */
wcut_status wcut_rill_curves(wcut_vec3 block, const wcut_history *history, const wcut_patch_grid *grid, int curves,
                             int *count, wcut_rill_curve **curve);
void wcut_rill_curves_free(int count, wcut_rill_curve *curve);

#endif
