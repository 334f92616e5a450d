/* CSV text, read through a window, to a table: what the file readers and the fuzzer share. */
#ifndef WCUT_IO_FILE_CSV_H
#define WCUT_IO_FILE_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/table.h>

#include "io/file/stream.h"

/* limits beyond which it is a slip of the pen, not a recording: of a file's columns, and of rows times columns (2 GiB) */
enum { WCUT_CSV_COLUMNS_MAX = 1000, WCUT_CSV_VALUES_MAX = 1 << 28 };

/* wcut_table_read of an open stream, which stays the caller's; a row fits into its window. The label stands in front of
   every message. Memory: the window and the table. */
wcut_status wcut_csv_read(wcut_stream *stream, const char *label, int numeric_count, const char *const *numeric,
                          wcut_table **table, wcut_error *error);

/* the same of bytes in memory, through a window of the given size; for tests and fuzzers */
wcut_status wcut_csv_parse(const char *text, size_t length, size_t window, const char *label, int numeric_count,
                           const char *const *numeric, wcut_table **table, wcut_error *error);

/* The same through a window of the usual size; every column tolerates text, and each field that is text (neither a number nor empty nor nan) is handed on,
   row by row; row and column from 0, in a row the column ascending. WCUT_NO_MEMORY where it is false. */
typedef bool wcut_csv_text(void *context, int row, int column, const char *text);
wcut_status wcut_csv_parse_texts(const char *text, size_t length, const char *label, wcut_csv_text *take, void *context,
                                 wcut_table **table, wcut_error *error);

#endif
