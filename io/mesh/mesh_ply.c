/* PLY (Turk 1994) as a mesh: its vertices, then the corners of its faces. */
#include <stdlib.h>

#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/mesh/mesh_formats.h"
#include "io/mesh/ply.h"

static bool read_vertices(wcut_source *s, const wcut_ply *m, wcut_mesh_builder *g, wcut_numbered *n) {
    const wcut_ply_element *e = &m->element[m->vertex];
    double value[WCUT_FIELDS] = {0};
    for (int64_t k = 0; k < e->count; k++)
        if (!wcut_ply_record(s, m, e, value, NULL) || !wcut_numbered_add(g, n, value)) return false;
    return true;
}

static bool read_mesh_ply_face(wcut_source *s, const wcut_ply *m, wcut_mesh_builder *g, wcut_numbered *n) {
    wcut_ply_corners corners = {0};
    double none[WCUT_FIELDS];
    int vertex[WCUT_POLYGON_MAX];
    if (!wcut_ply_record(s, m, &m->element[m->face], none, &corners)) return false;
    for (int k = 0; k < corners.count; k++) {
        const int64_t i = corners.vertex[k];
        if (i < 0 || i >= n->count)
            return wcut_source_refuse(s, "found a corner at vertex %lld, expected 0 to %d", (long long)i, n->count - 1);
        vertex[k] = wcut_numbered_use(g, n, (int)i);
        if (vertex[k] < 0) return false;
    }
    return wcut_mesh_builder_polygon(g, corners.count, vertex);
}

static bool has_corners(const wcut_ply *m) {
    const wcut_ply_element *e = &m->element[m->face];
    int lists = 0;
    for (int k = e->first; k < e->first + e->properties; k++)
        lists += m->property[k].is_corners && m->property[k].value != WCUT_SCALAR_F32 &&
                 m->property[k].value != WCUT_SCALAR_F64;
    return lists == 1;
}

static bool read_mesh_ply(wcut_source *s, wcut_ply *m, wcut_mesh_builder *g, wcut_numbered *n) {
    if (!wcut_ply_header(s, m)) return false;
    if (m->face < 0 || m->face < m->vertex || !has_corners(m))
        return wcut_source_refuse(s,
                                  "found no element face with a list vertex_indices of integers behind the element "
                                  "vertex, expected one: a cloud?");
    if (!wcut_ply_begin(s, m) || !read_vertices(s, m, g, n)) return false;
    if (!wcut_ply_skip(s, m, m->vertex + 1, m->face)) return false;
    for (int64_t k = 0; k < m->element[m->face].count; k++)
        if (!read_mesh_ply_face(s, m, g, n)) return false;
    return wcut_ply_skip(s, m, m->face + 1, m->elements) && wcut_source_check_end(s, m->element[m->elements - 1].size);
}

bool wcut_mesh_fill_ply(wcut_source *s, wcut_mesh_builder *g) {
    wcut_numbered n = {0};
    wcut_ply *m = wcut_alloc(1, sizeof *m);
    s->line = 1;
    const bool done = m ? read_mesh_ply(s, m, g, &n) : wcut_source_refuse_memory(s);
    wcut_numbered_free(&n);
    free(m);
    return done;
}
