/* The process laws (1) and (2) against their own definition: values, limits, slope, inverse. */
#include <wirecut/force_law.h>

#include "foam/force_law.h"
#include "test.h"

static const wcut_force_law law = {.a = 0.1, .b = 8.6e-4};
static const wcut_tension_law tension = {.a = 0.02, .b = 4e-4, .c = 0.001};

TEST(the_working_constants_give_the_known_force_at_20_mm_s) {
    /* Q_eff = 65 W/m over 0.02 m/s = 3250 J/m^2, F = 0.1 exp(-2.795) N/mm */
    ck_assert_double_eq(wcut_q_eff_eval(65, 20), 3250);
    ck_assert_double_eq_tol(wcut_force_law_eval(&law, 65, 20), 0.1 * exp(-2.795), 1e-16);
    ck_assert_double_eq_tol(wcut_tension_law_eval(&tension, 65, 20), 0.02 * exp(-1.3) + 0.001, 1e-16);
}

TEST(at_rest_the_foam_melts_without_force_and_at_endless_speed_it_is_cold) {
    ck_assert(isinf(wcut_q_eff_eval(65, 0)));
    ck_assert_double_eq(wcut_force_law_eval(&law, 65, 0), 0);
    ck_assert_double_eq(wcut_tension_law_eval(&tension, 65, 0), tension.c);
    ck_assert_double_eq_tol(wcut_force_law_eval(&law, 65, 1e12), law.a, 1e-9);
    ck_assert_double_eq_tol(wcut_tension_law_eval(&tension, 65, 1e12), tension.a + tension.c, 1e-9);
    ck_assert_double_eq(wcut_force_law_eval(&law, 0, 20), law.a);
}

TEST(force_rises_with_speed_and_falls_with_heat) {
    for (double v = 1; v < 100; v *= 1.3) {
        ck_assert_double_lt(wcut_force_law_eval(&law, 65, v), wcut_force_law_eval(&law, 65, 1.3 * v));
        ck_assert_double_gt(wcut_force_law_eval(&law, 65, v), wcut_force_law_eval(&law, 70, v));
    }
}

TEST(the_slope_is_that_of_the_force_by_central_differences) {
    double slope;
    for (double v = 1; v < 500; v *= 1.4) {
        const double h = 1e-4 * v;
        const double force = force_law_slope(&law, 65, v, &slope);
        const double difference =
            (wcut_force_law_eval(&law, 65, v + h) - wcut_force_law_eval(&law, 65, v - h)) / (2 * h);
        ck_assert_double_eq_tol(force, wcut_force_law_eval(&law, 65, v), 1e-13 * force);
        ck_assert_double_eq_tol(slope, difference, 1e-5 * slope); /* the difference's own error: (b Q / v)^2 h^2 / 6 */
    }
    ck_assert(force_law_slope(&law, 65, 0, &slope) == 0 && slope == 0);
    ck_assert(force_law_slope(&law, 65, 1e-3, &slope) == 0 && slope == 0); /* below the smallest double */
}

TEST(speed_from_force_is_the_inverse_of_force_from_speed) {
    for (double v = 5; v < 500; v *= 1.7) {
        double found = 999;
        ck_assert_int_eq(wcut_force_law_speed(&law, 65, wcut_force_law_eval(&law, 65, v), &found), WCUT_OK);
        ck_assert_double_eq_tol(found, v, 1e-12 * v);
        ck_assert_int_eq(wcut_tension_law_speed(&tension, 65, wcut_tension_law_eval(&tension, 65, v), &found), WCUT_OK);
        ck_assert_double_eq_tol(found, v, 1e-11 * v);
    }
}

TEST(a_force_that_no_speed_gives_is_refused_and_nothing_is_written) {
    const double none[] = {0, -1, 0.1, 0.2, NAN, (double)INFINITY};
    double speed = 999;
    for (int k = 0; k < 6; k++) {
        ck_assert_int_eq(wcut_force_law_speed(&law, 65, none[k], &speed), WCUT_BAD_ARGUMENT);
        ck_assert_int_eq(wcut_tension_law_speed(&tension, 65, none[k] + (k < 3 ? tension.c - 0.08 : 0), &speed),
                         WCUT_BAD_ARGUMENT);
    }
    ck_assert_int_eq(wcut_force_law_speed(&law, 0, 0.01, &speed), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_speed(&(wcut_force_law){-0.1, 8e-4}, 65, 0.01, &speed), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_speed(&(wcut_force_law){0.1, NAN}, 65, 0.01, &speed), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_speed(NULL, 65, 0.01, &speed), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_tension_law_speed(NULL, 65, 0.01, &speed), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_speed(&law, 65, 0.01, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_double_eq(speed, 999);
}
