/* What a scan says of every vertex of a mesh: deviations spread to where it has points, and the area where it has none. */
#include <wirecut/face.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "scan/kd_tree.h"
#include "scan/mesh_distance.h"

enum { PARTS_MAX = 64 };

static const double SAMPLES_MAX = 4e6; /* places on the whole mesh */
static const double MIN = 1e-3;        /* [1] weight below which a vertex has no value of its own */

/* ---- values ---- */

/* one round: vertices without a value get the mean of their neighbours that have one; how many did */
static int mesh_map_pass_on(const wcut_mesh *m, unsigned char *known, double *value, double *sum, int *count) {
    int found = 0;
    for (int t = 0; t < m->triangle_count; t++) {
        const int *v = m->triangle + 3 * (size_t)t;
        for (int k = 0; k < 3; k++)
            for (int n = 1; n < 3 && known[v[k]] == 0; n++)
                if (known[v[(k + n) % 3]] == 1) sum[v[k]] += value[v[(k + n) % 3]], count[v[k]]++;
    }
    for (int k = 0; k < m->vertex_count; k++) {
        if (count[k] == 0) continue;
        value[k] = sum[k] / count[k];
        known[k] = 1, found++;
        sum[k] = 0, count[k] = 0;
    }
    return found;
}

/* near[k]: the scan has a point at vertex k */
static wcut_status mesh_map_fill(const wcut_mesh *m, const double *sum, const double *weight, const unsigned char *near,
                                 double *value, unsigned char *present) {
    enum { WITHOUT = 2 };
    const size_t count = (size_t)m->vertex_count;
    double *more = wcut_alloc(count, sizeof *more);
    int *times = wcut_alloc(count, sizeof *times);
    const bool done = more && times;
    for (size_t k = 0; k < count && done; k++) {
        const bool own = weight[k] > MIN;
        present[k] = own ? 1 : near[k] ? 0 : WITHOUT;
        value[k] = own ? sum[k] / weight[k] : 0;
    }
    while (done && mesh_map_pass_on(m, present, value, more, times) > 0) continue;
    for (size_t k = 0; k < count && done; k++) present[k] = present[k] == 1;
    wcut_free(times);
    wcut_free(more);
    return done ? WCUT_OK : WCUT_NO_MEMORY;
}

/* ---- area ---- */

static double longest_of(const wcut_vec3 p[3]) {
    return fmax(vec3_distance(p[0], p[1]), fmax(vec3_distance(p[1], p[2]), vec3_distance(p[2], p[0])));
}

static void mesh_map_corners_of(const wcut_mesh *m, int t, wcut_vec3 p[3]) {
    for (int k = 0; k < 3; k++) p[k] = m->vertex[m->triangle[3 * (size_t)t + (size_t)k]];
}

/* the side of the parts into which triangles are divided: the support, or what keeps their number in bounds */
static double part_side(const wcut_mesh *m, double support) {
    double side = support, samples = 0;
    for (int t = 0; t < m->triangle_count; t++) {
        wcut_vec3 p[3];
        mesh_map_corners_of(m, t, p);
        const double parts = fmin(ceil(longest_of(p) / side), PARTS_MAX);
        samples += parts * parts;
    }
    return samples > SAMPLES_MAX ? side * sqrt(samples / SAMPLES_MAX) : side;
}

/* [mm^2] of a triangle where no point of the scan is within the support: by the middles of its parts */
static double missing_of(const wcut_vec3 p[3], double side, double support, const wcut_kd_tree *tree) {
    const int parts = (int)clamp(ceil(longest_of(p) / side), 1, PARTS_MAX);
    const wcut_vec3 a = vec3_sub(p[1], p[0]), b = vec3_sub(p[2], p[0]);
    const double limit = nextafter(support, INFINITY);
    int missing = 0;
    for (int i = 0; i < parts; i++)
        for (int j = 0; j < 2 * (parts - i) - 1; j++) { /* upright and hanging ones in turn */
            const int column = j / 2;
            const double middle = j % 2 ? 2.0 / 3 : 1.0 / 3, s = column + middle, t = i + middle;
            const wcut_vec3 at = vec3_add_scaled(vec3_add_scaled(p[0], s / parts, a), t / parts, b);
            missing += !(wcut_kd_tree_distance(tree, at, limit) < limit);
        }
    return vec3_length(vec3_cross(a, b)) / 2 * missing / ((double)parts * parts);
}

static wcut_status missing_area(const wcut_mesh *m, double support, const wcut_kd_tree *tree, int threads,
                                double *area) {
    const double side = part_side(m, support);
    double *missing = wcut_alloc((size_t)m->triangle_count, sizeof *missing), sum = 0;
    if (!missing) return WCUT_NO_MEMORY;
#pragma omp parallel for schedule(dynamic, 256) num_threads(wcut_threads(threads))
    for (int t = 0; t < m->triangle_count; t++) {
        wcut_vec3 p[3];
        mesh_map_corners_of(m, t, p);
        missing[t] = missing_of(p, side, support, tree);
    }
    for (int t = 0; t < m->triangle_count; t++) sum += missing[t];
    wcut_free(missing);
    *area = sum;
    return WCUT_OK;
}

/* ---- the whole ---- */

wcut_status wcut_mesh_map_eval(const wcut_mesh *mesh, const double *sum, const double *weight, int count,
                               const wcut_vec3 *point, double support, int threads, double *value,
                               unsigned char *present, double *area) {
    if (!mesh || !sum || !weight || count < 1 || !point || !wcut_are_near(count, point) ||
        !wcut_are_near(mesh->vertex_count, mesh->vertex) || !is_positive(support) || threads < 1 || !value ||
        !present || !area)
        return WCUT_BAD_ARGUMENT;

    /* which vertices have a point of the scan within the support */
    wcut_kd_tree tree;
    unsigned char *near = wcut_alloc((size_t)mesh->vertex_count, 1);
    wcut_status status = near ? wcut_kd_tree_build(count, point, threads, &tree) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        const double limit = nextafter(support, INFINITY);
#pragma omp parallel for schedule(dynamic, 1024) num_threads(wcut_threads(threads))
        for (int k = 0; k < mesh->vertex_count; k++)
            near[k] = wcut_kd_tree_distance(&tree, mesh->vertex[k], limit) < limit;

        /* the area without points, and the values where there are some */
        double missing = 0;
        status = missing_area(mesh, support, &tree, threads, &missing);
        if (status == WCUT_OK) status = mesh_map_fill(mesh, sum, weight, near, value, present);
        if (status == WCUT_OK) *area = missing;
        wcut_kd_tree_clear(&tree);
    }

    wcut_free(near);
    return status;
}
