/* The part of a lattice that a scan supports, and the rest of it, as meshes. */
#ifndef WCUT_SCAN_RECONSTRUCT_SHEET_H
#define WCUT_SCAN_RECONSTRUCT_SHEET_H

#include <wirecut/reconstruction.h>

#include "scan/kd_tree.h"
#include "scan/reconstruct_field.h"

typedef struct wcut_sheet {
    const wcut_lattice *lattice;
    const wcut_field *field;
    const unsigned char *covered; /* nodes: the face is there; NULL: everywhere */
    const wcut_kd_tree *tree;     /* of the scan */
    double support;               /* [mm] */
    wcut_vec3 block;              /* [mm]; 0: everything counts */
    wcut_vec3 *vertex;            /* nodes: S + h n; S where the field is not active */
    double *distance;             /* nodes [mm] from the scan, `support` or more where it has none */
} wcut_sheet;

/* vertices and their distances. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_sheet_raise(const wcut_lattice *lattice, const wcut_field *field, const unsigned char *covered,
                             const wcut_kd_tree *tree, double support, wcut_vec3 block, int threads, wcut_sheet *sheet);
void wcut_sheet_clear(wcut_sheet *sheet);

/* mesh, unmeasured, holes, areas and farthest of a zeroed reconstruction. WCUT_DEGENERATE (no triangle has support),
   WCUT_NO_MEMORY: the reconstruction holds what was made so far. */
wcut_status wcut_sheet_cut(const wcut_sheet *sheet, double hole_min, wcut_reconstruction *reconstruction);

/* unit normals of a mesh, the sum over the triangles around weighted by their area; its area [mm^2] */
double wcut_sheet_normals(wcut_mesh *mesh);

#endif
