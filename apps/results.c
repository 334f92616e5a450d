/* The results folder: made before the work begins, so that an hour of it does not end before a closed door. */
#include "results.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command.h"
#include "terminal.h"

static int refuse(const char *path, const char *cause) {
    return app_fail(APP_NOT_WRITTEN, "%s: %s, expected a folder to write results to", path, cause);
}

/* One folder of the way; it may be there already. */
static int make_folder(const char *path) {
    struct stat status;
    if (mkdir(path, 0777) == 0) return APP_DONE;
    int cause = errno;
    if (stat(path, &status) != 0) return refuse(path, strerror(cause));
    return S_ISDIR(status.st_mode) ? APP_DONE : refuse(path, "found a file");
}

int app_results_begin(app_results *results, const char *folder) {
    size_t length = strlen(folder);
    *results = (app_results){.folder = folder};
    if (length + 1 + APP_RESULT_NAME_MAX > sizeof results->path) return refuse(folder, strerror(ENAMETOOLONG));
    for (size_t i = 1; i <= length; i++) {
        if (folder[i] && folder[i] != '/') continue;
        memcpy(results->path, folder, i);
        results->path[i] = 0;
        int code = make_folder(results->path);
        if (code != APP_DONE) return code;
    }
    return access(folder, W_OK | X_OK) == 0 ? APP_DONE : refuse(folder, strerror(errno));
}

const char *app_results_path(app_results *results, const char *name) {
    size_t length = strlen(results->folder);
    const char *slash = length && results->folder[length - 1] == '/' ? "" : "/";
    snprintf(results->path, sizeof results->path, "%s%s%s", results->folder, slash, name);
    return results->path;
}

int app_results_add(app_results *results, const char *name, wcut_status status, const wcut_error *error) {
    if (status != WCUT_OK) return app_fail_status(status, NULL, error);
    if (results->count < APP_RESULTS_MAX) results->name[results->count++] = name;
    return APP_DONE;
}

int app_results_remove(app_results *results, const char *name) {
    const char *path = app_results_path(results, name);
    if (unlink(path) == 0 || errno == ENOENT) return APP_DONE;
    return app_fail(APP_NOT_WRITTEN, "%s: an earlier result cannot be removed: %s", path, strerror(errno));
}

int app_results_prune(app_results *results, const char *const *name) {
    for (; *name; name++) {
        int i = 0;
        while (i < results->count && strcmp(results->name[i], *name) != 0) i++;
        if (i < results->count) continue;
        int code = app_results_remove(results, *name);
        if (code != APP_DONE) return code;
    }
    return APP_DONE;
}

const char *app_results_list(const app_results *results) {
    static char list[APP_RESULTS_MAX * (APP_RESULT_NAME_MAX + 2)];
    char *to = list;
    *to = 0;
    for (int i = 0; i < results->count; i++)
        to += sprintf(to, "%s%.*s", i ? ", " : "", APP_RESULT_NAME_MAX, results->name[i]);
    return list;
}
