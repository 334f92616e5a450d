/* Curves and surfaces as nets of homogeneous control points along one direction, and back. */
#ifndef WCUT_SURFACE_NET_SHAPE_H
#define WCUT_SURFACE_NET_SHAPE_H

#include <wirecut/edit.h>

#include "surface/net.h"

/* All: WCUT_OK or WCUT_NO_MEMORY, and then nothing was written. */
wcut_status wcut_net_of_curve(const wcut_curve *curve, wcut_net *net);
wcut_status wcut_curve_of_net(const wcut_net *net, bool rational, wcut_curve **curve);
wcut_status wcut_net_of_surface(const wcut_surface *surface, wcut_direction along, wcut_net *net);

/* a net along a direction of `like`, with that surface's other direction and weights where that has them; `turned`
   exchanges the two */
wcut_status wcut_surface_of_net(const wcut_net *net, wcut_direction along, const wcut_surface *like, bool turned,
                                wcut_surface **surface);

#endif
