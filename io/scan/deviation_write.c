/* "wirecut-deviation/1" and zones.csv: what a comparison of scan and face found. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/deviation_file.h>
#include <wirecut/version.h>

#include <wirecut/angle.h>
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/text.h"

static void write_word(wcut_text *text, const char *word) { wcut_text_put(text, word, strlen(word)); }

/* "before" and a number */
static void put_number(wcut_text *text, const char *before, double value) {
    write_word(text, before);
    wcut_text_number(text, value);
}

static void put_string(wcut_text *text, const char *before, const char *value) {
    write_word(text, before);
    wcut_text_string(text, value);
}

static void put_count(wcut_text *text, const char *before, int value) { wcut_text_print(text, "%s%d", before, value); }

static void put_point(wcut_text *text, const char *before, wcut_vec3 p) {
    put_number(text, before, p.x);
    put_number(text, ", ", p.y);
    put_number(text, ", ", p.z);
    write_word(text, "]");
}

/* ---- parts of the document ---- */

static void put_scans(wcut_text *text, const wcut_compared *c) {
    put_string(text, ",\n  \"scan\": ", c->scan[0].name);
    write_word(text, ",\n  \"scans\": [");
    for (int k = 0; k < c->scans; k++) {
        put_string(text, k ? ",\n    {\"name\": " : "\n    {\"name\": ", c->scan[k].name);
        put_string(text, ", \"sha256\": ", c->scan[k].sha256);
        put_count(text, ", \"read\": ", c->scan[k].read);
        put_count(text, ", \"not_finite\": ", c->scan[k].not_finite);
        put_count(text, ", \"withheld\": ", c->scan[k].withheld);
        write_word(text, "}");
    }
    write_word(text, "]");
}

static void put_points(wcut_text *text, const wcut_compared *c) {
    int read = 0, removed = 0;
    for (int k = 0; k < c->scans; k++) read += c->scan[k].read;
    for (int k = 1; k < WCUT_REMOVAL_COUNT; k++) removed += c->removed[k];
    const int *place = c->found->place;
    put_count(text, ",\n  \"points\": {\"read\": ", read);
    put_count(text, ", \"removed\": ", removed);
    put_count(text, ", \"outside\": ", place[WCUT_PLACE_BEYOND]);
    put_count(text, ", \"ambiguous\": ", place[WCUT_PLACE_AMBIGUOUS]);
    put_count(text, ", \"used\": ", c->found->statistics.count);
    put_count(text, ", \"border\": ", place[WCUT_PLACE_BORDER]);
    put_count(text, ",\n    \"removed_as\": {\"duplicate\": ", c->removed[WCUT_REMOVAL_DUPLICATE]);
    put_count(text, ", \"isolated\": ", c->removed[WCUT_REMOVAL_ISOLATED]);
    put_count(text, ", \"outlier\": ", c->removed[WCUT_REMOVAL_OUTLIER]);
    put_count(text, ", \"thinned\": ", c->removed[WCUT_REMOVAL_THINNED]);
    write_word(text, "}}");
}

/* a figure of points that were compared, null where there were none */
static void put_known(wcut_text *text, const char *before, bool is_known, double value) {
    write_word(text, before);
    if (is_known)
        wcut_text_number(text, value);
    else
        write_word(text, "null");
}

static void put_text_or_null(wcut_text *text, const char *before, const char *string) {
    if (string)
        put_string(text, before, string);
    else
        wcut_text_print(text, "%snull", before);
}

/* the title block, and what was done to the scan before it was compared */
static void put_provenance(wcut_text *text, const wcut_compared *c) {
    put_text_or_null(text, ",\n  \"title\": {\"part\": ", c->part);
    put_text_or_null(text, ", \"inspector\": ", c->inspector);
    put_text_or_null(text, ", \"instrument\": ", c->instrument);
    put_text_or_null(text, ", \"date\": ", c->date);
    put_text_or_null(text, "},\n  \"datum_file\": ", c->datum_file);
    write_word(text, ",\n  \"cleaning\": ");

    /* what the cleaning removed */
    const wcut_clean_options *o = c->cleaning;
    if (!o) {
        write_word(text, "null");
        return;
    }

    /* each null where that removes nothing */
    write_word(text, o->duplicate >= 0 ? "{\"duplicates\": true" : "{\"duplicates\": false");
    put_known(text, ", \"isolated_mm\": ", o->radius > 0, o->radius);
    put_known(text, ", \"outlier_deviations\": ", o->neighbours > 0, o->deviations);
    put_known(text, ", \"thinned_mm\": ", o->voxel > 0, o->voxel);
    write_word(text, "}");
}

static void put_datums(wcut_text *text, int count, const wcut_datum_residual *datum) {
    write_word(text, ",\n    \"datums\": [");
    for (int k = 0; k < count; k++) {
        write_word(text, k ? ",\n      {\"kind\": " : "\n      {\"kind\": ");
        write_word(text, datum[k].is_face ? "\"face\"" : "\"point\"");
        put_count(text, ", \"number\": ", datum[k].datum + 1);
        put_point(text, ", \"moved_mm\": [", datum[k].moved);
        put_point(text, ", \"offset_mm\": [", datum[k].offset);
        put_number(text, ", \"distance_mm\": ", datum[k].distance);
        write_word(text, "}");
    }
    write_word(text, "]");
}

static void put_registration(wcut_text *text, const wcut_compared *c) {
    const wcut_registration *r = c->registration;
    static const char *const method[] = {"none", "datum", "fit"};
    static const char *const name[] = {"tx_mm", "ty_mm", "tz_mm", "rx_deg", "ry_deg", "rz_deg"};

    /* the motion as a matrix, then by its six parameters */
    put_string(text, ",\n  \"registration\": {\"method\": ", method[r->method]);
    write_word(text, ", \"matrix\": [");
    for (int k = 0; k < 16; k++) {
        write_word(text, k == 0 ? "[" : k % 4 == 0 ? "], [" : ", ");
        wcut_text_number(text, r->matrix[k]);
    }

    /* errors after and before, and what the motion turns about */
    put_number(text, "]], \"rms_mm\": ", r->rms);
    put_number(text, ", \"rms_before_mm\": ", r->rms_before);
    put_point(text, ",\n    \"pivot_mm\": [", r->pivot);
    write_word(text, ", \"parameters\": {");
    for (int k = 0; k < WCUT_DOF_COUNT; k++) {
        const double unit = k < 3 ? 1 : WCUT_DEG_PER_RAD;
        wcut_text_print(text, "%s\"%s\": {", k ? ", " : "", name[k]);
        put_number(text, "\"value\": ", r->parameter[k] * unit);
        put_number(text, ", \"sigma\": ", sqrt(r->covariance[k * WCUT_DOF_COUNT + k]) * unit);
        wcut_text_print(text, ", \"determined\": %s}", r->determined[k] ? "true" : "false");
    }

    /* how certain it is, and how much of the scan it rests on */
    write_word(text, "},\n    \"covariance_mm_rad\": [");
    for (int k = 0; k < WCUT_DOF_COUNT * WCUT_DOF_COUNT; k++) {
        write_word(text, k == 0 ? "[" : k % WCUT_DOF_COUNT == 0 ? "], [" : ", ");
        wcut_text_number(text, r->covariance[k]);
    }
    put_number(text, "]], \"overlap\": ", r->overlap);
    wcut_text_print(text, ", \"points\": %d, \"kept\": %d, \"free\": %d, \"rank\": %d", r->points, r->kept, r->free,
                    r->rank);

    /* whether another motion fits nearly as well, and how the fit ended */
    put_number(text, ", \"rival_rms_mm\": ", r->rival);
    put_count(text, ",\n    \"iterations\": ", r->iterations);
    put_number(text, ", \"step_mm\": ", r->step);
    put_number(text, ", \"standard_error_mm\": ", r->doubt);
    wcut_text_print(text, ", \"converged\": %s", r->converged ? "true" : "false");

    /* what is left of the datums */
    put_datums(text, c->datums, c->datum);
    write_word(text, "}");
}

static void put_statistics(wcut_text *text, const char *before, const wcut_statistics *s) {
    const struct {
        const char *name;
        double value;
    } figure[] = {{"mean", s->mean}, {"median", s->median}, {"std", s->std}, {"rms", s->rms},
                  {"mae", s->mae},   {"p01", s->p01},       {"p05", s->p05}, {"p95", s->p95},
                  {"p99", s->p99},   {"min", s->min},       {"max", s->max}};
    write_word(text, before);
    for (size_t k = 0; k < sizeof figure / sizeof *figure; k++) {
        wcut_text_print(text, "%s\"%s\": ", k ? ", " : "{", figure[k].name);
        put_known(text, "", s->count > 0, figure[k].value);
    }
    write_word(text, "}");
}

static void put_bands(wcut_text *text, const char *before, const wcut_statistics *s) {
    write_word(text, before);
    write_word(text, "[");
    for (int k = 0; k < s->bands; k++) {
        put_number(text, k ? ", {\"tolerance_mm\": " : "{\"tolerance_mm\": ", s->band[k]);
        put_known(text, ", \"share\": ", s->count > 0, s->within[k]);
        put_known(text, ", \"over\": ", s->count > 0, s->over[k]);
        put_known(text, ", \"under\": ", s->count > 0, s->under[k]);
        write_word(text, "}");
    }
    write_word(text, "]");
}

/* what stands beside the quantiles: parts, extremes, offset and form */
static void put_deviation_figures(wcut_text *text, const wcut_deviation_summary_result *r, const char *indent) {
    /* shares and means of positive and negative deviations */
    const wcut_statistics *s = &r->statistics;
    wcut_text_print(text, ",\n%s", indent);
    const bool any = s->count > 0;
    put_known(text, "\"positive\": {\"share\": ", any, any ? (double)s->positive / s->count : 0);
    put_known(text, ", \"mean_mm\": ", s->positive > 0, s->positive_mean);
    put_known(text, "}, \"negative\": {\"share\": ", any, any ? (double)s->negative / s->count : 0);
    put_known(text, ", \"mean_mm\": ", s->negative > 0, s->negative_mean);
    wcut_text_print(text, "},\n%s", indent);

    /* extremes: profile (ISO 1101) and Hausdorff distance */
    put_known(text, "\"profile_mm\": ", any, s->profile);
    put_known(text, ", \"hausdorff_scan_to_face_mm\": ", any, s->hausdorff);

    /* the offset and what is left of it */
    wcut_text_print(text, ",\n%s", indent);
    put_known(text, "\"kerf_offset_mm\": ", any, r->split.offset);
    put_known(text, ", \"kerf_offset_error_mm\": ", any, r->split.offset_error);
    put_known(text, ", \"form_rms_mm\": ", any, r->split.form_rms);
    put_known(text, ", \"noise_rms_mm\": ", any, r->split.noise_rms);
    put_known(text, ", \"cell_mm\": ", any, r->split.cell);
}

static void put_way_back(wcut_text *text, const wcut_compared *c) {
    put_number(text, ",\n  \"hausdorff_face_to_scan_mm\": ", c->face_to_scan->max);
    put_number(text, ", \"face_to_scan_mean_mm\": ", c->face_to_scan->mean);
    put_number(text, ", \"face_to_scan_resolution_mm\": ", c->resolution);
    if (c->unmeasured >= 0) {
        put_number(text, ",\n  \"unmeasured_mm2\": ", c->unmeasured);
        put_number(text, ", \"support_mm\": ", c->support);
    }
    if (!c->has_kerf) return;
    put_number(text, ",\n  \"kerf_mm\": {\"of_job\": ", c->kerf);
    put_number(text, ", \"by_scan\": ", c->kerf - 2 * c->found->split.offset);
    write_word(text, "}");
}

static void put_relation(wcut_text *text, const char *before, wcut_relation r) {
    put_number(text, before, r.of_deviation);
    put_number(text, ", \"of_size\": ", r.of_size);
    write_word(text, "}");
}

static void put_zones(wcut_text *text, const wcut_deviation_summary_result *r) {
    write_word(text, ",\n  \"zones\": [");

    /* zones without points are left out */
    bool first = true;
    for (int k = 0; k < r->zones; k++) {
        const wcut_zone *z = &r->zone[k];
        if (z->count == 0) continue;

        /* name, figures and box */
        put_string(text, first ? "\n    {\"name\": " : ",\n    {\"name\": ", z->name);
        put_count(text, ", \"count\": ", z->count);
        put_number(text, ", \"mean_mm\": ", z->mean);
        put_number(text, ", \"std_mm\": ", z->std);
        put_number(text, ", \"rms_mm\": ", z->rms);
        put_number(text, ", \"mae_mm\": ", z->mae);
        put_number(text, ", \"min_mm\": ", z->min);
        put_number(text, ", \"max_mm\": ", z->max);
        put_point(text, ", \"low_mm\": [", z->low);
        put_point(text, ", \"high_mm\": [", z->high);
        write_word(text, "}");
        first = false;
    }
    write_word(text, "]");
}

/* ---- zones and sections of the user ---- */

static const char *verdict_word(int passed) { return passed < 0 ? "null" : passed ? "true" : "false"; }

static void put_regions(wcut_text *text, const wcut_survey_result *s) {
    write_word(text, ",\n  \"user_zones\": [");
    for (int k = 0; k < s->of->regions; k++) {
        const wcut_region *r = &s->of->region[k];
        const wcut_region_result *f = &s->region[k];
        const bool any = f->count > 0;
        put_string(text, k ? ",\n    {\"name\": " : "\n    {\"name\": ", r->name);
        put_known(text, ", \"tolerance_mm\": ", r->tolerance > 0, r->tolerance);
        put_number(text, ", \"share\": ", r->share);
        put_count(text, ", \"count\": ", f->count);
        put_known(text, ", \"mean_mm\": ", any, f->mean);
        put_known(text, ", \"std_mm\": ", any, f->std);
        put_known(text, ", \"rms_mm\": ", any, f->rms);
        put_known(text, ", \"mae_mm\": ", any, f->mae);
        put_known(text, ", \"min_mm\": ", any, f->min);
        put_known(text, ", \"max_mm\": ", any, f->max);
        put_known(text, ", \"within\": ", any && r->tolerance > 0, f->within);
        wcut_text_print(text, ", \"passed\": %s}", verdict_word(f->passed));
    }
    write_word(text, "]");
}

static void put_sections(wcut_text *text, const wcut_survey_result *s) {
    write_word(text, ",\n  \"sections\": [");
    for (int k = 0; k < s->of->sections; k++) {
        const wcut_section *of = &s->of->section[k];
        const wcut_section_result *f = &s->section[k];
        int measured = 0;
        double squares = 0, largest = 0;
        for (int i = 0; i < f->rows; i++) {
            if (f->row[i].count == 0) continue;
            measured++;
            squares += f->row[i].deviation * f->row[i].deviation;
            largest = fmax(largest, fabs(f->row[i].deviation));
        }
        put_string(text, k ? ",\n    {\"name\": " : "\n    {\"name\": ", of->name);
        put_number(text, ", \"width_mm\": ", of->width);
        put_number(text, ", \"step_mm\": ", of->step);
        put_count(text, ", \"steps\": ", f->rows);
        put_count(text, ", \"measured\": ", measured);
        put_known(text, ", \"rms_mm\": ", measured > 0, measured ? sqrt(squares / measured) : 0);
        put_known(text, ", \"largest_mm\": ", measured > 0, largest);
        write_word(text, "}");
    }
    write_word(text, "]");
}

static void put_worst(wcut_text *text, const wcut_deviation_summary_result *r) {
    write_word(text, ",\n  \"worst\": [");
    for (int k = 0; k < r->worsts; k++) {
        const wcut_worst *w = &r->worst[k];
        put_point(text, k ? ",\n    {\"place_mm\": [" : "\n    {\"place_mm\": [", w->place);
        put_point(text, ", \"low_mm\": [", w->low);
        put_point(text, ", \"high_mm\": [", w->high);
        put_number(text, ", \"area_mm2\": ", w->area);
        put_number(text, ", \"mean_mm\": ", w->mean);
        put_number(text, ", \"peak_mm\": ", w->peak);
        put_number(text, ", \"volume_mm3\": ", w->volume);
        put_count(text, ", \"count\": ", w->count);
        write_word(text, "}");
    }
    write_word(text, "]");
}

static void put_reconstruction(wcut_text *text, const wcut_compared *c) {
    /* only where the scan was reconstructed */
    const wcut_reconstruction *r = c->reconstruction;
    if (!r) return;
    put_string(text, ",\n  \"reconstruction\": {\"method\": ", c->reconstruction_method);
    wcut_text_print(text, ", \"vertices\": %d, \"triangles\": %d", r->mesh->vertex_count, r->mesh->triangle_count);
    put_number(text, ", \"area_mm2\": ", r->area);
    put_number(text, ", \"unmeasured_mm2\": ", r->unmeasured_area);
    put_number(text, ", \"lost\": ", r->lost);
    put_number(text, ", \"farthest_mm\": ", r->farthest);
    put_number(text, ", \"spacing_mm\": ", r->spacing);
    put_number(text, ", \"smoothing_mm\": ", r->smoothing);

    /* holes, then deviations in both directions */
    write_word(text, ", \"holes\": [");
    for (int k = 0; k < r->hole_count; k++) {
        put_number(text, k ? ", {\"area_mm2\": " : "{\"area_mm2\": ", r->hole[k].area);
        put_point(text, ", \"centre_mm\": [", r->hole[k].centre);
        wcut_text_print(text, ", \"open\": %s}", r->hole[k].open ? "true" : "false");
    }
    write_word(text, "]");

    /* from the mesh of the scan to the face, and back */
    put_statistics(text, ",\n    \"scan_to_face_mm\": ", c->to_face);
    put_statistics(text, ",\n    \"face_to_scan_mm\": ", c->to_scan);
    write_word(text, "}");
}

/* ---- the document ---- */

static void put_document(wcut_text *t, const wcut_compared *c) {
    const wcut_deviation_summary_result *r = c->found;

    /* the files and what was compared */
    wcut_text_print(t, "{\n  \"format\": \"wirecut-deviation/1\",\n  \"version\": \"%s\"", WCUT_VERSION);
    put_string(t, ",\n  \"reference\": ", c->reference);
    put_string(t, ",\n  \"distance\": ", c->distance);
    put_scans(t, c);
    put_provenance(t, c);
    put_points(t, c);
    put_registration(t, c);

    /* the deviations after the registration */
    put_statistics(t, ",\n  \"distance_mm\": ", &r->statistics);
    put_deviation_figures(t, r, "  ");
    put_way_back(t, c);
    put_bands(t, ",\n  \"bands\": ", &r->statistics);

    /* the gate, where a tolerance was asked for */
    if (c->tolerance > 0) {
        put_number(t, ",\n  \"gate\": {\"tolerance_mm\": ", c->tolerance);
        put_number(t, ", \"share\": ", c->share);
        wcut_text_print(t, ", \"within\": %s}", c->within ? "true" : "false");
    }

    /* the deviations before the registration */
    put_statistics(t, ",\n  \"as_scanned\": {\"distance_mm\": ", &c->unmoved->statistics);
    put_bands(t, ", \"bands\": ", &c->unmoved->statistics);
    put_count(t, ", \"outside\": ", c->unmoved->place[WCUT_PLACE_BEYOND]);
    put_deviation_figures(t, c->unmoved, "    ");
    write_word(t, "}");

    /* what they go with, where a job tells */
    if (r->related) {
        put_relation(t, ",\n  \"correlation\": {\"time_since_entry\": {\"of_deviation\": ", r->time);
        put_relation(t, ", \"path_curvature\": {\"of_deviation\": ", r->path);
        put_relation(t, ", \"face_curvature\": {\"of_deviation\": ", r->bend);
        write_word(t, "}");
    }

    /* zones, worst areas, and the reconstruction at the end */
    put_zones(t, r);
    if (c->survey) {
        put_string(t, ",\n  \"zones_file\": ", c->zones_file ? c->zones_file : "");
        put_regions(t, c->survey);
        put_sections(t, c->survey);
    }
    put_worst(t, r);
    put_reconstruction(t, c);
    wcut_text_print(t, "\n}\n");
}

static bool are_figures(const wcut_statistics *s) { return s && s->bands >= 0 && s->bands <= WCUT_BANDS_MAX; }

static bool is_usable(const wcut_compared *c) {
    if (!c || !c->reference || !c->distance || c->scans < 1 || !c->scan || !c->registration || !c->found ||
        !c->unmoved || !are_figures(c->face_to_scan) ||
        (unsigned)c->registration->method > WCUT_REGISTRATION_METHOD_FIT ||
        (c->reconstruction && (!c->reconstruction_method || !c->to_scan || !c->to_face)))
        return false;
    for (int k = 0; k < c->scans; k++)
        if (!c->scan[k].name || !c->scan[k].sha256) return false;
    return are_figures(&c->found->statistics) && are_figures(&c->unmoved->statistics);
}

wcut_status wcut_deviation_print(const wcut_compared *compared, char **text) {
    wcut_text out;
    if (!is_usable(compared) || !text) return WCUT_BAD_ARGUMENT;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    put_document(&out, compared);
    return wcut_text_finish(&out, text, NULL);
}

wcut_status wcut_deviation_write(const wcut_compared *compared, const char *path, wcut_error *error) {
    char *text = NULL;
    wcut_status status = path ? wcut_deviation_print(compared, &text) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "a comparison: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, strlen(text), error);
    free(text);
    return status;
}

/* ---- zones.csv ---- */

static void put_zone(wcut_text *t, const wcut_zone *z, int bands) {
    wcut_text_print(t, "%s,%s,%d", z->name, z->is_patch ? "patch" : "phase", z->count);
    const double figure[] = {z->mean, z->std, z->rms, z->mae, z->min, z->max};
    for (size_t k = 0; k < sizeof figure / sizeof *figure; k++) {
        write_word(t, ",");
        if (z->count > 0) wcut_text_number(t, figure[k]);
    }
    const double side[] = {z->low.x, z->high.x, z->low.y, z->high.y};
    for (size_t k = 0; k < sizeof side / sizeof *side; k++) {
        write_word(t, ",");
        if (z->count > 0 || z->is_patch) wcut_text_number(t, side[k]);
    }
    for (int k = 0; k < bands; k++) {
        write_word(t, ",");
        if (z->count > 0) wcut_text_number(t, z->within[k]);
    }
    write_word(t, ",,,,\n");
}

/* a zone of the user: its box where it has one, and behind the bands its tolerance and verdict */
static void put_user_zone(wcut_text *t, const wcut_region *r, const wcut_region_result *f, int bands) {
    const bool any = f->count > 0;
    wcut_text_print(t, "%s,user,%d", r->name, f->count);
    const double figure[] = {f->mean, f->std, f->rms, f->mae, f->min, f->max};
    for (size_t k = 0; k < sizeof figure / sizeof *figure; k++) {
        write_word(t, ",");
        if (any) wcut_text_number(t, figure[k]);
    }
    const double side[] = {r->low.x, r->high.x, r->low.y, r->high.y};
    for (size_t k = 0; k < sizeof side / sizeof *side; k++) {
        write_word(t, ",");
        wcut_text_number(t, side[k]);
    }
    for (int k = 0; k < bands; k++) {
        write_word(t, ",");
        if (any) wcut_text_number(t, f->within_band[k]);
    }
    write_word(t, ",");
    if (r->tolerance > 0) wcut_text_number(t, r->tolerance);
    put_number(t, ",", r->share);
    write_word(t, ",");
    if (any && r->tolerance > 0) wcut_text_number(t, f->within);
    wcut_text_print(t, ",%s\n", f->passed < 0 ? "" : f->passed ? "pass" : "fail");
}

wcut_status wcut_zones_write(const wcut_deviation_summary_result *found, const wcut_survey_result *survey,
                             const char *path, wcut_error *error) {
    wcut_text t;
    if (!found || !path || found->zones < 0 || !are_figures(&found->statistics) || (found->zones > 0 && !found->zone) ||
        (survey && survey->bands != found->statistics.bands))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "zones: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    if (!wcut_text_create(&t, NULL)) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    write_word(&t, "zone,kind,count,mean_mm,std_mm,rms_mm,mae_mm,min_mm,max_mm,x_low_mm,x_high_mm,y_low_mm,y_high_mm");
    for (int k = 0; k < found->statistics.bands; k++) put_number(&t, ",within_mm_", found->statistics.band[k]);
    write_word(&t, ",tolerance_mm,share_required,share_within,verdict\n");
    for (int k = 0; k < found->zones; k++) put_zone(&t, &found->zone[k], found->statistics.bands);
    for (int k = 0; survey && k < survey->of->regions; k++)
        put_user_zone(&t, &survey->of->region[k], &survey->region[k], found->statistics.bands);
    char *text = NULL;
    wcut_status status = wcut_text_finish(&t, &text, NULL);
    if (status != WCUT_OK) return wcut_fail(error, status, "zones: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, strlen(text), error);
    free(text);
    return status;
}
