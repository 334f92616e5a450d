/* A mesh's triangles in the order of a tree, and its boxes. */
#ifndef WCUT_SCAN_MESH_DISTANCE_BOXES_H
#define WCUT_SCAN_MESH_DISTANCE_BOXES_H

#include "scan/mesh_layout.h"

/* order, boxes and nodes; fills triangles, point, index, vertex, node, leaf, centre, size and the box. WCUT_NO_MEMORY:
   what was made stays to be cleared. */
wcut_status wcut_mesh_boxes_build(const wcut_mesh *mesh, wcut_mesh_tree *tree);

#endif
