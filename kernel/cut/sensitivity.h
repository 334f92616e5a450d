/* How the wire of every station changes with what moves its ends or changes its length: derivatives of a run by any
   number of unknowns, carried along with it. */
#ifndef WCUT_CUT_SENSITIVITY_H
#define WCUT_CUT_SENSITIVITY_H

#include "cut/run.h"

/* What the unknowns do to a setup's ends: what the run is differentiated by. */
typedef struct wcut_end_motion {
    int count;               /* unknowns */
    int stations;            /* of the setup */
    const wcut_vec3 *by_a;   /* count x stations [mm per unit]: d end_a */
    const wcut_vec3 *by_b;   /* count x stations */
    const double *by_length; /* count x stations [mm per unit] */
    int threads;
    double
        limit; /* [1] a step may make a derivative so much larger; where it would more, as where a wire comes to touch a
                     face, the wire is taken to be carried along with its ends. 0: no limit, the true derivative */
} wcut_end_motion;

/* The derivatives as far as the run has come. One unknown after the other: x + k * nodes is unknown k's. */
typedef struct wcut_sensitivity {
    wcut_end_motion motion;
    int nodes;
    wcut_vec3 *x;             /* count x nodes [mm per unit]: of the wire as it is */
    wcut_vec3 *end_a, *end_b; /* count: where its ends were led to */
    double *length;           /* count */
    double *log_rate;         /* count: of the step that led here */
    wcut_vec3 *was;           /* count x nodes: of where the nodes come from */
    double *column;           /* count x (4 nodes - 7): right-hand sides, then solutions */
    double *by_rate;          /* 4 nodes - 7 */
    wcut_vec3 *pattern;       /* count x nodes [N per unit]: of the load that shapes it where no foam does */
    wcut_vec3 *ends;          /* 2 stations: room */
    wcut_vec3 *by;            /* count x stations x nodes [mm per unit]: borrowed, what is stored */
    bool failed;              /* a matrix was singular: the derivatives from there on are not those of the run */
} wcut_sensitivity;

/* room for a setup's run; `by` and the arrays of `motion` are borrowed. False: no memory, nothing is kept. */
bool wcut_sensitivity_create(const wcut_setup *setup, const wcut_end_motion *motion, wcut_vec3 *by,
                             wcut_sensitivity *out);
void wcut_sensitivity_destroy(wcut_sensitivity *s);

/* station 0 of a run, before its first step */
void wcut_sensitivity_begin(wcut_cut *cut);

/* A loaded sub-step has been solved: cut->hanging_shape and cut->hanging_tension, the solver's last evaluation with its
   slopes; cut->next is still the wire before it. The derivative of an equation's solution (implicit function theorem):
   J dU = - dR, dR what the equations have by ends, length and the wire before. */
void wcut_sensitivity_step(wcut_cut *cut, const wcut_step *step, const wcut_target *target, wcut_condition condition);

/* keep the derivatives of the station that the run is at, in `by` */
void wcut_sensitivity_store(const wcut_sensitivity *s, int station);

/* the hanging shape under its pattern becomes the wire; what leans on a face is taken to lean there as it does */
void wcut_sensitivity_hang(wcut_cut *cut, const wcut_target *target, const wcut_vec3 *load);

/* Run a setup to its end, or as far as it goes, and differentiate it. `by`: unknowns x stations x nodes [mm per unit],
   those of stations that were not reached are left. Status and history as of wcut_setup_run, without its further tries of
   first contact; WCUT_SINGULAR: the run has no derivative somewhere. */
wcut_status wcut_setup_differentiate(const wcut_setup *setup, const wcut_end_motion *motion, wcut_vec3 *by,
                                     wcut_history **history, wcut_error *error);

#endif
