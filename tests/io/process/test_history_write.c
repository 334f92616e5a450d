/* Histories out and back in: path.csv row by row, history.vtp value by value, summary.json key by key. */
#include <jansson.h>
#include <locale.h>
#include <stddef.h>
#include <stdint.h>
#include <wirecut/write.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "io/process/job.h"
#include "test.h"

static wcut_history history;
static wcut_vec3 *a, *b;
static wcut_error error;

static void setup(int m, int n) {
    history = given_history(m, n);
    a = calloc((size_t)m, sizeof *a);
    b = calloc((size_t)m, sizeof *b);
    for (int j = 0; j < m; j++) {
        a[j] = (wcut_vec3){-110, j / 3.0, 150 + j / 7.0};
        b[j] = (wcut_vec3){510, j / 9.0, 150};
    }
    error = (wcut_error){WCUT_OK, ""};
    enter_folder();
}

static void teardown(void) {
    forget_history(&history);
    free(a);
    free(b);
    leave_folder();
}

static void fine(wcut_status status) { ck_assert_msg(status == WCUT_OK, "%s", error.text); }

/* ---- path.csv ---- */

static double degrees(double radians) { return radians * (180 / 3.14159265358979323846); }

static void check_csv_row(char *line, int j) {
    const wcut_history_row *r = &history.row[j], *moved = j ? r : &history.row[1];
    const double expected[] = {j,
                               r->time,
                               a[j].x,
                               a[j].y,
                               a[j].z,
                               b[j].x,
                               b[j].y,
                               b[j].z,
                               moved->speed_a,
                               moved->speed_b,
                               r->tension_a,
                               r->tension_b,
                               degrees(r->alpha_a),
                               degrees(r->beta_a),
                               degrees(r->alpha_b),
                               degrees(r->beta_b)};
    size_t k = 0;
    for (char *word = strtok(line, ","); word; word = strtok(NULL, ",")) {
        if (word[0] >= 'a' && word[0] <= 'z') {
            ck_assert_uint_eq(k, 2);
            ck_assert_str_eq(word, wcut_phase_name(r->phase));
            continue;
        }
        ck_assert_uint_lt(k, sizeof expected / sizeof *expected);
        ck_assert_double_eq(strtod(word, NULL), expected[k++]);
    }
    ck_assert_uint_eq(k, sizeof expected / sizeof *expected);
}

TEST(path_csv_has_the_columns_of_the_format_and_exact_numbers) {
    setup(17, 5);
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8") != NULL, "the tests' own locale is missing");
    fine(wcut_history_write_csv(&history, a, b, "path.csv", &error));
    ck_assert_ptr_nonnull(setlocale(LC_ALL, "C"));
    size_t length;
    char *text = read_back("path.csv", &length), *line = text;
    static const char header[] =
        "station,time_s,phase,a_x_mm,a_y_mm,a_z_mm,b_x_mm,b_y_mm,b_z_mm,speed_a_mm_s,"
        "speed_b_mm_s,tension_a_N,tension_b_N,alpha_a_deg,beta_a_deg,alpha_b_deg,beta_b_deg\n";
    ck_assert(strncmp(text, header, sizeof header - 1) == 0);
    line += sizeof header - 1;
    for (int j = 0; j < history.stations; j++) {
        char *end = strchr(line, '\n');
        ck_assert_ptr_nonnull(end);
        *end = '\0';
        check_csv_row(line, j);
        line = end + 1;
    }
    ck_assert_ptr_eq(line, text + length);
    free(text);
    ck_assert_int_eq(count_entries("."), 1);
    teardown();
}

/* ---- history.vtp ---- */

/* where an array's values begin, and how many bytes it has; NULL where there is none of that name */
static const char *vtp_array(const char *text, size_t length, const char *name, uint64_t *size) {
    char key[64];
    snprintf(key, sizeof key, "Name=\"%s\"", name);
    const char *at = strstr(text, key);
    if (!at) return NULL;
    unsigned long long offset;
    ck_assert_int_eq(sscanf(strstr(at, "offset=\""), "offset=\"%llu\"", &offset), 1);
    static const char begin[] = "<AppendedData encoding=\"raw\">\n_";
    const char *values = strstr(text, begin) + sizeof begin - 1 + offset;
    memcpy(size, values, sizeof *size);
    ck_assert(values + sizeof *size + *size <= text + length);
    return values + sizeof *size;
}

static void holds(const char *text, size_t length, const char *name, const void *values, size_t size) {
    uint64_t found = 0;
    const char *at = vtp_array(text, length, name, &found);
    ck_assert_msg(at && found == size, "%s: %llu bytes, expected %zu", name, (unsigned long long)found, size);
    ck_assert_msg(memcmp(at, values, size) == 0, "%s: other values", name);
}

static void holds_reals(const char *text, size_t length, const char *name, size_t offset, double factor) {
    size_t m = (size_t)history.stations;
    double *value = calloc(m, sizeof *value);
    for (size_t j = 0; j < m; j++) {
        memcpy(&value[j], (const char *)&history.row[j] + offset, sizeof *value);
        value[j] *= factor;
    }
    holds(text, length, name, value, m * sizeof *value);
    free(value);
}

static void holds_integers(const char *text, size_t length, const char *name, size_t offset) {
    int32_t value[100];
    for (int j = 0; j < history.stations; j++) memcpy(&value[j], (const char *)&history.row[j] + offset, sizeof *value);
    holds(text, length, name, value, (size_t)history.stations * sizeof *value);
}

static void check_point_data(const char *text, size_t length) {
    size_t n = (size_t)history.nodes, count = (size_t)history.stations * n;
    holds(text, length, "position_mm", history.position, count * sizeof(wcut_vec3));
    holds(text, length, "force_N", history.force, count * sizeof(wcut_vec3));
    holds(text, length, "force_N_per_mm", history.force_line, count * sizeof(double));
    holds(text, length, "speed_mm_s", history.speed, count * sizeof(double));
    uint64_t size = 0;
    const char *tension = vtp_array(text, length, "tension_N", &size);
    ck_assert_uint_eq(size, count * sizeof(double));
    for (size_t i = 0; i < count; i++) {
        size_t edge = i / n * (n - 1) + (i % n < n - 1 ? i % n : n - 2); /* the last node repeats the last edge */
        ck_assert(memcmp(tension + i * sizeof(double), &history.tension[edge], sizeof(double)) == 0);
    }
}

static void check_cells(const char *text, size_t length) {
    const double deg = 180 / 3.14159265358979323846;
    holds_reals(text, length, "time_s", offsetof(wcut_history_row, time), 1);
    holds_reals(text, length, "duration_s", offsetof(wcut_history_row, duration), 1);
    holds_reals(text, length, "speed_a_mm_s", offsetof(wcut_history_row, speed_a), 1);
    holds_reals(text, length, "speed_b_mm_s", offsetof(wcut_history_row, speed_b), 1);
    holds_reals(text, length, "tension_a_N", offsetof(wcut_history_row, tension_a), 1);
    holds_reals(text, length, "tension_b_N", offsetof(wcut_history_row, tension_b), 1);
    holds_reals(text, length, "alpha_a_deg", offsetof(wcut_history_row, alpha_a), deg);
    holds_reals(text, length, "beta_a_deg", offsetof(wcut_history_row, beta_a), deg);
    holds_reals(text, length, "alpha_b_deg", offsetof(wcut_history_row, alpha_b), deg);
    holds_reals(text, length, "beta_b_deg", offsetof(wcut_history_row, beta_b), deg);
    holds_reals(text, length, "engaged_mm", offsetof(wcut_history_row, engaged_length), 1);
    holds_reals(text, length, "residual", offsetof(wcut_history_row, residual), 1);
    holds_integers(text, length, "phase", offsetof(wcut_history_row, phase));
    holds_integers(text, length, "condition", offsetof(wcut_history_row, condition));
    holds_integers(text, length, "iterations", offsetof(wcut_history_row, iterations));
    holds_integers(text, length, "substeps", offsetof(wcut_history_row, substeps));
}

static void check_lines(const char *text, size_t length) {
    uint64_t size = 0;
    const char *connectivity = vtp_array(text, length, "connectivity", &size);
    size_t count = (size_t)history.stations * (size_t)history.nodes;
    ck_assert_uint_eq(size, count * sizeof(int64_t));
    const char *offsets = vtp_array(text, length, "offsets", &size);
    ck_assert_uint_eq(size, (size_t)history.stations * sizeof(int64_t));
    for (size_t i = 0; i < count; i++) {
        int64_t point;
        memcpy(&point, connectivity + i * sizeof point, sizeof point);
        ck_assert_int_eq(point, (int64_t)i);
    }
    for (int j = 0; j < history.stations; j++) {
        int64_t end;
        memcpy(&end, offsets + (size_t)j * sizeof end, sizeof end);
        ck_assert_int_eq(end, (int64_t)(j + 1) * history.nodes);
    }
    static const char tail[] = "\n  </AppendedData>\n</VTKFile>\n";
    ck_assert_str_eq(offsets + size, tail);
    ck_assert_ptr_eq(offsets + size + sizeof tail - 1, text + length);
}

static void check_vtp(const char *path) {
    size_t length;
    char *text = read_back(path, &length), line[200];
    snprintf(line, sizeof line, "<Piece NumberOfPoints=\"%d\" NumberOfVerts=\"0\" NumberOfLines=\"%d\"",
             history.stations * history.nodes, history.stations);
    ck_assert_ptr_nonnull(strstr(text, line));
    ck_assert_ptr_nonnull(strstr(text, "Units: mm"));
    check_point_data(text, length);
    check_cells(text, length);
    check_lines(text, length);
    free(text);
}

TEST(a_history_comes_back_from_vtp_to_the_last_bit) {
    static const int size[][2] = {{1, 2}, {2, 3}, {13, 11}, {100, 61}};
    for (int k = 0; k < 4; k++) {
        setup(size[k][0], size[k][1]);
        fine(wcut_history_write_vtp(&history, "h.vtp", &error));
        check_vtp("h.vtp");
        ck_assert_int_eq(count_entries("."), 1);
        teardown();
    }
}

static wcut_station station(int j, const double *engaged) {
    const wcut_history_row *r = &history.row[j];
    size_t n = (size_t)history.nodes, at = (size_t)j * n;
    wcut_station s = {.index = j, .time = r->time, .duration = r->duration, .nodes = history.nodes};
    s.position = history.position + at;
    s.force = history.force + at;
    s.force_line = history.force_line + at;
    s.speed = history.speed + at;
    s.tension = history.tension + (size_t)j * (n - 1);
    s.engaged = engaged;
    s.speed_a = r->speed_a, s.speed_b = r->speed_b, s.tension_a = r->tension_a, s.tension_b = r->tension_b;
    s.alpha_a = r->alpha_a, s.beta_a = r->beta_a, s.alpha_b = r->alpha_b, s.beta_b = r->beta_b;
    s.engaged_length = r->engaged_length, s.phase = r->phase, s.condition = r->condition;
    s.iterations = r->iterations, s.substeps = r->substeps, s.residual = r->residual;
    return s;
}

/* a stream planned for `max` stations of which all of the history's come */
static void stream_to(const char *path, int max, const double *engaged) {
    wcut_vtp_stream *stream = NULL;
    fine(wcut_vtp_stream_create(path, max, history.nodes, &stream, &error));
    for (int j = 0; j < history.stations; j++) {
        wcut_station s = station(j, engaged);
        fine(wcut_vtp_stream_append(stream, &s, &error));
    }
    fine(wcut_vtp_stream_commit(stream, &error));
    wcut_vtp_stream_destroy(stream);
}

static void same_files(const char *one, const char *other) {
    size_t length, other_length;
    char *text = read_back(one, &length), *again = read_back(other, &other_length);
    ck_assert_uint_eq(length, other_length);
    ck_assert(memcmp(text, again, length) == 0);
    free(text);
    free(again);
}

TEST(a_stream_that_ends_early_is_the_file_of_a_shorter_plan) {
    setup(13, 61);
    fine(wcut_history_write_vtp(&history, "h.vtp", &error));
    static const int max[] = {13, 14, 99, 5000};
    for (int k = 0; k < 4; k++) {
        stream_to("s.vtp", max[k], NULL);
        same_files("h.vtp", "s.vtp");
    }
    ck_assert_int_eq(count_entries("."), 2);
    teardown();
}

TEST(a_stream_with_engagement_has_that_too) {
    double engaged[61];
    for (int i = 0; i < 61; i++) engaged[i] = i / 60.0;
    setup(7, 61);
    stream_to("s.vtp", 20, engaged);
    check_vtp("s.vtp");
    size_t length;
    uint64_t size = 0;
    char *text = read_back("s.vtp", &length);
    const char *at = vtp_array(text, length, "engaged", &size);
    ck_assert_uint_eq(size, 7 * sizeof engaged);
    for (int j = 0; j < 7; j++) ck_assert(memcmp(at + (size_t)j * sizeof engaged, engaged, sizeof engaged) == 0);
    free(text);
    teardown();
}

TEST(a_stream_that_is_not_committed_leaves_nothing) {
    wcut_vtp_stream *stream = NULL;
    setup(3, 4);
    fine(wcut_vtp_stream_create("s.vtp", 5, 4, &stream, &error));
    wcut_station s = station(0, NULL);
    fine(wcut_vtp_stream_append(stream, &s, &error));
    ck_assert_int_eq(count_entries("."), 1);
    ck_assert_int_eq(access("s.vtp", F_OK), -1);
    wcut_vtp_stream_destroy(stream);
    ck_assert_int_eq(count_entries("."), 0);
    wcut_vtp_stream_destroy(NULL);
    teardown();
}

TEST(a_stream_refuses_what_does_not_fit_it) {
    wcut_vtp_stream *stream = NULL;
    const double engaged[4] = {0};
    setup(3, 4);
    ck_assert_int_eq(wcut_vtp_stream_create("s.vtp", 0, 4, &stream, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_vtp_stream_create("s.vtp", 1, 1, &stream, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_vtp_stream_create(NULL, 1, 4, &stream, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_vtp_stream_create("none/s.vtp", 1, 4, &stream, &error), WCUT_NOT_WRITTEN);
    ck_assert_ptr_null(stream);
    fine(wcut_vtp_stream_create("s.vtp", 2, 4, &stream, &error));
    ck_assert_int_eq(wcut_vtp_stream_commit(stream, &error), WCUT_BAD_ARGUMENT); /* no station */
    wcut_station s = station(0, NULL);
    s.nodes = 5;
    ck_assert_int_eq(wcut_vtp_stream_append(stream, &s, &error), WCUT_BAD_ARGUMENT);
    s = station(0, NULL);
    s.speed_a = NAN;
    ck_assert_int_eq(wcut_vtp_stream_append(stream, &s, &error), WCUT_BAD_ARGUMENT);
    s = station(0, NULL);
    fine(wcut_vtp_stream_append(stream, &s, &error));
    s = station(1, engaged); /* the first had none */
    ck_assert_int_eq(wcut_vtp_stream_append(stream, &s, &error), WCUT_BAD_ARGUMENT);
    s = station(1, NULL);
    fine(wcut_vtp_stream_append(stream, &s, &error));
    ck_assert_int_eq(wcut_vtp_stream_append(stream, &s, &error), WCUT_BAD_ARGUMENT); /* one too many */
    fine(wcut_vtp_stream_commit(stream, &error));
    wcut_vtp_stream_destroy(stream);
    ck_assert_int_eq(count_entries("."), 1);
    teardown();
}

TEST(a_history_that_is_not_finite_is_refused_by_every_writer) {
    setup(3, 4);
    history.row[1].alpha_b = NAN;
    ck_assert_int_eq(wcut_history_write_csv(&history, a, b, "x", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_write_vtp(&history, "x", &error), WCUT_BAD_ARGUMENT);
    history.row[1].alpha_b = 0;
    history.position[5].z = INFINITY;
    ck_assert_int_eq(wcut_history_write_vtp(&history, "x", &error), WCUT_BAD_ARGUMENT);
    history.position[5].z = 0;
    a[2].x = NAN;
    ck_assert_int_eq(wcut_history_write_csv(&history, a, b, "x", &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_write_csv(NULL, a, b, "x", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_history_write_vtp(&history, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(count_entries("."), 0);
    teardown();
}

/* ---- summary.json ---- */

static wcut_setup *cut_setup;

/* a real job's setup: the summary asks it for name, mode and integrator only */
static void given_setup(void) {
    wcut_job *job = NULL;
    char *text = given_changed(given_path_job, "test cut", "</script>\\\"Fl\xc3\xbcgel");
    fine(wcut_job_parse(text, strlen(text), "given", &job, &error));
    fine(wcut_setup_create(job, NULL, &cut_setup, &error));
    wcut_job_destroy(job);
    free(text);
}

static double figure(const json_t *root, const char *key, const char *part) {
    const json_t *value = json_object_get(root, key);
    if (part) value = json_object_get(value, part);
    ck_assert_msg(json_is_number(value), "no number: %s %s", key, part ? part : "");
    return json_number_value(value);
}

static void check_summary(const json_t *root) {
    ck_assert_str_eq(json_string_value(json_object_get(root, "format")), "wirecut-summary/1");
    ck_assert_str_eq(json_string_value(json_object_get(root, "job")), "</script>\"Fl\xc3\xbcgel");
    ck_assert_str_eq(json_string_value(json_object_get(root, "integrator")), "implicit");
    ck_assert_str_eq(json_string_value(json_object_get(root, "mode")), "path");
    ck_assert(figure(root, "stations", NULL) == 12 && figure(root, "planned_stations", NULL) == 14);
    ck_assert(json_is_false(json_object_get(root, "complete")) && figure(root, "nodes", NULL) == 5);
    ck_assert_double_eq(figure(root, "duration_s", NULL), history.row[11].time);
    /* station 0 has not moved: it counts for no figure. speed_a, the greater one, is 20 + j / 3 */
    ck_assert_double_eq(figure(root, "speed_mm_s", "min"), 20 + 1 / 3.0);
    ck_assert_double_eq(figure(root, "speed_mm_s", "median"), 22);
    ck_assert_double_eq(figure(root, "speed_mm_s", "max"), 20 + 11 / 3.0);
    ck_assert_double_eq(figure(root, "alpha_deg", "min"), degrees(history.row[1].alpha_b));
    ck_assert_double_eq(figure(root, "alpha_deg", "max"), degrees(history.row[11].alpha_a));
    ck_assert_double_eq(figure(root, "beta_deg", "min"), degrees(history.row[1].beta_a));
    ck_assert_double_eq(figure(root, "beta_deg", "max"), degrees(history.row[1].beta_b));
    ck_assert_double_eq(figure(root, "tension_N", "max"), history.row[11].tension_b);
    ck_assert_double_eq(figure(root, "force_N_per_mm", "max"), history.force_line[59]);
    ck_assert_double_eq(figure(root, "residual", "max"), history.row[11].residual);
    ck_assert_double_eq(figure(root, "iterations", "mean"), 40 / 11.0); /* 3 4 5 2 3 4 5 2 3 4 5 */
    ck_assert(figure(root, "iterations", "max") == 5 && figure(root, "substeps", "max") == 2);
    ck_assert(figure(root, "speed_set_by", "tension") == 3 && figure(root, "speed_set_by", "speed_max") == 4 &&
              figure(root, "speed_set_by", "speed_min") == 4 && figure(root, "speed_set_by", "time") == 0);
    ck_assert(figure(root, "phases", "approach") == 2 && figure(root, "phases", "entry") == 3);
}

TEST(the_summary_holds_every_figure) {
    setup(12, 5);
    given_setup();
    fine(wcut_summary_write(cut_setup, &history, "summary.json", &error));
    json_t *root = json_load_file("summary.json", JSON_REJECT_DUPLICATES, NULL);
    ck_assert_ptr_nonnull(root);
    check_summary(root);
    json_decref(root);
    char *text = NULL;
    ck_assert_int_eq(wcut_summary_print(cut_setup, &history, &text), WCUT_OK);
    file_holds("summary.json", text);
    ck_assert_int_eq(text[strlen(text) - 1], '\n');
    free(text);
    wcut_setup_destroy(cut_setup);
    teardown();
}

TEST(a_summary_of_one_station_is_possible_and_of_none_is_not) {
    char *text = NULL;
    setup(1, 5);
    given_setup();
    ck_assert_int_eq(wcut_summary_print(cut_setup, &history, &text), WCUT_OK);
    free(text);
    text = NULL;
    history.force_line[3] = NAN;
    ck_assert_int_eq(wcut_summary_print(cut_setup, &history, &text), WCUT_BAD_ARGUMENT);
    history.stations = 0;
    ck_assert_int_eq(wcut_summary_print(cut_setup, &history, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_summary_print(NULL, &history, &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_summary_write(cut_setup, &history, "x", &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(text);
    ck_assert_int_eq(count_entries("."), 0);
    wcut_setup_destroy(cut_setup);
    teardown();
}

/* ---- memory ---- */

static wcut_status write_one(int writer) {
    char *text = NULL;
    if (writer == 0) return wcut_history_write_csv(&history, a, b, "0", &error);
    if (writer == 1) return wcut_history_write_vtp(&history, "1", &error);
    if (writer == 2) return wcut_summary_write(cut_setup, &history, "2", &error);
    wcut_status status = wcut_summary_print(cut_setup, &history, &text);
    free(text);
    return status;
}

TEST(running_out_of_memory_anywhere_writes_nothing) {
    setup(40, 50);
    given_setup();
    for (int writer = 0; writer < 4; writer++) {
        EACH_FAILED_ALLOCATION(write_one(writer), count_entries(".") == writer);
    }
    wcut_setup_destroy(cut_setup);
    teardown();
}
