/* Recordings: the channels of a CSV file, in the API's units. */
#include <math.h>
#include <stdio.h>
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

/* move the known columns out of the table into the channels, the first of each name */
static void sort_out(wcut_table *table, wcut_recording *recording) {
    int kept = 0;
    for (int c = 0; c < table->columns; c++) {
        int k = 0;
        while (k < WCUT_CHANNEL_COUNT && strcmp(table->column[c].name, channel_column[k].name) != 0) k++;
        if (k < WCUT_CHANNEL_COUNT && !recording->channel[k].name)
            recording->channel[k] = table->column[c];
        else
            table->column[kept++] = table->column[c];
    }
    table->columns = kept;
    recording->further = table;
    recording->samples = table->rows;
}

/* ---- columns of another program ---- */

static wcut_status check_format(const wcut_recording_format *f, wcut_error *error) {
    if (!(f->period >= 0 && f->period <= 1e6) || f->maps < 0 || (f->maps > 0 && !f->map))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "a format of a recording: expected a period of 0 to 1e6 s, and maps");
    for (int k = 0; k < f->maps; k++) {
        const wcut_column_map *m = &f->map[k];
        bool fits = (unsigned)m->channel < WCUT_CHANNEL_COUNT && m->column && m->column[0] && isfinite(m->factor) &&
                    m->factor != 0 && isfinite(m->offset);
        for (int i = 0; i < k; i++) fits = fits && f->map[i].channel != m->channel;
        if (!fits)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "a format of a recording: expected known channels once each, a column and a factor");
    }
    return WCUT_OK;
}

/* the column that a channel has in the file */
static const char *column_in_file(const wcut_recording_format *f, int channel) {
    for (int k = 0; k < f->maps; k++)
        if ((int)f->map[k].channel == channel) return f->map[k].column;
    return channel_column[channel].name;
}

static wcut_status refuse_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

/* one more column of a name, with the values of another one or zeros */
static wcut_status add_column(wcut_table *t, const char *name, int from, wcut_error *error) {
    wcut_column *grown = wcut_grow(t->column, (size_t)(t->columns + 1) * sizeof *grown);
    if (!grown) return refuse_memory(error);
    t->column = grown;
    wcut_column *c = &grown[t->columns];
    *c = (wcut_column){.name = wcut_copy_text(name)};
    const size_t n = (size_t)t->rows;
    c->value = from >= 0 ? wcut_copy(grown[from].value, n, sizeof(double)) : wcut_alloc(n, sizeof(double));
    if (from >= 0 && grown[from].present) c->present = wcut_copy(grown[from].present, n, 1);
    t->columns++; /* the table's to free, whole or not */
    if (!c->name || !c->value || (from >= 0 && grown[from].present && !c->present)) return refuse_memory(error);
    if (from >= 0) c->missing = grown[from].missing, c->text = grown[from].text;
    return WCUT_OK;
}

/* Give the columns of another program the names and units of channels. A column may serve several channels; one that
   has a channel's name and is not mapped to it is kept under a name with "file:" before it. */
static wcut_status map_columns(const wcut_recording_format *f, wcut_table *t, const char *path, wcut_error *error) {
    const int own = t->columns;
    for (int k = 0; k < f->maps; k++) {
        const wcut_column_map *m = &f->map[k];
        const char *name = channel_column[m->channel].name;
        const int from = wcut_table_locate(t, m->column);
        if (from < 0 || from >= own) {
            char label[WCUT_QUOTE_SIZE], quoted[WCUT_QUOTE_SIZE];
            return wcut_fail(error, WCUT_BAD_FORMAT, "%s: header: no column %s, which the format names for %s",
                             wcut_quote(label, path, WCUT_LABEL_MAX, 1),
                             wcut_quote(quoted, m->column, WCUT_FOUND_MAX, 0), name);
        }

        /* a copy under the channel's name, in its unit */
        const wcut_status status = add_column(t, name, from, error);
        if (status != WCUT_OK) return status;
        wcut_column *c = &t->column[t->columns - 1];
        for (int i = 0; i < t->rows; i++)
            if (!c->present || c->present[i]) c->value[i] = m->factor * c->value[i] + m->offset;
    }

    /* the file's own columns of the same names step aside */
    for (int c = 0; c < own; c++)
        for (int k = 0; k < f->maps; k++) {
            if (strcmp(t->column[c].name, channel_column[f->map[k].channel].name) != 0) continue;
            const size_t size = strlen(t->column[c].name) + sizeof "file:";
            char *aside = wcut_alloc(size, 1);
            if (!aside) return refuse_memory(error);
            snprintf(aside, size, "file:%s", t->column[c].name);
            free(t->column[c].name);
            t->column[c].name = aside;
        }

    return WCUT_OK;
}

/* the clock of a file without one */
static wcut_status add_clock(double period, wcut_table *t, const char *path, wcut_error *error) {
    const char *name = channel_column[WCUT_CHANNEL_TIME].name;
    if (wcut_table_locate(t, name) >= 0)
        return refuse_line(error, path, 1, "found time_s and a constant period, expected one of them");
    const wcut_status status = add_column(t, name, -1, error);
    for (int i = 0; status == WCUT_OK && i < t->rows; i++) t->column[t->columns - 1].value[i] = i * period;
    return status;
}

/* ---- which channels it must have ---- */

static bool table_has(const wcut_table *t, int from, int to) {
    for (int k = from; k <= to; k++)
        if (wcut_table_locate(t, channel_column[k].name) < 0) return false;
    return true;
}

static bool table_has_force(const wcut_table *t) {
    for (int k = WCUT_CHANNEL_FORCE_X; k <= WCUT_CHANNEL_FORCE_Z; k++)
        if (wcut_table_locate(t, channel_column[k].name) >= 0) return true;
    return false;
}

/* what a recording of this kind of rig must and may have; list: WCUT_CHANNEL_COUNT, gives how many */
static int list_channels(const wcut_table *t, wcut_known_column *list) {
    const bool force = table_has_force(t), placed = table_has(t, WCUT_CHANNEL_TOOL_X, WCUT_CHANNEL_TOOL_Z);
    const bool mounts_placed = table_has(t, WCUT_CHANNEL_A_X, WCUT_CHANNEL_B_Z);
    int count = 0;
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        const bool of_tool = k >= WCUT_CHANNEL_FORCE_X,
                   of_mounts = k >= WCUT_CHANNEL_SPEED_A && k <= WCUT_CHANNEL_BETA_B;
        if (force ? of_mounts : of_tool) continue; /* a further column */
        wcut_known_column c = channel_column[k];
        if (k == WCUT_CHANNEL_STATION && (force || mounts_placed)) c.required = false;
        if (k >= WCUT_CHANNEL_FORCE_X && k <= WCUT_CHANNEL_FORCE_Z) c.required = true;
        if (k == WCUT_CHANNEL_SPEED && !placed) c.required = true;
        list[count++] = c;
    }
    return count;
}

/* the table of a file, its columns named and scaled as channels, with a clock */
static wcut_status read_channels(const char *path, const wcut_recording_format *f, wcut_table **table,
                                 wcut_error *error) {
    const char *name[WCUT_CHANNEL_COUNT];
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) name[k] = column_in_file(f, k);
    wcut_status status = wcut_table_read(path, WCUT_CHANNEL_COUNT, name, table, error);
    if (status == WCUT_OK) status = map_columns(f, *table, path, error);
    if (status == WCUT_OK && f->period > 0) status = add_clock(f->period, *table, path, error);

    /* what it must have, by the rig that it is of */
    wcut_known_column list[WCUT_CHANNEL_COUNT];
    if (status == WCUT_OK) status = wcut_known_columns_check(*table, list_channels(*table, list), list, path, error);
    return status;
}

wcut_status wcut_recording_read(const char *path, const wcut_recording_format *format, wcut_recording **recording,
                                wcut_error *error) {
    static const wcut_recording_format plain = {0};
    const wcut_recording_format *f = format ? format : &plain;
    if (!path || !recording) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = check_format(f, error);
    if (status != WCUT_OK) return status;

    /* the table, with repeated rows dropped and time increasing */
    wcut_table *table = NULL;
    status = read_channels(path, f, &table, error);
    if (status == WCUT_OK && f->period == 0) drop_repeats(table);
    if (status == WCUT_OK) status = check_time(table, path, error);

    /* a recording takes the table over */
    wcut_recording *r = status == WCUT_OK ? wcut_alloc(1, sizeof *r) : NULL;
    if (status == WCUT_OK && !r) status = refuse_memory(error);
    if (status != WCUT_OK) {
        wcut_table_destroy(table);
        return status;
    }

    /* columns to their channels; angles in rad */
    sort_out(table, r);
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        bool angle = strcmp(channel_column[k].unit, "deg") == 0;
        for (int i = 0; angle && r->channel[k].name && i < r->samples; i++) r->channel[k].value[i] *= WCUT_RAD_PER_DEG;
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
