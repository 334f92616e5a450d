/* Dependence: a planted quantity is found by name and size, noise holds none. */
#include "explain/dependence.h"

#include "base/alloc.h"
#include "explain/features.h"
#include "explain/synthetic.h"
#include "test.h"

static synthetic given;
static wcut_evidence *evidence;
static wcut_fitted about;
static wcut_dependence found[WCUT_DEPENDENCES];
static int count;

static void given_cuts(int cuts, const concealed *what) {
    given = synthetic_create(cuts, what);
    evidence = evidence_of(&given, 2);
    about = fit_of(evidence, 0, what->effect);
}

static void forget(void) {
    wcut_fitted_destroy(&about);
    wcut_evidence_destroy(evidence);
    synthetic_destroy(&given);
}

static void find(void) {
    wcut_error error = {0};
    count = 999;
    const wcut_status status = wcut_dependence_find(evidence, &about, &count, found, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
}

TEST(noise_depends_on_nothing) {
    const concealed nothing = {.noise = 1, .seed = 51};
    given_cuts(SYNTHETIC_CUTS, &nothing);
    int cases = 0;
    for (uint64_t seed = 1; seed <= 5; seed++) {
        wcut_random random = wcut_random_seed(seed);
        white_rows(evidence, &random, about.residual);
        find();
        cases += count > 0;
    }
    ck_assert_int_eq(cases, 0);
    forget();
}

/* a relative change of the force by a quantity, as the linear model has it, in the residual */
static void plant(const wcut_feature *f, double size) {
    wcut_model model[2] = {about.model, about.model};
    const size_t rows = (size_t)evidence->rows;
    double *all = wcut_alloc(2 * rows, sizeof *all), *raw = wcut_alloc(rows, sizeof *raw);
    model[1].a *= exp(0.02);
    ck_assert_int_eq(wcut_models_rows(evidence, 2, model, all, NULL), WCUT_OK);
    for (int k = 0; k < evidence->cuts; k++) {
        const wcut_evidence_cut *c = &evidence->cut[k];
        wcut_response d = {0};
        double *value = wcut_alloc((size_t)WCUT_WEIGHTS * (size_t)c->bins, sizeof *value);
        ck_assert_int_eq(wcut_response_run(c->job, WCUT_NODES_COARSE, &c->exogenous, true, NULL, &d, NULL), WCUT_OK);
        wcut_feature_eval(c, &d, f, value);
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++) {
            const int row = c->row + i, weight = i < 2 * c->bins ? 0 : i < 4 * c->bins ? 1 : 2;
            all[row] = size * value[weight * c->bins + i % c->bins] * (all[rows + (size_t)row] - all[row]) / 0.02;
        }
        wcut_response_destroy(&d);
        wcut_free(value);
    }
    wcut_evidence_residual(evidence, raw);
    wcut_evidence_whiten(evidence, raw, all, all);
    for (size_t i = 0; i < rows; i++) about.residual[i] += all[i];
    wcut_free(all);
    wcut_free(raw);
}

TEST(a_grating_along_the_block_is_found_with_its_wavelength_and_size) {
    const concealed nothing = {.noise = 1, .seed = 52};
    given_cuts(SYNTHETIC_CUTS, &nothing);
    wcut_random random = wcut_random_seed(7);
    white_rows(evidence, &random, about.residual);
    wcut_feature list[WCUT_FEATURES_MOST];
    const int features = wcut_features_list(true, list);
    int sine = 0;
    while (sine < features && !(list[sine].wave && fabs(list[sine].constant - 90) < 1)) sine++;
    ck_assert_int_lt(sine, features);
    plant(&list[sine], 0.1);
    find();
    ck_assert_int_eq(count, 1);
    double wave = 0;
    ck_assert_msg(sscanf(found[0].quantity, "sin(2 pi y / %lf mm", &wave) == 1, "%s", found[0].quantity);
    ck_assert_double_eq_tol(wave, list[sine].constant, 12); /* 400 mm of block tell a wavelength to a tenth */
    ck_assert_double_eq_tol(found[0].coefficient.value, 0.1, 0.04);
    ck_assert(found[0].coefficient.low < found[0].coefficient.value &&
              found[0].coefficient.value < found[0].coefficient.high);
    ck_assert_double_gt(found[0].gain, 6);
    forget();
}

TEST(a_quantity_of_time_is_found_by_name) {
    const concealed nothing = {.noise = 1, .seed = 53};
    given_cuts(SYNTHETIC_CUTS, &nothing);
    wcut_random random = wcut_random_seed(8);
    white_rows(evidence, &random, about.residual);
    wcut_feature list[WCUT_FEATURES_MOST];
    const int features = wcut_features_list(true, list);
    int memory = 0;
    while (memory < features && strcmp(list[memory].name, "memory of 3.2 s of ln heat") != 0) memory++;
    ck_assert_int_lt(memory, features);
    plant(&list[memory], 0.8);
    find();
    ck_assert_int_ge(count, 1);
    ck_assert_str_eq(found[0].quantity, list[memory].name);
    const wcut_estimate c = found[0].coefficient;
    ck_assert_msg(c.low < 0.8 && 0.8 < c.high && c.high - c.low < 0.16, "%g in %g .. %g", c.value, c.low, c.high);
    ck_assert_double_eq_tol(c.value, 0.8, 0.04);
    forget();
}

TEST(a_denser_end_of_the_block_that_the_wire_was_driven_through_is_a_dependence_on_y) {
    wcut_effect denser = effect_of(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.5);
    denser.choice = 1; /* y */
    const concealed what = {.effects = 1, .effect = denser, .noise = 0.5, .seed = 54};
    given_cuts(SYNTHETIC_CUTS, &what);
    find();
    ck_assert_int_ge(count, 1);
    bool along = false; /* y, or what goes with it: the time in an evenly paced cut */
    for (int k = 0; k < count; k++)
        along = along || strstr(found[k].quantity, "y / L") || !strcmp(found[k].quantity, "time");
    ck_assert_msg(along, "%s", found[0].quantity);
    forget();
}

TEST(one_cut_confirms_nothing) {
    const concealed what = {.effects = 1, .effect = effect_of(WCUT_EFFECT_WIRE_THERMAL_LAG, 2), .noise = 1, .seed = 55};
    given_cuts(1, &what);
    find();
    ck_assert_int_eq(count, 0);
    forget();
}

TEST(without_memory_nothing_is_written) {
    const concealed nothing = {.noise = 1, .seed = 56};
    given_cuts(2, &nothing);
    wcut_error error = {0};
    count = 999;
    FIRST_FAILED_ALLOCATIONS(10, wcut_dependence_find(evidence, &about, &count, found, &error), count == 999);
    forget();
}
