/* What two closed meshes have in common, and whether a mesh meets itself: by CGAL, with exact predicates. */
#ifndef WCUT_SOLID_BOOLEAN_H
#define WCUT_SOLID_BOOLEAN_H

#include <wirecut/mesh.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The intersection of two closed meshes, oriented outwards and free of self-intersections; empty where they are apart.
   tag_a, tag_b: a number for every triangle; *tag: that of the triangle each one of the result lies in (to wcut_free).
   WCUT_DEGENERATE (an input that is not a solid, a result that would touch itself along an edge or at a corner),
   WCUT_NO_MEMORY, WCUT_INTERNAL (error, which may be NULL, says what CGAL said): nothing was written. */
wcut_status wcut_boolean_intersect(const wcut_mesh *a, const unsigned char *tag_a, const wcut_mesh *b,
                                   const unsigned char *tag_b, wcut_mesh **result, unsigned char **tag,
                                   wcut_error *error);

/* How many pairs of triangles meet otherwise than in the corners and edges they share; *place: on one of them.
   WCUT_DEGENERATE (edges of more than two triangles), WCUT_NO_MEMORY, WCUT_INTERNAL: nothing was written. */
wcut_status wcut_self_intersections(const wcut_mesh *mesh, int *pairs, wcut_vec3 *place, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
