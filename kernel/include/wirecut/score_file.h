/* wirecut/score_file.h - scores and residuals out (libwirecut-io). */
#ifndef WCUT_SCORE_FILE_H
#define WCUT_SCORE_FILE_H

#include <wirecut/export.h>
#include <wirecut/score.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * score.json as text: "wirecut-score/1" (FORMATS.md, Score).
 *
 * @param[in]  n       at least 1
 * @param[in]  cut     n; cuts of one case stand together
 * @param[in]  options that they were compared with, NULL for the defaults
 * @param[out] text    the caller's, to free()
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_score_print(int n, const wcut_scored_cut *cut, const wcut_comparison_options *options,
                                      char **text);

/**
 * Write score.json: the text of wcut_score_print into a file.
 *
 * @param[in]  n       at least 1
 * @param[in]  cut     n
 * @param[in]  options that they were compared with, NULL for the defaults
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_score_write(int n, const wcut_scored_cut *cut, const wcut_comparison_options *options,
                                      const char *path, wcut_error *error);

/**
 * residuals.csv: a row a sample with time, station, phase, whether it counts, and for every channel what was measured,
 * planned and replayed, and the residuals, measured less predicted. What is missing is an empty field.
 *
 * @param[in]  n     at least 1
 * @param[in]  cut   n; those that failed have no rows
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_residuals_write(int n, const wcut_scored_cut *cut, const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
