/* The black box: it learns what its inputs say, is judged on cuts it has not seen, and noise teaches it nothing. */
#include "explain/black_box.h"

#include "base/alloc.h"
#include "explain/synthetic.h"
#include "test.h"

static synthetic given;
static wcut_evidence *evidence;
static wcut_cross_validation proof;

/* forecasts made in place: measured = predicted + noise + `share` of an input two bins ago */
static void given_a_residual(int cuts, double share, double noise) {
    const concealed nothing = {.noise = 1, .seed = 41};
    given = synthetic_create(cuts, &nothing);
    evidence = evidence_of(&given, 1);
    proof = (wcut_cross_validation){.score = {{{0}}}};
    const size_t rows = (size_t)evidence->rows;
    size_t speeds = 0;
    for (int k = 0; k < cuts; k++) speeds += 2 * (size_t)evidence->cut[k].bins;
    proof.measured = (wcut_forecast){wcut_alloc(rows, sizeof(double)), wcut_alloc(speeds, sizeof(double))};
    for (int m = 0; m < WCUT_EVIDENCE_MODEL_BLACK_BOX; m++) {
        proof.in_sample[m] = (wcut_forecast){wcut_alloc(rows, sizeof(double)), wcut_alloc(speeds, sizeof(double))};
        proof.held_out[m] = (wcut_forecast){wcut_alloc(rows, sizeof(double)), wcut_alloc(speeds, sizeof(double))};
    }
    wcut_random random = wcut_random_seed(5);
    for (int k = 0; k < cuts; k++) {
        const wcut_evidence_cut *c = &evidence->cut[k];
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++) {
            const int bin = i % c->bins, ago = bin > 1 ? bin - 2 : 0, row = c->row + i;
            const double predicted = sin(0.2 * bin);
            for (int m = 0; m < WCUT_EVIDENCE_MODEL_BLACK_BOX; m++)
                proof.in_sample[m].row[row] = proof.held_out[m].row[row] = predicted;
            proof.measured.row[row] =
                predicted + noise * wcut_random_normal(&random) + share * (c->heat[ago] - 65) / 65;
        }
    }
}

static void forget(void) {
    wcut_cross_validation_destroy(&proof);
    wcut_evidence_destroy(evidence);
    synthetic_destroy(&given);
}

/* root mean square of what the recalibrated model leaves of both tensions, over the measured range */
static double left_before(void) {
    wcut_evidence_score fit[WCUT_EVIDENCE_CHANNEL_COUNT];
    ck_assert_int_eq(
        wcut_forecast_score(evidence, &proof.measured, &proof.held_out[WCUT_EVIDENCE_MODEL_RECALIBRATED], 1, fit),
        WCUT_OK);
    return fit[WCUT_EVIDENCE_CHANNEL_TENSION].rmse_over_range;
}

TEST(what_the_inputs_say_is_learnt_and_holds_on_other_cuts) {
    given_a_residual(SYNTHETIC_CUTS, 1, 0.02);
    ck_assert_int_eq(wcut_black_box_run(evidence, 1, &proof), WCUT_OK);
    const wcut_evidence_score *held_out = proof.held_out_score[WCUT_EVIDENCE_MODEL_BLACK_BOX],
                              *all = proof.score[WCUT_EVIDENCE_MODEL_BLACK_BOX];
    ck_assert_double_lt(held_out[WCUT_EVIDENCE_CHANNEL_TENSION].rmse_over_range, 0.6 * left_before());
    ck_assert_double_lt(all[WCUT_EVIDENCE_CHANNEL_TENSION].rmsd, held_out[WCUT_EVIDENCE_CHANNEL_TENSION].rmsd);
    ck_assert_double_gt(all[WCUT_EVIDENCE_CHANNEL_ALPHA].count, 0);
    ck_assert_int_eq(all[WCUT_EVIDENCE_CHANNEL_SPEED].count, 0);
    ck_assert_int_eq(all[WCUT_EVIDENCE_CHANNEL_SCAN].count, 0);
    ck_assert_int_eq(held_out[WCUT_EVIDENCE_CHANNEL_SPEED].count, 0);
    forget();
}

TEST(noise_teaches_it_nothing_that_holds) {
    given_a_residual(SYNTHETIC_CUTS, 0, 0.1);
    ck_assert_int_eq(wcut_black_box_run(evidence, 1, &proof), WCUT_OK);
    ck_assert_double_gt(
        proof.held_out_score[WCUT_EVIDENCE_MODEL_BLACK_BOX][WCUT_EVIDENCE_CHANNEL_TENSION].rmse_over_range,
        0.97 * left_before());
    forget();
}

TEST(missing_rows_are_left_out_and_one_cut_alone_holds_nothing_out) {
    given_a_residual(1, 1, 0.02);
    for (int i = 3; i < 9; i++) proof.measured.row[i] = (double)NAN;
    ck_assert_int_eq(wcut_black_box_run(evidence, 1, &proof), WCUT_OK);
    ck_assert_int_eq(proof.score[WCUT_EVIDENCE_MODEL_BLACK_BOX][WCUT_EVIDENCE_CHANNEL_TENSION].count,
                     2 * (evidence->cut[0].bins / 2) - 4); /* means of two bins, one of tension_a missing in four */
    for (int k = 0; k < WCUT_EVIDENCE_CHANNEL_COUNT; k++)
        ck_assert_int_eq(proof.held_out_score[WCUT_EVIDENCE_MODEL_BLACK_BOX][k].count, 0);
    forget();
}

TEST(without_memory_nothing_is_written) {
    given_a_residual(2, 1, 0.02);
    proof.score[WCUT_EVIDENCE_MODEL_BLACK_BOX][0].count = 999;
    FIRST_FAILED_ALLOCATIONS(12, wcut_black_box_run(evidence, 1, &proof),
                             proof.score[WCUT_EVIDENCE_MODEL_BLACK_BOX][0].count == 999);
    forget();
}
