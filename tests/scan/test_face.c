/* Where the cut face is scanned under each effect, by its formula. labels: unit */
#include <wirecut/effects.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "test.h"

static const wcut_vec3 block = {400, 600, 300};

static wcut_effect sized(wcut_effect_kind kind, double size, int choice) {
    wcut_effect e = wcut_effect_default(kind);
    e.value[0] = size, e.choice = choice;
    return e;
}

static wcut_vec3 seen(const wcut_effect *effect, int count, wcut_vec3 point) {
    const wcut_vec3 normal = {0, 0.6, 0.8};
    const double q_eff = 3000;
    ck_assert_int_eq(wcut_face_eval(count, effect, block, 1, &normal, &q_eff, &point), WCUT_OK);
    return point;
}

static void expect(wcut_effect e, wcut_vec3 at, wcut_vec3 expected) {
    ck_assert_double_lt(vec3_distance(seen(&e, 1, at), expected), 1e-12);
}

TEST(every_effect_moves_a_point_by_its_formula) {
    const wcut_vec3 p = {300, 150, 140}; /* u = 0.5, v = -0.5 */
    expect(sized(WCUT_EFFECT_KERF_GROWTH, 2e-4, 0), p, vec3_add_scaled(p, -0.3, vec3(0, 0.6, 0.8)));
    wcut_effect e = sized(WCUT_EFFECT_KERF_GROWTH, 0, 1);
    e.value[1] = 0.5;
    expect(e, p, vec3_add_scaled(p, -0.25 * log(3), vec3(0, 0.6, 0.8)));
    const wcut_vec3 q = {400, 150, 140}; /* u = 1, v = -0.5 */
    const double height[] = {0.75, 1, 0.25, 1.25, -0.5, 1, -0.125};
    for (int shape = 0; shape < 7; shape++)
        expect(sized(WCUT_EFFECT_BLOCK_SPRINGBACK, 2, shape), q, vec3(400, 150, 140 + 2 * height[shape]));
    expect(sized(WCUT_EFFECT_SCAN_SCALE, 1.01, 0), p, vec3(301, 148.5, 139.9));
    e = sized(WCUT_EFFECT_SCAN_OFFSET, 1, 0);
    e.value[1] = -2, e.value[2] = 3;
    expect(e, p, vec3(301, 148, 143));
    expect(sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 1, 0), p, p); /* physics of the step moves no scan */
}

TEST(neutral_effects_leave_every_bit_and_several_add_up) {
    wcut_effect e[] = {wcut_effect_default(WCUT_EFFECT_KERF_GROWTH), wcut_effect_default(WCUT_EFFECT_BLOCK_SPRINGBACK),
                       wcut_effect_default(WCUT_EFFECT_SCAN_OFFSET), wcut_effect_default(WCUT_EFFECT_SCAN_SCALE)};
    const wcut_vec3 p = {1.0 / 3, 0.1, 1e-9};
    const wcut_vec3 same = seen(e, 4, p);
    ck_assert(same.x == p.x && same.y == p.y && same.z == p.z);
    e[0] = sized(WCUT_EFFECT_BLOCK_SPRINGBACK, 2, 1), e[1] = sized(WCUT_EFFECT_BLOCK_SPRINGBACK, -1, 2);
    ck_assert_double_eq_tol(seen(e, 2, vec3(0, 0, 9)).z, 10, 1e-12);
}

TEST(what_is_missing_is_refused_and_the_points_stay) {
    wcut_effect e = sized(WCUT_EFFECT_KERF_GROWTH, 1e-4, 0);
    wcut_vec3 p = {999, 999, 999};
    const double q_eff[] = {NAN}, good[] = {100};
    const wcut_vec3 normal = {0, 0, 1};
    ck_assert_int_eq(wcut_face_eval(1, &e, block, 1, NULL, good, &p), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_eval(1, &e, block, 1, &normal, NULL, &p), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_eval(1, &e, block, 1, &normal, q_eff, &p), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_eval(1, &e, vec3(0, 1, 1), 1, &normal, good, &p), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_eval(1, &e, block, -1, &normal, good, &p), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_face_eval(1, NULL, block, 1, &normal, good, &p), WCUT_BAD_ARGUMENT);
    e.value[0] = NAN;
    ck_assert_int_eq(wcut_face_eval(1, &e, block, 1, &normal, good, &p), WCUT_BAD_ARGUMENT);
    ck_assert(p.x == 999 && p.y == 999 && p.z == 999);
    ck_assert_int_eq(wcut_face_eval(0, NULL, block, 0, NULL, NULL, NULL), WCUT_OK);
}
