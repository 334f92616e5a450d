/* The controller alone: its law against the closed form, limits, anti-windup, watchdog, and what a step never does. */
#include <math.h>
#include <stddef.h>
#include <string.h>
#include <wirecut/control.h>

#include "base/alloc.h"
#include "base/random.h"
#include "test.h"

/* labels: unit property */

enum { STATIONS = 101 };

static wcut_history_row row[STATIONS];
static wcut_history plan;
static wcut_control_settings settings;
static wcut_control *control;
static wcut_error error;

/* stations 4 mm apart: approach at 100 mm/s up to station 20, a cut at 20 mm/s, out again from station 90 on */
static void prepare(void) {
    memset(row, 0, sizeof row);
    for (int j = 0; j < STATIONS; j++) {
        const wcut_phase phase = j <= 20 ? WCUT_PHASE_APPROACH : j <= 90 ? WCUT_PHASE_STEADY : WCUT_PHASE_LEFT;
        row[j].phase = phase;
        row[j].speed_a = phase == WCUT_PHASE_STEADY ? 20 : 100;
        row[j].speed_b = 0.5 * row[j].speed_a;
        row[j].duration = j ? 4 / row[j].speed_a : 0;
        row[j].time = j ? row[j - 1].time + row[j].duration : 0;
        row[j].tension_a = row[j].tension_b = phase == WCUT_PHASE_STEADY ? 2 : 0;
    }
    plan = (wcut_history){.stations = STATIONS, .planned = STATIONS, .nodes = 3, .row = row};
    wcut_job job = {.tension = 2, .heat = 60, .force_law = {0.1, 8.6e-4}, .speed_min = 0.1, .speed_max = 100};
    settings = wcut_control_settings_default(&job);
    control = NULL;
    error = (wcut_error){.status = WCUT_OK};
}

static void forget(void) { wcut_control_destroy(control); }

static void make(void) { ck_assert_int_eq(wcut_control_create(&settings, &plan, &control, &error), WCUT_OK); }

static wcut_control_view look(void) {
    wcut_control_view view;
    wcut_control_look(control, &view);
    return view;
}

static double step(double time, double station, double a, double b) {
    double speed = 999;
    ck_assert_int_eq(wcut_control_step(control, time, station, a, b, &speed), WCUT_OK);
    return speed;
}

/* run from rest with readings that jitter by a millionth, as a sensor's do; gives the last speed */
static double go(int steps, double station, double tension) {
    static double time; /* of the test's one loop */
    double speed = 0;
    time = 0;
    for (int i = 0; i < steps; i++, time += 0.02) {
        const double t = tension + 1e-6 * (i % 7);
        speed = step(time, station, t, t);
    }
    return speed;
}

TEST(a_machine_begins_at_rest_and_reaches_the_plan_within_its_acceleration) {
    settings.feedback = false;
    make();
    ck_assert(step(0, 50, 2, 2) == 0);
    double before = 0;
    for (int i = 1; i < 100; i++) {
        const double speed = step(0.02 * i, 50, 2 + 1e-3 * (i % 2), 2);
        ck_assert_double_le(speed - before, settings.acceleration * 0.02 + 1e-9);
        before = speed;
    }
    ck_assert_double_eq_tol(before, 20, 1e-12);
}

TEST(the_correction_is_the_proportional_and_the_integral_of_the_log_error) {
    settings.caution = settings.filter = 0;
    settings.acceleration = 1e9;
    make();
    const double e = log(2.2 / 2), dt = 0.02;
    step(0, 50, 2.2, 2.2);
    for (int i = 1; i <= 10; i++) {
        const double speed = step(dt * i, 50, 2.2 + 1e-12 * i, 2.2 - 1e-12 * i);
        const double u = settings.gain * e + settings.rate * e * dt * i;
        ck_assert_double_eq_tol(look().correction, u, 1e-12);
        ck_assert_double_eq_tol(settings.exponent_speed / speed, settings.exponent_speed / 20 + u, 1e-9);
    }
}

TEST(against_a_foam_whose_law_is_wrong_the_loop_ends_at_the_speed_of_the_closed_form) {
    /* T = k (a'/a) exp(-s'/v + s/20): v* = s' / (s/20 + ln(a'/a)) */
    const double wrong[][2] = {{1.25, 1}, {0.75, 1}, {1, 1.25}, {1, 0.75}, {1.25, 0.75}, {0.75, 1.25}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        make();
        const double s = settings.exponent_speed, ratio = wrong[k][0], s_true = s * wrong[k][1];
        double speed = 10;
        wcut_random random = wcut_random_seed(k);
        for (int i = 0; i < 1000; i++) {
            const double tension =
                2 * ratio * exp(s / 20 - s_true / fmax(speed, 1)) + 1e-6 * wcut_random_normal(&random);
            speed = step(0.02 * i, 50, tension, tension);
        }
        ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_RUN);
        ck_assert_double_eq_tol(speed, s_true / (s / 20 + log(ratio)), 1e-3);
        forget();
        control = NULL;
    }
}

TEST(an_approach_slows_down_before_contact_and_speeds_up_only_behind_the_block) {
    settings.feedback = false;
    make();
    double station = 0, time = 0, speed = 0, before = 0;
    while (station < STATIONS - 1) {
        speed = step(time, station, 0, 0);
        ck_assert_double_le(fabs(speed - before), settings.acceleration * 0.01 + 1e-9);
        if (station > 20 - settings.margin / 4 && station < 90 + settings.margin / 4 - 1)
            ck_assert_msg(speed < 20 * 1.01, "%.2f mm/s at station %.2f", speed, station);
        before = speed;
        station += speed * 0.01 / 4;
        time += 0.01;
    }
    ck_assert_double_gt(speed, 50);
}

TEST(without_a_load_there_is_no_reason_to_go_faster_than_the_plan) {
    settings.caution = 0;
    make();
    ck_assert_double_eq_tol(go(500, 50, 0), 20, 1e-9);
    ck_assert(look().correction == 0);
}

TEST(the_integral_does_not_wind_up_at_a_speed_limit) {
    settings.caution = 0;
    settings.speed_max = 22;
    make();
    double time = 0;
    for (int i = 0; i < 2000; i++, time += 0.02) step(time, 50, 1.6 + 1e-6 * (i % 5), 1.6);
    ck_assert_double_eq_tol(look().speed, 22, 1e-12);
    for (int i = 0; i < 25; i++, time += 0.02) step(time, 50, 2.4 + 1e-6 * (i % 5), 2.4);
    ck_assert_double_lt(look().speed, 20.5); /* half a second later it is below the plan, not at the limit */
}

TEST(readings_that_cannot_be_are_dropped_and_end_in_a_stop_when_they_last) {
    const double bad[] = {NAN, INFINITY, -INFINITY, -1, 1e3};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        for (int mount = 0; mount < 2; mount++) {
            make();
            const double running = go(100, 50, 2.0);
            double speed = step(2.0, 50, mount ? 2 : bad[k], mount ? bad[k] : 2);
            ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_HOLD);
            ck_assert_double_eq_tol(speed, running, 0.1);
            step(2.02, 50, 2.00001, 2);
            ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_RUN);
            for (int i = 0; i < 30; i++) speed = step(2.04 + 0.02 * i, 50, mount ? 2 : bad[k], mount ? bad[k] : 2);
            ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_ABSURD);
            for (int i = 0; i < 30; i++) speed = step(2.64 + 0.02 * i, 50, 2 + 1e-3 * i, 2);
            ck_assert(speed == 0);
            ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_ABSURD);
            forget();
            control = NULL;
        }
}

TEST(a_sensor_that_repeats_itself_under_load_stops_the_machine_one_without_load_does_not) {
    make();
    for (int i = 0; i < 40; i++) step(0.02 * i, 50, 1.9, 2.1);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_STALE);
    forget();
    control = NULL;
    make();
    for (int i = 0; i < 400; i++) step(0.02 * i, 10, 0, 0);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_RUN);
}

TEST(a_clock_that_stands_still_runs_back_or_jumps_stops_the_machine) {
    const double next[] = {1.98, 1.0, NAN, INFINITY};
    for (size_t k = 0; k < sizeof next / sizeof *next; k++) {
        make();
        go(100, 50, 2);
        step(next[k], 50, 2, 2);
        ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_HOLD);
        double speed = 999;
        for (int i = 0; i < 200; i++) speed = step(next[k], 50, 2, 2);
        ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_STALE);
        ck_assert(speed == 0);
        forget();
        control = NULL;
    }
    make();
    const double before = go(100, 50, 2), after = step(3.0, 50, 2, 2);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_STALE);
    ck_assert_double_le(before - after, settings.acceleration * 0.02 + 1e-9);
}

TEST(over_tension_of_one_mount_twice_in_a_row_stops_for_good_a_single_spike_does_not) {
    make();
    go(100, 50, 2);
    step(2.00, 50, 6, 2);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_RUN);
    step(2.02, 50, 2, 2.1);
    step(2.04, 50, 2, 6);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_RUN);
    double before = step(2.06, 50, 2, 6.1);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_TENSION);
    for (int i = 0; i < 20; i++) {
        const double speed = step(2.08 + 0.02 * i, 50, 2, 2.01);
        ck_assert_double_le(before - speed, settings.acceleration * 0.02 + 1e-9);
        before = speed;
    }
    ck_assert(before == 0);
    ck_assert_int_eq(look().state, WCUT_CONTROL_STATE_STOP_TENSION);
}

TEST(whatever_is_read_the_speed_is_finite_within_its_limits_and_its_acceleration) {
    wcut_random random = wcut_random_seed(5);
    const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 0, -0.0, 5e-324, 4.9, 5.1};
    for (int round = 0; round < 200; round++) {
        make();
        double time = 0, before = 0;
        for (int i = 0; i < 300; i++) {
            double value[4];
            for (int k = 0; k < 4; k++)
                value[k] = wcut_random_below(&random, 8) ? 2 + wcut_random_normal(&random)
                                                         : odd[wcut_random_below(&random, 10)];
            const double dt = 0.04 * wcut_random_uniform(&random);
            const double now = wcut_random_below(&random, 20) ? time + dt : value[3];
            const double speed = step(now, 30 * value[2], value[0], value[1]);
            ck_assert(isfinite(speed) && speed >= 0 && speed <= settings.speed_max);
            ck_assert_double_le(fabs(speed - before), settings.acceleration * settings.fault_time + 1e-9);
            before = speed;
            if (now > time && now < time + 0.5) time = now;
        }
        forget();
        control = NULL;
    }
}

TEST(settings_out_of_range_are_refused_by_name) {
    const struct {
        size_t at;
        const char *name;
        double bad;
    } wrong[] = {{offsetof(wcut_control_settings, tension), "tension", 0},
                 {offsetof(wcut_control_settings, exponent_speed), "exponent_speed", NAN},
                 {offsetof(wcut_control_settings, gain), "gain", -1},
                 {offsetof(wcut_control_settings, rate), "rate", INFINITY},
                 {offsetof(wcut_control_settings, filter), "filter", -0.1},
                 {offsetof(wcut_control_settings, authority), "authority", 0},
                 {offsetof(wcut_control_settings, speed_min), "speed_min", 200},
                 {offsetof(wcut_control_settings, speed_max), "speed_max", -1},
                 {offsetof(wcut_control_settings, acceleration), "acceleration", 0},
                 {offsetof(wcut_control_settings, caution), "caution", -1},
                 {offsetof(wcut_control_settings, margin), "margin", NAN},
                 {offsetof(wcut_control_settings, noise), "noise", -1},
                 {offsetof(wcut_control_settings, tension_stop), "tension_stop", 1},
                 {offsetof(wcut_control_settings, tension_absurd), "tension_absurd", 0},
                 {offsetof(wcut_control_settings, fault_time), "fault_time", 0}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        wcut_control_settings s = settings;
        *(double *)((char *)&s + wrong[k].at) = wrong[k].bad;
        ck_assert_int_eq(wcut_control_create(&s, &plan, &control, &error), WCUT_BAD_ARGUMENT);
        ck_assert_ptr_null(control);
        ck_assert_msg(strstr(error.text, wrong[k].name) != NULL, "%s: %s", wrong[k].name, error.text);
    }
}

TEST(a_plan_that_is_none_is_refused_and_nothing_is_written) {
    ck_assert_int_eq(wcut_control_create(NULL, &plan, &control, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_control_create(&settings, NULL, &control, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_control_create(&settings, &plan, NULL, &error), WCUT_BAD_ARGUMENT);
    plan.stations = 50; /* a cut that ended early */
    ck_assert_int_eq(wcut_control_create(&settings, &plan, &control, &error), WCUT_BAD_ARGUMENT);
    plan.stations = STATIONS;
    row[30].speed_a = row[30].speed_b = NAN;
    ck_assert_int_eq(wcut_control_create(&settings, &plan, &control, &error), WCUT_BAD_ARGUMENT);
    row[30].speed_a = 20;
    row[30].tension_b = INFINITY;
    ck_assert_int_eq(wcut_control_create(&settings, &plan, &control, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(control);
    double speed = 999;
    ck_assert_int_eq(wcut_control_step(NULL, 0, 0, 0, 0, &speed), WCUT_BAD_ARGUMENT);
    ck_assert(speed == 999);
    wcut_control_destroy(NULL);
}

TEST(no_memory_is_said_and_nothing_is_written) {
    FIRST_FAILED_ALLOCATIONS(3, wcut_control_create(&settings, &plan, &control, &error), !control);
    make();
    step(0, 50, 2, 2);
    wcut_alloc_fail_at(1); /* a step asks for none: the counter is not used up */
    for (int i = 1; i < 100; i++) step(0.02 * i, 50, 2, 2 + 1e-6 * i);
    ck_assert_ptr_null(wcut_alloc(1, 1));
    wcut_alloc_fail_at(0);
}

TEST(every_state_has_its_words) {
    ck_assert_str_eq(wcut_control_state_name(WCUT_CONTROL_STATE_RUN), "run");
    ck_assert_str_eq(wcut_control_state_name(WCUT_CONTROL_STATE_STOP_STALE), "stop: stale readings");
    ck_assert_str_eq(wcut_control_state_name((wcut_control_state)99), "unknown");
}

FIXTURE(prepare, forget);
