/* Levenberg-Marquardt (Marquardt 1963) on the curves of a trial: from curves to better ones, round by round. */
#ifndef WCUT_INVERSE_DESCENT_H
#define WCUT_INVERSE_DESCENT_H

#include "inverse/trial.h"

enum { WCUT_ROUNDS_MAX = 64 };

/* Room for the equations, and what was noted so far. */
typedef struct wcut_descent {
    wcut_design_progress progress;
    void *context;
    wcut_design_round round[WCUT_ROUNDS_MAX];
    int rounds, runs;
    bool stopped;
    double *normal, *trial_normal, *matrix; /* unknowns squared */
    double *gradient, *trial_gradient, *step;
    bool active[WCUT_BOUNDS_MAX];
    unsigned char *strays; /* points: of the last level */
} wcut_descent;

/* room for a target of so many points; false: no memory, to be destroyed all the same */
bool wcut_descent_create(int points, wcut_design_progress progress, void *context, wcut_descent *s);
void wcut_descent_destroy(wcut_descent *s);

/* From curves to better ones, in so many steps at most, until the rms is at the goal. A run that fails is a step that is
   not taken. WCUT_OK: reached is theirs; WCUT_NOT_CONVERGED: the first run fails already; WCUT_NO_MEMORY. */
wcut_status wcut_descent_improve(wcut_descent *s, wcut_trial *search, wcut_design_curves *c, int steps, double goal,
                                 wcut_reached *reached);

/* note a round and tell it; whoever hears of it may stop the descent */
void wcut_descent_note(wcut_descent *s, const wcut_trial *search, const wcut_design_curves *c,
                       const wcut_reached *reached);

#endif
