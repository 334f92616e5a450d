/* The closest point of a mesh: branch and bound over boxes, a group of neighbours from nodes far below the root, in
   single precision until a triangle may be closer, then in double; the side from the normal at the foot. */
#include "scan/mesh_distance.h"

#include <assert.h>
#include <float.h>
#include <limits.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "base/wide.h"
#include "scan/mesh_distance_boxes.h"
#include "scan/mesh_distance_edges.h"

enum { GROUP = 32, FRONT = 4, STACK = 176 };

static const double BEYOND = 1e-9; /* of the size: a query this far outwards of the border is beyond it */

/* ---- making ---- */

void wcut_mesh_tree_destroy(wcut_mesh_tree *tree) {
    if (!tree) return;
    wcut_free(tree->point);
    wcut_free(tree->index);
    wcut_free(tree->vertex);
    wcut_free(tree->neighbour);
    wcut_free(tree->normal);
    wcut_free(tree->on_border);
    wcut_free(tree->node);
    wcut_free(tree->leaf);
    wcut_free(tree);
}

static bool mesh_distance_is_usable(const wcut_mesh *mesh) {
    if (!mesh || mesh->triangle_count < 1 || mesh->triangle_count > INT_MAX / 3 || mesh->vertex_count < 1 ||
        !mesh->vertex || !mesh->triangle)
        return false;
    if (!wcut_are_near(mesh->vertex_count, mesh->vertex)) return false;
    for (size_t k = 0; k < 3 * (size_t)mesh->triangle_count; k++)
        if (mesh->triangle[k] < 0 || mesh->triangle[k] >= mesh->vertex_count) return false;
    return true;
}

wcut_status wcut_mesh_tree_create(const wcut_mesh *mesh, wcut_mesh_tree **tree) {
    if (!tree || !mesh_distance_is_usable(mesh)) return WCUT_BAD_ARGUMENT;
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

static inline double mesh_distance_square_at(const wcut_mesh_corners *t, wcut_vec3 p, double b, double c) {
    const wcut_vec3 at = vec3_add_scaled(vec3_scale(1 - b - c, t->a), b, t->b);
    const wcut_vec3 r = vec3_sub(p, vec3_add_scaled(at, c, t->c));
    return vec3_dot(r, r);
}

static inline spot spot_at(const wcut_mesh_corners *t, wcut_vec3 p, double b, double c, feature on, int k) {
    return (spot){b, c, mesh_distance_square_at(t, p, b, c), on, k};
}

/* The closest point by the regions that corners and edges own (Ericson 2005, 5.1.5). An edge without length or a face
   without area owns none: its ends and edges do. */
static inline spot closest(const wcut_mesh_corners *t, wcut_vec3 p) {
    /* before corner a */
    const wcut_vec3 ab = vec3_sub(t->b, t->a), ac = vec3_sub(t->c, t->a), ap = vec3_sub(p, t->a);
    const double d1 = vec3_dot(ab, ap), d2 = vec3_dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return spot_at(t, p, 0, 0, CORNER, 0);

    /* before corner b, then the edge a b */
    const wcut_vec3 bp = vec3_sub(p, t->b);
    const double d3 = vec3_dot(ab, bp), d4 = vec3_dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return spot_at(t, p, 1, 0, CORNER, 1);
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 > 0 && d3 < 0) return spot_at(t, p, d1 / (d1 - d3), 0, EDGE, 0);

    /* before corner c, then the edge c a */
    const wcut_vec3 cp = vec3_sub(p, t->c);
    const double d5 = vec3_dot(ab, cp), d6 = vec3_dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return spot_at(t, p, 0, 1, CORNER, 2);
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 > 0 && d6 < 0) return spot_at(t, p, 0, d2 / (d2 - d6), EDGE, 2);

    /* the edge b c, by the barycentric coordinate of a */
    const double va = d3 * d6 - d5 * d4, to_c = d4 - d3, to_b = d5 - d6;
    if (va <= 0 && to_c > 0 && to_b > 0) {
        const double w = to_c / (to_c + to_b);
        return spot_at(t, p, 1 - w, w, EDGE, 1);
    }

    /* inside the triangle, by barycentric coordinates */
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

/* what distances in single precision are squared against */
static inline float mesh_distance_limit_of(const search *s, double distance) {
    const double reach = distance + s->slack, square = reach * reach * (1 + 1e-6);
    return square < FLT_MAX ? (float)square : FLT_MAX;
}

/* Squares of the distances from a node's boxes: outside an interval |p - low| + |p - high| is longer than the interval,
   by twice the distance. Without branches, so that compilers take all eight at once; nan for an empty box. */
WCUT_INLINE void box_squares(const wcut_mesh_node *restrict n, const float *restrict p, float *restrict square) {
    const float px = p[0], py = p[1], pz = p[2];
    for (int k = 0; k < WCUT_MESH_WIDE; k++) {
        const float x = fabsf(px - n->low[0][k]) + fabsf(px - n->high[0][k]) - (n->high[0][k] - n->low[0][k]);
        const float y = fabsf(py - n->low[1][k]) + fabsf(py - n->high[1][k]) - (n->high[1][k] - n->low[1][k]);
        const float z = fabsf(pz - n->low[2][k]) + fabsf(pz - n->high[2][k]) - (n->high[2][k] - n->low[2][k]);
        square[k] = 0.25F * (x * x + y * y + z * z);
    }
}

WCUT_INLINE float beyond_plane(const wcut_mesh_leaf *l, int i, int k, float x, float y, float z) {
    return l->plane[i][0][k] * x + l->plane[i][1][k] * y + l->plane[i][2][k] * z + l->plane[i][3][k];
}

/* Squares that those of the distances from a leaf's triangles are no less than; infinite for none. */
WCUT_INLINE void prism_squares(const wcut_mesh_leaf *restrict l, const float *restrict p, float *restrict square) {
    const float x = p[0], y = p[1], z = p[2];
    for (int k = 0; k < WCUT_MESH_LEAF; k++) {
        const float height = beyond_plane(l, 0, k, x, y, z), a = beyond_plane(l, 1, k, x, y, z);
        const float b = beyond_plane(l, 2, k, x, y, z), c = beyond_plane(l, 3, k, x, y, z);
        const float ab = a > b ? a : b, abc = ab > c ? ab : c, out = abc > 0 ? abc : 0;
        square[k] = height * height + out * out;
    }
}

/* which of eight squares are within the limit, in order, and how many; no branch: no processor could guess it */
WCUT_INLINE int pick(const float *square, float limit, int *near) {
    int count = 0;
    for (int k = 0; k < WCUT_MESH_WIDE; k++) {
        near[count] = k;
        count += square[k] <= limit;
    }
    return count;
}

/* the leaf's triangles that may be closer than what is known, the likeliest first, in full precision */
static void search_leaf(search *s, const wcut_mesh_leaf *l, const float *square, float *limit) {
    int near[WCUT_MESH_LEAF + 1];
    const int count = pick(square, *limit, near);
    for (int m = 1; m < count; m++)
        if (square[near[m]] < square[near[0]]) {
            const int keep = near[0];
            near[0] = near[m], near[m] = keep;
        }
    for (int m = 0; m < count; m++) {
        const int k = near[m];
        if (square[k] > *limit) continue;
        const wcut_mesh_corners corners = wcut_mesh_corners_of(s->t, l->first + k);
        const spot found = closest(&corners, s->p);
        if (found.square >= s->best.square) continue;
        s->best = found, s->triangle = l->first + k;
        *limit = mesh_distance_limit_of(s, sqrt(found.square));
    }
}

typedef struct entry {
    float square;
    int child;
} entry;

/* a node's boxes within the limit, onto a stack whose entries from `base` on are in order, the nearest last; its depth */
WCUT_INLINE int mesh_distance_push(const wcut_mesh_node *n, const float *at, float limit, int base, int depth,
                                   entry *stack) {
    float square[WCUT_MESH_WIDE];
    int near[WCUT_MESH_WIDE + 1];
    box_squares(n, at, square);
    const int count = pick(square, limit, near);
    for (int m = 0; m < count; m++) {
        const int k = near[m];
        int i = depth++;
        for (; i > base && stack[i - 1].square < square[k]; i--) stack[i] = stack[i - 1];
        stack[i].square = square[k], stack[i].child = n->child[k];
    }
    return depth;
}

/* Depth-first, the nearest box first, from nodes that hold all that matters. The foot is no further than `distance`. */
WCUT_WIDE static void mesh_distance_search_tree(search *s, double distance, int count, const wcut_mesh_node *from) {
    entry stack[STACK];
    int depth = 0;
    float limit = mesh_distance_limit_of(s, distance), square[WCUT_MESH_LEAF];
    s->best.square = INFINITY;
    for (int k = 0; k < count; k++) depth = mesh_distance_push(&from[k], s->at, limit, 0, depth, stack);
    while (depth > 0) {
        const entry next = stack[--depth];
        if (next.square > limit) continue;
        if (next.child >= 0) {
            depth = mesh_distance_push(&s->t->node[next.child], s->at, limit, depth, depth, stack);
            continue;
        }
        const wcut_mesh_leaf *l = &s->t->leaf[~next.child];
        prism_squares(l, s->at, square);
        search_leaf(s, l, square, &limit);
    }
}

/* ---- a group of queries ---- */

/* Nodes that hold every box near a group of queries, made of lanes of the tree's: with them a search begins far below
   the root. */
typedef struct front {
    wcut_mesh_node node[FRONT];
    int count;
} front;

typedef struct lane {
    const wcut_mesh_node *node;
    int k;
} lane;

/* the lanes of a node whose boxes are within the square root of `limit` from a box; how many there are */
WCUT_INLINE int near_lanes(const wcut_mesh_node *n, const float *low, const float *high, float limit, lane *to) {
    float square[WCUT_MESH_WIDE];
    for (int k = 0; k < WCUT_MESH_WIDE; k++) {
        float sum = 0;
        for (int c = 0; c < 3; c++) {
            const float under = n->low[c][k] - high[c], over = low[c] - n->high[c][k];
            const float gap = under > over ? under : over, off = gap > 0 ? gap : 0;
            sum += off * off;
        }
        square[k] = sum;
    }
    int count = 0;
    for (int k = 0; k < WCUT_MESH_WIDE; k++)
        if (square[k] <= limit) to[count++] = (lane){n, k};
    return count;
}

/* level by level, as long as the lanes fit */
WCUT_WIDE static void find_front(const wcut_mesh_tree *t, const float *low, const float *high, float limit, front *f) {
    /* the near lanes of the root */
    enum { ROOM = FRONT * WCUT_MESH_WIDE };
    lane list[ROOM], next[ROOM + WCUT_MESH_WIDE] = {{NULL, 0}};
    int count = near_lanes(&t->node[0], low, high, limit, list);

    /* replace each inner lane by its children's near lanes until they do not fit */
    for (bool deeper = true; deeper;) {
        int more = 0;
        deeper = false;
        for (int i = 0; i < count && more <= ROOM; i++) {
            const int child = list[i].node->child[list[i].k];
            if (child < 0) {
                next[more++] = list[i];
            } else {
                more += near_lanes(&t->node[child], low, high, limit, &next[more]);
                deeper = true;
            }
        }
        if (more > ROOM) break;
        count = more;
        memcpy(list, next, (size_t)count * sizeof *list);
    }

    /* pack the lanes into nodes; what is left over of the last one is empty */
    f->count = (count + WCUT_MESH_WIDE - 1) / WCUT_MESH_WIDE;
    for (int i = 0; i < f->count * WCUT_MESH_WIDE; i++) {
        wcut_mesh_node *to = &f->node[i / WCUT_MESH_WIDE];
        const int k = i % WCUT_MESH_WIDE;
        for (int c = 0; c < 3; c++) {
            to->low[c][k] = i < count ? list[i].node->low[c][list[i].k] : INFINITY;
            to->high[c][k] = i < count ? list[i].node->high[c][list[i].k] : -INFINITY;
        }
        to->child[k] = i < count ? list[i].node->child[list[i].k] : 0;
    }
}

/* the normal at the foot, and whether the foot is on the border */
static wcut_vec3 mesh_distance_normal_at(const wcut_mesh_tree *t, int i, const spot *at, bool *border) {
    const wcut_mesh_corners own_corners = wcut_mesh_corners_of(t, i), *p = &own_corners;
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
    const wcut_mesh_corners other = wcut_mesh_corners_of(t, t->neighbour[k]), *q = &other;
    return vec3_unit(vec3_add(own, vec3_unit(vec3_cross(vec3_sub(q->b, q->a), vec3_sub(q->c, q->a)))));
}

static void fill_foot(const search *s, wcut_mesh_foot *foot) {
    const wcut_mesh_corners corners = wcut_mesh_corners_of(s->t, s->triangle), *c = &corners;
    const spot *at = &s->best;
    bool border;
    const wcut_vec3 n = mesh_distance_normal_at(s->t, s->triangle, at, &border);
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

static void place_query(search *s, wcut_vec3 p) {
    const wcut_vec3 at = vec3_sub(p, s->t->centre);
    s->p = p;
    s->at[0] = (float)at.x, s->at[1] = (float)at.y, s->at[2] = (float)at.z;
    s->slack = 1e-6 * (vec3_length(at) + s->t->size);
}

/* What the first query of a group has found is no further from another one than it was from the first, and that from
   the other: nothing further from the group's box than this matters to any of them. */
static void prepare_group(const search *s, int count, const wcut_vec3 *query, front *f) {
    search other = *s;
    float low[3], high[3];
    memcpy(low, s->at, sizeof low);
    memcpy(high, s->at, sizeof high);
    double away = 0, slack = s->slack;
    for (int k = 1; k < count; k++) {
        place_query(&other, query[k]);
        for (int c = 0; c < 3; c++) {
            low[c] = other.at[c] < low[c] ? other.at[c] : low[c];
            high[c] = other.at[c] > high[c] ? other.at[c] : high[c];
        }
        away = fmax(away, vec3_distance(s->p, query[k]));
        slack = fmax(slack, other.slack);
    }
    const double reach = sqrt(s->best.square) + away + 2 * slack, square = reach * reach * (1 + 1e-6);
    find_front(s->t, low, high, square < FLT_MAX ? (float)square : FLT_MAX, f);
}

/* a block of queries; none is further from the mesh than the one before and the way from there */
void wcut_mesh_tree_locate_batch(const void *on, int count, const wcut_vec3 *query, const wcut_query_prefetch *ahead,
                                 void *feet) {
    _Static_assert(sizeof(wcut_mesh_foot) <= WCUT_QUERY_FOOT_SIZE, "fits");
    const wcut_mesh_tree *tree = on;
    wcut_mesh_foot *foot = feet;
    search s = {.t = tree};
    front f = {.count = 0};
    for (int k = 0; k < count; k++) {
        const bool leads = k % GROUP == 0;
        const double distance = k > 0 ? foot[k - 1].distance + vec3_distance(query[k - 1], query[k]) : INFINITY;
        place_query(&s, query[k]);
        wcut_query_prefetch_next(ahead, k);
        mesh_distance_search_tree(&s, distance, leads ? 1 : f.count, leads ? tree->node : f.node);
        assert(s.best.square < INFINITY);
        fill_foot(&s, &foot[k]);
        if (leads) prepare_group(&s, k + GROUP < count ? GROUP : count - k, &query[k], &f);
    }
}

static void mesh_distance_put_feet(void *to, int count, const int *index, const void *foot) {
    const wcut_mesh_foot *from = foot;
    wcut_mesh_foot *all = to;
    for (int k = 0; k < count; k++) all[index[k]] = from[k];
}

wcut_status wcut_mesh_tree_locate(const wcut_mesh_tree *tree, int count, const wcut_vec3 *query, int threads,
                                  wcut_mesh_foot *foot) {
    if (!tree || count < 0 || threads < 1 || (count > 0 && (!query || !foot || !wcut_are_near(count, query))))
        return WCUT_BAD_ARGUMENT;
    const wcut_query_batch batch = {.locate = wcut_mesh_tree_locate_batch,
                                    .on = tree,
                                    .take = mesh_distance_put_feet,
                                    .to = foot,
                                    .result = foot,
                                    .size = sizeof *foot};
    return wcut_query_batch_run(&batch, count, query, threads);
}
