/* CSV files to tables, and which of their columns a format knows. */
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/csv.h"
#include "io/file/look.h"
#include "io/file/stream.h"
#include "io/file/table_read.h"

wcut_status wcut_table_read(const char *path, int numeric_count, const char *const *numeric, wcut_table **table,
                            wcut_error *error) {
    bool named = path && table && numeric_count >= 0 && (numeric || numeric_count == 0);
    for (int k = 0; named && k < numeric_count; k++) named = numeric[k] != NULL;
    if (!named) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* read through a window, so that only the table is held */
    char name[WCUT_QUOTE_SIZE];
    wcut_stream stream;
    wcut_status status = wcut_stream_open(path, &stream, error);
    if (status == WCUT_NO_MEMORY)
        wcut_fail(error, status, "%s: %s", wcut_quote(name, path, WCUT_LABEL_MAX, 1), wcut_status_text(status));
    if (status != WCUT_OK) return status;
    const size_t length = wcut_stream_fill(&stream, stream.capacity);
    const char *head = (const char *)stream.data;

    /* another kind of file, by its first bytes */
    const wcut_look look = wcut_look_at(head, length, path);
    if (look.kind && !wcut_look_is_table(look.kind))
        status = wcut_look_refuse(head, length, path, "a table (CSV)", error);
    else
        status = wcut_csv_read(&stream, path, numeric_count, numeric, table, error);

    wcut_stream_close(&stream);
    return status;
}

/* the part of a column's name behind its stem, "_m_s"; NULL where it has another stem */
static const char *behind_stem(const char *name, const char *stem) {
    size_t n = strlen(stem);
    bool same = strncasecmp(name, stem, n) == 0 && (name[n] == '_' || name[n] == '\0');
    return same ? name + n : NULL;
}

/* does a name end in "_" and a unit of measure, or in nothing? */
static bool is_unit(const char *suffix) {
    static const char *const unit[] = {
        "",     "_s",    "_ms",   "_us",    "_min",    "_m",      "_mm",      "_cm",       "_um",       "_mm_s",
        "_m_s", "_mm/s", "_m/s",  "_m_min", "_mm_min", "_N",      "_kN",      "_mN",       "_g",        "_kg",
        "_deg", "_rad",  "_mrad", "_W",     "_kW",     "_W/m",    "_W_m",     "_W_mm",     "_V",        "_mV",
        "_A",   "_mA",   "_lbf",  "_in",    "_in_s",   "_degree", "_degrees", "_kW_per_m", "_W_per_mm", "_W_per_m"};
    for (size_t k = 0; k < sizeof unit / sizeof unit[0]; k++)
        if (strcasecmp(suffix, unit[k]) == 0) return true;
    return false;
}

static bool is_table_known(const char *name, int count, const wcut_known_column *known) {
    for (int k = 0; k < count; k++)
        if (strcmp(name, known[k].name) == 0) return true;
    return false;
}

/* a column that means a known one, but in another unit or spelling; NULL where there is none */
static const char *locate_misnamed(const wcut_table *table, int count, const wcut_known_column *known, int k) {
    for (int c = 0; c < table->columns; c++) {
        const char *name = table->column[c].name, *suffix = behind_stem(name, known[k].stem);
        if (suffix && is_unit(suffix) && !is_table_known(name, count, known)) return name;
    }
    return NULL;
}

wcut_status wcut_columns_check(const wcut_table *table, int count, const wcut_known_column *known, const char *label,
                               wcut_error *error) {
    char complaint[300] = "", name[WCUT_QUOTE_SIZE];
    size_t used = 0;
    for (int k = 0; k < count; k++) {
        if (wcut_table_locate(table, known[k].name) >= 0) continue;
        const char *other = locate_misnamed(table, count, known, k);
        if (!other && !known[k].required) continue;
        int n = snprintf(complaint + used, sizeof complaint - used, "%s%s", used ? ", " : "", known[k].name);
        used = used + (size_t)n < sizeof complaint ? used + (size_t)n : sizeof complaint - 1;
        if (!other) continue;
        n = snprintf(complaint + used, sizeof complaint - used, " (found %s: another unit or spelling)",
                     wcut_quote(name, other, WCUT_FOUND_MAX, 0));
        used = used + (size_t)n < sizeof complaint ? used + (size_t)n : sizeof complaint - 1;
    }
    if (used == 0) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_FORMAT, "%s: header: missing %s", wcut_quote(name, label, WCUT_LABEL_MAX, 1),
                     complaint);
}

/* where no column at all is known, the names tell what the table holds instead: said behind the complaint */
static void say_kind(const wcut_table *table, int count, const wcut_known_column *known, wcut_error *error) {
    char header[2000] = "";
    size_t used = 0;
    for (int k = 0; k < count; k++)
        if (known[k].required && wcut_table_locate(table, known[k].name) >= 0) return;
    for (int c = 0; c < table->columns && used + 2 < sizeof header; c++) {
        const int n = snprintf(header + used, sizeof header - used, "%s,", table->column[c].name);
        used = used + (size_t)n < sizeof header ? used + (size_t)n : sizeof header - 1;
    }
    const wcut_look look = wcut_look_at(header, used, "");
    const size_t end = strlen(error->text);
    if (look.kind) snprintf(error->text + end, sizeof error->text - end, "; found %s: %s", look.kind, look.use);
}

wcut_status wcut_known_columns_check(const wcut_table *table, int count, const wcut_known_column *known,
                                     const char *label, wcut_error *error) {
    const wcut_status status = wcut_columns_check(table, count, known, label, error);
    if (status == WCUT_BAD_FORMAT && error) say_kind(table, count, known, error);
    return status;
}

wcut_status wcut_known_table_read(const char *path, int count, const wcut_known_column *known, wcut_table **table,
                                  wcut_error *error) {
    const char **name = wcut_alloc((size_t)count, sizeof *name);
    if (!name) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    for (int k = 0; k < count; k++) name[k] = known[k].name;
    wcut_table *found = NULL;
    wcut_status status = wcut_table_read(path, count, name, &found, error);
    free(name);
    assert(status != WCUT_OK || found);
    if (status == WCUT_OK) status = wcut_known_columns_check(found, count, known, path, error);
    if (status == WCUT_OK)
        *table = found;
    else
        wcut_table_destroy(found);
    return status;
}
