/* "wirecut-element/1" in: a job, the edges that it shares, and what is made of it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/facade/element.h"
#include "io/file/json_read.h"
#include "io/file/read_file.h"
#include "io/process/job.h"
#include "io/study/study.h"

#define FORMAT "wirecut-element/1"

const char *const wcut_border_key[4] = {"x_low", "x_high", "y_low", "y_high"};

static bool read_element_format(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    return wcut_read_format(reader, at, FORMAT);
}

/* the job by its own reader, from the text of its part */
static bool read_element_job(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_element *e = into;
    wcut_text out;
    char *text = NULL;
    size_t length = 0;
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "a job");
    if (!wcut_text_create(&out, NULL)) return wcut_refuse_memory(reader);
    wcut_canonical_print(&out, at->value, NULL, NULL);
    if (wcut_text_finish(&out, &text, &length) != WCUT_OK) return wcut_refuse_memory(reader);
    const wcut_status status = wcut_job_parse(text, length, "$.job", &e->job, reader->error);
    free(text);
    if (status != WCUT_OK) reader->status = status;
    return status == WCUT_OK;
}

static bool read_border(wcut_reader *reader, const wcut_place *at, double **border) {
    int count = 0;
    void *list = NULL;
    const bool whole = wcut_read_array(reader, at, WCUT_FACADE_SAMPLES, WCUT_FACADE_SAMPLES, "heights",
                                       wcut_read_finite, sizeof(double), &count, &list);
    *border = list;
    return whole;
}

static bool read_borders(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_element *e = into;
    if (!json_is_object(at->value) || json_object_size(at->value) != 4)
        return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object of x_low, x_high, y_low and y_high");
    for (int b = 0; b < 4; b++) {
        const wcut_place member = wcut_place_member(at, wcut_border_key[b]);
        if (!read_border(reader, &member, &e->border[b])) return false;
    }
    return true;
}

static bool read_half(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"lower", "upper", NULL};
    int found = 0;
    if (!wcut_read_word(reader, at, word, &found)) return false;
    ((wcut_element *)into)->upper = found == 1;
    return true;
}

static bool read_thickness(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_positive(reader, at, &((wcut_element *)into)->options.thickness);
}

static bool read_density(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_positive(reader, at, &((wcut_element *)into)->options.density);
}

static bool read_panel(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {{"thickness_mm", true, read_thickness, 0},
                                        {"density_kg_per_m3", false, read_density, 0},
                                        {"half", false, read_half, 0}};
    return wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, into);
}

static bool read_moulds(wcut_reader *reader, const wcut_place *at, void *into) {
    if (!json_is_boolean(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "true or false");
    ((wcut_element *)into)->options.moulds = json_is_true(at->value);
    return true;
}

static bool read_chord(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_positive(reader, at, &((wcut_element *)into)->options.chord_tolerance);
}

wcut_element_options wcut_element_options_default(void) {
    return (wcut_element_options){.density = 2000, .chord_tolerance = 0.1};
}

wcut_status wcut_element_parse(const char *text, size_t length, const char *label, wcut_element **element,
                               wcut_error *error) {
    static const wcut_field fields[] = {
        {"format", true, read_element_format, 0}, {"job", true, read_element_job, 0},
        {"border_mm", false, read_borders, 0},    {"panel", false, read_panel, 0},
        {"moulds", false, read_moulds, 0},        {"chord_tolerance_mm", false, read_chord, 0}};
    wcut_reader reader = {label, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    const wcut_place at = {NULL, NULL, 0, root};

    /* the format before all else: another format has other keys */
    const wcut_place format = wcut_place_member(&at, "format");
    wcut_element *made = wcut_alloc(1, sizeof *made);
    bool whole = made || wcut_refuse_memory(&reader);
    if (whole) made->options = wcut_element_options_default();
    if (whole && json_is_object(root)) whole = read_element_format(&reader, &format, NULL);
    if (whole) whole = wcut_read_object(&reader, &at, fields, sizeof fields / sizeof *fields, made);
    json_decref(root);
    if (!whole) {
        wcut_element_destroy(made);
        return reader.status;
    }
    *element = made;
    return WCUT_OK;
}

wcut_status wcut_element_read(const char *path, wcut_element **element, wcut_error *error) {
    if (!path || !element) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_element_read: path or element is NULL");
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_ELEMENT_BYTES_MAX, &text, &length, error);
    if (status == WCUT_OK) status = wcut_element_parse(text, length, path, element, error);
    free(text);
    return status;
}

void wcut_element_destroy(wcut_element *element) {
    if (!element) return;
    wcut_job_destroy(element->job);
    for (int b = 0; b < 4; b++) wcut_free(element->border[b]);
    wcut_free(element);
}
