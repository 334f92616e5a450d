/* IGES files (5.3 and before), read: lines, sections, values, the directory. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/cad/iges_read.h"
#include "io/file/decimal.h"
#include "io/file/unit.h"

enum { COLUMNS = 80, FIELD = WCUT_IGES_FIELD };

/* ---- lines and sections ---- */

static bool is_blank_line(const char *p, size_t width) {
    while (width > 0 && (p[width - 1] == ' ' || p[width - 1] == '\t')) width--;
    return width == 0;
}

/* Columns are characters: one that UTF-8 writes in several bytes becomes one byte where the line is too long. Gives the
   line's width. */
static size_t squeeze_characters(char *line, size_t width) {
    size_t kept = 0;
    if (width <= COLUMNS) return width;
    for (size_t k = 0; k < width; k++) {
        const unsigned char c = (unsigned char)line[k];
        if ((c & 0xc0) == 0x80) continue;
        line[kept++] = c < 0x80 ? (char)c : '?';
    }
    return kept;
}

static bool find_lines(wcut_iges *f, char *text, size_t length) {
    const size_t max = length / COLUMNS + 1;
    f->line = wcut_alloc(max, sizeof *f->line);
    if (!f->line) return wcut_curves_refuse_memory(f->reader);
    for (char *p = text, *end = text + length; p < end;) {
        char *feed = memchr(p, '\n', (size_t)(end - p)), *stop = feed ? feed : end;
        size_t width = (size_t)(stop - p) - (stop > p && stop[-1] == '\r');
        if (is_blank_line(p, width)) width = 0;
        width = squeeze_characters(p, width);
        if (width > 0 && (width < COLUMNS || memchr(p, 0, width)))
            return wcut_curves_refuse(f->reader, "line %d: found %zu columns, expected 80 of text", f->lines + 1,
                                      width);
        if (width > 0) f->line[f->lines++] = p;
        p = stop + 1;
    }
    return true;
}

static int section_end(const wcut_iges *f, int from, char letter) {
    while (from < f->lines && f->line[from][72] == letter) from++;
    return from;
}

static bool find_sections(wcut_iges *f) {
    f->global = section_end(f, 0, 'S');
    f->directory = section_end(f, f->global, 'G');
    f->data = section_end(f, f->directory, 'D');
    f->end = section_end(f, f->data, 'P');
    if (f->global == 0 || f->directory == f->global || f->end >= f->lines || f->line[f->end][72] != 'T')
        return wcut_curves_refuse(f->reader, "line %d: found a section out of order, expected S, G, D, P, T",
                                  f->end + 1);
    if ((f->data - f->directory) % 2 != 0)
        return wcut_curves_refuse(f->reader, "found an odd number of directory lines, expected pairs");
    return true;
}

/* ---- values ---- */

/* the next character, or a zero at the end; the line is known to be wide enough */
static char next_char(wcut_iges_cursor *c) {
    if (c->at == c->width) {
        if (c->line + 1 >= c->end) return '\0';
        c->line++;
        c->at = 0;
    }
    return c->f->line[c->line][c->at++];
}

/* one value without blanks into token, its end passed; "" where it is empty or behind the end */
static void read_token(wcut_iges_cursor *c, char *token, size_t size) {
    size_t used = 0;

    /* character by character, until the separator or the end of the data */
    for (char ch; !c->ended && (ch = next_char(c)) != c->f->separator;) {
        if (ch == c->f->terminator || ch == '\0') {
            c->ended = true;
            break;
        }
        if (ch == 'H' && used > 0 && used < size && token[used - 1] >= '0' && token[used - 1] <= '9') {
            /* a string: its characters are not looked at for separators, and it is all there is of the value */
            token[used] = '\0';
            used = 0;
            for (int n = atoi(token); n > 0; n--) {
                const char inside = next_char(c);
                if (inside == '\0') break;
                if (used < size - 1) token[used++] = inside;
            }
        } else if (ch != ' ' && used < size - 1) {
            token[used++] = ch;
        }
    }
    token[used] = '\0';
}

bool wcut_iges_real(wcut_iges_cursor *c, double *value) {
    char token[64];
    read_token(c, token, sizeof token);
    for (char *p = token; *p; p++)
        if (*p == 'D' || *p == 'd') *p = 'E';
    const char *end = wcut_decimal_read(token, value);
    return end != token && *end == '\0' && isfinite(*value);
}

bool wcut_iges_int(wcut_iges_cursor *c, int min, int max, int *value) {
    double real = 0;
    if (!wcut_iges_real(c, &real) || real != floor(real) || real < min || real > max) return false;
    *value = (int)real;
    return true;
}

void wcut_iges_pass(wcut_iges_cursor *c) {
    char token[64];
    read_token(c, token, sizeof token);
}

bool wcut_iges_reals(wcut_iges_cursor *c, int count, double *value) {
    for (int k = 0; k < count; k++)
        if (!wcut_iges_real(c, &value[k])) return false;
    return true;
}

/* ---- the global section ---- */

/* [mm] of a unit by its name; 0: it is unknown. A mil of IGES is a thousandth of an inch, a mile MI */
static double find_unit(const char *name) {
    size_t n = strlen(name);
    while (n > 0 && name[n - 1] == ' ') n--;
    if (n == 2 && strncasecmp(name, "MI", 2) == 0) return 1609344;
    if (n == 3 && strncasecmp(name, "UIN", 3) == 0) return 2.54e-5;
    return wcut_unit_find(name, n);
}

static bool read_global(wcut_iges *f) {
    static const double millimetres[] = {0, 25.4, 1, 0, 304.8, 1609344, 1000, 1e6, 0.0254, 1e-3, 10, 2.54e-5};

    /* the separators are those of the standard until the file says otherwise */
    wcut_iges_cursor c = {f, f->global, f->directory, 0, 72, false};
    char token[64];
    double scale = 1;
    int unit = 1;
    f->separator = ',';
    f->terminator = ';';
    /* 1H,,1H;, : each says itself; only the usual ones are read */
    const char *line = f->line[f->global];
    if (!(strncmp(line, "1H,,1H;,", 8) == 0 || strncmp(line, ",,", 2) == 0 || strncmp(line, "1H,,,", 5) == 0))
        return wcut_curves_refuse(f->reader, "found separators other than , and ; in the global section");

    /* twelve fields before the scale */
    for (int k = 1; k <= 12; k++) {
        if (k == 1 && strncmp(line, "1H,", 3) == 0)
            c.at = 4;
        else if (k == 2 && strncmp(line, "1H,,1H;,", 8) == 0)
            c.at = 8;
        else
            read_token(&c, token, sizeof token);
    }
    /* the model's scale, the unit's number, and its name where the number is 3 or missing */
    wcut_iges_cursor before = c;
    read_token(&c, token, sizeof token);
    if (token[0] && !wcut_iges_real(&before, &scale)) scale = 0;
    before = c;
    read_token(&c, token, sizeof token);

    /* the unit by its number, or by its name */
    const bool is_given = token[0] != '\0';
    if (is_given && !wcut_iges_int(&before, 1, 11, &unit)) unit = 0;
    read_token(&c, token, sizeof token);
    const bool by_name = unit == 3 || (!is_given && token[0]);
    f->scale = (by_name ? find_unit(token) : millimetres[unit]) / scale;

    if (f->scale > 0 && isfinite(f->scale)) return true;
    return by_name
               ? wcut_curves_refuse(f->reader,
                                    "found the unit \"%.20s\", expected MM, CM, M, KM, UM, IN, FT, MI, MIL "
                                    "or UIN",
                                    token)
               : wcut_curves_refuse(f->reader, "found no unit of length or scale, expected one of the units 1 to 11");
}

/* ---- the directory ---- */

/* field k of a directory line, blank as 0; false: it is no number */
static bool read_iges_field(const char *line, int k, int *value) {
    const char *p = line + (size_t)FIELD * (size_t)k, *end = p + FIELD;
    int n = 0, sign = 1;
    while (p < end && *p == ' ') p++;
    if (p < end && *p == '-') sign = -1, p++;
    for (; p < end && *p >= '0' && *p <= '9'; p++) n = 10 * n + (*p - '0');
    while (p < end && *p == ' ') p++;
    *value = sign * n;
    return p == end;
}

bool wcut_iges_find(wcut_iges *f, int at, wcut_iges_entry *entry) {
    const char *first = f->line[at], *second = f->line[at + 1];
    wcut_iges_entry e = {.at = at};
    bool ok = read_iges_field(first, 0, &e.type) && read_iges_field(first, 1, &e.data) &&
              read_iges_field(first, 6, &e.transformation) && read_iges_field(second, 3, &e.lines) &&
              read_iges_field(second, 4, &e.form);
    memcpy(e.status, first + 64, FIELD);
    ok = ok && e.data >= 1 && e.lines >= 1 && e.data <= f->end - f->data && e.lines <= f->end - f->data - e.data + 1;
    *entry = e;
    return ok || wcut_curves_refuse(f->reader, "line %d: found a directory entry without its parameter data", at + 1);
}

bool wcut_iges_open(wcut_iges *f, const wcut_iges_entry *e, wcut_iges_cursor *c) {
    const int first = f->data + e->data - 1;
    int type = 0;
    *c = (wcut_iges_cursor){f, first, first + e->lines, 0, 64, false};
    return wcut_iges_int(c, e->type, e->type, &type) ||
           wcut_curves_refuse(f->reader, "line %d: found too few values, or values of another kind, for this entity",
                              e->at + 1);
}

bool wcut_iges_begin(wcut_curve_reader *r, char *text, size_t length, wcut_iges *f) {
    *f = (wcut_iges){.reader = r};
    if (!find_lines(f, text, length) || !find_sections(f) || !read_global(f)) return false;
    f->mark = wcut_alloc((size_t)(f->data - f->directory) / 2 + 1, sizeof *f->mark);
    return f->mark || wcut_curves_refuse_memory(r);
}

void wcut_iges_end(wcut_iges *f) {
    free(f->mark);
    free(f->line);
}
