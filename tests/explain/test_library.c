/* Families of effects: every form is at the same place, begins near the first, and has what is fitted in its ranges.
   labels: unit */
#include <math.h>

#include "base/numbers.h"
#include "explain/library.h"
#include "test.h"

static int forms_of(const wcut_effect *effect) {
    wcut_effect form;
    int count = 0;
    while (wcut_effect_form(effect, count, &form)) count++;
    return count;
}

static wcut_effect given(wcut_effect_kind kind, int choice, double strength, double second) {
    wcut_effect e = wcut_effect_choose(kind, choice);
    e.value[0] = strength;
    if (second > 0) e.value[1] = second;
    return e;
}

TEST(a_family_has_its_forms_at_the_same_place_and_the_effect_among_them) {
    const struct {
        wcut_effect effect;
        int forms, bases;
    } family[] = {{given(WCUT_EFFECT_WIRE_THERMAL_LAG, 0, 0.8, 0), 3, 1},
                  {given(WCUT_EFFECT_END_COOLING, 0, 0.3, 100), 2, 1},
                  {given(WCUT_EFFECT_TANGENTIAL_DRAG, 0, 0.3, 0), 2, 1},
                  {given(WCUT_EFFECT_MOUNT_COMPLIANCE, 3, 2, 0.3), 4, 1},
                  {given(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 4, 0.3, 0), 4, 3},
                  {given(WCUT_EFFECT_WIRE_FOULING, 1, 0.2, 700), 4, 2},
                  {given(WCUT_EFFECT_RATE_DEPENDENCE, 0, 0.2, 0), 0, 0},
                  {given(WCUT_EFFECT_CLOCK_OFFSET, 0, 0.2, 0), 0, 0}};
    for (size_t k = 0; k < sizeof family / sizeof *family; k++) {
        const wcut_effect *e = &family[k].effect;
        ck_assert_int_eq(forms_of(e), family[k].forms);
        bool itself = family[k].forms == 0;
        for (int nth = 0; nth < family[k].forms; nth++) {
            wcut_effect form = *e;
            ck_assert(wcut_effect_form(e, nth, &form));
            ck_assert_int_eq(form.kind, e->kind);
            ck_assert_int_eq(form.choice % family[k].bases, e->choice % family[k].bases);
            ck_assert_int_eq(wcut_effects_check(1, &form, NULL), WCUT_OK);

            // the same sign, and what is fitted of it begins inside its bounds
            ck_assert(form.value[0] * e->value[0] > 0);
            for (int c = 0; c < wcut_effect_coordinates(&form); c++) {
                const wcut_coordinate q = wcut_effect_coordinate(&form, c);
                const double x = wcut_scale_in(q.scale, form.value[q.at]);
                ck_assert_msg(x > q.low && x < q.high, "kind %d, choice %d, %d: %g", form.kind, form.choice, c, x);
            }
            itself = itself || (form.choice == e->choice && form.value[1] == e->value[1]);
        }
        ck_assert(itself);
    }
}

TEST(forms_that_grow_without_end_begin_where_the_first_is_after_a_metre) {
    const wcut_effect e = given(WCUT_EFFECT_WIRE_FOULING, 0, 0.2, 700);
    wcut_effect form = e;
    for (int nth = 1; nth < 4; nth++) {
        ck_assert(wcut_effect_form(&e, nth, &form));
        ck_assert_double_eq_tol(form.value[0], 0.2 * (1 - exp(-1000.0 / 700)), 1e-15);
        ck_assert_double_eq(form.value[1], 1000);
        ck_assert_int_eq(wcut_effect_coordinates(&form), nth == 3 ? 2 : 1);
    }
}

TEST(the_screen_has_room_for_every_variant) {
    const bool without[WCUT_EFFECT_COUNT] = {false};
    wcut_variant *variant = malloc((WCUT_VARIANTS + 1) * sizeof *variant);
    ck_assert_int_lt(wcut_library_variants(without, true, true, variant), WCUT_VARIANTS);
    free(variant);
}
