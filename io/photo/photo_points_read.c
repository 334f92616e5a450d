/* Points of a photograph from a CSV: pixels and places. */
#include <math.h>
#include <wirecut/overlay_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/table_read.h"

enum { COLUMNS = 5, POINTS_MIN = 4, POINTS_MAX = 500 };

static const wcut_known_column known[COLUMNS] = {{"u_px", "u", "px", true},
                                                 {"v_px", "v", "px", true},
                                                 {"x_mm", "x", "mm", true},
                                                 {"y_mm", "y", "mm", true},
                                                 {"z_mm", "z", "mm", true}};

/* every number of a row, or the column that is empty */
static int take_row(const wcut_table *table, int row, double value[COLUMNS]) {
    for (int k = 0; k < COLUMNS; k++) {
        const wcut_column *c = &table->column[wcut_table_locate(table, known[k].name)];
        if (c->present && !c->present[row]) return k;
        value[k] = c->value[row];
    }
    return -1;
}

wcut_status wcut_photo_points_read(const char *path, int *count, wcut_photo_point **point, wcut_error *error) {
    char quote[WCUT_QUOTE_SIZE];
    wcut_table *table = NULL;
    if (!path || !count || !point)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = wcut_known_table_read(path, COLUMNS, known, &table, error);
    if (status != WCUT_OK) return status;
    const int rows = table->rows;
    wcut_photo_point *made = NULL;
    if (rows < POINTS_MIN || rows > POINTS_MAX)
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: found %d points, expected %d to %d",
                           wcut_quote(quote, path, WCUT_LABEL_MAX, 1), rows, POINTS_MIN, POINTS_MAX);
    else if (!(made = wcut_alloc((size_t)rows, sizeof *made)))
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));

    /* no number may be missing */
    for (int r = 0; r < rows && status == WCUT_OK; r++) {
        double value[COLUMNS];
        const int missing = take_row(table, r, value);
        if (missing >= 0)
            status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: line %d: %s: found nothing, expected a number",
                               wcut_quote(quote, path, WCUT_LABEL_MAX, 1), table->line[r], known[missing].name);
        else
            made[r] = (wcut_photo_point){value[0], value[1], {value[2], value[3], value[4]}};
    }
    wcut_table_destroy(table);
    if (status == WCUT_OK) {
        *count = rows;
        *point = made;
    } else {
        wcut_free(made);
    }
    return status;
}
