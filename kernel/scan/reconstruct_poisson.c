/* Poisson reconstruction of an open sheet: closed to a thin body by a copy below and a rim, then trimmed to the scan. */
#include "scan/reconstruct_poisson.h"

#include <limits.h>
#include <string.h>
#include <wirecut/cloud.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/reconstruct_poisson_cgal.h"
#include "scan/reconstruct_sheet.h"

static const double COARSE = 3;       /* [1] spacing of the thinned points over that of the scan's */
static const double THICK = 10;       /* [1] thickness of the body over the spacing */
static const double SIZE = 1.5;       /* [1] of a triangle over the spacing */
static const double DISTANCE = 0.375; /* [1] of a triangle from the surface, over the spacing */
static const double UPRIGHT = 0.5;    /* [1] cosine to the face's normal below which a triangle belongs to the rim */

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
    if (status == WCUT_OK) status = wcut_thinning_step(thinning, b->count, b->point, keep);
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

/* the scan's points over the face, thinned; normals are those of the face, then of the points around on its side */
static wcut_status take_scan(const wcut_surface *surface, int count, const wcut_vec3 *point, const wcut_foot *foot,
                             double spacing, int threads, body *b) {
    wcut_status status = make_room(b, count);
    for (int k = 0; k < count && status == WCUT_OK; k++)
        if (!foot[k].beyond) put(b, point[k], normal_at(surface, &foot[k]));
    if (status == WCUT_OK) status = thin(spacing, b);
    if (status != WCUT_OK) return status;
    if (b->count < 3) return WCUT_DEGENERATE;
    wcut_vec3 *own = wcut_alloc((size_t)b->count, sizeof *own);
    status = own ? wcut_cloud_normals(b->count, b->point, NULL, threads, own, NULL) : WCUT_NO_MEMORY;
    for (int k = 0; k < b->count && status == WCUT_OK; k++) {
        const double cosine = vec3_dot(own[k], b->normal[k]);
        if (cosine != 0) b->normal[k] = vec3_scale(cosine < 0 ? -1 : 1, own[k]);
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
    const int corners = 3 * m->triangle_count, steps = (int)THICK;
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

/* ---- trimming ---- */

/* foot, deviation and distance from the scan of every vertex; keep: 1 where it belongs to the scanned sheet */
static wcut_status measure(const wcut_surface *surface, const wcut_kd_tree *tree, double support, int threads,
                           wcut_mesh *m, double *distance, unsigned char *keep) {
    wcut_projection *projection = NULL;
    wcut_foot *foot = wcut_alloc((size_t)m->vertex_count, sizeof *foot);
    wcut_status status = foot ? wcut_projection_create(surface, &projection) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_projection_locate(projection, m->vertex_count, m->vertex, threads, foot);
    const double limit = nextafter(support, INFINITY);
    for (int k = 0; k < m->vertex_count && status == WCUT_OK; k++) {
        distance[k] = wcut_kd_tree_distance(tree, m->vertex[k], limit);
        keep[k] =
            distance[k] <= support && !foot[k].beyond && vec3_dot(m->normal[k], normal_at(surface, &foot[k])) > UPRIGHT;
        m->uv[2 * k] = foot[k].u, m->uv[2 * k + 1] = foot[k].v;
        m->scalar[k] = foot[k].height;
    }
    wcut_projection_destroy(projection);
    wcut_free(foot);
    return status;
}

/* the triangles whose corners are all kept, as a mesh of their own; the furthest of its vertices */
static wcut_status trim(const wcut_mesh *m, const unsigned char *keep, const double *distance, wcut_mesh **trimmed,
                        double *farthest) {
    int triangles = 0, vertices = 0, *place = wcut_alloc((size_t)m->vertex_count, sizeof *place);
    if (!place) return WCUT_NO_MEMORY;
    for (int k = 0; k < m->triangle_count; k++) {
        const int *t = m->triangle + 3 * k;
        if (!keep[t[0]] || !keep[t[1]] || !keep[t[2]]) continue;
        triangles++;
        for (int a = 0; a < 3; a++)
            if (!place[t[a]]) place[t[a]] = ++vertices;
    }
    wcut_mesh *to = NULL;
    wcut_status status =
        triangles ? wcut_mesh_create(vertices, triangles, WCUT_MESH_NORMAL | WCUT_MESH_UV | WCUT_MESH_SCALAR, &to)
                  : WCUT_DEGENERATE;
    *farthest = 0;
    for (int k = 0; k < m->vertex_count && status == WCUT_OK; k++) {
        const int at = place[k] - 1;
        if (at < 0) continue;
        to->vertex[at] = m->vertex[k];
        to->uv[2 * at] = m->uv[2 * k], to->uv[2 * at + 1] = m->uv[2 * k + 1];
        to->scalar[at] = m->scalar[k];
        *farthest = fmax(*farthest, distance[k]);
    }
    for (int k = 0, at = 0; k < m->triangle_count && status == WCUT_OK; k++) {
        const int *t = m->triangle + 3 * k;
        if (!keep[t[0]] || !keep[t[1]] || !keep[t[2]]) continue;
        for (int a = 0; a < 3; a++) to->triangle[at++] = place[t[a]] - 1;
    }
    wcut_free(place);
    if (status == WCUT_OK) *trimmed = to;
    return status;
}

/* the body's mesh, less everything that is not the scanned sheet */
static wcut_status cut_out(const wcut_surface *surface, const wcut_kd_tree *tree, double support, int threads,
                           wcut_mesh *whole, wcut_reconstruction *r) {
    double *distance = wcut_alloc((size_t)whole->vertex_count, sizeof *distance), farthest;
    unsigned char *keep = wcut_alloc((size_t)whole->vertex_count, 1);
    wcut_mesh *sheet = NULL;
    wcut_status status = distance && keep ? WCUT_OK : WCUT_NO_MEMORY;
    wcut_sheet_normals(whole);
    if (status == WCUT_OK) status = measure(surface, tree, support, threads, whole, distance, keep);
    if (status == WCUT_OK) status = trim(whole, keep, distance, &sheet, &farthest);
    wcut_free(distance);
    wcut_free(keep);
    if (status != WCUT_OK) return status;
    /* what the field's mesh has of the supported area tells how much that is on the scan itself */
    const double whole_area = r->area / (1 - r->lost);
    r->area = wcut_sheet_normals(sheet);
    r->lost = fmax(0, 1 - r->area / whole_area);
    r->farthest = farthest;
    r->rms = 0;
    r->iterations = 0;
    wcut_mesh_destroy(r->mesh);
    r->mesh = sheet;
    return WCUT_OK;
}

wcut_status wcut_reconstruct_poisson(const wcut_surface *surface, int count, const wcut_vec3 *point,
                                     const wcut_foot *foot, const wcut_kd_tree *tree,
                                     const wcut_reconstruction_options *o, int threads, wcut_reconstruction *r) {
    const double spacing = o->spacing > 0 ? o->spacing : COARSE * r->point_spacing;
    body all = {0}, closing = {0};
    wcut_mesh *whole = NULL;
    wcut_status status = take_scan(surface, count, point, foot, spacing, threads, &all);
    if (status == WCUT_OK) status = close_below(r->mesh, spacing, &closing);
    if (status == WCUT_OK && all.count > INT_MAX - closing.count) status = WCUT_NO_MEMORY;
    const int scanned = all.count;
    if (status == WCUT_OK && all.count + closing.count > all.room) {
        body both = {0};
        status = make_room(&both, all.count + closing.count);
        for (int k = 0; k < all.count && status == WCUT_OK; k++) put(&both, all.point[k], all.normal[k]);
        clear_body(&all);
        all = both;
    }
    for (int k = 0; k < closing.count && status == WCUT_OK; k++) put(&all, closing.point[k], closing.normal[k]);
    clear_body(&closing);
    if (status == WCUT_OK)
        status = wcut_poisson_cgal(all.count, scanned, all.point, all.normal, SIZE * spacing, DISTANCE * spacing,
                                   o->seed, &whole);
    clear_body(&all);
    if (status == WCUT_OK) status = cut_out(surface, tree, o->support, threads, whole, r);
    if (status == WCUT_OK) r->spacing = spacing;
    wcut_mesh_destroy(whole);
    return status;
}
