/* Feet of many queries, handed out a block of neighbours at a time: whoever asks makes of them what it needs while they
   are at hand. */
#ifndef WCUT_SURFACE_SWEEP_H
#define WCUT_SURFACE_SWEEP_H

#include <wirecut/projection.h>

/* takes foot[k] of query index[k]; called by several threads at a time, for disjoint queries */
typedef void wcut_feet_taker(void *to, int count, const int *index, const wcut_foot *foot);

/* As wcut_projection_locate, of checked arguments. WCUT_NO_MEMORY: nothing was handed out. */
wcut_status wcut_projection_sweep(const wcut_projection *projection, int count, const wcut_vec3 *query, int threads,
                                  wcut_feet_taker *take, void *to);

#endif
