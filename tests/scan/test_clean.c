/* Cleaning: what was planted is found, each with its cause, and nothing else; thinning; units. */
#include "base/alloc.h"
#include "sheets.h"
#include "test.h"

enum { ROWS = 60, COLUMNS = 50, SHEET = ROWS * COLUMNS, PLANTED = 40, MAX = SHEET + 3 * PLANTED };

static wcut_vec3 point[MAX];
static unsigned char removal[MAX];
static wcut_clean_report report;

static void outputs_as_before(void) {
    memset(removal, 99, sizeof removal);
    memset(&report, 99, sizeof report);
}

static void untouched(void) {
    for (int k = 0; k < MAX; k++) ck_assert_int_eq(removal[k], 99);
    ck_assert_int_eq(report.removed[0], 0x63636363);
}

static void cleaned(int count, const wcut_clean_options *options) {
    outputs_as_before();
    ck_assert_int_eq(wcut_cloud_clean(count, point, options, 1, removal, &report), WCUT_OK);
    int found[WCUT_REMOVAL_COUNT] = {0};
    for (int k = 0; k < count; k++) found[removal[k]]++;
    for (int c = 0; c < WCUT_REMOVAL_COUNT; c++) ck_assert_int_eq(found[c], report.removed[c]);
}

/* removal[first .. end) is all `cause` */
static void all_are(int first, int end, int cause) {
    for (int k = first; k < end; k++) ck_assert_msg(removal[k] == cause, "point %d: %d", k, removal[k]);
}

TEST(a_regular_sheet_loses_nothing_not_even_its_corners) {
    given_lattice(ROWS, COLUMNS, 2, point);
    cleaned(SHEET, NULL);
    all_are(0, SHEET, WCUT_REMOVAL_KEPT);
    ck_assert(report.limit >= 3 * report.centre && report.scale < 0.1 * report.centre);
}

TEST(a_noisy_sheet_at_random_places_loses_nothing) {
    for (uint64_t seed = 1; seed <= 5; seed++) {
        given_saddle(SHEET, 0.5, 0.05, seed, point);
        cleaned(SHEET, NULL);
        all_are(0, SHEET, WCUT_REMOVAL_KEPT);
    }
}

/* the sheet, then copies, then points off it, then far ones in clusters of five */
static void plant(void) {
    wcut_random r = wcut_random_seed(4);
    given_lattice(ROWS, COLUMNS, 2, point);
    for (int k = 0; k < PLANTED; k++) {
        point[SHEET + k] = point[17 * k];
        wcut_vec3 off = point[61 * k];
        off.z += (k % 2 ? 1 : -1) * (30 + 5.0 * k + wcut_random_uniform(&r));
        point[SHEET + PLANTED + k] = off;
        point[SHEET + 2 * PLANTED + k] = vec3(5000.0 + 1000.0 * (k / 5), 0.5 * (k % 5), 1e6);
    }
}

TEST(planted_duplicates_and_outliers_are_found_and_nothing_else) {
    plant();
    cleaned(MAX, NULL);
    all_are(0, SHEET, WCUT_REMOVAL_KEPT);
    all_are(SHEET, SHEET + PLANTED, WCUT_REMOVAL_DUPLICATE);
    all_are(SHEET + PLANTED, MAX, WCUT_REMOVAL_OUTLIER);
}

TEST(mean_and_deviation_are_blind_beside_far_outliers_median_and_mad_are_not) {
    plant();
    wcut_clean_options o = wcut_clean_options_default();
    o.robust = 0;
    o.factor_min = 0;
    cleaned(MAX, &o);
    ck_assert_int_lt(report.removed[WCUT_REMOVAL_OUTLIER], 2 * PLANTED);
    /* on the sheet alone they are the textbook's: recompute them */
    given_saddle(SHEET, 0.2, 0.05, 7, point);
    o.deviations = 2;
    cleaned(SHEET, &o);
    ck_assert_double_eq_tol(report.limit, report.centre + 2 * report.scale, 1e-12);
    ck_assert_int_gt(report.removed[WCUT_REMOVAL_OUTLIER], 0);
    ck_assert_int_lt(report.removed[WCUT_REMOVAL_OUTLIER], SHEET / 10);
}

TEST(the_mean_distance_of_a_lattice_is_its_closed_form) {
    /* 4 neighbours of a flat lattice of step 2: inside all are 2 away; median 2, MAD 0 */
    for (int k = 0; k < SHEET; k++) point[k] = vec3(2.0 * (k % COLUMNS), 2.0 * (k / COLUMNS), 0);
    wcut_clean_options o = wcut_clean_options_default();
    o.neighbours = 4;
    cleaned(SHEET, &o);
    ck_assert_double_eq_tol(report.centre, 2, 1e-14);
    ck_assert_double_eq_tol(report.scale, 0, 1e-14);
    ck_assert_double_eq_tol(report.limit, 6, 1e-13);
    /* mean over all: edges have three at 2 and one at sqrt 8 or 4, whichever is nearer; corners two at 2, sqrt 8, 4 */
    o.robust = 0;
    cleaned(SHEET, &o);
    const int corners = 4, edges = 2 * (ROWS - 2) + 2 * (COLUMNS - 2), inside = SHEET - corners - edges;
    const double edge = (6 + sqrt(8)) / 4, corner = (4 + sqrt(8) + 4) / 4;
    ck_assert_double_eq_tol(report.centre, (2.0 * inside + edge * edges + corner * corners) / SHEET, 1e-12);
}

TEST(isolated_points_have_too_few_within_the_radius) {
    plant();
    wcut_clean_options o = wcut_clean_options_default();
    o.neighbours = 0;
    o.radius = 3;
    o.radius_min = 2; /* a corner has three within 3 mm, up a slope; a cluster of five its four others */
    cleaned(MAX, &o);
    all_are(0, SHEET, WCUT_REMOVAL_KEPT);
    all_are(SHEET, SHEET + PLANTED, WCUT_REMOVAL_DUPLICATE);
    all_are(SHEET + PLANTED, SHEET + 2 * PLANTED, WCUT_REMOVAL_ISOLATED);
    all_are(SHEET + 2 * PLANTED, MAX, WCUT_REMOVAL_KEPT);
    o.radius_min = 5;
    o.radius = 4.5;
    cleaned(MAX, &o);
    all_are(0, SHEET, WCUT_REMOVAL_KEPT);
    all_are(SHEET + 2 * PLANTED, MAX, WCUT_REMOVAL_ISOLATED);
    ck_assert(report.centre == 0 && report.scale == 0 && report.limit == 0);
}

TEST(near_duplicates_are_those_within_the_tolerance_of_a_kept_point) {
    wcut_clean_options o = wcut_clean_options_default();
    o.neighbours = 0;
    /* a chain 0.6 apart: every second one is kept, for a removed point removes no other */
    for (int k = 0; k < 100; k++) point[k] = vec3(0.6 * k, -3, 1e3);
    o.duplicate = 1;
    cleaned(100, &o);
    for (int k = 0; k < 100; k++) ck_assert_int_eq(removal[k], k % 2 ? WCUT_REMOVAL_DUPLICATE : WCUT_REMOVAL_KEPT);
    o.duplicate = 0.5;
    cleaned(100, &o);
    all_are(0, 100, WCUT_REMOVAL_KEPT);
    /* across the borders of the cubes, against all pairs */
    wcut_random r = wcut_random_seed(6);
    for (int k = 0; k < 2000; k++) {
        point[k] = vec3(20 * wcut_random_uniform(&r) - 10, 20 * wcut_random_uniform(&r) - 10, wcut_random_uniform(&r));
    }
    cleaned(2000, &o);
    for (int k = 0; k < 2000; k++) {
        int near = 0;
        for (int j = 0; j < k; j++) near |= removal[j] == WCUT_REMOVAL_KEPT && vec3_distance(point[j], point[k]) <= 0.5;
        ck_assert_int_eq(removal[k] == WCUT_REMOVAL_DUPLICATE, near);
    }
    ck_assert(report.removed[WCUT_REMOVAL_DUPLICATE] > 100 && report.removed[WCUT_REMOVAL_KEPT] > 100);
    o.duplicate = -1;
    for (int k = 0; k < 10; k++) point[k] = vec3(1, 2, 3);
    cleaned(10, &o);
    all_are(0, 10, WCUT_REMOVAL_KEPT);
}

TEST(equal_points_are_equal_whatever_the_sign_of_zero_and_one_step_apart_they_are_not) {
    wcut_clean_options o = wcut_clean_options_default();
    o.neighbours = 0;
    const wcut_vec3 p[] = {{0, 1, 2}, {-0.0, 1, 2}, {0, nextafter(1, 2), 2}, {1e12, -1e12, 0}, {1e12, -1e12, 0}};
    memcpy(point, p, sizeof p);
    cleaned(5, &o);
    const int expected[] = {WCUT_REMOVAL_KEPT, WCUT_REMOVAL_DUPLICATE, WCUT_REMOVAL_KEPT, WCUT_REMOVAL_KEPT,
                            WCUT_REMOVAL_DUPLICATE};
    for (int k = 0; k < 5; k++) ck_assert_int_eq(removal[k], expected[k]);
}

TEST(thinning_keeps_the_first_point_of_every_cube) {
    wcut_clean_options o = wcut_clean_options_default();
    o.neighbours = 0;
    o.voxel = 1;
    for (int k = 0; k < 1000; k++) point[k] = vec3(0.1 * (k % 100) - 5 + 0.05, 0.25 + (k / 100) * 0.5, -0.5);
    cleaned(1000, &o);
    /* 10 x 5 cubes, each with its first point in the file's order */
    ck_assert_int_eq(report.removed[WCUT_REMOVAL_KEPT], 50);
    for (int k = 0; k < 1000; k++) ck_assert_int_eq(removal[k] == WCUT_REMOVAL_KEPT, k % 10 == 0 && k / 100 % 2 == 0);
    ck_assert_int_eq(wcut_cloud_keep(1000, removal, point), 50);
    ck_assert(point[1].x == 0.1 * 10 - 5 + 0.05 && point[10].y == 1.25);
}

TEST(thinning_in_pieces_is_thinning_at_once) {
    static unsigned char once[MAX], keep[MAX];
    wcut_thinning *thinning = NULL;
    given_saddle(MAX, 0.3, 5, 3, point);
    for (int pieces = 1; pieces <= MAX; pieces = 7 * pieces) {
        ck_assert_int_eq(wcut_thinning_create(20, &thinning), WCUT_OK);
        for (int first = 0, end; first < MAX; first = end) {
            end = first + MAX / pieces < MAX ? first + MAX / pieces : MAX;
            ck_assert_int_eq(wcut_thinning_add(thinning, end - first, point + first, keep + first), WCUT_OK);
        }
        if (pieces == 1) memcpy(once, keep, sizeof keep);
        ck_assert(memcmp(once, keep, sizeof keep) == 0);
        wcut_thinning_destroy(thinning);
    }
}

TEST(a_table_of_cubes_grows_as_it_must) {
    static unsigned char keep[40000];
    static wcut_vec3 many[40000];
    for (int k = 0; k < 40000; k++) many[k] = vec3(k % 200 - 100, k / 200 - 100, 1e12 * (k % 2));
    wcut_thinning *thinning = NULL;
    ck_assert_int_eq(wcut_thinning_create(1, &thinning), WCUT_OK);
    for (int round = 0; round < 2; round++) {
        ck_assert_int_eq(wcut_thinning_add(thinning, 40000, many, keep), WCUT_OK);
        for (int k = 0; k < 40000; k++) ck_assert_int_eq(keep[k], round == 0);
    }
    many[0].x = NAN;
    ck_assert_int_eq(wcut_thinning_add(thinning, 1, many, keep), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_thinning_add(thinning, -1, many, keep), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_thinning_add(thinning, 1, NULL, keep), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_thinning_add(NULL, 1, many, keep), WCUT_BAD_ARGUMENT);
    wcut_thinning_destroy(thinning);
    wcut_thinning_destroy(NULL);
    wcut_thinning *none = (void *)many;
    ck_assert_int_eq(wcut_thinning_create(0.0009, &none), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_thinning_create(INFINITY, &none), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_thinning_create(1, NULL), WCUT_BAD_ARGUMENT);
    FIRST_FAILED_ALLOCATIONS(2, wcut_thinning_create(1, &none), none == (void *)many);
    ck_assert_ptr_eq(none, (void *)many);
    ck_assert_int_eq(wcut_thinning_create(1, &thinning), WCUT_OK);
    many[0].x = 0;
    wcut_alloc_fail_at(1); /* the first growth */
    ck_assert_int_eq(wcut_thinning_add(thinning, 40000, many, keep), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    wcut_thinning_destroy(thinning);
}

TEST(two_threads_give_the_same_bytes) {
    static unsigned char other[MAX];
    wcut_clean_report second;
    plant();
    wcut_clean_options o = wcut_clean_options_default();
    o.radius = 4;
    o.voxel = 3;
    for (o.robust = 0; o.robust < 2; o.robust++) {
        cleaned(MAX, &o);
        ck_assert_int_eq(wcut_cloud_clean(MAX, point, &o, 2, other, &second), WCUT_OK);
        ck_assert(memcmp(other, removal, sizeof other) == 0 && memcmp(&second, &report, sizeof report) == 0);
    }
}

TEST(clouds_that_are_none_are_degenerate_and_nothing_is_written) {
    outputs_as_before();
    for (int k = 0; k < 100; k++) point[k] = vec3(1, 2, 3);
    ck_assert_int_eq(wcut_cloud_clean(100, point, NULL, 1, removal, &report), WCUT_DEGENERATE); /* one place */
    ck_assert_int_eq(wcut_cloud_clean(1, point, NULL, 1, removal, &report), WCUT_DEGENERATE);
    given_lattice(4, 4, 1, point);
    ck_assert_int_eq(wcut_cloud_clean(10, point, NULL, 1, removal, &report), WCUT_DEGENERATE); /* 9 neighbours */
    wcut_clean_options o = wcut_clean_options_default();
    o.radius = 0.1;
    o.neighbours = 0;
    ck_assert_int_eq(wcut_cloud_clean(10, point, &o, 1, removal, &report), WCUT_DEGENERATE); /* all isolated */
    untouched();
    o.radius = 0;
    ck_assert_int_eq(wcut_cloud_clean(1, point, &o, 1, removal, NULL), WCUT_OK);
    ck_assert_int_eq(removal[0], WCUT_REMOVAL_KEPT);
    ck_assert_int_eq(wcut_cloud_clean(11, point, NULL, 1, removal, NULL), WCUT_OK);
}

TEST(arguments_outside_their_range_are_refused_and_nothing_is_written) {
    given_lattice(10, 10, 1, point);
    outputs_as_before();
    const wcut_clean_options good = wcut_clean_options_default();
    wcut_clean_options bad[14];
    for (int k = 0; k < 14; k++) bad[k] = good;
    bad[0].duplicate = NAN, bad[1].radius = -1, bad[2].radius = INFINITY, bad[3].radius_min = 0;
    bad[4].neighbours = -1, bad[5].neighbours = 129, bad[6].deviations = -1, bad[7].deviations = NAN;
    bad[8].factor_min = -1, bad[9].factor_min = INFINITY, bad[10].voxel = -1, bad[11].voxel = 1e-4, bad[12].voxel = NAN;
    bad[13].duplicate = INFINITY;
    for (int k = 0; k < 14; k++)
        ck_assert_int_eq(wcut_cloud_clean(100, point, &bad[k], 1, removal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_clean(0, point, NULL, 1, removal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_clean(100, NULL, NULL, 1, removal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_clean(100, point, NULL, 0, removal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_clean(100, point, NULL, 1, NULL, &report), WCUT_BAD_ARGUMENT);
    const double odd[] = {NAN, INFINITY, -INFINITY, 1.1e12};
    for (int k = 0; k < 12; k++) {
        const wcut_vec3 keep = point[99];
        (&point[99].x)[k % 3] = odd[k / 3];
        ck_assert_int_eq(wcut_cloud_clean(100, point, NULL, 1, removal, &report), WCUT_BAD_ARGUMENT);
        point[99] = keep;
    }
    untouched();
    ck_assert_int_eq(wcut_cloud_keep(5, NULL, point), 0);
    ck_assert_int_eq(wcut_cloud_keep(5, removal, NULL), 0);
    ck_assert_int_eq(wcut_cloud_keep(-1, removal, point), 0);
}

TEST(without_memory_nothing_is_written) {
    plant();
    wcut_clean_options o = wcut_clean_options_default();
    o.radius = 3;
    o.voxel = 3;
    outputs_as_before();
    EACH_FAILED_ALLOCATION(wcut_cloud_clean(MAX, point, &o, 1, removal, &report), (untouched(), true));
}

/* ---- units ---- */

static double factor_of(double scale, double share) {
    wcut_cloud_unit fit = {999, 999};
    const wcut_vec3 low = {10, -20, 130}, size = {400 * scale * share, 1200 * scale * share, 60 * scale};
    ck_assert_int_eq(wcut_cloud_unit_eval(low, vec3_add(low, size), vec3(400, 1200, 300), &fit), WCUT_OK);
    ck_assert_double_eq_tol(fit.ratio, vec3_length(size) / hypot(400, 1200), 1e-12 * fit.ratio);
    return fit.factor;
}

TEST(a_wrong_unit_is_noticed_and_named_by_its_factor) {
    ck_assert(factor_of(1, 1) == 1 && factor_of(1, 0.25) == 1 && factor_of(1, 1.4) == 1);
    ck_assert(factor_of(0.1, 1) == 10 && factor_of(10, 1) == 0.1);
    ck_assert(factor_of(1 / 25.4, 1) == 25.4 && factor_of(25.4, 1) == 1 / 25.4);
    ck_assert(factor_of(1e-3, 1) == 1000 && factor_of(1e3, 1) == 1 / 1000.0);
    ck_assert(factor_of(0.1, 0.7) == 10 && factor_of(1 / 25.4, 0.7) == 25.4);
    ck_assert(factor_of(3, 1) == 0 && factor_of(1e-6, 1) == 0 && factor_of(150, 1) == 0);
}

TEST(a_box_that_is_none_fits_nothing) {
    wcut_cloud_unit fit = {999, 999};
    const wcut_vec3 o = {0, 0, 0}, one = {1, 1, 1}, nan = {0, NAN, 0};
    ck_assert_int_eq(wcut_cloud_unit_eval(one, o, one, &fit), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_unit_eval(o, nan, one, &fit), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_unit_eval(o, one, o, &fit), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_unit_eval(o, one, nan, &fit), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_unit_eval(o, one, one, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_unit_eval(vec3(-1e308, -1e308, 0), vec3(1e308, 1e308, 0), one, &fit),
                     WCUT_BAD_ARGUMENT);
    ck_assert(fit.ratio == 999 && fit.factor == 999);
    ck_assert_int_eq(wcut_cloud_unit_eval(one, one, one, &fit), WCUT_OK); /* a cloud of one point */
    ck_assert(fit.ratio == 0 && fit.factor == 0);
}

TEST(one_place_and_one_line_are_no_scan) {
    wcut_vec3 p[50];
    int span = 999;
    for (int shift = 0; shift < 2; shift++) {
        const double far = shift ? 5e5 : 0;
        for (int k = 0; k < 50; k++) p[k] = (wcut_vec3){far + 1, 2, 3};
        ck_assert_int_eq(wcut_cloud_span(50, p, &span), WCUT_OK);
        ck_assert_int_eq(span, 0);
        for (int k = 0; k < 50; k++) p[k] = (wcut_vec3){far + (float)(0.3 * k), (float)(2.1 * k), (float)(-0.7 * k)};
        ck_assert_int_eq(wcut_cloud_span(50, p, &span), WCUT_OK);
        ck_assert_int_eq(span, 1);
        p[20].z += 0.01;
        ck_assert_int_eq(wcut_cloud_span(50, p, &span), WCUT_OK);
        ck_assert_int_eq(span, 2);
    }
    ck_assert_int_eq(wcut_cloud_span(1, p, &span), WCUT_OK);
    ck_assert_int_eq(span, 0);
    span = 999;
    ck_assert_int_eq(wcut_cloud_span(0, p, &span), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_span(50, NULL, &span), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_span(50, p, NULL), WCUT_BAD_ARGUMENT);
    p[3].y = NAN;
    ck_assert_int_eq(wcut_cloud_span(50, p, &span), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(span, 999);
}
