/* A rigid motion from a scan into the block's frame: options, the identity, and moving points by a matrix. */
#include "scan/register.h"

#include <string.h>

#include "base/fail.h"
#include "base/numbers.h"

static const double FAR = 1e12;
static const char *const dof_name[WCUT_DOF_COUNT] = {"tx", "ty", "tz", "rx", "ry", "rz"};

wcut_registration_options wcut_registration_options_default(void) {
    return (wcut_registration_options){
        .keep = 0.9, .coarse = 1, .max_points = 20000, .sensitivity = 0.003, .tolerance = 1e-7, .max_iterations = 200};
}

wcut_registration wcut_registration_none(void) {
    return (wcut_registration){.matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, .converged = 1};
}

static wcut_status check_dofs(const wcut_dof *dof, wcut_error *error) {
    for (int k = 0; k < WCUT_DOF_COUNT; k++) {
        const wcut_dof_kind kind = dof[k].kind;
        if (kind != WCUT_DOF_KIND_FREE && kind != WCUT_DOF_KIND_LOCKED && kind != WCUT_DOF_KIND_PRIOR)
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: kind %d, expected free, locked or prior", dof_name[k],
                             (int)kind);
        if (!(fabs(dof[k].value) <= FAR))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: value %g, expected a number", dof_name[k], dof[k].value);
        if (kind == WCUT_DOF_KIND_PRIOR && !is_positive(dof[k].sigma))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s: sigma %g, expected a positive number", dof_name[k],
                             dof[k].sigma);
    }
    if (!(vec3_length(vec3(dof[WCUT_DOF_RX].value, dof[WCUT_DOF_RY].value, dof[WCUT_DOF_RZ].value)) < WCUT_PI))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "rx, ry, rz: a rotation vector of pi or longer");
    return WCUT_OK;
}

wcut_status wcut_register_options(const wcut_registration_options *given, wcut_registration_options *options,
                                  wcut_error *error) {
    const wcut_registration_options o = given ? *given : wcut_registration_options_default();
    const wcut_status status = check_dofs(o.dof, error);
    if (status != WCUT_OK) return status;
    if (o.pivot_given && !(vec3_length(o.pivot) <= FAR))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "pivot: expected numbers up to 1e12");
    if (!(o.noise == 0 || is_positive(o.noise)) || !is_positive(o.tolerance) || o.max_iterations < 1)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "noise, tolerance, max_iterations: expected positive numbers");
    if (!(o.keep >= 0.5 && o.keep <= 1))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "keep: found %g, expected 0.5 to 1", o.keep);
    if (!(o.sensitivity >= 1e-6 && o.sensitivity <= 0.5))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "sensitivity: found %g, expected 1e-6 to 0.5", o.sensitivity);
    if (o.max_points < 100)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "max_points: found %d, expected 100 or more", o.max_points);
    *options = o;
    return WCUT_OK;
}

void wcut_register_start(const wcut_registration_options *o, double *x) {
    for (int k = 0; k < WCUT_DOF_COUNT; k++) x[k] = o->dof[k].value;
}

void wcut_register_matrix(const wcut_motion *motion, double *matrix) {
    const wcut_vec3 zero = motion_apply(motion, vec3(0, 0, 0));
    const wcut_vec3 row[3] = {motion->rotation.x, motion->rotation.y, motion->rotation.z};
    const double shift[3] = {zero.x, zero.y, zero.z};
    double m[16] = {0};
    for (int k = 0; k < 3; k++) {
        double *to = m + (size_t)4 * (size_t)k;
        to[0] = row[k].x, to[1] = row[k].y, to[2] = row[k].z;
        to[3] = shift[k];
    }
    m[15] = 1;
    memcpy(matrix, m, sizeof m);
}

wcut_status wcut_registration_move(const wcut_registration *registration, int count, wcut_vec3 *point,
                                   wcut_vec3 *normal) {
    if (!registration || count < 0 || (count && !point)) return WCUT_BAD_ARGUMENT;
    const double *m = registration->matrix;
    const mat3 turn = {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}};
    const wcut_vec3 shift = {m[3], m[7], m[11]};
    for (int i = 0; i < count; i++) {
        point[i] = vec3_add(mat3_times(turn, point[i]), shift);
        if (normal) normal[i] = mat3_times(turn, normal[i]);
    }
    return WCUT_OK;
}
