/* Sweeps of many queries along a curve through space, so that neighbours are answered together. */
#include "surface/query_batch.h"

#include "base/alloc.h"
#include "base/threads.h"
#include "surface/morton.h"

enum { BLOCK = WCUT_QUERY_BLOCK };

wcut_status wcut_query_batch_run(const wcut_query_batch *batch, int count, const wcut_vec3 *query, int threads) {
    /* the order along the curve */
    int *order;
    const wcut_status status = wcut_morton_order(count, query, threads, &order);
    if (status != WCUT_OK) return status;

    /* blocks of neighbours, each answered by one thread */
    const int blocks = count / BLOCK + (count % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(wcut_threads(threads))
    for (int block = 0; block < blocks; block++) {
        const int first = block * BLOCK, here = block == blocks - 1 ? count - first : BLOCK;
        wcut_vec3 near[BLOCK];
        _Alignas(16) char foot[BLOCK * WCUT_QUERY_FOOT_SIZE];

        /* the queries of the block, with the next block prefetched */
        for (int k = 0; k < here; k++) near[k] = query[order[first + k]];
        const wcut_query_prefetch ahead = {.result = batch->result,
                                           .size = batch->size,
                                           .query = query,
                                           .index = &order[first],
                                           .next = &order[block + 2 < blocks ? first + BLOCK : first]};

        batch->locate(batch->on, here, near, &ahead, foot);
        batch->take(batch->to, here, &order[first], foot);
    }

    wcut_free(order);
    return WCUT_OK;
}
