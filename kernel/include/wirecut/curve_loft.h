/* wirecut/curve_loft.h - a surface through curves of different degrees and knots. */
#ifndef WCUT_CURVE_LOFT_H
#define WCUT_CURVE_LOFT_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What a loft through curves did with them. */
typedef struct wcut_curve_loft_report {
    int used;             /**< sections that the surface passes through */
    int dropped;          /**< sections closer than `merge` to the one before */
    int nodes;            /**< points of equal arc length that each was taken at: control points along u */
    double section_error; /**< [mm] measured: largest distance between a curve and the surface's section at it */
    int closed;           /**< sections that end where they begin */
    int turned;           /**< sections that would be nearer to the one before if they ran backwards: a twist */
    int first_turned;     /**< the first of them, -1: none */
} wcut_curve_loft_report;

/**
 * Bicubic surface through curves of any degrees, knots and weights: each is taken at the same number of points of equal
 * arc length, doubled until the cubics through them miss no curve by more than a tolerance; then as wcut_surface_loft.
 * u is the share of the arc length. A curve without length makes an edge that is a point.
 *
 * @param[in]  count     curves, at least 2
 * @param[in]  curve     count valid curves, in order
 * @param[in]  merge     [mm] as in wcut_surface_loft
 * @param[in]  tolerance [mm] positive
 * @param[out] surface   the caller's, to wcut_surface_destroy
 * @param[out] parameter count, may be NULL: v of each section, for dropped ones that of the section kept before
 * @param[out] report    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (fewer than two distinct sections, lengths that overflow),
 *         WCUT_NOT_CONVERGED (4097 points of a curve do not suffice: a kink, or far too fine a tolerance),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_loft_curves(int count, const wcut_curve *const *curve, double merge, double tolerance,
                                              wcut_surface **surface, double *parameter,
                                              wcut_curve_loft_report *report);

#ifdef __cplusplus
}
#endif

#endif
