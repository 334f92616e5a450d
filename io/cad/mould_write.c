/* "wirecut-mould/1": both halves in figures, and whether they are solids. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <wirecut/angle.h>
#include <wirecut/mould.h>
#include <wirecut/mould_file.h>
#include <wirecut/version.h>

#include "base/degrees.h"
#include "base/fail.h"
#include "io/file/text.h"

static void put_truth(wcut_text *text, const char *before, int value) {
    wcut_text_print(text, "%s%s", before, value ? "true" : "false");
}

static void put_half(wcut_text *text, const char *name, const wcut_half *half) {
    const wcut_half_report *r = &half->report;
    wcut_text_print(text, ",\n  \"%s\": {", name);

    /* whether it is a solid */
    put_truth(text, "\"closed\": ", r->closed);
    put_truth(text, ", \"oriented\": ", r->oriented);
    wcut_text_print(text, ", \"self_intersections\": %d, \"pieces\": %d", r->self_intersections, r->pieces);

    /* volume, areas, triangles */
    wcut_text_put_number(text, ",\n    \"volume_mm3\": ", r->volume);
    wcut_text_put_number(text, ", \"area_mm2\": ", r->area);
    wcut_text_put_number(text, ", \"cut_area_mm2\": ", r->cut_area);
    wcut_text_print(text, ", \"triangles\": %d", half->mesh->triangle_count);

    /* box, drafts, walls, edges */
    wcut_text_put_point(text, ",\n    \"box_mm\": [[", r->box_low);
    wcut_text_put_point(text, ", [", r->box_high);
    wcut_text_put_number(text, "],\n    \"draft_deg\": {\"min\": ", WCUT_DEG_PER_RAD * r->draft_min);
    wcut_text_put_point(text, ", \"at_mm\": [", r->draft_place);
    put_truth(text, ", \"held\": ", r->draft_held);
    wcut_text_put_number(text, "},\n    \"undercut_mm2\": ", r->undercut_area);
    wcut_text_put_number(text, ",\n    \"wall_mm\": {\"min\": ", r->wall_min);
    wcut_text_put_point(text, ", \"at_mm\": [", r->wall_place);
    put_truth(text, ", \"held\": ", r->wall_held);
    wcut_text_put_number(text, "},\n    \"edge_deg\": {\"min\": ", WCUT_DEG_PER_RAD * r->edge_min);
    wcut_text_put_point(text, ", \"at_mm\": [", r->edge_place);

    wcut_text_put_number(text, "},\n    \"keys_mm3\": ", r->key_volume);
    wcut_text_print(text, ", \"exact_faces\": %d}", half->brep ? half->brep->face_count : 0);
}

static void put_mould_cut(wcut_text *text, const wcut_mould *m) {
    /* volumes and their balance, kerf, errors */
    wcut_text_put_number(text, ",\n  \"kerf_volume_mm3\": ", m->kerf_volume);
    wcut_text_put_number(text, ",\n  \"block_volume_mm3\": ", m->block_volume);
    wcut_text_put_number(text, ",\n  \"volume_error\": ", m->volume_error);
    wcut_text_put_number(text, ",\n  \"kerf_mm\": {\"min\": ", m->kerf_min);
    wcut_text_put_number(text, ", \"max\": ", m->kerf_max);
    wcut_text_put_number(text, "},\n  \"fit_error_mm\": ", m->fit_error);
    wcut_text_put_number(text, ",\n  \"chord_error_mm\": ", m->chord_error);

    /* how far the cut was prolonged, its smallest radius */
    wcut_text_put_number(text, ",\n  \"prolonged_mm\": {\"entry\": ", m->prolonged_entry);
    wcut_text_put_number(text, ", \"exit\": ", m->prolonged_exit);
    wcut_text_put_number(text, ", \"wire\": ", m->prolonged_side);
    wcut_text_put_number(text, "},\n  \"radius_mm\": {\"min\": ", m->radius_min);
    wcut_text_put_point(text, ", \"at_mm\": [", m->radius_place);
    wcut_text_put_number(text, ", \"wire\": ", m->wire_radius);

    /* what was asked for, what holds the halves, and how they were made */
    wcut_text_put_number(text, "},\n  \"asked\": {\"wall_mm\": ", m->wall_asked);
    wcut_text_put_number(text, ", \"draft_deg\": ", typed_degrees(m->draft_asked));
    wcut_text_put_number(text, ", \"thickness_mm\": ", m->thickness);
    wcut_text_put_number(text, ", \"scale\": ", m->scale);
    wcut_text_put_point(text, ", \"pull\": [", m->pull);
    wcut_text_print(text, "},\n  \"lugs\": %d", m->lugs);
    if (m->frame) wcut_text_put_number(text, ",\n  \"frame_volume_mm3\": ", m->frame_volume);
    wcut_text_print(text, ",\n  \"made_by\": \"%s\",\n  \"step\": ", m->by_boolean ? "booleans" : "index");
    wcut_text_string(text, m->by_boolean ? "not written: made by booleans, the halves are triangles without exact faces"
                                         : "exact faces");
}

static wcut_status print_mould(const wcut_mould *m, const char *name, char **text, size_t *length) {
    wcut_text out;
    if (!m || !m->lower.mesh || !m->upper.mesh || !name) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_print(&out, "{\n  \"format\": \"wirecut-mould/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(&out, name);
    put_half(&out, "lower", &m->lower);
    put_half(&out, "upper", &m->upper);
    put_mould_cut(&out, m);
    wcut_text_print(&out, "\n}\n");
    return wcut_text_finish(&out, text, length);
}

wcut_status wcut_mould_print(const wcut_mould *mould, const char *name, char **text) {
    return text ? print_mould(mould, name, text, NULL) : WCUT_BAD_ARGUMENT;
}

wcut_status wcut_mould_write(const wcut_mould *mould, const char *name, const char *path, wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    wcut_status status = path ? print_mould(mould, name, &text, &length) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "a mould: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
