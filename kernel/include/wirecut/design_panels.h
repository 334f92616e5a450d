/* wirecut/design_panels.h - a target in panels: several cuts side by side where one does not hold the tolerance. */
#ifndef WCUT_DESIGN_PANELS_H
#define WCUT_DESIGN_PANELS_H

#include <wirecut/design.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_DESIGN_PANELS_MAX = 64 };

/** A part of the block's plan, which is a block and a cut of its own. */
typedef struct wcut_design_panel {
    wcut_vec3 low, high;  /**< [mm] in the target's block; the panel's own block begins at low */
    double predicted_rms; /**< [mm] by its map */
    wcut_design *design;  /**< in the panel's block, turned by the design's feed */
} wcut_design_panel;

/** Where two panels meet: how their faces differ along the line between them. */
typedef struct wcut_design_joint {
    int first, second;           /**< panels */
    int places;                  /**< along the line, where both faces are; 0: the figures are not read */
    double step_rms, step_max;   /**< [mm] between the faces, across them */
    double angle_rms, angle_max; /**< [rad] between their normals */
} wcut_design_joint;

/** A division of a target, row by row along y. */
typedef struct wcut_design_panels {
    int across, along;        /**< panels along x and along y */
    int count;                /**< across * along */
    wcut_design_panel *panel; /**< count; panel j * across + i is the i-th along x, the j-th along y */
    int joints;
    wcut_design_joint *joint;
    double rms, max; /**< [mm] of all panels' points from the faces that their paths cut */
    int runs;        /**< simulations in all */
} wcut_design_panels;

/**
 * The division with the fewest panels that holds a tolerance: of every number of panels the division whose maps promise
 * the least rms, its panels designed one by one. Numbers whose maps promise far too little are passed over.
 *
 * @param[in]  target   the block's frame
 * @param[in]  job      process, stations and nodes of every panel; its block is the target's
 * @param[in]  options  NULL for the defaults; with free_edges 0 the panels' common edges lie on the target, so that they meet
 * @param[in]  most     panels, 1 .. WCUT_DESIGN_PANELS_MAX
 * @param[in]  held     [mm] rms that is to be held, positive
 * @param[in]  progress may be NULL
 * @param[in]  context  handed to progress
 * @param[out] panels   the caller's, to wcut_design_panels_destroy
 * @param[out] error    may be NULL
 * @return WCUT_OK, whether the tolerance is held or not: see rms; where it is not, the division with the lowest rms of those
 *         that were tried; WCUT_INTERRUPTED: a division whose panels all have a design is handed out, or, where there is none yet,
 *         nothing was written; the statuses of wcut_design_fit: nothing was written.
 */
WCUT_API wcut_status wcut_design_panels_fit(const wcut_design_target *target, const wcut_job *job,
                                            const wcut_design_options *options, int most, double held,
                                            wcut_design_progress progress, void *context, wcut_design_panels **panels,
                                            wcut_error *error);

/** Free panels with their designs; NULL is allowed. */
WCUT_API void wcut_design_panels_destroy(wcut_design_panels *panels);

#ifdef __cplusplus
}
#endif

#endif
