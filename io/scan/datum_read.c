/* Datums from a CSV: pairs of points, and points on faces that the wire did not cut. */
#include <math.h>
#include <stdlib.h>
#include <wirecut/deviation_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/table_read.h"

enum { SCAN = 0, BLOCK = 3, SIGMA = 6, COLUMNS = 7 };

static const double FAR = 1e12; /* [mm] */

static const wcut_known_column known[COLUMNS] = {
    {"scan_x_mm", "scan_x", "mm", true},   {"scan_y_mm", "scan_y", "mm", true},   {"scan_z_mm", "scan_z", "mm", true},
    {"block_x_mm", "block_x", "mm", true}, {"block_y_mm", "block_y", "mm", true}, {"block_z_mm", "block_z", "mm", true},
    {"sigma_mm", "sigma", "mm", false}};

/* a row's numbers, and which of them are there */
typedef struct row {
    double value[COLUMNS];
    bool there[COLUMNS];
} row;

static row row_of(const wcut_table *t, int r) {
    row found = {0};
    for (int k = 0; k < COLUMNS; k++) {
        const int c = wcut_table_locate(t, known[k].name);
        if (c < 0) continue;
        found.there[k] = !t->column[c].present || t->column[c].present[r];
        found.value[k] = t->column[c].value[r];
    }
    return found;
}

static wcut_vec3 triple(const double *value) { return (wcut_vec3){value[0], value[1], value[2]}; }

/* false: the row is neither a pair nor a point on a face */
static bool take_datum(wcut_datums *d, const row *r) {
    /* the scan's point, and one or three coordinates in the block */
    int block = 0, axis = 0;
    for (int k = 0; k < 3; k++) {
        if (!r->there[SCAN + k]) return false;
        if (r->there[BLOCK + k]) block++, axis = k;
    }

    /* finite and bounded values, a standard deviation of 0 or more */
    for (int k = 0; k < COLUMNS; k++)
        if (!(fabs(r->value[k]) <= FAR)) return false;
    if (r->value[SIGMA] < 0 || (block != 1 && block != 3)) return false;

    /* three make a pair, one a face */
    const wcut_vec3 scan = triple(&r->value[SCAN]), place = triple(&r->value[BLOCK]);
    if (block == 3) {
        d->pair[d->pairs++] = (wcut_datum_pair){scan, place, r->value[SIGMA]};
        return true;
    }

    /* an uncut face across the axis whose coordinate is given */
    const wcut_vec3 normal = {axis == 0, axis == 1, axis == 2};
    d->point[d->faces] = scan;
    d->face[d->faces] = (wcut_datum_face){place, normal, r->value[SIGMA], 1, &d->point[d->faces]};

    d->faces++;

    return true;
}

wcut_status wcut_datums_read(const char *path, wcut_datums **datums, wcut_error *error) {
    char quote[WCUT_QUOTE_SIZE];
    wcut_table *table = NULL;

    /* read the rows: known columns, no value missing that is needed */
    if (!path || !datums) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = wcut_known_table_read(path, COLUMNS, known, &table, error);
    if (status != WCUT_OK) return status;

    /* room for a pair in each row */
    const size_t rows = (size_t)table->rows;
    wcut_datums *d = wcut_alloc(1, sizeof *d);
    if (d) {
        d->pair = wcut_alloc(rows, sizeof *d->pair);
        d->face = wcut_alloc(rows, sizeof *d->face);
        d->point = wcut_alloc(rows, sizeof *d->point);
    }
    if (!d || !d->pair || !d->face || !d->point)
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));

    /* each row is a point of the scan and its place or its face */
    for (int r = 0; r < table->rows && status == WCUT_OK; r++) {
        const row found = row_of(table, r);
        if (!take_datum(d, &found))
            status = wcut_fail(error, WCUT_BAD_FORMAT,
                               "%s: line %d: expected a point of the scan and either its three coordinates in the "
                               "block or the one of a face that it lies on, up to 1e12 mm",
                               wcut_quote(quote, path, WCUT_LABEL_MAX, 1), table->line[r]);
    }

    /* a table without rows is no registration */
    if (status == WCUT_OK && table->rows == 0)
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: found no datum, expected at least one",
                           wcut_quote(quote, path, WCUT_LABEL_MAX, 1));

    wcut_table_destroy(table);
    if (status == WCUT_OK)
        *datums = d;
    else
        wcut_datums_destroy(d);

    return status;
}

void wcut_datums_destroy(wcut_datums *datums) {
    if (!datums) return;
    free(datums->pair);
    free(datums->face);
    free(datums->point);
    free(datums);
}
