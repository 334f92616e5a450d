/* CSV text in memory to a table: what the file readers and the fuzzer share. */
#ifndef WCUT_IO_FILE_CSV_H
#define WCUT_IO_FILE_CSV_H

#include <stdbool.h>
#include <stddef.h>
#include <wirecut/table.h>

/* limits beyond which it is a slip of the pen, not a recording */
enum { WCUT_CSV_COLUMNS_MOST = 1000 };
#define WCUT_CSV_BYTES_MOST ((size_t)1 << 36)

/* wcut_table_read of a text of `length` bytes and a zero behind them; label stands in front of every message */
wcut_status wcut_csv_parse(const char *text, size_t length, const char *label, int numeric_count,
                           const char *const *numeric, wcut_table **table, wcut_error *error);

/* a column that a format knows: its name is stem, "_" and unit, or the stem alone where unit is "" */
typedef struct wcut_known_column {
    const char *name, *stem, *unit;
    bool required;
} wcut_known_column;

/* WCUT_OK where every required column is there and none of the known ones is given in another unit; else
   WCUT_BAD_FORMAT with all the names */
wcut_status wcut_columns_check(const wcut_table *table, int count, const wcut_known_column *known, const char *label,
                               wcut_error *error);

/* a file to a table whose known columns are numeric and in place */
wcut_status wcut_known_table_read(const char *path, int count, const wcut_known_column *known, wcut_table **table,
                                  wcut_error *error);

#endif
