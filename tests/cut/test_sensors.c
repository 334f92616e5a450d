/* What faulty instruments make of a prediction, by their formulas. labels: unit */
#include <wirecut/effects.h>

#include "base/alloc.h"
#include "cut/cuts.h"
#include "test.h"

enum { N = 200 };

static double time[N], signal[WCUT_SENSED_COUNT][N];
static unsigned char present[N];
static double *value[WCUT_SENSED_COUNT];

static double truth(int k, double t) { return 2 + k + 0.3 * t; } /* linear: interpolation between samples is exact */

static void given_signals(void) {
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) value[k] = signal[k];
    for (int i = 0; i < N; i++) {
        time[i] = 100 + 0.05 * i + 0.01 * (i % 3);
        present[i] = i % 7 != 2; /* the first and the last are there */
        for (int k = 0; k < WCUT_SENSED_COUNT; k++) signal[k][i] = truth(k, time[i]);
    }
}

static wcut_effect sized(wcut_effect_kind kind, double size, int choice) {
    wcut_effect e = wcut_effect_default(kind);
    e.value[0] = size, e.choice = choice;
    return e;
}

static void sense(wcut_effect e) {
    given_signals();
    ck_assert_int_eq(wcut_sensors_eval(1, &e, N, time, present, value), WCUT_OK);
}

/* signal k is what `expected` says where it is present; all others are untouched */
static void only(int from, int to, double (*expected)(int k, double t)) {
    for (int k = 0; k < WCUT_SENSED_COUNT; k++)
        for (int i = 0; i < N; i++) {
            const bool changed = k >= from && k <= to && present[i];
            ck_assert_double_eq_tol(signal[k][i], changed ? expected(k, time[i]) : truth(k, time[i]), 1e-12);
        }
}

static double turned(int k, double t) { return truth(k, t) - 2 * WCUT_PI / 180; }
static double gained(int k, double t) { return truth(k, t) * 1.05; }
static double drifted(int k, double t) { return truth(k, t) + 0.2 * (t - 100) / 100; }
static double saturated(int k, double t) { return truth(k, t) + 0.2 * (1 - exp(-(t - 100) / 5)); }

TEST(each_fault_changes_its_own_channel_by_its_formula) {
    sense(sized(WCUT_EFFECT_ANGLE_OFFSET, -2, 2)); /* alpha_b */
    only(6, 6, turned);
    sense(sized(WCUT_EFFECT_TENSION_GAIN, 0.05, 1));
    only(3, 3, gained);
    sense(sized(WCUT_EFFECT_TENSION_GAIN, 0.05, 2));
    only(2, 3, gained);
    sense(sized(WCUT_EFFECT_TENSION_DRIFT, 0.2, 0));
    only(2, 2, drifted);
    wcut_effect e = sized(WCUT_EFFECT_TENSION_DRIFT, 0.2, 0);
    e.value[1] = 5;
    sense(e);
    only(2, 2, saturated);
    sense(sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 1, 0));
    only(0, -1, NULL);
}

TEST(a_clock_that_runs_behind_shows_what_was_before_and_the_speeds_as_they_are) {
    const double delay[] = {0.12, -0.07};
    for (int d = 0; d < 2; d++) {
        sense(sized(WCUT_EFFECT_CLOCK_OFFSET, delay[d], 0));
        for (int k = 0; k < WCUT_SENSED_COUNT; k++)
            for (int i = 0; i < N; i++) {
                const double t = time[i] - (k >= 2 && present[i] ? delay[d] : 0);
                const double held = fmin(fmax(t, time[0]), time[N - 1]);
                ck_assert_double_eq_tol(signal[k][i], truth(k, held), 1e-9);
            }
    }
}

TEST(neutral_faults_leave_every_bit) {
    for (int kind = 0; kind < WCUT_EFFECT_COUNT; kind++) {
        sense(wcut_effect_default((wcut_effect_kind)kind));
        for (int k = 0; k < WCUT_SENSED_COUNT; k++)
            for (int i = 0; i < N; i++) ck_assert(signal[k][i] == truth(k, time[i]));
    }
}

TEST(bad_arguments_are_refused_and_the_signals_stay) {
    given_signals();
    wcut_effect e = sized(WCUT_EFFECT_TENSION_GAIN, 0.05, 2);
    ck_assert_int_eq(wcut_sensors_eval(1, NULL, N, time, present, value), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sensors_eval(1, &e, -1, time, present, value), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sensors_eval(1, &e, N, NULL, present, value), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sensors_eval(1, &e, N, time, present, NULL), WCUT_BAD_ARGUMENT);
    time[5] = time[4];
    ck_assert_int_eq(wcut_sensors_eval(1, &e, N, time, present, value), WCUT_BAD_ARGUMENT);
    given_signals();
    e.value[0] = NAN;
    ck_assert_int_eq(wcut_sensors_eval(1, &e, N, time, present, value), WCUT_BAD_ARGUMENT);
    e = sized(WCUT_EFFECT_CLOCK_OFFSET, 0.1, 0);
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_sensors_eval(1, &e, N, time, present, value), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    only(0, -1, NULL);
}
