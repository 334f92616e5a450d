/* wirecut/vec3.h - a point or a vector; an array of them is an n x 3 row-major matrix. */
#ifndef WCUT_VEC3_H
#define WCUT_VEC3_H

/** A point [mm], a force [N] or a direction [1]. */
typedef struct wcut_vec3 {
    double x, y, z;
} wcut_vec3;

#endif
