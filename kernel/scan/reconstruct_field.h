/* The smooth field of heights over a lattice that is nearest to given ones and bends least. */
#ifndef WCUT_SCAN_RECONSTRUCT_FIELD_H
#define WCUT_SCAN_RECONSTRUCT_FIELD_H

#include "scan/reconstruct_lattice.h"

typedef struct wcut_field {
    double *height;        /* nodes [mm]; 0 where it is not active */
    unsigned char *active; /* nodes: 1 near the points: the field is solved for here */
    double rms;            /* [mm] of the points about the field */
    int iterations;
} wcut_field;

/* The least of sum (h(place_i) - height_i)^2 + density s^4 int h_xx^2 + 2 h_xy^2 + h_yy^2 dA over the nodes within
   `reach` cells of a point; density [1/mm^2] of the points, s = smoothing [mm]. count at least 1. WCUT_NOT_CONVERGED,
   WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_field_solve(const wcut_lattice *lattice, int count, const wcut_lattice_place *place,
                             const double *height, double density, double smoothing, int reach, int threads,
                             wcut_field *field);
void wcut_field_clear(wcut_field *field);

#endif
