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

bool wcut_mesh_builder_point(wcut_mesh_builder *builder, const double value[3], wcut_vec3 *point) {
    const double scale = builder->source->scale;
    for (int k = 0; k < 3; k++) {
        if (!isfinite(value[k]))
            return wcut_source_refuse(builder->source, "found a coordinate %c that is not finite, expected a number",
                                      "xyz"[k]);
        if (fabs(value[k] * scale) > WCUT_COORDINATE_FAR)
            return wcut_source_refuse(builder->source,
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
static size_t find_vertex_slot(const wcut_mesh_builder *builder, wcut_vec3 p) {
    size_t at = hash(p) & (builder->slots - 1);
    for (; builder->slot[at]; at = (at + 1) & (builder->slots - 1)) {
        const wcut_vec3 q = builder->vertex[builder->slot[at] - 1];
        if (q.x == p.x && q.y == p.y && q.z == p.z) break;
    }
    return at;
}

/* twice as many slots, filled anew */
static bool widen_mesh_builder(wcut_mesh_builder *builder) {
    const size_t slots = builder->slots ? 2 * builder->slots : 1024;
    int *slot = wcut_alloc(slots, sizeof *slot);
    if (!slot) return false;
    free(builder->slot);
    builder->slot = slot;
    builder->slots = slots;
    for (int i = 0; i < builder->vertices; i++) slot[find_vertex_slot(builder, builder->vertex[i])] = i + 1;
    return true;
}

int wcut_mesh_builder_vertex(wcut_mesh_builder *builder, wcut_vec3 p) {
    p = (wcut_vec3){p.x + 0.0, p.y + 0.0, p.z + 0.0}; /* -0 and 0 are one place */
    if (2 * ((size_t)builder->vertices + 1) > builder->slots && !widen_mesh_builder(builder))
        return wcut_source_refuse_memory(builder->source), -1;
    const size_t at = find_vertex_slot(builder, p);
    if (builder->slot[at]) return builder->slot[at] - 1;
    if (builder->vertices == INT_MAX - 1)
        return wcut_source_refuse(builder->source, "found more vertices, expected at most %d", INT_MAX - 1), -1;
    if (!wcut_mesh_builder_room((void **)&builder->vertex, &builder->vertex_room, (size_t)builder->vertices + 1,
                                sizeof p))
        return wcut_source_refuse_memory(builder->source), -1;
    builder->vertex[builder->vertices] = p;
    builder->slot[at] = ++builder->vertices;
    return builder->vertices - 1;
}

/* ---- vertices as a file numbers them ---- */

bool wcut_numbered_add(wcut_mesh_builder *builder, wcut_numbered *n, const double value[3]) {
    wcut_vec3 p;
    const size_t need = (size_t)n->count + 1;
    if (!wcut_mesh_builder_point(builder, value, &p)) return false;
    if (n->count == INT_MAX - 1)
        return wcut_source_refuse(builder->source, "found more vertices, expected at most %d", INT_MAX - 1);
    if (!wcut_mesh_builder_room((void **)&n->point, &n->point_room, need, sizeof p) ||
        !wcut_mesh_builder_room((void **)&n->vertex, &n->vertex_room, need, sizeof *n->vertex))
        return wcut_source_refuse_memory(builder->source);
    n->point[n->count] = p;
    n->vertex[n->count++] = -1;
    return true;
}

int wcut_numbered_use(wcut_mesh_builder *builder, wcut_numbered *n, int i) {
    if (n->vertex[i] < 0) n->vertex[i] = wcut_mesh_builder_vertex(builder, n->point[i]);
    return n->vertex[i];
}

void wcut_numbered_free(wcut_numbered *n) {
    free(n->point);
    free(n->vertex);
}

/* ---- triangles ---- */

bool wcut_mesh_builder_triangle(wcut_mesh_builder *builder, int a, int b, int c) {
    if (a == b || b == c || c == a) {
        builder->collapsed += builder->collapsed < INT_MAX;
        return true;
    }
    if (builder->triangles == builder->max)
        return wcut_source_refuse(builder->source, "found more than %d triangles, expected at most that", builder->max);
    const size_t n = 3 * (size_t)builder->triangles;
    if (!wcut_mesh_builder_room((void **)&builder->triangle, &builder->triangle_room, n + 3, sizeof *builder->triangle))
        return wcut_source_refuse_memory(builder->source);
    builder->triangle[n] = a;
    builder->triangle[n + 1] = b;
    builder->triangle[n + 2] = c;
    builder->triangles++;
    return true;
}

bool wcut_mesh_builder_polygon(wcut_mesh_builder *builder, int count, const int *corner) {
    if (count < 3 || count > WCUT_POLYGON_MAX)
        return wcut_source_refuse(builder->source, "found a polygon of %d corners, expected 3 to %d", count,
                                  WCUT_POLYGON_MAX);
    if (count == 3) return wcut_mesh_builder_triangle(builder, corner[0], corner[1], corner[2]);
    wcut_vec3 at[WCUT_POLYGON_MAX];
    int ear[3 * WCUT_POLYGON_MAX];
    for (int k = 0; k < count; k++) at[k] = builder->vertex[corner[k]];
    wcut_polygon_split(count, at, ear);
    builder->split += builder->split < INT_MAX;
    for (int k = 0; k < 3 * (count - 2); k += 3)
        if (!wcut_mesh_builder_triangle(builder, corner[ear[k]], corner[ear[k + 1]], corner[ear[k + 2]])) return false;
    return true;
}

/* ---- the end ---- */

static void find_box(const wcut_mesh_builder *builder, wcut_mesh_read_info *info) {
    info->low = info->high = builder->vertex[0];
    for (int i = 1; i < builder->vertices; i++) {
        const wcut_vec3 p = builder->vertex[i];
        info->low = (wcut_vec3){fmin(info->low.x, p.x), fmin(info->low.y, p.y), fmin(info->low.z, p.z)};
        info->high = (wcut_vec3){fmax(info->high.x, p.x), fmax(info->high.y, p.y), fmax(info->high.z, p.z)};
    }
}

bool wcut_mesh_builder_finish(wcut_mesh_builder *builder, wcut_mesh **mesh, wcut_mesh_read_info *info) {
    wcut_mesh *made = NULL;
    if (builder->triangles == 0)
        return wcut_source_refuse(builder->source, "found no triangle (%d collapsed), expected at least one",
                                  builder->collapsed);
    if (wcut_mesh_create(builder->vertices, builder->triangles, 0, &made) != WCUT_OK)
        return wcut_source_refuse_memory(builder->source);
    memcpy(made->vertex, builder->vertex, (size_t)builder->vertices * sizeof *made->vertex);
    memcpy(made->triangle, builder->triangle, 3 * (size_t)builder->triangles * sizeof *made->triangle);
    info->collapsed = builder->collapsed;
    info->split = builder->split;
    find_box(builder, info);
    *mesh = made;
    return true;
}

void wcut_mesh_builder_free(wcut_mesh_builder *builder) {
    free(builder->vertex);
    free(builder->triangle);
    free(builder->slot);
}
