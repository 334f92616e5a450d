/* From a face back to its scan: the distance to the nearest point, by a k-d tree, nearest box first. */
#include <wirecut/deviation.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "scan/kd_tree.h"

static const double FAR = 1e12; /* [mm] */

static double square_from_box(const wcut_kd_node *n, wcut_vec3 p) {
    const double x = fmax(fmax(n->low.x - p.x, p.x - n->high.x), 0);
    const double y = fmax(fmax(n->low.y - p.y, p.y - n->high.y), 0);
    const double z = fmax(fmax(n->low.z - p.z, p.z - n->high.z), 0);
    return x * x + y * y + z * z;
}

static double nearest_square(const wcut_kd_tree *t, wcut_vec3 p) {
    struct {
        double square;
        int node, level, first, end;
    } stack[64], at;
    int depth = 1;
    double best = INFINITY;
    stack[0].square = 0, stack[0].node = 0, stack[0].level = 0, stack[0].first = 0, stack[0].end = t->count;
    while (depth > 0) {
        at.square = stack[--depth].square, at.node = stack[depth].node, at.level = stack[depth].level;
        at.first = stack[depth].first, at.end = stack[depth].end;
        if (at.square >= best) continue;
        if (at.level == t->levels) {
            for (int i = at.first; i < at.end; i++) {
                const wcut_vec3 r = vec3_sub(t->point[i], p);
                best = fmin(best, vec3_dot(r, r));
            }
            continue;
        }
        const int middle = at.first + (at.end - at.first) / 2, child = 2 * at.node + 1;
        const double left = square_from_box(&t->node[child], p), right = square_from_box(&t->node[child + 1], p);
        for (int round = 0; round < 2; round++) { /* the nearer one is pushed last, and taken first */
            const bool second = (left <= right) == (round == 0);
            stack[depth].square = second ? right : left, stack[depth].node = child + second;
            stack[depth].level = at.level + 1;
            stack[depth].first = second ? middle : at.first, stack[depth].end = second ? at.end : middle;
            depth++;
        }
    }
    return best;
}

static bool are_near(int count, const wcut_vec3 *p) {
    for (int k = 0; k < count; k++)
        if (!(fabs(p[k].x) <= FAR && fabs(p[k].y) <= FAR && fabs(p[k].z) <= FAR)) return false;
    return true;
}

wcut_status wcut_cloud_locate(int count, const wcut_vec3 *point, int queries, const wcut_vec3 *query, int threads,
                              double *distance) {
    if (count < 1 || !point || queries < 0 || threads < 1 || (queries > 0 && (!query || !distance)) ||
        !are_near(count, point) || !are_near(queries, query))
        return WCUT_BAD_ARGUMENT;
    wcut_kd_tree tree;
    const wcut_status status = wcut_kd_tree_build(count, point, threads, &tree);
    if (status != WCUT_OK) return status;
#pragma omp parallel for schedule(dynamic, 256) num_threads(threads)
    for (int k = 0; k < queries; k++) distance[k] = sqrt(nearest_square(&tree, query[k]));
    wcut_kd_tree_clear(&tree);
    return WCUT_OK;
}
