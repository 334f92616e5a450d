/* One word on a cut and its reason. labels: unit */
#include <math.h>
#include <string.h>
#include <wirecut/feasibility.h>

#include "cut/cuts.h"
#include "test.h"

/* the verdict on a job by the default limits, the wire a strong one */
static wcut_feasibility verdict_on(const wcut_job *job, const wcut_robot_limits *limits) {
    wcut_setup *setup = setup_of(job, NULL);
    wcut_history *h = NULL;
    wcut_setup_run(setup, NULL, NULL, &h, NULL);
    ck_assert_ptr_nonnull(h);
    const size_t m = (size_t)h->stations;
    wcut_vec3 *a = wcut_alloc(m, sizeof *a), *b = wcut_alloc(m, sizeof *b);
    double *share = wcut_alloc(m * WCUT_FEASIBILITY_MEASURE_COUNT, sizeof *share), length;
    wcut_feasibility v;
    ck_assert_int_eq(wcut_history_path(setup, h, a, b, &length, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_feasibility_eval(job, h, a, b, limits, &v, share), WCUT_OK);

    /* the map holds what the word says */
    double worst = 0;
    for (size_t i = 0; i < m * WCUT_FEASIBILITY_MEASURE_COUNT; i++) worst = fmax(worst, share[i]);
    if (v.verdict == WCUT_FEASIBILITY_VERDICT_FEASIBLE) ck_assert_double_lt(worst, 1 + 1e-8);
    if (v.verdict == WCUT_FEASIBILITY_VERDICT_AT_LIMIT) ck_assert(worst >= 0.95 && worst < 1 + 1e-8);
    wcut_free(a);
    wcut_free(b);
    wcut_free(share);
    wcut_history_destroy(h);
    wcut_setup_destroy(setup);
    return v;
}

static wcut_job *design(void) {
    wcut_job *job = sample_job("freeform-1.json");
    job->stations = 61, job->nodes = 61;
    return job;
}

TEST(a_cut_within_its_limits_is_feasible_and_one_beyond_is_not_with_its_place) {
    wcut_job *job = design();
    wcut_robot_limits limits = wcut_robot_limits_default(job);
    limits.speed = 200, limits.cold_strength = 3000, limits.hot_strength = 1000;
    wcut_feasibility v = verdict_on(job, &limits);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_FEASIBLE);
    ck_assert_double_gt(v.radius_min, 50);
    limits.cold_strength = limits.hot_strength = 117; /* MPa; 2 N on 0.15 mm are 113 */
    v = verdict_on(job, &limits);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_AT_LIMIT);
    ck_assert_msg(strstr(v.reason, "stress of the wire"), "%s", v.reason);
    limits.alpha = 0.2;
    v = verdict_on(job, &limits);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_INFEASIBLE);
    ck_assert_msg(strstr(v.reason, "alpha") && v.station > 0, "%s", v.reason);
    wcut_job_destroy(job);
}

TEST(the_wires_strength_is_the_jobs_or_that_of_its_material_or_of_kanthal_a) {
    /* 2 N on 0.15 mm at 65 W/m: more than Kanthal A bears in air, less than nickel-chromium */
    wcut_job *job = design();
    const wcut_robot_limits stated = wcut_robot_limits_default(job);
    ck_assert(stated.cold_strength == 810 && stated.hot_strength == 100 && stated.emissivity == 0.88);
    ck_assert_int_eq(verdict_on(job, NULL).verdict, WCUT_FEASIBILITY_VERDICT_FEASIBLE);

    wcut_free(job->wire_material);
    job->wire_material = NULL;
    const wcut_robot_limits kanthal = wcut_robot_limits_default(job);
    ck_assert(kanthal.cold_strength == 725 && kanthal.hot_strength == 34 && kanthal.emissivity == 0.7);
    const wcut_feasibility v = verdict_on(job, NULL);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_INFEASIBLE);
    ck_assert_msg(strstr(v.reason, "stress of the wire"), "%s", v.reason);

    /* what the job states comes before both */
    job->wire_cold_strength = 900, job->wire_hot_strength = 200, job->wire_emissivity = 0.5;
    const wcut_robot_limits own = wcut_robot_limits_default(job);
    ck_assert(own.cold_strength == 900 && own.hot_strength == 200 && own.emissivity == 0.5);
    ck_assert_int_eq(verdict_on(job, NULL).verdict, WCUT_FEASIBILITY_VERDICT_FEASIBLE);
    wcut_job_destroy(job);
}

TEST(every_sample_job_is_feasible) {
    static const char *const name[] = {"freeform-1",    "freeform-2",    "freeform-3",    "freeform-4",
                                       "steady-300-50", "steady-300-60", "steady-300-70", "steady-300-85",
                                       "steady-400-50", "steady-400-60", "steady-400-70", "steady-400-85",
                                       "steady-500-50", "steady-500-60", "steady-500-70", "steady-500-85"};
    for (size_t k = 0; k < sizeof name / sizeof *name; k++) {
        char file[32];
        snprintf(file, sizeof file, "%s.json", name[k]);
        wcut_job *job = sample_job(file);
        job->nodes = 41;
        const wcut_feasibility v = verdict_on(job, NULL);
        ck_assert_msg(v.verdict == WCUT_FEASIBILITY_VERDICT_FEASIBLE, "%s: %s", name[k], v.reason);
        wcut_job_destroy(job);
    }
}

TEST(exchanged_edges_are_infeasible_for_the_wires_angle) {
    wcut_job *job = design();
    wcut_curve *edge = job->edge_a;
    job->edge_a = job->edge_b;
    job->edge_b = edge;
    const wcut_feasibility v = verdict_on(job, NULL);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_INFEASIBLE);
    ck_assert_msg(strstr(v.reason, "edges exchanged"), "%s", v.reason);
    wcut_job_destroy(job);
}

TEST(an_edge_that_runs_in_a_loop_is_infeasible_and_one_that_turns_half_round_is_not_called_so) {
    for (int k = 0; k < 2; k++) {
        wcut_job *job = design();
        wcut_vec3 point[21];
        for (int i = 0; i < 21; i++) {
            const double angle = (k ? 1 : 2) * WCUT_PI * i / 20;
            point[i] = vec3(job->block_size.x, 450 - 300 * cos(angle), 150 + 100 * sin(angle));
        }
        wcut_curve_destroy(job->edge_b);
        ck_assert_int_eq(wcut_curve_interpolate(21, point, &job->edge_b), WCUT_OK);
        const wcut_feasibility v = verdict_on(job, NULL);
        ck_assert_msg((strstr(v.reason, "edge B runs in a loop: it turns by 3") != NULL) == (k == 0), "%s", v.reason);
        if (k == 0) ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_INFEASIBLE);
        wcut_job_destroy(job);
    }
}

TEST(a_path_that_ends_in_the_foam_or_early_is_infeasible) {
    wcut_job *job = straight_job(400, 60, 540, 31, 30, -20, 200);
    wcut_feasibility v = verdict_on(job, NULL);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_INFEASIBLE);
    ck_assert_msg(strstr(v.reason, "wire in the foam"), "%s", v.reason);

    /* back through its own slot: named as such */
    for (int j = 20; j < 30; j++) job->mount_a[j].y = job->mount_b[j].y = job->mount_a[38 - j].y;
    v = verdict_on(job, NULL);
    ck_assert_int_eq(v.verdict, WCUT_FEASIBILITY_VERDICT_INFEASIBLE);
    ck_assert_msg(strstr(v.reason, "turns back by 180 deg"), "%s", v.reason);
    wcut_job_destroy(job);
}
