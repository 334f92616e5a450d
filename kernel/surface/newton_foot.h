/* Feet of many queries near a smooth bicubic surface: Newton's method in the span where a neighbour's foot leads to, and
   a radius for each span within which a stationary foot is proven to be the closest of all. */
#ifndef WCUT_SURFACE_NEWTON_FOOT_H
#define WCUT_SURFACE_NEWTON_FOOT_H

#include <stdbool.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>

#include "surface/newton_spans.h"
#include "surface/query_batch.h"

enum { WCUT_NEWTON_FOOT_BATCH = 1024 }; /* queries taken together */

/* a span, and where in it a search begins: parameters from -1/2 to 1/2 */
typedef struct wcut_span_place {
    int column, row;
    double s, t;
} wcut_span_place;

/* the place of a point of the surface */
wcut_span_place wcut_span_place_at(const wcut_newton_foot *q, double u, double v);

/* Feet within spans for up to WCUT_NEWTON_FOOT_BATCH queries, neighbours near one another, the first near `place`. done[k] is
   1 where foot[k] was found and proven; else 0, foot[k] was not written, and start[k] is where to go on. ahead, if not
   NULL, is fetched meanwhile. */
void wcut_newton_foot_batch(const wcut_newton_foot *newton, int count, const wcut_vec3 *query, wcut_span_place place,
                            const wcut_query_prefetch *ahead, wcut_foot *foot, unsigned char *done,
                            wcut_span_place *start);

/* a foot and the derivatives there */
typedef struct wcut_foot_jet {
    double u, v;
    wcut_vec3 point, along_u, along_v;
} wcut_foot_jet;

/* The foot of one query wherever Newton's method leads from a place, the surface's border included; false where it is
   not found or not proven, then nothing was written. */
bool wcut_newton_foot_slide(const wcut_newton_foot *newton, wcut_vec3 query, wcut_span_place place,
                            wcut_foot_jet *spot);

/* a better place to begin a query: from span to span as their middles tell */
wcut_span_place wcut_newton_foot_walk(const wcut_newton_foot *q, wcut_vec3 query, wcut_span_place from);

#endif
