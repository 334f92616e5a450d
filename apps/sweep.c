/* wirecut sweep: a study of many cases, run here or by Slurm, and its table. */
#include "sweep.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "results.h"
#include "scratch.h"
#include "terminal.h"

#define DEFAULT_JOBS "1"

enum { CALL_WORDS_MAX = 1024, VERBS_MAX = 64 };

static const char *const result_name[] = {"sweep.csv", "report.html", "sweep.json", NULL};

/* ---- the study against the table of verbs ---- */

static const app_verb *find_study_verb(const char *name) {
    for (int i = 0; app_verbs[i]; i++)
        if (strcmp(app_verbs[i]->name, name) == 0) return app_verbs[i];
    return NULL;
}

/* options that a sweep sets itself */
static int refuse_own_option(const char *path, int words, char **word) {
    static const char *const own[] = {"--output", "--json", "--quiet", "--help"};
    for (int w = 1; w < words - 1; w++) /* the last one is ours */
        for (int k = 0; k < 4; k++) {
            const size_t length = strlen(own[k]);
            if (strncmp(word[w], own[k], length) == 0 && (word[w][length] == '=' || word[w][length] == '\0'))
                return app_fail(APP_BAD_INPUT, "%s: found the option %s, which a sweep sets itself", path, own[k]);
        }
    return APP_DONE;
}

/* the words of the first case are a call that its verb understands */
static int check_study_call(const char *path, const wcut_study *study) {
    /* the verb must exist; a similar one is suggested */
    const wcut_study_info *info = wcut_study_view(study);
    const app_verb *verb = find_study_verb(info->verb);
    const char *names[VERBS_MAX] = {NULL};
    if (!verb) {
        for (int i = 0; app_verbs[i]; i++) names[i] = app_verbs[i]->name;
        const char *near = app_suggest(info->verb, names);
        return app_fail(APP_BAD_INPUT, "%s: $.verb: found \"%s\", expected a verb of the command%s%s", path, info->verb,
                        near ? ", such as " : "", near ? near : "");
    }

    /* the words as the processes get them */
    char *text = NULL, *word[CALL_WORDS_MAX];
    int words = 0;
    const wcut_status status = wcut_study_call_print(study, 0, "DIR", &text);
    if (status != WCUT_OK) return app_fail_status(status, path, NULL);
    for (char *at = text; *at && words < CALL_WORDS_MAX; at += strlen(at) + 1) {
        word[words++] = at;
        at[strcspn(at, "\n")] = '\0';
    }

    /* parse them as the verb does, without running it */
    app_call call = {0};
    int code = refuse_own_option(path, words, word);
    if (code == APP_DONE && app_parse(verb, words, word, &call) != APP_DONE)
        code = app_fail(APP_BAD_INPUT, "%s: its call of wirecut %s is wrong, see above", path, verb->name);
    app_call_clear(&call);
    free(text);
    return code;
}

/* ---- running ---- */

int app_sweep_program(char path[PATH_MAX]) {
    const ssize_t n = readlink("/proc/self/exe", path, PATH_MAX - 1);
    if (n < 0) return app_fail(APP_FAILED, "/proc/self/exe: %s", strerror(errno));
    path[n] = '\0';
    return APP_DONE;
}

/* what is done while cases run */
typedef struct watch {
    app_progress bar;
    const wcut_sweep *sweep;
    bool checked; /* a misspelt figure is said once, not after hours */
} watch;

/* the bar counts from 0 what the library counts from 1 */
static int step_cases(int looked, int cases, void *context) {
    watch *w = context;
    wcut_error error = {0};
    if (looked > 0 && !w->checked) {
        if (wcut_sweep_figures_query(w->sweep, &error) == WCUT_NOT_FOUND) app_say("warning: %s", error.text);
        w->checked = true;
    }
    return looked > 0 ? app_progress_step(looked - 1, cases, &w->bar) : app_is_interrupted();
}

/* processes side by side, each with one thread where the verb can have more: results do not depend on it */
static wcut_sweep_options pool_options(const app_call *call, const wcut_sweep *sweep, const char *program,
                                       watch *seen) {
    wcut_sweep_options options = wcut_sweep_options_default();
    const app_verb *verb = find_study_verb(wcut_study_view(wcut_sweep_view(sweep))->verb);
    const app_call of_verb = {.verb = verb};
    options.program = program;
    options.jobs = app_int(call, "jobs");
    options.progress = step_cases;
    options.context = seen;
    if (verb && options.jobs > 1 && app_has(&of_verb, "threads")) options.word = "--threads=1";
    return options;
}

static int run_cases(const app_call *call, wcut_sweep *sweep, int share, int shares) {
    char program[PATH_MAX];
    wcut_error error = {0};
    wcut_sweep_counts counts;
    int code = app_sweep_program(program);
    if (code != APP_DONE) return code;

    /* this share of the cases, with a progress bar */
    watch seen = {.bar = app_progress_begin(app_given(call, "quiet")), .sweep = sweep};
    seen.bar.unit = "cases";
    wcut_sweep_options options = pool_options(call, sweep, program, &seen);
    options.share = share;
    options.shares = shares;

    /* run; an interrupt ends the processes */
    app_catch_interrupts();
    const wcut_status status = wcut_sweep_run(sweep, &options, &counts, &error);
    app_progress_end(&seen.bar);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    if (!app_given(call, "quiet")) app_say("%d cases run, %d were whole", counts.ran, counts.cases - counts.ran);
    return APP_DONE;
}

/* ---- what there is ---- */

static int unfinished(const wcut_sweep_counts *counts) {
    return counts->state[WCUT_SWEEP_STATE_MISSING] + counts->state[WCUT_SWEEP_STATE_FAILED] +
           counts->state[WCUT_SWEEP_STATE_CRASHED];
}

static void say_counts(const wcut_sweep_counts *counts) {
    for (int s = 0; s < WCUT_SWEEP_STATE_COUNT; s++)
        if (counts->state[s] > 0)
            app_say("%d of %d cases: %s", counts->state[s], counts->cases, wcut_sweep_state_name((wcut_sweep_state)s));
}

static void print_counts(const wcut_sweep_counts *counts) {
    printf("{\n  \"format\": \"wirecut-sweep-status/1\",\n  \"cases\": %d", counts->cases);
    for (int s = 0; s < WCUT_SWEEP_STATE_COUNT; s++)
        printf(",\n  \"%s\": %d", wcut_sweep_state_name((wcut_sweep_state)s), counts->state[s]);
    printf("\n}\n");
}

static int show_status(const app_call *call, const wcut_sweep *sweep) {
    wcut_error error = {0};
    wcut_sweep_counts counts;
    const wcut_status status = wcut_sweep_query(sweep, &counts, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    if (app_given(call, "json")) print_counts(&counts);
    if (!app_given(call, "quiet")) say_counts(&counts);
    return unfinished(&counts) ? APP_FAILED : APP_DONE;
}

static int write_sweep_results(app_results *results, const wcut_sweep *sweep) {
    wcut_error error = {0};
    char *text = NULL;
    wcut_status status = wcut_sweep_write_csv(sweep, app_results_path(results, "sweep.csv"), &error);
    int code = app_results_add(results, "sweep.csv", status, &error);
    if (code != APP_DONE) return code;
    status = wcut_report_sweep_write(sweep, app_results_path(results, "report.html"), &error);
    code = app_results_add(results, "report.html", status, &error);
    if (code != APP_DONE) return code;
    status = wcut_sweep_print(sweep, &text, &error);
    return app_results_commit(results, "sweep.json", status, text);
}

/* the table, the page and the summary of what there is; 1 where a case is not there for good */
static int collect(const app_call *call, const wcut_sweep *sweep, const char *folder) {
    /* the set of results, replaced together */
    wcut_error error = {0};
    app_results results = {0};
    int code = app_results_begin(&results, folder, result_name);
    if (code == APP_DONE) code = write_sweep_results(&results, sweep);
    if (code == APP_DONE && app_given(call, "json")) fputs(results.text, stdout);

    /* how the cases ended, in words and by the exit code */
    wcut_sweep_counts counts;
    if (code == APP_DONE) {
        const wcut_status status = wcut_sweep_query(sweep, &counts, &error);
        if (status != WCUT_OK) code = app_fail_status(status, NULL, &error);
    }

    /* counts of the states, and the files */
    if (code == APP_DONE && !app_given(call, "quiet")) {
        say_counts(&counts);
        app_say("in %s: %s", folder, app_results_list(&results));
    }

    /* a rerun completes what is unfinished */
    if (code == APP_DONE && unfinished(&counts))
        code = app_fail(APP_FAILED, "%d of %d cases did not come to their end; the same command runs them again",
                        unfinished(&counts), counts.cases);
    app_results_end(&results);
    return code;
}

/* ---- how much it is ---- */

/* time and disk of one case, and of all: in a folder that is gone afterwards */
static int measure(const app_call *call, const char *scratch) {
    char program[PATH_MAX], table[PATH_MAX + 16];
    wcut_error error = {0};

    /* plan the study in the temporary folder */
    wcut_sweep *sweep = NULL;
    double seconds = 0, total = 0, bytes = 0;
    int code = app_sweep_program(program);
    if (code != APP_DONE) return code;
    wcut_status status = wcut_sweep_create(call->operand[0], scratch, &sweep, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    code = check_study_call(call->operand[0], wcut_sweep_view(sweep));

    /* its figures are those that the table asks for */
    if (code == APP_DONE) {
        watch seen = {.sweep = sweep, .checked = true};
        const wcut_sweep_options options = pool_options(call, sweep, program, &seen);
        app_catch_interrupts();
        snprintf(table, sizeof table, "%s/sweep.csv", scratch);
        status = wcut_sweep_measure(sweep, &options, &seconds, &total, &bytes, &error);
        if (status == WCUT_OK) status = wcut_sweep_write_csv(sweep, table, &error);
        if (status != WCUT_OK) code = app_fail_status(status, NULL, &error);
    }

    /* figures of one case, and estimates for all */
    const int cases = wcut_study_view(wcut_sweep_view(sweep))->cases, jobs = app_int(call, "jobs");
    if (code == APP_DONE && app_given(call, "json"))
        printf(
            "{\n  \"format\": \"wirecut-sweep-dry-run/1\",\n  \"cases\": %d,\n  \"jobs\": %d,\n"
            "  \"case_s\": %.3g,\n  \"total_s\": %.3g,\n  \"disk_bytes\": %.0f\n}\n",
            cases, jobs, seconds, total, bytes);
    if (code == APP_DONE && !app_given(call, "quiet"))
        app_say("%d cases: %.3g s each, %.3g s with %d processes; %.3g MB on disk", cases, seconds, total, jobs,
                bytes / 1e6);
    wcut_sweep_destroy(sweep);
    return code;
}

static int dry_run(const app_call *call) {
    char scratch[PATH_MAX];
    int code = app_scratch_make(scratch);
    if (code != APP_DONE) return code;
    code = measure(call, scratch);
    app_scratch_remove(scratch);
    return code;
}

/* ---- the verb ---- */

/* a sweep that was planned: its state, its table, or a share of its cases */
static int continue_sweep(const app_call *call) {
    wcut_error error = {0};
    wcut_sweep *sweep = NULL;
    const char *folder = call->operand[0];
    const wcut_status status = wcut_sweep_read(folder, &sweep, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    int code = APP_DONE;
    if (app_given(call, "task")) code = run_cases(call, sweep, app_int(call, "task"), app_int(call, "tasks"));
    if (code == APP_DONE && app_given(call, "collect"))
        code = collect(call, sweep, folder);
    else if (code == APP_DONE && app_given(call, "status"))
        code = show_status(call, sweep);
    wcut_sweep_destroy(sweep);
    return code;
}

/* plan, then run here or hand over */
static int begin_sweep(const app_call *call) {
    wcut_error error = {0};
    wcut_study *study = NULL;
    wcut_sweep *sweep = NULL;
    const char *path = call->operand[0], *folder = app_text(call, "output");

    /* what is wrong with the study is said before there is a folder */
    wcut_status status = wcut_study_read(path, &study, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    int code = check_study_call(path, study);
    wcut_study_destroy(study);
    if (code != APP_DONE) return code;

    /* plan the cases, then give them to Slurm or run them here */
    status = wcut_sweep_create(path, folder, &sweep, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    if (app_given(call, "slurm") || app_given(call, "slurm-script")) {
        code = app_sweep_slurm(call, sweep);
    } else {
        code = run_cases(call, sweep, 0, 1);
        if (code == APP_DONE) code = collect(call, sweep, folder);
    }
    wcut_sweep_destroy(sweep);
    return code;
}

static int sweep_verb(const app_call *call) {
    if (app_given(call, "status") || app_given(call, "collect") || app_given(call, "task")) return continue_sweep(call);
    if (app_given(call, "dry-run")) return dry_run(call);
    if (!app_given(call, "output"))
        return app_fail(APP_USAGE,
                        "--output is missing: expected -o DIR with a study, or --status or --collect with the folder "
                        "of a sweep (see wirecut sweep --help)");
    return begin_sweep(call);
}

static const app_operand operand[] = {
    {.name = "STUDY",
     .kind = APP_FILE,
     .help = "a study, wirecut-study/1; for --status and --collect a sweep's folder"},
    {.name = NULL},
};

static const app_option option[] = {
    {.kind = APP_FOLDER,
     .name = "output",
     .letter = 'o',
     .value = "DIR",
     .help = "folder of the sweep; it is created if missing"},
    {.kind = APP_INT,
     .name = "jobs",
     .letter = 'j',
     .value = "N",
     .low = 1,
     .high = WCUT_SWEEP_JOBS_MAX,
     .standard = DEFAULT_JOBS,
     .help = "processes at a time; with Slurm those of a task"},
    {.kind = APP_FLAG,
     .name = "resume",
     .help = "run the cases that are not whole, and those alone: always so, for scripts that say it"},
    {.kind = APP_FLAG,
     .name = "dry-run",
     .help = "say how many cases there are, how long they take (from the first one, which is run) and how much disk"},
    {.kind = APP_FLAG, .name = "status", .help = "say how the cases of a sweep's folder stand; 1 unless all are whole"},
    {.kind = APP_FLAG, .name = "collect", .help = "write the table of a sweep's folder anew"},
    {.kind = APP_INT,
     .name = "task",
     .value = "I",
     .low = 0,
     .high = 99999,
     .help = "run the I-th share of a sweep's folder, of --tasks"},
    APP_OPTIONS_SLURM,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_sweep = {
    .name = "sweep",
    .brief = "run a verb for many variants of its input, here or by Slurm, and collect figures",
    .about =
        "A study names an input, the parameters that vary in it (JSON pointers and options), how they are combined "
        "(grid, zip, rows of a CSV, Latin hypercube, Sobol), the verb to run and the figures to collect. Each case "
        "runs in its own process and its own folder, cases/HH/HASH, named by the SHA-256 of its content. A case whose "
        "files are whole is not run again: after an interruption the same command continues the sweep. A case that "
        "fails or crashes is recorded in its case.json with the end of its output and does not stop the others.\n"
        "Writes into DIR: sweep.csv (one row per case: parameters, figures, status; the same bytes whatever the "
        "order), report.html (parallel coordinates, scatter, the best cases) and sweep.json; before the first case "
        "plan.json, "
        "study.json, input.json and manifest.csv, the list of the cases.\n"
        "--slurm submits an array job. Each task runs its share; submit again to run what was lost, then --collect. "
        "--status and --collect work on any machine that can read the folder.",
    .operand = operand,
    .option = option,
    .run = sweep_verb,
};
