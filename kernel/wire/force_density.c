/* The force density method (Schek 1974) on a chain of nodes. */
#include <wirecut/force_density.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

wcut_fdm_options wcut_fdm_options_default(void) { return (wcut_fdm_options){.tolerance = 1e-9, .max_rounds = 1000}; }

/* (7): D_u is tridiagonal and positive definite, so eliminate without pivoting. */
static void solve_positions(int n, const wcut_vec3 *force, const double *q, double *g, wcut_vec3 *x) {
    g[0] = 0;
    for (int i = 1; i < n - 1; i++) {
        double d = q[i - 1] * (1 - g[i - 1]) + q[i];
        g[i] = q[i] / d;
        x[i] = vec3_scale(1 / d, vec3_add_scaled(force[i], q[i - 1], x[i - 1]));
    }
    for (int i = n - 2; i > 0; i--) x[i] = vec3_add_scaled(x[i], g[i], x[i + 1]);
}

/* p/l of every edge; return max|p/l - 1|. */
static double measure_edges(int n, const wcut_vec3 *x, const double *length, double *ratio) {
    double strain = 0;
    for (int e = 0; e < n - 1; e++) {
        ratio[e] = vec3_distance(x[e], x[e + 1]) / length[e];
        strain = fmax(strain, fabs(ratio[e] - 1));
    }
    return strain;
}

wcut_status wcut_fdm_solve(int n, const wcut_vec3 *force, const double *length, const wcut_fdm_options *options,
                           double *q, wcut_vec3 *x, wcut_fdm_report *report) {
    /* check everything before the first allocation */
    const wcut_fdm_options o = options ? *options : wcut_fdm_options_default();
    if (n < 3 || !force || !length || !q || !x || o.max_rounds < 1 || !isfinite(o.tolerance) || o.tolerance < 0)
        return WCUT_BAD_ARGUMENT;
    if (!vec3_all_finite(n - 2, force + 1) || !vec3_all_finite(1, x) || !vec3_all_finite(1, x + n - 1) ||
        !all_positive(n - 1, length) || !all_positive(n - 1, q))
        return WCUT_BAD_ARGUMENT;

    double *work = wcut_alloc(2 * (size_t)n, sizeof *work);
    if (!work) return WCUT_NO_MEMORY;
    double *g = work, *ratio = work + n;

    /* stop before (8), so that the q returned is the one x is in equilibrium with */
    wcut_fdm_report r = {.rounds = 1};
    for (;; r.rounds++) {
        solve_positions(n, force, q, g, x);
        r.strain = measure_edges(n, x, length, ratio);
        if (r.strain <= o.tolerance || r.rounds >= o.max_rounds) break;
        for (int e = 0; e < n - 1; e++) q[e] *= ratio[e];
    }

    wcut_free(work);
    if (report) *report = r;

    return r.strain <= o.tolerance ? WCUT_OK : WCUT_NOT_CONVERGED;
}
