/* wirecut/deviation_summary.h - statistics, zones and worst areas of all deviations of a scan, added piece by piece. */
#ifndef WCUT_DEVIATION_SUMMARY_H
#define WCUT_DEVIATION_SUMMARY_H

#include <wirecut/deviation.h>
#include <wirecut/export.h>
#include <wirecut/face.h>
#include <wirecut/statistics.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_WORST_MAX = 10, WCUT_ZONE_NAME = 32 };

/** How a scan is divided. */
typedef struct wcut_deviation_summary_options {
    wcut_vec3 low, high;         /**< [mm] the block, or the face's box; low < high in x and y */
    double patch;                /**< [mm] approximate side of the patches of the block; default 100; positive */
    double cell;                 /**< [mm] side of the smallest cell that worst areas consist of; default 1; positive */
    int bands;                   /**< 0 .. WCUT_BANDS_MAX; default 0 */
    double band[WCUT_BANDS_MAX]; /**< [mm] positive tolerances */
} wcut_deviation_summary_options;

/** A part of the cut, or a patch of the block, by the place of the feet. */
typedef struct wcut_zone {
    char name[WCUT_ZONE_NAME]; /**< "entry", "steady", "exit"; "patch 2 5": second from x = 0, fifth from y = 0 */
    int is_patch;
    wcut_vec3 low, high;           /**< [mm] of a patch its sides in x and y; of a part of the cut the feet's box */
    int count;                     /**< deviations; where it is 0 so is the rest */
    double mean, std, rms, mae;    /**< [mm] */
    double min, max;               /**< [mm] */
    double within[WCUT_BANDS_MAX]; /**< [1] share with |d| <= band */
} wcut_zone;

/** A connected area of cells whose mean deviations are of one sign and among the largest 5 % of the face. */
typedef struct wcut_worst {
    wcut_vec3 place;     /**< [mm] mean of its feet */
    wcut_vec3 low, high; /**< [mm] its box in x and y, of the feet in z */
    double area;         /**< [mm^2] of its cells seen along z */
    double volume;       /**< [mm^3] mean deviation times area: excess material, or missing material where negative */
    double mean;         /**< [mm] of its cells' means */
    double peak;         /**< [mm] the cell mean of largest size */
    int count;           /**< deviations */
} wcut_worst;

/** A deviation in three parts: one constant, what changes from cell to cell, and what changes within a cell. A cell's
    mean leaves out its lowest and its highest where it has four or more, the noise is a median over cells: outliers
    count in the statistics, not here. */
typedef struct wcut_split {
    double offset;       /**< [mm] mean of the cells' means, whatever the scan's density */
    double offset_error; /**< [mm] standard error of it by the noise alone */
    double form_rms;     /**< [mm] of the cells' means about it, less their own noise */
    double noise_rms;    /**< [mm] of deviations about their cell's mean, median over the cells */
    double cell;         /**< [mm] side of a cell: doubled until half of them hold 8 points */
    int cells;           /**< with two points or more */
} wcut_split;

/** Correlation of deviations with another quantity: Pearson's r, 0 where either is constant. */
typedef struct wcut_relation {
    double of_deviation; /**< of d */
    double of_size;      /**< of |d| */
} wcut_relation;

/** What a summary found. */
typedef struct wcut_deviation_summary_result {
    wcut_statistics statistics;
    int place[WCUT_PLACE_COUNT]; /**< points at each place; inside and border are in the figures */
    int zones;
    const wcut_zone *zone; /**< parts of the cut where a face is known, then patches row by row */
    int worsts;
    const wcut_worst *worst; /**< by size of volume */
    wcut_split split;
    int related;                    /**< 1: the relations are known, because the face is */
    wcut_relation time, path, bend; /**< time since entry, curvature of the path, size of the face's curvature */
} wcut_deviation_summary_result;

/** A summary in progress; memory does not grow with the count of points. */
typedef struct wcut_deviation_summary wcut_deviation_summary;

/** The defaults stated at the fields. */
WCUT_API wcut_deviation_summary_options wcut_deviation_summary_options_default(void);

/**
 * Begin a summary.
 *
 * @param[in]  options
 * @param[in]  face    that the deviations are from, borrowed; NULL: unknown, deviations from a mesh
 * @param[out] summary  the caller's, to wcut_deviation_summary_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also more than 10000 patches), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_summary_create(const wcut_deviation_summary_options *options, const wcut_face *face,
                                                   wcut_deviation_summary **summary);

/**
 * Add deviations.
 *
 * @param[in,out] summary   not in use by another thread
 * @param[in] count     0 or more; not more than INT_MAX in all
 * @param[in] deviation count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was added.
 */
WCUT_API wcut_status wcut_deviation_summary_add(wcut_deviation_summary *summary, int count,
                                                const wcut_deviation *deviation);

/**
 * What was found so far.
 *
 * @param[out] result borrowed until the next call with this summary
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_summary_eval(wcut_deviation_summary *summary,
                                                 const wcut_deviation_summary_result **result);

/** Free a summary; NULL is allowed. */
WCUT_API void wcut_deviation_summary_destroy(wcut_deviation_summary *summary);

#ifdef __cplusplus
}
#endif

#endif
