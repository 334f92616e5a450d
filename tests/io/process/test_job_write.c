/* Job files out: what was written reads back the same to the last bit, and nothing else is written. */
#include <locale.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "io/process/job.h"
#include "test.h"

static wcut_job *job, *again;
static wcut_error error;

static void given_job(const char *text) {
    ck_assert_int_eq(wcut_job_parse(text, strlen(text), "given", &job, &error), WCUT_OK);
    enter_folder();
}

static void forget(void) {
    wcut_job_destroy(job);
    wcut_job_destroy(again);
    job = again = NULL;
    leave_folder();
}

static void write_and_read(void) {
    wcut_job_destroy(again);
    again = NULL;
    error.text[0] = '\0';
    ck_assert_msg(wcut_job_write(job, "job.json", &error) == WCUT_OK, "%s", error.text);
    ck_assert_msg(wcut_job_read("job.json", &again, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(count_entries("."), 1);
}

static void same(const void *a, const void *b, size_t size) { ck_assert(a && b && memcmp(a, b, size) == 0); }

TEST(a_path_job_comes_back_to_the_last_bit) {
    given_job(given_path_job);
    job->mount_a[1] = (wcut_vec3){-1.0 / 3, 5e-324, 1.7976931348623157e308};
    job->mount_b[1] = (wcut_vec3){0.1 + 0.2, -0.0, 123456789012345680.0};
    job->wire_density = 7150.125;
    job->wire_cold_strength = 810.5, job->wire_hot_strength = 100.25, job->wire_emissivity = 0.875;
    write_and_read();
    ck_assert_double_eq(again->wire_density, 7150.125);
    ck_assert(again->wire_cold_strength == 810.5 && again->wire_hot_strength == 100.25);
    ck_assert_double_eq(again->wire_emissivity, 0.875);
    same(job->mount_a, again->mount_a, 3 * sizeof(wcut_vec3));
    same(job->mount_b, again->mount_b, 3 * sizeof(wcut_vec3));
    same(job->dither, again->dither, sizeof *job->dither);
    same(job->heat_step, again->heat_step, 2 * sizeof *job->heat_step);
    same(&job->block_size, &again->block_size, sizeof job->block_size);
    same(&job->force_law, &again->force_law, sizeof job->force_law);
    same(&job->tension_law, &again->tension_law, sizeof job->tension_law);
    ck_assert(again->nodes == 121 && again->wire_length == 620.25 && again->wire_diameter == 0.15);
    ck_assert(again->heat == 60 && again->tension == 2 && again->speed_max == 80 && again->speed_min == 0.5);
    ck_assert(again->kerf_width == 0.8 && again->kerf_per_q == 1.6e-4);
    ck_assert_str_eq(again->foam_material, "EPS 15 kg/m3");
    ck_assert_str_eq(again->wire_material, "Kanthal A");
    forget();
}

TEST(a_design_job_comes_back_to_the_last_bit) {
    given_job(given_design_job);
    write_and_read();
    ck_assert(again->mode == WCUT_MODE_DESIGN && again->stations == 41 && again->clearance == 80);
    const wcut_curve *a = job->edge_a, *b = again->edge_a;
    ck_assert(a->degree == b->degree && a->control_count == b->control_count && !b->weights);
    same(a->knots, b->knots, sizeof(double) * (size_t)(a->control_count + a->degree + 1));
    same(a->control, b->control, sizeof(wcut_vec3) * (size_t)a->control_count);
    same(job->edge_b->weights, again->edge_b->weights, 3 * sizeof(double));
    same(job->extra_u, again->extra_u, 3 * sizeof(double));
    same(job->extra_length, again->extra_length, 3 * sizeof(double));
    forget();
}

TEST(every_effect_comes_back_to_the_last_bit) {
    given_job(given_path_job);
    free(job->effect);
    job->effect = wcut_alloc(WCUT_EFFECT_COUNT, sizeof *job->effect);
    ck_assert_ptr_nonnull(job->effect);
    job->effect_count = WCUT_EFFECT_COUNT;
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) {
        const wcut_effect_info *info = wcut_effect_view((wcut_effect_kind)k);
        job->effect[k] = wcut_effect_choose((wcut_effect_kind)k, info->choice_key ? 1 : 0);
        for (const wcut_effect_parameter *p = wcut_effect_parameters(&job->effect[k]); p->key; p++)
            for (int c = 0; c < p->size; c++) job->effect[k].value[p->at + c] = p->low + (p->high - p->low) / (3 + c);
    }
    write_and_read();
    ck_assert_int_eq(again->effect_count, WCUT_EFFECT_COUNT);
    for (int k = 0; k < WCUT_EFFECT_COUNT; k++) {
        ck_assert_int_eq(again->effect[k].kind, k);
        ck_assert_int_eq(again->effect[k].choice, job->effect[k].choice);
        same(again->effect[k].value, job->effect[k].value, sizeof job->effect[k].value);
    }
    forget();
}

TEST(every_empirical_term_comes_back_with_its_own_parameters) {
    const wcut_effect_info *info = wcut_effect_view(WCUT_EFFECT_EMPIRICAL_FORCE);
    for (int term = 0; info->choice[term]; term++) {
        given_job(given_path_job);
        free(job->effect);
        job->effect = wcut_alloc(1, sizeof *job->effect);
        ck_assert_ptr_nonnull(job->effect);
        job->effect_count = 1;
        job->effect[0] = wcut_effect_choose(WCUT_EFFECT_EMPIRICAL_FORCE, term);
        for (const wcut_effect_parameter *p = wcut_effect_parameters(job->effect); p->key; p++)
            job->effect[0].value[p->at] = p->low + (p->high - p->low) / 3;
        write_and_read();
        ck_assert_int_eq(again->effect[0].choice, term);
        same(again->effect[0].value, job->effect[0].value, sizeof job->effect[0].value);
        forget();
    }
}

TEST(an_effect_that_the_reader_would_refuse_is_not_written) {
    given_job(given_path_job);
    free(job->effect);
    job->effect = wcut_alloc(1, sizeof *job->effect);
    ck_assert_ptr_nonnull(job->effect);
    job->effect_count = 1;
    *job->effect = (wcut_effect){.kind = WCUT_EFFECT_WIRE_THERMAL_LAG, .value = {-1, 10, 0.059, 0.0079}};
    ck_assert_int_eq(wcut_job_write(job, "job.json", &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "effects[0].time_constant_s (wire_thermal_lag): found -1"));
    job->effect->kind = WCUT_EFFECT_COUNT;
    ck_assert_int_eq(wcut_job_write(job, "job.json", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(count_entries("."), 0);
    forget();
}

TEST(numbers_are_the_shortest_and_know_no_locale) {
    given_job(given_path_job);
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8") != NULL, "the tests' own locale is missing");
    job->heat = 0.1;
    write_and_read();
    size_t length;
    char *text = read_back("job.json", &length);
    ck_assert_ptr_nonnull(strstr(text, "\"heat_W_per_m\": 0.1,"));
    ck_assert_ptr_nonnull(strstr(text, "[510, 3.0000000000000004, 150]"));
    ck_assert_ptr_null(strstr(text, "0,1"));
    free(text);
    forget();
}

TEST(hostile_names_come_back_as_they_are) {
    static const char name[] = "</script>\"\\ {\"a\": 1} Fl\xc3\xbcgel \xf0\x9f\x94\xa5 %s%n";
    given_job(given_path_job);
    free(job->name);
    job->name = wcut_copy_text(name);
    write_and_read();
    ck_assert_str_eq(again->name, name);
    forget();
}

/* refused, and the file that was there is as it was */
static void refused(const char *words) {
    write_file("job.json", "the old one");
    error = (wcut_error){WCUT_OK, ""};
    ck_assert_int_eq(wcut_job_write(job, "job.json", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(error.status, WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s", error.text);
    file_holds("job.json", "the old one");
    ck_assert_int_eq(count_entries("."), 1);
}

TEST(a_job_that_the_reader_would_refuse_is_not_written) {
    given_job(given_path_job);
    job->nodes = 2;
    refused("job.json: $.wire.nodes: found 2, expected an integer");
    job->nodes = 121;
    job->mount_a[1].x = NAN;
    refused("$.path.mount_a_mm[1][0]: found null, expected a number");
    job->mount_a[1].x = INFINITY;
    refused("$.path.mount_a_mm[1][0]: found null, expected a number");
    job->mount_a[1].x = 0;
    job->name[0] = '\x01';
    refused("expected a text without control characters");
    job->name[0] = '\xff'; /* no UTF-8 */
    refused("unable to decode byte 0xff");
    free(job->mount_b);
    job->mount_b = NULL;
    refused("without its name, path or design");
    ck_assert_int_eq(wcut_job_write(NULL, "job.json", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_write(job, NULL, NULL), WCUT_BAD_ARGUMENT);
    forget();
}

TEST(a_place_that_cannot_be_written_is_named) {
    given_job(given_path_job);
    ck_assert_int_eq(wcut_job_write(job, "none/job.json", &error), WCUT_NOT_WRITTEN);
    ck_assert_str_eq(error.text, "none/job.json: not written: No such file or directory");
    forget();
}

TEST(running_out_of_memory_anywhere_writes_nothing) {
    given_job(given_design_job);
    EACH_FAILED_ALLOCATION(wcut_job_write(job, "job.json", &error), count_entries(".") == 0);
    ck_assert_int_eq(count_entries("."), 1);
    forget();
}
