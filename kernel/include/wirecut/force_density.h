/* wirecut/force_density.h - equilibrium of a chain whose edge lengths are given. */
#ifndef WCUT_FORCE_DENSITY_H
#define WCUT_FORCE_DENSITY_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** When to stop. */
typedef struct wcut_fdm_options {
    double tolerance; /**< [1] strain to accept; default 1e-9 */
    int max_rounds;   /**< rounds before giving up; default 1000 */
} wcut_fdm_options;

/** Where it stopped. */
typedef struct wcut_fdm_report {
    double strain; /**< [1] max|p/l - 1| over the edges of x */
    int rounds;    /**< rounds taken */
} wcut_fdm_report;

/** The defaults stated at the fields. */
WCUT_API wcut_fdm_options wcut_fdm_options_default(void);

/**
 * Shape a chain into equilibrium under nodal forces, every edge at its length.
 *
 *     D_u X_u = F_u - D_f X_f,   q <- Q L^-1 p          (Rust et al. 2016, 5-8)
 *
 * @param[in]     n       nodes, at least 3; the first and the last are fixed
 * @param[in]     force   n [N]; the first and the last are not read
 * @param[in]     length  n-1 [mm], positive
 * @param[in]     options NULL for the defaults
 * @param[in,out] q       n-1 [N/mm], positive; a first guess in, force densities out
 * @param[in,out] x       n [mm]; the two ends in, every node out
 * @param[out]    report  may be NULL
 * @return WCUT_OK; WCUT_NOT_CONVERGED: q, x and report hold the last round;
 *         WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_fdm_solve(int n, const wcut_vec3 *force, const double *length,
                                    const wcut_fdm_options *options, double *q, wcut_vec3 *x, wcut_fdm_report *report);

#ifdef __cplusplus
}
#endif

#endif
