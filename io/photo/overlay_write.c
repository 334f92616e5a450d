/* "wirecut-overlay/1", rills.csv and the world file: what a photograph says of a cut. */
#include <math.h>
#include <wirecut/angle.h>
#include <wirecut/cut.h>
#include <wirecut/overlay_file.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/file/text.h"

static const char *const kind_word[] = {"plane", "pinhole", "full"};

static const char *truth(bool value) { return value ? "true" : "false"; }

/* ---- the document ---- */

static void put_camera(wcut_text *text, const wcut_overlaid *o) {
    /* a plane camera has neither focal length nor place */
    const wcut_camera *c = o->camera;
    const wcut_camera_report *r = o->report;
    wcut_text_print(text, ",\n  \"camera\": {\"kind\": \"%s\"", kind_word[c->kind]);
    if (c->kind != WCUT_CAMERA_KIND_PLANE) {
        wcut_text_put_number(text, ", \"focal_px\": ", c->focal);
        wcut_text_put_number(text, ", \"focal_sigma_px\": ", r->focal_sigma);
        wcut_text_put_number(text, ", \"k1\": ", c->k1);
        wcut_text_put_number(text, ", \"k2\": ", c->k2);
        wcut_text_put_point(text, ",\n    \"centre_mm\": [", c->centre);
        wcut_text_put_word(text, ", \"rotation\": [");
        for (int k = 0; k < 9; k++)
            wcut_text_put_number(text, k == 0 ? "[" : k % 3 == 0 ? "], [" : ", ", c->rotation[k]);
        wcut_text_put_word(text, "]]");
    }

    /* errors in the picture, and the point that the others contradict */
    wcut_text_put_number(text, ",\n    \"rms_px\": ", r->rms);
    wcut_text_put_number(text, ", \"sigma_px\": ", r->sigma);
    if (r->suspect >= 0)
        wcut_text_print(text, ", \"suspect_row\": %d", r->suspect + 1);
    else
        wcut_text_put_word(text, ", \"suspect_row\": null");

    /* each point beside its image */
    wcut_text_put_word(text, ",\n    \"points\": [");
    for (size_t k = 0; k < (size_t)o->points; k++) {
        wcut_text_put_number(text, k ? ",\n      {\"pixel\": [" : "\n      {\"pixel\": [", o->point[k].u);
        wcut_text_put_number(text, ", ", o->point[k].v);
        wcut_text_put_point(text, "], \"place_mm\": [", o->point[k].place);
        wcut_text_put_number(text, ", \"residual_px\": [", o->residual[2 * k]);
        wcut_text_put_number(text, ", ", o->residual[2 * k + 1]);
        wcut_text_put_number(text, "], \"leave_one_out_px\": ", r->left_out ? o->leave_one_out[k] : (double)NAN);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "]}");
}

static void put_rills(wcut_text *text, const wcut_overlay *o) {
    /* how much of the face is readable */
    wcut_text_print(text, ",\n  \"rills\": {\"patches\": %d, \"readable\": %d", o->columns * o->rows, o->readable);
    wcut_text_put_number(text, ", \"readable_share\": ", o->readable_share);
    wcut_text_put_number(text, ", \"noise_levels\": ", o->noise);

    /* medians of the phases that have patches */
    wcut_text_put_word(text, ",\n    \"phases\": {");
    bool first = true;
    for (int k = 0; k <= WCUT_PHASE_LEFT; k++) {
        const wcut_rill_phase *p = &o->phase[k];
        if (p->patches == 0) continue;
        wcut_text_print(text, "%s\n      \"%s\": {\"patches\": %d, \"readable\": %d", first ? "" : ",",
                        wcut_phase_name((wcut_phase)k), p->patches, p->readable);
        wcut_text_put_number(text, ", \"median_deg\": ", p->readable ? WCUT_DEG_PER_RAD * p->median : (double)NAN);
        wcut_text_put_number(text, ", \"sigma_deg\": ", p->readable ? WCUT_DEG_PER_RAD * p->sigma : (double)NAN);
        wcut_text_put_word(text, "}");
        first = false;
    }

    /* those that stand out most */
    wcut_text_put_word(text, "},\n    \"worst\": [");
    for (int k = 0; k < o->worst_count; k++) {
        const wcut_rill_patch *p = &o->patch[o->worst[k]];
        wcut_text_put_point(text, k ? ",\n      {\"place_mm\": [" : "\n      {\"place_mm\": [", p->place);
        wcut_text_put_number(text, ", \"angle_deg\": ", WCUT_DEG_PER_RAD * p->angle);
        wcut_text_put_number(text, ", \"sigma_deg\": ", WCUT_DEG_PER_RAD * hypot(p->sigma, p->systematic));
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "]}");
}

static void put_curve(wcut_text *text, const wcut_rill_curve *c) {
    wcut_text_print(text, "{\"station\": %d, \"readable\": %d", c->station, c->readable);
    wcut_text_put_number(text, ", \"range_mm\": ", c->readable ? c->range : (double)NAN);
    wcut_text_put_number(text, ", \"range_sigma_mm\": ", c->readable ? c->range_sigma : (double)NAN);
    wcut_text_print(text, ", \"differs\": %s, \"nodes\": [", truth(c->differs));
    for (int k = 0; k < c->count; k++) {
        const wcut_rill_node *n = &c->node[k];
        wcut_text_put_point(text, k ? ",\n      {\"place_mm\": [" : "\n      {\"place_mm\": [", n->place);
        wcut_text_put_number(text, ", \"deviation_mm\": ", n->readable ? n->deviation : (double)NAN);
        wcut_text_put_number(text, ", \"sigma_mm\": ", n->readable ? n->sigma : (double)NAN);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "]}");
}

/* a SHA-256, or null of a file that was not hashed */
static void put_hash(wcut_text *text, const char *before, const char *hash) {
    if (hash)
        wcut_text_put_string(text, before, hash);
    else
        wcut_text_print(text, "%snull", before);
}

static bool overlay_is_whole(const wcut_overlaid *o) {
    return o && o->job && o->photo && o->source && o->camera && o->report && o->points > 0 && o->point && o->residual &&
           o->leave_one_out && o->history && o->overlay && o->overlay->rectified && o->overlay->patch;
}

wcut_status wcut_overlay_print(const wcut_overlaid *o, char **out) {
    wcut_text text = {0};
    if (!overlay_is_whole(o) || !out) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&text, NULL)) return WCUT_NO_MEMORY;

    /* the sources and the camera */
    const wcut_overlay *v = o->overlay;
    wcut_text_print(&text, "{\n  \"format\": \"wirecut-overlay/1\",\n  \"version\": \"%s\"", WCUT_VERSION);
    wcut_text_put_string(&text, ",\n  \"job\": {\"name\": ", o->job);
    put_hash(&text, ", \"sha256\": ", o->job_sha256);
    wcut_text_put_string(&text, "},\n  \"photo\": {\"name\": ", o->photo);
    put_hash(&text, ", \"sha256\": ", o->photo_sha256);
    wcut_text_print(&text, ", \"width_px\": %d, \"height_px\": %d", o->camera->width, o->camera->height);
    wcut_text_print(&text, ", \"orientation\": %d, \"bits\": %d, \"profile_ignored\": %s}", o->source->orientation,
                    o->source->depth, truth(o->source->profile));
    put_camera(&text, o);

    /* the picture from above */
    wcut_text_put_number(&text, ",\n  \"rectified\": {\"mm_per_px\": ", v->resolution);
    wcut_text_print(&text, ", \"width_px\": %d, \"height_px\": %d", v->rectified->width, v->rectified->height);
    wcut_text_put_number(&text, ", \"covered_share\": ", v->covered);
    wcut_text_put_word(&text, "}");
    put_rills(&text, v);

    /* the shape that the rills tell */
    wcut_text_print(&text, ",\n  \"curves_that_differ\": %d,\n  \"curves\": [", v->differing);
    for (int k = 0; k < v->curve_count; k++) {
        wcut_text_put_word(&text, k ? ",\n    " : "\n    ");
        put_curve(&text, &v->curve[k]);
    }
    wcut_text_put_word(&text, "]\n}\n");
    return wcut_text_finish(&text, out, NULL);
}

/* ---- rills.csv ---- */

static bool put_rill_rows(wcut_text *text, const void *context) {
    const wcut_overlay *o = context;
    wcut_text_put_word(
        text, "x_mm,y_mm,z_mm,station,wire_deg,angle_deg,sigma_deg,systematic_deg,coherence,contrast_levels,covered\n");

    /* patches that the picture shows; their place and the direction of the wire */
    for (int k = 0; k < o->columns * o->rows; k++) {
        const wcut_rill_patch *p = &o->patch[k];
        if (!(p->covered > 0)) continue;
        wcut_text_put_number(text, "", p->place.x);
        wcut_text_put_number(text, ",", p->place.y);
        wcut_text_put_number(text, ",", p->place.z);
        wcut_text_put_number(text, ",", p->station);
        wcut_text_put_number(text, ",", WCUT_DEG_PER_RAD * p->wire);

        /* what is not readable is left empty */
        if (p->readable) {
            wcut_text_put_number(text, ",", WCUT_DEG_PER_RAD * p->angle);
            wcut_text_put_number(text, ",", WCUT_DEG_PER_RAD * p->sigma);
            wcut_text_put_number(text, ",", WCUT_DEG_PER_RAD * p->systematic);
        } else {
            wcut_text_put_word(text, ",,,");
        }
        wcut_text_put_number(text, ",", p->coherence);
        wcut_text_put_number(text, ",", p->contrast);
        wcut_text_put_number(text, ",", p->covered);
        wcut_text_put_word(text, "\n");
    }
    return !text->failed;
}

wcut_status wcut_rills_write(const wcut_overlay *overlay, const char *path, wcut_error *error) {
    if (!overlay || !overlay->patch || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rills: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    return wcut_text_write_file(path, put_rill_rows, overlay, error);
}

/* ---- the world file ---- */

typedef struct world {
    double resolution, length;
} world;

/* x of a column, turns (none), y of a row, and the middle of the first pixel */
static bool put_world(wcut_text *text, const void *context) {
    const world *w = context;
    wcut_text_put_number(text, "", w->resolution);
    wcut_text_put_number(text, "\n0\n0\n", -w->resolution);
    wcut_text_put_number(text, "\n", w->resolution / 2);
    wcut_text_put_number(text, "\n", w->length - w->resolution / 2);
    wcut_text_put_word(text, "\n");
    return !text->failed;
}

wcut_status wcut_world_write(const wcut_overlay *overlay, wcut_vec3 block, const char *path, wcut_error *error) {
    if (!overlay || !path || !isfinite(block.x + block.y + block.z) || !isfinite(overlay->resolution))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "world file: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    const world w = {overlay->resolution, block.y};
    return wcut_text_write_file(path, put_world, &w, error);
}
