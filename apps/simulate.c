/* wirecut simulate: a job file to history, surface, path curves and summary. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/wirecut.h>

#include "command.h"
#include "job.h"
#include "results.h"
#include "terminal.h"

/* Sections nearer than a job's own rounding of its coordinates are one section. */
#define MERGE_MM 1e-3
#define FORMATS "vtp,stl,obj,ply,glb,csv,step"

/* What a run may leave in its folder, in the order written. */
static const char *const result_name[] = {"history.vtp", "surface.stl",  "surface.obj",   "surface.ply", "surface.glb",
                                          "path.csv",    "surface.step", "job-path.json", "report.html", "summary.json",
                                          NULL};

typedef struct simulation {
    const app_call *call;
    const char *path; /* of the job */
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_surface *surface; /* through the stations */
    wcut_status ended;     /* how the run ended */
    app_results results;
} simulation;

/* ---- the run ---- */

/* Read the job and let the options have their say. */
static int load_simulation(simulation *s) {
    wcut_error error = {0};
    const int code = app_job_load(s->call, s->path, &s->job);
    if (code != APP_DONE) return code;

    wcut_cut_options options = wcut_cut_options_default();
    options.integrator = app_choice(s->call, "integrator") == 1 ? WCUT_INTEGRATOR_HEUN : WCUT_INTEGRATOR_IMPLICIT;
    const wcut_status status = wcut_setup_create(s->job, &options, &s->setup, &error);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, s->path, &error);
}

/* Cut from the first station to the last, or as far as it goes: then the history holds what there is. */
static int run_simulation(simulation *s) {
    wcut_error error = {0};
    app_progress progress = app_progress_begin(app_given(s->call, "quiet"));
    wcut_status status = wcut_setup_run(s->setup, app_progress_step, &progress, &s->history, &error);
    app_progress_end(&progress);
    s->ended = status;
    if (status == WCUT_INTERRUPTED && s->history)
        return app_fail(APP_INTERRUPTED, "%s: interrupted after station %d of 0 to %d", s->path,
                        s->history->stations - 1, s->history->planned - 1);
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, s->path, &error);
}

/* ---- the files ---- */

static int write_history(simulation *s) {
    wcut_error error = {0};
    const char *name = "history.vtp";
    if (!app_wants_format(s->call, "vtp")) return APP_DONE;
    wcut_status status = wcut_history_write_vtp(s->history, app_results_path(&s->results, name), &error);
    return app_results_add(&s->results, name, status, &error);
}

static wcut_status write_mesh_as(const wcut_mesh *mesh, int format, const char *path, wcut_error *error) {
    if (format == 0) return wcut_mesh_write_stl(mesh, path, error);
    if (format == 1) return wcut_mesh_write_obj(mesh, path, error);
    if (format == 2) return wcut_mesh_write_ply(mesh, "force_N_per_mm", path, error);
    return wcut_mesh_write_glb(mesh, path, error);
}

static int write_mesh(simulation *s, const wcut_mesh *mesh) {
    static const char *const name[] = {"surface.stl", "surface.obj", "surface.ply", "surface.glb"};
    int code = APP_DONE;
    for (int k = 0; k < 4 && code == APP_DONE; k++) {
        wcut_error error = {0};
        if (!app_wants_format(s->call, strrchr(name[k], '.') + 1)) continue;
        const wcut_status status = write_mesh_as(mesh, k, app_results_path(&s->results, name[k]), &error);
        code = app_results_add(&s->results, name[k], status, &error);
    }
    return code;
}

/* Loft the stations, triangulate, colour by the force on the wire. */
static int write_surface(simulation *s) {
    /* the loft through the stations */
    const wcut_history *h = s->history;
    wcut_mesh *mesh = NULL;
    const char *step = "lofting the surface";
    int code = APP_FAILED;
    double *parameter = calloc((size_t)h->stations, sizeof *parameter);
    wcut_status status = parameter ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK)
        status = wcut_surface_loft(h->stations, h->nodes, h->position, MERGE_MM, &s->surface, parameter, NULL);

    /* triangles within the chord tolerance, coloured by the force */
    if (status == WCUT_OK) {
        step = "triangulating the surface";
        status = wcut_surface_tessellate(s->surface, app_real(s->call, "chord-tolerance"), &mesh, NULL);
    }
    if (status == WCUT_OK) status = wcut_mesh_sample(mesh, h->stations, h->nodes, parameter, h->force_line);

    /* the message names the step that failed */
    if (status != WCUT_OK)
        code = app_fail(app_exit_code(status), "%s: %s: %s", s->path, step, wcut_status_text(status));
    else
        code = write_mesh(s, mesh);

    wcut_mesh_destroy(mesh);
    free(parameter);
    return code;
}

/* Smooth curve through the positions of a mount, dwells passed over; it stays NULL where the mount stands still. */
static wcut_status make_path(int count, const wcut_vec3 *mount, wcut_curve **curve) {
    wcut_vec3 *apart = calloc((size_t)count, sizeof *apart);
    int kept = 0;
    for (int k = 0; apart && k < count; k++) {
        const wcut_vec3 p = mount[k], q = kept ? apart[kept - 1] : p;
        const double x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
        if (kept == 0 || x * x + y * y + z * z > MERGE_MM * MERGE_MM) apart[kept++] = p;
    }
    const wcut_status status = !apart     ? WCUT_NO_MEMORY
                               : kept < 2 ? WCUT_OK
                                          : wcut_curve_interpolate(kept, apart, curve);
    free(apart);
    return status;
}

/* The surface and both path curves, exactly. */
static int write_step(simulation *s, const wcut_vec3 *mount_a, const wcut_vec3 *mount_b) {
    wcut_error error = {0};
    const char *name = "surface.step";
    if (!app_wants_format(s->call, "step")) return APP_DONE;
    wcut_curve *a = NULL, *b = NULL;
    wcut_status status = make_path(s->history->stations, mount_a, &a);
    if (status == WCUT_OK) status = make_path(s->history->stations, mount_b, &b);
    if (status == WCUT_OK) {
        wcut_shape shape[3] = {{.name = "cut", .surface = s->surface}};
        int count = 1;
        if (a) shape[count++] = (wcut_shape){.name = "path of mount A", .curve = a};
        if (b) shape[count++] = (wcut_shape){.name = "path of mount B", .curve = b};
        status = wcut_step_write(count, shape, WCUT_STEP_SCHEMA_AP214, app_results_path(&s->results, name), &error);
    }
    wcut_curve_destroy(a);
    wcut_curve_destroy(b);
    return app_results_add(&s->results, name, status, &error);
}

static int write_path(simulation *s) {
    /* room for both mounts */
    const wcut_history *h = s->history;
    double length = 0;
    int code = APP_FAILED;
    wcut_error error = {0};
    wcut_vec3 *mount_a = calloc((size_t)h->stations, sizeof *mount_a);
    wcut_vec3 *mount_b = calloc((size_t)h->stations, sizeof *mount_b);
    wcut_status status = mount_a && mount_b ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_history_path(s->setup, h, mount_a, mount_b, &length, &error);

    /* as CSV and as STEP curves */
    if (status != WCUT_OK) {
        code = app_fail_status(status, s->path, &error);
    } else {
        code = APP_DONE;
        if (app_wants_format(s->call, "csv")) {
            status = wcut_history_write_csv(h, mount_a, mount_b, app_results_path(&s->results, "path.csv"), &error);
            code = app_results_add(&s->results, "path.csv", status, &error);
        }
        if (code == APP_DONE) code = write_step(s, mount_a, mount_b);
    }

    free(mount_b);
    free(mount_a);
    return code;
}

/* what a design became: the job of both mounts' way, for whoever takes paths alone */
static int write_path_job(simulation *s) {
    wcut_error error = {0};
    const char *name = "job-path.json";
    wcut_job *path = NULL;
    wcut_status status = wcut_setup_path_job(s->setup, &path);
    if (status == WCUT_OK) status = wcut_job_write(path, app_results_path(&s->results, name), &error);
    wcut_job_destroy(path);
    return app_results_add(&s->results, name, status, &error);
}

static int write_report(simulation *s) {
    wcut_error error = {0};
    const char *name = "report.html";
    const wcut_report_simulate run = {.job_path = s->path,
                                      .integrator = app_text(s->call, "integrator"),
                                      .chord_tolerance = app_real(s->call, "chord-tolerance"),
                                      .merge = MERGE_MM,
                                      .ended = s->ended};
    wcut_status status =
        wcut_report_simulate_write(&run, s->setup, s->history, app_results_path(&s->results, name), &error);
    return app_results_add(&s->results, name, status, &error);
}

static int write_results(simulation *s) {
    bool surface = s->history->stations >= 2; /* a run that ended at its start swept none */
    int code = write_history(s);
    if (code == APP_DONE && surface) code = write_surface(s);
    if (code == APP_DONE && surface) code = write_path(s);
    const bool whole = s->history->stations == s->history->planned;
    if (code == APP_DONE && whole && s->job->mode == WCUT_MODE_DESIGN) code = write_path_job(s);
    if (code == APP_DONE) code = write_report(s);
    if (code != APP_DONE) return code;
    char *text = NULL;
    const wcut_status status = wcut_summary_print(s->setup, s->history, &text);
    return app_results_commit(&s->results, "summary.json", status, text);
}

/* ---- the answer ---- */

/* effects of instruments, scans and the scanned face change neither wire nor surface: nobody shall think they did */
static void say_effects(const wcut_job *job) {
    for (int k = 0; k < job->effect_count; k++) {
        const wcut_effect_info *info = wcut_effect_view(job->effect[k].kind);
        if (info->place == WCUT_EFFECT_PLACE_STEP || wcut_effect_is_neutral(&job->effect[k])) continue;
        app_say("note: %s acts on %s, not on the wire: these results do not show it", info->name,
                info->place == WCUT_EFFECT_PLACE_SENSOR ? "recordings" : "the scanned face or its scan");
    }
}

/* one word and its reason */
static void say_feasibility(const simulation *s) {
    const size_t stations = (size_t)s->history->stations;
    wcut_feasibility v;
    double length;
    wcut_vec3 *way = calloc(2 * stations, sizeof *way);
    if (way && wcut_history_path(s->setup, s->history, way, way + stations, &length, NULL) == WCUT_OK &&
        wcut_feasibility_eval(s->job, s->history, way, way + stations, NULL, &v, NULL) == WCUT_OK)
        app_say("%s%s: %s", v.verdict == WCUT_FEASIBILITY_VERDICT_INFEASIBLE ? "warning: " : "",
                wcut_feasibility_name(v.verdict), v.reason);
    free(way);
}

static int say_summary(const simulation *s) {
    wcut_summary sum;
    const wcut_status status = wcut_summary_eval(s->history, &sum);
    if (status != WCUT_OK) return app_fail_status(status, s->path, NULL);
    app_say("%s: %d of %d stations, %.1f s of cutting at %.3g to %.3g mm/s", s->job->name, s->history->stations,
            s->history->planned, sum.duration, sum.speed.min, sum.speed.max);
    app_say("largest residual %.1e, %.1f iterations per station", sum.residual_max, sum.iterations_mean);
    say_effects(s->job);
    say_feasibility(s);
    app_say("in %s: %s", s->results.folder, app_results_list(&s->results));
    return APP_DONE;
}

/* The summary to whom it concerns: people read standard error, programs standard output. */
static int give_summary(const simulation *s) {
    const int code = app_given(s->call, "quiet") ? APP_DONE : say_summary(s);
    if (app_given(s->call, "json")) fputs(s->results.text, stdout);
    return code;
}

static int run_simulate(const app_call *call) {
    /* check formats and job before the run */
    simulation s = {.call = call, .path = call->operand[0]};
    int ended = APP_DONE, code = app_check_formats(call, FORMATS);
    if (code == APP_DONE) code = load_simulation(&s);
    if (code == APP_DONE) code = app_results_begin(&s.results, app_text(call, "output"), result_name);

    /* a run that ended early leaves its results up to there */
    if (code == APP_DONE) {
        app_catch_interrupts();
        ended = run_simulation(&s);
        if (s.history && s.history->stations > 0) {
            code = write_results(&s);
            if (code == APP_DONE) code = give_summary(&s);
        }
    }

    /* the exit code says how the run ended */
    if (code == APP_DONE) code = ended;
    app_results_end(&s.results);

    wcut_surface_destroy(s.surface);
    wcut_history_destroy(s.history);
    wcut_setup_destroy(s.setup);
    wcut_job_destroy(s.job);
    return code;
}

/* ---- the table ---- */

/* defaults of the library */
static double simulate_integrator(void) { return wcut_cut_options_default().integrator; }
static double simulate_chord_tolerance(void) { return wcut_mould_default().chord_tolerance; }

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
     .library = simulate_integrator,
     .help = "implicit: shape, tensions and rate solved together; heun: the scheme of Rust et al. 2016, (9)-(11), "
             "unstable for short steps, kept for comparison"},
    APP_OPTION_STATIONS,
    APP_OPTION_NODES,
    {.kind = APP_REAL,
     .name = "chord-tolerance",
     .value = "MM",
     .low = 1e-4,
     .high = 1e3,
     .library = simulate_chord_tolerance,
     .help = "largest distance between triangles and surface, mm"},
    APP_OPTION_FORMATS(FORMATS),
    APP_OPTION_FORCE_LAW,
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
