/* "fields" of a facade: functions by their kinds, images and tables that are laid over it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/overlay_file.h>
#include <wirecut/table.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/description.h"

#define RAD_PER_DEG (3.14159265358979323846 / 180)

enum { LINE_POINTS_MAX = 100000, GRID_SIDE_MAX = 4096 };

/* what a field's keys are read into; image and table come from files */
typedef struct field_filling {
    wcut_facade_field field;
    const wcut_describing *of;
    char *file;
    double low, high;
    double direction, phase; /* [deg] */
} field_filling;

/* ---- values ---- */

#define READ_NUMBER(name, member, how)                                        \
    static bool name(wcut_reader *reader, const wcut_place *at, void *into) { \
        return how(reader, at, &((field_filling *)into)->member);             \
    }
READ_NUMBER(read_value, field.value, wcut_read_finite)
READ_NUMBER(read_amplitude, field.amplitude, wcut_read_finite)
READ_NUMBER(read_period, field.period, wcut_read_positive)
READ_NUMBER(read_radius, field.radius, wcut_read_positive)
READ_NUMBER(read_direction, direction, wcut_read_finite)
READ_NUMBER(read_phase, phase, wcut_read_finite)
READ_NUMBER(read_low, low, wcut_read_finite)
READ_NUMBER(read_high, high, wcut_read_finite)

static bool read_field_file(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, &((field_filling *)into)->file);
}

static bool read_uv(wcut_reader *reader, const wcut_place *at, void *into) {
    double *pair = into;
    if (json_array_size(at->value) != 2) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "two numbers, along u and v");
    for (size_t i = 0; i < 2; i++) {
        const wcut_place item = {at, NULL, i, json_array_get(at->value, i)};
        if (!wcut_read_finite(reader, &item, &pair[i])) return false;
    }
    return true;
}

static bool read_slope(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_uv(reader, at, ((field_filling *)into)->field.slope);
}

static bool read_attractor_point(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_facade_field *f = &((field_filling *)into)->field;
    if (f->place) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "one of \"point_mm\" and \"curve_mm\"");
    f->place = wcut_alloc(2, sizeof *f->place);
    f->points = 1;
    return f->place ? read_uv(reader, at, f->place) : wcut_refuse_memory(reader);
}

static bool read_attractor_curve(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_facade_field *f = &((field_filling *)into)->field;
    void *list = NULL;
    if (f->place) return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "one of \"point_mm\" and \"curve_mm\"");
    const bool whole = wcut_read_array(reader, at, 2, LINE_POINTS_MAX, "points [u, v]", read_uv, 2 * sizeof(double),
                                       &f->points, &list);
    f->place = list;
    return whole;
}

/* ---- images and tables ---- */

/* grey values of a picture, its lowest row first; a colour counts by its luminance (ITU-R BT.709) */
static bool grid_of_picture(wcut_reader *reader, const wcut_place *at, field_filling *to, const char *path) {
    static const double weight[3] = {0.2126, 0.7152, 0.0722};
    wcut_picture *picture = NULL;
    const wcut_status status = wcut_picture_read(path, &picture, NULL, reader->error);
    if (status != WCUT_OK) {
        reader->status = status;
        return false;
    }

    /* as large as a facade can use */
    wcut_facade_field *f = &to->field;
    f->rows = picture->height, f->columns = picture->width;
    bool whole = f->rows >= 2 && f->columns >= 2 && f->rows <= GRID_SIDE_MAX && f->columns <= GRID_SIDE_MAX;
    if (!whole)
        wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a picture of 2 x 2 to %d x %d pixels, not %d x %d", GRID_SIDE_MAX,
                    GRID_SIDE_MAX, f->columns, f->rows);
    if (whole) f->grid = wcut_alloc((size_t)f->rows * (size_t)f->columns, sizeof *f->grid);
    if (whole && !f->grid) whole = wcut_refuse_memory(reader);
    for (int r = 0; r < f->rows && whole; r++)
        for (int c = 0; c < f->columns; c++) {
            const size_t from =
                ((size_t)(f->rows - 1 - r) * (size_t)f->columns + (size_t)c) * (size_t)picture->channels;
            double grey = 0;
            for (int k = 0; k < 3; k++)
                grey += weight[k] * picture->pixel[from + (size_t)(picture->channels >= 3 ? k : 0)];
            f->grid[(size_t)r * (size_t)f->columns + (size_t)c] = to->low + (to->high - to->low) * grey / 255;
        }
    wcut_picture_destroy(picture);
    return whole;
}

/* a table of numbers: a row of it a row of the grid, the first at v = 0 */
static bool grid_of_table(wcut_reader *reader, const wcut_place *at, field_filling *to, const char *path) {
    wcut_table *table = NULL;
    const wcut_status status = wcut_table_read(path, 0, NULL, &table, reader->error);
    if (status != WCUT_OK) {
        reader->status = status;
        return false;
    }

    /* as large as a facade can use, and whole */
    wcut_facade_field *f = &to->field;
    f->rows = table->rows, f->columns = table->columns;
    bool whole = f->rows >= 2 && f->columns >= 2 && f->rows <= GRID_SIDE_MAX && f->columns <= GRID_SIDE_MAX;
    if (!whole)
        wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a table of 2 x 2 to %d x %d numbers under a header, not %d x %d",
                    GRID_SIDE_MAX, GRID_SIDE_MAX, f->rows, f->columns);
    if (whole) f->grid = wcut_alloc((size_t)f->rows * (size_t)f->columns, sizeof *f->grid);
    if (whole && !f->grid) whole = wcut_refuse_memory(reader);
    for (int c = 0; c < f->columns && whole; c++) {
        const wcut_column *column = &table->column[c];
        if (column->missing > 0)
            whole = wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a number in every field, not %d missing in column %d",
                                column->missing, c + 1);
        for (int r = 0; r < f->rows && whole; r++)
            f->grid[(size_t)r * (size_t)f->columns + (size_t)c] = column->value[r];
    }
    wcut_table_destroy(table);
    return whole;
}

static bool load_grid(wcut_reader *reader, const wcut_place *at, field_filling *to, bool image) {
    char *path = wcut_facade_join(reader, at, to->of, to->file);
    if (!path) return false;
    const bool whole = image ? grid_of_picture(reader, at, to, path) : grid_of_table(reader, at, to, path);
    wcut_free(path);
    return whole;
}

/* ---- a field ---- */

static bool skip_kind(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)reader, (void)at, (void)into;
    return true;
}

/* the keys of each kind, "kind" first */
static const wcut_field constant_key[] = {{"kind", true, skip_kind, 0}, {"value", true, read_value, 0}};
static const wcut_field linear_key[] = {
    {"kind", true, skip_kind, 0}, {"value", true, read_value, 0}, {"per_mm", true, read_slope, 0}};
static const wcut_field sine_key[] = {{"kind", true, skip_kind, 0},
                                      {"value", false, read_value, 0},
                                      {"amplitude", true, read_amplitude, 0},
                                      {"period_mm", true, read_period, 0},
                                      {"direction_deg", false, read_direction, 0},
                                      {"phase_deg", false, read_phase, 0}};
static const wcut_field image_key[] = {{"kind", true, skip_kind, 0},
                                       {"file", true, read_field_file, 0},
                                       {"low", true, read_low, 0},
                                       {"high", true, read_high, 0}};
static const wcut_field grid_key[] = {{"kind", true, skip_kind, 0}, {"file", true, read_field_file, 0}};
static const wcut_field attractor_key[] = {{"kind", true, skip_kind, 0},
                                           {"value", false, read_value, 0},
                                           {"amplitude", true, read_amplitude, 0},
                                           {"radius_mm", true, read_radius, 0},
                                           {"point_mm", false, read_attractor_point, 0},
                                           {"curve_mm", false, read_attractor_curve, 0}};

#define KEYS(list, kind) \
    { list, (int)(sizeof(list) / sizeof *(list)), kind }

static const struct {
    const wcut_field *key;
    int keys;
    wcut_facade_field_kind kind;
} kind_of[] = {KEYS(constant_key, WCUT_FACADE_FIELD_CONSTANT), KEYS(linear_key, WCUT_FACADE_FIELD_LINEAR),
               KEYS(sine_key, WCUT_FACADE_FIELD_SINE),         KEYS(image_key, WCUT_FACADE_FIELD_GRID),
               KEYS(grid_key, WCUT_FACADE_FIELD_GRID),         KEYS(attractor_key, WCUT_FACADE_FIELD_ATTRACTOR)};

static bool read_one_field(wcut_reader *reader, const wcut_place *at, field_filling *to) {
    static const char *const word[] = {"constant", "linear", "sine", "image", "grid", "attractor", NULL};
    enum { IMAGE = 3, GRID = 4 };
    int kind = 0;

    /* its kind says which keys it has */
    const wcut_place of = wcut_place_member(at, "kind");
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object with \"kind\"");
    if (!wcut_read_word(reader, &of, word, &kind)) return false;
    to->field.kind = kind_of[kind].kind;
    if (!wcut_read_object(reader, at, kind_of[kind].key, kind_of[kind].keys, to)) return false;
    to->field.direction = to->direction * RAD_PER_DEG;
    to->field.phase = to->phase * RAD_PER_DEG;

    /* what files hold, and what must be there */
    const wcut_place file = wcut_place_member(at, "file");
    if (kind == IMAGE || kind == GRID) return load_grid(reader, &file, to, kind == IMAGE);
    if (to->field.kind == WCUT_FACADE_FIELD_ATTRACTOR && !to->field.place)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "\"point_mm\" or \"curve_mm\"");
    return true;
}

bool wcut_facade_read_fields(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_describing *d = into;
    const size_t n = json_object_size(at->value);
    if (!json_is_object(at->value) || n < 1 || n > WCUT_FACADE_FIELDS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object of 1 to %d fields", WCUT_FACADE_FIELDS_MAX);
    d->field = wcut_alloc(n, sizeof *d->field);
    if (!d->field) return wcut_refuse_memory(reader);

    /* each under its name; a half read one is freed with the others */
    bool whole = true;
    for (void *i = json_object_iter((json_t *)at->value); i && whole;
         i = json_object_iter_next((json_t *)at->value, i)) {
        const wcut_place member = {at, json_object_iter_key(i), 0, json_object_iter_value(i)};
        field_filling to = {.of = d};
        wcut_named_field *f = &d->field[d->fields++];
        f->name = wcut_copy_text(member.key);
        whole = f->name ? read_one_field(reader, &member, &to) : wcut_refuse_memory(reader);
        free(to.file);
        f->field = to.field;
    }
    return whole;
}

bool wcut_facade_field_locate(wcut_reader *reader, const wcut_place *at, const wcut_describing *d, int *found) {
    const char *name = json_string_value(at->value);
    for (int k = 0; name && k < d->fields; k++)
        if (strcmp(d->field[k].name, name) == 0) {
            *found = k;
            return true;
        }
    return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "the name of one of \"fields\"");
}
