/* A mesh's triangles in a tree of boxes, eight to a node: ranges of the Z-curve, divided where its cells are. */
#include "scan/mesh_distance_boxes.h"

#include <string.h>

#include "base/alloc.h"
#include "base/vec3.h"
#include "surface/morton.h"

typedef struct builder {
    const wcut_mesh *mesh;
    wcut_mesh_tree *tree;
    const uint64_t *item; /* triangles along the Z-curve of their middles */
    int nodes, leaves;
} builder;

/* Where to divide a range of the curve: at the highest bit that its codes do not share (Lauterbach 2009), which is the
   middle of a cell; a range in one cell is halved. */
static int split_of(const uint64_t *item, int first, int end) {
    const uint64_t changed = (item[first] ^ item[end - 1]) >> WCUT_MORTON_INDEX;
    if (changed == 0) return first + (end - first) / 2;
    uint64_t bit = (uint64_t)1 << WCUT_MORTON_INDEX;
    for (uint64_t rest = changed >> 1; rest > 0; rest >>= 1) bit <<= 1;
    int low = first, high = end - 1; /* the bit is 0 at low, 1 at high */
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (item[middle] & bit)
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* a range into at most eight, none of them empty; gives how many. bound[k] .. bound[k + 1] is the k-th. */
static int mesh_distance_boxes_divide(const uint64_t *item, int first, int end, int bound[WCUT_MESH_WIDE + 1]) {
    int parts = 1;
    bound[0] = first, bound[1] = end;
    for (int round = 0; round < 3; round++) {
        int next[WCUT_MESH_WIDE + 1], count = 0;
        for (int k = 0; k < parts; k++) {
            next[count++] = bound[k];
            if (bound[k + 1] - bound[k] <= WCUT_MESH_LEAF) continue;
            next[count++] = split_of(item, bound[k], bound[k + 1]);
        }
        next[count] = end;
        parts = count;
        memcpy(bound, next, (size_t)(parts + 1) * sizeof *bound);
    }
    return parts;
}

/* single precision, rounded away from the box by more than the conversion's error */
static void mesh_distance_boxes_widen(const wcut_mesh_tree *t, wcut_vec3 p, float low[3], float high[3]) {
    const wcut_vec3 r = vec3_sub(p, t->centre);
    const double at[3] = {r.x, r.y, r.z}, slack = 1e-6 * t->size;
    for (int c = 0; c < 3; c++) {
        const float min = (float)(at[c] - slack), max = (float)(at[c] + slack);
        low[c] = min < low[c] ? min : low[c];
        high[c] = max > high[c] ? max : high[c];
    }
}

/* [1], [of the mesh's size]: what is thinner has no normal that can be told to 1e-6 */
static const double THIN = 1e-6, LOW = 1e-9;

/* the unit normal of a triangle; zero where it is too thin */
static wcut_vec3 normal_of(const wcut_mesh_tree *t, const wcut_vec3 corner[3]) {
    const wcut_vec3 ab = vec3_sub(corner[1], corner[0]), ac = vec3_sub(corner[2], corner[0]);
    const wcut_vec3 bc = vec3_sub(corner[2], corner[1]), area = vec3_cross(ab, ac);
    const double longest = sqrt(fmax(vec3_dot(ab, ab), fmax(vec3_dot(ac, ac), vec3_dot(bc, bc))));
    const double size = vec3_length(area);
    return size > longest * fmax(THIN * longest, LOW * t->size) ? vec3_scale(1 / size, area) : vec3(0, 0, 0);
}

/* a plane of a triangle's prism: the height over the face, the distance beyond an edge's side */
static void mesh_distance_boxes_put_plane(wcut_mesh_leaf *leaf, int plane, int lane, wcut_vec3 normal, wcut_vec3 at) {
    leaf->plane[plane][0][lane] = (float)normal.x, leaf->plane[plane][1][lane] = (float)normal.y;
    leaf->plane[plane][2][lane] = (float)normal.z, leaf->plane[plane][3][lane] = (float)-vec3_dot(normal, at);
}

/* without a normal all are zero, and the triangle is never left out */
static void put_prism(const wcut_mesh_tree *t, int i, wcut_mesh_leaf *leaf, int lane) {
    const int *v = t->vertex + 3 * (size_t)i;
    const wcut_vec3 corner[3] = {vec3_sub(t->point[v[0]], t->centre), vec3_sub(t->point[v[1]], t->centre),
                                 vec3_sub(t->point[v[2]], t->centre)};
    const wcut_vec3 n = normal_of(t, corner);
    mesh_distance_boxes_put_plane(leaf, 0, lane, n, corner[0]);
    for (int k = 0; k < 3; k++) {
        const wcut_vec3 along = vec3_sub(corner[(k + 1) % 3], corner[k]);
        mesh_distance_boxes_put_plane(leaf, k + 1, lane, vec3_unit(vec3_cross(along, n)), corner[k]);
    }
}

static void put_leaf(builder *b, int first, int end, float low[3], float high[3]) {
    wcut_mesh_tree *t = b->tree;
    wcut_mesh_leaf *leaf = &t->leaf[b->leaves++];
    leaf->first = first, leaf->count = end - first;
    for (int i = first; i < end; i++) {
        t->index[i] = wcut_morton_index(b->item[i]);
        const int *v = b->mesh->triangle + 3 * (size_t)t->index[i];
        memcpy(t->vertex + 3 * (size_t)i, v, 3 * sizeof *v);
        for (int k = 0; k < 3; k++) mesh_distance_boxes_widen(t, t->point[v[k]], low, high);
        put_prism(t, i, leaf, i - first);
    }
    for (int lane = end - first; lane < WCUT_MESH_LEAF; lane++) leaf->plane[0][3][lane] = INFINITY;
}

/* the node of a range and all below it; gives its number and its box. Each level takes a bit of the code at least, or
   the logarithm to base 8 of those in one cell. */
static int put_box_node(builder *b, int first, int end, float low[3], float high[3]) {
    /* the range divided into as many parts as a node has lanes */
    int bound[WCUT_MESH_WIDE + 1];
    const int parts = mesh_distance_boxes_divide(b->item, first, end, bound), number = b->nodes++;

    /* each lane: a node of its own, a leaf, or empty */
    for (int k = 0; k < WCUT_MESH_WIDE; k++) {
        wcut_mesh_node *node = &b->tree->node[number];
        float l[3] = {INFINITY, INFINITY, INFINITY}, h[3] = {-INFINITY, -INFINITY, -INFINITY};
        const int count = k < parts ? bound[k + 1] - bound[k] : 0;
        if (count > WCUT_MESH_LEAF) {
            node->child[k] = put_box_node(b, bound[k], bound[k + 1], l, h);
        } else if (count > 0) {
            node->child[k] = ~b->leaves;
            put_leaf(b, bound[k], bound[k + 1], l, h);
        }

        /* the box of the lane, and of the whole node */
        for (int c = 0; c < 3; c++) {
            node->low[c][k] = l[c], node->high[c][k] = h[c];
            low[c] = l[c] < low[c] ? l[c] : low[c];
            high[c] = h[c] > high[c] ? h[c] : high[c];
        }
    }

    return number;
}

static void mesh_distance_boxes_find_box(const wcut_mesh *mesh, wcut_mesh_tree *t) {
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

/* leaves and nodes that a range will have */
static void count_nodes(const uint64_t *item, int first, int end, size_t *nodes, size_t *leaves) {
    int bound[WCUT_MESH_WIDE + 1];
    const int parts = mesh_distance_boxes_divide(item, first, end, bound);
    ++*nodes;
    for (int k = 0; k < parts; k++)
        if (bound[k + 1] - bound[k] > WCUT_MESH_LEAF)
            count_nodes(item, bound[k], bound[k + 1], nodes, leaves);
        else
            ++*leaves;
}

static wcut_status sort_triangles(const wcut_mesh *mesh, const wcut_mesh_tree *t, uint64_t **item) {
    const size_t n = (size_t)mesh->triangle_count;
    wcut_vec3 *middle = wcut_alloc(n, sizeof *middle);
    for (size_t i = 0; middle && i < n; i++) {
        const int *v = mesh->triangle + 3 * i;
        const wcut_vec3 sum = vec3_add(vec3_add(mesh->vertex[v[0]], mesh->vertex[v[1]]), mesh->vertex[v[2]]);
        middle[i] = vec3_sub(vec3_scale(1.0 / 3, sum), t->centre);
    }
    const wcut_status status = middle ? wcut_morton_sort(mesh->triangle_count, middle, 1, 3, item) : WCUT_NO_MEMORY;
    wcut_free(middle);
    return status;
}

wcut_status wcut_mesh_boxes_build(const wcut_mesh *mesh, wcut_mesh_tree *tree) {
    /* sort the triangles along the Z-curve, and count what the tree needs */
    const size_t n = (size_t)mesh->triangle_count;
    size_t nodes = 0, leaves = 0;
    uint64_t *item = NULL;
    mesh_distance_boxes_find_box(mesh, tree);
    tree->triangles = mesh->triangle_count;
    if (sort_triangles(mesh, tree, &item) != WCUT_OK) return WCUT_NO_MEMORY;
    count_nodes(item, 0, (int)n, &nodes, &leaves);

    /* the tree owns all that it needs later, so that the mesh may go */
    tree->point = wcut_copy(mesh->vertex, (size_t)mesh->vertex_count, sizeof *tree->point);
    tree->index = wcut_alloc(n, sizeof *tree->index);
    tree->vertex = wcut_alloc(n, 3 * sizeof *tree->vertex);
    tree->node = wcut_alloc(nodes, sizeof *tree->node);
    tree->leaf = wcut_alloc(leaves, sizeof *tree->leaf);
    const bool there = tree->point && tree->index && tree->vertex && tree->node && tree->leaf;

    /* put the nodes, from the root down */
    if (there) {
        builder b = {.mesh = mesh, .tree = tree, .item = item};
        float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
        put_box_node(&b, 0, (int)n, low, high);
    }

    wcut_free(item);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}
