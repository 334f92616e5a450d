/* Calibration tables in, force_law.json out, and its blocks in a job. */
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/calibration.h>
#include <wirecut/calibration_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/process/job.h"
#include "test.h"

#define HEADER "heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg"
static const char *const sound = "# by hand\n" HEADER
                                 ",mass\n71,38.2,500,32.937,9.35,1\n85,81.8,300,55.211,6.37,2\n"
                                 "66,29.4,400,35.904,5.04,1\n77,46.1,500,71.546,5.29,0.5\n66,30.6,400,31.430,6.32,1\n";
static wcut_test_cut *cut;
static int cuts;
static wcut_error error;

static wcut_status read_text(const char *text, const char *weight) {
    char path[64];
    snprintf(path, sizeof path, "test_force_law_write.%ld.csv", (long)getpid());
    FILE *file = fopen(path, "wb");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    fclose(file);
    wcut_test_cut_destroy(cut);
    cut = NULL;
    cuts = 999;
    wcut_status status = wcut_calibration_table_read(path, weight, &cuts, &cut, &error);
    remove(path);
    return status;
}

static void refused(const char *text, const char *weight, const char *words) {
    ck_assert_int_eq(read_text(text, weight), WCUT_BAD_FORMAT);
    ck_assert(cut == NULL && cuts == 999);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
}

TEST(a_table_is_read_in_the_units_of_the_api) {
    ck_assert_int_eq(read_text(sound, NULL), WCUT_OK);
    ck_assert_int_eq(cuts, 5);
    ck_assert(cut[1].heat == 85 && cut[1].speed == 81.8 && cut[1].engaged == 300 && cut[1].tension_a == 55.211);
    ck_assert(cut[1].tension_b == cut[1].tension_a && cut[1].alpha_b == cut[1].alpha_a && cut[1].weight == 1);
    ck_assert_double_eq_tol(cut[1].alpha_a, 6.37 * acos(-1) / 180, 1e-15);
    ck_assert_int_eq(cut[1].line, 4);
    ck_assert_int_eq(read_text(sound, "mass"), WCUT_OK);
    ck_assert(cut[1].weight == 2 && cut[3].weight == 0.5);
    ck_assert_int_eq(read_text(HEADER "\n", NULL), WCUT_OK);
    ck_assert_int_eq(cuts, 0);
    wcut_test_cut_destroy(cut);
    cut = NULL;
}

TEST(a_table_that_breaks_its_format_is_refused_with_its_line) {
    refused("heat_W_per_m,speed_m_s,engaged_mm,tension_N\n1,2,3,4\n", NULL,
            "missing speed_mm_s (found speed_m_s: another unit or spelling), alpha_deg");
    refused(HEADER "\n60,20,400,10,5\n60,,400,10,5\n", NULL, "line 3: speed_mm_s: found a missing value");
    refused(HEADER "\n60,20,400,-1,5\n", NULL, "line 2: tension_N: found a number that is not positive");
    refused(HEADER "\n60,20,400,10,-90\n", NULL, "line 2: alpha_deg: found an angle of 90 deg or more");
    refused(HEADER "\n60,20,x,10,5\n", NULL, "line 2, column 7 (engaged_mm): found x");
    refused(HEADER "\n60,20,400,10,5\n", "mass", "mass: found no such column");
    refused(HEADER ",mass\n60,20,400,10,5,\n", "mass", "line 2: mass: found no positive weight");
}

TEST(a_missing_table_bad_arguments_and_memory_leave_the_output_alone) {
    int n = 999;
    wcut_test_cut *found = (wcut_test_cut *)&error;
    ck_assert_int_eq(wcut_calibration_table_read("no/such.csv", NULL, &n, &found, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_calibration_table_read(NULL, NULL, &n, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_calibration_table_read("a.csv", NULL, NULL, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_calibration_table_read("a.csv", NULL, &n, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(n == 999 && found == (wcut_test_cut *)&error);
    EACH_FAILED_ALLOCATION(read_text(sound, NULL), !cut);
    wcut_test_cut_destroy(cut);
    cut = NULL;
    wcut_test_cut_destroy(NULL);
}

static wcut_calibration fit;
static wcut_calibration_point point[5];

static void given_a_calibration(void) {
    ck_assert_int_eq(read_text(sound, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_calibration_fit(cuts, cut, NULL, &fit, point, &error), WCUT_OK);
}

/* a job around a process block */
static char *job_with(const json_t *process) {
    json_t *whole = json_loads(
        "{\"format\": \"wirecut-job/1\", \"name\": \"n\", \"block\": {\"size_mm\": [400, 800, 300]},"
        "\"wire\": {\"diameter_mm\": 0.15, \"nodes\": 21, \"length_mm\": 650},"
        "\"process\": {\"heat_W_per_m\": 60, \"tension_N\": 2},"
        "\"path\": {\"mount_a_mm\": [[-100, 0, 150], [-100, 800, 150]],"
        "\"mount_b_mm\": [[500, 0, 150], [500, 800, 150]]}}",
        0, NULL);
    ck_assert_int_eq(json_object_update(json_object_get(whole, "process"), (json_t *)process), 0);
    char *text = json_dumps(whole, JSON_REAL_PRECISION(17));
    json_decref(whole);
    return text;
}

TEST(the_process_block_drops_into_a_job_bit_for_bit) {
    given_a_calibration();
    char *text = NULL;
    ck_assert_int_eq(wcut_force_law_print(cuts, cut, NULL, &fit, point, &text), WCUT_OK);
    json_t *root = json_loads(text, JSON_REJECT_DUPLICATES, NULL);
    ck_assert_ptr_nonnull(root);
    char *job_text = job_with(json_object_get(root, "process"));
    wcut_job *job = NULL;
    ck_assert_msg(wcut_job_parse(job_text, strlen(job_text), "job", &job, &error) == WCUT_OK, "%s", error.text);
    ck_assert(job->force_law.a == fit.force.a && job->force_law.b == fit.force.b);
    ck_assert(fit.tension_fitted && job->tension_law.a == fit.tension.a && job->tension_law.c == fit.tension.c);
    wcut_job_destroy(job);
    free(job_text);
    json_decref(root);
    free(text);
}

TEST(the_file_holds_errors_covariance_range_and_every_residual) {
    given_a_calibration();
    const char *path = "test_force_law_write.json";
    ck_assert_int_eq(wcut_force_law_write(cuts, cut, NULL, &fit, point, path, &error), WCUT_OK);
    json_t *root = json_load_file(path, JSON_REJECT_DUPLICATES, NULL);
    remove(path);
    ck_assert_ptr_nonnull(root);
    const json_t *law = json_object_get(root, "force_law"), *range = json_object_get(law, "range_J_per_m2");
    ck_assert(json_number_value(json_object_get(law, "a_N_per_mm")) == fit.force.a);
    ck_assert(json_number_value(json_object_get(json_object_get(law, "standard_error"), "b_m2_per_J")) ==
              fit.force.standard_error[1]);
    const json_t *covariance = json_object_get(law, "covariance");
    ck_assert(json_array_size(covariance) == 2 && json_array_size(json_array_get(covariance, 0)) == 2);
    ck_assert(json_number_value(json_array_get(json_array_get(covariance, 0), 1)) == fit.force.covariance[1]);
    ck_assert(json_number_value(json_array_get(range, 1)) == fit.q_eff_high);
    ck_assert_int_eq((int)json_array_size(json_object_get(root, "residuals")), 5);
    const json_t *last = json_array_get(json_object_get(root, "residuals"), 4);
    ck_assert(json_number_value(json_object_get(json_object_get(last, "force"), "residual")) ==
              point[4].force.residual);
    ck_assert_int_eq((int)json_integer_value(json_object_get(last, "line")), 7);
    json_decref(root);
}

TEST(what_cannot_be_written_is_refused) {
    given_a_calibration();
    char *text = (char *)&error;
    ck_assert_int_eq(wcut_force_law_print(0, cut, NULL, &fit, point, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_print(cuts, NULL, NULL, &fit, point, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_print(cuts, cut, NULL, &fit, point, NULL), WCUT_BAD_ARGUMENT);
    wcut_calibration broken = fit;
    broken.force.covariance[4] = NAN;
    ck_assert_int_eq(wcut_force_law_print(cuts, cut, NULL, &broken, point, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_write(cuts, cut, NULL, &fit, point, NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_force_law_write(cuts, cut, NULL, &fit, point, "no/such/f.json", &error), WCUT_NOT_WRITTEN);
    wcut_alloc_fail_at(1);
    wcut_status status = wcut_force_law_print(cuts, cut, NULL, &fit, point, &text);
    wcut_alloc_fail_at(0);
    ck_assert_int_eq(status, WCUT_NO_MEMORY);
    ck_assert(text == (char *)&error);
    wcut_test_cut_destroy(cut);
    cut = NULL;
}
