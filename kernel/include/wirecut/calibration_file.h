/* wirecut/calibration_file.h - calibration tables in, force laws out (libwirecut-io). */
#ifndef WCUT_CALIBRATION_FILE_H
#define WCUT_CALIBRATION_FILE_H

#include <wirecut/calibration.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read a calibration table: heat_W_per_m, speed_mm_s, engaged_mm, tension_N, alpha_deg, one row a test cut; tension and
 * deflection are those of both mounts.
 *
 * @param[in]  path   a CSV file
 * @param[in]  weight the name of a further column with the weights of the cuts; NULL: all 1
 * @param[out] n      cuts, not negative
 * @param[out] cut    n, the caller's, to wcut_test_cut_destroy
 * @param[out] error  may be NULL; line and column, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (as wcut_table_read; columns missing or
 *         in another unit; a value missing or outside its range), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_calibration_table_read(const char *path, const char *weight, int *n, wcut_test_cut **cut,
                                                 wcut_error *error);

/** Free what wcut_calibration_table_read gave; NULL is allowed. */
WCUT_API void wcut_test_cut_destroy(wcut_test_cut *cut);

/**
 * Write `force_law.json`: the blocks "force_law" and "tension_law" of a job with their standard errors, covariances and
 * range of Q_eff, the reference pair, the tests, and a list of residuals.
 *
 * @param[in]  n           cuts, at least 1
 * @param[in]  cut         n
 * @param[in]  options     that the fit was made with; NULL for the defaults
 * @param[in]  calibration of these cuts
 * @param[in]  point       n
 * @param[in]  path        the target, replaced whole or not at all
 * @param[out] error       may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_force_law_write(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                          const wcut_calibration *calibration, const wcut_calibration_point *point,
                                          const char *path, wcut_error *error);

/**
 * The text of `force_law.json`.
 *
 * @param[in]  n           cuts, at least 1
 * @param[in]  cut         n
 * @param[in]  options     that the fit was made with; NULL for the defaults
 * @param[in]  calibration of these cuts
 * @param[in]  point       n
 * @param[out] text the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_force_law_print(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                          const wcut_calibration *calibration, const wcut_calibration_point *point,
                                          char **text);

#ifdef __cplusplus
}
#endif

#endif
