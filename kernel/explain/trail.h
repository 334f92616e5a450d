/* A trail: where the mounts of a cut were when, and under which heat; and the wire driven along it. */
#ifndef WCUT_EXPLAIN_TRAIL_H
#define WCUT_EXPLAIN_TRAIL_H

#include <wirecut/job.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#include "explain/stop.h"

/* tension_a, tension_b [N], alpha_a, beta_a, alpha_b, beta_b [rad]: the channels of a recording from TENSION_A on */
enum { WCUT_TRAIL_SIGNALS = 6 };

typedef struct wcut_trail {
    int count;       /* at least 2 */
    double *time;    /* count [s] increasing */
    double *station; /* count, not decreasing */
    double *heat;    /* count [W/m] over the step that ends here */
    int *sample;     /* count: which of the recording; NULL of a trail between its samples */
} wcut_trail;

typedef struct wcut_driven {
    int count, nodes;
    double *signal[WCUT_TRAIL_SIGNALS]; /* count each; 0 where absent */
    double *engaged;                    /* count [mm] of wire in the foam */
    unsigned char *present;             /* count: 0 where the solver failed */
    wcut_vec3 *position;                /* count x nodes [mm]; NULL where not asked for */
    double *speed;                      /* count x nodes [mm/s] of the nodes; NULL where not asked for */
} wcut_driven;

/*
 * The motion as it was recorded, smoothed over `window` [s] against the encoder's noise (wcut_track_create).
 * WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_trail_recorded(const wcut_job *job, const wcut_recording *recording, double window, wcut_trail *out,
                                wcut_error *error);

/*
 * The motion freed of what a tension loop feeds back: progress as a smooth function of the programmed progress, which
 * is time with the job's own dither in it, every `step` [s]. Noise of the tension does not reach it but through `width`
 * [s] of smoothing; the programme does in full. Instruments are computed along it (DIAGNOSIS: exogenous trajectory).
 */
wcut_status wcut_trail_exogenous(const wcut_job *job, const wcut_trail *recorded, double width, double step,
                                 wcut_trail *out);

/* The recorded motion as it is, every `step` [s]: what plain least squares takes its columns along. */
wcut_status wcut_trail_thin(const wcut_trail *recorded, double step, wcut_trail *out);

void wcut_trail_destroy(wcut_trail *trail);

/*
 * Drive a wire of so many nodes along a trail, time-driven. Where the solver fails the sample is absent and the next
 * step begins at the last place reached. stop: NULL, or asked at every sample. WCUT_OK; WCUT_INTERRUPTED; as
 * wcut_setup_create, wcut_cut_create: nothing was written.
 */
wcut_status wcut_trail_drive(const wcut_job *job, int nodes, const wcut_trail *trail, bool positions, wcut_stop *stop,
                             wcut_driven *out, wcut_error *error);
void wcut_driven_destroy(wcut_driven *driven);

/* y at x between given points, held beyond them; x: n, not decreasing, n >= 1 */
double wcut_between(int n, const double *x, const double *y, double at);

#endif
