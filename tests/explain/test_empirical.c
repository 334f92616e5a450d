/* Outside the library: terms are found by kind and size in cuts that the simulator made with them, noise and one cut hold
   none; a window of one cut is found as an event and does not bend the rest. labels: unit */
#include "explain/modelled.h"

#include "base/alloc.h"
#include "explain/synthetic.h"
#include "foam/empirical.h"
#include "test.h"

static synthetic given, other;
static wcut_evidence *evidence;
static wcut_fitted about;
static wcut_outside found;

static void given_cuts(int cuts, const concealed *what) {
    given = synthetic_create(cuts, what);
    evidence = evidence_of(&given, 2);
    about = fit_of(evidence, 0, what->effect);
}

static void forget(void) {
    wcut_outside_destroy(&found);
    wcut_fitted_destroy(&about);
    wcut_evidence_destroy(evidence);
    synthetic_destroy(&given);
    synthetic_destroy(&other);
    other = (synthetic){.cuts = 0};
}

static void find(void) {
    wcut_error error = {0};
    const wcut_status status = wcut_outside_find(evidence, &about, &found, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
}

static wcut_effect term_of(wcut_term term, double c, double shape) {
    wcut_effect e = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, term);
    e.value[0] = c;
    if (shape != 0) e.value[WCUT_EMPIRICAL_FORCE_SHAPE] = shape;
    return e;
}

static const wcut_effect *first_term(void) {
    ck_assert_ptr_nonnull(found.empirical.fit.residual);
    ck_assert_int_ge(found.empirical.fit.model.effects, 1);
    return &found.empirical.fit.model.effect[0];
}

TEST(noise_is_not_modelled) {
    for (uint64_t seed = 61; seed < 64; seed++) {
        const concealed nothing = {.noise = 1, .law_a = 1.1, .seed = seed};
        given_cuts(SYNTHETIC_CUTS, &nothing);
        find();
        ck_assert_ptr_null(wcut_outside_fit(&found));
        ck_assert_int_eq(found.events.count, 0);
        forget();
    }
}

TEST(layers_along_the_feed_are_found_with_wavelength_and_size) {
    const concealed what = {.effects = 1, .effect = term_of(WCUT_TERM_WAVE_Y, 0.15, 72), .noise = 1, .seed = 62};
    given_cuts(SYNTHETIC_CUTS, &what);
    find();
    const wcut_effect *e = first_term();
    ck_assert_int_eq(e->choice, WCUT_TERM_WAVE_Y);
    ck_assert_double_eq_tol(e->value[WCUT_EMPIRICAL_FORCE_SHAPE], 72, 1.5);
    ck_assert_double_eq_tol(hypot(e->value[0], e->value[1]), 0.15, 0.015);
    ck_assert_double_gt(found.empirical.held_out, 100);
    ck_assert_double_lt(found.left.slow, 2);
    char clause[160], formula[80];
    wcut_term_clause(e, clause, sizeof clause);
    wcut_term_formula(e, formula, sizeof formula);
    ck_assert_msg(strstr(clause, "+-15 % every 72 mm along the feed"), "%s", clause);
    ck_assert_msg(strstr(formula, "sin(2 pi y / 7"), "%s", formula);
    forget();
}

TEST(a_step_at_a_heat_input_is_found_with_its_place) {
    const concealed what = {.effects = 1, .effect = term_of(WCUT_TERM_HEAT_STEP, 0.25, 4700), .noise = 1, .seed = 63};
    given_cuts(SYNTHETIC_CUTS, &what);
    find();
    const wcut_effect *e = first_term();
    ck_assert_msg(e->choice == WCUT_TERM_HEAT_STEP || e->choice == WCUT_TERM_HEAT_HINGE, "%s",
                  wcut_term_name[e->choice]);
    ck_assert_double_eq_tol(e->value[WCUT_EMPIRICAL_FORCE_SHAPE], 4700, 400);
    ck_assert_double_gt(e->value[0], 0.1);
    forget();
}

TEST(one_cut_confirms_nothing) {
    const concealed what = {.effects = 1, .effect = term_of(WCUT_TERM_CLOCK, 0.3, 0), .noise = 1, .seed = 64};
    given_cuts(1, &what);
    find();
    ck_assert_ptr_null(found.empirical.fit.residual);
    forget();
}

TEST(a_window_of_one_cut_is_an_event_and_does_not_bend_the_rest) {
    wcut_effect window = term_of(WCUT_TERM_WINDOW, 0.6, 12);
    window.value[WCUT_EMPIRICAL_FORCE_SHAPE + 1] = 17;
    const concealed plain = {.noise = 1, .law_a = 1.15, .seed = 65};
    concealed burst = plain;
    burst.effects = 1, burst.effect = window;
    given = synthetic_create(SYNTHETIC_CUTS, &plain);
    other = synthetic_create(SYNTHETIC_CUTS, &burst);
    given.cut[1] = other.cut[1];
    evidence = evidence_of(&given, 2);
    about = fit_of(evidence, 0, window);
    find();
    ck_assert_int_eq(found.events.count, 1);
    const wcut_event *e = &found.events.event[0];
    ck_assert_int_eq(e->cut, 1);
    ck_assert_double_eq_tol(e->time[0], 12, 1);
    ck_assert_double_eq_tol(e->time[1], 17, 1);
    ck_assert_double_eq_tol(e->force, 0.6, 0.2);
    ck_assert_double_lt(found.events.after, 0.6 * found.events.recalibrated);
    ck_assert_double_lt(found.left.slow, 2);
    ck_assert_double_eq_tol(found.rest.model.a / given.job[0]->force_law.a, 1.15, 0.05);

    /* its bins are out of the evidence, and can be put back */
    int missing = 0, still = 0;
    for (int i = 0; i < evidence->cut[1].bins; i++) missing += !isfinite(evidence->cut[1].measured[0][i]);
    ck_assert_int_ge(missing, 9);
    wcut_events_restore(found.kept, evidence);
    for (int i = 0; i < evidence->cut[1].bins; i++) still += !isfinite(evidence->cut[1].measured[0][i]);
    ck_assert_int_eq(still, 0);
    forget();
}

TEST(without_memory_nothing_is_written) {
    const concealed nothing = {.noise = 1, .seed = 66};
    given_cuts(2, &nothing);
    wcut_error error = {0};
    found.left.slow = 999;
    FIRST_FAILED_ALLOCATIONS(10, wcut_outside_find(evidence, &about, &found, &error), found.left.slow == 999);
    forget();
}
