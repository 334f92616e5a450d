/* CSV text in memory to a table: what the file readers and the fuzzer share. */
#ifndef WCUT_IO_FILE_CSV_H
#define WCUT_IO_FILE_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/table.h>

/* limits beyond which it is a slip of the pen, not a recording */
enum { WCUT_CSV_COLUMNS_MAX = 1000 };
#define WCUT_CSV_BYTES_MAX ((size_t)512 << 20)

/* wcut_table_read of a text of `length` bytes and a zero behind them; label stands in front of every message */
wcut_status wcut_csv_parse(const char *text, size_t length, const char *label, int numeric_count,
                           const char *const *numeric, wcut_table **table, wcut_error *error);

/* The same, every column tolerates text, and each field that is text (neither a number nor empty nor nan) is handed on,
   row by row; row and column from 0, in a row the column ascending. WCUT_NO_MEMORY where it is false. */
typedef bool wcut_csv_text(void *context, int row, int column, const char *text);
wcut_status wcut_csv_parse_texts(const char *text, size_t length, const char *label, wcut_csv_text *take, void *context,
                                 wcut_table **table, wcut_error *error);

#endif
