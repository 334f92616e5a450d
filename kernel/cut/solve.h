/* Newton on shape, edge tensions and rate together. */
#ifndef WCUT_CUT_SOLVE_H
#define WCUT_CUT_SOLVE_H

#include "cut/system.h"

typedef struct wcut_solver {
    wcut_system system;
    double *step_by_residual; /* size: Newton step of the unknowns at fixed rate */
    double *step_by_rate;     /* size: change of the unknowns for a unit change of ln r */
    wcut_vec3 *trial_x;       /* n */
    double *trial_s;          /* n-1 */
} wcut_solver;

typedef struct wcut_solution {
    bool converged;
    int iterations;
    double residual; /* [1] the largest relative part */
    double log_rate; /* in: guess, or the given rate; out: the solution's */
    double pull;     /* [N] tension that the force asks for */
} wcut_solution;

bool wcut_solver_create(int n, wcut_solver *o);
void wcut_solver_destroy(wcut_solver *o);

/* Solve from the guess in x (n, ends fixed), s (n-1) and solution->log_rate; with `by_tension` the rate is an unknown
   and (4) an equation, without it the rate is given; on a bow's frame the ends of x are a guess too. x and s hold the
   last iterate in every case. */
void wcut_solver_run(wcut_solver *o, const wcut_step *step, bool by_tension, double tolerance, int max_iterations,
                     wcut_vec3 *x, double *s, wcut_solution *out);

#endif
