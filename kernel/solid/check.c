/* Edges counted by the corner they leave from, volumes by the divergence theorem: one pass over the triangles each. */
#include "solid/check.h"

#include <math.h>
#include <stdbool.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/mesh_volume.h"

/* ends of the directed edges that leave each vertex: end[first[v]] to end[first[v + 1] - 1] */
typedef struct fans {
    int *first, *end;
} fans;

static wcut_status check_gather(const wcut_mesh *m, fans *f) {
    const int corners = 3 * m->triangle_count;
    f->first = wcut_alloc((size_t)m->vertex_count + 2, sizeof *f->first);
    f->end = wcut_alloc((size_t)corners, sizeof *f->end);
    if (!f->first || !f->end) return WCUT_NO_MEMORY;
    int *start = f->first + 1; /* filling moves every start to that of the next vertex, where it belongs */
    for (int k = 0; k < corners; k++) start[m->triangle[k] + 1]++;
    for (int v = 0; v < m->vertex_count; v++) start[v + 1] += start[v];
    for (int k = 0; k < corners; k++) {
        const int next = k % 3 == 2 ? k - 2 : k + 1;
        f->end[start[m->triangle[k]]++] = m->triangle[next];
    }
    return WCUT_OK;
}

static int count_edge(const fans *f, int from, int to) {
    int n = 0;
    for (int k = f->first[from]; k < f->first[from + 1]; k++) n += f->end[k] == to;
    return n;
}

/* is every edge run through once in either direction? *two: by two triangles at all */
static bool edges_match(const wcut_mesh *m, const fans *f, bool *two) {
    bool match = true;
    *two = true;
    for (int v = 0; v < m->vertex_count; v++)
        for (int k = f->first[v]; k < f->first[v + 1]; k++) {
            const int along = count_edge(f, v, f->end[k]), back = count_edge(f, f->end[k], v);
            match = match && along == 1 && back == 1;
            *two = *two && along + back == 2;
        }
    return match;
}

static int root_of(int *parent, int v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
}

/* connected parts; parent: vertex_count */
static int count_pieces(const wcut_mesh *m, const fans *f, int *parent) {
    int pieces = 0;
    for (int v = 0; v < m->vertex_count; v++) parent[v] = v;
    for (int v = 0; v < m->vertex_count; v++)
        for (int k = f->first[v]; k < f->first[v + 1]; k++) parent[root_of(parent, v)] = root_of(parent, f->end[k]);
    for (int v = 0; v < m->vertex_count; v++) pieces += parent[v] == v && f->first[v] < f->first[v + 1];
    return pieces;
}

/* twice a triangle's area along its normal */
static wcut_vec3 triangle_normal_spread(const wcut_mesh *m, int t) {
    const int *c = m->triangle + 3 * (ptrdiff_t)t;
    const wcut_vec3 a = m->vertex[c[0]];
    return vec3_cross(vec3_sub(m->vertex[c[1]], a), vec3_sub(m->vertex[c[2]], a));
}

wcut_status wcut_check_boundary(const wcut_mesh *mesh, wcut_half_report *report) {
    fans f = {.first = NULL};

    /* edges by the corner they leave from */
    int *parent = wcut_alloc((size_t)mesh->vertex_count, sizeof *parent);
    wcut_status status = parent ? check_gather(mesh, &f) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        wcut_half_report *r = report;

        /* closed: every edge has two triangles; oriented: they run through it in opposite directions */
        bool two;
        r->oriented = edges_match(mesh, &f, &two);
        r->closed = two && mesh->triangle_count > 0;
        r->pieces = count_pieces(mesh, &f, parent);
        r->volume = wcut_mesh_volume(mesh);
        r->oriented = r->oriented && r->volume > 0;

        /* volume, area and box */
        r->area = 0;
        for (int t = 0; t < mesh->triangle_count; t++) r->area += vec3_length(triangle_normal_spread(mesh, t)) / 2;
        r->box_low = r->box_high = mesh->vertex_count > 0 ? mesh->vertex[0] : vec3(0, 0, 0);
        for (int v = 1; v < mesh->vertex_count; v++) {
            const wcut_vec3 p = mesh->vertex[v];
            r->box_low = vec3(fmin(r->box_low.x, p.x), fmin(r->box_low.y, p.y), fmin(r->box_low.z, p.z));
            r->box_high = vec3(fmax(r->box_high.x, p.x), fmax(r->box_high.y, p.y), fmax(r->box_high.z, p.z));
        }
    }

    wcut_free(f.end);
    wcut_free(f.first);
    wcut_free(parent);
    return status;
}

wcut_status wcut_check_open_edge(const wcut_mesh *mesh, bool *found, wcut_vec3 *place) {
    fans f = {.first = NULL};
    const wcut_status status = check_gather(mesh, &f);
    *found = false;
    for (int v = 0; status == WCUT_OK && !*found && v < mesh->vertex_count; v++)
        for (int k = f.first[v]; !*found && k < f.first[v + 1]; k++) {
            if (count_edge(&f, v, f.end[k]) == 1 && count_edge(&f, f.end[k], v) == 1) continue;
            *found = true;
            *place = vec3_mix(mesh->vertex[v], mesh->vertex[f.end[k]], 0.5);
        }
    wcut_free(f.end);
    wcut_free(f.first);
    return status;
}

void wcut_check_draft(const wcut_mesh *mesh, const unsigned char *tag, wcut_vec3 pull, wcut_half_report *report,
                      double *draft) {
    /* vertices that are not on the cut have no draft */
    for (int v = 0; v < mesh->vertex_count; v++) draft[v] = NAN;
    report->cut_area = report->undercut_area = 0;
    report->draft_min = INFINITY;

    /* each triangle of the cut: asin(N . p) */
    for (int t = 0; t < mesh->triangle_count; t++) {
        if (!tag[t]) continue;
        const wcut_vec3 n = triangle_normal_spread(mesh, t);
        const double area = vec3_length(n) / 2;
        if (!(area > 0)) continue;
        const double rise = vec3_dot(n, pull) / (2 * area);
        const double angle = asin(clamp(rise, -1, 1));

        /* a vertex has the least draft of its triangles */
        const int *c = mesh->triangle + 3 * (ptrdiff_t)t;
        for (int k = 0; k < 3; k++) draft[c[k]] = fmin(draft[c[k]], angle); /* fmin leaves a NaN out */

        /* areas, and the place of the least draft */
        report->cut_area += area;
        if (angle < 0) report->undercut_area += area;
        if (angle < report->draft_min) {
            report->draft_min = angle;
            report->draft_place =
                vec3_scale(1.0 / 3, vec3_add(mesh->vertex[c[0]], vec3_add(mesh->vertex[c[1]], mesh->vertex[c[2]])));
        }
    }
}
