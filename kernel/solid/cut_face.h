/* One cut face of the two: fitted, and as triangles that know where they lie in the block. */
#ifndef WCUT_SOLID_CUT_FACE_H
#define WCUT_SOLID_CUT_FACE_H

#include <wirecut/mould.h>

#include "solid/cap.h"
#include "solid/cut_face_fit.h"

typedef struct wcut_cut_face {
    wcut_face_fit fit;
    wcut_cap cap;
    double chord_error;
    double low, high; /* [mm] least and greatest z of the triangles */
} wcut_cut_face;

/* What both faces of a cut come from. */
typedef struct wcut_division {
    const wcut_surface *surface, *width; /* width: NULL where there is no kerf */
    wcut_vec3 block;
    const wcut_mould_options *options;
} wcut_division;

/* The face above the kerf (side 1/2) or below it (-1/2), cut off at sides `margin` outside the block's; `margin` 0 also
   checks how far the wire's surface was prolonged. Statuses of wcut_mould_create: nothing was written. */
wcut_status wcut_cut_face_solve(const wcut_division *d, double side, double margin, wcut_cut_face *face,
                                wcut_error *error);

/* free what wcut_cut_face_solve gave; a zeroed face is allowed */
void wcut_cut_face_clear(wcut_cut_face *face);

/* How a pair of faces lies between bottom and top: 0 inside, 1 leaves through one of them.
   WCUT_DEGENERATE: it misses the block, grazes a face, runs along an edge or through a corner; error says where. */
wcut_status wcut_cut_face_place(const wcut_division *d, const wcut_cut_face *lower, const wcut_cut_face *upper,
                                int *leaves, wcut_error *error);

#endif
