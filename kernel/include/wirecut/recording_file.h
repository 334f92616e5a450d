/* wirecut/recording_file.h - recordings in and out (libwirecut-io). */
#ifndef WCUT_RECORDING_FILE_H
#define WCUT_RECORDING_FILE_H

#include <wirecut/export.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Read a recording. Angles are turned from degrees into radians. Samples may be missing in every channel but time
 * (a channel of which every sample is missing has channel[].missing == samples); stations outside the path are kept. A row
 * that repeats the one before it in every cell, as loggers write them, is left out.
 *
 * @param[in]  path      a CSV file
 * @param[out] recording the caller's, to wcut_recording_destroy
 * @param[out] error     may be NULL; line and column, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (as wcut_table_read; columns missing or
 *         in another unit, no samples, time missing or not strictly increasing), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_recording_read(const char *path, wcut_recording **recording, wcut_error *error);

/** Free a recording with everything in it; NULL is allowed. */
WCUT_API void wcut_recording_destroy(wcut_recording *recording);

/**
 * Write a recording as FORMATS.md, Recording, describes it: the channels it has, angles in degrees, numbers as the
 * sensors of such a rig resolve them (time 1e-4 s, angles 1e-3 deg, others 1e-4).
 *
 * @param[in]  recording at least one sample, every required channel; `further` is not written
 * @param[in]  note      one line for a comment at the top; may be NULL
 * @param[in]  path      the target, replaced whole or not at all
 * @param[out] error     may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (time that does not increase as printed, too), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN:
 *         the target is as it was.
 */
WCUT_API wcut_status wcut_recording_write(const wcut_recording *recording, const char *note, const char *path,
                                          wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
