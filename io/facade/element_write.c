/* An element out: its input, and what came of it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/element.h"
#include "io/process/job.h"

enum { POINTS = WCUT_FACADE_SAMPLES * WCUT_FACADE_SAMPLES };

void wcut_text_put_list(wcut_text *text, const char *before, int count, const double *value) {
    wcut_text_put_word(text, before);
    for (int i = 0; i < count; i++) wcut_text_put_number(text, i ? "," : "[", value[i]);
    wcut_text_put(text, "]", 1);
}

static void put_borders(wcut_text *text, const double *const border[4]) {
    wcut_text_put_word(text, ",\n  \"border_mm\": ");
    for (int b = 0; b < 4; b++) {
        wcut_text_print(text, "%s\"%s\": ", b ? ",\n    " : "{\n    ", wcut_border_key[b]);
        wcut_text_put_list(text, "", WCUT_FACADE_SAMPLES, border[b]);
    }
    wcut_text_put_word(text, "}");
}

wcut_status wcut_element_print(const wcut_facade_element *element, const wcut_element_options *options, char **text,
                               wcut_error *error) {
    /* the job by its own writer, as a part */
    char *job = NULL;
    size_t length = 0;
    wcut_text out;
    const wcut_status status = wcut_job_print(element->job, "an element's job", &job, &length, error);
    if (status != WCUT_OK) return status;
    if (!wcut_text_create(&out, NULL)) {
        free(job);
        return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    wcut_text_put_word(&out, "{\n  \"format\": \"wirecut-element/1\",\n  \"job\": ");
    wcut_text_put(&out, job, length);
    free(job);

    /* its edges; of a panel also the half that it is cast on */
    const double *const border[4] = {element->border[0], element->border[1], element->border[2], element->border[3]};
    if (border[0]) put_borders(&out, border);
    if (options->thickness > 0) {
        wcut_text_put_number(&out, ",\n  \"panel\": {\"thickness_mm\": ", options->thickness);
        wcut_text_put_number(&out, ", \"density_kg_per_m3\": ", options->density);
        wcut_text_print(&out, ", \"half\": \"%s\"}", element->mirrored ? "upper" : "lower");
    }
    if (options->moulds) wcut_text_put_word(&out, ",\n  \"moulds\": true");
    wcut_text_put_number(&out, ",\n  \"chord_tolerance_mm\": ", options->chord_tolerance);
    wcut_text_put_word(&out, "\n}\n");
    if (wcut_text_finish(&out, text, NULL) == WCUT_OK) return WCUT_OK;
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

/* ---- the distinct ones ---- */

void wcut_distinct_clear(wcut_distinct *distinct) {
    for (int k = 0; distinct->text && k < distinct->count; k++) free(distinct->text[k]);
    wcut_free(distinct->text);
    wcut_free(distinct->of);
    *distinct = (wcut_distinct){0};
}

/* an element's text and its number */
typedef struct numbered_text {
    char *text;
    int element;
} numbered_text;

/* equal texts side by side, in the order of the elements */
static int by_text(const void *a, const void *b) {
    const numbered_text *x = a, *y = b;
    const int order = strcmp(x->text, y->text);
    return order ? order : x->element - y->element;
}

/* numbers in the order in which they first occur, and each text once */
static void number_distinct(const numbered_text *sorted, int count, wcut_distinct *d) {
    for (int i = 0; i < count; i++) {
        const bool again = i > 0 && strcmp(sorted[i].text, sorted[i - 1].text) == 0;
        d->of[sorted[i].element] = again ? d->of[sorted[i - 1].element] : sorted[i].element;
    }
    for (int k = 0; k < count; k++) {
        if (d->of[k] < k) {
            free(d->text[k]);
            d->text[k] = NULL;
            d->of[k] = d->of[d->of[k]];
        } else {
            d->text[d->count] = d->text[k];
            if (d->count < k) d->text[k] = NULL;
            d->of[k] = d->count++;
        }
    }
}

wcut_status wcut_distinct_create(const wcut_facade *facade, const wcut_element_options *options,
                                 wcut_distinct *distinct, wcut_error *error) {
    const size_t n = (size_t)facade->elements;
    wcut_distinct d = {.text = wcut_alloc(n, sizeof *d.text), .of = wcut_alloc(n, sizeof *d.of)};
    numbered_text *sorted = wcut_alloc(n, sizeof *sorted);
    wcut_status status = WCUT_OK;
    if (!d.text || !d.of || !sorted) status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));

    /* the text of every element; on failure all of them are freed */
    d.count = (int)n;
    for (int k = 0; k < d.count && status == WCUT_OK; k++) {
        status = wcut_element_print(&facade->element[k], options, &d.text[k], error);
        sorted[k] = (numbered_text){d.text[k], k};
    }
    if (status == WCUT_OK) {
        d.count = 0;
        qsort(sorted, n, sizeof *sorted, by_text);
        number_distinct(sorted, (int)n, &d);
        *distinct = d;
    } else {
        wcut_distinct_clear(&d);
    }
    wcut_free(sorted);
    return status;
}

/* ---- the result ---- */

static bool put_heights(wcut_text *text, const wcut_element_face *face) {
    double *value = wcut_alloc(POINTS, sizeof *value);
    if (!value) return false;
    for (int k = 0; k < POINTS; k++) value[k] = face->point[k].z;
    wcut_text_put_list(text, ",\n    \"z_mm\": ", POINTS, value);
    wcut_free(value);
    return true;
}

static bool put_face(wcut_text *text, const wcut_element_face *face) {
    /* its figures */
    const double block = face->block.x * face->block.y * face->block.z;
    wcut_text_put_point(text, ",\n  \"face\": {\"block_mm\": [", face->block);
    wcut_text_print(text, ", \"samples\": %d", WCUT_FACADE_SAMPLES);
    wcut_text_put_number(text, ", \"area_mm2\": ", face->area);
    wcut_text_put_number(text, ", \"volume_below_mm3\": ", face->volume);
    wcut_text_put_number(text, ", \"volume_above_mm3\": ", block - face->volume);
    wcut_text_put_number(text, ", \"radius_min_mm\": ", face->radius_min);
    wcut_text_put_number(text, ", \"moved_max_mm\": ", face->moved_max);
    wcut_text_put_number(text, ", \"fit_error_mm\": ", face->fit_error);

    /* heights at even steps of x and y, row by row along y */
    const bool whole = put_heights(text, face);
    if (face->force) wcut_text_put_list(text, ",\n    \"force_N_per_mm\": ", POINTS, face->force);
    wcut_text_put_list(text, ",\n    \"moved_mm\": ", POINTS, face->moved);
    for (int b = 0; b < 4; b++) {
        wcut_text_print(text, "%s\"%s\": ", b ? ", " : ",\n    \"cut_mm\": {", wcut_border_key[b]);
        wcut_text_put_list(text, "", WCUT_FACADE_SAMPLES, face->cut[b]);
    }
    wcut_text_put_word(text, "}}");
    return whole;
}

wcut_status wcut_element_result_print(const wcut_element *element, const wcut_setup *setup, const wcut_history *history,
                                      const wcut_element_face *face, const wcut_panel *panel, const char *refused,
                                      char **text) {
    wcut_text out;
    char *summary = NULL;
    if (!element || !setup || !history || !text) return WCUT_BAD_ARGUMENT;
    wcut_status status = wcut_summary_print(setup, history, &summary);
    if (status != WCUT_OK) return status;
    if (!wcut_text_create(&out, NULL)) {
        free(summary);
        return WCUT_NO_MEMORY;
    }

    /* the summary of the cut as wirecut simulate writes it, then the face */
    wcut_text_put_string(&out, "{\n  \"format\": \"wirecut-element-result/1\",\n  \"version\": ", wcut_version_text());
    wcut_text_print(&out, ",\n  \"half\": \"%s\",\n  \"summary\": ", element->upper ? "upper" : "lower");
    wcut_text_put_word(&out, summary);
    free(summary);
    const bool whole = !face || put_face(&out, face);
    if (refused) wcut_text_put_string(&out, ",\n  \"refused\": ", refused);

    /* the panel with its weight */
    if (panel) {
        wcut_text_put_number(&out, ",\n  \"panel\": {\"thickness_mm\": ", element->options.thickness);
        wcut_text_put_number(&out, ", \"density_kg_per_m3\": ", element->options.density);
        wcut_text_put_number(&out, ", \"volume_mm3\": ", panel->volume);
        wcut_text_put_number(&out, ", \"area_mm2\": ", panel->area);
        wcut_text_put_number(&out, ", \"mass_kg\": ", panel->volume * 1e-9 * element->options.density);
        wcut_text_print(&out, ", \"triangles\": %d}", panel->mesh->triangle_count);
    }
    wcut_text_put_word(&out, "\n}\n");
    if (!whole) out.failed = true;
    return wcut_text_finish(&out, text, NULL);
}
