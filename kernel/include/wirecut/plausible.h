/* wirecut/plausible.h - whether a recording can be of its job in the units that its columns state. */
#ifndef WCUT_PLAUSIBLE_H
#define WCUT_PLAUSIBLE_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The most doubts about a recording. */
enum { WCUT_DOUBTS_MAX = 6 };

/** A contradiction between a recording and its job. */
typedef struct wcut_doubt {
    wcut_channel channel; /**< the first of the columns that are meant */
    double ratio;         /**< [1] found over expected */
    bool certain;         /**< too far off for any machine: the recording cannot be used */
    wcut_error error;     /**< its text: columns, figures, the likely unit */
} wcut_doubt;

/**
 * Check a recording against its job for consistency:
 *
 * - the way of mount A at the recorded stations over the time against speed_a_mm_s (path mode; off by more than 1.3;
 *   certain by more than 5, as of a clock in ms, us, ns or min);
 * - measured places of mount A against the path (path mode; off by more than a quarter of the block);
 * - mean tensions against the job's (negative, or off by more than 5), mean heat alike;
 * - mean angles against the balance 2 T sin(alpha) = F L of the job's law (radians for degrees).
 *
 * @param[in]  job
 * @param[in]  recording at least one sample
 * @param[out] count     0 .. WCUT_DOUBTS_MAX
 * @param[out] doubt     WCUT_DOUBTS_MAX, of which count are written
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_recording_check(const wcut_job *job, const wcut_recording *recording, int *count,
                                          wcut_doubt *doubt);

#ifdef __cplusplus
}
#endif

#endif
