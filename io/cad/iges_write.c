/* IGES 5.3 files (US PRO 1996): rational B-spline curves (126) and surfaces (128), each with its name (406 form 15). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/cad/shape_check.h"
#include "io/file/number.h"
#include "io/file/text.h"
#include "io/file/utf8.h"

enum { LINE = 81, LINES_MAX = 9999999, TOKEN = 40, DATA = 64, GLOBAL = 72 };

/* the section being written, a line at a time */
typedef struct iges {
    wcut_text *text;
    char section;
    int width;     /* columns for data */
    long sequence; /* of the line being filled, from 1 */
    long entity;   /* the directory line that the data belong to; 0: none */
    int used;
    char line[LINE];
} iges;

/* one directory entry, two lines */
typedef struct entry {
    int type, form;
    long first, lines; /* of its parameter data */
    const char *status;
} entry;

/* ---- lines and tokens ---- */

/* a number at the right of its columns */
static void put_iges_field(char *to, int width, long value) {
    for (int k = width - 1; k >= 0; k--, value /= 10)
        to[k] = (char)(value > 0 || k == width - 1 ? '0' + value % 10 : ' ');
}

static void end_line(iges *f) {
    memset(f->line + f->used, ' ', (size_t)(72 - f->used));
    if (f->entity) put_iges_field(f->line + 64, 8, f->entity);
    f->line[72] = f->section;
    put_iges_field(f->line + 73, 7, f->sequence);
    f->line[80] = '\n';
    wcut_text_put(f->text, f->line, LINE);
    f->sequence++;
    f->used = 0;
}

/* a value and what ends it: never divided between two lines */
static void put_token(iges *f, const char *token, size_t length, char end) {
    if (f->used + (int)length + 1 > f->width) end_line(f);
    memcpy(f->line + f->used, token, length);
    f->line[f->used + (int)length] = end;
    f->used += (int)length + 1;
}

static void put_integer(iges *f, long value, char end) {
    char token[TOKEN];
    put_token(f, token, (size_t)snprintf(token, sizeof token, "%ld", value), end);
}

/* always with a point, and D before the exponent of a double */
static void put_real(iges *f, double value, char end) {
    char digits[WCUT_NUMBER_SIZE], token[TOKEN];
    const int length = wcut_number_print(value, digits);
    int used = 0;
    bool has_point = false;
    for (int i = 0; i < length; i++) {
        const bool is_exponent = digits[i] == 'e';
        has_point = has_point || digits[i] == '.';
        if (is_exponent && !has_point) token[used++] = '.', has_point = true;
        token[used++] = is_exponent ? 'D' : digits[i];
    }
    if (!has_point) token[used++] = '.';
    put_token(f, token, (size_t)used, end);
}

/* 5Hlower, at most 50 characters; IGES knows ASCII alone, so the rest becomes "_" */
static void put_iges_string(iges *f, const char *string, char end) {
    char plain[64], token[80];
    int length = 0;
    while (*string && length < 50) {
        uint32_t code;
        string = wcut_utf8_next(string, &code);
        plain[length++] = code >= 0x20 && code < 0x7f ? (char)code : '_';
    }
    const int n = length ? snprintf(token, sizeof token, "%dH%.*s", length, length, plain) : 0;
    put_token(f, token, (size_t)n, end);
}

static void begin_section(iges *f, char section, int width) {
    f->section = section;
    f->width = width;
    f->sequence = 1;
    f->entity = 0;
    f->used = 0;
}

/* ---- start and global section; gives the number of its lines ---- */

static long put_iges_head(iges *f, const char *name) {
    /* the start section: one line for people */
    begin_section(f, 'S', GLOBAL);
    f->used = snprintf(f->line, 72, "wirecut %s, lengths in mm", WCUT_VERSION);
    end_line(f);

    /* the global section, field by field (5.3, table 2): separators, names, sizes of numbers */
    begin_section(f, 'G', GLOBAL);
    put_token(f, "1H,", 3, ',');
    put_token(f, "1H;", 3, ',');
    put_iges_string(f, name, ',');
    put_iges_string(f, name, ',');
    put_iges_string(f, "wirecut " WCUT_VERSION, ',');
    put_iges_string(f, "wirecut " WCUT_VERSION, ',');
    static const int numbers[] = {32, 38, 6, 308, 15}; /* bits of an integer; range and digits of reals */
    for (int k = 0; k < 5; k++) put_integer(f, numbers[k], ',');

    /* the unit, and the smallest and largest lengths */
    put_iges_string(f, name, ',');
    put_real(f, 1, ',');
    put_integer(f, 2, ',');
    put_iges_string(f, "MM", ',');
    put_integer(f, 1, ',');
    put_real(f, 0.01, ',');
    put_iges_string(f, "19700101.000000", ','); /* a date must be there; this one is nobody's */
    put_real(f, 1e-6, ',');
    put_real(f, 0, ',');
    put_iges_string(f, "", ',');
    put_iges_string(f, "", ',');
    put_integer(f, 11, ','); /* version 5.3 */
    put_integer(f, 0, ',');
    put_iges_string(f, "19700101.000000", ';');
    end_line(f);

    return f->sequence - 1;
}

/* ---- parameter data ---- */

static void put_reals(iges *f, const double *value, size_t count) {
    for (size_t k = 0; k < count; k++) put_real(f, value[k], ',');
}

static void put_iges_weights(iges *f, const double *weight, size_t count) {
    for (size_t k = 0; k < count; k++) put_real(f, weight ? weight[k] : 1, ',');
}

/* behind the data: no associativity, one property, the name */
static void put_name_pointer(iges *f, long name) {
    put_integer(f, 0, ',');
    put_integer(f, 1, ',');
    put_integer(f, name, ';');
    end_line(f);
}

static bool is_same(wcut_vec3 a, wcut_vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

static void put_iges_curve(iges *f, const wcut_curve *c, long name) {
    const int n = c->control_count, p = c->degree;
    put_integer(f, 126, ',');
    put_integer(f, n - 1, ',');
    put_integer(f, p, ',');
    put_integer(f, 0, ','); /* not said to be planar */
    put_integer(f, is_same(c->control[0], c->control[n - 1]), ',');
    put_integer(f, c->weights == NULL, ',');
    put_integer(f, 0, ',');
    put_reals(f, c->knots, (size_t)n + (size_t)p + 1);
    put_iges_weights(f, c->weights, (size_t)n);
    put_reals(f, &c->control->x, 3 * (size_t)n);
    put_real(f, c->knots[p], ',');
    put_real(f, c->knots[n], ',');
    for (int k = 0; k < 3; k++) put_real(f, 0, ',');
    put_name_pointer(f, name);
}

/* whether the two borders of a direction are one curve: u, whose poles are steps of 1, or v */
static bool is_iges_closed(const wcut_surface *s, bool along_u) {
    const size_t columns = (size_t)s->count_u, rows = (size_t)s->count_v;
    const size_t count = along_u ? rows : columns, step = along_u ? columns : 1;
    const size_t across = along_u ? columns - 1 : columns * (rows - 1);
    for (size_t k = 0; k < count; k++)
        if (!is_same(s->control[k * step], s->control[k * step + across])) return false;
    return true;
}

static void put_surface(iges *f, const wcut_surface *s, long name) {
    const size_t count = (size_t)s->count_u * (size_t)s->count_v;

    /* counts, degrees, closed, rational, periodic */
    put_integer(f, 128, ',');
    put_integer(f, s->count_u - 1, ',');
    put_integer(f, s->count_v - 1, ',');
    put_integer(f, s->degree_u, ',');
    put_integer(f, s->degree_v, ',');
    put_integer(f, is_iges_closed(s, true), ',');
    put_integer(f, is_iges_closed(s, false), ',');
    put_integer(f, s->weights == NULL, ',');
    put_integer(f, 0, ',');
    put_integer(f, 0, ',');

    /* knots, weights, control points */
    put_reals(f, s->knots_u, (size_t)s->count_u + (size_t)s->degree_u + 1);
    put_reals(f, s->knots_v, (size_t)s->count_v + (size_t)s->degree_v + 1);
    put_iges_weights(f, s->weights, count);
    put_reals(f, &s->control->x, 3 * count);

    /* the domain in both directions */
    put_real(f, s->knots_u[s->degree_u], ',');
    put_real(f, s->knots_u[s->count_u], ',');
    put_real(f, s->knots_v[s->degree_v], ',');
    put_real(f, s->knots_v[s->count_v], ',');
    put_name_pointer(f, name);
}

static void put_name(iges *f, const char *name) {
    put_integer(f, 406, ',');
    put_integer(f, 1, ',');
    put_iges_string(f, name[0] ? name : "_", ';');
    end_line(f);
}

/* the data of entity k of the directory: shape k / 2, its name before its geometry */
static entry put_entity(iges *f, const wcut_shape *shape, long k) {
    const wcut_shape *s = shape + k / 2;
    entry e;
    f->entity = 2 * k + 1;
    if (k % 2 == 0) {
        e = (entry){406, 15, f->sequence, 0, "00020200"};
        put_name(f, s->name);
    } else if (s->surface) {
        e = (entry){128, 0, f->sequence, 0, "00000000"};
        put_surface(f, s->surface, f->entity - 2);
    } else {
        e = (entry){126, 0, f->sequence, 0, "00000000"};
        put_iges_curve(f, s->curve, f->entity - 2);
    }
    e.lines = f->sequence - e.first;
    return e;
}

/* ---- the directory, written when the lines of the data are known ---- */

static void print_iges_entry(char two[2 * LINE], const entry *e, long sequence) {
    const long field[2][9] = {{e->type, e->first, 0, 0, 0, 0, 0, 0, 0}, {e->type, 0, 0, e->lines, e->form, 0, 0, 0, 0}};
    for (int row = 0; row < 2; row++) {
        char *line = two + (size_t)row * LINE;
        for (int k = 0; k < 9; k++) put_iges_field(line + 8 * (size_t)k, 8, field[row][k]);
        line[72] = 'D';
        put_iges_field(line + 73, 7, sequence + row);
        line[80] = '\n';
    }
    memcpy(two + 64, e->status, 8);
    memset(two + LINE + 40, ' ', 24); /* two reserved fields, no label */
}

static wcut_status refuse_length(wcut_error *error) {
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "found more than %d lines of IGES, expected at most that: use STEP",
                     LINES_MAX);
}

static wcut_status write_iges_all(wcut_file *file, wcut_text *text, int count, const wcut_shape *shape,
                                  wcut_error *error) {
    iges f = {.text = text};
    const long global = put_iges_head(&f, shape[0].name), entities = 2L * count;
    const uint64_t directory = (uint64_t)(1 + global) * LINE;
    wcut_text_flush(text);

    /* the directory's entries go before the data, where room is left for them */
    wcut_file_seek(file, directory + (uint64_t)entities * 2 * LINE);
    begin_section(&f, 'P', DATA);
    for (long k = 0; k < entities; k++) {
        char two[2 * LINE];
        const entry e = put_entity(&f, shape, k);
        if (f.sequence > LINES_MAX) return refuse_length(error);
        print_iges_entry(two, &e, 2 * k + 1);
        wcut_file_write_at(file, directory + (uint64_t)k * 2 * LINE, two, sizeof two);
    }

    /* the lines of each section */
    const long data = f.sequence - 1;
    begin_section(&f, 'T', GLOBAL);
    f.used = snprintf(f.line, sizeof f.line, "S%7dG%7ldD%7ldP%7ld", 1, global, 2 * entities, data);
    end_line(&f);

    wcut_text_flush(text);

    /* the file appears whole or not at all */
    return wcut_file_commit(file, error);
}

static wcut_status check_iges(int count, const wcut_shape *shape, const char *path, wcut_error *error) {
    wcut_status status = wcut_shapes_check(count, shape, path, error);
    for (int k = 0; status == WCUT_OK && k < count; k++)
        if (shape[k].solid)
            status = wcut_fail(error, WCUT_BAD_ARGUMENT, "shape %d: found a solid, expected a surface or a curve", k);
    if (status == WCUT_OK && count > LINES_MAX / 4) status = refuse_length(error);
    return status;
}

wcut_status wcut_iges_write(int count, const wcut_shape *shape, const char *path, wcut_error *error) {
    wcut_file *file = NULL;
    wcut_text text = {0};
    wcut_status status = check_iges(count, shape, path, error);
    if (status == WCUT_OK) status = wcut_file_create(path, &file, error);
    if (status != WCUT_OK) return status;
    if (wcut_text_create(&text, file))
        status = write_iges_all(file, &text, count, shape, error);
    else
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    wcut_text_destroy(&text);
    wcut_file_destroy(file);
    return status;
}
