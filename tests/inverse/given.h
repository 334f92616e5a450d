/* What the tests of targets and designs share: a process, heights over a block of 400 x 600 x 300 mm, targets of them. */
#ifndef WCUT_TESTS_INVERSE_GIVEN_H
#define WCUT_TESTS_INVERSE_GIVEN_H

#include <wirecut/wirecut.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"

enum { GRID_X = 25, GRID_Y = 37 };

static const wcut_vec3 given_block = {400, 600, 300};

static inline double saddle(double x, double y) { return 150 + 4e-4 * ((x - 200) * (x - 200) - (y - 300) * (y - 300)); }

static inline double dome(double x, double y) {
    return 150 - 4e-4 * ((x - 200) * (x - 200) + (y - 300) * (y - 300)) / 2;
}

/* wire, heat and force law of the working set */
static inline wcut_job *given_process(int stations, int nodes) {
    wcut_job *job = NULL;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->block_size = given_block;
    job->wire_diameter = 0.15;
    job->stations = stations, job->nodes = nodes;
    job->heat = 65, job->tension = 2;
    job->force_law = (wcut_force_law){.a = 0.1, .b = 8.6e-4};
    job->clearance = 80;
    return job;
}

/* a surface of heights, 40 mm beyond the block's sides */
static inline wcut_surface *given_surface(double (*height)(double, double)) {
    static wcut_vec3 grid[GRID_X * GRID_Y];
    wcut_surface *surface = NULL;
    for (int j = 0; j < GRID_Y; j++)
        for (int i = 0; i < GRID_X; i++) {
            const double x = -40 + 480.0 * i / (GRID_X - 1), y = -40 + 680.0 * j / (GRID_Y - 1);
            grid[j * GRID_X + i] = vec3(x, y, height(x, y));
        }
    ck_assert_int_eq(wcut_surface_loft(GRID_Y, GRID_X, grid, 1e-3, &surface, NULL, NULL), WCUT_OK);
    return surface;
}

static inline wcut_design_target *given_target(double (*height)(double, double)) {
    wcut_surface *surface = given_surface(height);
    wcut_design_target *target = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_design_target_from_surface(surface, given_block, &target, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    wcut_surface_destroy(surface);
    return target;
}

#endif
