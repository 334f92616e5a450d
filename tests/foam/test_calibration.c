/* The calibration against scipy's curve_fit, closed forms, and made tables that want something. labels: unit oracle */
#include <math.h>
#include <stddef.h>
#include <string.h>
#include <wirecut/calibration.h>

#include "base/alloc.h"
#include "base/random.h"
#include "foam/calibration_reference.h"
#include "test.h"

enum { REFERENCE = (int)(sizeof heat / sizeof heat[0]), N = 24 };
static wcut_test_cut cut[N];
static wcut_calibration fit;
static wcut_calibration_point point[N];
static wcut_error error;

static double degrees(double angle) { return angle * acos(-1) / 180; }

static void given_the_reference_table(void) {
    for (int i = 0; i < REFERENCE; i++)
        cut[i] = (wcut_test_cut){heat[i],           speed[i],          engaged[i], tension_n[i], tension_n[i],
                                 degrees(alpha[i]), degrees(alpha[i]), 1,          i + 2};
}

/* a cut whose force per length is F and whose tension per length is T */
static wcut_test_cut cut_of(double q_i, double v, double force, double tension) {
    double angle = asin(force / tension / 2);
    return (wcut_test_cut){q_i, v, 400, 400 * tension, 400 * tension, angle, angle, 1, 0};
}

/* n cuts of the laws, with relative scatter */
static void given_a_made_table(int n, uint64_t seed, double scatter) {
    wcut_random random = wcut_random_seed(seed);
    for (int i = 0; i < n; i++) {
        double q_i = 50 + 40 * wcut_random_uniform(&random), v = 15 + 40 * wcut_random_uniform(&random);
        double q = 1000 * q_i / v, force = 0.06 * exp(-7e-4 * q) * (1 + scatter * wcut_random_normal(&random));
        double tension = (0.3 * exp(-5e-4 * q) + 0.04) * (1 + scatter * wcut_random_normal(&random));
        cut[i] = cut_of(q_i, v, force, tension);
    }
}

static wcut_status solve(int n, const wcut_calibration_options *o) {
    memset(&fit, 0, sizeof fit);
    memset(&error, 0, sizeof error);
    return wcut_calibration_fit(n, cut, o, &fit, point, &error);
}

/* parameters and covariance to 1e-8 of what scipy found */
static void agrees(const wcut_law_fit *law, int parameters, const double *value, const double *covariance) {
    const double found[3] = {law->a, law->b, law->c};
    for (int i = 0; i < parameters; i++) {
        ck_assert_double_eq_tol(found[i] / value[i], 1, 1e-8);
        ck_assert_double_eq_tol(law->standard_error[i] / sqrt(covariance[i * (parameters + 1)]), 1, 1e-8);
        for (int j = 0; j < parameters; j++)
            ck_assert_double_eq_tol(law->covariance[3 * i + j] / covariance[i * parameters + j], 1, 1e-8);
    }
}

TEST(both_laws_and_both_noises_agree_with_curve_fit_to_1e_8) {
    given_the_reference_table();
    wcut_calibration_options o = wcut_calibration_options_default();
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    agrees(&fit.force, 2, force_relative, force_relative_covariance);
    agrees(&fit.tension, 3, tension_relative, tension_relative_covariance);
    ck_assert(fit.tension_fitted && !fit.tension.c_held && fit.force.c_held);
    o.noise = WCUT_NOISE_ABSOLUTE;
    ck_assert_int_eq(solve(REFERENCE, &o), WCUT_OK);
    agrees(&fit.force, 2, force_absolute, force_absolute_covariance);
    agrees(&fit.tension, 3, tension_absolute, tension_absolute_covariance);
}

TEST(cuts_left_out_are_predicted_as_by_curve_fit_without_them) {
    given_the_reference_table();
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    double sum = 0;
    for (int i = 0; i < REFERENCE; i++) {
        ck_assert_double_eq_tol(point[i].force.left_out / force_left_out[i], 1, 1e-8);
        sum += pow(point[i].force.measured / force_left_out[i] - 1, 2);
    }
    ck_assert_int_eq(fit.force.left_out, REFERENCE);
    ck_assert_double_eq_tol(fit.force.leave_one_out, sqrt(sum / REFERENCE), 1e-9);
}

TEST(leaving_out_by_leverage_is_near_leaving_out_by_refitting) {
    enum { MANY = 204 };
    static wcut_test_cut many[MANY];
    static wcut_calibration_point at[MANY];
    double by_refit = 0;
    for (int n = 200; n <= MANY; n += MANY - 200) {
        for (int i = 0; i < n; i += N) {
            given_a_made_table(N, (uint64_t)i, 0.04);
            for (int k = 0; k < N && i + k < n; k++) many[i + k] = cut[k];
        }
        ck_assert_int_eq(wcut_calibration_fit(n, many, NULL, &fit, at, NULL), WCUT_OK);
        ck_assert_int_eq(fit.force.left_out, n);
        if (n == 200) by_refit = fit.force.leave_one_out;
    }
    ck_assert_double_eq_tol(fit.force.leave_one_out / by_refit, 1, 0.01);
    ck_assert_double_gt(fit.force.leave_one_out, fit.force.scale);
}

TEST(the_force_of_a_cut_is_that_of_both_mounts) {
    wcut_test_cut c = {60, 20, 400, 10, 12, 0.1, 0.05, 1, 0};
    ck_assert_double_eq_tol(wcut_test_cut_force(&c), (10 * sin(0.1) + 12 * sin(0.05)) / 400, 1e-15);
    ck_assert_double_eq_tol(wcut_test_cut_tension(&c), 11.0 / 400, 1e-15);
}

TEST(cuts_on_the_laws_give_them_back_without_error) {
    given_a_made_table(10, 1, 0);
    ck_assert_int_eq(solve(10, NULL), WCUT_OK);
    ck_assert_double_eq_tol(fit.force.a / 0.06, 1, 1e-10);
    ck_assert_double_eq_tol(fit.force.b / 7e-4, 1, 1e-10);
    ck_assert_double_eq_tol(fit.tension.a / 0.3, 1, 1e-8);
    ck_assert_double_eq_tol(fit.tension.b / 5e-4, 1, 1e-8);
    ck_assert_double_eq_tol(fit.tension.c / 0.04, 1, 1e-8);
    ck_assert_double_lt(fit.force.scale, 1e-9);
    ck_assert_int_eq(fit.force.lack, WCUT_LACK_OF_FIT_UNTESTED);
    for (int i = 0; i < 10; i++) ck_assert_double_eq_tol(point[i].force.measured, point[i].force.fitted, 1e-12);
}

TEST(the_reference_pair_is_the_inverse_law_and_its_errors_are_those_of_the_slopes) {
    given_the_reference_table();
    wcut_calibration_options o = wcut_calibration_options_default();
    o.reference_force = 0.0063;
    o.reference_heat = 65;
    ck_assert_int_eq(solve(REFERENCE, &o), WCUT_OK);
    const wcut_force_law law = {fit.force.a, fit.force.b};
    double v, slope[2], m[2];
    ck_assert_int_eq(wcut_force_law_speed(&law, 65, 0.0063, &v), WCUT_OK);
    ck_assert_double_eq_tol(fit.reference_speed / v, 1, 1e-13);
    ck_assert_double_eq_tol(fit.exponent, 1 / log(law.a / 0.0063), 1e-13);
    for (int k = 0; k < 2; k++) { /* central differences */
        wcut_force_law up = law, down = law;
        double h = 1e-5 * (k ? law.b : law.a), v_up, v_down;
        *(k ? &up.b : &up.a) += h;
        *(k ? &down.b : &down.a) -= h;
        wcut_force_law_speed(&up, 65, 0.0063, &v_up);
        wcut_force_law_speed(&down, 65, 0.0063, &v_down);
        slope[k] = (v_up - v_down) / (2 * h);
        m[k] = (1 / log(up.a / 0.0063) - 1 / log(down.a / 0.0063)) / (2 * h);
    }
    const double *c = fit.force.covariance;
    double variance = slope[0] * slope[0] * c[0] + 2 * slope[0] * slope[1] * c[1] + slope[1] * slope[1] * c[4];
    ck_assert_double_eq_tol(fit.reference_speed_error / sqrt(variance), 1, 1e-6);
    ck_assert_double_eq_tol(fit.exponent_error / fabs(m[0] * fit.force.standard_error[0]), 1, 1e-6);
    /* the point of the pair: at the middle of the data V0 is known far better than a */
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    ck_assert_double_lt(fit.reference_speed_error / fit.reference_speed, fit.force.standard_error[0] / fit.force.a / 2);
}

TEST(the_table_is_described_before_it_is_believed) {
    given_the_reference_table();
    cut[3].alpha_b = degrees(10.5);
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    ck_assert(fit.heats == REFERENCE && fit.speeds == REFERENCE && fit.q_effs == REFERENCE);
    ck_assert_int_eq(fit.large_angles, 1);
    ck_assert_int_eq(fit.separable, 1);
    ck_assert_double_eq_tol(fit.q_eff_low, 1000 * 48.2 / 55.62, 1e-9);
    ck_assert_double_eq_tol(fit.q_eff_high, 1000 * 82.0 / 15.26, 1e-9);
    ck_assert_double_gt(fit.correlation, 0.5);
}

TEST(one_heat_and_a_narrow_range_do_not_tell_a_from_b) {
    wcut_random random = wcut_random_seed(3);
    for (int i = 0; i < 8; i++) {
        double v = 30 + 0.2 * i, q = 1000 * 60 / v;
        cut[i] = cut_of(60, v, 0.06 * exp(-7e-4 * q) * (1 + 0.01 * wcut_random_normal(&random)), 0.2);
    }
    ck_assert_int_eq(solve(8, NULL), WCUT_OK);
    ck_assert(fit.heats == 1 && fit.speeds == 8 && fit.separable == 0);
    ck_assert_double_gt(fit.correlation, 0.99);
    /* yet the speed at the middle force stands */
    ck_assert_double_lt(fit.reference_speed_error / fit.reference_speed, 0.02);
}

TEST(repeated_cuts_are_the_yardstick_of_the_lack_of_fit) {
    wcut_random random = wcut_random_seed(6);
    for (int bent = 0; bent < 2; bent++) {
        for (int i = 0; i < N; i++) {
            double v = 15 + 6 * (i / 3), q = 1000 * 70 / v, u = (q - 2500) / 1500;
            double force = 0.06 * exp(-7e-4 * q + 0.3 * bent * u * u) * (1 + 0.02 * wcut_random_normal(&random));
            cut[i] = cut_of(70, v, force, 0.2);
        }
        ck_assert_int_eq(solve(N, NULL), WCUT_OK);
        ck_assert_int_eq(fit.force.lack, WCUT_LACK_OF_FIT_REPLICATE);
        ck_assert(fit.force.lack_degrees[0] == 6 && fit.force.lack_degrees[1] == 16);
        if (bent)
            ck_assert_double_lt(fit.force.lack_p, 1e-4);
        else
            ck_assert_double_gt(fit.force.lack_p, 0.01);
    }
}

TEST(a_power_of_the_speed_beside_q_eff_is_a_lack_of_fit) {
    given_a_made_table(12, 9, 0.02);
    ck_assert_int_eq(solve(12, NULL), WCUT_OK);
    ck_assert_int_eq(fit.force.lack, WCUT_LACK_OF_FIT_FLEXIBLE);
    ck_assert_double_gt(fit.force.lack_p, 0.01);
    for (int i = 0; i < 12; i++)
        cut[i].alpha_a = cut[i].alpha_b = asin(sin(cut[i].alpha_a) * pow(cut[i].speed / 30, 0.3));
    ck_assert_int_eq(solve(12, NULL), WCUT_OK);
    ck_assert_double_lt(fit.force.lack_p, 1e-3);
}

TEST(an_outlier_is_found_by_a_robust_loss_and_no_weight_is_the_same_as_no_cut) {
    given_a_made_table(12, 9, 0.02);
    ck_assert_int_eq(solve(12, NULL), WCUT_OK);
    wcut_calibration clean = fit;
    cut[12] = cut[5];
    cut[12].alpha_a = cut[12].alpha_b = 2 * cut[5].alpha_a;
    wcut_calibration_options o = wcut_calibration_options_default();
    for (int loss = WCUT_LOSS_SQUARE; loss <= WCUT_LOSS_TUKEY; loss++) {
        o.loss = (wcut_loss)loss;
        ck_assert_int_eq(solve(13, &o), WCUT_OK);
        double off = fabs(fit.force.a - clean.force.a) / clean.force.standard_error[0];
        if (loss == WCUT_LOSS_SQUARE) ck_assert_double_gt(off, 3);
        if (loss == WCUT_LOSS_HUBER) ck_assert_double_lt(off, 2);
        if (loss == WCUT_LOSS_TUKEY) ck_assert_double_lt(off, 1);
        if (loss == WCUT_LOSS_TUKEY) ck_assert(point[12].force.loss_weight == 0 && point[12].force.residual > 10);
    }
    cut[12].weight = 1e-14;
    ck_assert_int_eq(solve(13, NULL), WCUT_OK);
    ck_assert_double_eq_tol(fit.force.a / clean.force.a, 1, 1e-9);
}

TEST(the_evidence_says_what_the_scatter_is_proportional_to) {
    given_a_made_table(N, 21, 0.05);
    ck_assert_int_eq(solve(N, NULL), WCUT_OK);
    ck_assert_double_gt(fit.force.evidence, 3);
    wcut_random random = wcut_random_seed(22);
    for (int i = 0; i < N; i++) {
        double q = 1000 * cut[i].heat / cut[i].speed;
        cut[i] = cut_of(cut[i].heat, cut[i].speed, 0.06 * exp(-7e-4 * q) + 4e-4 * wcut_random_normal(&random), 0.2);
    }
    ck_assert_int_eq(solve(N, NULL), WCUT_OK);
    ck_assert_double_lt(fit.force.evidence, -3);
}

TEST(a_negative_c_is_not_admitted_and_a_rising_tension_is_no_law) {
    for (int i = 0; i < 10; i++) {
        double v = 15 + 5 * i, q = 1000 * 60 / v;
        cut[i] = cut_of(60, v, 0.06 * exp(-7e-4 * q), 0.3 * exp(-4e-4 * q) - 0.02);
    }
    ck_assert_int_eq(solve(10, NULL), WCUT_OK);
    ck_assert(fit.tension_fitted && fit.tension.c_held && fit.tension.c == 0 && fit.tension.standard_error[2] == 0);
    for (int i = 0; i < 10; i++) {
        double v = 15 + 5 * i, q = 1000 * 60 / v;
        cut[i] = cut_of(60, v, 0.06 * exp(-7e-4 * q), 0.1 + 5e-5 * q);
    }
    ck_assert_int_eq(solve(10, NULL), WCUT_OK);
    ck_assert(!fit.tension_fitted && fit.tension.a == 0 && point[0].tension.measured > 0);
    ck_assert_double_eq_tol(fit.force.b, 7e-4, 1e-12);
}

/* refused, with the words, and nothing written */
static void refused(int n, const wcut_calibration_options *o, wcut_status status, const char *words) {
    wcut_calibration untouched;
    memset(&untouched, 0x99, sizeof untouched);
    fit = untouched;
    point[0].q_eff = 999;
    ck_assert_int_eq(wcut_calibration_fit(n, cut, o, &fit, point, &error), status);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
    ck_assert(memcmp(&fit, &untouched, sizeof fit) == 0 && point[0].q_eff == 999);
}

TEST(values_out_of_range_are_refused_by_cut_or_line) {
    const size_t place[] = {offsetof(wcut_test_cut, heat),      offsetof(wcut_test_cut, speed),
                            offsetof(wcut_test_cut, engaged),   offsetof(wcut_test_cut, tension_a),
                            offsetof(wcut_test_cut, tension_b), offsetof(wcut_test_cut, alpha_a),
                            offsetof(wcut_test_cut, alpha_b),   offsetof(wcut_test_cut, weight)};
    const double bad[] = {NAN, INFINITY, -2};
    for (size_t k = 0; k < sizeof place / sizeof place[0]; k++) {
        for (int b = 0; b < 3; b++) {
            given_the_reference_table();
            memcpy((char *)&cut[2] + place[k], &bad[b], sizeof bad[b]);
            refused(REFERENCE, NULL, WCUT_BAD_ARGUMENT, "line 4: ");
            cut[2].line = 0;
            refused(REFERENCE, NULL, WCUT_BAD_ARGUMENT, "cut 2: ");
        }
    }
    given_the_reference_table();
    refused(2, NULL, WCUT_BAD_ARGUMENT, "found 2 test cuts");
    wcut_calibration_options o = wcut_calibration_options_default();
    o.confidence = 1;
    refused(REFERENCE, &o, WCUT_BAD_ARGUMENT, wcut_status_text(WCUT_BAD_ARGUMENT));
    o = wcut_calibration_options_default();
    o.reference_force = 0.5;
    refused(REFERENCE, &o, WCUT_BAD_ARGUMENT, "reference force: found 0.5");
    ck_assert_int_eq(wcut_calibration_fit(REFERENCE, NULL, NULL, &fit, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_calibration_fit(REFERENCE, cut, NULL, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
}

TEST(cuts_that_determine_no_law_are_refused_with_what_they_lack) {
    for (int i = 0; i < 4; i++) cut[i] = cut_of(60 * (1 + i % 2), 20 * (1 + i % 2), 0.01, 0.2);
    refused(4, NULL, WCUT_DEGENERATE, "found one level of Q_eff (3000 J/m^2)");
    for (int i = 0; i < 4; i++) cut[i] = cut_of(60, 20 + i, 0.01 - 1e-4 * i, 0.2);
    refused(4, NULL, WCUT_DEGENERATE, "does not fall with Q_eff");
    for (int i = 0; i < 4; i++) cut[i] = cut_of(60, 20 + i, i ? -0.01 : 0.01, 0.2);
    refused(4, NULL, WCUT_DEGENERATE, "found 1 cuts with a positive force");
}

TEST(a_scatter_as_large_as_the_forces_does_not_come_to_rest_and_is_said) {
    const double force[] = {0.1, 1e-7, 0.02, 3e-8, 0.06, 1e-6, 5e-3};
    int refusals = 0;
    for (int shift = 0; shift < 7 && !refusals; shift++) {
        for (int i = 0; i < 7; i++) cut[i] = cut_of(60, 15 + 6 * i, force[(i + shift) % 7], 0.2);
        wcut_status status = solve(7, NULL);
        if (status != WCUT_NOT_CONVERGED) continue;
        refusals++;
        refused(7, NULL, WCUT_NOT_CONVERGED, "does not come to rest");
    }
    ck_assert_int_gt(refusals, 0);
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    given_the_reference_table();
    wcut_calibration untouched;
    memset(&untouched, 0x99, sizeof untouched);
    fit = untouched;
    FIRST_FAILED_ALLOCATIONS(399, wcut_calibration_fit(REFERENCE, cut, NULL, &fit, point, &error),
                             memcmp(&fit, &untouched, sizeof fit) == 0);
}

TEST(the_band_of_a_curve_is_that_of_scipy_s_covariance) {
    enum { AT = (int)(sizeof band_q / sizeof band_q[0]) };
    double value[AT], low[AT], high[AT];
    given_the_reference_table();
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_law_fit_eval(&fit.force, 0.9, AT, band_q, value, low, high), WCUT_OK);
    for (int i = 0; i < AT; i++) {
        ck_assert_double_eq_tol(value[i] / (fit.force.a * exp(-fit.force.b * band_q[i])), 1, 1e-14);
        ck_assert_double_eq_tol(low[i] / force_band_low[i], 1, 1e-7);
        ck_assert_double_eq_tol(high[i] / force_band_high[i], 1, 1e-7);
    }
    ck_assert_int_eq(wcut_law_fit_eval(&fit.tension, 0.9, AT, band_q, value, low, high), WCUT_OK);
    for (int i = 0; i < AT; i++) {
        ck_assert_double_eq_tol(value[i], fit.tension.a * exp(-fit.tension.b * band_q[i]) + fit.tension.c, 1e-14);
        ck_assert_double_eq_tol(low[i], tension_band_low[i], 1e-9);
        ck_assert_double_eq_tol(high[i], tension_band_high[i], 1e-9);
    }
    /* without heat the curve is a + c: its band there is the interval of a, where c is held */
    ck_assert_int_eq(wcut_law_fit_eval(&fit.force, 0.95, 1, band_q, value, low, high), WCUT_OK);
    ck_assert_double_eq_tol(low[0] / fit.force.low[0], 1, 1e-12);
    ck_assert_double_eq_tol(high[0] / fit.force.high[0], 1, 1e-12);
    ck_assert_int_eq(wcut_law_fit_eval(&fit.force, 0.95, 1, band_q, value, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_law_fit_eval(&fit.force, 0.95, 0, NULL, NULL, NULL, NULL), WCUT_OK);
}

TEST(a_band_of_what_is_no_fit_is_refused) {
    given_the_reference_table();
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    const wcut_law_fit law = fit.force;
    const double good[2] = {1000, 2000}, below[2] = {1000, -1}, none[2] = {1000, NAN};
    double out[3][2] = {{999, 999}, {999, 999}, {999, 999}};
    wcut_law_fit exact = law, broken = law;
    exact.degrees = 0;
    broken.covariance[4] = NAN;
    const struct {
        const wcut_law_fit *law;
        double confidence;
        int n;
        const double *q;
    } bad[] = {{NULL, 0.9, 2, good},   {&law, 0, 2, good},     {&law, 1, 2, good},    {&law, NAN, 2, good},
               {&law, 0.9, -1, good},  {&law, 0.9, 2, NULL},   {&law, 0.9, 2, below}, {&law, 0.9, 2, none},
               {&exact, 0.9, 2, good}, {&broken, 0.9, 2, good}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        ck_assert_msg(wcut_law_fit_eval(bad[k].law, bad[k].confidence, bad[k].n, bad[k].q, out[0], out[1], out[2]) ==
                          WCUT_BAD_ARGUMENT,
                      "call %zu", k);
    ck_assert_int_eq(wcut_law_fit_eval(&law, 0.9, 2, good, NULL, out[1], out[2]), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < 6; k++) ck_assert(out[k / 2][k % 2] == 999);
}

TEST(leverages_are_those_of_the_hat_matrix_and_sum_to_the_parameters) {
    double force = 0, tension = 0;
    given_the_reference_table();
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    for (int i = 0; i < REFERENCE; i++) {
        const wcut_law_fit_point *p = &point[i].force;
        ck_assert_double_eq_tol(p->leverage / force_leverage[i], 1, 1e-7);
        ck_assert_double_eq_tol(p->relative, p->measured / p->fitted - 1, 1e-15);
        ck_assert_double_eq_tol(p->relative, p->residual * fit.force.scale, 1e-12); /* all weights are 1 */
        force += p->leverage;
        tension += point[i].tension.leverage;
        /* to first order the fitted value goes by h r / (1 - h), and its standard error is s sqrt(h) */
        double h = p->leverage, expected = sqrt(h) * p->residual / (1 - h);
        ck_assert_double_eq_tol(p->influence, expected, 0.03 + 0.1 * fabs(expected));
    }
    ck_assert_double_eq_tol(force, 2, 1e-9);
    ck_assert_double_eq_tol(tension, 3, 1e-9);
    for (int k = 0; k < 9; k++) {
        const wcut_law_fit *f = &fit.tension;
        double size = f->standard_error[k / 3] * f->standard_error[k % 3];
        ck_assert_double_eq_tol(f->correlation[k], f->covariance[k] / size, 1e-14);
    }
    ck_assert(fit.force.correlation[8] == 0 && fit.force.correlation[1] == fit.correlation);
}

TEST(a_cut_alone_at_its_q_eff_and_one_off_the_law_are_marked) {
    for (int i = 0; i < N; i++) {
        double q_i = 60 + i, v = 1000 * q_i / (2000 + 10 * i);
        if (i == N - 1) v = 1000 * q_i / 4000;
        double force = 0.06 * exp(-7e-4 * 1000 * q_i / v) * (1 + (i % 2 ? 0.01 : -0.01));
        cut[i] = cut_of(q_i, v, i == 5 ? 1.2 * force : force, 0.3);
    }
    ck_assert_int_eq(solve(N, NULL), WCUT_OK);
    for (int i = 0; i < N; i++) {
        ck_assert_int_eq((point[i].force.unusual & WCUT_UNUSUAL_LEVERAGE) != 0, i == N - 1);
        ck_assert_int_eq((point[i].force.unusual & WCUT_UNUSUAL_OUTLIER) != 0, i == 5);
    }
    ck_assert(point[5].force.unusual & WCUT_UNUSUAL_INFLUENTIAL);
    given_a_made_table(10, 1, 0); /* on the law itself nothing is unusual */
    ck_assert_int_eq(solve(10, NULL), WCUT_OK);
    for (int i = 0; i < 10; i++)
        ck_assert(!(point[i].force.unusual & (WCUT_UNUSUAL_OUTLIER | WCUT_UNUSUAL_INFLUENTIAL)));
}

TEST(normal_scores_are_those_of_blom_whatever_the_order) {
    const double value[7] = {3, -2, 8, 0, 8, 1, 5}; /* ranks 4 1 6 2 7 3 5: equal ones in their order */
    const int rank[7] = {4, 1, 6, 2, 7, 3, 5};
    double score[7] = {999, 999, 999, 999, 999, 999, 999};
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_gaussian_scores(7, value, score), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    const double broken[2] = {1, INFINITY};
    ck_assert_int_eq(wcut_gaussian_scores(2, broken, score), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_gaussian_scores(-1, value, score), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_gaussian_scores(7, NULL, score), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_gaussian_scores(7, value, NULL), WCUT_BAD_ARGUMENT);
    for (int i = 0; i < 7; i++) ck_assert(score[i] == 999);
    ck_assert_int_eq(wcut_gaussian_scores(0, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_gaussian_scores(7, value, score), WCUT_OK);
    for (int i = 0; i < 7; i++) ck_assert_double_eq_tol(score[i], blom[rank[i] - 1], 1e-10);
}

TEST(the_same_cuts_give_the_same_bytes) {
    given_the_reference_table();
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    wcut_calibration first = fit;
    ck_assert_int_eq(solve(REFERENCE, NULL), WCUT_OK);
    ck_assert(memcmp(&first.force, &fit.force, offsetof(wcut_law_fit, c_held)) == 0);
    ck_assert(first.reference_speed == fit.reference_speed && first.tension.evidence == fit.tension.evidence);
}
