/* A polygon cut into triangles. */
#ifndef WCUT_IO_MESH_POLYGON_H
#define WCUT_IO_MESH_POLYGON_H

#include <wirecut/vec3.h>

enum { WCUT_POLYGON_MAX = 1024 };

/* count corners, 3 .. WCUT_POLYGON_MAX, into count - 2 triangles of indices 0 .. count - 1, wound as the polygon is. Its edges stay
   edges of the triangles, so that a closed mesh stays closed, however odd the polygon. */
void wcut_polygon_split(int count, const wcut_vec3 *corner, int *triangle);

#endif
