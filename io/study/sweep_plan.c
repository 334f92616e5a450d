/* The plan of a sweep: study, input and the list of its cases, put into the folder that the cases go to; its lock. */
#define _XOPEN_SOURCE 700 /* realpath */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>
#include <wirecut/report.h>
#include <wirecut/results.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/read_file.h"
#include "io/file/results.h"
#include "io/study/sweep.h"
#include "io/study/sweep_table.h"

#define FORMAT "wirecut-sweep-plan/1"

static wcut_status fail_plan_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

/* ---- the lock ---- */

/* "process 4711 on node-7", as the holder wrote it */
static void read_holder(int fd, char *holder, size_t size) {
    const ssize_t n = pread(fd, holder, size - 1, 0);
    holder[n > 0 ? n : 0] = '\0';
    holder[strcspn(holder, "\n")] = '\0';
}

static void write_holder(int fd) {
    char host[64] = "", text[128];
    if (gethostname(host, sizeof host - 1) != 0) host[0] = '\0';
    const int n = snprintf(text, sizeof text, "process %ld on %s\n", (long)getpid(), host);

    /* for the words of who comes second alone: without it they name no process */
    if (ftruncate(fd, 0) == 0 && pwrite(fd, text, (size_t)n, 0) != n) (void)!ftruncate(fd, 0);
}

wcut_status wcut_sweep_lock(wcut_sweep *sweep, bool alone, wcut_error *error) {
    char holder[WCUT_QUOTE_SIZE] = "", shown[WCUT_QUOTE_SIZE], quoted[WCUT_QUOTE_SIZE];
    if (sweep->lock >= 0) return WCUT_OK;

    /* the lock file is never followed as a link */
    char *path = wcut_results_join(sweep->folder, ".sweep-lock");
    if (!path) return fail_plan_memory(error);
    const int fd = open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    const int code = errno;
    wcut_free(path);
    if (fd < 0) return wcut_fail_errno(error, WCUT_NOT_WRITTEN, code, sweep->folder, "cannot be locked");

    /* a file system without locks cannot refuse a second sweep: each case is whole or not there all the same */
    if (flock(fd, (alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        read_holder(fd, holder, sizeof holder);
        close(fd);
        return wcut_fail(error, WCUT_NOT_WRITTEN, "%s: another sweep runs there%s%s, expected it to end first",
                         wcut_quote(shown, sweep->folder, WCUT_LABEL_MAX, 1), holder[0] ? ": " : "",
                         wcut_quote(quoted, holder, WCUT_FOUND_MAX, 0));
    }

    /* the holder's name is for the message of the next one */
    write_holder(fd);
    sweep->lock = fd;
    return WCUT_OK;
}

/* ---- the files of the plan ---- */

void wcut_sweep_put_field(wcut_text *text, const char *value) {
    if (!strpbrk(value, ",\"\r\n")) {
        wcut_text_put_word(text, value);
        return;
    }
    wcut_text_put(text, "\"", 1);
    for (; *value; value++) {
        if (*value == '"') wcut_text_put(text, "\"", 1);
        wcut_text_put(text, value, 1);
    }
    wcut_text_put(text, "\"", 1);
}

void wcut_sweep_put_value(wcut_text *text, const wcut_study *study, int k, int parameter) {
    char *words = NULL;
    double number = 0;
    const json_t *value = wcut_study_value(study, k, parameter, &number);
    if (!value)
        wcut_text_number(text, number);
    else if (json_is_string(value))
        wcut_sweep_put_field(text, json_string_value(value));
    else if (wcut_study_value_print(study, k, parameter, &words) == WCUT_OK)
        wcut_sweep_put_field(text, words);
    else
        text->failed = true;
    free(words);
}

static bool put_manifest(wcut_text *text, const void *context) {
    const wcut_study *study = context;
    char hash[WCUT_STUDY_HASH_SIZE];

    /* header: number, hash, parameters */
    wcut_text_put_word(text, "case,hash");
    for (int p = 0; p < study->parameters; p++) {
        wcut_text_put(text, ",", 1);
        wcut_sweep_put_field(text, study->parameter[p].name);
    }
    wcut_text_put(text, "\n", 1);

    /* one row per case */
    for (int k = 0; k < study->info.cases && !text->failed; k++) {
        if (wcut_study_hash_eval(study, k, hash) != WCUT_OK) return false;
        wcut_text_print(text, "%d,%s", k, hash);
        for (int p = 0; p < study->parameters; p++) {
            wcut_text_put(text, ",", 1);
            wcut_sweep_put_value(text, study, k, p);
        }
        wcut_text_put(text, "\n", 1);
    }
    return !text->failed;
}

static wcut_status add_text(wcut_results *set, const char *name, const char *text, size_t length, wcut_error *error) {
    const char *path = wcut_results_path(set, name);
    if (!path) return fail_plan_memory(error);
    const wcut_status status = wcut_file_write_whole(path, text, length, error);
    return status == WCUT_OK ? wcut_results_add(set, name, error) : status;
}

static wcut_status print_plan(const wcut_study *study, const char *folder, char **text) {
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_put_string(&out, "{\n  \"format\": ", FORMAT);
    wcut_text_put_string(&out, ",\n  \"version\": ", wcut_version_text());
    wcut_text_put_string(&out, ",\n  \"name\": ", study->name);
    wcut_text_print(&out, ",\n  \"cases\": %d", study->info.cases);
    wcut_text_put_string(&out, ",\n  \"study_folder\": ", folder);
    wcut_text_put_word(&out, "\n}\n");
    return wcut_text_finish(&out, text, NULL);
}

/* where the names in the study are relative to, with a slash at its end; for free() */
static char *absolute_folder(const wcut_study *study) {
    char *real = realpath(*study->folder ? study->folder : ".", NULL);
    char *folder = real ? wcut_alloc(strlen(real) + 2, 1) : NULL;
    if (folder) {
        memcpy(folder, real, strlen(real));
        folder[strlen(real)] = '/';
    }
    free(real);
    return folder;
}

static wcut_status put_plan(wcut_results *set, const wcut_study *study, wcut_error *error) {
    char *text = NULL;
    wcut_status status = add_text(set, "study.json", study->text, study->text_length, error);
    if (status == WCUT_OK && study->base) status = add_text(set, "input.json", study->base, study->base_length, error);
    if (status == WCUT_OK) {
        const char *path = wcut_results_path(set, "manifest.csv");
        status = path ? wcut_text_write_file(path, put_manifest, study, error) : fail_plan_memory(error);
        if (status == WCUT_OK) status = wcut_results_add(set, "manifest.csv", error);
    }
    if (status == WCUT_OK && print_plan(study, study->folder, &text) != WCUT_OK) status = fail_plan_memory(error);
    if (status == WCUT_OK) status = wcut_results_commit(set, "plan.json", text, NULL, error);
    free(text);
    return status;
}

/* ---- begin and open ---- */

static wcut_status make_sweep(wcut_study *study, const char *folder, wcut_sweep **sweep, wcut_error *error) {
    wcut_sweep *made = wcut_alloc(1, sizeof *made);
    char *real = realpath(folder, NULL);
    if (made) made->folder = real ? wcut_copy_text(real) : NULL;
    free(real);
    if (!made || !made->folder) {
        wcut_free(made);
        wcut_study_destroy(study);
        return real ? fail_plan_memory(error)
                    : wcut_fail_errno(error, WCUT_NOT_FOUND, errno, folder, "cannot be found again");
    }
    made->study = study;
    made->lock = -1;
    *sweep = made;
    return WCUT_OK;
}

wcut_status wcut_sweep_plan(wcut_study *study, const char *folder, wcut_sweep **sweep, wcut_error *error) {
    static const char *const name[] = {"study.json", "input.json", "manifest.csv", "plan.json"};
    wcut_results *set = NULL;
    wcut_sweep *made = NULL;

    /* the folder, its lock, and then the plan */
    wcut_status status = wcut_results_create(folder, 4, name, &set, error);
    if (status == WCUT_OK)
        status = make_sweep(study, folder, &made, error);
    else
        wcut_study_destroy(study);
    if (status == WCUT_OK) status = wcut_sweep_lock(made, true, error);
    if (status == WCUT_OK) status = put_plan(set, made->study, error);
    wcut_results_destroy(set);
    if (status == WCUT_OK)
        *sweep = made;
    else
        wcut_sweep_destroy(made);
    return status;
}

wcut_status wcut_sweep_create(const char *path, const char *folder, wcut_sweep **sweep, wcut_error *error) {
    if (!path || !folder || !sweep || strchr(folder, '\n'))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_study *study = NULL;

    /* the study as its author wrote it */
    const wcut_status status = wcut_study_read(path, &study, error);
    if (status != WCUT_OK) return status;

    /* names stay what they are when the working folder is another one */
    char *absolute = absolute_folder(study);
    if (!absolute) {
        wcut_study_destroy(study);
        return fail_plan_memory(error);
    }
    wcut_free(study->folder);
    study->folder = absolute;
    return wcut_sweep_plan(study, folder, sweep, error);
}

/* a file of the plan into memory */
static wcut_status read_part(const char *folder, const char *name, char **text, size_t *length, wcut_error *error) {
    char *path = wcut_results_join(folder, name);
    if (!path) return fail_plan_memory(error);
    const wcut_status status = wcut_file_read(path, WCUT_STUDY_BYTES_MAX, text, length, error);
    wcut_free(path);
    return status;
}

/* what the plan says beside the study, for free(); it is of this version */
static wcut_status read_plan(const char *folder, char **study_folder, wcut_error *error) {
    char *text = NULL, label[WCUT_QUOTE_SIZE];

    /* the text of the plan, as JSON */
    size_t length = 0;
    wcut_status status = read_part(folder, "plan.json", &text, &length, error);
    if (status != WCUT_OK) return status;
    wcut_quote(label, folder, WCUT_LABEL_MAX, 1);
    wcut_reader reader = {"plan.json", error, WCUT_OK};
    json_t *root = wcut_json_load(&reader, text, length);
    free(text);
    if (!root) return reader.status;

    /* format and version must be these: a plan is run by the version that made it */
    const char *format = json_string_value(json_object_get(root, "format"));
    const char *version = json_string_value(json_object_get(root, "version"));
    const char *where = json_string_value(json_object_get(root, "study_folder"));
    if (!format || !version || !where || strcmp(format, FORMAT) != 0)
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s/plan.json: expected \"%s\"", label, FORMAT);
    else if (strcmp(version, wcut_version_text()) != 0)
        status = wcut_fail(error, WCUT_BAD_FORMAT, "%s: planned by wirecut %.20s, expected %s", label, version,
                           wcut_version_text());
    else if (!(*study_folder = wcut_copy_text(where)))
        status = fail_plan_memory(error);
    json_decref(root);
    return status;
}

/* the plan's files are those that it lists */
static wcut_status check_plan(const char *folder, wcut_error *error) {
    wcut_verification *v = NULL;
    char label[WCUT_QUOTE_SIZE];
    wcut_status status = wcut_results_verify(folder, &v, error);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < v->count && status == WCUT_OK; k++)
        if (strcmp(v->file[k].voucher, "plan.json") == 0 && v->file[k].state != WCUT_RESULT_STATE_WHOLE)
            status = wcut_fail(error, WCUT_BAD_FORMAT, "%s/%s: changed since the sweep was planned, expected it whole",
                               wcut_quote(label, folder, WCUT_LABEL_MAX, 1), v->file[k].name);
    wcut_verification_destroy(v);
    return status;
}

wcut_status wcut_sweep_read(const char *folder, wcut_sweep **sweep, wcut_error *error) {
    if (!folder || !sweep || strchr(folder, '\n'))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* plan, manifest and study, in this order: the first failure is reported */
    char *study_folder = NULL, *text = NULL, *base = NULL;
    size_t length = 0, base_length = 0;
    wcut_study *study = NULL;
    wcut_status status = read_plan(folder, &study_folder, error);
    if (status == WCUT_OK) status = check_plan(folder, error);
    if (status == WCUT_OK) status = read_part(folder, "study.json", &text, &length, error);
    if (status == WCUT_OK) {
        /* without an input of its own the study varies none */
        const wcut_status found = read_part(folder, "input.json", &base, &base_length, NULL);
        if (found != WCUT_OK && found != WCUT_NOT_FOUND)
            status = wcut_fail(error, found, "%s", wcut_status_text(found));
    }

    /* the study again, with the folder that its file names are relative to */
    if (status == WCUT_OK)
        status = wcut_study_parse(text, length, "study.json", study_folder, base, base_length, &study, error);
    if (status == WCUT_OK) status = make_sweep(study, folder, sweep, error);
    wcut_free(study_folder);
    free(text);
    free(base);
    return status;
}

void wcut_sweep_destroy(wcut_sweep *sweep) {
    if (!sweep) return;
    if (sweep->lock >= 0) close(sweep->lock);
    wcut_study_destroy(sweep->study);
    wcut_free(sweep->folder);
    wcut_free(sweep);
}

const wcut_study *wcut_sweep_view(const wcut_sweep *sweep) { return sweep ? sweep->study : NULL; }

const char *wcut_sweep_root(const wcut_sweep *sweep) { return sweep->folder; }
