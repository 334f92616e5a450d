/* What meets at a mesh's edges and corners: neighbours, the border, angle-weighted normals (Baerentzen, Aanaes 2005). */
#include "base/alloc.h"
#include "base/vec3.h"
#include "scan/mesh_distance.h"

/* the edge of triangle `triangle` from its corner `corner` to the next, by its lower and its higher vertex */
typedef struct edge {
    int low, high, triangle;
    unsigned char corner, turned; /* turned: it runs from high to low */
} edge;

static wcut_vec3 area_of(const wcut_mesh_corners *t) {
    return vec3_scale(0.5, vec3_cross(vec3_sub(t->b, t->a), vec3_sub(t->c, t->a)));
}

/* stable counting sort by one of the vertices */
static void sort_pass(int count, int vertices, int *start, const edge *from, edge *to, bool by_low) {
    for (int v = 0; v <= vertices; v++) start[v] = 0;
    for (int k = 0; k < count; k++) start[(by_low ? from[k].low : from[k].high) + 1]++;
    for (int v = 0; v < vertices; v++) start[v + 1] += start[v];
    for (int k = 0; k < count; k++) to[start[by_low ? from[k].low : from[k].high]++] = from[k];
}

static void list_edges(const wcut_mesh_tree *t, edge *list) {
    for (int i = 0; i < t->triangles; i++)
        for (int k = 0; k < 3; k++) {
            const int from = t->vertex[3 * (size_t)i + k], to = t->vertex[3 * (size_t)i + (k + 1) % 3];
            const bool turned = from > to;
            list[3 * (size_t)i + k] =
                (edge){turned ? to : from, turned ? from : to, i, (unsigned char)k, (unsigned char)turned};
        }
}

/* the triangles of one edge of space: one is a border, two are neighbours, anything else is odd */
static void join(wcut_mesh_tree *t, const edge *e, int count) {
    const bool whole = count == 2 && e[0].turned != e[1].turned && e[0].low != e[0].high;
    for (int k = 0; k < count; k++) {
        int *to = &t->neighbour[3 * (size_t)e[k].triangle + e[k].corner];
        *to = whole ? e[1 - k].triangle : count == 1 ? -1 : -2;
    }
    t->info.border_edges += count == 1;
    t->info.odd_edges += count > 1 && !whole;
    if (count == 1) t->on_border[e->low] = t->on_border[e->high] = 1;
}

static double angle_at(wcut_vec3 at, wcut_vec3 p, wcut_vec3 q) {
    const wcut_vec3 r = vec3_sub(p, at), s = vec3_sub(q, at);
    return atan2(vec3_length(vec3_cross(r, s)), vec3_dot(r, s));
}

static void find_normals(int vertices, wcut_mesh_tree *t) {
    for (int i = 0; i < t->triangles; i++) {
        const wcut_mesh_corners *p = &t->corner[i];
        const wcut_vec3 area = area_of(p), n = vec3_unit(area);
        const double size = vec3_length(area);
        t->info.flat += size == 0;
        t->info.area += size;
        t->info.area_sum = vec3_add(t->info.area_sum, area);
        if (size == 0) continue;
        const double angle[3] = {angle_at(p->a, p->b, p->c), angle_at(p->b, p->c, p->a), angle_at(p->c, p->a, p->b)};
        for (int k = 0; k < 3; k++) {
            wcut_vec3 *to = &t->normal[t->vertex[3 * (size_t)i + k]];
            *to = vec3_add_scaled(*to, angle[k], n);
        }
    }
    for (int v = 0; v < vertices; v++) t->normal[v] = vec3_unit(t->normal[v]);
}

wcut_status wcut_mesh_edges_build(const wcut_mesh *mesh, wcut_mesh_tree *tree) {
    const int vertices = mesh->vertex_count, edges = 3 * tree->triangles;
    edge *list = wcut_alloc((size_t)edges, sizeof *list), *sorted = wcut_alloc((size_t)edges, sizeof *sorted);
    int *start = wcut_alloc((size_t)vertices + 1, sizeof *start);
    tree->neighbour = wcut_alloc((size_t)edges, sizeof *tree->neighbour);
    tree->normal = wcut_alloc((size_t)vertices, sizeof *tree->normal);
    tree->on_border = wcut_alloc((size_t)vertices, 1);
    const bool there = list && sorted && start && tree->neighbour && tree->normal && tree->on_border;
    if (there) {
        list_edges(tree, list);
        sort_pass(edges, vertices, start, list, sorted, false);
        sort_pass(edges, vertices, start, sorted, list, true);
        for (int k = 0, end; k < edges; k = end) {
            for (end = k + 1; end < edges && list[end].low == list[k].low && list[end].high == list[k].high;) end++;
            join(tree, &list[k], end - k);
        }
        find_normals(vertices, tree);
    }
    wcut_free(start);
    wcut_free(sorted);
    wcut_free(list);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}
