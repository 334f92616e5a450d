/* Job files in: every key to its member, and every way to be wrong to one clear line. */
#include <jansson.h>
#include <locale.h>
#include <wirecut/job.h>
#include <wirecut/job_file.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "io/process/job.h"
#include "test.h"

static wcut_job *job;
static wcut_error error;

static wcut_status parse(const char *text, size_t length) {
    wcut_job_destroy(job);
    job = NULL;
    error = (wcut_error){WCUT_OK, ""};
    return wcut_job_parse(text, length, "j.json", &job, &error);
}

static void forget(void) {
    wcut_job_destroy(job);
    job = NULL;
}

/* the text is refused with this line, and no job is made */
static void refused(const char *text, wcut_status status, const char *line) {
    ck_assert_msg(parse(text, strlen(text)) == status, "status %d, expected %d: %s", error.status, status, error.text);
    ck_assert_ptr_null(job);
    ck_assert_int_eq(error.status, status);
    ck_assert_str_eq(error.text, line);
}

/* ... after a change of the path job, or of the design job */
static void refused_after(const char *text, const char *find, const char *by, wcut_status status, const char *line) {
    char *changed = given_changed(text, find, by);
    refused(changed, status, line);
    free(changed);
}

#define PATH(find, by, status, line) refused_after(given_path_job, find, by, status, "j.json: " line)
#define DESIGN(find, by, status, line) refused_after(given_design_job, find, by, status, "j.json: " line)

TEST(every_key_of_a_path_job_reaches_its_member) {
    ck_assert_int_eq(parse(given_path_job, strlen(given_path_job)), WCUT_OK);
    ck_assert_str_eq(job->name, "test cut");
    ck_assert_str_eq(job->foam_material, "EPS 15 kg/m3");
    ck_assert_str_eq(job->wire_material, "Kanthal A");
    ck_assert(job->block_size.x == 400 && job->block_size.y == 1200 && job->block_size.z == 300.5);
    ck_assert(job->wire_diameter == 0.15 && job->wire_length == 620.25 && job->nodes == 121);
    ck_assert(job->heat == 60 && job->tension == 2 && job->force_law.a == 0.1 && job->force_law.b == 8.6e-4);
    ck_assert(job->tension_law.a == 0.02 && job->tension_law.b == 4e-4 && job->tension_law.c == -0.001);
    ck_assert(job->speed_max == 80 && job->speed_min == 0.5 && job->kerf_width == 0.8 && job->kerf_per_q == 1.6e-4);
    ck_assert(job->mode == WCUT_MODE_PATH && job->stations == 3);
    ck_assert(job->mount_a[2].x == -110 && job->mount_a[2].z == 150.125);
    ck_assert(job->mount_b[2].y == 3.0000000000000004); /* the last bit too */
    ck_assert(job->dither_count == 1 && job->dither[0].amplitude == 0.045 && job->dither[0].period == 3.1 &&
              job->dither[0].phase == 1.2);
    ck_assert(job->heat_step_count == 2 && job->heat_step[1].from == 21.5 && job->heat_step[1].to == 30 &&
              job->heat_step[1].factor == 1.1);
    forget();
}

TEST(every_key_of_a_design_job_reaches_its_member_and_the_rest_has_defaults) {
    ck_assert_int_eq(parse(given_design_job, strlen(given_design_job)), WCUT_OK);
    ck_assert(job->mode == WCUT_MODE_DESIGN && job->stations == 41 && job->clearance == 80 && !job->mount_a);
    ck_assert(job->extra_count == 3 && job->extra_u[1] == 0.5 && job->extra_length[1] == 60);
    wcut_vec3 point;
    ck_assert_int_eq(wcut_curve_eval(job->edge_a, 1, 0, &point), WCUT_OK);
    ck_assert_double_eq_tol(point.y, 900, 1e-9);
    ck_assert(job->edge_b->degree == 2 && job->edge_b->weights[1] == 0.5 && job->edge_b->control[1].z == 200);
    ck_assert(job->speed_max == 100 && job->speed_min == 0.1 && job->kerf_width == 0 && job->tension_law.a == 0);
    ck_assert(!job->foam_material && !job->dither && !job->heat_step && job->wire_length == 0);
    forget();
}

TEST(what_is_no_json_is_refused_with_line_and_column) {
    refused("", WCUT_BAD_FORMAT, "j.json: line 1, column 0: '[' or '{' expected near end of file, expected valid JSON");
    refused("{\n \"a\": 1,\n}", WCUT_BAD_FORMAT,
            "j.json: line 3, column 1: string or '}' expected near '}', expected valid JSON");
    refused("{\"a\": 1} x", WCUT_BAD_FORMAT,
            "j.json: line 1, column 10: end of file expected near 'x', expected valid JSON");
    refused("{\"a\": 1, \"a\": 2}", WCUT_BAD_FORMAT,
            "j.json: line 1, column 12: duplicate object key near '\"a\"', expected valid JSON");
    refused("{\"a\": 1e400}", WCUT_BAD_FORMAT,
            "j.json: line 1, column 11: real number overflow near '1e400', expected valid JSON");
    PATH("620.25", "NaN", WCUT_BAD_FORMAT, "line 5, column 87: invalid token near 'NaN', expected valid JSON");
    PATH("620.25", "Infinity", WCUT_BAD_FORMAT,
         "line 5, column 92: invalid token near 'Infinity', expected valid JSON");
    PATH("620.25", "620,25", WCUT_BAD_FORMAT,
         "line 5, column 90: string or '}' expected near '25', expected valid JSON");
    PATH("test cut", "t\\u0000", WCUT_BAD_FORMAT, "line 3, column 19: \\u0000 in a string, expected valid JSON");
}

TEST(every_truncation_is_refused) {
    size_t length = strlen(given_path_job) - 2; /* without the closing brace */
    for (size_t n = 0; n <= length; n++) {
        char *part = malloc(n + 1); /* no more than that, so that a sanitizer sees a byte too far */
        memcpy(part, given_path_job, n);
        ck_assert_int_eq(parse(part, n), WCUT_BAD_FORMAT);
        ck_assert(job == NULL && strncmp(error.text, "j.json: line ", 13) == 0);
        free(part);
    }
}

TEST(a_byte_order_mark_is_ignored) {
    char *text = given_changed(given_path_job, "{", "\xef\xbb\xbf{");
    ck_assert_int_eq(parse(text, strlen(text)), WCUT_OK);
    free(text);
    forget();
}

TEST(unknown_keys_are_refused_with_the_near_one) {
    PATH("\"length_mm\"", "\"lenght_mm\"", WCUT_BAD_FORMAT,
         "$.wire: found the unknown key \"lenght_mm\", expected \"length_mm\"");
    PATH("\"nodes\"", "\"node\"", WCUT_BAD_FORMAT, "$.wire: found the unknown key \"node\", expected \"nodes\"");
    PATH("\"heat_W_per_m\"", "\"heat_w_per_m\"", WCUT_BAD_FORMAT,
         "$.process: found the unknown key \"heat_w_per_m\", expected \"heat_W_per_m\"");
    PATH("\"x-note\"", "\"note\"", WCUT_BAD_FORMAT, "$: found the unknown key \"note\", expected \"name\"");
    PATH("\"x-note\"", "\"comment\"", WCUT_BAD_FORMAT,
         "$: found the unknown key \"comment\", expected one of format, name, block, wire, process, path, design, "
         "limits, rig, feed, kerf, excitation, effects");
    PATH("\"kerf\": {", "\"kerf\": {\"a\\n\\u001b[2J\\u009b\": 1, ", WCUT_BAD_FORMAT,
         "$.kerf: found the unknown key \"a\\x0a\\x1b[2J\xc2\\x9b\", expected one of width_mm, per_J_m2_mm");
    DESIGN("\"weights\"", "\"weight\"", WCUT_BAD_FORMAT,
           "$.design.edge_b: found the unknown key \"weight\", expected \"weights\"");
    PATH("\"factor\": 1.1", "\"faktor\": 1.1", WCUT_BAD_FORMAT,
         "$.excitation.heat[1]: found the unknown key \"faktor\", expected \"factor\"");
}

TEST(missing_keys_are_named_with_what_they_should_be) {
    PATH("\"format\": \"wirecut-job/1\",", "", WCUT_BAD_FORMAT, "$.format: found nothing, expected \"wirecut-job/1\"");
    PATH("\"name\": \"test cut\",", "", WCUT_BAD_FORMAT, "$.name: found nothing, expected a string");
    PATH("\"nodes\": 121, ", "", WCUT_BAD_FORMAT, "$.wire.nodes: found nothing, expected an integer from 3 to 100000");
    PATH(", \"length_mm\": 620.25", "", WCUT_BAD_FORMAT,
         "$.wire.length_mm: found nothing, expected a number greater than 0: a job with a path needs it");
    PATH("\"path\"", "\"x-path\"", WCUT_BAD_FORMAT, "$: found an object, expected a \"path\" or a \"design\" in it");
    PATH(", \"c_N_per_mm\": -0.001", "", WCUT_BAD_FORMAT,
         "$.process.tension_law.c_N_per_mm: found nothing, expected a number");
    PATH("\"width_mm\": 0.8, ", "", WCUT_BAD_FORMAT, "$.kerf.width_mm: found nothing, expected a number of at least 0");
    DESIGN(", \"clearance_mm\": 80", "", WCUT_BAD_FORMAT,
           "$.design.clearance_mm: found nothing, expected a number of at least 0");
    DESIGN("{\"points_mm\": [[0, 0, 100], [0, 300, 130], [0, 600, 90], [0, 900, 100]]}", "{}", WCUT_BAD_FORMAT,
           "$.design.edge_a: found an object, expected a curve: \"points_mm\", or \"degree\", \"knots\" and "
           "\"control_points_mm\"");
}

TEST(wrong_types_are_refused) {
    refused("[1, 2]", WCUT_BAD_FORMAT, "j.json: $: found an array of 2, expected an object");
    PATH("wirecut-job/1", "wirecut-job/2", WCUT_BAD_FORMAT,
         "$.format: found \"wirecut-job/2\", expected \"wirecut-job/1\"");
    PATH("\"wirecut-job/1\"", "1", WCUT_BAD_FORMAT, "$.format: found 1, expected \"wirecut-job/1\"");
    PATH("\"test cut\"", "null", WCUT_BAD_FORMAT, "$.name: found null, expected a string");
    PATH("121", "\"121\"", WCUT_BAD_FORMAT, "$.wire.nodes: found \"121\", expected an integer from 3 to 100000");
    PATH("60.0", "true", WCUT_BAD_FORMAT, "$.process.heat_W_per_m: found true, expected a number greater than 0");
    PATH("[400, 1200, 300.5]", "400", WCUT_BAD_FORMAT, "$.block.size_mm: found 400, expected a point [x, y, z]");
    PATH("[-110, 1.5, 150]", "[-110, 1.5]", WCUT_BAD_FORMAT,
         "$.path.mount_a_mm[1]: found an array of 2, expected a point [x, y, z]");
    PATH("3.0000000000000004", "{}", WCUT_BAD_FORMAT, "$.path.mount_b_mm[2][1]: found an object, expected a number");
    PATH("\"effects\": []", "\"effects\": {}", WCUT_BAD_FORMAT,
         "$.effects: found an object, expected an array of at least 0 effects");
    DESIGN("[0.5, 60]", "0.5", WCUT_BAD_FORMAT,
           "$.design.extra_length_mm[1]: found 0.5, expected a pair [u, extra length in mm]");
    DESIGN("[[0, 5], [0.5, 60], [1, 5]]", "5", WCUT_BAD_FORMAT,
           "$.design.extra_length_mm: found 5, expected an array of at least 1 pairs [u, mm]");
}

TEST(values_outside_their_range_are_refused) {
    PATH("1200", "0", WCUT_BAD_ARGUMENT, "$.block.size_mm[1]: found 0, expected a number greater than 0");
    PATH("0.15", "-0.15", WCUT_BAD_ARGUMENT, "$.wire.diameter_mm: found -0.15, expected a number greater than 0");
    PATH("121", "2", WCUT_BAD_ARGUMENT, "$.wire.nodes: found 2, expected an integer from 3 to 100000");
    PATH("121", "100001", WCUT_BAD_ARGUMENT, "$.wire.nodes: found 100001, expected an integer from 3 to 100000");
    PATH("121", "12.5", WCUT_BAD_ARGUMENT, "$.wire.nodes: found 12.5, expected an integer from 3 to 100000");
    PATH("121", "99999999999999999999", WCUT_BAD_ARGUMENT,
         "$.wire.nodes: found 1e+20, expected an integer from 3 to 100000");
    PATH("8.6e-4", "0", WCUT_BAD_ARGUMENT, "$.process.force_law.b_m2_per_J: found 0, expected a number greater than 0");
    PATH("\"speed_min_mm_s\": 0.5", "\"speed_min_mm_s\": 80", WCUT_BAD_ARGUMENT,
         "$.limits.speed_min_mm_s: found 80, expected speed_min_mm_s (80) less than speed_max_mm_s (80)");
    PATH("[[510, 0, 150], ", "[", WCUT_BAD_ARGUMENT,
         "$.path.mount_b_mm: found an array of 2, expected 3 stations as in mount_a_mm");
    PATH("[[-110, 0, 150], [-110, 1.5, 150], [-110, 3, 150.125]]", "[[-110, 0, 150]]", WCUT_BAD_ARGUMENT,
         "$.path.mount_a_mm: found an array of 1, expected 2 to 1000000 stations");
    PATH("0.045", "-1.0", WCUT_BAD_ARGUMENT,
         "$.excitation.speed: found an array of 1, expected amplitudes that sum to less than 1 (not 1): the speed "
         "stays positive");
    PATH("\"to_s\": 30", "\"to_s\": 21.5", WCUT_BAD_ARGUMENT,
         "$.excitation.heat[1].to_s: found 21.5, expected more than from_s (21.5)");
    PATH("\"from_s\": 21.5", "\"from_s\": 21.25", WCUT_BAD_ARGUMENT,
         "$.excitation.heat[1].from_s: found 21.25, expected at least the to_s (21.5) of the interval before");
    PATH("\"factor\": 0.9", "\"factor\": 0", WCUT_BAD_ARGUMENT,
         "$.excitation.heat[0].factor: found 0, expected a number greater than 0");
    PATH("\"path\"", "\"design\": {}, \"path\"", WCUT_BAD_FORMAT,
         "$: found an object, expected either \"path\" or \"design\", not both");
}

TEST(design_values_outside_their_range_are_refused) {
    DESIGN("\"stations\": 41", "\"stations\": 1", WCUT_BAD_ARGUMENT,
           "$.design.stations: found 1, expected an integer from 2 to 1000000");
    DESIGN("\"stations\": 41", "\"stations\": 1000001", WCUT_BAD_ARGUMENT,
           "$.design.stations: found 1000001, expected an integer from 2 to 1000000");
    DESIGN("[0.5, 60]", "[1.5, 60]", WCUT_BAD_ARGUMENT,
           "$.design.extra_length_mm[1][0]: found 1.5, expected a parameter u from 0 to 1");
    DESIGN("[0.5, 60]", "[0, 60]", WCUT_BAD_ARGUMENT,
           "$.design.extra_length_mm[1][0]: found 0, expected u to increase, beyond 0");
    DESIGN("[0.5, 60]", "[0.5, -1]", WCUT_BAD_ARGUMENT,
           "$.design.extra_length_mm[1][1]: found -1, expected a number of at least 0");
    DESIGN("[0, 300, 130]", "[0, 0, 100]", WCUT_BAD_ARGUMENT,
           "$.design.edge_a: found an object, expected points of which no two neighbours coincide");
    DESIGN("\"degree\": 2", "\"degree\": 8", WCUT_BAD_ARGUMENT,
           "$.design.edge_b.degree: found 8, expected an integer from 1 to 7");
    DESIGN("\"degree\": 2", "\"degree\": 3", WCUT_BAD_ARGUMENT,
           "$.design.edge_b.control_points_mm: found an array of 3, expected 4 to 1000000 control points");
    DESIGN("[0, 0, 0, 1, 1, 1]", "[0, 0, 1, 1]", WCUT_BAD_ARGUMENT,
           "$.design.edge_b.knots: found an array of 4, expected 6 knots: control points + degree + 1");
    DESIGN("[0, 0, 0, 1, 1, 1]", "[0, 0, 1, 0, 1, 1]", WCUT_BAD_ARGUMENT,
           "$.design.edge_b: found an object, expected knots that do not decrease, span a domain, and repeat at most "
           "degree times inside it");
    DESIGN("[1, 0.5, 1]", "[1, 0.5]", WCUT_BAD_ARGUMENT,
           "$.design.edge_b.weights: found an array of 2, expected 3 weights, one a control point");
    DESIGN("[1, 0.5, 1]", "[1, 0, 1]", WCUT_BAD_ARGUMENT,
           "$.design.edge_b.weights[1]: found 0, expected a number greater than 0");
    DESIGN("\"degree\": 2", "\"degree\": 2, \"points_mm\": []", WCUT_BAD_FORMAT,
           "$.design.edge_b: found an object, expected either \"points_mm\" or \"degree\", not both");
}

TEST(an_effect_is_refused_by_name_not_ignored) {
#define EFFECT(text, status, message) PATH("\"effects\": []", "\"effects\": [" text "]", status, message)
    EFFECT("{\"name\": \"wire_termal_lag\", \"time_constant_s\": 1}", WCUT_BAD_ARGUMENT,
           "$.effects[0].name: found \"wire_termal_lag\", expected \"wire_thermal_lag\"");
    EFFECT("{\"name\": \"wire_thermal_lag\", \"time_constant\": 1}", WCUT_BAD_FORMAT,
           "$.effects[0]: found the unknown key \"time_constant\", expected \"time_constant_s\"");
    EFFECT("{\"name\": \"wire_thermal_lag\"}", WCUT_BAD_FORMAT,
           "$.effects[0].time_constant_s: found nothing, expected a number");
    EFFECT("{\"name\": \"wire_thermal_lag\", \"time_constant_s\": -1}", WCUT_BAD_ARGUMENT,
           "$.effects[0].time_constant_s: found -1, expected a number from 0 to 60");
    EFFECT("{\"name\": \"foam_density_gradient\", \"relative_change_across_block\": 0}", WCUT_BAD_FORMAT,
           "$.effects[0].axis: found nothing, expected one of x, y, z, x_quadratic, y_quadratic, z_quadratic, x_step, "
           "y_step, z_step, x_band, y_band, z_band");
    EFFECT("{\"name\": \"wire_thermal_lag\", \"form\": \"melted\", \"time_constant_s\": 1}", WCUT_BAD_ARGUMENT,
           "$.effects[0].form: found \"melted\", expected \"melt\"");
    EFFECT("{\"name\": \"wire_thermal_lag\", \"time_constant_s\": 1, \"slow_share\": 0.3}", WCUT_BAD_FORMAT,
           "$.effects[0]: found the unknown key \"slow_share\", expected one of name, form, time_constant_s, "
           "v_ref_mm_s, H0_W_per_mK, H1_W_s_per_mm_mK");
    EFFECT("{\"name\": \"foam_density_gradient\", \"axis\": \"w\", \"relative_change_across_block\": 0}",
           WCUT_BAD_ARGUMENT, "$.effects[0].axis: found \"w\", expected \"x\"");
    EFFECT("{\"name\": \"rate_dependence\", \"exponent\": 0}, {\"name\": \"rate_dependence\", \"exponent\": 0}",
           WCUT_BAD_ARGUMENT, "$.effects[1]: found an object, expected no second rate_dependence");
    EFFECT("{\"name\": \"foam_inclusion\", \"amplitude\": 0, \"radius_mm\": 9, \"position_mm\": [1, 2, 1e9]}",
           WCUT_BAD_ARGUMENT,
           "$.effects[0].position_mm: found an array of 3, expected coordinates from -1e+06 to 1e+06");
    EFFECT("7", WCUT_BAD_FORMAT, "$.effects[0]: found 7, expected an effect: {\"name\": .., ..}");
#undef EFFECT
}

TEST(an_effect_without_a_form_has_the_first_one) {
    static const struct {
        const char *text;
        int choice;
    } given[] = {{"{\"name\": \"wire_thermal_lag\", \"time_constant_s\": 1}", 0},
                 {"{\"name\": \"wire_thermal_lag\", \"form\": \"melt\", \"time_constant_s\": 1}", 2},
                 {"{\"name\": \"tangential_drag\", \"law\": \"speed\", \"mu\": 1}", 1},
                 {"{\"name\": \"end_cooling\", \"amplitude\": 0.1, \"length_mm\": 9}", 0}};
    for (size_t k = 0; k < sizeof given / sizeof *given; k++) {
        char list[300];
        snprintf(list, sizeof list, "\"effects\": [%s]", given[k].text);
        char *text = given_changed(given_path_job, "\"effects\": []", list);
        ck_assert_msg(parse(text, strlen(text)) == WCUT_OK, "%s", error.text);
        free(text);
        ck_assert_int_eq(job->effect_count, 1);
        ck_assert_int_eq(job->effect[0].choice, given[k].choice);
        forget();
    }
}

TEST(a_locale_with_decimal_commas_changes_nothing) {
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8") != NULL, "the tests' own locale is missing");
    ck_assert_str_eq(localeconv()->decimal_point, ",");
    ck_assert_int_eq(parse(given_path_job, strlen(given_path_job)), WCUT_OK);
    ck_assert(job->wire_length == 620.25 && job->force_law.b == 8.6e-4 && job->mount_b[2].y == 3.0000000000000004);
    PATH("\"to_s\": 30", "\"to_s\": 21.25", WCUT_BAD_ARGUMENT,
         "$.excitation.heat[1].to_s: found 21.25, expected more than from_s (21.5)");
    ck_assert_str_eq(localeconv()->decimal_point, ","); /* and the caller still has it */
    forget();
}

/* one line of printable text, whatever the file is called */
static void unreadable(const char *path, wcut_status status, const char *line) {
    error = (wcut_error){WCUT_OK, ""};
    ck_assert_int_eq(wcut_job_read(path, &job, &error), status);
    ck_assert_ptr_null(job);
    ck_assert_str_eq(error.text, line);
}

TEST(files_that_cannot_be_read_are_named_with_the_cause) {
    enter_folder();
    unreadable("none.json", WCUT_NOT_FOUND, "none.json: cannot be read: No such file or directory");
    unreadable(".", WCUT_NOT_FOUND, ".: cannot be read: Is a directory");
    unreadable("a\nb\x1b[31m.json", WCUT_NOT_FOUND, "a\\x0ab\\x1b[31m.json: cannot be read: No such file or directory");
    write_file("secret.json", given_path_job);
    ck_assert_int_eq(chmod("secret.json", 0), 0);
    if (geteuid() == 0) ck_assert_int_eq(seteuid(65534), 0);
    unreadable("secret.json", WCUT_NOT_FOUND, "secret.json: cannot be read: Permission denied");
    if (getuid() == 0) ck_assert_int_eq(seteuid(0), 0);
    leave_folder();
}

TEST(a_file_is_read_whole_and_one_that_is_too_long_is_refused) {
    enter_folder();
    write_file("job.json", given_path_job);
    ck_assert_int_eq(wcut_job_read("job.json", &job, &error), WCUT_OK);
    ck_assert_int_eq(job->stations, 3);
    forget();
    ck_assert_int_eq(truncate("job.json", (off_t)WCUT_JOB_BYTES_MAX + 1), 0);
    unreadable("job.json", WCUT_BAD_FORMAT, "job.json: found more than 256 MB, expected at most that");
    char path[1200]; /* a long name is shown by its end */
    memset(path, 'd', sizeof path);
    snprintf(path + 1000, 200, "/job.json");
    ck_assert_int_eq(wcut_job_read(path, &job, &error), WCUT_NOT_FOUND);
    ck_assert(strncmp(error.text, "...ddd", 6) == 0 &&
              strstr(error.text, "d/job.json: cannot be read: File name too long"));
    leave_folder();
}

TEST(null_arguments_are_refused) {
    ck_assert_int_eq(wcut_job_read(NULL, &job, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_read("job.json", NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_job_parse("{", 1, "j.json", &job, NULL), WCUT_BAD_FORMAT); /* error may be NULL */
}

/* ---- memory: every allocation fails once ---- */

static long json_countdown;
static void *json_allocate(size_t size) { return json_countdown > 0 && --json_countdown == 0 ? NULL : malloc(size); }

static void fail_each(void (*fail_at)(long), const char *text, wcut_status also) {
    wcut_status status = WCUT_NO_MEMORY;
    long k = 0;
    while (status != WCUT_OK) {
        fail_at(++k);
        status = parse(text, strlen(text));
        fail_at(0);
        bool told = status == WCUT_NO_MEMORY && strcmp(error.text, "j.json: out of memory") == 0;
        ck_assert_msg(status == WCUT_OK || (job == NULL && (told || status == also)), "%ld: %d %s", k, status,
                      error.text);
        ck_assert_int_lt(k, 10000);
    }
    ck_assert_int_gt(k, 2);
    forget();
}

static void fail_json_at(long k) { json_countdown = k; }

TEST(running_out_of_memory_anywhere_is_reported_and_leaks_nothing) {
    json_set_alloc_funcs(json_allocate, free);
    const char *const text[] = {given_path_job, given_design_job};
    for (int k = 0; k < 2; k++) {
        fail_each(wcut_alloc_fail_at, text[k], WCUT_NO_MEMORY);
        fail_each(fail_json_at, text[k], WCUT_BAD_FORMAT); /* jansson takes some of them for bad text */
    }
}

/* 432 recorded jobs, where they are there */
TEST(recorded_jobs_are_read_as_they_stand) {
    int count = 0;
    for (int c = 1; c <= 99; c++)
        for (int cut = 1; cut <= 9; cut++)
            for (int set = 0; set < 2; set++) {
                char path[400];
                snprintf(path, sizeof path, WCUT_SOURCE_DIR "/../shared/cases/%s/c%02d/cut-%02d/job.json",
                         set ? "exam" : "dev", c, cut);
                if (access(path, R_OK) != 0) continue;
                error.text[0] = '\0';
                ck_assert_msg(wcut_job_read(path, &job, &error) == WCUT_OK, "%s", error.text);
                forget();
                count++;
            }
    if (count == 0) printf("no ../shared/cases here: recorded jobs were not read\n");
}
