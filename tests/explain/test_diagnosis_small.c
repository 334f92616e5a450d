/* Diagnoses of two short cuts each: an effect that is named, a true job, blocks that differ, readings that come late. What
   the default run has of the main verb; the larger cases are in test_diagnosis and test_concealment.
   labels: unit */
#include "explain/machine.h"
#include "test.h"

static wcut_diagnosis *diagnose(const machine_secret *secret) {
    machine_case m = machine_create(2, secret);
    wcut_diagnosis *d = machine_diagnose(&m, NULL);
    machine_destroy(&m);
    return d;
}

static const wcut_rig_row *row_of(const wcut_diagnosis *d, const char *name) {
    for (int k = 0; k < d->rig_rows; k++)
        if (strcmp(d->rig[k].name, name) == 0) return &d->rig[k];
    ck_abort_msg("the table of the rig has no %s", name);
    return NULL;
}

TEST(a_lag_is_named_and_its_interval_holds_it) {
    const machine_secret secret = {
        .effects = 1, .effect = {machine_effect(WCUT_EFFECT_WIRE_THERMAL_LAG, 0, 0.8, 0)}, .seed = 5};
    wcut_diagnosis *d = diagnose(&secret);
    ck_assert_msg(machine_names(d, WCUT_EFFECT_WIRE_THERMAL_LAG, WCUT_EFFECT_WIRE_THERMAL_LAG), "%s",
                  machine_verdict(d));
    const wcut_estimate *found = &d->effect[0].parameter[0];
    ck_assert_msg(found->low < 0.8 && found->high > 0.8, "%g to %g", found->low, found->high);
    ck_assert_double_lt(found->high - found->low, 0.5);
    wcut_diagnosis_destroy(d);
}

TEST(blocks_that_differ_are_no_effect_and_the_table_says_by_how_much) {
    const machine_secret secret = {.level = {0.95, 1.05}, .seed = 3};
    wcut_diagnosis *d = diagnose(&secret);
    ck_assert_msg(d->kind == WCUT_VERDICT_NONE, "%s", machine_verdict(d));
    const wcut_rig_row *level = row_of(d, "block_level");
    ck_assert_int_eq(level->cuts, 2);
    const double apart = level->of_cut[1].value - level->of_cut[0].value;
    ck_assert_msg(apart > 0.03 && apart < 0.12, "%g", apart); /* b takes a part: the two cuts have two heats */
    ck_assert_msg(level->value.low < 0.05 && level->value.high > 0.05, "%g to %g", level->value.low, level->value.high);
    wcut_diagnosis_destroy(d);
}

TEST(late_tension_readings_are_an_instrument_s_fault) {
    const machine_secret secret = {.delay = 0.2, .seed = 4};
    wcut_diagnosis *d = diagnose(&secret);
    ck_assert_msg(machine_names(d, WCUT_EFFECT_TENSION_DELAY, WCUT_EFFECT_TENSION_DELAY), "%s", machine_verdict(d));
    ck_assert_msg(fabs(d->effect[0].effect.value[0] - 0.2) < 0.05, "%s", machine_verdict(d));
    ck_assert_int_eq(d->kind, WCUT_VERDICT_INSTRUMENT);
    wcut_diagnosis_destroy(d);
}
