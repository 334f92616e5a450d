/* wirecut/offset.h - the surface at a distance from another, as a kerf leaves it. */
#ifndef WCUT_OFFSET_H
#define WCUT_OFFSET_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Accuracy of an offset, and where it folds or crosses itself. */
typedef struct wcut_offset_report {
    double error;     /**< [mm] measured: largest distance of the result from S + distance n at equal parameters */
    double curvature; /**< [1/mm] strongest bend towards the side of the offset, 0 where it bends away everywhere */
    double tight_u;   /**< where that is */
    double tight_v;   /**< */
    int folds;        /**< samples where its radius 1 / curvature is no larger than the distance: the result folds */
    int crossings;    /**< pairs of triangles of the result's tessellation that cross */
    double crossing_u[2]; /**< parameters of the first such pair */
    double crossing_v[2]; /**< */
} wcut_offset_report;

/**
 * A bicubic surface through S + distance n at parameters chosen so that its error is at most a tolerance, measured
 * between them at every knot of S and at quarters of every cell. Same parameters as S. At a pole the normal is that of
 * the points around it.
 *
 * @param[in]  surface   a valid surface, its normal continuous
 * @param[in]  distance  [mm] finite; positive towards S_u x S_v
 * @param[in]  tolerance [mm] positive
 * @param[out] offset    the caller's, to wcut_surface_destroy
 * @param[out] report    may be NULL (folds and crossings are then not looked for); folds and crossings are not errors:
 *                       a caller who needs a surface without them checks that both are 0
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (the surface has a crease, or no area), WCUT_NOT_CONVERGED (more
 *         than 2^24 control points would be needed, or a tolerance below 1e-14 of the coordinates), WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_surface_offset(const wcut_surface *surface, double distance, double tolerance,
                                         wcut_surface **offset, wcut_offset_report *report);

#ifdef __cplusplus
}
#endif

#endif
