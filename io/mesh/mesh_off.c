/* OFF (Geomview) as a mesh, in double precision. */
#include "io/mesh/mesh_formats.h"
#include "io/mesh/off_read.h"

static bool read_faces(wcut_source *s, wcut_off_reader *r, wcut_mesh_builder *g, wcut_numbered *n) {
    int corner[WCUT_POLYGON_MAX], count = 0;
    while (r->faces > 0) {
        if (!wcut_off_face(r, WCUT_POLYGON_MAX, corner, &count)) return false;

        /* points and lines bound nothing */
        if (count < 3) continue;
        for (int k = 0; k < count; k++) {
            if (corner[k] >= n->count)
                return wcut_source_refuse(s, "found a corner at vertex %d, expected 0 to %d", corner[k], n->count - 1);
            corner[k] = wcut_numbered_use(g, n, corner[k]);
            if (corner[k] < 0) return false;
        }
        if (!wcut_mesh_builder_polygon(g, count, corner)) return false;
    }
    return wcut_off_end(r);
}

bool wcut_mesh_fill_off(wcut_source *s, wcut_mesh_builder *g) {
    wcut_off_reader r;
    wcut_numbered n = {0};
    double value[WCUT_FIELDS] = {0};
    bool done = wcut_off_begin(s, &r);
    while (done && r.vertices > 0) done = wcut_off_vertex(&r, value) && wcut_numbered_add(g, &n, value);
    done = done && read_faces(s, &r, g, &n);
    wcut_numbered_free(&n);
    return done;
}
