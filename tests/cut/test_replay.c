/* Predictions of a recording: exact where it came from the same wire, and honest where samples are missing. */
#include <wirecut/recording_file.h>
#include "base/alloc.h"
#include "base/random.h"
#include "cut/trials.h"
#include "test.h"

enum { SAMPLES = 150, TENSION_A = 2, TENSION_B = 3, ALPHA_A = 4 };
#define PACE 3.0 /* stations a second, 18 mm/s */
#define STEP 0.1

static wcut_job *job;
static wcut_setup *setup;
static wcut_recording *recording;
static wcut_prediction *prediction;
static wcut_error error;

static void given_a_driven_cut(void) {
    job = short_job();
    setup = setup_of(job, NULL);
    recording = driven_recording(job, PACE, STEP, SAMPLES);
    prediction = NULL;
}

static void forget(void) {
    wcut_prediction_destroy(prediction);
    wcut_recording_destroy(recording);
    wcut_setup_destroy(setup);
    wcut_job_destroy(job);
}

static wcut_status replay(double window) {
    wcut_replay_options o = wcut_replay_options_default();
    o.window = window;
    wcut_prediction_destroy(prediction);
    prediction = NULL;
    error = (wcut_error){0};
    return wcut_prediction_replay(setup, recording, &o, &prediction, &error);
}

static void refused(const char *words) {
    ck_assert_int_eq(replay(0), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(prediction);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
}

/* ---- the motion ---- */

TEST(smoothing_keeps_a_parabola_whatever_the_sampling) {
    double t[40], y[40], smooth[40];
    for (int i = 0; i < 40; i++) {
        t[i] = 0.05 * i + 0.02 * sin(7.0 * i);
        y[i] = 3 - 2 * t[i] + 0.7 * t[i] * t[i];
        smooth[i] = 999;
    }
    wcut_smooth(40, t, y, 0.5, smooth);
    for (int i = 0; i < 40; i++) ck_assert_double_eq_tol(smooth[i], y[i], 1e-13);
}

TEST(smoothing_answers_an_impulse_with_savitzky_and_golays_weights) {
    const double weight[5] = {-3, 12, 17, 12, -3};
    double t[21], y[21] = {0}, smooth[21];
    for (int i = 0; i < 21; i++) t[i] = i;
    y[10] = 35;
    wcut_smooth(21, t, y, 4, smooth);
    for (int i = -2; i <= 2; i++) ck_assert_double_eq_tol(smooth[10 + i], weight[i + 2], 1e-12);
    ck_assert(smooth[7] == 0 && smooth[13] == 0);
}

TEST(smoothing_leaves_alone_what_it_cannot_determine) {
    const double t[6] = {0, 1, 5, 5 + 1e-13, 5 + 2e-13, 9}, y[6] = {1, -1, 4, 2, 8, 3};
    double smooth[6] = {999, 999, 999, 999, 999, 999};
    wcut_smooth(6, t, y, 0.5, smooth);
    for (int i = 0; i < 6; i++) ck_assert_double_eq(smooth[i], y[i]);
}

TEST(a_path_goes_through_its_stations_smoothly_and_never_backwards) {
    const wcut_vec3 p[5] = {{0, 0, 0}, {0, 1, 0}, {0, 11, 0}, {0, 12, 0}, {0, 13, 0}}; /* spacings 1 and 10 */
    for (int j = 0; j < 5; j++) ck_assert_double_eq(wcut_path_at(5, p, j).y, p[j].y);
    double before = 0;
    for (double s = 0.01; s < 4; s += 0.01) {
        const double y = wcut_path_at(5, p, s).y;
        ck_assert(y > before);
        before = y;
    }
    const double h = 1e-6; /* one slope from both sides */
    const double left = (p[1].y - wcut_path_at(5, p, 1 - h).y) / h, right = (wcut_path_at(5, p, 1 + h).y - p[1].y) / h;
    ck_assert_double_eq_tol(left, right, 1e-3);
}

/* ---- replayed ---- */

TEST(the_replay_of_a_driven_wire_is_that_wire) {
    double worst;
    given_a_driven_cut();
    ck_assert_int_eq(replay(0), WCUT_OK);
    ck_assert_int_eq(prediction->failed + prediction->standing + prediction->without_motion, 0);
    ck_assert_int_eq(prediction->first_failed, -1);
    for (int k = 0; k < WCUT_SIGNAL_COUNT; k++) {
        ck_assert_int_eq(compare_signal(recording, prediction, k, &worst), SAMPLES);
        ck_assert_msg(worst < 1e-8, "signal %d: %g", k, worst);
    }
    double max = 0; /* the wire was in the foam at all */
    for (int i = 0; i < SAMPLES; i++) max = fmax(max, prediction->value[TENSION_A][i]);
    ck_assert(max > 0.5);
    forget();
}

TEST(smoothing_an_even_motion_changes_nothing) {
    double worst;
    given_a_driven_cut();
    ck_assert_int_eq(replay(0.5), WCUT_OK);
    ck_assert_int_eq(compare_signal(recording, prediction, TENSION_B, &worst), SAMPLES);
    ck_assert(worst < 1e-8 && prediction->scatter < 1e-12);
    forget();
}

/* RMS of the replayed tension's residual while the wire is in the foam */
static double tension_scatter(void) {
    double sum = 0;
    for (int i = 60; i < 100; i++) {
        ck_assert(prediction->present[i]);
        const double d = prediction->value[TENSION_A][i] - values(recording, WCUT_CHANNEL_TENSION_A)[i];
        sum += d * d;
    }
    return sqrt(sum / 40);
}

TEST(an_encoders_noise_is_smoothed_out_of_the_tension) {
    given_a_driven_cut();
    wcut_random random = wcut_random_seed(5);
    for (int i = 0; i < SAMPLES; i++) values(recording, WCUT_CHANNEL_STATION)[i] += 0.01 * wcut_random_normal(&random);
    ck_assert_int_eq(replay(0), WCUT_OK);
    const double raw = tension_scatter();
    ck_assert_int_eq(replay(1), WCUT_OK);
    const double smoothed = tension_scatter();
    ck_assert_msg(smoothed < raw / 3, "raw %g N, smoothed %g N", raw, smoothed);
    ck_assert_double_eq_tol(prediction->scatter, 0.01 * sqrt(1 - 0.207), 0.002); /* eleven points less a parabola */
    forget();
}

TEST(missing_samples_stay_missing_and_a_gap_is_stepped_over) {
    given_a_driven_cut();
    for (int i = 60; i < 75; i++) lose_sample(recording, WCUT_CHANNEL_STATION, i);
    ck_assert_int_eq(replay(0), WCUT_OK);
    ck_assert_int_eq(prediction->without_motion, 15);
    for (int i = 0; i < SAMPLES; i++) ck_assert_int_eq(prediction->present[i], i < 60 || i >= 75);
    /* the gap's motion was even: longer steps over it, nearly the same wire behind it */
    for (int i = 75; i < 100; i++) {
        ck_assert_double_eq_tol(prediction->value[TENSION_A][i], values(recording, WCUT_CHANNEL_TENSION_A)[i], 0.02);
        ck_assert_double_eq_tol(prediction->value[ALPHA_A][i], values(recording, WCUT_CHANNEL_ALPHA_A)[i], 0.01);
    }
    forget();
}

TEST(a_mount_that_stands_or_jitters_back_gets_no_step) {
    given_a_driven_cut();
    double *station = values(recording, WCUT_CHANNEL_STATION);
    station[80] = station[79];
    station[81] = station[79] - 0.4;
    ck_assert_int_eq(replay(0), WCUT_OK);
    ck_assert_int_eq(prediction->standing, 2);
    ck_assert(!prediction->present[80] && !prediction->present[81] && prediction->present[82]);
    /* the way of three samples in three samples' time: the speed that was driven is the even one */
    ck_assert_double_eq_tol(prediction->value[0][82], 18, 1e-6);
    forget();
}

TEST(a_recording_that_begins_late_is_led_in_along_the_path) {
    given_a_driven_cut();
    for (int i = 0; i < SAMPLES; i++) /* the first 40 samples were not recorded */
        for (int k = 0; k <= WCUT_CHANNEL_BETA_B && i + 40 < SAMPLES; k++)
            values(recording, (wcut_channel)k)[i] = values(recording, (wcut_channel)k)[i + 40];
    recording->samples = SAMPLES - 40;
    ck_assert_int_eq(replay(0), WCUT_OK);
    ck_assert_int_eq(prediction->present[0], 1);
    for (int i = 30; i < 60; i++)
        ck_assert_double_eq_tol(prediction->value[TENSION_A][i], values(recording, WCUT_CHANNEL_TENSION_A)[i], 0.02);
    forget();
}

TEST(heat_is_the_recordings_and_held_where_it_is_missing) {
    given_a_driven_cut();
    ck_assert_int_eq(replay(0), WCUT_OK);
    const double usual = prediction->value[TENSION_A][90];
    double *heat = add_channel(recording, WCUT_CHANNEL_HEAT);
    for (int i = 0; i < SAMPLES; i++) heat[i] = 1.2 * job->heat;
    for (int i = 50; i < SAMPLES; i++) lose_sample(recording, WCUT_CHANNEL_HEAT, i);
    ck_assert_int_eq(replay(0), WCUT_OK);
    const double hot = prediction->value[TENSION_A][90];
    ck_assert(hot < 0.9 * usual);
    heat[7] = -1;
    refused("line 9: heat_W_per_m: found -1");
    forget();
}

TEST(without_a_heat_column_the_jobs_programme_holds) {
    given_a_driven_cut();
    job->heat_step = wcut_alloc(1, sizeof *job->heat_step);
    job->heat_step[job->heat_step_count++] = (wcut_heat_step){.from = 0, .to = 9, .factor = 1.2};
    wcut_setup_destroy(setup);
    setup = setup_of(job, NULL);
    ck_assert_int_eq(replay(0), WCUT_OK);
    ck_assert(prediction->value[TENSION_A][80] < 0.9 * values(recording, WCUT_CHANNEL_TENSION_A)[80]);
    ck_assert_double_eq_tol(prediction->value[TENSION_A][110], values(recording, WCUT_CHANNEL_TENSION_A)[110], 0.02);
    forget();
}

static void measure_positions(void) {
    for (int k = 0; k < 6; k++) {
        double *to = add_channel(recording, (wcut_channel)(WCUT_CHANNEL_A_X + k));
        for (int i = 0; i < SAMPLES; i++) {
            const wcut_vec3 *path = k < 3 ? job->mount_a : job->mount_b;
            const wcut_vec3 p = wcut_path_at(job->stations, path, values(recording, WCUT_CHANNEL_STATION)[i]);
            to[i] = k % 3 == 0 ? p.x : k % 3 == 1 ? p.y : p.z;
        }
    }
}

TEST(measured_positions_replay_alike_and_a_sample_that_fails_is_counted) {
    double worst;
    given_a_driven_cut();
    measure_positions();
    const wcut_replay_options o = {.motion = WCUT_MOTION_POSITION, .window = 0};
    ck_assert_int_eq(wcut_prediction_replay(setup, recording, &o, &prediction, NULL), WCUT_OK);
    ck_assert_int_eq(compare_signal(recording, prediction, TENSION_A, &worst), SAMPLES);
    ck_assert(worst < 1e-6);
    /* mounts further apart than the wire is long */
    values(recording, WCUT_CHANNEL_B_X)[70] += 100;
    wcut_prediction_destroy(prediction);
    ck_assert_int_eq(wcut_prediction_replay(setup, recording, &o, &prediction, NULL), WCUT_OK);
    ck_assert_int_eq(prediction->failed, 1);
    ck_assert_int_eq(prediction->first_failed, 70);
    ck_assert(!prediction->present[70] && prediction->present[71] && prediction->value[TENSION_A][70] == 0);
    ck_assert_msg(strstr(prediction->cause.text, "the wire is 380 mm long") != NULL, "%s", prediction->cause.text);
    ck_assert_double_eq_tol(prediction->value[TENSION_A][90], values(recording, WCUT_CHANNEL_TENSION_A)[90], 0.02);
    forget();
}

/* ---- planned ---- */

TEST(the_plan_is_its_rows_at_stations_and_its_speeds_between_them) {
    given_a_driven_cut();
    wcut_history *plan = run_of(job);
    for (int i = 0; i < SAMPLES; i++) values(recording, WCUT_CHANNEL_STATION)[i] = 0.5 * i;
    lose_sample(recording, WCUT_CHANNEL_STATION, 3);
    ck_assert_int_eq(wcut_prediction_plan(plan, recording, &prediction, NULL), WCUT_OK);
    for (int i = 0; i < SAMPLES; i++) {
        const wcut_history_row *row = &plan->row[i / 2], *next = &plan->row[i / 2 + 1];
        ck_assert_int_eq(prediction->present[i], i != 3);
        if (i == 3) continue;
        if (i % 2 == 0) {
            ck_assert_double_eq_tol(prediction->value[TENSION_B][i], row->tension_b, 1e-12);
            ck_assert_double_eq_tol(prediction->value[ALPHA_A][i], row->alpha_a, 1e-12);
        } else {
            ck_assert_double_eq_tol(prediction->value[0][i], next->speed_a, 1e-12);
            ck_assert_double_eq_tol(prediction->value[1][i], next->speed_b, 1e-12);
            ck_assert_double_eq_tol(prediction->value[TENSION_B][i], (row->tension_b + next->tension_b) / 2, 1e-12);
        }
    }
    wcut_history_destroy(plan);
    forget();
}

TEST(a_plan_that_ended_early_predicts_up_to_there) {
    given_a_driven_cut();
    wcut_history *plan = run_of(job);
    plan->stations = 21;
    ck_assert_int_eq(wcut_prediction_plan(plan, recording, &prediction, NULL), WCUT_OK);
    for (int i = 0; i < SAMPLES; i++)
        ck_assert_int_eq(prediction->present[i], values(recording, WCUT_CHANNEL_STATION)[i] <= 20);
    ck_assert_int_eq(prediction->first_failed, 66);
    ck_assert(strstr(prediction->cause.text, "ended at station 20 of 80") != NULL);
    wcut_history_destroy(plan);
    forget();
}

/* ---- what is refused ---- */

TEST(stations_outside_the_path_and_ways_back_are_refused_with_their_line) {
    given_a_driven_cut();
    double *station = values(recording, WCUT_CHANNEL_STATION);
    const double good = station[30];
    station[30] = 82;
    refused("line 32: station: found 82, expected 0 .. 80");
    station[30] = -1.5;
    refused("line 32: station: found -1.5, expected 0 .. 80");
    station[30] = good - 2;
    refused("line 32: station: found 7.3 after 9, expected no more than one station back");
    station[30] = good;
    ck_assert_int_eq(replay(0), WCUT_OK);
    for (int i = 0; i < SAMPLES; i++) lose_sample(recording, WCUT_CHANNEL_STATION, i);
    refused("station: found no sample");
    forget();
}

TEST(options_jobs_and_arguments_that_cannot_be_are_refused) {
    given_a_driven_cut();
    ck_assert_int_eq(replay(-1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(replay(NAN), WCUT_BAD_ARGUMENT);
    const wcut_replay_options o = {.motion = WCUT_MOTION_POSITION, .window = 0};
    ck_assert_int_eq(wcut_prediction_replay(setup, recording, &o, &prediction, &error), WCUT_BAD_ARGUMENT);
    ck_assert(strstr(error.text, "a_x_mm") != NULL);
    ck_assert_int_eq(wcut_prediction_replay(NULL, recording, NULL, &prediction, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_prediction_replay(setup, NULL, NULL, &prediction, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_prediction_replay(setup, recording, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_prediction_plan(NULL, recording, &prediction, NULL), WCUT_BAD_ARGUMENT);
    const wcut_history none = {.stations = 0, .planned = 81};
    ck_assert_int_eq(wcut_prediction_plan(&none, recording, &prediction, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(prediction);
    wcut_job *design = sample_job("freeform-3.json");
    wcut_setup *of_design = setup_of(design, NULL);
    ck_assert_int_eq(wcut_prediction_replay(of_design, recording, NULL, &prediction, &error), WCUT_BAD_ARGUMENT);
    ck_assert(strstr(error.text, "design") != NULL);
    wcut_setup_destroy(of_design);
    wcut_job_destroy(design);
    wcut_prediction_destroy(NULL);
    forget();
}

TEST(without_memory_nothing_is_written) {
    given_a_driven_cut();
    recording->samples = 3;
    wcut_history *plan = run_of(job);
    for (int which = 0; which < 2; which++) {
        wcut_prediction_destroy(prediction);
        prediction = NULL;
        EACH_FAILED_ALLOCATION(which ? wcut_prediction_plan(plan, recording, &prediction, NULL)
                                     : wcut_prediction_replay(setup, recording, NULL, &prediction, NULL),
                               !prediction);
    }
    wcut_history_destroy(plan);
    forget();
}
