/* wirecut/statistics.h - figures of any number of signed deviations. */
#ifndef WCUT_STATISTICS_H
#define WCUT_STATISTICS_H

#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { WCUT_BANDS_MAX = 8 };

/** Figures of deviations; all 0 where there is none. */
typedef struct wcut_statistics {
    int count;
    double mean, std, rms, mae;          /**< [mm] std about the mean, of n - 1; mae: mean size */
    double median, p01, p05, p95, p99;   /**< [mm] to 6e-5 of their size or 1e-9 mm */
    double min, max;                     /**< [mm] exact */
    double hausdorff;                    /**< [mm] max |d|: from scan to face */
    double profile;                      /**< [mm] 2 max |d|: the width of the zone about the face that holds all */
    int positive, negative;              /**< deviations above and below 0 */
    double positive_mean, negative_mean; /**< [mm] of each part; 0 where it is empty */
    int bands;
    double band[WCUT_BANDS_MAX];   /**< [mm] tolerances */
    double within[WCUT_BANDS_MAX]; /**< [1] share with |d| <= band */
    double over[WCUT_BANDS_MAX];   /**< [1] share with d > band */
    double under[WCUT_BANDS_MAX];  /**< [1] share with d < -band */
} wcut_statistics;

/** Statistics in progress: sums, and a histogram whose bins grow with size; 11 MiB for any count. */
typedef struct wcut_histogram wcut_histogram;

/**
 * Begin statistics.
 *
 * @param[in]  bands 0 .. WCUT_BANDS_MAX
 * @param[in]  band  bands [mm] positive
 * @param[out] histogram the caller's, to wcut_histogram_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_histogram_create(int bands, const double *band, wcut_histogram **histogram);

/**
 * Add deviations.
 *
 * @param[in,out] histogram not in use by another thread
 * @param[in] count     0 or more; not more than INT_MAX in all
 * @param[in] deviation count [mm], finite
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was added.
 */
WCUT_API wcut_status wcut_histogram_add(wcut_histogram *histogram, int count, const double *deviation);

/**
 * The figures so far.
 *
 * @param[in]  histogram  with any number of deviations
 * @param[out] statistics all 0 where there is none
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_histogram_eval(const wcut_histogram *histogram, wcut_statistics *statistics);

/** Free a histogram; NULL is allowed. */
WCUT_API void wcut_histogram_destroy(wcut_histogram *histogram);

#ifdef __cplusplus
}
#endif

#endif
