/* A cut predicted before it is made: the mounts moved over time as the plan and its programme have it, and what would be measured. */
#ifndef WCUT_EXPLAIN_PREDICTED_CUT_H
#define WCUT_EXPLAIN_PREDICTED_CUT_H

#include <wirecut/history.h>
#include <wirecut/job.h>

#include "explain/stop.h"

/* nodes of a predicted cut: what two models differ by is the same with more */
enum { WCUT_PREDICTED_CUT_NODES = 25 };

/* [s] of a step: a fifth of the shortest lag that a recording at 20 Hz can show */
#define WCUT_PREDICTED_CUT_STEP 0.2

/* [1] of the plan's longest engagement: beyond it most of the wire is in the foam, and the excitation runs */
#define WCUT_MOST_OF_WIRE 0.5

/* where the mounts are when, under what power */
typedef struct wcut_schedule {
    int count;       /* steps of WCUT_PREDICTED_CUT_STEP, at least 1 */
    double *station; /* count: at the end of each step, real-valued, increasing, the last is the path's end */
    double *heat;    /* count [W/m] over the step */
    double *engaged; /* count [1] of the plan's longest engagement, at the end of the step */
    double *speed;   /* count [mm/s] of the plan's faster mount at the station, without the excitation */
    bool *held;      /* count: the plan's speed there is set by the tension, not by a limit */
} wcut_schedule;

/* The plan of a job without its effects, turned into a schedule with its excitation.
   WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (as wcut_setup_create; the plan never touches the block),
   WCUT_NOT_CONVERGED (the plan does not reach the path's end), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_schedule_create(const wcut_job *job, wcut_schedule *schedule, wcut_error *error);
void wcut_schedule_destroy(wcut_schedule *schedule);

/* what would be measured along a schedule, instruments included */
typedef struct wcut_predicted_cut {
    int count, nodes;
    unsigned char *present;           /* count: 1 where the step was solved */
    double *value[WCUT_SENSED_COUNT]; /* count each [mm/s, N, rad] */
    wcut_vec3 *position;              /* count x nodes [mm] of the wire */
    double *speed, *inside;           /* count x nodes [mm/s], [1] share in the foam */
} wcut_predicted_cut;

/* Drive a job, its effects included, along a schedule of that job or of one that differs in effects, law or length.
   stop: NULL, or asked at every step. WCUT_OK, also where steps failed; WCUT_INTERRUPTED, WCUT_BAD_ARGUMENT,
   WCUT_DEGENERATE, WCUT_NOT_CONVERGED (no equilibrium at station 0), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_predicted_cut_run(const wcut_job *job, const wcut_schedule *schedule, wcut_stop *stop,
                                   wcut_predicted_cut *predicted, wcut_error *error);
void wcut_predicted_cut_destroy(wcut_predicted_cut *predicted);

#endif
