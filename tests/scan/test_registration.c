/* Registration against known motions, Bayes' rule in closed form, and the coverage of its covariance.
   labels: unit plain */
#include <limits.h>
#include <string.h>
#include <wirecut/registration.h>

#include "base/alloc.h"
#include "base/symmetric.h"
#include "scan/faces.h"
#include "scan/register_motion.h"
#include "scan/sheets.h"
#include "test.h"

enum { N = 600, DOFS = WCUT_DOF_COUNT };
static const double DEG = WCUT_PI / 180;
static wcut_vec3 on_face[N], scan[N];
static wcut_registration_options options;
static wcut_registration found;

/* a result that no call has touched */
static void forget(void) { memset(&found, 0x99, sizeof found); }

static void assert_untouched(void) {
    wcut_registration blank;
    memset(&blank, 0x99, sizeof blank);
    ck_assert_mem_eq(&found, &blank, sizeof blank);
}

/* move a copy of `from` by the inverse of a motion about the middle of the block, so that the motion brings it back */
static wcut_motion misplace(int count, const wcut_vec3 *from, const double *x, wcut_vec3 *to) {
    const wcut_motion m = wcut_motion_of(vec3(200, 300, 150), x);
    for (int i = 0; i < count; i++) {
        const wcut_vec3 q = vec3_sub(vec3_sub(from[i], m.pivot), vec3(x[0], x[1], x[2]));
        to[i] = vec3_add(mat3_row_product(q, m.rotation), m.pivot); /* R^T q */
    }
    return m;
}

/* the furthest that a registration leaves a point from where it belongs */
static double furthest(int count, const wcut_vec3 *from, const wcut_vec3 *to) {
    static wcut_vec3 moved[N];
    double max = 0;
    memcpy(moved, from, (size_t)count * sizeof *moved);
    ck_assert_int_eq(wcut_registration_move(&found, count, moved, NULL), WCUT_OK);
    for (int i = 0; i < count; i++) max = fmax(max, vec3_distance(moved[i], to[i]));
    return max;
}

/* about the middle of the block, all free */
static void given_options(void) {
    options = wcut_registration_options_default();
    options.pivot_given = 1;
    options.pivot = vec3(200, 300, 150);
    options.tolerance = 1e-10;
    forget();
}

/* ---- motions ---- */

TEST(a_rotation_vector_survives_its_matrix) {
    wcut_random r = wcut_random_seed(5);
    for (int trial = 0; trial < 200; trial++) {
        double x[DOFS] = {1, 2, 3, 0, 0, 0};
        const double angle = trial < 20 ? pow(10, -trial) : WCUT_PI * wcut_random_uniform(&r) * (1 - 1e-9);
        wcut_vec3 axis = {wcut_random_normal(&r), wcut_random_normal(&r), wcut_random_normal(&r)};
        axis = vec3_scale(angle, vec3_unit(axis));
        x[3] = axis.x, x[4] = axis.y, x[5] = axis.z;
        const wcut_vec3 pivot = {10, -20, 30}, to = {11, -18, 33};
        const wcut_motion m = wcut_motion_of(pivot, x), back = wcut_motion_between(pivot, m.rotation, pivot, to);
        for (int k = 0; k < DOFS; k++) ck_assert_double_eq_tol(back.x[k], x[k], 1e-12 * fmax(1, fabs(x[k])) * 30);
    }
}

TEST(the_jacobian_of_a_rotation_is_its_derivative) {
    const double h = 1e-6, base[DOFS] = {0, 0, 0, 0.7, -1.1, 0.4};
    const wcut_vec3 p = {3, -2, 5}, pivot = {1, 1, 1};
    const mat3 jacobian = wcut_motion_jacobian(base + 3);
    const wcut_motion m = wcut_motion_of(pivot, base);
    for (int k = 0; k < 3; k++) {
        double x[DOFS], y[DOFS];
        memcpy(x, base, sizeof x);
        memcpy(y, base, sizeof y);
        x[3 + k] += h, y[3 + k] -= h;
        const wcut_motion a = wcut_motion_of(pivot, x), b = wcut_motion_of(pivot, y);
        const wcut_vec3 slope = vec3_scale(0.5 / h, vec3_sub(motion_apply(&a, p), motion_apply(&b, p)));
        const wcut_vec3 unit = {k == 0, k == 1, k == 2};
        const wcut_vec3 told = vec3_cross(mat3_times(jacobian, unit), motion_arm(&m, p));
        ck_assert_double_lt(vec3_distance(slope, told), 1e-8);
    }
}

TEST(eigenvectors_diagonalise_and_the_greatest_comes_first) {
    wcut_random r = wcut_random_seed(8);
    double a[36], copy[36], value[6], vector[36];
    for (int i = 0; i < 6; i++)
        for (int j = i; j < 6; j++) a[6 * i + j] = a[6 * j + i] = wcut_random_normal(&r) * pow(10, i - j);
    memcpy(copy, a, sizeof a);
    wcut_symmetric_eigen(6, a, value, vector);
    for (int k = 0; k < 6; k++) {
        if (k) ck_assert_double_ge(value[k - 1], value[k]);
        for (int i = 0; i < 6; i++) {
            double sum = 0;
            for (int j = 0; j < 6; j++) sum += copy[6 * i + j] * vector[6 * j + k];
            ck_assert_double_eq_tol(sum, value[k] * vector[6 * i + k], 1e-13 * 10);
        }
    }
}

TEST(none_is_the_identity_and_moving_turns_normals) {
    found = wcut_registration_none();
    wcut_vec3 point[2] = {{1, 2, 3}, {-4, 5, 6}}, normal[2] = {{0, 0, 1}, {1, 0, 0}};
    ck_assert_int_eq(wcut_registration_move(&found, 2, point, normal), WCUT_OK);
    ck_assert(point[1].x == -4 && point[1].y == 5 && point[1].z == 6 && normal[1].x == 1);
    ck_assert_int_eq(found.method, WCUT_REGISTRATION_METHOD_NONE);
    const double quarter[16] = {0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30, 0, 0, 0, 1};
    memcpy(found.matrix, quarter, sizeof quarter);
    ck_assert_int_eq(wcut_registration_move(&found, 2, point, normal), WCUT_OK);
    ck_assert(point[0].x == 8 && point[0].y == 21 && point[0].z == 33 && normal[1].y == 1 && normal[1].x == 0);
    ck_assert_int_eq(wcut_registration_move(NULL, 2, point, normal), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_move(&found, -1, point, normal), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_move(&found, 1, NULL, normal), WCUT_BAD_ARGUMENT);
    ck_assert(point[0].x == 8);
}

/* ---- datums ---- */

enum { PAIRS = 5 };
static const wcut_vec3 corner[PAIRS] = {{0, 0, 0}, {400, 0, 10}, {400, 600, 0}, {0, 600, 40}, {150, 210, 90}};
static wcut_datum_pair pair[PAIRS];

/* corners of the block, seen by a scanner that is elsewhere; each coordinate with its noise */
static void given_pairs(const double *x, double sigma, uint64_t seed) {
    wcut_vec3 seen[PAIRS];
    wcut_random r = wcut_random_seed(seed);
    misplace(PAIRS, corner, x, seen);
    for (int i = 0; i < PAIRS; i++) {
        const wcut_vec3 e = {wcut_random_normal(&r), wcut_random_normal(&r), wcut_random_normal(&r)};
        pair[i] = (wcut_datum_pair){vec3_add_scaled(seen[i], sigma, e), corner[i], sigma};
    }
}

TEST(pairs_give_a_motion_back_however_large_it_is) {
    wcut_random r = wcut_random_seed(11);
    for (int trial = 0; trial < 100; trial++) {
        double x[DOFS];
        for (int k = 0; k < 3; k++) x[k] = 2000 * (wcut_random_uniform(&r) - 0.5), x[k + 3] = wcut_random_normal(&r);
        given_pairs(x, 0, 1);
        given_options();
        ck_assert_int_eq(wcut_registration_solve_datum(PAIRS, pair, 0, NULL, &options, &found, NULL), WCUT_OK);
        wcut_vec3 seen[PAIRS];
        for (int i = 0; i < PAIRS; i++) seen[i] = pair[i].scan;
        ck_assert_double_lt(furthest(PAIRS, seen, corner), 1e-9);
        ck_assert(found.rank == 6 && found.free == 6 && found.points == 15 && found.kept == 15 && found.overlap == 1);
        ck_assert_int_eq(found.method, WCUT_REGISTRATION_METHOD_DATUM);
        ck_assert_int_le(found.iterations, 1);
    }
}

/* (x - truth) C^-1 (x - truth) of those found, chi-square with six degrees of freedom */
static double mahalanobis(const double *truth) {
    double e[DOFS], z[DOFS], sum = 0;
    for (int k = 0; k < DOFS; k++) e[k] = found.parameter[k] - truth[k];
    ck_assert(wcut_symmetric_solve(DOFS, found.covariance, e, z, NULL));
    for (int k = 0; k < DOFS; k++) sum += e[k] * z[k];
    return sum;
}

/* chi-square of six: mean 6, variance 12, 95 % below 12.592; `slack` [1]: how much too wide the covariance may be */
static void assert_chi_square(int trials, double sum, int inside, double slack) {
    ck_assert_double_le(sum / trials, 6 + 4 * sqrt(12.0 / trials));
    ck_assert_double_ge(sum / trials, 6 * (1 - slack) - 4 * sqrt(12.0 / trials));
    ck_assert_double_ge((double)inside / trials, 0.95 - 4 * sqrt(0.95 * 0.05 / trials));
    if (slack == 0) ck_assert_double_le((double)inside / trials, 0.95 + 4 * sqrt(0.95 * 0.05 / trials));
}

TEST(the_covariance_of_pairs_covers_the_truth) {
    const double x[DOFS] = {3, -2, 5, 0.2, -0.3, 0.9};
    double sum = 0;
    int inside = 0;
    enum { TRIALS = 1000 };
    for (int trial = 0; trial < TRIALS; trial++) {
        given_pairs(x, 0.2, (uint64_t)trial);
        pair[0].sigma = pair[1].sigma = 0.2;
        given_options();
        ck_assert_int_eq(wcut_registration_solve_datum(PAIRS, pair, 0, NULL, &options, &found, NULL), WCUT_OK);
        ck_assert(found.noise == 0);
        sum += mahalanobis(x);
        inside += mahalanobis(x) < 12.592;
    }
    assert_chi_square(TRIALS, sum, inside, 0);
}

TEST(a_pair_with_half_the_sigma_counts_four_times) {
    /* one free shift: the mean weighted by 1 / sigma^2, and its variance */
    given_options();
    for (int k = 0; k < DOFS; k++) options.dof[k].kind = k == WCUT_DOF_TZ ? WCUT_DOF_KIND_FREE : WCUT_DOF_KIND_LOCKED;
    const wcut_datum_pair two[2] = {{{0, 0, 0}, {0, 0, 1}, 0.2}, {{9, 0, 0}, {9, 0, 2}, 0.1}};
    ck_assert_int_eq(wcut_registration_solve_datum(2, two, 0, NULL, &options, &found, NULL), WCUT_OK);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TZ], (1 + 4 * 2) / 5.0, 1e-12);
    ck_assert_double_eq_tol(found.covariance[2 * DOFS + 2], 1 / (1 / 0.04 + 1 / 0.01), 1e-12);
    ck_assert(found.free == 1 && found.rank == 1 && found.determined[WCUT_DOF_TZ] && !found.determined[WCUT_DOF_TX]);
}

/* three, two and one point on three faces of the block */
static const wcut_vec3 bottom[3] = {{40, 50, 0}, {370, 30, 0}, {210, 550, 0}}, side[2] = {{0, 40, 20}, {0, 580, 60}},
                       front[1] = {{180, 0, 30}};
static wcut_vec3 seen_on_face[6];
static wcut_datum_face face[3];

static void given_faces(const double *x, double sigma) {
    misplace(3, bottom, x, seen_on_face);
    misplace(2, side, x, seen_on_face + 3);
    misplace(1, front, x, seen_on_face + 5);
    face[0] = (wcut_datum_face){{77, 88, 0}, {0, 0, -2}, sigma, 3, seen_on_face};
    face[1] = (wcut_datum_face){{0, 5, 5}, {-1, 0, 0}, sigma, 2, seen_on_face + 3};
    face[2] = (wcut_datum_face){{5, 0, 5}, {0, -1, 0}, sigma, 1, seen_on_face + 5};
}

TEST(six_points_on_three_faces_fix_a_block) {
    const double x[DOFS] = {4, -7, 3, 0.05, -0.03, 0.2};
    given_faces(x, 0.05);
    given_options();
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 3, face, &options, &found, NULL), WCUT_OK);
    for (int k = 0; k < DOFS; k++) ck_assert_double_eq_tol(found.parameter[k], x[k], 1e-9);
    ck_assert(found.rank == 6 && found.points == 6);
    ck_assert_double_gt(found.rms_before, 1);
    ck_assert_double_lt(found.rms, 1e-9);
}

TEST(a_face_and_pairs_work_together) {
    const double x[DOFS] = {4, -7, 3, 0.05, -0.03, 0.2};
    given_faces(x, 0);
    given_pairs(x, 0, 1);
    given_options();
    ck_assert_int_eq(wcut_registration_solve_datum(2, pair, 1, face, &options, &found, NULL), WCUT_OK);
    for (int k = 0; k < DOFS; k++) ck_assert_double_eq_tol(found.parameter[k], x[k], 1e-9);
}

TEST(what_is_left_of_datums_is_told_one_by_one) {
    const wcut_vec3 on[2] = {{5, 5, 8}, {5, 5, 9}};
    const wcut_datum_pair two[2] = {{{0, 0, 0}, {0, 0, 3}, 0}, {{10, 0, 0}, {13, 4, 3}, 0}};
    const wcut_datum_face top = {{0, 0, 10}, {0, 0, -2}, 0, 2, on};
    wcut_datum_residual left[4], blank[4];
    found = wcut_registration_none();
    found.matrix[11] = 3; /* 3 mm up */
    ck_assert_int_eq(wcut_datum_residual_eval(&found, 2, two, 1, &top, left), WCUT_OK);
    ck_assert(!left[0].is_face && left[0].distance == 0 && left[0].moved.z == 3);
    ck_assert(left[1].datum == 1 && left[1].offset.x == -3 && left[1].offset.y == -4 && left[1].distance == 5);
    ck_assert(left[2].is_face && left[2].datum == 0 && left[2].distance == -1 && left[2].offset.z == 1);
    ck_assert(left[3].distance == -2 && left[3].moved.z == 12);
    memset(blank, 0x99, sizeof blank);
    memcpy(left, blank, sizeof left);
    const wcut_datum_face flat = {{0, 0, 10}, {0, 0, 0}, 0, 2, on};
    ck_assert_int_eq(wcut_datum_residual_eval(&found, 2, two, 1, &flat, left), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_datum_residual_eval(NULL, 2, two, 1, &top, left), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_datum_residual_eval(&found, 2, NULL, 1, &top, left), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_datum_residual_eval(&found, -1, two, 1, &top, left), WCUT_BAD_ARGUMENT);
    ck_assert_mem_eq(left, blank, sizeof left);
}

TEST(pairs_on_a_line_leave_the_turn_about_it_where_it_was) {
    given_options();
    const wcut_datum_pair line[3] = {
        {{0, 0, 0}, {0, 0, 3}, 0.1}, {{10, 0, 0}, {10, 0, 3}, 0.1}, {{30, 0, 0}, {30, 0, 3}, 0.1}};
    options.pivot = vec3(0, 0, 0);
    ck_assert_int_eq(wcut_registration_solve_datum(3, line, 0, NULL, &options, &found, NULL), WCUT_OK);
    ck_assert(found.rank == 5 && found.free == 6 && !found.determined[WCUT_DOF_RX] && found.determined[WCUT_DOF_TZ]);
    ck_assert(found.parameter[WCUT_DOF_RX] == 0);
    for (int k = 0; k < DOFS; k++) ck_assert(found.covariance[DOFS * k + WCUT_DOF_RX] == 0);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TZ], 3, 1e-9);
}

static wcut_status solve_pairs(int pairs, wcut_error *error) {
    return wcut_registration_solve_datum(pairs, pair, 0, NULL, &options, &found, error);
}

TEST(bad_datums_are_refused) {
    const double x[DOFS] = {0};
    wcut_error error;
    given_faces(x, 0.1);
    given_options();
    given_pairs(x, 0, 1);
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 0, NULL, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 1, NULL, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_solve_datum(-1, pair, 1, face, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_solve_datum(1, pair, 1, face, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "all or none"));
    pair[3].scan.y = NAN;
    ck_assert_int_eq(solve_pairs(PAIRS, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "pair 3"));
    face[1].normal = vec3(0, 0, 0);
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 3, face, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    given_faces(x, 0.1);
    face[2].count = 0;
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 3, face, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    given_faces(x, 0.1);
    seen_on_face[4].x = INFINITY;
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 3, face, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    given_faces(x, -1);
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 3, face, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    assert_untouched();
}

TEST(datums_that_say_nothing_are_degenerate) {
    const double x[DOFS] = {0};
    wcut_error error;
    given_pairs(x, 0, 1);
    given_options();
    ck_assert_int_eq(solve_pairs(1, &error), WCUT_DEGENERATE); /* three residuals, three unknowns, no sigma */
    for (int k = 0; k < DOFS; k++) options.dof[k].kind = WCUT_DOF_KIND_LOCKED;
    ck_assert_int_eq(solve_pairs(PAIRS, &error), WCUT_DEGENERATE);
    ck_assert_int_eq(error.status, WCUT_DEGENERATE);
    assert_untouched();
}

TEST(datums_stopped_early_hand_out_the_last_step) {
    const double x[DOFS] = {4, -7, 3, 0.4, -0.5, 1.2};
    given_faces(x, 0.1);
    given_options();
    options.max_iterations = 1;
    ck_assert_int_eq(wcut_registration_solve_datum(0, NULL, 3, face, &options, &found, NULL), WCUT_NOT_CONVERGED);
    ck_assert_int_eq(found.iterations, 1);
    ck_assert_double_lt(found.rms, found.rms_before);
}

TEST(options_outside_their_ranges_are_refused) {
    const double x[DOFS] = {0};
    given_pairs(x, 0.1, 1);
    wcut_error error;
    for (int k = 0; k < 12; k++) {
        given_options();
        if (k == 0) options.dof[2].kind = 7;
        if (k == 1) options.dof[2].value = NAN;
        if (k == 2) options.dof[3] = (wcut_dof){WCUT_DOF_KIND_PRIOR, 0, 0};
        if (k == 3) options.dof[3].value = options.dof[4].value = 3;
        if (k == 4) options.pivot.x = INFINITY;
        if (k == 5) options.noise = -1;
        if (k == 6) options.keep = 0.4;
        if (k == 7) options.keep = 1.1;
        if (k == 8) options.max_points = 99;
        if (k == 9) options.sensitivity = 0;
        if (k == 10) options.tolerance = 0;
        if (k == 11) options.max_iterations = 0;
        ck_assert_int_eq(solve_pairs(PAIRS, &error), WCUT_BAD_ARGUMENT);
        ck_assert(error.text[0]);
        assert_untouched();
    }
}

/* ---- best fit ---- */

static wcut_surface *surface;
static wcut_projection *projection;

static void given_wavy(void) {
    surface = given_face(wavy_height);
    projection = given_projection(surface);
    given_options();
    options.coarse = 0;
}

static void given_flat(void) {
    surface = given_face(flat_height);
    projection = given_projection(surface);
    given_options();
    options.coarse = 0;
}

static void end_face(void) {
    wcut_projection_destroy(projection);
    wcut_surface_destroy(surface);
}

static wcut_status fit(int count) { return wcut_registration_fit(projection, count, scan, &options, 1, &found, NULL); }

TEST(a_scan_without_noise_comes_back_to_rounding) {
    given_wavy();
    const double x[DOFS] = {4, -6, 3, 0.6 * DEG, -0.4 * DEG, 1.1 * DEG};
    given_scan(surface, N, 0.05, 0, 1, on_face);
    misplace(N, on_face, x, scan);
    options.keep = 1;
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert_double_lt(furthest(N, scan, on_face), 1e-6);
    for (int k = 0; k < 3; k++) ck_assert_double_eq_tol(found.parameter[k], x[k], 1e-6);
    for (int k = 3; k < DOFS; k++) ck_assert_double_eq_tol(found.parameter[k], x[k], 1e-7 * DEG * 10);
    ck_assert(found.rank == 6 && found.overlap == 1 && found.points == N && found.kept == N);
    ck_assert_double_gt(found.rms_before, 1);
    ck_assert_int_eq(found.method, WCUT_REGISTRATION_METHOD_FIT);
    end_face();
}

TEST(trimming_leaves_outliers_out) {
    given_wavy();
    const double x[DOFS] = {2, -1, 1.5, 0.2 * DEG, 0.3 * DEG, -0.5 * DEG};
    given_scan(surface, N, 0.05, 0, 2, on_face);
    for (int i = 0; i < N; i += 12) on_face[i].z += 4 + i % 7; /* 8 % */
    misplace(N, on_face, x, scan);
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert_double_lt(furthest(N, scan, on_face), 1e-6);
    /* no outlier has a weight, each of the others has one */
    ck_assert_int_eq(found.kept, N - (N + 11) / 12);
    end_face();
}

TEST(a_scan_from_anywhere_is_found_by_the_coarse_start) {
    given_wavy();
    options.coarse = 1;
    const double motion[3][DOFS] = {
        {500, 300, -200, 0.3, 2.8, 0.4}, {-40, 900, 70, 0, 0, 3.0}, {0, 0, 0, 1.5, -1.2, 1}};
    for (int trial = 0; trial < 3; trial++) {
        given_scan(surface, N, 0.03, 0, 3, on_face);
        misplace(N, on_face, motion[trial], scan);
        ck_assert_int_eq(fit(N), WCUT_OK);
        ck_assert_double_lt(furthest(N, scan, on_face), 1e-6);
        ck_assert_double_gt(found.rival, 100 * found.rms);
    }
    end_face();
}

TEST(points_beyond_the_border_do_not_pull) {
    given_wavy();
    const double x[DOFS] = {1, -2, 0.5, 0.1 * DEG, 0, 0.2 * DEG};
    given_scan(surface, N, 0.05, 0, 4, on_face);
    for (int i = 0; i < 60; i++) on_face[i] = vec3(on_face[i].x, -30 - i, 170);
    misplace(N, on_face, x, scan);
    options.keep = 1;
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert_double_lt(furthest(N, scan, on_face), 1e-6);
    ck_assert_double_eq_tol(found.overlap, 0.9, 1e-12);
    end_face();
}

TEST(a_locked_degree_of_freedom_stays_to_the_bit) {
    given_wavy();
    const double x[DOFS] = {3, 2, -1, 0.5 * DEG, 0.2 * DEG, -0.7 * DEG};
    given_scan(surface, N, 0.05, 0.05, 5, on_face);
    misplace(N, on_face, x, scan);
    options.dof[WCUT_DOF_TX] = (wcut_dof){WCUT_DOF_KIND_LOCKED, 0.1, 0};
    options.dof[WCUT_DOF_RZ] = (wcut_dof){WCUT_DOF_KIND_LOCKED, -0.3 * DEG, 0};
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert(found.parameter[WCUT_DOF_TX] == 0.1 && found.parameter[WCUT_DOF_RZ] == -0.3 * DEG);
    ck_assert(found.free == 4 && found.rank == 4 && !found.determined[WCUT_DOF_TX] && found.determined[WCUT_DOF_TY]);
    for (int k = 0; k < DOFS; k++) ck_assert(found.covariance[DOFS * k + WCUT_DOF_RZ] == 0);
    end_face();
}

TEST(a_prior_and_the_data_meet_where_bayes_says) {
    given_flat();
    given_scan(surface, N, 0.05, 0, 6, scan);
    for (int i = 0; i < N; i++) scan[i].z -= 0.4; /* the data ask for tz = 0.4 */
    for (int k = 0; k < DOFS; k++) options.dof[k].kind = WCUT_DOF_KIND_LOCKED;
    options.dof[WCUT_DOF_TZ] = (wcut_dof){WCUT_DOF_KIND_PRIOR, 0.1, 0.02};
    options.noise = 0.5;
    options.keep = 1;
    ck_assert_int_eq(fit(N), WCUT_OK);
    const double data = N / 0.25, prior = 1 / 0.0004;
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TZ], (data * 0.4 + prior * 0.1) / (data + prior), 1e-9);
    ck_assert_double_eq_tol(found.covariance[2 * DOFS + 2], 1 / (data + prior), 1e-15);
    ck_assert(found.noise == 0.5);
    end_face();
}

TEST(a_prior_alone_determines_what_the_face_does_not) {
    given_flat();
    given_scan(surface, N, 0.1, 0.1, 7, scan);
    options.dof[WCUT_DOF_TX] = (wcut_dof){WCUT_DOF_KIND_PRIOR, 1.5, 0.3};
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert(found.rank == 4 && found.determined[WCUT_DOF_TX] && !found.determined[WCUT_DOF_TY]);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TX], 1.5, 1e-6);
    ck_assert_double_eq_tol(found.covariance[0], 0.09, 1e-4);
    end_face();
}

TEST(a_flat_face_determines_three_and_invents_nothing) {
    given_flat();
    const double x[DOFS] = {0, 0, 2, 0.3 * DEG, -0.2 * DEG, 0};
    given_scan(surface, N, 0.1, 0.05, 8, on_face);
    misplace(N, on_face, x, scan);
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert(found.rank == 3 && found.free == 6);
    ck_assert(!found.determined[WCUT_DOF_TX] && !found.determined[WCUT_DOF_TY] && !found.determined[WCUT_DOF_RZ]);
    ck_assert(found.determined[WCUT_DOF_TZ] && found.determined[WCUT_DOF_RX] && found.determined[WCUT_DOF_RY]);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TX], 0, 1e-6);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TY], 0, 1e-6);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_RZ], 0, 1e-6);
    ck_assert_double_eq_tol(found.parameter[WCUT_DOF_TZ], 2, 0.02);
    for (int k = 0; k < DOFS; k++) ck_assert(found.covariance[k] == 0);
    end_face();
}

/* the fit of many scans with noise, all points kept or trimmed */
static void assert_coverage(double keep, double given_noise) {
    const double x[DOFS] = {0.3, -0.2, 0.4, 0.05 * DEG, -0.1 * DEG, 0.1 * DEG};
    double sum = 0, noise = 0;
    int inside = 0;
    enum { TRIALS = 300 };
    given_wavy();
    options.keep = keep;
    options.noise = given_noise;
    options.tolerance = 1e-5;
    for (int trial = 0; trial < TRIALS; trial++) {
        given_scan(surface, 300, 0.05, 0.1, (uint64_t)trial, on_face);
        misplace(300, on_face, x, scan);
        ck_assert_int_eq(fit(300), WCUT_OK);
        sum += mahalanobis(x);
        noise += found.noise / TRIALS;
        inside += mahalanobis(x) < 12.592;
    }
    /* steps end at the first set of points that keeps itself, which is a little better than the limit of many points */
    assert_chi_square(TRIALS, sum, inside, keep < 1 ? 0.2 : 0);
    ck_assert_double_eq_tol(noise, 0.1, 0.002);
    end_face();
}

TEST(the_covariance_of_a_fit_covers_the_truth) { assert_coverage(1, 0.1); }

TEST(trimming_is_in_the_covariance) { assert_coverage(0.9, 0); }

TEST(a_best_fit_hides_a_deviation_and_no_motion_shows_it) {
    /* the wire lagged on one half: a face that rises by up to 8 mm towards x = 400, which looks like a tilt */
    given_wavy();
    double truth = 0, hidden = 0;
    wcut_random r = wcut_random_seed(9);
    for (int i = 0; i < N; i++) {
        const double u = 0.05 + 0.9 * wcut_random_uniform(&r), v = 0.05 + 0.9 * wcut_random_uniform(&r);
        scan[i] = above(surface, u, v, 8 * u * u);
        truth += 64 * u * u * u * u / N;
    }
    options.keep = 1;
    ck_assert_int_eq(fit(N), WCUT_OK);
    ck_assert_double_eq_tol(found.rms_before, sqrt(truth), 1e-6); /* none: the truth */
    ck_assert_double_lt(found.rms, 0.25 * sqrt(truth));
    wcut_foot foot[N];
    ck_assert_int_eq(wcut_registration_move(&found, N, scan, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_projection_locate(projection, N, scan, 1, foot), WCUT_OK);
    for (int i = 0; i < N; i++) hidden = fmin(hidden, foot[i].height);
    ck_assert_double_lt(hidden, -0.3); /* and a dent that is not there */
    end_face();
}

TEST(the_result_does_not_depend_on_threads) {
    given_wavy();
    options.coarse = 1;
    given_scan(surface, N, 0, 0.1, 10, scan);
    ck_assert_int_eq(fit(N), WCUT_OK);
    const wcut_registration one = found;
    forget();
    ck_assert_int_eq(wcut_registration_fit(projection, N, scan, &options, 3, &found, NULL), WCUT_OK);
    ck_assert_mem_eq(&found.matrix, &one.matrix, sizeof one.matrix);
    ck_assert_mem_eq(&found.covariance, &one.covariance, sizeof one.covariance);
    ck_assert(found.rms == one.rms && found.rival == one.rival);
    end_face();
}

TEST(bad_scans_are_refused) {
    given_wavy();
    given_scan(surface, N, 0, 0.1, 10, scan);
    ck_assert_int_eq(fit(5), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(fit(0), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit(NULL, N, scan, NULL, 1, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit(projection, N, NULL, NULL, 1, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit(projection, N, scan, NULL, 0, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_registration_fit(projection, N, scan, NULL, 1, NULL, NULL), WCUT_BAD_ARGUMENT);
    options.keep = 2;
    ck_assert_int_eq(fit(N), WCUT_BAD_ARGUMENT);
    options.keep = 1;
    scan[N - 1].y = NAN;
    ck_assert_int_eq(fit(N), WCUT_BAD_ARGUMENT);
    assert_untouched();
    end_face();
}

TEST(scans_that_determine_nothing_are_degenerate) {
    given_wavy();
    for (int i = 0; i < N; i++) scan[i] = vec3(100, 100, 150); /* all in one place */
    ck_assert_int_eq(fit(N), WCUT_DEGENERATE);
    for (int i = 0; i < N; i++) scan[i] = vec3(10 + 0.5 * i, 20 + 0.7 * i, 150); /* on one line */
    ck_assert_int_eq(fit(N), WCUT_DEGENERATE);
    given_scan(surface, N, 0, 0.1, 10, scan);
    for (int i = 0; i < N; i++) scan[i].x += 5000; /* nowhere near */
    ck_assert_int_eq(fit(N), WCUT_DEGENERATE);
    given_scan(surface, N, 0, 0.1, 10, scan);
    for (int k = 0; k < DOFS; k++) options.dof[k].kind = WCUT_DOF_KIND_LOCKED;
    ck_assert_int_eq(fit(N), WCUT_DEGENERATE);
    assert_untouched();
    end_face();
}

TEST(a_fit_stopped_early_hands_out_the_last_step) {
    given_wavy();
    const double x[DOFS] = {4, -6, 3, 2 * DEG, -2 * DEG, 3 * DEG};
    given_scan(surface, N, 0.05, 0.1, 1, on_face);
    misplace(N, on_face, x, scan);
    options.max_iterations = 1;
    ck_assert_int_eq(fit(N), WCUT_NOT_CONVERGED);
    ck_assert_int_eq(found.iterations, 1);
    ck_assert_double_lt(found.rms, found.rms_before);
    end_face();
}

TEST(no_memory_is_told_at_every_allocation) {
    given_wavy();
    options.coarse = 1;
    given_scan(surface, N, 0, 0.1, 10, scan);
    EACH_FAILED_ALLOCATION_BY(7, fit(N), (assert_untouched(), true));
    end_face();
}
