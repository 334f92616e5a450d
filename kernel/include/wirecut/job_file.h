/* wirecut/job_file.h - jobs in and out (libwirecut-io). */
#ifndef WCUT_JOB_FILE_H
#define WCUT_JOB_FILE_H

#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read a job file, "format": "wirecut-job/1". Keys that begin with x- are ignored, others unknown are refused.
 *
 * @param[in]  path  a JSON file
 * @param[out] job   the caller's, to wcut_job_destroy
 * @param[out] error may be NULL; the JSON path, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT,
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_job_read(const char *path, wcut_job **job, wcut_error *error);

/**
 * Write a job file; numbers are the shortest that read back the same.
 *
 * @param[in]  job   a job that wcut_setup_create would accept
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_job_write(const wcut_job *job, const char *path, wcut_error *error);

/**
 * Take the process laws of a calibration, `force_law.json` of wcut_force_law_print, in the place of the job's own.
 *
 * @param[in,out] job
 * @param[in]     path  the file; a tension law that it does not have leaves the job without one
 * @param[out]    error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_BAD_FORMAT, WCUT_NOT_FOUND, WCUT_NO_MEMORY: the job is as it was.
 */
WCUT_API wcut_status wcut_job_read_force_law(wcut_job *job, const char *path, wcut_error *error);

/**
 * Take the two edges of a design from a file of curves, as a CAD program writes it: STEP, IGES, JSON or CSV
 * (wcut_curve_set_read). The curve of lower x becomes that of mount A, and each is turned, if necessary, to run with
 * the feed.
 *
 * @param[in,out] job   in design mode
 * @param[in]     path  a file that holds two curves
 * @param[out]    error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a job in path mode), WCUT_BAD_FORMAT (not two curves, and as
 *         wcut_curve_set_read), WCUT_NOT_FOUND, WCUT_NO_MEMORY: the job is as it was.
 */
WCUT_API wcut_status wcut_job_read_edges(wcut_job *job, const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
