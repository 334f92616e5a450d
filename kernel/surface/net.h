/* Curves side by side over one knot vector, homogeneous: what editing a curve and a surface have in common. */
#ifndef WCUT_SURFACE_NET_H
#define WCUT_SURFACE_NET_H

#include <wirecut/curve.h>
#include <wirecut/surface.h>

#include "surface/rational.h"

/* control point k of curve c is at[k * lanes + c] */
typedef struct wcut_net {
    int degree, count, lanes;
    double *knots;        /* count + degree + 1 */
    wcut_homogeneous *at; /* count x lanes */
} wcut_net;

/* room for `count` control points; WCUT_NO_MEMORY: nothing was written */
wcut_status wcut_net_new(int degree, int count, int lanes, wcut_net *net);

/* free what the functions here gave; a zeroed net is allowed */
void wcut_net_clear(wcut_net *net);

/* insert a knot inside the domain, `times` times; on failure the net is as it was */
wcut_status wcut_net_insert(wcut_net *net, double u, int times);

/* the parts on either side of a parameter inside the domain; on failure nothing is written */
wcut_status wcut_net_split(const wcut_net *net, double u, wcut_net *low, wcut_net *high);

/* run every curve through backwards, in place */
void wcut_net_reverse(wcut_net *net);

/* how often a parameter is a knot */
int wcut_net_multiplicity(const wcut_net *net, double u);

#endif
