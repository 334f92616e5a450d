/* A scan compared with the face that a job should leave, by the C API:  compare JOBS-FOLDER OUT-FOLDER */
#include <stdio.h>
#include <wirecut/wirecut.h>

static void say_doubt(const char *text, void *context) {
    (void)context;
    fprintf(stderr, "%s\n", text);
}

/* compare, and leave the files of `wirecut compare` in a folder */
static wcut_status compare(const char *job, const char *scan, const char *folder, wcut_compare_result **result,
                           wcut_error *error) {
    const wcut_compare_reference reference = {.path = job};
    const wcut_compare_scan part = {.path = scan};
    const wcut_compare_watch watch = {.warn = say_doubt};
    wcut_compare_options options = wcut_compare_options_default();
    options.method = WCUT_REGISTRATION_METHOD_FIT;
    options.tolerance = 1;

    // the set is put into its folder whole or not at all
    const char *name[WCUT_COMPARE_FILES_MAX];
    const int names = wcut_compare_files(NULL, name);
    wcut_results *set = NULL;
    wcut_status status = wcut_results_create(folder, names, name, &set, error);
    if (!status) status = wcut_compare_run(&reference, 1, &part, &options, set, &watch, result, error);
    if (!status) status = wcut_compare_write(*result, set, NULL, error);
    wcut_results_destroy(set);
    return status;
}

int main(int argc, char **argv) {
    if (argc != 3) return fprintf(stderr, "usage: compare JOBS-FOLDER OUT-FOLDER\n"), 2;
    char path[2][4096];
    snprintf(path[0], sizeof path[0], "%s/steady-400-60.json", argv[1]);
    snprintf(path[1], sizeof path[1], "%s/../scans/steady-400-60.xyz", argv[1]);

    wcut_compare_result *result = NULL;
    wcut_error error = {0}; /* says place and expectation */
    const wcut_status status = compare(path[0], path[1], argv[2], &result, &error);
    if (status) {
        fprintf(stderr, "failed: %s\n", error.text[0] ? error.text : wcut_status_text(status));
    } else {
        const wcut_deviation_summary_result *found = result->compared.found, *unmoved = result->compared.unmoved;
        printf(
            "%d deviations, RMS %.3f mm as scanned, %.3f mm after a best fit: offset %.3f, form %.3f, noise %.3f mm\n",
            found->statistics.count, unmoved->statistics.rms, found->statistics.rms, found->split.offset,
            found->split.form_rms, found->split.noise_rms);
    }
    wcut_compare_destroy(result);
    return status ? 1 : 0;
}
