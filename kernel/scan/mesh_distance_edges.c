/* What meets at a mesh's edges and corners: neighbours, the border, angle-weighted normals (Baerentzen, Aanaes 2005). */
#include "scan/mesh_distance_edges.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* An edge of a triangle: its lower and higher vertex in turn as it is sorted, then which one it is: 3 triangle + corner
   that it begins at, twice, and 1 if it runs from the higher vertex to the lower. */
typedef struct edge {
    int other;
    unsigned which;
} edge;

static inline int mesh_distance_edges_corner_of(edge e) { return (int)(e.which >> 1); }

/* the vertex that the edge begins at, and the next one */
static inline void ends_of(const wcut_mesh_tree *t, int corner, int *from, int *to) {
    *from = t->vertex[corner], *to = t->vertex[corner % 3 == 2 ? corner - 2 : corner + 1];
}

static void begin_buckets(int vertices, int *start) {
    for (int v = 0; v < vertices; v++) start[v + 1] += start[v];
}

/* by the higher vertex, then by the lower: stable counting sorts. `other` is the lower one, then the higher one;
   start[v] ends as the end of the lower vertex v. */
static void sort_edges(const wcut_mesh_tree *t, int vertices, int *start, edge *room, edge *sorted) {
    const int edges = 3 * t->triangles;
    int from, to;

    /* count the edges of each higher vertex */
    for (int k = 0; k < edges; k++) {
        ends_of(t, k, &from, &to);
        start[(from > to ? from : to) + 1]++;
    }

    /* put the edges into the buckets of their higher vertex, turned where they run downwards */
    begin_buckets(vertices, start);
    for (int k = 0; k < edges; k++) {
        ends_of(t, k, &from, &to);
        const bool turned = from > to;
        room[start[turned ? from : to]++] = (edge){turned ? to : from, 2 * (unsigned)k + turned};
    }

    /* the same by the lower vertex; the sort is stable, so that equal edges are neighbours */
    for (int v = 0; v <= vertices; v++) start[v] = 0;
    for (int k = 0; k < edges; k++) start[room[k].other + 1]++;
    begin_buckets(vertices, start);
    for (int k = 0; k < edges; k++) {
        ends_of(t, mesh_distance_edges_corner_of(room[k]), &from, &to);
        sorted[start[room[k].other]++] = (edge){from > to ? from : to, room[k].which};
    }
}

/* the triangles of one edge of space: one is a border, two are neighbours, anything else is odd */
static void mesh_distance_edges_join(wcut_mesh_tree *t, const edge *e, int count) {
    int low, high;
    ends_of(t, mesh_distance_edges_corner_of(e[0]), &low, &high);
    const bool whole = count == 2 && (e[0].which & 1) != (e[1].which & 1) && low != high;
    for (int k = 0; k < count; k++)
        t->neighbour[mesh_distance_edges_corner_of(e[k])] = whole        ? mesh_distance_edges_corner_of(e[1 - k]) / 3
                                                            : count == 1 ? -1
                                                                         : -2;
    t->info.border_edges += count == 1;
    t->info.nonmanifold_edges += count > 1 && !whole;
    if (count == 1) t->on_border[low] = t->on_border[high] = 1;
}

/* edges come in the order of their lower vertex, whose range ends at end[low] */
static void join_edges(wcut_mesh_tree *t, int vertices, const int *end, const edge *sorted) {
    for (int v = 0, k = 0; v < vertices; v++)
        for (int next; k < end[v]; k = next) {
            for (next = k + 1; next < end[v] && sorted[next].other == sorted[k].other;) next++;
            mesh_distance_edges_join(t, &sorted[k], next - k);
        }
}

static void mesh_distance_edges_find_normals(int vertices, wcut_mesh_tree *t) {
    for (int i = 0; i < t->triangles; i++) {
        /* the triangle's area vector, and sums over the mesh */
        const wcut_mesh_corners p = wcut_mesh_corners_of(t, i);
        const wcut_vec3 ab = vec3_sub(p.b, p.a), ac = vec3_sub(p.c, p.a), bc = vec3_sub(p.c, p.b);
        const wcut_vec3 area = vec3_scale(0.5, vec3_cross(ab, ac));
        const double size = vec3_length(area);
        t->info.flat += size == 0;
        t->info.area += size;
        t->info.area_sum = vec3_add(t->info.area_sum, area);
        if (size == 0) continue;

        /* unit normal, and the angles at the three corners */
        const wcut_vec3 n = vec3_scale(1 / size, area);
        const double at_a = atan2(2 * size, vec3_dot(ab, ac)), at_b = atan2(2 * size, -vec3_dot(ab, bc));
        const double angle[3] = {at_a, at_b, fmax(0, WCUT_PI - at_a - at_b)};

        /* add the normal to each corner, weighted by its angle */
        for (int k = 0; k < 3; k++) {
            wcut_vec3 *to = &t->normal[t->vertex[3 * (size_t)i + (size_t)k]];
            *to = vec3_add_scaled(*to, angle[k], n);
        }
    }

    for (int v = 0; v < vertices; v++) t->normal[v] = vec3_unit(t->normal[v]);
}

wcut_status wcut_mesh_edges_build(const wcut_mesh *mesh, wcut_mesh_tree *tree) {
    const int vertices = mesh->vertex_count;
    const size_t edges = 3 * (size_t)tree->triangles;
    edge *room = wcut_alloc(edges, sizeof *room), *sorted = wcut_alloc(edges, sizeof *sorted);
    int *start = wcut_alloc((size_t)vertices + 1, sizeof *start);
    tree->neighbour = wcut_alloc(edges, sizeof *tree->neighbour);
    tree->normal = wcut_alloc((size_t)vertices, sizeof *tree->normal);
    tree->on_border = wcut_alloc((size_t)vertices, 1);
    const bool there = room && sorted && start && tree->neighbour && tree->normal && tree->on_border;
    if (there) {
        sort_edges(tree, vertices, start, room, sorted);
        join_edges(tree, vertices, start, sorted);
        mesh_distance_edges_find_normals(vertices, tree);
    }
    wcut_free(start);
    wcut_free(sorted);
    wcut_free(room);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}
