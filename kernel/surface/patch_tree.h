/* A binary tree of a surface's pieces, down to where each is flat beside its size. */
#ifndef WCUT_SURFACE_PATCH_TREE_H
#define WCUT_SURFACE_PATCH_TREE_H

#include <wirecut/surface.h>

#include "surface/patch.h"

typedef struct wcut_patch_node {
    wcut_patch patch; /* a node with a crease inside has infinite bends */
    int child;        /* the first of two neighbouring children; 0 where there are none */
} wcut_patch_node;

/* node[0] is the whole surface; the caller frees it. WCUT_DEGENERATE where derivatives overflow; WCUT_NO_MEMORY. */
wcut_status wcut_patch_tree_build(const wcut_surface *surface, wcut_patch_node **node);

#endif
