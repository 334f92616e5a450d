/* wirecut/curvature.h - how strongly a surface bends. */
#ifndef WCUT_CURVATURE_H
#define WCUT_CURVATURE_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The principal curvatures at a point, from the two fundamental forms (do Carmo 1976, 3.3):
 *
 *     k = H +- sqrt(H^2 - K),   H = (E N - 2 F M + G L) / (2 (E G - F^2)),   K = (L N - M^2) / (E G - F^2)
 *
 * Positive where the surface bends towards its normal S_u x S_v.
 *
 * @param[in]  surface a valid surface
 * @param[in]  u, v    parameters; outside the domain they are clamped to it
 * @param[out] larger  [1/mm] the curvature of the larger size
 * @param[out] smaller [1/mm] the other one; may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (S_u and S_v span no plane: a pole, an edge shrunk to a point):
 *         nothing was written.
 */
WCUT_API wcut_status wcut_surface_curvature(const wcut_surface *surface, double u, double v, double *larger,
                                            double *smaller);

#ifdef __cplusplus
}
#endif

#endif
