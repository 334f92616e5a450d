/* "wirecut-feasibility/1": what can be followed of a target and why not all of it, and how near a design came. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/angle.h>
#include <wirecut/design_file.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/file/text.h"

/* ---- words ---- */

/* the reason that covers the largest share of the map; NONE where all of it can be followed */
static wcut_design_reason main_reason(const wcut_design_map *m) {
    wcut_design_reason most = WCUT_DESIGN_REASON_NONE;
    for (int r = WCUT_DESIGN_REASON_DOMED; r <= WCUT_DESIGN_REASON_PATTERN; r++)
        if (m->share[r] > (most ? m->share[most] : 0)) most = (wcut_design_reason)r;
    return most;
}

static const char *words_of_reason(wcut_design_reason reason) {
    static const char *const text[] = {"every place can be followed",
                                       "the target is domed (positive Gauss curvature), where no wire lies in it",
                                       "wires would have to be bent tighter than the force on them bends them",
                                       "wires would stand beyond their largest angle at the block's sides",
                                       "no family of wires runs from side to side there"};
    return text[reason];
}

wcut_status wcut_design_result_say(const wcut_design_result *r, int size, char *text) {
    if (!r || !r->map || size < 1 || !text) return WCUT_BAD_ARGUMENT;
    const wcut_design_map *m = r->map;
    const wcut_design_reason reason = main_reason(m);

    /* panels, the map alone, or one cut */
    if (r->panels) {
        double step = 0;
        for (int k = 0; k < r->panels->joints; k++) step = fmax(step, r->panels->joint[k].step_max);
        snprintf(
            text, (size_t)size,
            "%d panels, %d across and %d along, come to %.3g mm rms of the target (%.3g mm at most): the tolerance of "
            "%.3g mm rms is %s; where they meet the step is %.3g mm at most.",
            r->panels->count, r->panels->across, r->panels->along, r->face_rms, r->face_max, r->tolerance,
            r->face_rms <= r->tolerance ? "held" : "not held", step);
        return WCUT_OK;
    }
    if (!r->design) {
        snprintf(text, (size_t)size,
                 "Fed along %s, a cut comes to %.3g mm rms at worst (%.3g mm at most) by the map: %s%s.",
                 wcut_design_feed_name(m->feed), m->predicted_rms, m->predicted_max,
                 reason ? "where it does not follow, " : "", words_of_reason(reason));
        return WCUT_OK;
    }
    const bool held = r->face_rms <= r->tolerance;
    snprintf(text, (size_t)size,
             "The cut comes to %.3g mm rms of the target (%.3g mm at most), fed along %s: the tolerance of "
             "%.3g mm rms is %s%s%s.",
             r->face_rms, r->face_max, wcut_design_feed_name(r->design->feed), r->tolerance, held ? "held" : "not held",
             held || !reason ? "" : "; ", held || !reason ? "" : words_of_reason(reason));
    return WCUT_OK;
}

/* ---- the file ---- */

static void put_design_map(wcut_text *text, const wcut_design_map *m) {
    wcut_text_print(text, ",\n  \"feed\": ");
    wcut_text_string(text, wcut_design_feed_name(m->feed));
    wcut_text_put_number(text, ",\n  \"predicted_mm\": {\"rms\": ", m->predicted_rms);
    wcut_text_put_number(text, ", \"max\": ", m->predicted_max);

    /* of feeds that were tried */
    wcut_text_print(text, "},\n  \"feeds\": [");
    bool first = true;
    for (int f = WCUT_DESIGN_FEED_PLUS_Y; f <= WCUT_DESIGN_FEED_MINUS_X; f++) {
        if (!isfinite(m->feed_rms[f])) continue;
        wcut_text_print(text, "%s{\"feed\": ", first ? "" : ", ");
        wcut_text_string(text, wcut_design_feed_name((wcut_design_feed)f));
        wcut_text_put_number(text, ", \"rms_mm\": ", m->feed_rms[f]);
        wcut_text_print(text, "}");
        first = false;
    }
    wcut_text_put_number(text, "],\n  \"domed_share\": ", m->domed_share);

    /* shares of the block's plan */
    wcut_text_print(text, ",\n  \"not_followed\": {");
    for (int r = WCUT_DESIGN_REASON_DOMED; r <= WCUT_DESIGN_REASON_PATTERN; r++) {
        wcut_text_print(text, "%s", r > WCUT_DESIGN_REASON_DOMED ? ", " : "");
        wcut_text_string(text, wcut_design_reason_name((wcut_design_reason)r));
        wcut_text_put_number(text, ": ", m->share[r]);
    }
    wcut_text_print(text, "}");
}

static void put_design_figures(wcut_text *text, const wcut_design_result *r) {
    const wcut_design *d = r->design;
    wcut_text_put_number(text, ",\n  \"design_mm\": {\"rms\": ", d->rms);
    wcut_text_put_number(text, ", \"max\": ", d->max);
    wcut_text_put_number(text, ", \"start_rms\": ", d->start_rms);
    wcut_text_put_number(text, "},\n  \"face_mm\": {\"rms\": ", r->face_rms);
    wcut_text_put_number(text, ", \"max\": ", r->face_max);
    wcut_text_put_number(text, ", \"unpolished_rms\": ", d->unpolished_rms);
    wcut_text_print(text, "},\n  \"points\": {\"used\": %d, \"strays\": %d, \"uncovered\": %d}", d->used, d->strays,
                    d->uncovered);
    wcut_text_print(text, ",\n  \"within\": %s", r->face_rms <= r->tolerance ? "true" : "false");

    /* from the target's block to the design's */
    wcut_text_print(text, ",\n  \"turn\": [");
    for (int k = 0; k < 12; k++) wcut_text_put_number(text, k ? ", " : "", d->turn[k]);
    wcut_text_print(text, "],\n  \"runs\": %d,\n  \"rounds\": [", d->runs);
    for (int k = 0; k < d->rounds; k++) {
        const wcut_design_round *one = &d->round[k];
        wcut_text_print(text, "%s\n    {\"stations\": %d, \"nodes\": %d, \"unknowns\": %d, \"runs\": %d", k ? "," : "",
                        one->stations, one->nodes, one->unknowns, one->runs);
        wcut_text_put_number(text, ", \"rms_mm\": ", one->rms);
        wcut_text_put_number(text, ", \"max_mm\": ", one->max);
        wcut_text_print(text, "}");
    }
    wcut_text_print(text, "]");
}

static void put_panels(wcut_text *text, const wcut_design_result *r) {
    const wcut_design_panels *p = r->panels;
    wcut_text_put_number(text, ",\n  \"face_mm\": {\"rms\": ", r->face_rms);
    wcut_text_put_number(text, ", \"max\": ", r->face_max);
    wcut_text_print(text,
                    "},\n  \"within\": %s,\n  \"runs\": %d,\n  \"across\": %d,\n  \"along\": %d,\n  \"panels\": [",
                    r->face_rms <= r->tolerance ? "true" : "false", p->runs, p->across, p->along);

    /* each with its place in the target's block and the turn that leads from its own block to its design's */
    for (int k = 0; k < p->count; k++) {
        const wcut_design_panel *one = &p->panel[k];
        wcut_text_put_number(text, k ? ",\n    {\"low_mm\": [" : "\n    {\"low_mm\": [", one->low.x);
        wcut_text_put_number(text, ", ", one->low.y);
        wcut_text_put_number(text, "], \"high_mm\": [", one->high.x);
        wcut_text_put_number(text, ", ", one->high.y);
        wcut_text_print(text, "], \"feed\": ");
        wcut_text_string(text, wcut_design_feed_name(one->design->feed));
        wcut_text_put_number(text, ", \"predicted_rms_mm\": ", one->predicted_rms);
        wcut_text_put_number(text, ", \"rms_mm\": ", one->design->path_rms);
        wcut_text_put_number(text, ", \"max_mm\": ", one->design->path_max);
        wcut_text_print(text, ", \"turn\": [");
        for (int n = 0; n < 12; n++) wcut_text_put_number(text, n ? ", " : "", one->design->turn[n]);
        wcut_text_print(text, "]}");
    }
    wcut_text_print(text, "],\n  \"joints\": [");
    for (int k = 0; k < p->joints; k++) {
        const wcut_design_joint *one = &p->joint[k];
        wcut_text_print(text, "%s\n    {\"panels\": [%d, %d], \"places\": %d", k ? "," : "", one->first + 1,
                        one->second + 1, one->places);
        wcut_text_put_number(text, ", \"step_mm\": {\"rms\": ", one->step_rms);
        wcut_text_put_number(text, ", \"max\": ", one->step_max);
        wcut_text_put_number(text, "}, \"angle_deg\": {\"rms\": ", one->angle_rms * WCUT_DEG_PER_RAD);
        wcut_text_put_number(text, ", \"max\": ", one->angle_max * WCUT_DEG_PER_RAD);
        wcut_text_print(text, "}}");
    }
    wcut_text_print(text, "]");
}

static wcut_status print_result(const wcut_design_result *r, char **text, size_t *length) {
    if (!r || !r->target || !r->map) return WCUT_BAD_ARGUMENT;
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;

    /* what was asked for, the map, the design */
    wcut_text_print(
        &out, "{\n  \"format\": \"wirecut-feasibility/1\",\n  \"version\": \"%s\",\n  \"target\": ", WCUT_VERSION);
    wcut_text_string(&out, r->target);
    wcut_text_put_number(&out, ",\n  \"tolerance_mm\": ", r->tolerance);
    put_design_map(&out, r->map);
    if (r->design) put_design_figures(&out, r);
    if (r->panels) put_panels(&out, r);
    wcut_text_print(&out, "\n}\n");
    return wcut_text_finish(&out, text, length);
}

wcut_status wcut_design_result_print(const wcut_design_result *result, char **text) {
    size_t length;
    return text ? print_result(result, text, &length) : WCUT_BAD_ARGUMENT;
}

wcut_status wcut_design_result_write(const wcut_design_result *result, const char *path, wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    wcut_status status = path ? print_result(result, &text, &length) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "a design: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
