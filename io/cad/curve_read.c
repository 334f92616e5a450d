/* Curves in: which format a file has, and those of JSON and CSV. */
#include "io/cad/curve_set.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <wirecut/table.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/csv.h"
#include "io/file/read_file.h"
#include "io/process/curve_json.h"

#define BYTES_MAX ((size_t)256 << 20)

wcut_curve_read_options wcut_curve_read_options_default(void) {
    return (wcut_curve_read_options){.format = WCUT_CURVE_FORMAT_ANY, .interpolate = 1, .max_curves = 10000};
}

/* ---- JSON ---- */

/* what the functions of JSON are handed */
static bool read_listed(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_curve_reader *r = into;
    for (size_t k = 0; k < json_array_size(at->value); k++) {
        const wcut_place item = {at, NULL, k, json_array_get(at->value, k)};
        wcut_curve *curve = NULL;
        if (!wcut_read_curve(reader, &item, &curve) || !wcut_curves_add(r, curve, "", 0)) return false;
    }
    return json_is_array(at->value) || wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an array of curves");
}

static bool read_root(wcut_reader *reader, const wcut_place *root, wcut_curve_reader *r) {
    static const wcut_field fields[] = {{"curves", true, read_listed, 0}};
    if (json_object_get(root->value, "curves")) return wcut_read_object(reader, root, fields, 1, r);
    wcut_curve *curve = NULL;
    return wcut_read_curve(reader, root, &curve) && wcut_curves_add(r, curve, "", 0);
}

bool wcut_curves_fill_json(wcut_curve_reader *r, char *text, size_t length) {
    wcut_error error = {WCUT_OK, ""};
    wcut_reader reader = {.label = r->label, .error = &error};
    json_t *json = wcut_json_load(&reader, text, length);
    const wcut_place root = {.value = json};
    const bool done = json && read_root(&reader, &root, r);
    json_decref(json);
    if (!done && r->failure.status == WCUT_OK) {
        r->failure = error;
        /* a file is not an argument, however wrong its values are */
        if (r->failure.status == WCUT_BAD_ARGUMENT) r->failure.status = WCUT_BAD_FORMAT;
    }
    return done;
}

/* ---- CSV ---- */

static const char *const column[] = {"x_mm", "y_mm", "z_mm", "curve"};
enum { COLUMNS = 4, CURVE = 3 };

/* the points of rows from .. end - 1 */
static bool add_rows(wcut_curve_reader *r, const wcut_table *t, const int *at, int from, int end) {
    char place[40] = "";
    const int count = end - from;
    wcut_vec3 *point = wcut_alloc((size_t)count, sizeof *point);
    wcut_curve *curve = NULL;
    if (!point) return wcut_curves_refuse_memory(r);

    /* the points of the rows */
    for (int k = 0; k < count; k++) {
        double *to = &point[k].x;
        for (int c = 0; c < 3; c++) to[c] = t->column[at[c]].value[from + k];
    }
    snprintf(place, sizeof place, "line %d", t->line[from]);

    /* a polyline through them, or a smooth curve */
    if (!r->options->interpolate) {
        curve = wcut_curves_polyline(r, place, count, point);
    } else {
        const wcut_status status = count >= 2 ? wcut_curve_interpolate(count, point, &curve) : WCUT_DEGENERATE;
        if (status == WCUT_NO_MEMORY) wcut_curves_refuse_memory(r);
        if (status != WCUT_OK && status != WCUT_NO_MEMORY)
            wcut_curves_refuse(r, "%s: found %d points, expected two or more, neighbours apart", place, count);
    }

    free(point);
    return curve && wcut_curves_add(r, curve, "", 0);
}

static bool check_row(wcut_curve_reader *r, const wcut_table *t, const int *at, int row) {
    for (int c = 0; c < COLUMNS; c++) {
        const wcut_column *one = at[c] >= 0 ? &t->column[at[c]] : NULL;
        if (one && one->present && !one->present[row])
            return wcut_curves_refuse(r, "line %d: found no %s, expected a number", t->line[row], column[c]);
        if (one && !(one->value[row] >= -1e12 && one->value[row] <= 1e12))
            return wcut_curves_refuse(r, "line %d: found a %s beyond 1e12", t->line[row], column[c]);
    }
    return true;
}

static bool add_table(wcut_curve_reader *r, const wcut_table *t) {
    int at[COLUMNS], from = 0;
    for (int c = 0; c < COLUMNS; c++) at[c] = wcut_table_locate(t, column[c]);
    for (int c = 0; c < 3; c++)
        if (at[c] < 0) return wcut_curves_refuse(r, "found no column %s, expected x_mm, y_mm, z_mm", column[c]);
    for (int row = 0; row < t->rows; row++) {
        if (!check_row(r, t, at, row)) return false;
        const double *curve = at[CURVE] >= 0 ? t->column[at[CURVE]].value : NULL;
        const bool ends = row + 1 == t->rows || (curve && curve[row] != curve[row + 1]);
        if (ends && !add_rows(r, t, at, from, row + 1)) return false;
        if (ends) from = row + 1;
    }
    return true;
}

bool wcut_curves_fill_csv(wcut_curve_reader *r, char *text, size_t length) {
    wcut_table *table = NULL;
    wcut_error error = {WCUT_OK, ""};
    if (wcut_csv_parse(text, length, r->label, COLUMNS, column, &table, &error) != WCUT_OK) {
        r->failure = error;
        return false;
    }
    const bool done = add_table(r, table);
    wcut_table_destroy(table);
    return done;
}

/* ---- any ---- */

static wcut_curve_format find_curve_format(const char *text, size_t length, const char *label) {
    static const struct {
        const char *ending;
        wcut_curve_format format;
    } known[] = {{".step", WCUT_CURVE_FORMAT_STEP}, {".stp", WCUT_CURVE_FORMAT_STEP},
                 {".p21", WCUT_CURVE_FORMAT_STEP},  {".igs", WCUT_CURVE_FORMAT_IGES},
                 {".iges", WCUT_CURVE_FORMAT_IGES}, {".json", WCUT_CURVE_FORMAT_JSON},
                 {".csv", WCUT_CURVE_FORMAT_CSV}};
    const size_t n = strlen(label);
    if (strncmp(text, "ISO-10303-21;", 13) == 0) return WCUT_CURVE_FORMAT_STEP;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        const size_t m = strlen(known[k].ending);
        if (n > m && strcasecmp(label + n - m, known[k].ending) == 0) return known[k].format;
    }
    if (length > 80 && text[72] == 'S' && (text[80] == '\n' || text[80] == '\r')) return WCUT_CURVE_FORMAT_IGES;
    return WCUT_CURVE_FORMAT_ANY;
}

static bool fill_curve(wcut_curve_reader *r, char *text, size_t length) {
    static wcut_curves_fill *const by_format[] = {NULL, wcut_curves_fill_step, wcut_curves_fill_iges,
                                                  wcut_curves_fill_json, wcut_curves_fill_csv};
    wcut_curve_set *set = r->set;
    set->format =
        r->options->format != WCUT_CURVE_FORMAT_ANY ? r->options->format : find_curve_format(text, length, r->label);
    if (set->format == WCUT_CURVE_FORMAT_ANY)
        return wcut_curves_refuse(r, "found no curves in a known format, expected STEP, IGES, JSON or CSV");
    if (!by_format[set->format](r, text, length)) return false;
    if (set->count > 0) return true;
    return set->left_out
               ? wcut_curves_refuse(r, "found no curve that is read, %d left out: %s", set->left_out, set->why)
               : wcut_curves_refuse(r, "found no curve, expected at least one");
}

wcut_status wcut_curve_set_read_memory(char *text, size_t length, const char *label,
                                       const wcut_curve_read_options *options, wcut_curve_set **set,
                                       wcut_error *error) {
    wcut_curve_reader r = {.label = label, .options = options, .set = wcut_alloc(1, sizeof(wcut_curve_set))};
    if (r.set && fill_curve(&r, text, length)) {
        *set = r.set;
        return WCUT_OK;
    }
    if (!r.set) wcut_curves_refuse_memory(&r);
    wcut_curve_set_destroy(r.set);
    if (error) *error = r.failure;
    return r.failure.status;
}

wcut_status wcut_curve_set_read(const char *path, const wcut_curve_read_options *options, wcut_curve_set **set,
                                wcut_error *error) {
    const wcut_curve_read_options o = options ? *options : wcut_curve_read_options_default();
    char *text = NULL;
    size_t length = 0;
    if (!path || !set || (unsigned)o.format >= WCUT_CURVE_FORMAT_COUNT || o.max_curves < 1 ||
        (unsigned)o.interpolate > 1)
        return WCUT_BAD_ARGUMENT;
    wcut_status status = wcut_file_read(path, BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_curve_set_read_memory(text, length, path, &o, set, error);
    free(text);
    return status;
}
