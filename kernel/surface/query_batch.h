/* Many queries answered a block of neighbours at a time, whose feet are taken while they are at hand. */
#ifndef WCUT_SURFACE_QUERY_BATCH_H
#define WCUT_SURFACE_QUERY_BATCH_H

#include <stddef.h>
#include <wirecut/projection.h>

enum {
    WCUT_QUERY_BLOCK = 1024,
    WCUT_QUERY_FOOT_SIZE = 128 /* bytes of a foot, at most */
};

/* What will be met in memory, in an order of its own: prefetched while a block is searched. */
typedef struct wcut_query_prefetch {
    const char *result; /* what the taker will write, `size` bytes a query */
    size_t size;
    const wcut_vec3 *query;  /* all of them */
    const int *index, *next; /* of this block and the next */
} wcut_query_prefetch;

/* to be called for each query of a block */
static inline void wcut_query_prefetch_next(const wcut_query_prefetch *a, int k) {
    const char *result = a->result + a->size * (size_t)a->index[k];
    __builtin_prefetch(result, 1, 2);
    __builtin_prefetch(result + a->size - 1, 1, 2);
    __builtin_prefetch(&a->query[a->next[k]], 0, 2);
}

/* finds the feet of 1 to WCUT_QUERY_BLOCK queries that are near one another */
typedef void wcut_query_locator(const void *on, int count, const wcut_vec3 *query, const wcut_query_prefetch *ahead,
                                void *foot);

/* takes foot[k] of query index[k]; called by several threads at a time, for disjoint queries */
typedef void wcut_query_taker(void *to, int count, const int *index, const void *foot);

typedef struct wcut_query_batch {
    wcut_query_locator *locate;
    const void *on;
    wcut_query_taker *take;
    void *to;
    const void *result; /* where `take` writes, for prefetching */
    size_t size;        /* [bytes] of a result */
} wcut_query_batch;

/* Queries are finite; the same blocks for any number of threads. WCUT_NO_MEMORY: nothing was taken. */
wcut_status wcut_query_batch_run(const wcut_query_batch *batch, int count, const wcut_vec3 *query, int threads);

/* a batch's locator of wcut_foot on a wcut_projection */
wcut_query_locator wcut_projection_locate_batch;

#endif
