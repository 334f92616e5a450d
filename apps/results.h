/* A verb's results: a set of files that replaces the earlier one whole, or not at all. */
#ifndef APP_RESULTS_H
#define APP_RESULTS_H

#include <stdbool.h>
#include <wirecut/results.h>
#include <wirecut/status.h>

enum { APP_RESULTS_MAX = 64 };

typedef struct app_results {
    const char *folder;
    wcut_results *set;
    int count;
    const char *name[APP_RESULTS_MAX]; /* in the order written, the voucher last once it is committed */
    bool lacks_memory;                 /* for the path of a result */
    char *text;                        /* the voucher as it stands on disk; NULL before */
} app_results;

/* Begin a set in a folder, which is made with those above it: before the work, so that an hour of it does not end
   before a closed door. names: those that the run may write, closed by NULL. */
int app_results_begin(app_results *results, const char *folder, const char *const *names);

/* Where a result is written; valid until the next call. */
const char *app_results_path(app_results *results, const char *name);

/* After writing a result: take it into the set, or say why it is not on disk. The name is borrowed. */
int app_results_add(app_results *results, const char *name, wcut_status status, const wcut_error *error);

/* Put the set into its folder under a voucher: its text, which is freed, and the status of printing that. */
int app_results_commit(app_results *results, const char *voucher, wcut_status status, char *text);

/* The same with a text that is a constant. */
int app_results_commit_words(app_results *results, const char *voucher, const char *text);

/* Free the set; what was not committed is removed, and the folder has its earlier files. */
void app_results_end(app_results *results);

/* The names written, with commas; valid until the next call. */
const char *app_results_list(const app_results *results);

#endif
