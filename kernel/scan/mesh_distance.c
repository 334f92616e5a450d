/* The closest point of a mesh: branch and bound over boxes, each query starting from its neighbour's triangle; the side
   from the normal at the foot. Order of queries matters more than the tree. */
#include <float.h>
#include <limits.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/mesh_distance.h"
#include "surface/morton.h"

enum { BLOCK = 256, STACK = 160, AHEAD = 8 };

static const double BEYOND = 1e-9; /* of the size: a query this far outwards of the border is beyond it */

/* ---- making ---- */

void wcut_mesh_tree_destroy(wcut_mesh_tree *tree) {
    if (!tree) return;
    wcut_free(tree->corner);
    wcut_free(tree->index);
    wcut_free(tree->vertex);
    wcut_free(tree->neighbour);
    wcut_free(tree->normal);
    wcut_free(tree->on_border);
    wcut_free(tree->node);
    wcut_free(tree);
}

static bool is_usable(const wcut_mesh *mesh) {
    if (!mesh || mesh->triangle_count < 1 || mesh->triangle_count > INT_MAX / 3 || mesh->vertex_count < 1 ||
        !mesh->vertex || !mesh->triangle)
        return false;
    if (!wcut_are_near(mesh->vertex_count, mesh->vertex)) return false;
    for (size_t k = 0; k < 3 * (size_t)mesh->triangle_count; k++)
        if (mesh->triangle[k] < 0 || mesh->triangle[k] >= mesh->vertex_count) return false;
    return true;
}

wcut_status wcut_mesh_tree_create(const wcut_mesh *mesh, wcut_mesh_tree **tree) {
    if (!tree || !is_usable(mesh)) return WCUT_BAD_ARGUMENT;
    wcut_mesh_tree *t = wcut_alloc(1, sizeof *t);
    if (!t) return WCUT_NO_MEMORY;
    wcut_status status = wcut_mesh_boxes_build(mesh, t);
    if (status == WCUT_OK) status = wcut_mesh_edges_build(mesh, t);
    if (status == WCUT_OK && t->info.area == 0) status = WCUT_DEGENERATE;
    if (status == WCUT_OK)
        *tree = t;
    else
        wcut_mesh_tree_destroy(t);
    return status;
}

const wcut_mesh_tree_info *wcut_mesh_tree_view(const wcut_mesh_tree *tree) { return tree ? &tree->info : NULL; }

/* ---- one triangle ---- */

/* where on a triangle a point is closest: on its face, on edge k from corner k to the next, at corner k */
typedef enum feature { FACE, EDGE, CORNER } feature;

typedef struct spot {
    double b, c, square; /* weights of the second and third corner; of the distance */
    feature on;
    int k;
} spot;

static inline double square_at(const wcut_mesh_corners *t, wcut_vec3 p, double b, double c) {
    const wcut_vec3 at = vec3_add_scaled(vec3_scale(1 - b - c, t->a), b, t->b);
    const wcut_vec3 r = vec3_sub(p, vec3_add_scaled(at, c, t->c));
    return vec3_dot(r, r);
}

static inline spot spot_at(const wcut_mesh_corners *t, wcut_vec3 p, double b, double c, feature on, int k) {
    return (spot){b, c, square_at(t, p, b, c), on, k};
}

/* The closest point by the regions that corners and edges own (Ericson 2005, 5.1.5). An edge without length or a face
   without area owns none: its ends and edges do. */
static inline spot closest(const wcut_mesh_corners *t, wcut_vec3 p) {
    const wcut_vec3 ab = vec3_sub(t->b, t->a), ac = vec3_sub(t->c, t->a), ap = vec3_sub(p, t->a);
    const double d1 = vec3_dot(ab, ap), d2 = vec3_dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return spot_at(t, p, 0, 0, CORNER, 0);
    const wcut_vec3 bp = vec3_sub(p, t->b);
    const double d3 = vec3_dot(ab, bp), d4 = vec3_dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return spot_at(t, p, 1, 0, CORNER, 1);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 > 0 && d3 < 0) return spot_at(t, p, d1 / (d1 - d3), 0, EDGE, 0);
    const wcut_vec3 cp = vec3_sub(p, t->c);
    const double d5 = vec3_dot(ab, cp), d6 = vec3_dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return spot_at(t, p, 0, 1, CORNER, 2);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 > 0 && d6 < 0) return spot_at(t, p, 0, d2 / (d2 - d6), EDGE, 2);
    const double va = d3 * d6 - d5 * d4, to_c = d4 - d3, to_b = d5 - d6;
    if (va <= 0 && to_c > 0 && to_b > 0) {
        const double w = to_c / (to_c + to_b);
        return spot_at(t, p, 1 - w, w, EDGE, 1);
    }
    const double sum = va + vb + vc;
    if (!(sum > 0)) return spot_at(t, p, 0, 0, CORNER, 0);
    return spot_at(t, p, vb / sum, vc / sum, FACE, 0);
}

/* ---- one query ---- */

typedef struct search {
    const wcut_mesh_tree *t;
    wcut_vec3 p;
    float at[3];  /* p about the centre */
    double slack; /* [mm] by how much the boxes' distances may be too long: rounding */
    spot best;
    int triangle;
} search;

/* true where one of these triangles is closer than what is known */
static bool offer(search *s, int first, int count) {
    bool closer = false;
    for (int i = first; i < first + count; i++) {
        const spot found = closest(&s->t->corner[i], s->p);
        if (found.square < s->best.square) s->best = found, s->triangle = i, closer = true;
    }
    return closer;
}

/* what a box's distance is squared against */
static inline float limit_of(const search *s) {
    const double reach = sqrt(s->best.square) + s->slack, square = reach * reach * (1 + 1e-6);
    return square < FLT_MAX ? (float)square : FLT_MAX;
}

/* Squares of the distances from a node's boxes: outside an interval |p - low| + |p - high| is longer than the interval,
   by twice the distance. Without branches, so that compilers take all eight at once; nan for an empty box. */
static inline void box_squares(const wcut_mesh_node *restrict n, const float *restrict p, float *restrict square) {
    const float px = p[0], py = p[1], pz = p[2];
    for (int k = 0; k < WCUT_MESH_WIDE; k++) {
        const float x = fabsf(px - n->low[0][k]) + fabsf(px - n->high[0][k]) - (n->high[0][k] - n->low[0][k]);
        const float y = fabsf(py - n->low[1][k]) + fabsf(py - n->high[1][k]) - (n->high[1][k] - n->low[1][k]);
        const float z = fabsf(pz - n->low[2][k]) + fabsf(pz - n->high[2][k]) - (n->high[2][k] - n->low[2][k]);
        square[k] = 0.25F * (x * x + y * y + z * z);
    }
}

/* Depth-first, the nearest box first. */
static void search_tree(search *s) {
    struct {
        float square;
        int first, count;
    } stack[STACK];
    int depth = 1;
    stack[0].square = 0, stack[0].first = 0, stack[0].count = 0;
    float limit = limit_of(s);
    while (depth > 0) {
        depth--;
        if (stack[depth].square > limit) continue;
        if (stack[depth].count > 0) {
            if (offer(s, stack[depth].first, stack[depth].count)) limit = limit_of(s);
            continue;
        }
        const wcut_mesh_node *n = &s->t->node[stack[depth].first];
        float square[WCUT_MESH_WIDE];
        box_squares(n, s->at, square);
        const int base = depth;
        for (int k = 0; k < WCUT_MESH_WIDE; k++) {
            if (!(square[k] <= limit)) continue;
            int i = depth++;
            for (; i > base && stack[i - 1].square < square[k]; i--) stack[i] = stack[i - 1];
            stack[i].square = square[k], stack[i].first = n->first[k], stack[i].count = n->count[k];
        }
    }
}

/* the normal at the foot, and whether the foot is on the border */
static wcut_vec3 normal_at(const wcut_mesh_tree *t, int i, const spot *at, bool *border) {
    const wcut_mesh_corners *p = &t->corner[i];
    const wcut_vec3 own = vec3_unit(vec3_cross(vec3_sub(p->b, p->a), vec3_sub(p->c, p->a)));
    const size_t k = 3 * (size_t)i + (size_t)at->k;
    *border = false;
    if (at->on == CORNER) {
        *border = t->on_border[t->vertex[k]];
        return t->normal[t->vertex[k]];
    }
    if (at->on == FACE) return own;
    *border = t->neighbour[k] == -1;
    if (t->neighbour[k] < 0) return own;
    const wcut_mesh_corners *q = &t->corner[t->neighbour[k]];
    return vec3_unit(vec3_add(own, vec3_unit(vec3_cross(vec3_sub(q->b, q->a), vec3_sub(q->c, q->a)))));
}

static void fill_foot(const search *s, wcut_mesh_foot *foot) {
    const wcut_mesh_corners *c = &s->t->corner[s->triangle];
    const spot *at = &s->best;
    bool border;
    const wcut_vec3 n = normal_at(s->t, s->triangle, at, &border);
    wcut_vec3 point = vec3_add_scaled(vec3_scale(1 - at->b - at->c, c->a), at->b, c->b);
    point = vec3_add_scaled(point, at->c, c->c);
    const wcut_vec3 r = vec3_sub(s->p, point);
    const double height = vec3_dot(r, n), along = vec3_length(vec3_add_scaled(r, -height, n));
    *foot = (wcut_mesh_foot){.point = point,
                             .distance = sqrt(at->square),
                             .height = height,
                             .b = at->b,
                             .c = at->c,
                             .triangle = s->t->index[s->triangle],
                             .border = border,
                             .beyond = border && along > BEYOND * (s->t->size + vec3_length(s->p))};
}

wcut_status wcut_mesh_tree_locate(const wcut_mesh_tree *tree, int count, const wcut_vec3 *query, int threads,
                                  wcut_mesh_foot *foot) {
    if (!tree || count < 0 || threads < 1 || (count > 0 && (!query || !foot || !wcut_are_near(count, query))))
        return WCUT_BAD_ARGUMENT;
    int *order;
    const wcut_status status = wcut_morton_order(count, query, threads, &order);
    if (status != WCUT_OK) return status;
    const int blocks = count / BLOCK + (count % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int block = 0; block < blocks; block++) {
        const int end = block == blocks - 1 ? count : (block + 1) * BLOCK;
        search s = {.t = tree, .triangle = 0};
        for (int k = block * BLOCK; k < end; k++) {
            if (k + AHEAD < end) {
                __builtin_prefetch(&query[order[k + AHEAD]]);
                __builtin_prefetch(&foot[order[k + AHEAD]], 1);
            }
            s.p = query[order[k]];
            const wcut_vec3 at = vec3_sub(s.p, tree->centre);
            s.at[0] = (float)at.x, s.at[1] = (float)at.y, s.at[2] = (float)at.z;
            s.slack = 1e-6 * (vec3_length(at) + tree->size);
            s.best = closest(&tree->corner[s.triangle], s.p);
            search_tree(&s);
            fill_foot(&s, &foot[order[k]]);
        }
    }
    wcut_free(order);
    return WCUT_OK;
}
