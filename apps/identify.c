/* wirecut identify: from a job the identification cuts that let a diagnosis tell lags, rates and heats apart. */
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/diagnosis.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

enum { CUTS_MAX = 8, NAME_SIZE = 32 };

typedef struct identification {
    const app_call *call;
    int count;
    wcut_job *job, *cut[CUTS_MAX];
    char name[CUTS_MAX][NAME_SIZE];
    const char *result[CUTS_MAX + 2];
    app_results results;
} identification;

static int load_identify(identification *x) {
    wcut_error error = {0};
    const char *path = x->call->operand[0];
    int code = app_job_load_path(x->call, path, &x->job);
    if (code == APP_DONE)
        code = app_require_two_arms(
            x->job, path,
            "the programme varies a speed that the tension sets; one that is commanded is varied by "
            "feed.profile");
    if (code != APP_DONE) return code;

    x->count = app_int(x->call, "cuts");
    const wcut_status status =
        wcut_identification_create(x->job, x->count, (unsigned long long)app_int(x->call, "seed"), x->cut, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, path, &error);
}

/* their names, and the NULL that closes the list */
static void name_identify_results(identification *x) {
    for (int k = 0; k < CUTS_MAX; k++) {
        snprintf(x->name[k], sizeof x->name[k], "identification-%d.json", k + 1);
        x->result[k] = x->name[k];
    }
    x->result[CUTS_MAX] = "identify.json";
}

/* the jobs, under identify.json */
static int write_identify_results(identification *x) {
    int code = APP_DONE;
    for (int k = 0; k < x->count && code == APP_DONE; k++) {
        wcut_error error = {0};
        const wcut_status status = wcut_job_write(x->cut[k], app_results_path(&x->results, x->name[k]), &error);
        code = app_results_add(&x->results, x->name[k], status, &error);
    }
    if (code != APP_DONE) return code;
    return app_results_commit_words(&x->results, "identify.json", "{\n  \"format\": \"wirecut-identification/1\"\n}\n");
}

static double dither_of(const wcut_job *job) {
    double sum = 0;
    for (int i = 0; i < job->dither_count; i++) sum += job->dither[i].amplitude;
    return sum;
}

static double longest_step(const wcut_job *job) {
    double max = 0;
    for (int i = 0; i < job->heat_step_count; i++) {
        const double size = job->heat_step[i].factor - 1;
        if (size > max) max = size;
        if (-size > max) max = -size;
    }
    return max;
}

static void say_identify_summary(const identification *x) {
    for (int k = 0; k < x->count; k++)
        app_say("%s: %s: speed varied by up to %.1f %%, %d heater steps of %.1f %%", x->name[k], x->cut[k]->name,
                100 * dither_of(x->cut[k]), x->cut[k]->heat_step_count, 100 * longest_step(x->cut[k]));
    app_say("in %s: %s", x->results.folder, app_results_list(&x->results));
}

static int identify(const app_call *call) {
    identification x = {.call = call};
    int code = load_identify(&x);
    name_identify_results(&x);
    if (code == APP_DONE) code = app_results_begin(&x.results, app_text(call, "output"), x.result);
    if (code == APP_DONE) code = write_identify_results(&x);
    if (code == APP_DONE && !app_given(call, "quiet")) say_identify_summary(&x);
    if (code == APP_DONE && app_given(call, "json")) fputs(x.results.text, stdout);
    app_results_end(&x.results);
    for (int k = 0; k < x.count; k++) wcut_job_destroy(x.cut[k]);
    wcut_job_destroy(x.job);
    return code;
}

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_INT,
     .name = "cuts",
     .value = "N",
     .low = 1,
     .high = CUTS_MAX,
     .standard = "2",
     .help = "identification cuts to make"},
    {.kind = APP_INT,
     .name = "seed",
     .value = "N",
     .low = 0,
     .high = 2147483647,
     .standard = "1",
     .help = "seed of periods, phases and steps"},
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_identify = {
    .name = "identify",
    .brief = "make identification cuts from a job: varied speed and heater steps",
    .about =
        "Ordinary cuts cannot separate a lag of the wire, a lag of a sensor and a dependence on speed: speed, heat, "
        "time and place change together in them. An identification cut is the same cut with three sines on the speed "
        "(4 to 5.5 % each, 3 to 12 s) and steps of the heater (10 %, 6 to 14 s). The second one is run backwards where "
        "the path allows it, which separates effects of the place in the block from effects of time.\nWrites into DIR: "
        "identification-1.json and so on, jobs with \"excitation\". The amplitudes are as large as the job's speed "
        "limits allow and keep the tension below twice its target without feedback. Make these cuts (wirecut "
        "path writes their programs), add their recordings to the case, and run wirecut diagnose.",
    .operand = operand,
    .option = option,
    .run = identify,
};
