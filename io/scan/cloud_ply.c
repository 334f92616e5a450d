/* PLY (Turk 1994) as a cloud: the vertices of any header, ascii or binary; other elements and properties are
   skipped. */
#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "base/fail.h"
#include "io/mesh/ply.h"
#include "io/scan/cloud_source.h"

static bool fill_ply(wcut_cloud_source *s, wcut_batch *b) {
    const wcut_ply *m = s->state;
    const wcut_ply_element *e = &m->element[m->vertex];
    double value[WCUT_FIELDS] = {0};
    if (!m->ascii && !e->has_list) {
        if (!wcut_cloud_fill_records(s, b)) return false;
    } else {
        for (; s->left > 0 && b->count < b->capacity; s->left--)
            if (!wcut_ply_record(&s->in, m, e, value, NULL) || !wcut_cloud_take(s, b, value)) return false;
    }
    if (s->left != 0) return true;
    s->left = -1; /* what follows is looked at once */
    return wcut_ply_skip(&s->in, m, m->vertex + 1, m->elements) &&
           wcut_source_check_end(&s->in, m->element[m->elements - 1].size);
}

bool wcut_cloud_begin_ply(wcut_cloud_source *s) {
    wcut_ply *m = wcut_alloc(1, sizeof *m);
    if (!m) return wcut_source_refuse_memory(&s->in);
    s->state = m;
    s->in.line = 1;
    s->fill = fill_ply;
    if (!wcut_ply_header(&s->in, m) || !wcut_ply_begin(&s->in, m)) return false;
    s->info.has_normals = m->record.fields == 6;
    return wcut_cloud_state(s, m->element[m->vertex].count, 0, "vertices");
}
