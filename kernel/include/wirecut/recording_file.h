/* wirecut/recording_file.h - recordings in and out (libwirecut-io). */
#ifndef WCUT_RECORDING_FILE_H
#define WCUT_RECORDING_FILE_H

#include <wirecut/export.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A column of another program's file that a channel is read from: channel = factor column + offset, in the unit of the
   channel's name. */
typedef struct wcut_column_map {
    wcut_channel channel;
    char *column;  /**< its name in the file's header */
    double factor; /**< finite, not 0; default 1 */
    double offset; /**< finite, in the channel's unit; default 0 */
} wcut_column_map;

/** How the file of a recording is read; all zero: columns are named as the channels are. */
typedef struct wcut_recording_format {
    int maps;             /**< at least 0 */
    wcut_column_map *map; /**< maps, each channel at most once */
    double
        period; /**< [s] constant time between rows where the file has no clock: row i is at i period; 0: it has one */
} wcut_recording_format;

/**
 * A column map from a text, "time_s=timestamp,force_x_N=Fx*0.001,x_mm=px*1000+600": CHANNEL=COLUMN, then perhaps *FACTOR,
 * then perhaps +OFFSET or -OFFSET, separated by commas.
 *
 * @param[in]  text   maps; "" gives none
 * @param[out] format period 0; the caller's, to wcut_recording_format_clear
 * @param[out] error  may be NULL; the part, what was expected
 * @return WCUT_OK; WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_recording_format_parse(const char *text, wcut_recording_format *format, wcut_error *error);

/** Free the maps of a format and make it all zero; NULL is allowed. */
WCUT_API void wcut_recording_format_clear(wcut_recording_format *format);

/**
 * Read a recording. Angles are turned from degrees into radians. Samples may be missing in every channel but time
 * (a channel of which every sample is missing has channel[].missing == samples); stations outside the path are kept. A
 * row that repeats the one before it in every cell, as loggers write them, is left out where the file has a clock. A
 * file with a column force_x_N, force_y_N or force_z_N is one of a tool with a force sensor.
 *
 * @param[in]  path      a CSV file
 * @param[in]  format    how it is read; NULL: columns are named as the channels are
 * @param[out] recording the caller's, to wcut_recording_destroy
 * @param[out] error     may be NULL; line and column, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (as wcut_table_read; columns missing or
 *         in another unit, no samples, time missing or not strictly increasing, a column of the format that is not
 *         there, a period beside a clock), WCUT_BAD_ARGUMENT (a format outside its ranges, too), WCUT_NO_MEMORY: nothing
 *         was written.
 */
WCUT_API wcut_status wcut_recording_read(const char *path, const wcut_recording_format *format,
                                         wcut_recording **recording, wcut_error *error);

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
