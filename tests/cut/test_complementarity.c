/* v <= v_max, T <= k, one of them with equality, at every station; and what a wire does that nothing touches.
   labels: property */
#include "cut/cuts.h"
#include "test.h"

static double faster_speed(const wcut_history_row *r) { return fmax(r->speed_a, r->speed_b); }

/* how often each condition held; fails where a station breaks it */
typedef struct tally {
    int tension, max, min, free;
} tally;

static tally check_every_station(const wcut_job *job, const wcut_history *h) {
    tally count = {0};
    const double k = job->tension;
    for (int j = 1; j < h->stations; j++) {
        const wcut_history_row *r = &h->row[j];
        const double v = faster_speed(r), pull = pull_at(h, j);
        ck_assert_double_gt(v, job->speed_min * (1 - 1e-12));
        ck_assert_double_lt(v, job->speed_max * (1 + 1e-12));
        if (r->substeps != 1) continue; /* the sub-steps' speeds differ, the station tells their mean */
        const bool loaded = r->engaged_length > 0;
        if (r->condition == WCUT_CONDITION_TENSION) {
            ck_assert_double_eq_tol(pull, k, 1e-9 * k);
            count.tension++;
        } else if (r->condition == WCUT_CONDITION_SPEED_MAX) {
            ck_assert_double_eq_tol(v, job->speed_max, 1e-12 * v);
            if (loaded) ck_assert_double_le(pull, k * (1 + 1e-9));
            loaded ? count.max++ : count.free++;
        } else {
            ck_assert_int_eq(r->condition, WCUT_CONDITION_SPEED_MIN);
            ck_assert_double_eq_tol(v, job->speed_min, 1e-12 * v);
            ck_assert_double_ge(pull, k * (1 - 1e-9));
            count.min++;
        }
        ck_assert_double_le(r->residual, 1e-9);
    }
    return count;
}

static tally tally_of(wcut_job *job) {
    wcut_history *h = run_of(job);
    const tally count = check_every_station(job, h);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
    return count;
}

TEST(the_sample_jobs_hold_the_tension_in_the_foam_and_the_speed_limit_outside) {
    const char *const name[] = {"steady-300-50.json", "steady-400-60.json", "steady-500-85.json"};
    for (int k = 0; k < 3; k++) {
        const tally count = tally_of(sample_job(name[k]));
        ck_assert_int_gt(count.tension, 280);
        ck_assert_int_gt(count.free + count.max, 2);
    }
}

TEST(a_job_with_a_low_speed_limit_stays_at_it_with_less_tension) {
    wcut_job *job = sample_job("steady-400-60.json");
    job->speed_max = 15;
    const tally count = tally_of(job);
    ck_assert_int_gt(count.max, 200);
}

TEST(a_job_with_a_high_least_speed_stays_at_it_with_more_tension) {
    wcut_job *job = straight_job(400, 60, 620, 61, 100, 200, 500);
    job->speed_min = 30;
    const tally count = tally_of(job);
    ck_assert_int_eq(count.min, 99);
}

TEST(swinging_in_space_the_conditions_hold_too) {
    const tally count = tally_of(swinging_job(61, 200));
    ck_assert_int_gt(count.tension, 190);
}

TEST(without_contact_the_wire_keeps_its_shape_and_feeds_at_its_limit) {
    wcut_job *job = straight_job(400, 60, 540, 61, 40, -150, -5);
    job->speed_max = 80;
    wcut_history *h = run_of(job);
    for (int j = 1; j < h->stations; j++) {
        const wcut_history_row *r = &h->row[j];
        ck_assert_double_eq_tol(faster_speed(r), 80, 1e-10);
        ck_assert_int_eq(r->condition, WCUT_CONDITION_SPEED_MAX);
        ck_assert_int_eq(r->phase, WCUT_PHASE_APPROACH);
        ck_assert(r->tension_a == 0 && r->engaged_length == 0);
        const wcut_vec3 way = vec3_sub(job->mount_a[j], job->mount_a[0]);
        for (int i = 0; i < h->nodes; i++)
            ck_assert_double_lt(vec3_distance(nodes_at(h, j)[i], vec3_add(nodes_at(h, 0)[i], way)), 1e-6);
    }
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(at_station_0_the_wire_hangs_trailing_or_straight_where_it_is_as_long_as_the_chord) {
    for (int k = 0; k < 2; k++) {
        wcut_job *job = straight_job(400, 60, k == 0 ? 540 : 520, 61, 3, -150, 1);
        wcut_setup *setup = setup_of(job, NULL);
        wcut_cut *cut = NULL;
        ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
        wcut_station s;
        wcut_cut_view(cut, &s);
        double way = 0;
        for (int i = 0; i < 60; i++) way += vec3_distance(s.position[i], s.position[i + 1]);
        ck_assert_double_eq_tol(way, job->wire_length, 1e-6);
        if (k == 0) ck_assert_double_lt(s.position[30].y, -150 - 40);
        if (k == 1) ck_assert_double_eq_tol(s.position[30].y, -150, 1e-9);
        ck_assert(s.index == 0 && s.time == 0 && s.tension_a == 0 && s.phase == WCUT_PHASE_APPROACH);
        wcut_cut_destroy(cut);
        wcut_setup_destroy(setup);
        wcut_job_destroy(job);
    }
}
