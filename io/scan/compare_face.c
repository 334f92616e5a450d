/* What a scan is compared with: the face that a job leaves, a mesh, a face of a CAD file, or a surface. */
#include "io/scan/compare_face.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <wirecut/job_file.h>
#include <wirecut/read.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/scan/face_choice.h"

/* Sections nearer than a job's own rounding of its coordinates are one section. */
#define MERGE_MM 1e-3

/* [1] the area that a mesh shows from one side more than from the other, over its whole area, for it to face that way */
#define SIDED 1e-3

/* a failure whose text does not name a place gets this one */
static wcut_status place_failure(wcut_status status, const char *place, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    if (status == WCUT_OK || !error) return status;
    if (!error->text[0] || error->status == WCUT_OK)
        return wcut_fail(error, status, "%s: %s", wcut_quote(name, place, WCUT_LABEL_MAX, 1), wcut_status_text(status));
    error->status = status;
    return status;
}

/* ---- a job ---- */

typedef struct simulating {
    const wcut_compare_watch *watch;
} simulating;

static int pass_station(int station, int stations, void *context) {
    const wcut_compare_watch *w = ((simulating *)context)->watch;
    return w && w->progress ? w->progress(WCUT_COMPARE_STAGE_SIMULATE, station, stations, w->context) : 0;
}

static wcut_status read_job(wcut_compare_face *f, const wcut_compare_reference *r, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    wcut_status status = place_failure(wcut_job_read(r->path, &f->owned_job, error), r->path, error);
    if (status == WCUT_OK && r->force_law)
        status = place_failure(wcut_job_read_force_law(f->owned_job, r->force_law, error), r->force_law, error);
    if (status != WCUT_OK || !r->edges) return status;

    /* only a design has edges */
    if (f->owned_job->mode != WCUT_MODE_DESIGN)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: edges: expected a design, found a path",
                         wcut_quote(name, r->path, WCUT_LABEL_MAX, 1));
    return place_failure(wcut_job_read_edges(f->owned_job, r->edges, error), r->edges, error);
}

static wcut_status simulate_reference(wcut_compare_face *f, const wcut_compare_reference *r,
                                      const wcut_compare_watch *watch, wcut_error *error) {
    simulating s = {watch};
    wcut_status status = read_job(f, r, error);
    if (status != WCUT_OK) return status;

    /* half a face would be compared with a whole scan: what ends early is a failure */
    status = wcut_setup_create(f->owned_job, NULL, &f->owned_setup, error);
    if (status == WCUT_OK) status = wcut_setup_run(f->owned_setup, pass_station, &s, &f->owned_history, error);
    f->job = f->owned_job, f->setup = f->owned_setup, f->history = f->owned_history;
    if (status == WCUT_OK || !error) return status;

    /* the solver's text names a station, not the file */
    char name[WCUT_QUOTE_SIZE];
    const wcut_error told = *error;
    return wcut_fail(error, status, "%s: %s", wcut_quote(name, r->path, WCUT_LABEL_MAX, 1),
                     told.text[0] ? told.text : wcut_status_text(status));
}

static wcut_status make_face(wcut_compare_face *f, wcut_error *error) {
    const size_t stations = (size_t)f->history->stations;
    double length;
    f->mount_a = wcut_alloc(stations, sizeof *f->mount_a);
    f->mount_b = wcut_alloc(stations, sizeof *f->mount_b);
    if (!f->mount_a || !f->mount_b) return WCUT_NO_MEMORY;
    wcut_status status = wcut_history_path(f->setup, f->history, f->mount_a, f->mount_b, &length, error);
    if (status == WCUT_OK) status = wcut_face_create(f->job, f->history, f->mount_a, f->mount_b, MERGE_MM, &f->face);
    if (status == WCUT_OK) status = wcut_projection_create(f->face->surface, &f->projection);
    return status;
}

static wcut_status load_job(wcut_compare_face *f, const wcut_compare_options *o, wcut_error *error) {
    wcut_status status = make_face(f, error);
    if (status == WCUT_OK && f->distance == WCUT_COMPARE_DISTANCE_MESH) {
        status = wcut_surface_tessellate(f->face->surface, o->chord_tolerance, &f->owned_mesh, NULL);
        if (status == WCUT_OK) status = wcut_mesh_tree_create(f->owned_mesh, &f->tree);
        f->mesh = f->owned_mesh;
    }
    if (status != WCUT_OK) return place_failure(status, f->name, error);

    /* the window is the block */
    f->surface = f->face->surface;
    f->low = f->face->low, f->high = f->face->high;
    f->options.low = f->low, f->options.high = f->high;
    f->kerf = wcut_face_kerf(f->face);
    return WCUT_OK;
}

/* ---- a mesh ---- */

static void warn_of_reference(const wcut_compare_watch *watch, const char *name, const char *text) {
    char line[2 * WCUT_QUOTE_SIZE], quoted[WCUT_QUOTE_SIZE];
    if (!watch || !watch->warn) return;
    snprintf(line, sizeof line, "%s: warning: %s", wcut_quote(quoted, name, WCUT_LABEL_MAX, 1), text);
    watch->warn(line, watch->context);
}

/* which way a mesh faces on the whole; a closed one faces no way */
static void warn_of_mesh(const wcut_compare_face *f, const wcut_mesh_tree_info *info, const wcut_compare_watch *watch) {
    const bool up = info->area_sum.z > SIDED * info->area, down = info->area_sum.z < -SIDED * info->area;
    char text[WCUT_QUOTE_SIZE];
    if (down && !f->options.flip)
        warn_of_reference(watch, f->name,
                          "the triangles face down, so deviations are positive below them; flip turns them");
    if (up && f->options.flip)
        warn_of_reference(watch, f->name, "the triangles faced up; after the flip deviations are positive below them");
    if (info->nonmanifold_edges == 0) return;
    snprintf(text, sizeof text,
             "%d edges have three triangles or more, or two wound against each other: the sign of deviations is "
             "unreliable near them",
             info->nonmanifold_edges);
    warn_of_reference(watch, f->name, text);
}

static wcut_status load_mesh(wcut_compare_face *f, const wcut_compare_watch *watch, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    const wcut_status status = wcut_mesh_tree_create(f->mesh, &f->tree);
    if (status != WCUT_OK) return place_failure(status, f->name, error);
    const wcut_mesh_tree_info *info = wcut_mesh_tree_view(f->tree);
    f->low = info->low, f->high = info->high;
    warn_of_mesh(f, info, watch);
    if (f->low.x < f->high.x && f->low.y < f->high.y) return WCUT_OK;
    return wcut_fail(error, WCUT_DEGENERATE, "%s: found a mesh that has no extent in x or y, expected a cut face",
                     wcut_quote(name, f->name, WCUT_LABEL_MAX, 1));
}

/* ---- a surface ---- */

/* its triangles carry the map of colours, whatever distances are taken to */
static wcut_status load_surface(wcut_compare_face *f, const wcut_compare_options *o, const wcut_compare_watch *watch,
                                wcut_error *error) {
    wcut_status status = wcut_surface_tessellate(f->surface, o->chord_tolerance, &f->owned_mesh, NULL);
    f->mesh = f->owned_mesh;
    if (status == WCUT_OK) status = wcut_projection_create(f->surface, &f->projection);
    if (status == WCUT_OK) return load_mesh(f, watch, error);
    return place_failure(status, f->name, error);
}

/* ---- a face of a CAD file ---- */

static wcut_status refuse_choice(const wcut_compare_face *f, const char *path, wcut_error *error) {
    const wcut_trimmed_set *set = f->faces;
    char name[WCUT_QUOTE_SIZE], names[160] = "";
    wcut_face_list(set, names, sizeof names);
    return wcut_fail(error, WCUT_BAD_FORMAT,
                     "%s: found %d face%s (%s), expected a choice: --face NAME or number, several with commas, or all",
                     wcut_quote(name, path, WCUT_LABEL_MAX, 1), set->count, set->count == 1 ? "" : "s", names);
}

static wcut_status refuse_several(const wcut_compare_face *f, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(
        error, WCUT_BAD_ARGUMENT,
        "%s: --face: several faces have distances to their surfaces alone, expected --distance surface and "
        "no reconstruction",
        wcut_quote(name, f->name, WCUT_LABEL_MAX, 1));
}

/* one mesh behind another, in the first's place */
static wcut_status append_mesh(wcut_mesh **mesh, const wcut_mesh *more) {
    const wcut_mesh *a = *mesh;
    if (more->vertex_count > INT_MAX - a->vertex_count || more->triangle_count > INT_MAX / 3 - a->triangle_count)
        return WCUT_BAD_ARGUMENT;
    const size_t n = (size_t)a->vertex_count, m = (size_t)more->vertex_count, t = (size_t)a->triangle_count;
    wcut_mesh *both;
    const wcut_status status = wcut_mesh_create((int)(n + m), a->triangle_count + more->triangle_count,
                                                WCUT_MESH_NORMAL | WCUT_MESH_UV, &both);
    if (status != WCUT_OK) return status;
    memcpy(both->vertex, a->vertex, n * sizeof *both->vertex);
    memcpy(both->vertex + n, more->vertex, m * sizeof *both->vertex);
    memcpy(both->normal, a->normal, n * sizeof *both->normal);
    memcpy(both->normal + n, more->normal, m * sizeof *both->normal);
    memcpy(both->uv, a->uv, 2 * n * sizeof *both->uv);
    memcpy(both->uv + 2 * n, more->uv, 2 * m * sizeof *both->uv);
    memcpy(both->triangle, a->triangle, 3 * t * sizeof *both->triangle);
    for (size_t k = 0; k < 3 * (size_t)more->triangle_count; k++)
        both->triangle[3 * t + k] = more->triangle[k] + a->vertex_count;
    wcut_mesh_destroy(*mesh);
    *mesh = both;
    return WCUT_OK;
}

/* the triangles of all faces that were chosen, and projections of those behind the first */
static wcut_status load_others(wcut_compare_face *f, const int *face, int count, const wcut_compare_options *o) {
    f->other = wcut_alloc((size_t)count, sizeof *f->other);
    f->other_projection = wcut_alloc((size_t)count, sizeof *f->other_projection);
    if (!f->other || !f->other_projection) return WCUT_NO_MEMORY;
    for (int k = 1; k < count; k++) {
        wcut_mesh *mesh = NULL;
        const wcut_trimmed *t = f->faces->face[face[k]];
        wcut_status status = wcut_trimmed_mesh(t, o->chord_tolerance, &mesh);
        if (status == WCUT_OK) status = append_mesh(&f->owned_mesh, mesh);
        wcut_mesh_destroy(mesh);
        if (status == WCUT_OK) status = wcut_projection_create(t->surface, &f->other_projection[f->others]);
        if (status != WCUT_OK) return status;
        f->other[f->others++] = t;
    }
    return WCUT_OK;
}

static wcut_status load_chosen(wcut_compare_face *f, const int *face, int count, const wcut_compare_options *o,
                               const wcut_compare_watch *watch, wcut_error *error) {
    if (count > 1 && (o->distance != WCUT_COMPARE_DISTANCE_SURFACE || o->reconstruct)) return refuse_several(f, error);
    f->trimmed = f->faces->face[face[0]];
    f->surface = f->trimmed->surface;
    wcut_status status = wcut_trimmed_mesh(f->trimmed, o->chord_tolerance, &f->owned_mesh);
    if (status == WCUT_OK) status = load_others(f, face, count, o);
    f->mesh = f->owned_mesh;
    if (status == WCUT_OK) status = wcut_projection_create(f->surface, &f->projection);
    if (status == WCUT_OK) return load_mesh(f, watch, error);
    return place_failure(status, f->name, error);
}

static wcut_status load_cad(wcut_compare_face *f, const wcut_compare_reference *r, const wcut_compare_options *o,
                            const wcut_compare_watch *watch, wcut_error *error) {
    char text[WCUT_QUOTE_SIZE + 60];
    wcut_status status = wcut_trimmed_set_read(r->path, &f->faces, error);
    if (status != WCUT_OK) return place_failure(status, r->path, error);
    if (f->faces->left_out > 0) {
        snprintf(text, sizeof text, "%d left out: %s", f->faces->left_out, f->faces->why);
        warn_of_reference(watch, f->name, text);
    }

    /* the faces that were chosen, the first of them the reference's surface */
    int *face = wcut_alloc((size_t)f->faces->count, sizeof *face);
    if (!face) return place_failure(WCUT_NO_MEMORY, r->path, error);
    const int count = wcut_face_choose(f->faces, r->face, face);
    status = count > 0 ? load_chosen(f, face, count, o, watch, error) : refuse_choice(f, r->path, error);
    wcut_free(face);
    return status;
}

wcut_status wcut_compare_face_base(wcut_compare_face *face, const wcut_surface **surface, wcut_error *error) {
    wcut_compare_face *f = face;
    char name[WCUT_QUOTE_SIZE];
    *surface = f->surface ? f->surface : f->base;
    if (*surface) return WCUT_OK;
    wcut_status status = wcut_mesh_base(f->mesh, f->options.flip, &f->base);
    if (status == WCUT_DEGENERATE)
        return wcut_fail(error, status,
                         "%s: found a mesh that is closed, folds over or is steeper than 84 deg somewhere, expected an "
                         "open sheet over a plane, as a reconstruction needs it",
                         wcut_quote(name, f->name, WCUT_LABEL_MAX, 1));
    if (status == WCUT_OK) status = wcut_projection_create(f->base, &f->projection);
    *surface = f->base;
    return place_failure(status, f->name, error);
}

/* ---- any ---- */

/* whether a name ends with one of a list, which ends with NULL */
static bool has_ending(const char *path, const char *const *ending) {
    const char *dot = strrchr(path, '.');
    for (; dot && *ending; ending++)
        if (strcasecmp(dot, *ending) == 0) return true;
    return false;
}

/* a job is JSON: by its ending or its first byte; what comes through a pipe is a job */
static bool is_job(const char *path) {
    static const char *const job_ending[] = {".json", NULL};
    static const char *const mesh_ending[] = {".stl", ".ply", ".obj", ".off", ".glb", ".gltf", NULL};
    if (has_ending(path, job_ending)) return true;
    if (has_ending(path, mesh_ending)) return false;

    /* the first byte behind blanks and the mark of UTF-8 */
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

/* a CAD file by its ending or its first bytes */
static bool is_cad(const char *path) {
    static const char *const cad_ending[] = {".step", ".stp", ".p21", ".iges", ".igs", NULL};
    char head[14] = "";
    struct stat about;
    if (has_ending(path, cad_ending)) return true;
    FILE *file = stat(path, &about) == 0 && S_ISREG(about.st_mode) ? fopen(path, "rb") : NULL;
    if (!file) return false;
    const size_t n = fread(head, 1, 13, file);
    fclose(file);
    return n == 13 && strcmp(head, "ISO-10303-21;") == 0;
}

static wcut_status refuse_face(const wcut_compare_face *f, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: --face: expected a CAD file with it, .step or .iges",
                     wcut_quote(name, f->name, WCUT_LABEL_MAX, 1));
}

static wcut_status refuse_change(const wcut_compare_face *f, const char *what, wcut_error *error) {
    char name[WCUT_QUOTE_SIZE];
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: %s: expected a job, found none",
                     wcut_quote(name, f->name, WCUT_LABEL_MAX, 1), what);
}

static wcut_status load_file(wcut_compare_face *f, const wcut_compare_reference *r, const wcut_compare_options *o,
                             const wcut_compare_watch *watch, wcut_error *error) {
    /* a job is simulated; a mesh is read in its unit and has no edges or force law to change, nor has a CAD file */
    wcut_status status;
    if (r->face && !is_cad(r->path)) return refuse_face(f, error);
    if (is_cad(r->path)) {
        if (r->edges || r->force_law) return refuse_change(f, r->edges ? "edges" : "force law", error);
        status = load_cad(f, r, o, watch, error);
    } else if (is_job(r->path)) {
        status = simulate_reference(f, r, watch, error);
        if (status == WCUT_OK) status = load_job(f, o, error);
    } else {
        if (r->edges || r->force_law) return refuse_change(f, r->edges ? "edges" : "force law", error);

        /* a mesh, in its own unit */
        wcut_mesh_read_options options = wcut_mesh_read_options_default();
        options.unit = o->reference_unit;
        status = place_failure(wcut_mesh_read(r->path, &options, &f->owned_mesh, NULL, error), r->path, error);
        f->mesh = f->owned_mesh;
        if (status == WCUT_OK) status = load_mesh(f, watch, error);
    }

    /* the hash of the file goes into the reports */
    return status == WCUT_OK ? wcut_source_hash(r->path, f->hash, error) : status;
}

wcut_status wcut_compare_face_load(const wcut_compare_reference *reference, const wcut_compare_options *options,
                                   const wcut_compare_watch *watch, wcut_compare_face *face, wcut_error *error) {
    const wcut_compare_reference *r = reference;
    wcut_compare_face *f = face;

    /* defaults, and the name that messages use */
    *f = (wcut_compare_face){.name = r->name   ? r->name
                                     : r->path ? r->path
                                               : "reference",
                             .distance = options->distance,
                             .options = wcut_deviation_options_default()};
    f->options.flip = options->flip;
    if (!r->path && r->face) return refuse_face(f, error);
    if (!r->path && (r->edges || r->force_law)) return refuse_change(f, r->edges ? "edges" : "force law", error);

    /* one of the four */
    wcut_status status;
    if (r->path) {
        status = load_file(f, r, options, watch, error);
    } else if (r->history) {
        f->job = wcut_setup_job(r->setup), f->setup = r->setup, f->history = r->history;
        status = load_job(f, options, error);
    } else if (r->mesh) {
        f->mesh = r->mesh;
        status = load_mesh(f, watch, error);
    } else {
        f->surface = r->surface;
        status = load_surface(f, options, watch, error);
    }
    if (status != WCUT_OK) return status;

    /* distances to the surface need one; area of the face seen from above */
    if (!f->surface && f->distance == WCUT_COMPARE_DISTANCE_SURFACE) f->distance = WCUT_COMPARE_DISTANCE_MESH;
    f->plan = (f->high.x - f->low.x) * (f->high.y - f->low.y);
    return WCUT_OK;
}

void wcut_compare_face_clear(wcut_compare_face *face) {
    wcut_mesh_tree_destroy(face->tree);
    wcut_mesh_destroy(face->owned_mesh);
    wcut_projection_destroy(face->projection);
    for (int k = 0; face->other_projection && k < face->others; k++) wcut_projection_destroy(face->other_projection[k]);
    wcut_free(face->other_projection);
    wcut_free(face->other);
    wcut_trimmed_set_destroy(face->faces);
    wcut_surface_destroy(face->base);
    wcut_face_destroy(face->face);
    wcut_history_destroy(face->owned_history);
    wcut_setup_destroy(face->owned_setup);
    wcut_job_destroy(face->owned_job);
    wcut_free(face->mount_a);
    wcut_free(face->mount_b);
    *face = (wcut_compare_face){0};
}

wcut_status wcut_compare_face_prepare(wcut_compare_face *face) {
    wcut_status status = face->projection ? wcut_projection_prepare_many(face->projection) : WCUT_OK;
    for (int k = 0; status == WCUT_OK && k < face->others; k++)
        status = wcut_projection_prepare_many(face->other_projection[k]);
    return status;
}

/* Of two faces the one that the point belongs to: where it counts before where it does not, then the nearer one. Beyond
   the border of both it is ambiguous only where it is so on one. */
static bool is_better(const wcut_deviation *a, const wcut_deviation *b) {
    const bool counts_a = a->place <= WCUT_PLACE_BORDER, counts_b = b->place <= WCUT_PLACE_BORDER;
    if (counts_a != counts_b) return counts_a;
    if (!counts_a && a->place != b->place) return a->place == WCUT_PLACE_AMBIGUOUS;
    return fabs(a->distance) < fabs(b->distance);
}

/* by several faces: each point by the best of them */
static wcut_status locate_on_others(const wcut_compare_face *f, int count, const wcut_vec3 *point, int threads,
                                    wcut_deviation *deviation) {
    wcut_deviation *on = wcut_alloc((size_t)count, sizeof *on);
    wcut_status status = on || count == 0 ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < f->others; k++) {
        status = wcut_deviation_from_trimmed(f->other[k], f->other_projection[k], count, point, &f->options, threads,
                                             on, NULL);
        for (int i = 0; status == WCUT_OK && i < count; i++)
            if (is_better(&on[i], &deviation[i])) deviation[i] = on[i];
    }
    wcut_free(on);
    return status;
}

wcut_status wcut_compare_face_locate(const wcut_compare_face *face, int count, const wcut_vec3 *point, int threads,
                                     wcut_deviation *deviation, wcut_foot *foot) {
    const wcut_compare_face *f = face;
    if (f->trimmed && !wcut_compare_face_by_triangles(f)) {
        const wcut_status status =
            wcut_deviation_from_trimmed(f->trimmed, f->projection, count, point, &f->options, threads, deviation, foot);
        return status == WCUT_OK && f->others > 0 ? locate_on_others(f, count, point, threads, deviation) : status;
    }
    if (!wcut_compare_face_by_triangles(f))
        return wcut_deviation_from_surface(f->projection, count, point, &f->options, threads, deviation, foot);
    const wcut_status status = wcut_deviation_from_mesh(f->tree, count, point, &f->options, threads, deviation);
    return status == WCUT_OK && f->face ? wcut_deviation_onto_surface(f->mesh, count, deviation) : status;
}

bool wcut_compare_face_by_triangles(const wcut_compare_face *face) {
    return !face->surface || face->distance == WCUT_COMPARE_DISTANCE_MESH;
}
