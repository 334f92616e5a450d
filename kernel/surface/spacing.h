/* Where the lines of a structured grid lie: a density of lines along each direction, from curvature, then refined. */
#ifndef WCUT_SURFACE_SPACING_H
#define WCUT_SURFACE_SPACING_H

#include <stdbool.h>
#include <wirecut/surface.h>

/* a density of grid lines, constant between breaks; a crease is a break that must be a grid line */
typedef struct wcut_spacing {
    int pieces;
    double *at;      /* pieces + 1 parameters, increasing */
    double *density; /* pieces: lines per unit of parameter */
    bool *crease;    /* pieces + 1; the first and the last are */
} wcut_spacing;

/* densities for which the bound (h_u^2 |S_uu| + 2 h_u h_v |S_uv| + h_v^2 |S_vv|) / 8 stays within a chord tolerance
   (Filip, Magedson, Markot 1986), the second derivatives bounded by their control points. A rational surface is
   estimated by its polynomial sister. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_spacing_estimate(const wcut_surface *surface, double chord_tolerance, wcut_spacing *along_u,
                                  wcut_spacing *along_v);

/* grid lines of a spacing, itself a spacing whose breaks are the lines, each a piece of one cell.
   WCUT_NOT_CONVERGED (more than `max` lines), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_spacing_lines(const wcut_spacing *spacing, int max, wcut_spacing *lines);

/* free what the two above gave; a zeroed spacing is allowed */
void wcut_spacing_clear(wcut_spacing *spacing);

#endif
