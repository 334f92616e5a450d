/* wirecut/job_rig.h - what holds the wire of a job and how it is fed: two arms, a bow, a blade. */
#ifndef WCUT_JOB_RIG_H
#define WCUT_JOB_RIG_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What holds the wire. */
typedef enum wcut_rig_kind {
    WCUT_RIG_KIND_TWO_ARMS, /**< each end on an arm of its own, one length of wire, the tension is controlled */
    WCUT_RIG_KIND_BOW,      /**< a taut wire between the ends of an elastic frame; its length is an answer */
    WCUT_RIG_KIND_BLADE     /**< straight between its ends, whatever loads it */
} wcut_rig_kind;

/** What holds the wire; all but kind and force frame is of a bow. Equations: NOTATION.md, Rigs. */
typedef struct wcut_rig {
    wcut_rig_kind kind; /**< default two arms */
    double pretension;  /**< [N] of the cold wire, straight, before it is loaded; 0, the default: the job's
                                wire_length is that of the cold wire without tension, and the frame is unloaded at rest */
    double stiffness;   /**< [N/mm] force along the wire over the way by which the frame's ends come closer; positive;
                                default INFINITY: rigid */
    double
        wire_stiffness;  /**< [N] EA of the wire; INFINITY: it does not stretch; default 0: of material and diameter */
    double expansion;    /**< [1/K] of the wire, not negative; default -1: of its material */
    bool force_in_block; /**< the force sensor's readings are in the block frame; default: in that of the tool */
} wcut_rig;

/** What the commanded speed depends on. */
typedef enum wcut_feed_kind {
    WCUT_FEED_KIND_NONE,     /**< none is commanded: the tension sets the speed */
    WCUT_FEED_KIND_CONSTANT, /**< speed[0] */
    WCUT_FEED_KIND_STATIONS, /**< speed[j] on the way from station j-1 to j; speed[0] on none, as in path.csv */
    WCUT_FEED_KIND_TIME      /**< speed[k] at time[k], linear between, constant before and after */
} wcut_feed_kind;

/** Commanded speed of the faster mount. */
typedef struct wcut_feed {
    wcut_feed_kind kind;
    int count;     /**< 0 without a feed, 1, the job's stations, or at least 2 */
    double *speed; /**< count [mm/s] positive */
    double *time;  /**< count [s] since station 0, strictly increasing, from 0 or later; NULL but for a time profile */
} wcut_feed;

/** Where a tool is: its frame in the block's. */
typedef struct wcut_pose {
    wcut_vec3 at;   /**< [mm] */
    double turn[4]; /**< unit quaternion w, x, y, z: tool to block */
} wcut_pose;

/**
 * A point of the tool in the block frame.
 *
 * @param[in] pose  turn need not be of unit length, but not 0
 * @param[in] point [mm] in the tool frame
 * @return [mm] in the block frame
 */
WCUT_API wcut_vec3 wcut_pose_point(const wcut_pose *pose, wcut_vec3 point);

/** The word of a kind in files: "two_arms", "bow", "blade"; "unknown" outside the enum. */
WCUT_API const char *wcut_rig_name(wcut_rig_kind kind);

/**
 * How long a way takes that begins at a time, by the commanded speed.
 *
 * @param[in]  feed     with a speed, checked
 * @param[in]  station  to which the way leads, at least 1
 * @param[in]  from     [s] since station 0, not negative
 * @param[in]  way      [mm] of the faster mount, positive
 * @param[out] duration [s]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (no feed, a station that it has no speed for): nothing was written.
 */
WCUT_API wcut_status wcut_feed_eval(const wcut_feed *feed, int station, double from, double way, double *duration);

/** What a wire is made of. */
typedef struct wcut_wire_material {
    const char *name;       /**< a part of what jobs call it, in any case of letters */
    double modulus;         /**< [MPa] Young's, at 20 degC */
    double expansion;       /**< [1/K] mean from 20 to 500 degC */
    double cold_strength;   /**< [MPa] tensile, at 20 degC */
    double hot_strength;    /**< [MPa] at hot_temperature; exponential between */
    double hot_temperature; /**< [degC] */
    double emissivity;      /**< [1] of the oxidised surface */
} wcut_wire_material;

/** The properties of a wire's material by its name, borrowed; NULL where it is NULL or none of those known. */
WCUT_API const wcut_wire_material *wcut_wire_material_view(const char *name);

#ifdef __cplusplus
}
#endif

#endif
