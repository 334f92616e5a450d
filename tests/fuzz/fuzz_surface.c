/* Loft, evaluation, tessellation, projection, split, fit, offset, knot removal, bounds and sections from any bytes: a
   status, never a NaN, never a false claim. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/bounds.h>
#include <wirecut/crossing.h>
#include <wirecut/edit.h>
#include <wirecut/intersect.h>
#include <wirecut/mesh.h>
#include <wirecut/offset.h>
#include <wirecut/projection.h>
#include <wirecut/reshape.h>
#include <wirecut/surface.h>
#include <wirecut/surface_fit.h>

enum { SIDE_MAX = 12 };

static void demand(int truth) {
    if (!truth) abort();
}

static int all_finite_points(int n, const wcut_vec3 *p) {
    for (int i = 0; i < n; i++)
        if (!isfinite(p[i].x) || !isfinite(p[i].y) || !isfinite(p[i].z)) return 0;
    return 1;
}

/* tessellate and check what came out; overflow ends in a status too */
static void tessellate(const wcut_surface *s, double tolerance) {
    wcut_mesh *mesh;
    wcut_tessellation_report report;
    if (wcut_surface_tessellate(s, tolerance, &mesh, &report) != WCUT_OK) return;
    demand(report.chord_error <= tolerance && mesh->vertex_count == report.rows * report.columns);
    demand(all_finite_points(mesh->vertex_count, mesh->vertex) && all_finite_points(mesh->vertex_count, mesh->normal));
    for (int k = 0; k < 3 * mesh->triangle_count; k++)
        demand(mesh->triangle[k] >= 0 && mesh->triangle[k] < mesh->vertex_count);
    wcut_mesh_destroy(mesh);
}

static double distance(wcut_vec3 a, wcut_vec3 b) {
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

/* no point of a coarse grid may be closer than the foot, by more than its gap */
static void project(const wcut_surface *s, wcut_vec3 query) {
    wcut_projection *projection;
    if (wcut_projection_create(s, &projection) != WCUT_OK) return;
    wcut_foot foot;
    demand(wcut_projection_locate(projection, 1, &query, 1, &foot) == WCUT_OK);
    demand(isfinite(foot.distance) && isfinite(foot.height) && foot.gap >= 0);
    for (int k = 0; k < 49; k++) {
        wcut_vec3 p;
        demand(wcut_surface_eval(s, k % 7 / 6.0, k / 7 / 6.0, 0, &p) == WCUT_OK);
        const double there = distance(p, query);
        demand(foot.distance <= there * (1 + 1e-9) + 1e-7 && foot.distance - foot.gap <= there * (1 + 1e-9) + 1e-7);
    }
    wcut_projection_destroy(projection);
}

/* the parts meet */
static void split(const wcut_surface *s, double at) {
    wcut_surface *low, *high;
    if (wcut_surface_split(s, WCUT_DIRECTION_V, at, &low, &high) != WCUT_OK) return;
    wcut_vec3 a, b;
    demand(wcut_surface_eval(low, 0.4, at, 0, &a) == WCUT_OK && wcut_surface_eval(high, 0.4, at, 0, &b) == WCUT_OK);
    demand(distance(a, b) < 1e-6);
    wcut_surface_destroy(low);
    wcut_surface_destroy(high);
}

/* the largest distance at equal parameters, on a coarse grid */
static double apart(const wcut_surface *a, const wcut_surface *b) {
    double max = 0;
    for (int k = 0; k < 81; k++) {
        wcut_vec3 p, q;
        demand(wcut_surface_eval(a, k % 9 / 8.0, k / 9 / 8.0, 0, &p) == WCUT_OK);
        demand(wcut_surface_eval(b, k % 9 / 8.0, k / 9 / 8.0, 0, &q) == WCUT_OK);
        max = fmax(max, distance(p, q));
    }
    return max;
}

/* a box holds every point of a coarse grid */
static void bound(const wcut_surface *s, double tolerance) {
    wcut_box box;
    demand(wcut_surface_bounds(s, tolerance, &box) == WCUT_OK);
    for (int k = 0; k < 81; k++) {
        wcut_vec3 p;
        demand(wcut_surface_eval(s, k % 9 / 8.0, k / 9 / 8.0, 0, &p) == WCUT_OK);
        const double slack = 1e-9 * (1 + fabs(p.x) + fabs(p.y) + fabs(p.z));
        demand(p.x >= box.low.x - slack && p.y >= box.low.y - slack && p.z >= box.low.z - slack);
        demand(p.x <= box.high.x + slack && p.y <= box.high.y + slack && p.z <= box.high.z + slack);
    }
}

/* what is shorter, higher or elsewhere says how far off it is, and is no further */
static void reshape(const wcut_surface *s, double tolerance) {
    wcut_surface *r;
    double error;
    if (wcut_surface_remove_knots(s, tolerance, &r, &error) == WCUT_OK) {
        demand(error <= tolerance && apart(s, r) <= error + 1e-6);
        wcut_surface_destroy(r);
    }
    if (s->degree_u < WCUT_DEGREE_MAX && wcut_surface_elevate(s, WCUT_DIRECTION_U, 1, &r) == WCUT_OK) {
        demand(apart(s, r) < 1e-6);
        wcut_surface_destroy(r);
    }
    if (wcut_surface_offset(s, 3 * tolerance, 30 + 10 * tolerance, &r, NULL) == WCUT_OK) {
        demand(all_finite_points(r->count_u * r->count_v, r->control));
        wcut_surface_destroy(r);
    }
}

/* points of a section lie on its plane and on the surface */
static void section(const wcut_surface *s, wcut_vec3 point, wcut_vec3 normal, double tolerance) {
    wcut_traces *t;
    if (wcut_surface_intersect_plane(s, point, normal, tolerance, &t) != WCUT_OK) return;
    for (int k = 0; k < t->count; k++) {
        demand(t->trace[k].count >= 2 || t->trace[k].closed);
        for (int i = 0; i < t->trace[k].count; i++) {
            const wcut_vec3 p = t->trace[k].point[i];
            const double off = (p.x - point.x) * normal.x + (p.y - point.y) * normal.y + (p.z - point.z) * normal.z;
            demand(isfinite(off) && fabs(off) <= 1e-6 * (fabs(normal.x) + fabs(normal.y) + fabs(normal.z)));
        }
    }
    wcut_traces_destroy(t);
}

/* one of the dearer ones each time */
static void examine(const wcut_surface *s, int which, double merge, double tolerance, int stations, int nodes,
                    const wcut_vec3 *x) {
    if (which == 0) reshape(s, tolerance);
    if (which == 1) section(s, x[stations * nodes / 2], (wcut_vec3){merge - 2, tolerance - 128, x[0].y / 3}, tolerance);
    wcut_surface_report looked;
    if (which == 2 && wcut_surface_inspect(s, 100 + tolerance, &looked) == WCUT_OK)
        demand(looked.folds >= 0 && looked.crossings >= 0);
    wcut_surface *fitted;
    wcut_surface_fit_report fit;
    if (which == 3 && wcut_surface_fit(stations, nodes, x, merge, tolerance, &fitted, NULL, &fit) == WCUT_OK) {
        demand(fit.node_error <= tolerance && fit.between_error <= tolerance);
        wcut_surface_destroy(fitted);
    }
}

/* bytes: stations, nodes, merge, tolerance, then 3-byte nodes; an odd first byte takes whole doubles instead */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    if (size < 4) return 0;
    const int stations = data[0] / 2 % SIDE_MAX + 1, nodes = data[1] % SIDE_MAX + 1, raw = data[0] % 2;
    const double merge = data[2] / 64.0, tolerance = 1 + data[3];
    const int which = data[3] % 4;
    wcut_vec3 x[SIDE_MAX * SIDE_MAX] = {{0, 0, 0}};
    double *to = &x[0].x;
    data += 4, size -= 4;
    for (int k = 0; k < 3 * stations * nodes && size >= (raw ? sizeof(double) : 1); k++) {
        if (raw) {
            memcpy(&to[k], data, sizeof(double));
        } else {
            to[k] = data[0] - 128;
        }
        data += raw ? sizeof(double) : 1, size -= raw ? sizeof(double) : 1;
    }
    wcut_surface *s;
    double v[SIDE_MAX];
    wcut_loft_report report;
    if (wcut_surface_loft(stations, nodes, x, merge, &s, v, &report) != WCUT_OK) return 0;
    demand(report.used + report.dropped == stations && v[0] == 0 && v[stations - 1] == 1);
    demand(all_finite_points(s->count_u * s->count_v, s->control));
    wcut_vec3 ders[16];
    demand(wcut_surface_eval(s, 0.3, 0.7, 3, ders) == WCUT_OK);
    double size_of = 0;
    for (int k = 0; k < 3 * stations * nodes; k++) size_of = fmax(size_of, fabs(to[k]));
    if (size_of < 1e3) { /* larger ones have millions of triangles, and tell nothing new */
        tessellate(s, tolerance);
        project(s, (wcut_vec3){to[0] + merge, to[1], to[2] - tolerance});
        split(s, merge / 4);
        bound(s, tolerance / 100);
        examine(s, which, merge, tolerance, stations, nodes, x);
    }
    wcut_surface_destroy(s);
    return 0;
}
