/* A mesh's triangles in a balanced tree of boxes, eight to a node: ranges are halved across their longest side. */
#include <string.h>

#include "base/alloc.h"
#include "base/vec3.h"
#include "scan/mesh_distance.h"

/* a triangle on its way to its leaf */
typedef struct item {
    float at[3]; /* its middle, about the mesh's centre */
    int index;
} item;

typedef struct builder {
    const wcut_mesh *mesh;
    wcut_mesh_tree *tree;
    item *item;
    int nodes;
} builder;

static inline void swap_items(item *a, item *b) {
    const item keep = *a;
    *a = *b;
    *b = keep;
}

/* put the item of rank `rank` into its place, no larger one before it, no smaller one behind it (Hoare 1961); equal
   items stop both sides. The middle of three makes sorted input harmless; what is contrived against it is only slow. */
static void select_rank(item *a, int first, int end, int rank, int axis) {
    int low = first, high = end - 1;
    while (high > low) {
        const int middle = low + (high - low) / 2;
        if (a[middle].at[axis] < a[low].at[axis]) swap_items(&a[middle], &a[low]);
        if (a[high].at[axis] < a[low].at[axis]) swap_items(&a[high], &a[low]);
        if (a[high].at[axis] < a[middle].at[axis]) swap_items(&a[high], &a[middle]);
        const float pivot = a[middle].at[axis];
        int i = low, j = high;
        while (i <= j) {
            while (a[i].at[axis] < pivot) i++;
            while (a[j].at[axis] > pivot) j--;
            if (i <= j) swap_items(&a[i++], &a[j--]);
        }
        if (rank <= j)
            high = j;
        else if (rank >= i)
            low = i;
        else
            return;
    }
}

static int longest_axis(const item *a, int first, int end) {
    float low[3], high[3];
    memcpy(low, a[first].at, sizeof low);
    memcpy(high, a[first].at, sizeof high);
    for (int i = first + 1; i < end; i++)
        for (int c = 0; c < 3; c++) {
            low[c] = a[i].at[c] < low[c] ? a[i].at[c] : low[c];
            high[c] = a[i].at[c] > high[c] ? a[i].at[c] : high[c];
        }
    int axis = 0;
    for (int c = 1; c < 3; c++)
        if (high[c] - low[c] > high[axis] - low[axis]) axis = c;
    return axis;
}

/* a range into at most eight, none of them empty; gives how many. bound[k] .. bound[k + 1] is the k-th. */
static int divide(item *a, int first, int end, int bound[WCUT_MESH_WIDE + 1]) {
    int parts = 1;
    bound[0] = first, bound[1] = end;
    for (int round = 0; round < 3; round++) {
        int next[WCUT_MESH_WIDE + 1], count = 0;
        for (int k = 0; k < parts; k++) {
            next[count++] = bound[k];
            if (bound[k + 1] - bound[k] <= WCUT_MESH_LEAF) continue;
            const int middle = bound[k] + (bound[k + 1] - bound[k]) / 2;
            select_rank(a, bound[k], bound[k + 1], middle, longest_axis(a, bound[k], bound[k + 1]));
            next[count++] = middle;
        }
        next[count] = end;
        parts = count;
        memcpy(bound, next, (size_t)(parts + 1) * sizeof *bound);
    }
    return parts;
}

/* single precision, rounded away from the box by more than the conversion's error */
static void widen(const wcut_mesh_tree *t, wcut_vec3 p, float low[3], float high[3]) {
    const wcut_vec3 r = vec3_sub(p, t->centre);
    const double at[3] = {r.x, r.y, r.z}, slack = 1e-6 * t->size;
    for (int c = 0; c < 3; c++) {
        const float least = (float)(at[c] - slack), most = (float)(at[c] + slack);
        low[c] = least < low[c] ? least : low[c];
        high[c] = most > high[c] ? most : high[c];
    }
}

static void put_leaf(builder *b, int first, int end, float low[3], float high[3]) {
    wcut_mesh_tree *t = b->tree;
    for (int i = first; i < end; i++) {
        const int *v = b->mesh->triangle + 3 * (size_t)b->item[i].index;
        t->index[i] = b->item[i].index;
        memcpy(t->vertex + 3 * (size_t)i, v, 3 * sizeof *v);
        t->corner[i] = (wcut_mesh_corners){b->mesh->vertex[v[0]], b->mesh->vertex[v[1]], b->mesh->vertex[v[2]]};
        for (int k = 0; k < 3; k++) widen(t, b->mesh->vertex[v[k]], low, high);
    }
}

/* the node of a range and all below it; gives its number and its box. The depth is the logarithm to base 8. */
static int put_node(builder *b, int first, int end, float low[3], float high[3]) {
    int bound[WCUT_MESH_WIDE + 1];
    const int parts = divide(b->item, first, end, bound), number = b->nodes++;
    for (int k = 0; k < WCUT_MESH_WIDE; k++) {
        wcut_mesh_node *node = &b->tree->node[number];
        float l[3] = {INFINITY, INFINITY, INFINITY}, h[3] = {-INFINITY, -INFINITY, -INFINITY};
        const int count = k < parts ? bound[k + 1] - bound[k] : 0;
        if (count > WCUT_MESH_LEAF) {
            node->first[k] = put_node(b, bound[k], bound[k + 1], l, h);
        } else if (count > 0) {
            node->first[k] = bound[k];
            node->count[k] = count;
            put_leaf(b, bound[k], bound[k + 1], l, h);
        }
        for (int c = 0; c < 3; c++) {
            node->low[c][k] = l[c], node->high[c][k] = h[c];
            low[c] = l[c] < low[c] ? l[c] : low[c];
            high[c] = h[c] > high[c] ? h[c] : high[c];
        }
    }
    return number;
}

static void find_box(const wcut_mesh *mesh, wcut_mesh_tree *t) {
    wcut_vec3 low = mesh->vertex[mesh->triangle[0]], high = low;
    for (size_t k = 0; k < 3 * (size_t)mesh->triangle_count; k++) {
        const wcut_vec3 p = mesh->vertex[mesh->triangle[k]];
        low = vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    t->info.low = low, t->info.high = high;
    t->centre = vec3_mix(low, high, 0.5);
    t->size = vec3_distance(low, high) / 2;
}

wcut_status wcut_mesh_boxes_build(const wcut_mesh *mesh, wcut_mesh_tree *tree) {
    const size_t n = (size_t)mesh->triangle_count;
    builder b = {.mesh = mesh, .tree = tree, .item = wcut_alloc(n, sizeof *b.item)};
    tree->triangles = mesh->triangle_count;
    tree->corner = wcut_alloc(n, sizeof *tree->corner);
    tree->index = wcut_alloc(n, sizeof *tree->index);
    tree->vertex = wcut_alloc(n, 3 * sizeof *tree->vertex);
    /* a node's range has more than a leaf holds, and those of one level are disjoint: 1/5 + 1/40 + ... < 1/4 */
    tree->node = wcut_alloc(n / 4 + 8, sizeof *tree->node);
    const bool there = b.item && tree->corner && tree->index && tree->vertex && tree->node;
    if (there) {
        find_box(mesh, tree);
        for (size_t i = 0; i < n; i++) {
            const int *v = mesh->triangle + 3 * i;
            wcut_vec3 m = vec3_add(vec3_add(mesh->vertex[v[0]], mesh->vertex[v[1]]), mesh->vertex[v[2]]);
            m = vec3_sub(vec3_scale(1.0 / 3, m), tree->centre);
            b.item[i] = (item){{(float)m.x, (float)m.y, (float)m.z}, (int)i};
        }
        float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
        put_node(&b, 0, (int)n, low, high);
    }
    wcut_free(b.item);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}
