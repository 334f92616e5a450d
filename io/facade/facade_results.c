/* What came of a facade's elements: read from their folders, and compared at the joints. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/element.h"
#include "io/study/sweep.h"

enum { POINTS = WCUT_FACADE_SAMPLES * WCUT_FACADE_SAMPLES };

static double number_in(const json_t *object, const char *key) {
    const json_t *value = json_object_get(object, key);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

/* a list of `count` numbers; false: it is not one */
static bool read_result_list(const json_t *object, const char *key, int count, double *value) {
    const json_t *list = json_object_get(object, key);
    if (!json_is_array(list) || json_array_size(list) != (size_t)count) return false;
    for (int k = 0; k < count; k++) {
        value[k] = json_number_value(json_array_get(list, (size_t)k));
        if (!json_is_number(json_array_get(list, (size_t)k))) return false;
    }
    return true;
}

/* ---- an element ---- */

/* the face again, from the heights of a result; NULL: there is none, or no memory */
static wcut_element_face *load_face(const json_t *object, wcut_vec3 block) {
    double *height = wcut_alloc(POINTS, sizeof *height);
    wcut_element_face *face = NULL;
    bool whole = height && read_result_list(object, "z_mm", POINTS, height);
    if (whole) whole = wcut_element_face_interpolate(block, height, &face) == WCUT_OK;

    /* what is known of its points and borders */
    if (whole) {
        face->force = wcut_alloc(POINTS, sizeof *face->force);
        if (face->force && !read_result_list(object, "force_N_per_mm", POINTS, face->force)) {
            wcut_free(face->force);
            face->force = NULL;
        }
        whole = read_result_list(object, "moved_mm", POINTS, face->moved);
        const json_t *cut = json_object_get(object, "cut_mm");
        for (int b = 0; b < 4 && whole; b++)
            whole = read_result_list(cut, wcut_border_key[b], WCUT_FACADE_SAMPLES, face->cut[b]);
        face->moved_max = number_in(object, "moved_max_mm");
        face->fit_error = number_in(object, "fit_error_mm");
        const double radius = number_in(object, "radius_min_mm");
        face->radius_min = isfinite(radius) ? radius : INFINITY;
    }
    wcut_free(height);
    if (whole) return face;
    wcut_element_face_destroy(face);
    return NULL;
}

static void copy_reason(wcut_facade_item *item, const char *words) {
    const size_t length = words ? strlen(words) : 0;
    const size_t kept = length < sizeof item->reason ? length : sizeof item->reason - 1;
    if (words) memcpy(item->reason, words, kept);
    item->reason[kept] = '\0';
}

/* figures from the result's document */
static void fill_item(const json_t *root, wcut_facade_item *item) {
    const json_t *summary = json_object_get(root, "summary"), *face = json_object_get(root, "face");
    const json_t *speed = json_object_get(summary, "speed_mm_s"), *verdict = json_object_get(summary, "feasibility");
    const json_t *panel = json_object_get(root, "panel");
    const char *word = json_string_value(json_object_get(verdict, "verdict"));
    item->feasible = item->state == WCUT_SWEEP_STATE_DONE && word && strcmp(word, "infeasible") != 0;
    if (word && strcmp(word, "feasible") != 0) copy_reason(item, json_string_value(json_object_get(verdict, "reason")));
    item->duration = number_in(summary, "duration_s");
    item->speed_min = number_in(speed, "min"), item->speed_max = number_in(speed, "max");
    item->radius_min = number_in(face, "radius_min_mm");
    item->foam_lower = number_in(face, "volume_below_mm3"), item->foam_upper = number_in(face, "volume_above_mm3");
    item->area = number_in(face, "area_mm2");
    item->moved_max = number_in(face, "moved_max_mm");
    item->panel_volume = number_in(panel, "volume_mm3"), item->panel_mass = number_in(panel, "mass_kg");
}

/* a case of the sweep into an item and a face */
static wcut_status load_item(const wcut_sweep *sweep, int k, wcut_vec3 block, wcut_facade_item *item,
                             wcut_element_face **face) {
    wcut_sweep_record record;
    *item = (wcut_facade_item){.distinct = k};
    item->duration = item->speed_min = item->speed_max = item->radius_min = item->foam_lower = item->foam_upper = NAN;
    item->area = item->moved_max = item->panel_volume = item->panel_mass = NAN;
    if (wcut_study_hash_eval(sweep->study, k, item->hash) != WCUT_OK) return WCUT_NO_MEMORY;
    char *folder = wcut_sweep_folder(sweep, item->hash);
    if (!folder) return WCUT_NO_MEMORY;

    /* its record, then its result */
    wcut_sweep_record_read(folder, &record);
    item->state = record.state;
    json_t *root = wcut_sweep_result_load(folder, &record);
    if (root) {
        fill_item(root, item);
        *face = load_face(json_object_get(root, "face"), block);
        item->face = *face;
    }
    if (record.state != WCUT_SWEEP_STATE_DONE) copy_reason(item, record.words);
    json_decref(root);
    wcut_free(folder);
    return WCUT_OK;
}

/* ---- all of them ---- */

static wcut_status fill_results(const wcut_facade_description *d, const wcut_sweep *sweep,
                                const wcut_distinct *distinct, wcut_facade_results *r) {
    const wcut_facade *f = d->facade;
    for (int k = 0; k < f->elements; k++) {
        const int which = distinct->of[k];
        int first = 0;
        while (distinct->of[first] != which) first++;

        /* an element like an earlier one has the same result */
        wcut_status status = WCUT_OK;
        if (first < k) {
            r->item[k] = r->item[first];
        } else {
            status = load_item(sweep, which, f->element[k].job->block_size, &r->item[k], &r->face[which]);
        }
        if (status != WCUT_OK) return status;
    }

    /* the joints that have a face on both sides */
    for (int j = 0; j < f->joints; j++) {
        const wcut_facade_joint *joint = &f->joint[j];
        const wcut_element_face *a = r->item[joint->element[0]].face, *b = r->item[joint->element[1]].face;
        r->joint[j] = (wcut_joint_report){NAN, NAN, NAN, NAN, NAN};
        if (a && b && wcut_joint_eval(f, j, a, b, &r->joint[j]) != WCUT_OK) return WCUT_BAD_ARGUMENT;
    }
    return WCUT_OK;
}

wcut_status wcut_facade_results_read(const wcut_facade_description *description, const wcut_element_options *options,
                                     const wcut_sweep *sweep, wcut_facade_results **results, wcut_error *error) {
    if (!description || !options || !sweep || !results)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_distinct distinct = {0};
    wcut_status status = wcut_distinct_create(description->facade, options, &distinct, error);
    if (status != WCUT_OK) return status;
    if (distinct.count != sweep->study->info.cases) {
        wcut_distinct_clear(&distinct);
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "found a sweep of %d cases, expected that of the facade's %d distinct elements",
                         sweep->study->info.cases, distinct.count);
    }

    /* room for all of it */
    wcut_facade_results *r = wcut_alloc(1, sizeof *r);
    if (r) {
        r->description = description;
        r->distinct = distinct.count;
        r->item = wcut_alloc((size_t)description->facade->elements, sizeof *r->item);
        r->face = wcut_alloc((size_t)distinct.count, sizeof *r->face);
        r->joint = wcut_alloc((size_t)description->facade->joints, sizeof *r->joint);
    }
    status = r && r->item && r->face && r->joint ? fill_results(description, sweep, &distinct, r) : WCUT_NO_MEMORY;
    wcut_distinct_clear(&distinct);
    if (status == WCUT_OK) {
        *results = r;
        return WCUT_OK;
    }
    wcut_facade_results_destroy(r);
    return wcut_fail(error, status, "%s", wcut_status_text(status));
}

void wcut_facade_results_destroy(wcut_facade_results *results) {
    if (!results) return;
    for (int k = 0; k < results->distinct && results->face; k++) wcut_element_face_destroy(results->face[k]);
    wcut_free(results->item);
    wcut_free(results->face);
    wcut_free(results->joint);
    wcut_free(results);
}
