/* wirecut facade: a description of many elements to their cuts, and to the whole of them. */
#include "facade.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/wirecut.h>

#include "results.h"
#include "sweep.h"
#include "terminal.h"

/* what is collected, in the order written */
static const char *const result_name[] = {"facade.glb",  "facade.step", "facade.csv",
                                          "report.html", "facade.json", NULL};

typedef struct facade_run {
    const app_call *call;
    const char *folder;
    wcut_element_options options;
    wcut_facade_description *description;
    wcut_sweep *sweep;
    wcut_facade_results *results;
    app_results files;
} facade_run;

/* ---- the elements ---- */

/* the bar counts from 0 what the library counts from 1 */
static int step_elements(int looked, int cases, void *context) {
    return looked > 0 ? app_progress_step(looked - 1, cases, context) : app_is_interrupted();
}

/* processes side by side: all processors where nothing is said */
static int processes(const app_call *call) {
    if (app_given(call, "jobs")) return app_int(call, "jobs");
    const long online = sysconf(_SC_NPROCESSORS_ONLN);
    return online < 1 ? 1 : online > WCUT_SWEEP_JOBS_MAX ? WCUT_SWEEP_JOBS_MAX : (int)online;
}

static int run_elements(facade_run *r) {
    char program[PATH_MAX];
    wcut_error error = {0};
    wcut_sweep_counts counts;
    const int code = app_sweep_program(program);
    if (code != APP_DONE) return code;

    /* those that are not whole; an interrupt ends the processes */
    app_progress bar = app_progress_begin(app_given(r->call, "quiet"));
    bar.unit = "elements";
    wcut_sweep_options options = wcut_sweep_options_default();
    options.program = program;
    options.jobs = processes(r->call);
    options.progress = step_elements;
    options.context = &bar;
    app_catch_interrupts();
    const wcut_status status = wcut_sweep_run(r->sweep, &options, &counts, &error);
    app_progress_end(&bar);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    if (!app_given(r->call, "quiet"))
        app_say("%d placements, %d distinct; %d run now, %d were whole", r->description->facade->elements, counts.cases,
                counts.ran, counts.cases - counts.ran);
    return APP_DONE;
}

/* ---- the whole ---- */

static bool has_any_face(const wcut_facade_results *results) {
    for (int k = 0; k < results->distinct; k++)
        if (results->face[k]) return true;
    return false;
}

static int write_facade(facade_run *r) {
    wcut_error error = {0};
    app_results *files = &r->files;
    int code = APP_DONE;

    /* geometry, where there is any */
    if (has_any_face(r->results)) {
        wcut_status status = wcut_facade_write_glb(r->results, app_results_path(files, "facade.glb"), &error);
        code = app_results_add(files, "facade.glb", status, &error);
        if (code != APP_DONE) return code;
        status = wcut_facade_write_step(r->results, app_results_path(files, "facade.step"), &error);
        code = app_results_add(files, "facade.step", status, &error);
    }

    /* table, page, and the document that vouches for them */
    if (code == APP_DONE) {
        const wcut_status status = wcut_facade_write_csv(r->results, app_results_path(files, "facade.csv"), &error);
        code = app_results_add(files, "facade.csv", status, &error);
    }
    if (code == APP_DONE) {
        const wcut_status status =
            wcut_report_facade_write(r->results, r->call->operand[0], app_results_path(files, "report.html"), &error);
        code = app_results_add(files, "report.html", status, &error);
    }
    if (code != APP_DONE) return code;
    char *text = NULL;
    const wcut_status status = wcut_facade_print(r->results, &text);
    return app_results_commit(files, "facade.json", status, text);
}

/* every distinct element that cannot be made, once, and what is left at the joints; gives an exit code */
static int say_facade(const facade_run *r) {
    const wcut_facade *f = r->description->facade;
    int infeasible = 0;
    for (int k = 0; k < f->elements; k++) {
        const wcut_facade_item *item = &r->results->item[k];
        if (item->feasible) continue;
        infeasible++;
        bool first = true;
        for (int i = 0; i < k; i++) first = first && r->results->item[i].distinct != item->distinct;
        if (first)
            app_say("element %d (row %d, column %d): %s", k, f->element[k].row, f->element[k].column,
                    item->reason[0] ? item->reason : wcut_sweep_state_name(item->state));
    }

    /* the joints in two figures */
    double step = 0, angle = 0;
    for (int j = 0; j < f->joints; j++) {
        if (r->results->joint[j].step_max > step) step = r->results->joint[j].step_max;
        if (r->results->joint[j].angle_max > angle) angle = r->results->joint[j].angle_max;
    }
    if (!app_given(r->call, "quiet")) {
        app_say("%d joints: faces as cut differ by up to %.3g mm, kinks up to %.3g deg", f->joints, step,
                angle * WCUT_DEG_PER_RAD);
        app_say("in %s: %s", r->folder, app_results_list(&r->files));
    }
    if (infeasible == 0) return APP_DONE;
    return app_fail(APP_NOT_CONVERGED, "%d of %d elements cannot be made as described; the others are on disk",
                    infeasible, f->elements);
}

/* an element that was stopped by something else than its own content is to be run again */
static int unfinished_elements(const wcut_facade_results *results, int elements) {
    int count = 0;
    for (int k = 0; k < elements; k++) {
        const wcut_sweep_state state = results->item[k].state;
        count +=
            state == WCUT_SWEEP_STATE_MISSING || state == WCUT_SWEEP_STATE_FAILED || state == WCUT_SWEEP_STATE_CRASHED;
    }
    return count;
}

static int collect_facade(facade_run *r) {
    wcut_error error = {0};
    int code = app_results_begin(&r->files, r->folder, result_name);
    if (code != APP_DONE) return code;
    const wcut_status status = wcut_facade_results_read(r->description, &r->options, r->sweep, &r->results, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);

    /* the files, then what to know of them */
    code = write_facade(r);
    if (code == APP_DONE && app_given(r->call, "json")) fputs(r->files.text, stdout);
    if (code == APP_DONE) code = say_facade(r);
    const int unfinished = unfinished_elements(r->results, r->description->facade->elements);
    if (unfinished > 0 && (code == APP_DONE || code == APP_NOT_CONVERGED))
        code =
            app_fail(APP_FAILED, "%d elements did not come to their end; the same command runs them again", unfinished);
    return code;
}

/* ---- the verb ---- */

static int run_facade(const app_call *call) {
    int code = app_check_formats(call, APP_FACADE_FORMATS);
    if (code != APP_DONE) return code;
    if (app_given(call, "element")) return app_facade_element(call);

    /* what is made of every element */
    wcut_error error = {0};
    facade_run r = {.call = call, .folder = app_text(call, "output"), .options = wcut_element_options_default()};
    if (app_given(call, "thickness")) r.options.thickness = app_real(call, "thickness");
    r.options.density = app_real(call, "density");
    r.options.moulds = app_given(call, "moulds");
    r.options.chord_tolerance = app_real(call, "chord-tolerance");
    r.options.formats = app_text(call, "formats");

    /* what is wrong with the description is said before there is a folder */
    wcut_status status = wcut_facade_read(call->operand[0], &r.description, &error);
    if (status == WCUT_OK) status = wcut_facade_sweep_create(r.description, &r.options, r.folder, &r.sweep, &error);
    code = status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
    if (code == APP_DONE) code = run_elements(&r);
    if (code == APP_DONE) code = collect_facade(&r);
    app_results_end(&r.files);
    wcut_facade_results_destroy(r.results);
    wcut_sweep_destroy(r.sweep);
    wcut_facade_description_destroy(r.description);
    return code;
}

static double default_density(void) { return wcut_element_options_default().density; }

static const app_operand operand[] = {
    {.name = "FACADE", .kind = APP_FILE, .help = "a facade, wirecut-facade/1; with --element one of its elements"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_INT,
     .name = "jobs",
     .letter = 'j',
     .value = "N",
     .low = 1,
     .high = WCUT_SWEEP_JOBS_MAX,
     .help = "elements at a time, each in a process; all processors where it is not given"},
    {.kind = APP_FLAG, .name = "moulds", .help = "both halves of every distinct element, as STL and STEP"},
    {.kind = APP_REAL,
     .name = "thickness",
     .value = "MM",
     .low = 1e-3,
     .high = 1e4,
     .help = "make the panel that is cast on every face, mm: closed, as STL and STEP, with volume and weight"},
    {.kind = APP_REAL,
     .name = "density",
     .value = "KG/M3",
     .low = 1e-3,
     .high = 1e5,
     .library = default_density,
     .help = "density of the panels, kg/m3"},
    APP_OPTION_CHORD_TOLERANCE,
    {.kind = APP_TEXT,
     .name = "formats",
     .value = "LIST",
     .standard = "csv,step",
     .help = "files of every element's cut, with commas: some of " APP_FACADE_FORMATS},
    {.kind = APP_FLAG,
     .name = "element",
     .help = "run one element, wirecut-element/1, the input.json of its folder: what a facade does with each"},
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_facade = {
    .name = "facade",
    .brief = "cut the elements of a facade and put them together",
    .about =
        "A facade is a lattice of elements on a plane, a cylinder or a surface, or a list of placements. Edges and the "
        "wire's extra length come from fields over the facade, or elements follow jobs of their own, or variants that "
        "a "
        "rule deals. Neighbours share one edge curve, so that they meet.\n"
        "Equal elements are cut once. Each distinct one is run in its own process and its own folder, cases/HH/HASH, "
        "with its job (input.json), path.csv, job-path.json, report.html and element.json. One that is whole is not "
        "run again: after an interruption the same command goes on. One that cannot be cut is reported and does not "
        "stop the others.\n"
        "Writes into DIR: facade.glb (an instance of its mesh for each element, coloured by the force), facade.step "
        "(an "
        "assembly of the exact faces, each distinct one once), facade.csv (a row for each element), report.html (the "
        "whole facade to turn, to pick from and to sort) and facade.json. The face of an element is that of its cut, "
        "carried to the shared edges; how far is in moved_max_mm, and the step between neighbours without it in "
        "joint_step_max_mm.",
    .operand = operand,
    .option = option,
    .run = run_facade,
};
