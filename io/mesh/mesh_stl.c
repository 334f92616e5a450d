/* STL as a mesh: corners in one place are one vertex. */
#include "io/mesh/mesh_formats.h"
#include "io/mesh/stl_read.h"

bool wcut_mesh_fill_stl(wcut_source *s, wcut_mesh_builder *g) {
    wcut_stl_reader r;
    double corner[3];
    int v[3], k = 0;
    if (!wcut_stl_begin(s, &r)) return false;
    while (wcut_stl_next(&r, corner)) {
        wcut_vec3 p;
        if (!wcut_mesh_builder_point(g, corner, &p)) return false;
        v[k] = wcut_mesh_builder_vertex(g, p);
        if (v[k] < 0) return false;
        k = (k + 1) % 3;
        if (k == 0 && !wcut_mesh_builder_triangle(g, v[0], v[1], v[2])) return false;
    }
    return s->failure.status == WCUT_OK;
}
