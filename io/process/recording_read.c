/* Recordings: the channels of a CSV file, in the API's units. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/recording.h>
#include <wirecut/recording_file.h>

#include <wirecut/angle.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/table_read.h"

#define KNOWN_NAME(stem, unit) (sizeof unit > 1 ? stem "_" unit : stem)
#define KNOWN_ENTRY(name, stem, unit, required) {KNOWN_NAME(stem, unit), stem, unit, required},
static const wcut_known_column channel_column[] = {WCUT_CHANNEL_LIST(KNOWN_ENTRY)};
#undef KNOWN_ENTRY

static wcut_status refuse_line(wcut_error *error, const char *path, int line, const char *what) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: line %d: %s", wcut_quote(name, path, WCUT_LABEL_MAX, 1), line, what);
}

/* whether a row says nothing that the row before it did not say: the same cells in every column */
static bool is_repeated(const wcut_table *table, int row) {
    for (int c = 0; c < table->columns; c++) {
        const wcut_column *x = &table->column[c];
        const bool there = !x->present || x->present[row], before = !x->present || x->present[row - 1];
        if (there != before || (there && x->value[row] != x->value[row - 1])) return false;
    }
    return true;
}

/* leave out samples that were written twice */
static void drop_repeats(wcut_table *table) {
    int kept = table->rows > 0;
    for (int i = 1; i < table->rows; i++) {
        const bool repeated = is_repeated(table, i);
        for (int c = 0; c < table->columns; c++) {
            wcut_column *x = &table->column[c];
            if (repeated) {
                x->missing -= x->present && !x->present[i];
                continue;
            }
            x->value[kept] = x->value[i];
            if (x->present) x->present[kept] = x->present[i];
        }
        if (!repeated) table->line[kept++] = table->line[i];
    }
    table->rows = kept;
}

/* a clock that every sample has and that runs forward */
static wcut_status check_time(const wcut_table *table, const char *path, wcut_error *error) {
    const wcut_column *time = &table->column[wcut_table_locate(table, channel_column[WCUT_CHANNEL_TIME].name)];
    if (table->rows == 0) return refuse_line(error, path, 1, "found a header and no samples, expected at least one");
    for (int i = 0; i < table->rows; i++) {
        if (time->present && !time->present[i])
            return refuse_line(error, path, table->line[i], "time_s: found a missing sample, expected a time");
        if (i == 0 || time->value[i] > time->value[i - 1]) continue;
        char name[WCUT_QUOTE_SIZE];
        return wcut_fail(error, WCUT_BAD_FORMAT, "%s: line %d: time_s: found %.9g after %.9g, expected a later time",
                         wcut_quote(name, path, WCUT_LABEL_MAX, 1), table->line[i], time->value[i], time->value[i - 1]);
    }
    return WCUT_OK;
}

/* move the known columns out of the table into the channels */
static void sort_out(wcut_table *table, wcut_recording *recording) {
    int kept = 0;
    for (int c = 0; c < table->columns; c++) {
        int k = 0;
        while (k < WCUT_CHANNEL_COUNT && strcmp(table->column[c].name, channel_column[k].name) != 0) k++;
        if (k < WCUT_CHANNEL_COUNT)
            recording->channel[k] = table->column[c];
        else
            table->column[kept++] = table->column[c];
    }
    table->columns = kept;
    recording->further = table;
    recording->samples = table->rows;
}

wcut_status wcut_recording_read(const char *path, wcut_recording **recording, wcut_error *error) {
    if (!path || !recording) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* the table, with repeated rows dropped and time increasing */
    wcut_table *table = NULL;
    wcut_status status = wcut_known_table_read(path, WCUT_CHANNEL_COUNT, channel_column, &table, error);
    if (status == WCUT_OK) drop_repeats(table);
    if (status == WCUT_OK) status = check_time(table, path, error);
    wcut_recording *r = status == WCUT_OK ? wcut_alloc(1, sizeof *r) : NULL;
    if (status == WCUT_OK && !r) status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    if (status != WCUT_OK) {
        wcut_table_destroy(table);
        return status;
    }

    /* columns to their channels; angles in rad */
    sort_out(table, r);
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        bool angle = strcmp(channel_column[k].unit, "deg") == 0;
        for (int i = 0; angle && i < r->samples; i++) r->channel[k].value[i] *= WCUT_RAD_PER_DEG;
    }
    *recording = r;
    return WCUT_OK;
}

void wcut_recording_destroy(wcut_recording *recording) {
    if (!recording) return;
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        free(recording->channel[k].name);
        free(recording->channel[k].value);
        free(recording->channel[k].present);
    }
    wcut_table_destroy(recording->further);
    free(recording);
}
