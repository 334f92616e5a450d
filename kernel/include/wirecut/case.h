/* wirecut/case.h - cuts that are looked at together: each a job, a recording and perhaps a scan. */
#ifndef WCUT_CASE_H
#define WCUT_CASE_H

#include <wirecut/export.h>
#include <wirecut/recording_file.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The files of a cut: paths that can be opened, with the folder of the case file in front. */
typedef struct wcut_case_cut {
    char *job;
    char *recording;
    char *scan; /**< NULL: not scanned */
} wcut_case_cut;

/** A case. */
typedef struct wcut_case {
    char *name;                   /**< UTF-8 */
    int cuts;                     /**< at least 1 */
    wcut_case_cut *cut;           /**< cuts */
    char *calibration;            /**< NULL: none */
    wcut_recording_format format; /**< how its recordings are read: "columns", "period_s" */
} wcut_case;

/**
 * Read a case file, "format": "wirecut-case/1". The files it names are not opened, and need not be there. A name is
 * relative to the case file and may not leave its folder: one that is empty, begins with / or has a part .. is refused;
 * symbolic links are followed. Keys that begin with x- are ignored, others unknown are
 * refused.
 *
 * @param[in]  path  a JSON file
 * @param[out] found the caller's, to wcut_case_destroy
 * @param[out] error may be NULL; the JSON path, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_case_read(const char *path, wcut_case **found, wcut_error *error);

/** Free a case with everything in it; NULL is allowed. */
WCUT_API void wcut_case_destroy(wcut_case *found);

enum { WCUT_FORMAT_SIZE = 64 }; /**< bytes of a format's name, with its final zero */

/**
 * What a JSON file says it is: its member "format".
 *
 * @param[in]  path   a JSON file
 * @param[out] format WCUT_FORMAT_SIZE bytes
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (no JSON object, or no such text in
 *         it), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_format_read(const char *path, char *format, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
