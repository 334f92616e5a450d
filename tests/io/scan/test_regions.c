/* Zones and sections of a user: read from JSON, measured against closed forms, written; what is refused. */
#include <math.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wirecut/mould_file.h>
#include <wirecut/survey.h>
#include <wirecut/table.h>

#include "base/alloc.h"
#include "io/given.h"
#include "test.h"

#define ZONES                                                                                                         \
    "{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"left\", \"box_mm\": [[0, 0, -1], [10, 20, 9]], "      \
    "\"tolerance_mm\": 0.2}, {\"name\": \"triangle\", \"polygon_mm\": [[10.2, 0], [30.2, 0], [30.2, 20]], "           \
    "\"tolerance_mm\": 0.2, \"share_percent\": 50}, {\"name\": \"plain\", \"box_mm\": [[0, 0, 0], [30, 20, 0]]}, "    \
    "{\"name\": \"empty\", \"box_mm\": [[90, 90, 0], [91, 91, 1]], \"tolerance_mm\": 1}], \"sections\": [{\"name\": " \
    "\"A-A\", \"line_mm\": [[0, 10], [30, 10]], \"width_mm\": 2, \"step_mm\": 10}, {\"name\": \"corner\", "           \
    "\"line_mm\": "                                                                                                   \
    "[[5, 0], [5, 10], [15, 10]]}]}"

static wcut_regions *regions;
static wcut_error error;

static void read_zones(const char *text) {
    write_file("zones.json", text);
    ck_assert_msg(wcut_regions_read("zones.json", &regions, &error) == WCUT_OK, "%s", error.text);
}

/* a grid of 1 mm over 30 x 20 mm: the face is z = 0, the scan is at 0.01 x */
enum { POINTS = 30 * 20 };
static wcut_vec3 point[POINTS];
static wcut_deviation deviation[POINTS];

static void make_points(void) {
    for (int k = 0; k < POINTS; k++) {
        const double x = k % 30 + 0.5, y = k / 30 + 0.5;
        point[k] = (wcut_vec3){x, y, 0.01 * x};
        deviation[k] = (wcut_deviation){.distance = 0.01 * x, .foot = {x, y, 0}, .place = WCUT_PLACE_INSIDE};
    }
}

/* the outer face of a half with three pockets, each of radius 6 mm at 9 mm from two sides */
static void write_half(const char *path) {
    static const wcut_vec3 block = {100, 80, 60};
    wcut_vec3 node[4] = {{-10, -10, 40}, {110, -10, 40}, {-10, 90, 40}, {110, 90, 40}};
    wcut_key key[WCUT_KEYS_AT_CORNERS];
    wcut_surface *cut = NULL;
    wcut_mould *mould = NULL;
    wcut_mould_options o = wcut_mould_default();
    ck_assert_int_eq(wcut_surface_loft(2, 2, node, 0, &cut, NULL, NULL), WCUT_OK);
    ck_assert_int_eq(wcut_keys_at_corners(block, 6, -5, key), WCUT_OK);
    o.key = key, o.key_count = WCUT_KEYS_AT_CORNERS, o.chord_tolerance = 1;
    ck_assert_msg(wcut_mould_create(cut, block, &o, &mould, &error) == WCUT_OK, "%s", error.text);
    ck_assert_int_eq(wcut_mould_write_step(mould, "half", WCUT_MOULD_PART_LOWER, WCUT_STEP_SCHEMA_AP214, path, &error),
                     WCUT_OK);
    wcut_mould_destroy(mould);
    wcut_surface_destroy(cut);
}

TEST(a_zone_is_a_face_of_a_cad_file_without_its_holes) {
    wcut_survey *survey = NULL;
    enter_folder();
    ck_assert_int_eq(mkdir("cad", 0700), 0);
    write_half("cad/half.step");
    write_file("cad/zones.json",
               "{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"back\", \"tolerance_mm\": 1, "
               "\"step_face\": {\"file\": \"half.step\", \"face\": \"outer face\"}}, {\"name\": \"top\", "
               "\"step_face\": {\"file\": \"half.step\", \"face\": \"cut face\"}}]}");
    ck_assert_msg(wcut_regions_read("cad/zones.json", &regions, &error) == WCUT_OK, "%s", error.text);

    /* every millimetre of 110 x 90 mm */
    wcut_vec3 *x = wcut_alloc(9900, sizeof *x);
    wcut_deviation *d = wcut_alloc(9900, sizeof *d);
    int back = 0, top = 0;
    for (int k = 0; k < 9900; k++) {
        x[k] = (wcut_vec3){k % 110 - 4.5, k / 110 - 4.5, 0};
        d[k] = (wcut_deviation){.distance = 0.5, .foot = x[k], .place = WCUT_PLACE_INSIDE};
        const bool in = x[k].x > 0 && x[k].x < 100 && x[k].y > 0 && x[k].y < 80;
        const double hole =
            fmin(hypot(x[k].x - 9, x[k].y - 9), fmin(hypot(x[k].x - 91, x[k].y - 9), hypot(x[k].x - 9, x[k].y - 71)));
        top += in;
        back += in && hole > 6;
    }
    ck_assert_int_eq(wcut_survey_create(regions, 0, NULL, &survey), WCUT_OK);
    ck_assert_int_eq(wcut_survey_add(survey, 9900, x, d), WCUT_OK);
    const wcut_survey_result *r = wcut_survey_eval(survey);
    ck_assert_int_eq(top, 8000);
    ck_assert_int_eq(r->region[0].count, back);
    ck_assert_int_eq(r->region[1].count, top);
    ck_assert_int_eq(r->region[0].passed, 1);
    wcut_survey_destroy(survey);
    wcut_regions_destroy(regions);
    wcut_free(d);
    wcut_free(x);

    /* what is no face, or seen on edge */
    static const struct {
        const char *face, *words;
    } bad[] = {{"{\"file\": \"half.step\"}", "one face of the file"},
               {"{\"file\": \"half.step\", \"face\": 99}", "one face of the file"},
               {"{\"file\": \"half.step\", \"face\": \"side x = 0\"}", "seen on edge"},
               {"{\"file\": \"none.step\"}", "none.step"},
               {"{\"file\": 3}", "the name of a STEP or IGES file"},
               {"{\"file\": \"half.step\", \"face\": []}", "a name or a number"},
               {"{\"file\": \"half.step\", \"colour\": 1}", "alone"},
               {"7", "the name of a STEP or IGES file"}};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        char text[400];
        snprintf(text, sizeof text,
                 "{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\", \"step_face\": %s}]}", bad[k].face);
        write_file("cad/zones.json", text);
        regions = NULL;
        ck_assert_int_ne(wcut_regions_read("cad/zones.json", &regions, &error), WCUT_OK);
        ck_assert_msg(!regions && strstr(error.text, bad[k].words) != NULL, "%s: %s", bad[k].face, error.text);
    }
    unlink("cad/half.step");
    unlink("cad/zones.json");
    leave_folder();
}

TEST(zones_and_sections_hold_what_lies_in_them) {
    wcut_survey *survey = NULL;
    enter_folder();
    read_zones(ZONES);
    ck_assert(regions->regions == 4 && regions->sections == 2);
    make_points();
    deviation[POINTS - 1].place = WCUT_PLACE_BEYOND;
    static const double band[] = {0.02, 0.05};
    ck_assert_int_eq(wcut_survey_create(regions, 2, band, &survey), WCUT_OK);
    ck_assert_int_eq(wcut_survey_add(survey, 100, point, deviation), WCUT_OK);
    ck_assert_int_eq(wcut_survey_add(survey, POINTS - 100, point + 100, deviation + 100), WCUT_OK);
    const wcut_survey_result *r = wcut_survey_eval(survey);

    /* x in 0 .. 10: mean 0.05, all within 0.2 */
    const wcut_region_result *f = r->region;
    ck_assert(f[0].count == 200 && f[0].within == 1 && f[0].passed == 1);
    ck_assert_double_eq_tol(f[0].mean, 0.05, 1e-12);
    ck_assert_double_eq_tol(f[0].mae, 0.05, 1e-12);
    ck_assert(f[0].within_band[0] == 0.2 && f[0].within_band[1] == 0.5 && r->bands == 2);
    ck_assert_double_eq_tol(f[0].rms, 0.01 * sqrt(33.25), 1e-12);
    ck_assert_double_eq_tol(f[0].min, 0.005, 1e-15);
    ck_assert_double_eq_tol(f[0].max, 0.095, 1e-15);

    /* below the diagonal: column x has x - 10 points; within 0.2 are columns 10 .. 19 */
    double count = 0, within = 0, sum = 0;
    for (int k = 0; k < POINTS; k++)
        if (point[k].y < point[k].x - 10.2 && k != POINTS - 1)
            count++, within += point[k].x <= 20, sum += 0.01 * point[k].x;
    ck_assert(f[1].count == count && f[1].passed == 0);
    ck_assert_double_eq_tol(f[1].within, within / count, 1e-12);
    ck_assert_double_eq_tol(f[1].mean, sum / count, 1e-12);
    ck_assert(f[2].count == POINTS - 1 && f[2].passed == -1 && f[2].within == 0);
    ck_assert(f[3].count == 0 && f[3].passed == 0 && r->passed == 0);

    /* rows y = 9.5 and 10.5, steps of 10 mm */
    const wcut_section_result *s = r->section;
    ck_assert_int_eq(s[0].rows, 3);
    for (int k = 0; k < 3; k++) {
        ck_assert_int_eq(s[0].row[k].count, 20);
        ck_assert(s[0].row[k].along == 10 * k + 5 && s[0].row[k].x == 10 * k + 5 && s[0].row[k].y == 10);
        ck_assert_double_eq_tol(s[0].row[k].measured, 0.01 * (10 * k + 5), 1e-12);
        ck_assert_double_eq_tol(s[0].row[k].deviation, 0.01 * (10 * k + 5), 1e-12);
        ck_assert(s[0].row[k].nominal == 0);
    }
    ck_assert_int_eq(s[1].rows, 2);
    ck_assert(s[1].row[1].x == 10 && s[1].row[1].y == 10);

    /* as a table */
    wcut_table *table = NULL;
    static const char *const numeric[] = {"along_mm", "nominal_z_mm", "measured_z_mm", "deviation_mm", "count"};
    ck_assert_int_eq(wcut_sections_write(r, "sections.csv", NULL), WCUT_OK);
    ck_assert_int_eq(wcut_table_read("sections.csv", 5, numeric, &table, NULL), WCUT_OK);
    ck_assert_int_eq(table->rows, 5);
    ck_assert_double_eq_tol(table->column[wcut_table_locate(table, "deviation_mm")].value[1], 0.15, 1e-12);
    wcut_table_destroy(table);
    ck_assert_int_eq(wcut_sections_write(NULL, "sections.csv", NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_sections_write(r, "/nowhere/sections.csv", NULL), WCUT_NOT_WRITTEN);
    wcut_survey_destroy(survey);
    wcut_regions_destroy(regions);
    leave_folder();
}

TEST(what_is_no_zone_and_no_section_is_refused_with_its_place) {
    static const struct {
        const char *text, *words;
    } bad[] = {
        {"{\"format\": \"wirecut-job/1\"}", "expected \"wirecut-zones/1\"; simulate"},
        {"{\"format\": \"wirecut-zones/1\"}", "a zone or a section at least"},
        {"{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\"}]}",
         "one of \"box_mm\", \"polygon_mm\", \"step_face\""},
        {"{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a,b\", \"box_mm\": [[0,0,0],[1,1,1]]}]}",
         "$.zones[0].name: found \"a,b\", expected a name"},
        {"{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\", \"box_mm\": [[0,0,0],[1,-1,1]]}]}",
         "a lower corner, then an upper one"},
        {"{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\", \"polygon_mm\": [[0,0],[1,1]]}]}",
         "3 to 1000 points"},
        {"{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\", \"polygon_mm\": [[0,0],[1,1],[2,1e13]]}]}",
         "a coordinate up to 1e12 mm"},
        {"{\"format\": \"wirecut-zones/1\", \"zones\": [{\"name\": \"a\", \"box_mm\": [[0,0,0],[1,1,1]], "
         "\"share_percent\": 101}]}",
         "a percentage, 0 to 100"},
        {"{\"format\": \"wirecut-zones/1\", \"sections\": [{\"name\": \"a\", \"line_mm\": [[0,0],[0,0]]}]}",
         "neighbours apart"},
        {"{\"format\": \"wirecut-zones/1\", \"sections\": [{\"name\": \"a\", \"line_mm\": [[0,0],[0,1]], \"step_mm\": "
         "0}]}",
         "$.sections[0].step_mm: found 0"},
    };
    enter_folder();
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        regions = (wcut_regions *)&error;
        write_file("zones.json", bad[k].text);
        const wcut_status status = wcut_regions_read("zones.json", &regions, &error);
        ck_assert_msg(status == WCUT_BAD_FORMAT || status == WCUT_BAD_ARGUMENT, "read: %s", bad[k].text);
        ck_assert_ptr_eq(regions, (wcut_regions *)&error);
        ck_assert_msg(strstr(error.text, bad[k].words) != NULL, "found: %s\nexpected: %s", error.text, bad[k].words);
    }
    ck_assert_int_eq(wcut_regions_read("nowhere.json", &regions, &error), WCUT_NOT_FOUND);
    ck_assert_int_eq(wcut_regions_read(NULL, &regions, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_regions_read("zones.json", NULL, NULL), WCUT_BAD_ARGUMENT);

    /* steps without end, memory */
    write_file("zones.json",
               "{\"format\": \"wirecut-zones/1\", \"sections\": [{\"name\": \"a\", \"line_mm\": [[0,0],[0,9e9]], "
               "\"step_mm\": 1e-9}]}");
    ck_assert_int_eq(wcut_regions_read("zones.json", &regions, &error), WCUT_OK);
    wcut_survey *survey = NULL;
    ck_assert_int_eq(wcut_survey_create(regions, 0, NULL, &survey), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_survey_create(NULL, 0, NULL, &survey), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_survey_add(NULL, 0, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_null(wcut_survey_eval(NULL));
    wcut_regions_destroy(regions);
    regions = NULL;
    write_file("zones.json", ZONES);
    EACH_FAILED_ALLOCATION(wcut_regions_read("zones.json", &regions, &error), !regions);
    EACH_FAILED_ALLOCATION(wcut_survey_create(regions, 0, NULL, &survey), !survey);
    wcut_survey_destroy(survey);
    wcut_regions_destroy(regions);
    leave_folder();
}
