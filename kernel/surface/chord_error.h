/* The distance between a surface and the triangles of its grid, measured by dense sampling. */
#ifndef WCUT_SURFACE_CHORD_ERROR_H
#define WCUT_SURFACE_CHORD_ERROR_H

#include <wirecut/surface.h>

#include "surface/spacing.h"

/* Sample every cell of a grid at the knots inside it and in between, at least at its quarters, and take the distance
   from each sample to the cell's triangle over it. error_u, error_v: the largest of each column and row of cells, exact
   where it exceeds `held`; *most: the largest of all. WCUT_NO_MEMORY. */
wcut_status wcut_chord_error(const wcut_surface *surface, const wcut_spacing *lines_u, const wcut_spacing *lines_v,
                             double held, double *error_u, double *error_v, double *max);

/* distance of a point to a triangle, which may be degenerate */
double wcut_triangle_distance(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c);

#endif
