/* A comparison of a scan with a face: load, register, measure point by point, and the way back. */
#include "compare_run.h"
#include <wirecut/deviation_file.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "terminal.h"

enum { FOUND, UNMOVED };
enum { MANY = 100000 };
enum { GLANCE = 20000 }; /* points that set the colours, the support and the first warnings */

static int fail(wcut_status status, const char *step, const wcut_error *error) {
    return app_fail_status(status, error && error->text[0] ? NULL : step, error);
}

/* ---- what is compared ---- */

/* a point, or a row of them, says nothing of a face */
static int check_span(const app_comparison *c) {
    static const char *const where[] = {"in one place", "on one line"};
    int span;
    const wcut_status status = wcut_cloud_span(c->scans.count, c->scans.point, &span);
    if (status != WCUT_OK) return fail(status, c->options.scan[0], NULL);
    if (span == 2) return APP_DONE;
    return app_fail(APP_BAD_INPUT, "%s: found %d points %s, expected a scan of a face", c->options.scan[0],
                    c->scans.held ? c->scans.count : c->scans.removed[WCUT_REMOVAL_KEPT], where[span]);
}

static void warn_of_unit(const app_comparison *c) {
    const app_reference *r = &c->reference;
    const wcut_vec3 size = {r->high.x - r->low.x, r->high.y - r->low.y, fmax(r->high.z - r->low.z, 1)};
    wcut_cloud_unit fit;
    if (wcut_cloud_unit_eval(c->scans.low, c->scans.high, size, &fit) != WCUT_OK || fit.factor == 1) return;
    if (fit.factor > 0)
        app_say(
            "%s: warning: the scan is %.3g times as large as the face; multiplied by %.5g it would fit: another "
            "--unit or --reference-unit?",
            c->options.scan[0], fit.ratio, fit.factor);
    else
        app_say("%s: warning: the scan is %.3g times as large as the face", c->options.scan[0], fit.ratio);
}

/* An even choice of the points held. */
static int glance(const app_comparison *c, wcut_vec3 *point) {
    const int count = c->scans.count, step = count > GLANCE ? count / GLANCE : 1;
    int taken = 0;
    for (int k = 0; k < count && taken < GLANCE; k += step) point[taken++] = c->scans.point[k];
    return taken;
}

/* [mm] the distance of neighbouring points, if they cover the face evenly */
static double spacing_of(const app_comparison *c) {
    const int count = c->scans.held ? c->scans.count : c->scans.removed[WCUT_REMOVAL_KEPT];
    return sqrt(c->reference.plan / fmax(count, 1));
}

/* worth its while for many points only */
static int prepare_many(app_comparison *c) {
    if (!c->reference.projection || c->scans.removed[WCUT_REMOVAL_KEPT] < MANY) return APP_DONE;
    const wcut_status status = wcut_projection_prepare_many(c->reference.projection);
    return status == WCUT_OK ? APP_DONE : fail(status, "compare", NULL);
}

/* ---- registration ---- */

static int register_datum(app_comparison *c) {
    /* the datums of the file */
    wcut_error error = {0};
    wcut_datums *datums = NULL;
    wcut_status status = wcut_datums_read(c->options.datum_path, &datums, &error);
    if (status == WCUT_OK) {
        status = wcut_registration_solve_datum(datums->pairs, datums->pair, datums->faces, datums->face,
                                               &c->options.registration, &c->registration, &error);
        if (status != WCUT_OK && status != WCUT_NOT_CONVERGED && error.text[0])
            return wcut_datums_destroy(datums), app_fail(APP_BAD_INPUT, "%s: %s", c->options.datum_path, error.text);
    }
    if (status == WCUT_NOT_CONVERGED) status = WCUT_OK; /* told at the end */

    /* what is left of each, a point of a face each */
    if (status == WCUT_OK) {
        c->datums = datums->pairs + datums->faces;
        c->datum = calloc((size_t)c->datums, sizeof *c->datum);
        status = c->datum ? wcut_datum_residual_eval(&c->registration, datums->pairs, datums->pair, datums->faces,
                                                     datums->face, c->datum)
                          : WCUT_NO_MEMORY;
    }

    wcut_datums_destroy(datums);
    return status == WCUT_OK ? APP_DONE : fail(status, c->options.datum_path, &error);
}

static int register_fit(app_comparison *c) {
    wcut_error error = {0};
    const app_reference *r = &c->reference;
    const app_compare_options *o = &c->options;
    const wcut_status status = r->is_job
                                   ? wcut_registration_fit(r->projection, c->scans.count, c->scans.point,
                                                           &o->registration, o->threads, &c->registration, &error)
                                   : wcut_registration_fit_mesh(r->mesh, r->tree, c->scans.count, c->scans.point,
                                                                &o->registration, o->threads, &c->registration, &error);
    /* the best pose is written, and that it is in doubt */
    return status == WCUT_OK || status == WCUT_NOT_CONVERGED ? APP_DONE : fail(status, "registering the scan", &error);
}

static int register_scan(app_comparison *c) {
    c->registration = wcut_registration_none();
    if (c->options.method == WCUT_REGISTRATION_METHOD_DATUM) return register_datum(c);
    return c->options.method == WCUT_REGISTRATION_METHOD_FIT ? register_fit(c) : APP_DONE;
}

/* ---- what comes before the points ---- */

static int compare_numbers(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The strongest colour is for the deviation that one point in a hundred exceeds, two digits of it; a scan of which no
   point is over the face is refused before it is read on. */
static wcut_status look(app_comparison *c, int *counted) {
    /* a sample of the scan, moved as the registration says */
    wcut_vec3 *point = calloc(GLANCE, sizeof *point);
    wcut_deviation *d = calloc(GLANCE, sizeof *d);
    double *size = calloc(GLANCE, sizeof *size);
    wcut_status status = point && d && size ? WCUT_OK : WCUT_NO_MEMORY;
    const int count = status == WCUT_OK ? glance(c, point) : 0;
    if (status == WCUT_OK) status = wcut_registration_move(&c->registration, count, point, NULL);
    if (status == WCUT_OK) status = app_reference_locate(&c->reference, count, point, c->options.threads, d, NULL);

    /* sizes of the deviations of points on the face */
    *counted = 0;
    for (int k = 0; k < count && status == WCUT_OK; k++)
        if (d[k].place <= WCUT_PLACE_BORDER) size[(*counted)++] = fabs(d[k].distance);

    /* the limit of the colours: the 99th percentile, rounded up to two digits */
    if (*counted > 0) {
        qsort(size, (size_t)*counted, sizeof *size, compare_numbers);
        const double max = fmax(size[(int)(0.99 * (*counted - 1))], 1e-3), unit = pow(10, floor(log10(max)) - 1);
        c->limit = ceil(max / unit) * unit;
    }

    free(size);
    free(d);
    free(point);
    return status;
}

static int refuse_elsewhere(const app_comparison *c) {
    const app_reference *r = &c->reference;
    const wcut_vec3 *l = &c->scans.low, *h = &c->scans.high;
    return app_fail(APP_BAD_INPUT,
                    "%s: found points from (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm, none of them over the face, "
                    "expected some in (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm: another --unit, or --register?",
                    c->options.scan[0], l->x, l->y, l->z, h->x, h->y, h->z, r->low.x, r->low.y, r->low.z, r->high.x,
                    r->high.y, r->high.z);
}

static wcut_status begin_survey(app_comparison *c, int which) {
    wcut_deviation_summary_options options = wcut_deviation_summary_options_default();
    options.low = c->reference.low, options.high = c->reference.high;
    options.bands = c->options.bands;
    memcpy(options.band, c->options.band, sizeof options.band);
    return wcut_deviation_summary_create(&options, c->reference.face, &c->summary[which]);
}

static wcut_status make_map(app_comparison *c) {
    wcut_status status = WCUT_OK;
    if (c->reference.is_job) {
        status = wcut_face_mesh(c->reference.face, &c->mesh);
        if (status == WCUT_OK) status = wcut_face_map_create(c->reference.face, &c->map);
    } else {
        c->mesh = c->reference.mesh;
    }
    if (status != WCUT_OK) return status;
    const size_t count = (size_t)c->mesh->vertex_count;
    c->value = calloc(count, sizeof *c->value);
    c->present = calloc(count, 1);
    c->sum = calloc(c->map ? 1 : count, sizeof *c->sum);
    c->weight = calloc(c->map ? 1 : count, sizeof *c->weight);
    return c->value && c->present && c->sum && c->weight ? WCUT_OK : WCUT_NO_MEMORY;
}

/* the points' normals, where they are wanted: of what is held, as registered, to the side of the removed half */
static int find_normals(app_comparison *c) {
    /* none are wanted, or the points are not held in memory */
    const size_t count = (size_t)c->scans.count;
    wcut_normals_options options = wcut_normals_options_default();
    options.neighbours = c->options.normals;
    if (c->options.normals == 0) return APP_DONE;
    if (!c->scans.held)
        return app_fail(APP_USAGE, "--normals: found %d points, expected --hold of at least as many",
                        c->scans.removed[WCUT_REMOVAL_KEPT]);

    /* normals belong to the points as they are moved */
    c->normal = calloc(count, sizeof *c->normal);
    wcut_vec3 *moved = calloc(count, sizeof *moved);
    wcut_status status = c->normal && moved ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        memcpy(moved, c->scans.point, count * sizeof *moved);
        status = wcut_registration_move(&c->registration, c->scans.count, moved, NULL);
    }
    if (status == WCUT_OK)
        status = wcut_cloud_normals(c->scans.count, moved, &options, c->options.threads, c->normal, NULL);

    free(moved);
    return status == WCUT_OK ? APP_DONE : fail(status, "finding the points' normals", NULL);
}

static int prepare_comparison(app_comparison *c, app_results *results) {
    wcut_error error = {0};

    /* a first look decides the limit of the colours */
    int counted = 0;
    wcut_status status = look(c, &counted);
    if (status == WCUT_OK && counted == 0) return refuse_elsewhere(c);

    /* support of a point: given, or from the spacing */
    const double spacing = spacing_of(c);
    c->support = c->options.support > 0 ? c->options.support : fmax(1.5, 2.5 * spacing);
    if (status == WCUT_OK) status = begin_survey(c, FOUND);

    /* a face of too many zones: a vertex far from the others, or another unit */
    const wcut_vec3 *low = &c->reference.low, *high = &c->reference.high;
    if (status == WCUT_BAD_ARGUMENT)
        return app_fail(APP_BAD_INPUT,
                        "%s: found a face from (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm, too large for its zones: a "
                        "stray vertex, or another --reference-unit?",
                        c->reference.path, low->x, low->y, low->z, high->x, high->y, high->z);

    /* the deviations as they were scanned, for comparison */
    if (status == WCUT_OK && c->options.method != WCUT_REGISTRATION_METHOD_NONE) status = begin_survey(c, UNMOVED);
    if (status == WCUT_OK) status = make_map(c);

    /* arrays for the deviations of the points that are held */
    const size_t count = (size_t)c->scans.count;
    c->deviation = calloc(count, sizeof *c->deviation);
    if (c->options.reconstruct > 0) c->foot = calloc(count, sizeof *c->foot);
    if (status == WCUT_OK && (!c->deviation || (c->options.reconstruct > 0 && !c->foot))) status = WCUT_NO_MEMORY;

    /* the file of coloured points is written as they come */
    if (status == WCUT_OK)
        status = wcut_deviation_stream_create(app_results_path(results, "deviation.ply"), c->limit, c->normal != NULL,
                                              &c->points, &error);

    return status == WCUT_OK ? APP_DONE : fail(status, "compare", &error);
}

/* ---- the points ---- */

/* room for a piece */
typedef struct pass {
    app_comparison *c;
    app_progress progress;
    int total;
    wcut_vec3 *moved;      /* APP_SCAN_PIECE */
    wcut_deviation *found; /* APP_SCAN_PIECE */
} pass;

/* what the view, the reconstruction and the way back need of a piece that is held */
static void keep_piece(app_comparison *c, int first, int count, const wcut_vec3 *moved, const wcut_deviation *d) {
    memcpy(c->scans.point + first, moved, (size_t)count * sizeof *moved);
    for (int k = 0; k < count; k++) c->deviation[first + k] = d[k].place <= WCUT_PLACE_BORDER ? d[k].distance : NAN;
}

static wcut_status locate_points(const app_comparison *c, int count, const wcut_vec3 *point, wcut_deviation *d,
                                 wcut_foot *foot) {
    return app_reference_locate(&c->reference, count, point, c->options.threads, d, foot);
}

static wcut_status spread_deviation(app_comparison *c, int count, const wcut_deviation *d) {
    if (!c->map) return wcut_mesh_spread(c->mesh, count, d, c->sum, c->weight);
    wcut_face_map_add(c->map, c->reference.face, count, d);
    return WCUT_OK;
}

static int take_piece(void *context, int first, int count, const wcut_vec3 *point) {
    pass *p = context;

    /* before the registration, where there is one */
    app_comparison *c = p->c;
    wcut_error error = {0};
    wcut_status status = WCUT_OK;
    if (c->summary[UNMOVED]) {
        status = locate_points(c, count, point, p->found, NULL);
        if (status == WCUT_OK) status = wcut_deviation_summary_add(c->summary[UNMOVED], count, p->found);
    }

    /* after the registration, with feet where a reconstruction needs them */
    memcpy(p->moved, point, (size_t)count * sizeof *point);
    if (status == WCUT_OK) status = wcut_registration_move(&c->registration, count, p->moved, NULL);
    wcut_foot *foot = c->foot && c->scans.held && !c->reference.tree ? c->foot + first : NULL;
    if (status == WCUT_OK) status = locate_points(c, count, p->moved, p->found, foot);
    if (status == WCUT_OK && c->options.distance != APP_TO_RECONSTRUCTION)
        status = wcut_deviation_summary_add(c->summary[FOUND], count, p->found);

    /* spread over the map of the face, and into the file */
    if (status == WCUT_OK) status = spread_deviation(c, count, p->found);
    if (status == WCUT_OK)
        status = wcut_deviation_stream_append(c->points, count, p->moved, c->normal ? c->normal + first : NULL,
                                              p->found, &error);
    if (status != WCUT_OK) return fail(status, "measuring deviations", &error);

    /* keep what is held in memory, and show the progress */
    if (c->scans.held) keep_piece(c, first, count, p->moved, p->found);
    if (app_progress_step(first + count - 1, p->total, &p->progress))
        return app_fail(APP_INTERRUPTED, "compare: interrupted after %d of %d points", first + count, p->total);

    return APP_DONE;
}

/* the sample of a scan that was streamed, and feet where they were not taken along */
static int take_sample(void *context, int first, int count, const wcut_vec3 *point) {
    pass *p = context;
    app_comparison *c = p->c;
    memcpy(p->moved, point, (size_t)count * sizeof *point);
    wcut_status status = wcut_registration_move(&c->registration, count, p->moved, NULL);
    if (status == WCUT_OK) status = locate_points(c, count, p->moved, p->found, NULL);
    if (status != WCUT_OK) return fail(status, "measuring deviations", NULL);
    keep_piece(c, first, count, p->moved, p->found);
    return APP_DONE;
}

static int measure_scans(app_comparison *c) {
    /* a piece of points at a time */
    pass p = {.c = c, .total = c->scans.held ? c->scans.count : c->scans.removed[WCUT_REMOVAL_KEPT]};
    p.moved = calloc(APP_SCAN_PIECE, sizeof *p.moved);
    p.found = calloc(APP_SCAN_PIECE, sizeof *p.found);
    int code = p.moved && p.found ? APP_DONE : fail(WCUT_NO_MEMORY, "compare", NULL);

    /* all points once */
    p.progress = app_progress_begin(c->options.quiet);
    p.progress.unit = "points";
    if (code == APP_DONE) code = app_scans_pass(&c->scans, take_piece, &p);
    app_progress_end(&p.progress);

    /* of a scan that is not held, the sample is measured for the view */
    for (int k = 0; k < c->scans.count && code == APP_DONE && !c->scans.held; k += APP_SCAN_PIECE) {
        const int left = c->scans.count - k;
        code = take_sample(&p, k, left < APP_SCAN_PIECE ? left : APP_SCAN_PIECE, c->scans.point + k);
    }

    /* feet for the reconstruction, where they are not there yet */
    if (code == APP_DONE && c->foot && (!c->scans.held || c->reference.tree)) {
        const wcut_status status = wcut_projection_locate(c->reference.projection, c->scans.count, c->scans.point,
                                                          c->options.threads, c->foot);
        if (status != WCUT_OK) code = fail(status, "measuring deviations", NULL);
    }

    free(p.found);
    free(p.moved);
    return code;
}

/* ---- the scan as a face ---- */

/* figures of deviations that count; reversed: the other face's point of view */
static wcut_status histogram(const app_comparison *c, int count, const wcut_deviation *d, int sign,
                             wcut_statistics *statistics) {
    wcut_histogram *histogram = NULL;
    wcut_status status = wcut_histogram_create(c->options.bands, c->options.band, &histogram);
    for (int k = 0; k < count && status == WCUT_OK; k++) {
        const double distance = sign * d[k].distance;
        if (d[k].place <= WCUT_PLACE_BORDER) status = wcut_histogram_add(histogram, 1, &distance);
    }
    if (status == WCUT_OK) status = wcut_histogram_eval(histogram, statistics);
    wcut_histogram_destroy(histogram);
    return status;
}

/* the reconstruction's vertices from the face; they are what the summary is of where distances are taken so */
static wcut_status measure_to_face(app_comparison *c, wcut_deviation *d) {
    const app_reference *r = &c->reference;
    const wcut_mesh *mesh = c->reconstruction->mesh;
    const int count = mesh->vertex_count, threads = c->options.threads;
    wcut_status status =
        r->is_job ? wcut_deviation_from_surface(r->projection, count, mesh->vertex, &r->options, threads, d, NULL)
                  : app_reference_locate(r, count, mesh->vertex, threads, d, NULL);
    for (int k = 0; k < count && status == WCUT_OK && !r->is_job; k++) mesh->scalar[k] = d[k].distance;
    if (status == WCUT_OK) status = histogram(c, count, d, 1, &c->to_face);
    if (status == WCUT_OK && c->options.distance == APP_TO_RECONSTRUCTION)
        status = wcut_deviation_summary_add(c->summary[FOUND], count, d);
    return status;
}

/* the face's grid, or the mesh's vertices, from the reconstruction: what is above the face has it below */
static wcut_status measure_to_scan(app_comparison *c, wcut_deviation *d) {
    const wcut_face *face = c->reference.face;
    wcut_mesh_tree *tree = NULL;
    wcut_status status = wcut_mesh_tree_create(c->reconstruction->mesh, &tree);
    if (status == WCUT_OK)
        status = wcut_deviation_from_mesh(tree, c->mesh->vertex_count, c->mesh->vertex, NULL, c->options.threads, d);
    for (int k = 0; k < c->mesh->vertex_count && status == WCUT_OK && face; k++)
        if (!face->inside[k]) d[k].place = WCUT_PLACE_BEYOND;
    if (status == WCUT_OK) status = histogram(c, c->mesh->vertex_count, d, -1, &c->to_scan);
    wcut_mesh_tree_destroy(tree);
    return status;
}

static int reconstruct_scans(app_comparison *c) {
    wcut_error error = {0};

    /* only where it is asked for */
    if (c->options.reconstruct == 0) return APP_DONE;
    wcut_reconstruction_options options = wcut_reconstruction_options_default();
    /* of a scan that was streamed there is a sample only, whose points are that far apart */
    options.support = fmax(c->support, 2.5 * c->scans.spacing);

    /* the face of a job is bounded by its block, that of a mesh by the mesh */
    if (c->reference.is_job)
        options.block = c->reference.high;
    else
        options.mesh = c->reference.mesh;

    /* the surface that the scan lies over */
    const wcut_surface *surface = NULL;
    const int code = app_reference_base(&c->reference, &surface);
    if (code != APP_DONE) return code;
    wcut_status status = wcut_reconstruction_create(surface, c->scans.count, c->scans.point, c->foot, &options,
                                                    c->options.threads, &c->reconstruction, &error);
    if (status != WCUT_OK) return fail(status, "reconstructing the scan", &error);

    /* deviations of the mesh's vertices, both ways */
    const int vertices = c->reconstruction->mesh->vertex_count, grid = c->mesh->vertex_count;
    wcut_deviation *d = calloc((size_t)(vertices > grid ? vertices : grid), sizeof *d);
    status = d ? measure_to_face(c, d) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = measure_to_scan(c, d);

    free(d);
    return status == WCUT_OK ? APP_DONE : fail(status, "measuring the reconstruction", NULL);
}

/* ---- the way back, the map ---- */

static wcut_status measure_back(app_comparison *c) {
    const wcut_mesh *mesh = c->mesh;
    wcut_vec3 *from = calloc((size_t)mesh->vertex_count, sizeof *from);
    double *distance = calloc((size_t)mesh->vertex_count, sizeof *distance);
    int count = 0;
    wcut_histogram *histogram = NULL;
    wcut_status status = from && distance ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; k < mesh->vertex_count && status == WCUT_OK; k++)
        if (!c->reference.is_job || c->reference.face->inside[k]) from[count++] = mesh->vertex[k];
    if (status == WCUT_OK)
        status = wcut_cloud_locate(c->scans.count, c->scans.point, count, from, c->options.threads, distance);
    if (status == WCUT_OK) status = wcut_histogram_create(0, NULL, &histogram);
    if (status == WCUT_OK) status = wcut_histogram_add(histogram, count, distance);
    if (status == WCUT_OK) status = wcut_histogram_eval(histogram, &c->face_to_scan);
    wcut_histogram_destroy(histogram);
    free(distance);
    free(from);
    return status;
}

static wcut_status fill_map(app_comparison *c, double *unmeasured) {
    if (c->map) return wcut_face_map_eval(c->map, c->reference.face, c->support, c->value, c->present, unmeasured);
    return wcut_mesh_map_eval(c->mesh, c->sum, c->weight, c->scans.count, c->scans.point,
                              fmax(c->support, sqrt(3) * c->scans.spacing), c->options.threads, c->value, c->present,
                              unmeasured);
}

/* everything that is written, in one place */
static int conclude_comparison(app_comparison *c) {
    /* the way back: from the face to the scan */
    static const char *const distance[] = {"surface", "mesh", "reconstruction"};
    double unmeasured = 0;
    wcut_status status = measure_back(c);
    if (status == WCUT_OK) status = fill_map(c, &unmeasured);

    /* figures after and before the registration */
    const wcut_deviation_summary_result *found = NULL, *unmoved = NULL;
    if (status == WCUT_OK) status = wcut_deviation_summary_eval(c->summary[FOUND], &found);
    if (status == WCUT_OK && c->summary[UNMOVED]) status = wcut_deviation_summary_eval(c->summary[UNMOVED], &unmoved);
    if (status != WCUT_OK) return fail(status, "compare", NULL);
    if (found->statistics.count == 0) return refuse_elsewhere(c);

    /* what was compared, and how */
    c->found = (wcut_compared){.reference = c->reference.path,
                               .distance = distance[c->reference.distance],
                               .part = c->options.part,
                               .inspector = c->options.inspector,
                               .instrument = c->options.instrument,
                               .date = c->options.date,
                               .datum_file = c->options.datum_path,
                               .cleaning = c->options.scans.cleaned ? &c->options.scans.clean : NULL,
                               .scans = c->scans.files,
                               .scan = c->scans.scan,
                               .registration = &c->registration,
                               .datums = c->datums,
                               .datum = c->datum,
                               .found = found,
                               .unmoved = unmoved ? unmoved : found,
                               .face_to_scan = &c->face_to_scan,
                               .resolution = sqrt(3) * c->scans.spacing,
                               .kerf = c->reference.kerf,
                               .has_kerf = c->reference.is_job,
                               .unmeasured = unmeasured,
                               .support = c->support,
                               .tolerance = c->options.tolerance,
                               .share = c->options.share,
                               .within = 1};

    /* counts of the cleaning, the gate, and the reconstruction */
    memcpy(c->found.removed, c->scans.removed, sizeof c->found.removed);
    for (int k = 0; k < found->statistics.bands; k++)
        if (found->statistics.band[k] == c->options.tolerance)
            c->found.within = found->statistics.within[k] >= c->options.share;
    if (c->reconstruction) {
        c->found.reconstruction_method = "field";
        c->found.reconstruction = c->reconstruction;
        c->found.to_scan = &c->to_scan, c->found.to_face = &c->to_face;
    }

    return APP_DONE;
}

int app_comparison_run(app_comparison *comparison, const app_compare_options *options, app_results *results) {
    /* the face */
    app_comparison *c = comparison;
    *c = (app_comparison){.options = *options};
    const app_compare_options *o = &c->options;
    const app_reference_options reference = {.path = o->reference,
                                             .force_law = o->force_law,
                                             .call = o->call,
                                             .distance = o->distance,
                                             .chord_tolerance = o->chord_tolerance,
                                             .unit = o->reference_unit,
                                             .flip = o->flip,
                                             .quiet = o->quiet};
    int code = app_reference_load(&c->reference, &reference);

    /* a reconstruction needs a surface to lie over */
    const wcut_surface *surface;
    if (code == APP_DONE && o->reconstruct > 0) code = app_reference_base(&c->reference, &surface);

    /* the scan, which must lie where the face is */
    app_scan_options scans = o->scans;
    scans.plan = c->reference.plan;
    if (code == APP_DONE) code = app_scans_read(&c->scans, &scans, o->files, o->scan);
    if (code == APP_DONE) code = check_span(c);
    if (code != APP_DONE) return code;

    /* what is done to many points is prepared once */
    warn_of_unit(c);
    code = prepare_many(c);

    /* the steps, each on what the one before left */
    if (code == APP_DONE) code = register_scan(c);
    if (code == APP_DONE) code = find_normals(c);
    if (code == APP_DONE) code = prepare_comparison(c, results);
    if (code == APP_DONE) code = measure_scans(c);
    if (code == APP_DONE) code = reconstruct_scans(c);

    return code == APP_DONE ? conclude_comparison(c) : code;
}

void app_comparison_clear(app_comparison *comparison) {
    app_comparison *c = comparison;
    wcut_deviation_stream_destroy(c->points);
    wcut_reconstruction_destroy(c->reconstruction);
    wcut_face_map_destroy(c->map);
    if (c->reference.is_job) wcut_mesh_destroy(c->mesh);
    for (int k = 0; k < 2; k++) wcut_deviation_summary_destroy(c->summary[k]);
    void *const memory[] = {c->value, c->present, c->sum, c->weight, c->deviation, c->normal, c->foot, c->datum};
    for (size_t k = 0; k < sizeof memory / sizeof *memory; k++) free(memory[k]);
    app_scans_clear(&c->scans);
    app_reference_clear(&c->reference);
}
