/* A cut that was run, and the files that hold it. */
#include "simulation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "terminal.h"

/* ---- the run ---- */

/* Cut from the first station to the last, or as far as it goes: then the history holds what there is. */
int app_simulation_run(app_simulation *s) {
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

static int write_history(app_simulation *s) {
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

static int write_mesh(app_simulation *s, const wcut_mesh *mesh) {
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
static int write_surface(app_simulation *s) {
    /* the loft through the stations */
    const wcut_history *h = s->history;
    wcut_mesh *mesh = NULL;
    const char *step = "lofting the surface";
    int code = APP_FAILED;
    double *parameter = calloc((size_t)h->stations, sizeof *parameter);
    wcut_status status = parameter ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK)
        status = wcut_surface_loft(h->stations, h->nodes, h->position, APP_MERGE_MM, &s->surface, parameter, NULL);

    /* triangles within the chord tolerance, coloured by the force */
    if (status == WCUT_OK) {
        step = "triangulating the surface";
        status = wcut_surface_tessellate(s->surface, app_real(s->call, "chord-tolerance"), &mesh, NULL);
    }
    if (status == WCUT_OK) status = wcut_mesh_sample(mesh, h->stations, h->nodes, parameter, h->force_line);

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
        if (kept == 0 || x * x + y * y + z * z > APP_MERGE_MM * APP_MERGE_MM) apart[kept++] = p;
    }
    const wcut_status status = !apart     ? WCUT_NO_MEMORY
                               : kept < 2 ? WCUT_OK
                                          : wcut_curve_interpolate(kept, apart, curve);
    free(apart);
    return status;
}

/* The surface and both path curves, exactly. */
static int write_step(app_simulation *s, const wcut_vec3 *mount_a, const wcut_vec3 *mount_b) {
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

static int write_path(app_simulation *s) {
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
static int write_path_job(app_simulation *s) {
    wcut_error error = {0};
    const char *name = "job-path.json";
    wcut_job *path = NULL;
    wcut_status status = wcut_setup_path_job(s->setup, &path);
    if (status == WCUT_OK) status = wcut_job_write(path, app_results_path(&s->results, name), &error);
    wcut_job_destroy(path);
    return app_results_add(&s->results, name, status, &error);
}

/* what users of a bow ask for: figures, stations, the map of its face, the feed chart */
static int write_bow(app_simulation *s) {
    wcut_error error = {0};
    const wcut_status made = wcut_bow_results_create(s->setup, s->history, NULL, &s->bow, &error);
    int code = made == WCUT_OK ? APP_DONE : app_fail_status(made, s->path, &error);
    for (int k = WCUT_BOW_FILE_FIGURES; code == APP_DONE && k <= WCUT_BOW_FILE_CHART; k++) {
        const char *name = wcut_bow_file_name((wcut_bow_file)k);
        if (k > WCUT_BOW_FILE_FIGURES && !app_wants_format(s->call, "csv")) continue;
        const wcut_status status =
            wcut_bow_results_write(s->bow, s->history, (wcut_bow_file)k, app_results_path(&s->results, name), &error);
        code = app_results_add(&s->results, name, status, &error);
    }
    return code;
}

int app_simulation_write(app_simulation *s) {
    bool surface = s->history->stations >= 2; /* a run that ended at its start swept none */
    int code = write_history(s);
    if (code == APP_DONE && surface) code = write_surface(s);
    if (code == APP_DONE && surface) code = write_path(s);
    const bool whole = s->history->stations == s->history->planned;
    if (code == APP_DONE && whole && s->job->mode == WCUT_MODE_DESIGN) code = write_path_job(s);
    if (code == APP_DONE && surface && s->job->rig.kind == WCUT_RIG_KIND_BOW) code = write_bow(s);
    return code;
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

/* the three things that users of a bow ask for, at the job's own heat */
static void say_bow(const wcut_bow_results *r, double heat) {
    app_say(
        "the wire bows by %.3g mm at most, at station %d; the face departs from the ruled surface by %.3g mm at most, "
        "at station %d",
        r->bow.value, r->bow.station, fabs(r->departure_max.value), r->departure_max.station);
    app_say("tension %.3g N at most of %.3g N that the wire bears at %.0f degC; force on the tool %.3g N at most",
            r->tension_max, r->strength, r->temperature, r->force_max);
    const wcut_feed_chart_row *c = &r->chart[WCUT_FEED_CHART_HEATS / 2];
    const double *bow = wcut_feed_chart_bows();
    app_say("largest feed at %.3g W/m: %.3g mm/s for a bow of %g mm, %.3g for %g, %.3g for %g%s", heat, c->feed[0],
            bow[0], c->feed[1], bow[1], c->feed[2], bow[2], c->too_hot ? "; the wire is too hot in air" : "");
    if (r->slack_share > 0)
        app_say("warning: the wire hangs slack at %.0f %% of the stations: its heat takes the pretension",
                100 * r->slack_share);
}

/* one word and its reason */
static void say_feasibility(const app_simulation *s) {
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

int app_simulation_say(const app_simulation *s) {
    wcut_summary sum;
    const wcut_status status = wcut_summary_eval(s->history, &sum);
    if (status != WCUT_OK) return app_fail_status(status, s->path, NULL);
    app_say("%s: %d of %d stations, %.1f s of cutting at %.3g to %.3g mm/s", s->job->name, s->history->stations,
            s->history->planned, sum.duration, sum.speed.min, sum.speed.max);
    app_say("largest residual %.1e, %.1f iterations per station", sum.residual_max, sum.iterations_mean);
    say_effects(s->job);
    if (s->bow) say_bow(s->bow, s->job->heat);
    say_feasibility(s);
    app_say("in %s: %s", s->results.folder, app_results_list(&s->results));
    return APP_DONE;
}

double app_chord_tolerance(void) { return wcut_mould_default().chord_tolerance; }

void app_simulation_clear(app_simulation *s) {
    app_results_end(&s->results);
    wcut_bow_results_destroy(s->bow);
    wcut_surface_destroy(s->surface);
    wcut_history_destroy(s->history);
    wcut_setup_destroy(s->setup);
    wcut_job_destroy(s->job);
}
