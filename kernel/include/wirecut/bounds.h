/* wirecut/bounds.h - the box about a curve or a surface, and how far they keep from a block. */
#ifndef WCUT_BOUNDS_H
#define WCUT_BOUNDS_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A box with its sides along the axes. */
typedef struct wcut_box {
    wcut_vec3 low, high; /**< [mm] low <= high */
} wcut_box;

/**
 * A box that holds a curve and is nowhere wider by more than a tolerance: hulls of control points, halved until tight.
 *
 * @param[in]  curve     a valid curve
 * @param[in]  tolerance [mm] positive
 * @param[out] box       each side beyond the curve by at most tolerance, or 1e-12 of its coordinates where that is more
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_curve_bounds(const wcut_curve *curve, double tolerance, wcut_box *box);

/**
 * A box that holds a surface; as wcut_curve_bounds.
 *
 * @return As wcut_curve_bounds.
 */
WCUT_API wcut_status wcut_surface_bounds(const wcut_surface *surface, double tolerance, wcut_box *box);

/**
 * How near a curve comes to a block at any parameter: no point of the curve is nearer than `distance`.
 *
 * @param[in]  curve     a valid curve
 * @param[in]  block     filled; low <= high, finite
 * @param[in]  tolerance [mm] positive: how much less than the true one the distance may be, or 1e-12 of the
 *                       coordinates where that is more
 * @param[out] distance  [mm] 0 where the curve touches or enters the block
 * @param[out] u         a parameter at which it is at most distance + tolerance; may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_curve_clearance(const wcut_curve *curve, const wcut_box *block, double tolerance,
                                          double *distance, double *u);

/** Where a path comes nearest to a block. */
typedef struct wcut_path_near {
    double distance; /**< [mm] 0 where it touches or enters the block */
    double station;  /**< real-valued, 0 .. count - 1 */
    wcut_vec3 place; /**< [mm] on the path */
} wcut_path_near;

/**
 * How near a mount comes to a block along the whole curve through its stations, between them too: the cubic of
 * wcut_curve_interpolate, dwells left out, measured as by wcut_curve_clearance.
 *
 * @param[in]  count     stations, at least 1
 * @param[in]  mount     count [mm], finite
 * @param[in]  block     filled; low <= high, finite
 * @param[in]  tolerance [mm] positive, as for wcut_curve_clearance
 * @param[out] near      the least distance, and where
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_path_clearance(int count, const wcut_vec3 *mount, const wcut_box *block, double tolerance,
                                         wcut_path_near *near);

#ifdef __cplusplus
}
#endif

#endif
