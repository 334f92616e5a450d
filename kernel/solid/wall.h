/* How thick a half is behind its cut face, and how sharp the edges are in which that meets the block's sides. */
#ifndef WCUT_SOLID_WALL_H
#define WCUT_SOLID_WALL_H

#include "solid/cut_face.h"

/* wall_min, wall_place, edge_min and edge_place of wcut_half_report for a half made by index, from the triangles of its
   cut face */
void wcut_wall_measure(const wcut_division *d, int upper, const wcut_cut_face *face, wcut_half_report *report);

#endif
