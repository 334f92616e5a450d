/* What a scan is compared with: the face that a job leaves, or a mesh. */
#include "compare_reference.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include <wirecut/job_file.h>
#include "command.h"
#include "job.h"
#include "terminal.h"

/* Sections nearer than a job's own rounding of its coordinates are one section. */
#define MERGE_MM 1e-3

/* [1] the area that a mesh shows from one side more than from the other, over its whole area, for it to face that way */
#define SIDED 1e-3

/* whether a name ends with one of a list, which ends with NULL */
static bool has_ending(const char *path, const char *const *ending) {
    const char *dot = strrchr(path, '.');
    for (; dot && *ending; ending++)
        if (strcasecmp(dot, *ending) == 0) return true;
    return false;
}

static const char *const mesh_ending[] = {".stl", ".ply", ".obj", ".off", ".glb", ".gltf", NULL};
static const char *const cad_ending[] = {".step", ".stp", ".iges", ".igs", NULL};

/* ---- a job ---- */

static int simulate_reference(app_reference *r, const app_reference_options *o) {
    wcut_error error = {0};
    const int code = app_job_load(o->call, r->path, &r->job);
    if (code != APP_DONE) return code;
    wcut_status status = o->force_law ? wcut_job_read_force_law(r->job, o->force_law, &error) : WCUT_OK;
    if (status != WCUT_OK) return app_fail_status(status, error.text[0] ? NULL : o->force_law, &error);
    status = wcut_setup_create(r->job, NULL, &r->setup, &error);
    if (status != WCUT_OK) return app_fail_status(status, r->path, &error);
    app_progress progress = app_progress_begin(o->quiet);
    status = wcut_setup_run(r->setup, app_progress_step, &progress, &r->history, &error);
    app_progress_end(&progress);
    /* half a face would be compared with a whole scan */
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, r->path, &error);
}

static wcut_status make_face(app_reference *r, wcut_error *error) {
    const size_t stations = (size_t)r->history->stations;
    double length;
    r->mount_a = calloc(stations, sizeof *r->mount_a);
    r->mount_b = calloc(stations, sizeof *r->mount_b);
    if (!r->mount_a || !r->mount_b) return WCUT_NO_MEMORY;
    wcut_status status = wcut_history_path(r->setup, r->history, r->mount_a, r->mount_b, &length, error);
    if (status == WCUT_OK) status = wcut_face_create(r->job, r->history, r->mount_a, r->mount_b, MERGE_MM, &r->face);
    if (status == WCUT_OK) status = wcut_projection_create(r->face->surface, &r->projection);
    return status;
}

static int load_job(app_reference *r, const app_reference_options *o) {
    wcut_error error = {0};
    int code = simulate_reference(r, o);
    if (code != APP_DONE) return code;
    wcut_status status = make_face(r, &error);
    if (status == WCUT_OK && r->distance == APP_TO_MESH) {
        status = wcut_surface_tessellate(r->face->surface, o->chord_tolerance, &r->mesh, NULL);
        if (status == WCUT_OK) status = wcut_mesh_tree_create(r->mesh, &r->tree);
    }
    if (status != WCUT_OK) return app_fail_status(status, r->path, &error);
    r->low = r->face->low, r->high = r->face->high;
    r->options.low = r->low, r->options.high = r->high;
    r->kerf = wcut_face_kerf(r->face);
    return APP_DONE;
}

/* ---- a mesh ---- */

/* which way a mesh faces on the whole; a closed one faces no way */
static void warn_of_mesh(const app_reference *r, const wcut_mesh_tree_info *info) {
    const bool up = info->area_sum.z > SIDED * info->area, down = info->area_sum.z < -SIDED * info->area;
    if (down && !r->options.flip)
        app_say("%s: warning: the triangles face down, so deviations are positive below them; --flip turns them",
                r->path);
    if (up && r->options.flip)
        app_say("%s: warning: the triangles faced up; after --flip deviations are positive below them", r->path);
    if (info->nonmanifold_edges > 0)
        app_say(
            "%s: warning: %d edges have three triangles or more, or two wound against each other: the sign of "
            "deviations is unreliable near them",
            r->path, info->nonmanifold_edges);
}

static int load_mesh(app_reference *r, wcut_length_unit unit) {
    wcut_error error = {0};
    wcut_mesh_read_options options = wcut_mesh_read_options_default();
    options.unit = unit;
    wcut_status status = wcut_mesh_read(r->path, &options, &r->mesh, NULL, &error);
    if (status != WCUT_OK) return app_fail_status(status, NULL, &error);
    status = wcut_mesh_tree_create(r->mesh, &r->tree);
    if (status != WCUT_OK) return app_fail_status(status, r->path, NULL);
    const wcut_mesh_tree_info *info = wcut_mesh_tree_view(r->tree);
    r->low = info->low, r->high = info->high;
    warn_of_mesh(r, info);
    if (r->low.x < r->high.x && r->low.y < r->high.y) return APP_DONE;
    return app_fail(APP_BAD_INPUT, "%s: found a mesh that has no extent in x or y, expected a cut face", r->path);
}

int app_reference_base(app_reference *reference, const wcut_surface **surface) {
    app_reference *r = reference;
    *surface = r->is_job ? r->face->surface : r->base;
    if (*surface) return APP_DONE;
    wcut_status status = wcut_mesh_base(r->mesh, r->options.flip, &r->base);
    if (status == WCUT_DEGENERATE)
        return app_fail(APP_BAD_INPUT,
                        "%s: found a mesh that is closed, folds over or is steeper than 84 deg somewhere, expected an "
                        "open sheet over a plane, as --reconstruct needs it",
                        r->path);
    if (status == WCUT_OK) status = wcut_projection_create(r->base, &r->projection);
    *surface = r->base;
    return status == WCUT_OK ? APP_DONE : app_fail_status(status, r->path, NULL);
}

/* ---- either ---- */

/* a job is JSON: by its ending or its first byte; what comes through a pipe is a job */
static bool is_job(const char *path) {
    static const char *const ending[] = {".json", NULL};
    if (has_ending(path, ending)) return true;
    if (has_ending(path, mesh_ending)) return false;
    struct stat about;
    FILE *file = stat(path, &about) == 0 && S_ISREG(about.st_mode) ? fopen(path, "rb") : NULL;
    if (!file) return true;
    int c = fgetc(file);
    for (int k = 0;
         k < 1000 && (c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == 0xef || c == 0xbb || c == 0xbf); k++)
        c = fgetc(file);
    fclose(file);
    return c == '{' || c == '[';
}

int app_reference_load(app_reference *reference, const app_reference_options *options) {
    wcut_error error = {0};

    /* nothing is loaded yet */
    app_reference *r = reference;
    const char *path = options->path;
    *r = (app_reference){.path = path, .distance = options->distance, .options = wcut_deviation_options_default()};

    /* a CAD file has no stations, and its surface is not read */
    if (has_ending(path, cad_ending))
        return app_fail(APP_BAD_INPUT,
                        "%s: found a CAD file, expected a job, whose surface is exact, or a mesh: .stl .ply .obj .off "
                        ".glb",
                        path);

    /* a job has stations; a mesh has vertices alone */
    r->is_job = is_job(path);
    r->options.flip = options->flip;
    if (!r->is_job && options->call && app_given(options->call, "edges"))
        return app_fail(APP_BAD_INPUT, "%s: --edges: expected a design, found no job", options->path);

    /* the face and its box */
    const int code = r->is_job ? load_job(r, options) : load_mesh(r, options->unit);
    if (code != APP_DONE) return code;

    /* a mesh has no exact surface to measure to */
    if (!r->is_job && options->distance == APP_TO_SURFACE) r->distance = APP_TO_MESH;

    /* the area in plan, and the hash for the report */
    r->plan = (r->high.x - r->low.x) * (r->high.y - r->low.y);
    const wcut_status status = wcut_source_hash(path, r->hash, &error);

    return status == WCUT_OK ? APP_DONE : app_fail_status(status, NULL, &error);
}

void app_reference_clear(app_reference *reference) {
    wcut_mesh_tree_destroy(reference->tree);
    wcut_mesh_destroy(reference->mesh);
    wcut_projection_destroy(reference->projection);
    wcut_surface_destroy(reference->base);
    wcut_face_destroy(reference->face);
    wcut_history_destroy(reference->history);
    wcut_setup_destroy(reference->setup);
    wcut_job_destroy(reference->job);
    free(reference->mount_a);
    free(reference->mount_b);
    *reference = (app_reference){0};
}

wcut_status app_reference_locate(const app_reference *reference, int count, const wcut_vec3 *point, int threads,
                                 wcut_deviation *deviation, wcut_foot *foot) {
    const app_reference *r = reference;
    if (!r->tree)
        return wcut_deviation_from_surface(r->projection, count, point, &r->options, threads, deviation, foot);
    const wcut_status status = wcut_deviation_from_mesh(r->tree, count, point, &r->options, threads, deviation);
    return status == WCUT_OK && r->is_job ? wcut_deviation_onto_surface(r->mesh, count, deviation) : status;
}
