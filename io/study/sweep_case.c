/* case.json: how a case of a sweep ended, what vouches for its results, and its last words. */
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/report.h>
#include <wirecut/results.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/read_file.h"
#include "io/file/results.h"
#include "io/study/sweep.h"

#define FORMAT "wirecut-sweep-case/1"

enum { RECORD_BYTES_MAX = 1 << 16, RESULT_BYTES_MAX = 256 << 20 };

static const struct {
    const char *word;
    bool final;
} state_of[] = {
#define STATE(name, word, final) {word, final},
    WCUT_SWEEP_STATE_LIST(STATE)
#undef STATE
};

const char *wcut_sweep_state_name(wcut_sweep_state state) {
    return (unsigned)state < WCUT_SWEEP_STATE_COUNT ? state_of[state].word : NULL;
}

char *wcut_sweep_folder(const wcut_sweep *sweep, const char *hash) {
    const size_t size = strlen(sweep->folder) + strlen("/cases/") + 3 + strlen(hash) + 1;
    char *path = wcut_alloc(size, 1);
    if (path) snprintf(path, size, "%s/cases/%.2s/%s", sweep->folder, hash, hash);
    return path;
}

/* ---- in ---- */

/* a JSON file of a folder; NULL: there is none that can be read. It is our own: what is wrong with it is no error, the
   case is run again. */
static json_t *load(const char *folder, const char *name, size_t max) {
    char *text = NULL, *path = wcut_results_join(folder, name);
    size_t length = 0;
    json_t *root = NULL;
    if (path && wcut_file_read(path, max, &text, &length, NULL) == WCUT_OK) {
        wcut_reader reader = {name, NULL, WCUT_OK};
        root = wcut_json_load(&reader, text, length);
    }
    free(text);
    wcut_free(path);
    return root;
}

static void copy_text(char *to, size_t size, const json_t *value) {
    const char *text = json_string_value(value);
    if (text && strlen(text) < size) memcpy(to, text, strlen(text) + 1);
}

bool wcut_sweep_record_read(const char *folder, wcut_sweep_record *record) {
    *record = (wcut_sweep_record){.state = WCUT_SWEEP_STATE_MISSING};
    json_t *root = load(folder, "case.json", RECORD_BYTES_MAX);
    const char *format = json_string_value(json_object_get(root, "format"));
    const char *state = json_string_value(json_object_get(root, "state"));
    if (format && state && strcmp(format, FORMAT) == 0)
        for (int s = 0; s < WCUT_SWEEP_STATE_COUNT; s++)
            if (strcmp(state, state_of[s].word) == 0) record->state = (wcut_sweep_state)s;
    record->seconds = json_number_value(json_object_get(root, "seconds"));
    copy_text(record->result, sizeof record->result, json_object_get(root, "result"));
    copy_text(record->hash, sizeof record->hash, json_object_get(root, "result_sha256"));
    copy_text(record->words, sizeof record->words, json_object_get(root, "words"));
    json_decref(root);
    return record->state != WCUT_SWEEP_STATE_MISSING;
}

/* the states that leave results */
static bool has_result(wcut_sweep_state state) {
    return state == WCUT_SWEEP_STATE_DONE || state == WCUT_SWEEP_STATE_OUTSIDE ||
           state == WCUT_SWEEP_STATE_NOT_CONVERGED;
}

static bool hash_fits(const char *folder, const wcut_sweep_record *record) {
    char found[WCUT_SHA256_TEXT] = "", *path = wcut_results_join(folder, record->result);
    const bool fits = path && wcut_file_hash(path, found, NULL) == WCUT_OK && strcmp(found, record->hash) == 0;
    wcut_free(path);
    return fits;
}

bool wcut_sweep_record_is_whole(const char *folder, const wcut_sweep_record *record) {
    if (!state_of[record->state].final) return false;
    if (!has_result(record->state) || !record->result[0]) return !has_result(record->state);
    wcut_verification *v = NULL;
    if (!hash_fits(folder, record) || wcut_results_verify(folder, &v, NULL) != WCUT_OK) return false;
    const bool whole = v->broken == 0;
    wcut_verification_destroy(v);
    return whole;
}

json_t *wcut_sweep_result_load(const char *folder, const wcut_sweep_record *record) {
    if (!has_result(record->state) || !record->result[0]) return NULL;
    return load(folder, record->result, RESULT_BYTES_MAX);
}

/* ---- out ---- */

/* the JSON file of the folder that vouches for the others: it has "files" and "sha256" */
static void find_result(const char *folder, wcut_sweep_record *record) {
    DIR *list = opendir(folder);
    for (struct dirent *entry = list ? readdir(list) : NULL; entry; entry = readdir(list)) {
        const size_t length = strlen(entry->d_name);
        if (length < 6 || length >= sizeof record->result || strcmp(entry->d_name + length - 5, ".json") != 0 ||
            *entry->d_name == '.' || strcmp(entry->d_name, "case.json") == 0 ||
            strcmp(entry->d_name, "input.json") == 0)
            continue;
        json_t *root = load(folder, entry->d_name, RESULT_BYTES_MAX);
        if (json_is_object(json_object_get(root, "sha256")) && json_is_array(json_object_get(root, "files")))
            memcpy(record->result, entry->d_name, length + 1);
        json_decref(root);
    }
    if (list) closedir(list);
}

static bool put_record(wcut_text *text, const void *context) {
    const wcut_sweep_record *record = context;
    wcut_text_put_string(text, "{\n  \"format\": ", FORMAT);
    wcut_text_put_string(text, ",\n  \"version\": ", wcut_version_text());
    wcut_text_put_string(text, ",\n  \"state\": ", state_of[record->state].word);
    wcut_text_print(text, ",\n  \"exit_code\": %d,\n  \"signal\": %d", record->code, record->signal);
    wcut_text_put_number(text, ",\n  \"seconds\": ", record->seconds);
    wcut_text_put_string(text, ",\n  \"result\": ", record->result);
    wcut_text_put_string(text, ",\n  \"result_sha256\": ", record->hash);
    wcut_text_put_string(text, ",\n  \"words\": ", record->words);
    wcut_text_put_word(text, "\n}\n");
    return !text->failed;
}

wcut_status wcut_sweep_record_write(const char *folder, wcut_sweep_record *record, wcut_error *error) {
    /* the voucher of the results, and its hash */
    if (has_result(record->state)) {
        find_result(folder, record);
        char *path = wcut_results_join(folder, record->result);
        if (!path) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
        const bool found = record->result[0] && wcut_file_hash(path, record->hash, NULL) == WCUT_OK;
        wcut_free(path);

        /* it said that it was done, and left nothing that vouches for it */
        if (!found) {
            record->state = WCUT_SWEEP_STATE_FAILED;
            record->result[0] = '\0';
        }
    }

    /* case.json appears whole or not at all */
    char *path = wcut_results_join(folder, "case.json");
    if (!path) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    const wcut_status status = wcut_text_write_file(path, put_record, record, error);
    wcut_free(path);
    return status;
}
