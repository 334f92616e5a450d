/* wirecut/mould.h - the block cut in two: two closed solids, as triangles and as exact faces, with their checks. */
#ifndef WCUT_MOULD_H
#define WCUT_MOULD_H

#include <wirecut/brep.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A cone, flat at its end, on the face of a half that the wire does not cut: it locates the half on a base plate. */
typedef struct wcut_key {
    int upper;         /**< 0: on z = 0 of the lower half, 1: on z = H of the upper */
    double x, y;       /**< [mm] of its axis, along z */
    double radius;     /**< [mm] on the face */
    double tip_radius; /**< [mm] at its end: positive, smaller than radius */
    double height;     /**< [mm] positive: a cone that stands out; negative: a pocket */
} wcut_key;

/** How a block is divided; `wcut_mould_default` fills it in. */
typedef struct wcut_mould_options {
    double chord_tolerance; /**< [mm] between triangles and exact cut face; 0.1 */
    double fit_tolerance;   /**< [mm] between exact cut face and the wire's surface, verified; 0.005 */
    double prolong;         /**< [mm] how far the cut may be continued straight where it ends inside the block; 100 */
    double kerf;            /**< [mm] width that the wire removes, half on either side; 0. Not read with a field: */
    int kerf_stations;      /**< rows of the field below; 0: the kerf is the same everywhere */
    int kerf_nodes;         /**< columns of it, at equal steps of u */
    const double *kerf_parameter; /**< kerf_stations: v of each row, not decreasing (wcut_surface_loft) */
    const double *kerf_field; /**< kerf_stations x kerf_nodes [mm], not negative; smoothed as the surface's knots do */
    int key_count;
    const wcut_key *key;    /**< key_count, apart from each other and from the block's edges */
    double thickness;       /**< [mm] of the casting between the halves, along the normals of the cut, half on either
                                 side, in place of the kerf: no wire cuts both faces at once; 0: none */
    double lug_radius;      /**< [mm] of the cones of the locating lugs; 0: no lugs. Three boxes beside each half, two
                                 at x = 0 and one at x = W, so that the halves fit in one way only. Cones of the lower
                                 half end on the floors of pockets of the upper, at the distance of the cut faces */
    double lug_height;      /**< [mm] of a cone that is in its pocket; positive with lugs */
    double lug_clearance;   /**< [mm] between flank of cone and pocket, radially; 0.1 */
    double frame_wall;      /**< [mm] of a frame around the block in which both halves lie; 0: none; not with lugs */
    double frame_clearance; /**< [mm] between block and frame; 0.2 */
    double scale;           /**< [1] 1 + shrinkage of the cast: both halves are larger by it, from the origin; 1 */
    wcut_vec3 pull;         /**< [1] direction in which the cast leaves the lower half, the upper half's is opposite;
                                 any length; +z */
    double wire_diameter;   /**< [mm] to judge the surface's smallest radius by; 0 */
    double wall_asked;      /**< [mm] required wall_min; 0 */
    double draft_asked;     /**< [rad] required draft_min; -pi/2: any */
    const wcut_mesh *stock; /**< closed mesh inside the block that is cut in the block's place; NULL */
} wcut_mould_options;

/** What a half is like; lengths, areas and volumes of the scaled solid. */
typedef struct wcut_half_report {
    int closed;                  /**< 1: every edge has two triangles */
    int oriented;                /**< 1: ... in opposite directions, and the volume is positive */
    int self_intersections;      /**< pairs of triangles that touch without sharing a corner, or overlap: 0, proven */
    int pieces;                  /**< connected parts: 1 unless the cut leaves through top or bottom */
    double volume;               /**< [mm3] */
    double area;                 /**< [mm2] of the whole surface */
    double cut_area;             /**< [mm2] of the cut face */
    wcut_vec3 box_low, box_high; /**< [mm] */
    double draft_min;            /**< [rad] least angle between cut face and pull, negative where it is undercut */
    wcut_vec3 draft_place;       /**< [mm] ... and where */
    double undercut_area;        /**< [mm2] of the cut face that turns away from the pull */
    double wall_min;             /**< [mm] least distance, in any direction, from the cut face to the face opposite and
                                     to pockets in it; and to a side of the block that the inward normal of the cut
                                     face meets within 45 deg, so that an edge sharper than that gives 0. NaN with a
                                     stock, or where the cut leaves through top or bottom */
    wcut_vec3 wall_place;        /**< [mm] ... and where on the cut face; NaN likewise */
    double edge_min;             /**< [rad] least angle inside the half between cut face and a side; NaN likewise */
    wcut_vec3 edge_place;        /**< [mm] ... and where; NaN likewise */
    int wall_held, draft_held;   /**< 1: as required; an unknown wall holds only where 0 is required */
    double key_volume;           /**< [mm3] of its keys and lugs, those of pockets negative */
} wcut_half_report;

/** One half. */
typedef struct wcut_half {
    wcut_mesh *mesh;    /**< closed, oriented outwards; vertices shared by index */
    unsigned char *cut; /**< triangle_count: 1 where it is of the cut face */
    double *draft; /**< vertex_count [rad]: least angle to the pull of the cut face's triangles there, NaN elsewhere */
    wcut_brep *brep; /**< the same solid exactly; NULL where the cut leaves through top or bottom, or with a stock */
    wcut_half_report report;
} wcut_half;

/** Both halves and what they have in common. */
typedef struct wcut_mould {
    wcut_half lower, upper;
    wcut_mesh *frame;      /**< closed; NULL without one */
    wcut_brep *frame_brep; /**< the same exactly; NULL without one */
    double frame_volume;   /**< [mm3] of it */
    wcut_mesh *kerf;       /**< closed: what is between the halves, the casting of a thickness; NULL where both are 0 */
    double kerf_volume;    /**< [mm3] of it */
    double block_volume;   /**< [mm3] of the block or the stock */
    double volume_error;   /**< [1] |lower + upper + kerf - keys - block| / block */
    double fit_error;      /**< [mm] measured: largest distance from the wire's surface to the exact cut face */
    double chord_error;    /**< [mm] measured: largest distance from triangles to the exact cut face */
    double prolonged_entry;    /**< [mm] how far the cut was continued inside the block where it begins, 0 if not */
    double prolonged_exit;     /**< [mm] ... and where it ends */
    double prolonged_side;     /**< [mm] ... and at the ends of the wire */
    double radius_min;         /**< [mm] least radius of curvature of the cut, INFINITY where it is flat */
    wcut_vec3 radius_place;    /**< [mm] ... and where */
    double kerf_min, kerf_max; /**< [mm] over the cut face */
    double thickness;          /**< [mm] as asked for */
    int lugs;                  /**< of each half */
    double scale;              /**< [1] as asked for */
    double wire_radius;        /**< [mm] as asked for */
    double wall_asked;         /**< [mm] as asked for */
    double draft_asked;        /**< [rad] as asked for */
    wcut_vec3 pull;            /**< [1] unit; out of the lower half, the upper half's is opposite */
    int by_boolean;            /**< 1: made by mesh booleans (stock, or the cut leaves through top or bottom) */
} wcut_mould;

/** The defaults written beside each option. */
WCUT_API wcut_mould_options wcut_mould_default(void);

/**
 * Divide the block [0, W] x [0, L] x [0, H] along a surface, `lower` below it and `upper` above.
 *
 * The surface runs along the wire in u, from x <= 0 to x >= W, x increasing, and with the feed in v, from y <= 0 to
 * y >= L; it may overhang. It is trimmed where it meets the block's sides, each border curve exactly in its plane, and
 * written anew over the unit square, (s, t) -> (W s, y, z), a bicubic surface within fit_tolerance. Halves come from
 * it by index. Where the cut leaves through top or bottom, and for a stock, they come from booleans of such solids.
 *
 * @param[in]  surface    the wire's surface, such as wcut_surface_loft gives
 * @param[in]  block_size [mm] W, L, H, positive
 * @param[in]  options    NULL: the defaults
 * @param[out] mould      the caller's, to wcut_mould_destroy; closed, oriented, free of self-intersections
 * @param[out] error      may be NULL; what is wrong and where in the block
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (an option out of range, keys that meet, no room for lugs, lugs or a frame with a
 *         stock or both together, lugs where the cut leaves through top or bottom, a stock that is not closed or not inside
 *         the block); WCUT_DEGENERATE (the cut misses the block, grazes a face, runs along an edge or through a corner,
 *         ends inside the block further than `prolong`, folds over itself, its kerf folds); WCUT_NOT_CONVERGED (no
 *         bicubic surface within fit_tolerance, no triangles within chord_tolerance, of a size that fits);
 *         WCUT_NO_MEMORY; WCUT_INTERNAL: nothing was written.
 */
WCUT_API wcut_status wcut_mould_create(const wcut_surface *surface, wcut_vec3 block_size,
                                       const wcut_mould_options *options, wcut_mould **mould, wcut_error *error);

/** Free a mould; NULL is allowed. */
WCUT_API void wcut_mould_destroy(wcut_mould *mould);

enum { WCUT_KEYS_AT_CORNERS = 6 };

/**
 * Three keys on the uncut face of each half, near its corners at x low and y low, at x high and y low, and at x low and
 * y high, so that a half fits in one way only; flanks 20 deg from the axis, radius / 2 away from the block's sides.
 *
 * @param[in]  block_size [mm] W, L, H, positive
 * @param[in]  radius     [mm] positive
 * @param[in]  height     [mm] positive: cones, negative: pockets; |height| tan 20 deg is less than the radius
 * @param[out] key        WCUT_KEYS_AT_CORNERS
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_keys_at_corners(wcut_vec3 block_size, double radius, double height, wcut_key *key);

/**
 * The kerf at every node of a cut, the job's width + per_q Q_eff with Q_eff = Q_I / v: Q_I the job's heat by its
 * programme, v the node's speed, at least the job's lowest one; station 0, which was not arrived at, has that of
 * station 1.
 *
 * @param[in]  job     that the history came from
 * @param[in]  history of that job, at least two stations
 * @param[out] field   history->stations x history->nodes [mm], for options->kerf_field
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_history_kerf(const wcut_job *job, const wcut_history *history, double *field);

#ifdef __cplusplus
}
#endif

#endif
