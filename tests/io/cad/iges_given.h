/* Small IGES files as text. */
#ifndef WCUT_TESTS_IO_CAD_IGES_GIVEN_H
#define WCUT_TESTS_IO_CAD_IGES_GIVEN_H

#include <stdio.h>
#include <string.h>

/* an entity of a small file: type, form, status and data, which is broken behind commas */
typedef struct iges_entity {
    int type, form;
    const char *status, *data;
} iges_entity;

/* how much of a text goes into one line of 64 columns */
static inline int iges_part(const char *data) {
    int n = (int)strlen(data);
    if (n <= 64) return n;
    for (n = 64; n > 0 && data[n - 1] != ','; n--) {
    }
    return n;
}

static inline int iges_lines(const char *data) {
    int lines = 0;
    for (; *data; data += iges_part(data)) lines++;
    return lines;
}

/* a file of entities, in a unit by number and name; author: of any letters */
static inline void put_iges(char *to, const char *unit, const char *author, int count, const iges_entity *entity) {
    to += sprintf(to, "%-72sS%7d\n", "start", 1);
    to += sprintf(to, "%-72sG%7d\n", "1H,,1H;,1Ha,1Hf,1Hs,1Hp,32,38,6,308,15,,", 1);
    to += sprintf(to, "1.,%s,1,0.01,15H20000101.000000,1.D-6,0.,%s,", unit, author);
    int letters = 0, line = 1;
    for (const char *p = to - 1; *p != '\n'; p--) letters += ((unsigned char)*p & 0xc0) != 0x80;
    to += sprintf(to, "%*sG%7d\n", 72 - letters, "", 2);
    to += sprintf(to, "%-72sG%7d\n", ",11,0,;", 3);
    for (int k = 0; k < count; k++) {
        const iges_entity *e = &entity[k];
        to += sprintf(to, "%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d\n", e->type, line, 0, 0, 0, 0, 0, 0, e->status, 2 * k + 1);
        to += sprintf(to, "%8d%8d%8d%8d%8d%32sD%7d\n", e->type, 0, 0, iges_lines(e->data), e->form, "", 2 * k + 2);
        line += iges_lines(e->data);
    }
    line = 1;
    for (int k = 0; k < count; k++)
        for (const char *p = entity[k].data; *p; p += iges_part(p))
            to += sprintf(to, "%-64.*s%8dP%7d\n", iges_part(p), p, 2 * k + 1, line++);
    sprintf(to, "S      1G      3D%7dP%7d%40sT      1\n", 2 * count, line - 1, "");
}

#endif
