/* wirecut/rig_prior_file.h - what a cell knows of its own rig, from a file (libwirecut-io). */
#ifndef WCUT_RIG_PRIOR_FILE_H
#define WCUT_RIG_PRIOR_FILE_H

#include <wirecut/diagnosis.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read "wirecut-rig/1" (FORMATS.md, Rig): what it does not name is that of an ordinary cell. Keys that begin with x- are
 * ignored, others unknown are refused.
 *
 * @param[in]  path  a JSON file
 * @param[out] prior what a diagnosis takes as its options' rig
 * @param[out] error may be NULL; the JSON path, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT (a width of 0 or
 *         less), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_rig_prior_read(const char *path, wcut_rig_prior *prior, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
