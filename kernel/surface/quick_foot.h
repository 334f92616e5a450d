/* Feet of many queries near a smooth bicubic surface: Newton's method from a neighbour's foot, and a radius for each
   span within which a stationary foot is proven to be the closest of all. */
#ifndef WCUT_SURFACE_QUICK_FOOT_H
#define WCUT_SURFACE_QUICK_FOOT_H

#include <stdbool.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>

typedef struct wcut_quick wcut_quick;

/* *quick is NULL where the surface is not bicubic, polynomial and once continuously differentiable, or has more than
   200000 spans: then there is no quick way. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_quick_create(const wcut_surface *surface, wcut_quick **quick);
void wcut_quick_destroy(wcut_quick *quick);

/* the span of the last foot: where the search for the next one's begins; -1, -1: unknown */
typedef struct wcut_quick_place {
    int column, row;
} wcut_quick_place;

/* The foot of p, starting from that of a neighbour; false where it is not found or not proven so quickly, or lies on
   the surface's border: then foot was not written. */
bool wcut_quick_foot(const wcut_quick *quick, wcut_vec3 p, const wcut_foot *near, wcut_quick_place *place,
                     wcut_foot *foot);

#endif
