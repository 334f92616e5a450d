/* Case files: names that stay in their folder, and nothing else; formats of files. */
#include <wirecut/case.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/given.h"
#include "io/process/case.h"
#include "test.h"

static const char whole[] =
    "{\"format\": \"wirecut-case/1\", \"name\": \"c \\u00b5\", \"cuts\": [\n"
    "  {\"job\": \"cut-01/job.json\", \"recording\": \"cut-01/recording.csv\", \"scan\": \"cut-01/scan.ply\"},\n"
    "  {\"job\": \"./cut-02/..job.json\", \"recording\": \"r..csv\", \"scan\": null, \"x-note\": 1}],\n"
    " \"calibration\": \"calibration.csv\"}";

static wcut_status parse(const char *text, wcut_case **found, wcut_error *error) {
    *error = (wcut_error){WCUT_OK, ""};
    return wcut_case_parse(text, strlen(text), "a/b/case.json", found, error);
}

TEST(a_case_names_its_files_from_its_own_folder) {
    wcut_case *c = NULL;
    wcut_error error;
    ck_assert_int_eq(parse(whole, &c, &error), WCUT_OK);
    ck_assert_str_eq(c->name, "c \xc2\xb5");
    ck_assert_int_eq(c->cuts, 2);
    ck_assert_str_eq(c->cut[0].job, "a/b/cut-01/job.json");
    ck_assert_str_eq(c->cut[0].scan, "a/b/cut-01/scan.ply");
    ck_assert_str_eq(c->cut[1].job, "a/b/./cut-02/..job.json");
    ck_assert_str_eq(c->cut[1].recording, "a/b/r..csv");
    ck_assert_ptr_null(c->cut[1].scan);
    ck_assert_str_eq(c->calibration, "a/b/calibration.csv");
    wcut_case_destroy(c);
    c = NULL;
    ck_assert_int_eq(wcut_case_parse(whole, strlen(whole), "case.json", &c, NULL), WCUT_OK);
    ck_assert_str_eq(c->cut[0].job, "cut-01/job.json");
    wcut_case_destroy(c);
    wcut_case_destroy(NULL);
}

/* the whole case with `find` replaced is refused, and says so */
static void refused(const char *find, const char *by, wcut_status status, const char *words) {
    wcut_case *c = NULL;
    wcut_error error;
    char *text = given_changed(whole, find, by);
    ck_assert_int_eq(parse(text, &c, &error), status);
    ck_assert_ptr_null(c);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
    free(text);
}

TEST(no_name_leaves_the_folder) {
    const char *const name[] = {"/etc/passwd", "..", "../x", "a/../../x", "a/..", "a//../x", "./..", ""};
    for (size_t i = 0; i < sizeof name / sizeof *name; i++)
        refused("cut-01/job.json", name[i], WCUT_BAD_ARGUMENT, "$.cuts[0].job: found \"");
    refused("cut-01/scan.ply", "../scan.ply", WCUT_BAD_ARGUMENT, "$.cuts[0].scan");
    refused("r..csv", "/r.csv", WCUT_BAD_ARGUMENT, "$.cuts[1].recording");
    refused("calibration.csv", "../calibration.csv", WCUT_BAD_ARGUMENT, "$.calibration");
}

TEST(what_is_no_case_is_refused_with_its_place) {
    refused("wirecut-case/1", "wirecut-job/1", WCUT_BAD_FORMAT, "$.format: found \"wirecut-job/1\"");
    refused("\"job\": \"cut-01/job.json\"", "\"jobs\": 1", WCUT_BAD_FORMAT, "expected \"job\"");
    refused("\"job\": \"cut-01/job.json\",", "", WCUT_BAD_FORMAT, "$.cuts[0].job: found nothing");
    refused("\"cut-01/scan.ply\"", "7", WCUT_BAD_FORMAT, "$.cuts[0].scan: found 7");
    refused("\"c \\u00b5\"", "null", WCUT_BAD_FORMAT, "$.name");
    refused("\"calibration\":", "\"scan\":", WCUT_BAD_FORMAT, "unknown key \"scan\"");
    refused("}],", "}] ", WCUT_BAD_FORMAT, "line 4");
    refused("cut-01/job.json", "cut\\u0000.json", WCUT_BAD_FORMAT, "\\u0000");
    wcut_case *c = NULL;
    wcut_error error;
    ck_assert_int_eq(parse("{\"format\": \"wirecut-case/1\", \"name\": \"\", \"cuts\": []}", &c, &error),
                     WCUT_BAD_FORMAT);
    ck_assert_int_eq(parse("[]", &c, &error), WCUT_BAD_FORMAT);
    ck_assert_int_eq(wcut_case_read("no such file", &c, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_case_read(NULL, &c, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_case_read("x", NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(c);
}

TEST(a_files_format_is_read) {
    char format[WCUT_FORMAT_SIZE] = "999";
    wcut_error error = {WCUT_OK, ""};
    enter_folder();
    write_file("case.json", whole);
    ck_assert_int_eq(wcut_format_read("case.json", format, NULL), WCUT_OK);
    ck_assert_str_eq(format, "wirecut-case/1");
    const char *const bad[] = {"[]",
                               "{}",
                               "{\"format\": 1}",
                               "time_s,station\n0,1\n",
                               "",
                               "{\"format\": \"0123456789012345678901234567890123456789012345678901234567890123\"}"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        write_file("case.json", bad[i]);
        ck_assert_int_eq(wcut_format_read("case.json", format, &error), WCUT_BAD_FORMAT);
        ck_assert_str_eq(format, "wirecut-case/1");
    }
    ck_assert_int_eq(wcut_format_read("none", format, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_format_read(NULL, format, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_format_read("case.json", NULL, NULL), WCUT_BAD_ARGUMENT);
    leave_folder();
}

TEST(without_memory_a_case_is_not_read) {
    wcut_case *c = NULL;
    wcut_error error;
    EACH_FAILED_ALLOCATION(parse(whole, &c, &error), !c);
    wcut_case_destroy(c);
}
