/* Closest points of many queries on a mesh. */
#ifndef WCUT_SCAN_MESH_DISTANCE_H
#define WCUT_SCAN_MESH_DISTANCE_H

#include "scan/mesh_layout.h"
#include "surface/query_batch.h"

/* a batch's locator of wcut_mesh_foot on a wcut_mesh_tree */
wcut_query_locator wcut_mesh_tree_locate_batch;

#endif
