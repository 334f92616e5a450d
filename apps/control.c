/* wirecut control: a job in closed loop with a foam that is not what the job says, recorded as a machine would. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

static const char *const result_name[] = {"recording.csv", "report.html", "control.json", NULL};

typedef struct loop {
    const app_call *call;
    const char *path; /* of the job */
    wcut_job *job;
    wcut_history *history;
    wcut_control_settings settings;
    wcut_rig_options options;
    wcut_rig_run *feedback, *plan;
    app_results results;
} loop;

/* ---- the disturbance ---- */

enum { KEY_MAX = 32 };

static int refuse_disturbance(const char *found, const char *expected) {
    return app_fail(APP_USAGE, "control: --disturb: found \"%s\", expected %s", found, expected);
}

/* one KEY:VALUE */
static int disturb_by(wcut_rig_options *o, const char *item) {
    /* the disturbances by key, each with its factor into the API's unit and its range */
    const struct {
        const char *name;
        double *to, unit, low, high;
    } key[] = {{"law-a", &o->law_a, 1, 0.01, 100},
               {"law-b", &o->law_b, 1, 0.01, 100},
               {"density", &o->density, 1, 0.01, 100},
               {"density-from", &o->density_from, 1, -1e6, 1e6},
               {"delay", &o->delay, 1, 0, 10},
               {"lag", &o->lag, 1, 0, 10},
               {"noise", &o->noise_tension, 1, 0, 1e3},
               {"angle-noise", &o->noise_angle, WCUT_RAD_PER_DEG, 0, 90},
               {"speed-noise", &o->noise_speed, 1, 0, 1e3},
               {"position-noise", &o->noise_position, 1, 0, 1e3}};
    enum { KEYS = sizeof key / sizeof *key };
    const char *names[KEYS + 1] = {NULL};
    for (int k = 0; k < KEYS; k++) names[k] = key[k].name;

    /* the key stands before the colon */
    const size_t length = strcspn(item, ":");
    char name[KEY_MAX] = "";
    if (length < sizeof name && item[length] == ':') memcpy(name, item, length);

    /* the number behind it: plain digits to the end, in range */
    for (int k = 0; k < KEYS; k++) {
        if (strcmp(name, key[k].name) != 0) continue;
        const char *digits = item + length + 1;
        char *end = NULL;
        const double value = strtod(digits, &end);
        if (end == digits || *end || digits[strspn(digits, "0123456789.+-eE")] ||
            !(value >= key[k].low && value <= key[k].high)) {
            char expected[160];
            snprintf(expected, sizeof expected, "%s:NUMBER with a number from %g to %g", name, key[k].low, key[k].high);
            return refuse_disturbance(item, expected);
        }
        *key[k].to = value * key[k].unit;
        return APP_DONE;
    }

    /* an unknown key: refuse it with the nearest known one */
    const char *near = app_suggest(name, names);
    char expected[120];
    snprintf(expected, sizeof expected, "KEY:NUMBER with a key that --help lists%s%s", near ? "; did you mean " : "",
             near ? near : "");

    return refuse_disturbance(item, expected);
}

static int disturb(loop *l) {
    if (!app_given(l->call, "disturb")) return APP_DONE;
    const char *text = app_text(l->call, "disturb");
    const size_t size = strlen(text) + 1;
    char *copy = malloc(size);
    if (!copy) return app_fail_status(WCUT_NO_MEMORY, NULL, NULL);
    int code = APP_DONE;
    char *item = memcpy(copy, text, size);
    while (item && code == APP_DONE) {
        char *comma = strchr(item, ',');
        if (comma) *comma = 0;
        code = disturb_by(&l->options, item);
        item = comma ? comma + 1 : NULL;
    }
    free(copy);
    return code;
}

/* ---- the runs ---- */

static wcut_status simulate_control_job(loop *l, wcut_setup **setup, wcut_history **history, wcut_error *error) {
    wcut_status status = wcut_setup_create(l->job, NULL, setup, error);
    if (status == WCUT_OK) status = wcut_setup_run(*setup, NULL, NULL, history, error);
    return status;
}

static wcut_status simulate_plan(loop *l, wcut_error *error) {
    wcut_setup *setup = NULL;
    const wcut_status status = simulate_control_job(l, &setup, &l->history, error);
    wcut_setup_destroy(setup);
    return status;
}

static int load_loop(loop *l) {
    int code = app_job_load_path(l->call, l->path, &l->job);
    if (code == APP_DONE)
        code = app_require_two_arms(l->job, l->path,
                                    "the loop holds the tension of a wire between two arms by their speed");
    if (code != APP_DONE) return code;

    /* defaults of the library for this job */
    l->settings = wcut_control_settings_default(l->job);
    l->options = wcut_rig_options_default(l->job);

    /* options that replace them, by name */
    const struct {
        const char *name;
        double *to;
    } option[] = {{"gain", &l->settings.gain},
                  {"integral", &l->settings.rate},
                  {"filter", &l->settings.filter},
                  {"acceleration", &l->settings.acceleration},
                  {"tension-stop", &l->settings.tension_stop},
                  {"period", &l->options.period}};
    for (size_t i = 0; i < sizeof option / sizeof *option; i++)
        if (app_given(l->call, option[i].name)) *option[i].to = app_real(l->call, option[i].name);

    /* a limit for absurd readings above the limit for a stop */
    if (l->settings.tension_absurd < 2 * l->settings.tension_stop)
        l->settings.tension_absurd = 2 * l->settings.tension_stop;

    l->options.seed = (uint64_t)app_int(l->call, "seed");
    l->options.excitation = !app_given(l->call, "no-excitation");

    return disturb(l);
}

static int run_rig(loop *l, bool feedback, wcut_rig_run **run) {
    wcut_error error = {0};
    wcut_control_settings settings = l->settings;
    settings.feedback = feedback;
    app_progress progress = app_progress_begin(app_given(l->call, "quiet"));
    wcut_status status =
        wcut_rig_run_create(l->job, l->history, &settings, &l->options, app_progress_step, &progress, run, &error);
    app_progress_end(&progress);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, l->path, &error);
}

static int control_cut(loop *l) {
    wcut_error error = {0};
    wcut_status status = simulate_plan(l, &error);
    if (status != WCUT_OK) return app_fail_status(status, l->path, &error);
    int code = run_rig(l, true, &l->feedback);
    if (code == APP_DONE) code = run_rig(l, false, &l->plan);
    return code;
}

/* ---- the files ---- */

static const wcut_rig_run *recorded(const loop *l) { return app_given(l->call, "no-feedback") ? l->plan : l->feedback; }

static wcut_rig_summary summarize(const loop *l) {
    return (wcut_rig_summary){.job = l->job,
                              .control = &l->settings,
                              .options = &l->options,
                              .feedback = l->feedback,
                              .plan = l->plan,
                              .plan_recorded = app_given(l->call, "no-feedback")};
}

static int write_recording(loop *l) {
    wcut_error error = {0};
    const wcut_status status = wcut_recording_write(&recorded(l)->recording, "simulated by wirecut control",
                                                    app_results_path(&l->results, "recording.csv"), &error);
    return app_results_add(&l->results, "recording.csv", status, &error);
}

/* a run that was interrupted or could not go on leaves its recording, and a voucher that says it is a part */
static int write_part(loop *l) {
    if (!recorded(l)) return APP_DONE;
    const int code = write_recording(l);
    if (code != APP_DONE) return code;
    return app_results_commit_words(&l->results, "control.json",
                                    "{\n  \"format\": \"wirecut-control/1\",\n  \"complete\": false\n}\n");
}

static int write_control_results(loop *l) {
    wcut_error error = {0};
    char *text = NULL;
    app_results *r = &l->results;
    const wcut_rig_summary summary = summarize(l);
    int code = write_recording(l);
    if (code != APP_DONE) return code;
    wcut_status status = wcut_report_control_write(&summary, l->path, app_results_path(r, "report.html"), &error);
    code = app_results_add(r, "report.html", status, &error);
    if (code != APP_DONE) return code;
    status = wcut_rig_summary_print(&summary, &text);
    return app_results_commit(r, "control.json", status, text);
}

static void say_run(const char *name, const wcut_rig_run *run) {
    char end[80] = "";
    if (run->ended != WCUT_CONTROL_STATE_RUN)
        snprintf(end, sizeof end, ", ended by a safe %s", wcut_control_state_name(run->ended));
    app_say("%s: %.1f s, overshoot %.0f %%%s", name, run->duration, 100 * run->overshoot, end);
    if (run->has_steady)
        app_say("  steady phase: mean %.4g N (%+.2f %%), rms error %.2g %%, largest %.2g %%",
                run->target * (1 + run->steady.mean), 100 * run->steady.mean, 100 * run->steady.rms,
                100 * run->steady.max);
    if (!run->has_density) return;
    const wcut_rig_figures *f = &run->density;
    char settled[64] = "does not settle within 5 %";
    if (f->settled < f->to - f->from) snprintf(settled, sizeof settled, "settles within 5 %% after %.1f s", f->settled);
    app_say("  after the density step: mean %+.2f %%, largest error %.2g %%, %s", 100 * f->mean, 100 * f->max, settled);
}

static void say_control(const loop *l) {
    app_say("%s: target %.3g N; foam: a times %.3g, b times %.3g, density step times %.3g", l->job->name,
            l->settings.tension, l->options.law_a, l->options.law_b, l->options.density);
    say_run("with feedback", l->feedback);
    say_run("plan alone", l->plan);
    app_say("in %s: %s", l->results.folder, app_results_list(&l->results));
}

static int control(const app_call *call) {
    /* job and options, then the folder for the results */
    loop l = {.call = call, .path = call->operand[0]};
    int code = load_loop(&l);
    if (code == APP_DONE) code = app_results_begin(&l.results, app_text(call, "output"), result_name);

    /* run with feedback and with the plan alone; a run that ended early leaves its part */
    if (code == APP_DONE) {
        app_catch_interrupts();
        code = control_cut(&l);
        if (code == APP_DONE)
            code = write_control_results(&l);
        else if (code == APP_INTERRUPTED || code == APP_NOT_CONVERGED)
            code = write_part(&l) == APP_DONE ? code : APP_NOT_WRITTEN;
    }

    /* results for people and for programs */
    if (code == APP_DONE && !app_given(call, "quiet")) say_control(&l);
    if (code == APP_DONE && app_given(call, "json")) fputs(l.results.text, stdout);

    /* a safe stop is an exit code of its own */
    if (code == APP_DONE && recorded(&l)->ended != WCUT_CONTROL_STATE_RUN)
        code = app_fail(APP_OUTSIDE, "%s: safe %s at %.2f s", l.path, wcut_control_state_name(recorded(&l)->ended),
                        recorded(&l)->duration);

    app_results_end(&l.results);

    wcut_rig_run_destroy(l.plan);
    wcut_rig_run_destroy(l.feedback);
    wcut_history_destroy(l.history);
    wcut_job_destroy(l.job);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */
static double control_seed(void) { return (double)wcut_rig_options_default(&(wcut_job){0}).seed; }
static double control_period(void) { return wcut_rig_options_default(&(wcut_job){0}).period; }
static double control_gain(void) { return wcut_control_settings_default(&(wcut_job){0}).gain; }
static double control_integral(void) { return wcut_control_settings_default(&(wcut_job){0}).rate; }
static double control_filter(void) { return wcut_control_settings_default(&(wcut_job){0}).filter; }
static double control_acceleration(void) { return wcut_control_settings_default(&(wcut_job){0}).acceleration; }

static const app_operand operand[] = {
    {.name = "JOB", .kind = APP_FILE, .help = "a job file, wirecut-job/1"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    APP_OPTION_EDGES,
    {.kind = APP_TEXT,
     .name = "disturb",
     .value = "KEY:X,...",
     .help = "how the rig differs from the job. Factors, default 1: law-a, law-b, density (of a, where y is beyond "
             "density-from mm, default half the block). Times, default 0.05 s: delay of the tension readings, lag of "
             "the mounts. Standard deviations: noise (tension, 0.02 N), angle-noise (0.05 deg), speed-noise (0.1 "
             "mm/s), position-noise (0.05 mm)"},
    {.kind = APP_FLAG,
     .name = "no-feedback",
     .help = "record the run with the plan alone; both runs are reported in any case"},
    {.kind = APP_FLAG, .name = "no-excitation", .help = "leave out the job's speed dither and heat steps"},
    {.kind = APP_INT,
     .name = "seed",
     .value = "N",
     .low = 0,
     .high = 2147483647,
     .library = control_seed,
     .help = "seed of the sensors' noise"},
    {.kind = APP_REAL,
     .name = "period",
     .value = "S",
     .low = 1e-3,
     .high = 1,
     .library = control_period,
     .help = "period of the control loop, s; the recording has at most 20 samples a second"},
    {.kind = APP_REAL,
     .name = "gain",
     .value = "KP",
     .low = 0,
     .high = 100,
     .library = control_gain,
     .help = "proportional gain on ln(tension / target)"},
    {.kind = APP_REAL,
     .name = "integral",
     .value = "KI",
     .low = 0,
     .high = 1000,
     .library = control_integral,
     .help = "integral gain, 1/s"},
    {.kind = APP_REAL,
     .name = "filter",
     .value = "S",
     .low = 0,
     .high = 100,
     .library = control_filter,
     .help = "time constant of the low-pass on the tension, s"},
    {.kind = APP_REAL,
     .name = "acceleration",
     .value = "A",
     .low = 1e-3,
     .high = 1e6,
     .library = control_acceleration,
     .help = "largest acceleration of a mount, mm/s^2"},
    {.kind = APP_REAL,
     .name = "tension-stop",
     .value = "N",
     .low = 1e-6,
     .high = 1e6,
     .help = "tension of either mount at which the machine stops, N; default 2.5 times the target"},
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_control = {
    .name = "control",
    .brief = "run a job in closed loop on a disturbed rig in simulation, and record it",
    .about =
        "Simulates the job and takes its speeds as the plan. Then runs it twice on a rig in simulation whose foam, "
        "sensors and machine differ from the job: with feedback of the measured tension, and with the plan alone. The "
        "controller adds u = gain e + integral of e, e = ln(tension / target), to the exponent b Q / v of the force "
        "law; ln(tension) is linear in it.\nWrites into DIR: recording.csv (what the machine would have recorded), "
        "report.html and control.json (tension error, overshoot, settling). If the recorded run ends in a safe stop, "
        "the exit code is 5.",
    .operand = operand,
    .option = option,
    .run = control,
};
