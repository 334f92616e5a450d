/* Where the parts of a STEP assembly stand, and in which units their numbers are. */
#ifndef WCUT_IO_CAD_STEP_PLACES_H
#define WCUT_IO_CAD_STEP_PLACES_H

#include "io/cad/step_curves.h"

/* p -> row . p + shift [mm] */
typedef struct wcut_step_place {
    wcut_vec3 row[3], shift;
} wcut_step_place;

enum { WCUT_STEP_PLACES_MAX = 256 };

/* whether an instance is a representation of shape, and its list of items; NULL: it is none */
const char *wcut_step_items(const char *body);

/* the representation of shape that lists an item; 0: none does */
long wcut_step_holder(const wcut_step_source *source, long item);

/* the source's units become those of a representation's context, where it states some; false: refused */
bool wcut_step_use_units(wcut_step_source *source, long representation);

/* Which instances the items of a representation lead to, but for mapped ones: reached[k] for the k-th of the file. false:
   refused */
bool wcut_step_reach(wcut_step_source *source, const char *representation, unsigned char *reached);

/* The places of a representation in the whole: one where nothing moves it, one each where an assembly or a mapped item
   uses it. false: refused */
bool wcut_step_find_places(wcut_step_source *source, long representation, wcut_step_place place[WCUT_STEP_PLACES_MAX],
                           int *count);

/* move a curve's control points; false: refused, at #id */
bool wcut_step_set_in_place(wcut_step_source *source, long id, const wcut_step_place *place, wcut_curve *curve);

#endif
