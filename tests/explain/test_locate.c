/* Locating: nothing in noise, nothing in values without order, a planted bump where it was planted. */
#include "explain/locate.h"

#include "base/alloc.h"
#include "explain/synthetic.h"
#include "test.h"

static synthetic given;
static wcut_evidence *evidence;
static double *residual, *raw;
static wcut_mismatch found[WCUT_MISMATCHES];
static int count;

static void given_a_quiet_case(void) {
    const concealed nothing = {.noise = 1, .seed = 5};
    given = synthetic_create(SYNTHETIC_CUTS, &nothing);
    evidence = evidence_of(&given, 1);
    residual = wcut_alloc((size_t)evidence->rows + 1000, sizeof *residual);
    raw = wcut_alloc((size_t)evidence->rows + 1000, sizeof *raw);
}

static void forget(void) {
    wcut_free(raw);
    wcut_free(residual);
    wcut_evidence_destroy(evidence);
    synthetic_destroy(&given);
}

static void locate(void) {
    wcut_error error = {0};
    count = 999;
    const wcut_status status = wcut_mismatch_locate(evidence, residual, &count, found, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
}

/* a face of 10 x 8 patches behind the rows of the first cut: stripes along y, lanes along x */
static void give_patches(void) {
    enum { ROWS = 20, LANES = 8, N = ROWS * LANES };
    wcut_evidence_cut *c = &evidence->cut[0];
    wcut_patches p = {.count = N,
                      .station = wcut_alloc(N, sizeof(double)),
                      .across = wcut_alloc(N, sizeof(double)),
                      .point = wcut_alloc(N, sizeof(wcut_vec3)),
                      .normal = wcut_alloc(N, sizeof(wcut_vec3)),
                      .distance = wcut_alloc(N, sizeof(double)),
                      .sigma = wcut_alloc(N, sizeof(double)),
                      .q_eff = wcut_alloc(N, sizeof(double))};
    for (int i = 0; i < N; i++) {
        const double row = i / LANES + 0.5, lane = i % LANES + 0.5;
        p.station[i] = 10 + 4 * row, p.across[i] = (60 + 30 * lane) / 360;
        p.point[i] = vec3(30 * lane, 20 * row, 150), p.normal[i] = vec3(0, 0, 1);
        p.sigma[i] = 0.05, p.q_eff[i] = 3000;
    }
    c->patch = p;
    evidence->rows = 0;
    for (int k = 0; k < evidence->cuts; k++) {
        evidence->cut[k].row = evidence->rows;
        evidence->rows += WCUT_SIGNALS * evidence->cut[k].bins + evidence->cut[k].patch.count;
    }
}

TEST(noise_holds_no_mismatch_but_one_case_in_a_hundred) {
    give_patches();
    int cases = 0;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        wcut_random random = wcut_random_seed(seed);
        white_rows(evidence, &random, residual);
        locate();
        cases += count > 0;
    }
    /* 0.6 are expected, if the correction is exact; 4 or more have a probability of 0.003 */
    ck_assert_int_le(cases, 3);
}

/* noise and a bump in alpha_b of the second cut, from bin 10 on */
static void plant(int length, double size, uint64_t seed) {
    const wcut_evidence_cut *c = &evidence->cut[1];
    wcut_random random = wcut_random_seed(seed);
    wcut_evidence_residual(evidence, raw);
    noise_rows(evidence, &random, residual);
    for (int i = 10; i < 10 + length; i++) residual[c->row + 4 * c->bins + i] += size * evidence->sigma[4];
    wcut_evidence_whiten(evidence, raw, residual, residual);
}

TEST(a_planted_bump_is_found_where_and_as_large_as_it_is) {
    const wcut_evidence_cut *c = &evidence->cut[1];
    plant(12, 4, 3);
    locate();
    ck_assert_int_ge(count, 1);
    const wcut_mismatch *m = &found[0];
    ck_assert_int_eq(m->cut, 1);
    ck_assert_int_eq(m->channel, WCUT_EVIDENCE_CHANNEL_ALPHA);
    ck_assert_str_eq(m->column, "alpha_b_deg");
    const double from = c->from + 10 * WCUT_BIN_WIDTH, to = from + 12 * WCUT_BIN_WIDTH;
    ck_assert_double_eq_tol(m->time[0], from, 1.01);
    ck_assert_double_eq_tol(m->time[1], to, 1.01);
    const double size = 4 * evidence->sigma[4] * 180 / WCUT_PI;
    ck_assert_double_eq_tol(m->mean, size, size / 2);
    ck_assert(m->p_value >= 0 && m->p_value <= WCUT_LOCATE_LEVEL);
    ck_assert(m->share > 0.2 && m->share <= 1);
    ck_assert(isnan(m->wire[0]) && isnan(m->wire[1]));
    ck_assert_double_lt(m->station[0], m->station[1]);
    /* the box is where the wire was: across the whole block, and some way along it */
    ck_assert(m->block[0].x >= 0 && m->block[0].x < 30 && m->block[1].x <= 240 && m->block[1].x > 210);
    ck_assert(m->block[0].y >= 0 && m->block[1].y <= 400 && m->block[0].y < m->block[1].y);
    for (int k = 1; k < count; k++) { /* what else there is lies beside it, and is less */
        ck_assert_double_le(found[k].share, m->share);
        if (found[k].cut == 1 && found[k].channel == WCUT_EVIDENCE_CHANNEL_ALPHA && !strcmp(found[k].column, m->column))
            ck_assert(found[k].time[1] <= m->time[0] + 1e-9 || found[k].time[0] >= m->time[1] - 1e-9);
    }
}

TEST(a_shift_of_a_whole_channel_is_one_mismatch) {
    wcut_random random = wcut_random_seed(8);
    const wcut_evidence_cut *c = &evidence->cut[2];
    wcut_evidence_residual(evidence, raw);
    noise_rows(evidence, &random, residual);
    for (int i = 0; i < c->bins; i++) residual[c->row + i] -= 4 * evidence->sigma[0];
    wcut_evidence_whiten(evidence, raw, residual, residual);
    locate();
    ck_assert_int_eq(count, 1);
    ck_assert_str_eq(found[0].column, "tension_a_N");
    ck_assert_double_eq_tol(found[0].mean, -4 * evidence->sigma[0], evidence->sigma[0]);
    ck_assert_double_gt(found[0].time[1] - found[0].time[0], 0.6 * c->bins * WCUT_BIN_WIDTH);
}

TEST(the_same_values_in_another_order_are_nothing) {
    int cases = 0;
    for (uint64_t seed = 1; seed <= 20; seed++) {
        plant(16, 4, seed);
        wcut_random random = wcut_random_seed(seed + 100);
        for (int k = 0; k < evidence->cuts; k++) {
            const wcut_evidence_cut *c = &evidence->cut[k];
            for (int s = 0; s < WCUT_SIGNALS; s++) {
                double *z = residual + c->row + s * c->bins, mean = 0;
                for (int i = 0; i < c->bins; i++) mean += z[i] / c->bins;
                for (int i = 0; i < c->bins; i++) {
                    const int j = i + wcut_random_below(&random, c->bins - i);
                    const double swap = z[j] - mean;
                    z[j] = z[i], z[i] = swap;
                }
            }
        }
        locate();
        cases += count > 0;
    }
    ck_assert_int_le(cases, 1);
}

TEST(patches_of_a_face_that_are_off_are_found_along_the_wire) {
    give_patches();
    wcut_random random = wcut_random_seed(4);
    white_rows(evidence, &random, residual);
    const wcut_evidence_cut *c = &evidence->cut[0];
    double *z = residual + c->row + WCUT_SIGNALS * c->bins;
    for (int i = 0; i < c->patch.count; i++)
        if (c->patch.point[i].x > 170 && c->patch.point[i].y < 200) z[i] += 3;
    locate();
    ck_assert_int_ge(count, 1);
    const wcut_mismatch *m = &found[0];
    ck_assert_str_eq(m->column, "scan");
    ck_assert_int_eq(m->channel, WCUT_EVIDENCE_CHANNEL_SCAN);
    ck_assert_double_eq_tol(m->mean, 0.15, 0.05);
    ck_assert(m->block[0].x > 110 && m->block[1].y < 260);
    /* the wire's own millimetres from where it enters the block: here x, for it is straight */
    ck_assert_double_eq_tol(m->wire[0], m->block[0].x * 380 / 360, 2);
    ck_assert_double_eq_tol(m->wire[1], m->block[1].x * 380 / 360, 2);
    ck_assert_double_lt(m->time[0], m->time[1]);
}

TEST(rows_that_are_missing_do_not_matter) {
    wcut_evidence_cut *c = &evidence->cut[1];
    for (int i = 12; i < 15; i++) c->measured[4][i] = (double)NAN;
    plant(12, 5, 3);
    locate();
    ck_assert_int_ge(count, 1);
    ck_assert_str_eq(found[0].column, "alpha_b_deg");
    ck_assert(isfinite(found[0].mean));
}

TEST(without_memory_nothing_is_written) {
    plant(12, 5, 3);
    wcut_error error = {0};
    count = 999;
    FIRST_FAILED_ALLOCATIONS(6, wcut_mismatch_locate(evidence, residual, &count, found, &error), count == 999);
}

FIXTURE(given_a_quiet_case, forget);
