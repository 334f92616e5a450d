/* One side for the normals of a sheet. */
#ifndef WCUT_SCAN_ORIENT_H
#define WCUT_SCAN_ORIENT_H

#include <wirecut/cloud.h>

#include "scan/kd_tree.h"

/* Turn normals (tree->count, in the tree's order; 0 where undefined) towards a unit vector: those of |n . side| >=
   steep by it, the others after the neighbour that is most parallel, along a minimum spanning forest of 1 - |n n'| over
   the `neighbours` nearest (Hoppe, DeRose, Duchamp, McDonald, Stuetzle 1992); a piece without a fixed one as a whole,
   so that its sum points to the side. Counts go into the report. WCUT_NO_MEMORY: the normals are still unit or 0. */
wcut_status wcut_orient(const wcut_kd_tree *tree, int neighbours, wcut_vec3 side, double steep, int threads,
                        wcut_vec3 *normal, wcut_normals_report *report);

#endif
