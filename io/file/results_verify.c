/* A folder's files against the vouchers in it. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wirecut/report.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/journal.h"
#include "io/file/results.h"

static wcut_status fail_results_verify_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

wcut_status wcut_result_state_find(const char *folder, const char *name, const char *hash, wcut_result_state *state,
                                   wcut_error *error) {
    struct stat s;
    char found[WCUT_RESULT_HASH_SIZE];
    char *path = wcut_results_join(folder, name);
    wcut_status status = path ? WCUT_OK : fail_results_verify_memory(error);
    *state = WCUT_RESULT_STATE_CHANGED;
    if (status == WCUT_OK && lstat(path, &s) != 0)
        *state = WCUT_RESULT_STATE_MISSING;
    else if (status == WCUT_OK && S_ISREG(s.st_mode)) {
        status = wcut_file_hash(path, found, error);
        if (status == WCUT_OK && strcmp(found, hash) == 0) *state = WCUT_RESULT_STATE_WHOLE;
    }
    wcut_free(path);
    return status;
}

/* one more file of a voucher */
static wcut_status add_file(wcut_verification *v, const char *folder, const char *voucher, const char *name,
                            const json_t *hash, wcut_error *error) {
    wcut_verified_file *grown = wcut_grow(v->file, (size_t)(v->count + 1) * sizeof *grown);
    if (!grown) return fail_results_verify_memory(error);
    v->file = grown;
    wcut_verified_file *f = &v->file[v->count];
    *f = (wcut_verified_file){wcut_copy_text(voucher), wcut_copy_text(name), WCUT_RESULT_STATE_CHANGED};
    v->count++; /* destroy frees what there is of it */
    if (!f->voucher || !f->name) return fail_results_verify_memory(error);

    /* a name that leaves the folder is no file of this set */
    wcut_status status = WCUT_OK;
    if (json_is_string(hash) && wcut_result_name_is_fine(name))
        status = wcut_result_state_find(folder, name, json_string_value(hash), &f->state, error);
    v->broken += f->state != WCUT_RESULT_STATE_WHOLE;
    return status;
}

/* The JSON file NAME of a folder: its root, for json_decref, and in it the object of hashes by name; NULL where it is no
   voucher. WCUT_OK, WCUT_NO_MEMORY. */
static wcut_status load_voucher(const char *folder, const char *name, json_t **root, json_t **hashes) {
    json_error_t cause;
    memset(&cause, 0, sizeof cause);
    struct stat s;
    *root = NULL;

    /* where the voucher would be */
    char *path = wcut_results_join(folder, name);
    if (!path) return WCUT_NO_MEMORY;

    /* a pipe that is called so is no voucher, and nobody shall wait for it */
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    errno = 0;
    if (fd >= 0 && fstat(fd, &s) == 0 && S_ISREG(s.st_mode)) *root = json_loadfd(fd, JSON_REJECT_DUPLICATES, &cause);
    const int code = errno;
    if (fd >= 0) close(fd);
    wcut_free(path);
    if (!*root && code == ENOMEM) return WCUT_NO_MEMORY;
    if (!*root) return json_error_code(&cause) == json_error_out_of_memory ? WCUT_NO_MEMORY : WCUT_OK;

    /* a voucher has a list of files and their hashes */
    *hashes = json_object_get(*root, "sha256");
    if (json_is_object(*hashes) && json_is_array(json_object_get(*root, "files"))) return WCUT_OK;
    json_decref(*root);
    *root = NULL;

    return WCUT_OK;
}

static wcut_status check_voucher(wcut_verification *v, const char *folder, const char *name, wcut_error *error) {
    json_t *root, *hashes, *hash;
    const char *key;
    wcut_status status = load_voucher(folder, name, &root, &hashes);
    if (status != WCUT_OK) return fail_results_verify_memory(error);
    if (!root) return WCUT_OK;
    v->vouchers++;
    json_object_foreach(hashes, key, hash) {
        if (status == WCUT_OK) status = add_file(v, folder, name, key, hash, error);
    }
    json_decref(root);
    return status;
}

static int by_name(const void *a, const void *b) {
    const wcut_verified_file *x = a, *y = b;
    const int order = strcmp(x->voucher, y->voucher);
    return order ? order : strcmp(x->name, y->name);
}

static wcut_status check_vouchers(wcut_verification *v, const char *folder, int fd, wcut_error *error) {
    const int again = openat(fd, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = again < 0 ? NULL : fdopendir(again);
    if (!list) {
        const int code = errno;
        if (again >= 0) close(again);
        return wcut_fail_errno(error, WCUT_NOT_FOUND, code, folder, "cannot be read");
    }
    wcut_status status = WCUT_OK;
    for (struct dirent *entry = readdir(list); entry && status == WCUT_OK; entry = readdir(list)) {
        const size_t length = strlen(entry->d_name);
        if (length > 5 && strcmp(entry->d_name + length - 5, ".json") == 0)
            status = check_voucher(v, folder, entry->d_name, error);
    }
    closedir(list);
    if (status == WCUT_OK && v->count > 1) qsort(v->file, (size_t)v->count, sizeof *v->file, by_name);
    return status;
}

wcut_status wcut_results_verify(const char *folder, wcut_verification **verification, wcut_error *error) {
    if (!folder || !verification) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));

    /* the folder, held open */
    const int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) return wcut_fail_errno(error, WCUT_NOT_FOUND, errno, folder, "cannot be read");
    wcut_verification *v = wcut_alloc(1, sizeof *v);
    int locked = 0;

    /* under the lock, so that no run is half way */
    wcut_status status = v ? wcut_results_enter(folder, fd, NULL, &locked, error) : fail_results_verify_memory(error);
    if (status == WCUT_OK) status = check_vouchers(v, folder, fd, error);
    if (status == WCUT_OK && v->vouchers == 0) {
        char shown[WCUT_QUOTE_SIZE];
        status =
            wcut_fail(error, WCUT_NOT_FOUND, "%s: found no voucher, expected a JSON file with \"files\" and \"sha256\"",
                      wcut_quote(shown, folder, WCUT_LABEL_MAX, 1));
    }

    wcut_results_leave(fd, locked);
    close(fd);
    if (status == WCUT_OK)
        *verification = v;
    else
        wcut_verification_destroy(v);

    return status;
}

void wcut_verification_destroy(wcut_verification *verification) {
    if (!verification) return;
    for (int k = 0; k < verification->count; k++) {
        wcut_free(verification->file[k].voucher);
        wcut_free(verification->file[k].name);
    }
    wcut_free(verification->file);
    wcut_free(verification);
}
