/* wirecut apply: what a diagnosis found, put into any job. */
#include <math.h>
#include <stdio.h>
#include <wirecut/correction.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "terminal.h"

static void say_apply_summary(const wcut_correction *c, const wcut_job *was, const char *path) {
    app_say("a %.6g -> %.6g N/mm, b %.6g -> %.6g m2/J", was->force_law.a, c->a, was->force_law.b, c->b);
    if (was->mode == WCUT_MODE_PATH)
        app_say("wire %.6g -> %.6g mm", was->wire_length, was->wire_length + c->length_change);
    if (isfinite(c->kerf)) app_say("kerf %.4g -> %.4g mm", was->kerf_width, c->kerf);
    for (int e = 0; e < c->effects; e++) app_say("with %s", wcut_effect_view(c->effect[e].kind)->name);
    app_say("%s", path);
}

static void print_apply_json(const wcut_correction *c, const char *path) {
    printf("{\"format\": \"wirecut-apply/1\", \"job\": \"%s\", \"effects\": [", path);
    for (int e = 0; e < c->effects; e++) printf("%s\"%s\"", e ? ", " : "", wcut_effect_view(c->effect[e].kind)->name);
    printf("]}\n");
}

static int apply(const app_call *call) {
    /* the correction and the job that gets it */
    const char *path = app_text(call, "output");
    wcut_correction correction;
    wcut_error error = {0};
    wcut_job *job = NULL;
    wcut_status status = wcut_correction_read(call->operand[0], &correction, &error);
    if (status == WCUT_OK) status = wcut_job_read(call->operand[1], &job, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    const wcut_job was = *job; /* numbers alone: its arrays may be gone below */
    status = wcut_correction_apply(&correction, job, &error);
    int code = status == WCUT_OK ? APP_DONE : app_fail_status(status, call->operand[1], &error);

    /* the job is written under its new name */
    if (code == APP_DONE) {
        status = wcut_job_write(job, path, &error);
        if (status != WCUT_OK) code = app_fail_status(status, NULL, &error);
    }

    /* words for people, JSON for programs */
    if (code == APP_DONE && !app_given(call, "quiet")) say_apply_summary(&correction, &was, path);
    if (code == APP_DONE && app_given(call, "json")) print_apply_json(&correction, path);

    wcut_job_destroy(job);
    return code;
}

static const app_operand operand[] = {
    {.name = "DIAGNOSIS", .kind = APP_FILE, .help = "diagnosis.json of wirecut diagnose"},
    {.name = "JOB", .kind = APP_FILE, .help = "any job of the same foam, wire and machine, wirecut-job/1"},
    {.name = NULL},
};

static const app_option option[] = {
    {.kind = APP_TEXT,
     .name = "output",
     .letter = 'o',
     .required = true,
     .value = "JOB2",
     .help = "the corrected job, a file"},
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_apply = {
    .name = "apply",
    .brief = "put what a diagnosis found into a job",
    .about =
        "Writes JOB2: JOB with the recalibrated force law and wire length, the kerf that the scans showed, and the "
        "effects found or modelled. The job's own effects and its excitation (dither, heater steps) are left out. "
        "simulate, path, mould, score and control then predict what the diagnosis calls \"after\".\n"
        "A diagnosis whose verdict is unknown, with nothing modelled, withholds its correction: its recalibration "
        "may compensate for the unknown cause. The call is then refused.",
    .operand = operand,
    .option = option,
    .run = apply,
};
