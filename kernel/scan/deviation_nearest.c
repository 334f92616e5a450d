/* From a face back to its scan: the distance to the nearest point, by a k-d tree. */
#include <wirecut/deviation.h>

#include "base/threads.h"
#include "scan/kd_tree.h"
#include "scan/mesh_distance.h"

wcut_status wcut_cloud_locate(int count, const wcut_vec3 *point, int queries, const wcut_vec3 *query, int threads,
                              double *distance) {
    if (count < 1 || !point || queries < 0 || threads < 1 || (queries > 0 && (!query || !distance)) ||
        !wcut_are_near(count, point) || !wcut_are_near(queries, query))
        return WCUT_BAD_ARGUMENT;
    wcut_kd_tree tree;
    const wcut_status status = wcut_kd_tree_build(count, point, threads, &tree);
    if (status != WCUT_OK) return status;
#pragma omp parallel for schedule(dynamic, 256) num_threads(wcut_threads(threads))
    for (int k = 0; k < queries; k++) distance[k] = wcut_kd_tree_distance(&tree, query[k], INFINITY);
    wcut_kd_tree_clear(&tree);
    return WCUT_OK;
}
