/* "wirecut-study/1": what is varied, how it is combined, what runs, and what is collected. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/report.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/read_file.h"
#include "io/file/utf8.h"
#include "io/process/case.h"
#include "io/study/pointer.h"
#include "io/study/study.h"

#define FORMAT "wirecut-study/1"

/* ---- values ---- */

static bool read_format(wcut_reader *reader, const wcut_place *at, void *into) {
    (void)into;
    const char *format = json_string_value(at->value);
    return (format && strcmp(format, FORMAT) == 0) || wcut_refuse(reader, at, WCUT_BAD_FORMAT, "\"" FORMAT "\"");
}

static bool read_study_name(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, &((wcut_study *)into)->name);
}

static bool read_verb(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_study *study = into;
    if (!wcut_read_text(reader, at, &study->verb)) return false;
    return (*study->verb >= 'a' && *study->verb <= 'z' && strcmp(study->verb, "sweep") != 0) ||
           wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a verb of the command, other than sweep");
}

/* a file's name: an input, a CSV of rows */
static bool read_file_name(wcut_reader *reader, const wcut_place *at, char **into) {
    if (!wcut_read_text(reader, at, into)) return false;
    return (**into && **into != '-') || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "a file's name, without - in front");
}

/* the file that is varied, or a list that it begins */
static bool read_input(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_study *study = into;
    const size_t n = json_is_array(at->value) ? json_array_size(at->value) : 1;
    if (n < 1 || n > WCUT_STUDY_INPUTS_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "1 to %d names of files", WCUT_STUDY_INPUTS_MAX);
    study->input = wcut_alloc(n, sizeof *study->input);
    if (!study->input) return wcut_refuse_memory(reader);
    if (!json_is_array(at->value)) return read_file_name(reader, at, &study->input[study->inputs++]);
    for (size_t i = 0; i < n; i++) {
        const wcut_place item = {at, NULL, i, json_array_get(at->value, i)};
        if (!read_file_name(reader, &item, &study->input[study->inputs++])) return false;
    }
    return true;
}

static bool read_options(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_study *study = into;
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object");
    for (void *i = json_object_iter((json_t *)at->value); i; i = json_object_iter_next((json_t *)at->value, i)) {
        const wcut_place member = {at, json_object_iter_key(i), 0, json_object_iter_value(i)};
        if (!*member.key || strspn(member.key, "abcdefghijklmnopqrstuvwxyz-") != strlen(member.key) ||
            *member.key == '-')
            return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "names of options without their dashes");
        if (json_is_object(member.value) || json_is_array(member.value) || json_is_null(member.value))
            return wcut_refuse(reader, &member, WCUT_BAD_FORMAT, "a number, a text, true or false");
        if (json_is_string(member.value) && !wcut_utf8_is_plain(json_string_value(member.value)))
            return wcut_refuse(reader, &member, WCUT_BAD_FORMAT, "a text without control characters");
    }
    study->options = json_incref((json_t *)at->value);
    return true;
}

static bool read_combine(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"grid", "zip", "rows", "latin_hypercube", "sobol", NULL};
    int found = 0;
    if (!wcut_read_word(reader, at, word, &found)) return false;
    ((wcut_study *)into)->combine = (wcut_combine)found;
    return true;
}

static bool read_cases(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 1, WCUT_STUDY_CASES_MAX, &((wcut_study *)into)->asked);
}

static bool read_seed(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_int(reader, at, 0, INT32_MAX, &((wcut_study *)into)->seed);
}

static bool read_rows(wcut_reader *reader, const wcut_place *at, void *into) {
    return read_file_name(reader, at, &((wcut_study *)into)->rows);
}

static bool read_parameters(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_study *study = into;
    if (!at->value && study->rows) return wcut_study_read_rows(reader, at, study);
    return wcut_study_read_parameters(reader, at, study);
}

/* ---- figures ---- */

static bool read_figures(wcut_reader *reader, const wcut_place *at, void *into) {
    wcut_study *study = into;

    /* limits before memory */
    const size_t n = json_object_size(at->value);
    if (!json_is_object(at->value)) return wcut_refuse(reader, at, WCUT_BAD_FORMAT, "an object");
    if (n < 1 || n > WCUT_STUDY_FIGURES_MAX)
        return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "1 to %d figures", WCUT_STUDY_FIGURES_MAX);
    study->figure = wcut_alloc(n, sizeof *study->figure);
    study->pointer = wcut_alloc(n, sizeof *study->pointer);
    if (!study->figure || !study->pointer) return wcut_refuse_memory(reader);

    /* a name and a JSON pointer into the result, each checked when the study is read */
    for (void *i = json_object_iter((json_t *)at->value); i; i = json_object_iter_next((json_t *)at->value, i)) {
        const wcut_place member = {at, json_object_iter_key(i), 0, json_object_iter_value(i)};
        const int f = study->figures++;
        study->figure[f] = wcut_copy_text(member.key);
        if (!study->figure[f]) return wcut_refuse_memory(reader);
        if (!*member.key || !wcut_utf8_is_plain(member.key))
            return wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "names of figures without control characters");
        if (!wcut_read_text(reader, &member, &study->pointer[f])) return false;
        if (!*study->pointer[f] || !wcut_pointer_is_valid(study->pointer[f]))
            return wcut_refuse(reader, &member, WCUT_BAD_ARGUMENT, "a JSON pointer, such as /duration_s");
    }
    return true;
}

static bool read_goal(wcut_reader *reader, const wcut_place *at, void *into) {
    static const char *const word[] = {"lowest", "highest", NULL};
    int found = 0;
    if (!wcut_read_word(reader, at, word, &found)) return false;
    ((wcut_study *)into)->highest = found == 1;
    return true;
}

static bool read_best_figure(wcut_reader *reader, const wcut_place *at, void *into) {
    return wcut_read_text(reader, at, &((wcut_study *)into)->best);
}

static bool read_best(wcut_reader *reader, const wcut_place *at, void *into) {
    static const wcut_field fields[] = {{"figure", true, read_best_figure, 0}, {"goal", true, read_goal, 0}};
    wcut_study *study = into;
    if (!wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, study)) return false;
    for (int f = 0; f < study->figures; f++)
        if (strcmp(study->best, study->figure[f]) == 0) study->info.best = f;
    return study->info.best >= 0 || wcut_refuse(reader, at, WCUT_BAD_ARGUMENT, "\"figure\" one of \"figures\"");
}

/* ---- files that cases use as they are ---- */

static wcut_status add_study_file(wcut_study *study, const char *name, wcut_error *error) {
    wcut_study_file *grown = wcut_grow(study->file, (size_t)(study->files + 1) * sizeof *grown);
    if (!grown) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    study->file = grown;
    char *path = wcut_study_join(study, name), *own = wcut_copy_text(name);
    wcut_status status = path && own ? wcut_file_hash(path, study->file[study->files].hash, error)
                                     : wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    wcut_free(path);

    /* a file that cannot be read is not in the list */
    if (status == WCUT_OK)
        study->file[study->files++].name = own;
    else
        wcut_free(own);
    return status;
}

/* a text that is a file's name: its content is a part of the case. Others are words. */
static wcut_status add_if_file(wcut_study *study, const char *name, wcut_error *error) {
    if (!name || !*name) return WCUT_OK;
    for (int i = 0; i < study->files; i++)
        if (strcmp(study->file[i].name, name) == 0) return WCUT_OK;
    const wcut_status status = add_study_file(study, name, NULL);
    return status == WCUT_NOT_FOUND ? WCUT_OK
           : status == WCUT_OK      ? WCUT_OK
                                    : wcut_fail(error, status, "%s", wcut_status_text(status));
}

/* a file that a recorded case names, or may name as a value of a parameter */
static wcut_status add_beside_input(wcut_study *study, const char *name, wcut_error *error) {
    char *path = wcut_study_beside_input(study, name);
    if (!path) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    const wcut_status status = add_if_file(study, path, error);
    wcut_free(path);
    return status;
}

/* the files of a recorded case: those of its own text, and those that parameters put in their place */
static wcut_status hash_recorded(wcut_study *study, wcut_error *error) {
    wcut_case *found = NULL;
    char *path = wcut_study_join(study, study->input[0]);
    if (!path) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    const size_t folder = wcut_folder_length(path);
    wcut_status status = wcut_case_parse(study->base, study->base_length, path, &found, error);
    wcut_free(path);
    for (int i = 0; status == WCUT_OK && wcut_case_file(found, i); i++)
        status = add_beside_input(study, wcut_case_file(found, i) + folder, error);
    wcut_case_destroy(found);

    /* texts of the parameters that are pointers */
    for (int p = 0; p < study->parameters; p++)
        for (size_t i = 0; *study->parameter[p].name == '/' && i < json_array_size(study->parameter[p].list); i++) {
            const char *name = json_string_value(json_array_get(study->parameter[p].list, i));
            if (name && *name && status == WCUT_OK) status = add_beside_input(study, name, error);
        }
    return status;
}

static wcut_status hash_files(wcut_study *study, wcut_error *error) {
    wcut_status status = WCUT_OK;
    for (int i = study->canonical ? 1 : 0; i < study->inputs && status == WCUT_OK; i++)
        status = add_study_file(study, study->input[i], error);
    for (void *i = json_object_iter(study->options); i && status == WCUT_OK;
         i = json_object_iter_next(study->options, i))
        status = add_if_file(study, json_string_value(json_object_iter_value(i)), error);
    for (int p = 0; p < study->parameters; p++)
        for (size_t i = 0; *study->parameter[p].name == '-' && i < json_array_size(study->parameter[p].list); i++)
            if (status == WCUT_OK)
                status = add_if_file(study, json_string_value(json_array_get(study->parameter[p].list, i)), error);
    return status == WCUT_OK && study->recorded ? hash_recorded(study, error) : status;
}

/* ---- the whole ---- */

char *wcut_study_join(const wcut_study *study, const char *name) {
    return wcut_path_join(study->folder, *name == '/' ? 0 : strlen(study->folder), name);
}

/* parameters stand in the file, or are the columns of the rows' file, but not both */
static bool check_rows(wcut_reader *reader, const wcut_place *at, const wcut_study *study) {
    const wcut_place rows = wcut_place_member(at, "rows"), parameters = wcut_place_member(at, "parameters");
    if (study->combine != WCUT_COMBINE_ROWS)
        return !rows.value ||
               wcut_refuse(reader, &rows, WCUT_BAD_ARGUMENT, "no \"rows\" unless \"combine\" is \"rows\"");
    if (!rows.value) return wcut_refuse(reader, &rows, WCUT_BAD_FORMAT, "the name of a CSV file");
    return !parameters.value ||
           wcut_refuse(reader, &parameters, WCUT_BAD_ARGUMENT, "no \"parameters\": they are the columns of \"rows\"");
}

static bool has_pointer(const wcut_study *study) {
    for (int p = 0; p < study->parameters; p++)
        if (*study->parameter[p].name != '-') return true;
    return false;
}

/* the input that is varied: as the caller has it, or by its name */
static bool take_input(wcut_reader *reader, const wcut_place *at, wcut_study *study, const char *base, size_t length) {
    if (!has_pointer(study)) return true;
    char *text = NULL, *path = base ? NULL : wcut_study_join(study, study->input[0]);
    if (!base && !path) return wcut_refuse_memory(reader);
    if (!base) {
        reader->status = wcut_file_read(path, WCUT_STUDY_BYTES_MAX, &text, &length, reader->error);
        wcut_free(path);
        if (reader->status != WCUT_OK) return false;
    } else {
        text = wcut_copy(base, length + 1, 1);
        if (!text) return wcut_refuse_memory(reader);
    }
    study->base = text;
    study->base_length = length;
    const wcut_place parameters = wcut_place_member(at, study->rows ? "rows" : "parameters");
    return wcut_study_prepare_input(reader, &parameters, study, text, length);
}

static bool read_study(wcut_reader *reader, const wcut_place *at, wcut_study *study, const char *base, size_t length) {
    static const wcut_field fields[] = {{"format", true, read_format, 0},    {"name", true, read_study_name, 0},
                                        {"verb", true, read_verb, 0},        {"input", true, read_input, 0},
                                        {"options", false, read_options, 0}, {"combine", false, read_combine, 0},
                                        {"cases", false, read_cases, 0},     {"seed", false, read_seed, 0},
                                        {"rows", false, read_rows, 0},       {"figures", true, read_figures, 0},
                                        {"best", false, read_best, 0},       {"parameters", false, read_parameters, 0}};
    /* the format before all else: another format has other keys */
    const wcut_place format = wcut_place_member(at, "format");
    if (json_is_object(at->value) && !read_format(reader, &format, NULL)) return false;
    if (!wcut_read_object(reader, at, fields, sizeof fields / sizeof *fields, study)) return false;
    if (!check_rows(reader, at, study)) return false;
    if (study->parameters == 0) {
        const wcut_place parameters = wcut_place_member(at, "parameters");
        if (!read_parameters(reader, &parameters, study)) return false;
    }
    const wcut_place combine = wcut_place_member(at, "combine");
    return take_input(reader, at, study, base, length) && wcut_study_combine(reader, &combine, study);
}

static void fill_info(wcut_study *study) {
    wcut_study_info *info = &study->info;
    for (int p = 0; p < study->parameters; p++) study->parameter_name[p] = study->parameter[p].name;
    info->name = study->name;
    info->verb = study->verb;
    info->parameters = study->parameters;
    info->parameter = study->parameter_name;
    info->figures = study->figures;
    info->figure = (const char *const *)study->figure;
    info->pointer = (const char *const *)study->pointer;
    info->best_is_highest = study->highest;
}

wcut_status wcut_study_parse(const char *text, size_t length, const char *label, const char *folder, const char *base,
                             size_t base_length, wcut_study **study, wcut_error *error) {
    wcut_reader reader = {label, error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    if (!root) return reader.status;
    const wcut_place at = {NULL, NULL, 0, root};

    /* an empty study that keeps its text */
    wcut_study *made = wcut_alloc(1, sizeof *made);
    bool whole = made != NULL;
    if (whole) {
        made->info.best = -1;
        made->folder = wcut_copy_text(folder);
        made->text = wcut_copy(text, length + 1, 1);
        made->text_length = length;
        whole = made->folder && made->text;
    }

    /* the document, then the files that it names */
    if (!whole) wcut_refuse_memory(&reader);
    if (whole) whole = read_study(&reader, &at, made, base, base_length);
    json_decref(root);

    /* the caller gets a whole study or none */
    if (whole) reader.status = hash_files(made, error);
    if (whole && reader.status == WCUT_OK) {
        fill_info(made);
        *study = made;
        return WCUT_OK;
    }
    wcut_study_destroy(made);
    return reader.status;
}

wcut_status wcut_study_read(const char *path, wcut_study **study, wcut_error *error) {
    if (!path || !study) return wcut_fail(error, WCUT_BAD_ARGUMENT, "wcut_study_read: path or study is NULL");

    /* the text, at most WCUT_STUDY_BYTES_MAX bytes */
    char *text = NULL;
    size_t length = 0;
    wcut_status status = wcut_file_read(path, WCUT_STUDY_BYTES_MAX, &text, &length, error);
    if (status != WCUT_OK) return status;

    /* its folder, with the slash */
    char *folder = wcut_path_join(path, wcut_folder_length(path), "");
    if (folder) {
        status = wcut_study_parse(text, length, path, folder, NULL, 0, study, error);
    } else {
        status = wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    }
    wcut_free(folder);
    free(text);
    return status;
}

static void free_texts(int count, char **text) {
    for (int i = 0; i < count && text; i++) wcut_free(text[i]);
    wcut_free(text);
}

void wcut_study_destroy(wcut_study *study) {
    if (!study) return;

    /* parameters own their lists */
    for (int p = 0; p < study->parameters && study->parameter; p++) {
        json_decref(study->parameter[p].list);
        wcut_free(study->parameter[p].name);
        wcut_free(study->parameter[p].interval);
    }

    /* lists of texts, then single allocations; JSON by its reference count */
    free_texts(study->inputs, study->input);
    free_texts(study->figures, study->figure);
    free_texts(study->figures, study->pointer);
    json_decref(study->options);

    for (int i = 0; i < study->files; i++) wcut_free(study->file[i].name);

    /* arrays and texts */
    wcut_free(study->parameter);
    wcut_free(study->parameter_name);
    wcut_free(study->folder);
    wcut_free(study->name);
    wcut_free(study->verb);
    wcut_free(study->rows);
    wcut_free(study->best);
    free(study->canonical);
    wcut_free(study->order);
    wcut_free(study->file);
    wcut_free(study->text);
    wcut_free(study->base);
    wcut_free(study);
}

const wcut_study_info *wcut_study_view(const wcut_study *study) { return study ? &study->info : NULL; }
