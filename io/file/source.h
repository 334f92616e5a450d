/* A file that is read byte by byte or line by line: what the readers of meshes and clouds share. */
#ifndef WCUT_IO_SOURCE_H
#define WCUT_IO_SOURCE_H

#include <stdbool.h>
#include <stdint.h>

#include "io/file/stream.h"

/* x y z nx ny nz */
enum { WCUT_FIELDS = 6 };

/* [mm] a coordinate beyond this is no part: the earth's centre is nearer, in mm, than 1e10 */
static const double WCUT_COORDINATE_FAR = 1e12;

typedef struct wcut_source {
    wcut_stream stream;
    char *label;        /* the file's name, in front of every refusal */
    wcut_error failure; /* the first refusal; it stays */
    long line;          /* of the first unread byte, from 1; 0: the format has no lines */
    bool binary;        /* numbers have a byte order that could be the wrong one */
    double scale;       /* [mm] of the file's unit */
    char ending;        /* of its lines, the last byte of one: a feed or a return; 0: not known yet */
} wcut_source;

/* WCUT_OK: to wcut_source_close. WCUT_NOT_FOUND, WCUT_NO_MEMORY: nothing to close */
wcut_status wcut_source_open(const char *path, wcut_source *source, wcut_error *error);

/* the same of bytes in memory, through a window of the given size; for tests and fuzzers */
wcut_status wcut_source_open_memory(const void *bytes, size_t size, size_t window, const char *label,
                                    wcut_source *source, wcut_error *error);

void wcut_source_close(wcut_source *source);

/* ---- each of these refuses the file and gives false; the first refusal stays ---- */

/* "LABEL: byte 12: ..." or "LABEL: line 3: ..." where lines are counted */
bool wcut_source_refuse(wcut_source *source, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* for want of memory */
bool wcut_source_refuse_memory(wcut_source *source);

/* the file ends where more is expected, or could not be read on */
bool wcut_source_refuse_end(wcut_source *source, const char *expected);

/* the file ends with `left` of the stated records missing */
bool wcut_source_refuse_truncated(wcut_source *source, int64_t left, const char *what);

/* the line at `line` for the text at `at`: "LABEL: line 3, column 7: found X, expected ..." */
bool wcut_source_refuse_text(wcut_source *source, const char *line, const char *at, const char *expected);

/* ---- checks: false means refused ---- */

/* nothing follows but blanks, line ends and zeros, or, in binary, less than a record of that size */
bool wcut_source_check_end(wcut_source *source, size_t record);

/* a header's count: at least `size` bytes each fit into the file, and an int counts them */
bool wcut_source_check_count(wcut_source *source, int64_t count, uint64_t size, const char *what);

#endif
