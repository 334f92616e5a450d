/* A photograph over the simulated wire: rectified, its rills measured, the shape that they tell. */
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "photo/camera.h"
#include "photo/face_grid.h"
#include "photo/rectify.h"
#include "photo/rill_curve.h"
#include "photo/rills.h"

enum { PATCHES_MAX = 1000000, CURVES_MAX = 1000 };

/* [rad] 0.1 deg: what the simulated direction itself is good for within a patch */
static const double ANGLE_FLOOR = 0.1 * WCUT_PI / 180;

/* [rad] 0.05 deg: what sampling and filters turn all directions by; seen on rendered pictures */
static const double COMMON_FLOOR = 0.05 * WCUT_PI / 180;

/* ---- pictures ---- */

wcut_status wcut_picture_create(int width, int height, int channels, wcut_picture **picture) {
    if (width < 1 || height < 1 || width > 1000000 || height > 1000000 ||
        (long long)width * height > WCUT_PICTURE_PIXELS || (channels != 1 && channels != 3 && channels != 4) ||
        !picture)
        return WCUT_BAD_ARGUMENT;
    wcut_picture *p = wcut_alloc(1, sizeof *p);
    if (!p) return WCUT_NO_MEMORY;
    *p = (wcut_picture){.width = width, .height = height, .channels = channels};
    p->pixel = wcut_alloc((size_t)width * height, (size_t)channels);
    if (!p->pixel) {
        wcut_free(p);
        return WCUT_NO_MEMORY;
    }
    *picture = p;
    return WCUT_OK;
}

void wcut_picture_destroy(wcut_picture *picture) {
    if (!picture) return;
    wcut_free(picture->pixel);
    wcut_free(picture);
}

wcut_overlay_options wcut_overlay_options_default(void) {
    return (wcut_overlay_options){.patch = 20, .curves = 24, .threads = 1};
}

/* ---- what the camera's uncertainty does to a direction ---- */

/* direction in the block of what a moved camera sees along the wire, laid out by the unmoved one */
static bool apparent_direction(const wcut_camera *camera, const wcut_camera *moved, const wcut_vec3 p[3], double x,
                               double y, double *direction) {
    wcut_pixel a[3], b[3];
    for (int k = 0; k < 3; k++) {
        a[k] = wcut_camera_pixel(camera, p[k]);
        b[k] = wcut_camera_pixel(moved, p[k]);
        if (!(a[k].depth > 0) || !(b[k].depth > 0)) return false;
    }

    /* the image of the direction, and back through the other camera's map */
    const double u = x * (b[1].u - b[0].u) + y * (b[2].u - b[0].u), v = x * (b[1].v - b[0].v) + y * (b[2].v - b[0].v);
    const double m11 = a[1].u - a[0].u, m12 = a[2].u - a[0].u, m21 = a[1].v - a[0].v, m22 = a[2].v - a[0].v;
    const double det = m11 * m22 - m12 * m21;
    if (!(fabs(det) > 0)) return false;
    *direction = atan2((m11 * v - m21 * u) / det, (m22 * u - m12 * v) / det);
    return true;
}

/* [rad] standard deviation of a direction at a patch from the covariance of the camera */
static double systematic_of(const wcut_camera *camera, const wcut_camera_report *report, const wcut_face_grid *grid,
                            const wcut_rill_patch *patch) {
    if (!report || camera->kind == WCUT_CAMERA_KIND_PLANE) return 0;
    const double h = 2 * grid->cell;
    const wcut_face_place right = wcut_face_grid_locate(grid, patch->place.x + h, patch->place.y),
                          up = wcut_face_grid_locate(grid, patch->place.x, patch->place.y + h);
    if (!right.there || !up.there) return 0;
    const wcut_vec3 p[3] = {
        patch->place, {patch->place.x + h, patch->place.y, right.z}, {patch->place.x, patch->place.y + h, up.z}};
    const double x = cos(patch->wire), y = sin(patch->wire);

    /* derivative by each parameter, a standard deviation to either side */
    enum { N = WCUT_CAMERA_PARAMETERS };
    double slope[N] = {0}, variance = 0;
    for (int j = 0; j < N; j++) {
        const double sigma = sqrt(report->covariance[j * N + j]);
        double step[N] = {0}, low, high;
        if (!(sigma > 0)) continue;
        step[j] = sigma;
        const wcut_camera after = wcut_camera_moved(camera, step);
        step[j] = -sigma;
        const wcut_camera before = wcut_camera_moved(camera, step);
        if (!apparent_direction(camera, &after, p, x, y, &high) || !apparent_direction(camera, &before, p, x, y, &low))
            continue;
        double d = high - low;
        d -= 2 * WCUT_PI * floor(d / (2 * WCUT_PI) + 0.5);
        slope[j] = d / (2 * sigma);
    }
    for (int j = 0; j < N; j++)
        for (int k = 0; k < N; k++) variance += slope[j] * slope[k] * report->covariance[j * N + k];
    return sqrt(fmax(variance, 0));
}

/* ---- patches ---- */

static wcut_status measure_patch(const wcut_grey *grey, const wcut_face_grid *grid, wcut_vec3 block, double side,
                                 const wcut_camera *camera, const wcut_camera_report *report, wcut_rill_patch *patch) {
    const wcut_face_place f = wcut_face_grid_locate(grid, patch->place.x, patch->place.y);
    if (!f.there) return WCUT_OK;
    patch->place.z = f.z;
    patch->station = f.station;
    patch->wire = atan2(f.tangent_y, f.tangent_x);
    if (patch->wire > WCUT_PI / 2) patch->wire -= WCUT_PI;
    if (patch->wire <= -WCUT_PI / 2) patch->wire += WCUT_PI;
    const wcut_status status = wcut_rills_measure(grey, grid, block, side, patch);
    if (status != WCUT_OK || !patch->readable) return status;
    patch->sigma = hypot(patch->sigma, ANGLE_FLOOR);
    patch->systematic = hypot(systematic_of(camera, report, grid, patch), COMMON_FLOOR);
    return WCUT_OK;
}

static wcut_status measure_patches(const wcut_grey *grey, const wcut_face_grid *grid, wcut_vec3 block,
                                   const wcut_camera *camera, const wcut_camera_report *report,
                                   const wcut_patch_grid *layout, int threads, wcut_progress progress, void *context,
                                   wcut_rill_patch *patch) {
    for (int row = 0; row < layout->rows; row++) {
        if (progress && progress(row, layout->rows, context) != 0) return WCUT_INTERRUPTED;
        int failed = 0;
#pragma omp parallel for num_threads(wcut_threads(threads)) schedule(dynamic) reduction(+ : failed)
        for (int column = 0; column < layout->columns; column++) {
            wcut_rill_patch *p = &patch[(size_t)row * layout->columns + column];
            p->place.x = layout->x0 + (column + 0.5) * layout->side;
            p->place.y = layout->y0 + (row + 0.5) * layout->side;
            failed += measure_patch(grey, grid, block, layout->side, camera, report, p) != WCUT_OK;
        }
        if (failed > 0) return WCUT_NO_MEMORY;
    }
    return WCUT_OK;
}

/* ---- sums over patches ---- */

/* median and its standard deviation: of independent patches, and the camera's part that all share */
static wcut_status phase_median(const wcut_overlay *o, const wcut_history *h, int phase, wcut_rill_phase *to) {
    const int all = o->columns * o->rows;
    double *angle = wcut_alloc((size_t)all, sizeof *angle);
    if (!angle) return WCUT_NO_MEMORY;
    double own = 0, common = 0;
    for (int k = 0; k < all; k++) {
        const wcut_rill_patch *p = &o->patch[k];
        if (p->covered < 0.5 || (int)h->row[(int)(p->station + 0.5)].phase != phase) continue;
        to->patches++;
        if (!p->readable) continue;
        angle[to->readable++] = p->angle;
        own += p->sigma;
        common += p->systematic;
    }
    const int n = to->readable;
    if (n > 0) {
        wcut_sort(n, angle);
        to->median = sorted_median(n, angle);

        /* 1.2533 / sqrt(n) of the scatter, from the median absolute deviation */
        for (int k = 0; k < n; k++) angle[k] = fabs(angle[k] - to->median);
        wcut_sort(n, angle);
        const double scatter = fmax(1.4826 * sorted_median(n, angle), own / n);
        to->sigma = hypot(1.2533 * scatter / sqrt(n), common / n);
    }
    wcut_free(angle);
    return WCUT_OK;
}

/* [1] angle over its standard deviation */
static double standing_out(const wcut_rill_patch *p) { return fabs(p->angle) / hypot(p->sigma, p->systematic); }

/* the patches that stand out most, by insertion */
static void list_worst(wcut_overlay *o) {
    for (int k = 0; k < o->columns * o->rows; k++) {
        if (!o->patch[k].readable) continue;
        int at = o->worst_count;
        while (at > 0 && standing_out(&o->patch[k]) > standing_out(&o->patch[o->worst[at - 1]])) at--;
        if (at == WCUT_OVERLAY_WORST) continue;
        if (o->worst_count < WCUT_OVERLAY_WORST) o->worst_count++;
        for (int i = o->worst_count - 1; i > at; i--) o->worst[i] = o->worst[i - 1];
        o->worst[at] = k;
    }
}

static wcut_status summarise(const wcut_history *h, wcut_overlay *o) {
    int covered = 0;
    for (int k = 0; k < o->columns * o->rows; k++) {
        covered += o->patch[k].covered >= 0.5;
        o->readable += o->patch[k].readable;
    }
    o->readable_share = covered > 0 ? fmin((double)o->readable / covered, 1) : 0;
    list_worst(o);
    for (int k = 0; k < o->curve_count; k++) o->differing += o->curve[k].differs;
    wcut_status status = WCUT_OK;
    for (int phase = 0; phase <= WCUT_PHASE_LEFT && status == WCUT_OK; phase++)
        status = phase_median(o, h, phase, &o->phase[phase]);
    return status;
}

/* ---- the whole ---- */

static wcut_status check_overlay(wcut_vec3 block, const wcut_history *h, const wcut_camera *camera,
                                 const wcut_picture *picture, const wcut_overlay_options *o, wcut_error *error) {
    if (!is_positive(block.x) || !is_positive(block.y) || !is_positive(block.z) || block.x > 1e6 || block.y > 1e6 ||
        !h || h->stations < 2 || h->nodes < 2 || !h->row || !h->position || !camera || !picture || !picture->pixel)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "overlay: expected a block, a history of two stations, a camera and a picture");
    /* the picture is the camera's */
    if (picture->width != camera->width || picture->height != camera->height || picture->width < 2 ||
        picture->height < 2 || (picture->channels != 1 && picture->channels != 3 && picture->channels != 4))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "overlay: found a picture of %d x %d px and a camera of %d x %d px",
                         picture->width, picture->height, camera->width, camera->height);
    if (!isfinite(o->resolution) || o->resolution < 0 || !is_positive(o->patch) || o->curves < 0 ||
        o->curves > CURVES_MAX || o->threads < 1)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "overlay: expected a resolution of 0 or more, a positive patch, 0 to %d curves, "
                         "a thread or more",
                         CURVES_MAX);
    if (floor(block.x / o->patch) * floor(block.y / o->patch) > PATCHES_MAX)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "overlay: found patches of %g mm, expected at most %d in the block",
                         o->patch, PATCHES_MAX);
    /* numbers of both */
    wcut_vec3 origin = {0, 0, 0};
    double pixel[2];
    if (wcut_camera_project(camera, 1, &origin, pixel, NULL) != WCUT_OK ||
        !vec3_all_finite(h->stations * h->nodes, h->position))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "overlay: expected finite positions and a sound camera");
    return WCUT_OK;
}

/* the side of the face from which a camera looks: +1 above it */
static double side_of_wire(const wcut_face_grid *g, const wcut_camera *camera) {
    double sum = 0, count = 0;
    for (int k = 0; k < g->columns * g->rows; k++)
        if (g->station[k] >= 0) sum += g->z[k], count += 1;
    return camera->centre.z > sum / count ? 1 : -1;
}

/* what can be seen, and how finely */
static wcut_status prepare_face(wcut_vec3 block, const wcut_history *h, const wcut_camera *camera,
                                const wcut_overlay_options *o, wcut_face_grid **grid, double *resolution,
                                wcut_error *error) {
    wcut_face_grid *g = NULL;
    wcut_status status = wcut_face_grid_create(block, h, o->upper, &g);
    if (status != WCUT_OK)
        return wcut_fail(
            error, status, "overlay: %s",
            status == WCUT_DEGENERATE ? "the simulated wires pass no place of the block" : wcut_status_text(status));
    /* a camera on the other side sees the other half, or its points are mirrored */
    if (camera->kind != WCUT_CAMERA_KIND_PLANE) {
        if (side_of_wire(g, camera) != (o->upper ? -1 : 1))
            status = wcut_fail(
                error, WCUT_DEGENERATE,
                "overlay: the points put the camera %s the face; expected it %s: the other half is in the picture, "
                "or the points are mirrored",
                o->upper ? "above" : "below", o->upper ? "below" : "above");
        else
            wcut_face_grid_hide(g, camera->centre, o->upper);
    }
    *resolution = o->resolution > 0 ? o->resolution : wcut_rectify_resolution(g, block, camera);
    if (status == WCUT_OK && !(*resolution > 0))
        status =
            wcut_fail(error, WCUT_DEGENERATE,
                      "overlay: the picture shows no place of the simulated face; expected the points of this cut");
    if (status == WCUT_OK)
        *grid = g;
    else
        wcut_face_grid_destroy(g);
    return status;
}

/* the rectified picture to patches and curves */
static wcut_status measure_overlay(wcut_vec3 block, const wcut_history *h, const wcut_face_grid *grid,
                                   const wcut_camera *camera, const wcut_camera_report *report,
                                   const wcut_overlay_options *options, wcut_progress progress, void *context,
                                   wcut_overlay *o) {
    wcut_patch_grid layout = {.columns = (int)fmax(floor(block.x / options->patch), 1),
                              .rows = (int)fmax(floor(block.y / options->patch), 1),
                              .side = options->patch};
    layout.x0 = (block.x - layout.columns * layout.side) / 2;
    layout.y0 = (block.y - layout.rows * layout.side) / 2;
    o->columns = layout.columns;
    o->rows = layout.rows;
    o->patch = wcut_alloc((size_t)layout.columns * layout.rows, sizeof *o->patch);
    if (!o->patch) return WCUT_NO_MEMORY;

    /* patches, then the wires through them */
    wcut_grey *grey = NULL;
    wcut_status status = wcut_grey_create(o->rectified, o->resolution, &grey);
    if (status == WCUT_OK) {
        o->noise = grey->noise;
        status =
            measure_patches(grey, grid, block, camera, report, &layout, options->threads, progress, context, o->patch);
    }
    wcut_grey_destroy(grey);
    layout.patch = o->patch;
    if (status == WCUT_OK) status = wcut_rill_curves(block, h, &layout, options->curves, &o->curve_count, &o->curve);
    return status == WCUT_OK ? summarise(h, o) : status;
}

wcut_status wcut_overlay_create(wcut_vec3 block, const wcut_history *history, const wcut_camera *camera,
                                const wcut_camera_report *report, const wcut_picture *picture,
                                const wcut_overlay_options *options, wcut_progress progress, void *context,
                                wcut_overlay **overlay, wcut_error *error) {
    const wcut_overlay_options o = options ? *options : wcut_overlay_options_default();
    if (!overlay) return wcut_fail(error, WCUT_BAD_ARGUMENT, "overlay: %s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = check_overlay(block, history, camera, picture, &o, error);
    if (status != WCUT_OK) return status;

    /* the face as the camera sees it */
    wcut_face_grid *grid = NULL;
    double resolution = 0;
    status = prepare_face(block, history, camera, &o, &grid, &resolution, error);
    if (status != WCUT_OK) return status;

    wcut_overlay *made = wcut_alloc(1, sizeof *made);
    status = made ? WCUT_OK : WCUT_NO_MEMORY;
    if (made) made->resolution = resolution;
    if (status == WCUT_OK)
        status = wcut_rectify(grid, block, camera, picture, resolution, o.threads, &made->rectified, &made->covered);
    if (status == WCUT_BAD_ARGUMENT) {
        status = wcut_fail(error, status,
                           "overlay: found a resolution of %g mm, expected one that gives a picture of 1 to %d pixels",
                           resolution, WCUT_PICTURE_PIXELS);
    } else {
        if (status == WCUT_OK)
            status = measure_overlay(block, history, grid, camera, report, &o, progress, context, made);
        if (status != WCUT_OK) wcut_fail(error, status, "overlay: %s", wcut_status_text(status));
    }
    wcut_face_grid_destroy(grid);
    if (status == WCUT_OK)
        *overlay = made;
    else
        wcut_overlay_destroy(made);
    return status;
}

void wcut_overlay_destroy(wcut_overlay *overlay) {
    if (!overlay) return;
    wcut_picture_destroy(overlay->rectified);
    wcut_rill_curves_free(overlay->curve_count, overlay->curve);
    wcut_free(overlay->patch);
    wcut_free(overlay);
}
