/* Figures against closed forms, and whole comparisons: of what was simulated, with known noise, with a bias. */
#include <wirecut/recording_file.h>
#include <wirecut/score.h>

#include "base/alloc.h"
#include "base/random.h"
#include "cut/trials.h"
#include "test.h"

enum { SAMPLES = 150 };

/* ---- figures ---- */

TEST(the_figures_are_the_textbooks) {
    const double x[4] = {1, 2, 3, 6}, y[4] = {0, 3, 2, 5}; /* d = 1, -1, 1, 1 */
    wcut_score s;
    memset(&s, 0x55, sizeof s);
    ck_assert_int_eq(wcut_score_eval(4, x, y, 0, &s), WCUT_OK);
    ck_assert_int_eq(s.count, 4);
    ck_assert_double_eq_tol(s.bias, 0.5, 1e-15);
    ck_assert_double_eq_tol(s.rmsd, 1, 1e-15); /* sqrt((3 x 0.25 + 2.25) / 3) */
    ck_assert_double_eq_tol(s.rmse, 1, 1e-15);
    ck_assert_double_eq_tol(s.range, 5, 1e-15);
    ck_assert_double_eq_tol(s.nrmsd, 0.2, 1e-15);
    ck_assert_double_eq_tol(s.rmse_over_range, 0.2, 1e-15);
    /* sums of squares about the means 14 and 13, of products 12 */
    ck_assert_double_eq_tol(s.correlation, 12 / sqrt(14 * 13.0), 1e-15);
    ck_assert(s.correlated);
}

TEST(a_bias_escapes_the_nrmsd_and_not_the_rmse_over_range) {
    double x[100], y[100];
    for (int i = 0; i < 100; i++) x[i] = sin(0.1 * i), y[i] = x[i] - 5;
    wcut_score s;
    ck_assert_int_eq(wcut_score_eval(100, x, y, 0, &s), WCUT_OK);
    ck_assert(s.nrmsd < 1e-14);
    ck_assert_double_eq_tol(s.rmse_over_range, 5 / s.range, 1e-13);
    ck_assert_double_eq_tol(s.bias, 5, 1e-13);
    ck_assert_double_eq_tol(s.correlation, 1, 1e-13);
}

TEST(what_is_not_defined_is_zero_and_says_so) {
    const double flat[3] = {2, 2, 2}, y[3] = {1, 2, 3};
    wcut_score s;
    ck_assert_int_eq(wcut_score_eval(3, flat, y, 0, &s), WCUT_OK);
    ck_assert(s.range == 0 && s.nrmsd == 0 && s.rmse_over_range == 0 && !s.correlated && s.rmsd > 0);
    ck_assert_int_eq(wcut_score_eval(1, y, flat, 0, &s), WCUT_OK);
    ck_assert(s.count == 1 && s.rmsd == 0 && s.bias == -1 && s.rmse == 1 && !s.correlated);
    ck_assert_int_eq(wcut_score_eval(0, NULL, NULL, 0, &s), WCUT_OK);
    ck_assert(s.count == 0 && s.rmse == 0 && s.range == 0);
    ck_assert_int_eq(wcut_score_eval(3, flat, y, 4, &s), WCUT_OK);
    ck_assert_double_eq_tol(s.nrmsd, 0.25, 1e-15);
}

TEST(figures_of_impossible_values_are_refused) {
    const double x[2] = {1, NAN}, y[2] = {1, 2};
    wcut_score s = {.count = 999};
    ck_assert_int_eq(wcut_score_eval(2, x, y, 0, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_eval(2, y, x, 0, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_eval(2, y, y, -1, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_eval(-1, y, y, 0, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_eval(2, NULL, y, 0, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_eval(2, y, y, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_mean(1, NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(s.count, 999);
}

TEST(a_mean_leaves_out_what_a_score_lacks) {
    const wcut_score of[3] = {
        {.count = 10, .rmsd = 1, .range = 4, .nrmsd = 0.25, .bias = -1, .correlated = true, .correlation = 0.5},
        {.count = 0},
        {.count = 5, .rmsd = 3, .bias = 2}};
    wcut_score mean;
    ck_assert_int_eq(wcut_score_mean(3, of, &mean), WCUT_OK);
    ck_assert_int_eq(mean.count, 2);
    ck_assert_double_eq_tol(mean.rmsd, 2, 1e-15);
    ck_assert_double_eq_tol(mean.bias, 0.5, 1e-15);
    ck_assert_double_eq_tol(mean.nrmsd, 0.25, 1e-15);
    ck_assert_double_eq_tol(mean.correlation, 0.5, 1e-15);
}

TEST(names_of_channels_and_parts_are_those_of_files) {
    ck_assert_str_eq(wcut_scored_name(WCUT_SCORED_SPEED), "speed");
    ck_assert_str_eq(wcut_scored_name(WCUT_SCORED_BETA_B), wcut_channel_name(WCUT_CHANNEL_BETA_B));
    ck_assert_str_eq(wcut_scored_unit(WCUT_SCORED_ALPHA), "deg");
    ck_assert_str_eq(wcut_part_name(WCUT_PART_EXIT), "exit");
    ck_assert_str_eq(wcut_scored_name(WCUT_SCORED_COUNT), "");
    ck_assert_str_eq(wcut_scored_unit(WCUT_SCORED_COUNT), "");
    ck_assert_str_eq(wcut_part_name(WCUT_PART_COUNT), "");
}

/* ---- comparisons ---- */

static wcut_job *job;
static wcut_recording *recording;
static wcut_comparison_options options;

static void given_a_driven_cut(void) {
    job = short_job();
    recording = driven_recording(job, 3, 0.1, SAMPLES);
    options = wcut_comparison_options_default();
    options.settle = options.leave = 0.35;
    options.replay.window = 0;
}

static void forget(void) {
    wcut_recording_destroy(recording);
    wcut_job_destroy(job);
}

static wcut_comparison *compared(void) {
    wcut_comparison *c = NULL;
    wcut_error error = {0};
    const wcut_status status = wcut_comparison_create(job, recording, &options, &c, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return c;
}

TEST(a_recording_of_the_simulation_scores_nothing) {
    given_a_driven_cut();
    wcut_comparison *c = compared();
    for (int k = WCUT_SCORED_TENSION; k < WCUT_SCORED_COUNT; k++) {
        const wcut_score *s = c->replayed_score.of[k];
        if (k == WCUT_SCORED_SPEED_A || k == WCUT_SCORED_SPEED_B) continue;
        ck_assert_int_gt(s->count, 40);
        ck_assert_msg(s->rmsd < 1e-5 && fabs(s->bias) < 1e-5, "%s: %g", wcut_scored_name((wcut_scored)k), s->rmsd);
    }
    ck_assert_int_eq(c->replayed_score.of[WCUT_SCORED_SPEED][0].count, 0);
    ck_assert_int_eq(c->replayed_score.of[WCUT_SCORED_SPEED_A][0].count, 0);
    ck_assert_int_gt(c->planned_score.of[WCUT_SCORED_SPEED][0].count, 40);
    wcut_comparison_destroy(c);
    forget();
}

TEST(the_rmsd_is_the_noise_that_was_put_in) {
    given_a_driven_cut();
    wcut_random random = wcut_random_seed(3);
    for (int i = 0; i < SAMPLES; i++) {
        values(recording, WCUT_CHANNEL_TENSION_A)[i] += 0.05 * wcut_random_normal(&random) + 0.2;
        values(recording, WCUT_CHANNEL_TENSION_B)[i] += 0.05 * wcut_random_normal(&random) + 0.2;
    }
    wcut_comparison *c = compared();
    const wcut_score *s = &c->replayed_score.of[WCUT_SCORED_TENSION][WCUT_PART_ALL];
    ck_assert_int_eq(s->count, 2 * c->counted_samples);
    ck_assert_double_eq_tol(s->rmsd, 0.05, 3 * 0.05 / sqrt(2 * s->count)); /* three standard errors */
    ck_assert_double_eq_tol(s->bias, 0.2, 3 * 0.05 / sqrt(s->count));
    ck_assert_double_eq_tol(s->rmse_over_range * s->range, sqrt(0.2 * 0.2 + 0.05 * 0.05), 0.02);
    wcut_comparison_destroy(c);
    forget();
}

TEST(the_samples_that_count_lie_between_contact_and_leaving) {
    given_a_driven_cut();
    wcut_comparison *c = compared();
    wcut_history *plan = run_of(job);
    int contact = 0, left = 0, counted = 0;
    while (plan->row[contact].phase == WCUT_PHASE_APPROACH) contact++;
    for (int j = 0; j < plan->stations; j++)
        if (plan->row[j].phase != WCUT_PHASE_APPROACH && plan->row[j].phase != WCUT_PHASE_LEFT) left = j + 1;
    ck_assert(contact > 0 && left < 45); /* 45 stations were driven */
    const double first = ceil(contact / 0.3 - 1e-9) * 0.1 - 0.1, last = ceil(left / 0.3 - 1e-9) * 0.1 - 0.1;
    ck_assert_double_eq_tol(c->contact, first, 1e-9);
    ck_assert_double_eq_tol(c->leave, last, 1e-9);
    ck_assert_double_eq_tol(c->from, first + 0.35, 1e-9);
    ck_assert_double_eq_tol(c->to, last - 0.35, 1e-9);
    for (int i = 0; i < SAMPLES; i++) {
        const double t = 0.1 * i;
        if (c->counted[i]) ck_assert(t >= c->from && t <= c->to && c->phase[i] != WCUT_PHASE_LEFT);
        counted += c->counted[i];
    }
    ck_assert_int_eq(counted, c->counted_samples);
    ck_assert_int_eq(c->phase[0], WCUT_PHASE_APPROACH);
    ck_assert_int_eq(c->phase[SAMPLES - 1], WCUT_PHASE_LEFT);
    int parts = 0;
    for (int part = WCUT_PART_ENTRY; part < WCUT_PART_COUNT; part++)
        parts += c->replayed_score.of[WCUT_SCORED_ALPHA_A][part].count;
    ck_assert_int_eq(parts, counted);
    wcut_history_destroy(plan);
    wcut_comparison_destroy(c);
    forget();
}

TEST(missing_measurements_are_left_out_channel_by_channel) {
    given_a_driven_cut();
    for (int i = 0; i < SAMPLES; i++) lose_sample(recording, WCUT_CHANNEL_BETA_A, i);
    for (int i = 60; i < 70; i++) lose_sample(recording, WCUT_CHANNEL_TENSION_A, i);
    wcut_comparison *c = compared();
    ck_assert_int_eq(c->replayed_score.of[WCUT_SCORED_BETA_A][0].count, 0);
    ck_assert_int_eq(c->replayed_score.of[WCUT_SCORED_BETA][0].count, c->counted_samples);
    ck_assert_int_eq(c->replayed_score.of[WCUT_SCORED_TENSION_A][0].count, c->counted_samples - 10);
    ck_assert_int_eq(c->replayed_score.of[WCUT_SCORED_TENSION_B][0].count, c->counted_samples);
    wcut_comparison_destroy(c);
    forget();
}

TEST(many_cuts_in_parallel_are_the_same_bytes_as_one_by_one) {
    enum { CUTS = 5 };
    given_a_driven_cut();
    const wcut_job *jobs[CUTS] = {job, job, NULL, job, job};
    const wcut_recording *recordings[CUTS] = {recording, recording, recording, recording, recording};
    wcut_comparison *many[CUTS], *one = compared();
    wcut_error error[CUTS];
    wcut_recording *bad = driven_recording(job, 3, 0.1, 5);
    values(bad, WCUT_CHANNEL_STATION)[4] = 500;
    recordings[1] = bad;
    ck_assert_int_eq(wcut_comparison_run(CUTS, jobs, recordings, &options, NULL, NULL, many, error), WCUT_OK);
    ck_assert(!many[2] && error[2].status == WCUT_OK);
    ck_assert(!many[1] && error[1].status == WCUT_BAD_ARGUMENT && strstr(error[1].text, "line 6: station: found 500"));
    for (int i = 0; i < CUTS; i++) {
        if (!many[i]) continue;
        ck_assert(memcmp(&many[i]->replayed_score, &one->replayed_score, sizeof one->replayed_score) == 0);
        ck_assert(memcmp(&many[i]->planned_score, &one->planned_score, sizeof one->planned_score) == 0);
    }
    wcut_scores planned, replayed;
    ck_assert_int_eq(wcut_scores_mean(CUTS, (const wcut_comparison *const *)many, &planned, &replayed), WCUT_OK);
    ck_assert_int_eq(planned.of[WCUT_SCORED_SPEED][0].count, 3);
    ck_assert_double_eq_tol(planned.of[WCUT_SCORED_SPEED][0].rmsd, one->planned_score.of[WCUT_SCORED_SPEED][0].rmsd,
                            1e-14);
    for (int i = 0; i < CUTS; i++) wcut_comparison_destroy(many[i]);
    wcut_comparison_destroy(one);
    wcut_recording_destroy(bad);
    forget();
}

static int stop_at_once(int done, int count, void *context) {
    *(int *)context += 1;
    ck_assert(done >= 0 && done < count);
    return 1;
}

TEST(a_run_that_is_stopped_keeps_what_was_done) {
    enum { CUTS = 12 };
    given_a_driven_cut();
    const wcut_job *jobs[CUTS];
    const wcut_recording *recordings[CUTS];
    for (int i = 0; i < CUTS; i++) jobs[i] = job, recordings[i] = recording;
    wcut_comparison *many[CUTS];
    wcut_error error[CUTS];
    int calls = 0, done = 0;
    ck_assert_int_eq(wcut_comparison_run(CUTS, jobs, recordings, &options, stop_at_once, &calls, many, error),
                     WCUT_INTERRUPTED);
    for (int i = 0; i < CUTS; i++) {
        ck_assert((many[i] != NULL) == (error[i].status == WCUT_OK));
        if (!many[i]) ck_assert_int_eq(error[i].status, WCUT_INTERRUPTED);
        done += many[i] != NULL;
        wcut_comparison_destroy(many[i]);
    }
    ck_assert_int_eq(done, calls);
    ck_assert_int_ge(done, 1);
    forget();
}

TEST(a_comparison_of_the_impossible_is_refused) {
    given_a_driven_cut();
    wcut_comparison *c = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_comparison_create(NULL, recording, &options, &c, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_comparison_create(job, NULL, &options, &c, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_comparison_create(job, recording, &options, NULL, NULL), WCUT_BAD_ARGUMENT);
    options.settle = -1;
    ck_assert_int_eq(wcut_comparison_create(job, recording, &options, &c, NULL), WCUT_BAD_ARGUMENT);
    options.settle = 0, options.tolerance = NAN;
    ck_assert_int_eq(wcut_comparison_create(job, recording, &options, &c, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_comparison_run(1, NULL, NULL, &options, NULL, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    options.tolerance = 1e-6;
    job->wire_length = 100; /* shorter than the mounts are apart */
    ck_assert_int_eq(wcut_comparison_create(job, recording, &options, &c, &error), WCUT_DEGENERATE);
    ck_assert(error.text[0] != 0);
    ck_assert_ptr_null(c);
    wcut_comparison_destroy(NULL);
    forget();
}

TEST(without_memory_nothing_is_written) {
    given_a_driven_cut();
    recording->samples = 3;
    wcut_comparison *c = NULL;
    EACH_FAILED_ALLOCATION(wcut_comparison_create(job, recording, &options, &c, NULL), !c);
    wcut_comparison_destroy(c);
    forget();
}
