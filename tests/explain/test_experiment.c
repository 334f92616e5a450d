/* The next experiment: what only an excitation tells apart is told by one, place from time by the way back, a face by
   another heat; what nothing tells apart is said so. labels: unit property plain */
#include "cut/setup.h"
#include "explain/experiment.h"

#include "base/alloc.h"
#include "cut/cuts.h"
#include "explain/identify.h"
#include "test.h"

static wcut_job *short_job(void) {
    wcut_job *job = straight_job(400, 60, 560, 31, 120, -20, 700);
    job->block_size = vec3(400, 600, 300);
    ck_assert(wcut_job_name(job, "short"));
    job->speed_max = 60;
    return job;
}

static wcut_effect sized(wcut_effect_kind kind, double size) {
    wcut_effect e = wcut_effect_default(kind);
    e.value[0] = size;
    return e;
}

static double chosen(const wcut_job *job, wcut_effect a, wcut_effect b, wcut_job **best, char *reason) {
    double separation = 999;
    wcut_error error = {0};
    const wcut_status status = wcut_experiment_choose(job, 1, &a, 1, &b, NULL, best, &separation, reason, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return separation;
}

TEST(a_thermal_lag_and_a_late_clock_are_told_apart_by_an_excitation) {
    wcut_job *job = short_job(), *best = NULL;
    char reason[WCUT_DIAGNOSIS_TEXT];
    const double s =
        chosen(job, sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.3), sized(WCUT_EFFECT_CLOCK_OFFSET, 0.2), &best, reason);
    ck_assert_msg(s > 5 && (best->dither_count > 0 || best->heat_step_count > 0), "%g: %s", s, reason);
    ck_assert_ptr_nonnull(strstr(reason, "wire thermal lag from clock offset"));
    ck_assert_int_eq(best->effect_count, 0);
    ck_assert_int_eq(best->nodes, job->nodes);
    wcut_job_destroy(best);
    wcut_job_destroy(job);
}

TEST(a_gradient_along_the_feed_and_a_fouling_wire_are_told_apart_by_the_way_back) {
    wcut_job *job = short_job(), *best = NULL;
    char reason[WCUT_DIAGNOSIS_TEXT];
    wcut_effect along = sized(WCUT_EFFECT_FOAM_DENSITY_GRADIENT, 0.12), fouling = sized(WCUT_EFFECT_WIRE_FOULING, 1.2);
    along.choice = 1;            /* y */
    fouling.value[1] = 10 * 600; /* hardly bent over a cut: 1 - exp(-0.1) of it */
    const double s = chosen(job, along, fouling, &best, reason);
    ck_assert_msg(s > 5 && strstr(best->name, "backwards"), "%g: %s: %s", s, best->name, reason);
    ck_assert_double_eq(best->mount_a[0].y, job->mount_a[job->stations - 1].y);
    wcut_job_destroy(best);
    wcut_job_destroy(job);
}

TEST(a_growing_kerf_and_a_shifted_scan_are_told_apart_by_a_scan_at_other_heats) {
    wcut_job *job = short_job(), *best = NULL;
    char reason[WCUT_DIAGNOSIS_TEXT];
    wcut_effect shift = wcut_effect_default(WCUT_EFFECT_SCAN_OFFSET);
    shift.value[2] = -0.3;
    const double s = chosen(job, sized(WCUT_EFFECT_KERF_GROWTH, 1.6e-4), shift, &best, reason);
    ck_assert_msg(s > 0.5 && strstr(reason, "scanned"), "%g: %s", s, reason);
    wcut_job_destroy(best);
    wcut_job_destroy(job);
}

TEST(the_same_explanation_twice_is_told_apart_by_nothing_and_said_so) {
    wcut_job *job = short_job(), *best = NULL;
    char reason[WCUT_DIAGNOSIS_TEXT];
    const wcut_effect lag = sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.4);
    ck_assert_double_eq(chosen(job, lag, lag, &best, reason), 0);
    ck_assert_ptr_eq(strstr(reason, "None of "), reason);
    wcut_job_destroy(best);
    wcut_job_destroy(job);
}

TEST(what_a_refit_of_the_plain_model_explains_does_not_count) {
    wcut_job *job = short_job(), *best = NULL;
    char reason[WCUT_DIAGNOSIS_TEXT];
    double weak = 0, strong = 0;
    const wcut_effect level = sized(WCUT_EFFECT_RATE_DEPENDENCE, 0.004), gain = sized(WCUT_EFFECT_TENSION_GAIN, 0.5);
    ck_assert_int_eq(wcut_experiment_choose(job, 1, &level, 0, NULL, NULL, &best, &weak, reason, NULL), WCUT_OK);
    ck_assert_ptr_nonnull(strstr(reason, "the plain model"));
    wcut_job_destroy(best);
    ck_assert_int_eq(wcut_experiment_choose(job, 1, &gain, 0, NULL, NULL, &best, &strong, reason, NULL), WCUT_OK);
    ck_assert_msg(weak < 3 && strong > 30, "%g %g", weak, strong);
    wcut_job_destroy(best);
    wcut_job_destroy(job);
}

TEST(what_cannot_be_run_is_refused_and_nothing_is_written) {
    wcut_job *job = short_job(), *best = job;
    char reason[WCUT_DIAGNOSIS_TEXT] = "as it was";
    double s = 999;
    wcut_error error = {0};
    wcut_effect lag = sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.4);
    ck_assert_int_eq(wcut_experiment_choose(NULL, 1, &lag, 0, NULL, NULL, &best, &s, reason, &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_experiment_choose(job, 1, NULL, 0, NULL, NULL, &best, &s, reason, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_experiment_choose(job, 1, &lag, 0, NULL, NULL, NULL, &s, reason, &error), WCUT_BAD_ARGUMENT);
    lag.value[0] = -1;
    ck_assert_int_eq(wcut_experiment_choose(job, 1, &lag, 0, NULL, NULL, &best, &s, reason, &error), WCUT_BAD_ARGUMENT);
    lag.value[0] = 0.4;
    for (int j = 0; j < job->stations; j++) job->mount_a[j].z += 1000, job->mount_b[j].z += 1000;
    ck_assert_int_eq(wcut_experiment_choose(job, 1, &lag, 0, NULL, NULL, &best, &s, reason, &error), WCUT_DEGENERATE);
    ck_assert_ptr_eq(best, job);
    ck_assert_double_eq(s, 999);
    ck_assert_str_eq(reason, "as it was");
    wcut_job_destroy(job);
}

TEST(where_memory_ends_nothing_is_written) {
    wcut_job *job = short_job(), *best = NULL;
    char reason[WCUT_DIAGNOSIS_TEXT];
    double s = 999;
    const wcut_effect lag = sized(WCUT_EFFECT_WIRE_THERMAL_LAG, 0.4);
    job->stations = 20;
    for (int j = 0; j < job->stations; j++) job->mount_a[j].y = job->mount_b[j].y = -20 + 36.0 * j;
    EACH_FAILED_ALLOCATION_BY(127, wcut_experiment_choose(job, 1, &lag, 0, NULL, NULL, &best, &s, reason, NULL),
                              !best && s == 999);
    wcut_job_destroy(best);
    wcut_job_destroy(job);
}
