/* A trajectory: where the mounts of a cut were when, and under which heat; and the wire driven along it. */
#ifndef WCUT_EXPLAIN_TRAJECTORY_H
#define WCUT_EXPLAIN_TRAJECTORY_H

#include <wirecut/job.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#include "explain/stop.h"

/* tension_a, tension_b [N], alpha_a, beta_a, alpha_b, beta_b [rad]: the channels of a recording from TENSION_A on */
enum { WCUT_SIGNALS = 6 };

typedef struct wcut_trajectory {
    int count;       /* at least 2 */
    double *time;    /* count [s] increasing */
    double *station; /* count, not decreasing */
    double *heat;    /* count [W/m] over the step that ends here */
    int *sample;     /* count: which of the recording; NULL of a trajectory between its samples */
} wcut_trajectory;

typedef struct wcut_response {
    int count, nodes;
    double *signal[WCUT_SIGNALS]; /* count each; 0 where absent */
    double *engaged;              /* count [mm] of wire in the foam */
    unsigned char *present;       /* count: 0 where the solver failed */
    wcut_vec3 *position;          /* count x nodes [mm]; NULL where not asked for */
    double *speed;                /* count x nodes [mm/s] of the nodes; NULL where not asked for */
} wcut_response;

/*
 * The motion as it was recorded, smoothed over `window` [s] against the encoder's noise (wcut_track_create).
 * WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_trajectory_recorded(const wcut_job *job, const wcut_recording *recording, double window,
                                     wcut_trajectory *out, wcut_error *error);

/*
 * The motion freed of what a tension loop feeds back: progress as a smooth function of the programmed progress, which
 * is time with the job's own dither in it, every `step` [s]. Noise of the tension does not reach it but through `width`
 * [s] of smoothing; the programme does in full. Columns of a fit are computed along it (NOTATION.md, Exogenous trajectory).
 */
wcut_status wcut_trajectory_exogenous(const wcut_job *job, const wcut_trajectory *recorded, double width, double step,
                                      wcut_trajectory *out);

/* The recorded motion as it is, every `step` [s]: what plain least squares takes its columns along. */
wcut_status wcut_trajectory_thin(const wcut_trajectory *recorded, double step, wcut_trajectory *out);

void wcut_trajectory_destroy(wcut_trajectory *trajectory);

/*
 * Drive a wire of so many nodes along a trajectory, time-driven. Where the solver fails the sample is absent and the next
 * step begins at the last place reached. stop: NULL, or asked at every sample. WCUT_OK; WCUT_INTERRUPTED; as
 * wcut_setup_create, wcut_cut_create: nothing was written.
 */
wcut_status wcut_response_run(const wcut_job *job, int nodes, const wcut_trajectory *trajectory, bool positions,
                              wcut_stop *stop, wcut_response *out, wcut_error *error);
void wcut_response_destroy(wcut_response *driven);

/* y at x between given points, held beyond them; x: n, not decreasing, n >= 1 */
double wcut_between(int n, const double *x, const double *y, double at);

#endif
