/* Time-driven steps: the same equations with the time given and the tensions as the answer. labels: unit property */
#include "cut/cuts.h"
#include "test.h"

static wcut_cut *begin(const wcut_setup *setup) {
    wcut_cut *cut = NULL;
    ck_assert_int_eq(wcut_cut_create(setup, &cut, NULL), WCUT_OK);
    return cut;
}

TEST(a_run_replayed_in_its_own_time_has_its_own_shapes_and_tension) {
    wcut_job *const job[] = {swinging_job(61, 150), sample_job("steady-400-60.json")};
    for (int k = 0; k < 2; k++) {
        wcut_history *h = run_of(job[k]);
        wcut_setup *setup = setup_of(job[k], NULL);
        wcut_cut *cut = begin(setup);
        double worst = 0, shape = 0;
        int compared = 0;
        for (int j = 1; j < h->stations; j++) {
            ck_assert_int_eq(
                wcut_cut_drive(cut, job[k]->mount_a[j], job[k]->mount_b[j], h->row[j].duration, job[k]->heat, NULL),
                WCUT_OK);
            wcut_station s;
            wcut_cut_view(cut, &s);
            ck_assert_int_eq(s.condition, WCUT_CONDITION_TIME);
            ck_assert_double_eq_tol(s.time, h->row[j].time, 1e-9 * s.time);
            if (h->row[j].condition != WCUT_CONDITION_TENSION) continue;
            worst = fmax(worst, fabs(s.tension_a - h->row[j].tension_a));
            worst = fmax(worst, fabs(s.tension_b - h->row[j].tension_b));
            if (k == 1) worst = fmax(worst, fabs(s.tension_a - job[k]->tension)); /* planar, the mounts alike */
            shape = fmax(shape, shape_difference(s.nodes, s.position, nodes_at(h, j)));
            compared++;
        }
        ck_assert_int_gt(compared, 140);
        ck_assert_double_lt(worst, 1e-8 * job[k]->tension);
        ck_assert_double_lt(shape, 1e-6);
        wcut_cut_destroy(cut);
        wcut_setup_destroy(setup);
        wcut_history_destroy(h);
        wcut_job_destroy(job[k]);
    }
}

TEST(faster_than_planned_the_wire_is_pulled_harder_and_hotter_it_is_pulled_less) {
    wcut_job *job = straight_job(400, 60, 620, 61, 200, 200, 800);
    wcut_history *h = run_of(job);
    wcut_setup *setup = setup_of(job, NULL);
    double tension[3];
    for (int k = 0; k < 3; k++) {
        wcut_cut *cut = begin(setup);
        for (int j = 1; j < 200; j++)
            ck_assert_int_eq(
                wcut_cut_drive(cut, job->mount_a[j], job->mount_b[j], h->row[j].duration / (k == 1 ? 1.1 : 1),
                               job->heat * (k == 2 ? 1.1 : 1), NULL),
                WCUT_OK);
        wcut_station s;
        wcut_cut_view(cut, &s);
        tension[k] = s.tension_a;
        wcut_cut_destroy(cut);
    }
    /* steady: F is T times a constant of the shape, so T changes as exp(-b Q / v) does */
    const double q_eff = wcut_q_eff_eval(job->heat, h->row[199].speed_a);
    ck_assert_double_eq_tol(tension[1] / tension[0], exp(job->force_law.b * q_eff * (1 - 1 / 1.1)), 1e-6);
    ck_assert_double_eq_tol(tension[2] / tension[0], exp(job->force_law.b * q_eff * (1 - 1.1)), 1e-6);
    wcut_setup_destroy(setup);
    wcut_history_destroy(h);
    wcut_job_destroy(job);
}

TEST(what_cannot_be_driven_is_refused_and_the_run_goes_on) {
    wcut_job *job = straight_job(400, 60, 620, 61, 20, 200, 260);
    wcut_setup *setup = setup_of(job, NULL);
    wcut_cut *cut = begin(setup);
    const wcut_vec3 a = job->mount_a[1], b = job->mount_b[1];
    const double bad[] = {0, -1, NAN, (double)INFINITY};
    wcut_error error = {0};
    for (int k = 0; k < 4; k++) {
        ck_assert_int_eq(wcut_cut_drive(cut, a, b, bad[k], 65, &error), WCUT_BAD_ARGUMENT);
        ck_assert_int_eq(wcut_cut_drive(cut, a, b, 0.1, bad[k], &error), WCUT_BAD_ARGUMENT);
    }
    ck_assert_int_eq(wcut_cut_drive(cut, vec3(NAN, 0, 0), b, 0.1, 65, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cut_drive(NULL, a, b, 0.1, 65, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cut_drive(cut, vec3(-500, 200, 150), b, 0.1, 65, &error), WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "960") && strstr(error.text, "620"), "%s", error.text);
    wcut_station s;
    wcut_cut_view(cut, &s);
    ck_assert(s.index == 0 && s.time == 0);
    ck_assert_int_eq(wcut_cut_drive(cut, a, b, 0.1, 65, &error), WCUT_OK);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(a_drive_without_a_solution_leaves_the_state_before_in_view) {
    wcut_job *job = swinging_job(61, 150);
    wcut_cut_options options = wcut_cut_options_default();
    options.max_halvings = 0;
    wcut_setup *setup = setup_of(job, &options);
    wcut_cut *cut = begin(setup);
    ck_assert_int_eq(wcut_cut_drive(cut, job->mount_a[1], job->mount_b[1], 0.1, 65, NULL), WCUT_OK);
    wcut_station s;
    wcut_cut_view(cut, &s);
    wcut_vec3 before[61];
    memcpy(before, s.position, sizeof before);
    wcut_error error = {0};
    /* back out of its own cut in one stride, both ends crossed over: no wire follows that */
    ck_assert_int_eq(wcut_cut_drive(cut, vec3(410, 400, 290), vec3(-10, 100, 10), 1e-3, 65, &error),
                     WCUT_NOT_CONVERGED);
    ck_assert_int_gt((int)strlen(error.text), 20);
    wcut_cut_view(cut, &s);
    ck_assert_int_eq(s.index, 1);
    ck_assert_int_eq(memcmp(before, s.position, sizeof before), 0);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

TEST(heun_is_not_driven_and_a_design_is_driven_along_its_path) {
    wcut_job *design = sample_job("freeform-1.json"), *path = swinging_job(31, 20), *of_design = NULL;
    wcut_cut_options heun = wcut_cut_options_default();
    heun.integrator = WCUT_INTEGRATOR_HEUN;
    wcut_setup *setup = setup_of(path, &heun);
    wcut_cut *cut = begin(setup);
    ck_assert_int_eq(wcut_cut_drive(cut, vec3(0, 4, 150), vec3(400, 4, 150), 0.1, 65, NULL), WCUT_BAD_ARGUMENT);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);

    setup = setup_of(design, NULL);
    cut = begin(setup);
    ck_assert_int_eq(wcut_setup_path_job(setup, &of_design), WCUT_OK);
    for (int j = 1; j < 10; j++)
        ck_assert_int_eq(wcut_cut_drive(cut, of_design->mount_a[j], of_design->mount_b[j], 0.1, 65, NULL), WCUT_OK);
    wcut_cut_destroy(cut);
    wcut_setup_destroy(setup);
    wcut_job_destroy(of_design);
    wcut_job_destroy(design);
    wcut_job_destroy(path);
}
