/* Figures of deviations against sorting them; offset, form and noise, worst areas and zones against what was made. */
#include <wirecut/deviation_summary.h>

#include "base/alloc.h"
#include "scan/sheets.h"
#include "test.h"

enum { MAX = 200000 };

static double value[MAX], sorted[MAX];
static wcut_deviation deviation[MAX];

static int compare(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* numpy's default quantile */
static double quantile_of(int count, double p) {
    const double at = p * (count - 1);
    const int k = (int)at, next = k + 1 < count ? k + 1 : k;
    return sorted[k] + (at - k) * (sorted[next] - sorted[k]);
}

static wcut_statistics figures_of(int count, int piece) {
    const double band[] = {0.25, 1};
    wcut_histogram *histogram = NULL;
    wcut_statistics s;
    memset(&s, 0x99, sizeof s);
    ck_assert_int_eq(wcut_histogram_create(2, band, &histogram), WCUT_OK);
    for (int k = 0; k < count; k += piece)
        ck_assert_int_eq(wcut_histogram_add(histogram, count - k < piece ? count - k : piece, value + k), WCUT_OK);
    ck_assert_int_eq(wcut_histogram_eval(histogram, &s), WCUT_OK);
    wcut_histogram_destroy(histogram);
    return s;
}

/* 0 normal about 0.3, 1 far offset and small spread, 2 very small, 3 a few values only, 4 of all sizes and both signs */
static void given_values(int shape, int count) {
    wcut_random r = wcut_random_seed((uint64_t)shape + 1);
    for (int k = 0; k < count; k++) {
        const double n = wcut_random_normal(&r);
        value[k] = shape == 0   ? 0.3 + 0.5 * n
                   : shape == 1 ? 1e4 + 1e-3 * n
                   : shape == 2 ? 1e-6 * n
                   : shape == 3 ? floor(3 * wcut_random_uniform(&r)) - 1
                                : n * pow(10, 6 * wcut_random_uniform(&r) - 3);
    }
}

TEST(figures_are_those_of_all_values_in_order) {
    const int counts[] = {1, 2, 3, 10, 1001, MAX};
    for (int t = 0; t < 5 * 6; t++) {
        const int count = counts[t % 6];
        given_values(t / 6, count);
        memcpy(sorted, value, (size_t)count * sizeof *sorted);
        qsort(sorted, (size_t)count, sizeof *sorted, compare);
        const wcut_statistics s = figures_of(count, 997);
        long double sum = 0, squares = 0, sizes = 0, about = 0;
        int within = 0, over = 0, under = 0, positive = 0;
        for (int k = 0; k < count; k++) {
            sum += value[k], squares += (long double)value[k] * value[k], sizes += fabs(value[k]);
            within += fabs(value[k]) <= 0.25, over += value[k] > 0.25, under += value[k] < -0.25;
            positive += value[k] > 0;
        }
        for (int k = 0; k < count; k++) about += (value[k] - sum / count) * (value[k] - sum / count);
        const double largest = fmax(fabs(sorted[0]), fabs(sorted[count - 1])), size = fmax(largest, 1e-9);
        ck_assert_int_eq(s.count, count);
        ck_assert_double_eq_tol(s.mean, (double)(sum / count), 1e-13 * size);
        ck_assert_double_eq_tol(s.rms, (double)sqrtl(squares / count), 1e-12 * size);
        ck_assert_double_eq_tol(s.mae, (double)(sizes / count), 1e-12 * size);
        if (count > 1) ck_assert_double_eq_tol(s.std, (double)sqrtl(about / (count - 1)), 1e-11 * size);
        ck_assert(s.min == sorted[0] && s.max == sorted[count - 1] && s.hausdorff == largest &&
                  s.profile == 2 * largest);
        const double found[] = {s.p01, s.p05, s.median, s.p95, s.p99}, p[] = {0.01, 0.05, 0.5, 0.95, 0.99};
        for (int k = 0; k < 5; k++) {
            const double expected = quantile_of(count, p[k]);
            /* both neighbours of a rank are known to a bin's width */
            const int rank = (int)(p[k] * (count - 1)), next = rank + 1 < count ? rank + 1 : rank;
            const double scale = fmax(fabs(sorted[rank]), fabs(sorted[next]));
            ck_assert_msg(fabs(found[k] - expected) <= 6.2e-5 * scale + 1e-9,
                          "quantile %g of %d values, shape %d: %g, %g", p[k], count, t / 6, found[k], expected);
        }
        ck_assert_double_eq_tol(s.within[0], (double)within / count, 1e-15);
        ck_assert_double_eq_tol(s.over[0], (double)over / count, 1e-15);
        ck_assert_double_eq_tol(s.under[0], (double)under / count, 1e-15);
        ck_assert_int_eq(s.positive, positive);
    }
}

TEST(pieces_and_parts_add_up) {
    given_values(0, 5000);
    const wcut_statistics a = figures_of(5000, 5000), b = figures_of(5000, 7);
    ck_assert(a.median == b.median && a.p01 == b.p01 && a.positive == b.positive && a.within[1] == b.within[1]);
    ck_assert_double_eq_tol(a.std, b.std, 1e-13);
    ck_assert_double_eq_tol((a.positive * a.positive_mean + a.negative * a.negative_mean) / a.count, a.mean, 1e-12);
    ck_assert_double_gt(a.positive_mean, 0);
    ck_assert_double_lt(a.negative_mean, 0);
}

TEST(nothing_has_no_figures) {
    const wcut_statistics s = figures_of(0, 1);
    ck_assert(s.count == 0 && s.mean == 0 && s.std == 0 && s.median == 0 && s.hausdorff == 0 && s.within[0] == 0);
}

TEST(bad_histograms_are_refused) {
    wcut_histogram *histogram = (wcut_histogram *)999;
    const double bad[] = {1, 0}, odd[] = {1, NAN};
    wcut_statistics s;
    ck_assert_int_eq(wcut_histogram_create(2, bad, &histogram), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_create(WCUT_BANDS_MAX + 1, bad, &histogram), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_create(-1, NULL, &histogram), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_create(1, NULL, &histogram), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_create(0, NULL, NULL), WCUT_BAD_ARGUMENT);
    FIRST_FAILED_ALLOCATIONS(2, wcut_histogram_create(0, NULL, &histogram), true);
    ck_assert_ptr_eq(histogram, (wcut_histogram *)999);
    ck_assert_int_eq(wcut_histogram_create(0, NULL, &histogram), WCUT_OK);
    ck_assert_int_eq(wcut_histogram_add(histogram, 2, odd), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_add(histogram, -1, odd), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_add(NULL, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_eval(histogram, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_eval(NULL, &s), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_histogram_eval(histogram, &s), WCUT_OK);
    ck_assert_int_eq(s.count, 0); /* the refused values were not counted */
    wcut_histogram_destroy(histogram);
    wcut_histogram_destroy(NULL);
}

/* ---- surveys ---- */

/* deviations over [0, 400] x [0, 1200] mm: an offset, a bump, noise, a few strays */
static const double OFFSET = -0.4, NOISE = 0.2;

static double bump(double x, double y) {
    const double dx = (x - 300) / 25, dy = (y - 900) / 25;
    return 3 * exp(-dx * dx - dy * dy);
}

static void given_deviations(int count, double noise, int strays) {
    wcut_random r = wcut_random_seed(11);
    for (int k = 0; k < count; k++) {
        const double x = 400 * wcut_random_uniform(&r), y = 1200 * wcut_random_uniform(&r);
        const double d = OFFSET + bump(x, y) + noise * wcut_random_normal(&r);
        deviation[k] = (wcut_deviation){.distance = k < strays ? (k % 2 ? 12 : -12) : d, .foot = {x, y, 150 + x / 10}};
    }
}

static const wcut_deviation_summary_result *survey_of(int count, wcut_deviation_summary **summary) {
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    const wcut_deviation_summary_result *result = NULL;
    o.high = vec3(400, 1200, 300);
    o.bands = 1, o.band[0] = 0.5;
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, summary), WCUT_OK);
    for (int k = 0; k < count; k += 1000)
        ck_assert_int_eq(wcut_deviation_summary_add(*summary, count - k < 1000 ? count - k : 1000, deviation + k),
                         WCUT_OK);
    ck_assert_int_eq(wcut_deviation_summary_eval(*summary, &result), WCUT_OK);
    return result;
}

TEST(offset_form_and_noise_are_told_apart_in_spite_of_strays) {
    /* the bump's own mean and spread over the face: pi s^2 A / area, and so on */
    const double area = 400 * 1200, pi = acos(-1), mean = pi * 625 * 3 / area;
    const double form = sqrt(pi * 625 / 2 * 9 / area - mean * mean);
    for (int strays = 0; strays <= 60; strays += 60) {
        wcut_deviation_summary *summary;
        given_deviations(60000, NOISE, strays);
        const wcut_split s = survey_of(60000, &summary)->split;
        ck_assert_double_eq_tol(s.offset, OFFSET + mean, 0.004);
        ck_assert_double_eq_tol(s.offset_error, NOISE / sqrt(60000), 0.3 * NOISE / sqrt(60000));
        ck_assert_double_eq_tol(s.form_rms, form, 0.03);
        ck_assert_double_eq_tol(s.noise_rms, NOISE, 0.01);
        wcut_deviation_summary_destroy(summary);
    }
}

TEST(the_worst_area_is_where_the_bump_is) {
    wcut_deviation_summary *summary;
    given_deviations(60000, 0.05, 40);
    const wcut_deviation_summary_result *r = survey_of(60000, &summary);
    ck_assert_int_ge(r->worsts, 1);
    const wcut_worst *w = &r->worst[0];
    ck_assert_double_eq_tol(w->place.x, 300, 3);
    ck_assert_double_eq_tol(w->place.y, 900, 3);
    ck_assert_double_eq_tol(w->place.z, 180, 2);
    ck_assert_double_eq_tol(w->peak, 3 + OFFSET, 0.3);
    ck_assert_double_eq_tol(w->volume, w->mean * w->area, 1e-9 * w->volume);
    ck_assert(w->low.x < 300 && w->high.x > 300 && w->low.y < 900 && w->high.y > 900);
    for (int k = 1; k < r->worsts; k++) ck_assert(fabs(r->worst[k].volume) <= fabs(r->worst[k - 1].volume));
    wcut_deviation_summary_destroy(summary);
}

TEST(every_patch_recovers_its_offset_within_the_noise) {
    wcut_deviation_summary *summary;
    given_deviations(MAX, NOISE, 0);
    for (int k = 0; k < MAX; k++) /* patch by patch another offset */
        deviation[k].distance += 0.1 * floor(deviation[k].foot.x / 100) - 0.05 * floor(deviation[k].foot.y / 100) -
                                 bump(deviation[k].foot.x, deviation[k].foot.y);
    const wcut_deviation_summary_result *r = survey_of(MAX, &summary);
    ck_assert_int_eq(r->zones, 4 * 12);
    for (int k = 0; k < r->zones; k++) {
        const wcut_zone *z = &r->zone[k];
        const double offset = OFFSET + 0.1 * (k % 4) - 0.05 * (k / 4);
        ck_assert(z->is_patch && z->low.x == 100 * (k % 4) && z->high.y == 100 * (k / 4 + 1));
        ck_assert_msg(fabs(z->mean - offset) < 4 * NOISE / sqrt(z->count), "%s: %g, %g", z->name, z->mean, offset);
        ck_assert_double_eq_tol(z->std, NOISE, 0.02);
    }
    ck_assert_str_eq(r->zone[5].name, "patch 2 2");
    ck_assert_int_eq(r->related, 0);
    wcut_deviation_summary_destroy(summary);
}

TEST(points_that_do_not_count_are_only_counted) {
    wcut_deviation_summary *summary;
    given_deviations(1000, 0.1, 0);
    for (int k = 0; k < 100; k++) deviation[k].place = k % 2 ? WCUT_PLACE_BEYOND : WCUT_PLACE_AMBIGUOUS;
    for (int k = 0; k < 100; k++) deviation[k].distance = 1e6;
    deviation[200].place = WCUT_PLACE_BORDER;
    const wcut_deviation_summary_result *r = survey_of(1000, &summary);
    ck_assert_int_eq(r->statistics.count, 900);
    ck_assert(r->place[WCUT_PLACE_BEYOND] == 50 && r->place[WCUT_PLACE_AMBIGUOUS] == 50);
    ck_assert(r->place[WCUT_PLACE_BORDER] == 1 && r->place[WCUT_PLACE_INSIDE] == 899);
    ck_assert_double_lt(r->statistics.hausdorff, 5);
    wcut_deviation_summary_destroy(summary);
}

TEST(one_deviation_and_none_are_surveyed_too) {
    for (int count = 0; count < 2; count++) {
        wcut_deviation_summary *summary;
        given_deviations(1, 0, 0);
        const wcut_deviation_summary_result *r = survey_of(count, &summary);
        ck_assert_int_eq(r->statistics.count, count);
        ck_assert_int_eq(r->worsts, 0);
        ck_assert(r->split.cells == 0 && isfinite(r->split.offset) && r->split.noise_rms == 0);
        wcut_deviation_summary_destroy(summary);
    }
}

TEST(bad_summaries_are_refused) {
    wcut_deviation_summary_options o = wcut_deviation_summary_options_default();
    wcut_deviation_summary *summary = (wcut_deviation_summary *)999;
    const wcut_deviation_summary_result *result;
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_BAD_ARGUMENT); /* no box */
    o.high = vec3(400, 1200, 300);
    ck_assert_int_eq(wcut_deviation_summary_create(NULL, NULL, &summary), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, NULL), WCUT_BAD_ARGUMENT);
    o.patch = 1;
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_BAD_ARGUMENT); /* 480000 patches */
    o.patch = 1e-300;
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_BAD_ARGUMENT);
    o.patch = 100, o.cell = 0;
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_BAD_ARGUMENT);
    o.cell = 1, o.bands = 1, o.band[0] = -1;
    ck_assert_int_eq(wcut_deviation_summary_create(&o, NULL, &summary), WCUT_BAD_ARGUMENT);
    o.bands = 0;
    ck_assert_ptr_eq(summary, (wcut_deviation_summary *)999);
    EACH_FAILED_ALLOCATION(wcut_deviation_summary_create(&o, NULL, &summary), summary == (wcut_deviation_summary *)999);
    given_deviations(2, 0, 0);
    deviation[1].distance = NAN;
    ck_assert_int_eq(wcut_deviation_summary_add(summary, 2, deviation), WCUT_BAD_ARGUMENT);
    deviation[1].distance = 0, deviation[1].place = WCUT_PLACE_COUNT;
    ck_assert_int_eq(wcut_deviation_summary_add(summary, 2, deviation), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_summary_add(summary, -1, deviation), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_summary_add(NULL, 0, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_deviation_summary_eval(summary, NULL), WCUT_BAD_ARGUMENT);
    wcut_alloc_fail_at(1);
    ck_assert_int_eq(wcut_deviation_summary_eval(summary, &result), WCUT_NO_MEMORY);
    wcut_alloc_fail_at(0);
    ck_assert_int_eq(wcut_deviation_summary_eval(summary, &result), WCUT_OK);
    ck_assert_int_eq(result->statistics.count, 0);
    wcut_deviation_summary_destroy(summary);
    wcut_deviation_summary_destroy(NULL);
}
