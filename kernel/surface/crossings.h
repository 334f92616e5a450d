/* Where a surface's tessellation runs through itself. */
#ifndef WCUT_SURFACE_CROSSINGS_H
#define WCUT_SURFACE_CROSSINGS_H

#include <wirecut/crossing.h>

/* pairs of triangles that cross, and the parameters of the first; what wcut_surface_tessellate and wcut_mesh_crossings
   return */
wcut_status wcut_surface_crossings(const wcut_surface *surface, double chord_tolerance, int *count, double u[2],
                                   double v[2]);

#endif
