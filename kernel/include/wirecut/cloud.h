/* wirecut/cloud.h - point clouds of a scanned face: reading, units, thinning, cleaning, normals. */
#ifndef WCUT_CLOUD_H
#define WCUT_CLOUD_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a cloud is stored. */
typedef enum wcut_cloud_format {
    WCUT_CLOUD_FORMAT_ANY,  /**< by the first bytes; an STL without "solid", OBJ and OFF by the name's ending */
    WCUT_CLOUD_FORMAT_PLY,  /**< ascii, binary of either byte order */
    WCUT_CLOUD_FORMAT_TEXT, /**< XYZ, PTS, ASC, CSV: a point a line */
    WCUT_CLOUD_FORMAT_STL,  /**< the corners of its triangles, so that most come several times; no normals */
    WCUT_CLOUD_FORMAT_LAS,  /**< 1.0 to 1.4, point formats 0 to 10, not compressed */
    WCUT_CLOUD_FORMAT_PCD,  /**< ascii, binary or compressed (LZF); the viewpoint is not applied */
    WCUT_CLOUD_FORMAT_OBJ,  /**< its vertices, whatever its faces are; no normals */
    WCUT_CLOUD_FORMAT_OFF,  /**< the same */
    /** glTF, by assimp in a process of its own: the vertices of every node, held as a whole, at most 20000000; it is in
        metres with y upwards, and becomes mm with z upwards whatever the option unit says */
    WCUT_CLOUD_FORMAT_GLTF,
    WCUT_CLOUD_FORMAT_PTX, /**< scans in sequence, each moved by its matrix; beams without a hit are withheld */
    WCUT_CLOUD_FORMAT_COUNT
} wcut_cloud_format;

/** What a source has given so far. */
typedef struct wcut_cloud_info {
    wcut_cloud_format format; /**< as found, never WCUT_CLOUD_FORMAT_ANY */
    int has_normals;          /**< 1 where the file has them */
    double unit;              /**< [mm] of the file's unit, as it states it or the options do */
    int stated;               /**< points that the header states, and the file must hold; -1: it states none */
    int read;                 /**< points handed out */
    int not_finite;           /**< points left out since a coordinate is NaN or infinite: scanners write misses so */
    int withheld;             /**< points left out since the file itself says so (LAS) */
    int thinned;              /**< points left out by wcut_cloud_read for its option voxel */
    wcut_vec3 low, high;      /**< [mm] the box of the points handed out; 0 before the first */
} wcut_cloud_info;

/** A cloud in memory. */
typedef struct wcut_cloud {
    int count;            /**< 1 or more */
    wcut_vec3 *point;     /**< count [mm] */
    wcut_vec3 *normal;    /**< count [1] of length 1, or 0 where the file has none for a point; NULL: none at all */
    wcut_cloud_info info; /**< of the file it came from */
} wcut_cloud;

/** How a cloud's size compares with the block's. */
typedef struct wcut_cloud_unit {
    double ratio;  /**< [1] diagonal of the cloud's box over that of the block's W x L */
    double factor; /**< [1] what its coordinates should be multiplied by: 1 where the sizes agree (ratio 0.2 to 1.5),
                      else the one of 10, 25.4, 1000 and their inverses that comes nearest to ratio 1, within 0.5
                      to 1.25; 0 where none does */
} wcut_cloud_unit;

/**
 * Compare a cloud's size with the block's, to notice a wrong unit.
 *
 * @param[in]  low, high  [mm] the cloud's box; low <= high
 * @param[in]  block_size [mm] W, L, H; positive
 * @param[out] fit        ratio and factor
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_cloud_unit_eval(wcut_vec3 low, wcut_vec3 high, wcut_vec3 block_size, wcut_cloud_unit *fit);

/**
 * Whether a cloud can be a scan of a face at all.
 *
 * @param[in]  count points, 1 or more
 * @param[in]  point count [mm], finite, up to 1e12
 * @param[out] span  0: all of them in one place; 1: on one line; 2: neither
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_cloud_span(int count, const wcut_vec3 *point, int *span);

/** Thinning as points come in: the first point of each cube of a lattice through the origin stays. */
typedef struct wcut_thinning wcut_thinning;

/**
 * Begin to thin.
 *
 * @param[in]  voxel    [mm] side of a cube, 1e-3 or more
 * @param[out] thinning the caller's, to wcut_thinning_destroy; 16 to 43 bytes for each cube that holds a point
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_thinning_create(double voxel, wcut_thinning **thinning);

/**
 * Thin further points.
 *
 * @param[in,out] thinning not in use by another thread
 * @param[in]  count 0 or more
 * @param[in]  point count [mm], finite, up to 1e12
 * @param[out] keep  count: 1: the first of its cube in all calls, 0: not
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written; WCUT_NO_MEMORY: keep is not to be used, nor the thinning.
 */
WCUT_API wcut_status wcut_thinning_add(wcut_thinning *thinning, int count, const wcut_vec3 *point, unsigned char *keep);

/** Free a thinning; NULL is allowed. */
WCUT_API void wcut_thinning_destroy(wcut_thinning *thinning);

/** Why a point was removed, in the order of the steps. */
typedef enum wcut_removal {
    WCUT_REMOVAL_KEPT,
    WCUT_REMOVAL_DUPLICATE, /**< as near as `duplicate` to a kept point before it */
    WCUT_REMOVAL_ISOLATED,  /**< fewer than `radius_min` others within `radius` */
    WCUT_REMOVAL_OUTLIER,   /**< further from its neighbours than points of this cloud are */
    WCUT_REMOVAL_THINNED,   /**< not the first in its cube of side `voxel` */
    WCUT_REMOVAL_COUNT
} wcut_removal;

/** What is removed. */
typedef struct wcut_clean_options {
    double duplicate;  /**< [mm] default 0: only equal points; negative: none */
    double radius;     /**< [mm] default 0: no point is isolated */
    int radius_min;    /**< default 4; 1 or more */
    int neighbours;    /**< k, to whose mean distance a point is held; default 10, up to 128; 0: no point is an
                            outlier. Outliers in clusters of more than k are not noticed */
    double deviations; /**< m; default 6; not negative */
    double factor_min; /**< [1] default 3; 0 or more */
    int robust;        /**< default 1: centre and scale are median and 1.4826 MAD; 0: mean and standard deviation, which
                            far outliers move */
    double voxel;      /**< [mm] default 0: not thinned; else 1e-3 or more */
} wcut_clean_options;

/** What was removed. */
typedef struct wcut_clean_report {
    int removed[WCUT_REMOVAL_COUNT]; /**< by cause; removed[WCUT_REMOVAL_KEPT] points are left */
    double centre, scale;            /**< [mm] of the mean distance to the neighbours; 0 without that step */
    double limit;                    /**< [mm] an outlier's is greater; 0 without that step */
} wcut_clean_report;

/** The defaults stated at the fields. */
WCUT_API wcut_clean_options wcut_clean_options_default(void);

/**
 * Find the points of a cloud that do not belong to the scanned face, without changing it:
 *
 *     outlier:  d_i > max(centre + m scale, factor_min centre),   d_i the mean distance to the k nearest   (Rusu 2008)
 *
 * The second bound is there for regular scans, whose scale is almost 0: at their corners d_i is twice that of the
 * inside. Isolated points and outliers are both judged in what is left without duplicates.
 *
 * @param[in]  count   points, 1 or more
 * @param[in]  point   count [mm], finite, up to 1e12
 * @param[in]  options NULL for the defaults
 * @param[in]  threads 1 or more; the result does not depend on it
 * @param[out] removal count wcut_removal
 * @param[out] report  may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (every point is removed, or too few are left for the neighbours asked for),
 *         WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_cloud_clean(int count, const wcut_vec3 *point, const wcut_clean_options *options, int threads,
                                      unsigned char *removal, wcut_clean_report *report);

/**
 * Move the kept rows of an array to its front, in their order.
 *
 * @param[in]     count   rows, 0 or more
 * @param[in]     removal count, as wcut_cloud_clean gives
 * @param[in,out] row     count points or normals
 * @return rows kept; 0 where an argument is NULL or negative.
 */
WCUT_API int wcut_cloud_keep(int count, const unsigned char *removal, wcut_vec3 *row);

/** How normals are found. */
typedef struct wcut_normals_options {
    int neighbours; /**< k nearest points and the point itself make the plane; default 16; 2 to 128 */
    wcut_vec3 side; /**< the removed half is there; default +z, right for the lower half; not 0 */
    double steep; /**< [1] in 0 .. 1: where |n . side| is at least that, the side decides a normal's sign; a steeper one
                       follows its neighbours (Hoppe 1992). Default 0.5; 1: each connected sheet is turned as a whole,
                       which takes longer and is also right under overhangs */
} wcut_normals_options;

/** What was found. */
typedef struct wcut_normals_report {
    int undefined;  /**< points whose neighbours are on one line or in one place: their normal is 0 */
    int propagated; /**< points whose sign came from their neighbours */
    int guessed;    /**< of these, the starts of connected pieces that are steep throughout: turned to the side */
} wcut_normals_report;

/** The defaults stated at the fields. */
WCUT_API wcut_normals_options wcut_normals_options_default(void);

/**
 * Normals of a cloud: for each point the direction in which its k nearest points vary least (Pearson 1901), turned
 * towards the removed half.
 *
 * @param[in]  count   points, 3 or more
 * @param[in]  point   count [mm], finite, up to 1e12
 * @param[in]  options NULL for the defaults
 * @param[in]  threads 1 or more; the result does not depend on it
 * @param[out] normal  count [1]
 * @param[out] report  may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (no point has a normal: all are on one line or in one place), WCUT_BAD_ARGUMENT,
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_cloud_normals(int count, const wcut_vec3 *point, const wcut_normals_options *options,
                                        int threads, wcut_vec3 *normal, wcut_normals_report *report);

#ifdef __cplusplus
}
#endif

#endif
