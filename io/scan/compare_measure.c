/* The figures of a comparison: every point from the face, the scan as a mesh, and the way back from face to scan. */
#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/scan/compare_state.h"

/* ---- the points ---- */

/* room for a piece */
typedef struct pass {
    wcut_comparing *c;
    int total;
    wcut_vec3 *moved;      /* WCUT_COMPARE_PIECE */
    wcut_deviation *found; /* WCUT_COMPARE_PIECE */
    wcut_deviation *flat;  /* WCUT_COMPARE_PIECE, on the triangles of a surface; NULL where there is none */
} pass;

/* what the view, the reconstruction and the way back need of a piece that is held */
static void keep_piece(wcut_comparing *c, int first, int count, const wcut_vec3 *moved, const wcut_deviation *d) {
    memcpy(c->cloud.point + first, moved, (size_t)count * sizeof *moved);
    for (int k = 0; k < count; k++) c->deviation[first + k] = d[k].place <= WCUT_PLACE_BORDER ? d[k].distance : NAN;
    if (c->row) memcpy(c->row + first, d, (size_t)count * sizeof *d);
}

static wcut_status locate_points(const wcut_comparing *c, int count, const wcut_vec3 *point, wcut_deviation *d,
                                 wcut_foot *foot) {
    return wcut_compare_face_locate(&c->face, count, point, c->options.threads, d, foot);
}

/* into the map of colours; the exact distances to a given surface are spread by the triangles that they are near */
static wcut_status spread_deviation(const pass *p, int count) {
    wcut_comparing *c = p->c;
    if (c->map) {
        wcut_face_map_add(c->map, c->face.face, count, p->found);
        return WCUT_OK;
    }
    if (!p->flat) return wcut_mesh_spread(c->mesh, count, p->found, c->sum, c->weight);

    /* where on the triangles, and how far from the surface */
    const wcut_status status =
        wcut_deviation_from_mesh(c->face.tree, count, p->moved, &c->face.options, c->options.threads, p->flat);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < count; k++) p->flat[k].distance = p->found[k].distance, p->flat[k].place = p->found[k].place;
    return wcut_mesh_spread(c->mesh, count, p->flat, c->sum, c->weight);
}

static wcut_status measure_piece(const pass *p, int first, int count, const wcut_vec3 *point, wcut_error *error) {
    wcut_comparing *c = p->c;
    wcut_status status = WCUT_OK;

    /* as scanned */
    if (c->summary[WCUT_COMPARE_UNMOVED]) {
        status = locate_points(c, count, point, p->found, NULL);
        if (status == WCUT_OK) status = wcut_deviation_summary_add(c->summary[WCUT_COMPARE_UNMOVED], count, p->found);
    }

    /* as registered */
    memcpy(p->moved, point, (size_t)count * sizeof *point);
    if (status == WCUT_OK) status = wcut_registration_move(&c->registration, count, p->moved, NULL);
    const bool keeps_feet = c->foot && c->cloud.held && !wcut_compare_face_by_triangles(&c->face);
    if (status == WCUT_OK) status = locate_points(c, count, p->moved, p->found, keeps_feet ? c->foot + first : NULL);

    /* to where it is summed up and written */
    if (status == WCUT_OK && c->options.distance != WCUT_COMPARE_DISTANCE_RECONSTRUCTION)
        status = wcut_deviation_summary_add(c->summary[WCUT_COMPARE_FOUND], count, p->found);
    if (status == WCUT_OK && c->survey) status = wcut_survey_add(c->survey, count, p->moved, p->found);
    if (status == WCUT_OK) status = spread_deviation(p, count);
    if (status == WCUT_OK && c->points)
        status = wcut_deviation_stream_append(c->points, count, p->moved, c->normal ? c->normal + first : NULL,
                                              p->found, error);
    return status;
}

static wcut_status take_piece(void *context, int first, int count, const wcut_vec3 *point, wcut_error *error) {
    const pass *p = context;
    wcut_comparing *c = p->c;
    const wcut_status status = measure_piece(p, first, count, point, error);
    if (status != WCUT_OK) return wcut_compare_fail(status, "measuring deviations", error);
    if (c->cloud.held) keep_piece(c, first, count, p->moved, p->found);

    /* whoever watches may stop it */
    const wcut_compare_watch *w = &c->watch;
    if (!w->progress || !w->progress(WCUT_COMPARE_STAGE_MEASURE, first + count - 1, p->total, w->context))
        return WCUT_OK;
    return wcut_fail(error, WCUT_INTERRUPTED, "compare: interrupted after %d of %d points", first + count, p->total);
}

/* the sample of a scan that was streamed, and feet where they were not taken along */
static wcut_status take_sample_piece(const pass *p, int first, int count, const wcut_vec3 *point) {
    wcut_comparing *c = p->c;
    memcpy(p->moved, point, (size_t)count * sizeof *point);
    wcut_status status = wcut_registration_move(&c->registration, count, p->moved, NULL);
    if (status == WCUT_OK) status = locate_points(c, count, p->moved, p->found, NULL);
    if (status == WCUT_OK) keep_piece(c, first, count, p->moved, p->found);
    return status;
}

static wcut_status measure_sample(const pass *p) {
    wcut_comparing *c = p->c;
    wcut_status status = WCUT_OK;
    for (int k = 0; k < c->cloud.count && status == WCUT_OK && !c->cloud.held; k += WCUT_COMPARE_PIECE) {
        const int left = c->cloud.count - k;
        status = take_sample_piece(p, k, left < WCUT_COMPARE_PIECE ? left : WCUT_COMPARE_PIECE, c->cloud.point + k);
    }
    if (status == WCUT_OK && c->foot && (!c->cloud.held || wcut_compare_face_by_triangles(&c->face)))
        status =
            wcut_projection_locate(c->face.projection, c->cloud.count, c->cloud.point, c->options.threads, c->foot);
    return status;
}

wcut_status wcut_compare_measure(wcut_comparing *comparing, wcut_error *error) {
    wcut_comparing *c = comparing;

    /* buffers of one piece; chords are located too where the surface is exact and the map needs triangles */
    const bool exact = c->face.surface && !c->face.face && !wcut_compare_face_by_triangles(&c->face);
    pass p = {.c = c, .total = c->cloud.held ? c->cloud.count : c->cloud.removed[WCUT_REMOVAL_KEPT]};
    p.moved = wcut_alloc(WCUT_COMPARE_PIECE, sizeof *p.moved);
    p.found = wcut_alloc(WCUT_COMPARE_PIECE, sizeof *p.found);
    if (exact) p.flat = wcut_alloc(WCUT_COMPARE_PIECE, sizeof *p.flat);
    wcut_status status =
        p.moved && p.found && (!exact || p.flat) ? WCUT_OK : wcut_compare_fail(WCUT_NO_MEMORY, "compare", error);

    /* all points, then the sample that stands for them in the view */
    if (status == WCUT_OK) status = wcut_compare_cloud_pass(&c->cloud, take_piece, &p, error);
    if (status == WCUT_OK) {
        status = measure_sample(&p);
        if (status != WCUT_OK) wcut_compare_fail(status, "measuring deviations", error);
    }
    wcut_free(p.flat);
    wcut_free(p.found);
    wcut_free(p.moved);
    return status;
}

/* ---- the scan as a face ---- */

/* figures of deviations that count; reversed: the other face's point of view */
static wcut_status histogram(const wcut_comparing *c, int count, const wcut_deviation *d, int sign,
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
static wcut_status measure_to_face(wcut_comparing *c, wcut_deviation *d) {
    const wcut_compare_face *f = &c->face;
    const wcut_mesh *mesh = c->reconstruction->mesh;
    const int count = mesh->vertex_count, threads = c->options.threads;
    wcut_status status =
        f->surface ? wcut_deviation_from_surface(f->projection, count, mesh->vertex, &f->options, threads, d, NULL)
                   : wcut_compare_face_locate(f, count, mesh->vertex, threads, d, NULL);
    for (int k = 0; k < count && status == WCUT_OK && !f->surface; k++) mesh->scalar[k] = d[k].distance;
    if (status == WCUT_OK) status = histogram(c, count, d, 1, &c->to_face);
    if (status == WCUT_OK && c->options.distance == WCUT_COMPARE_DISTANCE_RECONSTRUCTION)
        status = wcut_deviation_summary_add(c->summary[WCUT_COMPARE_FOUND], count, d);
    return status;
}

/* the face's grid, or the mesh's vertices, from the reconstruction: what is above the face has it below */
static wcut_status measure_to_scan(wcut_comparing *c, wcut_deviation *d) {
    const wcut_face *face = c->face.face;
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

wcut_status wcut_compare_reconstruct(wcut_comparing *comparing, wcut_error *error) {
    wcut_comparing *c = comparing;
    if (!c->options.reconstruct) return WCUT_OK;

    /* of a scan that was streamed there is a sample only, whose points are that far apart */
    wcut_reconstruction_options options = wcut_reconstruction_options_default();
    options.support = fmax(c->support, 2.5 * c->cloud.spacing);
    if (c->face.face)
        options.block = c->face.high;
    else if (!c->face.surface)
        options.mesh = c->face.mesh;

    /* heights over the base surface of the face */
    const wcut_surface *surface = NULL;
    wcut_status status = wcut_compare_face_base(&c->face, &surface, error);
    if (status != WCUT_OK) return status;
    status = wcut_reconstruction_create(surface, c->cloud.count, c->cloud.point, c->foot, &options, c->options.threads,
                                        &c->reconstruction, error);
    if (status != WCUT_OK) return wcut_compare_fail(status, "reconstructing the scan", error);

    /* its figures, both ways */
    const int vertices = c->reconstruction->mesh->vertex_count, grid = c->mesh->vertex_count;
    wcut_deviation *d = wcut_alloc((size_t)(vertices > grid ? vertices : grid), sizeof *d);
    status = d ? measure_to_face(c, d) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = measure_to_scan(c, d);
    wcut_free(d);
    return status == WCUT_OK ? WCUT_OK : wcut_compare_fail(status, "measuring the reconstruction", error);
}

/* ---- the way back, the map ---- */

static wcut_status measure_from_face(wcut_comparing *c) {
    const wcut_mesh *mesh = c->mesh;
    wcut_vec3 *from = wcut_alloc((size_t)mesh->vertex_count, sizeof *from);
    double *distance = wcut_alloc((size_t)mesh->vertex_count, sizeof *distance);
    int count = 0;
    wcut_histogram *histogram = NULL;
    wcut_status status = from && distance ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; k < mesh->vertex_count && status == WCUT_OK; k++)
        if (!c->face.face || c->face.face->inside[k]) from[count++] = mesh->vertex[k];
    if (status == WCUT_OK)
        status = wcut_cloud_locate(c->cloud.count, c->cloud.point, count, from, c->options.threads, distance);
    if (status == WCUT_OK) status = wcut_histogram_create(0, NULL, &histogram);
    if (status == WCUT_OK) status = wcut_histogram_add(histogram, count, distance);
    if (status == WCUT_OK) status = wcut_histogram_eval(histogram, &c->face_to_scan);
    wcut_histogram_destroy(histogram);
    wcut_free(distance);
    wcut_free(from);
    return status;
}

static wcut_status fill_compare_map(wcut_comparing *c, double *unmeasured) {
    if (c->map) return wcut_face_map_eval(c->map, c->face.face, c->support, c->value, c->present, unmeasured);
    return wcut_mesh_map_eval(c->mesh, c->sum, c->weight, c->cloud.count, c->cloud.point,
                              fmax(c->support, sqrt(3) * c->cloud.spacing), c->options.threads, c->value, c->present,
                              unmeasured);
}

wcut_status wcut_compare_measure_back(wcut_comparing *comparing, double *unmeasured, wcut_error *error) {
    wcut_status status = measure_from_face(comparing);
    if (status == WCUT_OK) status = fill_compare_map(comparing, unmeasured);
    return status == WCUT_OK ? WCUT_OK : wcut_compare_fail(status, "compare", error);
}
