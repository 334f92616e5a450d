/* The equilibrium without its checks, for callers that step: it allocates nothing. */
#ifndef WCUT_WIRE_EQUILIBRIUM_H
#define WCUT_WIRE_EQUILIBRIUM_H

#include <wirecut/equilibrium.h>

wcut_status wcut_equilibrium_shape(int n, const wcut_vec3 *force, const double *length,
                                   const wcut_equilibrium_options *options, wcut_vec3 *x, double *q,
                                   wcut_equilibrium_report *report);

#endif
