/* A mesh that grows as a file is read: corners in one place are one vertex, by a hash of their coordinates' bits. */
#include "io/mesh/mesh_builder.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"

bool wcut_mesh_builder_room(void **data, size_t *room, size_t need, size_t size) {
    if (need <= *room) return true;
    size_t wanted = *room < 512 ? 1024 : 2 * *room;
    if (wanted < need) wanted = need;
    void *grown = wanted <= SIZE_MAX / size ? wcut_grow(*data, wanted * size) : NULL;
    if (!grown) return false;
    *data = grown;
    *room = wanted;
    return true;
}

bool wcut_mesh_builder_point(wcut_mesh_builder *g, const double value[3], wcut_vec3 *point) {
    const double scale = g->source->scale;
    for (int k = 0; k < 3; k++) {
        if (!isfinite(value[k]))
            return wcut_source_refuse(g->source, "found a coordinate %c that is not finite, expected a number",
                                      "xyz"[k]);
        if (fabs(value[k] * scale) > WCUT_COORDINATE_FAR)
            return wcut_source_refuse(g->source,
                                      "found %c = %.6g mm, expected at most 1e12: a wrong byte order or unit?",
                                      "xyz"[k], value[k] * scale);
    }
    *point = (wcut_vec3){value[0] * scale, value[1] * scale, value[2] * scale};
    return true;
}

/* ---- vertices ---- */

static uint64_t bits_of(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* the finaliser of MurmurHash3 (Appleby 2011) over the three coordinates */
static size_t hash(wcut_vec3 p) {
    uint64_t h = bits_of(p.x);
    const uint64_t next[3] = {bits_of(p.y), bits_of(p.z), 0};
    for (int k = 0; k < 3; k++) {
        h ^= h >> 33;
        h *= 0xff51afd7ed558ccdu;
        h ^= h >> 33;
        h *= 0xc4ceb9fe1a85ec53u;
        h ^= h >> 33;
        h += next[k];
    }
    return (size_t)h;
}

/* the slot of a point, or the empty one where it belongs */
static size_t find_slot(const wcut_mesh_builder *g, wcut_vec3 p) {
    size_t at = hash(p) & (g->slots - 1);
    for (; g->slot[at]; at = (at + 1) & (g->slots - 1)) {
        const wcut_vec3 q = g->vertex[g->slot[at] - 1];
        if (q.x == p.x && q.y == p.y && q.z == p.z) break;
    }
    return at;
}

/* twice as many slots, filled anew */
static bool widen_mesh_builder(wcut_mesh_builder *g) {
    const size_t slots = g->slots ? 2 * g->slots : 1024;
    int *slot = wcut_alloc(slots, sizeof *slot);
    if (!slot) return false;
    free(g->slot);
    g->slot = slot;
    g->slots = slots;
    for (int i = 0; i < g->vertices; i++) slot[find_slot(g, g->vertex[i])] = i + 1;
    return true;
}

int wcut_mesh_builder_vertex(wcut_mesh_builder *g, wcut_vec3 p) {
    p = (wcut_vec3){p.x + 0.0, p.y + 0.0, p.z + 0.0}; /* -0 and 0 are one place */
    if (2 * ((size_t)g->vertices + 1) > g->slots && !widen_mesh_builder(g))
        return wcut_source_refuse_memory(g->source), -1;
    const size_t at = find_slot(g, p);
    if (g->slot[at]) return g->slot[at] - 1;
    if (g->vertices == INT_MAX - 1)
        return wcut_source_refuse(g->source, "found more vertices, expected at most %d", INT_MAX - 1), -1;
    if (!wcut_mesh_builder_room((void **)&g->vertex, &g->vertex_room, (size_t)g->vertices + 1, sizeof p))
        return wcut_source_refuse_memory(g->source), -1;
    g->vertex[g->vertices] = p;
    g->slot[at] = ++g->vertices;
    return g->vertices - 1;
}

/* ---- vertices as a file numbers them ---- */

bool wcut_numbered_add(wcut_mesh_builder *g, wcut_numbered *n, const double value[3]) {
    wcut_vec3 p;
    const size_t need = (size_t)n->count + 1;
    if (!wcut_mesh_builder_point(g, value, &p)) return false;
    if (n->count == INT_MAX - 1)
        return wcut_source_refuse(g->source, "found more vertices, expected at most %d", INT_MAX - 1);
    if (!wcut_mesh_builder_room((void **)&n->point, &n->point_room, need, sizeof p) ||
        !wcut_mesh_builder_room((void **)&n->vertex, &n->vertex_room, need, sizeof *n->vertex))
        return wcut_source_refuse_memory(g->source);
    n->point[n->count] = p;
    n->vertex[n->count++] = -1;
    return true;
}

int wcut_numbered_use(wcut_mesh_builder *g, wcut_numbered *n, int i) {
    if (n->vertex[i] < 0) n->vertex[i] = wcut_mesh_builder_vertex(g, n->point[i]);
    return n->vertex[i];
}

void wcut_numbered_free(wcut_numbered *n) {
    free(n->point);
    free(n->vertex);
}

/* ---- triangles ---- */

bool wcut_mesh_builder_triangle(wcut_mesh_builder *g, int a, int b, int c) {
    if (a == b || b == c || c == a) {
        g->collapsed += g->collapsed < INT_MAX;
        return true;
    }
    if (g->triangles == g->max)
        return wcut_source_refuse(g->source, "found more than %d triangles, expected at most that", g->max);
    const size_t n = 3 * (size_t)g->triangles;
    if (!wcut_mesh_builder_room((void **)&g->triangle, &g->triangle_room, n + 3, sizeof *g->triangle))
        return wcut_source_refuse_memory(g->source);
    g->triangle[n] = a;
    g->triangle[n + 1] = b;
    g->triangle[n + 2] = c;
    g->triangles++;
    return true;
}

bool wcut_mesh_builder_polygon(wcut_mesh_builder *g, int count, const int *corner) {
    if (count < 3 || count > WCUT_POLYGON_MAX)
        return wcut_source_refuse(g->source, "found a polygon of %d corners, expected 3 to %d", count,
                                  WCUT_POLYGON_MAX);
    if (count == 3) return wcut_mesh_builder_triangle(g, corner[0], corner[1], corner[2]);
    wcut_vec3 at[WCUT_POLYGON_MAX];
    int ear[3 * WCUT_POLYGON_MAX];
    for (int k = 0; k < count; k++) at[k] = g->vertex[corner[k]];
    wcut_polygon_split(count, at, ear);
    g->split += g->split < INT_MAX;
    for (int k = 0; k < 3 * (count - 2); k += 3)
        if (!wcut_mesh_builder_triangle(g, corner[ear[k]], corner[ear[k + 1]], corner[ear[k + 2]])) return false;
    return true;
}

/* ---- the end ---- */

static void find_box(const wcut_mesh_builder *g, wcut_mesh_read_info *info) {
    info->low = info->high = g->vertex[0];
    for (int i = 1; i < g->vertices; i++) {
        const wcut_vec3 p = g->vertex[i];
        info->low = (wcut_vec3){fmin(info->low.x, p.x), fmin(info->low.y, p.y), fmin(info->low.z, p.z)};
        info->high = (wcut_vec3){fmax(info->high.x, p.x), fmax(info->high.y, p.y), fmax(info->high.z, p.z)};
    }
}

bool wcut_mesh_builder_finish(wcut_mesh_builder *g, wcut_mesh **mesh, wcut_mesh_read_info *info) {
    wcut_mesh *made = NULL;
    if (g->triangles == 0)
        return wcut_source_refuse(g->source, "found no triangle (%d collapsed), expected at least one", g->collapsed);
    if (wcut_mesh_create(g->vertices, g->triangles, 0, &made) != WCUT_OK) return wcut_source_refuse_memory(g->source);
    memcpy(made->vertex, g->vertex, (size_t)g->vertices * sizeof *made->vertex);
    memcpy(made->triangle, g->triangle, 3 * (size_t)g->triangles * sizeof *made->triangle);
    info->collapsed = g->collapsed;
    info->split = g->split;
    find_box(g, info);
    *mesh = made;
    return true;
}

void wcut_mesh_builder_free(wcut_mesh_builder *g) {
    free(g->vertex);
    free(g->triangle);
    free(g->slot);
}
