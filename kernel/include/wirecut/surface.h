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
 * Copy knots, control points and weights into a new surface, checked.
 *
 * @param[in]  degree_u, degree_v 1 .. WCUT_DEGREE_MAX
 * @param[in]  count_u, count_v   more than the degree; their product at most INT_MAX / 8
 * @param[in]  knots_u, knots_v   count + degree + 1, as in wcut_curve_create
 * @param[in]  control            count_v x count_u [mm], finite
 * @param[in]  weights            count_v x count_u, positive; NULL for a polynomial surface
 * @param[out] surface            the caller's, to wcut_surface_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_create(int degree_u, int degree_v, int count_u, int count_v, const double *knots_u,
                                         const double *knots_v, const wcut_vec3 *control, const double *weights,
                                         wcut_surface **surface);

/**
 * Bicubic surface through the wire of every station: u along the wire from mount A to B at equal steps (equal arc
 * length, one knot vector for all sections), v over the stations at averaged chord length, both over [0, 1]: a step of
 * v is the mean distance of its two sections. Degree 3, less where there are fewer than four nodes or sections.
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

/**
 * Points on the grid of given parameters, the basis functions of each computed once.
 *
 * @param[in]  surface  a valid surface
 * @param[in]  count_u  columns, at least 1
 * @param[in]  u        count_u, finite; outside the domain clamped to it
 * @param[in]  count_v  rows, at least 1
 * @param[in]  v        count_v, finite; outside the domain clamped to it
 * @param[out] point    count_v x count_u [mm]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_eval_grid(const wcut_surface *surface, int count_u, const double *u, int count_v,
                                            const double *v, wcut_vec3 *point);

/** The parameter range of a valid surface: u in [first[0], last[0]], v in [first[1], last[1]]. */
WCUT_API void wcut_surface_domain(const wcut_surface *surface, double first[2], double last[2]);

#ifdef __cplusplus
}
#endif

#endif
