/* wirecut/surface.h - rational B-spline surfaces, the loft through a wire's stations. */
#ifndef WCUT_SURFACE_H
#define WCUT_SURFACE_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A tensor-product B-spline surface S(u, v), rational where it has weights. */
typedef struct wcut_surface {
    int degree_u, degree_v; /**< 1 .. WCUT_DEGREE_MAX */
    int count_u, count_v;   /**< control points in each direction */
    double *knots_u;        /**< count_u + degree_u + 1 */
    double *knots_v;        /**< count_v + degree_v + 1 */
    wcut_vec3 *control;     /**< count_v x count_u [mm]: row j runs along u at the j-th control point of v */
    double *weights;        /**< count_v x count_u, positive; NULL for a polynomial surface */
} wcut_surface;

/** What a loft did with its sections. */
typedef struct wcut_loft_report {
    int used;    /**< sections that the surface passes through */
    int dropped; /**< sections closer than `merge` to the one before */
} wcut_loft_report;

/**
 * Bicubic surface through the wire of every station: u along the wire from mount A to B at equal steps (equal arc
 * length, one knot vector for all sections), v over the stations at averaged chord length, both over [0, 1].
 * Degree 3, less where there are fewer than four nodes or sections.
 *
 * @param[in]  stations  at least 2
 * @param[in]  nodes     at least 2
 * @param[in]  position  stations x nodes [mm], finite
 * @param[in]  merge     [mm] a section whose nodes are all nearer than this to those of the section kept before it is
 *                       dropped; not negative
 * @param[out] surface   the caller's, to wcut_surface_destroy
 * @param[out] parameter stations, may be NULL: v of each section, for dropped ones that of the section kept before
 * @param[out] report    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (fewer than two distinct sections),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_loft(int stations, int nodes, const wcut_vec3 *position, double merge,
                                       wcut_surface **surface, double *parameter, wcut_loft_report *report);

/** Free a surface; NULL is allowed. */
WCUT_API void wcut_surface_destroy(wcut_surface *surface);

/**
 * A point of the surface and its partial derivatives.
 *
 * @param[in]  surface a valid surface
 * @param[in]  u, v    parameters; outside the domain they are clamped to it
 * @param[in]  order   highest derivative in each direction, 0 .. 3
 * @param[out] ders    (order + 1) x (order + 1): ders[k * (order + 1) + l] = d^(k+l) S / du^k dv^l, k + l <= order;
 *                     the rest 0
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_surface_eval(const wcut_surface *surface, double u, double v, int order, wcut_vec3 *ders);

#ifdef __cplusplus
}
#endif

#endif
