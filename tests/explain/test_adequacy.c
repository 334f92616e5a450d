/* Adequacy against a simulated null: what noise leaves is likely, a misfit is not, and slow sensors are no physics. */
#include "explain/adequacy.h"

#include "base/alloc.h"
#include "explain/search.h"
#include "explain/synthetic.h"
#include "test.h"

enum { DRAWS = 200 };

static synthetic given;
static wcut_evidence *evidence;

static void given_a_case(void) {
    const concealed nothing = {.noise = 1, .seed = 5};
    given = synthetic_create(SYNTHETIC_CUTS, &nothing);
    evidence = evidence_of(&given, 1);
}

static void forget(void) {
    wcut_evidence_destroy(evidence);
    synthetic_destroy(&given);
}

static double p_of(double slow, unsigned long long seed) {
    double p = 999;
    ck_assert_int_eq(wcut_adequacy_p_value(evidence, slow, DRAWS, seed, &p), WCUT_OK);
    return p;
}

/* slow misfit of a recording of noise with a given share of slow noise, whitened as evidence is */
static double slow_of_noise(double share, wcut_random *random) {
    double *row = wcut_alloc((size_t)evidence->rows, sizeof *row);
    const wcut_variances assumed = evidence->noise;
    for (int g = 0; g < WCUT_NOISE_GROUPS; g++) evidence->noise.slow[g] = share;
    noise_rows(evidence, random, row);
    evidence->noise = assumed;
    wcut_evidence_whiten(evidence, row, row, row);
    const double left = wcut_residual_stats_eval(evidence, row).slow;
    wcut_free(row);
    return left;
}

TEST(what_the_true_model_leaves_is_no_surprise) {
    double *z = wcut_alloc((size_t)evidence->rows, sizeof *z);
    wcut_evidence_residual(evidence, z);
    wcut_evidence_whiten(evidence, z, z, z);
    const double left = wcut_residual_stats_eval(evidence, z).slow;
    ck_assert_double_gt(p_of(left, 1), 0.05);
    wcut_free(z);
}

TEST(the_least_p_is_one_over_all_and_the_largest_is_one) {
    ck_assert_double_eq(p_of(50, 1), 1.0 / (DRAWS + 1));
    ck_assert_double_eq(p_of(0, 1), 1);
}

TEST(more_left_is_less_likely) {
    double last = 1;
    for (double slow = 0.8; slow < 3.2; slow += 0.4) {
        const double p = p_of(slow, 3);
        ck_assert_double_le(p, last);
        last = p;
    }
    ck_assert_double_lt(last, 0.05);
}

TEST(p_is_even_where_the_share_of_slow_noise_is_drawn_as_the_null_has_it) {
    enum { TIMES = 60 };
    wcut_random random = wcut_random_seed(17);
    int below_half = 0, below_tenth = 0;
    for (int i = 0; i < TIMES; i++) {
        const double share = WCUT_SLOWEST_NOISE * wcut_random_uniform(&random);
        const double p = p_of(slow_of_noise(share, &random), 100 + (unsigned long long)i);
        below_half += p < 0.5, below_tenth += p < 0.1;
    }
    /* binomial, four standard deviations and more */
    ck_assert_int_ge(below_half, 14);
    ck_assert_int_le(below_half, 46);
    ck_assert_int_le(below_tenth, 16);
}

TEST(the_same_seed_gives_the_same_p_another_one_nearly) {
    ck_assert_double_eq(p_of(1.2, 7), p_of(1.2, 7));
    ck_assert_double_eq_tol(p_of(1.2, 7), p_of(1.2, 8), 0.2);
}

TEST(without_memory_nothing_is_written) {
    double p = 999;
    FIRST_FAILED_ALLOCATIONS(2, wcut_adequacy_p_value(evidence, 1, DRAWS, 1, &p), p == 999);
}

FIXTURE(given_a_case, forget);
