/* What meets at a mesh's edges and corners. */
#ifndef WCUT_SCAN_MESH_DISTANCE_EDGES_H
#define WCUT_SCAN_MESH_DISTANCE_EDGES_H

#include "scan/mesh_layout.h"

/* edges, border and normals of a tree whose triangles are in order. WCUT_NO_MEMORY. */
wcut_status wcut_mesh_edges_build(const wcut_mesh *mesh, wcut_mesh_tree *tree);

#endif
