/* The files of a comparison, as one set under deviation.json. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/compare.h>
#include <wirecut/write.h>

#include "base/fail.h"

int wcut_compare_files(const wcut_compare_result *result, const char *name[WCUT_COMPARE_FILES_MAX]) {
    static const char *const all[WCUT_COMPARE_FILES_MAX] = {
        "deviation.ply", "deviation_mesh.ply", "deviation_mesh.obj", "reconstruction.ply", "reconstruction.stl",
        "zones.csv",     "sections.csv",       "report.html",        "deviation.json"};
    int count = 0;
    if (!name) return 0;
    const wcut_survey_result *survey = result ? result->compared.survey : NULL;
    for (int k = 0; k < WCUT_COMPARE_FILES_MAX; k++) {
        if (result && !result->compared.reconstruction && strncmp(all[k], "reconstruction.", 15) == 0) continue;
        if (result && !(survey && survey->of->sections > 0) && strcmp(all[k], "sections.csv") == 0) continue;
        name[count++] = all[k];
    }
    return count;
}

/* a file of the set, but for deviation.ply and the voucher */
static wcut_status write_file(const wcut_compare_result *c, const char *name, const char *path, wcut_error *error) {
    const wcut_report_compare *p = &c->page;
    const wcut_mesh *scan = c->compared.reconstruction ? c->compared.reconstruction->mesh : NULL;
    if (strcmp(name, "deviation_mesh.ply") == 0)
        return wcut_deviation_mesh_write_ply(p->mesh, p->value, p->present, c->limit, path, error);
    if (strcmp(name, "deviation_mesh.obj") == 0)
        return wcut_deviation_mesh_write_obj(p->mesh, p->value, p->present, c->limit, path, error);
    if (scan && strcmp(name, "reconstruction.ply") == 0)
        return wcut_deviation_mesh_write_ply(scan, scan->scalar, NULL, c->limit, path, error);
    if (scan && strcmp(name, "reconstruction.stl") == 0) return wcut_mesh_write_stl(scan, path, error);
    if (strcmp(name, "zones.csv") == 0) return wcut_zones_write(c->compared.found, c->compared.survey, path, error);
    if (strcmp(name, "sections.csv") == 0) return wcut_sections_write(c->compared.survey, path, error);
    return wcut_report_compare_write(p, path, error);
}

static wcut_status add_compare_file(const wcut_compare_result *c, wcut_results *results, const char *name,
                                    wcut_error *error) {
    const char *path = wcut_results_path(results, name);
    wcut_status status = path ? write_file(c, name, path, error) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_results_add(results, name, error);
    if (status == WCUT_OK) return WCUT_OK;

    /* the user knows the folder, not the hidden one in it */
    wcut_results_reword(results, error);
    if (error && error->text[0]) return status;
    return wcut_fail(error, status, "%s: %s", name, wcut_status_text(status));
}

wcut_status wcut_compare_write(const wcut_compare_result *result, wcut_results *results, char **text,
                               wcut_error *error) {
    const char *name[WCUT_COMPARE_FILES_MAX];

    /* figures exist only of a comparison that streamed its points into these results */
    if (!result || !results)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a comparison and a set of results are expected");
    if (!result->streamed)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "deviation.ply: expected a comparison that was run with results");
    if (error) *error = (wcut_error){0};

    /* deviation.ply is there since the run, the voucher comes last */
    const int files = wcut_compare_files(result, name);
    wcut_status status = WCUT_OK;
    for (int k = 1; k < files - 1 && status == WCUT_OK; k++) status = add_compare_file(result, results, name[k], error);
    if (status != WCUT_OK) return status;

    /* deviation.json makes the set whole */
    char *words = NULL;
    status = wcut_deviation_print(&result->compared, &words);
    if (status == WCUT_OK)
        status = wcut_results_commit(results, name[files - 1], words, text, error);
    else
        wcut_fail(error, status, "%s: %s", name[files - 1], wcut_status_text(status));
    free(words);
    return status;
}
