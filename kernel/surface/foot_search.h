/* One query's closest point: branch and bound over the tree of pieces, Newton's method where that is convex. */
#ifndef WCUT_SURFACE_FOOT_SEARCH_H
#define WCUT_SURFACE_FOOT_SEARCH_H

#include <wirecut/projection.h>

#include "surface/newton_foot.h"
#include "surface/patch_tree.h"

struct wcut_projection {
    const wcut_surface *surface;
    wcut_patch_node *node;
    wcut_newton_foot
        *newton; /* NULL until wcut_projection_prepare_many, and where Newton's method in spans is not available */
    double first[2], last[2]; /* the domain */
    double size;              /* [mm] of the surface and its coordinates: what rounding is relative to */
};

/* the closest point to p; `near`, if not NULL, is a foot found for a neighbour */
void wcut_foot_search(const wcut_projection *m, wcut_vec3 p, const wcut_foot *near, wcut_foot *foot);

/* point, distance, height and border of a foot that is known to be the closest */
void wcut_foot_describe(const wcut_projection *m, wcut_vec3 p, const wcut_foot_jet *at, wcut_foot *foot);

#endif
