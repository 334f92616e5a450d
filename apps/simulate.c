/* wirecut simulate: a job file to history, surface, path curves and summary. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "simulation.h"
#include "terminal.h"

#define FORMATS APP_SIMULATION_FORMATS

/* What a run may leave in its folder, in the order written. */
static const char *const result_name[] = {APP_SIMULATION_FILES, "report.html", "summary.json", NULL};

/* ---- the run ---- */

/* Read the job and let the options have their say. */
static int load_simulation(app_simulation *s) {
    wcut_error error = {0};
    const int code = app_job_load(s->call, s->path, &s->job);
    if (code != APP_DONE) return code;

    wcut_cut_options options = wcut_cut_options_default();
    options.integrator = app_choice(s->call, "integrator") == 1 ? WCUT_INTEGRATOR_HEUN : WCUT_INTEGRATOR_IMPLICIT;
    const wcut_status status = wcut_setup_create(s->job, &options, &s->setup, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, s->path, &error);
}

static int write_report(app_simulation *s) {
    wcut_error error = {0};
    const char *name = "report.html";
    const wcut_report_simulate run = {.job_path = s->path,
                                      .integrator = app_text(s->call, "integrator"),
                                      .chord_tolerance = app_real(s->call, "chord-tolerance"),
                                      .merge = APP_MERGE_MM,
                                      .ended = s->ended};
    wcut_status status =
        wcut_report_simulate_write(&run, s->setup, s->history, app_results_path(&s->results, name), &error);
    return app_results_add(&s->results, name, status, &error);
}

static int write_results(app_simulation *s) {
    int code = app_simulation_write(s);
    if (code == APP_DONE) code = write_report(s);
    if (code != APP_DONE) return code;

    /* the summary goes in last: with it the results count */
    char *text = NULL;
    const wcut_status status = wcut_summary_print(s->setup, s->history, &text);
    return app_results_commit(&s->results, "summary.json", status, text);
}

/* ---- the answer ---- */

/* The summary to whom it concerns: people read standard error, programs standard output. */
static int give_summary(const app_simulation *s) {
    const int code = app_given(s->call, "quiet") ? APP_DONE : app_simulation_say(s);
    if (app_given(s->call, "json")) fputs(s->results.text, stdout);
    return code;
}

static int run_simulate(const app_call *call) {
    /* check formats and job before the run */
    app_simulation s = {.call = call, .path = call->operand[0]};
    int ended = APP_DONE, code = app_check_formats(call, FORMATS);
    if (code == APP_DONE) code = load_simulation(&s);
    if (code == APP_DONE) code = app_results_begin(&s.results, app_text(call, "output"), result_name);

    /* a run that ended early leaves its results up to there */
    if (code == APP_DONE) {
        app_catch_interrupts();
        ended = app_simulation_run(&s);
        if (s.history && s.history->stations > 0) {
            code = write_results(&s);
            if (code == APP_DONE) code = give_summary(&s);
        }
    }

    /* the exit code says how the run ended */
    if (code == APP_DONE) code = ended;
    app_simulation_clear(&s);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    APP_OPTION_EDGES,
    {.kind = APP_CHOICE,
     .name = "integrator",
     .value = "implicit|heun",
     .standard = "implicit",
     .help = "implicit: shape, tensions and rate solved together; heun: the scheme of Rust et al. 2016, (9)-(11), "
             "unstable for short steps, kept for comparison"},
    APP_OPTION_STATIONS,
    APP_OPTION_NODES,
    APP_OPTION_CHORD_TOLERANCE,
    APP_OPTION_FORMATS(FORMATS),
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_STRENGTH,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_simulate = {
    .name = "simulate",
    .brief = "simulate the cut of a job: history, surface, path curves",
    .about =
        "Simulates the cut of a job, station by station, and writes into DIR: history.vtp (every station's nodes, "
        "forces, speeds and tensions, for ParaView), surface.stl, surface.obj, surface.ply and surface.glb (the "
        "surface lofted through the stations; force as vertex colour and scalar), path.csv (both mounts' path curves), "
        "surface.step (exact surface and path curves, for CAD), report.html (everything on one page, for any browser) "
        "and summary.json, which is written last and lists the files.\nIf the cut cannot be solved to its end, or is "
        "interrupted, the files hold the stations up to there.",
    .operand = operand,
    .option = option,
    .run = run_simulate,
};
