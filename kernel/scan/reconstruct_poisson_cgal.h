/* Poisson reconstruction in space, of a cloud that encloses a volume. */
#ifndef WCUT_SCAN_RECONSTRUCT_POISSON_CGAL_H
#define WCUT_SCAN_RECONSTRUCT_POISSON_CGAL_H

#include <stdint.h>
#include <wirecut/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The surface between inside and outside of count >= 4 finite points with unit normals that point outwards (Kazhdan,
   Bolitho, Hoppe 2006), at the level that is in the middle of the first `scanned` >= 1 of them; triangles no further than `distance` [mm] from it and not wider than `size` [mm]. Serial; the
   same bytes for the same seed. mesh: the caller's, to wcut_mesh_destroy; with normals and scalar, both zero, and uv.
   WCUT_NOT_CONVERGED (the linear solver failed), WCUT_NO_MEMORY, WCUT_INTERNAL: nothing was written. */
wcut_status wcut_poisson_cgal(int count, int scanned, const wcut_vec3 *point, const wcut_vec3 *normal, double size,
                              double distance, uint64_t seed, wcut_mesh **mesh);

#ifdef __cplusplus
}
#endif

#endif
