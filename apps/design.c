/* wirecut design: a target surface to the job that cuts it nearest, with what it reaches and why not more. */
#include <assert.h>
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

enum { SENTENCE = 512, PANELS = 16 };

/* Of each panel its design and the job of its paths. */
#define PANEL_FILES(n) "panel-" #n "-design.json", "panel-" #n "-job.json"
#define PANELS_FILES                                                                                                \
    PANEL_FILES(1), PANEL_FILES(2), PANEL_FILES(3), PANEL_FILES(4), PANEL_FILES(5), PANEL_FILES(6), PANEL_FILES(7), \
        PANEL_FILES(8), PANEL_FILES(9), PANEL_FILES(10), PANEL_FILES(11), PANEL_FILES(12), PANEL_FILES(13),         \
        PANEL_FILES(14), PANEL_FILES(15), PANEL_FILES(16)

/* What a design may leave in its folder, in the order written. */
static const char *const result_name[] = {"design.json",    APP_SIMULATION_FILES, PANELS_FILES,
                                          "deviation.json", "feasibility.ply",    "feasibility.json",
                                          "report.html",    "summary.json",       NULL};
static const char *const panel_name[2 * PANELS] = {PANELS_FILES};

typedef struct designing {
    const app_call *call;
    const char *path; /* of the target */
    wcut_vec3 block;
    wcut_job *process;
    wcut_design_target *target;
    wcut_design_options options;
    wcut_design_map *map;
    wcut_design *design;
    wcut_design_panels *panels; /* two or more */
    app_simulation cut;
    wcut_face *face;
    wcut_deviation *deviation; /* of the design's points from the face */
    double *distance;          /* the same as numbers; NaN where it does not count */
    wcut_deviation_summary *summary;
    const wcut_deviation_summary_result *found;
    wcut_design_result result;
} designing;

/* ---- what is asked for ---- */

/* block, wire and process: of a job, or as the options say */
static int load_process(designing *d) {
    const app_call *call = d->call;
    wcut_error error = {0};
    int code = APP_DONE;
    if (app_given(call, "process")) {
        code = app_job_load(NULL, app_text(call, "process"), &d->process);
        assert(code != APP_DONE || d->process);
        if (code == APP_DONE)
            code = app_require_two_arms(d->process, app_text(call, "process"), "a design shapes a slack wire");
    } else if (!app_given(call, "force-law")) {
        code = app_fail(APP_USAGE, "expected --process JOB.json, or --force-law FILE with --heat and --tension");
    } else {
        const wcut_status status = wcut_job_create(&d->process);
        if (status != WCUT_OK) return app_fail_status(status, NULL, NULL);
        d->process->wire_diameter = 0.15;
        d->process->heat = 65, d->process->tension = 2, d->process->clearance = 80;
        d->process->nodes = 121;
    }
    if (code != APP_DONE) return code;

    /* a path is not used: its count is that of the job, not of the options */
    free(d->process->mount_a);
    free(d->process->mount_b);
    d->process->mount_a = d->process->mount_b = NULL;

    /* options before the job's own */
    if (app_given(call, "heat")) d->process->heat = app_real(call, "heat");
    if (app_given(call, "tension")) d->process->tension = app_real(call, "tension");
    if (app_given(call, "clearance")) d->process->clearance = app_real(call, "clearance");
    if (app_given(call, "nodes")) d->process->nodes = app_int(call, "nodes");
    d->process->stations = app_int(call, "stations");
    d->process->block_size = d->block;
    if (!app_given(call, "force-law")) return APP_DONE;
    const wcut_status status = wcut_job_read_force_law(d->process, app_text(call, "force-law"), &error);
    return status == WCUT_OK ? APP_DONE
                             : app_fail_status(status, error.text[0] ? NULL : app_text(call, "force-law"), &error);
}

static void take_design_options(designing *d) {
    const app_call *call = d->call;
    const char *slash = strrchr(d->path, '/');
    d->options = wcut_design_options_default();
    d->options.feed = (wcut_design_feed)app_choice(call, "feed");
    d->options.free_edges = app_choice(call, "edge-heights") == 0;
    d->options.tolerance = app_real(call, "tolerance");
    d->options.angle_max = app_real(call, "angle") * WCUT_RAD_PER_DEG;
    d->options.threads = app_int(call, "threads");
    d->options.name = slash ? slash + 1 : d->path;
    d->result = (wcut_design_result){.target = d->path, .tolerance = d->options.tolerance};
}

/* ---- the search ---- */

/* a line for each round; asks to stop once interrupted */
static int say_round(const wcut_design_round *round, void *context) {
    const designing *d = context;
    if (!app_given(d->call, "quiet"))
        app_say("%d stations of %d nodes, %d unknowns, %d runs: %.4g mm rms, %.3g mm at most", round->stations,
                round->nodes, round->unknowns, round->runs, round->rms, round->max);
    return app_is_interrupted();
}

/* as few panels as hold the tolerance; one of them is a design as any other */
static int search_panels(designing *d) {
    wcut_error error = {0};
    const wcut_status status = wcut_design_panels_fit(d->target, d->process, &d->options, app_int(d->call, "panels"),
                                                      d->options.tolerance, say_round, d, &d->panels, &error);
    if (status != WCUT_OK && !(status == WCUT_INTERRUPTED && d->panels))
        return app_fail_status(status, d->path, &error);
    if (d->panels->count > 1) {
        d->result.panels = d->panels;
        d->result.face_rms = d->panels->rms, d->result.face_max = d->panels->max;
        return APP_DONE;
    }
    d->design = d->panels->panel[0].design;
    d->panels->panel[0].design = NULL;
    d->result.design = d->design;
    return APP_DONE;
}

static int search_design(designing *d) {
    wcut_error error = {0};
    wcut_status status = wcut_design_map_create(d->target, d->process, &d->options, &d->map, &error);
    if (status != WCUT_OK) return app_fail_status(status, d->path, &error);
    d->result.map = d->map;
    if (app_given(d->call, "feasibility-only")) return APP_DONE;
    if (app_int(d->call, "panels") > 1) return search_panels(d);
    status = wcut_design_fit(d->target, d->process, &d->options, say_round, d, &d->design, &error);
    if (status != WCUT_OK && status != WCUT_INTERRUPTED) return app_fail_status(status, d->path, &error);
    d->result.design = d->design;
    return APP_DONE;
}

/* ---- what the robot's paths cut ---- */

static int run_design(designing *d) {
    wcut_error error = {0};
    app_simulation *s = &d->cut;
    const wcut_status status = wcut_setup_create(d->design->path, NULL, &s->setup, &error);
    if (status != WCUT_OK) return app_fail_status(status, d->path, &error);
    return app_simulation_run(s);
}

/* the design's points from the face that the paths leave */
static wcut_status measure_face(designing *d) {
    const int count = d->design->points;
    wcut_projection *projection = NULL;
    wcut_deviation_summary_options options = wcut_deviation_summary_options_default();
    wcut_status status = wcut_face_create(d->cut.job, d->cut.history, NULL, NULL, APP_MERGE_MM, &d->face);
    if (status == WCUT_OK) status = wcut_projection_create(d->face->surface, &projection);
    d->deviation = calloc((size_t)count, sizeof *d->deviation);
    d->distance = calloc((size_t)count, sizeof *d->distance);
    if (status == WCUT_OK && (!d->deviation || !d->distance)) status = WCUT_NO_MEMORY;
    if (status == WCUT_OK)
        status = wcut_deviation_from_surface(projection, count, d->design->point, NULL, d->options.threads,
                                             d->deviation, NULL);

    /* what the figures count, and what the page shows */
    options.low = d->face->low, options.high = d->face->high;
    if (status == WCUT_OK) status = wcut_deviation_summary_create(&options, d->face, &d->summary);
    if (status == WCUT_OK) status = wcut_deviation_summary_add(d->summary, count, d->deviation);
    if (status == WCUT_OK) status = wcut_deviation_summary_eval(d->summary, &d->found);
    for (int k = 0; status == WCUT_OK && k < count; k++)
        d->distance[k] = d->deviation[k].place <= WCUT_PLACE_BORDER ? d->deviation[k].distance : NAN;
    if (status == WCUT_OK) {
        d->result.face_rms = d->found->statistics.rms;
        d->result.face_max = d->found->statistics.hausdorff;
    }
    wcut_projection_destroy(projection);
    return status;
}

/* ---- the files ---- */

static int write_design(designing *d) {
    wcut_error error = {0};
    app_results *results = &d->cut.results;
    wcut_status status = wcut_job_write(d->design->job, app_results_path(results, "design.json"), &error);
    const int code = app_results_add(results, "design.json", status, &error);
    if (code != APP_DONE) return code;
    status = wcut_job_write(d->design->path, app_results_path(results, "job-path.json"), &error);
    return app_results_add(results, "job-path.json", status, &error);
}

static int write_deviation(designing *d) {
    wcut_error error = {0};
    app_results *results = &d->cut.results;
    const wcut_registration none = wcut_registration_none();
    const wcut_statistics unused = {0};
    const wcut_compared_scan scan = {.name = d->path, .sha256 = "", .read = d->design->points};
    wcut_compared found = {.reference = "job-path.json",
                           .distance = "surface",
                           .scans = 1,
                           .scan = &scan,
                           .registration = &none,
                           .found = d->found,
                           .unmoved = d->found,
                           .face_to_scan = &unused,
                           .unmeasured = -1,
                           .within = d->result.face_rms <= d->result.tolerance};
    found.removed[WCUT_REMOVAL_KEPT] = d->design->points;
    const wcut_status status = wcut_deviation_write(&found, app_results_path(results, "deviation.json"), &error);
    return app_results_add(results, "deviation.json", status, &error);
}

/* the map as coloured triangles on the target */
static int write_map(designing *d) {
    wcut_error error = {0};
    app_results *results = &d->cut.results;
    const wcut_design_map *m = d->map;
    wcut_mesh *mesh = NULL;
    wcut_status status = wcut_mesh_create(m->rows * m->columns, 2 * (m->rows - 1) * (m->columns - 1), 0, &mesh);
    double limit = 1e-3;
    for (int k = 0; status == WCUT_OK && k < m->rows * m->columns; k++) {
        mesh->vertex[k] = m->point[k];
        limit = fmax(limit, fabs(m->bow[k]));
    }
    int *to = status == WCUT_OK ? mesh->triangle : NULL;
    for (int j = 0; to && j + 1 < m->rows; j++)
        for (int i = 0; i + 1 < m->columns; i++) {
            const int a = j * m->columns + i, b = a + m->columns;
            const int corner[6] = {a, a + 1, b + 1, a, b + 1, b};
            memcpy(to, corner, sizeof corner);
            to += 6;
        }
    const char *name = "feasibility.ply";
    if (status == WCUT_OK)
        status = wcut_deviation_mesh_write_ply(mesh, m->bow, NULL, limit, app_results_path(results, name), &error);
    wcut_mesh_destroy(mesh);
    const int code = app_results_add(results, name, status, &error);
    if (code != APP_DONE) return code;

    /* the same from above */
    name = "feasibility.png";
    status = wcut_design_map_write_png(m, limit, app_results_path(results, name), &error);
    return app_results_add(results, name, status, &error);
}

static int write_design_report(designing *d) {
    wcut_error error = {0};
    app_results *results = &d->cut.results;
    const wcut_report_design page = {.title = d->options.name,
                                     .block = d->design ? d->design->job->block_size : d->block,
                                     .result = &d->result,
                                     .history = d->cut.history,
                                     .deviation = d->distance};
    const wcut_status status = wcut_report_design_write(&page, app_results_path(results, "report.html"), &error);
    return app_results_add(results, "report.html", status, &error);
}

/* the map's figures: the file that vouches for the others where there is no cut */
static int write_figures(designing *d, bool last) {
    app_results *results = &d->cut.results;
    const char *name = "feasibility.json";
    if (last) {
        char *text = NULL;
        const wcut_status status = wcut_design_result_print(&d->result, &text);
        return app_results_commit(results, name, status, text);
    }
    wcut_error error = {0};
    const wcut_status status = wcut_design_result_write(&d->result, app_results_path(results, name), &error);
    return app_results_add(results, name, status, &error);
}

static int write_panels(designing *d) {
    app_results *results = &d->cut.results;
    for (int k = 0; k < d->panels->count; k++) {
        const wcut_design *one = d->panels->panel[k].design;
        for (int file = 0; file < 2; file++) {
            wcut_error error = {0};
            const char *name = panel_name[2 * k + file];
            const wcut_status status =
                wcut_job_write(file ? one->path : one->job, app_results_path(results, name), &error);
            const int code = app_results_add(results, name, status, &error);
            if (code != APP_DONE) return code;
        }
    }
    return APP_DONE;
}

static int write_design_files(designing *d) {
    int code = d->result.panels ? write_panels(d) : APP_DONE;
    if (d->design) {
        code = write_design(d);
        if (code == APP_DONE) code = app_simulation_write(&d->cut);
        if (code == APP_DONE) code = write_deviation(d);
    }
    if (code == APP_DONE) code = write_map(d);
    if (code == APP_DONE) code = write_design_report(d);
    if (code != APP_DONE) return code;
    if (!d->design) return write_figures(d, true);
    code = write_figures(d, false);
    if (code != APP_DONE) return code;
    char *text = NULL;
    const wcut_status status = wcut_summary_print(d->cut.setup, d->cut.history, &text);
    return app_results_commit(&d->cut.results, "summary.json", status, text);
}

/* ---- the verb ---- */

static void clear_designing(designing *d) {
    wcut_deviation_summary_destroy(d->summary);
    wcut_face_destroy(d->face);
    free(d->deviation);
    free(d->distance);
    d->cut.job = NULL; /* the design's */
    app_simulation_clear(&d->cut);
    wcut_design_destroy(d->design);
    wcut_design_panels_destroy(d->panels);
    wcut_design_map_destroy(d->map);
    wcut_design_target_destroy(d->target);
    wcut_job_destroy(d->process);
}

static int say_result(const designing *d) {
    char sentence[SENTENCE];
    if (wcut_design_result_say(&d->result, SENTENCE, sentence) == WCUT_OK && !app_given(d->call, "quiet"))
        app_say("%s", sentence);
    if (!app_given(d->call, "quiet")) app_say("in %s: %s", d->cut.results.folder, app_results_list(&d->cut.results));
    if (app_given(d->call, "json")) {
        char *text = NULL;
        const wcut_status status = wcut_design_result_print(&d->result, &text);
        if (status != WCUT_OK) return app_fail_status(status, NULL, NULL);
        fputs(text, stdout);
        free(text);
    }
    const bool cut = d->design || d->result.panels;
    return cut && !(d->result.face_rms <= d->result.tolerance) ? APP_OUTSIDE : APP_DONE;
}

static int run_designing(const app_call *call) {
    designing d = {.call = call, .path = call->operand[0]};
    d.cut = (app_simulation){.call = call, .path = d.path};
    int code = app_check_formats(call, FORMATS);
    if (code == APP_DONE) code = app_design_block(app_text(call, "block"), &d.block);
    if (code == APP_DONE) code = load_process(&d);
    take_design_options(&d);

    /* the target, then the folder: nothing is made for a target that cannot be */
    if (code == APP_DONE) code = app_design_target_load(call, d.path, d.block, &d.target);
    if (code == APP_DONE) code = app_results_begin(&d.cut.results, app_text(call, "output"), result_name);
    if (code == APP_DONE) {
        app_catch_interrupts();
        code = search_design(&d);
    }
    if (code == APP_DONE && d.design) {
        d.cut.job = d.design->path;
        code = run_design(&d);
        const wcut_status status = code == APP_DONE ? measure_face(&d) : WCUT_OK;
        if (status != WCUT_OK) code = app_fail_status(status, d.path, NULL);
    }
    if (code == APP_DONE) code = write_design_files(&d);
    if (code == APP_DONE) code = say_result(&d);
    clear_designing(&d);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */

static const app_operand operand[] = {
    {.name = "TARGET",
     .kind = APP_FILE,
     .help =
         "an open sheet over the block: faces of CAD within their borders (.step .iges), a mesh (.stl .obj .ply .off "
         ".glb) or a cloud (.xyz .csv .pts .ply .pcd .las)"},
    {.name = NULL},
};

static const app_option option[] = {
    APP_OPTION_OUTPUT,
    {.kind = APP_TEXT, .name = "block", .required = true, .value = "W,L,H", .help = "size of the block, mm"},
    {.kind = APP_FILE,
     .name = "process",
     .value = "JOB",
     .help = "a job whose wire, heat, tension, force law and limits are taken; its own block and paths are not"},
    APP_OPTION_FORCE_LAW,
    {.kind = APP_REAL,
     .name = "heat",
     .value = "W_PER_M",
     .low = 0.1,
     .high = 1e5,
     .help = "heat of the wire, W/m; default that of the job, or 65"},
    {.kind = APP_REAL,
     .name = "tension",
     .value = "N",
     .low = 1e-3,
     .high = 1e4,
     .help = "tension at the mounts, N; default that of the job, or 2"},
    {.kind = APP_REAL,
     .name = "clearance",
     .value = "MM",
     .low = 0,
     .high = 1e5,
     .help = "distance that both mounts keep from the block, mm; default that of the job, or 80"},
    {.kind = APP_TEXT,
     .name = "place",
     .value = "WHERE",
     .standard = "identity",
     .help =
         "identity, centred (the middle of its box in that of the block), or 12 numbers: the rows of a 3 x 4 matrix"},
    {.kind = APP_CHOICE,
     .name = "unit",
     .value = "mm|cm|m|inch|ft|dm|um",
     .standard = "mm",
     .help = "unit of the target's numbers, where the file states none"},
    {.kind = APP_TEXT,
     .name = "face",
     .value = "NAME|N",
     .help = "of a CAD file: the face that is the target, by its name or its number from 1; default all of them"},
    {.kind = APP_REAL,
     .name = "tolerance",
     .value = "MM",
     .low = 1e-6,
     .high = 1e3,
     .standard = "0.5",
     .help = "largest rms distance of the target from the face that the paths cut, mm; beyond it the exit code is 5"},
    {.kind = APP_CHOICE,
     .name = "edge-heights",
     .value = "free|fixed",
     .standard = "free",
     .help = "free: the edges' heights are found too; fixed: the edges lie on the target's borders"},
    {.kind = APP_CHOICE,
     .name = "feed",
     .value = "auto|+y|-y|+x|-x",
     .standard = "auto",
     .help = "direction of feed in the target's block; auto: the one of the best map"},
    {.kind = APP_INT,
     .name = "panels",
     .value = "N",
     .low = 1,
     .high = PANELS,
     .standard = "1",
     .help = "where one cut does not hold the tolerance, as few panels as do, up to so many: across, along or both"},
    {.kind = APP_REAL,
     .name = "angle",
     .value = "DEG",
     .low = 5,
     .high = 85,
     .standard = "60",
     .help = "largest angle of the wire at the block's sides, deg"},
    {.kind = APP_FLAG, .name = "feasibility-only", .help = "stop after the map of what can be followed"},
    {.kind = APP_INT,
     .name = "stations",
     .value = "N",
     .low = 41,
     .high = 20000,
     .standard = "241",
     .help = "stations of the design"},
    {.kind = APP_INT,
     .name = "nodes",
     .value = "N",
     .low = 21,
     .high = 2000,
     .help = "nodes along the wire; default 121, or those of the job"},
    APP_OPTION_CHORD_TOLERANCE,
    APP_OPTION_FORMATS(FORMATS),
    APP_OPTION_THREADS,
    APP_OPTIONS_OF_ALL,
};

const app_verb app_verb_design = {
    .name = "design",
    .brief = "find the cut that comes nearest to a target surface",
    .about =
        "Finds the edges, the lag and the extra length of the wire whose cut comes nearest to TARGET, and writes into "
        "DIR: "
        "design.json (a job of design mode), job-path.json and all else that simulate writes of it, deviation.json "
        "(the "
        "target's points from the face that the paths cut), feasibility.ply, feasibility.png and feasibility.json "
        "(what of the target "
        "no "
        "wire can follow, and why) and report.html. With panels it writes panel-K-design.json and panel-K-job.json of "
        "each, "
        "which simulate and path take, and feasibility.json has their places, deviations and joints; with "
        "--edge-heights "
        "fixed their common edges lie on the target.\nA wire in steady foam is an asymptotic curve of the surface that "
        "it "
        "cuts: where the target is domed, no cut follows it. The map says so before anything is simulated.\nThe "
        "design's "
        "frame has the feed along +y; feasibility.json states the turn of the block that leads to it.",
    .operand = operand,
    .option = option,
    .run = run_designing,
};
