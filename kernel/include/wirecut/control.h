/* wirecut/control.h - force-adaptive speed: feedforward from a simulated cut, feedback from the measured tension. */
#ifndef WCUT_CONTROL_H
#define WCUT_CONTROL_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The law. Tension follows the foam's force, T ~ a exp(-s / v) with s = b Q_I, so that ln T is linear in the slowness
   1/v, with the same slope at every speed, tension and density. The controller therefore acts on the slowness, in
   units of 1/s, and measures the error as a logarithm:

       s / v = s / v_plan(station) + u,   u = gain e + integral of (rate e dt),   e = ln(T / k)

   One pair of gains then serves every job; a wrong `a`, or a foam of another density, is one constant u. */

/** Settings of a controller; `wcut_control_settings_default` fills them in for a job. */
typedef struct wcut_control_settings {
    bool feedback;         /**< false: the plan alone, limits and watchdog stay */
    double tension;        /**< [N] target k, mean of both mounts */
    double exponent_speed; /**< [mm/s] s = 1000 b Q_I of the job's force law */
    double gain;           /**< [1] proportional, on the log tension error; default 0.3 */
    double rate;           /**< [1/s] integral; default 1.5 */
    double filter;         /**< [s] time constant of the tension's low-pass; 0: none; default 0.1 */
    double authority;      /**< [1] largest |u|: the foam's force may be e^authority times the plan's; default 2 */
    double speed_min;      /**< [mm/s] of the faster mount while it cuts */
    double speed_max;      /**< [mm/s] of the faster mount */
    double acceleration;   /**< [mm/s^2] largest change of the commanded speed, either way; default 200 */
    double caution;        /**< [1] initial u: the first contact would have the tension e^-caution k; default 1 */
    double margin;         /**< [mm] of path before and after the contact that are run at cutting speed; default 10 */
    double noise;          /**< [N] a reading within +- this is no load; default 0.1 k */
    double tension_stop;   /**< [N] of either mount, two readings in a row: safe stop; default 2.5 k */
    double tension_absurd; /**< [N] no sensor of this rig can read more; default 25 k */
    double fault_time;     /**< [s] readings absurd, repeated or late for longer: safe stop; default 0.5 */
} wcut_control_settings;

/** What the controller is doing. A stop is latched: the speed ramps to 0 and stays there. */
typedef enum wcut_control_state {
    WCUT_CONTROL_STATE_RUN,          /**< plan and feedback */
    WCUT_CONTROL_STATE_HOLD,         /**< the reading was dropped: plan with the last correction */
    WCUT_CONTROL_STATE_STOP_TENSION, /**< over-tension */
    WCUT_CONTROL_STATE_STOP_ABSURD,  /**< reading not finite, negative beyond its noise or out of range, for too long */
    WCUT_CONTROL_STATE_STOP_STALE    /**< sensor repeats itself, or time stands still, for too long */
} wcut_control_state;

/** The controller's last step, for logs and displays. */
typedef struct wcut_control_view {
    wcut_control_state state;
    double speed;      /**< [mm/s] commanded, of the faster mount */
    double planned;    /**< [mm/s] at this station, slowed down ahead of what the acceleration allows */
    double tension;    /**< [N] mean of both mounts, filtered */
    double error;      /**< [1] ln(tension / target) in the feedback */
    double correction; /**< [1] u */
    int dropped;       /**< readings dropped so far */
} wcut_control_view;

typedef struct wcut_control wcut_control; /**< one loop's memory: belongs to one thread at a time */

/** Defaults for a job: its tension, heat, force law and speed limits. */
WCUT_API wcut_control_settings wcut_control_settings_default(const wcut_job *job);

/**
 * Make a controller. The plan's speed of the faster mount becomes the feedforward, slowed down beforehand where its
 * drop would need more than 7/10 of the acceleration.
 *
 * @param[in]  settings within the ranges above: all finite, gain, rate, filter, caution, margin and noise not negative,
 *                      the others positive, speed_min < speed_max, tension < tension_stop < tension_absurd
 * @param[in]  plan     a whole path-mode history of at least two stations; may be freed afterwards
 * @param[out] control  the caller's, to wcut_control_destroy
 * @param[out] error    may be NULL; which setting is wrong
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_control_create(const wcut_control_settings *settings, const wcut_history *plan,
                                         wcut_control **control, wcut_error *error);

/** Free a controller; NULL is allowed. */
WCUT_API void wcut_control_destroy(wcut_control *control);

/**
 * One step of the loop: readings in, speed out. No allocation, no lock, no system call, no loop: under 2 us. The first
 * call starts the clock and gives 0; a machine begins at rest. Whatever the readings are, the speed is finite, in
 * [0, speed_max] and within the acceleration.
 *
 * @param[in,out] control   a controller
 * @param[in]     time      [s] of the readings; not later than at the call before: the readings are stale
 * @param[in]     station   real-valued position along the path; beyond the path its ends count
 * @param[in]     tension_a [N] as measured
 * @param[in]     tension_b [N] as measured
 * @param[out]    speed     [mm/s] to command, of the faster mount along its path
 * @return WCUT_OK, with wcut_control_look for whether it holds or stops; WCUT_BAD_ARGUMENT: a pointer is NULL, nothing
 *         was written. No reading is an error.
 */
WCUT_API wcut_status wcut_control_step(wcut_control *control, double time, double station, double tension_a,
                                       double tension_b, double *speed);

/** Look at the last step; before the first the speed is 0. */
WCUT_API void wcut_control_look(const wcut_control *control, wcut_control_view *view);

/** The name of a state: "run", "hold", "stop: over-tension", "stop: absurd readings", "stop: stale readings". */
WCUT_API const char *wcut_control_state_name(wcut_control_state state);

#ifdef __cplusplus
}
#endif

#endif
