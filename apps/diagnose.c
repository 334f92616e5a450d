/* wirecut diagnose: a case to what explains it, what that is worth on other cuts, and the job that knows it. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/diagnosis.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "recording.h"
#include "results.h"
#include "terminal.h"

/* what a run may leave in its folder, in the order written */
static const char *const result_name[] = {"job-improved.json", "next-experiment.json", "report.html", "diagnosis.json",
                                          NULL};

/* a cut of the case as far as its files could be read */
typedef struct trial {
    wcut_job *job;
    wcut_recording *recording;
    wcut_cloud *scan;
} trial;

typedef struct run {
    const app_call *call;
    wcut_case *found;
    trial *trial; /* found->cuts */
    wcut_diagnosis_cut *cut;
    int test_cuts;
    wcut_test_cut *calibration;
    wcut_diagnosis_options options;
    wcut_rig_prior rig;    /* of --rig */
    wcut_recording *still; /* of --still */
    wcut_diagnosis *diagnosis;
    bool failed;  /* memory ran out */
    bool stopped; /* memory ran out for an input, or it has no hash: said, and nothing is written */
    int said, sources;
    char **said_text;               /* 2 found->cuts + 1 */
    char **cut_name;                /* found->cuts */
    wcut_report_source *source;     /* 3 found->cuts + 2 */
    char (*hash)[WCUT_SHA256_TEXT]; /* of the sources */
    int code;                       /* of the first file that could not be read */
    app_results results;
} run;

/* ---- options ---- */

static int leave_diagnose_out(run *r, const char *name) {
    const char *names[WCUT_EFFECT_COUNT + 1] = {NULL};
    wcut_effect_kind kind;
    if (wcut_effect_locate(name, &kind) == WCUT_OK) {
        r->options.without[kind] = true;
        return APP_DONE;
    }
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) names[k] = wcut_effect_view((wcut_effect_kind)k)->name;
    const char *near = app_suggest(name, names);
    return app_fail(APP_USAGE, "diagnose: --without: found \"%s\", expected an effect's name%s%s", name,
                    near ? "; did you mean " : "", near ? near : "");
}

static int read_diagnose_options(run *r) {
    /* defaults, as many threads as there are processors */
    r->options = wcut_diagnosis_options_default();
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    r->options.threads = app_given(r->call, "threads") ? app_int(r->call, "threads")
                         : processors > 0              ? (int)processors
                                                       : 1;

    /* the seed makes the run repeatable */
    r->options.seed = (unsigned long long)app_int(r->call, "seed");
    r->options.proof = !app_given(r->call, "no-proof");
    r->options.naive = app_given(r->call, "naive");

    /* effects to leave out, separated by commas */
    if (!app_given(r->call, "without")) return APP_DONE;
    const char *list = app_text(r->call, "without");
    int code = APP_DONE;
    while (code == APP_DONE) {
        const int length = (int)strcspn(list, ",");
        char name[256];
        snprintf(name, sizeof name, "%.*s", length, list);
        code = leave_diagnose_out(r, name);
        if (!list[length]) break;
        list += length + 1;
    }

    return code;
}

/* ---- what is there ---- */

static int fail_diagnose_memory(void) { return app_fail_status(WCUT_NO_MEMORY, "diagnose", NULL); }

/* a, b and c in one text, to free() */
static char *join_diagnose(run *r, const char *a, const char *b, const char *c) {
    const size_t size = strlen(a) + strlen(b) + strlen(c) + 1;
    char *text = malloc(size);
    if (text)
        snprintf(text, size, "%s%s%s", a, b, c);
    else
        r->failed = true;
    return text;
}

/* a file that cannot be read is said, here and on the page, and the diagnosis goes on without it */
static void note_diagnose_bad(run *r, wcut_status status, const wcut_error *error, const char *loss) {
    const int code = app_fail_status(status, NULL, error);
    if (r->code == APP_DONE || status == WCUT_NO_MEMORY) r->code = code;
    r->stopped = r->stopped || status == WCUT_NO_MEMORY;
    r->said_text[r->said++] = join_diagnose(r, error->text, ": ", loss);
}

static void note_source(run *r, const char *role, const char *path) {
    char *hash = r->hash[r->sources];
    wcut_error error = {0};
    const wcut_status status = wcut_source_hash(path, hash, &error);
    r->source[r->sources++] = (wcut_report_source){role, path, hash[0] ? hash : NULL};
    if (status == WCUT_OK) return;
    r->code = app_fail_status(status, NULL, &error);
    r->stopped = true;
}

static void read_diagnose_cut(run *r, int i) {
    const wcut_case_cut *files = &r->found->cut[i];
    trial *t = &r->trial[i];
    wcut_error error = {0};

    /* job and recording; without one of them the cut is left out */
    wcut_status status = app_job_read_cut(r->call, files->job, &t->job, &error);
    if (status == WCUT_OK)
        note_source(r, "job", files->job);
    else
        note_diagnose_bad(r, status, &error, "the cut is left out");
    if (status == WCUT_OK) {
        status = wcut_recording_read(files->recording, &r->found->format, &t->recording, &error);
        if (status == WCUT_OK)
            note_source(r, "recording", files->recording);
        else
            note_diagnose_bad(r, status, &error, "the cut is left out");
    }

    /* stations from positions, where the file has none */
    if (status == WCUT_OK) {
        status = wcut_recording_place(t->job, t->recording, &error);
        if (status != WCUT_OK) {
            note_diagnose_bad(r, status, &error, "the cut is left out");
            wcut_recording_destroy(t->recording);
            t->recording = NULL;
        }
    }

    /* a recording that cannot belong to its job is left out, a doubtful one is kept */
    wcut_doubt doubt[WCUT_DOUBTS_MAX];
    int doubts = 0;
    if (status == WCUT_OK) status = wcut_recording_check(t->job, t->recording, &doubts, doubt);
    for (int k = 0; k < doubts; k++) {
        if (doubt[k].certain) {
            note_diagnose_bad(r, doubt[k].error.status, &doubt[k].error, "the cut is left out");
            wcut_recording_destroy(t->recording);
            t->recording = NULL;
            status = doubt[k].error.status;
            break;
        }
        app_say("%s: warning: %s", files->recording, doubt[k].error.text);
    }

    /* a scan is not required */
    if (status == WCUT_OK && files->scan) {
        status = wcut_cloud_read(files->scan, NULL, &t->scan, &error);
        if (status == WCUT_OK)
            note_source(r, "scan", files->scan);
        else
            note_diagnose_bad(r, status, &error, "the cut is diagnosed without its scan");
    }

    /* what is missing stays NULL, and the diagnosis says so */
    r->cut[i] = (wcut_diagnosis_cut){.job = t->job, .recording = t->recording, .scan = t->scan};
}

static void read_diagnose_calibration(run *r) {
    if (!r->found->calibration) return;
    wcut_error error = {0};
    const wcut_status status =
        wcut_calibration_table_read(r->found->calibration, NULL, &r->test_cuts, &r->calibration, &error);
    if (status == WCUT_OK)
        note_source(r, "calibration", r->found->calibration);
    else
        note_diagnose_bad(r, status, &error, "diagnosed without the calibration table");
}

/* what the cell knows of itself, and what its sensors read at rest */
static int read_diagnose_cell(run *r) {
    wcut_error error = {0};
    if (app_given(r->call, "rig")) {
        const char *path = app_text(r->call, "rig");
        const wcut_status status = wcut_rig_prior_read(path, &r->rig, &error);
        if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
        r->options.rig = &r->rig;
        note_source(r, "rig", path);
    }
    if (app_given(r->call, "still")) {
        const char *path = app_text(r->call, "still");
        const wcut_status status = wcut_recording_read(path, &r->found->format, &r->still, &error);
        if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
        r->options.still = r->still;
        note_source(r, "record at rest", path);
    }
    return APP_DONE;
}

static int load_diagnose(run *r) {
    /* options, then the case */
    wcut_error error = {0};
    const char *path = r->call->operand[0];
    int code = read_diagnose_options(r);
    if (code != APP_DONE) return code;
    const wcut_status status = wcut_case_read(path, &r->found, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    code = app_recording_format(r->call, &r->found->format);
    if (code != APP_DONE) return code;

    /* room for every cut and its files */
    const size_t n = (size_t)r->found->cuts;
    r->trial = calloc(n, sizeof *r->trial);
    r->cut = calloc(n, sizeof *r->cut);
    r->cut_name = calloc(n, sizeof *r->cut_name);
    r->said_text = calloc(2 * n + 1, sizeof *r->said_text);
    r->source = calloc(3 * n + 4, sizeof *r->source);
    r->hash = calloc(3 * n + 4, sizeof *r->hash);
    if (!r->trial || !r->cut || !r->cut_name || !r->said_text || !r->source || !r->hash) return fail_diagnose_memory();

    /* the files, as many as can be read */
    note_source(r, "case", path);
    code = read_diagnose_cell(r);
    if (code != APP_DONE) return code;
    int usable = 0;
    for (int i = 0; i < r->found->cuts && !r->stopped; i++) {
        read_diagnose_cut(r, i);
        usable += r->trial[i].recording != NULL;
    }
    if (!r->stopped) read_diagnose_calibration(r);
    if (r->stopped) return r->code;
    if (r->failed) return fail_diagnose_memory();

    /* at least one cut must be usable */
    if (usable > 0) return APP_DONE;

    return app_fail(r->code, "%s: no cut with a job and a recording that can be read", path);
}

/* ---- the run ---- */

static int diagnose_case(run *r) {
    wcut_error error = {0};
    app_progress progress = app_progress_begin(app_given(r->call, "quiet"));
    progress.unit = "steps";
    const wcut_status status = wcut_diagnosis_create(r->found->cuts, r->cut, r->test_cuts, r->calibration, &r->options,
                                                     app_progress_step, &progress, &r->diagnosis, &error);
    app_progress_end(&progress);
    if (status == WCUT_INTERRUPTED) return app_fail_status(status, r->call->operand[0], &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, r->call->operand[0], &error);
}

/* ---- the files ---- */

static int write_job(run *r, const wcut_job *job, const char *name) {
    wcut_error error = {0};
    if (!job) return APP_DONE;
    const wcut_status status = wcut_job_write(job, app_results_path(&r->results, name), &error);
    return app_results_add(&r->results, name, status, &error);
}

/* "2 free form": what a cut is called on the page */
static char *name_cut(run *r, int i) {
    const wcut_job *job = r->trial[i].job;
    char number[16];
    snprintf(number, sizeof number, "%d", i + 1);
    return join_diagnose(r, number, " ", job && job->name ? job->name : r->found->cut[i].job);
}

static int write_diagnose_report(run *r) {
    /* names of the cuts as the page shows them */
    const wcut_diagnosis *d = r->diagnosis;
    wcut_error error = {0};
    for (int i = 0; i < r->found->cuts; i++) r->cut_name[i] = name_cut(r, i);
    if (r->failed) return fail_diagnose_memory();

    /* how the diagnosis was made */
    const wcut_report_fact option[] = {
        {"effects left out", app_given(r->call, "without") ? app_text(r->call, "without") : "none", 0, ""},
        {"forward proof", r->options.proof ? "run" : "not run", 0, ""},
        {"seed", NULL, (double)r->options.seed, ""}};

    /* the page */
    const wcut_report_diagnose page = {.title = r->found->name,
                                       .diagnosis = d,
                                       .cut_name = (const char *const *)r->cut_name,
                                       .said = r->said,
                                       .said_text = (const char *const *)r->said_text,
                                       .options = sizeof option / sizeof *option,
                                       .option = option,
                                       .sources = r->sources,
                                       .source = r->source};
    const wcut_status status = wcut_report_diagnose_write(&page, app_results_path(&r->results, "report.html"), &error);

    return app_results_add(&r->results, "report.html", status, &error);
}

/* what a run leaves in its folder, under diagnosis.json */
static int write_diagnose_results(run *r) {
    char *text = NULL;
    int code = write_job(r, r->diagnosis->improved, "job-improved.json");
    if (code == APP_DONE) code = write_job(r, r->diagnosis->next_experiment, "next-experiment.json");
    if (code == APP_DONE) code = write_diagnose_report(r);
    if (code != APP_DONE) return code;
    const wcut_status status = wcut_diagnosis_print(r->diagnosis, r->found->name, &text);
    return app_results_commit(&r->results, "diagnosis.json", status, text);
}

/* ---- the summary ---- */

static void print_effects(const wcut_diagnosis *d) {
    for (int e = 0; e < d->effects; e++) {
        const wcut_found_effect *f = &d->effect[e];
        const wcut_effect_info *info = wcut_effect_view(f->effect.kind);
        printf("  %-8s %s", f->present ? "present" : "possible", info->name);
        if (info->choice_key) printf(", %s %s", info->choice_key, info->choice[f->effect.choice]);
        printf(" (confidence %.2f)", f->confidence);
        for (const wcut_effect_parameter *p = wcut_effect_parameters(&f->effect); p->key; p++)
            for (int k = 0; k < p->size; k++)
                if (f->estimated[p->at + k])
                    printf("%s %s %.4g [%.4g, %.4g]", k ? "," : ";", k ? "" : p->key, f->effect.value[p->at + k],
                           f->parameter[p->at + k].low, f->parameter[p->at + k].high);
        printf("\n");
    }
}

static void print_figure(const wcut_evidence_score *f) {
    if (f->count > 0)
        printf(" %12.4f", f->rmse_over_range);
    else
        printf(" %12s", "-");
}

/* of held-out cuts where there are any, else of all */
static void print_fits(const wcut_diagnosis *d) {
    bool held = false;
    for (int i = 0; d->held_out && i < d->cuts; i++) held = held || d->held_out[i];
    printf("RMSE over range, %-14s %12s %12s %12s\n", held ? "held-out cuts" : "all cuts", "before", "recalibrated",
           "after");
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
        if (d->score[WCUT_EVIDENCE_MODEL_BEFORE][c].count < 1) continue;
        printf("  %-29s", wcut_evidence_name((wcut_evidence_channel)c));
        for (int m = WCUT_EVIDENCE_MODEL_BEFORE; m <= WCUT_EVIDENCE_MODEL_AFTER; m++)
            print_figure(held ? &d->held_out_score[m][c] : &d->score[m][c]);
        printf("\n");
    }
}

static void print_diagnose_summary(const run *r) {
    const wcut_diagnosis *d = r->diagnosis;
    printf("%s\n", d->sentence);
    printf("verdict %s, confidence %.2f\n", wcut_verdict_name(d->kind), d->confidence);
    print_effects(d);
    print_fits(d);
    if (d->next_experiment) printf("next experiment: %s\n", d->next_reason);
}

static void give_diagnose_summary(const run *r) {
    const bool quiet = app_given(r->call, "quiet");
    if (!quiet) app_say("in %s: %s", r->results.folder, app_results_list(&r->results));
    if (app_given(r->call, "json"))
        fputs(r->results.text, stdout);
    else if (!quiet)
        print_diagnose_summary(r);
}

static void forget_diagnose(run *r) {
    for (int i = 0; r->trial && i < r->found->cuts; i++) {
        wcut_cloud_destroy(r->trial[i].scan);
        wcut_recording_destroy(r->trial[i].recording);
        wcut_job_destroy(r->trial[i].job);
    }
    for (int i = 0; i < r->said; i++) free(r->said_text[i]);
    for (int i = 0; r->cut_name && i < r->found->cuts; i++) free(r->cut_name[i]);
    wcut_test_cut_destroy(r->calibration);
    wcut_recording_destroy(r->still);
    wcut_diagnosis_destroy(r->diagnosis);
    wcut_case_destroy(r->found);
    free(r->hash);
    free(r->source);
    free(r->said_text);
    free(r->cut_name);
    free(r->cut);
    free(r->trial);
}

static int diagnose(const app_call *call) {
    run r = {.call = call};
    int code = load_diagnose(&r);
    if (code == APP_DONE) code = app_results_begin(&r.results, app_text(call, "output"), result_name);
    if (code == APP_DONE) {
        app_catch_interrupts();
        code = diagnose_case(&r);
        if (r.diagnosis) {
            const int written = write_diagnose_results(&r);
            if (written != APP_DONE) code = written;
            if (written == APP_DONE) give_diagnose_summary(&r);
        }
    }
    if (code == APP_DONE) code = r.code;
    app_results_end(&r.results);
    forget_diagnose(&r);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */
static double diagnose_seed(void) { return (double)wcut_diagnosis_options_default().seed; }

static const app_operand operand[] = {
    {.name = "CASE", .kind = APP_FILE, .help = "a case file, wirecut-case/1"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_INT,
     .name = "threads",
     .value = "N",
     .low = 1,
     .high = 1024,
     .help = "number of threads; default one for each processor. Results do not depend on it"},
    APP_OPTION_FORCE_LAW,
    APP_OPTIONS_RECORDING,
    {.kind = APP_FILE,
     .name = "rig",
     .value = "FILE",
     .help = "what the cell knows of itself, wirecut-rig/1; samples/rig.json holds the defaults"},
    {.kind = APP_FILE,
     .name = "still",
     .value = "FILE",
     .help = "a recording with standing mounts and a slack, cold wire: its tensions are the zeros of the sensors"},
    {.kind = APP_EFFECTS,
     .name = "without",
     .value = "EFFECT,...",
     .help = "effects to leave out of the library, by their names in job files"},
    {.kind = APP_FLAG, .name = "no-proof", .help = "do not run the prediction of held-out cuts and the black box"},
    {.kind = APP_FLAG, .name = "naive", .help = "also run plain least squares, to show which effect it would name"},
    {.kind = APP_INT,
     .name = "seed",
     .value = "N",
     .low = 0,
     .high = 2147483647,
     .library = diagnose_seed,
     .help = "seed of the simulated noise"},
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_diagnose = {
    .name = "diagnose",
    .brief = "explain the difference between recordings, scans and simulation of a case",
    .about =
        "Recalibrates a, b and the wire's length, locates the mismatch that exceeds noise, fits every effect of "
        "physics and of instruments and every pair of them, and decides: physics, instrument, both, none, ambiguous or "
        "unknown. An effect is named only if it improves the prediction of cuts that were not fitted.\nWrites into "
        "DIR: diagnosis.json, report.html, job-improved.json (the first cut's job, recalibrated, with the effects "
        "found) and, where another cut would separate the alternatives, next-experiment.json. The verdict and a table "
        "go to standard "
        "output.\nA file that cannot be read is reported and left out; the command then ends with the exit code of the "
        "first such file. An interrupted diagnosis writes what was found until then, marked as incomplete.",
    .operand = operand,
    .option = option,
    .run = diagnose,
};
