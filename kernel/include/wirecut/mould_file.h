/* wirecut/mould_file.h - the figures of a divided block out (libwirecut-io). */
#ifndef WCUT_MOULD_FILE_H
#define WCUT_MOULD_FILE_H

#include <wirecut/export.h>
#include <wirecut/mould.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * `mould.json`, "wirecut-mould/1" (FORMATS.md, Mould).
 *
 * @param[in]  mould from wcut_mould_create
 * @param[in]  name  of the job, UTF-8
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mould_write(const wcut_mould *mould, const char *name, const char *path, wcut_error *error);

/**
 * The text of `mould.json`: the caller's, to free(); ends with a line feed.
 *
 * @param[in]  mould from wcut_mould_create
 * @param[in]  name  of the job, UTF-8
 * @param[out] text  the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mould_print(const wcut_mould *mould, const char *name, char **text);

#ifdef __cplusplus
}
#endif

#endif
