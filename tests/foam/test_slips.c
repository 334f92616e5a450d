/* Slipped decimal points in a table of test cuts: each column is found, a good table has none. */
#include <math.h>
#include <wirecut/calibration.h>

#include "test.h"

enum { CUTS = 16, LINE = 5 };

/* cuts on a law, a per cent about it */
static void give(wcut_test_cut *cut) {
    for (int i = 0; i < CUTS; i++) {
        const double heat = 50 + 10 * (i % 4), speed = 9.5 + 0.9 * i, q = 1000 * heat / speed;
        const double force = 0.1 * exp(-8.6e-4 * q) * (1 + 0.01 * sin(5.0 * i));
        const double engaged = 300 + 100 * (i % 3),
                     tension = engaged * (0.3 * exp(-8e-4 * q) + 0.002) * (1 + 0.01 * cos(3.0 * i));
        const double alpha = asin(force * engaged / (2 * tension));
        cut[i] = (wcut_test_cut){heat, speed, engaged, tension, tension, alpha, alpha, 1, i + 2};
    }
}

static wcut_slip find(const wcut_test_cut *cut, int expected) {
    wcut_slip slip[CUTS] = {{.cut = -1}};
    int count = 999;
    ck_assert_int_eq(wcut_calibration_slips(CUTS, cut, NULL, &count, slip, NULL), WCUT_OK);
    ck_assert_int_eq(count, expected);
    return slip[0];
}

TEST(a_table_without_slips_has_none) {
    wcut_test_cut cut[CUTS];
    give(cut);
    find(cut, 0);
}

TEST(the_slip_of_each_column_is_found_with_its_factor) {
    wcut_test_cut cut[CUTS];
    give(cut);
    cut[LINE].alpha_a *= 0.1, cut[LINE].alpha_b *= 0.1;
    wcut_slip slip = find(cut, 1);
    ck_assert(slip.cut == LINE && slip.column == WCUT_SLIP_COLUMN_ALPHA && slip.factor == 10);
    ck_assert_double_eq_tol(slip.ratio, 0.1, 0.02);
    give(cut);
    cut[LINE].tension_a *= 10, cut[LINE].tension_b *= 10;
    slip = find(cut, 1);
    ck_assert(slip.cut == LINE && slip.column == WCUT_SLIP_COLUMN_TENSION && slip.factor == 0.1);
    give(cut);
    cut[LINE].engaged *= 0.1;
    slip = find(cut, 1);
    ck_assert(slip.cut == LINE && slip.column == WCUT_SLIP_COLUMN_ENGAGED && slip.factor == 10);
}

TEST(an_outlier_that_no_slip_explains_is_named_without_a_column) {
    wcut_test_cut cut[CUTS];
    give(cut);
    cut[LINE].alpha_a *= 2.5, cut[LINE].alpha_b *= 2.5;
    const wcut_slip slip = find(cut, 1);
    ck_assert(slip.cut == LINE && slip.column == WCUT_SLIP_COLUMN_NONE && slip.factor == 1 && slip.ratio > 2);
}

TEST(what_is_no_table_is_refused_and_nothing_is_written) {
    wcut_test_cut cut[CUTS];
    wcut_slip slip[CUTS];
    int count = 999;
    give(cut);
    ck_assert_int_eq(wcut_calibration_slips(0, cut, NULL, &count, slip, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_calibration_slips(CUTS, NULL, NULL, &count, slip, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_calibration_slips(2, cut, NULL, &count, slip, NULL), WCUT_BAD_ARGUMENT);
    cut[3].heat = NAN;
    ck_assert_int_eq(wcut_calibration_slips(CUTS, cut, NULL, &count, slip, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(count, 999);
}
