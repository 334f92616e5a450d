/* wirecut/replay.h - a recording predicted sample by sample: from the job alone, and from its recorded motion. */
#ifndef WCUT_REPLAY_H
#define WCUT_REPLAY_H

#include <wirecut/cut.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Measured and predicted alike: signal k is the channel WCUT_CHANNEL_SPEED_A + k, up to WCUT_CHANNEL_BETA_B. */
enum { WCUT_SIGNAL_COUNT = 8 };

/** Where the mounts' motion is taken from. */
typedef enum wcut_motion {
    WCUT_MOTION_STATION, /**< the path of the job at the recorded station */
    WCUT_MOTION_POSITION /**< the measured positions a_x .. b_z */
} wcut_motion;

/** How a recording is replayed. */
typedef struct wcut_replay_options {
    wcut_motion motion; /**< default WCUT_MOTION_STATION */
    /** [s] Width of the window over which the motion is smoothed, not negative; 0: as recorded. An encoder's noise is
        a noise of the speed, and the foam's force follows the speed. Default 0.5. */
    double window;
} wcut_replay_options;

/** A prediction of a recording. */
typedef struct wcut_prediction {
    int samples;
    unsigned char *present;           /**< samples: 1 where there is a prediction */
    double *value[WCUT_SIGNAL_COUNT]; /**< samples each [mm/s, N, rad]; 0 where there is none */
    int without_motion;               /**< samples without a station (or position): no prediction */
    int standing;                     /**< samples at which the mounts had not moved: no step, no prediction */
    int failed;                       /**< samples that the solver, or the plan, did not reach */
    int first_failed;                 /**< the first of them; -1: none */
    wcut_error cause;                 /**< of the first of them; WCUT_OK: none */
    double scatter;                   /**< [1, or mm of measured positions] RMS of the motion taken for noise */
    int iterations;                   /**< Newton iterations in all; 0 of a plan */
} wcut_prediction;

/** The defaults stated at the fields. */
WCUT_API wcut_replay_options wcut_replay_options_default(void);

/**
 * The **planned** prediction: a tension-driven run, interpolated at the recording's stations. It knows the job alone;
 * a programmed excitation is not in it. Angles and tensions are linear between stations, speeds between the middles
 * of the steps that they are means of.
 *
 * @param[in]  plan       of the job, whole or as far as it went: samples beyond are `failed`
 * @param[in]  recording  of that job
 * @param[out] prediction the caller's, to wcut_prediction_destroy
 * @param[out] error      may be NULL; the recording's line
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (an argument missing, a plan without stations, a station outside the path by more
 *         than one, backwards by more than one, no station at all), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_prediction_plan(const wcut_history *plan, const wcut_recording *recording,
                                          wcut_prediction **prediction, wcut_error *error);

/**
 * The **replayed** prediction: the recorded motion drives the wire, tensions and angles are the answer
 * (wcut_cut_drive). The speed is an input here; its values are those of the motion that was driven.
 *
 * The motion is the local parabola of least squares over `window` around every sample (Savitzky, Golay 1964, here for
 * any sampling), then made non-decreasing, because the foam behind the wire is cut already. From station 0 to the
 * first sample the wire is led at the pace of the recording's first second. A gap is crossed in steps of one station
 * at most, at an even pace; a sample at which the solver fails is missing, and the next step begins at the last one
 * solved. Heat is the recording's, held over missing samples; without that column the job's, times its programmed
 * factor.
 *
 * @param[in]  setup      of the job, path mode and implicit
 * @param[in]  recording  of that job
 * @param[in]  options    NULL for the defaults
 * @param[out] prediction the caller's, to wcut_prediction_destroy
 * @param[out] error      may be NULL; the recording's line
 * @return WCUT_OK (however many samples failed); WCUT_BAD_ARGUMENT (as wcut_prediction_plan; no measured positions
 * where they are asked for, heat that is not positive, a design-mode job), WCUT_NOT_CONVERGED (no equilibrium at
 *         station 0), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_prediction_replay(const wcut_setup *setup, const wcut_recording *recording,
                                            const wcut_replay_options *options, wcut_prediction **prediction,
                                            wcut_error *error);

/** Free a prediction; NULL is allowed. */
WCUT_API void wcut_prediction_destroy(wcut_prediction *prediction);

#ifdef __cplusplus
}
#endif

#endif
