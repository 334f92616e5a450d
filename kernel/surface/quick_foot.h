/* Feet of many queries near a smooth bicubic surface: Newton's method in the span where a neighbour's foot leads to, and
   a radius for each span within which a stationary foot is proven to be the closest of all. */
#ifndef WCUT_SURFACE_QUICK_FOOT_H
#define WCUT_SURFACE_QUICK_FOOT_H

#include <stdbool.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>

#include "surface/sweep.h"

enum { WCUT_QUICK_MOST = 1024 }; /* queries taken together */

typedef struct wcut_quick wcut_quick;

/* size: [mm] of the surface and its coordinates. *quick is NULL where the surface is not bicubic, polynomial and once
   continuously differentiable, or has more than 200000 spans: then there is no quick way. WCUT_NO_MEMORY: nothing was
   written. */
wcut_status wcut_quick_create(const wcut_surface *surface, double size, wcut_quick **quick);
void wcut_quick_destroy(wcut_quick *quick);

/* a span, and where in it a search begins: parameters from -1/2 to 1/2 */
typedef struct wcut_quick_place {
    int column, row;
    double s, t;
} wcut_quick_place;

/* the place of a point of the surface */
wcut_quick_place wcut_quick_at(const wcut_quick *quick, double u, double v);

/* Feet within spans for up to WCUT_QUICK_MOST queries, neighbours near one another, the first near `place`. done[k] is
   1 where foot[k] was found and proven; else 0, foot[k] was not written, and start[k] is where to go on. ahead, if not
   NULL, is fetched meanwhile. */
void wcut_quick_feet(const wcut_quick *quick, int count, const wcut_vec3 *query, wcut_quick_place place,
                     const wcut_sweep_ahead *ahead, wcut_foot *foot, unsigned char *done, wcut_quick_place *start);

/* a foot and the derivatives there */
typedef struct wcut_quick_spot {
    double u, v;
    wcut_vec3 point, along_u, along_v;
} wcut_quick_spot;

/* The foot of one query wherever Newton's method leads from a place, the surface's border included; false where it is
   not found or not proven, then nothing was written. */
bool wcut_quick_slide(const wcut_quick *quick, wcut_vec3 query, wcut_quick_place place, wcut_quick_spot *spot);

/* a better place to begin a query: from span to span as their middles tell */
wcut_quick_place wcut_quick_walk(const wcut_quick *quick, wcut_vec3 query, wcut_quick_place from);

#endif
