/* A lattice over a plane, laid onto the mesh that is a sheet over it. */
#ifndef WCUT_SCAN_RECONSTRUCT_BASE_H
#define WCUT_SCAN_RECONSTRUCT_BASE_H

#include <wirecut/mesh.h>
#include <wirecut/projection.h>

#include "scan/reconstruct_lattice.h"

/* where the mesh is over each node */
typedef struct wcut_base {
    double *height;         /* nodes [mm] over the plane; that of a node nearby where the mesh is not */
    unsigned char *covered; /* nodes: the mesh is there */
} wcut_base;

/* Heights of a mesh over the plane of a lattice, whose nodes are moved onto it. WCUT_BAD_ARGUMENT (no node has the mesh
   over it), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_base_lay(const wcut_surface *plane, const wcut_mesh *mesh, int threads, wcut_lattice *lattice,
                          wcut_base *base);
void wcut_base_clear(wcut_base *base);

/* [mm] the mesh's height at a place */
double wcut_base_eval(const wcut_base *base, const wcut_lattice *lattice, wcut_lattice_place place);

#endif
