/* Poisson reconstruction in space, of a cloud that encloses a volume: where its surface crosses given lines. */
#ifndef WCUT_SCAN_RECONSTRUCT_POISSON_CGAL_H
#define WCUT_SCAN_RECONSTRUCT_POISSON_CGAL_H

#include <stdint.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The surface between inside and outside of count finite points that enclose a volume, with unit normals that point out
   of it (Kazhdan, Bolitho, Hoppe 2006), at the level that is in the middle of the first `scanned` >= 1 of them. along:
   for each of `lines` places and unit directions out of the volume, the crossing nearest to the place that leaves the
   volume [mm], in -reach .. reach; crossed: 1 where there is one. Serial; the same bytes for the same seed.
   WCUT_NOT_CONVERGED (the linear solver failed): nothing was written; WCUT_NO_MEMORY, WCUT_INTERNAL: along and crossed
   may be written in part. */
wcut_status wcut_poisson_cross(int count, int scanned, const wcut_vec3 *point, const wcut_vec3 *normal, uint64_t seed,
                               int lines, const wcut_vec3 *from, const wcut_vec3 *direction, double reach,
                               double *along, unsigned char *crossed);

#ifdef __cplusplus
}
#endif

#endif
