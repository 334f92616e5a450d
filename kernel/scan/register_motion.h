/* A rigid motion in six numbers: a shift and a rotation vector about a pivot. */
#ifndef WCUT_SCAN_REGISTER_MOTION_H
#define WCUT_SCAN_REGISTER_MOTION_H

#include <wirecut/registration.h>

#include "base/mat3.h"

/* p -> R(x[3..5]) (p - pivot) + pivot + x[0..2] */
typedef struct wcut_motion {
    wcut_vec3 pivot;
    double x[WCUT_DOF_COUNT];
    mat3 rotation; /* R, of wcut_motion_of */
} wcut_motion;

/* the motion of six numbers (Rodrigues 1840) */
wcut_motion wcut_motion_of(wcut_vec3 pivot, const double *x);

/* the motion p -> R (p - from) + to, its rotation vector not longer than pi */
wcut_motion wcut_motion_between(wcut_vec3 pivot, mat3 rotation, wcut_vec3 from, wcut_vec3 to);

/* d(R q) = (J dw) x (R q): J, 3 x 3, of a rotation vector w */
mat3 wcut_motion_jacobian(const double *w);

/* R (p - pivot) */
static inline wcut_vec3 motion_arm(const wcut_motion *m, wcut_vec3 p) {
    return mat3_times(m->rotation, vec3_sub(p, m->pivot));
}

static inline wcut_vec3 motion_apply(const wcut_motion *m, wcut_vec3 p) {
    return vec3_add(vec3_add(motion_arm(m, p), m->pivot), vec3(m->x[0], m->x[1], m->x[2]));
}

#endif
