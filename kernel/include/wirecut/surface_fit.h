/* wirecut/surface_fit.h - a surface with few control points near a grid of nodes. */
#ifndef WCUT_SURFACE_FIT_H
#define WCUT_SURFACE_FIT_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a fit reached. */
typedef struct wcut_surface_fit_report {
    double node_error;    /**< [mm] measured: largest distance of a node from the surface at the node's parameters */
    double between_error; /**< [mm] measured: largest distance from the loft through all nodes, between these */
    int control_count;    /**< control points of the surface */
    int node_count;       /**< nodes of the sections used */
    int used, dropped;    /**< sections, as in wcut_loft_report */
} wcut_surface_fit_report;

/**
 * Bicubic surface by least squares near the wire of every station, with knots only where they are needed: their
 * density follows the fourth root of the error, until the distance is within a tolerance at every node, and from the
 * loft through the nodes between them. Parameters as in wcut_surface_loft; the corners are kept. Where a direction
 * needs nearly as many control points as there are nodes it is interpolated.
 *
 * @param[in]  stations  at least 2
 * @param[in]  nodes     at least 2
 * @param[in]  position  stations x nodes [mm], finite
 * @param[in]  merge     [mm] as in wcut_surface_loft
 * @param[in]  tolerance [mm] positive
 * @param[out] surface   the caller's, to wcut_surface_destroy
 * @param[out] parameter stations, may be NULL: v of each section, for dropped ones that of the section kept before
 * @param[out] report    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (as wcut_surface_loft), WCUT_NOT_CONVERGED (a tolerance that
 *         rounding alone exceeds), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_fit(int stations, int nodes, const wcut_vec3 *position, double merge,
                                      double tolerance, wcut_surface **surface, double *parameter,
                                      wcut_surface_fit_report *report);

#ifdef __cplusplus
}
#endif

#endif
