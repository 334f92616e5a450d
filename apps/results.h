/* A verb's results: the folder they go to, and what of them is wholly on disk. */
#ifndef APP_RESULTS_H
#define APP_RESULTS_H

#include <limits.h>
#include <wirecut/status.h>

enum { APP_RESULTS_MAX = 32, APP_RESULT_NAME_MAX = 64 };

typedef struct app_results {
    const char *folder;
    int count;
    const char *name[APP_RESULTS_MAX]; /* in the order written */
    char path[PATH_MAX];
} app_results;

/* Create the folder, with those above it, unless it is there and can be written to. */
int app_results_begin(app_results *results, const char *folder);

/* Where a result goes; valid until the next call. */
const char *app_results_path(app_results *results, const char *name);

/* After writing a result: note it down, or say why it is not on disk. */
int app_results_add(app_results *results, const char *name, wcut_status status, const wcut_error *error);

/* Remove a result of an earlier run, which would lie beside those of this one. */
int app_results_remove(app_results *results, const char *name);

/* Remove those of an earlier run's results that this run did not write; names are closed by NULL. */
int app_results_prune(app_results *results, const char *const *name);

/* The names written, with commas; valid until the next call. */
const char *app_results_list(const app_results *results);

#endif
