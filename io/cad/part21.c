/* The clear text encoding of STEP (ISO 10303-21): numbered instances, reals, strings. */
#include "io/cad/part21.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "io/file/number.h"
#include "io/file/utf8.h"

enum { A_LINE = 8 };

/* ---- into a room ---- */

/* the shortest digits, a point behind the first ones where there is none, a capital exponent */
static size_t print_real(char *to, double value) {
    const size_t length = (size_t)wcut_number_print(value, to);
    char *exponent = memchr(to, 'e', length);
    if (exponent) *exponent = 'E';
    if (memchr(to, '.', length)) return length;
    char *end = exponent ? exponent : to + length;
    memmove(end + 1, end, (size_t)(to + length - end));
    *end = '.';
    return length + 1;
}

static size_t print_words(char *to, const char *words) {
    const size_t n = strlen(words);
    memcpy(to, words, n);
    return n;
}

static size_t print_begin(char *to, wcut_id id) {
    size_t used = print_words(to, "#");
    used += (size_t)wcut_integer_print((uint64_t)id, to + used);
    to[used++] = '=';
    return used;
}

static wcut_id put_part21_triple(wcut_part21 *p, const char *words, wcut_vec3 v) {
    char *room = wcut_text_room(p->text);
    const double value[3] = {v.x, v.y, v.z};
    size_t used = print_begin(room, ++p->last);
    used += print_words(room + used, words);
    for (int k = 0; k < 3; k++) {
        room[used++] = k ? ',' : '(';
        used += print_real(room + used, value[k]);
    }
    used += print_words(room + used, "));\n");
    p->text->count += used;
    return p->last;
}

/* ---- instances ---- */

wcut_id wcut_p21_begin(wcut_part21 *p) {
    char *room = wcut_text_room(p->text);
    p->text->count += print_begin(room, ++p->last);
    return p->last;
}

wcut_id wcut_p21_put(wcut_part21 *p, const char *format, ...) {
    const wcut_id id = wcut_p21_begin(p);
    va_list arguments;
    va_start(arguments, format);
    char *room = wcut_text_room(p->text);
    const int n = vsnprintf(room, WCUT_TEXT_ROOM, format, arguments);
    va_end(arguments);
    p->text->count += n < WCUT_TEXT_ROOM ? (size_t)n : WCUT_TEXT_ROOM - 1;
    wcut_text_put(p->text, ";\n", 2);
    return id;
}

wcut_id wcut_p21_point(wcut_part21 *p, wcut_vec3 point) { return put_part21_triple(p, "CARTESIAN_POINT('',", point); }

wcut_id wcut_p21_direction(wcut_part21 *p, wcut_vec3 direction) {
    return put_part21_triple(p, "DIRECTION('',", direction);
}

/* ---- values ---- */

void wcut_p21_real(wcut_part21 *p, double value) {
    char *room = wcut_text_room(p->text);
    p->text->count += print_real(room, value);
}

void wcut_p21_string(wcut_part21 *p, const char *text) {
    wcut_text_put(p->text, "'", 1);
    while (*text) {
        uint32_t code;
        text = wcut_utf8_next(text, &code);
        if (code == '\'' || code == '\\')
            wcut_text_print(p->text, "%c%c", (char)code, (char)code);
        else if (code >= 0x20 && code < 0x7f)
            wcut_text_print(p->text, "%c", (char)code);
        else if (code <= 0xffff)
            wcut_text_print(p->text, "\\X2\\%04X\\X0\\", (unsigned)code);
        else
            wcut_text_print(p->text, "\\X4\\%08X\\X0\\", (unsigned)code);
    }
    wcut_text_put(p->text, "'", 1);
}

/* what stands before entry k of a list: its opening, or a comma and at times a line feed */
static size_t print_gap(char *to, int k) { return print_words(to, k == 0 ? "(" : k % A_LINE ? "," : ",\n"); }

void wcut_p21_references(wcut_part21 *p, wcut_id first, int count, int step) {
    for (int k = 0; k < count; k++) {
        char *room = wcut_text_room(p->text);
        size_t used = print_gap(room, k);
        room[used++] = '#';
        used += (size_t)wcut_integer_print((uint64_t)(first + (wcut_id)k * step), room + used);
        p->text->count += used;
    }
    wcut_text_put(p->text, ")", 1);
}

void wcut_p21_reals(wcut_part21 *p, const double *value, int count, int step) {
    for (int k = 0; k < count; k++) {
        char *room = wcut_text_room(p->text);
        size_t used = print_gap(room, k);
        used += print_real(room + used, value[(size_t)k * (size_t)step]);
        p->text->count += used;
    }
    wcut_text_put(p->text, ")", 1);
}
