/* The input that a study varies: its canonical text, and where in it the values of the parameters go. */
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/read_file.h"
#include "io/study/pointer.h"
#include "io/study/study.h"

/* the values that are taken out, and who takes them */
typedef struct cutting {
    wcut_study *study;
    const json_t **value; /* parameters; NULL: an option */
} cutting;

static bool cut_out(void *context, const json_t *value, const wcut_text *text) {
    cutting *c = context;
    for (int p = 0; p < c->study->parameters; p++) {
        if (c->value[p] != value) continue;
        c->study->parameter[p].at = text->count;
        c->study->order[c->study->places++] = p;
        return true;
    }
    return false;
}

/* a parameter's pointer leads to a value of the input, and none into another */
static bool locate_all(wcut_reader *reader, const wcut_place *at, wcut_study *study, json_t *root,
                       const json_t **value) {
    char nearest[WCUT_POINTER_SIZE];

    /* the value that each pointer leads to */
    for (int p = 0; p < study->parameters; p++) {
        const char *name = study->parameter[p].name;
        const wcut_place place = {at, name, 0, json_object_get(at->value, name)};
        if (*name == '-') continue;
        value[p] = wcut_pointer_locate(root, name);
        if (!value[p] && wcut_pointer_nearest(root, name, nearest))
            return wcut_refuse(reader, &place, WCUT_BAD_ARGUMENT,
                               "a pointer to a value of %s; it has none there, the nearest is %s", study->input[0],
                               nearest);
        if (!value[p])
            return wcut_refuse(reader, &place, WCUT_BAD_ARGUMENT, "a pointer to a value of %s", study->input[0]);

        /* two parameters must not set the same value */
        for (int q = 0; q < p; q++)
            if (wcut_pointer_overlaps(study->parameter[q].name, name))
                return wcut_refuse(reader, &place, WCUT_BAD_ARGUMENT, "a place of its own: %s holds it or lies in it",
                                   study->parameter[q].name);
    }

    /* a value of its own marks each place: true, false and null are one and the same wherever they stand */
    for (int p = 0; p < study->parameters; p++) {
        if (!value[p] || value[p] == root) continue; /* the whole input needs no mark: it is the first value */
        json_t *mark = json_object();
        value[p] = mark;
        if (!wcut_pointer_replace(root, study->parameter[p].name, mark)) return wcut_refuse_memory(reader);
    }
    return true;
}

/* A case of recordings names files relative to its own folder: they go with it into the folder of each run. */
static bool is_recorded(const json_t *root) {
    const char *format = json_string_value(json_object_get(root, "format"));
    return format && strcmp(format, "wirecut-case/1") == 0;
}

char *wcut_study_beside_input(const wcut_study *study, const char *name) {
    return wcut_path_join(study->input[0], wcut_folder_length(study->input[0]), name);
}

static bool print_template(wcut_reader *reader, const wcut_place *at, wcut_study *study, json_t *root) {
    wcut_text text;
    cutting c = {study, wcut_alloc((size_t)study->parameters, sizeof *c.value)};
    study->order = wcut_alloc((size_t)study->parameters, sizeof *study->order);
    bool whole = (c.value && study->order) || wcut_refuse_memory(reader);
    study->recorded = is_recorded(root);
    if (whole) whole = locate_all(reader, at, study, root, c.value);
    if (whole) {
        whole = wcut_text_create(&text, NULL);
        if (whole) wcut_canonical_print(&text, root, cut_out, &c);
        if (!whole || wcut_text_finish(&text, &study->canonical, NULL) != WCUT_OK) whole = wcut_refuse_memory(reader);
    }
    wcut_free(c.value);
    return whole;
}

bool wcut_study_prepare_input(wcut_reader *reader, const wcut_place *at, wcut_study *study, const char *base,
                              size_t length) {
    char *path = wcut_study_join(study, study->input[0]);
    if (!path) return wcut_refuse_memory(reader);
    wcut_reader of_input = {path, reader->error, WCUT_OK};
    json_t *root = wcut_json_load(&of_input, base, length);
    const bool whole = root && print_template(reader, at, study, root);
    if (!root) reader->status = of_input.status;
    json_decref(root);
    wcut_free(path);
    return whole;
}
