/* Points as binary records, read as they are laid out. */
#include <wirecut/cloud_file.h>
#include "io/scan/cloud_source.h"

bool wcut_cloud_fill_records(wcut_cloud_source *s, wcut_batch *b) {
    const wcut_record *r = s->state;
    wcut_stream *t = &s->in.stream;

    /* a record must fit into the window */
    if (r->size > t->capacity)
        return wcut_source_refuse(&s->in, "found records of %zu bytes, expected at most %zu", r->size, t->capacity);
    while (s->left > 0 && b->count < b->capacity) {
        if (wcut_stream_fill(t, r->size) < r->size) return wcut_source_refuse_truncated(&s->in, s->left, "points");

        /* the whole records in the window */
        for (; s->left > 0 && b->count < b->capacity && t->end - t->at >= r->size; s->left--) {
            double value[WCUT_FIELDS] = {0};
            if (!wcut_record_read(r, t->data + t->at, value))
                s->info.withheld++;
            else if (!wcut_cloud_take(s, b, value))
                return false;
            t->at += r->size;
        }
    }

    return true;
}
