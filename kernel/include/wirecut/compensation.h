/* wirecut/compensation.h - paths corrected so that what the machine cuts comes out as it is wanted. */
#ifndef WCUT_COMPENSATION_H
#define WCUT_COMPENSATION_H

#include <wirecut/design.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Corrected paths, and what they are worth. */
typedef struct wcut_compensation {
    wcut_job *job;                 /**< mode path: the job's mounts' way, corrected; its effects are left as they are */
    double before_rms, before_max; /**< [mm] of the target's points from the face that the job cuts */
    double after_rms, after_max;   /**< [mm] the same of the corrected job */
    int used, strays, uncovered;   /**< points, as in wcut_design */
    int branch; /**< station from which on the corrected wire bows to the other side than it did before: another solution
                     of first contact; -1: nowhere */
    int runs;   /**< simulations in all */
    int rounds;
    wcut_design_round *round; /**< rounds */
    int stations;             /**< of the job */
    double *nearer;           /**< stations [mm] by which the mounts' distance gets less, set along x */
    double *lag;              /**< stations [mm] by which mount A leads mount B more than before */
    double *rise_a, *rise_b;  /**< stations [mm] of the mounts */
} wcut_compensation;

/**
 * Correct the mounts' heights, their lag and their distance over the stations so that the face that the job cuts, with its
 * kerf and its effects, comes nearest to a target: Levenberg-Marquardt on splines, with the derivatives of the run.
 *
 * @param[in]  target   in the job's block; a job's own planned face where its effects are to be compensated
 * @param[in]  job      of either mode; its effects are what the machine does
 * @param[in]  options  NULL for the defaults; feed, free_edges and angle_max are not looked at
 * @param[in]  progress may be NULL
 * @param[in]  context  handed to progress
 * @param[out] out      the caller's, to wcut_compensation_destroy
 * @param[out] error    may be NULL
 * @return WCUT_OK, whether it gained much or not: see after_rms; WCUT_INTERRUPTED: the best so far is handed out;
 *         the statuses of wcut_setup_create and of wcut_setup_run, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_compensation_fit(const wcut_design_target *target, const wcut_job *job,
                                           const wcut_design_options *options, wcut_design_progress progress,
                                           void *context, wcut_compensation **out, wcut_error *error);

/**
 * How far a target's points are from the face that a job cuts, with its kerf and effects.
 *
 * @param[in]  target in the job's block
 * @param[in]  job    of either mode
 * @param[in]  threads 1 or more; the result does not depend on it
 * @param[out] rms    [mm] of the points over the face
 * @param[out] max    [mm]
 * @param[out] error  may be NULL
 * @return WCUT_OK; the statuses of wcut_setup_create and of wcut_setup_run, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing
 *         was written.
 */
WCUT_API wcut_status wcut_compensation_measure(const wcut_design_target *target, const wcut_job *job, int threads,
                                               double *rms, double *max, wcut_error *error);

/** Free a compensation; NULL is allowed. */
WCUT_API void wcut_compensation_destroy(wcut_compensation *compensation);

#ifdef __cplusplus
}
#endif

#endif
