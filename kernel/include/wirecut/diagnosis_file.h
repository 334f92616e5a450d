/* wirecut/diagnosis_file.h - a diagnosis out, as text or as a file (libwirecut-io). */
#ifndef WCUT_DIAGNOSIS_FILE_H
#define WCUT_DIAGNOSIS_FILE_H

#include <wirecut/diagnosis.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * diagnosis.json as text: as wcut_diagnosis_write.
 *
 * @param[out] text the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_diagnosis_print(const wcut_diagnosis *diagnosis, const char *name, char **text);

/**
 * diagnosis.json: "wirecut-diagnosis/1" (FORMATS.md, Diagnosis).
 *
 * @param[in]  diagnosis
 * @param[in]  name  of the case
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_diagnosis_write(const wcut_diagnosis *diagnosis, const char *name, const char *path,
                                          wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
