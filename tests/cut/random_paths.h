/* Random paths of a slack wire whose ends run at different heights and speeds, one of them backwards for a moment. */
#ifndef WCUT_TESTS_CUT_RANDOM_PATHS_H
#define WCUT_TESTS_CUT_RANDOM_PATHS_H

#include "base/random.h"
#include "cut/cuts.h"

enum { RANDOM_LEVELS = 3, RANDOM_STATIONS = 241 };

static inline double between(wcut_random *r, double low, double high) {
    return low + (high - low) * wcut_random_uniform(r);
}

/* one end's course: where it is at u = 0 .. 1 */
typedef struct random_course {
    double x, y, z, aside, lag, back, rise[2], swing, turns;
} random_course;

static inline random_course course_of(wcut_random *r, double x, bool backwards) {
    random_course c = {.x = x, .turns = backwards ? 3 : 2};
    c.y = between(r, -15, 0), c.z = between(r, 110, 190);
    c.aside = between(r, -10, 30) * (x < 0 ? 1 : -1), c.lag = between(r, -60, 60);
    c.back = backwards ? between(r, 0, 10) : 0;
    c.rise[0] = between(r, -40, 40), c.rise[1] = between(r, -40, 40);
    c.swing = between(r, -17, 17);
    return c;
}

static inline wcut_vec3 course_at(const random_course *c, double u) {
    return vec3(c->x + c->aside * u, c->y + 700 * u + c->lag * u * (1 - u) + c->back * expm1(-200 * u),
                c->z + c->rise[0] * u + c->rise[1] * u * u + c->swing * sin(c->turns * u));
}

/* The path of a seed, sampled; the wire is 3 to 25 % longer than the distance of its ends at the start. */
static inline wcut_job *random_path(int seed, int stations) {
    wcut_random r = wcut_random_seed((uint64_t)seed);
    wcut_job *job = job_without_path(400, 1, 61, stations);
    job->block_size.y = 600;
    job->heat = between(&r, 60, 85);
    const random_course a = course_of(&r, between(&r, -120, -60), true);
    const random_course b = course_of(&r, between(&r, 460, 520), false);
    job->wire_length = between(&r, 1.03, 1.25) * vec3_distance(course_at(&a, 0), course_at(&b, 0));
    for (int i = 0; i <= RANDOM_STATIONS; i++) {
        const double u = (double)i / RANDOM_STATIONS;
        job->wire_length = fmax(job->wire_length, 1.02 * vec3_distance(course_at(&a, u), course_at(&b, u)));
    }
    for (int j = 0; j < stations; j++) {
        const double u = (double)j / (stations - 1);
        job->mount_a[j] = course_at(&a, u), job->mount_b[j] = course_at(&b, u);
    }
    return job;
}

/* largest distance of equal nodes over the block, station j of `count` in both histories [mm] */
static inline double apart_over_block(const wcut_history *g, const wcut_history *h, int j, int count) {
    const wcut_vec3 *x = nodes_at(g, j * (g->stations - 1) / count), *y = nodes_at(h, j * (h->stations - 1) / count);
    double worst = 0;
    for (int i = 0; i < g->nodes; i++)
        if (x[i].x > 0 && x[i].x < 400) worst = fmax(worst, vec3_distance(x[i], y[i]));
    return worst;
}

/* One path at 241, 481 and 961 stations: the runs that found no equilibrium; apart [mm]: how far each two successive
   runs are from each other at most, from the first millimetre of the block on; -1 where one failed. */
static inline int run_random_path(int seed, double apart[RANDOM_LEVELS - 1]) {
    wcut_history *h[RANDOM_LEVELS] = {0};
    bool whole[RANDOM_LEVELS];
    int failed = 0;
    for (int k = 0; k < RANDOM_LEVELS; k++) {
        wcut_job *job = random_path(seed, (RANDOM_STATIONS - 1) * (1 << k) + 1);
        wcut_setup *setup = setup_of(job, NULL);
        whole[k] = wcut_setup_run(setup, NULL, NULL, &h[k], NULL) == WCUT_OK;
        failed += !whole[k];
        wcut_setup_destroy(setup);
        wcut_job_destroy(job);
    }

    for (int k = 0; k + 1 < RANDOM_LEVELS; k++) {
        apart[k] = whole[k] && whole[k + 1] ? 0 : -1;
        if (apart[k] < 0) continue;
        int first = 0;
        while (h[k]->row[first].phase == WCUT_PHASE_APPROACH) first++;
        for (int j = first / (1 << k) + 2; j < 200; j++)
            apart[k] = fmax(apart[k], apart_over_block(h[k], h[k + 1], j, RANDOM_STATIONS - 1));
    }
    for (int k = 0; k < RANDOM_LEVELS; k++) wcut_history_destroy(h[k]);
    return failed;
}

#endif
