/* wirecut/equilibrium.h - the same equilibrium as force_density.h by Newton's method, for straight wires too. */
#ifndef WCUT_EQUILIBRIUM_H
#define WCUT_EQUILIBRIUM_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** When to stop. */
typedef struct wcut_equilibrium_options {
    double tolerance;   /**< [1] strain, and unbalance over the largest force, to accept; default 1e-12 */
    int max_iterations; /**< Newton steps before giving up; default 100 */
} wcut_equilibrium_options;

/** Where it stopped. */
typedef struct wcut_equilibrium_report {
    double strain;    /**< [1] max|p/l - 1| */
    double unbalance; /**< [1] largest nodal force left, over the largest of load and tension */
    int iterations;   /**< Newton steps taken */
} wcut_equilibrium_report;

/** The defaults stated at the fields. */
WCUT_API wcut_equilibrium_options wcut_equilibrium_options_default(void);

/**
 * Shape an inextensible chain into equilibrium under given nodal forces, hanging in tension.
 *
 *     q_e (X_{e+1} - X_e) - q_{e-1} (X_e - X_{e-1}) + F_e = 0,   |X_{e+1} - X_e| = l_e     (Schek 1974; Newton)
 *
 * No first guess is needed: it starts from the shape of a taut wire under the same load.
 *
 * @param[in]     n       nodes, at least 3; the first and the last are fixed
 * @param[in]     force   n [N], not all zero; the first and the last are not read
 * @param[in]     length  n-1 [mm], positive, their sum greater than the ends' distance
 * @param[in]     options NULL for the defaults
 * @param[in,out] x       n [mm]; the two ends in, every node out
 * @param[out]    q       n-1 [N/mm] force densities
 * @param[out]    report  may be NULL
 * @return WCUT_OK; WCUT_NOT_CONVERGED: x, q and report hold the last iterate (a chain with so much slack that an
 *         unloaded part of it goes without tension has no unique shape and ends here);
 *         WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (wire not longer than the chord, no load): nothing was written.
 */
WCUT_API wcut_status wcut_equilibrium_solve(int n, const wcut_vec3 *force, const double *length,
                                            const wcut_equilibrium_options *options, wcut_vec3 *x, double *q,
                                            wcut_equilibrium_report *report);

#ifdef __cplusplus
}
#endif

#endif
