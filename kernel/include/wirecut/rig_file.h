/* wirecut/rig_file.h - control.json: the figures of a closed loop out (libwirecut-io). */
#ifndef WCUT_RIG_FILE_H
#define WCUT_RIG_FILE_H

#include <wirecut/export.h>
#include <wirecut/rig.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The text of `control.json`, "format": "wirecut-control/1".
 *
 * @param[in]  summary every pointer set
 * @param[out] text    the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_rig_summary_print(const wcut_rig_summary *summary, char **text);

/**
 * Write `control.json`: the same text into a file.
 *
 * @param[in]  summary every pointer set
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_rig_summary_write(const wcut_rig_summary *summary, const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
