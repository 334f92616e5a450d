/* labels: unit
   mould.json, and the kerf of a history: what they say, what they refuse. */
#include "solid/cuts.h"

#include <unistd.h>
#include <wirecut/job.h>
#include <wirecut/mould_file.h>

#include "test.h"

static char *slurp(const char *path) {
    FILE *f = fopen(path, "rb");
    ck_assert_ptr_nonnull(f);
    char *text = calloc(1, 100000);
    ck_assert_ptr_nonnull(text);
    ck_assert_uint_gt(fread(text, 1, 99999, f), 0);
    ck_assert_int_eq(fclose(f), 0);
    return text;
}

TEST(the_figures_are_printed_and_written_alike_with_null_for_what_is_not_known) {
    wcut_surface *s = cut_of(cut_leaving);
    wcut_mould *m = cut_divide(s, cut_block, NULL);
    char *text = NULL;
    ck_assert_int_eq(wcut_mould_print(m, "a \"quoted\" name", &text), WCUT_OK);
    static const char *const part[] = {"\"format\": \"wirecut-mould/1\"",
                                       "\"job\": \"a \\\"quoted\\\" name\"",
                                       "\"closed\": true",
                                       "\"oriented\": true",
                                       "\"self_intersections\": 0",
                                       "\"wall_mm\": {\"min\": null, \"at_mm\": [null, null, null], \"held\": true}",
                                       "\"pull\": [0, 0, 1]",
                                       "\"step\": \"not written: made by booleans",
                                       "\"made_by\": \"booleans\"",
                                       "\"exact_faces\": 0"};
    for (size_t k = 0; k < sizeof part / sizeof *part; k++)
        ck_assert_msg(strstr(text, part[k]) != NULL, "expected %s in: %s", part[k], text);
    wcut_error error = {.text = ""};
    ck_assert_int_eq(wcut_mould_write(m, "a \"quoted\" name", "mould_test.json", &error), WCUT_OK);
    char *written = slurp("mould_test.json");
    ck_assert_str_eq(text, written);
    free(written);
    free(text);
    ck_assert_int_eq(unlink("mould_test.json"), 0);

    char *const mark = (char *)&cut_block, *kept = mark;
    ck_assert_int_eq(wcut_mould_print(NULL, "name", &kept), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mould_print(m, NULL, &kept), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mould_print(m, "name", NULL), WCUT_BAD_ARGUMENT);
    ck_assert(kept == mark);
    ck_assert_int_eq(wcut_mould_write(m, "name", NULL, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mould_write(m, "name", "no/such/folder/mould.json", &error), WCUT_NOT_WRITTEN);
    ck_assert(error.status == WCUT_NOT_WRITTEN && strstr(error.text, "no/such/folder"));
    wcut_mould_destroy(m);
    wcut_surface_destroy(s);
}

/* how often a word stands in a file */
static int times(const char *path, const char *word) {
    FILE *f = fopen(path, "rb");
    ck_assert_ptr_nonnull(f);
    char *text = calloc(1, 4000000);
    ck_assert_ptr_nonnull(text);
    ck_assert_uint_gt(fread(text, 1, 3999999, f), 0);
    ck_assert_int_eq(fclose(f), 0);
    int count = 0;
    for (const char *at = text; (at = strstr(at, word)) != NULL; at++) count++;
    free(text);
    return count;
}

TEST(parts_are_written_with_colours_and_names_and_what_is_missing_is_refused) {
    wcut_surface *s = cut_of(cut_level);
    wcut_mould_options o = wcut_mould_default();
    o.lug_radius = 12, o.lug_height = 10;
    wcut_mould *m = cut_divide(s, cut_block, &o);
    wcut_error error = {.text = ""};
    const wcut_mould_part lower = WCUT_MOULD_PART_LOWER, upper = WCUT_MOULD_PART_UPPER;
    ck_assert_int_eq(wcut_mould_write_step(m, "panel", lower, WCUT_STEP_SCHEMA_AP214, "a.step", &error), WCUT_OK);

    /* a style for the solid and each of its faces, three colours, faces by their names */
    const int faces = m->lower.brep->face_count;
    ck_assert_int_eq(times("a.step", "=STYLED_ITEM("), 1 + faces);
    ck_assert_int_eq(times("a.step", "COLOUR_RGB("), 3);
    ck_assert_int_eq(times("a.step", "ADVANCED_FACE('cut face'"), 1);
    ck_assert_int_eq(times("a.step", "ADVANCED_FACE('lug'"), 15);
    ck_assert_int_eq(times("a.step", "ADVANCED_FACE('key flank'"), 6);
    ck_assert_int_eq(times("a.step", "MANIFOLD_SOLID_BREP('panel lower'"), 1);
    ck_assert_int_eq(unlink("a.step"), 0);
    ck_assert_int_eq(wcut_mould_write_3mf(m, "panel", lower | upper, 1, "a.3mf", &error), WCUT_OK);
    ck_assert_int_eq(access("a.3mf", R_OK), 0);
    ck_assert_int_eq(unlink("a.3mf"), 0);

    /* parts that are not there, sums where one is meant, no part */
    const unsigned bad[] = {0, 4, 8, 16, 1 | 4};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        ck_assert_int_eq(wcut_mould_write_3mf(m, "panel", bad[k], 0, "a.3mf", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mould_write_step(m, "panel", 3, WCUT_STEP_SCHEMA_AP214, "a.step", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_mould_write_step(m, NULL, lower, WCUT_STEP_SCHEMA_AP214, "a.step", &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_int_ne(access("a.3mf", F_OK), 0);
    ck_assert_int_ne(access("a.step", F_OK), 0);
    wcut_mould_destroy(m);

    /* halves by booleans are triangles */
    wcut_surface *leaving = cut_of(cut_leaving);
    m = cut_divide(leaving, cut_block, NULL);
    ck_assert_int_eq(wcut_mould_write_step(m, "panel", lower, WCUT_STEP_SCHEMA_AP214, "a.step", &error),
                     WCUT_BAD_ARGUMENT);
    ck_assert_msg(strstr(error.text, "exact faces") != NULL, "%s", error.text);
    wcut_mould_destroy(m);
    wcut_surface_destroy(leaving);
    wcut_surface_destroy(s);
}

TEST(the_kerf_of_a_history_grows_with_the_heat_left_per_area) {
    enum { STATIONS = 3, NODES = 2 };
    wcut_history_row row[STATIONS] = {{.time = 0}, {.time = 2}, {.time = 5}};
    double speed[STATIONS * NODES] = {0, 0, 20, 40, 10, 0.01}, field[STATIONS * NODES];
    wcut_heat_step step = {.from = 4, .to = 6, .factor = 0.5};
    wcut_history h = {.stations = STATIONS, .nodes = NODES, .row = row, .speed = speed};
    wcut_job *job = NULL;
    ck_assert_int_eq(wcut_job_create(&job), WCUT_OK);
    job->heat = 60, job->kerf_width = 0.8, job->kerf_per_q = 1e-4, job->speed_min = 0.1;
    job->heat_step_count = 1, job->heat_step = &step;
    ck_assert_int_eq(wcut_history_kerf(job, &h, field), WCUT_OK);
    /* 60 W/m at 20 mm/s leave 3000 J/m^2, 0.3 mm; the last station has half the heat, its last node the least speed */
    const double wanted[STATIONS * NODES] = {1.1, 0.95, 1.1, 0.95, 1.1, 0.8 + 30};
    for (int k = 0; k < STATIONS * NODES; k++) ck_assert_double_le(fabs(field[k] - wanted[k]), 1e-12);

    for (int k = 0; k < STATIONS * NODES; k++) field[k] = 999;
    speed[3] = NAN;
    ck_assert_int_eq(wcut_history_kerf(job, &h, field), WCUT_BAD_ARGUMENT);
    speed[3] = 40;
    h.stations = 1;
    ck_assert_int_eq(wcut_history_kerf(job, &h, field), WCUT_BAD_ARGUMENT);
    h.stations = STATIONS;
    job->kerf_width = -1;
    ck_assert_int_eq(wcut_history_kerf(job, &h, field), WCUT_BAD_ARGUMENT);
    job->kerf_width = 0.8, job->kerf_per_q = NAN;
    ck_assert_int_eq(wcut_history_kerf(job, &h, field), WCUT_BAD_ARGUMENT);
    job->kerf_per_q = 0, job->heat = 0;
    ck_assert_int_eq(wcut_history_kerf(job, &h, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_kerf(NULL, &h, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_kerf(job, NULL, field), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_kerf(job, &h, NULL), WCUT_BAD_ARGUMENT);
    for (int k = 0; k < STATIONS * NODES; k++) ck_assert_double_eq(field[k], 999);
    job->heat_step_count = 0, job->heat_step = NULL;
    wcut_job_destroy(job);
}
