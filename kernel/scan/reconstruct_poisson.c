/* Poisson reconstruction of an open sheet: closed to a thin body by a copy below and a rim. */
#include "scan/reconstruct_poisson.h"

#include <limits.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/reconstruct_poisson_cgal.h"

static const int THICK = 10; /* [1] thickness of the body over the spacing */

/* points with normals that point out of the body */
typedef struct body {
    int count, room;
    wcut_vec3 *point, *normal;
} body;

static void clear_body(body *b) {
    wcut_free(b->point);
    wcut_free(b->normal);
    *b = (body){0};
}

static wcut_status make_room(body *b, int room) {
    b->point = wcut_alloc((size_t)room, sizeof *b->point);
    b->normal = wcut_alloc((size_t)room, sizeof *b->normal);
    b->room = room;
    return b->point && b->normal ? WCUT_OK : WCUT_NO_MEMORY;
}

static void put(body *b, wcut_vec3 point, wcut_vec3 normal) {
    b->point[b->count] = point;
    b->normal[b->count++] = normal;
}

/* keep the first point of each cube */
static wcut_status thin(double side, body *b) {
    wcut_thinning *thinning = NULL;
    unsigned char *keep = wcut_alloc((size_t)b->count, 1);
    wcut_status status = keep ? wcut_thinning_create(fmax(side, 1e-3), &thinning) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_thinning_add(thinning, b->count, b->point, keep);
    wcut_thinning_destroy(thinning);
    int count = 0;
    for (int k = 0; k < b->count && status == WCUT_OK; k++)
        if (keep[k]) b->point[count] = b->point[k], b->normal[count++] = b->normal[k];
    wcut_free(keep);
    if (status == WCUT_OK) b->count = count;
    return status;
}

/* S_u x S_v of length 1; 0 where there is none */
static wcut_vec3 normal_at(const wcut_surface *surface, const wcut_foot *foot) {
    wcut_vec3 d[4];
    /* cannot fail: the surface is valid, so are the feet */
    (void)wcut_surface_eval(surface, foot->u, foot->v, 1, d);
    return vec3_unit(vec3_cross(d[2], d[1]));
}

/* ---- the sheet itself ---- */

/* the scan's points over the face, thinned; normals of the points around, on the face's side */
static wcut_status take_scan(const wcut_poisson_input *in, body *b) {
    wcut_status status = make_room(b, in->count);
    for (int k = 0; k < in->count && status == WCUT_OK; k++)
        if (!in->foot[k].beyond) put(b, in->point[k], normal_at(in->surface, &in->foot[k]));
    if (status == WCUT_OK) status = thin(in->spacing, b);
    if (status != WCUT_OK) return status;
    if (b->count < 3) return WCUT_DEGENERATE;
    wcut_vec3 *own = wcut_alloc((size_t)b->count, sizeof *own);
    status = own ? wcut_cloud_normals(b->count, b->point, NULL, in->threads, own, NULL) : WCUT_NO_MEMORY;
    for (int k = 0; k < b->count && status == WCUT_OK; k++) {
        const double cosine = vec3_dot(own[k], b->normal[k]);
        if (cosine > 0 || cosine < 0) b->normal[k] = vec3_scale(cosine < 0 ? -1 : 1, own[k]);
    }
    wcut_free(own);
    return status;
}

/* ---- what closes it ---- */

/* an edge from vertex a to b, of one triangle alone: 1 in `border` for each corner of each triangle where it begins */
static wcut_status find_border(const wcut_mesh *m, unsigned char *border) {
    const int corners = 3 * m->triangle_count;
    int *head = wcut_alloc((size_t)m->vertex_count, sizeof *head), *next = wcut_alloc((size_t)corners, sizeof *next);
    if (head && next) {
        for (int k = 0; k < corners; k++) { /* the edges that begin at each vertex */
            next[k] = head[m->triangle[k]];
            head[m->triangle[k]] = k + 1;
        }
        for (int k = 0; k < corners; k++) {
            const int from = m->triangle[k], to = m->triangle[k - k % 3 + (k + 1) % 3];
            border[k] = 1;
            for (int e = head[to]; e; e = next[e - 1])
                if (m->triangle[e - 1 - (e - 1) % 3 + e % 3] == from) border[k] = 0;
        }
    }
    const wcut_status status = head && next ? WCUT_OK : WCUT_NO_MEMORY;
    wcut_free(head);
    wcut_free(next);
    return status;
}

/* points down the rim below the edge from a to b, the triangle to the left of it */
static void put_rim(const wcut_mesh *m, int a, int b, wcut_vec3 down, double spacing, int steps, body *closing) {
    const wcut_vec3 edge = vec3_sub(m->vertex[b], m->vertex[a]), middle = vec3_mix(m->vertex[a], m->vertex[b], 0.5);
    const wcut_vec3 out = vec3_unit(vec3_cross(down, edge));
    for (int k = 1; k < steps; k++) put(closing, vec3_add_scaled(middle, k * spacing, down), out);
}

/* the sheet's copy below it, and the rim between the two */
static wcut_status close_below(const wcut_mesh *m, double spacing, body *closing) {
    const int corners = 3 * m->triangle_count, steps = THICK;
    unsigned char *border = wcut_alloc((size_t)corners, 1);
    wcut_status status = border ? find_border(m, border) : WCUT_NO_MEMORY;
    wcut_vec3 down = {0, 0, 0};
    long long room = m->vertex_count;
    for (int k = 0; k < corners && status == WCUT_OK; k++) room += border[k] ? steps - 1 : 0;
    for (int k = 0; k < m->vertex_count; k++) down = vec3_sub(down, m->normal[k]);
    down = vec3_unit(down);
    if (status == WCUT_OK) status = room <= INT_MAX ? make_room(closing, (int)room) : WCUT_NO_MEMORY;
    for (int k = 0; k < m->vertex_count && status == WCUT_OK; k++)
        put(closing, vec3_add_scaled(m->vertex[k], THICK * spacing, down), vec3_scale(-1, m->normal[k]));
    for (int k = 0; k < corners && status == WCUT_OK; k++)
        if (border[k]) put_rim(m, m->triangle[k], m->triangle[k - k % 3 + (k + 1) % 3], down, spacing, steps, closing);
    wcut_free(border);
    return status == WCUT_OK ? thin(spacing, closing) : status;
}

/* ---- the whole ---- */

/* the points of `closing` behind those of `all` */
static wcut_status join(body *all, const body *closing) {
    body both = {0};
    if (all->count > INT_MAX - closing->count) return WCUT_NO_MEMORY;
    const wcut_status status = make_room(&both, all->count + closing->count);
    for (int k = 0; k < all->count && status == WCUT_OK; k++) put(&both, all->point[k], all->normal[k]);
    for (int k = 0; k < closing->count && status == WCUT_OK; k++) put(&both, closing->point[k], closing->normal[k]);
    clear_body(all);
    *all = both;
    return status;
}

/* where Poisson's surface of a body crosses the normals of the field's active nodes */
static wcut_status cross(const wcut_poisson_input *in, const body *b, int scanned, wcut_field *field) {
    const int nodes = lattice_nodes(in->lattice);
    body line = {0};
    int *node = wcut_alloc((size_t)nodes, sizeof *node);
    double *along = wcut_alloc((size_t)nodes, sizeof *along);
    unsigned char *crossed = wcut_alloc((size_t)nodes, 1);
    wcut_status status = node && along && crossed ? make_room(&line, nodes) : WCUT_NO_MEMORY;
    for (int k = 0; k < nodes && status == WCUT_OK; k++) {
        const wcut_vec3 n = in->lattice->normal[k];
        if (!field->active[k] || !(vec3_dot(n, n) > 0)) continue;
        node[line.count] = k;
        put(&line, vec3_add_scaled(in->lattice->point[k], field->height[k], n), n);
    }
    if (status == WCUT_OK)
        status = wcut_poisson_cross(b->count, scanned, b->point, b->normal, in->seed, line.count, line.point,
                                    line.normal, in->reach, along, crossed);
    for (int k = 0; k < line.count && status == WCUT_OK; k++) {
        field->active[node[k]] = crossed[k];
        field->height[node[k]] += crossed[k] ? along[k] : 0;
    }
    clear_body(&line);
    wcut_free(node);
    wcut_free(along);
    wcut_free(crossed);
    return status;
}

wcut_status wcut_reconstruct_poisson(const wcut_poisson_input *in, wcut_field *field) {
    body all = {0}, closing = {0};
    wcut_status status = take_scan(in, &all);
    const int scanned = all.count;
    if (status == WCUT_OK) status = close_below(in->sheet, in->spacing, &closing);
    if (status == WCUT_OK) status = join(&all, &closing);
    clear_body(&closing);
    if (status == WCUT_OK) status = cross(in, &all, scanned, field);
    clear_body(&all);
    return status;
}
