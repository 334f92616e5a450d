/* The face of an element: the cut in its block, its borders carried to shared edges, as points and a surface. */
#include <float.h>
#include <string.h>
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "facade/layout.h"
#include "solid/cut_face.h"
#include "surface/interpolate.h"
#include "surface/mesh_volume.h"

enum { N = WCUT_FACADE_SAMPLES, LAST_SAMPLE = N - 1, DEGREE = 3, STEPS_MAX = 100 };

/* borders meet at the corners to this [mm]: heights come from files */
static const double CORNERS_HELD = 1e-5;

/* the cut is followed this closely [mm]: closer than foam is cut, and reached where the wire comes to the block at rest */
static const double FIT = 0.05;

/* a place along the feed is found where y is this near [mm] */
static const double BORDER_FOUND = 1e-11;

static double share_of_sample(int k) { return (double)k / LAST_SAMPLE; }

static wcut_vec3 *sample_at(wcut_vec3 *point, int j, int i) { return point + (ptrdiff_t)j * N + i; }

/* ---- the surface through samples ---- */

/* x and y of the control points: linear in the parameters, so that they are the knots' averages (Greville 1967) */
static void set_places(wcut_vec3 block, const double *knots, wcut_vec3 *control) {
    double at[N];
    for (int k = 0; k < N; k++) at[k] = (knots[k + 1] + knots[k + 2] + knots[k + 3]) / 3;
    at[0] = 0, at[LAST_SAMPLE] = 1;
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            wcut_vec3 *p = sample_at(control, j, i);
            p->x = block.x * at[i], p->y = block.y * at[j];
        }
}

/* A bicubic through the samples at even parameters. Control points of a border come from its own samples alone: two
   faces with one border have one border curve. */
static wcut_status interpolate_samples(wcut_vec3 block, const wcut_vec3 *point, wcut_surface **surface) {
    double parameter[N], knots[N + DEGREE + 1];
    for (int k = 0; k < N; k++) parameter[k] = share_of_sample(k);
    wcut_knots_average(DEGREE, N, parameter, knots);

    /* along u, then along v */
    wcut_vec3 *control = wcut_copy(point, (size_t)N * N, sizeof *control);
    if (!control) return WCUT_NO_MEMORY;
    wcut_status status = wcut_interpolate_rows(DEGREE, N, knots, parameter, N, control);
    if (status == WCUT_OK) status = wcut_interpolate_columns(DEGREE, N, knots, parameter, N, control);
    if (status == WCUT_OK) {
        set_places(block, knots, control);
        status = wcut_surface_create(DEGREE, DEGREE, N, N, knots, knots, control, NULL, surface);
    }
    wcut_free(control);
    return status;
}

/* area of the face and volume under it, by the triangles of the samples */
static void measure_element(wcut_element_face *f) {
    static const int corner[2][3][2] = {{{0, 0}, {0, 1}, {1, 1}}, {{0, 0}, {1, 1}, {1, 0}}};
    f->area = f->volume = 0;
    for (int k = 0; k < LAST_SAMPLE * LAST_SAMPLE; k++)
        for (int t = 0; t < 2; t++) {
            wcut_vec3 p[3];
            for (int c = 0; c < 3; c++)
                p[c] = *sample_at(f->point, k / LAST_SAMPLE + corner[t][c][0], k % LAST_SAMPLE + corner[t][c][1]);
            const wcut_vec3 turn = vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0]));
            f->area += vec3_length(turn) / 2;
            f->volume += turn.z / 2 * (p[0].z + p[1].z + p[2].z) / 3;
        }
}

static wcut_element_face *new_face(wcut_vec3 block) {
    wcut_element_face *f = wcut_alloc(1, sizeof *f);
    if (!f) return NULL;
    f->block = block;
    f->radius_min = INFINITY;
    f->point = wcut_alloc((size_t)N * N, sizeof *f->point);
    f->moved = wcut_alloc((size_t)N * N, sizeof *f->moved);
    bool room = f->point && f->moved;
    for (int b = 0; b < 4; b++) room = (f->cut[b] = wcut_alloc(N, sizeof *f->cut[b])) && room;
    if (room) return f;
    wcut_element_face_destroy(f);
    return NULL;
}

void wcut_element_face_destroy(wcut_element_face *face) {
    if (!face) return;
    wcut_surface_destroy(face->surface);
    wcut_free(face->point);
    wcut_free(face->force);
    wcut_free(face->moved);
    for (int b = 0; b < 4; b++) wcut_free(face->cut[b]);
    wcut_free(face);
}

/* ---- the cut as heights ---- */

/* The parameter at which a curve of the patch along the feed is at y, by Newton's method inside a bracket; false: it
   does not go on there. *t: at least where it was before. */
static bool locate_along(const wcut_curve *curve, double y, double *t, double *height) {
    double low = *t, high = 1, at = *t;
    wcut_vec3 ders[2];
    for (int k = 0; k < STEPS_MAX; k++) {
        if (wcut_curve_eval(curve, at, 1, ders) != WCUT_OK) return false;
        const double off = ders[0].y - y;
        if (fabs(off) <= BORDER_FOUND || high - low <= DBL_EPSILON) break;
        if (off < 0) {
            low = at;
        } else {
            high = at;
        }

        /* a step that leaves the bracket is replaced by its middle */
        const double next = ders[1].y > 0 ? at - off / ders[1].y : low;
        at = next > low && next < high ? next : (low + high) / 2;
    }
    *t = at;
    *height = ders[0].z;
    return fabs(ders[0].y - y) <= 1e3 * BORDER_FOUND;
}

/* heights of the patch in the plane x = share of the width, at y = (j + offset) steps */
static wcut_status sample_column(const wcut_surface *patch, wcut_vec3 block, double share, int count, double offset,
                                 double *height, wcut_error *error) {
    wcut_curve *curve = NULL;
    wcut_status status = wcut_surface_iso_curve(patch, WCUT_DIRECTION_V, share, &curve);
    double t = 0;
    for (int j = 0; j < count && status == WCUT_OK; j++) {
        const double y = block.y * (j + offset) / LAST_SAMPLE;
        if (!locate_along(curve, y, &t, &height[j]))
            status =
                wcut_fail(error, WCUT_DEGENERATE,
                          "element: the face overhangs near (%.6g, %.6g) mm of the block; expected one height over "
                          "every place",
                          block.x * share, y);
    }
    wcut_curve_destroy(curve);
    return status;
}

/* the face as it is cut: heights at even steps across and along the block */
static wcut_status sample_cut(const wcut_surface *patch, wcut_element_face *f, wcut_error *error) {
    double height[N];
    for (int i = 0; i < N; i++) {
        const wcut_status status = sample_column(patch, f->block, share_of_sample(i), N, 0, height, error);
        if (status != WCUT_OK) return status;
        for (int j = 0; j < N; j++) {
            wcut_vec3 *p = sample_at(f->point, j, i);
            *p = vec3(f->block.x * share_of_sample(i), f->block.y * share_of_sample(j), height[j]);
        }
    }

    /* its borders */
    for (int k = 0; k < N; k++) {
        f->cut[0][k] = sample_at(f->point, k, 0)->z;
        f->cut[1][k] = sample_at(f->point, k, LAST_SAMPLE)->z;
        f->cut[2][k] = sample_at(f->point, 0, k)->z;
        f->cut[3][k] = sample_at(f->point, LAST_SAMPLE, k)->z;
    }
    return WCUT_OK;
}

/* how far the surface through the samples of the cut misses the cut in the middles between them */
static wcut_status measure_fit(const wcut_surface *patch, wcut_element_face *f, wcut_error *error) {
    wcut_surface *through = NULL;
    wcut_status status = interpolate_samples(f->block, f->point, &through);
    double height[N];
    for (int i = 0; i < LAST_SAMPLE && status == WCUT_OK; i++) {
        const double s = (i + 0.5) / LAST_SAMPLE;
        status = sample_column(patch, f->block, s, LAST_SAMPLE, 0.5, height, error);
        for (int j = 0; j < LAST_SAMPLE && status == WCUT_OK; j++) {
            wcut_vec3 p;
            status = wcut_surface_eval(through, s, (j + 0.5) / LAST_SAMPLE, 0, &p);
            if (status == WCUT_OK) f->fit_error = fmax(f->fit_error, fabs(p.z - height[j]));
        }
    }
    wcut_surface_destroy(through);
    return status;
}

/* ---- borders carried ---- */

/* the moves of the borders spread over the face: ruled both ways, less the bilinear patch of the corners (Coons 1967) */
static void carry_borders(const double *const border[4], wcut_element_face *f) {
    double move[4][N];
    for (int b = 0; b < 4; b++)
        for (int k = 0; k < N; k++) move[b][k] = border[b] ? border[b][k] - f->cut[b][k] : 0;

    /* corners belong to two borders: the sides say where they are */
    for (int b = 2; b < 4; b++) {
        move[b][0] = move[0][b == 3 ? LAST_SAMPLE : 0];
        move[b][LAST_SAMPLE] = move[1][b == 3 ? LAST_SAMPLE : 0];
    }
    for (int j = 0; j < N; j++)
        for (int i = 0; i < N; i++) {
            const double s = share_of_sample(i), t = share_of_sample(j);
            const double across = (1 - s) * move[0][j] + s * move[1][j], along = (1 - t) * move[2][i] + t * move[3][i];
            const double low = (1 - s) * move[2][0] + s * move[2][LAST_SAMPLE];
            const double high = (1 - s) * move[3][0] + s * move[3][LAST_SAMPLE];
            const double up = across + along - (1 - t) * low - t * high;
            f->moved[(ptrdiff_t)j * N + i] = up;
            f->moved_max = fmax(f->moved_max, fabs(up));
            sample_at(f->point, j, i)->z += up;
        }

    /* the borders themselves to the last bit; corners as the sides have them */
    for (int b = 3; b >= 0; b--)
        for (int k = 0; k < N && border[b]; k++) {
            const int j = b < 2 ? k : b == 3 ? LAST_SAMPLE : 0, i = b < 2 ? (b ? LAST_SAMPLE : 0) : k;
            *sample_at(f->point, j, i) = wcut_border_point(f->block, b, k, border[b][k]);
        }
}

/* the force at the node of the cut that is nearest to each sample */
static wcut_status sample_force(int count, const wcut_vec3 *position, const double *force, wcut_element_face *f) {
    if (count == 0) return WCUT_OK;
    f->force = wcut_alloc((size_t)N * N, sizeof *f->force);
    if (!f->force) return WCUT_NO_MEMORY;
    for (int k = 0; k < N * N; k++) {
        double min = INFINITY;
        for (int i = 0; i < count; i++) {
            const wcut_vec3 d = vec3_sub(position[i], f->point[k]);
            const double squared = vec3_dot(d, d);
            if (squared < min) min = squared, f->force[k] = force[i];
        }
    }
    return WCUT_OK;
}

/* ---- for the caller ---- */

static bool are_borders_fine(const double *const border[4]) {
    for (int b = 0; b < 4; b++)
        if (border[b] && !all_finite(N, border[b])) return false;

    /* what two borders have in common is the same */
    for (int k = 0; k < 4; k++) {
        const double *side = border[k % 2], *across = border[2 + k / 2];
        if (side && across && !(fabs(side[k / 2 ? LAST_SAMPLE : 0] - across[k % 2 ? LAST_SAMPLE : 0]) <= CORNERS_HELD))
            return false;
    }
    return true;
}

/* the patch of the cut over the block, inside it */
static wcut_status fit_patch(const wcut_surface *wire, wcut_vec3 block, wcut_cut_face *cut, wcut_error *error) {
    wcut_mould_options options = wcut_mould_default();
    options.fit_tolerance = FIT;
    const wcut_division d = {.surface = wire, .block = block, .options = &options};
    int leaves = 0;
    wcut_status status = wcut_cut_face_solve(&d, 0, 0, cut, error);
    if (status != WCUT_OK) return status;
    status = wcut_cut_face_place(&d, cut, cut, &leaves, error);
    if (status == WCUT_OK && leaves)
        status = wcut_fail(
            error, WCUT_DEGENERATE,
            "the cut leaves the block through its %s: from z = %.6g to %.6g mm, expected it between 0 and %.6g mm",
            cut->low < 0 ? "bottom" : "top", cut->low, cut->high, block.z);
    if (status != WCUT_OK) wcut_cut_face_clear(cut);
    return status;
}

wcut_status wcut_element_face_create(const wcut_surface *wire, wcut_vec3 block, const double *const border[4],
                                     int stations, int nodes, const wcut_vec3 *position, const double *force,
                                     wcut_element_face **face, wcut_error *error) {
    const bool forced = stations != 0;
    if (!wire || !border || !face || !is_positive(block.x) || !is_positive(block.y) || !is_positive(block.z) ||
        !are_borders_fine(border) || (forced && (stations < 1 || nodes < 1 || !position || !force)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "element: expected a surface, a block, and borders that meet at the corners");

    /* the cut as it is */
    wcut_cut_face cut = {.chord_error = 0};
    wcut_status status = fit_patch(wire, block, &cut, error);
    if (status != WCUT_OK) return status;
    const wcut_surface *patch = cut.fit.patch;
    wcut_error said = {.text = ""};
    wcut_element_face *f = new_face(block);
    status = f ? sample_cut(patch, f, &said) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = measure_fit(patch, f, &said);

    /* carried to the shared edges */
    if (status == WCUT_OK) carry_borders(border, f);
    if (status == WCUT_OK) status = interpolate_samples(block, f->point, &f->surface);
    if (status == WCUT_OK) status = sample_force(stations * nodes, position, force, f);
    if (status == WCUT_OK) {
        f->radius_min = cut.fit.radius;
        measure_element(f);
        *face = f;
    } else {
        wcut_element_face_destroy(f);
        wcut_fail(error, status, "%s", said.text[0] ? said.text : wcut_status_text(status));
    }
    wcut_cut_face_clear(&cut);
    return status;
}

wcut_status wcut_element_face_interpolate(wcut_vec3 block, const double *height, wcut_element_face **face) {
    if (!height || !face || !is_positive(block.x) || !is_positive(block.y) || !is_positive(block.z) ||
        !all_finite(N * N, height))
        return WCUT_BAD_ARGUMENT;
    wcut_element_face *f = new_face(block);
    if (!f) return WCUT_NO_MEMORY;
    for (int k = 0; k < N * N; k++)
        f->point[k] = vec3(block.x * share_of_sample(k % N), block.y * share_of_sample(k / N), height[k]);

    /* surface and figures */
    const wcut_status status = interpolate_samples(block, f->point, &f->surface);
    if (status == WCUT_OK) {
        measure_element(f);
        *face = f;
    } else {
        wcut_element_face_destroy(f);
    }
    return status;
}
