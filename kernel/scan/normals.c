/* Normals of a cloud: the direction in which a point's neighbourhood varies least (Pearson 1901). */
#include <wirecut/cloud.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "scan/kd_tree.h"
#include "scan/orient.h"

enum { BLOCK = 1024 };

static const double FAR = 1e12;
static const double FLAT = 1e-6; /* [1] variance across over variance along, below which a neighbourhood is a line */

wcut_normals_options wcut_normals_options_default(void) {
    return (wcut_normals_options){.neighbours = 16, .side = {0, 0, 1}, .steep = 0.5};
}

/* a symmetric matrix */
typedef struct covariance {
    double xx, xy, xz, yy, yz, zz;
} covariance;

/* of the points around p, p itself among them */
static covariance normals_measure(const wcut_kd_tree *t, wcut_vec3 p, const wcut_kd_nearest *nearest) {
    wcut_vec3 mean = {0, 0, 0};
    for (int j = 0; j < nearest->count; j++) mean = vec3_add(mean, vec3_sub(t->point[nearest->place[j]], p));
    mean = vec3_scale(1.0 / (nearest->count + 1), mean);
    covariance c = {mean.x * mean.x, mean.x * mean.y, mean.x * mean.z,
                    mean.y * mean.y, mean.y * mean.z, mean.z * mean.z};
    for (int j = 0; j < nearest->count; j++) {
        const wcut_vec3 d = vec3_sub(vec3_sub(t->point[nearest->place[j]], p), mean);
        c.xx += d.x * d.x, c.xy += d.x * d.y, c.xz += d.x * d.z;
        c.yy += d.y * d.y, c.yz += d.y * d.z, c.zz += d.z * d.z;
    }
    return c;
}

/* eigenvalues of a symmetric matrix by the cosine formula (Smith 1961), the least first */
static void eigenvalues(const covariance *c, double value[3]) {
    const double mean = (c->xx + c->yy + c->zz) / 3, x = c->xx - mean, y = c->yy - mean, z = c->zz - mean;
    const double square = (x * x + y * y + z * z + 2 * (c->xy * c->xy + c->xz * c->xz + c->yz * c->yz)) / 6;
    const double p = sqrt(square);
    value[0] = value[1] = value[2] = mean;
    if (!(p > 0)) return;
    const double a = x / p, b = y / p, d = z / p, e = c->xy / p, f = c->xz / p, g = c->yz / p;
    const double half = (a * (b * d - g * g) - e * (e * d - g * f) + f * (e * g - b * f)) / 2;
    const double angle = acos(clamp(half, -1, 1)) / 3;
    value[2] = mean + 2 * p * cos(angle);
    value[0] = mean + 2 * p * cos(angle + 2 * WCUT_PI / 3);
    value[1] = 3 * mean - value[0] - value[2];
}

/* the direction of least variance: across two rows of the matrix less its least eigenvalue; 0 where there is none */
static wcut_vec3 min_direction(covariance c) {
    const double size = c.xx + c.yy + c.zz;
    if (!(size > 0)) return vec3(0, 0, 0);
    c.xx /= size, c.xy /= size, c.xz /= size, c.yy /= size, c.yz /= size, c.zz /= size;
    double value[3];
    eigenvalues(&c, value);
    if (!(value[1] > FLAT * value[2])) return vec3(0, 0, 0);
    const wcut_vec3 row[3] = {
        {c.xx - value[0], c.xy, c.xz}, {c.xy, c.yy - value[0], c.yz}, {c.xz, c.yz, c.zz - value[0]}};
    wcut_vec3 best = {0, 0, 0};
    for (int k = 0; k < 3; k++) {
        const wcut_vec3 n = vec3_cross(row[k], row[(k + 1) % 3]);
        if (vec3_dot(n, n) > vec3_dot(best, best)) best = n;
    }
    return vec3_unit(best);
}

/* normals of a block of the tree's points, either side up */
static void normals_find_normals(const wcut_kd_tree *t, int neighbours, int first, int end, wcut_vec3 *normal) {
    wcut_kd_nearest nearest;
    for (int k = first; k < end; k++) {
        wcut_kd_tree_nearest(t, k, neighbours, &nearest);
        normal[k] = min_direction(normals_measure(t, t->point[k], &nearest));
    }
}

static wcut_status normals_solve(const wcut_kd_tree *t, const wcut_normals_options *o, int threads, wcut_vec3 *normal,
                                 wcut_normals_report *report) {
    const int blocks = t->count / BLOCK + (t->count % BLOCK > 0);
#pragma omp parallel for schedule(dynamic) num_threads(wcut_threads(threads))
    for (int b = 0; b < blocks; b++)
        normals_find_normals(t, o->neighbours, b * BLOCK, b == blocks - 1 ? t->count : (b + 1) * BLOCK, normal);
    for (int k = 0; k < t->count; k++) report->undefined += !(vec3_dot(normal[k], normal[k]) > 0);
    if (report->undefined == t->count) return WCUT_DEGENERATE;
    return wcut_orient(t, o->neighbours, vec3_unit(o->side), o->steep, threads, normal, report);
}

wcut_status wcut_cloud_normals(int count, const wcut_vec3 *point, const wcut_normals_options *options, int threads,
                               wcut_vec3 *normal, wcut_normals_report *report) {
    const wcut_normals_options o = options ? *options : wcut_normals_options_default();

    /* check the options and every coordinate */
    if (count < 3 || !point || threads < 1 || !normal) return WCUT_BAD_ARGUMENT;
    if (o.neighbours < 2 || o.neighbours > WCUT_KD_NEAREST_MAX || !(o.steep >= 0 && o.steep <= 1) ||
        !is_positive(vec3_length(o.side)))
        return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++)
        if (!(fabs(point[k].x) <= FAR && fabs(point[k].y) <= FAR && fabs(point[k].z) <= FAR)) return WCUT_BAD_ARGUMENT;

    /* neighbours by a tree; one side for all normals */
    wcut_kd_tree tree;
    wcut_status status = wcut_kd_tree_build(count, point, threads, &tree);
    if (status != WCUT_OK) return status;
    wcut_normals_report r = {0, 0, 0};
    wcut_vec3 *found = wcut_alloc((size_t)count, sizeof *found);
    status = found ? normals_solve(&tree, &o, threads, found, &r) : WCUT_NO_MEMORY;

    /* the normals in the order of the points */
    if (status == WCUT_OK) {
        for (int k = 0; k < count; k++) normal[tree.index[k]] = found[k];
        if (report) *report = r;
    }
    wcut_free(found);
    wcut_kd_tree_clear(&tree);

    return status;
}
