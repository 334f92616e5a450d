/* A cut at a commanded speed: the same equations with the time given; the tension is the answer. labels: property */
#include "cut/cuts.h"

static void take_feed(wcut_job *job, wcut_feed_kind kind, int count, const double *speed, const double *time) {
    job->feed = (wcut_feed){kind, count, wcut_copy(speed, (size_t)count, sizeof *speed),
                            time ? wcut_copy(time, (size_t)count, sizeof *time) : NULL};
}

TEST(a_cut_fed_at_the_speeds_that_it_found_is_the_same_cut) {
    enum { M = 120 };
    wcut_job *job = straight_job(400, 60, 620, 41, M, 200, 800);
    wcut_history *free_run = run_of(job);
    double speed[M];
    for (int j = 0; j < M; j++) speed[j] = fmax(free_run->row[j].speed_a, free_run->row[j].speed_b);
    speed[0] = speed[1];
    take_feed(job, WCUT_FEED_KIND_STATIONS, M, speed, NULL);
    wcut_history *fed = run_of(job);
    for (int j = 1; j < M; j++) {
        ck_assert_int_eq(fed->row[j].condition, WCUT_CONDITION_TIME);
        ck_assert_double_eq_tol(fed->row[j].time, free_run->row[j].time, 1e-9 * free_run->row[j].time);
        if (free_run->row[j].condition != WCUT_CONDITION_TENSION) continue;
        ck_assert_double_eq_tol(fed->row[j].tension_a, job->tension, 1e-7 * job->tension);
        ck_assert_double_lt(shape_difference(41, nodes_at(fed, j), nodes_at(free_run, j)), 1e-6);
    }
    wcut_history_destroy(free_run);
    wcut_history_destroy(fed);
    wcut_job_destroy(job);
}

TEST(the_time_of_a_run_is_the_way_over_the_commanded_speed) {
    wcut_job *job = straight_job(400, 60, 620, 31, 60, 200, 440);
    const double constant = 12, ramp[] = {10, 20}, time[] = {0, 10};
    take_feed(job, WCUT_FEED_KIND_CONSTANT, 1, &constant, NULL);
    wcut_history *h = run_of(job);
    ck_assert_double_eq_tol(h->row[59].time, 20, 1e-10);
    ck_assert_double_eq_tol(h->row[30].speed_a, 12, 1e-10);
    wcut_history_destroy(h);

    /* 10 t + t^2 / 2 = 240 mm */
    wcut_free(job->feed.speed);
    take_feed(job, WCUT_FEED_KIND_TIME, 2, ramp, time);
    h = run_of(job);
    ck_assert_double_eq_tol(h->row[59].time, 10 + (240 - 150) / 20.0, 1e-9);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(the_paper_s_scheme_takes_no_feed) {
    wcut_job *job = straight_job(400, 60, 620, 31, 60, 200, 440);
    const double constant = 12;
    take_feed(job, WCUT_FEED_KIND_CONSTANT, 1, &constant, NULL);
    wcut_cut_options o = wcut_cut_options_default();
    o.integrator = WCUT_INTEGRATOR_HEUN;
    wcut_setup *setup = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_setup_create(job, &o, &setup, &error), WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "feed: found one with the integrator heun") != NULL, "%s", error.text);
    ck_assert_ptr_null(setup);
    wcut_job_destroy(job);
}
