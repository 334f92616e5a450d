/* wirecut/curvature.h - a surface's normal, and how strongly it bends. */
#ifndef WCUT_CURVATURE_H
#define WCUT_CURVATURE_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A surface at a point, to second order. Curvatures are positive where it bends towards its normal. */
typedef struct wcut_tangent_frame {
    wcut_vec3 point;  /**< [mm] */
    wcut_vec3 normal; /**< [1] unit, along S_u x S_v */
    double gauss;     /**< [1/mm^2] K, the product of the principal curvatures */
    double mean;      /**< [1/mm] H, half their sum */
    double larger;    /**< [1/mm] the principal curvature of the larger size */
    double smaller;   /**< [1/mm] the other one */
    wcut_vec3 along;  /**< [1] unit tangent along which it bends by `larger`; along S_u where both are the same */
    wcut_vec3 across; /**< [1] normal x along */
} wcut_tangent_frame;

/**
 * The unit normal S_u x S_v / |S_u x S_v|.
 *
 * @param[in]  surface a valid surface
 * @param[in]  u, v    parameters; outside the domain they are clamped to it
 * @param[out] normal  [1]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (S_u and S_v span no plane: a pole, an edge shrunk to a point):
 *         nothing was written.
 */
WCUT_API wcut_status wcut_surface_normal(const wcut_surface *surface, double u, double v, wcut_vec3 *normal);

/**
 * Normal, principal, Gaussian and mean curvature with the principal directions (do Carmo 1976, 3.2).
 *
 * @param[in]  surface a valid surface
 * @param[in]  u, v    parameters; outside the domain they are clamped to it
 * @param[out] frame   as its fields say
 * @return as wcut_surface_normal.
 */
WCUT_API wcut_status wcut_surface_frame(const wcut_surface *surface, double u, double v, wcut_tangent_frame *frame);

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
