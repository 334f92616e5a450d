/* wirecut/crossing.h - where a mesh or a surface intersects itself, folds or shrinks to a point. */
#ifndef WCUT_CROSSING_H
#define WCUT_CROSSING_H

#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Two triangles of a mesh that cross. */
typedef struct wcut_crossing {
    int first, second; /**< triangles, first < second */
    wcut_vec3 point;   /**< [mm] where an edge of one meets the other */
} wcut_crossing;

/**
 * Pairs of triangles that cross though they have no corner in common, by index or by place.
 *
 * @param[in]  mesh     its vertices finite
 * @param[in]  room     pairs that `crossing` holds, 0 or more
 * @param[out] crossing the first `room` pairs in rising order; may be NULL where room is 0
 * @param[out] count    of all pairs
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mesh_crossings(const wcut_mesh *mesh, int room, wcut_crossing *crossing, int *count);

/** What is wrong with a surface, and where. */
typedef struct wcut_surface_report {
    int closed_u, closed_v; /**< 1: the edges at both ends of that direction coincide */
    int poles;              /**< of its four edges, those shrunk to a point */
    int folds; /**< cells of its tessellation in which the normal turns by 60 degrees or more at once: folds,
                                  or creases of that angle */
    double fold_u, fold_v; /**< the first one */
    int crossings;         /**< pairs of triangles of its tessellation that cross */
    double crossing_u[2];  /**< parameters of the first pair */
    double crossing_v[2];  /**< */
    double chord_error;    /**< [mm] of the tessellation that was inspected; finer faults are not found */
} wcut_surface_report;

/**
 * Search a surface's tessellation for folds and self-intersections, such as of a loft whose sections turn over or pass
 * one another.
 *
 * @param[in]  surface         a valid surface
 * @param[in]  chord_tolerance [mm] positive
 * @param[out] report          filled
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_CONVERGED, WCUT_DEGENERATE (no area), WCUT_NO_MEMORY, as
 *         wcut_surface_tessellate: nothing was written.
 */
WCUT_API wcut_status wcut_surface_inspect(const wcut_surface *surface, double chord_tolerance,
                                          wcut_surface_report *report);

#ifdef __cplusplus
}
#endif

#endif
