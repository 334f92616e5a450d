/* A chain of nodes: tangents, lengths, the angles at its mounts. */
#ifndef WCUT_WIRE_CHAIN_H
#define WCUT_WIRE_CHAIN_H

#include <wirecut/vec3.h>

/* unit tangent at node i: central difference, one-sided at the ends */
wcut_vec3 wcut_chain_tangent(int n, const wcut_vec3 *x, int i);

/* sum of the edges [mm] */
double wcut_chain_length(int n, const wcut_vec3 *x);

/* Angles of the wire at both mounts [rad]; signs as FORMATS defines them: alpha positive trailing behind the feed (+y),
   beta positive upward. */
void wcut_chain_angles(int n, const wcut_vec3 *x, double *alpha_a, double *beta_a, double *alpha_b, double *beta_b);

#endif
