/* Clouds whose surface is known: what the tests of cleaning and normals start from. */
#ifndef WCUT_TESTS_SCAN_SHEETS_H
#define WCUT_TESTS_SCAN_SHEETS_H

#include <math.h>
#include <string.h>
#include <wirecut/cloud.h>

#include "base/random.h"
#include "base/vec3.h"
#include "test.h"

/* a saddle over [0, 400] x [0, 1200] mm; its slope is at most `slope` */
static inline double saddle_height(double x, double y, double slope) {
    return 150 + slope * (x - 200) * (y - 600) / hypot(200, 600);
}

static inline wcut_vec3 saddle_normal(double x, double y, double slope) {
    const double size = hypot(200, 600);
    return vec3_unit(vec3(-slope * (y - 600) / size, -slope * (x - 200) / size, 1));
}

/* count points at random places of the saddle, moved along z by a normal deviate of `noise` [mm] */
static inline void given_saddle(int count, double slope, double noise, uint64_t seed, wcut_vec3 *point) {
    wcut_random r = wcut_random_seed(seed);
    for (int k = 0; k < count; k++) {
        const double x = 400 * wcut_random_uniform(&r), y = 1200 * wcut_random_uniform(&r);
        point[k] = vec3(x, y, saddle_height(x, y, slope) + noise * wcut_random_normal(&r));
    }
}

/* a regular lattice of rows x columns, `step` mm apart, on the saddle of slope 0.5 */
static inline void given_lattice(int rows, int columns, double step, wcut_vec3 *point) {
    for (int k = 0; k < rows * columns; k++) {
        const double x = step * (k % columns), y = step * (k / columns);
        point[k] = vec3(x, y, saddle_height(x, y, 0.5));
    }
}

#endif
