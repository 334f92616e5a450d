/* wirecut compensate: a job's paths corrected for what a diagnosis found of the machine. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "design_target.h"
#include "job.h"
#include "results.h"
#include "simulation.h"
#include "terminal.h"

#define FORMATS APP_SIMULATION_FORMATS

enum { SENTENCE = 900 };

/* What a compensation may leave in its folder, in the order written. */
static const char *const result_name[] = {"job-corrected.json", APP_SIMULATION_FILES, "report.html",
                                          "compensation.json", NULL};

typedef struct compensating {
    const app_call *call;
    const char *path; /* of the job */
    wcut_job *job;
    wcut_job *machine; /* the same cut as the machine makes it */
    wcut_design_target *target;
    wcut_design_options options;
    wcut_compensation *found;
    wcut_correction correction; /* of a diagnosis */
    bool diagnosed;
    double *moved; /* machine's effects [mm] */
    app_simulation cut;
    wcut_compensation_result result;
} compensating;

/* ---- what the machine does ---- */

/* faults of instruments do not move the face: they are not to be compensated */
static void drop_instruments(wcut_job *job) {
    int kept = 0;
    for (int e = 0; e < job->effect_count; e++) {
        const wcut_effect_place place = wcut_effect_view(job->effect[e].kind)->place;
        if (place == WCUT_EFFECT_PLACE_STEP || place == WCUT_EFFECT_PLACE_FACE) job->effect[kept++] = job->effect[e];
    }
    job->effect_count = kept;
}

/* the job along its paths, with what a diagnosis corrects, or as an improved job has it */
static int load_machine(compensating *c) {
    const char *with = app_text(c->call, "with");
    wcut_error error = {0};
    wcut_setup *setup = NULL;
    wcut_job *improved = NULL;
    wcut_status status = wcut_setup_create(c->job, NULL, &setup, &error);
    if (status != WCUT_OK) return app_fail_status(status, c->path, &error);
    status = wcut_setup_path_job(setup, &c->machine);
    wcut_setup_destroy(setup);
    if (status != WCUT_OK) return app_fail_status(status, c->path, NULL);

    /* a job, else a diagnosis */
    char format[WCUT_FORMAT_SIZE];
    status = wcut_format_read(with, format, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    if (strcmp(format, "wirecut-job/1") == 0) {
        status = wcut_job_read(with, &improved, &error);
        if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
        if (app_given(c->call, "force-law")) {
            wcut_job_destroy(improved);
            return app_fail(APP_USAGE,
                            "compensate: --force-law: expected a diagnosis by --with, found a job, which has the "
                            "machine's law");
        }
        if (improved->mode != WCUT_MODE_PATH || improved->stations != c->machine->stations) {
            wcut_job_destroy(improved);
            return app_fail(APP_BAD_INPUT, "%s: found a job of other paths, expected the improved job of %s", with,
                            c->path);
        }
        wcut_job_destroy(c->machine);
        c->machine = improved;
    } else {
        status = wcut_correction_read(with, &c->correction, &error);
        if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
        status = wcut_correction_apply(&c->correction, c->machine, &error);
        if (status != WCUT_OK) return app_fail_status(status, with, &error);
        c->diagnosed = true;
    }
    drop_instruments(c->machine);
    return APP_DONE;
}

/* ---- the target ---- */

/* the face that the job plans */
static int plan_target(compensating *c) {
    wcut_error error = {0};
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_face *face = NULL;
    wcut_status status = wcut_setup_create(c->job, NULL, &setup, &error);
    if (status == WCUT_OK) status = wcut_setup_run(setup, NULL, NULL, &history, &error);
    if (status == WCUT_OK) status = wcut_face_create(c->job, history, NULL, NULL, APP_MERGE_MM, &face);
    if (status == WCUT_OK)
        status = wcut_design_target_from_surface(face->surface, c->job->block_size, &c->target, &error);
    wcut_face_destroy(face);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, c->path, &error);
}

static int load_compensation(compensating *c) {
    int code = app_job_load(c->call, c->path, &c->job);
    if (code == APP_DONE)
        code = app_require_two_arms(c->job, c->path, "a correction moves the mounts against each other");
    if (code == APP_DONE) code = load_machine(c);
    if (code != APP_DONE) return code;
    c->options = wcut_design_options_default();
    c->options.threads = app_int(c->call, "threads");
    c->result = (wcut_compensation_result){.job = c->path,
                                           .with = app_text(c->call, "with"),
                                           .target = app_text(c->call, "target"),
                                           .spread = app_real(c->call, "spread"),
                                           .worth = app_real(c->call, "worth")};
    return app_given(c->call, "target")
               ? app_design_target_load(c->call, app_text(c->call, "target"), c->job->block_size, &c->target)
               : plan_target(c);
}

/* ---- what it is worth ---- */

static int say_compensation_round(const wcut_design_round *round, void *context) {
    const compensating *c = context;
    if (!app_given(c->call, "quiet"))
        app_say("%d stations of %d nodes, %d unknowns, %d runs: %.4g mm rms, %.3g mm at most", round->stations,
                round->nodes, round->unknowns, round->runs, round->rms, round->max);
    return app_is_interrupted();
}

/* a job's effects at an end of their intervals, or by the spread smaller or larger */
static void change_sizes(const compensating *c, int larger, wcut_job *job) {
    const double factor = larger ? 1 + c->result.spread : 1 - c->result.spread;
    const wcut_correction *found = &c->correction;
    for (int e = 0; e < job->effect_count; e++) {
        wcut_effect *effect = &job->effect[e];
        for (int k = 0; c->result.interval && k < found->effects; k++)
            if (found->effect[k].kind == effect->kind && found->effect[k].choice == effect->choice)
                *effect = larger ? found->high[k] : found->low[k];
        for (int v = 0; !c->result.interval && v < wcut_effect_view(effect->kind)->strengths; v++)
            effect->value[v] *= factor;
    }
    if (!c->result.interval)
        job->kerf_per_q *= factor;
    else if (job->kerf_per_q > 0)
        job->kerf_per_q = larger ? found->kerf_per_q_high : found->kerf_per_q_low;
}

/* a job's deviation with other effects, which are taken back */
static wcut_status measure_changed(const compensating *c, wcut_job *job,
                                   void (*change)(const compensating *, int, wcut_job *), int which, double *rms) {
    const int count = job->effect_count;
    const double kerf = job->kerf_per_q;
    double max;
    wcut_effect *kept = calloc((size_t)count + 1, sizeof *kept);
    if (!kept) return WCUT_NO_MEMORY;
    for (int e = 0; e < count; e++) kept[e] = job->effect[e];
    change(c, which, job);
    const wcut_status status = wcut_compensation_measure(c->target, job, c->options.threads, rms, &max, NULL);
    for (int e = 0; e < count; e++) job->effect[e] = kept[e];
    job->effect_count = count;
    job->kerf_per_q = kerf;
    free(kept);
    return status;
}

/* effects that were taken for smaller or larger than they are: both jobs */
static wcut_status measure_beside(const compensating *c, int larger, double *before, double *after) {
    const wcut_status status = measure_changed(c, c->machine, change_sizes, larger, before);
    return status == WCUT_OK ? measure_changed(c, c->found->job, change_sizes, larger, after) : status;
}

/* all but one effect away */
static void leave_one(const compensating *c, int which, wcut_job *job) {
    (void)c;
    job->effect[0] = job->effect[which];
    job->effect_count = 1;
    job->kerf_per_q = 0;
}

static wcut_status measure_effects(compensating *c) {
    const int count = c->machine->effect_count;
    c->moved = calloc((size_t)count + 1, sizeof *c->moved);
    wcut_status status = c->moved ? WCUT_OK : WCUT_NO_MEMORY;
    for (int e = 0; e < count && status == WCUT_OK; e++)
        status = measure_changed(c, c->machine, leave_one, e, &c->moved[e]);
    c->result.effects = count, c->result.effect = c->machine->effect, c->result.moved = c->moved;
    return status;
}

static int find_compensation(compensating *c) {
    wcut_error error = {0};
    wcut_status status =
        wcut_compensation_fit(c->target, c->machine, &c->options, say_compensation_round, c, &c->found, &error);
    if (status != WCUT_OK && status != WCUT_INTERRUPTED) return app_fail_status(status, c->path, &error);
    c->result.compensation = c->found;

    /* effects that were taken for smaller or larger than they are, and each alone */
    c->result.interval = c->diagnosed && c->correction.intervals > 0;
    status = measure_beside(c, 0, &c->result.smaller_before, &c->result.smaller_rms);
    if (status == WCUT_OK) status = measure_beside(c, 1, &c->result.larger_before, &c->result.larger_rms);
    if (status == WCUT_OK) status = measure_effects(c);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, c->path, NULL);
}

/* ---- the files ---- */

static int write_compensation(compensating *c) {
    wcut_error error = {0};
    app_simulation *s = &c->cut;
    const char *name = "job-corrected.json";
    s->job = c->found->job;
    wcut_status status = wcut_setup_create(s->job, NULL, &s->setup, &error);
    if (status != WCUT_OK) return app_fail_status(status, c->path, &error);
    int code = app_simulation_run(s);
    if (code != APP_DONE) return code;
    status = wcut_job_write(s->job, app_results_path(&s->results, name), &error);
    code = app_results_add(&s->results, name, status, &error);
    if (code == APP_DONE) code = app_simulation_write(s);
    if (code != APP_DONE) return code;

    /* the page, then the figures, which vouch for the rest */
    const char *slash = strrchr(c->path, '/'), *page = "report.html";
    status = wcut_report_compensate_write(slash ? slash + 1 : c->path, &c->result, app_results_path(&s->results, page),
                                          &error);
    code = app_results_add(&s->results, page, status, &error);
    if (code != APP_DONE) return code;
    char *text = NULL;
    status = wcut_compensation_print(&c->result, &text);
    return app_results_commit(&s->results, "compensation.json", status, text);
}

static void say_compensation(const compensating *c) {
    char sentence[SENTENCE];
    if (app_given(c->call, "json")) fputs(c->cut.results.text, stdout);
    if (app_given(c->call, "quiet")) return;
    if (wcut_compensation_say(&c->result, SENTENCE, sentence) == WCUT_OK) app_say("%s", sentence);
    app_say("in %s: %s", c->cut.results.folder, app_results_list(&c->cut.results));
}

static int run_compensate(const app_call *call) {
    compensating c = {.call = call, .path = call->operand[0]};
    c.cut = (app_simulation){.call = call, .path = c.path};
    int code = app_check_formats(call, FORMATS);
    if (code == APP_DONE) code = load_compensation(&c);
    if (code == APP_DONE) code = app_results_begin(&c.cut.results, app_text(call, "output"), result_name);
    if (code == APP_DONE) {
        app_catch_interrupts();
        code = find_compensation(&c);
    }
    if (code == APP_DONE) code = write_compensation(&c);
    if (code == APP_DONE) say_compensation(&c);

    /* the corrected job belongs to the compensation */
    c.cut.job = NULL;
    app_simulation_clear(&c.cut);
    wcut_compensation_destroy(c.found);
    free(c.moved);
    wcut_design_target_destroy(c.target);
    wcut_job_destroy(c.machine);
    wcut_job_destroy(c.job);
    return code;
}

/* ---- the table ---- */

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1: what is to be cut"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_FILE,
     .name = "with",
     .required = true,
     .value = "FILE",
     .help = "what the machine does: diagnosis.json, or job-improved.json of the same job"},
    {.kind = APP_FILE,
     .name = "target",
     .value = "FILE",
     .help = "what is wanted in the block's frame, of CAD, a mesh or a cloud; default the face that JOB plans"},
    {.kind = APP_TEXT,
     .name = "place",
     .value = "WHERE",
     .standard = "identity",
     .help = "of --target: identity, centred, or 12 numbers: the rows of a 3 x 4 matrix"},
    {.kind = APP_CHOICE,
     .name = "unit",
     .value = "mm|cm|m|inch|ft|dm|um",
     .standard = "mm",
     .help = "unit of the numbers of --target, where the file states none"},
    {.kind = APP_TEXT,
     .name = "face",
     .value = "NAME|N",
     .help = "of --target as a CAD file: its face, by its name or its number from 1; default all of them"},
    {.kind = APP_REAL,
     .name = "spread",
     .value = "SHARE",
     .low = 0,
     .high = 0.9,
     .standard = "0.1",
     .help =
         "by how much the effects may be smaller or larger than assumed, the gain being stated for both; a diagnosis "
         "with 95 % intervals has their ends instead"},
    {.kind = APP_REAL,
     .name = "worth",
     .value = "MM",
     .low = 0,
     .high = 100,
     .standard = "0.1",
     .help = "rms deviation below which a correction is said to be not worth it, mm"},
    APP_OPTION_CHORD_TOLERANCE,
    APP_OPTION_FORMATS(FORMATS),
    APP_OPTION_FORCE_LAW,
    APP_OPTION_THREADS,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_compensate = {
    .name = "compensate",
    .brief = "correct a job's paths for what a diagnosis found",
    .about =
        "Corrects the heights, the lag and the distance of both mounts over the stations of JOB so that the face that "
        "the "
        "machine cuts, with the effects of a diagnosis, comes nearest to what JOB plans, or to a target. Writes into "
        "DIR: "
        "job-corrected.json (both mounts' paths, with the effects, so that simulate and path give the machine's own "
        "speeds), what simulate writes of it, report.html and compensation.json.\nFaults of instruments in the "
        "diagnosis are left "
        "out: "
        "they do not move the face.",
    .operand = operand,
    .option = option,
    .run = run_compensate,
};
