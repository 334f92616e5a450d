/* wirecut/robot.h - a cut as the motion of two synchronised robots: thinned targets, limits, programs. */
#ifndef WCUT_ROBOT_H
#define WCUT_ROBOT_H

#include <stdbool.h>
#include <wirecut/bounds.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What the tool frame does. Its x axis looks along the wire into the cut, its z axis up, at both mounts. */
typedef enum wcut_tool_frame {
    WCUT_TOOL_FRAME_FIXED,    /**< along the rest direction, +x at A, -x at B; the head's own axes turn and measure */
    WCUT_TOOL_FRAME_FOLLOWING /**< along the wire, by the simulated alpha and beta */
} wcut_tool_frame;

/** [mm] how far a lead-out takes the wire out of the block that it clears. */
#define WCUT_LEAD_CLEARANCE 1.0

/** How the motion is made from a history. */
typedef struct wcut_robot_options {
    double chord_tolerance; /**< [mm] either mount's distance from its path; default 0.1 */
    double time_tolerance;  /**< [mm] how far along its path either mount may be from where it would be; default 1 */
    double angle_tolerance; /**< [rad] of a following frame; default 0.5 deg */
    double lead_in;         /**< [mm] both mounts begin so far before station 0, against the feed; default 0 */
    double lead_out;        /**< [mm] and go on so far behind the last station; default 0 */
    double zone;            /**< [mm] blend radius, at most 2/5 of the shorter neighbouring move; default 1 */
    wcut_tool_frame frame;
    const wcut_job *heater; /**< whose heater programme runs, its power and its steps; NULL, the default: none */
    const wcut_job *clear;  /**< whose block the lead-out clears: it is lead_out or longer, until the wire of the last
                                 station, moved along as it is, is WCUT_LEAD_CLEARANCE out of the block; NULL, the default: lead_out */
    const wcut_job *tool;   /**< of a bow or a blade: the motion is that of the one robot that holds it; NULL, the
                                 default: two robots */
} wcut_robot_options;

/** A target that both robots reach at the same moment. */
typedef struct wcut_robot_target {
    int station;             /**< of the history; -1: lead-in, -2: lead-out, -3: between stations, of the heater */
    double time, duration;   /**< [s] since the first target; of the move to this one */
    wcut_vec3 a, b;          /**< [mm] block frame */
    double speed_a, speed_b; /**< [mm/s] of the move to this one; first: 0 */
    double zone_a, zone_b;   /**< [mm] 0: exact stop, at the first and the last */
    double frame_a[4];       /**< unit quaternion w, x, y, z of the tool in the block frame, w not negative */
    double frame_b[4];
    double heat; /**< [W/m] of the wire from here on; 0: as before */
} wcut_robot_target;

/** The one robot of a bow or a blade, in the place of robot 0 or 1. */
#define WCUT_ROBOT_SINGLE 2

/** The motion of both robots, or of one. */
typedef struct wcut_robot_motion {
    bool single; /**< one robot: a, speed_a, zone_a and frame_a of its targets are of its tool; b .. are not
                                    read. Its tool is the job's; where that has none its origin is half way between the
                                    mounts, x along the wire from A to B, turned from the block's the shorter way */
    int count;   /**< at least 2 */
    wcut_robot_target *target; /**< count */
    int stations;              /**< that it was made from */
    int first, last;           /**< targets between which the wire is over the path: lead-in and -out are outside */
    double lead_out;           /**< [mm] of the lead-out, 0: none */
    double chord_error;        /**< [mm] largest that thinning left */
    double time_error;         /**< [mm] the same along the path */
    double duration;           /**< [s] */
} wcut_robot_motion;

/** Limits of the cell and the wire; `wcut_robot_limits_default` fills them in. */
typedef struct wcut_robot_limits {
    double speed;        /**< [mm/s] of a mount; default the job's speed_max */
    double acceleration; /**< [mm/s^2] of a mount; default 1000 */
    double alpha, beta;  /**< [rad] largest size of the head's angles; default 60 and 30 deg */
    double ambient;      /**< [degC] default 20 */
    double
        emissivity; /**< [1] of the oxidised wire; default the job's, or that of the wire's material, Kanthal A where it has none */
    double temperature;     /**< [degC] of the wire in air; default 900 */
    double cold_strength;   /**< [MPa] at 20 degC; default as the emissivity */
    double hot_strength;    /**< [MPa] at hot_temperature; default as the emissivity */
    double hot_temperature; /**< [degC] default that of the wire's material, 900 */
} wcut_robot_limits;

/** One figure against its limit. */
typedef struct wcut_robot_check {
    const char *name; /**< "speed of mount A" */
    const char *unit; /**< "mm/s" */
    double value, limit;
    int station; /**< where it is largest; -1: everywhere */
    bool over;   /**< value beyond the limit */
} wcut_robot_check;

enum { WCUT_ROBOT_CHECKS = 10 };

/** The defaults stated at the fields. */
WCUT_API wcut_robot_options wcut_robot_options_default(void);
/** The defaults stated at the fields, for a job. */
WCUT_API wcut_robot_limits wcut_robot_limits_default(const wcut_job *job);

/**
 * Let a planned history run at the pace of its job's excitation: the speed of station to station is multiplied by the mean
 * of 1 + sum A sin(2 pi t / P + phase) over it, from where half of the longest engagement is in the foam; t is 0 at
 * station 0. Times, durations and speeds of the mounts change, nothing else: tensions and angles stay those of the plan.
 *
 * @param[in]     job     its dither; without one nothing changes
 * @param[in,out] history at least two stations
 * @param[out]    error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (amplitudes of 1 or more together, stations more than a fifth of the shortest
 *         period apart): the history is as it was.
 */
WCUT_API wcut_status wcut_history_excite(const wcut_job *job, wcut_history *history, wcut_error *error);

/**
 * Make the motion of two robots from a history and its path curves: one list of targets for both, so that they stay in
 * step; between targets both go straight and evenly. A station is left out where both mounts stay within the chord
 * tolerance of their paths and the time tolerance of their places at every moment (Ramer 1972, Douglas, Peucker 1973).
 * Where the heater changes its power there is a target of its own, between stations too.
 *
 * @param[in]  history at least two stations
 * @param[in]  mount_a history->stations [mm], from wcut_history_path
 * @param[in]  mount_b history->stations [mm]
 * @param[in]  options NULL for the defaults
 * @param[out] motion  the caller's, to wcut_robot_motion_destroy
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (tolerances not positive, leads or zone negative, speeds not positive),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_robot_motion_create(const wcut_history *history, const wcut_vec3 *mount_a,
                                              const wcut_vec3 *mount_b, const wcut_robot_options *options,
                                              wcut_robot_motion **motion, wcut_error *error);

/** Free a motion; NULL is allowed. */
WCUT_API void wcut_robot_motion_destroy(wcut_robot_motion *motion);

/**
 * Temperature of a hot wire in still air: Q_I / (pi d) = h (T - T0) + e sigma (T^4 - T0^4) with natural convection
 * around a horizontal cylinder, Nu = (0.60 + 0.387 Ra^(1/6) / (1 + (0.559 / Pr)^(9/16))^(8/27))^2 (Churchill, Chu
 * 1975), air by Sutherland's law at the film temperature. Kanthal A 0.15 mm: 649 degC at 65 W/m, 759 at 85.
 *
 * @param[in]  heat        [W/m] not negative
 * @param[in]  diameter    [mm] positive
 * @param[in]  ambient     [degC] -100 .. 200
 * @param[in]  emissivity  [1] 0 .. 1
 * @param[out] temperature [degC]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (hotter than 3000 degC, too): nothing was written.
 */
WCUT_API wcut_status wcut_wire_temperature(double heat, double diameter, double ambient, double emissivity,
                                           double *temperature);

/**
 * Check a cut against the limits of cell and wire. Speeds and accelerations are those of the stations, not of the
 * thinned targets. The wire's strength falls exponentially from its cold to its hot value and on; the stress is that of
 * the largest tension of either mount, and its check is `over` where it exceeds the strength at the temperature in air.
 *
 * @param[in]  job     that the history came from
 * @param[in]  history at least two stations
 * @param[in]  mount_a history->stations [mm]
 * @param[in]  mount_b history->stations [mm]
 * @param[in]  limits  NULL for the defaults; all finite and positive, but emissivity 0 .. 1 and any ambient
 * @param[out] check   WCUT_ROBOT_CHECKS
 * @return WCUT_OK, also where limits are exceeded; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_robot_limits_check(const wcut_job *job, const wcut_history *history, const wcut_vec3 *mount_a,
                                             const wcut_vec3 *mount_b, const wcut_robot_limits *limits,
                                             wcut_robot_check *check);

#ifdef __cplusplus
}
#endif

#endif
