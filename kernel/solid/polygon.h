/* Triangles of a plane region with holes, by its border's own vertices: ears are cut off (Meisters 1975). */
#ifndef WCUT_SOLID_POLYGON_H
#define WCUT_SOLID_POLYGON_H

#include <wirecut/status.h>

#include "solid/orient2d.h"

/* `loops` closed runs of points one after the other, the first counter-clockwise around the region, the others its
   holes, clockwise; no two touch or cross. Every point is a corner of the triangles, none is added.
   triangle: (points + 2 loops - 4) x 3 places in the runs, counter-clockwise, none flat.
   WCUT_DEGENERATE (no such region), WCUT_NO_MEMORY: the contents of triangle are undefined. */
wcut_status wcut_polygon_triangulate(int loops, const int *size, const wcut_point2d *point, int *triangle);

#endif
