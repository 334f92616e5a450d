/* 3 x 3 matrices: the derivative of one vector by another. */
#ifndef WCUT_BASE_MAT3_H
#define WCUT_BASE_MAT3_H

#include "base/vec3.h"

typedef struct mat3 {
    wcut_vec3 x, y, z; /* rows */
} mat3;

/* a + u v^T */
static inline mat3 mat3_add_outer(mat3 a, wcut_vec3 u, wcut_vec3 v) {
    return (mat3){vec3_add_scaled(a.x, u.x, v), vec3_add_scaled(a.y, u.y, v), vec3_add_scaled(a.z, u.z, v)};
}

/* a + s I */
static inline mat3 mat3_add_identity(mat3 a, double s) {
    a.x.x += s, a.y.y += s, a.z.z += s;
    return a;
}

static inline mat3 mat3_add(mat3 a, mat3 b) {
    return (mat3){vec3_add(a.x, b.x), vec3_add(a.y, b.y), vec3_add(a.z, b.z)};
}

/* a v */
static inline wcut_vec3 mat3_times(mat3 a, wcut_vec3 v) {
    return vec3(vec3_dot(a.x, v), vec3_dot(a.y, v), vec3_dot(a.z, v));
}

/* u^T a */
static inline wcut_vec3 mat3_row_product(wcut_vec3 u, mat3 a) {
    return vec3_add_scaled(vec3_add_scaled(vec3_scale(u.x, a.x), u.y, a.y), u.z, a.z);
}

#endif
