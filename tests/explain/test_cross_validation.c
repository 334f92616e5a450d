/* The forward proof: figures as a score's, cuts predicted from the others, better where the model is right. */
#include "explain/cross_validation.h"

#include "base/alloc.h"
#include "cut/score.h"
#include "cut/setup.h"
#include "explain/correct.h"
#include "explain/synthetic.h"
#include "test.h"

static synthetic given;
static wcut_evidence *evidence;
static wcut_fitted none, lag;

static void given_a_lag(int cuts, bool plain, int threads) {
    const concealed what = {.effects = 1,
                            .effect = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 1),
                            .law_a = 1.15,
                            .noise = 1,
                            .plain_programme = plain,
                            .seed = 31};
    given = synthetic_create(cuts, &what);
    evidence = evidence_of(&given, threads);
    none = fit_of(evidence, 0, what.effect);
    lag = fit_of(evidence, 1, effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.4));
}

static void forget(void) {
    wcut_fitted_destroy(&none);
    wcut_fitted_destroy(&lag);
    wcut_evidence_destroy(evidence);
    synthetic_destroy(&given);
}

static wcut_cross_validation prove(const wcut_fitted *recalibrated, const wcut_fitted *chosen) {
    wcut_cross_validation p = {.score = {{{999}}}};
    wcut_error error = {0};
    const wcut_status status = wcut_cross_validation_create(evidence, recalibrated, chosen, 1, &p, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return p;
}

TEST(a_true_effect_predicts_left_out_cuts_better_than_any_law) {
    given_a_lag(SYNTHETIC_CUTS, false, 2);
    wcut_cross_validation p = prove(&none, &lag);
    const int tension = WCUT_EVIDENCE_CHANNEL_TENSION, alpha = WCUT_EVIDENCE_CHANNEL_ALPHA;
    const wcut_evidence_score *before = p.held_out_score[WCUT_EVIDENCE_MODEL_BEFORE],
                              *again = p.held_out_score[WCUT_EVIDENCE_MODEL_RECALIBRATED];
    const wcut_evidence_score *after = p.held_out_score[WCUT_EVIDENCE_MODEL_AFTER];
    ck_assert_double_lt(after[tension].rmsd, 0.6 * again[tension].rmsd);
    ck_assert_double_lt(after[tension].rmse_over_range, 0.6 * again[tension].rmse_over_range);
    /* a law that is bent to take up a lag is no better than one that is off by a seventh */
    ck_assert_double_lt(after[tension].rmse_over_range, 0.6 * before[tension].rmse_over_range);
    ck_assert_double_lt(after[alpha].rmsd, again[alpha].rmsd);
    /* in sample it is no worse */
    ck_assert_double_le(p.score[WCUT_EVIDENCE_MODEL_AFTER][tension].rmsd, 1.02 * after[tension].rmsd);
    for (int m = 0; m < WCUT_EVIDENCE_MODEL_BLACK_BOX; m++) {
        for (int k = WCUT_EVIDENCE_CHANNEL_TENSION; k <= WCUT_EVIDENCE_CHANNEL_BETA; k++) {
            const wcut_evidence_score *f = &p.held_out_score[m][k];
            int bins = 0;
            for (int cut = 0; cut < SYNTHETIC_CUTS; cut++) bins += 2 * (evidence->cut[cut].bins / 2);
            ck_assert(f->count > 0.9 * bins && f->count <= bins);
            ck_assert(f->low > 0 && f->low <= f->rmse_over_range && f->rmse_over_range <= f->high);
        }
        /* programmed cuts have no plan, and these were not scanned */
        ck_assert_int_eq(p.score[m][WCUT_EVIDENCE_CHANNEL_SPEED].count, 0);
        ck_assert_int_eq(p.score[m][WCUT_EVIDENCE_CHANNEL_SCAN].count, 0);
    }
    for (int k = 0; k < WCUT_EVIDENCE_CHANNEL_COUNT; k++) {
        ck_assert_int_eq(p.score[WCUT_EVIDENCE_MODEL_BLACK_BOX][k].count, 0);
        if (p.score[WCUT_EVIDENCE_MODEL_BEFORE][k].count == 0) continue;
        /* what nothing was fitted to is the same, held out or not */
        ck_assert_double_eq(p.score[WCUT_EVIDENCE_MODEL_BEFORE][k].rmsd,
                            p.held_out_score[WCUT_EVIDENCE_MODEL_BEFORE][k].rmsd);
    }
    wcut_cross_validation_destroy(&p);
    forget();
}

TEST(jobs_with_the_correction_applied_score_what_the_table_says_of_the_model) {
    given_a_lag(SYNTHETIC_CUTS, false, 2);
    wcut_cross_validation p = prove(&none, &lag);
    const wcut_correction correction = wcut_fitted_correction(&lag);
    wcut_job *applied[SYNTHETIC_CUTS];
    for (int k = 0; k < SYNTHETIC_CUTS; k++) {
        applied[k] = wcut_job_copy(given.job[k]);
        ck_assert_ptr_nonnull(applied[k]);
        ck_assert_int_eq(wcut_correction_apply(&correction, applied[k], NULL), WCUT_OK);
        evidence->cut[k].job = applied[k];
    }
    wcut_cross_validation again = prove(&none, &none);
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
        const wcut_evidence_score *after = &p.score[WCUT_EVIDENCE_MODEL_AFTER][c],
                                  *job = &again.score[WCUT_EVIDENCE_MODEL_BEFORE][c];
        if (c == WCUT_EVIDENCE_CHANNEL_SPEED) continue; /* the applied jobs have a plan, the excited ones had none */
        ck_assert_int_eq(after->count, job->count);
        ck_assert_double_eq(after->rmsd, job->rmsd);
        ck_assert_double_eq(after->rmse_over_range, job->rmse_over_range);
    }
    ck_assert_double_lt(again.score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_TENSION].rmsd,
                        0.6 * p.score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_TENSION].rmsd);
    wcut_cross_validation_destroy(&p);
    wcut_cross_validation_destroy(&again);
    for (int k = 0; k < SYNTHETIC_CUTS; k++) wcut_job_destroy(applied[k]);
    forget();
}

TEST(one_model_proved_against_itself_gives_equal_figures_for_any_number_of_threads) {
    given_a_lag(2, false, 1);
    wcut_cross_validation one = prove(&none, &none);
    ck_assert_int_eq(memcmp(one.held_out_score[WCUT_EVIDENCE_MODEL_AFTER],
                            one.held_out_score[WCUT_EVIDENCE_MODEL_RECALIBRATED], sizeof one.held_out_score[0]),
                     0);
    evidence->threads = 3;
    wcut_cross_validation three = prove(&none, &none);
    ck_assert_int_eq(memcmp(one.score, three.score, sizeof one.score), 0);
    ck_assert_int_eq(memcmp(one.held_out_score, three.held_out_score, sizeof one.held_out_score), 0);
    ck_assert_int_eq(memcmp(one.held_out[1].row, three.held_out[1].row, (size_t)evidence->rows * sizeof(double)), 0);
    wcut_cross_validation_destroy(&one);
    wcut_cross_validation_destroy(&three);
    forget();
}

/* the tension that the programmed speed ends at is the target, or so much of it */
static void aim(double part) {
    const wcut_evidence_cut *c = &evidence->cut[0];
    given.job[0]->tension = part * (c->measured[0][c->bins - 8] + c->measured[1][c->bins - 8]) / 2;
}

TEST(one_cut_is_planned_but_nothing_can_be_held_out) {
    given_a_lag(1, true, 1);
    aim(1);
    wcut_cross_validation p = prove(&none, &lag);
    for (int m = 0; m < WCUT_EVIDENCE_MODEL_COUNT; m++)
        for (int k = 0; k < WCUT_EVIDENCE_CHANNEL_COUNT; k++) ck_assert_int_eq(p.held_out_score[m][k].count, 0);
    ck_assert_double_gt(p.score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_SPEED].count,
                        0.9 * evidence->cut[0].bins);
    ck_assert_double_gt(p.score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_SPEED].rmse_over_range, 0);
    /* the measured speed of the forecast is that of the recording */
    const double pace = 3.4 * 500 / 120;
    ck_assert_double_eq_tol(p.measured.speed[3], pace, 0.02);
    wcut_cross_validation_destroy(&p);
    forget();
}

TEST(a_speed_at_another_tension_than_the_target_is_no_judge_of_a_plan) {
    given_a_lag(1, true, 1);
    aim(1.25);
    wcut_cross_validation p = prove(&none, &none);
    ck_assert_int_eq(p.score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_SPEED].count, 0);
    ck_assert_int_gt(p.score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_TENSION].count, 0);
    for (int i = 0; i < 2 * evidence->cut[0].bins; i++) ck_assert(isnan(p.measured.speed[i]));
    wcut_cross_validation_destroy(&p);
    forget();
}

/* ---- figures ---- */

TEST(figures_are_a_scores_and_their_interval_holds_them) {
    enum { BINS = 60 };
    wcut_evidence_cut cut = {.bins = BINS};
    wcut_evidence e = {.cuts = 1, .cut = &cut, .rows = 6 * BINS, .threads = 1};
    double row[6 * BINS], other[6 * BINS], speed[2 * BINS], none_there[2 * BINS], x[BINS], y[BINS];
    wcut_random random = wcut_random_seed(2);
    for (int i = 0; i < 6 * BINS; i++) row[i] = sin(0.1 * i), other[i] = row[i] + 0.1 * wcut_random_normal(&random);
    for (int i = 0; i < 2 * BINS; i++) speed[i] = i, none_there[i] = (double)NAN;
    other[2 * BINS + 5] = (double)NAN; /* a bin of alpha_a */
    const wcut_forecast measured = {row, speed}, predicted = {other, none_there};
    wcut_evidence_score fit[WCUT_EVIDENCE_CHANNEL_COUNT], again[WCUT_EVIDENCE_CHANNEL_COUNT];
    ck_assert_int_eq(wcut_forecast_score(&e, &measured, &predicted, 7, fit), WCUT_OK);
    ck_assert_int_eq(fit[WCUT_EVIDENCE_CHANNEL_SPEED].count, 0);
    ck_assert(isnan(fit[WCUT_EVIDENCE_CHANNEL_SPEED].low));
    ck_assert_int_eq(fit[WCUT_EVIDENCE_CHANNEL_SCAN].count, 0);
    ck_assert_int_eq(fit[WCUT_EVIDENCE_CHANNEL_ALPHA].count, BINS - 1); /* both mounts, means of two bins */
    for (int i = 0; i < BINS; i++)                                      /* both tensions stand first */
        x[i] = (row[2 * i] + row[2 * i + 1]) / 2, y[i] = (other[2 * i] + other[2 * i + 1]) / 2;
    wcut_score score = wcut_score_of(BINS, x, y, 0);
    ck_assert_int_eq(fit[WCUT_EVIDENCE_CHANNEL_TENSION].count, BINS);
    ck_assert_double_eq_tol(fit[WCUT_EVIDENCE_CHANNEL_TENSION].rmsd, score.rmsd, 1e-12);
    ck_assert_double_eq_tol(fit[WCUT_EVIDENCE_CHANNEL_TENSION].nrmsd, score.nrmsd, 1e-12);
    ck_assert_double_eq_tol(fit[WCUT_EVIDENCE_CHANNEL_TENSION].rmse_over_range, score.rmse_over_range, 1e-12);
    for (int i = 0; i < BINS; i++) { /* beta: the fourth and the sixth signal, in deg */
        const int at = (i < BINS / 2 ? 3 : 4) * BINS + 2 * i;
        x[i] = (row[at] + row[at + 1]) / 2 * 180 / WCUT_PI, y[i] = (other[at] + other[at + 1]) / 2 * 180 / WCUT_PI;
    }
    score = wcut_score_of(BINS, x, y, 0);
    const wcut_evidence_score *beta = &fit[WCUT_EVIDENCE_CHANNEL_BETA];
    ck_assert_double_eq_tol(beta->rmsd, score.rmsd, 1e-10);
    /* 60 independent values: 95 % of their root mean square lie within about 18 % */
    ck_assert_double_eq_tol(beta->low / beta->rmse_over_range, 0.82, 0.09);
    ck_assert_double_eq_tol(beta->high / beta->rmse_over_range, 1.18, 0.09);
    ck_assert_int_eq(wcut_forecast_score(&e, &measured, &predicted, 7, again), WCUT_OK);
    ck_assert_double_eq(again[WCUT_EVIDENCE_CHANNEL_BETA].low, beta->low);
    bool differs = false; /* six blocks have few means: a quantile may be the same by chance */
    for (unsigned seed = 8; seed < 14; seed++) {
        ck_assert_int_eq(wcut_forecast_score(&e, &measured, &predicted, seed, again), WCUT_OK);
        differs = differs || again[WCUT_EVIDENCE_CHANNEL_BETA].low != beta->low;
    }
    ck_assert(differs);
}

TEST(without_memory_nothing_is_written) {
    given_a_lag(1, true, 1);
    wcut_cross_validation p = {.score = {{{.count = 999}}}};
    wcut_error error = {0};
    FIRST_FAILED_ALLOCATIONS(8, wcut_cross_validation_create(evidence, &none, &lag, 1, &p, &error),
                             p.score[0][0].count == 999);
    forget();
}
