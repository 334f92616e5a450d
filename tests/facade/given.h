/* What the tests of facades share: a job of a small block, fields, a plan on a plane, faces of given heights. */
#ifndef WCUT_TESTS_FACADE_GIVEN_H
#define WCUT_TESTS_FACADE_GIVEN_H

#include <math.h>
#include <string.h>
#include <wirecut/facade.h>

#include "test.h"

enum { N = WCUT_FACADE_SAMPLES, END = N - 1, POINTS = N * N };

/* a design of a block of W x L x H mm whose edges are straight at half its height */
static inline wcut_job *flat_job(double w, double l, double h) {
    wcut_job *job = NULL;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    const wcut_vec3 a[3] = {{0, 0, h / 2}, {0, l / 2, h / 2}, {0, l, h / 2}};
    const wcut_vec3 b[3] = {{w, 0, h / 2}, {w, l / 2, h / 2}, {w, l, h / 2}};
    job->block_size = (wcut_vec3){w, l, h};
    job->mode = WCUT_MODE_DESIGN;
    job->stations = 21, job->nodes = 21;
    ck_assert_int_eq(wcut_curve_interpolate(3, a, &job->edge_a), WCUT_OK);
    ck_assert_int_eq(wcut_curve_interpolate(3, b, &job->edge_b), WCUT_OK);
    job->extra_count = 1;
    job->extra_u = wcut_alloc(1, sizeof(double));
    job->extra_length = wcut_alloc(1, sizeof(double));
    job->extra_length[0] = 2;
    return job;
}

/* every cell of a plane lattice, with one job */
typedef struct given_plan {
    wcut_facade_plan plan;
    wcut_facade_placement placement[64];
    const wcut_job *job[2];
    wcut_facade_field height[1], extra[1];
} given_plan;

static inline void give_plan(given_plan *g, const wcut_job *job, int rows, int columns) {
    memset(g, 0, sizeof *g);
    g->job[0] = job;
    g->height[0] = (wcut_facade_field){.kind = WCUT_FACADE_FIELD_SINE,
                                       .value = job->block_size.z / 2,
                                       .amplitude = 20,
                                       .period = 700,
                                       .direction = 0.6};
    g->extra[0] = (wcut_facade_field){.kind = WCUT_FACADE_FIELD_CONSTANT, .value = 2};
    for (int k = 0; k < rows * columns; k++)
        g->placement[k] = (wcut_facade_placement){.row = k / columns, .column = k % columns};
    g->plan = (wcut_facade_plan){.rows = rows,
                                 .columns = columns,
                                 .match = WCUT_FACADE_MATCH_EDGE,
                                 .match_move = 5,
                                 .placements = rows * columns,
                                 .placement = g->placement,
                                 .jobs = 1,
                                 .job = g->job,
                                 .heights = 1,
                                 .height = g->height,
                                 .extras = 1,
                                 .extra = g->extra,
                                 .overrun = -1};
}

/* a wire's surface over a block and around it, as a graph: the height of (x, y) */
typedef double (*given_height)(double x, double y);
static inline wcut_surface *graph(wcut_vec3 block, given_height height) {
    enum { STATIONS = 41, NODES = 31 };
    wcut_vec3 *p = wcut_alloc(STATIONS * NODES, sizeof *p);
    for (int k = 0; k < STATIONS * NODES; k++) {
        const int row = k / NODES, column = k % NODES;
        const double x = -20 + (block.x + 40) * column / (NODES - 1), y = -20 + (block.y + 40) * row / (STATIONS - 1);
        p[k] = (wcut_vec3){x, y, height(x, y)};
    }
    wcut_surface *s = NULL;
    ck_assert_int_eq(wcut_surface_loft(STATIONS, NODES, p, 1e-3, &s, NULL, NULL), WCUT_OK);
    wcut_free(p);
    return s;
}

#endif
