/* The programme of an identification cut in a plan, against its closed form; heater targets. */
#include <math.h>
#include <string.h>
#include <wirecut/robot.h>

#include "base/numbers.h"
#include "test.h"

enum { STATIONS = 101 };

static wcut_history_row row[STATIONS];
static wcut_vec3 mount[STATIONS];
static wcut_dither dither[2] = {{0.05, 3, 1}, {0.04, 5, -0.5}};
static wcut_heat_step step[2] = {{4.03, 7, 0.9}, {7, 9.5, 1.1}};

/* even 20 mm/s, a station every 0.1 s, in the foam from station 20 on */
static wcut_history even_history(void) {
    for (int j = 0; j < STATIONS; j++) {
        row[j] = (wcut_history_row){.time = 0.1 * j, .duration = 0.1, .speed_a = 20, .speed_b = 10};
        row[j].engaged_length = j < 20 ? 0 : 300;
        mount[j] = (wcut_vec3){0, 2 * j, 0};
    }
    return (wcut_history){.stations = STATIONS, .planned = STATIONS, .row = row};
}

static const wcut_job job = {.heat = 60, .dither_count = 2, .dither = dither, .heat_step_count = 2, .heat_step = step};

/* integral of 1 + sum A sin(2 pi t / P + phase) */
static double integral(double from, double to) {
    double sum = to - from;
    for (int k = 0; k < 2; k++) {
        const double w = 2 * WCUT_PI / dither[k].period, phase = dither[k].phase;
        sum += dither[k].amplitude / w * (cos(w * from + phase) - cos(w * to + phase));
    }
    return sum;
}

TEST(the_way_of_each_step_is_the_integral_of_the_pace) {
    wcut_history h = even_history();
    ck_assert_int_eq(wcut_history_excite(&job, &h, NULL), WCUT_OK);
    for (int j = 1; j < STATIONS; j++) {
        const double plan = j <= 20 ? row[j].time - row[j - 1].time : integral(row[j - 1].time, row[j].time);
        ck_assert_double_eq_tol(plan, 0.1, 1e-12);
        ck_assert_double_eq_tol(row[j].speed_a * row[j].duration, 2, 1e-12);
        ck_assert_double_eq_tol(row[j].speed_b, row[j].speed_a / 2, 1e-12);
    }
    ck_assert_double_eq(row[20].time, 2.0);
}

TEST(without_a_programme_nothing_changes) {
    wcut_history h = even_history();
    ck_assert_int_eq(wcut_history_excite(&(wcut_job){.heat = 60}, &h, NULL), WCUT_OK);
    for (int j = 0; j < STATIONS; j++) ck_assert_double_eq_tol(row[j].time, 0.1 * j, 1e-12);
}

TEST(a_sine_that_the_stations_cannot_follow_is_refused_and_nothing_is_changed) {
    wcut_history h = even_history();
    wcut_error error = {0};
    wcut_dither quick = {0.05, 0.4, 0};
    ck_assert_int_eq(wcut_history_excite(&(wcut_job){.dither_count = 1, .dither = &quick}, &h, &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "station 20 comes 0.1 s"));
    quick = (wcut_dither){1.2, 5, 0};
    ck_assert_int_eq(wcut_history_excite(&(wcut_job){.dither_count = 1, .dither = &quick}, &h, &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_excite(NULL, &h, &error), WCUT_BAD_ARGUMENT);
    ck_assert_double_eq(row[50].time, 5.0);
}

TEST(the_heater_s_changes_have_targets_of_their_own) {
    wcut_history h = even_history();
    wcut_robot_options o = wcut_robot_options_default();
    wcut_robot_motion *m = NULL;
    o.heater = &job;
    ck_assert_int_eq(wcut_robot_motion_create(&h, mount, mount, &o, &m, NULL), WCUT_OK);
    ck_assert_int_eq(m->count, 5); /* an even straight way has two targets, and three changes lie on it */
    static const double time[] = {4.03, 7, 9.5}, heat[] = {54, 66, 60};
    for (int k = 0; k < 3; k++) {
        const wcut_robot_target *t = &m->target[k + 1];
        ck_assert_double_eq_tol(t->time, time[k], 1e-12);
        ck_assert_double_eq_tol(t->heat, heat[k], 1e-12);
        ck_assert_double_eq_tol(t->a.y, 20 * time[k], 1e-9);
        ck_assert_double_eq_tol(t->speed_a, 20, 1e-9);
        ck_assert_int_eq(t->station, -3);
    }
    ck_assert_double_eq(m->target[0].heat, 0);
    ck_assert_double_eq(m->target[4].heat, 0);
    wcut_robot_motion_destroy(m);
}
