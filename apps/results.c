/* A verb's results: a set of files that replaces the earlier one whole, or not at all. */
#include "results.h"

#include <stdio.h>
#include <stdlib.h>

#include "command.h"
#include "terminal.h"

int app_results_begin(app_results *results, const char *folder, const char *const *names) {
    wcut_error error = {0};
    int count = 0;
    while (names && names[count]) count++;
    *results = (app_results){.folder = folder};
    const wcut_status status = wcut_results_create(folder, count, names, &results->set, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
}

const char *app_results_path(app_results *results, const char *name) {
    const char *path = wcut_results_path(results->set, name);
    results->lacks_memory = results->lacks_memory || !path;
    return path ? path : ""; /* nothing can be written there: the next add says why */
}

int app_results_add(app_results *results, const char *name, wcut_status status, const wcut_error *error) {
    wcut_error told = error ? *error : (wcut_error){0};
    if (results->lacks_memory) return app_fail_status(WCUT_NO_MEMORY, name, NULL);
    if (status == WCUT_OK) status = wcut_results_add(results->set, name, &told);
    if (status != WCUT_OK) {
        wcut_results_reword(results->set, &told);
        return app_fail_status(status, told.text[0] ? NULL : name, &told);
    }
    if (results->count < APP_RESULTS_MAX) results->name[results->count++] = name;
    return APP_DONE;
}

int app_results_commit_words(app_results *results, const char *voucher, const char *text) {
    wcut_error error = {0};
    const wcut_status status = wcut_results_commit(results->set, voucher, text, &results->text, &error);
    if (status != WCUT_OK) return app_fail_status(status, error.text[0] ? NULL : voucher, &error);
    if (results->count < APP_RESULTS_MAX) results->name[results->count++] = voucher;
    return APP_DONE;
}

int app_results_commit(app_results *results, const char *voucher, wcut_status status, char *text) {
    const int code =
        status == WCUT_OK ? app_results_commit_words(results, voucher, text) : app_fail_status(status, voucher, NULL);
    free(text);
    return code;
}

void app_results_end(app_results *results) {
    wcut_results_destroy(results->set);
    free(results->text);
    results->set = NULL;
    results->text = NULL;
}

const char *app_results_list(const app_results *results) {
    static char list[APP_RESULTS_MAX * (WCUT_RESULTS_NAME_SIZE + 2)];
    char *to = list;
    *to = 0;
    for (int i = 0; i < results->count; i++)
        to += sprintf(to, "%s%.*s", i ? ", " : "", WCUT_RESULTS_NAME_SIZE - 1, results->name[i]);
    return list;
}
