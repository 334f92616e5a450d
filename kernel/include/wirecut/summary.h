/* wirecut/summary.h - a cut in a few figures. */
#ifndef WCUT_SUMMARY_H
#define WCUT_SUMMARY_H

#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Least and greatest of something over the stations. */
typedef struct wcut_range {
    double min, max;
} wcut_range;

/** Figures over every station that the wire moved to (station 0 where there is no other). */
typedef struct wcut_summary {
    double duration;        /**< [s] */
    wcut_range speed;       /**< [mm/s] of the faster mount */
    double speed_median;    /**< [mm/s] */
    wcut_range alpha, beta; /**< [rad] of both mounts */
    wcut_range tension;     /**< [N] of both mounts */
    double force_line_max;  /**< [N/mm] over all nodes */
    double residual_max;    /**< [1] */
    double iterations_mean; /**< Newton iterations a station */
    int iterations_max;
    double substeps_mean;
    int substeps_max;
    int conditions[WCUT_CONDITION_TIME + 1]; /**< stations by what set their rate */
    int phases[WCUT_PHASE_LEFT + 1];         /**< stations by phase */
} wcut_summary;

/**
 * Sum a history up.
 *
 * @param[in]  history at least one station
 * @param[out] summary
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_summary_eval(const wcut_history *history, wcut_summary *summary);

#ifdef __cplusplus
}
#endif

#endif
