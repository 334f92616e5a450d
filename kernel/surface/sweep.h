/* Many queries answered a block of neighbours at a time, whose feet are taken while they are at hand. */
#ifndef WCUT_SURFACE_SWEEP_H
#define WCUT_SURFACE_SWEEP_H

#include <stddef.h>
#include <wirecut/projection.h>

enum {
    WCUT_SWEEP_BLOCK = 1024,
    WCUT_SWEEP_FOOT = 128, /* bytes of a foot, at most */
    WCUT_SWEEP_AHEAD = 16  /* how far ahead a taker fetches what it will write: the order of memory is another one */
};

/* finds the feet of 1 to WCUT_SWEEP_BLOCK queries that are near one another */
typedef void wcut_sweep_locator(const void *on, int count, const wcut_vec3 *query, void *foot);

/* takes foot[k] of query index[k]; called by several threads at a time, for disjoint queries */
typedef void wcut_sweep_taker(void *to, int count, const int *index, const void *foot);

typedef struct wcut_sweep {
    wcut_sweep_locator *locate;
    const void *on;
    wcut_sweep_taker *take;
    void *to;
} wcut_sweep;

/* Queries are finite; the same blocks for any number of threads. WCUT_NO_MEMORY: nothing was taken. */
wcut_status wcut_sweep_run(const wcut_sweep *sweep, int count, const wcut_vec3 *query, int threads);

/* wcut_projection_locate, of checked arguments, with a taker of wcut_foot */
wcut_status wcut_projection_sweep(const wcut_projection *projection, int count, const wcut_vec3 *query, int threads,
                                  wcut_sweep_taker *take, void *to);

#endif
