/* A scanned sheet closed to a thin body, for Poisson reconstruction in space. */
#ifndef WCUT_SCAN_RECONSTRUCT_POISSON_H
#define WCUT_SCAN_RECONSTRUCT_POISSON_H

#include <stdint.h>
#include <wirecut/cloud.h>
#include <wirecut/mesh.h>
#include <wirecut/projection.h>

#include "scan/reconstruct_field.h"

/* the scan over the face, and its sheet as the field has it */
typedef struct wcut_poisson_input {
    const wcut_surface *surface;
    const wcut_lattice *lattice;
    const wcut_mesh *sheet; /* only where there is support: its border is closed */
    int count;
    const wcut_vec3 *point; /* count [mm] */
    const wcut_foot *foot;  /* count; those beyond the border are left out */
    double spacing;         /* [mm] of the points that are used */
    double reach;           /* [mm] how far a height may be from the field's */
    uint64_t seed;
    int threads;
} wcut_poisson_input;

/* Replace the heights of a field by those of Poisson's surface; what that does not reach becomes inactive.
   WCUT_DEGENERATE, WCUT_NOT_CONVERGED, WCUT_NO_MEMORY, WCUT_INTERNAL: the field is as it was. */
wcut_status wcut_reconstruct_poisson(const wcut_poisson_input *input, wcut_field *field);

#endif
