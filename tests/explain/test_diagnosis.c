/* Diagnoses of small and of bad cases: any number of threads, stopped half way, with parts missing, refused.
   labels: unit slow */
#include <wirecut/diagnosis_file.h>
#include "base/alloc.h"
#include "cut/cuts.h"
#include "explain/cross_validation.h"
#include "explain/machine.h"
#include "test.h"

/* what an output holds before a call */
static char untouched;
#define UNTOUCHED ((wcut_diagnosis *)(void *)&untouched)

static machine_secret lag(void) {
    return (machine_secret){
        .effects = 1, .effect = {machine_effect(WCUT_EFFECT_WIRE_THERMAL_LAG, 0, 0.8, 0)}, .seed = 5};
}

static bool says(const wcut_diagnosis *d, const char *what) {
    for (int k = 0; k < d->limits; k++)
        if (strstr(d->limit[k], what)) return true;
    return false;
}

static wcut_diagnosis *diagnose(int cuts, const wcut_diagnosis_cut *cut, int test_cuts, const wcut_test_cut *table) {
    wcut_diagnosis_options options = wcut_diagnosis_options_default();
    wcut_diagnosis *d = NULL;
    wcut_error error = {0};
    options.proof = false;
    const wcut_status status = wcut_diagnosis_create(cuts, cut, test_cuts, table, &options, NULL, NULL, &d, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return d;
}

/* ---- threads and progress ---- */

/* stops so many calls after a step has begun */
typedef struct watch {
    int stop_at, after, last, calls, asked;
    bool in_order;
} watch;

static int look(int done, int all, void *context) {
    watch *w = context;
    w->in_order = w->in_order && done >= w->last && done < all;
    w->last = done, w->calls++;
    if (done < w->stop_at || w->after-- > 0) return 0;
    return ++w->asked;
}

TEST(one_thread_two_and_three_give_the_same_bytes) {
    const machine_secret secret = lag();
    machine_case m = machine_create(2, &secret);
    char *text[3] = {NULL};
    for (int k = 0; k < 3; k++) {
        wcut_diagnosis_options options = wcut_diagnosis_options_default();
        wcut_diagnosis *d = NULL;
        wcut_error error = {0};
        watch w = {.stop_at = 1000, .in_order = true};
        options.threads = k + 1;
        const wcut_status status = wcut_diagnosis_create(2, m.cut, 0, NULL, &options, look, &w, &d, &error);
        ck_assert_msg(status == WCUT_OK, "%s", error.text);
        ck_assert(w.in_order && w.calls > 5);
        ck_assert(!d->interrupted);
        ck_assert_int_eq(wcut_diagnosis_print(d, "a case", &text[k]), WCUT_OK);
        wcut_diagnosis_destroy(d);
    }
    for (int k = 0; k < 3; k++) {
        ck_assert_str_eq(text[0], text[k]);
        if (k > 0) free(text[k]);
    }
    free(text[0]);
    machine_destroy(&m);
}

/* Within a drive of a wire, not between stages only: calls come by the hundred in each. Two threads, so that both hear. */
TEST(a_diagnosis_that_is_stopped_keeps_what_it_has) {
    static const struct {
        int stop_at, after;
        const char *stage; /* NULL: before there is anything */
    } stop[] = {{0, 0, NULL},
                {0, 100, NULL},
                {1, 100, NULL},
                {4, 0, "while the library was screened"},
                {5, 200, "while effects were fitted one by one"},
                {33, 200, "while the forward proof was run"}};
    const machine_secret secret = lag();
    machine_case m = machine_create(2, &secret);
    wcut_diagnosis_options options = wcut_diagnosis_options_default();
    options.threads = 2;
    for (size_t k = 0; k < sizeof stop / sizeof *stop; k++) {
        wcut_diagnosis *d = UNTOUCHED;
        wcut_error error = {0};
        watch w = {.stop_at = stop[k].stop_at, .after = stop[k].after, .in_order = true};
        ck_assert_int_eq(wcut_diagnosis_create(2, m.cut, 0, NULL, &options, look, &w, &d, &error), WCUT_INTERRUPTED);
        ck_assert_msg(strstr(error.text, "stopped on request while"), "%s", error.text);
        ck_assert_int_eq(w.asked, 1); /* heard at once: nobody is asked again */
        ck_assert_msg((d == UNTOUCHED) == !stop[k].stage, "stopped %d calls after %d", stop[k].after, stop[k].stop_at);
        if (!stop[k].stage) continue;
        ck_assert(d->interrupted);
        ck_assert_str_eq(d->stopped, stop[k].stage);
        ck_assert_msg(strstr(d->sentence, "Stopped on request") && strstr(d->sentence, stop[k].stage), "%s",
                      d->sentence);
        ck_assert_int_ge(d->hypotheses, 1);
        ck_assert_int_eq(d->traces, 12);
        ck_assert_int_eq(d->score[WCUT_EVIDENCE_MODEL_AFTER][WCUT_EVIDENCE_CHANNEL_TENSION].count, 0);
        if (stop[k].stop_at == 33)
            ck_assert_msg(machine_names(d, WCUT_EFFECT_WIRE_THERMAL_LAG, WCUT_EFFECT_WIRE_THERMAL_LAG), "%s",
                          machine_verdict(d));
        else /* what was not tried is not ruled out */
            ck_assert_msg(d->kind != WCUT_VERDICT_NONE && d->confidence == 0, "%s", machine_verdict(d));
        char *text = NULL;
        ck_assert_int_eq(wcut_diagnosis_print(d, "a case", &text), WCUT_OK);
        ck_assert(strstr(text, "\"interrupted\": true") && strstr(text, stop[k].stage));
        free(text);
        wcut_diagnosis_destroy(d);
    }
    machine_destroy(&m);
}

/* ---- bad cases ---- */

/* steady test cuts of a foam with this law, 1 % of scatter in turn up and down */
static void make_table(double a, double b, wcut_test_cut *table) {
    static const double heat[] = {50, 60, 70, 85}, alpha[] = {18, 27, 36};
    for (int i = 0; i < 12; i++) {
        const double turn = alpha[i % 3] * WCUT_PI / 180, force = 2 * 2 * sin(turn) / 400;
        const double tension = 2 * (i % 2 ? 1.01 : 0.99);
        table[i] = (wcut_test_cut){.heat = heat[i / 3],
                                   .speed = 1000 * heat[i / 3] * b / log(a / force),
                                   .engaged = 400,
                                   .tension_a = tension,
                                   .tension_b = tension,
                                   .alpha_a = turn,
                                   .alpha_b = turn,
                                   .weight = 1};
    }
}

static void empty(wcut_recording *r, wcut_channel channel) {
    wcut_column *c = &r->channel[channel];
    wcut_free(c->present);
    c->present = wcut_alloc((size_t)r->samples, 1);
    memset(c->present, 0, (size_t)r->samples);
    c->missing = r->samples;
}

TEST(a_good_case_has_none_of_the_bad_ones_limits) {
    const machine_secret secret = {.seed = 31};
    machine_case m = machine_create(2, &secret);
    wcut_test_cut table[12];
    make_table(0.1, 8.6e-4, table);
    wcut_diagnosis *d = diagnose(2, m.cut, 12, table);
    static const char *const bad[] = {"is left out:", "With one cut", "No cut has an excitation",
                                      "empty",        "one heat",     "calibration table"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) ck_assert_msg(!says(d, bad[k]), "%s", bad[k]);
    ck_assert_msg(says(d, "Without a scan"), "no scan");
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}

TEST(everything_bad_at_once_runs_and_each_of_it_is_said) {
    const machine_secret secret = {.plain = true, .one_heat = true, .seed = 32};
    machine_case m = machine_create(1, &secret);
    wcut_test_cut table[12];
    make_table(0.1 * 1.6, 8.6e-4 * 1.5, table);
    empty(&m.run[0]->recording, WCUT_CHANNEL_BETA_A);
    const wcut_diagnosis_cut cut[3] = {m.cut[0], {.job = m.job[0]}, {.recording = m.cut[0].recording}};
    wcut_diagnosis *d = diagnose(3, cut, 12, table);
    static const char *const bad[] = {"Cut 2 is left out: it has no recording",
                                      "Cut 3 is left out: it has no job",
                                      "With one cut nothing can be held out",
                                      "Without a scan",
                                      "No cut has an excitation",
                                      "1 channels of the recordings are empty",
                                      "one heat",
                                      "The calibration table contradicts the cuts"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) ck_assert_msg(says(d, bad[k]), "not said: %s", bad[k]);
    ck_assert_int_eq(d->cuts, 3);
    ck_assert_msg(d->effects == 0, "%s", machine_verdict(d)); /* no effect was there, whatever is missing */
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}

/* ---- refused ---- */

static wcut_status refused(int cuts, const wcut_diagnosis_cut *cut, int test_cuts, int threads) {
    wcut_diagnosis_options options = wcut_diagnosis_options_default();
    wcut_diagnosis *d = UNTOUCHED;
    wcut_error error = {0};
    options.threads = threads;
    const wcut_status status = wcut_diagnosis_create(cuts, cut, test_cuts, NULL, &options, NULL, NULL, &d, &error);
    ck_assert(d == UNTOUCHED);
    ck_assert_int_gt((int)strlen(error.text), 0);
    return status;
}

TEST(what_cannot_be_diagnosed_is_refused_and_nothing_written) {
    const machine_secret secret = {.plain = true, .seed = 33};
    machine_case m = machine_create(1, &secret);
    const wcut_diagnosis_cut none = {0}, alone = {.job = m.job[0]};
    ck_assert_int_eq(refused(0, m.cut, 0, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(refused(1, NULL, 0, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(refused(1, m.cut, 3, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(refused(1, m.cut, 0, 0), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(refused(1, &none, 0, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(refused(1, &alone, 0, 1), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_diagnosis_create(1, m.cut, 0, NULL, NULL, NULL, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    wcut_recording bare = *m.cut[0].recording;
    bare.further = NULL;
    const wcut_diagnosis_cut unnumbered = {.job = m.job[0], .recording = &bare};
    ck_assert_int_eq(refused(1, &unnumbered, 0, 1), WCUT_BAD_ARGUMENT);
    m.job[0]->wire_length = 300; /* shorter than the mounts are apart */
    ck_assert_int_eq(refused(1, m.cut, 0, 1), WCUT_DEGENERATE);
    m.job[0]->wire_length = 560;
    m.job[0]->mode = WCUT_MODE_DESIGN;
    ck_assert_int_eq(refused(1, m.cut, 0, 1), WCUT_BAD_ARGUMENT);
    m.job[0]->mode = WCUT_MODE_PATH;
    machine_destroy(&m);
}

/* ---- the correction, scored again ---- */

/* what jobs that are put right score as they are, in bins that were made before */
static void check_score(const wcut_evidence *e, const wcut_diagnosis *d) {
    wcut_fitted none = {0};
    wcut_cross_validation proof = {0};
    wcut_error error = {0};
    ck_assert_int_eq(wcut_model_fit(e, &e->at, &none, &error), WCUT_OK);
    ck_assert_int_eq(wcut_cross_validation_create(e, &none, &none, 1, &proof, &error), WCUT_OK);
    for (int c = WCUT_EVIDENCE_CHANNEL_TENSION; c <= WCUT_EVIDENCE_CHANNEL_BETA; c++) {
        const wcut_evidence_score *after = &d->score[WCUT_EVIDENCE_MODEL_AFTER][c];
        const wcut_evidence_score *before = &proof.score[WCUT_EVIDENCE_MODEL_BEFORE][c];
        ck_assert_int_eq(before->count, after->count);
        ck_assert_msg(fabs(before->rmse_over_range / after->rmse_over_range - 1) < 1e-6, "%s: %.9g, again %.9g",
                      wcut_evidence_name((wcut_evidence_channel)c), after->rmse_over_range, before->rmse_over_range);
    }
    wcut_cross_validation_destroy(&proof);
    wcut_fitted_destroy(&none);
}

/* the model called "after" put into the jobs by the correction is what the table scored: diagnosed anew, the corrected jobs
   are "before" what they were "after" */
TEST(corrected_jobs_have_the_figures_that_the_table_calls_after) {
    const machine_secret secret = {
        .effects = 1, .effect = {machine_effect(WCUT_EFFECT_WIRE_THERMAL_LAG, 0, 0.8, 0)}, .law_a = 1.1, .seed = 5};
    machine_case m = machine_create(2, &secret);
    wcut_diagnosis_options options = wcut_diagnosis_options_default();
    wcut_diagnosis *d = NULL, *again = NULL;
    wcut_error error = {0};
    ck_assert_int_eq(wcut_diagnosis_create(m.cuts, m.cut, 0, NULL, &options, NULL, NULL, &d, &error), WCUT_OK);
    ck_assert_str_eq(d->withheld, "");

    // in the bins of the first diagnosis the figures are the same
    wcut_evidence *e = NULL;
    ck_assert_int_eq(wcut_evidence_create(m.cuts, m.cut, false, 1, NULL, &e, &error), WCUT_OK);
    const wcut_model model = e->at;
    ck_assert_int_eq(wcut_evidence_predict(e, &model, false, &error), WCUT_OK);
    for (int k = 0; k < m.cuts; k++) ck_assert_int_eq(wcut_correction_apply(&d->correction, m.job[k], &error), WCUT_OK);
    check_score(e, d);
    wcut_evidence_destroy(e);

    // diagnosed anew, its bins begin where the corrected wire is taut
    ck_assert_int_eq(wcut_diagnosis_create(m.cuts, m.cut, 0, NULL, &options, NULL, NULL, &again, &error), WCUT_OK);
    for (int c = WCUT_EVIDENCE_CHANNEL_TENSION; c <= WCUT_EVIDENCE_CHANNEL_BETA; c++) {
        const wcut_evidence_score *after = &d->score[WCUT_EVIDENCE_MODEL_AFTER][c];
        const wcut_evidence_score *before = &again->score[WCUT_EVIDENCE_MODEL_BEFORE][c];
        ck_assert_int_gt(after->count, 50);
        /* 0.25 s later, half a bin: other means of the same readings */
        ck_assert_msg(fabs(before->rmse_over_range / after->rmse_over_range - 1) < 0.3, "%s: %g, again %g",
                      wcut_evidence_name((wcut_evidence_channel)c), after->rmse_over_range, before->rmse_over_range);
    }

    // what was wrong before is gone with it
    const double wrong = d->score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_TENSION].rmse_over_range;
    ck_assert_double_lt(again->score[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_TENSION].rmse_over_range,
                        wrong / 4);

    // and the improved job is the first cut's with it
    ck_assert_double_eq(d->improved->force_law.a, m.job[0]->force_law.a);
    ck_assert_double_eq(d->improved->wire_length, m.job[0]->wire_length);
    ck_assert_int_eq(d->improved->effect_count, 1);
    ck_assert_int_eq(d->improved->dither_count + d->improved->heat_step_count, 0);
    wcut_diagnosis_destroy(again);
    wcut_diagnosis_destroy(d);
    machine_destroy(&m);
}
