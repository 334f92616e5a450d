/* wirecut/job.h - what is to be cut: block, wire, process, and the path or the design. */
#ifndef WCUT_JOB_H
#define WCUT_JOB_H

#include <wirecut/curve.h>
#include <wirecut/effects.h>
#include <wirecut/export.h>
#include <wirecut/force_law.h>
#include <wirecut/job_rig.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Whether the mounts' path or the design's edge curves are given. */
typedef enum wcut_mode { WCUT_MODE_PATH, WCUT_MODE_DESIGN } wcut_mode;

/** One sine of a programmed speed dither: 1 + sum amplitude sin(2 pi t / period + phase). */
typedef struct wcut_dither {
    double amplitude; /**< [1] */
    double period;    /**< [s] positive */
    double phase;     /**< [rad] */
} wcut_dither;

/** One interval in which the heater's power is multiplied by a factor. */
typedef struct wcut_heat_step {
    double from, to; /**< [s] from < to */
    double factor;   /**< [1] positive */
} wcut_heat_step;

/** A job; `wcut_job_create` gives one with every optional part at its default. */
typedef struct wcut_job {
    char *name;          /**< UTF-8 */
    char *foam_material; /**< UTF-8, may be NULL */
    char *wire_material; /**< UTF-8, may be NULL */

    wcut_vec3 block_size;      /**< [mm] W, L, H: the block fills [0,W] x [0,L] x [0,H] */
    double wire_diameter;      /**< [mm] */
    double wire_density;       /**< [kg/m3] of its material, for its weight along -z; default 0: weightless */
    double wire_cold_strength; /**< [MPa] tensile, at 20 degC; default 0: that of its material */
    double wire_hot_strength;  /**< [MPa] tensile, at 900 degC; default 0: the same */
    double wire_emissivity;    /**< [1] of its oxidised surface, up to 1; default 0: the same */
    double wire_length;        /**< [mm] path mode: between the mounts; design mode, blade, bow with a pretension: not
                                    read */
    int nodes;                 /**< at least 3 */

    double heat;    /**< [W/m] positive; 0 of a blade: F = a */
    double tension; /**< [N] target at each mount, k; of a bow or a blade not read: its tension is an answer */
    wcut_force_law force_law;
    wcut_tension_law tension_law; /**< a = 0 where the job gives none */
    double speed_max;             /**< [mm/s] of the faster mount; default 100 */
    double speed_min;             /**< [mm/s] of the faster mount; default 0.1 */

    double kerf_width; /**< [mm] default 0 */
    double kerf_per_q; /**< [mm m^2/J] growth with the local Q_eff; default 0 */

    wcut_rig rig;   /**< what holds the wire */
    wcut_feed feed; /**< commanded speed; a bow and a blade have one */

    wcut_mode mode;
    int stations;       /**< at least 2 */
    wcut_vec3 *mount_a; /**< path mode: stations [mm]; NULL in design mode */
    wcut_vec3 *mount_b; /**< path mode: stations [mm]; NULL in design mode */
    wcut_pose *tool;    /**< stations; NULL where mounts are given: else both mounts are points of this one tool */
    wcut_vec3 mount_a_in_tool, mount_b_in_tool; /**< [mm] with a tool */

    wcut_curve *edge_a;   /**< design mode: where the wire enters the block's side A */
    wcut_curve *edge_b;   /**< design mode: ... and side B */
    int extra_count;      /**< design mode: points of the extra-length function, at least 1 */
    double *extra_u;      /**< extra_count, strictly increasing in [0, 1] */
    double *extra_length; /**< extra_count [mm], not negative: wire beyond |P_a P_b| */
    double clearance;     /**< [mm] design mode: both mounts keep it from the block */
    double
        overrun; /**< [mm] design mode: so far before the block and behind it may edges run, between the planes of its
                         sides; default 0 */

    int dither_count;
    wcut_dither *dither; /**< identification cuts: speed programme */
    int heat_step_count;
    wcut_heat_step *heat_step; /**< identification cuts: heater programme */

    int effect_count;
    wcut_effect *effect; /**< what is simulated beyond the plain model; 0 of them by default */
} wcut_job;

/**
 * An empty job with the defaults of every optional part.
 *
 * @param[out] job the caller's, to wcut_job_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_job_create(wcut_job **job);

/** Free a job with everything in it; NULL is allowed. */
WCUT_API void wcut_job_destroy(wcut_job *job);

/**
 * Change the number of stations of a path-mode job: both mount paths are resampled at the same parameter, that of
 * the mean of both paths' arc lengths, on the polylines through the given stations, which are what was programmed
 * between them; a tool turns evenly from station to station. Speeds of stations follow. In design mode only the count
 * changes.
 *
 * @param[in,out] job      a filled job
 * @param[in]     stations at least 2
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: the job is as it was.
 */
WCUT_API wcut_status wcut_job_resample(wcut_job *job, int stations);

/**
 * Give a path-mode job the mounts that its tool leads: of every station both mounts' places by the tool's pose.
 *
 * @param[in,out] job   with tool; mount_a and mount_b are replaced; the poses get unit quaternions, w not negative
 * @param[out]    error may be NULL; the station
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (no tool, a pose that is no rotation: a quaternion that is more than 1e-3 off
 *         unit length), WCUT_NO_MEMORY: the job is as it was.
 */
WCUT_API wcut_status wcut_job_place_mounts(wcut_job *job, wcut_error *error);

/**
 * Heater power at a time of a recording: the job's, times the factor of the step of its programme that holds there.
 *
 * @param[in] job  a filled job
 * @param[in] time [s]
 * @return [W/m]
 */
WCUT_API double wcut_job_heat_eval(const wcut_job *job, double time);

/**
 * Speed at a time over what the controller asks for: 1 + sum A sin(2 pi t / P + phase) of the job's programme.
 *
 * @param[in] job  a filled job
 * @param[in] time [s]
 * @return [1]; 1 without a programme
 */
WCUT_API double wcut_job_pace_eval(const wcut_job *job, double time);

#ifdef __cplusplus
}
#endif

#endif
