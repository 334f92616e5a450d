/* Distances of a scan from a face for a best fit: along the normal of the exact closest point (Chen, Medioni 1991),
   trimmed. */
#include "scan/register_cloud.h"

#include <stdbool.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/threads.h"
#include "scan/mesh_distance.h"
#include "scan/register.h"
#include "scan/span.h"
#include "surface/foot_search.h"

enum { MIN = WCUT_DOF_COUNT };

static const double SOFT = 0.25; /* [1] of the limit of the share kept: weights fall from 1 to 0 within so much of it */

wcut_status wcut_register_sample(wcut_register_face face, int count, const wcut_vec3 *point, int max, double keep,
                                 int threads, wcut_register_cloud *cloud) {
    wcut_register_cloud c = {.face = face, .count = count < max ? count : max, .keep = keep, .threads = threads};
    const size_t n = (size_t)c.count;
    c.point = wcut_alloc(n, sizeof *c.point);
    c.moved = wcut_alloc(n, sizeof *c.moved);
    c.normal = wcut_alloc(n, sizeof *c.normal);
    c.at = wcut_alloc(n, sizeof *c.at);
    c.foot = wcut_alloc(n, face.projection ? sizeof(wcut_foot) : sizeof(wcut_mesh_foot));
    c.square = wcut_alloc(n, sizeof *c.square);
    c.weight = wcut_alloc(n, sizeof *c.weight);
    if (!c.point || !c.moved || !c.normal || !c.at || !c.foot || !c.square || !c.weight) {
        wcut_register_sample_clear(&c);
        return WCUT_NO_MEMORY;
    }
    for (int i = 0; i < c.count; i++) c.point[i] = point[(long long)i * count / c.count];
    *cloud = c;
    return WCUT_OK;
}

void wcut_register_sample_clear(wcut_register_cloud *cloud) {
    wcut_free(cloud->point);
    wcut_free(cloud->moved);
    wcut_free(cloud->normal);
    wcut_free(cloud->at);
    wcut_free(cloud->foot);
    wcut_free(cloud->square);
    wcut_free(cloud->weight);
    *cloud = (wcut_register_cloud){0};
}

/* S_u x S_v of length 1 at a foot; 0 where the surface has no normal */
static wcut_vec3 normal_of_surface(const wcut_projection *projection, const wcut_foot *foot) {
    wcut_vec3 d[4];
    /* cannot fail: the surface is valid, so are the feet */
    (void)wcut_surface_eval(projection->surface, foot->u, foot->v, 1, d);
    return vec3_unit(vec3_cross(d[2], d[1]));
}

/* that of the triangle */
static wcut_vec3 normal_of_mesh(const wcut_mesh *mesh, const wcut_mesh_foot *foot) {
    const int *v = mesh->triangle + 3 * (size_t)foot->triangle;
    const wcut_vec3 a = mesh->vertex[v[0]];
    return vec3_unit(vec3_cross(vec3_sub(mesh->vertex[v[1]], a), vec3_sub(mesh->vertex[v[2]], a)));
}

/* the sample moved, and its feet */
static wcut_status find_feet(wcut_register_cloud *c, const wcut_motion *motion) {
    const wcut_register_face *f = &c->face;
    for (int i = 0; i < c->count; i++) c->moved[i] = motion_apply(motion, c->point[i]);
    if (!f->projection) {
        wcut_mesh_foot *foot = c->foot;
        const wcut_status status = wcut_mesh_tree_locate(f->tree, c->count, c->moved, c->threads, foot);
        for (int i = 0; i < c->count && status == WCUT_OK; i++) c->at[i] = foot[i].point;
        return status;
    }
    wcut_foot *foot = c->foot;
    const wcut_status status = wcut_projection_locate(f->projection, c->count, c->moved, c->threads, foot);
    for (int i = 0; i < c->count && status == WCUT_OK; i++) c->at[i] = foot[i].point;
    return status;
}

static void register_cloud_find_normals(wcut_register_cloud *c) {
    const wcut_register_face *f = &c->face;
#pragma omp parallel for schedule(static) num_threads(wcut_threads(c->threads))
    for (int i = 0; i < c->count; i++)
        c->normal[i] = f->projection ? normal_of_surface(f->projection, (const wcut_foot *)c->foot + i)
                                     : normal_of_mesh(f->mesh, (const wcut_mesh_foot *)c->foot + i);
}

/* the greatest of the share kept of `count` squares, which are sorted */
static double limit_of(int count, double keep, double *square) {
    wcut_sort(count, square);
    const int kept = (int)ceil(keep * count);
    return square[kept - 1];
}

wcut_status wcut_register_closeness(wcut_register_cloud *c, const wcut_motion *motion, double *rms) {
    const wcut_status status = find_feet(c, motion);
    if (status != WCUT_OK) return status;
    for (int i = 0; i < c->count; i++) {
        const wcut_vec3 d = vec3_sub(c->moved[i], c->at[i]);
        c->square[i] = vec3_dot(d, d);
    }
    const double limit = limit_of(c->count, c->keep, c->square);
    double sum = 0;
    int used = 0;
    for (; used < c->count && c->square[used] <= limit; used++) sum += c->square[used];
    *rms = sqrt(sum / used);
    return WCUT_OK;
}

static double height_of(const wcut_register_cloud *c, int i) {
    return vec3_dot(c->normal[i], vec3_sub(c->moved[i], c->at[i]));
}

static bool is_beyond(const wcut_register_cloud *c, int i) {
    return c->face.projection ? ((const wcut_foot *)c->foot)[i].beyond : ((const wcut_mesh_foot *)c->foot)[i].beyond;
}

/* [1] 1 at 0, 0 at 1 and beyond, smooth between */
static double fade(double t) {
    const double x = t < 0 ? 0 : t > 1 ? 1 : t;
    return 1 - x * x * (3 - 2 * x);
}

/* the weight of a deviate whose size is t times the limit of the share kept */
static double register_cloud_weight_of(double t) { return fade((t - 1 + SOFT) / (2 * SOFT)); }

/* the weight of a point at height r: its size over the limit, and how far it is beyond a border */
static double weigh(const wcut_register_cloud *c, int i, double r, double limit) {
    const double w = register_cloud_weight_of(fabs(r) / limit);
    if (w == 0 || !is_beyond(c, i)) return w;
    const wcut_vec3 d = vec3_sub(c->moved[i], c->at[i]), side = vec3_sub(d, vec3_scale(r, c->normal[i]));
    return w * fade(vec3_length(side) / limit);
}

wcut_status wcut_register_distances(void *data, const wcut_motion *motion, wcut_register_sums *sums) {
    wcut_register_cloud *c = data;
    const wcut_status status = find_feet(c, motion);
    if (status != WCUT_OK) return status;

    /* feet of the points under this motion, and normals there */
    int over = 0;
    register_cloud_find_normals(c);

    /* the limit is that of the points over the face */
    for (int i = 0; i < c->count; i++) {
        c->weight[i] = 0;
        if (is_beyond(c, i) || !(vec3_dot(c->normal[i], c->normal[i]) > 0)) continue;
        const double r = height_of(c, i);
        c->square[over++] = r * r;
    }
    if (over < MIN) return WCUT_DEGENERATE;

    /* weights by the limit, and the sums of the normal equations */
    const double limit = fmax(sqrt(limit_of(over, c->keep, c->square)), 1e-300);

    for (int i = 0; i < c->count; i++) {
        if (!(vec3_dot(c->normal[i], c->normal[i]) > 0)) continue;
        const double r = height_of(c, i), w = c->keep < 1 || is_beyond(c, i) ? weigh(c, i, r, limit) : 1;
        c->weight[i] = w;
        if (w == 0) continue;
        register_add(sums, w, c->normal[i], vec3_cross(motion_arm(motion, c->point[i]), c->normal[i]), r);
    }

    sums->overlap = (double)over / c->count;

    return sums->used < MIN ? WCUT_DEGENERATE : WCUT_OK;
}

double wcut_register_held(const void *data, const wcut_motion *motion) {
    const wcut_register_cloud *c = data;
    double sum = 0;
    for (int i = 0; i < c->count; i++) {
        if (c->weight[i] == 0) continue;
        const double r = vec3_dot(c->normal[i], vec3_sub(motion_apply(motion, c->point[i]), c->at[i]));
        sum += c->weight[i] * r * r;
    }
    return sum;
}

/* weighted variance of a standard normal deviate, the limit being the quantile of the share kept: what trimming leaves
   of it (Croux, Rousseeuw 1992, with soft weights; Simpson's rule, exact to 1e-9) */
static double consistency_of(double keep) {
    enum { PANELS = 2000 };
    if (keep >= 1) return 1;
    const double q = wcut_gaussian_quantile((1 + keep) / 2), h = (1 + SOFT) * q / PANELS;
    double weight = 0, square = 0;
    for (int k = 0; k <= PANELS; k++) {
        const double x = k * h, part = (k == 0 || k == PANELS ? 1
                                        : k % 2               ? 4
                                                              : 2) *
                                       register_cloud_weight_of(x / q) * exp(-x * x / 2);
        weight += part;
        square += part * x * x;
    }
    return square / weight;
}

wcut_register_problem wcut_register_fit_problem(wcut_register_cloud *cloud, const wcut_registration_options *options,
                                                double length) {
    return (wcut_register_problem){.model = wcut_register_distances,
                                   .held = wcut_register_held,
                                   .data = cloud,
                                   .options = options,
                                   .length = length,
                                   .noise = options->noise,
                                   .consistency = consistency_of(options->keep),
                                   .max_iterations = options->max_iterations};
}
