/* A job in memory: defaults, another number of stations on the same path, its programme. */
#include <float.h>
#include <math.h>
#include <string.h>
#include <wirecut/job.h>

#include "base/alloc.h"
#include "test.h"

static wcut_job *job;

/* mount A goes 3 mm then 1 mm, mount B 1 mm then 3 mm: the mean way is 2 and 2 */
static void given_a_path(void) {
    static const wcut_vec3 a[] = {{0, 0, 0}, {0, 3, 0}, {0, 4, 0}}, b[] = {{9, 0, 5}, {9, 1, 5}, {9, 1, 8}};
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->stations = 3;
    job->mount_a = wcut_copy(a, 3, sizeof *a);
    job->mount_b = wcut_copy(b, 3, sizeof *b);
}

static void forget(void) {
    wcut_job_destroy(job);
    job = NULL;
}

TEST(a_new_job_has_the_defaults_of_every_optional_part) {
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    ck_assert_str_eq(job->name, "");
    ck_assert(job->speed_max == 100 && job->speed_min == 0.1 && job->kerf_width == 0 && job->tension_law.a == 0);
    ck_assert(job->mode == WCUT_MODE_PATH && !job->mount_a && !job->edge_a && job->dither_count == 0);
    forget();
    wcut_job_destroy(NULL);
    ck_assert_int_eq(wcut_job_create(NULL), WCUT_BAD_ARGUMENT);
}

/* a step holds from its beginning up to its end; a sine of period 4 s and phase 90 deg is at its crest at 0 s */
TEST(the_programme_says_heat_and_pace_at_any_time) {
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->heat = 60;
    ck_assert(wcut_job_heat_eval(job, 3) == 60 && wcut_job_pace_eval(job, 3) == 1);
    static const wcut_heat_step step[] = {{2, 4, 0.9}, {4, 5, 1.1}};
    static const wcut_dither dither[] = {{0.05, 4, 1.5707963267948966}, {0.02, 8, 0}};
    job->heat_step = wcut_copy(step, 2, sizeof *step), job->heat_step_count = 2;
    job->dither = wcut_copy(dither, 2, sizeof *dither), job->dither_count = 2;
    static const double time[] = {-1, 1.999, 2, 3.999, 4, 5}, heat[] = {60, 60, 54, 54, 66, 60};
    for (int k = 0; k < 6; k++) ck_assert_double_eq_tol(wcut_job_heat_eval(job, time[k]), heat[k], 1e-12);
    ck_assert_double_eq_tol(wcut_job_pace_eval(job, 0), 1.05, 1e-15);
    ck_assert_double_eq_tol(wcut_job_pace_eval(job, 2), 1 - 0.05 + 0.02, 1e-15);
    forget();
}

TEST(stations_lie_at_equal_steps_of_the_mean_way) {
    given_a_path();
    ck_assert_int_eq(wcut_job_resample(job, 5), WCUT_OK);
    ck_assert_int_eq(job->stations, 5);
    static const double a_y[] = {0, 1.5, 3, 3.5, 4}, b_y[] = {0, 0.5, 1, 1, 1}, b_z[] = {5, 5, 5, 6.5, 8};
    for (int j = 0; j < 5; j++) {
        ck_assert_double_eq_tol(job->mount_a[j].y, a_y[j], 1e-14);
        ck_assert_double_eq_tol(job->mount_b[j].y, b_y[j], 1e-14);
        ck_assert_double_eq_tol(job->mount_b[j].z, b_z[j], 1e-14);
        ck_assert(job->mount_a[j].x == 0 && job->mount_b[j].x == 9);
    }
    forget();
}

TEST(both_ends_stay_bit_for_bit) {
    for (int m = 2; m < 400; m++) {
        given_a_path();
        job->mount_a[2].y = 4.1 / 3;
        ck_assert_int_eq(wcut_job_resample(job, m), WCUT_OK);
        ck_assert(job->mount_a[m - 1].y == 4.1 / 3 && job->mount_b[m - 1].z == 8 && job->mount_b[0].z == 5);
        forget();
    }
}

TEST(a_pause_in_the_path_is_passed_over) {
    given_a_path();
    job->mount_a[1] = job->mount_a[0];
    job->mount_b[1] = job->mount_b[0];
    ck_assert_int_eq(wcut_job_resample(job, 3), WCUT_OK);
    ck_assert_double_eq_tol(job->mount_a[1].y, 2, 1e-14);
    forget();
}

TEST(in_design_mode_only_the_count_changes) {
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->mode = WCUT_MODE_DESIGN;
    ck_assert_int_eq(wcut_job_resample(job, 77), WCUT_OK);
    ck_assert(job->stations == 77 && !job->mount_a);
    forget();
}

static void refused(int stations, wcut_status status) {
    const wcut_vec3 *a = job->mount_a, *b = job->mount_b;
    ck_assert_int_eq(wcut_job_resample(job, stations), status);
    ck_assert(job->mount_a == a && job->mount_b == b && job->stations == 3);
}

TEST(what_cannot_be_resampled_leaves_the_job_as_it_was) {
    given_a_path();
    ck_assert_int_eq(wcut_job_resample(NULL, 5), WCUT_BAD_ARGUMENT);
    refused(1, WCUT_BAD_ARGUMENT);
    job->mount_a[1].y = NAN;
    refused(5, WCUT_BAD_ARGUMENT);
    job->mount_a[1].y = DBL_MAX;
    job->mount_a[2].y = -DBL_MAX;
    refused(5, WCUT_BAD_ARGUMENT); /* longer than a double can tell */
    for (int j = 0; j < 3; j++) job->mount_a[j] = job->mount_b[j] = (wcut_vec3){1, 2, 3};
    refused(5, WCUT_BAD_ARGUMENT); /* goes nowhere */
    forget();
}

TEST(running_out_of_memory_leaves_the_job_as_it_was) {
    wcut_job *none = NULL;
    FIRST_FAILED_ALLOCATIONS(2, wcut_job_create(&none), !none);
    given_a_path();
    for (long k = 1; k <= 3; k++) {
        wcut_alloc_fail_at(k);
        refused(5, WCUT_NO_MEMORY);
        wcut_alloc_fail_at(0);
    }
    forget();
}
