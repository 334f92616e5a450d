/* A job is read, and then the options change it. */
#include "job.h"

#include <stdio.h>
#include <wirecut/cut.h>
#include <wirecut/job_file.h>

#include "terminal.h"

static bool gives(const app_call *call, const char *option) {
    return call && app_has(call, option) && app_given(call, option);
}

/* A failure whose text does not name a file gets its name. */
static wcut_status name_place(wcut_status status, const char *path, wcut_error *error) {
    if (!error->text[0]) snprintf(error->text, sizeof error->text, "%s: %s", path, wcut_status_text(status));
    error->status = status;
    return status;
}

static wcut_status change_job(const app_call *call, const char *path, wcut_job *job, wcut_error *error) {
    if (gives(call, "nodes")) job->nodes = app_int(call, "nodes");
    if (gives(call, "cold-strength")) job->wire_cold_strength = app_real(call, "cold-strength");
    if (gives(call, "hot-strength")) job->wire_hot_strength = app_real(call, "hot-strength");
    if (gives(call, "stations")) {
        const wcut_status status = wcut_job_resample(job, app_int(call, "stations"));
        if (status != WCUT_OK) return name_place(status, path, error);
    }
    if (gives(call, "force-law")) {
        const wcut_status status = wcut_job_read_force_law(job, app_text(call, "force-law"), error);
        if (status != WCUT_OK) return name_place(status, app_text(call, "force-law"), error);
    }
    if (!gives(call, "edges")) return WCUT_OK;

    /* only a design has edges */
    const wcut_status status = wcut_job_read_edges(job, app_text(call, "edges"), error);
    if (status == WCUT_BAD_ARGUMENT)
        snprintf(error->text, sizeof error->text, "%s: --edges: expected a design, found a path", path);
    return status == WCUT_OK ? WCUT_OK : name_place(status, app_text(call, "edges"), error);
}

wcut_status app_job_read(const app_call *call, const char *path, wcut_job **job, wcut_error *error) {
    *job = NULL;
    wcut_status status = wcut_job_read(path, job, error);
    if (status != WCUT_OK) return name_place(status, path, error);
    status = change_job(call, path, *job, error);
    if (status == WCUT_OK) return WCUT_OK;

    wcut_job_destroy(*job);
    *job = NULL;
    return status;
}

/* the path that a design becomes, in its place */
static wcut_status take_path(const char *path, wcut_job **job, wcut_error *error) {
    wcut_setup *setup = NULL;
    wcut_job *driven = NULL;
    wcut_error cause = {0};
    wcut_status status = wcut_setup_create(*job, NULL, &setup, &cause);
    if (status != WCUT_OK) snprintf(error->text, sizeof error->text, "%.150s: %.300s", path, cause.text);
    if (status == WCUT_OK) {
        status = wcut_setup_path_job(setup, &driven);
        if (status == WCUT_NOT_CONVERGED)
            snprintf(error->text, sizeof error->text,
                     "%.150s: its plan ends early; wirecut simulate says where and why", path);
    }
    wcut_setup_destroy(setup);
    if (status != WCUT_OK) return name_place(status, path, error);
    wcut_job_destroy(*job);
    *job = driven;
    return WCUT_OK;
}

static wcut_status forget_job(wcut_status status, wcut_job **job) {
    if (status == WCUT_OK) return WCUT_OK;
    wcut_job_destroy(*job);
    *job = NULL;
    return status;
}

wcut_status app_job_read_path(const app_call *call, const char *path, wcut_job **job, wcut_error *error) {
    const wcut_status status = app_job_read(call, path, job, error);
    if (status != WCUT_OK || (*job)->mode == WCUT_MODE_PATH) return status;
    return forget_job(take_path(path, job, error), job);
}

wcut_status app_job_read_cut(const app_call *call, const char *path, wcut_job **job, wcut_error *error) {
    wcut_status status = app_job_read(NULL, path, job, error);
    if (status != WCUT_OK) return status;
    if ((*job)->mode == WCUT_MODE_DESIGN) status = take_path(path, job, error);
    if (status == WCUT_OK) status = change_job(call, path, *job, error);
    return forget_job(status, job);
}

int app_job_load_path(const app_call *call, const char *path, wcut_job **job) {
    wcut_error error = {0};
    const wcut_status status = app_job_read_path(call, path, job, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
}

int app_job_load(const app_call *call, const char *path, wcut_job **job) {
    wcut_error error = {0};
    const wcut_status status = app_job_read(call, path, job, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
}

int app_require_two_arms(const wcut_job *job, const char *path, const char *reason) {
    if (job->rig.kind == WCUT_RIG_KIND_TWO_ARMS) return APP_DONE;
    return app_fail(APP_BAD_INPUT, "%s: rig.kind: found %s, expected two_arms: %s", path, wcut_rig_name(job->rig.kind),
                    reason);
}
