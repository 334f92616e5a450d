/* The mounts' way of a design (Rust et al. 2016, 2.6): both ends of every wire of its plan prolonged along their
   tangents, from where the wire leaves the block to mounts that are clear of it, with one length of wire throughout; an
   approach before it and a way out behind it, on which the wire is out of the block. */
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "cut/setup.h"
#include "wire/chain.h"

#define INSIDE_MAX 0.05  /* [1] of the block's width: so long may a wire's prolongation run through foam */
#define LEAD_MARGIN 10.0 /* [mm] between block and wire where a lead begins or ends */
#define WAY_OUT 0.125    /* [1] wire lengths of way whose motion goes on behind the last station */

/* how far [mm] the straight way along t from p runs through the block */
static double way_inside(const wcut_block *block, wcut_vec3 p, wcut_vec3 t) {
    const double reach = block->size.x + block->size.y + block->size.z;
    wcut_vec3 unused[2];
    return reach * wcut_block_engagement(block, p, vec3_add_scaled(p, reach, t), unused, unused + 1);
}

/* The shortest way along t from a point on the block until it is `clearance` away. The distance from a convex block is
   convex along a line, so that beyond the shortest way it only grows. False where the line runs through the block. */
static bool way_to_clearance(const wcut_block *block, wcut_vec3 from, wcut_vec3 t, double clearance, double *way) {
    const double size = block->size.x + block->size.y + block->size.z + clearance;
    double low = 0, high = 10 * size;
    if (way_inside(block, from, t) > INSIDE_MAX * block->size.x) return false;
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

/* ---- the mounts of the plan's stations ---- */

typedef struct extension {
    wcut_vec3 out_a, out_b;
    double way_a, way_b; /* [mm] the smallest that keeps the clearance */
} extension;

static wcut_status extend(const wcut_setup *plan, const wcut_history *h, int j, extension *e, wcut_error *error) {
    const int n = h->nodes;

    /* end tangents that point out of the wire */
    const wcut_vec3 *x = h->position + (size_t)j * (size_t)n;
    double unused;
    e->out_a = wcut_chain_outward(x[0], x[1], x[2], &unused);
    e->out_b = wcut_chain_outward(x[n - 1], x[n - 2], x[n - 3], &unused);

    /* both ends, the first that does not come clear is named */
    const wcut_block *block = &plan->foam.block;
    const double clearance = plan->job->clearance;
    const char *end = "A";
    if (way_to_clearance(block, x[0], e->out_a, clearance, &e->way_a)) {
        end = "B";
        if (way_to_clearance(block, x[n - 1], e->out_b, clearance, &e->way_b)) return WCUT_OK;
    }
    return wcut_fail(
        error, WCUT_DEGENERATE,
        "station %d: the wire's tangent at end %s, prolonged, runs through the block or does not come %g mm clear of "
        "it; expected a wire that leaves the block there (edge_a on the side x = 0, edge_b on x = %g)",
        j, end, clearance, block->size.x);
}

/* The prolongations change with the wire's length between the edges by half its change each, so that it slides as little
   as it can and alike at both ends (the plan reckons with that): way = (L - l_j)/2 +- c. The smallest L and c that keep the
   clearance at every station. */
static double common_length(const wcut_setup *plan, int stations, const extension *e, double *shift) {
    double max_a = 0, max_b = 0;
    for (int j = 0; j < stations; j++) {
        max_a = fmax(max_a, 2 * e[j].way_a + plan->length[j]);
        max_b = fmax(max_b, 2 * e[j].way_b + plan->length[j]);
    }
    *shift = (max_a - max_b) / 4;
    return (max_a + max_b) / 2;
}

/* ---- leads ---- */

/* whether the wire at mounts a and b, through n nodes between, touches the block when all of it is moved */
static bool touches_moved(const wcut_block *block, int n, const wcut_vec3 *x, wcut_vec3 a, wcut_vec3 b,
                          wcut_vec3 move) {
    wcut_vec3 unused[2], last = vec3_add(a, move);
    for (int i = 0; i <= n; i++) {
        const wcut_vec3 next = vec3_add(i < n ? x[i] : b, move);
        if (wcut_block_engagement(block, last, next, unused, unused + 1) > 0) return true;
        last = next;
    }
    return false;
}

/* how far [mm] along `direction` the wire has to be moved until it is out of the block, and a margin */
static double way_clear(const wcut_block *block, int n, const wcut_vec3 *x, wcut_vec3 a, wcut_vec3 b,
                        wcut_vec3 direction) {
    const double reach = 2 * vec3_length(block->size), step = LEAD_MARGIN / 8;
    double way = 0;
    while (way < reach && touches_moved(block, n, x, a, b, vec3_scale(way, direction))) way += step;
    return way + LEAD_MARGIN;
}

/* the mean direction in which the edges end: that of the wire, while the mounts may even go back as it gets straight */
static wcut_vec3 last_motion(const wcut_setup *plan, int count) {
    const wcut_vec3 *a = plan->end_a, *b = plan->end_b;
    double way = 0;
    int j = count - 1;
    for (; j > 0 && way < WAY_OUT * plan->length[count - 1]; j--)
        way += (vec3_distance(a[j], a[j - 1]) + vec3_distance(b[j], b[j - 1])) / 2;
    const wcut_vec3 move = vec3_add(vec3_sub(a[count - 1], a[j]), vec3_sub(b[count - 1], b[j]));
    return vec3_length(move) > 1e-9 * plan->length[0] ? vec3_unit(move) : plan->feed;
}

/* stations of a lead of that way, about as far apart as those of the plan */
static int lead_stations(double way, double spacing) { return (int)clamp(ceil(way / spacing), 1, 100000); }

/* p holds the mounts of `count` stations of the plan, with room for none besides: put the leads before and behind */
static wcut_status add_leads(const wcut_setup *plan, const wcut_history *h, bool whole, wcut_design_path *p,
                             wcut_error *error) {
    /* in and out along the first and the last motion */
    const int n = h->nodes, count = h->stations, last = count - 1;
    const wcut_block *block = &plan->foam.block;
    const wcut_vec3 *first_x = h->position, *last_x = h->position + (size_t)last * (size_t)n;
    const wcut_vec3 back = vec3_scale(-1, plan->feed), onward = last_motion(plan, count);

    /* how long they are */
    double way = 0;
    for (int j = 1; j < count; j++)
        way += (vec3_distance(p->mount_a[j], p->mount_a[j - 1]) + vec3_distance(p->mount_b[j], p->mount_b[j - 1])) / 2;
    const double spacing = count > 1 ? way / last : LEAD_MARGIN / 4;
    const double way_in = way_clear(block, n, first_x, p->mount_a[0], p->mount_b[0], back);
    const double way_out = whole ? way_clear(block, n, last_x, p->mount_a[last], p->mount_b[last], onward) : 0;
    const int in = lead_stations(way_in, spacing), out = whole ? lead_stations(way_out, spacing) : 0;

    /* the plan's stations between both */
    const size_t total = (size_t)in + (size_t)count + (size_t)out;
    wcut_vec3 *a = wcut_alloc(total, sizeof *a), *b = wcut_alloc(total, sizeof *b);
    if (!a || !b) {
        wcut_free(a);
        wcut_free(b);
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for the path curves of %d stations", count);
    }
    for (int j = 0; j < in; j++) {
        const double left = way_in * (in - j) / in;
        a[j] = vec3_add_scaled(p->mount_a[0], left, back);
        b[j] = vec3_add_scaled(p->mount_b[0], left, back);
    }
    memcpy(a + in, p->mount_a, (size_t)count * sizeof *a);
    memcpy(b + in, p->mount_b, (size_t)count * sizeof *b);
    for (int j = 1; j <= out; j++) {
        a[in + last + j] = vec3_add_scaled(p->mount_a[last], way_out * j / out, onward);
        b[in + last + j] = vec3_add_scaled(p->mount_b[last], way_out * j / out, onward);
    }

    /* they take the place of what was there */
    wcut_free(p->mount_a);
    wcut_free(p->mount_b);
    p->mount_a = a, p->mount_b = b;
    p->stations = (int)total;
    p->part_first = in, p->part_last = in + last;

    return WCUT_OK;
}

wcut_status wcut_design_path_create(const wcut_setup *plan, const wcut_history *h, wcut_design_path *out,
                                    wcut_error *error) {
    /* room for the extensions and the mounts of all stations */
    const size_t m = (size_t)h->stations, n = (size_t)h->nodes;
    extension *e = wcut_alloc(m, sizeof *e);
    wcut_design_path p = {0};
    p.mount_a = wcut_alloc(m, sizeof *p.mount_a);
    p.mount_b = wcut_alloc(m, sizeof *p.mount_b);
    wcut_status status = WCUT_OK;
    if (!e || !p.mount_a || !p.mount_b)
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for the path curves of %d stations", h->stations);
    for (int j = 0; status == WCUT_OK && j < h->stations; j++) status = extend(plan, h, j, &e[j], error);

    /* one length of wire, the mounts along the tangents */
    if (status == WCUT_OK) {
        double shift;
        p.length = common_length(plan, h->stations, e, &shift);

        /* both mounts at the ends of the wire prolonged, shifted so that material slides evenly */
        for (size_t j = 0; j < m; j++) {
            const wcut_vec3 *x = h->position + j * n;
            const double half = (p.length - plan->length[j]) / 2;
            p.mount_a[j] = vec3_add_scaled(x[0], half + shift, e[j].out_a);
            p.mount_b[j] = vec3_add_scaled(x[n - 1], half - shift, e[j].out_b);
        }
        status = add_leads(plan, h, h->stations == h->planned, &p, error);
    }
    wcut_free(e);
    if (status == WCUT_OK)
        *out = p;
    else
        wcut_design_path_destroy(&p);

    return status;
}

void wcut_design_path_destroy(wcut_design_path *path) {
    wcut_free(path->mount_a);
    wcut_free(path->mount_b);
    *path = (wcut_design_path){0};
}

/* ---- the public view ---- */

wcut_status wcut_history_path(const wcut_setup *setup, const wcut_history *history, wcut_vec3 *mount_a,
                              wcut_vec3 *mount_b, double *length, wcut_error *error) {
    if (!setup || !history || history->stations < 1 || history->nodes < 3 || !mount_a || !mount_b || !length)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a setup, its history and places for the paths are expected");
    if (history->stations > setup->stations)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "found a history of %d stations, expected at most the setup's %d",
                         history->stations, setup->stations);

    /* not the wire's ends: mounts may give way */
    memcpy(mount_a, setup->end_a, (size_t)history->stations * sizeof *mount_a);
    memcpy(mount_b, setup->end_b, (size_t)history->stations * sizeof *mount_b);
    *length = setup->length[0];
    return WCUT_OK;
}
