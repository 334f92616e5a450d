/* Path curves of a design: both ends of every wire prolonged along their tangents to one common length, mounts clear of
   the block (Rust et al. 2016, 2.6). */
#include <wirecut/history.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "cut/setup.h"
#include "wire/chain.h"

/* The shortest way along t from a point on the block until it is `clearance` away. The distance from a convex block is
   convex along a line, so that beyond the shortest way it only grows. False where the line runs into the block. */
static bool way_to_clearance(const wcut_block *block, wcut_vec3 from, wcut_vec3 t, double clearance, double *way) {
    const double size = block->size.x + block->size.y + block->size.z + clearance;
    const wcut_vec3 near = vec3_add_scaled(from, 1e-6 * size, t);
    const double slack = 1e-7 * size; /* edge curves lie on the faces only as well as their numbers are rounded */
    if (near.x > slack && near.x < block->size.x - slack && near.y > slack && near.y < block->size.y - slack &&
        near.z > slack && near.z < block->size.z - slack)
        return false;
    double low = 0, high = 10 * size;
    if (wcut_block_distance(block, vec3_add_scaled(from, high, t)) < clearance) return false;
    for (int i = 0; i < 200 && high - low > 1e-12 * size; i++) {
        const double middle = (low + high) / 2;
        if (wcut_block_distance(block, vec3_add_scaled(from, middle, t)) < clearance)
            low = middle;
        else
            high = middle;
    }
    *way = high;
    return true;
}

typedef struct extension {
    wcut_vec3 out_a, out_b;
    double way_a, way_b; /* [mm] the least that keeps the clearance */
} extension;

static wcut_status extend(const wcut_setup *setup, const wcut_history *h, int j, extension *e, wcut_error *error) {
    const int n = h->nodes;
    const wcut_vec3 *x = h->position + (size_t)j * (size_t)n;
    double unused;
    e->out_a = wcut_chain_outward(x[0], x[1], x[2], &unused);
    e->out_b = wcut_chain_outward(x[n - 1], x[n - 2], x[n - 3], &unused);
    const wcut_block *block = &setup->foam.block;
    const double clearance = setup->job->clearance;
    const char *end = "A";
    if (way_to_clearance(block, x[0], e->out_a, clearance, &e->way_a)) {
        end = "B";
        if (way_to_clearance(block, x[n - 1], e->out_b, clearance, &e->way_b)) return WCUT_OK;
    }
    return wcut_fail(
        error, WCUT_DEGENERATE,
        "station %d: the wire's tangent at end %s, prolonged, does not come %g mm clear of the block; expected "
        "a wire that leaves the block there",
        j, end, clearance);
}

/* what is left of the common length goes to both ends alike */
static void place_mounts(const wcut_setup *setup, const wcut_history *h, const extension *e, double common,
                         wcut_vec3 *mount_a, wcut_vec3 *mount_b) {
    const size_t n = (size_t)h->nodes;
    for (int j = 0; j < h->stations; j++) {
        const wcut_vec3 *x = h->position + (size_t)j * n;
        const double rest = (common - setup->length[j] - e[j].way_a - e[j].way_b) / 2;
        mount_a[j] = vec3_add_scaled(x[0], e[j].way_a + rest, e[j].out_a);
        mount_b[j] = vec3_add_scaled(x[n - 1], e[j].way_b + rest, e[j].out_b);
    }
}

wcut_status wcut_history_path(const wcut_setup *setup, const wcut_history *history, wcut_vec3 *mount_a,
                              wcut_vec3 *mount_b, double *length, wcut_error *error) {
    if (!setup || !history || history->stations < 1 || history->nodes < 3 || !mount_a || !mount_b || !length)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a setup, its history and places for the paths are expected");
    const int m = history->stations;
    if (m > setup->job->stations)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found a history of %d stations, expected at most the setup's %d", m,
                         setup->job->stations);
    if (setup->job->mode == WCUT_MODE_PATH) {
        for (int j = 0; j < m; j++) {
            mount_a[j] = setup->end_a[j]; /* not the wire's ends: mounts may give way */
            mount_b[j] = setup->end_b[j];
        }
        *length = setup->job->wire_length;
        return WCUT_OK;
    }
    extension *e = wcut_alloc((size_t)m, sizeof *e);
    if (!e) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for the path curves of %d stations", m);
    wcut_status status = WCUT_OK;
    double common = 0;
    for (int j = 0; j < m && status == WCUT_OK; j++) {
        status = extend(setup, history, j, &e[j], error);
        common = fmax(common, setup->length[j] + e[j].way_a + e[j].way_b);
    }
    if (status == WCUT_OK) {
        place_mounts(setup, history, e, common, mount_a, mount_b);
        *length = common;
    }
    wcut_free(e);
    return status;
}
