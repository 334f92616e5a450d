/* Locating lugs: boxes beside the block, a cone on each of the lower half, a pocket for it in each of the upper. */
#ifndef WCUT_SOLID_LUGS_H
#define WCUT_SOLID_LUGS_H

#include "solid/cut_face.h"

enum { WCUT_LUGS = 3 };

typedef struct wcut_lug {
    int side;            /* 0: at x = 0, 1: at x = W */
    wcut_vec3 corner[4]; /* [mm] x, y counter-clockwise seen from above; the first edge lies on the block's side */
    double level, far;   /* [mm] z of the face with the cone or pocket, and of the one opposite */
    wcut_key key;        /* on that face, rising from it in both halves */
} wcut_lug;

/* The lugs of both halves, lug[0] of the lower and lug[1] of the upper, at those places where the border of the cut
   rises and falls least: two at x = 0, one at x = W. WCUT_BAD_ARGUMENT (no room: error says where), nothing written. */
wcut_status wcut_lugs_place(const wcut_division *d, const wcut_cap *lower, const wcut_cap *upper,
                            wcut_lug lug[2][WCUT_LUGS], wcut_error *error);

/* [mm3] that a lug adds, exact for its triangles */
double wcut_lug_volume(const wcut_lug *lug, int upper, double chord_tolerance);

/* The two caps between which a lug lies: its block side is border 1 - side of them. Statuses of wcut_cap_flat. */
wcut_status wcut_lug_caps(const wcut_lug *lug, int upper, double chord_tolerance, wcut_cap *floor, wcut_cap *ceiling);

#endif
