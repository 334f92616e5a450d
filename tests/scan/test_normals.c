/* Normals of clouds against those of the surface they lie on: exact, with noise, on every side, under overhangs. */
#include "base/alloc.h"
#include "base/numbers.h"
#include "sheets.h"
#include "test.h"

enum { COUNT = 4000 };

static wcut_vec3 point[COUNT], normal[COUNT], truth[COUNT];
static wcut_normals_report report;

static void outputs_as_before(void) {
    for (int k = 0; k < COUNT; k++) normal[k] = vec3(999, 999, 999);
    report = (wcut_normals_report){999, 999, 999};
}

static void untouched(void) {
    for (int k = 0; k < COUNT; k++) ck_assert(normal[k].x == 999 && normal[k].y == 999 && normal[k].z == 999);
    ck_assert_int_eq(report.undefined, 999);
}

static void found(int count, const wcut_normals_options *options) {
    outputs_as_before();
    ck_assert_int_eq(wcut_cloud_normals(count, point, options, 1, normal, &report), WCUT_OK);
}

/* [rad] root mean square angle to the truth; `wrong` counts those on the other side */
static double angle_rms(int count, int *wrong) {
    double sum = 0;
    *wrong = 0;
    for (int k = 0; k < count; k++) {
        ck_assert_double_eq_tol(vec3_length(normal[k]), 1, 1e-12);
        *wrong += vec3_dot(normal[k], truth[k]) < 0;
        const double angle = asin(fmin(1, vec3_length(vec3_cross(normal[k], truth[k]))));
        sum += angle * angle;
    }
    return sqrt(sum / count);
}

TEST(a_plane_has_its_normal_to_the_last_digits) {
    wcut_random r = wcut_random_seed(2);
    const wcut_vec3 n = vec3_unit(vec3(0.3, -0.4, 0.7)), u = vec3_unit(vec3_cross(n, vec3(1, 0, 0))),
                    v = vec3_cross(n, u);
    for (int k = 0; k < COUNT; k++) {
        const double a = 300 * wcut_random_uniform(&r), b = 300 * wcut_random_uniform(&r);
        point[k] = vec3_add_scaled(vec3_add_scaled(vec3(1000, 2000, -500), a, u), b, v);
    }
    found(COUNT, NULL);
    for (int k = 0; k < COUNT; k++) ck_assert_double_lt(vec3_distance(normal[k], n), 1e-9);
    ck_assert(report.undefined == 0 && report.propagated == 0 && report.guessed == 0);
    wcut_normals_options o = wcut_normals_options_default();
    o.side = vec3(0, 0, -7);
    found(COUNT, &o);
    for (int k = 0; k < COUNT; k++) ck_assert_double_lt(vec3_distance(normal[k], vec3_scale(-1, n)), 1e-9);
}

static void given_true_saddle(double slope, double noise) {
    given_saddle(COUNT, slope, noise, 11, point);
    for (int k = 0; k < COUNT; k++) truth[k] = saddle_normal(point[k].x, point[k].y, slope);
}

TEST(a_saddle_has_its_normals_all_towards_the_removed_half) {
    int wrong;
    given_true_saddle(0.5, 0);
    found(COUNT, NULL);
    ck_assert_double_lt(angle_rms(COUNT, &wrong), 0.01);
    ck_assert_int_eq(wrong, 0);
}

TEST(noise_tilts_a_normal_by_its_size_over_the_neighbourhoods) {
    /* A plane fitted to k + 1 points of a disc of radius R: slopes vary by noise / sqrt((k + 1) R^2 / 4), and pi R^2
       holds k points at the density of the sheet. Two slopes tilt it. Fewer neighbours or border points tilt more. */
    int wrong;
    const double noise = 0.3, density = COUNT / (400.0 * 1200.0);
    given_true_saddle(0, noise);
    for (int k = 8; k <= 64; k *= 2) {
        wcut_normals_options o = wcut_normals_options_default();
        o.neighbours = k;
        found(COUNT, &o);
        const double radius = sqrt(k / (WCUT_PI * density));
        const double expected = noise * sqrt(2 / ((k + 1) * radius * radius / 4));
        const double angle = angle_rms(COUNT, &wrong);
        ck_assert_double_gt(angle, 0.8 * expected);
        ck_assert_double_lt(angle, 1.8 * expected);
        ck_assert_int_eq(wrong, 0);
    }
}

TEST(steep_flanks_take_the_side_of_their_neighbours) {
    /* slopes up to 6: most normals are further from upright than 60 degrees */
    int wrong;
    given_true_saddle(6, 0.5);
    found(COUNT, NULL);
    angle_rms(COUNT, &wrong);
    ck_assert_int_eq(wrong, 0);
    ck_assert_int_gt(report.propagated, COUNT / 4);
    ck_assert_int_eq(report.guessed, 0);
}

/* direction [rad] of an S that rises from one level to another, leaning over by as much as `lean` */
static double direction_of(double lean, double s) { return s > 1 && s < 1 + WCUT_PI ? lean * sin(s - 1) : 0; }

/* at the arc length 100 s [mm] it goes that way; it never meets itself */
static void given_overhang(double lean) {
    enum { STEPS = 20000 };
    static double y[STEPS + 1], z[STEPS + 1];
    const double step = (2 + WCUT_PI) / STEPS;
    for (int i = 0; i < STEPS; i++) {
        const double direction = direction_of(lean, (i + 0.5) * step);
        y[i + 1] = y[i] + 100 * step * cos(direction);
        z[i + 1] = z[i] + 100 * step * sin(direction);
    }
    wcut_random r = wcut_random_seed(8);
    for (int k = 0; k < COUNT; k++) {
        const int i = wcut_random_below(&r, STEPS);
        const double direction = direction_of(lean, (i + 0.5) * step);
        point[k] = vec3(100 * wcut_random_uniform(&r), y[i] / 2 + y[i + 1] / 2, z[i] / 2 + z[i + 1] / 2);
        truth[k] = vec3(0, -sin(direction), cos(direction));
    }
}

TEST(beyond_the_vertical_neighbours_decide_and_far_beyond_the_sheet_as_a_whole) {
    int wrong;
    wcut_normals_options o = wcut_normals_options_default();
    given_overhang(2); /* 25 degrees beyond the vertical */
    o.steep = 0;
    found(COUNT, &o);
    angle_rms(COUNT, &wrong);
    ck_assert_int_gt(wrong, COUNT / 50); /* the side alone */
    o.steep = 0.5;
    found(COUNT, &o);
    angle_rms(COUNT, &wrong);
    ck_assert_int_eq(wrong, 0);
    given_overhang(2.4); /* 48 degrees: beyond 30 the side decides wrongly */
    found(COUNT, &o);
    angle_rms(COUNT, &wrong);
    ck_assert_int_gt(wrong, COUNT / 50);
    o.steep = 1;
    found(COUNT, &o);
    const double angle = angle_rms(COUNT, &wrong);
    ck_assert_int_eq(wrong, 0);
    ck_assert_double_lt(angle, 0.1);
    ck_assert_int_eq(report.guessed, 0); /* its levels are exactly upright: they begin */
    o.side = vec3(0, 0, -1);
    found(COUNT, &o);
    angle_rms(COUNT, &wrong);
    ck_assert_int_eq(wrong, COUNT);
}

TEST(every_piece_of_a_cloud_is_turned_for_itself) {
    /* three sheets, far apart, leaning to either side */
    int wrong;
    wcut_random r = wcut_random_seed(3);
    for (int k = 0; k < COUNT; k++) {
        const double a = wcut_random_uniform(&r), b = wcut_random_uniform(&r),
                     slope = k % 3 == 0   ? 3
                             : k % 3 == 1 ? -3
                                          : 9;
        point[k] = vec3(1000.0 * (k % 3) + a * 20, b * 60, slope * a * 20);
        truth[k] = vec3_unit(vec3(-slope, 0, 1));
    }
    found(COUNT, NULL);
    ck_assert_double_lt(angle_rms(COUNT, &wrong), 1e-9);
    ck_assert(wrong == 0 && report.guessed == 3 && report.propagated == COUNT);
}

TEST(a_line_has_no_normal_and_says_so) {
    for (int k = 0; k < 500; k++) point[k] = vec3(0.1 * k, 0.2 * k, -0.3 * k);
    outputs_as_before();
    ck_assert_int_eq(wcut_cloud_normals(500, point, NULL, 1, normal, &report), WCUT_DEGENERATE);
    for (int k = 0; k < 500; k++) point[k] = vec3(4, 5, 6);
    ck_assert_int_eq(wcut_cloud_normals(500, point, NULL, 1, normal, &report), WCUT_DEGENERATE);
    untouched();
    /* a line beside a sheet: its points alone have none */
    for (int k = 0; k < 500; k++) point[k] = k < 100 ? vec3(1e4 + k, 0, 0) : vec3(k % 20, k / 20, 0);
    found(500, NULL);
    ck_assert_int_eq(report.undefined, 100);
    for (int k = 0; k < 500; k++) ck_assert_double_eq_tol(normal[k].z, k < 100 ? 0 : 1, 1e-12);
}

TEST(three_points_are_enough_for_one_normal) {
    const wcut_vec3 p[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    memcpy(point, p, sizeof p);
    found(3, NULL);
    for (int k = 0; k < 3; k++) ck_assert_double_lt(vec3_distance(normal[k], vec3(0, 0, 1)), 1e-12);
}

TEST(two_threads_give_the_same_bytes) {
    static wcut_vec3 other[COUNT];
    wcut_normals_report second;
    given_overhang(2.4);
    wcut_normals_options o = wcut_normals_options_default();
    for (o.steep = 0; o.steep <= 1; o.steep += 0.5) {
        found(COUNT, &o);
        ck_assert_int_eq(wcut_cloud_normals(COUNT, point, &o, 2, other, &second), WCUT_OK);
        ck_assert(memcmp(other, normal, sizeof other) == 0 && memcmp(&second, &report, sizeof report) == 0);
    }
}

TEST(arguments_outside_their_range_are_refused_and_nothing_is_written) {
    given_true_saddle(0.5, 0);
    outputs_as_before();
    const wcut_normals_options good = wcut_normals_options_default();
    wcut_normals_options bad[7] = {good, good, good, good, good, good, good};
    bad[0].neighbours = 1, bad[1].neighbours = 129, bad[2].side = vec3(0, 0, 0), bad[3].side.x = NAN;
    bad[4].steep = -0.1, bad[5].steep = 1.1, bad[6].steep = NAN;
    for (int k = 0; k < 7; k++)
        ck_assert_int_eq(wcut_cloud_normals(COUNT, point, &bad[k], 1, normal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_normals(2, point, NULL, 1, normal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_normals(COUNT, NULL, NULL, 1, normal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_normals(COUNT, point, NULL, 0, normal, &report), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_cloud_normals(COUNT, point, NULL, 1, NULL, &report), WCUT_BAD_ARGUMENT);
    point[7].y = NAN;
    ck_assert_int_eq(wcut_cloud_normals(COUNT, point, NULL, 1, normal, &report), WCUT_BAD_ARGUMENT);
    point[7].y = -2e12;
    ck_assert_int_eq(wcut_cloud_normals(COUNT, point, NULL, 1, normal, &report), WCUT_BAD_ARGUMENT);
    untouched();
}

TEST(without_memory_nothing_is_written) {
    given_overhang(2.4);
    outputs_as_before();
    EACH_FAILED_ALLOCATION(wcut_cloud_normals(COUNT, point, NULL, 1, normal, &report), (untouched(), true));
}
