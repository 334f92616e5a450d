/* Vectors in space. */
#ifndef WCUT_BASE_VEC3_H
#define WCUT_BASE_VEC3_H

#include <math.h>
#include <stdbool.h>
#include <wirecut/vec3.h>

static inline wcut_vec3 vec3(double x, double y, double z) { return (wcut_vec3){x, y, z}; }

static inline wcut_vec3 vec3_add(wcut_vec3 a, wcut_vec3 b) { return vec3(a.x + b.x, a.y + b.y, a.z + b.z); }

static inline wcut_vec3 vec3_sub(wcut_vec3 a, wcut_vec3 b) { return vec3(a.x - b.x, a.y - b.y, a.z - b.z); }

static inline wcut_vec3 vec3_scale(double s, wcut_vec3 a) { return vec3(s * a.x, s * a.y, s * a.z); }

/* a + s b */
static inline wcut_vec3 vec3_add_scaled(wcut_vec3 a, double s, wcut_vec3 b) {
    return vec3(a.x + s * b.x, a.y + s * b.y, a.z + s * b.z);
}

/* (1 - t) a + t b */
static inline wcut_vec3 vec3_mix(wcut_vec3 a, wcut_vec3 b, double t) {
    return vec3_add_scaled(vec3_scale(1 - t, a), t, b);
}

static inline double vec3_dot(wcut_vec3 a, wcut_vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

static inline wcut_vec3 vec3_cross(wcut_vec3 a, wcut_vec3 b) {
    return vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double vec3_length(wcut_vec3 a) { return sqrt(vec3_dot(a, a)); }

static inline double vec3_distance(wcut_vec3 a, wcut_vec3 b) { return vec3_length(vec3_sub(a, b)); }

/* a / |a|, or zero where a is zero */
static inline wcut_vec3 vec3_unit(wcut_vec3 a) {
    double length = vec3_length(a);
    return length > 0 ? vec3_scale(1 / length, a) : vec3(0, 0, 0);
}

static inline bool vec3_is_finite(wcut_vec3 a) { return isfinite(a.x) && isfinite(a.y) && isfinite(a.z); }

static inline bool vec3_all_finite(int n, const wcut_vec3 *a) {
    for (int i = 0; i < n; i++)
        if (!vec3_is_finite(a[i])) return false;
    return true;
}

#endif
