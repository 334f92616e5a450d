/* Registration by datums: pairs of points in closed form (Horn 1987), faces that the wire did not cut. */
#include <limits.h>
#include <stdbool.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "base/symmetric.h"
#include "scan/register.h"
#include "scan/register_solve.h"
#include "scan/span.h"

static const double FAR = 1e12;

typedef struct datums {
    int pairs, faces;
    const wcut_datum_pair *pair;
    const wcut_datum_face *face;
} datums;

static double weight_of(double sigma) { return sigma > 0 ? 1 / (sigma * sigma) : 1; }

/* the residuals of pairs, three each, and of the points on faces */
static wcut_status register_datum_residuals(void *data, const wcut_motion *motion, wcut_register_sums *sums) {
    static const wcut_vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const datums *d = data;

    /* pairs: three residuals each, along x, y and z */
    for (int i = 0; i < d->pairs; i++) {
        const wcut_vec3 arm = motion_arm(motion, d->pair[i].scan);
        const wcut_vec3 r = vec3_sub(motion_apply(motion, d->pair[i].scan), d->pair[i].block);
        for (int k = 0; k < 3; k++)
            register_add(sums, weight_of(d->pair[i].sigma), axis[k], vec3_cross(arm, axis[k]), vec3_dot(axis[k], r));
    }

    /* faces: one residual for each point, along the normal */
    for (int i = 0; i < d->faces; i++) {
        const wcut_datum_face *f = &d->face[i];
        const wcut_vec3 n = vec3_unit(f->normal);
        for (int k = 0; k < f->count; k++) {
            const double r = vec3_dot(n, vec3_sub(motion_apply(motion, f->scan[k]), f->point));
            register_add(sums, weight_of(f->sigma), n, vec3_cross(motion_arm(motion, f->scan[k]), n), r);
        }
    }
    sums->overlap = 1;

    return WCUT_OK;
}

/* ---- closed form ---- */

/* the two weighted centroids of the pairs */
static void centre_pairs(const datums *d, wcut_vec3 *scan, wcut_vec3 *block) {
    double weight = 0;
    *scan = *block = vec3(0, 0, 0);
    for (int i = 0; i < d->pairs; i++) {
        const double w = weight_of(d->pair[i].sigma);
        weight += w;
        *scan = vec3_add_scaled(*scan, w, d->pair[i].scan);
        *block = vec3_add_scaled(*block, w, d->pair[i].block);
    }
    *scan = vec3_scale(1 / weight, *scan);
    *block = vec3_scale(1 / weight, *block);
}

/* the rotation of the quaternion that is the greatest eigenvector of Horn's matrix */
static mat3 horn(const datums *d, wcut_vec3 scan, wcut_vec3 block) {
    double s[9] = {0};
    for (int i = 0; i < d->pairs; i++) {
        const wcut_vec3 a = vec3_sub(d->pair[i].scan, scan), b = vec3_sub(d->pair[i].block, block);
        const double w = weight_of(d->pair[i].sigma), left[3] = {a.x, a.y, a.z}, right[3] = {b.x, b.y, b.z};
        for (int k = 0; k < 9; k++) s[k] += w * left[k / 3] * right[k % 3];
    }
    double n[16] = {s[0] + s[4] + s[8], s[5] - s[7],        s[6] - s[2],         s[1] - s[3],
                    s[5] - s[7],        s[0] - s[4] - s[8], s[1] + s[3],         s[6] + s[2],
                    s[6] - s[2],        s[1] + s[3],        -s[0] + s[4] - s[8], s[5] + s[7],
                    s[1] - s[3],        s[6] + s[2],        s[5] + s[7],         -s[0] - s[4] + s[8]};
    double value[4], q[16];
    wcut_symmetric_eigen(4, n, value, q);
    const double w = q[0], x = q[4], y = q[8], z = q[12];
    return (mat3){{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                  {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                  {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
}

/* ---- the whole ---- */

static wcut_status check_sigma(double sigma, int *known, int *unknown, wcut_error *error) {
    if (!(sigma == 0 || is_positive(sigma)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a datum's sigma: found %g, expected a positive number or 0", sigma);
    *known |= sigma > 0;
    *unknown |= !(sigma > 0);
    return WCUT_OK;
}

static bool is_near(wcut_vec3 p) { return vec3_length(p) <= FAR; }

static wcut_status check_face(int i, const wcut_datum_face *f, long long *residual_count, wcut_error *error) {
    if (f->count < 1 || !f->scan)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "face %d: found %d points, expected 1 or more", i, f->count);
    if (!is_near(f->point) || !(vec3_length(f->normal) > 0) || !is_near(f->normal))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "face %d: expected a point and a normal of some length", i);
    for (int k = 0; k < f->count; k++)
        if (!is_near(f->scan[k]))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "face %d, point %d: expected numbers up to 1e12", i, k);
    *residual_count += f->count;
    return WCUT_OK;
}

/* whether sigmas are known is told in `known`; the residuals are at most INT_MAX */
static wcut_status register_datum_check(const datums *d, int *known, int *residual_count, wcut_error *error) {
    int unknown = 0;
    long long count = 3LL * d->pairs;
    *known = 0;
    for (int i = 0; i < d->pairs; i++) {
        if (!is_near(d->pair[i].scan) || !is_near(d->pair[i].block))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "pair %d: expected numbers up to 1e12", i);
        if (check_sigma(d->pair[i].sigma, known, &unknown, error) != WCUT_OK) return WCUT_BAD_ARGUMENT;
    }
    for (int i = 0; i < d->faces; i++) {
        if (check_face(i, &d->face[i], &count, error) != WCUT_OK) return WCUT_BAD_ARGUMENT;
        if (check_sigma(d->face[i].sigma, known, &unknown, error) != WCUT_OK) return WCUT_BAD_ARGUMENT;
    }
    if (*known && unknown)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "some datums have a sigma and others none: expected all or none");
    if (count > INT_MAX) return wcut_fail(error, WCUT_BAD_ARGUMENT, "more datum points than %d", INT_MAX);
    *residual_count = (int)count;
    return WCUT_OK;
}

/* the centroid of all datum points, or what is given; and how far they are from it (RMS) */
static double find_pivot(const datums *d, const wcut_registration_options *o, wcut_vec3 *pivot) {
    wcut_vec3 mean = {0, 0, 0};
    double square = 0, count = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < d->pairs; i++) {
            const wcut_vec3 p = vec3_sub(d->pair[i].scan, *pivot);
            mean = vec3_add(mean, d->pair[i].scan), square += vec3_dot(p, p), count++;
        }
        for (int i = 0; i < d->faces; i++)
            for (int k = 0; k < d->face[i].count; k++) {
                const wcut_vec3 p = vec3_sub(d->face[i].scan[k], *pivot);
                mean = vec3_add(mean, d->face[i].scan[k]), square += vec3_dot(p, p), count++;
            }
        if (pass == 1) break;
        *pivot = o->pivot_given ? o->pivot : vec3_scale(1 / count, mean);
        square = count = 0;
    }
    return square > 0 ? sqrt(square / count) : 1;
}

static bool all_free(const wcut_dof *dof) {
    for (int k = 0; k < WCUT_DOF_COUNT; k++)
        if (dof[k].kind != WCUT_DOF_KIND_FREE) return false;
    return true;
}

/* where Gauss-Newton starts: at the closed form if the pairs ask for it, else at the values */
static wcut_motion register_datum_start(const datums *d, const wcut_registration_options *o, wcut_vec3 pivot) {
    wcut_vec3 scan, block;
    double x[WCUT_DOF_COUNT];
    wcut_register_start(o, x);
    if (d->pairs < 3 || !all_free(o->dof)) return wcut_motion_of(pivot, x);
    centre_pairs(d, &scan, &block);
    if (!wcut_spans_plane(d->pairs, &d->pair->scan, sizeof *d->pair, NULL)) return wcut_motion_of(pivot, x);
    return wcut_motion_between(pivot, horn(d, scan, block), scan, block);
}

wcut_status wcut_registration_solve_datum(int pairs, const wcut_datum_pair *pair, int faces,
                                          const wcut_datum_face *face, const wcut_registration_options *options,
                                          wcut_registration *registration, wcut_error *error) {
    /* check the arguments and the options */
    datums d = {pairs, faces, pair, face};
    wcut_registration_options o;
    int known = 0, count = 0;
    if (pairs < 0 || faces < 0 || pairs + (long long)faces < 1 || (pairs && !pair) || (faces && !face) || !registration)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "datums: found %d pairs and %d faces, expected some", pairs, faces);
    wcut_status status = wcut_register_options(options, &o, error);
    if (status == WCUT_OK) status = register_datum_check(&d, &known, &count, error);
    if (status != WCUT_OK) return status;

    /* the pivot, and lengths from it */
    wcut_vec3 pivot = {0, 0, 0};
    const double length = find_pivot(&d, &o, &pivot);
    wcut_registration r = wcut_registration_none();

    /* residuals before anything is moved */
    wcut_register_sums before = {.weight = 0};
    const wcut_motion stay = wcut_motion_of(pivot, (double[WCUT_DOF_COUNT]){0});
    status = register_datum_residuals(&d, &stay, &before);
    r.method = WCUT_REGISTRATION_METHOD_DATUM;
    r.points = count;
    r.rms_before = sqrt(before.plain / before.used);

    /* the start in closed form, then least squares in all directions that the datums determine */
    wcut_motion motion = register_datum_start(&d, &o, pivot);
    const wcut_register_problem problem = {.model = register_datum_residuals,
                                           .data = &d,
                                           .options = &o,
                                           .length = length,
                                           .noise = known ? 1 : o.noise,
                                           .consistency = 1,
                                           .max_iterations = o.max_iterations};

    if (status == WCUT_OK) status = wcut_register_solve(&problem, &motion, &r);
    if (status != WCUT_OK && status != WCUT_NOT_CONVERGED)
        return wcut_fail(error, status,
                         "datums: nothing to be determined, or sigmas unknown and no residual more than unknowns");

    /* the noise is known: it is not estimated */
    if (known) r.noise = 0;
    wcut_register_matrix(&motion, r.matrix);
    *registration = r;

    return status == WCUT_OK ? status : wcut_fail(error, status, "datums: stopped after %d steps", r.iterations);
}

/* ---- what is left ---- */

static bool is_finite_point(wcut_vec3 p) { return isfinite(p.x) && isfinite(p.y) && isfinite(p.z); }

static bool are_datums(int pairs, const wcut_datum_pair *pair, int faces, const wcut_datum_face *face) {
    if (pairs < 0 || faces < 0 || (pairs > 0 && !pair) || (faces > 0 && !face)) return false;
    for (int k = 0; k < pairs; k++)
        if (!is_finite_point(pair[k].scan) || !is_finite_point(pair[k].block)) return false;
    for (int k = 0; k < faces; k++) {
        const wcut_datum_face *f = &face[k];
        if (f->count < 1 || !f->scan || !is_finite_point(f->point) || !is_finite_point(f->normal) ||
            !(vec3_length(f->normal) > 0))
            return false;
        for (int i = 0; i < f->count; i++)
            if (!is_finite_point(f->scan[i])) return false;
    }
    return true;
}

wcut_status wcut_datum_residual_eval(const wcut_registration *registration, int pairs, const wcut_datum_pair *pair,
                                     int faces, const wcut_datum_face *face, wcut_datum_residual *residual) {
    if (!registration || !residual || !are_datums(pairs, pair, faces, face)) return WCUT_BAD_ARGUMENT;
    wcut_datum_residual *to = residual;

    /* pairs: from the block's point to the moved one */
    for (int k = 0; k < pairs; k++, to++) {
        *to = (wcut_datum_residual){.datum = k, .moved = pair[k].scan};
        (void)wcut_registration_move(registration, 1, &to->moved, NULL);
        to->offset = vec3_sub(to->moved, pair[k].block);
        to->distance = vec3_length(to->offset);
    }

    /* faces: along the normal alone */
    for (int k = 0; k < faces; k++) {
        const wcut_vec3 normal = vec3_unit(face[k].normal);
        for (int i = 0; i < face[k].count; i++, to++) {
            *to = (wcut_datum_residual){.is_face = 1, .datum = k, .moved = face[k].scan[i]};
            (void)wcut_registration_move(registration, 1, &to->moved, NULL);
            to->distance = vec3_dot(normal, vec3_sub(to->moved, face[k].point));
            to->offset = vec3_scale(to->distance, normal);
        }
    }

    return WCUT_OK;
}
