/* wirecut/projection.h - the closest point of a surface or a curve, certified to be the closest of all. */
#ifndef WCUT_PROJECTION_H
#define WCUT_PROJECTION_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The point of a surface that is closest to a query. */
typedef struct wcut_foot {
    double u, v;     /**< parameters */
    wcut_vec3 point; /**< [mm] S(u, v) */
    double distance; /**< [mm] from the query, not negative */
    double height;   /**< [mm] of the query over the tangent plane at the foot, positive on the side of S_u x S_v; its
                          size is the distance unless the query is beyond */
    double gap;      /**< [mm] no point of the surface is closer than distance - gap. 0 (to rounding, 1e-13 of the
                          surface's size) except where many points are equally near, as at the centre of a sphere */
    int beyond;      /**< 1: the foot is on the surface's border and the query beyond it, not above it; 0 otherwise */
} wcut_foot;

/** What queries of one surface share: a tree of its pieces. Const once made, for any number of threads. */
typedef struct wcut_projection wcut_projection;

/**
 * Prepare a surface for projection: a tree of pieces, each with its Taylor model and bounds on its second derivatives.
 *
 * @param[in]  surface    a valid surface; borrowed, must outlive the projection and not change
 * @param[out] projection the caller's, to wcut_projection_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (lengths beyond 1e100 mm), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_projection_create(const wcut_surface *surface, wcut_projection **projection);

/** Free a projection; NULL is allowed. */
WCUT_API void wcut_projection_destroy(wcut_projection *projection);

/**
 * Prepare once more, for a hundred thousand queries or more near a smooth bicubic surface: for each of its spans a
 * radius is found within which a stationary foot is proven to be the closest of all, so that most queries take a few
 * Newton steps. The feet are as exact and as certain as without; where this is not possible, the search is as before.
 *
 * @param[in,out] projection not in use by another thread
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: the projection is as it was.
 */
WCUT_API wcut_status wcut_projection_prepare_many(wcut_projection *projection);

/**
 * The closest point of the surface for each query: Newton's method in pieces where the squared distance is provably
 * convex, every other piece excluded by its bound. Queries are taken in an order that keeps neighbours together; feet
 * come back in the order given, the same bytes for every number of threads.
 *
 * @param[in]  projection of a surface that has not changed since
 * @param[in]  count      queries, 0 or more
 * @param[in]  query      count [mm], finite, nearer than 1e100
 * @param[in]  threads    1 or more
 * @param[out] foot       count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_projection_locate(const wcut_projection *projection, int count, const wcut_vec3 *query,
                                            int threads, wcut_foot *foot);

/** The point of a curve that is closest to a query. */
typedef struct wcut_curve_foot {
    double u;        /**< parameter */
    wcut_vec3 point; /**< [mm] C(u) */
    double distance; /**< [mm] from the query */
    double gap;      /**< [mm] no point of the curve is closer than distance - gap; 0 (to rounding, 1e-12 of the curve's
                          size) except where a whole arc is equally near, as at the centre of a circle */
    int beyond;      /**< 1: the foot is an end of the curve and the query beyond it; 0 otherwise */
} wcut_curve_foot;

/**
 * The closest point of a curve for each query: pieces bounded by the hulls of their control points, halved where they
 * may hold a closer one; Newton's method inside them. The same bytes for every number of threads.
 *
 * @param[in]  curve   a valid curve
 * @param[in]  count   queries, 0 or more
 * @param[in]  query   count [mm], finite, nearer than 1e100
 * @param[in]  threads 1 or more
 * @param[out] foot    count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (lengths beyond 1e100 mm), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_locate(const wcut_curve *curve, int count, const wcut_vec3 *query, int threads,
                                       wcut_curve_foot *foot);

#ifdef __cplusplus
}
#endif

#endif
