/* A mesh as a sheet over a plane: the plane, and a lattice over it that is laid onto the mesh triangle by triangle. */
#include "scan/reconstruct_base.h"

#include <stdlib.h>
#include <string.h>
#include <wirecut/reconstruction.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/mesh_distance.h"

/* [1] cosine of the steepest triangle against the plane's normal: 84 deg */
static const double STEEP = 0.1;
static const double FLAT = 1e-12; /* [1] doubled area over the longest side squared, below which it has no side */

/* ---- the plane ---- */

static wcut_vec3 area_vector(const wcut_mesh *m, int t, double *longest) {
    const int *v = m->triangle + 3 * (size_t)t;
    const wcut_vec3 a = vec3_sub(m->vertex[v[1]], m->vertex[v[0]]), b = vec3_sub(m->vertex[v[2]], m->vertex[v[0]]);
    *longest = fmax(vec3_length(a), fmax(vec3_length(b), vec3_distance(a, b)));
    return vec3_cross(a, b);
}

/* the direction that the whole mesh faces; 0 where none of its triangles may be turned so far away from it */
static wcut_vec3 reconstruct_base_direction_of(const wcut_mesh *m, int flip) {
    wcut_vec3 sum = {0, 0, 0};
    double longest;
    for (int t = 0; t < m->triangle_count; t++) sum = vec3_add(sum, area_vector(m, t, &longest));
    const wcut_vec3 n = vec3_unit(sum);
    for (int t = 0; t < m->triangle_count; t++) {
        const wcut_vec3 a = area_vector(m, t, &longest);
        const double size = vec3_length(a);
        if (size > FLAT * longest * longest && !(vec3_dot(a, n) > STEEP * size)) return (wcut_vec3){0, 0, 0};
    }
    return vec3_scale(flip ? -1 : 1, n);
}

static bool reconstruct_base_is_usable(const wcut_mesh *m) {
    if (!m || m->triangle_count < 1 || m->vertex_count < 3 || !wcut_are_near(m->vertex_count, m->vertex)) return false;
    for (size_t k = 0; k < 3 * (size_t)m->triangle_count; k++)
        if (m->triangle[k] < 0 || m->triangle[k] >= m->vertex_count) return false;
    return true;
}

wcut_status wcut_mesh_base(const wcut_mesh *mesh, int flip, wcut_surface **surface) {
    if (!surface || !reconstruct_base_is_usable(mesh)) return WCUT_BAD_ARGUMENT;

    /* direction across the sheet, and two axes in its plane */
    const wcut_vec3 n = reconstruct_base_direction_of(mesh, flip), x = {1, 0, 0}, y = {0, 1, 0};
    if (!(vec3_dot(n, n) > 0)) return WCUT_DEGENERATE;
    const wcut_vec3 along = fabs(n.x) < 0.9 ? x : y;
    const wcut_vec3 e = vec3_unit(vec3_sub(along, vec3_scale(vec3_dot(along, n), n))), f = vec3_cross(n, e);

    /* the extent in the plane, and the mean height */
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY}, height = 0;
    for (int k = 0; k < mesh->vertex_count; k++) {
        const wcut_vec3 p = mesh->vertex[k];
        const double at[2] = {vec3_dot(p, e), vec3_dot(p, f)};
        for (int c = 0; c < 2; c++) low[c] = fmin(low[c], at[c]), high[c] = fmax(high[c], at[c]);
        height += vec3_dot(p, n) / mesh->vertex_count;
    }

    /* the corners of the rectangle, as a bilinear surface */
    wcut_vec3 corner[4];
    for (int k = 0; k < 4; k++)
        corner[k] = vec3_add_scaled(vec3_add_scaled(vec3_scale(height, n), k % 2 ? high[0] : low[0], e),
                                    k / 2 ? high[1] : low[1], f);
    const double knot[] = {0, 0, 1, 1};

    return wcut_surface_create(1, 1, 2, 2, knot, knot, corner, NULL, surface);
}

/* ---- onto the mesh ---- */

/* a vertex seen along the plane's normal: in steps of the lattice, and its height */
typedef struct corner {
    double x, y, height;
} corner;

static corner lattice_corner(const wcut_lattice *l, const wcut_foot *foot, double height) {
    const wcut_lattice_place p = wcut_lattice_locate(l, foot->u, foot->v);
    const int column = p.cell % l->columns, row = p.cell / l->columns;
    return (corner){column + (double)p.s, row + (double)p.t, height};
}

static double reconstruct_base_turn(const corner *a, const corner *b, double x, double y) {
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

/* the nodes that a triangle covers, a rounding wider than it is */
static void cover(const wcut_lattice *l, const corner c[3], wcut_base *base) {
    const double slack = 1e-5, area = reconstruct_base_turn(&c[0], &c[1], c[2].x, c[2].y);
    const double left = fmin(c[0].x, fmin(c[1].x, c[2].x)), right = fmax(c[0].x, fmax(c[1].x, c[2].x));
    const double front = fmin(c[0].y, fmin(c[1].y, c[2].y)), back = fmax(c[0].y, fmax(c[1].y, c[2].y));
    if (!(fabs(area) > 0)) return;
    for (int j = (int)ceil(front - slack); j <= (int)floor(back + slack); j++)
        for (int i = (int)ceil(left - slack); i <= (int)floor(right + slack); i++) {
            double w[3];
            bool inside = true;
            for (int k = 0; k < 3; k++) {
                const corner *p = &c[(k + 1) % 3], *q = &c[(k + 2) % 3];
                w[k] = reconstruct_base_turn(p, q, i, j) / area;
                inside = inside && w[k] * fabs(area) >= -slack * hypot(q->x - p->x, q->y - p->y);
            }
            if (!inside) continue;
            base->covered[j * l->columns + i] = 1;
            base->height[j * l->columns + i] = w[0] * c[0].height + w[1] * c[1].height + w[2] * c[2].height;
        }
}

/* Nodes that are not covered go on from those that are, from neighbour to neighbour: straight for NEAR steps, so that
   cells at the mesh's border are no bend, then level. */
static bool reconstruct_base_spread(const wcut_lattice *l, wcut_base *base) {
    enum { NEAR = 2 };

    /* begin with all covered nodes */
    const int nodes = lattice_nodes(l), columns = l->columns;
    int *queue = wcut_alloc((size_t)nodes, sizeof *queue), last = 0;
    unsigned char *known = wcut_copy(base->covered, (size_t)nodes, 1); /* 1 covered, steps from there + 1 else */
    const bool done = queue && known;
    for (int k = 0; k < nodes && done; k++)
        if (known[k]) queue[last++] = k;

    /* breadth first: each node takes its height from the one it is reached from */
    for (int first = 0; first < last && done; first++) {
        const int k = queue[first], i = k % columns, j = k / columns;
        const int next[] = {i > 0 ? k - 1 : k, i < columns - 1 ? k + 1 : k, j > 0 ? k - columns : k,
                            j < l->rows - 1 ? k + columns : k};
        for (int n = 0; n < 4; n++) {
            const int to = next[n], before = next[n ^ 1];
            if (known[to]) continue;
            const bool straight = known[k] <= NEAR && before != k && known[before];
            base->height[to] = base->height[k] + (straight ? base->height[k] - base->height[before] : 0);
            known[to] = (unsigned char)(known[k] <= NEAR ? known[k] + 1 : known[k]);
            queue[last++] = to;
        }
    }

    wcut_free(known);
    wcut_free(queue);
    return done;
}

/* vertices seen along the plane's normal; the plane is bilinear, so that parameters are lengths over sides */
static wcut_status find_corners(const wcut_surface *plane, const wcut_mesh *mesh, int threads,
                                const wcut_lattice *lattice, corner *at) {
    wcut_projection *projection = NULL;
    wcut_foot *foot = wcut_alloc((size_t)mesh->vertex_count, sizeof *foot);
    wcut_status status = foot ? wcut_projection_create(plane, &projection) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_projection_locate(projection, mesh->vertex_count, mesh->vertex, threads, foot);
    for (int k = 0; k < mesh->vertex_count && status == WCUT_OK; k++)
        at[k] =
            lattice_corner(lattice, &foot[k], vec3_dot(vec3_sub(mesh->vertex[k], foot[k].point), lattice->normal[0]));
    wcut_projection_destroy(projection);
    wcut_free(foot);
    return status;
}

void wcut_base_clear(wcut_base *base) {
    wcut_free(base->height);
    wcut_free(base->covered);
    *base = (wcut_base){0};
}

wcut_status wcut_base_lay(const wcut_surface *plane, const wcut_mesh *mesh, int threads, wcut_lattice *lattice,
                          wcut_base *base) {
    if (!reconstruct_base_is_usable(mesh)) return WCUT_BAD_ARGUMENT;
    const size_t nodes = (size_t)lattice_nodes(lattice);

    /* height and cover of the lattice's nodes */
    wcut_base b = {wcut_alloc(nodes, sizeof *b.height), wcut_alloc(nodes, 1)};
    corner *at = wcut_alloc((size_t)mesh->vertex_count, sizeof *at);
    wcut_status status = b.height && b.covered && at ? WCUT_OK : WCUT_NO_MEMORY;

    /* corners of the mesh on the lattice, then cover it triangle by triangle */
    if (status == WCUT_OK) status = find_corners(plane, mesh, threads, lattice, at);
    for (int t = 0; t < mesh->triangle_count && status == WCUT_OK; t++) {
        const int *v = mesh->triangle + 3 * (size_t)t;
        cover(lattice, (corner[3]){at[v[0]], at[v[1]], at[v[2]]}, &b);
    }

    /* a mesh that covers no node cannot be a base */
    if (status == WCUT_OK && !memchr(b.covered, 1, nodes)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK && !reconstruct_base_spread(lattice, &b)) status = WCUT_NO_MEMORY;

    for (size_t k = 0; k < nodes && status == WCUT_OK; k++)
        lattice->point[k] = vec3_add_scaled(lattice->point[k], b.height[k], lattice->normal[k]);
    wcut_free(at);
    if (status == WCUT_OK)
        *base = b;
    else
        wcut_base_clear(&b);

    return status;
}

double wcut_base_eval(const wcut_base *base, const wcut_lattice *lattice, wcut_lattice_place place) {
    const double *h = base->height + place.cell, s = (double)place.s, t = (double)place.t;
    const double *up = h + lattice->columns;
    return (1 - t) * ((1 - s) * h[0] + s * h[1]) + t * ((1 - s) * up[0] + s * up[1]);
}
