/* Projection of many points on a surface: the tree they share, their order, threads. */
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/foot_search.h"
#include "surface/morton.h"

/* Queries of a block start from the one before; blocks know nothing of each other, so threads change no byte. */
enum { BLOCK = 256, AHEAD = 8 };

/* [mm] squares of lengths up to this stay finite, with room for products */
static const double FAR = 1e100;

/* the diagonal of the control points' box and the largest coordinate */
static double size_of(const wcut_surface *s) {
    wcut_vec3 low = s->control[0], high = low;
    for (int k = 1; k < s->count_u * s->count_v; k++) {
        const wcut_vec3 c = s->control[k];
        low = vec3(fmin(low.x, c.x), fmin(low.y, c.y), fmin(low.z, c.z));
        high = vec3(fmax(high.x, c.x), fmax(high.y, c.y), fmax(high.z, c.z));
    }
    return vec3_distance(low, high) + fmax(vec3_length(low), vec3_length(high));
}

wcut_status wcut_projection_create(const wcut_surface *surface, wcut_projection **projection) {
    if (!surface || !projection) return WCUT_BAD_ARGUMENT;
    wcut_projection *m = wcut_alloc(1, sizeof *m);
    if (!m) return WCUT_NO_MEMORY;
    m->surface = surface;
    m->size = size_of(surface);
    if (!(m->size < FAR)) {
        wcut_free(m);
        return WCUT_DEGENERATE;
    }
    wcut_surface_domain(surface, m->first, m->last);
    const wcut_status status = wcut_patch_tree_build(surface, &m->node);
    if (status == WCUT_OK) {
        *projection = m;
    } else {
        wcut_free(m);
    }
    return status;
}

void wcut_projection_destroy(wcut_projection *projection) {
    if (!projection) return;
    wcut_quick_destroy(projection->quick);
    wcut_free(projection->node);
    wcut_free(projection);
}

wcut_status wcut_projection_hasten(wcut_projection *projection) {
    if (!projection) return WCUT_BAD_ARGUMENT;
    return projection->quick ? WCUT_OK : wcut_quick_create(projection->surface, &projection->quick);
}

wcut_status wcut_projection_locate(const wcut_projection *projection, int count, const wcut_vec3 *query, int threads,
                                   wcut_foot *foot) {
    if (!projection || count < 0 || threads < 1 || (count > 0 && (!query || !foot))) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++)
        if (!(vec3_length(query[k]) < FAR)) return WCUT_BAD_ARGUMENT;
    int *order;
    const wcut_status status = wcut_morton_order(count, query, &order);
    if (status != WCUT_OK) return status;
    const int blocks = count / BLOCK + (count % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int block = 0; block < blocks; block++) {
        const wcut_foot *near = NULL;
        wcut_quick_place place = {-1, -1};
        const int end = block == blocks - 1 ? count : (block + 1) * BLOCK;
        for (int k = block * BLOCK; k < end; k++) {
            if (k + AHEAD < end) {
                __builtin_prefetch(&query[order[k + AHEAD]]);
                __builtin_prefetch(&foot[order[k + AHEAD]], 1);
            }
            wcut_foot *to = &foot[order[k]];
            if (!near || !projection->quick || !wcut_quick_foot(projection->quick, query[order[k]], near, &place, to))
                wcut_foot_search(projection, query[order[k]], near, to);
            near = to;
        }
    }
    wcut_free(order);
    return WCUT_OK;
}
