/* A structured grid of lines u = const, v = const over a face, evenly dense in mm. */
#ifndef WCUT_SCAN_RECONSTRUCT_LATTICE_H
#define WCUT_SCAN_RECONSTRUCT_LATTICE_H

#include <wirecut/surface.h>

/* node j * columns + i is S(u_i, v_j); cell j * columns + i lies between it and node (i + 1, j + 1) */
typedef struct wcut_lattice {
    int columns, rows;
    double *u, *v;     /* columns, rows: increasing */
    wcut_vec3 *point;  /* rows x columns [mm] */
    wcut_vec3 *normal; /* rows x columns [1]; 0 where the face has none */
} wcut_lattice;

/* a place in a cell, 0 .. 1 along u and v */
typedef struct wcut_lattice_place {
    int cell;
    float s, t;
} wcut_lattice_place;

enum { WCUT_LATTICE_MAX = 5000000 };

/* Lines so dense that neighbours are at most about `spacing` [mm] apart where they are furthest. WCUT_BAD_ARGUMENT (more
   than WCUT_LATTICE_MAX nodes), WCUT_DEGENERATE (a side of the face has no length), WCUT_NO_MEMORY: nothing was
   written. */
wcut_status wcut_lattice_build(const wcut_surface *surface, double spacing, int threads, wcut_lattice *lattice);
void wcut_lattice_clear(wcut_lattice *lattice);

/* where parameters of the domain lie; outside they are clamped to it */
wcut_lattice_place wcut_lattice_locate(const wcut_lattice *lattice, double u, double v);

static inline int lattice_nodes(const wcut_lattice *l) { return l->columns * l->rows; }

#endif
