/* wirecut/curve_measure.h - a curve's frame, curvature, torsion and arc length. */
#ifndef WCUT_CURVE_MEASURE_H
#define WCUT_CURVE_MEASURE_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The Frenet frame of a curve at a point. */
typedef struct wcut_frame {
    wcut_vec3 point;    /**< [mm] */
    wcut_vec3 tangent;  /**< [1] unit */
    wcut_vec3 normal;   /**< [1] unit, towards the centre of curvature; zero where the curve is straight */
    wcut_vec3 binormal; /**< [1] unit, tangent x normal; zero where the curve is straight */
    double curvature;   /**< [1/mm] not negative */
    double torsion;     /**< [1/mm] positive where the curve leaves its plane along the binormal; 0 where straight */
} wcut_frame;

/**
 * The Frenet frame, curvature |C' x C''| / |C'|^3 and torsion (C' x C'') . C''' / |C' x C''|^2 (do Carmo 1976, 1.5).
 *
 * @param[in]  curve a valid curve
 * @param[in]  u     parameter; outside the domain it is clamped to it
 * @param[out] frame where |C' x C''| is below 1e-12 |C'| |C''| the curve counts as straight
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (C' is zero): nothing was written.
 */
WCUT_API wcut_status wcut_curve_frame(const wcut_curve *curve, double u, wcut_frame *frame);

/**
 * Arc length between two parameters, by Gauss's rule with halving until it is right to 1e-12 of the length.
 *
 * @param[in]  curve  a valid curve
 * @param[in]  from   parameter; outside the domain it is clamped to it
 * @param[in]  to     parameter; likewise, may be less than `from`
 * @param[out] length [mm] negative where `to` is less than `from`
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (the length overflows): nothing was written.
 */
WCUT_API wcut_status wcut_curve_length(const wcut_curve *curve, double from, double to, double *length);

/**
 * The parameter at an arc length from the curve's first point, by safeguarded Newton iteration.
 *
 * @param[in]  curve  a valid curve
 * @param[in]  length [mm] from 0 to the curve's own; beyond that the end is given
 * @param[out] u      parameter, its length right to 1e-11 of the curve's
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (the curve has no length, or one that overflows): nothing was
 * written.
 */
WCUT_API wcut_status wcut_curve_locate_length(const wcut_curve *curve, double length, double *u);

#ifdef __cplusplus
}
#endif

#endif
