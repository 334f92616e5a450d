/* Fits: the normal equations against dense least squares, and true parameters back from cuts of the library's own wire.
   labels: unit plain */
#include "explain/model_fit.h"

#include "base/alloc.h"
#include "base/least_squares.h"
#include "explain/synthetic.h"
#include "test.h"

/* ---- normal equations ---- */

enum { N = 5 };

typedef struct problem {
    wcut_evidence e;
    wcut_evidence_cut cut[3];
    double column[N * 126], residual[126];
} problem;

/* three cuts of 7 bins, 126 rows; the last column is nearly a copy of the first */
static void given_columns(problem *p) {
    wcut_random random = wcut_random_seed(9);
    memset(p, 0, sizeof *p);
    p->e = (wcut_evidence){.cuts = 3, .cut = p->cut, .rows = 126, .threads = 2};
    for (int k = 0; k < 3; k++) p->cut[k].bins = 7, p->cut[k].row = 42 * k;
    for (int i = 0; i < 126; i++) {
        for (int k = 0; k < N; k++) p->column[k * 126 + i] = wcut_random_normal(&random);
        p->column[4 * 126 + i] = p->column[i] + 0.01 * p->column[4 * 126 + i];
        p->residual[i] = 2 * p->column[i] - p->column[126 + i] + wcut_random_normal(&random);
    }
}

TEST(normal_equations_give_what_dense_least_squares_gives_with_priors_as_rows) {
    problem p;
    given_columns(&p);
    wcut_normal_equations normal;
    ck_assert_int_eq(wcut_normal_equations_create(N, 0, 3, &normal), WCUT_OK);
    wcut_normal_equations_fill(&p.e, p.column, p.residual, &normal);
    const int chosen[4] = {0, 1, 3, 4};
    const double centre[N] = {0.5, -1, 3, 0, 0.1}, precision[N] = {1, 4, 9, 0.25, 2};
    for (int without = -1; without < 3; without++) {
        double t[4] = {999}, covariance[16], cost = 999, a[130 * 4], b[130], x[4], inverse[16], expected = 0;
        ck_assert(wcut_normal_equations_solve(&normal, 4, chosen, centre, precision, without, t, covariance, &cost));
        int m = 0;
        for (int i = 0; i < 126; i++) {
            if (without >= 0 && i / 42 == without) continue;
            for (int k = 0; k < 4; k++) a[m * 4 + k] = p.column[chosen[k] * 126 + i];
            b[m++] = p.residual[i];
        }
        for (int j = 0; j < 4; j++, m++) {
            for (int k = 0; k < 4; k++) a[m * 4 + k] = j == k ? sqrt(precision[chosen[j]]) : 0;
            b[m] = sqrt(precision[chosen[j]]) * centre[chosen[j]];
        }
        double again[130 * 4], right[130];
        memcpy(again, a, sizeof again);
        memcpy(right, b, sizeof right);
        ck_assert_int_eq(wcut_qr_solve(m, 4, a, b, x, inverse), WCUT_OK);
        for (int i = 0; i < m; i++) {
            double d = right[i];
            for (int k = 0; k < 4; k++) d -= again[i * 4 + k] * x[k];
            expected += d * d;
        }
        ck_assert_double_eq_tol(cost, expected, 1e-7);
        for (int k = 0; k < 4; k++) ck_assert_double_eq_tol(t[k], x[k], 1e-7);
        for (int k = 0; k < 16; k++) ck_assert_double_eq_tol(covariance[k], inverse[k], 1e-7);
    }
    wcut_normal_equations_destroy(&normal);
}

TEST(what_a_cut_costs_is_its_own_sum_of_squares) {
    problem p;
    given_columns(&p);
    wcut_normal_equations normal;
    ck_assert_int_eq(wcut_normal_equations_create(N, 0, 3, &normal), WCUT_OK);
    wcut_normal_equations_fill(&p.e, p.column, p.residual, &normal);
    const int chosen[2] = {1, 2};
    const double t[2] = {-0.7, 0.3};
    double expected = 0;
    for (int i = 42; i < 84; i++) expected += pow(p.residual[i] + 0.7 * p.column[126 + i] - 0.3 * p.column[252 + i], 2);
    ck_assert_double_eq_tol(wcut_normal_equations_cost(&normal, 1, 2, chosen, t), expected, 1e-9);
    wcut_normal_equations_destroy(&normal);
}

TEST(columns_that_are_the_same_are_refused_unless_a_prior_holds_them) {
    problem p;
    given_columns(&p);
    memcpy(p.column + 126, p.column, 126 * sizeof(double));
    wcut_normal_equations normal;
    ck_assert_int_eq(wcut_normal_equations_create(N, 0, 3, &normal), WCUT_OK);
    wcut_normal_equations_fill(&p.e, p.column, p.residual, &normal);
    const int chosen[2] = {0, 1};
    const double centre[N] = {0}, open[N] = {0}, held[N] = {1, 1, 1, 1, 1};
    double t[2], cost;
    ck_assert(!wcut_normal_equations_solve(&normal, 2, chosen, centre, open, -1, t, NULL, &cost));
    ck_assert(wcut_normal_equations_solve(&normal, 2, chosen, centre, held, -1, t, NULL, &cost));
    ck_assert_double_eq_tol(t[0], t[1], 1e-9);
    wcut_normal_equations_destroy(&normal);
}

/* ---- cuts ---- */

/* within so many of its own standard errors */
static void ck_near(double found, double expected, double error, double max, const char *what) {
    ck_assert_msg(fabs(found - expected) <= max * error, "%s: found %g +- %g, expected %g", what, found, error,
                  expected);
}

TEST(a_concealed_lag_comes_back_with_the_law_that_was_off) {
    const concealed what = {.effects = 1,
                            .effect = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.8),
                            .law_a = 1.12,
                            .law_b = 0.94,
                            .noise = 1,
                            .seed = 21};
    synthetic s = synthetic_create(SYNTHETIC_CUTS, &what);
    wcut_evidence *e = evidence_of(&s, 2);
    wcut_fitted none = fit_of(e, 0, what.effect), lag = fit_of(e, 1, effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3));
    ck_assert_int_ge(lag.count, 1);
    ck_assert_double_gt(none.cost - lag.cost, 200);
    const wcut_coordinate *c = &lag.coordinate[0];
    ck_near(lag.x[WCUT_BASE], wcut_scale_in(c->scale, 0.8), lag.error[WCUT_BASE], 4, "lag");
    ck_near(lag.x[0], log(0.1 * 1.12), lag.error[0], 4, "ln a");
    ck_near(lag.x[1], log(8.6e-4 * 0.94), lag.error[1], 4, "ln b");
    ck_assert_double_eq_tol(lag.model.effect[0].value[0], 0.8, 0.1);
    ck_assert_double_eq(lag.model.effect[0].value[0], wcut_scale_out(c->scale, lag.x[WCUT_BASE]));
    ck_assert(!lag.at_bound);
    ck_assert(isnan(lag.kerf));                /* no scans */
    for (int k = 0; k < SYNTHETIC_CUTS; k++) { /* every cut, predicted by the others, says so */
        ck_assert_double_lt(lag.held_out[k], none.held_out[k]);
        const double *without = lag.without + (size_t)k * (size_t)(WCUT_BASE + lag.count);
        ck_assert_double_eq_tol(wcut_fitted_model(&lag, without).effect[0].value[0], 0.8, 0.2);
    }
    wcut_fitted_destroy(&lag);
    wcut_fitted_destroy(&none);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(where_nothing_is_concealed_effects_gain_no_more_than_chance) {
    const concealed what = {.law_a = 0.9, .noise = 1, .seed = 22};
    synthetic s = synthetic_create(SYNTHETIC_CUTS, &what);
    wcut_evidence *e = evidence_of(&s, 2);
    const wcut_effect tried[3] = {effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3),
                                  effect_of(WCUT_EFFECT_RATE_DEPENDENCE, 0.1),
                                  effect_of(WCUT_EFFECT_TENSION_GAIN, 0.02)};
    wcut_fitted none = fit_of(e, 0, tried[0]);
    ck_near(none.x[0], log(0.09), none.error[0], 4, "ln a");
    ck_near(none.x[1], log(8.6e-4), none.error[1], 4, "ln b");
    /* the smoothing of the motion is a misfit of its own: what is left may be some more than the rows */
    ck_assert_double_lt(none.cost, 2.0 * e->rows);
    for (int k = 0; k < 3; k++) {
        wcut_fitted f = fit_of(e, 1, tried[k]);
        const double gain = none.cost - f.cost;
        ck_assert_msg(gain < 14, "%s gains %g", wcut_effect_view(tried[k].kind)->name, gain);
        wcut_fitted_destroy(&f);
    }
    wcut_fitted_destroy(&none);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

/* A lag of no length is a bound. Noise asks for a lag below it in about half of all cases: what lies beyond gains nothing. */
TEST(a_value_beyond_its_bound_gains_no_likelihood) {
    int held = 0;
    for (uint64_t seed = 30; seed < 34 && held == 0; seed++) {
        const concealed what = {.noise = 1, .seed = seed};
        synthetic s = synthetic_create(2, &what);
        wcut_evidence *e = evidence_of(&s, 2);
        const wcut_effect lag = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3);
        wcut_fitted none = fit_of(e, 0, lag), f = fit_of(e, 1, lag);
        ck_assert_double_ge(f.x[WCUT_BASE], f.coordinate[0].low);

        /* at the bound: the model without it, its cost, and the same base; an interval all the same */
        if (f.x[WCUT_BASE] == 0) {
            held++;
            ck_assert_double_eq_tol(f.cost, none.cost, 0.5);
            ck_assert_double_eq_tol(f.misfit, none.misfit, 0.5);
            ck_assert_double_eq_tol(f.x[0], none.x[0], 0.2 * none.error[0]);
            ck_assert_double_gt(f.error[WCUT_BASE], 0.001);
        }
        wcut_fitted_destroy(&none);
        wcut_fitted_destroy(&f);
        wcut_evidence_destroy(e);
        synthetic_destroy(&s);
    }
    ck_assert_int_ge(held, 1);
}

TEST(the_jackknife_of_equal_cuts_is_zero_and_that_of_two_is_not_told) {
    double without[3 * 4] = {1, 2, 3, 4, 1, 2, 3, 5, 1, 2, 3, 9};
    wcut_evidence_cut cut[3] = {{.bins = 1}, {.bins = 1}, {.bins = 1}};
    wcut_evidence e = {.cuts = 3, .cut = cut};
    const wcut_fitted f = {.count = 1, .without = without};
    ck_assert_double_eq(wcut_fitted_jackknife(&e, &f, 2), 0);
    ck_assert_double_eq_tol(wcut_fitted_jackknife(&e, &f, 3), sqrt(2.0 / 3 * (4 + 1 + 9)), 1e-12); /* about 6 */
    cut[2].bins = 0;                                                                               /* left out */
    ck_assert_double_eq(wcut_fitted_jackknife(&e, &f, 3), 0);
}

TEST(a_faulty_instrument_is_fitted_along_the_same_motion) {
    wcut_effect gain = effect_of(WCUT_EFFECT_TENSION_GAIN, 0.04);
    const concealed what = {.effects = 1, .effect = gain, .noise = 1, .seed = 23};
    synthetic s = synthetic_create(2, &what);
    wcut_evidence *e = evidence_of(&s, 1);
    gain.value[0] = 0.01;
    wcut_fitted f = fit_of(e, 1, gain);
    ck_assert_double_eq_tol(f.model.effect[0].value[0], 0.04, fmax(4 * f.error[WCUT_BASE], 0.004));
    wcut_fitted_destroy(&f);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(the_same_bytes_come_from_any_number_of_threads) {
    const concealed what = {.noise = 1, .seed = 24};
    synthetic s = synthetic_create(2, &what);
    wcut_evidence *one = evidence_of(&s, 1), *two = evidence_of(&s, 2);
    const wcut_effect lag = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3);
    wcut_fitted a = fit_of(one, 1, lag), b = fit_of(two, 1, lag);
    ck_assert_int_eq(memcmp(a.x, b.x, sizeof a.x), 0);
    ck_assert_int_eq(memcmp(a.residual, b.residual, (size_t)one->rows * sizeof(double)), 0);
    ck_assert_double_eq(a.cost, b.cost);
    wcut_fitted_destroy(&a);
    wcut_fitted_destroy(&b);
    wcut_evidence_destroy(one);
    wcut_evidence_destroy(two);
    synthetic_destroy(&s);
}

TEST(models_that_move_the_wire_alike_are_told) {
    const wcut_model plain = {.a = 0.1, .b = 8e-4};
    wcut_model other = plain;
    ck_assert(wcut_models_same_motion(&plain, &other));
    other.effects = 1, other.effect[0] = effect_of(WCUT_EFFECT_ANGLE_OFFSET, 1); /* an instrument moves nothing */
    ck_assert(wcut_models_same_motion(&plain, &other));
    other.effect[0] = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0); /* neither does what is neutral */
    ck_assert(wcut_models_same_motion(&plain, &other));
    other.effect[0].value[0] = 0.2;
    ck_assert(!wcut_models_same_motion(&plain, &other));
    other = plain, other.length_change = 0.1;
    ck_assert(!wcut_models_same_motion(&plain, &other));
}

TEST(a_profile_is_the_curvature_where_the_response_is_straight) {
    const concealed what = {.effects = 1, .effect = effect_of(WCUT_EFFECT_TENSION_DRIFT, 0.1), .noise = 1, .seed = 12};
    synthetic s = synthetic_create(2, &what);
    wcut_evidence *e = evidence_of(&s, 1);
    wcut_fitted f = fit_of(e, 1, effect_of(WCUT_EFFECT_TENSION_DRIFT, 0.05));
    ck_assert_double_eq(f.below[WCUT_BASE], 1.96 * f.error[WCUT_BASE]);
    f.below[WCUT_BASE] = f.above[WCUT_BASE] = 999;
    ck_assert_int_eq(wcut_fitted_profile(e, &f, NULL), WCUT_OK);
    ck_assert_double_eq_tol(f.below[WCUT_BASE], 1.96 * f.error[WCUT_BASE], 0.06 * 1.96 * f.error[WCUT_BASE]);
    ck_assert_double_eq_tol(f.above[WCUT_BASE], 1.96 * f.error[WCUT_BASE], 0.06 * 1.96 * f.error[WCUT_BASE]);
    wcut_fitted_destroy(&f);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(a_profile_holds_the_truth_and_ends_at_the_bounds) {
    /* a hundred times the noise: hardly anything is known of a stiffness of 100 N/mm, and its reciprocal has a bound at 0 */
    const concealed what = {
        .effects = 1, .effect = effect_of(WCUT_EFFECT_MOUNT_COMPLIANCE, 100), .noise = 100, .seed = 3};
    synthetic s = synthetic_create(2, &what);
    wcut_evidence *e = evidence_of(&s, 1);
    wcut_fitted f = fit_of(e, 1, effect_of(WCUT_EFFECT_MOUNT_COMPLIANCE, 60));
    const wcut_coordinate *c = &f.coordinate[0];
    const double x = f.x[WCUT_BASE], truth = wcut_scale_in(c->scale, 100);
    ck_assert_double_lt(x - 1.96 * f.error[WCUT_BASE], c->low); /* the curvature knows no bound */
    ck_assert_int_eq(wcut_fitted_profile(e, &f, NULL), WCUT_OK);
    ck_assert_double_eq_tol(x - f.below[WCUT_BASE], c->low, 1e-12);
    ck_assert(x + f.above[WCUT_BASE] > truth && x + f.above[WCUT_BASE] <= c->high);
    wcut_fitted_destroy(&f);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(a_profile_without_memory_changes_nothing) {
    const concealed what = {.effects = 1, .effect = effect_of(WCUT_EFFECT_TENSION_DRIFT, 0.1), .noise = 1, .seed = 12};
    synthetic s = synthetic_create(1, &what);
    wcut_evidence *e = evidence_of(&s, 1);
    wcut_fitted f = fit_of(e, 1, effect_of(WCUT_EFFECT_TENSION_DRIFT, 0.05));
    f.below[WCUT_BASE] = f.above[WCUT_BASE] = 999;
    FIRST_FAILED_ALLOCATIONS(7, wcut_fitted_profile(e, &f, NULL),
                             f.below[WCUT_BASE] == 999 && f.above[WCUT_BASE] == 999);
    wcut_fitted_destroy(&f);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(without_memory_nothing_is_written) {
    const concealed what = {.noise = 1, .seed = 25};
    synthetic s = synthetic_create(1, &what);
    wcut_evidence *e = evidence_of(&s, 1);
    const wcut_model start = e->at;
    wcut_fitted f = {.count = 999};
    FIRST_FAILED_ALLOCATIONS(8, wcut_model_fit(e, &start, &f, NULL), f.count == 999);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}
