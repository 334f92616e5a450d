/* The clear text encoding of STEP (ISO 10303-21), read: instances by their number, records by their name. */
#include "io/cad/part21_read.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/decimal.h"

enum { DEPTH_MAX = 64 };

/* ---- a text without blanks and comments ---- */

/* behind the comment that begins at p; NULL: it does not end */
static const char *skip_comment(const char *p, const char *end) {
    for (p += 2; p + 1 < end; p++)
        if (p[0] == '*' && p[1] == '/') return p + 2;
    return NULL;
}

/* copy a string with its quotes; a quote in it stands twice, which is two strings to this. NULL: it does not end */
static const char *copy_string(const char *p, const char *end, char **to) {
    *(*to)++ = *p++;
    while (p < end && *p != '\'' && *p) *(*to)++ = *p++;
    if (p == end || *p == '\0') return NULL;
    *(*to)++ = *p++;
    return p;
}

/* squeeze in place; gives the new length, or 0 where it is refused */
static size_t squeeze(wcut_curve_reader *r, char *text, size_t length) {
    const char *p = text, *end = text + length;
    char *to = text;

    /* white space and comments go, strings stay as they are */
    while (p && p < end) {
        const unsigned char c = (unsigned char)*p;
        if (c == '\'') {
            p = copy_string(p, end, &to);
        } else if (c == '/' && p + 1 < end && p[1] == '*') {
            p = skip_comment(p, end);
        } else if (c <= 0x20 && c != 0) {
            p++;
        } else if (c == 0 || c >= 0x7f) {
            wcut_curves_refuse(r, "byte %ld: found the character %d outside a string, expected ASCII", (long)(p - text),
                               c);
            return 0;
        } else {
            *to++ = *p++;
        }
    }

    /* copy_string and skip_comment give NULL where the text ends first */
    if (!p) {
        wcut_curves_refuse(r, "found a string or comment without an end");
        return 0;
    }

    *to = '\0';

    return (size_t)(to - text);
}

/* ---- statements ---- */

/* the end of the statement at p, its ";"; NULL: refused. Parentheses are balanced up to there. */
static char *end_statement(wcut_curve_reader *r, char *p) {
    int depth = 0;
    const char *from = p;
    for (; *p && !(*p == ';' && depth == 0); p++) {
        if (*p == '\'') {
            for (p++; *p != '\''; p++) {
            } /* squeeze saw its end */
            continue;
        }
        depth += (*p == '(') - (*p == ')');
        if (depth < 0 || depth > DEPTH_MAX || *p == ';') break;
    }
    if (*p == ';' && depth == 0) return p;
    wcut_curves_refuse(r, "found \"%.40s\", expected parentheses in pairs, not deeper than %d, and a semicolon", from,
                       DEPTH_MAX);
    return NULL;
}

/* #12= at p: its number and what is behind it; NULL: refused */
static char *read_part21_number(wcut_curve_reader *r, char *p, long *id) {
    char *at = p + 1;
    long n = 0;
    for (; *at >= '0' && *at <= '9' && n < LONG_MAX / 100; at++) n = 10 * n + (*at - '0');
    if (at > p + 1 && *at == '=') {
        *id = n;
        return at + 1;
    }
    wcut_curves_refuse(r, "found \"%.40s\", expected #, a number and =", p);
    return NULL;
}

static bool add_part21_instance(wcut_p21_file *f, size_t *room, long id, const char *body) {
    if ((size_t)f->count == *room) {
        const size_t wanted = *room ? 2 * *room : 1024;
        wcut_p21_instance *grown = wanted <= INT_MAX ? wcut_grow(f->instance, wanted * sizeof *grown) : NULL;
        if (!grown) return wcut_curves_refuse_memory(f->reader);
        f->instance = grown;
        *room = wanted;
    }
    f->instance[f->count++] = (wcut_p21_instance){id, body};
    return true;
}

static bool read_statements(wcut_p21_file *f, char *p) {
    size_t room = 0;
    while (*p) {
        char *end = end_statement(f->reader, p);
        long id = 0;
        if (!end) return false;
        *end = '\0';
        if (*p == '#') {
            char *body = read_part21_number(f->reader, p, &id);
            if (!body || !add_part21_instance(f, &room, id, body)) return false;
        }
        if (strcmp(p, "END-ISO-10303-21") == 0) return true;
        p = end + 1;
    }
    return wcut_curves_refuse(f->reader, "found the end of the file, expected END-ISO-10303-21;");
}

static int compare_record_numbers(const void *a, const void *b) {
    const long i = ((const wcut_p21_instance *)a)->id, j = ((const wcut_p21_instance *)b)->id;
    return (i > j) - (i < j);
}

bool wcut_p21_open(wcut_curve_reader *r, char *text, size_t length, wcut_p21_file *f) {
    *f = (wcut_p21_file){.reader = r};
    if (squeeze(r, text, length) == 0) return wcut_curves_refuse(r, "found nothing, expected ISO-10303-21;");
    if (strncmp(text, "ISO-10303-21;", 13) != 0)
        return wcut_curves_refuse(r, "found \"%.20s\", expected ISO-10303-21;", text);
    if (!read_statements(f, text)) return false;
    if (f->count > 0) qsort(f->instance, (size_t)f->count, sizeof *f->instance, compare_record_numbers);
    for (int k = 1; k < f->count; k++)
        if (f->instance[k].id == f->instance[k - 1].id)
            return wcut_curves_refuse(r, "found #%ld twice, expected each number once", f->instance[k].id);
    return true;
}

void wcut_p21_close(wcut_p21_file *f) { free(f->instance); }

const char *wcut_p21_find(const wcut_p21_file *f, long id) {
    const wcut_p21_instance key = {id, NULL};
    const wcut_p21_instance *found =
        f->count ? bsearch(&key, f->instance, (size_t)f->count, sizeof key, compare_record_numbers) : NULL;
    return found ? found->body : NULL;
}

/* ---- records and items; parentheses are balanced ---- */

/* from a string's first quote to its last, or to the end: a record that is cut short may begin inside one */
static const char *skip_string(const char *p) {
    for (p++; *p && *p != '\''; p++) {
    }
    return p;
}

/* from an item (or a keyword) to the "," or ")" behind it, or to the end */
static const char *skip_item(const char *p) {
    int depth = 0;
    for (; *p && !(depth == 0 && (*p == ',' || *p == ')')); p++) {
        if (*p == '\'') p = skip_string(p);
        if (*p == '\0') break;
        depth += (*p == '(') - (*p == ')');
    }
    return p;
}

static bool has_name(const char *p, const char *name) {
    const size_t n = strlen(name);
    return strncmp(p, name, n) == 0 && p[n] == '(';
}

const char *wcut_p21_record(const char *body, const char *name) {
    if (body[0] != '(') return has_name(body, name) ? body + strlen(name) : NULL;
    for (const char *p = body + 1; *p && *p != ')';) {
        if (has_name(p, name)) return p + strlen(name);
        for (; *p && *p != '(' && *p != ')'; p++)
            if (*p == '\'' && *(p = skip_string(p)) == '\0') break;
        int depth = 0;
        do {
            if (*p == '\'') p = skip_string(p);
            depth += (*p == '(') - (*p == ')');
            if (*p) p++;
        } while (*p && depth > 0);
    }
    return NULL;
}

const char *wcut_p21_next(const char *item) {
    const char *end = skip_item(item);
    return *end == ',' ? end + 1 : NULL;
}

const char *wcut_p21_item(const char *list, int k) {
    if (!list || *list != '(' || list[1] == ')') return NULL;
    const char *p = list + 1;
    while (p && k-- > 0) p = wcut_p21_next(p);
    return p;
}

int wcut_p21_length(const char *list) {
    int n = 0;
    for (const char *p = wcut_p21_item(list, 0); p; p = wcut_p21_next(p)) n++;
    return n;
}

static bool ends_item(const char *p) { return *p == ',' || *p == ')'; }

bool wcut_p21_read_real(const char *item, double *value) {
    const char *end = item ? wcut_decimal_read(item, value) : item;
    return end != item && ends_item(end) && isfinite(*value);
}

bool wcut_p21_read_integer(const char *item, int min, int max, int *value) {
    long n = 0;
    const char *p = item;
    if (!p) return false;
    for (; *p >= '0' && *p <= '9' && n < INT_MAX; p++) n = 10 * n + (*p - '0');
    if (p == item || !ends_item(p) || n < min || n > max) return false;
    *value = (int)n;
    return true;
}

bool wcut_p21_read_reference(const char *item, long *id) {
    const char *p = item;
    long n = 0;
    if (!p || *p != '#') return false;
    for (p++; *p >= '0' && *p <= '9' && n < LONG_MAX / 100; p++) n = 10 * n + (*p - '0');
    if (p == item + 1 || !ends_item(p)) return false;
    *id = n;
    return true;
}

bool wcut_p21_is(const char *item, const char *word) {
    const size_t n = strlen(word);
    return item && strncmp(item, word, n) == 0 && (ends_item(item + n) || item[n] == '(');
}
