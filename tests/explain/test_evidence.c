/* Evidence: bins of what was measured and predicted at any rate, and noise made white. */
#include "explain/droop.h"
#include "explain/evidence.h"

#include "base/alloc.h"
#include "explain/synthetic.h"
#include "test.h"

static const concealed nothing = {.noise = 0, .seed = 1}, noisy = {.noise = 1, .seed = 2};

TEST(the_jobs_own_wire_leaves_nothing_but_the_smoothing_of_its_motion) {
    synthetic s = synthetic_create(2, &nothing);
    wcut_evidence *e = evidence_of(&s, 1);
    double *residual = wcut_alloc((size_t)e->rows, sizeof *residual);
    wcut_evidence_residual(e, residual);
    ck_assert_int_eq(e->rows, WCUT_SIGNALS * (e->cut[0].bins + e->cut[1].bins));
    for (int k = 0; k < 2; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        ck_assert_int_gt(c->bins, 25);
        ck_assert_double_gt(c->from, c->contact);
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++)
            ck_assert_double_le(fabs(residual[c->row + i]), i < 2 * c->bins ? 0.05 : 0.002);
        for (int i = 1; i < c->bins; i++) {
            ck_assert_double_eq_tol(c->middle[i] - c->middle[i - 1], WCUT_BIN_WIDTH, 1e-12);
            ck_assert_double_gt(c->station[i], c->station[i - 1]);
            ck_assert(c->pace[i] > 9 && c->pace[i] < 20 && c->heat[i] > 50 && c->heat[i] < 80);
            ck_assert(c->engaged[i] > 150 && c->engaged[i] < 400);
        }
    }
    wcut_free(residual);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(whitened_noise_has_unit_variance_and_no_memory) {
    synthetic s = synthetic_create(1, &noisy);
    wcut_evidence *e = evidence_of(&s, 1);
    double *z = wcut_alloc((size_t)e->rows, sizeof *z), square = 0, product = 0, next = 0;
    const wcut_evidence_cut *c = &e->cut[0];
    wcut_random random = wcut_random_seed(11);
    int n = 0, pairs = 0;
    for (int draw = 0; draw < 200; draw++) {
        white_rows(e, &random, z);
        for (int k = 0; k < WCUT_SIGNALS; k++) {
            for (int i = 0; i < c->bins; i++) square += pow(z[k * c->bins + i], 2), n++;
            for (int i = 2; i < c->bins; i++) {
                product += z[k * c->bins + i] * z[k * c->bins + i - 1];
                next += z[k * c->bins + i] * z[k * c->bins + i - 2], pairs++;
            }
        }
    }
    /* four standard errors */
    ck_assert_double_eq_tol(square / n, 1, 4 * sqrt(2.0 / n));
    ck_assert_double_eq_tol(product / pairs, 0, 4 / sqrt(pairs));
    ck_assert_double_eq_tol(next / pairs, 0, 4 / sqrt(pairs));
    wcut_free(z);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(whitening_is_linear_and_missing_rows_are_nothing) {
    synthetic s = synthetic_create(1, &noisy);
    wcut_evidence *e = evidence_of(&s, 1);
    const size_t rows = (size_t)e->rows;
    double *x = wcut_alloc(5 * rows, sizeof *x), *y = x + rows, *sum = x + 2 * rows, *wx = x + 3 * rows;
    double *wy = x + 4 * rows;
    e->cut[0].measured[0][7] = (double)NAN;
    wcut_random random = wcut_random_seed(3);
    noise_rows(e, &random, x);
    noise_rows(e, &random, y);
    for (size_t i = 0; i < rows; i++) sum[i] = 2 * x[i] - 3 * y[i];
    double *raw = wcut_alloc(rows, sizeof *raw);
    wcut_evidence_residual(e, raw);
    ck_assert(isnan(raw[7]));
    wcut_evidence_whiten(e, raw, x, wx);
    wcut_evidence_whiten(e, raw, y, wy);
    wcut_evidence_whiten(e, raw, sum, sum);
    for (size_t i = 0; i < rows; i++) ck_assert_double_eq_tol(sum[i], 2 * wx[i] - 3 * wy[i], 1e-10);
    ck_assert_double_eq(wx[7], 0);
    ck_assert_double_ne(wx[8], 0);
    wcut_free(raw);
    wcut_free(x);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(the_white_part_of_the_noise_is_measured_and_a_misfit_does_not_move_it) {
    synthetic s = synthetic_create(2, &noisy);
    wcut_evidence *e = evidence_of(&s, 1);
    /* five samples of 0.02 N, 0.05 deg in a bin; what smoothing does to the motion comes on top */
    const double tension = 0.02 / sqrt(5), angle = 0.05 * WCUT_PI / 180 / sqrt(5);
    for (int k = 0; k < WCUT_SIGNALS; k++) {
        const double expected = k < 2 ? tension : angle;
        ck_assert(e->sigma[k] > 0.6 * expected && e->sigma[k] < 2 * expected);
    }
    const double before = e->sigma[2];
    wcut_model model = e->at;
    model.a *= 0.7;
    ck_assert_int_eq(wcut_evidence_predict(e, &model, false, NULL), WCUT_OK);
    ck_assert_double_eq_tol(e->sigma[2], before, 0.4 * before);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(the_same_bytes_come_from_any_number_of_threads) {
    synthetic s = synthetic_create(2, &noisy);
    wcut_evidence *one = evidence_of(&s, 1), *two = evidence_of(&s, 2);
    ck_assert_int_eq(one->rows, two->rows);
    for (int k = 0; k < 2; k++) {
        const wcut_evidence_cut *a = &one->cut[k], *b = &two->cut[k];
        const size_t bytes = (size_t)a->bins * sizeof(double);
        for (int i = 0; i < WCUT_SIGNALS; i++) {
            ck_assert_int_eq(memcmp(a->predicted[i], b->predicted[i], bytes), 0);
            ck_assert_int_eq(memcmp(a->measured[i], b->measured[i], bytes), 0);
        }
    }
    wcut_evidence_destroy(one);
    wcut_evidence_destroy(two);
    synthetic_destroy(&s);
}

TEST(a_model_of_a_cut_is_its_job_with_another_law_length_and_effects) {
    synthetic s = synthetic_create(2, &nothing);
    wcut_evidence *e = evidence_of(&s, 1);
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    wcut_model model = {.a = 0.07, .b = 5e-4, .length_change = -0.5, .effects = 1, .carried = true};
    model.effect[0] = effect_of(WCUT_EFFECT_WIRE_FOULING, 0.1);
    const wcut_job first = wcut_model_job(e, &model, 0, effect);
    ck_assert_double_eq(first.force_law.a, 0.07);
    ck_assert_double_eq(first.force_law.b, 5e-4);
    ck_assert_double_eq(first.wire_length, 379.5);
    ck_assert_int_eq(first.effect_count, 1);
    ck_assert_double_eq(first.effect[0].value[2], 0);
    const wcut_job second = wcut_model_job(e, &model, 1, effect);
    ck_assert_double_eq(second.effect[0].value[2], 400); /* the block's length, brought along */
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(a_case_that_shows_nothing_is_refused) {
    synthetic s = synthetic_create(1, &nothing);
    wcut_evidence *e = NULL;
    wcut_error error = {0};
    wcut_diagnosis_cut without = {.job = s.job[0]};
    ck_assert_int_eq(wcut_evidence_create(1, &without, false, 1, NULL, &e, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(e);
    ck_assert_ptr_nonnull(strstr(error.text, "no cut with a job and a recording"));
    s.recording[0]->samples = 30; /* 3 s: it has not touched the foam for long */
    ck_assert_int_eq(wcut_evidence_create(1, s.cut, false, 1, NULL, &e, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(e);
    ck_assert_ptr_nonnull(strstr(error.text, "4 s in the foam"));
    s.recording[0]->samples = SYNTHETIC_SAMPLES;
    s.job[0]->wire_length = 100; /* shorter than the mounts are apart */
    const wcut_status status = wcut_evidence_create(1, s.cut, false, 1, NULL, &e, &error);
    ck_assert_msg(status == WCUT_DEGENERATE || status == WCUT_BAD_ARGUMENT, "%d %s", status, error.text);
    ck_assert_ptr_null(e);
    synthetic_destroy(&s);
}

TEST(without_memory_nothing_is_written) {
    synthetic s = synthetic_create(1, &nothing);
    wcut_evidence *e = NULL;
    wcut_error error = {0};
    FIRST_FAILED_ALLOCATIONS(3, wcut_evidence_create(1, s.cut, false, 1, NULL, &e, &error), !e);
    synthetic_destroy(&s);
}

/* directions that point down by `deg` at the entry and come into line within six seconds or so */
static void let_hang(const wcut_evidence *e, int cut, double deg, double *open) {
    const wcut_evidence_cut *c = &e->cut[cut];
    for (int s = 3; s < WCUT_SIGNALS; s += 2)
        for (int i = 0; i < c->bins; i++) open[c->row + s * c->bins + i] -= deg * WCUT_PI / 180 * exp(-i / 4.0);
}

TEST(entries_in_which_every_wire_hangs_are_left_out_and_no_other) {
    synthetic s = synthetic_create(2, &noisy);
    wcut_evidence *e = evidence_of(&s, 1);
    const size_t rows = (size_t)e->rows;
    double *open = wcut_alloc(rows, sizeof *open);
    const int bins[2] = {e->cut[0].bins, e->cut[1].bins};
    wcut_evidence_residual(e, open);

    // noise alone, and one cut alone: nothing goes
    ck_assert_double_eq(wcut_droop_leave_out(e, open), 0);
    let_hang(e, 0, 1, open);
    ck_assert_double_eq(wcut_droop_leave_out(e, open), 0);
    ck_assert_int_eq(e->rows, (int)rows);

    // both, as gravity has it: the first seconds go, what is left stands where it stood
    let_hang(e, 1, 1, open);
    const double middle = e->cut[1].middle[bins[1] - 1], last = e->cut[1].measured[4][bins[1] - 1];
    const double seconds = wcut_droop_leave_out(e, open);
    ck_assert(seconds >= 4 && seconds <= 12);
    for (int k = 0; k < 2; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        ck_assert(c->bins < bins[k] && c->bins >= bins[k] / 2);
        ck_assert_double_eq_tol(c->middle[0], c->from + WCUT_BIN_WIDTH / 2, 1e-12);
        ck_assert_int_eq(c->row, k ? WCUT_SIGNALS * e->cut[0].bins : 0);
    }
    ck_assert_int_eq(e->rows, WCUT_SIGNALS * (e->cut[0].bins + e->cut[1].bins));
    ck_assert_double_eq(e->cut[1].middle[e->cut[1].bins - 1], middle);
    ck_assert_double_eq(e->cut[1].measured[4][e->cut[1].bins - 1], last);

    // up is no weight
    wcut_evidence_residual(e, open);
    let_hang(e, 0, -1, open);
    let_hang(e, 1, -1, open);
    ck_assert_double_eq(wcut_droop_leave_out(e, open), 0);
    wcut_free(open);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

/* ---- rates, ripple, spikes ---- */

/* a recording on finer samples: on straight lines between its own, with noise of each reading's own */
static wcut_recording *finer(const wcut_recording *r, int times, double noise, wcut_random *random) {
    wcut_recording *out = blank_recording((r->samples - 1) * times + 1, SYNTHETIC_STEP / times);
    add_channel(out, WCUT_CHANNEL_HEAT);
    for (int c = WCUT_CHANNEL_STATION; c <= WCUT_CHANNEL_HEAT; c++) {
        if (!r->channel[c].value) continue;
        const double size = c == WCUT_CHANNEL_TENSION_A || c == WCUT_CHANNEL_TENSION_B ? 0.02 * noise : 0;
        for (int i = 0; i < out->samples; i++) {
            const int k = i / times < r->samples - 1 ? i / times : r->samples - 2;
            const double share = (double)(i - k * times) / times;
            out->channel[c].value[i] = (1 - share) * r->channel[c].value[k] + share * r->channel[c].value[k + 1] +
                                       size * wcut_random_normal(random);
        }
    }
    return out;
}

static void exchange_recording(synthetic *s, wcut_recording *r) {
    wcut_recording_destroy(s->recording[0]);
    s->recording[0] = r;
    s->cut[0].recording = r;
}

TEST(a_recording_at_500_Hz_has_the_same_bins_with_less_noise) {
    synthetic s = synthetic_create(1, &nothing);
    wcut_random random = wcut_random_seed(41);
    wcut_evidence *slow = evidence_of(&s, 1);
    exchange_recording(&s, finer(s.recording[0], 50, 1, &random));
    wcut_evidence *fast = evidence_of(&s, 1);
    ck_assert_int_eq(fast->rows, slow->rows);
    ck_assert_double_eq_tol(fast->cut[0].from, slow->cut[0].from, 1e-9);

    // 250 readings a bin: the noise of their mean
    const double expected = 0.02 / sqrt(250);
    for (int m = 0; m < 2; m++) {
        ck_assert_double_eq_tol(fast->cut[0].within[m] / expected, 1, 0.1);

        // five readings from a bin's beginning on stand for a time 0.05 s before its middle: so far the two differ
        const double *few = slow->cut[0].measured[m], *many = fast->cut[0].measured[m];
        double steepest = 0;
        for (int i = 1; i < fast->cut[0].bins; i++)
            steepest = fmax(steepest, fabs(many[i] - many[i - 1]) / WCUT_BIN_WIDTH);
        for (int i = 0; i < fast->cut[0].bins; i++) {
            ck_assert_double_le(fabs(many[i] - few[i]), 0.05 * steepest + 5 * expected);
            ck_assert_double_le(fabs(fast->cut[0].predicted[m][i] - slow->cut[0].predicted[m][i]),
                                0.05 * steepest + 0.01);
        }
    }
    wcut_evidence_destroy(fast);
    wcut_evidence_destroy(slow);
    synthetic_destroy(&s);
}

TEST(what_is_faster_than_a_bin_is_told_from_the_noise_of_readings) {
    synthetic s = synthetic_create(1, &noisy);
    wcut_evidence *e = evidence_of(&s, 1);
    ck_assert_double_lt(wcut_evidence_swiftness(e), 3);
    wcut_evidence_destroy(e);

    // a ripple of 0.1 N and 1.1 s under quiet readings at 200 Hz
    wcut_random random = wcut_random_seed(42);
    exchange_recording(&s, finer(s.recording[0], 20, 0.1, &random));
    for (int i = 0; i < s.recording[0]->samples; i++)
        for (int m = 0; m < 2; m++)
            s.recording[0]->channel[WCUT_CHANNEL_TENSION_A + m].value[i] +=
                0.1 * sin(2 * WCUT_PI * i * SYNTHETIC_STEP / 20 / 1.1);
    e = evidence_of(&s, 1);
    ck_assert_double_gt(wcut_evidence_swiftness(e), 5);
    wcut_evidence_destroy(e);
    synthetic_destroy(&s);
}

TEST(spikes_and_lost_readings_leave_the_bins_where_they_were) {
    synthetic s = synthetic_create(1, &noisy);
    wcut_evidence *clean = evidence_of(&s, 1);
    wcut_random random = wcut_random_seed(43);
    int spikes = 0;
    for (int i = 5; i + 5 < s.recording[0]->samples; i++) {
        const double draw = wcut_random_uniform(&random);

        // one reading in fifty is off by 1 N, another is missing
        if (draw < 0.02)
            s.recording[0]->channel[WCUT_CHANNEL_TENSION_A].value[i] += draw < 0.01 ? 1 : -1, spikes++, i += 2;
        if (draw > 0.98) lose_sample(s.recording[0], WCUT_CHANNEL_TENSION_A, i);
    }
    ck_assert_int_gt(spikes, 3);
    wcut_evidence *e = evidence_of(&s, 1);
    for (int i = 0; i < e->cut[0].bins; i++)
        ck_assert_msg(fabs(e->cut[0].measured[0][i] - clean->cut[0].measured[0][i]) < 0.04, "bin %d: %g, clean %g", i,
                      e->cut[0].measured[0][i], clean->cut[0].measured[0][i]);
    ck_assert_double_lt(e->sigma[0], 1.5 * clean->sigma[0]);
    wcut_evidence_destroy(e);
    wcut_evidence_destroy(clean);
    synthetic_destroy(&s);
}
