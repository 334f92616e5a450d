/* Wires of single cuts in the verdict: named beyond what wires are cut to by hand, from a table of the rig made here.
   labels: unit */
#include "explain/cut_length.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "test.h"

static wcut_diagnosis *given(wcut_verdict_kind kind, const char *sentence, int cuts, const double *length) {
    wcut_diagnosis *d = calloc(1, sizeof *d);
    d->kind = kind, d->confidence = 0.9;
    snprintf(d->sentence, sizeof d->sentence, "%s", sentence);
    d->rig = calloc(2, sizeof *d->rig);
    d->rig_rows = 2;
    snprintf(d->rig[0].name, sizeof d->rig[0].name, "block_level");
    snprintf(d->rig[1].name, sizeof d->rig[1].name, "wire_length_mm");
    d->rig[1].cuts = cuts;
    for (int k = 0; k < cuts; k++) {
        d->rig[1].cut[k] = k;
        d->rig[1].of_cut[k] = (wcut_estimate){length[k], length[k] - 0.4, length[k] + 0.4};
    }
    return d;
}

static void forget(wcut_diagnosis *d) {
    free(d->rig);
    free(d);
}

TEST(a_wrong_wire_is_named_with_its_cut_and_the_rest_of_the_sentence_stays) {
    const double length[] = {0.2, -1.9, 4.2, -3.6};
    wcut_diagnosis *d = given(WCUT_VERDICT_NONE, "No difference beyond noise.", 4, length);
    wcut_cut_length_report(d);
    ck_assert_int_eq(d->kind, WCUT_VERDICT_INSTRUMENT);
    ck_assert_int_eq(d->effects, 2);
    for (int e = 0; e < 2; e++) {
        ck_assert_int_eq(d->effect[e].effect.kind, WCUT_EFFECT_WIRE_LENGTH);
        ck_assert_int_eq(d->effect[e].cut, 3 + e);
        ck_assert_double_eq(d->effect[e].effect.value[0], length[2 + e]);
        ck_assert(d->effect[e].present && d->effect[e].estimated[0]);
        ck_assert_double_eq(d->effect[e].parameter[0].low, length[2 + e] - 0.4);
    }
    ck_assert_str_eq(
        d->sentence,
        "The wire of cut 3 is 4.2 mm longer than its job states. The wire of cut 4 is 3.6 mm shorter than its "
        "job states. Otherwise no difference beyond noise.");
    forget(d);
}

TEST(wires_cut_by_hand_and_verdicts_that_are_open_stay_as_they_are) {
    const double by_hand[] = {2.1, -2.9, 0}, wrong[] = {0, 5};
    wcut_diagnosis *d = given(WCUT_VERDICT_NONE, "No difference beyond noise.", 3, by_hand);
    wcut_cut_length_report(d);
    ck_assert_int_eq(d->kind, WCUT_VERDICT_NONE);
    ck_assert_int_eq(d->effects, 0);
    ck_assert_str_eq(d->sentence, "No difference beyond noise.");
    forget(d);

    // what is not understood, and a length that is hardly known
    d = given(WCUT_VERDICT_UNKNOWN, "An unknown effect.", 2, wrong);
    wcut_cut_length_report(d);
    ck_assert_int_eq(d->effects, 0);
    d->kind = WCUT_VERDICT_NONE;
    d->rig[1].of_cut[1].low = 1, d->rig[1].of_cut[1].high = 9;
    wcut_cut_length_report(d);
    ck_assert_int_eq(d->effects, 0);
    forget(d);
}

TEST(beside_physics_the_verdict_is_of_both) {
    const double wrong[] = {0, 5};
    wcut_diagnosis *d = given(WCUT_VERDICT_PHYSICS, "The wire drags.", 2, wrong);
    d->effects = 1;
    wcut_cut_length_report(d);
    ck_assert_int_eq(d->kind, WCUT_VERDICT_BOTH);
    ck_assert_int_eq(d->effects, 2);
    ck_assert_str_eq(d->sentence, "The wire of cut 2 is 5.0 mm longer than its job states. The wire drags.");
    forget(d);
}
