/* Curves from IGES files (5.3 and before): rational B-splines (126), lines (110), strings of points (106). */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "curve_set.h"
#include "decimal.h"
#include "fail.h"

enum { COLUMNS = 80, NUMBER = 7, FIELD = 8 };

/* the lines of a file and where its sections begin */
typedef struct iges {
    wcut_curve_reader *reader;
    int lines;
    const char **line;                /* each of at least COLUMNS characters */
    int global, directory, data, end; /* lines */
    char separator, terminator;
    double scale; /* [mm] */
} iges;

/* values one after the other, across the lines of a section */
typedef struct cursor {
    const iges *f;
    int line, end; /* the next line, and the one not to be read */
    int at, width;
    bool ended; /* a terminator was passed */
} cursor;

/* ---- lines and sections ---- */

static bool find_lines(iges *f, char *text, size_t length) {
    const size_t most = length / COLUMNS + 1;
    f->line = wcut_io_alloc(most, sizeof *f->line);
    if (!f->line) return wcut_curves_refuse_memory(f->reader);
    for (char *p = text, *end = text + length; p < end;) {
        char *feed = memchr(p, '\n', (size_t)(end - p)), *stop = feed ? feed : end;
        const size_t width = (size_t)(stop - p) - (stop > p && stop[-1] == '\r');
        if (width > 0 && (width < COLUMNS || memchr(p, 0, width)))
            return wcut_curves_refuse(f->reader, "line %d: found %zu columns, expected 80 of text", f->lines + 1,
                                      width);
        if (width > 0) f->line[f->lines++] = p;
        p = stop + 1;
    }
    return true;
}

static int section_end(const iges *f, int from, char letter) {
    while (from < f->lines && f->line[from][72] == letter) from++;
    return from;
}

static bool find_sections(iges *f) {
    f->global = section_end(f, 0, 'S');
    f->directory = section_end(f, f->global, 'G');
    f->data = section_end(f, f->directory, 'D');
    f->end = section_end(f, f->data, 'P');
    if (f->global == 0 || f->directory == f->global || f->end >= f->lines || f->line[f->end][72] != 'T')
        return wcut_curves_refuse(f->reader, "line %d: found no section in its order, expected S, G, D, P and T",
                                  f->end + 1);
    if ((f->data - f->directory) % 2 != 0)
        return wcut_curves_refuse(f->reader, "found an odd number of directory lines, expected pairs");
    return true;
}

/* ---- values ---- */

/* the next character, or a zero at the end; the line is known to be wide enough */
static char next_char(cursor *c) {
    if (c->at == c->width) {
        if (c->line + 1 >= c->end) return '\0';
        c->line++;
        c->at = 0;
    }
    return c->f->line[c->line][c->at++];
}

/* one value without blanks into token, its end passed; "" where it is empty or behind the end */
static void read_token(cursor *c, char *token, size_t size) {
    size_t used = 0;
    for (char ch; !c->ended && (ch = next_char(c)) != c->f->separator;) {
        if (ch == c->f->terminator || ch == '\0') {
            c->ended = true;
            break;
        }
        if (ch == 'H' && used > 0 && used < size && token[used - 1] >= '0' && token[used - 1] <= '9') {
            token[used] = '\0'; /* a string: its characters are not looked at for separators */
            for (int n = atoi(token); n > 0 && next_char(c); n--) {
            }
            used = 0;
        } else if (ch != ' ' && used < size - 1) {
            token[used++] = ch;
        }
    }
    token[used] = '\0';
}

static bool read_real(cursor *c, double *value) {
    char token[64];
    read_token(c, token, sizeof token);
    for (char *p = token; *p; p++)
        if (*p == 'D' || *p == 'd') *p = 'E';
    const char *end = wcut_decimal_read(token, value);
    return end != token && *end == '\0' && isfinite(*value);
}

static bool read_int(cursor *c, int least, int most, int *value) {
    double real = 0;
    if (!read_real(c, &real) || real != floor(real) || real < least || real > most) return false;
    *value = (int)real;
    return true;
}

/* ---- the global section ---- */

static bool read_global(iges *f) {
    static const double millimetres[] = {0, 25.4, 1, 0, 304.8, 1609344, 1000, 1e6, 0.0254, 1e-3, 10, 2.54e-5};
    cursor c = {f, f->global, f->directory, 0, 72, false};
    char token[64];
    double scale = 1;
    int unit = 1;
    f->separator = ',';
    f->terminator = ';';
    /* 1H,,1H;, : each says itself; only the usual ones are read */
    const char *line = f->line[f->global];
    if (!(strncmp(line, "1H,,1H;,", 8) == 0 || strncmp(line, ",,", 2) == 0 || strncmp(line, "1H,,,", 5) == 0))
        return wcut_curves_refuse(f->reader, "found separators other than , and ; in the global section");
    for (int k = 1; k <= 12; k++) {
        if (k == 1 && strncmp(line, "1H,", 3) == 0)
            c.at = 4;
        else if (k == 2 && strncmp(line, "1H,,1H;,", 8) == 0)
            c.at = 8;
        else
            read_token(&c, token, sizeof token);
    }
    cursor before = c;
    read_token(&c, token, sizeof token);
    if (token[0] && !read_real(&before, &scale)) scale = 0;
    before = c;
    read_token(&c, token, sizeof token);
    if (token[0] && !read_int(&before, 1, 11, &unit)) unit = 0;
    f->scale = millimetres[unit] / scale;
    if (!(f->scale > 0) || !isfinite(f->scale))
        return wcut_curves_refuse(f->reader,
                                  "found no unit of length or scale, expected one of the units 1, 2, 4 to 11");
    return true;
}

/* ---- entities ---- */

typedef struct entry {
    int type, data, transformation, form, lines;
    char status[FIELD + 1];
} entry;

/* field k of a directory line, blank as 0; false: it is no number */
static bool read_field(const char *line, int k, int *value) {
    const char *p = line + (size_t)FIELD * (size_t)k, *end = p + FIELD;
    int n = 0, sign = 1;
    while (p < end && *p == ' ') p++;
    if (p < end && *p == '-') sign = -1, p++;
    for (; p < end && *p >= '0' && *p <= '9'; p++) n = 10 * n + (*p - '0');
    while (p < end && *p == ' ') p++;
    *value = sign * n;
    return p == end;
}

static bool read_entry(iges *f, int at, entry *e) {
    const char *first = f->line[at], *second = f->line[at + 1];
    bool ok = read_field(first, 0, &e->type) && read_field(first, 1, &e->data) &&
              read_field(first, 6, &e->transformation) && read_field(second, 3, &e->lines) &&
              read_field(second, 4, &e->form);
    memcpy(e->status, first + 64, FIELD);
    e->status[FIELD] = '\0';
    ok = ok && e->data >= 1 && e->lines >= 1 && e->data <= f->end - f->data &&
         e->lines <= f->end - f->data - e->data + 1;
    return ok || wcut_curves_refuse(f->reader, "line %d: found a directory entry whose data are not there", at + 1);
}

static bool read_numbers(cursor *c, int count, double *value) {
    for (int k = 0; k < count; k++)
        if (!read_real(c, &value[k])) return false;
    return true;
}

static void scale_points(const iges *f, wcut_vec3 *p, int count) {
    for (int k = 0; f->scale != 1 && k < count; k++)
        p[k] = (wcut_vec3){p[k].x * f->scale, p[k].y * f->scale, p[k].z * f->scale};
}

static bool refuse_data(iges *f, const char *place) {
    return wcut_curves_refuse(f->reader, "%s: found too few or other values than its kind has", place);
}

/* type 126; NULL: refused or left out */
static wcut_curve *read_spline(iges *f, cursor *c, const char *place) {
    /* a value takes two characters at least, so what the data cannot hold is refused before memory is asked for */
    const int most = (c->end - c->line) * 32;
    int last = 0, degree = 0, flag[4];
    bool ok = read_int(c, 1, most, &last) && read_int(c, 1, 1000, &degree);
    for (int k = 0; ok && k < 4; k++) ok = read_int(c, 0, 1, &flag[k]);
    if (!ok) return refuse_data(f, place), NULL;
    if (degree > WCUT_DEGREE_MAX) return wcut_curves_leave_out(f->reader, "a degree above 7"), NULL;
    const int count = last + 1, knots = count + degree + 1;
    double *value = wcut_io_alloc((size_t)knots + 4 * (size_t)count, sizeof *value);
    if (!value) return wcut_curves_refuse_memory(f->reader), NULL;
    double *weight = value + knots;
    wcut_vec3 *control = (wcut_vec3 *)(weight + count);
    wcut_curve *curve = NULL;
    if (read_numbers(c, knots + 4 * count, value)) {
        bool same = true;
        for (int k = 1; k < count; k++) same = same && weight[k] == weight[0];
        scale_points(f, control, count);
        const bool is_rational = !(same && weight[0] > 0);
        curve = wcut_curves_make(f->reader, place, degree, count, value, control, is_rational ? weight : NULL);
    } else {
        refuse_data(f, place);
    }
    free(value);
    return curve;
}

/* type 110, or 106 with `count` points from `first` on; NULL: refused */
static wcut_curve *read_points(iges *f, cursor *c, const char *place, int count) {
    wcut_vec3 *point = wcut_io_alloc((size_t)count, sizeof *point);
    wcut_curve *curve = NULL;
    if (!point) return wcut_curves_refuse_memory(f->reader), NULL;
    if (read_numbers(c, 3 * count, &point->x)) {
        scale_points(f, point, count);
        curve = wcut_curves_polyline(f->reader, place, count, point);
    } else {
        refuse_data(f, place);
    }
    free(point);
    return curve;
}

static bool is_curve(const entry *e) {
    static const int type[] = {100, 102, 104, 106, 110, 112, 126, 130, 142};
    for (size_t k = 0; k < sizeof type / sizeof *type; k++)
        if (e->type == type[k]) return e->type != 106 || e->form <= 3 || (e->form >= 11 && e->form <= 13);
    return false;
}

/* NULL: refused or left out */
static wcut_curve *read_curve(iges *f, const entry *e, cursor *c, const char *place) {
    int kind = 0, count = 0;
    char text[40];
    if (e->type == 126) return read_spline(f, c, place);
    if (e->type == 110 && e->form == 0) return read_points(f, c, place, 2);
    if (e->type == 106 && (e->form == 2 || e->form == 12)) {
        if (read_int(c, 2, 2, &kind) && read_int(c, 2, (c->end - c->line) * 32, &count))
            return read_points(f, c, place, count);
        return refuse_data(f, place), NULL;
    }
    snprintf(text, sizeof text, "type %d form %d", e->type, e->form);
    wcut_curves_leave_out(f->reader, text);
    return NULL;
}

static bool add_entity(iges *f, int at) {
    entry e = {0};
    char place[40];
    int type = 0;
    if (!read_entry(f, at, &e)) return false;
    if (!is_curve(&e)) return true;
    snprintf(place, sizeof place, "line %d", at + 1);
    if (e.transformation != 0) return wcut_curves_leave_out(f->reader, "a curve with a transformation"), true;
    if (e.status[3] == '1' || e.status[3] == '3' || (e.status[4] == '0' && e.status[5] == '5'))
        return wcut_curves_leave_out(f->reader, "a piece of another entity"), true;
    const int first = f->data + e.data - 1;
    cursor c = {f, first, first + e.lines, 0, 64, false};
    if (!read_int(&c, e.type, e.type, &type)) return refuse_data(f, place);
    wcut_curve *curve = read_curve(f, &e, &c, place);
    if (curve) return wcut_curves_add(f->reader, curve, "", 0);
    return f->reader->failure.status == WCUT_OK;
}

bool wcut_curves_fill_iges(wcut_curve_reader *r, char *text, size_t length) {
    iges f = {.reader = r};
    bool done = find_lines(&f, text, length) && find_sections(&f) && read_global(&f);
    for (int at = f.directory; done && at < f.data; at += 2) done = add_entity(&f, at);
    free(f.line);
    return done;
}
