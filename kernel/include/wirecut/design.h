/* wirecut/design.h - from a target surface to the cut that comes nearest to it. */
#ifndef WCUT_DESIGN_H
#define WCUT_DESIGN_H

#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/trimmed.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A surface that a cut is to come near to, an open sheet over the block. Const once made. */
typedef struct wcut_design_target wcut_design_target;

/**
 * A target from a surface. What of it lies over the block counts.
 *
 * @param[in]  surface one height over every place of the block; it may end before the block's sides
 * @param[in]  block   [mm] W, L, H
 * @param[out] target  the caller's, to wcut_design_target_destroy
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (it is not over the block, folds over or stands upright somewhere, or lies outside the
 *         block's height; says where, and whether its unit looks wrong), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_design_target_from_surface(const wcut_surface *surface, wcut_vec3 block,
                                                     wcut_design_target **target, wcut_error *error);

/**
 * The same from faces of a CAD file: what is inside their borders counts.
 *
 * @param[in]  faces  1 .. 100
 * @param[in]  face   faces; together one height over every place of the block
 * @param[in]  block  [mm] W, L, H
 * @param[out] target the caller's, to wcut_design_target_destroy
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (as wcut_design_target_from_surface; two faces above each other), WCUT_BAD_ARGUMENT,
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_design_target_from_faces(int faces, const wcut_trimmed *const *face, wcut_vec3 block,
                                                   wcut_design_target **target, wcut_error *error);

/**
 * The same from triangles.
 *
 * @param[in]  mesh   an open sheet, one height over every place of the block
 * @param[in]  block  [mm] W, L, H
 * @param[out] target the caller's, to wcut_design_target_destroy
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (as wcut_design_target_from_surface; a closed or non-manifold mesh),
 *         WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_design_target_from_mesh(const wcut_mesh *mesh, wcut_vec3 block, wcut_design_target **target,
                                                  wcut_error *error);

/**
 * The same from points: a scan, with noise, holes and strays. A fit to it is robust (Tukey's biweight).
 *
 * @param[in]  count  points, 50 or more over the block
 * @param[in]  point  count [mm], finite
 * @param[in]  block  [mm] W, L, H
 * @param[out] target the caller's, to wcut_design_target_destroy
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (as wcut_design_target_from_surface), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_design_target_from_points(int count, const wcut_vec3 *point, wcut_vec3 block,
                                                    wcut_design_target **target, wcut_error *error);

/** Free a target; NULL is allowed. */
WCUT_API void wcut_design_target_destroy(wcut_design_target *target);

/** Along which axis of the target's block the wire is fed. The design's own frame always feeds along +y. */
typedef enum wcut_design_feed {
    WCUT_DESIGN_FEED_AUTO, /**< all four are tried */
    WCUT_DESIGN_FEED_PLUS_Y,
    WCUT_DESIGN_FEED_MINUS_Y,
    WCUT_DESIGN_FEED_PLUS_X,
    WCUT_DESIGN_FEED_MINUS_X
} wcut_design_feed;

/** "auto", "+y", "-y", "+x", "-x". */
WCUT_API const char *wcut_design_feed_name(wcut_design_feed feed);

/** How a design is searched for. */
typedef struct wcut_design_options {
    wcut_design_feed feed; /**< default WCUT_DESIGN_FEED_AUTO */
    int free_edges;   /**< 1 (default): both edges' heights are unknowns; 0: the edges lie on the target's borders */
    double tolerance; /**< [mm] the search ends where the rms is this small; not negative; default 0.01 */
    double angle_max; /**< [rad] of the wire against the x axis at the block's sides; default 60 deg */
    int unknowns_max; /**< coefficients of each curve at most, 6 .. 40; default 24 */
    int threads;      /**< 1 or more; no result depends on it; default 1 */
    const char *name; /**< UTF-8, of the design's job; default NULL: that of the job that was given */
} wcut_design_options;

/** The defaults stated at the fields. */
WCUT_API wcut_design_options wcut_design_options_default(void);

/** Why a place of the target cannot be followed. */
typedef enum wcut_design_reason {
    WCUT_DESIGN_REASON_NONE,  /**< it can */
    WCUT_DESIGN_REASON_DOMED, /**< positive Gauss curvature: no wire lies in it */
    WCUT_DESIGN_REASON_TIGHT, /**< it would need a wire bent tighter than the force on it bends it, F/T */
    WCUT_DESIGN_REASON_ANGLE, /**< the wire's angle at the block's sides would be beyond its limit */
    WCUT_DESIGN_REASON_PATTERN /**< no family of wires runs from side to side there, though each place is saddle-shaped */
} wcut_design_reason;

/** "", "domed", "tight", "angle", "pattern". */
WCUT_API const char *wcut_design_reason_name(wcut_design_reason reason);

/** What can be said of a target before anything is simulated. */
typedef struct wcut_design_map {
    wcut_design_feed feed; /**< the best one, or the one that was asked for */
    double predicted_rms;  /**< [mm] of what no wire can follow; an upper bound where the target can be reached */
    double predicted_max;  /**< [mm] */
    double feed_rms[5];    /**< [mm] by wcut_design_feed; not finite where a feed was not tried */
    double domed_share;    /**< [1] of the target, with positive Gauss curvature */
    int rows, columns;     /**< of the map, along y and x of the target's block */
    wcut_vec3 *point;      /**< rows x columns [mm] on the target */
    double *bow;           /**< rows x columns [mm] predicted deviation, positive above the target */
    double *gauss;         /**< rows x columns [1/mm^2] */
    unsigned char *reason; /**< rows x columns, wcut_design_reason: where |bow| is more than the tolerance */
    double share[5];       /**< [1] of the map by wcut_design_reason */
} wcut_design_map;

/**
 * Whether a cut can follow a target, without simulating: a wire in steady foam is an asymptotic curve of the surface that
 * it cuts, so that along it the normal curvature is 0. Candidate wires (a chord skewed by a lag, bowed back by a sag) are
 * laid on the target, the normal curvature is integrated twice along them, and dynamic programming (Bellman 1957) finds
 * the lag and the sag of every place of the feed.
 *
 * @param[in]  target  the block's frame
 * @param[in]  job     process and block; mode, edges and paths are not looked at
 * @param[in]  options NULL for the defaults
 * @param[out] map     the caller's, to wcut_design_map_destroy
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also a job of another block), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_design_map_create(const wcut_design_target *target, const wcut_job *job,
                                            const wcut_design_options *options, wcut_design_map **map,
                                            wcut_error *error);

/** Free a map; NULL is allowed. */
WCUT_API void wcut_design_map_destroy(wcut_design_map *map);

/** One round of a search. */
typedef struct wcut_design_round {
    int stations, nodes; /**< of the runs */
    int unknowns;        /**< in all */
    int runs;            /**< so far, those with derivatives among them */
    double rms, max;     /**< [mm] */
} wcut_design_round;

/** A cut that was found. */
typedef struct wcut_design {
    wcut_job *job;  /**< mode design, in the design's frame: the target's block turned so that the feed is +y */
    wcut_job *path; /**< mode path: the way of both mounts, corrected so that what they cut is nearest to the target */
    wcut_design_feed feed;
    double turn[12];             /**< 3 x 4 row-major: from the target's block frame to the design's */
    double rms, max;             /**< [mm] of the target's points inside the block from the face of the plan */
    double path_rms, path_max;   /**< [mm] of the same from the face that the path cuts */
    double unpolished_rms;       /**< [mm] of the same from the face that the job's own path cuts */
    double start_rms;            /**< [mm] of the best start, before any fit */
    int used, strays, uncovered; /**< points: that count, that are strays of a cloud, that the face does not reach */
    int runs;                    /**< simulations in all */
    int rounds;
    wcut_design_round *round;  /**< rounds */
    int points;                /**< of the target that count */
    wcut_vec3 *point;          /**< points [mm], in the design's frame */
    int stations;              /**< of the job */
    double *lag, *sag, *extra; /**< stations [mm] how far end A leads end B, the bow, the wire's extra length */
} wcut_design;

/** Called after every round; return 0 to go on, anything else to stop. */
typedef int (*wcut_design_progress)(const wcut_design_round *round, void *context);

/**
 * The cut that comes nearest to a target: Levenberg-Marquardt (Marquardt 1963) on splines over the feed of both edges'
 * heights, lag and extra length, from the starts of a map, on coarse runs first and on the job's own stations and nodes
 * at the end. Derivatives are those of the step's equations.
 *
 * @param[in]  target
 * @param[in]  job      block, wire, process, stations and nodes; mode, edges and paths are not looked at
 * @param[in]  options  NULL for the defaults
 * @param[in]  progress may be NULL
 * @param[in]  context  handed to progress
 * @param[out] design   the caller's, to wcut_design_destroy
 * @param[out] error    may be NULL
 * @return WCUT_OK, whether the tolerance is held or not: see rms; WCUT_INTERRUPTED: the best so far is handed out;
 *         WCUT_NOT_CONVERGED (no start could be simulated), WCUT_BAD_ARGUMENT, WCUT_DEGENERATE, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_design_fit(const wcut_design_target *target, const wcut_job *job,
                                     const wcut_design_options *options, wcut_design_progress progress, void *context,
                                     wcut_design **design, wcut_error *error);

/** Free a design; NULL is allowed. */
WCUT_API void wcut_design_destroy(wcut_design *design);

#ifdef __cplusplus
}
#endif

#endif
