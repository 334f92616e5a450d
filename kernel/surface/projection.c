/* Projection of many points on a surface: the tree they share, their order, threads. */
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/foot_search.h"
#include "surface/morton.h"
#include "surface/query_batch.h"

/* Queries of a block start from those before; blocks know nothing of each other, so threads change no byte. */
enum { BLOCK = WCUT_QUERY_BLOCK };

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
    wcut_newton_foot_destroy(projection->newton);
    wcut_free(projection->node);
    wcut_free(projection);
}

wcut_status wcut_projection_prepare_many(wcut_projection *projection) {
    if (!projection) return WCUT_BAD_ARGUMENT;
    return projection->newton ? WCUT_OK
                              : wcut_newton_foot_create(projection->surface, projection->size, &projection->newton);
}

/* ---- many queries ---- */

/* the first query by a search of the tree, then all of a block side by side; what is left one by one, from where such a
   search ended last */
void wcut_projection_locate_batch(const void *on, int count, const wcut_vec3 *query, const wcut_query_prefetch *ahead,
                                  void *feet) {
    const wcut_projection *m = on;
    wcut_foot *foot = feet;
    _Static_assert(sizeof(wcut_foot) <= WCUT_QUERY_FOOT_SIZE, "fits");
    unsigned char done[BLOCK] = {0};
    wcut_span_place start[BLOCK];
    const wcut_foot *near = &foot[0];

    /* the first query by the tree */
    wcut_foot_search(m, query[0], NULL, &foot[0]);

    /* the others by Newton steps within spans */
    if (m->newton) {
        const wcut_span_place from = wcut_span_place_at(m->newton, near->u, near->v);
        wcut_query_prefetch rest = *ahead;
        rest.index++, rest.next++;
        wcut_newton_foot_batch(m->newton, count - 1, query + 1, from, &rest, foot + 1, done + 1, start + 1);
    }

    /* what is left: Newton from where the batch stopped, then from the last foot that the tree found */
    for (int k = 1; k < count; k++) {
        if (done[k]) continue;
        wcut_foot_jet at;
        if (m->newton && wcut_newton_foot_slide(m->newton, query[k], start[k], &at)) {
            wcut_foot_describe(m, query[k], &at, &foot[k]);
            continue;
        }
        if (m->newton) {
            const wcut_span_place from = wcut_span_place_at(m->newton, near->u, near->v);
            if (wcut_newton_foot_slide(m->newton, query[k], wcut_newton_foot_walk(m->newton, query[k], from), &at)) {
                wcut_foot_describe(m, query[k], &at, &foot[k]);
                continue;
            }
        }

        /* last by the tree */
        wcut_foot_search(m, query[k], near, &foot[k]);
        near = &foot[k];
    }
}

static void put_feet(void *to, int count, const int *index, const void *foot) {
    const wcut_foot *from = foot;
    wcut_foot *all = to;
    for (int k = 0; k < count; k++) all[index[k]] = from[k];
}

wcut_status wcut_projection_locate(const wcut_projection *projection, int count, const wcut_vec3 *query, int threads,
                                   wcut_foot *foot) {
    if (!projection || count < 0 || threads < 1 || (count > 0 && (!query || !foot))) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++)
        if (!(vec3_length(query[k]) < FAR)) return WCUT_BAD_ARGUMENT;
    const wcut_query_batch batch = {.locate = wcut_projection_locate_batch,
                                    .on = projection,
                                    .take = put_feet,
                                    .to = foot,
                                    .result = foot,
                                    .size = sizeof *foot};
    return wcut_query_batch_run(&batch, count, query, threads);
}
