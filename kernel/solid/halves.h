/* Both halves and the kerf between two cut faces: by index where the cut stays inside, else by booleans. */
#ifndef WCUT_SOLID_HALVES_H
#define WCUT_SOLID_HALVES_H

#include "solid/cut_face.h"
#include "solid/lugs.h"

typedef struct wcut_part {
    wcut_mesh *mesh;
    unsigned char *tag;     /* a triangle: 1 where it is of the cut face */
    int self_intersections; /* 0, or what was found */
    wcut_vec3 place;        /* ... and where */
} wcut_part;

typedef struct wcut_parts {
    wcut_part lower, upper, kerf; /* kerf: empty where there is none */
} wcut_parts;

/* The parts of the block; both faces are inside it (leaves 0 of wcut_cut_face_place). place: the lugs of both halves,
   NULL: none. */
wcut_status wcut_halves_by_index(const wcut_division *d, const wcut_cut_face *lower, const wcut_cut_face *upper,
                                 const wcut_lug (*place)[WCUT_LUGS], wcut_parts *parts, wcut_error *error);

/* The parts of the stock, or of the block; the faces reach beyond its sides by `margin`. *block_volume: [mm3] of it,
   without keys */
wcut_status wcut_halves_by_boolean(const wcut_division *d, const wcut_cut_face *lower, const wcut_cut_face *upper,
                                   double margin, wcut_parts *parts, double *block_volume, wcut_error *error);

/* free what the two above gave; zeroed parts are allowed */
void wcut_parts_clear(wcut_parts *parts);

#endif
