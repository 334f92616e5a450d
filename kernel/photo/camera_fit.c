/* A camera from points: linear start, then Levenberg-Marquardt on the pixels, each point left out in turn. */
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/least_squares.h"
#include "base/numbers.h"
#include "photo/camera.h"

enum { COUNT_MAX = 500, PLANE_MAX = 5, FULL_MIN = 6, K2_MIN = 10, HOMOGRAPHY = 8 };

/* flat: rms distance from the best plane below this share of the extent; on a line: the second extent likewise */
static const double FLAT = 0.01, LINE = 0.005;

/* a focal length that is known worse than this is not used */
static const double FOCAL_SHARE = 0.1;

/* how many parameters a camera of a kind has with so many points */
static int camera_parameters_of(wcut_camera_kind kind, int count) {
    if (kind == WCUT_CAMERA_KIND_PLANE) return HOMOGRAPHY;
    return kind == WCUT_CAMERA_KIND_PINHOLE ? 7 : count >= K2_MIN ? 9 : 8;
}

/* the points of a fit, one of them may be left out */
typedef struct camera_problem {
    int count, without; /* without: -1 for none */
    const wcut_photo_point *point;
    const wcut_camera *start;
    int parameters;
} camera_problem;

wcut_camera_options wcut_camera_options_default(void) { return (wcut_camera_options){.pixel_sigma = 0.25}; }

/* ---- the fit ---- */

/* the start moved by x: a camera's parameters, or the first eight numbers of a homography */
static wcut_camera camera_at(const camera_problem *p, const double *x) {
    if (p->start->kind == WCUT_CAMERA_KIND_PLANE) {
        wcut_camera moved = *p->start;
        for (int k = 0; k < HOMOGRAPHY; k++) moved.homography[k] += x[k] * fabs(moved.homography[8]);
        return moved;
    }
    double step[WCUT_CAMERA_PARAMETERS] = {0};
    memcpy(step, x, (size_t)p->parameters * sizeof *step);
    return wcut_camera_moved(p->start, step);
}

static bool camera_residuals(const camera_problem *p, const double *x, double *r) {
    const wcut_camera camera = camera_at(p, x);
    int at = 0;
    for (int i = 0; i < p->count; i++) {
        if (i == p->without) continue;
        const wcut_pixel seen = wcut_camera_pixel(&camera, p->point[i].place);
        if (!(seen.depth > 0)) return false;
        r[at++] = seen.u - p->point[i].u;
        r[at++] = seen.v - p->point[i].v;
    }
    return all_finite(at, r);
}

/* residuals, and their derivatives by central differences: errors of 1e-9 of a pixel */
static bool camera_model(void *data, const double *x, double *r, double *jacobian) {
    const camera_problem *p = data;
    if (!camera_residuals(p, x, r)) return false;
    if (!jacobian) return true;

    const int m = 2 * (p->count - (p->without >= 0)), n = p->parameters;
    const wcut_vec3 away = vec3_sub(p->start->centre, p->point[0].place);
    double moved[WCUT_CAMERA_PARAMETERS], low[2 * COUNT_MAX], high[2 * COUNT_MAX];
    bool sound = true;
    for (int j = 0; sound && j < n; j++) {
        /* steps in the unit of each parameter */
        const bool plane = p->start->kind == WCUT_CAMERA_KIND_PLANE, place = !plane && j >= 3 && j < 6;
        const double h = place ? 1e-6 * (1 + vec3_length(away)) : plane ? 1e-6 * (j < 6 ? 1 : 1e-3) : 1e-6;
        memcpy(moved, x, (size_t)n * sizeof *moved);
        moved[j] = x[j] - h;
        sound = camera_residuals(p, moved, low);
        moved[j] = x[j] + h;
        sound = sound && camera_residuals(p, moved, high);
        for (int i = 0; sound && i < m; i++) jacobian[(size_t)i * n + j] = (high[i] - low[i]) / (2 * h);
    }
    return sound;
}

/* what a fit gives beside the camera */
typedef struct camera_outcome {
    double cost; /* [px^2] */
    int degrees, iterations;
    double inverse[WCUT_CAMERA_PARAMETERS * WCUT_CAMERA_PARAMETERS]; /* (J^T J)^-1, parameters x parameters */
} camera_outcome;

/* the camera that minimises the misfit from a start; WCUT_SINGULAR, WCUT_NO_MEMORY */
static wcut_status refine_camera(const camera_problem *given, wcut_camera *camera, camera_outcome *outcome) {
    const wcut_camera start = *camera;
    camera_problem own = *given, *const p = &own;
    p->start = &start;
    const int n = p->parameters, m = 2 * (p->count - (p->without >= 0));
    double x[WCUT_CAMERA_PARAMETERS] = {0}, unused[WCUT_CAMERA_PARAMETERS];
    const wcut_lsq_problem problem = {.m = m, .n = n, .model = camera_model, .data = p};
    wcut_lsq_options options = wcut_lsq_options_default();
    options.tolerance = 1e-8;
    wcut_lsq_report report;
    wcut_status status = m < n ? WCUT_SINGULAR : wcut_lsq_solve(&problem, &options, x, NULL, NULL, &report);
    if (status != WCUT_OK && status != WCUT_NOT_CONVERGED) return status == WCUT_BAD_ARGUMENT ? WCUT_SINGULAR : status;

    /* the inverse of the normal equations at the minimum */
    double *jacobian = wcut_alloc((size_t)m * n, sizeof *jacobian), *r = wcut_alloc((size_t)m, sizeof *r);
    status = jacobian && r ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK && !camera_model(p, x, r, jacobian)) status = WCUT_SINGULAR;
    if (status == WCUT_OK) status = wcut_qr_solve(m, n, jacobian, r, unused, outcome->inverse);
    wcut_free(jacobian);
    wcut_free(r);
    if (status != WCUT_OK) return status;

    *camera = camera_at(p, x);
    outcome->cost = report.cost;
    outcome->degrees = m - n;
    outcome->iterations = report.iterations;
    return WCUT_OK;
}

/* per coordinate [px], not better than a point is measured */
static double outcome_sigma(const camera_outcome *o, double pixel_sigma) {
    return o->degrees > 0 ? fmax(sqrt(o->cost / o->degrees), pixel_sigma) : pixel_sigma;
}

/* a plane's image; a pinhole camera where the perspective tells its focal length */
static wcut_status fit_plane(const wcut_camera_points *points, double pixel_sigma, wcut_camera *camera,
                             camera_outcome *outcome) {
    bool determined = false;
    wcut_status status = wcut_camera_plane(points, camera, &determined);
    if (status != WCUT_OK) return status;

    camera_problem p = {.count = points->count, .without = -1, .point = points->point};
    wcut_camera pinhole = *camera;
    pinhole.kind = WCUT_CAMERA_KIND_PINHOLE;
    p.parameters = camera_parameters_of(pinhole.kind, points->count);
    if (determined) {
        status = refine_camera(&p, &pinhole, outcome);
        if (status == WCUT_NO_MEMORY) return status;
        const double share =
            status == WCUT_OK ? sqrt(outcome->inverse[6 * 7 + 6]) * outcome_sigma(outcome, pixel_sigma) : 1;
        if (share <= FOCAL_SHARE) {
            *camera = pinhole;
            return WCUT_OK;
        }
    }

    camera->kind = WCUT_CAMERA_KIND_PLANE;
    p.parameters = camera_parameters_of(camera->kind, points->count);
    return refine_camera(&p, camera, outcome);
}

/* WCUT_SINGULAR: the points do not determine it; WCUT_NOT_CONVERGED: no camera is near what they say */
static wcut_status fit_full(const wcut_camera_points *points, wcut_camera *camera, camera_outcome *outcome,
                            bool *mirrored) {
    wcut_status status = wcut_camera_direct(points, camera, mirrored);
    if (status != WCUT_OK || *mirrored) return status;

    camera->kind = WCUT_CAMERA_KIND_FULL;
    camera_problem p = {.count = points->count, .without = -1, .point = points->point};
    p.parameters = camera_parameters_of(camera->kind, points->count);
    status = refine_camera(&p, camera, outcome);
    return status == WCUT_SINGULAR ? WCUT_NOT_CONVERGED : status;
}

/* whether the points are the mirror image of what a camera sees, to within `limit` [px] rms */
static wcut_status is_mirror_image(const wcut_camera_points *points, const wcut_camera *camera, double limit,
                                   bool *answer) {
    wcut_photo_point *flipped = wcut_alloc((size_t)points->count, sizeof *flipped);
    if (!flipped) return WCUT_NO_MEMORY;
    for (int k = 0; k < points->count; k++) {
        flipped[k] = points->point[k];
        flipped[k].u = 2 * points->middle[0] - flipped[k].u;
    }
    wcut_camera_points turned = *points;
    turned.point = flipped;
    wcut_camera found = {.width = camera->width, .height = camera->height};
    camera_outcome outcome = {0};
    bool again = false;
    const wcut_status status = fit_full(&turned, &found, &outcome, &again);
    *answer = status == WCUT_OK && !again && sqrt(outcome.cost / points->count) <= limit;
    wcut_free(flipped);
    return status == WCUT_NO_MEMORY ? status : WCUT_OK;
}

/* ---- what is wrong with points ---- */

static wcut_status fail_points(wcut_error *error, const char *what) {
    return wcut_fail(error, WCUT_DEGENERATE, "points: %s", what);
}

static wcut_status check_spread(const wcut_camera_points *points, wcut_error *error) {
    for (int i = 0; i < points->count; i++)
        for (int k = 0; k < i; k++)
            if (vec3_distance(points->point[i].place, points->point[k].place) <= 1e-6 * points->spread[0])
                return wcut_fail(error, WCUT_DEGENERATE,
                                 "points: found rows %d and %d at one place, expected each once", k + 1, i + 1);
    if (!(points->spread[0] > 0) || points->spread[1] < LINE * points->spread[0])
        return fail_points(error, "all places lie on one line; expected points spread over the block's face");

    /* few points are for a plane, more for a camera in space */
    const bool flat = points->spread[2] < FLAT * points->spread[0];
    if (points->count <= PLANE_MAX && !flat)
        return wcut_fail(
            error, WCUT_DEGENERATE,
            "points: found %d points up to %.3g mm rms off a plane; expected 4 or 5 points of one plane, or 6 and "
            "more in space",
            points->count, points->spread[2]);
    if (points->count > PLANE_MAX && flat)
        return wcut_fail(
            error, WCUT_DEGENERATE,
            "points: all %d places lie in one plane (%.3g mm rms), which does not tell a camera from its focal "
            "length and distortion; expected points at other heights too, or 4 or 5 points for the plane alone",
            points->count, points->spread[2]);
    return WCUT_OK;
}

static wcut_status check_points(int count, const wcut_photo_point *point, int width, int height, wcut_error *error) {
    for (int i = 0; i < count; i++) {
        const wcut_photo_point *p = &point[i];
        if (!isfinite(p->u) || !isfinite(p->v) || !vec3_is_finite(p->place) || fabs(p->place.x) > 1e9 ||
            fabs(p->place.y) > 1e9 || fabs(p->place.z) > 1e9)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "point %d: expected finite numbers, places up to 1e9 mm", i + 1);
        if (p->u < -0.5 || p->v < -0.5 || p->u > width - 0.5 || p->v > height - 0.5)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "point %d: found u %.1f, v %.1f px, expected a point inside the picture of %d x %d px",
                             i + 1, p->u, p->v, width, height);
    }
    return WCUT_OK;
}

/* ---- each point left out in turn ---- */

/* a camera without point i; from the linear start where enough points are left, else from the camera of all */
static wcut_status fit_without(const camera_problem *all, const wcut_camera *camera, const wcut_photo_point *rest,
                               int i, wcut_camera *without, camera_outcome *outcome) {
    camera_problem p = *all;
    p.without = i;
    *without = *camera;
    if (camera->kind == WCUT_CAMERA_KIND_FULL && all->count - 1 >= FULL_MIN) {
        wcut_camera_points points;
        bool mirrored = false;
        wcut_camera_points_measure(all->count - 1, rest, camera->width, camera->height, &points);
        wcut_camera start = *camera;
        start.k1 = start.k2 = 0;
        if (wcut_camera_direct(&points, &start, &mirrored) == WCUT_OK && !mirrored) *without = start;
    }
    return refine_camera(&p, without, outcome);
}

/* leave_one_out [px], and the point whose removal explains most of the misfit; -1: none stands out */
static wcut_status leave_each_out(const camera_problem *all, const wcut_camera *camera, double sigma,
                                  double pixel_sigma, double *leave_one_out, int *suspect) {
    wcut_photo_point *rest = wcut_alloc((size_t)all->count, sizeof *rest);
    if (!rest) return WCUT_NO_MEMORY;
    double best = 0;
    int worst = -1;
    wcut_status status = WCUT_OK;
    for (int i = 0; i < all->count && status != WCUT_NO_MEMORY; i++) {
        wcut_camera without;
        camera_outcome outcome;
        for (int k = 0, at = 0; k < all->count; k++)
            if (k != i) rest[at++] = all->point[k];
        status = fit_without(all, camera, rest, i, &without, &outcome);
        leave_one_out[i] = 0;
        if (status != WCUT_OK) continue; /* the rest does not hold a camera: nothing can be said of the point */

        const wcut_pixel seen = wcut_camera_pixel(&without, all->point[i].place);
        leave_one_out[i] = seen.depth > 0 ? hypot(seen.u - all->point[i].u, seen.v - all->point[i].v)
                                          : 2 * hypot(camera->width, camera->height);
        const double left = outcome_sigma(&outcome, pixel_sigma);
        if (outcome.degrees >= 2 && leave_one_out[i] > 6 * left && sigma > 2 * left && (worst < 0 || left < best))
            worst = i, best = left;
    }
    wcut_free(rest);
    *suspect = worst;
    return status == WCUT_NO_MEMORY ? status : WCUT_OK;
}

/* ---- the whole ---- */

static wcut_status refuse_misfit(const camera_problem *p, const wcut_camera_report *r, double limit,
                                 wcut_error *error) {
    if (r->suspect < 0)
        return wcut_fail(
            error, WCUT_NOT_CONVERGED,
            "points: no camera sees them so: they are missed by %.1f px rms, expected at most %.1f; check that "
            "rows are not interchanged",
            r->rms, limit);
    const wcut_photo_point *s = &p->point[r->suspect];
    return wcut_fail(
        error, WCUT_NOT_CONVERGED,
        "points: missed by %.1f px rms, expected at most %.1f; without point %d (u %.1f, v %.1f, x %.6g, y %.6g, z "
        "%.6g) the others fit: check that row",
        r->rms, limit, r->suspect + 1, s->u, s->v, s->place.x, s->place.y, s->place.z);
}

/* a linear start and a fit of all points; limit: [px] rms that is accepted */
static wcut_status fit_camera(const wcut_camera_points *points, double pixel_sigma, double limit, wcut_camera *c,
                              camera_outcome *outcome, wcut_error *error) {
    /* up to PLANE_MAX points determine a plane camera, more of them the whole camera */
    bool mirrored = false;
    wcut_status status = points->count <= PLANE_MAX ? fit_plane(points, pixel_sigma, c, outcome)
                                                    : fit_full(points, c, outcome, &mirrored);

    /* a mirror image is named as such: no other message would lead to it */
    if (status == WCUT_OK && mirrored) {
        status = is_mirror_image(points, c, limit, &mirrored);
        if (status == WCUT_OK && mirrored)
            return fail_points(error,
                               "they are a mirror image of what a camera sees; expected u to the right, v down, and "
                               "places in the block's right-handed frame");
        if (status == WCUT_OK) status = WCUT_NOT_CONVERGED;
    }

    /* what is wrong with the points */
    if (status == WCUT_NOT_CONVERGED)
        return wcut_fail(error, status,
                         "points: no camera sees them so; check that no row is mistyped and no two rows are "
                         "interchanged");
    if (status == WCUT_SINGULAR)
        return fail_points(error,
                           "they do not determine a camera; expected points spread over the picture, no three of four "
                           "on a line");
    return status == WCUT_OK ? status : wcut_fail(error, status, "points: %s", wcut_status_text(status));
}

/* figures of a fit */
static void fill_report(const camera_problem *p, const wcut_camera *c, const camera_outcome *o, double pixel_sigma,
                        const wcut_camera_points *points, wcut_camera_report *r) {
    *r = (wcut_camera_report){.parameters = p->parameters, .iterations = o->iterations, .suspect = -1};
    r->rms = sqrt(o->cost / p->count);
    r->sigma = outcome_sigma(o, pixel_sigma);
    r->flatness = points->spread[2];
    if (c->kind == WCUT_CAMERA_KIND_PLANE) return;
    for (int i = 0; i < p->parameters; i++)
        for (int j = 0; j < p->parameters; j++)
            r->covariance[i * WCUT_CAMERA_PARAMETERS + j] = r->sigma * r->sigma * o->inverse[i * p->parameters + j];
    r->focal_sigma = c->focal * sqrt(r->covariance[6 * WCUT_CAMERA_PARAMETERS + 6]);
}

wcut_status wcut_camera_fit(int count, const wcut_photo_point *point, int width, int height,
                            const wcut_camera_options *options, wcut_camera *camera, wcut_camera_report *report,
                            double *residual, double *leave_one_out, wcut_error *error) {
    const wcut_camera_options o = options ? *options : wcut_camera_options_default();
    if (count < 4 || count > COUNT_MAX || !point || width < 2 || height < 2 || width > 1000000 || height > 1000000 ||
        !camera || !is_positive(o.pixel_sigma) || !isfinite(o.rms_max) || o.rms_max < 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "camera: found %d points of a picture of %d x %d px, expected 4 to %d points", count, width,
                         height, COUNT_MAX);
    wcut_status status = check_points(count, point, width, height, error);
    if (status != WCUT_OK) return status;

    /* the camera of all points */
    wcut_camera_points points;
    wcut_camera_points_measure(count, point, width, height, &points);
    status = check_spread(&points, error);
    if (status != WCUT_OK) return status;
    wcut_camera found = {.width = width, .height = height};
    camera_outcome outcome = {0};
    const double limit = o.rms_max > 0 ? o.rms_max : fmax(2, hypot(width, height) / 1000);
    status = fit_camera(&points, o.pixel_sigma, limit, &found, &outcome, error);
    if (status != WCUT_OK) return status;

    /* each point beside a camera that does not know it */
    camera_problem p = {.count = count, .without = -1, .point = point};
    p.parameters = camera_parameters_of(found.kind, count);
    wcut_camera_report r;
    fill_report(&p, &found, &outcome, o.pixel_sigma, &points, &r);
    double *left = wcut_alloc((size_t)count, sizeof *left);
    if (!left) return wcut_fail(error, WCUT_NO_MEMORY, "points: %s", wcut_status_text(WCUT_NO_MEMORY));
    r.left_out = 2 * (count - 1) > p.parameters;
    if (r.left_out) status = leave_each_out(&p, &found, r.sigma, o.pixel_sigma, left, &r.suspect);
    if (status != WCUT_OK)
        status = wcut_fail(error, status, "points: %s", wcut_status_text(status));
    else if (r.rms > limit)
        status = refuse_misfit(&p, &r, limit, error);

    /* outputs last */
    if (status == WCUT_OK) {
        *camera = found;
        if (report) *report = r;
        if (leave_one_out && r.left_out) memcpy(leave_one_out, left, (size_t)count * sizeof *left);
        for (size_t i = 0; residual && i < (size_t)count; i++) {
            const wcut_pixel seen = wcut_camera_pixel(&found, point[i].place);
            residual[2 * i] = point[i].u - seen.u;
            residual[2 * i + 1] = point[i].v - seen.v;
        }
    }
    wcut_free(left);
    return status;
}
