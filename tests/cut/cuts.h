/* What the tests of whole cuts share: jobs made in place, runs, and what a station asks of its mounts. */
#ifndef WCUT_TESTS_CUT_CUTS_H
#define WCUT_TESTS_CUT_CUTS_H

#include <stdio.h>
#include <string.h>
#include <wirecut/cut.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"

#define SAMPLE_JOBS WCUT_SOURCE_DIR "/samples/jobs/"

/* A path-mode job of the working constants without its path: block W x 1200 x 300 mm, 2 N, 65 W/m. */
static inline wcut_job *job_without_path(double width, double wire_length, int nodes, int stations) {
    wcut_job *job;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->block_size = vec3(width, 1200, 300);
    job->wire_diameter = 0.15;
    job->wire_length = wire_length;
    job->nodes = nodes;
    job->heat = 65;
    job->tension = 2;
    job->force_law = (wcut_force_law){.a = 0.1, .b = 8.6e-4};
    job->stations = stations;
    job->mount_a = wcut_alloc((size_t)stations, sizeof *job->mount_a);
    job->mount_b = wcut_alloc((size_t)stations, sizeof *job->mount_b);
    ck_assert(job->mount_a && job->mount_b);
    return job;
}

/* Both mounts `beside` mm beside the block, straight along y from `first` to `last`. */
static inline wcut_job *straight_job(double width, double beside, double wire_length, int nodes, int stations,
                                     double first, double last) {
    wcut_job *job = job_without_path(width, wire_length, nodes, stations);
    for (int j = 0; j < stations; j++) {
        const double y = first + (last - first) * j / (stations - 1);
        job->mount_a[j] = vec3(-beside, y, 150);
        job->mount_b[j] = vec3(width + beside, y, 150);
    }
    return job;
}

/* The mounts approach each other on smooth curves in space while the wire is in the foam: nothing is steady. */
static inline wcut_job *swinging_job(int nodes, int stations) {
    wcut_job *job = job_without_path(400, 620, nodes, stations);
    for (int j = 0; j < stations; j++) {
        const double u = (double)j / (stations - 1);
        job->mount_a[j] = vec3(-100 + 40 * u * u, 150 + 260 * u, 150 + 30 * sin(2 * u));
        job->mount_b[j] = vec3(505 - 50 * u, 150 + 220 * u + 30 * u * u, 140 - 40 * u * u);
    }
    return job;
}

static inline wcut_setup *setup_of(const wcut_job *job, const wcut_cut_options *options) {
    wcut_setup *setup = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_setup_create(job, options, &setup, &error);
    ck_assert_msg(status == WCUT_OK, "%s: %s", job->name, error.text);
    return setup;
}

static inline wcut_history *run_of(const wcut_job *job) {
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *history = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_setup_run(setup, NULL, NULL, &history, &error);
    ck_assert_msg(status == WCUT_OK, "%s: %s", job->name, error.text);
    ck_assert_int_eq(history->stations, wcut_setup_stations(setup).stations);
    wcut_setup_destroy(setup);
    return history;
}

static inline wcut_job *sample_job(const char *name) {
    char path[1000];
    snprintf(path, sizeof path, "%s%s", SAMPLE_JOBS, name);
    wcut_job *job = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_job_read(path, &job, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return job;
}

static inline const wcut_vec3 *nodes_at(const wcut_history *h, int station) {
    return h->position + (size_t)station * (size_t)h->nodes;
}

static inline const wcut_vec3 *forces_at(const wcut_history *h, int station) {
    return h->force + (size_t)station * (size_t)h->nodes;
}

static inline const double *tensions_at(const wcut_history *h, int station) {
    return h->tension + (size_t)station * (size_t)(h->nodes - 1);
}

/* the left side of (4) over |t_0 + t_{n-1}|: the tension that the foam's force asks for [N] */
static inline double pull_at(const wcut_history *h, int station) {
    const int n = h->nodes;
    const wcut_vec3 *x = nodes_at(h, station), *f = forces_at(h, station);
    wcut_vec3 sum = {0, 0, 0};
    for (int i = 0; i < n; i++) sum = vec3_add(sum, f[i]);
    const wcut_vec3 a = vec3_add_scaled(vec3_add_scaled(vec3_scale(3, x[0]), -4, x[1]), 1, x[2]);
    const wcut_vec3 b = vec3_add_scaled(vec3_add_scaled(vec3_scale(3, x[n - 1]), -4, x[n - 2]), 1, x[n - 3]);
    return vec3_length(sum) / vec3_length(vec3_add(vec3_unit(a), vec3_unit(b)));
}

/* largest distance of equal nodes [mm] */
static inline double shape_difference(int n, const wcut_vec3 *a, const wcut_vec3 *b) {
    double worst = 0;
    for (int i = 0; i < n; i++) worst = fmax(worst, vec3_distance(a[i], b[i]));
    return worst;
}

#endif
