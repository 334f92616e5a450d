/* score.json and residuals.csv: in the units of files, with what failed and without what is missing. */
#include <jansson.h>
#include <unistd.h>
#include <wirecut/recording_file.h>
#include <wirecut/score.h>
#include <wirecut/score_file.h>
#include <wirecut/table.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "cut/trials.h"
#include "test.h"

static wcut_job *job;
static wcut_recording *recording;
static wcut_comparison *comparison;
static wcut_error failure;

static void given_scored_cuts(wcut_scored_cut cut[3]) {
    job = short_job();
    recording = driven_recording(job, 3, 0.1, 140);
    lose_sample(recording, WCUT_CHANNEL_BETA_B, 80);
    lose_sample(recording, WCUT_CHANNEL_STATION, 90);
    wcut_comparison_options o = wcut_comparison_options_default();
    o.settle = o.leave = 0.3;
    ck_assert_int_eq(wcut_comparison_create(job, recording, &o, &comparison, NULL), WCUT_OK);
    failure = (wcut_error){WCUT_BAD_FORMAT, "line 7: \"odd\"\n"};
    cut[0] = (wcut_scored_cut){"one", "a, \"quoted\" cut", "job.json", "r.csv", recording, comparison, NULL};
    cut[1] = (wcut_scored_cut){"one", "bad", "job.json", "none.csv", NULL, NULL, &failure};
    cut[2] = (wcut_scored_cut){"two", "third", "job.json", "r.csv", recording, comparison, NULL};
}

static void forget_scored_cuts(void) {
    wcut_comparison_destroy(comparison);
    wcut_recording_destroy(recording);
    wcut_job_destroy(job);
}

static double number_at(const json_t *root, const char *a, const char *b, const char *c) {
    const json_t *value = json_object_get(json_object_get(json_object_get(root, a), b), c);
    ck_assert_msg(json_is_number(value), "%s.%s.%s is no number", a, b, c);
    return json_number_value(value);
}

TEST(scores_are_written_in_the_units_of_files) {
    wcut_scored_cut cut[3];
    char *text = NULL;
    given_scored_cuts(cut);
    ck_assert_int_eq(wcut_score_print(3, cut, NULL, &text), WCUT_OK);
    json_t *root = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    ck_assert_ptr_nonnull(root);
    ck_assert_str_eq(json_string_value(json_object_get(root, "format")), "wirecut-score/1");
    const json_t *cuts = json_object_get(root, "cuts"), *first = json_array_get(cuts, 0);
    ck_assert_uint_eq(json_array_size(cuts), 3);
    ck_assert_str_eq(json_string_value(json_object_get(first, "cut")), "a, \"quoted\" cut");
    const wcut_score *alpha = &comparison->planned_score.of[WCUT_SCORED_ALPHA][WCUT_PART_ALL];
    const wcut_score *speed = &comparison->planned_score.of[WCUT_SCORED_SPEED_A][WCUT_PART_ALL];
    const double degree = acos(-1) / 180;
    ck_assert_double_eq_tol(number_at(first, "planned", "alpha", "rmsd"), alpha->rmsd / degree, 1e-12);
    ck_assert_double_eq_tol(number_at(first, "planned", "alpha", "nrmsd"), alpha->nrmsd, 1e-12);
    ck_assert_double_eq_tol(number_at(first, "planned", "speed_a_mm_s", "bias"), speed->bias, 1e-12);
    ck_assert_ptr_null(json_object_get(json_object_get(first, "replayed"), "speed"));
    ck_assert_double_eq_tol(number_at(json_object_get(root, "mean"), "planned", "alpha", "rmsd"), alpha->rmsd / degree,
                            1e-12);
    ck_assert_str_eq(json_string_value(json_object_get(json_array_get(cuts, 1), "error")), failure.text);
    ck_assert_uint_eq(json_array_size(json_object_get(root, "cases")), 2);
    json_decref(root);
    free(text);
    forget_scored_cuts();
}

TEST(residuals_are_a_row_a_sample_and_missing_ones_are_empty) {
    wcut_scored_cut cut[3];
    given_scored_cuts(cut);
    char path[64];
    snprintf(path, sizeof path, "test_score_write.%ld.csv", (long)getpid());
    ck_assert_int_eq(wcut_residuals_write(3, cut, path, NULL), WCUT_OK);
    wcut_table *table = NULL;
    wcut_error error = {WCUT_OK, ""};
    ck_assert_msg(wcut_table_read(path, 0, NULL, &table, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(table->rows, 280);
    const int measured = wcut_table_locate(table, "beta_b_deg"),
              planned = wcut_table_locate(table, "planned_beta_b_deg");
    const int residual = wcut_table_locate(table, "planned_residual_alpha_a_deg"),
              station = wcut_table_locate(table, "station");
    const int replayed = wcut_table_locate(table, "replayed_tension_a_N"),
              counted = wcut_table_locate(table, "counted");
    ck_assert(measured >= 0 && planned >= 0 && residual >= 0 && station >= 0 && replayed >= 0 && counted >= 0);
    ck_assert_int_eq(wcut_table_locate(table, "replayed_speed_a_mm_s"), -1);
    ck_assert(!table->column[measured].present[80] && table->column[measured].missing == 2);
    ck_assert(!table->column[station].present[90] && !table->column[planned].present[90] &&
              !table->column[replayed].present[90]);
    int rows = 0;
    for (int i = 0; i < 140; i++) rows += table->column[counted].value[i] == 1;
    ck_assert_int_eq(rows, comparison->counted_samples);
    const double d =
        (recording->channel[WCUT_CHANNEL_ALPHA_A].value[70] - comparison->planned->value[4][70]) * 180 / acos(-1);
    ck_assert_double_eq_tol(table->column[residual].value[70], d, 1e-6);
    wcut_table_destroy(table);
    remove(path);
    forget_scored_cuts();
}

TEST(scores_that_cannot_be_written_are_not) {
    wcut_scored_cut cut[3], half;
    char *text = NULL;
    given_scored_cuts(cut);
    half = cut[0], half.samples = NULL;
    ck_assert_int_eq(wcut_score_print(0, cut, NULL, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_print(1, &half, NULL, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_print(3, cut, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_write(3, cut, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_score_write(3, cut, NULL, "no/such/folder/score.json", NULL), WCUT_NOT_WRITTEN);
    ck_assert_int_eq(wcut_residuals_write(3, cut, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_residuals_write(3, cut, "no/such/folder/r.csv", NULL), WCUT_NOT_WRITTEN);
    EACH_FAILED_ALLOCATION(wcut_score_print(3, cut, NULL, &text), !text);
    free(text);
    forget_scored_cuts();
}
