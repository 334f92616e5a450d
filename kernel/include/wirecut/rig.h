/* wirecut/rig.h - a controller in closed loop with the simulated wire: what a machine with this job would record. */
#ifndef WCUT_RIG_H
#define WCUT_RIG_H

#include <stdbool.h>
#include <stdint.h>
#include <wirecut/control.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How the rig differs from what the job says, and how it measures. With the defaults foam and job agree. */
typedef struct wcut_rig_options {
    double law_a, law_b;   /**< [1] the foam's force law over the job's; default 1 */
    double density;        /**< [1] further factor of `a` on the wire that is beyond density_from; default 1 */
    double density_from;   /**< [mm] y in the block; default half its length */
    double delay;          /**< [s] of the tension's readings, not negative, at most 10; default 0.05 */
    double lag;            /**< [s] first-order lag of the mounts' speed behind the command; default 0.05 */
    double noise_tension;  /**< [N] standard deviations, not negative: default 0.02 */
    double noise_angle;    /**< [rad] default 0.05 deg */
    double noise_speed;    /**< [mm/s] default 0.1 */
    double noise_position; /**< [mm] default 0.05 */
    uint64_t seed;         /**< of the noise; default 1 */
    double period;         /**< [s] of the loop, 1e-4 .. 1; default 0.025 */
    int decimation;        /**< loop steps a recorded sample; default 0: 20 Hz, or every step of a slower loop */
    bool excitation;       /**< run the job's dither and heat steps; default true */
} wcut_rig_options;

/** Tension over an interval: the wire's own, without sensor noise, mean of both mounts. */
typedef struct wcut_rig_figures {
    double from, to;       /**< [s] */
    double mean, rms, max; /**< [1] mean, root mean square and largest size of (tension - target) / target */
    double settled;        /**< [s] after `from` until the tension stays within 5 % of the target; to - from if never */
} wcut_rig_figures;

/** A closed-loop run. All arrays have recording.samples entries. */
typedef struct wcut_rig_run {
    wcut_recording recording;     /**< every required channel, speed_command, heat and mount positions, as measured */
    double *tension;              /**< [N] the wire's own, mean of both mounts */
    double *planned;              /**< [mm/s] the plan's speed of mount A at the station */
    wcut_phase *phase;            /**< the plan's, at the station */
    wcut_control_state *state;    /**< the controller's */
    double *beyond;               /**< [1] share of the engaged wire beyond density_from */
    int room;                     /**< samples that the arrays can hold */
    wcut_control_state ended;     /**< WCUT_CONTROL_STATE_RUN: at the path's end; else what stopped it */
    bool complete;                /**< the path's end was reached */
    double duration;              /**< [s] */
    double target;                /**< [N] */
    double overshoot;             /**< [1] (largest tension - target) / target over the whole cut, at least 0 */
    bool has_steady, has_density; /**< whether the intervals below exist */
    wcut_rig_figures steady;      /**< while the plan is in its steady phase */
    wcut_rig_figures density;     /**< the part of it after half the engaged wire is beyond density_from */
} wcut_rig_run;

/** Defaults for a job. */
WCUT_API wcut_rig_options wcut_rig_options_default(const wcut_job *job);

/**
 * Run a job in closed loop: every period the controller reads the delayed, noisy tensions of the time-driven
 * simulation and commands the speed with which both mounts advance along their paths, from rest, to the last station.
 * The density step multiplies `a` by a mean over the engaged wire, so that it comes gradually, as the bow passes it.
 *
 * @param[in]  job      path mode
 * @param[in]  plan     its whole history, as wcut_setup_run gives it
 * @param[in]  control  the controller's settings
 * @param[in]  options  NULL for the defaults
 * @param[in]  progress may be NULL; called with the station reached
 * @param[in]  context  handed to progress
 * @param[out] run      the caller's, to wcut_rig_run_destroy
 * @param[out] error    may be NULL
 * @return WCUT_OK, a safe stop too; WCUT_NOT_CONVERGED (no equilibrium of the wire, or no end of the path after 20
 *         times the plan's duration), WCUT_INTERRUPTED: run holds the samples up to there, where there is one at
 *         least; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (as wcut_setup_create), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_rig_run_create(const wcut_job *job, const wcut_history *plan,
                                         const wcut_control_settings *control, const wcut_rig_options *options,
                                         wcut_progress progress, void *context, wcut_rig_run **run, wcut_error *error);

/** Free a run; NULL is allowed. */
WCUT_API void wcut_rig_run_destroy(wcut_rig_run *run);

/** The content of `control.json`: one job, the same disturbance, with feedback and with the plan alone. */
typedef struct wcut_rig_summary {
    const wcut_job *job;
    const wcut_control_settings *control;
    const wcut_rig_options *options;
    const wcut_rig_run *feedback; /**< with feedback */
    const wcut_rig_run *plan;     /**< the plan alone */
    bool plan_recorded;           /**< recording.csv is that of the plan alone */
} wcut_rig_summary;

#ifdef __cplusplus
}
#endif

#endif
