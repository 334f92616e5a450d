/* Identification cuts: within the machine's limits, the same for the same seed, as strong as the limits allow, and run
   by the closed loop. labels: unit property */
#include <wirecut/diagnosis.h>
#include <wirecut/rig.h>

#include "base/alloc.h"
#include "cut/cuts.h"
#include "cut/setup.h"
#include "explain/identify.h"
#include "test.h"

/* a cut of about 40 s, entry, steady part and exit */
static wcut_job *short_job(void) {
    wcut_job *job = straight_job(300, 60, 450, 31, 90, -20, 700);
    job->block_size = vec3(300, 600, 200);
    ck_assert(wcut_job_name(job, "short"));
    job->speed_max = 60;
    for (int j = 0; j < job->stations; j++) {
        job->mount_a[j].z = job->mount_b[j].z = 100;
    }
    return job;
}

static void destroy_all(int count, wcut_job **job) {
    for (int k = 0; k < count; k++) wcut_job_destroy(job[k]);
}

TEST(a_cut_gets_three_incommensurate_sines_and_steps_of_heat_that_go_up_as_often_as_down) {
    wcut_job *job = short_job(), *cut[3] = {NULL};
    wcut_error error = {0};
    ck_assert_msg(wcut_identification_create(job, 3, 7, cut, &error) == WCUT_OK, "%s", error.text);
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(cut[k]->dither_count, 3);
        for (int i = 0; i < 3; i++) {
            const wcut_dither d = cut[k]->dither[i];
            ck_assert(d.amplitude >= 0.03 && d.amplitude <= 0.055);
            ck_assert(d.period >= 3 && d.period <= 12 && d.phase >= 0 && d.phase < 6.2832);
            if (i == 0) continue;
            const double ratio = d.period / cut[k]->dither[i - 1].period;
            ck_assert_msg(ratio > 1.1 && ratio < 2.6, "%g", ratio);
        }
        const int steps = cut[k]->heat_step_count;
        int up = 0;
        ck_assert_int_ge(steps, 2);
        for (int i = 0; i < steps; i++) {
            const wcut_heat_step s = cut[k]->heat_step[i];
            up += s.factor > 1;
            ck_assert_double_eq_tol(fabs(s.factor - 1), 0.1, 1e-12);
            ck_assert(s.to > s.from && s.to - s.from <= 14);
            if (i) ck_assert_double_gt(s.from, cut[k]->heat_step[i - 1].to);
        }
        ck_assert_int_le(abs(2 * up - steps), 1);
    }
    ck_assert_str_eq(cut[0]->name, "short, identification 1");
    ck_assert_str_eq(cut[1]->name, "short, identification 2, backwards");
    for (int j = 0; j < job->stations; j++) {
        ck_assert_double_eq(cut[0]->mount_a[j].y, job->mount_a[j].y);
        ck_assert_double_eq(cut[1]->mount_a[j].y, job->mount_a[job->stations - 1 - j].y);
        ck_assert_double_eq(cut[1]->mount_b[j].x, job->mount_b[job->stations - 1 - j].x);
    }
    destroy_all(3, cut);
    wcut_job_destroy(job);
}

TEST(the_same_seed_gives_the_same_cuts_and_another_one_others) {
    wcut_job *job = short_job(), *a[2] = {NULL}, *b[2] = {NULL}, *c[2] = {NULL};
    ck_assert_int_eq(wcut_identification_create(job, 2, 1, a, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_identification_create(job, 2, 1, b, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_identification_create(job, 2, 2, c, NULL), WCUT_OK);
    for (int k = 0; k < 2; k++) {
        ck_assert_int_eq(memcmp(a[k]->dither, b[k]->dither, 3 * sizeof *a[k]->dither), 0);
        ck_assert_int_eq(a[k]->heat_step_count, b[k]->heat_step_count);
        ck_assert_int_ne(memcmp(a[k]->dither, c[k]->dither, 3 * sizeof *a[k]->dither), 0);
    }
    ck_assert_int_ne(memcmp(a[0]->dither, a[1]->dither, 3 * sizeof *a[0]->dither), 0);
    destroy_all(2, a);
    destroy_all(2, b);
    destroy_all(2, c);
    wcut_job_destroy(job);
}

TEST(a_machine_with_little_speed_to_spare_gets_a_smaller_dither_and_none_where_there_is_none) {
    wcut_job *job = short_job(), *cut[3] = {NULL};
    wcut_history *plan = run_of(job);
    const double max = plan->row[plan->stations / 2].speed_a;
    double before = 1;
    const double spare[] = {2, 1.2, 1.05};
    for (int k = 0; k < 3; k++) {
        job->speed_max = max * spare[k];
        ck_assert_int_eq(wcut_identification_create(job, 1, 3, &cut[k], NULL), WCUT_OK);
        double sum = 0;
        for (int i = 0; i < cut[k]->dither_count; i++) sum += cut[k]->dither[i].amplitude;
        ck_assert_double_lt(sum, before + 1e-12);
        ck_assert_double_le(sum, fmax(spare[k] / 1.1 - 1, 0) + 0.2 * (k == 0));
        before = sum;
    }
    ck_assert_double_eq(before, 0);
    destroy_all(3, cut);
    wcut_history_destroy(plan);
    wcut_job_destroy(job);
}

TEST(even_without_feedback_the_tension_stays_below_twice_the_target) {
    wcut_job *job = short_job(), *cut = NULL;
    job->force_law.b *= 3; /* so steep a law that 10 % of heat alone would double the force */
    job->force_law.a *= 40;
    ck_assert_int_eq(wcut_identification_create(job, 1, 5, &cut, NULL), WCUT_OK);
    ck_assert_double_lt(fabs(cut->heat_step[0].factor - 1), 0.1);
    wcut_schedule schedule = {0};
    wcut_predicted_cut run = {0};
    ck_assert_int_eq(wcut_schedule_create(cut, &schedule, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_predicted_cut_run(cut, &schedule, NULL, &run, NULL), WCUT_OK);
    double max = 0;
    for (int i = 0; i < run.count; i++)
        if (run.present[i] && schedule.engaged[i] >= WCUT_MOST_OF_WIRE && schedule.held[i])
            max = fmax(max, (run.value[2][i] + run.value[3][i]) / 2);
    ck_assert_msg(max > 1.2 * job->tension && max < 2.01 * job->tension, "%g N", max);
    wcut_predicted_cut_destroy(&run);
    wcut_schedule_destroy(&schedule);
    wcut_job_destroy(cut);
    wcut_job_destroy(job);
}

/* in closed loop the dither is in the speed, the steps are in the heat, and the tension is held all the same */
TEST(the_loop_runs_both_ways_to_the_end_with_the_excitation_in_its_recording) {
    wcut_job *job = short_job(), *cut[2] = {NULL};
    ck_assert_int_eq(wcut_identification_create(job, 2, 1, cut, NULL), WCUT_OK);
    for (int k = 0; k < 2; k++) {
        wcut_history *plan = run_of(cut[k]);
        const wcut_control_settings control = wcut_control_settings_default(cut[k]);
        wcut_rig_options o = wcut_rig_options_default(cut[k]);
        wcut_rig_run *run = NULL;
        wcut_error error = {0};
        o.noise_tension = o.noise_angle = o.noise_speed = o.noise_position = 0;
        const wcut_status status = wcut_rig_run_create(cut[k], plan, &control, &o, NULL, NULL, &run, &error);
        ck_assert_msg(status == WCUT_OK && run->complete, "cut %d: %s", k + 1, error.text);
        const double *heat = run->recording.channel[WCUT_CHANNEL_HEAT].value;
        int stepped = 0;
        for (int i = 0; i < run->recording.samples; i++) stepped += heat[i] != job->heat;
        ck_assert_int_gt(stepped, run->recording.samples / 6);
        ck_assert(run->has_steady);
        ck_assert_msg(fabs(run->steady.mean) < 0.03 && run->steady.rms < 0.15, "cut %d: %g %g", k + 1, run->steady.mean,
                      run->steady.rms);
        wcut_rig_run_destroy(run);
        wcut_history_destroy(plan);
    }
    destroy_all(2, cut);
    wcut_job_destroy(job);
}

TEST(what_is_no_job_is_refused_and_nothing_is_written) {
    wcut_job *job = short_job(), *out[8];
    wcut_error error = {0};
    for (int k = 0; k < 8; k++) out[k] = job;
    ck_assert_int_eq(wcut_identification_create(NULL, 1, 1, out, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_identification_create(job, 0, 1, out, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_identification_create(job, 9, 1, out, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_identification_create(job, 1, 1, NULL, &error), WCUT_BAD_ARGUMENT);
    job->mode = WCUT_MODE_DESIGN;
    ck_assert_int_eq(wcut_identification_create(job, 1, 1, out, &error), WCUT_BAD_ARGUMENT);
    job->mode = WCUT_MODE_PATH;
    job->heat = -1;
    ck_assert_int_eq(wcut_identification_create(job, 1, 1, out, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "heat"));
    job->heat = 65;
    for (int j = 0; j < job->stations; j++) job->mount_a[j].z += 1000, job->mount_b[j].z += 1000;
    ck_assert_int_eq(wcut_identification_create(job, 1, 1, out, &error), WCUT_DEGENERATE);
    for (int k = 0; k < 8; k++) ck_assert_ptr_eq(out[k], job);
    wcut_job_destroy(job);
}

TEST(wherever_memory_ends_nothing_is_written) {
    wcut_job *job = short_job(), *out = NULL;
    job->stations = 12;
    for (int j = 0; j < job->stations; j++) job->mount_a[j].y = job->mount_b[j].y = -20 + 60.0 * j;
    EACH_FAILED_ALLOCATION(wcut_identification_create(job, 1, 1, &out, NULL), !out);
    wcut_job_destroy(out);
    wcut_job_destroy(job);
}
