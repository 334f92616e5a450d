/* wirecut/curve.h - rational B-spline curves. */
#ifndef WCUT_CURVE_H
#define WCUT_CURVE_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_DEGREE_MAX = 7 };

/** A clamped or unclamped B-spline curve, rational where it has weights. */
typedef struct wcut_curve {
    int degree;         /**< 1 .. WCUT_DEGREE_MAX */
    int control_count;  /**< at least degree + 1 */
    double *knots;      /**< control_count + degree + 1, not decreasing */
    wcut_vec3 *control; /**< control_count [mm] */
    double *weights;    /**< control_count, positive; NULL for a polynomial curve */
} wcut_curve;

/**
 * Copy knots, control points and weights into a new curve, checked.
 *
 * @param[in]  degree        1 .. WCUT_DEGREE_MAX
 * @param[in]  control_count at least degree + 1
 * @param[in]  knots         control_count + degree + 1, finite, not decreasing, no interior knot more than
 *                           degree times, a domain of positive length
 * @param[in]  control       control_count [mm], finite
 * @param[in]  weights       control_count, positive; NULL for a polynomial curve
 * @param[out] curve         the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_create(int degree, int control_count, const double *knots, const wcut_vec3 *control,
                                       const double *weights, wcut_curve **curve);

/** Free a curve; NULL is allowed. */
WCUT_API void wcut_curve_destroy(wcut_curve *curve);

/**
 * Cubic curve through points at chord-length parameters over [0, 1]
 * (degree 1 through two points, 2 through three).
 *
 * @param[in]  count  points, at least 2
 * @param[in]  point  count [mm], finite, neighbours apart
 * @param[out] curve  the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (neighbours coincide), WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_curve_interpolate(int count, const wcut_vec3 *point, wcut_curve **curve);

/**
 * Cubic curve through points at given parameters, with given derivatives at its ends (less than cubic where points and
 * derivatives are fewer than four together).
 *
 * @param[in]  count     points, at least 2
 * @param[in]  point     count [mm], finite
 * @param[in]  parameter count, finite, rising; NULL: chord lengths over [0, 1], neighbours apart
 * @param[in]  first     dC/du [mm] at the first point, finite; NULL: left free
 * @param[in]  last      dC/du [mm] at the last point, finite; NULL: left free
 * @param[out] curve     the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (neighbours coincide, or all but), WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_curve_interpolate_at(int count, const wcut_vec3 *point, const double *parameter,
                                               const wcut_vec3 *first, const wcut_vec3 *last, wcut_curve **curve);

/**
 * A point of the curve and its derivatives.
 *
 * @param[in]  curve a valid curve
 * @param[in]  u     parameter; outside the domain it is clamped to it
 * @param[in]  order highest derivative, 0 .. 3
 * @param[out] ders  order + 1: the point [mm] and d^k/du^k
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_curve_eval(const wcut_curve *curve, double u, int order, wcut_vec3 *ders);

/** The parameter range [first, last] of a valid curve. */
WCUT_API void wcut_curve_domain(const wcut_curve *curve, double *first, double *last);

#ifdef __cplusplus
}
#endif

#endif
