/* wirecut score: recordings beside what the simulation says of them, planned and replayed. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "recording.h"
#include "results.h"
#include "terminal.h"

/* a cut that is asked for */
typedef struct trial {
    const char *of_case; /* NULL: none */
    const char *job_path, *recording_path;
    const wcut_recording_format *format; /* how the recording is read */
    int job_of;                          /* the trial that reads the job: an earlier one where they share it */
    wcut_job *job;
    wcut_recording *recording;
    wcut_comparison *comparison;
    wcut_error error;
} trial;

/* everything in a run; arrays in step are what the library takes */
typedef struct scoring {
    const app_call *call;
    wcut_comparison_options options;
    int cases, cuts, scored, code; /* code: the first bad cut's */
    wcut_case **found;             /* cases */
    wcut_recording_format format;  /* of recordings without a case */
    trial *trial;                  /* cuts */
    const wcut_job **job;
    const wcut_recording **recording;
    wcut_comparison **comparison;
    wcut_error *error;
    wcut_scored_cut *named;
    int groups;
    const char **group_name;
    wcut_scores *planned, *replayed; /* groups + 1: the last is of all */
    app_results results;
} scoring;

static const char *const result_name[] = {"score.json", "residuals.csv", "report.html", NULL};

static int fail_score_memory(void) { return app_fail_status(WCUT_NO_MEMORY, "score", NULL); }

/* a bad cut, or case: said, remembered, and not the end */
static void note_score_bad(scoring *s, int code) {
    if (s->code == APP_DONE) s->code = code;
}

/* ---- what is asked for ---- */

static int list_cases(scoring *s) {
    /* the cases that can be read; one that cannot is reported and passed over */
    const int n = s->call->operand_count;
    s->found = calloc((size_t)n, sizeof *s->found);
    if (!s->found) return fail_score_memory();
    for (int i = 0; i < n; i++) {
        wcut_error error = {0};
        const wcut_status status = wcut_case_read(s->call->operand[i], &s->found[s->cases], &error);
        if (status == WCUT_OK)
            s->cuts += s->found[s->cases++]->cuts;
        else
            note_score_bad(s, app_fail_status(status, NULL, &error));
    }
    for (int c = 0; c < s->cases; c++) {
        const int code = app_recording_format(s->call, &s->found[c]->format);
        if (code != APP_DONE) return code;
    }

    /* a row for each cut of each case */
    if (s->cuts == 0) return s->code;
    s->trial = calloc((size_t)s->cuts, sizeof *s->trial);
    if (!s->trial) return fail_score_memory();

    /* each cut reads its own job */
    int at = 0;
    for (int c = 0; c < s->cases; c++)
        for (int k = 0; k < s->found[c]->cuts; k++, at++)
            s->trial[at] = (trial){.of_case = s->found[c]->name,
                                   .job_path = s->found[c]->cut[k].job,
                                   .recording_path = s->found[c]->cut[k].recording,
                                   .format = &s->found[c]->format,
                                   .job_of = at};

    return APP_DONE;
}

static int list_recordings(scoring *s) {
    s->cuts = s->call->operand_count - 1;
    if (s->cuts == 0)
        return app_fail(
            APP_USAGE,
            "%s: found a job without recordings, expected JOB.json RECORDING.csv... (see wirecut score --help)",
            s->call->operand[0]);
    s->trial = calloc((size_t)s->cuts, sizeof *s->trial);
    if (!s->trial) return fail_score_memory();
    const int code = app_recording_format(s->call, &s->format);
    for (int i = 0; i < s->cuts; i++)
        s->trial[i] = (trial){.job_path = s->call->operand[0],
                              .recording_path = s->call->operand[i + 1],
                              .format = &s->format,
                              .job_of = 0};
    return code;
}

/* the first operand says what they all are */
static int list_cuts(scoring *s) {
    char format[WCUT_FORMAT_SIZE];
    wcut_error error = {0};
    const char *first = s->call->operand[0];
    const size_t length = strlen(first);
    for (int k = 1; k < s->call->operand_count && length > 4 && strcmp(first + length - 4, ".csv") == 0; k++) {
        const char *ending = strrchr(s->call->operand[k], '.');
        if (ending && strcmp(ending, ".json") == 0)
            return app_fail(
                APP_USAGE, "score: found the recording %s before %s, expected the job first: JOB.json RECORDING.csv...",
                first, s->call->operand[k]);
    }
    const wcut_status status = wcut_format_read(s->call->operand[0], format, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    if (strcmp(format, "wirecut-case/1") == 0) return list_cases(s);
    if (strcmp(format, "wirecut-job/1") == 0) return list_recordings(s);
    return app_fail(APP_BAD_INPUT, "%s: $.format: found \"%s\", expected \"wirecut-case/1\" or \"wirecut-job/1\"",
                    s->call->operand[0], format);
}

/* what contradicts the job is said; a clock that no machine has is the end of the cut */
static wcut_status doubt_trial(const scoring *s, trial *t) {
    wcut_doubt doubt[WCUT_DOUBTS_MAX];
    int count = 0;
    const wcut_status status = wcut_recording_check(s->trial[t->job_of].job, t->recording, &count, doubt);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < count; k++) {
        if (!doubt[k].certain) {
            app_say("%s: warning: %s", t->recording_path, doubt[k].error.text);
            continue;
        }
        t->error.status = doubt[k].error.status;
        snprintf(t->error.text, sizeof t->error.text, "%.150s: %.300s", t->recording_path, doubt[k].error.text);
        wcut_recording_destroy(t->recording);
        t->recording = NULL;
        return t->error.status;
    }
    return WCUT_OK;
}

/* read a cut's files; what is wrong with them is the cut's */
static wcut_status read_trial(scoring *s, trial *t) {
    wcut_status status = WCUT_OK;
    if (&s->trial[t->job_of] == t) status = app_job_read_cut(s->call, t->job_path, &t->job, &t->error);
    if (status == WCUT_OK && !s->trial[t->job_of].job) {
        t->error = s->trial[t->job_of].error; /* the same job could not be read before */
        return t->error.status;
    }
    if (status == WCUT_OK) status = wcut_recording_read(t->recording_path, t->format, &t->recording, &t->error);
    if (status == WCUT_OK) status = wcut_recording_place(s->trial[t->job_of].job, t->recording, &t->error);
    return status == WCUT_OK ? doubt_trial(s, t) : status;
}

static int load_score(scoring *s) {
    s->options = wcut_comparison_options_default();
    s->options.replay.motion = app_choice(s->call, "motion") == 1 ? WCUT_MOTION_POSITION : WCUT_MOTION_STATION;
    s->options.replay.window = app_real(s->call, "window");
    s->options.settle = app_real(s->call, "settle");
    s->options.leave = app_real(s->call, "leave");
    const int code = list_cuts(s);
    if (code != APP_DONE) return code;
    for (int i = 0; i < s->cuts; i++) {
        const wcut_status status = read_trial(s, &s->trial[i]);
        if (status != WCUT_OK) note_score_bad(s, app_fail_status(status, NULL, &s->trial[i].error));
    }
    return APP_DONE;
}

/* ---- the run ---- */

static bool make_score_room(scoring *s) {
    const size_t n = s->cuts > 0 ? (size_t)s->cuts : 1;
    s->job = calloc(n, sizeof *s->job);
    s->recording = calloc(n, sizeof *s->recording);
    s->comparison = calloc(n, sizeof *s->comparison);
    s->error = calloc(n, sizeof *s->error);
    s->named = calloc(n, sizeof *s->named);
    s->group_name = calloc(n, sizeof *s->group_name);
    s->planned = calloc(n + 1, sizeof *s->planned);
    s->replayed = calloc(n + 1, sizeof *s->replayed);
    return s->job && s->recording && s->comparison && s->error && s->named && s->group_name && s->planned &&
           s->replayed;
}

/* Compare every cut that could be read. APP_DONE or APP_INTERRUPTED. */
static int run_scoring(scoring *s) {
    /* cuts whose job and recording were read */
    for (int i = 0; i < s->cuts; i++) {
        trial *t = &s->trial[i];
        if (t->recording) s->job[i] = s->trial[t->job_of].job, s->recording[i] = t->recording;
    }

    /* compare them, several at once */
    app_progress progress = app_progress_begin(app_given(s->call, "quiet"));
    progress.unit = "cuts";
    const wcut_status status = wcut_comparison_run(s->cuts, s->job, s->recording, &s->options, app_progress_step,
                                                   &progress, s->comparison, s->error);
    app_progress_end(&progress);

    /* results, and the error of each cut that failed */
    for (int i = 0; i < s->cuts; i++) {
        trial *t = &s->trial[i];
        t->comparison = s->comparison[i];
        s->scored += t->comparison != NULL;
        if (!t->recording || t->comparison) continue;
        t->error = s->error[i];
        if (t->error.status != WCUT_INTERRUPTED)
            note_score_bad(s, app_fail_status(t->error.status, t->recording_path, &t->error));
    }

    /* an interruption is told with what was done */
    if (status == WCUT_INTERRUPTED)
        return app_fail(APP_INTERRUPTED, "interrupted after %d of %d cuts", s->scored, s->cuts);

    return status == WCUT_OK ? APP_DONE : app_fail_status(status, "score", NULL);
}

/* how many bytes of every recording's path are folders that all of them share */
static size_t find_shared_folders(const scoring *s) {
    const char *first = s->trial[0].recording_path, *slash = strrchr(first, '/');
    size_t shared = slash ? (size_t)(slash - first) + 1 : 0;
    for (int i = 1; i < s->cuts; i++) {
        const char *path = s->trial[i].recording_path;
        while (shared > 0 && (strncmp(path, first, shared) != 0 || first[shared - 1] != '/')) shared--;
    }
    return shared;
}

/* A cut as its files name it: outside a case by its recording, without the folders that all share. */
static void name_cuts(scoring *s) {
    const size_t shared = s->cuts > 0 ? find_shared_folders(s) : 0;
    for (int i = 0; i < s->cuts; i++) {
        const trial *t = &s->trial[i];
        s->named[i] = (wcut_scored_cut){.of_case = t->of_case,
                                        .name = !t->of_case ? t->recording_path + shared
                                                : t->job    ? t->job->name
                                                            : t->job_path,
                                        .job = t->job_path,
                                        .recording = t->recording_path,
                                        .samples = t->comparison ? t->recording : NULL,
                                        .comparison = t->comparison,
                                        .error = &t->error};
    }
}

/* means by case, or by cut where there is one case or none; behind them the mean of all */
static void find_means(scoring *s) {
    const bool by_case = s->cases > 1;
    int at = 0;
    for (int g = 0; at < s->cuts; g++) {
        const int count = by_case ? s->found[g]->cuts : 1;
        s->group_name[g] = by_case ? s->found[g]->name : s->named[g].name;
        wcut_scores_mean(count, (const wcut_comparison *const *)s->comparison + at, &s->planned[g], &s->replayed[g]);
        at += count;
        s->groups = g + 1;
    }
    wcut_scores_mean(s->cuts, (const wcut_comparison *const *)s->comparison, &s->planned[s->groups],
                     &s->replayed[s->groups]);
}

/* ---- the files ---- */

static int write_score_report(scoring *s) {
    /* the sources with their hashes */
    const app_call *call = s->call;
    const char *role = s->cases > 0 ? "case" : "job";
    wcut_report_source *source = calloc((size_t)call->operand_count, sizeof *source);
    char(*hash)[WCUT_SHA256_TEXT] = calloc((size_t)call->operand_count, sizeof *hash);
    wcut_error error = {0};
    wcut_status status = source && hash ? WCUT_OK : WCUT_NO_MEMORY;
    for (int i = 0; status == WCUT_OK && i < call->operand_count; i++) {
        /* one that cannot be read was reported before, and has no hash */
        if (access(call->operand[i], R_OK) == 0) status = wcut_source_hash(call->operand[i], hash[i], &error);
        source[i] = (wcut_report_source){s->cases == 0 && i > 0 ? "recording" : role, call->operand[i],
                                         hash[i][0] ? hash[i] : NULL};
    }

    /* several cases have no name of their own */
    char title[64];
    snprintf(title, sizeof title, "%d cases, %d cuts", s->cases, s->cuts);
    const wcut_report_score scored = {.title = s->cases > 1    ? title
                                               : s->cases == 1 ? s->found[0]->name
                                                               : s->trial[0].job->name,
                                      .cuts = s->cuts,
                                      .cut = s->named,
                                      .groups = s->groups,
                                      .group_name = s->group_name,
                                      .planned = s->planned,
                                      .replayed = s->replayed,
                                      .group_label = s->cases > 1 ? "case" : "cut",
                                      .options = &s->options,
                                      .nodes = app_given(call, "nodes") ? app_int(call, "nodes") : 0,
                                      .sources = call->operand_count,
                                      .source = source};

    /* write the page into the set of results */
    if (status == WCUT_OK)
        status = wcut_report_score_write(&scored, app_results_path(&s->results, "report.html"), &error);
    const int code = app_results_add(&s->results, "report.html", status, &error);

    free(hash);
    free(source);
    return code;
}

/* What a run leaves in its folder, under score.json. */
static int write_score_results(scoring *s) {
    wcut_error error = {0};
    char *text = NULL;
    const char *name = "residuals.csv";
    wcut_status status = wcut_residuals_write(s->cuts, s->named, app_results_path(&s->results, name), &error);
    int code = app_results_add(&s->results, name, status, &error);
    if (code == APP_DONE) code = write_score_report(s);
    if (code != APP_DONE) return code;
    status = wcut_score_print(s->cuts, s->named, &s->options, &text);
    return app_results_commit(&s->results, "score.json", status, text);
}

/* ---- the summary ---- */

typedef enum figure { FIGURE_NRMSD, FIGURE_RMSE, FIGURE_BIAS, FIGURES } figure;

static void put_score_figure(char *to, size_t size, const wcut_score *s, int scored, figure what) {
    const bool angle = scored == WCUT_SCORED_ALPHA || scored == WCUT_SCORED_BETA;
    if (s->count == 0 || (what != FIGURE_BIAS && !(s->range > 0)))
        snprintf(to, size, "%8s", "-");
    else if (what == FIGURE_BIAS)
        snprintf(to, size, "%+8.3g", s->bias * (angle ? WCUT_DEG_PER_RAD : 1));
    else
        snprintf(to, size, "%8.4f", what == FIGURE_NRMSD ? s->nrmsd : s->rmse_over_range);
}

/* a line of a figure of each channel, planned and replayed */
static void say_row(const char *name, const wcut_scores *planned, const wcut_scores *replayed, figure what) {
    char text[7][32];
    for (int k = 0; k < 4; k++) put_score_figure(text[k], sizeof text[k], &planned->of[k][WCUT_PART_ALL], k, what);
    for (int k = 1; k < 4; k++)
        put_score_figure(text[k + 3], sizeof text[k + 3], &replayed->of[k][WCUT_PART_ALL], k, what);
    const size_t length = strlen(name);
    const bool is_long = length > 24; /* the end of a path tells more than its beginning */
    app_say("%s%-*s %s %s %s %s   %s %s %s", is_long ? "..." : "", is_long ? 21 : 24,
            is_long ? name + length - 21 : name, text[0], text[1], text[2], text[3], text[4], text[5], text[6]);
}

/* NRMSD is blind to a bias: the two that see it stand below it */
static void say_rows(const char *name, const wcut_scores *planned, const wcut_scores *replayed) {
    say_row(name, planned, replayed, FIGURE_NRMSD);
    say_row("  RMSE/range", planned, replayed, FIGURE_RMSE);
    say_row("  bias (mm/s, N, deg)", planned, replayed, FIGURE_BIAS);
}

/* the highest of each figure over the groups, told apart from NRMSD 0 by its range */
static void say_worst(const scoring *s) {
    wcut_scores planned = {0}, replayed = {0};
    for (int g = 0; g < s->groups; g++)
        for (int k = 0; k < 4; k++) {
            if (s->planned[g].of[k][0].nrmsd >= planned.of[k][0].nrmsd) planned.of[k][0] = s->planned[g].of[k][0];
            if (s->replayed[g].of[k][0].nrmsd >= replayed.of[k][0].nrmsd) replayed.of[k][0] = s->replayed[g].of[k][0];
        }
    say_row("worst", &planned, &replayed, FIGURE_NRMSD);
}

static void say_samples(const scoring *s) {
    int failed = 0, unplanned = 0, standing = 0;
    for (int i = 0; i < s->cuts; i++) {
        if (!s->comparison[i]) continue;
        failed += s->comparison[i]->replayed->failed;
        standing += s->comparison[i]->replayed->standing;
        unplanned += s->comparison[i]->planned->failed;
    }
    if (failed + unplanned + standing > 0)
        app_say(
            "samples without a prediction: %d where the replay did not converge, %d beyond the plan, %d where the "
            "mounts stood still",
            failed, unplanned, standing);
}

static void say_table(const scoring *s) {
    app_say("NRMSD                     planned                                replayed");
    app_say("%-24s %8s %8s %8s %8s   %8s %8s %8s", s->cases > 1 ? "case" : "cut", "speed", "tension", "alpha", "beta",
            "tension", "alpha", "beta");
    for (int g = 0; g < s->groups; g++) say_rows(s->group_name[g], &s->planned[g], &s->replayed[g]);
    if (s->groups > 1) {
        say_rows("mean over cuts", &s->planned[s->groups], &s->replayed[s->groups]);
        say_worst(s);
    }
    say_samples(s);
    app_say("%d of %d cuts scored; in %s: %s", s->scored, s->cuts, s->results.folder, app_results_list(&s->results));
}

static void give_score_summary(const scoring *s) {
    if (!app_given(s->call, "quiet")) say_table(s);
    if (app_given(s->call, "json")) fputs(s->results.text, stdout);
}

static void forget_score(scoring *s) {
    for (int i = 0; s->trial && i < s->cuts; i++) {
        wcut_comparison_destroy(s->trial[i].comparison);
        wcut_recording_destroy(s->trial[i].recording);
        wcut_job_destroy(s->trial[i].job);
    }
    for (int i = 0; i < s->cases; i++) wcut_case_destroy(s->found[i]);
    free(s->found);
    wcut_recording_format_clear(&s->format);
    free(s->trial);
    free(s->job);
    free(s->recording);
    free(s->comparison);
    free(s->error);
    free(s->named);
    free(s->group_name);
    free(s->planned);
    free(s->replayed);
}

static int score(const app_call *call) {
    /* read, then make room for the results */
    scoring s = {.call = call};
    int ended = APP_DONE, code = load_score(&s);
    if (code == APP_DONE && !make_score_room(&s)) code = fail_score_memory();
    if (code == APP_DONE) code = app_results_begin(&s.results, app_text(call, "output"), result_name);

    /* run, and write what was scored */
    if (code == APP_DONE) {
        app_catch_interrupts();
        ended = run_scoring(&s);
        if (s.scored > 0) {
            name_cuts(&s);
            find_means(&s);
            code = write_score_results(&s);
            if (code == APP_DONE) give_score_summary(&s);
        } else {
            app_say("none of %d cuts could be scored: nothing was written", s.cuts);
        }
    }

    /* the exit code of the run, or that of a file that could not be read */
    if (code == APP_DONE) code = ended != APP_DONE ? ended : s.code;

    app_results_end(&s.results);
    forget_score(&s);

    return code;
}

/* ---- the table ---- */

/* defaults of the library */
static double score_motion(void) { return wcut_comparison_options_default().replay.motion; }
static double score_window(void) { return wcut_comparison_options_default().replay.window; }
static double score_settle(void) { return wcut_comparison_options_default().settle; }
static double score_leave(void) { return wcut_comparison_options_default().leave; }

static const app_operand operand[] = {
    {.name = "INPUT",
     .kind = APP_FILE,
     .help = "a job and its recordings, JOB.json RECORDING.csv..., or cases, CASE.json...",
     .many = true},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_CHOICE,
     .name = "motion",
     .value = "station|position",
     .library = score_motion,
     .help = "motion of the replay: the job's path at the recorded station, or the measured mount positions a_x_mm .. "
             "b_z_mm"},
    {.kind = APP_REAL,
     .name = "window",
     .value = "S",
     .low = 0,
     .high = 60,
     .library = score_window,
     .help = "width of the window in which the motion is smoothed before the replay, s; 0: as recorded"},
    {.kind = APP_REAL,
     .name = "settle",
     .value = "S",
     .low = 0,
     .high = 1e6,
     .library = score_settle,
     .help = "time left out after the plan's first contact, where measured data oscillate, s"},
    {.kind = APP_REAL,
     .name = "leave",
     .value = "S",
     .low = 0,
     .high = 1e6,
     .library = score_leave,
     .help = "time left out before the wire leaves the block, s"},
    APP_OPTIONS_RECORDING,
    APP_OPTION_NODES,
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_score = {
    .name = "score",
    .brief = "compare recordings with two predictions: RMSD, NRMSD, bias",
    .about =
        "Predicts every recording twice. Planned: from the job alone. Replayed: the wire is driven by the recorded "
        "motion; the speed is an input there and is not scored. Writes into DIR: score.json (RMSD, NRMSD over the "
        "range of the measured data, RMSE over range, bias, correlation, by channel and phase), residuals.csv (one row "
        "a sample) and report.html.\nNRMSD does not include a bias; RMSE over range does. The figures of a phase are "
        "divided by the range of the whole cut. A residual is the measured less the predicted value.\nA cut that "
        "cannot be scored is reported and the others are scored; the command then ends with the exit code of the first "
        "such cut. Samples at which the replay does not converge have no prediction; their number is reported. The "
        "planned run leaves out the job's excitation.",
    .operand = operand,
    .option = option,
    .run = score,
};
