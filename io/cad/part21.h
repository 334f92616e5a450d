/* The clear text encoding of STEP (ISO 10303-21): numbered instances, reals, strings. */
#ifndef WCUT_IO_CAD_PART21_H
#define WCUT_IO_CAD_PART21_H

#include <wirecut/vec3.h>

#include "io/file/text.h"

/* an instance's number */
typedef long wcut_id;

typedef struct wcut_part21 {
    wcut_text *text;
    wcut_id last; /* the number given last */
} wcut_part21;

/* a whole instance, "#12=" and ";" around the printf text of at most 4000 bytes; gives its number */
wcut_id wcut_p21_put(wcut_part21 *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* "#12=" of an instance to be ended by the caller; gives its number */
wcut_id wcut_p21_begin(wcut_part21 *p);

/* a real, which always has a point: 1. 0.5 1.E-5 */
void wcut_p21_real(wcut_part21 *p, double value);

/* a string in quotes: ASCII, the rest of UTF-8 as \X2\ and \X4\; what is not UTF-8 becomes U+FFFD */
void wcut_p21_string(wcut_part21 *p, const char *text);

/* #7=CARTESIAN_POINT('',(1.,2.,3.)); and the same of a DIRECTION */
wcut_id wcut_p21_point(wcut_part21 *p, wcut_vec3 point);
wcut_id wcut_p21_direction(wcut_part21 *p, wcut_vec3 direction);

/* count references #first, #(first + step), ... in parentheses, with line feeds */
void wcut_p21_references(wcut_part21 *p, wcut_id first, int count, int step);

/* count reals in parentheses, every step-th of value, with line feeds */
void wcut_p21_reals(wcut_part21 *p, const double *value, int count, int step);

#endif
