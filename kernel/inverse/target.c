/* What a cut is to come near to: points over the block's plan, and a smooth height through them. */
#include "inverse/target.h"

#include <stdio.h>
#include <string.h>
#include <wirecut/mesh_tree.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"

#define BESIDE 0.25      /* [1] of the block's width: what lies further beside it says nothing of it */
#define STEEP 0.1        /* [1] least upward part of a target's normal: 84 deg */
#define ABOVE 0.1        /* [mm] two faces of a target this far apart at a place lie above each other */
#define COVERED_MIN 0.25 /* [1] of the block's plan */

enum { ACROSS = 33, ROWS_MAX = 129, SAMPLES = 61, POINTS_MIN = 50, CLOUD_MAX = 6000, FACES_MAX = 100 };

/* ---- points that stand for a target, and its heights ---- */

static bool over_block(wcut_vec3 block, wcut_vec3 p, double beside) {
    return p.x >= -beside && p.x <= block.x + beside && p.y >= -beside && p.y <= block.y + beside;
}

/* the box of points */
static void find_target_corners(int count, const wcut_vec3 *point, wcut_vec3 corner[2]) {
    corner[0] = corner[1] = point[0];
    for (int k = 1; k < count; k++) {
        const wcut_vec3 p = point[k], low = corner[0], high = corner[1];
        corner[0] = vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        corner[1] = vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
}

/* the box of points, for words of a wrong unit */
static wcut_status say_outside(wcut_vec3 block, int count, const wcut_vec3 *point, const char *what,
                               wcut_error *error) {
    wcut_vec3 corner[2];
    find_target_corners(count, point, corner);
    const wcut_vec3 low = corner[0], high = corner[1];
    return wcut_fail(
        error, WCUT_DEGENERATE,
        "the target fills x %.6g .. %.6g, y %.6g .. %.6g, z %.6g .. %.6g mm, the block 0 .. %g, 0 .. %g, 0 "
        ".. %g mm: %s%s",
        low.x, high.x, low.y, high.y, low.z, high.z, block.x, block.y, block.z, what,
        wcut_unit_hint(fmax(high.x - low.x, high.y - low.y), fmax(block.x, block.y)));
}

/* a target whose size says that its numbers are of another unit than the block's */
static wcut_status check_target_size(wcut_vec3 block, int count, const wcut_vec3 *point, wcut_error *error) {
    wcut_vec3 low = point[0], high = low;
    for (int k = 1; k < count; k++) {
        low = vec3(fmin(low.x, point[k].x), fmin(low.y, point[k].y), 0);
        high = vec3(fmax(high.x, point[k].x), fmax(high.y, point[k].y), 0);
    }
    const double size = fmax(high.x - low.x, high.y - low.y), side = fmax(block.x, block.y);
    return *wcut_unit_hint(size, side) ? say_outside(block, count, point, "their sizes differ", error) : WCUT_OK;
}

/* keep what is over the block or just beside it; gives how many */
static int keep_over(wcut_vec3 block, double beside, int count, wcut_vec3 *point) {
    int kept = 0;
    for (int k = 0; k < count; k++)
        if (over_block(block, point[k], beside)) point[kept++] = point[k];
    return kept;
}

/* the heights through points, over the block and as far beside it as the points go */
static wcut_status fit_heights(wcut_design_target *t, int count, const wcut_vec3 *point, wcut_error *error) {
    wcut_vec3 low = {0, 0, 0}, high = {t->block.x, t->block.y, 0};
    for (int k = 0; k < count; k++) {
        low = vec3(fmin(low.x, point[k].x), fmin(low.y, point[k].y), 0);
        high = vec3(fmax(high.x, point[k].x), fmax(high.y, point[k].y), 0);
    }
    const wcut_status status = wcut_heights_fit(count, point, low, high, t->robust, &t->heights);
    if (status == WCUT_DEGENERATE) return wcut_fail(error, status, "the target's points determine no sheet");
    return status == WCUT_OK ? status : wcut_fail(error, status, "no memory for a target of %d points", count);
}

/* whether the block holds it, and enough of the block is under it */
static wcut_status check_whole_target(const wcut_design_target *t, wcut_error *error) {
    if (t->covered < COVERED_MIN)
        return say_outside(t->block, t->count ? t->count : 1, t->count ? t->point : &(wcut_vec3){0, 0, 0},
                           "it is over less than a quarter of the block's plan", error);
    int outside = 0;
    for (int k = 0; k < t->count; k++) outside += !(t->point[k].z >= 0 && t->point[k].z <= t->block.z);
    if (outside > (t->robust ? t->count / 10 : 0))
        return say_outside(t->block, t->count, t->point, "it is not inside the block's height", error);
    return WCUT_OK;
}

static wcut_status check_block(wcut_vec3 block, const void *from, wcut_design_target **target, wcut_error *error) {
    if (from && target && is_positive(block.x) && is_positive(block.y) && is_positive(block.z)) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "a target, a block of positive size and a place for it are expected");
}

/* a target without points; the lattice of places over the block that an exact one is measured at */
static wcut_design_target *create_target(wcut_vec3 block, int *rows) {
    wcut_design_target *t = wcut_alloc(1, sizeof *t);
    *rows = (int)clamp(ceil(ACROSS * block.y / block.x), 9, ROWS_MAX);
    if (!t) return NULL;
    t->block = block;
    t->point = wcut_alloc((size_t)ACROSS * (size_t)*rows, sizeof *t->point);
    if (t->point) return t;
    wcut_free(t);
    return NULL;
}

/* places over the block at the target's height: near it already */
static void lay_lattice(const wcut_design_target *t, int rows, wcut_vec3 *place) {
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < ACROSS; i++) {
            const double x = t->block.x * (i + 0.5) / ACROSS, y = t->block.y * (j + 0.5) / rows;
            place[j * ACROSS + i] = vec3(x, y, wcut_heights_eval(&t->heights, x, y).z);
        }
}

/* ---- faces of surfaces ---- */

/* a grid of points on a face, and which of them are inside its loops */
typedef struct face_grid {
    wcut_vec3 *point; /* SAMPLES x SAMPLES */
    bool *inside;
} face_grid;

static wcut_status sample_face(const wcut_trimmed *face, const face_grid *grid, wcut_error *error) {
    double first[2], last[2], u[SAMPLES], v[SAMPLES];
    wcut_surface_domain(face->surface, first, last);
    for (int k = 0; k < SAMPLES; k++) {
        u[k] = first[0] + (last[0] - first[0]) * k / (SAMPLES - 1);
        v[k] = first[1] + (last[1] - first[1]) * k / (SAMPLES - 1);
    }
    const wcut_status status = wcut_surface_eval_grid(face->surface, SAMPLES, u, SAMPLES, v, grid->point);
    if (status != WCUT_OK) return wcut_fail(error, status, "%s", wcut_status_text(status));

    /* what is beside the loops does not count */
    for (int j = 0; j < SAMPLES; j++)
        for (int i = 0; i < SAMPLES; i++) grid->inside[j * SAMPLES + i] = wcut_trimmed_inside(face, u[i], v[j]) != 0;
    return WCUT_OK;
}

/* One side up all over what is over the block; *beside: how far beside it the face is a sheet too [mm]. A face that a
   wire swept folds where the wire hung free. */
static wcut_status check_fold(wcut_vec3 block, const face_grid *grid, double *beside, wcut_error *error) {
    int up[2] = {0, 0}, down[2] = {0, 0}, steep = 0;
    for (int j = 0; j + 1 < SAMPLES; j++)
        for (int i = 0; i + 1 < SAMPLES; i++) {
            const int at = j * SAMPLES + i;
            const wcut_vec3 *p = grid->point + at;
            if (!grid->inside[at] || !grid->inside[at + SAMPLES + 1] || !over_block(block, p[0], BESIDE * block.x))
                continue;

            /* which way it faces, over the block and beside it */
            const wcut_vec3 n = vec3_unit(vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[SAMPLES], p[0])));
            const int inside = over_block(block, p[0], 0) && over_block(block, p[SAMPLES + 1], 0);
            up[inside] += n.z > STEEP, down[inside] += n.z < -STEEP;
            if (vec3_length(n) < 0.5 || fabs(n.z) > STEEP) continue;
            steep++;
            if (inside)
                return wcut_fail(
                    error, WCUT_DEGENERATE,
                    "the target stands steeper than 84 deg at (%.4g, %.4g, %.4g) mm; expected a sheet over the "
                    "block",
                    p->x, p->y, p->z);
        }
    if (up[1] > 0 && down[1] > 0)
        return wcut_fail(error, WCUT_DEGENERATE,
                         "the target folds over; expected one height over every place of the block");
    const bool sheet = steep == 0 && (up[0] + up[1] == 0 || down[0] + down[1] == 0);
    *beside = sheet ? BESIDE * block.x : 0;
    return WCUT_OK;
}

/* every face on its grid: all points for the size, then those over the block, *kept of them, in the place of all */
static wcut_status sample_faces(wcut_vec3 block, int faces, const wcut_trimmed *const *face, wcut_vec3 *point,
                                int *kept, wcut_error *error) {
    enum { N = SAMPLES * SAMPLES };
    face_grid grid = {wcut_alloc(N, sizeof *grid.point), wcut_alloc(N, sizeof *grid.inside)};
    wcut_status status =
        grid.point && grid.inside ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for a target");
    wcut_vec3 corner[2] = {{0, 0, 0}, {0, 0, 0}};
    int count = 0;
    for (int pass = 0; pass < 2 && status == WCUT_OK; pass++) {
        count = 0;
        for (int f = 0; f < faces && status == WCUT_OK; f++) {
            double beside = HUGE_VAL;
            status = sample_face(face[f], &grid, error);
            if (status == WCUT_OK && pass == 1) status = check_fold(block, &grid, &beside, error);
            for (int k = 0; k < N && status == WCUT_OK; k++)
                if (grid.inside[k] && (pass == 0 || over_block(block, grid.point[k], beside)))
                    point[count++] = grid.point[k];
        }

        /* the unit of all of it, then whether enough is over the block; words of the box of all */
        if (status == WCUT_OK && pass == 0 && count == 0)
            status = wcut_fail(error, WCUT_DEGENERATE, "the target has no point inside its borders");
        if (status == WCUT_OK && pass == 0) status = check_target_size(block, count, point, error);
        if (status == WCUT_OK && pass == 0) find_target_corners(count, point, corner);
        if (status == WCUT_OK && pass == 1 && count < POINTS_MIN)
            status = say_outside(block, 2, corner, "it is not over the block", error);
    }
    *kept = count;
    wcut_free(grid.point);
    wcut_free(grid.inside);
    return status;
}

/* points on one face: the feet of places near it; what is beyond its border is not it. A place that another face has
   too must have it at the same height. */
static wcut_status locate_face(const wcut_design_target *t, const wcut_trimmed *face, int places,
                               const wcut_vec3 *place, wcut_foot *foot, wcut_vec3 *found, bool *has,
                               wcut_error *error) {
    wcut_projection *projection = NULL;
    wcut_status status = wcut_projection_create(face->surface, &projection);
    if (status == WCUT_OK) status = wcut_projection_locate(projection, places, place, 1, foot);
    wcut_projection_destroy(projection);
    if (status != WCUT_OK) return wcut_fail(error, status, "the target: %s", wcut_status_text(status));
    for (int k = 0; k < places; k++) {
        const wcut_vec3 p = foot[k].point;
        if (foot[k].beyond || !over_block(t->block, p, 0) || !wcut_trimmed_inside(face, foot[k].u, foot[k].v)) continue;
        const double apart = fabs(found[k].z - p.z), aside = hypot(found[k].x - p.x, found[k].y - p.y);
        if (has[k] && apart > ABOVE && aside < apart / 4)
            return wcut_fail(error, WCUT_DEGENERATE,
                             "two faces of the target lie above each other at (%.4g, %.4g) mm, %.4g and %.4g mm high; "
                             "expected one height over every place of the block",
                             p.x, p.y, fmin(p.z, found[k].z), fmax(p.z, found[k].z));
        if (!has[k] || vec3_distance(p, place[k]) < vec3_distance(found[k], place[k])) found[k] = p;
        has[k] = true;
    }
    return WCUT_OK;
}

/* the points of all faces at the lattice over the block */
static wcut_status locate_faces(wcut_design_target *t, int rows, int faces, const wcut_trimmed *const *face,
                                wcut_error *error) {
    const size_t places = (size_t)ACROSS * (size_t)rows;
    wcut_vec3 *place = wcut_alloc(places, sizeof *place), *found = wcut_alloc(places, sizeof *found);
    wcut_foot *foot = wcut_alloc(places, sizeof *foot);
    bool *has = wcut_alloc(places, sizeof *has);
    wcut_status status = WCUT_OK;
    if (!place || !found || !foot || !has) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a target");
    if (status == WCUT_OK) lay_lattice(t, rows, place);
    for (int f = 0; f < faces && status == WCUT_OK; f++)
        status = locate_face(t, face[f], (int)places, place, foot, found, has, error);
    for (size_t k = 0; k < places && status == WCUT_OK; k++)
        if (has[k]) t->point[t->count++] = found[k];
    if (status == WCUT_OK) t->covered = (double)t->count / (double)places;
    wcut_free(place);
    wcut_free(found);
    wcut_free(foot);
    wcut_free(has);
    return status;
}

wcut_status wcut_design_target_from_faces(int faces, const wcut_trimmed *const *face, wcut_vec3 block,
                                          wcut_design_target **target, wcut_error *error) {
    int rows = 0, kept = 0;
    wcut_status status = check_block(block, face, target, error);
    if (status != WCUT_OK) return status;
    if (faces < 1 || faces > FACES_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "the target: found %d faces, expected 1 to %d", faces, FACES_MAX);
    for (int f = 0; f < faces; f++)
        if (!face[f] || !face[f]->surface) return wcut_fail(error, WCUT_BAD_ARGUMENT, "the target: a face is missing");

    /* heights from above through all faces, then points on them */
    wcut_vec3 *sample = wcut_alloc((size_t)faces * SAMPLES * SAMPLES, sizeof *sample);
    wcut_design_target *t = create_target(block, &rows);
    if (!t || !sample) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a target");
    if (status == WCUT_OK) status = sample_faces(block, faces, face, sample, &kept, error);
    if (status == WCUT_OK) status = fit_heights(t, kept, sample, error);
    if (status == WCUT_OK) status = locate_faces(t, rows, faces, face, error);
    if (status == WCUT_OK) status = check_whole_target(t, error);
    wcut_free(sample);
    if (status == WCUT_OK)
        *target = t;
    else
        wcut_design_target_destroy(t);
    return status;
}

wcut_status wcut_design_target_from_surface(const wcut_surface *surface, wcut_vec3 block, wcut_design_target **target,
                                            wcut_error *error) {
    wcut_trimmed whole = {0};
    const wcut_trimmed *const face = &whole;
    memcpy(&whole.surface, &surface, sizeof surface); /* it is only read */
    if (!surface) return wcut_fail(error, WCUT_BAD_ARGUMENT, "a target, a block and a place for it are expected");
    return wcut_design_target_from_faces(1, &face, block, target, error);
}

/* ---- a mesh ---- */

/* Points all over the triangles, no further apart than a few hundredths of the block, in the order of the triangles;
   gives how many there are, and writes them where there is room. */
static int sample_mesh(const wcut_mesh *mesh, wcut_vec3 block, double spacing, wcut_vec3 *point) {
    int count = 0;
    for (int k = 0; k < mesh->triangle_count; k++) {
        const int *c = mesh->triangle + 3 * (size_t)k;
        const wcut_vec3 a = mesh->vertex[c[0]], b = mesh->vertex[c[1]], d = mesh->vertex[c[2]];
        const wcut_vec3 middle = vec3_scale(1.0 / 3, vec3_add(a, vec3_add(b, d)));
        const double size = fmax(vec3_distance(a, b), fmax(vec3_distance(b, d), vec3_distance(d, a)));
        if (!over_block(block, middle, BESIDE * block.x + size)) continue;
        const int parts = (int)clamp(ceil(size / spacing), 1, 200);
        for (int i = 0; i < parts; i++)
            for (int j = 0; i + j < parts; j++) {
                const double u = (i + 1.0 / 3) / parts, v = (j + 1.0 / 3) / parts;
                const wcut_vec3 p = vec3_add_scaled(vec3_add_scaled(a, u, vec3_sub(b, a)), v, vec3_sub(d, a));
                if (!over_block(block, p, BESIDE * block.x)) continue;
                if (point) point[count] = p;
                count++;
            }
    }
    return count;
}

/* one side up all over: an open sheet from above */
static wcut_status check_sheet(const wcut_mesh *mesh, const wcut_mesh_tree_info *info, wcut_error *error) {
    if (info->border_edges == 0)
        return wcut_fail(error, WCUT_DEGENERATE, "the target is closed; expected an open sheet over the block");
    if (info->nonmanifold_edges > 0)
        return wcut_fail(
            error, WCUT_DEGENERATE,
            "the target has %d edges with three triangles or more, or two wound against each other; expected "
            "an open sheet over the block",
            info->nonmanifold_edges);
    const double side = info->area_sum.z < 0 ? -1 : 1;
    for (int k = 0; k < mesh->triangle_count; k++) {
        const int *c = mesh->triangle + 3 * (size_t)k;
        const wcut_vec3 a = mesh->vertex[c[0]];
        const wcut_vec3 n = vec3_unit(vec3_cross(vec3_sub(mesh->vertex[c[1]], a), vec3_sub(mesh->vertex[c[2]], a)));
        if (vec3_length(n) > 0.5 && side * n.z <= STEEP)
            return wcut_fail(
                error, WCUT_DEGENERATE,
                "the target folds over or stands steeper than 84 deg at (%.4g, %.4g, %.4g) mm; expected one "
                "height over every place of the block",
                a.x, a.y, a.z);
    }
    return WCUT_OK;
}

wcut_status wcut_design_target_from_mesh(const wcut_mesh *mesh, wcut_vec3 block, wcut_design_target **target,
                                         wcut_error *error) {
    int rows = 0;
    wcut_status status = check_block(block, mesh, target, error);
    if (status != WCUT_OK) return status;
    wcut_mesh_tree *tree = NULL;
    status = wcut_mesh_tree_create(mesh, &tree);
    if (status != WCUT_OK) return wcut_fail(error, status, "the target: %s", wcut_status_text(status));
    status = check_target_size(block, mesh->vertex_count, mesh->vertex, error);
    if (status == WCUT_OK) status = check_sheet(mesh, wcut_mesh_tree_view(tree), error);
    wcut_vec3 *sample = NULL, *place = NULL;
    wcut_mesh_foot *foot = NULL;
    wcut_design_target *t = NULL;

    /* from above, by a point every hundredth of the block or a vertex's worth */
    if (status == WCUT_OK) {
        const double spacing = fmax(block.x, block.y) / 100;
        const int count = sample_mesh(mesh, block, spacing, NULL);
        if (count < POINTS_MIN) {
            status = say_outside(block, mesh->vertex_count, mesh->vertex, "it is not over the block", error);
        } else {
            sample = wcut_alloc((size_t)count, sizeof *sample);
            t = create_target(block, &rows);
            if (!sample || !t) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a target");
            if (status == WCUT_OK) status = fit_heights(t, sample_mesh(mesh, block, spacing, sample), sample, error);
        }
    }

    /* points on it */
    if (status == WCUT_OK && t) {
        const size_t places = (size_t)ACROSS * (size_t)rows;
        place = wcut_alloc(places, sizeof *place);
        foot = wcut_alloc(places, sizeof *foot);
        status = place && foot ? WCUT_OK : WCUT_NO_MEMORY;
        if (status == WCUT_OK) {
            lay_lattice(t, rows, place);
            status = wcut_mesh_tree_locate(tree, (int)places, place, 1, foot);
        }
        if (status != WCUT_OK) wcut_fail(error, status, "the target: %s", wcut_status_text(status));
        for (size_t k = 0; status == WCUT_OK && k < places; k++)
            if (!foot[k].beyond && over_block(block, foot[k].point, 0)) t->point[t->count++] = foot[k].point;
        if (status == WCUT_OK) t->covered = (double)t->count / (double)places;
    }
    if (status == WCUT_OK && t) status = check_whole_target(t, error);
    wcut_mesh_tree_destroy(tree);
    wcut_free(foot);
    wcut_free(place);
    wcut_free(sample);
    if (status == WCUT_OK)
        *target = t;
    else
        wcut_design_target_destroy(t);
    return status;
}

/* ---- a cloud ---- */

/* share of a lattice of 16 x 16 places of the block that have a point */
static double coverage(wcut_vec3 block, int count, const wcut_vec3 *point) {
    enum { SIDE = 16 };
    bool has[SIDE * SIDE] = {false};
    int full = 0;
    for (int k = 0; k < count; k++) {
        const int i = (int)clamp(floor(SIDE * point[k].x / block.x), 0, SIDE - 1);
        const int j = (int)clamp(floor(SIDE * point[k].y / block.y), 0, SIDE - 1);
        has[j * SIDE + i] = true;
    }
    for (int k = 0; k < SIDE * SIDE; k++) full += has[k];
    return (double)full / (SIDE * SIDE);
}

wcut_status wcut_design_target_from_points(int count, const wcut_vec3 *point, wcut_vec3 block,
                                           wcut_design_target **target, wcut_error *error) {
    wcut_status status = check_block(block, point, target, error);
    if (status != WCUT_OK) return status;
    if (count < 1 || !vec3_all_finite(count, point))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "the target: expected points with finite coordinates");

    status = check_target_size(block, count, point, error);
    if (status != WCUT_OK) return status;

    /* an even choice of them */
    const int step = count > CLOUD_MAX ? count / CLOUD_MAX : 1;
    wcut_design_target *t = wcut_alloc(1, sizeof *t);
    if (t) t->point = wcut_alloc((size_t)count / (size_t)step + 1, sizeof *t->point);
    if (!t || !t->point) {
        wcut_free(t);
        return wcut_fail(error, WCUT_NO_MEMORY, "no memory for a target of %d points", count);
    }
    t->block = block;
    t->robust = true;
    for (int k = 0; k < count; k += step) t->point[t->count++] = point[k];
    const int kept = keep_over(block, BESIDE * block.x, t->count, t->point);
    if (kept < POINTS_MIN) {
        status = say_outside(block, count, point, "fewer than 50 of its points are over the block", error);
    } else {
        t->count = kept;
        status = fit_heights(t, t->count, t->point, error);
    }
    if (status == WCUT_OK) {
        int inside = 0;
        for (int k = 0; k < t->count; k++)
            if (over_block(block, t->point[k], 0)) t->point[inside++] = t->point[k];
        t->count = inside;
        t->covered = coverage(block, t->count, t->point);
        status = check_whole_target(t, error);
    }
    if (status == WCUT_OK)
        *target = t;
    else
        wcut_design_target_destroy(t);
    return status;
}

void wcut_design_target_destroy(wcut_design_target *t) {
    if (!t) return;
    wcut_free(t->point);
    wcut_heights_clear(&t->heights);
    wcut_free(t);
}

/* ---- parts ---- */

wcut_status wcut_design_target_window(const wcut_design_target *target, wcut_vec3 low, wcut_vec3 high,
                                      wcut_design_target **out) {
    wcut_design_target *t = wcut_copy(target, 1, sizeof *target);
    if (!t) return WCUT_NO_MEMORY;
    const size_t coefficients = (size_t)(target->heights.cells_x + 3) * (size_t)(target->heights.cells_y + 3);
    t->block = vec3(high.x - low.x, high.y - low.y, target->block.z);
    t->count = 0;
    t->point = wcut_alloc((size_t)target->count, sizeof *t->point);
    t->heights.coefficient = wcut_copy(target->heights.coefficient, coefficients, sizeof *t->heights.coefficient);
    t->heights.low = vec3(target->heights.low.x - low.x, target->heights.low.y - low.y, 0);
    t->heights.high = vec3(target->heights.high.x - low.x, target->heights.high.y - low.y, 0);
    wcut_status status = t->point && t->heights.coefficient ? WCUT_OK : WCUT_NO_MEMORY;

    /* the points in the window, from its corner */
    for (int k = 0; status == WCUT_OK && k < target->count; k++) {
        const wcut_vec3 p = vec3(target->point[k].x - low.x, target->point[k].y - low.y, target->point[k].z);
        if (over_block(t->block, p, 0)) t->point[t->count++] = p;
    }
    if (status == WCUT_OK && t->count < POINTS_MIN) status = WCUT_DEGENERATE;
    if (status == WCUT_OK)
        *out = t;
    else
        wcut_design_target_destroy(t);
    return status;
}

/* ---- feeds ---- */

const char *wcut_design_feed_name(wcut_design_feed feed) {
    static const char *const text[] = {"auto", "+y", "-y", "+x", "-x"};
    return (unsigned)feed < sizeof text / sizeof *text ? text[feed] : "unknown";
}

wcut_vec3 wcut_design_turn(wcut_design_feed feed, wcut_vec3 block, wcut_vec3 p) {
    if (feed == WCUT_DESIGN_FEED_MINUS_Y) return vec3(block.x - p.x, block.y - p.y, p.z);
    if (feed == WCUT_DESIGN_FEED_PLUS_X) return vec3(block.y - p.y, p.x, p.z);
    if (feed == WCUT_DESIGN_FEED_MINUS_X) return vec3(p.y, block.x - p.x, p.z);
    return p;
}

wcut_status wcut_design_target_turn(const wcut_design_target *target, wcut_design_feed feed, wcut_design_target **out) {
    const bool along_x = feed == WCUT_DESIGN_FEED_PLUS_X || feed == WCUT_DESIGN_FEED_MINUS_X;
    const wcut_heights *from = &target->heights;
    wcut_design_target *t = wcut_copy(target, 1, sizeof *target);
    if (!t) return WCUT_NO_MEMORY;
    const int nx = from->cells_x + 3, ny = from->cells_y + 3;
    wcut_heights *h = &t->heights;
    t->point = wcut_alloc((size_t)t->count, sizeof *t->point);
    h->coefficient = wcut_alloc((size_t)nx * (size_t)ny, sizeof *h->coefficient);
    if (!t->point || !h->coefficient) {
        wcut_design_target_destroy(t);
        return WCUT_NO_MEMORY;
    }

    /* the block, the points, the rectangle of the heights */
    if (along_x) t->block = vec3(target->block.y, target->block.x, target->block.z);
    for (int k = 0; k < t->count; k++) t->point[k] = wcut_design_turn(feed, target->block, target->point[k]);
    const wcut_vec3 a = wcut_design_turn(feed, target->block, from->low);
    const wcut_vec3 b = wcut_design_turn(feed, target->block, from->high);
    h->low = vec3(fmin(a.x, b.x), fmin(a.y, b.y), 0), h->high = vec3(fmax(a.x, b.x), fmax(a.y, b.y), 0);
    if (along_x) {
        h->cells_x = from->cells_y, h->cells_y = from->cells_x;
        h->step_x = from->step_y, h->step_y = from->step_x;
    }

    /* the coefficients stand where they stood */
    for (int j = 0; j < ny; j++)
        for (int i = 0; i < nx; i++) {
            int to_x = i, to_y = j;
            if (feed == WCUT_DESIGN_FEED_MINUS_Y) to_x = nx - 1 - i, to_y = ny - 1 - j;
            if (feed == WCUT_DESIGN_FEED_PLUS_X) to_x = ny - 1 - j, to_y = i;
            if (feed == WCUT_DESIGN_FEED_MINUS_X) to_x = j, to_y = nx - 1 - i;
            h->coefficient[to_y * (h->cells_x + 3) + to_x] = from->coefficient[j * nx + i];
        }
    *out = t;
    return WCUT_OK;
}
