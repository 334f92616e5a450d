/* A block divided along the wire's surface: options checked, faces fitted, halves made, everything proven or refused. */
#include <limits.h>
#include <stdbool.h>
#include <string.h>
#include <wirecut/mould.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "solid/boolean.h"
#include "solid/check.h"
#include "solid/frame.h"
#include "solid/halves.h"
#include "solid/kerf.h"
#include "solid/keys.h"
#include "solid/solid_brep.h"
#include "solid/wall.h"
#include "surface/mesh_volume.h"

/* lower + upper + kerf - keys = block to this share, or it is a defect */
static const double VOLUME_HELD = 1e-6;

/* Booleans cut beside the sides, by this share of the block: coinciding planes would leave slivers. */
static const double MARGIN_SHARE = 2e-3;

/* A stock may reach beyond the block by this share of it. */
static const double STOCK_SHARE = 1e-6;

wcut_mould_options wcut_mould_default(void) {
    return (wcut_mould_options){.chord_tolerance = 0.1,
                                .fit_tolerance = 0.005,
                                .prolong = 100,
                                .lug_clearance = 0.1,
                                .frame_clearance = 0.2,
                                .scale = 1,
                                .draft_asked = -WCUT_PI / 2,
                                .pull = {.x = 0, .y = 0, .z = 1}};
}

static void half_clear(wcut_half *half) {
    wcut_mesh_destroy(half->mesh);
    wcut_brep_destroy(half->brep);
    wcut_free(half->draft);
    wcut_free(half->cut);
}

void wcut_mould_destroy(wcut_mould *mould) {
    if (!mould) return;
    half_clear(&mould->lower);
    half_clear(&mould->upper);
    wcut_mesh_destroy(mould->kerf);
    wcut_mesh_destroy(mould->frame);
    wcut_brep_destroy(mould->frame_brep);
    wcut_free(mould);
}

/* ---- what is asked for ---- */

static wcut_status check_key(const wcut_key *key, wcut_vec3 block, wcut_error *error) {
    const bool ok = isfinite(key->x) && isfinite(key->y) && is_positive(key->radius) && is_positive(key->tip_radius) &&
                    key->tip_radius < key->radius && isfinite(key->height) && key->height != 0 &&
                    fabs(key->height) < block.z;
    if (ok) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT,
                     "key: radius %.4g, tip %.4g, height %.4g mm, expected 0 < tip < radius and a height other than 0, "
                     "less than the block's",
                     key->radius, key->tip_radius, key->height);
}

static wcut_status check_stock(const wcut_mesh *stock, wcut_vec3 block, wcut_error *error) {
    /* counts, arrays and coordinates */
    const double over = STOCK_SHARE * fmax(block.x, fmax(block.y, block.z));
    if (stock->vertex_count < 4 || stock->triangle_count < 4 || stock->triangle_count > INT_MAX / 3 || !stock->vertex ||
        !stock->triangle || !vec3_all_finite(stock->vertex_count, stock->vertex))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "stock: expected a closed mesh with finite coordinates");

    /* every corner names a vertex */
    for (int k = 0; k < 3 * stock->triangle_count; k++)
        if (stock->triangle[k] < 0 || stock->triangle[k] >= stock->vertex_count)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "stock: triangle %d names no vertex", k / 3);

    /* closed, and wound outwards */
    wcut_half_report r = {.closed = 0};
    wcut_status status = wcut_check_boundary(stock, &r);
    if (status != WCUT_OK) return status;
    if (!r.closed || !r.oriented) {
        bool found;
        wcut_vec3 at = {0, 0, 0};
        status = wcut_check_open_edge(stock, &found, &at);
        if (status != WCUT_OK) return status;
        if (!found) return wcut_fail(error, WCUT_BAD_ARGUMENT, "stock: the mesh is not oriented outwards");
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "stock: the mesh is not %s near (%.6g, %.6g, %.6g) mm",
                         r.closed
                             ? "oriented alike on both sides of an edge"
                             : "closed: an edge lies in one triangle or in more than two (a hole, or bodies that share "
                               "a face or an edge, which are one body)",
                         at.x, at.y, at.z);
    }

    /* inside the block, but for a share of its size */
    if (r.box_low.x < -over || r.box_low.y < -over || r.box_low.z < -over || r.box_high.x > block.x + over ||
        r.box_high.y > block.y + over || r.box_high.z > block.z + over)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "stock: from (%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g) mm, expected it inside the block",
                         r.box_low.x, r.box_low.y, r.box_low.z, r.box_high.x, r.box_high.y, r.box_high.z);

    /* free of self-intersections */
    int pairs;
    wcut_vec3 at;
    status = wcut_self_intersections(stock, &pairs, &at, error);
    if (status == WCUT_DEGENERATE) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK && pairs > 0) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_BAD_ARGUMENT) wcut_fail(error, status, "stock: the mesh meets itself");

    return status;
}

/* what holds the halves over each other */
static wcut_status check_holders(const wcut_mould_options *o, wcut_error *error) {
    if (!(o->lug_radius >= 0) || !isfinite(o->lug_radius) || !(o->lug_clearance >= 0) || !isfinite(o->lug_clearance) ||
        (o->lug_radius > 0 && !is_positive(o->lug_height)))
        return wcut_fail(
            error, WCUT_BAD_ARGUMENT,
            "lugs: found a radius of %g, a height of %g and a clearance of %g mm, expected a positive height "
            "and none of the others negative",
            o->lug_radius, o->lug_height, o->lug_clearance);
    if (!(o->frame_wall >= 0) || !isfinite(o->frame_wall) || !(o->frame_clearance >= 0) ||
        !isfinite(o->frame_clearance))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "frame: found a wall of %g and a clearance of %g mm, expected neither negative", o->frame_wall,
                         o->frame_clearance);
    if (o->lug_radius > 0 && o->frame_wall > 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "lugs and a frame: expected one of them, the frame stands where lugs do");
    if ((o->lug_radius > 0 || o->frame_wall > 0) && o->stock)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "%s with a stock: expected one of them, its sides are not the block's",
                         o->lug_radius > 0 ? "lugs" : "a frame");
    return WCUT_OK;
}

static wcut_status mould_check_options(const wcut_mould_options *o, wcut_vec3 block, wcut_error *error) {
    /* numbers and ranges, in the order of the options */
    if (!is_positive(o->chord_tolerance) || !is_positive(o->fit_tolerance))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "tolerances: found %g and %g mm, expected them positive",
                         o->chord_tolerance, o->fit_tolerance);
    if (!(o->prolong >= 0) || !isfinite(o->kerf) || o->kerf < 0 || !(o->wire_diameter >= 0))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "prolong %g, kerf %g, wire %g mm: expected none of them negative",
                         o->prolong, o->kerf, o->wire_diameter);
    if (o->kerf_stations != 0 && (o->kerf_stations < 2 || o->kerf_nodes < 2 || !o->kerf_parameter || !o->kerf_field))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "kerf: expected a field of at least 2 x 2 values");
    if (!(o->thickness >= 0) || !isfinite(o->thickness))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "thickness: found %g mm, expected it not negative", o->thickness);
    if (!(o->wall_asked >= 0) || !(fabs(o->draft_asked) <= WCUT_PI / 2))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "wall %g mm, draft %g rad: expected a length and an angle up to pi/2", o->wall_asked,
                         o->draft_asked);
    if (!is_positive(o->scale) || !vec3_is_finite(o->pull) || !(vec3_length(o->pull) > 0))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "scale %g: expected it positive, and a direction to pull in",
                         o->scale);
    if (o->key_count < 0 || o->key_count > 1000 || (o->key_count > 0 && !o->key) || (o->key_count > 0 && o->stock))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "keys: found %d, expected at most 1000, and none with a stock",
                         o->key_count);

    /* lugs and frame; keys and stock against the block */
    const wcut_status held = check_holders(o, error);
    if (held != WCUT_OK) return held;
    for (int k = 0; k < o->key_count; k++) {
        const wcut_status status = check_key(&o->key[k], block, error);
        if (status != WCUT_OK) return status;
    }

    return o->stock ? check_stock(o->stock, block, error) : WCUT_OK;
}

/* faces of the cut: one and the same where there is no kerf */
typedef struct faces {
    wcut_cut_face made[2];
    const wcut_cut_face *lower, *upper;
    int lugs;
    wcut_lug lug[2][WCUT_LUGS]; /* lugs of them of each half */
} faces;

/* ---- what came out ---- */

static wcut_status report_half(const wcut_division *d, const wcut_part *part, const faces *f, int upper,
                               wcut_half *half, wcut_error *error) {
    /* edges, volume and area of the mesh */
    const char *name = upper ? "upper" : "lower";
    const wcut_vec3 pull = vec3_unit(d->options->pull);
    wcut_half_report *r = &half->report;
    const wcut_status status = wcut_check_boundary(part->mesh, r);
    if (status != WCUT_OK) return status;

    /* drafts of the cut; the upper half is pulled the other way */
    half->draft = wcut_alloc((size_t)part->mesh->vertex_count, sizeof *half->draft);
    if (!half->draft) return WCUT_NO_MEMORY;
    wcut_check_draft(part->mesh, part->tag, upper ? vec3_scale(-1, pull) : pull, r, half->draft);

    /* self-intersections refuse the half, open edges are a fault of ours */
    r->self_intersections = part->self_intersections;
    r->key_volume = wcut_keys_volume(d->options, upper);
    for (int k = 0; k < f->lugs; k++)
        r->key_volume += wcut_lug_volume(&f->lug[upper][k], upper, d->options->chord_tolerance);
    if (r->self_intersections > 0)
        return wcut_fail(error, WCUT_DEGENERATE,
                         "%s: %d pairs of triangles of the %s half meet near (%.6g, %.6g, %.6g) mm",
                         d->options->stock ? "the cut folds over itself, or runs along a face of the stock"
                                           : "the cut folds over itself",
                         r->self_intersections, name, part->place.x, part->place.y, part->place.z);
    if (!r->closed || !r->oriented)
        return wcut_fail(error, WCUT_INTERNAL, "the %s half is %s", name,
                         r->closed ? "turned inside out" : "not closed");

    return WCUT_OK;
}

/* the volumes of the parts against that of the block; WCUT_INTERNAL where they do not add up */
static wcut_status mould_balance(wcut_mould *m, wcut_error *error) {
    const double keys = m->lower.report.key_volume + m->upper.report.key_volume;
    m->kerf_volume = m->kerf ? wcut_mesh_volume(m->kerf) : 0;
    m->volume_error = fabs(m->lower.report.volume + m->upper.report.volume + m->kerf_volume - keys - m->block_volume) /
                      m->block_volume;
    if (m->volume_error <= VOLUME_HELD && m->kerf_volume >= 0) return WCUT_OK;
    return wcut_fail(error, WCUT_INTERNAL,
                     "the volumes do not add up: lower %.9g, upper %.9g, kerf %.9g, keys %.9g, block %.9g mm3",
                     m->lower.report.volume, m->upper.report.volume, m->kerf_volume, keys, m->block_volume);
}

/* what was asked for beside the geometry, of the solids as they will be */
static void judge_half(const wcut_mould_options *o, wcut_half_report *r) {
    r->wall_held = o->wall_asked == 0 || r->wall_min >= o->wall_asked;
    r->draft_held = r->draft_min >= o->draft_asked;
}

static void scale_mesh(wcut_mesh *mesh, double f) {
    for (int k = 0; mesh && k < mesh->vertex_count; k++) mesh->vertex[k] = vec3_scale(f, mesh->vertex[k]);
}

static void scale_half(wcut_half *half, double f) {
    wcut_half_report *r = &half->report;
    scale_mesh(half->mesh, f);
    if (half->brep) wcut_brep_scale(half->brep, f);
    r->volume *= f * f * f, r->key_volume *= f * f * f;
    r->area *= f * f, r->cut_area *= f * f, r->undercut_area *= f * f;
    r->wall_min *= f;
    r->box_low = vec3_scale(f, r->box_low), r->box_high = vec3_scale(f, r->box_high);
    r->draft_place = vec3_scale(f, r->draft_place);
    r->wall_place = vec3_scale(f, r->wall_place), r->edge_place = vec3_scale(f, r->edge_place);
}

/* the halves grow with the cast's shrinkage; tolerances and what is said of the cut itself stay those of the cut */
static void scale_mould(wcut_mould *m, double f) {
    scale_half(&m->lower, f);
    scale_half(&m->upper, f);
    scale_mesh(m->kerf, f);
    scale_mesh(m->frame, f);
    if (m->frame_brep) wcut_brep_scale(m->frame_brep, f);
    m->kerf_volume *= f * f * f, m->block_volume *= f * f * f, m->frame_volume *= f * f * f;
    m->scale = f;
}

/* ---- the division ---- */

static void faces_clear(faces *f) {
    wcut_cut_face_clear(&f->made[0]);
    wcut_cut_face_clear(&f->made[1]);
}

static wcut_status fit_faces(const wcut_division *d, double margin, faces *f, wcut_error *error) {
    memset(f, 0, sizeof *f);
    wcut_status status = wcut_cut_face_solve(d, d->width ? -0.5 : 0, margin, &f->made[0], error);
    if (status == WCUT_OK && d->width) status = wcut_cut_face_solve(d, 0.5, margin, &f->made[1], error);
    f->lower = &f->made[0];
    f->upper = d->width ? &f->made[1] : &f->made[0];
    return status;
}

static void describe_cut(const faces *f, wcut_mould *m) {
    const wcut_face_fit *a = &f->lower->fit, *b = &f->upper->fit;
    m->fit_error = fmax(a->fit_error, b->fit_error);
    m->chord_error = fmax(f->lower->chord_error, f->upper->chord_error);
    m->prolonged_entry = fmax(a->entry, b->entry);
    m->prolonged_exit = fmax(a->exit, b->exit);
    m->prolonged_side = fmax(a->wire, b->wire);
    m->radius_min = fmin(a->radius, b->radius);
    m->radius_place = a->radius <= b->radius ? a->radius_place : b->radius_place;
    m->kerf_min = fmin(a->width_min, b->width_min);
    m->kerf_max = fmax(a->width_max, b->width_max);
}

/* exact faces, walls and edges */
static wcut_status describe_halves(const wcut_division *d, const faces *f, wcut_mould *m, wcut_error *error) {
    /* keys against the cut face */
    for (int upper = 0; upper < 2; upper++) {
        const wcut_cut_face *face = upper ? f->upper : f->lower;
        wcut_half *half = upper ? &m->upper : &m->lower;
        wcut_status status = wcut_keys_check(d, upper, face, error);
        if (status != WCUT_OK) return status;

        /* walls and exact faces exist for halves made by index only */
        half->report.wall_min = half->report.edge_min = NAN;
        half->report.wall_place = half->report.edge_place = vec3(NAN, NAN, NAN);
        if (m->by_boolean) continue;
        wcut_wall_measure(d, upper, face, &half->report);

        /* exact faces, with the half's own keys */
        wcut_key *own;
        int count;
        status = wcut_keys_of(d->options, upper, &own, &count);
        if (status != WCUT_OK) return status;
        status = wcut_brep_of_half(face->fit.patch, upper, upper ? d->block.z : 0, count, own, f->lugs, f->lug[upper],
                                   &half->brep);
        wcut_free(own);
        if (status != WCUT_OK) return status;
    }

    return WCUT_OK;
}

/* parts from the faces, by index or by booleans */
static wcut_status make_parts(const wcut_division *d, faces *f, wcut_mould *m, wcut_parts *parts, wcut_error *error) {
    int leaves = 0;
    wcut_status status = d->options->stock ? WCUT_OK : wcut_cut_face_place(d, f->lower, f->upper, &leaves, error);
    if (status != WCUT_OK) return status;
    m->by_boolean = leaves || d->options->stock;
    if (!m->by_boolean) {
        m->block_volume = d->block.x * d->block.y * d->block.z;
        if (d->options->lug_radius > 0) {
            status = wcut_lugs_place(d, &f->lower->cap, &f->upper->cap, f->lug, error);
            if (status != WCUT_OK) return status;
            f->lugs = m->lugs = WCUT_LUGS;
        }
        return wcut_halves_by_index(d, f->lower, f->upper, f->lugs ? f->lug : NULL, parts, error);
    }
    if (d->options->lug_radius > 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "lugs: the cut leaves through top or bottom, expected one that stays between them");
    const double margin = MARGIN_SHARE * fmax(d->block.x, d->block.y);
    faces wide;
    status = fit_faces(d, margin, &wide, error);
    if (status == WCUT_OK)
        status = wcut_halves_by_boolean(d, wide.lower, wide.upper, margin, parts, &m->block_volume, error);
    faces_clear(&wide);
    return status;
}

/* the frame, seen by the same check as the halves */
static wcut_status frame_halves(const wcut_division *d, wcut_mould *m, wcut_error *error) {
    const wcut_mould_options *o = d->options;
    if (!(o->frame_wall > 0)) return WCUT_OK;
    wcut_status status = wcut_frame_create(d->block, o->frame_wall, o->frame_clearance, &m->frame, &m->frame_brep);
    wcut_half_report r = {.closed = 0};
    if (status == WCUT_OK) status = wcut_check_boundary(m->frame, &r);
    if (status != WCUT_OK) return status;
    m->frame_volume = r.volume;
    return r.closed && r.oriented ? WCUT_OK : wcut_fail(error, WCUT_INTERNAL, "the frame is not closed");
}

static wcut_status mould_divide(const wcut_division *d, wcut_mould *m, wcut_error *error) {
    faces f;
    wcut_parts parts = {.lower = {.mesh = NULL}};

    /* the cut faces, then the solids between them and the block's */
    wcut_status status = fit_faces(d, 0, &f, error);
    if (status == WCUT_OK) status = make_parts(d, &f, m, &parts, error);
    if (status == WCUT_OK) {
        describe_cut(&f, m);
        status = describe_halves(d, &f, m, error);
    }

    /* check both halves; the mould takes over their meshes */
    if (status == WCUT_OK) status = report_half(d, &parts.lower, &f, 0, &m->lower, error);
    if (status == WCUT_OK) status = report_half(d, &parts.upper, &f, 1, &m->upper, error);
    if (status == WCUT_OK) {
        m->lower.mesh = parts.lower.mesh, m->upper.mesh = parts.upper.mesh, m->kerf = parts.kerf.mesh;
        m->lower.cut = parts.lower.tag, m->upper.cut = parts.upper.tag;
        parts.lower.mesh = parts.upper.mesh = parts.kerf.mesh = NULL;
        parts.lower.tag = parts.upper.tag = NULL;
        status = mould_balance(m, error);
    }
    if (status == WCUT_OK) status = frame_halves(d, m, error);
    if (status == WCUT_OK) {
        /* scale for shrinkage, then judge walls and drafts at the final size */
        const wcut_mould_options *o = d->options;
        scale_mould(m, o->scale);
        judge_half(o, &m->lower.report);
        judge_half(o, &m->upper.report);
        m->wire_radius = o->wire_diameter / 2;
        m->thickness = o->thickness;
        m->wall_asked = o->wall_asked, m->draft_asked = o->draft_asked, m->pull = vec3_unit(o->pull);
    }
    wcut_parts_clear(&parts);
    faces_clear(&f);

    return status;
}

wcut_status wcut_mould_create(const wcut_surface *surface, wcut_vec3 block_size, const wcut_mould_options *options,
                              wcut_mould **mould, wcut_error *error) {
    /* check arguments and options */
    const wcut_mould_options standard = wcut_mould_default(), *o = options ? options : &standard;
    if (!surface || !mould) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a surface and a place for the mould expected");
    if (!is_positive(block_size.x) || !is_positive(block_size.y) || !is_positive(block_size.z))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "block: found %g x %g x %g mm, expected it positive", block_size.x,
                         block_size.y, block_size.z);

    /* the kerf as a spline over the surface's knots, then the division */
    wcut_surface *width = NULL;
    wcut_mould *m = NULL;
    wcut_status status = mould_check_options(o, block_size, error);
    if (status == WCUT_OK) status = wcut_kerf_width(surface, o, &width, error);
    if (status == WCUT_OK) {
        const wcut_division d = {.surface = surface, .width = width, .block = block_size, .options = o};
        m = wcut_alloc(1, sizeof *m);
        status = m ? mould_divide(&d, m, error) : WCUT_NO_MEMORY;
    }

    /* hand over, or say where memory ended */
    wcut_surface_destroy(width);
    if (status == WCUT_OK) {
        *mould = m;
        return WCUT_OK;
    }
    wcut_mould_destroy(m);
    if (status == WCUT_NO_MEMORY) wcut_fail(error, status, "dividing the block: %s", wcut_status_text(status));

    return status;
}
