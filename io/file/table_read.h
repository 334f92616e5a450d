/* CSV files whose columns a format knows. */
#ifndef WCUT_IO_TABLE_READ_H
#define WCUT_IO_TABLE_READ_H

#include <stdbool.h>
#include <wirecut/table.h>

/* a column that a format knows: its name is stem, "_" and unit, or the stem alone where unit is "" */
typedef struct wcut_known_column {
    const char *name, *stem, *unit;
    bool required;
} wcut_known_column;

/* WCUT_OK where every required column is there and none of the known ones is given in another unit; else
   WCUT_BAD_FORMAT with all the names */
wcut_status wcut_columns_check(const wcut_table *table, int count, const wcut_known_column *known, const char *label,
                               wcut_error *error);

/* the same; where nothing of the table is known, what it holds instead is said behind the names */
wcut_status wcut_known_columns_check(const wcut_table *table, int count, const wcut_known_column *known,
                                     const char *label, wcut_error *error);

/* a file to a table whose known columns are numeric and in place */
wcut_status wcut_known_table_read(const char *path, int count, const wcut_known_column *known, wcut_table **table,
                                  wcut_error *error);

#endif
