/* Sweeps of many queries along a curve through space, so that neighbours are answered together. */
#include "surface/sweep.h"

#include "base/alloc.h"
#include "surface/morton.h"

enum { BLOCK = WCUT_SWEEP_BLOCK };

wcut_status wcut_sweep_run(const wcut_sweep *sweep, int count, const wcut_vec3 *query, int threads) {
    int *order;
    const wcut_status status = wcut_morton_order(count, query, threads, &order);
    if (status != WCUT_OK) return status;
    const int blocks = count / BLOCK + (count % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int block = 0; block < blocks; block++) {
        const int first = block * BLOCK, here = block == blocks - 1 ? count - first : BLOCK;
        wcut_vec3 near[BLOCK];
        _Alignas(16) char foot[BLOCK * WCUT_SWEEP_FOOT];
        for (int k = 0; k < here; k++) near[k] = query[order[first + k]];
        const wcut_sweep_ahead ahead = {.result = sweep->result,
                                        .size = sweep->size,
                                        .query = query,
                                        .index = &order[first],
                                        .next = &order[block + 2 < blocks ? first + BLOCK : first]};
        sweep->locate(sweep->on, here, near, &ahead, foot);
        sweep->take(sweep->to, here, &order[first], foot);
    }
    wcut_free(order);
    return WCUT_OK;
}
