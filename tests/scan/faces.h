/* Simulated faces with known scans of them: what the tests of registration and reconstruction start from. */
#ifndef WCUT_TESTS_SCAN_FACES_H
#define WCUT_TESTS_SCAN_FACES_H

#include <math.h>
#include <wirecut/projection.h>
#include <wirecut/surface.h>

#include "base/numbers.h"
#include "base/random.h"
#include "base/vec3.h"
#include "test.h"

/* a face of a double curved cut over 400 x 600 mm, without symmetry */
static inline double wavy_height(double x, double y) {
    return 150 + 30 * sin(0.011 * y + 0.004 * x) + 20 * cos(0.013 * x - 0.003 * y) + 1e-6 * x * x * y;
}

static inline double flat_height(double x, double y) {
    (void)x, (void)y;
    return 150;
}

/* the face z = height(x, y) over 0 .. 400, 0 .. 600 mm, as lofts are: u along x, v along y */
static inline wcut_surface *given_face(double (*height)(double, double)) {
    enum { NODES = 41, STATIONS = 61 };
    static wcut_vec3 node[NODES * STATIONS];
    for (int j = 0; j < STATIONS; j++)
        for (int i = 0; i < NODES; i++) {
            const double x = 400.0 * i / (NODES - 1), y = 600.0 * j / (STATIONS - 1);
            node[j * NODES + i] = vec3(x, y, height(x, y));
        }
    wcut_surface *surface = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, node, 1e-3, &surface, NULL, NULL), WCUT_OK);
    return surface;
}

static inline wcut_projection *given_projection(const wcut_surface *surface) {
    wcut_projection *projection = NULL;
    ck_assert_int_eq(wcut_projection_create(surface, &projection), WCUT_OK);
    return projection;
}

/* the point of the face at u, v, moved by `height` [mm] along its normal */
static inline wcut_vec3 above(const wcut_surface *surface, double u, double v, double height) {
    wcut_vec3 d[4];
    ck_assert_int_eq(wcut_surface_eval(surface, u, v, 1, d), WCUT_OK);
    return vec3_add_scaled(d[0], height, vec3_unit(vec3_cross(d[2], d[1])));
}

/* count points at random places of the face, `margin` [1] away from its border, with normal noise along the normal */
static inline void given_scan(const wcut_surface *surface, int count, double margin, double noise, uint64_t seed,
                              wcut_vec3 *point) {
    wcut_random r = wcut_random_seed(seed);
    for (int k = 0; k < count; k++) {
        const double u = margin + (1 - 2 * margin) * wcut_random_uniform(&r);
        const double v = margin + (1 - 2 * margin) * wcut_random_uniform(&r);
        point[k] = above(surface, u, v, noise > 0 ? noise * wcut_random_normal(&r) : 0);
    }
}

#endif
