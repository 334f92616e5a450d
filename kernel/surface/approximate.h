/* A bicubic surface through samples of any map of two parameters, refined until it is as near as asked. */
#ifndef WCUT_SURFACE_APPROXIMATE_H
#define WCUT_SURFACE_APPROXIMATE_H

#include <stdbool.h>
#include <wirecut/surface.h>

/* points of the map on a grid, count_v x count_u */
typedef wcut_status (*wcut_grid_map)(const void *data, int count_u, const double *u, int count_v, const double *v,
                                     wcut_vec3 *point);

/* a direction of the map: where it is smooth, and where to look */
typedef struct wcut_map_axis {
    int joints;          /* at least 2: both ends of the domain, and where second derivatives jump */
    const double *joint; /* joints, rising */
    int watched;         /* 0 or more */
    const double *watch; /* watched, rising, within the domain: parameters that the last check must look at */
} wcut_map_axis;

/* Samples become lines of a grid; cells are halved in the direction that misses the map at their middles, and at last
   the quarters of all cells and the watched parameters are measured. *error: the largest distance found there.
   WCUT_NOT_CONVERGED, WCUT_NO_MEMORY, what the map returns, WCUT_DEGENERATE (it is not finite): nothing was written. */
wcut_status wcut_approximate(wcut_grid_map map, const void *data, const wcut_map_axis *u, const wcut_map_axis *v,
                             double tolerance, wcut_surface **surface, double *error);

#endif
