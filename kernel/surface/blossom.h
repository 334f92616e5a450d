/* Polar forms of B-splines: the same curves over another knot vector or of a higher degree (Ramshaw 1989). */
#ifndef WCUT_SURFACE_BLOSSOM_H
#define WCUT_SURFACE_BLOSSOM_H

#include "surface/net.h"

/* The polar form f of the polynomial piece over a span, symmetric, affine in each argument, f(u, .., u) = C(u):
   f(argument[0], .., argument[degree - 1]) = sum_r coefficient[r] P_{span - degree + r}. */
void wcut_blossom(int degree, const double *knots, int span, const double *argument, double *coefficient);

/* Row i of the matrix that takes the control points of a net to those over the `count` + degree + 1 knots, which hold
   every knot inside the new domain at least as often as the net does: degree + 1 entries from *first on. */
void wcut_blossom_row(int degree, int old_count, const double *old_knots, const double *knots, int i, int *first,
                      double *coefficient);

/* The same curves over such knots, or, with degree one more than the net's, over knots that each appear once more.
   WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_net_rewrite(const wcut_net *net, int degree, int count, const double *knots, wcut_net *result);

/* The same curves with the ends of their domain as knots of full multiplicity, in place. WCUT_NO_MEMORY: as it was. */
wcut_status wcut_net_clamp(wcut_net *net);

/* The same curves, one degree higher, clamped, in place. WCUT_NO_MEMORY: as they were. */
wcut_status wcut_net_elevate(wcut_net *net);

/* control points that wcut_net_elevate would give */
int wcut_net_elevated_count(const wcut_net *net);

#endif
