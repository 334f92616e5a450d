/* Points that a text gives one after the other, and which curve each belongs to. */
#ifndef WCUT_IO_CAD_POINT_GROUP_H
#define WCUT_IO_CAD_POINT_GROUP_H

#include "io/cad/curve_set.h"

/* names, each once, in the order in which they came */
typedef struct wcut_point_names {
    int count, room;
    struct point_name {
        const char *at; /* of the text that is read */
        int length;
    } * name;
    int slots, *slot; /* hashed: a place in name + 1, 0 for none */
} wcut_point_names;

typedef struct wcut_point {
    wcut_vec3 at;
    int curve; /* from 0 */
    int line;  /* where it stands */
} wcut_point;

typedef struct wcut_points {
    int count, room;
    wcut_point *point;
} wcut_points;

/* the place of a name, which is added where it is new; -1: no memory, refused */
int wcut_point_names_locate(wcut_curve_reader *reader, wcut_point_names *names, const char *at, int length);
void wcut_point_names_clear(wcut_point_names *names);

/* false: no memory, refused */
bool wcut_points_add(wcut_curve_reader *reader, wcut_points *points, int curve, int line, wcut_vec3 at);
void wcut_points_clear(wcut_points *points);

/* Curves 0 .. curves - 1 of the points, in their order; name may be NULL, or holds a name for each. A curve without
   points is passed over. `place` is what a line is called in a refusal: "line". */
bool wcut_points_end(wcut_curve_reader *reader, const wcut_points *points, int curves, const wcut_point_names *name,
                     const char *place);

/* a curve through points as the options say; NULL: refused */
wcut_curve *wcut_points_curve(wcut_curve_reader *reader, const char *place, int count, const wcut_vec3 *point);

#endif
