/* The sample jobs: cut to their ends without a wobble, their phases, and where along the wire the foam loads it
   (Rust et al. 2016, 2.5). labels: unit property plain */
#include "cut/cuts.h"
#include "cut/wobble.h"
#include "test.h"

static const char *const all_jobs[] = {
    "freeform-1.json",    "freeform-2.json",    "freeform-3.json",    "freeform-4.json",
    "steady-300-50.json", "steady-300-60.json", "steady-300-70.json", "steady-300-85.json",
    "steady-400-50.json", "steady-400-60.json", "steady-400-70.json", "steady-400-85.json",
    "steady-500-50.json", "steady-500-60.json", "steady-500-70.json", "steady-500-85.json"};

enum { JOBS = sizeof all_jobs / sizeof *all_jobs };

static void run_one(const char *name, int stations) {
    wcut_job *job = sample_job(name);
    ck_assert_int_eq(wcut_job_resample(job, stations), WCUT_OK);
    wcut_history *h = run_of(job);
    ck_assert_int_ge(h->stations, stations);
    for (int j = 0; j < h->stations; j++) ck_assert_double_le(h->row[j].residual, 1e-10);
    /* a design's wire comes loose to the block, and its path bends where the way out begins: in between */
    wcut_setup *setup = setup_of(job, NULL);
    const bool design = job->mode == WCUT_MODE_DESIGN;
    h->stations = wcut_setup_stations(setup).part_last + 1;
    wcut_setup_destroy(setup);
    const wobble w = wobble_of(h, design ? 8 : 0);
    ck_assert_msg(w.speed < 0.01 && w.angle < 1e-4 && w.force < 3e-3, "%s, %d stations: %g %g %g", name, stations,
                  w.speed, w.angle, w.force);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST_EACH(every_sample_job_is_cut_to_its_end_without_a_wobble_at_60_stations, JOBS) { run_one(all_jobs[_i], 60); }

TEST_EACH(every_sample_job_is_cut_to_its_end_without_a_wobble_at_300_stations, JOBS) { run_one(all_jobs[_i], 300); }

TEST(the_phases_follow_each_other_and_the_planned_geometry) {
    wcut_job *job = sample_job("steady-400-60.json");
    wcut_history *h = run_of(job);
    double first[5], last[5]; /* y of the mounts at a phase's ends */
    for (int p = 0; p < 5; p++) first[p] = last[p] = NAN;
    for (int j = 0; j < h->stations; j++) {
        const int p = (int)h->row[j].phase;
        if (j > 0) ck_assert_int_ge(p, (int)h->row[j - 1].phase);
        if (isnan(first[p])) first[p] = job->mount_a[j].y;
        last[p] = job->mount_a[j].y;
    }
    ck_assert_double_eq(first[WCUT_PHASE_APPROACH], -6);
    ck_assert_double_eq_tol(first[WCUT_PHASE_ENTRY], 6, 4); /* 6 mm of sag behind the mounts at most */
    ck_assert_double_eq_tol(first[WCUT_PHASE_STEADY], 300,
                            16); /* the mounts approach each other up to y = 300, ever less */
    ck_assert_double_eq_tol(last[WCUT_PHASE_STEADY], 900, 16); /* and part from y = 900 on, ever more */
    ck_assert_double_gt(first[WCUT_PHASE_LEFT], 1200);
    ck_assert_double_lt(first[WCUT_PHASE_LEFT], 1200 + 20);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

/* force across the wire per engaged length, in the mean over a part of the block's width */
static double mean_line(const wcut_history *h, int j, double from, double to) {
    const wcut_vec3 *x = nodes_at(h, j);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < h->nodes; i++)
        if (x[i].x >= from && x[i].x <= to) sum += h->force_line[(size_t)j * (size_t)h->nodes + (size_t)i], count++;
    return sum / count;
}

/* outer tenths of the width over the middle fifth, where the mounts are at y */
static double outer_over_centre(const wcut_job *job, const wcut_history *h, double y) {
    int j = 0;
    while (job->mount_a[j].y < y) j++;
    const double w = job->block_size.x;
    return (mean_line(h, j, 0.01 * w, 0.1 * w) + mean_line(h, j, 0.9 * w, 0.99 * w)) / 2 /
           mean_line(h, j, 0.4 * w, 0.6 * w);
}

TEST(entering_the_outer_wire_is_loaded_and_leaving_its_centre) {
    const char *const name[] = {"steady-300-60.json", "steady-400-60.json", "steady-500-60.json"};
    const double entry[] = {2, 3, 4}, exit[] = {0.65, 0.6, 0.6}; /* the wider the block, the emptier its centre */
    for (int k = 0; k < 3; k++) {
        wcut_job *job = sample_job(name[k]);
        wcut_history *h = run_of(job);
        const double e = outer_over_centre(job, h, 100), s = outer_over_centre(job, h, 700),
                     x = outer_over_centre(job, h, 1120);
        ck_assert_double_gt(e, entry[k]);
        ck_assert_double_lt(x, exit[k]);
        ck_assert_double_eq_tol(s, 0.9, 0.1); /* even over the width: over the length it is cos alpha at the sides */
        wcut_history_destroy(h);
        wcut_job_destroy(job);
    }
}

TEST(in_the_steady_phase_the_load_is_even_over_the_width) {
    wcut_job *job = sample_job("steady-400-60.json");
    wcut_history *h = run_of(job);
    int j = 0;
    while (job->mount_a[j].y < 850) j++;
    const wcut_vec3 *x = nodes_at(h, j);
    double low = 1e9, high = 0;
    for (int i = 1; i < h->nodes - 1; i++) {
        if (x[i].x < 8 || x[i].x > 392) continue;
        const wcut_vec3 t = vec3_unit(vec3_sub(x[i + 1], x[i - 1]));
        const double over_width = h->force_line[(size_t)j * (size_t)h->nodes + (size_t)i] / t.x;
        low = fmin(low, over_width), high = fmax(high, over_width);
    }
    ck_assert_double_lt(high / low - 1, 5e-3);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}
