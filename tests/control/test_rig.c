/* The closed loop: a force law that is wrong, a density step, delay and noise, with feedback and without. */
/* labels: property plain */
#include <math.h>
#include <string.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>
#include <wirecut/rig.h>

#include "base/alloc.h"
#include "test.h"

static wcut_job *job;
static wcut_history *plan;
static wcut_control_settings settings;
static wcut_rig_options options;
static wcut_rig_run *run;
static wcut_error error;

/* one plan for all tests: straight feed, 400 mm block, entry, a steady phase and exit */
static void begin(void) {
    wcut_setup *setup = NULL;
    const wcut_status status = wcut_job_read(WCUT_SOURCE_DIR "/samples/jobs/steady-400-60.json", &job, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    job->nodes = 41;
    ck_assert_int_eq(wcut_setup_create(job, NULL, &setup, &error), WCUT_OK);
    ck_assert_int_eq(wcut_setup_run(setup, NULL, NULL, &plan, &error), WCUT_OK);
    wcut_setup_destroy(setup);
}

static void end(void) {
    wcut_history_destroy(plan);
    wcut_job_destroy(job);
}

static void prepare(void) {
    settings = wcut_control_settings_default(job);
    options = wcut_rig_options_default(job);
    run = NULL;
}

static void forget(void) { wcut_rig_run_destroy(run); }

static void cut(bool feedback) {
    wcut_rig_run_destroy(run);
    run = NULL;
    settings.feedback = feedback;
    const wcut_status status = wcut_rig_run_create(job, plan, &settings, &options, NULL, NULL, &run, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
}

TEST(with_a_true_job_the_loop_follows_the_plan) {
    cut(true);
    ck_assert(run->complete && run->has_steady);
    ck_assert_double_lt(fabs(run->steady.mean), 0.005);
    ck_assert_double_lt(run->overshoot, 0.5);
    const int n = run->recording.samples;
    ck_assert_double_eq_tol(run->recording.channel[WCUT_CHANNEL_STATION].value[n - 1], job->stations - 1, 1);
}

/* factors of a and b, and by how much the tension is off in the steady phase with the plan alone: F'/F - 1 */
static const double wrong[][2] = {{1.25, 1}, {0.75, 1}, {1, 1.25}, {1, 0.75}};

TEST_EACH(with_feedback_the_steady_tension_is_within_5_percent_for_laws_wrong_by_25_percent, 4) {
    options.law_a = wrong[_i][0];
    options.law_b = wrong[_i][1];
    cut(true);
    ck_assert_msg(run->complete, "a x %g, b x %g: %s", options.law_a, options.law_b,
                  wcut_control_state_name(run->ended));
    ck_assert_double_lt(fabs(run->steady.mean), 0.05);
    ck_assert_double_lt(run->steady.rms, 0.05);
    ck_assert_double_lt(run->steady.settled, 5);
}

TEST_EACH(with_the_plan_alone_the_tension_is_off_as_the_law_is, 4) {
    settings.tension_stop = 40; /* so that it may show */
    settings.tension_absurd = 400;
    options.law_a = wrong[_i][0];
    options.law_b = wrong[_i][1];
    cut(false);
    ck_assert(run->complete);
    const double speed = run->planned[run->recording.samples / 2];
    const double exponent = 1000 * job->force_law.b * job->heat / speed;
    const double off = options.law_a * exp(exponent * (1 - options.law_b)) - 1;
    ck_assert_double_eq_tol(run->steady.mean, off, 0.02 * (1 + off));
    ck_assert_double_gt(fabs(run->steady.mean), 0.2);
}

TEST(without_feedback_a_law_that_hides_the_force_ends_in_a_safe_stop) {
    options.law_b = 0.75;
    cut(false);
    ck_assert_int_eq(run->ended, WCUT_CONTROL_STATE_STOP_TENSION);
    ck_assert(!run->complete);
    ck_assert_int_eq(run->state[run->recording.samples - 1], WCUT_CONTROL_STATE_STOP_TENSION);
}

TEST_EACH(behind_a_density_step_the_tension_comes_back, 2) {
    const double factor[] = {1.5, 0.6};
    options.density = factor[_i];
    cut(true);
    ck_assert(run->complete && run->has_density);
    ck_assert_double_lt(run->density.max, 0.3);
    ck_assert_double_lt(run->density.settled, 4);
    ck_assert_double_lt(fabs(run->steady.mean), 0.05);
    cut(false);
    ck_assert_double_gt(run->density.settled, 10);
    ck_assert_double_gt(fabs(run->density.mean), 0.3);
}

TEST(the_wire_itself_is_stable_where_the_map_says_and_swings_where_it_does_not) {
    options.delay = 0.3; /* kernel/stability.svg: stable up to 2.5 times the default gains */
    options.density = 1.1;
    settings.gain *= 1.5;
    settings.rate *= 1.5;
    cut(true);
    ck_assert(run->complete && run->has_density);
    ck_assert_double_lt(run->density.settled, 3);
    ck_assert_double_lt(run->steady.rms, 0.03);
    settings.gain *= 3;
    settings.rate *= 3;
    cut(true);
    ck_assert(!run->complete || run->steady.rms > 0.2);
}

TEST(the_recording_is_one_of_its_seed_to_the_bit) {
    cut(true);
    wcut_rig_run *first = run;
    run = NULL;
    cut(true);
    ck_assert_int_eq(first->recording.samples, run->recording.samples);
    const size_t size = sizeof(double) * (size_t)run->recording.samples;
    for (int k = 0; k < WCUT_CHANNEL_COUNT; k++) {
        ck_assert((first->recording.channel[k].name != NULL) == (run->recording.channel[k].name != NULL));
        if (run->recording.channel[k].name)
            ck_assert_int_eq(memcmp(first->recording.channel[k].value, run->recording.channel[k].value, size), 0);
    }
    options.seed = 2;
    cut(true);
    ck_assert_int_ne(memcmp(first->recording.channel[WCUT_CHANNEL_TENSION_A].value,
                            run->recording.channel[WCUT_CHANNEL_TENSION_A].value, size / 2),
                     0);
    wcut_rig_run_destroy(first);
}

TEST(sensor_noise_is_as_large_as_asked_and_samples_come_at_20_hz) {
    options.noise_tension = 0.05;
    options.delay = 0;
    cut(true);
    double sum = 0, squares = 0;
    int count = 0;
    const wcut_column *c = run->recording.channel;
    for (int i = 0; i < run->recording.samples; i++) {
        const double e =
            (c[WCUT_CHANNEL_TENSION_A].value[i] + c[WCUT_CHANNEL_TENSION_B].value[i]) / 2 - run->tension[i];
        sum += e;
        squares += e * e;
        count++;
        if (i > 0)
            ck_assert_double_eq_tol(c[WCUT_CHANNEL_TIME].value[i] - c[WCUT_CHANNEL_TIME].value[i - 1], 0.05, 1e-9);
    }
    const double expected = 0.05 / sqrt(2);
    ck_assert_double_lt(fabs(sum / count), 4 * expected / sqrt(count));
    ck_assert_double_eq_tol(sqrt(squares / count), expected, 4 * expected / sqrt(2.0 * count));
}

TEST(the_excitation_is_run_once_the_wire_is_in_and_can_be_left_out) {
    wcut_dither dither = {.amplitude = 0.2, .period = 4};
    wcut_heat_step heat = {.from = 20, .to = 30, .factor = 0.9};
    job->dither = &dither;
    job->heat_step = &heat;
    job->dither_count = job->heat_step_count = 1;
    settings.tension_stop = 40; /* a plan alone that is dithered by a fifth pulls hard */
    settings.tension_absurd = 400;
    cut(false);
    const wcut_column *c = run->recording.channel;
    double max = 0;
    for (int i = 0; i < run->recording.samples; i++) {
        const double time = c[WCUT_CHANNEL_TIME].value[i], set = c[WCUT_CHANNEL_HEAT].value[i];
        if (time > 20.1 && time < 29.9) ck_assert(set == 0.9 * job->heat);
        if (time < 19.9 || time > 30.1) ck_assert(set == job->heat);
        if (run->phase[i] == WCUT_PHASE_STEADY) {
            const double factor = c[WCUT_CHANNEL_SPEED_COMMAND].value[i] / run->planned[i];
            ck_assert_double_eq_tol(factor, 1 + 0.2 * sin(2 * acos(-1) * time / 4), 0.03);
            max = fmax(max, factor);
        }
        if (run->phase[i] == WCUT_PHASE_APPROACH)
            ck_assert_double_le(c[WCUT_CHANNEL_SPEED_COMMAND].value[i], settings.speed_max);
    }
    ck_assert_double_gt(max, 1.15);
    options.excitation = false;
    cut(false);
    for (int i = 0; i < run->recording.samples; i++)
        ck_assert(run->recording.channel[WCUT_CHANNEL_HEAT].value[i] == job->heat);
    job->dither = NULL;
    job->heat_step = NULL;
    job->dither_count = job->heat_step_count = 0;
}

static int stop_at(int station, int stations, void *context) {
    ck_assert_int_le(station, stations);
    return station > *(int *)context;
}

TEST(an_interrupted_run_holds_what_was_cut) {
    int at = 50;
    ck_assert_int_eq(wcut_rig_run_create(job, plan, &settings, &options, stop_at, &at, &run, &error), WCUT_INTERRUPTED);
    ck_assert_ptr_nonnull(run);
    ck_assert(!run->complete && run->recording.samples > 10);
}

TEST(what_is_out_of_range_is_refused_and_nothing_is_written) {
    wcut_rig_options bad[6];
    for (int k = 0; k < 6; k++) bad[k] = options;
    bad[0].law_a = 0;
    bad[1].delay = -1;
    bad[2].noise_tension = NAN;
    bad[3].period = 0;
    bad[4].density_from = INFINITY;
    bad[5].decimation = -1;
    for (int k = 0; k < 6; k++) {
        ck_assert_int_eq(wcut_rig_run_create(job, plan, &settings, &bad[k], NULL, NULL, &run, &error),
                         WCUT_BAD_ARGUMENT);
        ck_assert_ptr_null(run);
    }
    ck_assert_int_eq(wcut_rig_run_create(NULL, plan, &settings, NULL, NULL, NULL, &run, &error), WCUT_BAD_ARGUMENT);
    settings.gain = NAN;
    ck_assert_int_eq(wcut_rig_run_create(job, plan, &settings, NULL, NULL, NULL, &run, &error), WCUT_BAD_ARGUMENT);
    settings = wcut_control_settings_default(job);
    job->stations--; /* another path than the plan's */
    ck_assert_int_eq(wcut_rig_run_create(job, plan, &settings, NULL, NULL, NULL, &run, &error), WCUT_BAD_ARGUMENT);
    job->stations++;
    job->wire_length /= 2;
    ck_assert_int_eq(wcut_rig_run_create(job, plan, &settings, NULL, NULL, NULL, &run, &error), WCUT_DEGENERATE);
    job->wire_length *= 2;
    ck_assert_ptr_null(run);
    wcut_rig_run_destroy(NULL);
}

TEST(no_memory_is_said_and_nothing_is_written) {
    int at = 2; /* long enough for the first samples */
    for (long k = 1; k <= 90; k++) {
        wcut_alloc_fail_at(k);
        const wcut_status status = wcut_rig_run_create(job, plan, &settings, &options, stop_at, &at, &run, &error);
        wcut_alloc_fail_at(0);
        ck_assert(status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED);
        if (status == WCUT_NO_MEMORY) ck_assert_ptr_null(run);
        if (k == 1) ck_assert_int_eq(status, WCUT_NO_MEMORY);
        wcut_rig_run_destroy(run);
        run = NULL;
    }
}

FIXTURE_ONCE(begin, end);
FIXTURE(prepare, forget);
