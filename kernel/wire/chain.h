/* A chain of nodes: its end tangents, the angles at its mounts. */
#ifndef WCUT_WIRE_CHAIN_H
#define WCUT_WIRE_CHAIN_H

#include <wirecut/vec3.h>

/* Unit tangent at an end, out of the wire, from the one-sided difference of second order 3 X_0 - 4 X_1 + X_2 (the first
   edge alone is half an edge off, an error of first order where the end is in the foam). *scale: [1/mm] of the tangent
   per length of that difference. */
wcut_vec3 wcut_chain_outward(wcut_vec3 end, wcut_vec3 next, wcut_vec3 second, double *scale);

/* Angles of the wire at both mounts [rad]; signs (FORMATS.md, Rules): alpha positive trailing behind the feed (+y),
   beta positive upward. */
void wcut_chain_angles(int n, const wcut_vec3 *x, double *alpha_a, double *beta_a, double *alpha_b, double *beta_b);

#endif
