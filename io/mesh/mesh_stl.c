/* STL as a mesh: the corners of the cloud reader, three a triangle. */
#include "io/mesh/mesh_formats.h"

enum { PIECE = 3 * 1024 };

bool wcut_mesh_fill_stl(wcut_cloud_source *s, wcut_mesh_builder *g) {
    wcut_vec3 corner[PIECE];
    if (!wcut_cloud_begin_stl(s)) return false;
    for (;;) {
        int count = 0;
        if (wcut_cloud_source_next(s, PIECE, corner, NULL, &count, NULL) != WCUT_OK) return false;
        if (s->info.not_finite > 0)
            return wcut_cloud_refuse(s, "found a corner that is not finite, expected three numbers");
        if (count == 0) return true;
        for (int k = 0; k + 2 < count; k += 3) {
            int v[3];
            for (int c = 0; c < 3; c++) {
                v[c] = wcut_mesh_builder_vertex(g, corner[k + c]);
                if (v[c] < 0) return false;
            }
            if (!wcut_mesh_builder_triangle(g, v[0], v[1], v[2])) return false;
        }
    }
}
