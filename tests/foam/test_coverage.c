/* What the calibration promises, over 1,000 made tables: its intervals hold the truth as often as they say, its test of
   the lack of fit cries wolf as seldom as it says. labels: property plain */
#include <math.h>
#include <wirecut/calibration.h>

#include "base/random.h"
#include "test.h"

enum { TABLES = 1000, CUTS = 12 };
#define A 0.06
#define B 7e-4
#define SCATTER 0.03

/* a table as the development cases have them: 12 cuts, deflections of 5 to 9.5 degrees, 3 % of scatter */
static void make_table(wcut_random *random, wcut_noise noise, wcut_test_cut *cut) {
    for (int i = 0; i < CUTS; i++) {
        double heat = 45 + 45 * wcut_random_uniform(random),
               speed = heat * (12 + 30 * wcut_random_uniform(random)) / 60;
        double force = A * exp(-B * 1000 * heat / speed),
               angle = (5 + 4.5 * wcut_random_uniform(random)) * acos(-1) / 180;
        double scatter = SCATTER * wcut_random_normal(random);
        force += scatter * (noise == WCUT_NOISE_RELATIVE ? force : 0.01);
        double tension = force * 400 / (2 * sin(angle));
        cut[i] = (wcut_test_cut){heat, speed, 400, tension, tension, angle, angle, 1, 0};
    }
}

/* how often the intervals of a, b and V0 and the band of the curve at 3,000 J/m^2 hold the truth, and how often the
   lack of fit is found at 5 % */
static void count(wcut_noise noise, int held[4], int *lack) {
    wcut_random random = wcut_random_seed(2016);
    wcut_calibration_options o = wcut_calibration_options_default();
    o.noise = noise;
    o.reference_force = 0.0063;
    o.reference_heat = 65;
    const double truth = B * 65 * 1000 / log(A / 0.0063), t_quantile = 2.2281388519649385; /* 10 degrees */
    for (int k = 0; k < TABLES; k++) {
        wcut_test_cut cut[CUTS];
        wcut_calibration c;
        make_table(&random, noise, cut);
        ck_assert_int_eq(wcut_calibration_fit(CUTS, cut, &o, &c, NULL, NULL), WCUT_OK);
        held[0] += c.force.low[0] <= A && A <= c.force.high[0];
        held[1] += c.force.low[1] <= B && B <= c.force.high[1];
        held[2] += fabs(c.reference_speed - truth) <= t_quantile * c.reference_speed_error;
        const double q = 3000, force = A * exp(-B * q);
        double fitted, low, high;
        ck_assert_int_eq(wcut_law_fit_eval(&c.force, o.confidence, 1, &q, &fitted, &low, &high), WCUT_OK);
        held[3] += low <= force && force <= high;
        *lack += c.force.lack_p < 0.05;
    }
}

static void check(wcut_noise noise) {
    static const char *const of[4] = {"a", "b", "V0", "the curve"};
    int held[4] = {0}, lack = 0;
    count(noise, held, &lack);
    for (int k = 0; k < 4; k++)
        ck_assert_msg(held[k] >= 930 && held[k] <= 970, "%s: %d of 1000, expected 930 to 970", of[k], held[k]);
    ck_assert_msg(lack >= 30 && lack <= 70, "lack of fit: %d of 1000, expected 30 to 70", lack);
}

TEST(intervals_hold_the_truth_as_often_as_they_say_under_relative_noise) { check(WCUT_NOISE_RELATIVE); }

TEST(intervals_hold_the_truth_as_often_as_they_say_under_absolute_noise) { check(WCUT_NOISE_ABSOLUTE); }

TEST(robust_losses_come_to_rest_and_stay_near_the_truth_whatever_one_cut_does) {
    wcut_random random = wcut_random_seed(7);
    wcut_calibration_options o = wcut_calibration_options_default();
    double worst[3] = {0};
    for (int k = 0; k < 40; k++) {
        wcut_test_cut cut[CUTS];
        wcut_calibration c;
        make_table(&random, WCUT_NOISE_RELATIVE, cut);
        double factor = exp(3 * wcut_random_normal(&random));
        cut[k % CUTS].tension_a *= factor;
        cut[k % CUTS].tension_b *= factor;
        for (int loss = WCUT_LOSS_SQUARE; loss <= WCUT_LOSS_TUKEY; loss++) {
            o.loss = (wcut_loss)loss;
            wcut_status status = wcut_calibration_fit(CUTS, cut, &o, &c, NULL, NULL);
            if (loss == WCUT_LOSS_SQUARE && status != WCUT_OK) continue; /* so be it: that is what robust is for */
            ck_assert_msg(status == WCUT_OK, "table %d, factor %g, loss %d: status %d", k, factor, loss, status);
            worst[loss] = fmax(worst[loss], fabs(log(c.force.b / B)));
        }
    }
    ck_assert_double_gt(worst[WCUT_LOSS_SQUARE], 0.5);
    ck_assert_msg(worst[WCUT_LOSS_TUKEY] < 0.25, "b is off by up to %g", worst[WCUT_LOSS_TUKEY]);
}
