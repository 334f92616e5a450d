/* Arcs of circles and ellipses as rational curves. */
#ifndef WCUT_IO_CAD_ARC_H
#define WCUT_IO_CAD_ARC_H

#include <wirecut/curve.h>

enum { WCUT_ARC_POLES = 9 };

/* poles, weights and knots of the arc center + cos(t) x + sin(t) y, t from `from` to `to` [rad], at most a whole turn
   in either direction; degree 2. Gives the number of poles. */
int wcut_arc(wcut_vec3 center, wcut_vec3 x, wcut_vec3 y, double from, double to, wcut_vec3 pole[WCUT_ARC_POLES],
             double weight[WCUT_ARC_POLES], double knot[WCUT_ARC_POLES + 3]);

#endif
