/* wirecut/intersect.h - where a surface meets a plane or the faces of a block. */
#ifndef WCUT_INTERSECT_H
#define WCUT_INTERSECT_H

#include <wirecut/bounds.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A curve on a surface as a polyline, within the tolerance of the call. */
typedef struct wcut_trace {
    int count;        /**< points, at least 2 */
    int closed;       /**< 1: the last point is joined to the first, which is not repeated */
    int face;         /**< of the block: 0 x low, 1 x high, 2 y low, 3 y high, 4 z low, 5 z high; 0 for a plane; -1: it
                           passes over several (wcut_traces_join) */
    wcut_vec3 *point; /**< count [mm], on the surface, off the plane by rounding */
    double *uv;       /**< count x 2, their parameters; a curve over the seam of a closed surface jumps there */
} wcut_trace;

/** All curves in which two shapes meet. */
typedef struct wcut_traces {
    int count;
    wcut_trace *trace; /**< count */
    int touching;      /**< places smaller than the tolerance where the plane touches the surface, or curves cross */
    double touch_u;    /**< the first of them */
    double touch_v;    /**< */
    int loose;         /**< ends of curves that are neither on the surface's border nor on the face's: 0, but beside
                                touching places */
} wcut_traces;

/**
 * The curves in which a surface meets a plane: the height over the plane is a B-spline, whose cells are halved until a
 * cell has no change of sign, or holds a curve that is a graph over one parameter (after Snyder 1992). No loop is
 * missed, however small. A plane that coincides with the surface over an area gives no curve there; one that touches
 * it may give one or not.
 *
 * @param[in]  surface   a valid surface
 * @param[in]  point     [mm] of the plane, finite
 * @param[in]  normal    finite, not zero, any length
 * @param[in]  tolerance [mm] positive
 * @param[out] traces    the caller's, to wcut_traces_destroy; may hold none
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_CONVERGED (more than 2^22 cells: a plane that touches along curves, and
 *         a tolerance far too fine), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_intersect_plane(const wcut_surface *surface, wcut_vec3 point, wcut_vec3 normal,
                                                  double tolerance, wcut_traces **traces);

/**
 * The curves in which a surface meets the faces of a block, each on one face and ending at its edges, exactly where the
 * surface meets these, or at the surface's border.
 *
 * @param[in]  surface   a valid surface
 * @param[in]  block     finite, low < high
 * @param[in]  tolerance [mm] positive; a curve that leaves its face by less than this need not be divided there
 * @param[out] traces    as above
 * @return as wcut_surface_intersect_plane.
 */
WCUT_API wcut_status wcut_surface_intersect_box(const wcut_surface *surface, const wcut_box *block, double tolerance,
                                                wcut_traces **traces);

/**
 * Join curves end to end: of those on a block's faces, over its edges, the outline of the cut. A cut whose border is
 * outside the block gives closed lines only.
 *
 * @param[in]  traces    from wcut_surface_intersect_box or wcut_surface_intersect_plane
 * @param[in]  tolerance [mm] positive; ends nearer than this are one place, the nearest first
 * @param[out] outline   the caller's, to wcut_traces_destroy; `loose` counts the ends that stay free
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_traces_join(const wcut_traces *traces, double tolerance, wcut_traces **outline);

/** Free traces; NULL is allowed. */
WCUT_API void wcut_traces_destroy(wcut_traces *traces);

#ifdef __cplusplus
}
#endif

#endif
