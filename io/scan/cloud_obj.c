/* OBJ as a cloud: its vertices, line by line in the memory of a window; which of them are faces' is not looked at. */
#include <wirecut/cloud_file.h>
#include "io/mesh/obj.h"
#include "io/scan/cloud_source.h"

static bool read_cloud_obj_line(wcut_cloud_source *s, const char *line, wcut_batch *b) {
    const char *p = wcut_skip_blanks(line), *rest = wcut_obj_match(p, "v");
    double value[WCUT_FIELDS] = {0};
    if (rest) return wcut_obj_vertex(&s->in, line, rest, value) && wcut_cloud_take(s, b, value);
    return wcut_obj_match(p, "f") || wcut_obj_is_passed_over(p) || wcut_obj_refuse(&s->in, line, p);
}

static bool fill_obj(wcut_cloud_source *s, wcut_batch *b) {
    size_t length;
    while (b->count < b->capacity) {
        const char *line = wcut_obj_line(&s->in, &length);
        if (!line) return s->in.failure.status == WCUT_OK;
        if (!read_cloud_obj_line(s, line, b)) return false;
        wcut_row_done(&s->in, length);
    }
    return true;
}

bool wcut_cloud_begin_obj(wcut_cloud_source *s) {
    s->in.line = 1;
    s->fill = fill_obj;
    return true;
}
