/* OFF as a cloud: its vertices, line by line in the memory of a window; the faces behind them are not looked at. */
#include "base/alloc.h"
#include "io/mesh/off_read.h"
#include "io/scan/cloud_source.h"

static bool fill_off(wcut_cloud_source *s, wcut_batch *b) {
    wcut_off_reader *r = s->state;
    while (r->vertices > 0 && b->count < b->capacity) {
        double value[WCUT_FIELDS] = {0};
        if (!wcut_off_vertex(r, value) || !wcut_cloud_take(s, b, value)) return false;
    }
    return true;
}

bool wcut_cloud_begin_off(wcut_cloud_source *s) {
    wcut_off_reader *r = wcut_alloc(1, sizeof *r);
    if (!r) return wcut_source_refuse_memory(&s->in);
    s->state = r;
    s->fill = fill_off;
    if (!wcut_off_begin(&s->in, r)) return false;
    s->info.has_normals = r->has_normals;
    return wcut_cloud_state(s, r->vertices, 0, "vertices");
}
