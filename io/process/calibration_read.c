/* Calibration tables: one test cut a row, in the API's units. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/calibration.h>
#include <wirecut/calibration_file.h>

#include <wirecut/angle.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/table_read.h"

enum { HEAT, SPEED, ENGAGED, TENSION, ALPHA, KNOWN };
static const wcut_known_column known_column[KNOWN] = {
    [HEAT] = {"heat_W_per_m", "heat", "W_per_m", true}, [SPEED] = {"speed_mm_s", "speed", "mm_s", true},
    [ENGAGED] = {"engaged_mm", "engaged", "mm", true},  [TENSION] = {"tension_N", "tension", "N", true},
    [ALPHA] = {"alpha_deg", "alpha", "deg", true},
};

static wcut_status refuse_calibration(wcut_error *error, const char *path, int line, const char *column,
                                      const char *what) {
    char label[WCUT_QUOTE_SIZE], name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: line %d: %s: %s", wcut_quote(label, path, WCUT_LABEL_MAX, 1), line,
                     wcut_quote(name, column, WCUT_FOUND_MAX, 0), what);
}

static bool is_calibration_there(const wcut_column *column, int row) {
    return !column->present || column->present[row];
}

/* one cut; every value must be there and in its range, for a test cut without one is none */
static wcut_status read_calibration_cut(const wcut_table *table, const int *place, int weight, int row,
                                        const char *path, wcut_test_cut *cut, wcut_error *error) {
    double value[KNOWN];
    int line = table->line[row];

    /* numbers that must be there, all but the angle positive */
    for (int k = 0; k < KNOWN; k++) {
        const wcut_column *column = &table->column[place[k]];
        value[k] = column->value[row];
        if (!is_calibration_there(column, row))
            return refuse_calibration(error, path, line, column->name, "found a missing value, expected a number");
        if (k != ALPHA && !(value[k] > 0))
            return refuse_calibration(error, path, line, column->name,
                                      "found a number that is not positive, expected a positive one");
    }

    /* the angle of the wire, the weight of the cut */
    if (!(fabs(value[ALPHA]) < 90))
        return refuse_calibration(error, path, line, known_column[ALPHA].name,
                                  "found an angle of 90 deg or more, expected less");
    double mass = weight >= 0 ? table->column[weight].value[row] : 1;
    if (!(mass > 0))
        return refuse_calibration(error, path, line, table->column[weight].name,
                                  "found no positive weight, expected one");

    /* angles in the API's unit; both mounts have the same tension and angle */
    double alpha = value[ALPHA] * WCUT_RAD_PER_DEG;
    *cut = (wcut_test_cut){value[HEAT], value[SPEED], value[ENGAGED], value[TENSION], value[TENSION], alpha, alpha,
                           mass,        line};

    return WCUT_OK;
}

static wcut_status read_calibration_cuts(const wcut_table *table, const char *weight, const char *path,
                                         wcut_test_cut *cut, wcut_error *error) {
    int place[KNOWN], of_weight = wcut_table_locate(table, weight);
    if (weight && of_weight < 0)
        return refuse_calibration(error, path, 1, weight, "found no such column, expected the column of the weights");
    for (int k = 0; k < KNOWN; k++) place[k] = wcut_table_locate(table, known_column[k].name);
    for (int i = 0; i < table->rows; i++) {
        wcut_status status = read_calibration_cut(table, place, of_weight, i, path, &cut[i], error);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

wcut_status wcut_calibration_table_read(const char *path, const char *weight, int *n, wcut_test_cut **cut,
                                        wcut_error *error) {
    if (!path || !n || !cut) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_table *table = NULL;
    wcut_status status = wcut_known_table_read(path, KNOWN, known_column, &table, error);
    if (status != WCUT_OK) return status;
    wcut_test_cut *found = wcut_alloc((size_t)table->rows, sizeof *found);
    status = found ? read_calibration_cuts(table, weight, path, found, error)
                   : wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    if (status == WCUT_OK) {
        *n = table->rows;
        *cut = found;
    } else {
        free(found);
    }
    wcut_table_destroy(table);
    return status;
}

void wcut_test_cut_destroy(wcut_test_cut *cut) { free(cut); }
