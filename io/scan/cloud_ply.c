/* PLY (Turk 1994) as a cloud: the vertices of any header, ascii or binary; other elements and properties are
   skipped. */
#include "base/alloc.h"
#include "base/fail.h"
#include "io/mesh/ply.h"

static bool fill(wcut_cloud_source *s, wcut_batch *b) {
    const wcut_ply *m = s->state;
    const wcut_ply_element *e = &m->element[m->vertex];
    double value[WCUT_FIELDS] = {0};
    if (!m->ascii && !e->has_list) {
        if (!wcut_record_fill(s, b)) return false;
    } else {
        for (; s->left > 0 && b->count < b->capacity; s->left--)
            if (!wcut_ply_record(s, m, e, value, NULL) || !wcut_cloud_take(s, b, value)) return false;
    }
    if (s->left != 0) return true;
    s->left = -1; /* what follows is looked at once */
    return wcut_ply_skip(s, m, m->vertex + 1, m->elements) && wcut_cloud_check_end(s);
}

bool wcut_cloud_begin_ply(wcut_cloud_source *s) {
    wcut_ply *m = wcut_alloc(1, sizeof *m);
    if (!m) return wcut_cloud_refuse_memory(s);
    s->state = m;
    s->line = 1;
    s->fill = fill;
    return wcut_ply_header(s, m) && wcut_ply_begin(s, m);
}
