/* wirecut/table.h - a CSV file as columns of numbers. */
#ifndef WCUT_TABLE_H
#define WCUT_TABLE_H

#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One column. A missing sample is a 0 in `present`, never a NaN in `value`. */
typedef struct wcut_column {
    char *name;             /**< as in the header, without quotes */
    double *value;          /**< rows, in the file's unit; 0 where missing */
    unsigned char *present; /**< rows of 1 (there) or 0 (missing); NULL where no sample is missing */
    int missing;            /**< samples missing: fields that are empty, nan or text */
    int text;               /**< those of them that are text: neither a number nor empty nor nan */
} wcut_column;

/** A table; every column has the same number of rows. */
typedef struct wcut_table {
    int rows;
    int columns;
    wcut_column *column; /**< columns, in the file's order */
    int *line;           /**< rows: the line of the file where each row begins, from 1 */
} wcut_table;

/**
 * Read a CSV file: a header row, then one row a sample; fields separated by commas, semicolons, tabs or blanks, as the
 * header has them, quoted where need be; lines that begin with # are comments, empty lines are skipped; a byte order
 * mark and CRLF are tolerated. Numbers have a decimal point whatever the locale, between other separators than commas
 * a decimal comma too, and become the nearest double.
 *
 * @param[in]  path          a file, or a pipe
 * @param[in]  numeric_count how many names follow, not negative
 * @param[in]  numeric       numeric_count names of columns that may hold nothing but numbers and missing samples, where
 *                           they are there; in other columns text is tolerated and counts as missing
 * @param[out] table         the caller's, to wcut_table_destroy; a table may have 0 rows
 * @param[out] error         may be NULL; line and column, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (no header, columns without a name or
 *         named twice, a row with more or fewer fields than the header, a quote that is not closed, a text or a number
 *         beyond the range of a double in a numeric column), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_table_read(const char *path, int numeric_count, const char *const *numeric,
                                     wcut_table **table, wcut_error *error);

/**
 * The column of a name.
 *
 * @return its index; -1 where there is none, or an argument is NULL.
 */
WCUT_API int wcut_table_locate(const wcut_table *table, const char *name);

/** Free a table with everything in it; NULL is allowed. */
WCUT_API void wcut_table_destroy(wcut_table *table);

#ifdef __cplusplus
}
#endif

#endif
