/* Studies: values and cases, designs of experiments, inputs and hashes of cases, what is refused and where. */
#include <math.h>
#include <wirecut/study.h>

#include "base/fail.h"
#include "io/given.h"
#include "io/study/pointer.h"
#include "io/study/sample.h"
#include "io/study/study.h"
#include "test.h"

static const char whole[] =
    "{\"format\": \"wirecut-study/1\", \"name\": \"s\", \"verb\": \"simulate\", \"input\": \"job.json\",\n"
    " \"options\": {\"nodes\": 31, \"quick\": true, \"slow\": false, \"formats\": \"csv\"},\n"
    " \"parameters\": {\"/process/heat_W_per_m\": [50, 60, 70.5], \"/limits/speed_max_mm_s\": {\"from\": 10, \"to\": "
    "20, "
    "\"count\": 2},\n  \"--stations\": [5, 6]},\n"
    " \"combine\": \"grid\", \"figures\": {\"time\": \"/duration_s\", \"worst\": \"/residual/max\"},\n"
    " \"best\": {\"figure\": \"worst\", \"goal\": \"highest\"}, \"x-note\": 1}";

static wcut_status parse(const char *text, wcut_study **study, wcut_error *error) {
    *error = (wcut_error){WCUT_OK, ""};
    return wcut_study_parse(text, strlen(text), "study.json", "", given_path_job, strlen(given_path_job), study, error);
}

static wcut_study *given_study(const char *text) {
    wcut_study *study = NULL;
    wcut_error error;
    ck_assert_msg(parse(text, &study, &error) == WCUT_OK, "%s", error.text);
    return study;
}

/* a value as text is what is expected */
static void check_value(const wcut_study *study, int k, int parameter, const char *expected) {
    char *text = NULL;
    ck_assert_int_eq(wcut_study_value_print(study, k, parameter, &text), WCUT_OK);
    ck_assert_str_eq(text, expected);
    free(text);
}

TEST(a_grid_runs_through_every_combination_the_last_parameter_fastest) {
    wcut_study *s = given_study(whole);
    const wcut_study_info *info = wcut_study_view(s);
    ck_assert_int_eq(info->cases, 12);
    ck_assert_int_eq(info->parameters, 3);
    ck_assert_str_eq(info->parameter[2], "--stations");
    ck_assert_int_eq(info->best, 1);
    ck_assert(info->best_is_highest);
    static const char *const expected[12][3] = {{"50", "10", "5"},   {"50", "10", "6"},   {"50", "20", "5"},
                                                {"50", "20", "6"},   {"60", "10", "5"},   {"60", "10", "6"},
                                                {"60", "20", "5"},   {"60", "20", "6"},   {"70.5", "10", "5"},
                                                {"70.5", "10", "6"}, {"70.5", "20", "5"}, {"70.5", "20", "6"}};
    for (int k = 0; k < 12; k++)
        for (int p = 0; p < 3; p++) check_value(s, k, p, expected[k][p]);
    wcut_study_destroy(s);
}

/* the member of a printed input that a pointer names */
static double input_number(const wcut_study *study, int k, const char *pointer) {
    char *text = NULL;
    json_error_t cause;
    ck_assert_int_eq(wcut_study_input_print(study, k, &text), WCUT_OK);
    json_t *root = json_loads(text, 0, &cause);
    ck_assert_msg(root != NULL, "%s", cause.text);
    const double value = json_number_value(wcut_pointer_locate(root, pointer));
    json_decref(root);
    free(text);
    return value;
}

TEST(an_input_is_the_given_one_but_for_the_values_of_its_case) {
    wcut_study *s = given_study(whole);
    ck_assert_double_eq(input_number(s, 8, "/process/heat_W_per_m"), 70.5);
    ck_assert_double_eq(input_number(s, 8, "/limits/speed_max_mm_s"), 10);
    ck_assert_double_eq(input_number(s, 2, "/limits/speed_max_mm_s"), 20);

    /* everything else is as it was, to the last digit */
    ck_assert_double_eq(input_number(s, 2, "/path/mount_b_mm/2/1"), 3.0000000000000004);
    ck_assert_double_eq(input_number(s, 2, "/kerf/per_J_m2_mm"), 1.6e-4);
    wcut_study_destroy(s);
}

TEST(true_false_and_null_are_varied_where_the_pointer_says_alone) {
    static const char input[] = "{\"a\": true, \"b\": [null, true, null], \"c\": true}";
    static const char text[] =
        "{\"format\": \"wirecut-study/1\", \"name\": \"s\", \"verb\": \"simulate\", \"input\": \"i.json\",\n"
        " \"parameters\": {\"/b/1\": [false, \"x\"], \"/b/2\": [1, 2]}, \"combine\": \"zip\", \"figures\": {\"f\": "
        "\"/f\"}}";
    wcut_study *s = NULL;
    wcut_error error = {WCUT_OK, ""};
    char *made = NULL;
    ck_assert_msg(wcut_study_parse(text, strlen(text), "s", "", input, strlen(input), &s, &error) == WCUT_OK, "%s",
                  error.text);
    ck_assert_int_eq(wcut_study_input_print(s, 1, &made), WCUT_OK);
    ck_assert_str_eq(made, "{\"a\":true,\"b\":[null,\"x\",2],\"c\":true}");
    free(made);
    ck_assert_int_eq(wcut_study_input_print(s, 0, &made), WCUT_OK);
    ck_assert_str_eq(made, "{\"a\":true,\"b\":[null,false,1],\"c\":true}");
    free(made);
    wcut_study_destroy(s);
}

static void hash_of(const char *text, int k, char *hash) {
    wcut_study *s = given_study(text);
    ck_assert_int_eq(wcut_study_hash_eval(s, k, hash), WCUT_OK);
    wcut_study_destroy(s);
}

/* whether case k of the study with `find` replaced has another hash */
static bool tells_apart(const char *find, const char *by, int k) {
    char before[WCUT_STUDY_HASH_SIZE], after[WCUT_STUDY_HASH_SIZE], *text = given_changed(whole, find, by);
    hash_of(whole, k, before);
    hash_of(text, k, after);
    free(text);
    return strcmp(before, after) != 0;
}

TEST(a_hash_is_of_the_content_of_a_case_and_of_nothing_else) {
    /* other names, figures, cases beside it and spellings of a number are no other case */
    ck_assert(!tells_apart("\"name\": \"s\"", "\"name\": \"t\"", 0));
    ck_assert(!tells_apart("/residual/max", "/residual/min", 0));
    ck_assert(!tells_apart("[50, 60, 70.5]", "[50, 99]", 0));
    ck_assert(!tells_apart("[50, 60, 70.5]", "[5e1, 60]", 0));
    ck_assert(!tells_apart("{\"from\": 10, \"to\": 20, \"count\": 2}", "[10, 20]", 0));

    /* value, option and verb are */
    ck_assert(tells_apart("[50, 60, 70.5]", "[51, 60]", 0));
    ck_assert(tells_apart("\"nodes\": 31", "\"nodes\": 32", 0));
    ck_assert(tells_apart("\"--stations\": [5, 6]", "\"--stations\": [7]", 0));
    ck_assert(tells_apart("\"simulate\"", "\"mould\"", 0));
}

TEST(the_words_of_a_case_are_verb_inputs_folder_and_options_in_order) {
    wcut_study *s = given_study(whole);
    char *text = NULL;
    ck_assert_int_eq(wcut_study_call_print(s, 3, "/d", &text), WCUT_OK);
    ck_assert_str_eq(text,
                     "simulate\n/d/input.json\n-o\n/d\n--formats=csv\n--nodes=31\n--quick\n--stations=6\n--quiet\n");
    free(text);
    ck_assert_int_eq(wcut_study_call_print(s, 3, "a\nb", &text), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_study_call_print(s, 12, "/d", &text), WCUT_BAD_ARGUMENT);
    wcut_study_destroy(s);
}

TEST(ranges_have_both_ends_and_steps_stay_inside) {
    char *text = given_changed(whole, "[50, 60, 70.5]", "{\"from\": 1, \"to\": 100, \"count\": 3, \"scale\": \"log\"}");
    char *more = given_changed(text, "[5, 6]", "{\"from\": 5, \"to\": 6.9, \"step\": 0.5}");
    wcut_study *s = given_study(more);
    ck_assert_int_eq(wcut_study_view(s)->cases, 3 * 2 * 4);
    check_value(s, 0, 0, "1");
    check_value(s, 8, 0, "10");
    check_value(s, 16, 0, "100");
    check_value(s, 3, 2, "6.5");
    wcut_study_destroy(s);
    free(more);
    free(text);
}

/* ---- designs of experiments ---- */

TEST(sobol_points_are_those_of_scipy) {
    /* scipy 1.10.1, qmc.Sobol(21, scramble=False): points 777 and 1000 */
    static const double expected[2][WCUT_SOBOL_MAX] = {
        {0.6923828125, 0.9365234375, 0.1630859375, 0.2744140625, 0.6357421875, 0.3564453125, 0.1904296875,
         0.7626953125, 0.3486328125, 0.3232421875, 0.7451171875, 0.6962890625, 0.3837890625, 0.4736328125,
         0.5693359375, 0.5146484375, 0.4033203125, 0.8642578125, 0.3701171875, 0.7529296875, 0.2373046875},
        {0.2197265625, 0.0966796875, 0.5185546875, 0.6767578125, 0.2802734375, 0.9072265625, 0.0458984375,
         0.8994140625, 0.5009765625, 0.0693359375, 0.0849609375, 0.2548828125, 0.1611328125, 0.3837890625,
         0.1435546875, 0.3701171875, 0.7197265625, 0.3447265625, 0.9912109375, 0.7255859375, 0.5224609375}};
    for (int d = 0; d < WCUT_SOBOL_MAX; d++) {
        ck_assert_double_eq(wcut_sobol_eval(d, 777, 0), expected[0][d]);
        ck_assert_double_eq(wcut_sobol_eval(d, 1000, 0), expected[1][d]);
    }
}

TEST(every_interval_holds_one_point_of_a_block_whatever_the_seed) {
    enum { N = 256 };
    for (int d = 0; d < WCUT_SOBOL_MAX; d++)
        for (uint64_t seed = 0; seed < 3; seed++) {
            int sobol[N] = {0}, latin[N] = {0}, interval[N];
            wcut_latin_fill(d, N, seed, interval);
            for (int k = 0; k < N; k++) {
                const double jitter = wcut_latin_jitter(d, k, seed);
                ck_assert(jitter >= 0 && jitter < 1);
                sobol[(int)(N * wcut_sobol_eval(d, (uint32_t)k, seed))]++;
                latin[interval[k]]++;
            }
            for (int i = 0; i < N; i++) ck_assert(sobol[i] == 1 && latin[i] == 1);
        }
    ck_assert_double_ne(wcut_sobol_eval(1, 5, 1), wcut_sobol_eval(1, 5, 2));
}

TEST(samples_fill_their_intervals_evenly_and_come_back_by_their_seed) {
    static const char *const method[] = {"latin_hypercube", "sobol"};
    for (int m = 0; m < 2; m++) {
        char text[600];
        snprintf(
            text, sizeof text,
            "{\"format\": \"wirecut-study/1\", \"name\": \"s\", \"verb\": \"simulate\", \"input\": \"job.json\", "
            "\"combine\": \"%s\", \"cases\": 64, \"seed\": 7, \"parameters\": {\"/process/heat_W_per_m\": {\"from\": "
            "40, \"to\": 80}, \"/wire/nodes\": {\"from\": 11, \"to\": 17, \"step\": 2}, \"/wire/diameter_mm\": "
            "[0.1, 0.2]}, \"figures\": {\"f\": \"/f\"}}",
            method[m]);
        wcut_study *s = given_study(text), *again = given_study(text);
        int heat[8] = {0}, nodes[4] = {0}, thin = 0;
        for (int k = 0; k < 64; k++) {
            double value[3], other;
            for (int p = 0; p < 3; p++) {
                const json_t *listed = wcut_study_value(s, k, p, &value[p]);
                if (listed) value[p] = json_number_value(listed);
            }
            heat[(int)((value[0] - 40) / 5)]++;
            nodes[(int)((value[1] - 11) / 2)]++;
            thin += value[2] < 0.15;
            wcut_study_value(again, k, 0, &other);
            ck_assert_double_eq(value[0], other);
        }
        for (int i = 0; i < 8; i++) ck_assert_int_eq(heat[i], 8);
        for (int i = 0; i < 4; i++) ck_assert_int_eq(nodes[i], 16);
        ck_assert_int_eq(thin, 32);
        wcut_study_destroy(s);
        wcut_study_destroy(again);
    }
}

/* ---- refusals ---- */

/* the whole study with `find` replaced is refused, and says so */
static void refused(const char *find, const char *by, wcut_status status, const char *words) {
    wcut_study *s = NULL;
    wcut_error error;
    char *text = given_changed(whole, find, by);
    ck_assert_msg(parse(text, &s, &error) == status, "%s: %s", by, error.text);
    ck_assert_ptr_null(s);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
    free(text);
}

TEST(a_pointer_to_nothing_is_refused_with_the_nearest) {
    refused("/process/heat_W_per_m", "/proces/heat_W_per_m", WCUT_BAD_ARGUMENT, "the nearest is /process/heat_W_per_m");
    refused("/process/heat_W_per_m", "/heat_W_per_m", WCUT_BAD_ARGUMENT, "the nearest is /process/heat_W_per_m");
    refused("/process/heat_W_per_m", "/wire/node", WCUT_BAD_ARGUMENT, "the nearest is /wire/nodes");
    refused("/process/heat_W_per_m", "/path/mount_a_mm/3", WCUT_BAD_ARGUMENT, "the nearest is /path/mount_");
    refused("/process/heat_W_per_m", "/path/mount_a_mm/00", WCUT_BAD_ARGUMENT, "the nearest is");
    refused("/process/heat_W_per_m", "/limits", WCUT_BAD_ARGUMENT, "/limits holds it or lies in it");
}

TEST(too_many_cases_are_refused_with_their_number) {
    char *text = given_changed(whole, "[50, 60, 70.5]", "{\"from\": 1, \"to\": 2, \"count\": 1000}");
    char *more = given_changed(text, "\"count\": 2}", "\"count\": 1000}");
    char *most = given_changed(more, "[5, 6]", "{\"from\": 1, \"to\": 1000, \"step\": 1}");
    wcut_study *s = NULL;
    wcut_error error;
    ck_assert_int_eq(parse(most, &s, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "not of 1000000000"));
    free(most);
    free(more);
    free(text);
    refused("[50, 60, 70.5]", "{\"from\": 0, \"to\": 1e300, \"step\": 1}", WCUT_BAD_ARGUMENT, "at most 1000000 values");
}

TEST(ranges_have_a_limit_together) {
    char text[2000] =
        "{\"format\": \"wirecut-study/1\", \"name\": \"s\", \"verb\": \"v\", \"input\": \"i\", \"parameters\": {";
    for (int k = 0; k < 5; k++)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "%s\"--o%c\": {\"from\": 0, \"to\": 1, \"count\": 1000000}", k ? ", " : "", 'a' + k);
    snprintf(text + strlen(text), sizeof text - strlen(text), "}, \"combine\": \"zip\", \"figures\": {\"f\": \"/f\"}}");
    wcut_study *s = NULL;
    wcut_error error;
    ck_assert_int_eq(parse(text, &s, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "4000000 values of all ranges"));
}

TEST(what_else_is_wrong_is_refused_with_its_place) {
    refused("wirecut-study/1", "wirecut-job/1", WCUT_BAD_FORMAT, "$.format");
    refused("\"simulate\"", "\"sweep\"", WCUT_BAD_ARGUMENT, "$.verb");
    refused("\"job.json\"", "\"-x\"", WCUT_BAD_ARGUMENT, "$.input");
    refused("\"job.json\"", "[]", WCUT_BAD_ARGUMENT, "$.input");
    refused("\"nodes\": 31", "\"no des\": 31", WCUT_BAD_ARGUMENT, "$.options");
    refused("\"nodes\": 31", "\"nodes\": [31]", WCUT_BAD_FORMAT, "$.options.nodes");
    refused("\"csv\"", "\"a\\nb\"", WCUT_BAD_FORMAT, "$.options.formats");
    refused("\"grid\"", "\"zip\"", WCUT_BAD_ARGUMENT, "3 values");
    refused("\"grid\"", "\"rows\"", WCUT_BAD_FORMAT, "$.rows");
    refused("\"grid\"", "\"sobol\"", WCUT_BAD_ARGUMENT, "\"cases\" says");
    refused("\"grid\"", "\"grid\", \"cases\": 3", WCUT_BAD_ARGUMENT, "no \"cases\"");
    refused("\"grid\"", "\"grid\", \"rows\": \"r.csv\"", WCUT_BAD_ARGUMENT, "$.rows");
    refused("[50, 60, 70.5]", "[]", WCUT_BAD_ARGUMENT, "1 to 1000000 values");
    refused("[50, 60, 70.5]", "7", WCUT_BAD_FORMAT, "an array of values");
    refused("[50, 60, 70.5]", "{\"from\": 2, \"to\": 1, \"count\": 2}", WCUT_BAD_ARGUMENT, "greater than \"from\"");
    refused("[50, 60, 70.5]", "{\"from\": 0, \"to\": 1, \"count\": 2, \"scale\": \"log\"}", WCUT_BAD_ARGUMENT,
            "than 0");
    refused("[50, 60, 70.5]", "{\"from\": 1, \"to\": 2}", WCUT_BAD_ARGUMENT, "either \"count\" or \"step\"");
    refused("\"--stations\"", "\"-n\"", WCUT_BAD_ARGUMENT, "a parameter's name");
    refused("[5, 6]", "[5, null]", WCUT_BAD_FORMAT, "[1]: found null");
    refused("/duration_s", "duration_s", WCUT_BAD_ARGUMENT, "$.figures.time");
    refused("\"figure\": \"worst\"", "\"figure\": \"wurst\"", WCUT_BAD_ARGUMENT, "$.best");
    refused("\"input\": \"job.json\"", "\"input\": \"none.json\", \"inputs\": 1", WCUT_BAD_FORMAT, "unknown key");
}

TEST(pointers_are_rfc_6901) {
    /* the examples of its section 5 */
    json_t *root = json_loads("{\"foo\": [\"bar\", \"baz\"], \"\": 0, \"a/b\": 1, \"c%d\": 2, \"m~n\": 8}", 0, NULL);
    ck_assert_ptr_eq(wcut_pointer_locate(root, ""), root);
    ck_assert_str_eq(json_string_value(wcut_pointer_locate(root, "/foo/0")), "bar");
    ck_assert_int_eq(json_integer_value(wcut_pointer_locate(root, "/a~1b")), 1);
    ck_assert_int_eq(json_integer_value(wcut_pointer_locate(root, "/m~0n")), 8);
    ck_assert_ptr_eq(wcut_pointer_locate(root, "/"), json_object_get(root, ""));
    const char *const nothing[] = {"/foo/2", "/foo/01", "/foo/-", "/foo/0/x",
                                   "foo",    "/a~b",    "/m~2n",  "/foo/99999999999"};
    for (size_t i = 0; i < sizeof nothing / sizeof *nothing; i++)
        ck_assert_ptr_null(wcut_pointer_locate(root, nothing[i]));
    json_decref(root);
}

TEST(no_memory_is_said_and_leaves_nothing) {
    wcut_study *s = NULL;
    wcut_error error;
    EACH_FAILED_ALLOCATION(parse(whole, &s, &error), !s);
    char *text = NULL, hash[WCUT_STUDY_HASH_SIZE] = "9";
    EACH_FAILED_ALLOCATION(wcut_study_input_print(s, 1, &text), !text);
    free(text);
    text = NULL;
    EACH_FAILED_ALLOCATION(wcut_study_call_print(s, 1, "/d", &text), !text);
    free(text);
    EACH_FAILED_ALLOCATION(wcut_study_hash_eval(s, 1, hash), strcmp(hash, "9") == 0);
    wcut_study_destroy(s);
}
