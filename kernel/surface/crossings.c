/* Triangles of a mesh that cross: a box tree over them against itself, edges against triangles (Moeller, Trumbore 1997),
   and what that tells of a surface. */
#include "surface/crossings.h"

#include <limits.h>
#include <stddef.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/curvature.h"
#include "surface/morton.h"

/* Of the mesh's size: corners nearer than this are one, edges whose ends are nearer to a plane do not pass it. */
static const double SAME = 1e-9;

typedef struct node {
    wcut_vec3 low, high;
} node;

/* A complete binary tree in an array: the children of k are 2 k + 1 and 2 k + 2, the last `leaves` nodes are triangles in
   an order that keeps neighbours together, or empty. */
typedef struct finder {
    const wcut_mesh *mesh;
    int leaves;
    node *tree;
    int *order;
    double same;
    int room, count;
    wcut_crossing *found; /* room, rising */
} finder;

static wcut_vec3 corner(const wcut_mesh *m, int triangle, int k) { return m->vertex[m->triangle[3 * triangle + k]]; }

static bool overlap(const node *a, const node *b) {
    return a->low.x <= b->high.x && b->low.x <= a->high.x && a->low.y <= b->high.y && b->low.y <= a->high.y &&
           a->low.z <= b->high.z && b->low.z <= a->high.z;
}

static void crossings_widen(node *n, wcut_vec3 low, wcut_vec3 high) {
    n->low = vec3(fmin(n->low.x, low.x), fmin(n->low.y, low.y), fmin(n->low.z, low.z));
    n->high = vec3(fmax(n->high.x, high.x), fmax(n->high.y, high.y), fmax(n->high.z, high.z));
}

/* narrower than what counts as one place: it crosses nothing that its neighbours do not, and thousands of such in one
   place would be tested against each other */
static bool is_sliver(const finder *f, int t) {
    const wcut_vec3 a = corner(f->mesh, t, 0), ab = vec3_sub(corner(f->mesh, t, 1), a),
                    ac = vec3_sub(corner(f->mesh, t, 2), a), bc = vec3_sub(ac, ab);
    const double longest = fmax(vec3_length(ab), fmax(vec3_length(ac), vec3_length(bc)));
    return !(vec3_length(vec3_cross(ab, ac)) > f->same * longest);
}

static wcut_status build(finder *f) {
    const wcut_mesh *m = f->mesh;

    /* a complete binary tree, its leaves in the order of the Z-curve */
    f->leaves = 1;
    while (f->leaves < m->triangle_count) f->leaves *= 2;
    wcut_vec3 *middle = wcut_alloc((size_t)m->triangle_count, sizeof *middle);
    f->tree = wcut_alloc((size_t)f->leaves, 2 * sizeof *f->tree);
    wcut_status status = middle && f->tree ? WCUT_OK : WCUT_NO_MEMORY;
    for (int t = 0; t < m->triangle_count && status == WCUT_OK; t++)
        middle[t] = vec3_scale(1.0 / 3, vec3_add(vec3_add(corner(m, t, 0), corner(m, t, 1)), corner(m, t, 2)));
    if (status == WCUT_OK) status = wcut_morton_order(m->triangle_count, middle, 1, &f->order);
    wcut_free(middle);
    if (status != WCUT_OK) return status;

    /* boxes of the leaves; slivers are left out, because their crossings are rounding */
    const node empty = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};
    for (int k = 0; k < f->leaves; k++) {
        node *leaf = &f->tree[f->leaves - 1 + k];
        *leaf = empty;
        if (k >= m->triangle_count || is_sliver(f, f->order[k])) continue;
        for (int c = 0; c < 3; c++) crossings_widen(leaf, corner(m, f->order[k], c), corner(m, f->order[k], c));
    }

    /* boxes of the inner nodes, from the leaves up */
    for (int k = f->leaves - 2; k >= 0; k--) {
        f->tree[k] = f->tree[2 * k + 1];
        crossings_widen(&f->tree[k], f->tree[2 * k + 2].low, f->tree[2 * k + 2].high);
    }

    return WCUT_OK;
}

static bool share_corner(const finder *f, int a, int b) {
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (vec3_distance(corner(f->mesh, a, i), corner(f->mesh, b, j)) <= f->same) return true;
    return false;
}

/* does an edge of triangle a pass through triangle b, and where? */
static bool pierces(const finder *f, int a, int b, wcut_vec3 *where) {
    const wcut_vec3 o = corner(f->mesh, b, 0), e1 = vec3_sub(corner(f->mesh, b, 1), o),
                    e2 = vec3_sub(corner(f->mesh, b, 2), o), n = vec3_cross(e1, e2);
    const double square = vec3_dot(n, n), near = f->same * sqrt(square);
    if (!(square > 0)) return false;
    double height[3];
    for (int k = 0; k < 3; k++) height[k] = vec3_dot(n, vec3_sub(corner(f->mesh, a, k), o));
    for (int k = 0; k < 3; k++) {
        const double from = height[k], to = height[(k + 1) % 3];
        if (!((from > near && to < -near) || (from < -near && to > near))) continue;
        const wcut_vec3 at = vec3_mix(corner(f->mesh, a, k), corner(f->mesh, a, (k + 1) % 3), from / (from - to));
        const wcut_vec3 off = vec3_sub(at, o);
        const double s = vec3_dot(vec3_cross(off, e2), n), t = vec3_dot(vec3_cross(e1, off), n);
        if (s < 0 || t < 0 || s + t > square) continue;
        *where = at;
        return true;
    }
    return false;
}

/* keep the first pairs in rising order */
static void crossings_keep(finder *f, wcut_crossing c) {
    int at = f->count < f->room ? f->count : f->room;
    if (f->count < INT_MAX) f->count++;
    while (at > 0 && (f->found[at - 1].first > c.first ||
                      (f->found[at - 1].first == c.first && f->found[at - 1].second > c.second))) {
        if (at < f->room) f->found[at] = f->found[at - 1];
        at--;
    }
    if (at < f->room) f->found[at] = c;
}

static void test_pair(finder *f, int p, int q) {
    const int a = f->order[p], b = f->order[q];
    wcut_vec3 where;
    if (!(pierces(f, a, b, &where) || pierces(f, b, a, &where)) || share_corner(f, a, b)) return;
    crossings_keep(f, (wcut_crossing){.first = a < b ? a : b, .second = a < b ? b : a, .point = where});
}

/* pairs with one triangle under each of two nodes of one level */
static void crossings_cross(finder *f, int a, int b) {
    if (!overlap(&f->tree[a], &f->tree[b])) return;
    if (a >= f->leaves - 1) {
        test_pair(f, a - f->leaves + 1, b - f->leaves + 1);
        return;
    }
    for (int k = 1; k <= 2; k++)
        for (int l = 1; l <= 2; l++) crossings_cross(f, 2 * a + k, 2 * b + l);
}

wcut_status wcut_mesh_crossings(const wcut_mesh *mesh, int room, wcut_crossing *crossing, int *count) {
    if (!mesh || room < 0 || (room > 0 && !crossing) || !count || !vec3_all_finite(mesh->vertex_count, mesh->vertex))
        return WCUT_BAD_ARGUMENT;
    if (mesh->triangle_count > INT_MAX / 4) return WCUT_BAD_ARGUMENT;
    finder f = {.mesh = mesh, .room = room};
    for (int k = 0; k < mesh->vertex_count; k++) f.same = fmax(f.same, SAME * vec3_length(mesh->vertex[k]));
    f.found = wcut_alloc((size_t)room + 1, sizeof *f.found);
    wcut_status status = f.found ? build(&f) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        for (int k = 0; k < f.leaves - 1; k++) crossings_cross(&f, 2 * k + 1, 2 * k + 2);
        for (int k = 0; k < room && k < f.count; k++) crossing[k] = f.found[k];
        *count = f.count;
    }
    wcut_free(f.order);
    wcut_free(f.tree);
    wcut_free(f.found);
    return status;
}

static wcut_status mesh_crossings_by_parameter(const wcut_mesh *mesh, int *count, double u[2], double v[2]) {
    wcut_crossing first;
    int found;
    const wcut_status status = wcut_mesh_crossings(mesh, 1, &first, &found);
    if (status != WCUT_OK) return status;
    *count = found;
    for (int k = 0; k < 2 && found > 0; k++) {
        const int *t = &mesh->triangle[3 * (size_t)(k ? first.second : first.first)];
        u[k] = (mesh->uv[2 * (size_t)t[0]] + mesh->uv[2 * (size_t)t[1]] + mesh->uv[2 * (size_t)t[2]]) / 3;
        v[k] = (mesh->uv[2 * (size_t)t[0] + 1] + mesh->uv[2 * (size_t)t[1] + 1] + mesh->uv[2 * (size_t)t[2] + 1]) / 3;
    }
    return WCUT_OK;
}

wcut_status wcut_surface_crossings(const wcut_surface *surface, double chord_tolerance, int *count, double u[2],
                                   double v[2]) {
    wcut_mesh *mesh;
    wcut_status status = wcut_surface_tessellate(surface, chord_tolerance, &mesh, NULL);
    if (status != WCUT_OK) return status;
    status = mesh_crossings_by_parameter(mesh, count, u, v);
    wcut_mesh_destroy(mesh);
    return status;
}

/* ---- a surface as a whole ------------------------------------------------------------------------------------------- */

enum { TURNS_MAX = 12 }; /* halvings of a cell after which a turn of the normal is a jump */

/* Does the normal jump between two places? A smooth one turns by less the nearer they are. */
static bool jumps(const wcut_surface *s, const double a[2], wcut_vec3 normal_a, const double b[2], wcut_vec3 normal_b,
                  int halvings) {
    if (vec3_dot(normal_a, normal_b) > 0.5) return false;
    if (halvings == TURNS_MAX) return true;
    const double middle[2] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    wcut_vec3 normal;
    if (wcut_surface_normal(s, middle[0], middle[1], &normal) != WCUT_OK) return true;
    return jumps(s, a, normal_a, middle, normal, halvings + 1) || jumps(s, middle, normal, b, normal_b, halvings + 1);
}

static void find_folds(const wcut_surface *s, const wcut_mesh *m, int columns, int rows, wcut_surface_report *r) {
    for (int j = 0; j + 1 < rows; j++)
        for (int i = 0; i + 1 < columns; i++) {
            const int at[4] = {j * columns + i, j * columns + i + 1, (j + 1) * columns + i + 1, (j + 1) * columns + i};
            bool fold = false;
            for (int k = 0; k < 4 && !fold; k++) { /* its two diagonals, and the edges it begins with */
                const int a = at[k < 2 ? k : 0], b = at[k < 2 ? k + 2 : k == 2 ? 1 : 3];
                fold = jumps(s, &m->uv[2 * (size_t)a], m->normal[a], &m->uv[2 * (size_t)b], m->normal[b], 0);
            }
            if (!fold) continue;
            if (r->folds++ == 0) r->fold_u = m->uv[2 * (size_t)at[0]], r->fold_v = m->uv[2 * (size_t)at[0] + 1];
        }
}

/* Do `count` points of a mesh, `stride` apart, coincide with those from `other` on (or, without a stride there, with one
   point)? */
static bool coincide(const wcut_mesh *m, int from, int stride, int other, int other_stride, int count, double same) {
    for (int k = 0; k < count; k++)
        if (vec3_distance(m->vertex[from + k * stride], m->vertex[other + k * other_stride]) > same) return false;
    return true;
}

wcut_status wcut_surface_inspect(const wcut_surface *surface, double chord_tolerance, wcut_surface_report *report) {
    if (!report) return WCUT_BAD_ARGUMENT;

    /* triangles of the surface at this tolerance */
    wcut_mesh *m;
    wcut_tessellation_report grid;
    wcut_status status = wcut_surface_tessellate(surface, chord_tolerance, &m, &grid);
    if (status != WCUT_OK) return status;
    wcut_surface_report r = {.chord_error = grid.chord_error};
    const int columns = grid.columns, rows = grid.rows, top = (rows - 1) * columns, right = columns - 1;

    /* vertices nearer than rounding are one */
    double same = 0;
    for (int k = 0; k < m->vertex_count; k++) same = fmax(same, SAME * vec3_length(m->vertex[k]));

    /* poles: sides of the grid that shrink to a point; closed directions: opposite sides that coincide */
    const bool pole[4] = {coincide(m, 0, 1, 0, 0, columns, same), coincide(m, top, 1, top, 0, columns, same),
                          coincide(m, 0, columns, 0, 0, rows, same), coincide(m, right, columns, right, 0, rows, same)};
    for (int k = 0; k < 4; k++) r.poles += pole[k];
    r.closed_v = coincide(m, 0, 1, top, 1, columns, same);
    r.closed_u = coincide(m, 0, columns, right, columns, rows, same);

    /* folds of the surface, crossings of its triangles */
    find_folds(surface, m, columns, rows, &r);
    status = mesh_crossings_by_parameter(m, &r.crossings, r.crossing_u, r.crossing_v);
    wcut_mesh_destroy(m);
    if (status == WCUT_OK) *report = r;

    return status;
}
