/* The scanned face from points and their feet: spacing, field of deviation, the mesh where there is support. */
#include <wirecut/reconstruction.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "scan/kd_tree.h"
#include "scan/reconstruct_base.h"
#include "scan/reconstruct_field.h"
#include "scan/reconstruct_sheet.h"
#include "scan/span.h"

enum { MIN = 10, NEAR = 8, SAMPLE = 2000 };

static const double FAR = 1e12;

wcut_reconstruction_options wcut_reconstruction_options_default(void) {
    return (wcut_reconstruction_options){.support = 1.5, .hole_min = 10};
}

void wcut_reconstruction_destroy(wcut_reconstruction *reconstruction) {
    if (!reconstruction) return;
    wcut_mesh_destroy(reconstruction->mesh);
    wcut_mesh_destroy(reconstruction->unmeasured);
    wcut_free(reconstruction->hole);
    wcut_free(reconstruction);
}

/* ---- what is given ---- */

static wcut_status reconstruct_check_options(const wcut_reconstruction_options *o, wcut_error *error) {
    if (!is_positive(o->support) || o->support > FAR)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "support: found %g, expected a positive number", o->support);
    if (!(o->spacing >= 0 && o->spacing <= FAR) || !(o->smoothing >= 0 && o->smoothing <= FAR) ||
        !(o->hole_min >= 0 && o->hole_min <= FAR))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "spacing, smoothing, hole_min: expected 0 or a positive number");
    const wcut_vec3 b = o->block;
    const bool none = b.x == 0 && b.y == 0 && b.z == 0;
    if (!none && !(is_positive(b.x) && is_positive(b.y) && is_positive(b.z)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "block: expected three positive numbers, or none");
    return WCUT_OK;
}

static wcut_status check_scan(const wcut_surface *surface, int count, const wcut_vec3 *point, const wcut_foot *foot,
                              wcut_error *error) {
    double first[2], last[2];
    wcut_surface_domain(surface, first, last);
    for (int k = 0; k < count; k++) {
        const wcut_foot *f = &foot[k];
        if (!(fabs(point[k].x) <= FAR && fabs(point[k].y) <= FAR && fabs(point[k].z) <= FAR))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "scan: point %d: expected numbers up to 1e12", k);
        if (!(f->u >= first[0] && f->u <= last[0] && f->v >= first[1] && f->v <= last[1]) || !isfinite(f->height))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "scan: point %d: its foot is not on the surface", k);
    }
    return WCUT_OK;
}

/* [mm] root of the area per point: the median, over some points, of the disc that reaches to the eighth neighbour */
static double point_spacing(const wcut_kd_tree *tree) {
    double spacing[SAMPLE] = {0};
    const int count = tree->count < SAMPLE ? tree->count : SAMPLE;
    const int neighbours = tree->count - 1 < NEAR ? tree->count - 1 : NEAR;
    for (int k = 0; k < count; k++) {
        wcut_kd_nearest nearest;
        wcut_kd_tree_nearest(tree, (int)((long long)k * tree->count / count), neighbours, &nearest);
        spacing[k] = sqrt(WCUT_PI * nearest.square[neighbours - 1] / (neighbours - 0.5));
    }
    wcut_sort(count, spacing);
    return spacing[count / 2];
}

/* ---- the field ---- */

/* the points over the face, by place and height */
typedef struct heights {
    int count;
    wcut_lattice_place *place;
    double *height;
} heights;

static void clear_heights(heights *h) {
    wcut_free(h->place);
    wcut_free(h->height);
}

static wcut_status find_heights(const wcut_lattice *lattice, const wcut_base *base, int count, const wcut_foot *foot,
                                int threads, heights *found) {
    heights h = {0, wcut_alloc((size_t)count, sizeof *h.place), wcut_alloc((size_t)count, sizeof *h.height)};
    if (!h.place || !h.height) {
        clear_heights(&h);
        return WCUT_NO_MEMORY;
    }
#pragma omp parallel for schedule(static) num_threads(wcut_threads(threads))
    for (int k = 0; k < count; k++) h.place[k] = wcut_lattice_locate(lattice, foot[k].u, foot[k].v);
    for (int k = 0; k < count; k++)
        if (!foot[k].beyond) {
            h.place[h.count] = h.place[k];
            h.height[h.count++] = foot[k].height - (base->height ? wcut_base_eval(base, lattice, h.place[k]) : 0);
        }
    *found = h;
    return WCUT_OK;
}

/* a scan on its way */
typedef struct job {
    const wcut_surface *surface;
    int count, threads;
    const wcut_vec3 *point;
    const wcut_foot *foot;
    const wcut_reconstruction_options *options;
    wcut_kd_tree tree;
    wcut_lattice lattice;
    wcut_base base; /* of a mesh */
    wcut_field field;
} job;

static wcut_status solve_field(job *j, wcut_reconstruction *r) {
    heights h = {0};
    wcut_status status = find_heights(&j->lattice, &j->base, j->count, j->foot, j->threads, &h);
    r->used = h.count;
    r->beyond = j->count - h.count;
    if (status == WCUT_OK && h.count < MIN) status = WCUT_DEGENERATE;
    if (status == WCUT_OK) {
        const int reach = (int)fmin(ceil(j->options->support / r->spacing), 1000);
        const double density = 1 / (r->point_spacing * r->point_spacing);
        status = wcut_field_solve(&j->lattice, h.count, h.place, h.height, density, r->smoothing, reach, j->threads,
                                  &j->field);
    }
    clear_heights(&h);
    r->rms = j->field.rms;
    r->iterations = j->field.iterations;
    return status;
}

/* the field as meshes */
static wcut_status cut(const job *j, wcut_reconstruction *r) {
    wcut_sheet sheet = {0};
    const wcut_reconstruction_options *o = j->options;
    wcut_status status =
        wcut_sheet_raise(&j->lattice, &j->field, j->base.covered, &j->tree, o->support, o->block, j->threads, &sheet);
    if (status == WCUT_OK) status = wcut_sheet_cut(&sheet, o->hole_min, r);
    wcut_sheet_clear(&sheet);
    return status;
}

static wcut_status reconstruct_job(job *j, wcut_reconstruction *r, wcut_error *error) {
    const wcut_reconstruction_options *o = j->options;
    r->point_spacing = point_spacing(&j->tree);
    if (!(r->point_spacing > 0))
        return wcut_fail(error, WCUT_DEGENERATE, "scan: most points are in one place with eight others");
    r->spacing = o->spacing > 0 ? o->spacing : fmin(2 * r->point_spacing, o->support);
    r->smoothing = o->smoothing > 0 ? o->smoothing : 2 * r->point_spacing;
    wcut_status status = wcut_lattice_build(j->surface, r->spacing, j->threads, &j->lattice);
    if (status == WCUT_OK && o->mesh) status = wcut_base_lay(j->surface, o->mesh, j->threads, &j->lattice, &j->base);
    if (status == WCUT_OK) status = solve_field(j, r);
    if (status == WCUT_OK) status = cut(j, r);
    wcut_field_clear(&j->field);
    wcut_base_clear(&j->base);
    wcut_lattice_clear(&j->lattice);
    if (status == WCUT_OK) return status;
    return wcut_fail(error, status,
                     "reconstruction: %s; %d points over the face, %g mm apart, support %g mm, grid %g mm",
                     wcut_status_text(status), r->used, r->point_spacing, o->support, r->spacing);
}

wcut_status wcut_reconstruction_create(const wcut_surface *surface, int count, const wcut_vec3 *point,
                                       const wcut_foot *foot, const wcut_reconstruction_options *options, int threads,
                                       wcut_reconstruction **reconstruction, wcut_error *error) {
    const wcut_reconstruction_options o = options ? *options : wcut_reconstruction_options_default();

    /* check arguments, options and the scan */
    if (!surface || !point || !foot || threads < 1 || !reconstruction)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "reconstruction: an argument is missing");
    if (count < MIN)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "scan: found %d points, expected at least %d", count, MIN);
    wcut_status status = reconstruct_check_options(&o, error);
    if (status == WCUT_OK) status = check_scan(surface, count, point, foot, error);
    if (status != WCUT_OK) return status;

    /* points on a line span no face */
    if (!wcut_spans_plane(count, point, sizeof *point, NULL))
        return wcut_fail(error, WCUT_DEGENERATE, "scan: its points are in one place or on one line");

    /* a tree for spacing and support */
    job j = {.surface = surface, .count = count, .threads = threads, .point = point, .foot = foot, .options = &o};
    wcut_reconstruction *r = wcut_alloc(1, sizeof *r);
    status = r ? wcut_kd_tree_build(count, point, threads, &j.tree) : WCUT_NO_MEMORY;
    if (status != WCUT_OK) {
        wcut_free(r);
        return wcut_fail(error, status, "reconstruction: %s", wcut_status_text(status));
    }

    /* reconstruct, and hand over or release */
    status = reconstruct_job(&j, r, error);
    wcut_kd_tree_clear(&j.tree);
    if (status != WCUT_OK)
        wcut_reconstruction_destroy(r);
    else
        *reconstruction = r;

    return status;
}
