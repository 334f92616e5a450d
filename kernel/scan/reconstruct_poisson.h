/* A scanned sheet closed to a thin body, for Poisson reconstruction in space. */
#ifndef WCUT_SCAN_RECONSTRUCT_POISSON_H
#define WCUT_SCAN_RECONSTRUCT_POISSON_H

#include <wirecut/reconstruction.h>

#include "scan/kd_tree.h"

/* Put Poisson's mesh in the place of the field's in a reconstruction. Points beyond the face's border are left out.
   WCUT_DEGENERATE, WCUT_NOT_CONVERGED, WCUT_NO_MEMORY, WCUT_INTERNAL: the reconstruction is as it was. */
wcut_status wcut_reconstruct_poisson(const wcut_surface *surface, int count, const wcut_vec3 *point,
                                     const wcut_foot *foot, const wcut_kd_tree *tree,
                                     const wcut_reconstruction_options *options, int threads,
                                     wcut_reconstruction *reconstruction);

#endif
