/* Registration by best fit: a coarse start, then steps on the sample of the scan. */
#include <stdbool.h>

#include "base/fail.h"
#include "base/numbers.h"
#include "scan/mesh_distance.h"
#include "scan/register.h"
#include "scan/register_cloud.h"
#include "scan/register_coarse.h"
#include "scan/span.h"

enum { MIN = WCUT_DOF_COUNT };

static const double FAR = 1e12;

static double distance_rms(const wcut_register_cloud *c, wcut_vec3 pivot) {
    double sum = 0;
    for (int i = 0; i < c->count; i++) {
        const wcut_vec3 p = vec3_sub(c->point[i], pivot);
        sum += vec3_dot(p, p);
    }
    return sqrt(sum / c->count);
}

static bool wants_coarse(const wcut_registration_options *o) {
    for (int k = 0; k < WCUT_DOF_COUNT; k++)
        if (o->dof[k].kind != WCUT_DOF_KIND_FREE) return false;
    return o->coarse;
}

static wcut_status register_fit_solve(wcut_register_cloud *c, const wcut_registration_options *o,
                                      wcut_registration *registration, wcut_error *error) {
    wcut_registration r = wcut_registration_none();
    wcut_vec3 pivot;
    double x[WCUT_DOF_COUNT];
    if (!wcut_spans_plane(c->count, c->point, sizeof *c->point, &pivot))
        return wcut_fail(error, WCUT_DEGENERATE, "scan: its points are in one place or on one line");
    if (o->pivot_given) pivot = o->pivot;

    /* lengths are measured from the pivot; the start is that of the options */
    const double length = distance_rms(c, pivot);
    const wcut_motion stay = wcut_motion_of(pivot, (double[WCUT_DOF_COUNT]){0});
    wcut_register_start(o, x);
    wcut_motion motion = wcut_motion_of(pivot, x);

    /* how close the scan is as it came, then a coarse start where all is free */
    wcut_status status = wcut_register_closeness(c, &stay, &r.rms_before);
    if (status == WCUT_OK && wants_coarse(o))
        status = wcut_register_coarse(c->face, c->count, c->point, length, o, c->threads, &motion, &r.rival);
    if (status != WCUT_OK) return wcut_fail(error, status, "registration: %s", wcut_status_text(status));

    /* the fit itself */
    r.method = WCUT_REGISTRATION_METHOD_FIT;
    r.points = c->count;
    const wcut_register_problem problem = wcut_register_fit_problem(c, o, length);
    status = wcut_register_solve(&problem, &motion, &r);
    if (status == WCUT_DEGENERATE)
        return wcut_fail(error, status, "scan: fewer than %d points over the face, or nothing to be determined", MIN);
    if (status != WCUT_OK && status != WCUT_NOT_CONVERGED)
        return wcut_fail(error, status, "registration: %s", wcut_status_text(status));
    wcut_register_matrix(&motion, r.matrix);
    *registration = r;

    return status == WCUT_OK ? status : wcut_fail(error, status, "registration: stopped after %d steps", r.iterations);
}

static wcut_status register_fit_fit(wcut_register_face face, int count, const wcut_vec3 *point,
                                    const wcut_registration_options *options, int threads,
                                    wcut_registration *registration, wcut_error *error) {
    wcut_registration_options o;
    wcut_register_cloud cloud;
    if (!point || threads < 1 || !registration)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "registration: an argument is missing");
    if (count < MIN)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "scan: found %d points, expected at least %d", count, MIN);

    /* check the options and the points */
    wcut_status status = wcut_register_options(options, &o, error);
    if (status != WCUT_OK) return status;
    for (int i = 0; i < count; i++)
        if (!(fabs(point[i].x) <= FAR && fabs(point[i].y) <= FAR && fabs(point[i].z) <= FAR))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "scan: point %d: expected numbers up to 1e12", i);

    /* fit a sample of the scan */
    status = wcut_register_sample(face, count, point, o.max_points, o.keep, threads, &cloud);
    if (status != WCUT_OK) return wcut_fail(error, status, "registration: %s", wcut_status_text(status));
    status = register_fit_solve(&cloud, &o, registration, error);
    wcut_register_sample_clear(&cloud);

    return status;
}

wcut_status wcut_registration_fit(const wcut_projection *projection, int count, const wcut_vec3 *point,
                                  const wcut_registration_options *options, int threads,
                                  wcut_registration *registration, wcut_error *error) {
    if (!projection) return wcut_fail(error, WCUT_BAD_ARGUMENT, "registration: an argument is missing");
    return register_fit_fit((wcut_register_face){.projection = projection}, count, point, options, threads,
                            registration, error);
}

wcut_status wcut_registration_fit_mesh(const wcut_mesh *mesh, const wcut_mesh_tree *tree, int count,
                                       const wcut_vec3 *point, const wcut_registration_options *options, int threads,
                                       wcut_registration *registration, wcut_error *error) {
    if (!mesh || !tree || mesh->triangle_count != tree->triangles)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "registration: expected a mesh and its tree");
    return register_fit_fit((wcut_register_face){.mesh = mesh, .tree = tree}, count, point, options, threads,
                            registration, error);
}
