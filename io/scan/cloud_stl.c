/* STL as a cloud: the corners of its triangles. */
#include <wirecut/cloud_file.h>
#include "base/alloc.h"
#include "io/mesh/stl_read.h"
#include "io/scan/cloud_source.h"

static bool fill_stl(wcut_cloud_source *s, wcut_batch *b) {
    wcut_stl_reader *r = s->state;
    while (b->count < b->capacity) {
        double value[WCUT_FIELDS] = {0};
        if (!wcut_stl_next(r, value)) return s->in.failure.status == WCUT_OK;
        if (!wcut_cloud_take(s, b, value)) return false;
    }
    return true;
}

bool wcut_cloud_begin_stl(wcut_cloud_source *s) {
    wcut_stl_reader *r = wcut_alloc(1, sizeof *r);
    if (!r) return wcut_source_refuse_memory(&s->in);
    s->state = r;
    s->fill = fill_stl;
    if (!wcut_stl_begin(&s->in, r)) return false;
    return r->stated < 0 || wcut_cloud_state(s, 3 * r->stated, 0, "corners");
}
