/* OBJ (Wavefront) as a mesh: v and f; what changes no triangle is passed over, free-form geometry refused. */
#include <limits.h>
#include <string.h>

#include <wirecut/cloud_file.h>
#include "io/mesh/mesh_formats.h"
#include "io/mesh/obj.h"

static bool add_vertex(wcut_source *s, const char *line, const char *p, wcut_mesh_builder *g, wcut_numbered *n) {
    double value[WCUT_FIELDS];
    return wcut_obj_vertex(s, line, p, value) && wcut_numbered_add(g, n, value);
}

/* an index that is not 0; NULL: none */
static const char *read_index(const char *p, int64_t *index) {
    const char *at = p + (*p == '-');
    int64_t i = 0;
    const char *first = at;
    for (; *at >= '0' && *at <= '9'; at++) {
        if (i > INT_MAX) return NULL;
        i = 10 * i + (*at - '0');
    }
    *index = *p == '-' ? -i : i;
    return at > first && i != 0 ? at : NULL;
}

/* "7", "7/1", "7//2", "7/1/2", the first counted from 1, or back from the last vertex where it is negative */
static const char *read_corner(const char *p, int count, int *vertex) {
    int64_t index, other;
    p = read_index(p, &index);
    for (int part = 0; p && *p == '/' && part < 2; part++) {
        p++;
        /* either part may be left out: "7/", "7//", "7/1/" */
        if (*p != '/' && !wcut_is_blank(*p) && !wcut_is_line_end(p)) p = read_index(p, &other);
    }
    if (!p || !(wcut_is_blank(*p) || wcut_is_line_end(p))) return NULL;
    index = index < 0 ? count + index : index - 1;
    if (index < 0 || index >= count) return NULL;
    *vertex = (int)index;
    return p;
}

static bool read_face(wcut_source *s, const char *line, const char *p, wcut_mesh_builder *g, wcut_numbered *n) {
    int vertex[WCUT_POLYGON_MAX], count = 0, i = 0;
    for (; !wcut_is_line_end(p); count++) {
        if (count == WCUT_POLYGON_MAX) return wcut_source_refuse_text(s, line, p, "at most 1024 corners");
        const char *behind = read_corner(p, n->count, &i);
        if (!behind) return wcut_source_refuse_text(s, line, p, "a corner at one of the vertices above");
        vertex[count] = wcut_numbered_use(g, n, i);
        if (vertex[count] < 0) return false;
        p = wcut_skip_blanks(behind);
    }
    return wcut_mesh_builder_polygon(g, count, vertex);
}

static bool read_obj_line(wcut_source *s, const char *line, wcut_mesh_builder *g, wcut_numbered *n) {
    const char *p = wcut_skip_blanks(line), *rest;
    if ((rest = wcut_obj_match(p, "v")) != NULL) return add_vertex(s, line, rest, g, n);
    if ((rest = wcut_obj_match(p, "f")) != NULL) return read_face(s, line, rest, g, n);
    return wcut_obj_is_passed_over(p) || wcut_obj_refuse(s, line, p);
}

bool wcut_mesh_fill_obj(wcut_source *s, wcut_mesh_builder *g) {
    wcut_numbered n = {0};
    size_t length;
    bool done = true;
    s->line = 1;
    for (const char *line; done && (line = wcut_obj_line(s, &length)) != NULL; wcut_row_done(s, length))
        done = read_obj_line(s, line, g, &n);
    wcut_numbered_free(&n);
    return done && s->failure.status == WCUT_OK;
}
