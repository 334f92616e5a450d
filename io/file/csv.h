/* CSV text in memory to a table: what the file readers and the fuzzer share. */
#ifndef WCUT_IO_FILE_CSV_H
#define WCUT_IO_FILE_CSV_H

#include <stddef.h>
#include <wirecut/table.h>

/* limits beyond which it is a slip of the pen, not a recording */
enum { WCUT_CSV_COLUMNS_MAX = 1000 };
#define WCUT_CSV_BYTES_MAX ((size_t)512 << 20)

/* wcut_table_read of a text of `length` bytes and a zero behind them; label stands in front of every message */
wcut_status wcut_csv_parse(const char *text, size_t length, const char *label, int numeric_count,
                           const char *const *numeric, wcut_table **table, wcut_error *error);

#endif
