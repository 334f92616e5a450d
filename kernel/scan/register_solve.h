/* Least squares for a rigid motion whose six degrees of freedom are free, locked or known beforehand. */
#ifndef WCUT_SCAN_REGISTER_SOLVE_H
#define WCUT_SCAN_REGISTER_SOLVE_H

#include <wirecut/registration.h>

#include "scan/register_motion.h"

/* sums over the residuals r that are used, each with a weight w; a row of the Jacobian is d r by a shift and by a turn
   about the moved pivot: (n, a x n) for the distance of a point with the arm a along n */
typedef struct wcut_register_sums {
    double h[WCUT_DOF_COUNT * WCUT_DOF_COUNT]; /* w J^T J, the upper triangle */
    double g[WCUT_DOF_COUNT];                  /* w J^T r */
    double square;                             /* w r^2 */
    double plain;                              /* r^2 */
    double weight;                             /* w */
    int used;                                  /* residuals */
    double overlap;                            /* [1] share of points over the surface */
} wcut_register_sums;

/* the residuals at a motion. WCUT_DEGENERATE: too few are left there; WCUT_NO_MEMORY */
typedef wcut_status (*wcut_register_model)(void *data, const wcut_motion *motion, wcut_register_sums *sums);

/* the cost at a trial motion with the points, feet and weights of the last call of the model: sum w r^2 */
typedef double (*wcut_register_cost)(const void *data, const wcut_motion *trial);

typedef struct wcut_register_problem {
    wcut_register_model model;
    wcut_register_cost held; /* NULL: the model chooses the same residuals at every motion and is its own cost */
    void *data;
    const wcut_registration_options *options;
    double length;      /* [mm] RMS distance of the points from the pivot: what a turn moves them by */
    double noise;       /* of a residual of weight 1; 0: estimated */
    double consistency; /* [1] variance of a normal deviate among those kept; 1 where all are */
    int max_iterations;
} wcut_register_problem;

/* add one residual: weight, row of the Jacobian by shift and turn, value */
static inline void register_add(wcut_register_sums *s, double weight, wcut_vec3 n, wcut_vec3 turn, double r) {
    const double row[WCUT_DOF_COUNT] = {n.x, n.y, n.z, turn.x, turn.y, turn.z};
    for (int i = 0; i < WCUT_DOF_COUNT; i++) {
        for (int j = i; j < WCUT_DOF_COUNT; j++) s->h[WCUT_DOF_COUNT * i + j] += weight * row[i] * row[j];
        s->g[i] += weight * row[i] * r;
    }
    s->square += weight * r * r;
    s->plain += r * r;
    s->weight += weight;
    s->used++;
}

/* From motion->x, where locked parameters already have their values, to the least of

       sum w r^2 / noise^2 + sum over priors (x_k - value_k)^2 / sigma_k^2

   by damped Gauss-Newton steps. Where the model chooses its residuals anew (closest points), a step lowers the cost of
   those chosen, and the choice follows: points that come and go do not stop it. It has converged where a step moves
   the points by less than the tolerance, or, with chosen residuals, by less than a hundredth of the motion's standard
   error. Directions that neither data nor priors determine are not moved along. registration:
   parameters, covariance, rank and what goes with them. WCUT_OK; WCUT_NOT_CONVERGED: both hold the last step;
   WCUT_DEGENERATE, WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_register_solve(const wcut_register_problem *problem, wcut_motion *motion,
                                wcut_registration *registration);

#endif
