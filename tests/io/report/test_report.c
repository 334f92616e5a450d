/* wcut_report_write: what stands in the file, what is refused, what thinning keeps. The page itself is opened in
   tests/report. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/file/sha256.h"
#include "io/report/report_page.h"
#include "report/pages.h"
#include "test.h"

static pages_data data;
static char folder[] = "/tmp/wirecut-report-XXXXXX", path[64];
static wcut_error error;

static void given_a_folder(void) {
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/report.html", folder);
    pages_fill(&data);
}

static void then_tidy(void) {
    remove(path);
    ck_assert_msg(rmdir(folder) == 0, "something else was left in the folder");
    strcpy(folder, "/tmp/wirecut-report-XXXXXX");
}

/* the whole file; to free */
static char *read_page(size_t *size) {
    FILE *file = fopen(path, "rb");
    ck_assert_ptr_nonnull(file);
    fseek(file, 0, SEEK_END);
    *size = (size_t)ftell(file);
    rewind(file);
    char *text = calloc(*size + 1, 1);
    ck_assert_ptr_nonnull(text);
    ck_assert_uint_eq(fread(text, 1, *size, file), *size);
    fclose(file);
    return text;
}

static int count_of(const char *text, const char *word) {
    int count = 0;
    for (const char *at = text; (at = strstr(at, word)); at++) count++;
    return count;
}

/* the JSON between its tags; to json_decref */
static json_t *read_document(const char *page) {
    static const char tag[] = "<script type=\"application/json\" id=\"report\">";
    const char *from = strstr(page, tag);
    ck_assert_ptr_nonnull(from);
    from += strlen(tag);
    const char *to = strstr(from, "</script>");
    ck_assert_ptr_nonnull(to);
    json_error_t where;
    json_t *document = json_loadb(from, (size_t)(to - from), JSON_REJECT_DUPLICATES, &where);
    ck_assert_msg(document != NULL, "%s", where.text);
    return document;
}

/* the least page that is written */
static wcut_report plain(void) { return (wcut_report){.verb = "simulate", .title = "a job", .verdict = "It was cut."}; }

TEST(the_same_report_gives_the_same_bytes) {
    given_a_folder();
    size_t size[2];
    char *page[2];
    for (int k = 0; k < 2; k++) {
        ck_assert_int_eq(pages_write_cut(&data, path, &error), WCUT_OK);
        page[k] = read_page(&size[k]);
    }
    ck_assert(size[0] == size[1] && memcmp(page[0], page[1], size[0]) == 0);
    free(page[0]);
    free(page[1]);
    then_tidy();
}

TEST(hostile_names_end_no_element_and_come_back_whole) {
    given_a_folder();
    ck_assert_int_eq(pages_write_cut(&data, path, &error), WCUT_OK);
    size_t size;
    char *page = read_page(&size);
    json_t *document = read_document(page);
    const int arrays = count_of(page, "<script type=\"text/plain\"");
    ck_assert_int_gt(arrays, 10);
    ck_assert_msg(strlen(page) == size, "a zero byte");
    /* document, arrays, program: nothing else begins or ends */
    ck_assert_int_eq(count_of(page, "<script"), arrays + 2);
    ck_assert_int_eq(count_of(page, "</script"), arrays + 2);
    ck_assert_int_eq(count_of(page, "<style"), 1);
    ck_assert_int_eq(count_of(page, "<img src"), 0);
    ck_assert_int_eq(count_of(page, "<!--"), 0);
    const char *title = json_string_value(json_object_get(document, "title"));
    ck_assert_ptr_nonnull(strstr(title, "</script><script>window.broken=1</script>"));
    ck_assert_ptr_nonnull(strstr(title, "\xe2\x80\xa8\xe2\x80\xa9 \xef\xbf\xbd"));
    json_decref(document);
    free(page);
    then_tidy();
}

TEST(the_policy_pins_the_script_and_the_style_that_are_there) {
    given_a_folder();
    wcut_report report = plain();
    ck_assert_int_eq(wcut_report_write(&report, path, &error), WCUT_OK);
    size_t size;
    char *page = read_page(&size);
    static const struct {
        const char *before, *after, *source;
    } pinned[] = {{"<script>", "</script>", "script-src 'sha256-"}, {"<style>", "</style>", "style-src 'sha256-"}};
    for (int k = 0; k < 2; k++) {
        const char *from = strstr(page, pinned[k].before) + strlen(pinned[k].before);
        const char *to = strstr(from, pinned[k].after);
        wcut_sha256 hash;
        uint8_t digest[WCUT_SHA256_SIZE];
        char text[45] = "";
        wcut_sha256_begin(&hash);
        wcut_sha256_add(&hash, from, (size_t)(to - from));
        wcut_sha256_end(&hash, digest);
        wcut_base64_print(sizeof digest, digest, text);
        ck_assert_int_eq(strncmp(strstr(page, pinned[k].source) + strlen(pinned[k].source), text, 44), 0);
    }
    ck_assert_ptr_nonnull(strstr(page, "default-src 'none'"));
    ck_assert_ptr_null(strstr(page, "unsafe"));
    free(page);
    then_tidy();
}

TEST(both_libraries_keep_their_licences) {
    const char *script = (const char *)wcut_report_script;
    char head[4096];
    memcpy(head, script, sizeof head - 1);
    head[sizeof head - 1] = 0;
    ck_assert_int_eq(count_of(head, "The MIT License"), 2);
    ck_assert_ptr_nonnull(strstr(head, "three.js authors"));
    ck_assert_ptr_nonnull(strstr(head, "Leon Sorokin"));
}

TEST(numbers_come_back_exact_and_gaps_as_null) {
    given_a_folder();
    const double number[] = {0.1, NAN, -1e-300};
    const wcut_report_column column = {"value", "mm", number, NULL};
    const wcut_report_table table = {"t", NULL, 3, 1, &column};
    const wcut_report_section section = {"s", NULL, 0, 0, 1, NULL, NULL, &table, NULL};
    const wcut_report_fact fact = {"f", NULL, 1.0 / 3, "N"};
    wcut_report report = plain();
    report.section_count = 1, report.section = &section, report.fact_count = 1, report.fact = &fact;
    ck_assert_int_eq(wcut_report_write(&report, path, &error), WCUT_OK);
    size_t size;
    char *page = read_page(&size);
    json_t *document = read_document(page), *cells;
    double value;
    ck_assert_int_eq(json_unpack(document, "{s:[{s:f}]}", "facts", "value", &value), 0);
    ck_assert(value == 1.0 / 3);
    ck_assert_int_eq(
        json_unpack(document, "{s:[{s:[{s:[{s:o}]}]}]}", "sections", "tables", "columns", "numbers", &cells), 0);
    ck_assert(json_real_value(json_array_get(cells, 0)) == 0.1 && json_real_value(json_array_get(cells, 2)) == -1e-300);
    ck_assert(json_is_null(json_array_get(cells, 1)));
    json_decref(document);
    free(page);
    then_tidy();
}

TEST(a_million_points_stay_under_25_megabytes) {
    given_a_folder();
    ck_assert(pages_fill_cloud(&data));
    ck_assert_int_eq(pages_write_cloud(&data, path, &error), WCUT_OK);
    struct stat s;
    ck_assert_int_eq(stat(path, &s), 0);
    ck_assert_int_le(s.st_size, 25000000);
    pages_free(&data);
    then_tidy();
}

TEST(more_than_25_megabytes_are_refused_and_the_target_stays) {
    given_a_folder();
    enum { CELLS = 1000 };
    static double x[CELLS], value[CELLS * CELLS];
    for (int i = 0; i < CELLS; i++) x[i] = i;
    wcut_report_map map[5];
    for (int k = 0; k < 5; k++)
        map[k] = (wcut_report_map){"m", NULL,  "x",   "",   "y", "",    "v",
                                   "",  CELLS, CELLS, x,    x,   value, WCUT_REPORT_SCALE_SEQUENTIAL,
                                   0,   false, 0,     NULL, NULL};
    wcut_report_section section = {"s", NULL, 0, 4, 0, NULL, map, NULL, NULL};
    wcut_report report = plain();
    report.section_count = 1, report.section = &section;
    ck_assert_int_eq(wcut_report_write(&report, path, &error), WCUT_OK);
    struct stat before, after;
    ck_assert_int_eq(stat(path, &before), 0);
    section.map_count = 5;
    ck_assert_int_eq(wcut_report_write(&report, path, &error), WCUT_BAD_ARGUMENT);
    ck_assert_ptr_nonnull(strstr(error.text, "at most 25 MB"));
    ck_assert_int_eq(stat(path, &after), 0);
    ck_assert(before.st_ino == after.st_ino && before.st_size == after.st_size);
    then_tidy();
}

/* every part of a report broken in turn: refused with a word, and no file appears */
TEST(what_breaks_a_limit_is_refused_and_nothing_is_written) {
    given_a_folder();
    double x[] = {0, 1, 2, 3}, y[] = {1, 2, NAN, 4}, low[] = {0, 0, 0, 0};
    int triangle[] = {0, 1, 2};
    const char *text[] = {"a", NULL, "b", "c"};
    wcut_vec3 vertex[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    for (int broken = -1; broken < 36; broken++) {
        wcut_report_fact fact = {"f", NULL, 1, ""};
        wcut_report_series series = {"s", WCUT_REPORT_MARK_LINE, 4, {x, NULL}, y, NULL, NULL};
        wcut_report_span span = {"p", {0, 0}, {1, 1}};
        wcut_report_chart chart = {.title = "c",
                                   .x_label = {"x"},
                                   .y_label = "y",
                                   .series_count = 1,
                                   .series = &series,
                                   .span_count = 1,
                                   .span = &span};
        int band[] = {0, 1};
        const char *name[] = {"p", "q"};
        wcut_report_map map = {"m", NULL,  "x", "",   "y", "", "v", "", 2, 2, x, x, y, WCUT_REPORT_SCALE_DIVERGING,
                               0,   false, 2,   band, name};
        wcut_report_column column[] = {{"n", "", x, NULL}, {"t", "", NULL, text}};
        wcut_report_table table = {"t", NULL, 4, 2, column};
        wcut_report_section section = {"s", NULL, 1, 1, 1, &chart, &map, &table, NULL};
        wcut_report_field field = {"f", "", WCUT_REPORT_SCALE_DIVERGING, 0.1, y};
        wcut_report_shape shape = {.name = "s",
                                   .vertex_count = 4,
                                   .vertex = vertex,
                                   .triangle_count = 1,
                                   .triangle = triangle,
                                   .field_count = 1,
                                   .field = &field};
        wcut_report_line line = {"g", NULL, 4, vertex};
        wcut_report_scene scene = {.title = "s", .shape_count = 1, .shape = &shape, .line_count = 1, .line = &line};
        wcut_report_source source = {"job", "j.json", NULL};
        wcut_report r = {.verb = "v",
                         .title = "t",
                         .verdict = "w",
                         .fact_count = 1,
                         .fact = &fact,
                         .scene = &scene,
                         .section_count = 1,
                         .section = &section,
                         .source_count = 1,
                         .source = &source};
        double decreasing[] = {0, 2, 1, 3}, infinite[] = {0, 1, INFINITY, 3}, huge[] = {0, 1, 2e30, 3};
        wcut_vec3 away[] = {{0, 0, 0}, {NAN, 0, 0}, {0, 1, 0}, {1, 1, 0}};
        int missing[] = {0, 1, 4};
        switch (broken) {
            case 0:
                r.title = NULL;
                break;
            case 1:
                r.fact = NULL;
                break;
            case 2:
                fact.label = NULL;
                break;
            case 3:
                fact.value = INFINITY;
                break;
            case 4:
                series.x[0] = decreasing;
                break;
            case 5:
                series.y = infinite;
                break;
            case 6:
                series.low = low;
                break;
            case 7:
                series.count = 0;
                break;
            case 8:
                chart.series_count = 9;
                break;
            case 9:
                chart.y_label = NULL;
                break;
            case 10:
                span.to[1] = NAN;
                break;
            case 11:
                map.x = decreasing + 1;
                break;
            case 12:
                map.rows = 1;
                break;
            case 13:
                map.rows = 2000, map.columns = 2000;
                break;
            case 14:
                column[1].number = x;
                break;
            case 15:
                column[0].number = huge;
                break;
            case 16:
                table.rows = -1;
                break;
            case 17:
                shape.vertex = away;
                break;
            case 18:
                shape.rows = 2, shape.columns = 3;
                break;
            case 19:
                shape.triangle = missing;
                break;
            case 20:
                shape.field_count = 13;
                break;
            case 21:
                field.value = huge;
                break;
            case 22:
                field.tolerance = -1;
                break;
            case 23:
                scene.block_size.x = -1;
                break;
            case 24:
                scene.shape_count = 0;
                break;
            case 25:
                line.group = NULL;
                break;
            case 26:
                source.name = NULL;
                break;
            case 27:
                r.tone = (wcut_report_tone)7;
                break;
            case 28:
                series.mark = (wcut_report_mark)-1;
                break;
            case 29:
                section.title = NULL;
                break;
            case 30:
                map.limit = NAN;
                break;
            case 31:
                shape.rows = 2, shape.columns = 2;
                break; /* a grid has no triangles of its own */
            case 32:
                map.band_label = NULL;
                break;
            case 33:
                name[1] = NULL;
                break;
            case 34:
                band[1] = 0;
                break;
            case 35:
                band[1] = 2; /* of two rows */
                break;
            default:
                break;
        }
        error.text[0] = 0;
        const wcut_status status = wcut_report_write(&r, path, &error);
        ck_assert_msg(status == (broken < 0 ? WCUT_OK : WCUT_BAD_ARGUMENT), "%d: %s", broken, error.text);
        ck_assert_msg(broken < 0 || strncmp(error.text, "report: ", 8) == 0, "%d: %s", broken, error.text);
        ck_assert_int_eq(access(path, F_OK) == 0, broken < 0);
        remove(path);
    }
    wcut_report r = plain();
    ck_assert_int_eq(wcut_report_write(NULL, path, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_report_write(&r, NULL, NULL), WCUT_BAD_ARGUMENT);
    then_tidy();
}

TEST(a_folder_that_is_not_there_is_not_written_to) {
    wcut_report report = plain();
    ck_assert_int_eq(wcut_report_write(&report, "/nowhere/report.html", &error), WCUT_NOT_WRITTEN);
    ck_assert_ptr_nonnull(strstr(error.text, "/nowhere/report.html"));
}

TEST(out_of_memory_anywhere_leaves_no_file) {
    given_a_folder();
    EACH_FAILED_ALLOCATION(pages_write_cut(&data, path, &error), access(path, F_OK) != 0);
    then_tidy();
}

TEST(base64_is_that_of_rfc_4648) {
    static const char *const pair[][2] = {{"", ""},
                                          {"f", "Zg=="},
                                          {"fo", "Zm8="},
                                          {"foo", "Zm9v"},
                                          {"foob", "Zm9vYg=="},
                                          {"fooba", "Zm9vYmE="},
                                          {"foobar", "Zm9vYmFy"},
                                          {"\xff\xef\xbe", "/+++"}};
    for (size_t k = 0; k < sizeof pair / sizeof *pair; k++) {
        char text[16] = "";
        wcut_base64_print(strlen(pair[k][0]), pair[k][0], text);
        ck_assert_str_eq(text, pair[k][1]);
    }
}

TEST(bytes_that_are_no_utf_8_are_replaced_one_by_one) {
    static const char *const pair[][2] = {
        {"plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80", "plain \xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80"},
        {"\xff", "\xef\xbf\xbd"},
        {"a\xc3", "a\xef\xbf\xbd"},                                               /* cut off */
        {"\xc0\xaf", "\xef\xbf\xbd\xef\xbf\xbd"},                                 /* overlong */
        {"\xed\xa0\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"},                 /* surrogate */
        {"\xf4\x90\x80\x80", "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd"}, /* beyond U+10FFFF */
    };
    for (size_t k = 0; k < sizeof pair / sizeof *pair; k++) {
        char *clean = wcut_report_text(pair[k][0]);
        ck_assert_str_eq(clean, pair[k][1]);
        free(clean);
    }
}

TEST(a_thinned_series_keeps_lowest_highest_and_gaps) {
    enum { COUNT = 100000, MAX = 1000 };
    static double value[COUNT];
    static int index[COUNT];
    for (int i = 0; i < COUNT; i++) value[i] = sin(0.01 * i);
    value[12345] = 9, value[77777] = -9;
    for (int i = 40000; i < 41000; i++) value[i] = NAN;
    const int kept = wcut_report_thin(COUNT, value, MAX, index);
    ck_assert(kept > MAX / 2 && kept <= MAX);
    bool top = false, bottom = false, gap = false;
    for (int k = 0; k < kept; k++) {
        ck_assert(k == 0 || index[k] > index[k - 1]);
        top |= index[k] == 12345, bottom |= index[k] == 77777, gap |= isnan(value[index[k]]);
    }
    ck_assert(top && bottom && gap);
    ck_assert_int_eq(wcut_report_thin(MAX, value, MAX, index), MAX);
    ck_assert_int_eq(index[MAX - 1], MAX - 1);
}

TEST(quantiles_are_order_statistics_of_what_is_there) {
    enum { COUNT = 1001 };
    double value[COUNT + 1], quantile[11];
    for (int i = 0; i < COUNT; i++) value[i] = (i * 7919) % COUNT;
    value[COUNT] = NAN;
    int found = 999;
    ck_assert_int_eq(wcut_report_quantiles(COUNT + 1, value, 11, quantile, &found), WCUT_OK);
    ck_assert_int_eq(found, COUNT);
    for (int k = 0; k < 11; k++) ck_assert_double_eq(quantile[k], 100 * k);
    quantile[0] = 999;
    ck_assert_int_eq(wcut_report_quantiles(1, value + COUNT, 11, quantile, &found), WCUT_OK);
    ck_assert(found == 0 && quantile[0] == 999);
}

TEST(a_big_grid_is_thinned_evenly_with_its_last_row_and_column) {
    enum { ROWS = 3001, COLUMNS = 401 };
    static double value[ROWS * COLUMNS];
    static wcut_vec3 vertex[ROWS * COLUMNS];
    const wcut_report_field field = {"f", "", WCUT_REPORT_SCALE_SEQUENTIAL, 0, value};
    const wcut_report_shape shape = {.name = "s",
                                     .vertex_count = ROWS * COLUMNS,
                                     .vertex = vertex,
                                     .rows = ROWS,
                                     .columns = COLUMNS,
                                     .row_label = "r",
                                     .column_label = "c",
                                     .field_count = 1,
                                     .field = &field};
    wcut_report_view view;
    ck_assert_int_eq(wcut_report_view_create(&shape, 1, &view), WCUT_OK);
    ck_assert(view.count == view.rows * view.columns && view.count <= WCUT_REPORT_VERTICES &&
              view.count > WCUT_REPORT_VERTICES / 4);
    ck_assert_int_eq(view.index[0], 0);
    ck_assert_int_eq(view.index[1], view.column_stride);
    ck_assert_int_eq(view.index[view.columns], view.row_stride * COLUMNS);
    ck_assert_int_eq(view.index[view.columns - 1], COLUMNS - 1);
    ck_assert_int_eq(view.index[view.count - 1], ROWS * COLUMNS - 1);
    free(view.index);
}

TEST(cases_outside_their_limits_are_refused_and_those_within_are_not) {
    given_a_folder();
    double x[3] = {1, 2, NAN};
    int number[3] = {0, 1, 2}, best[1] = {2};
    const char *link[3] = {"a", NULL, "b"}, *word[3] = {"u", NULL, "v"};
    const wcut_report_column column[] = {{"x", "", x, NULL}, {"w", "", NULL, word}};
    const wcut_report_cases sound = {3, 2, 1, column, number, link, 0, false, 1, best, NULL};
    for (int broken = -1; broken < 10; broken++) {
        wcut_report_cases cases = sound;
        const wcut_report_section section = {.title = "s", .cases = &cases};
        wcut_report report = plain();
        report.section_count = 1;
        report.section = &section;
        best[0] = broken == 0 ? 3 : 2;
        if (broken == 1) cases.rows = 0;
        if (broken == 2) cases.rows = 20001;
        if (broken == 3) cases.columns = 1;
        if (broken == 4) cases.column = NULL;
        if (broken == 5) cases.number = NULL;
        if (broken == 6) cases.link = NULL;
        if (broken == 7) cases.goal = 2;
        if (broken == 8) cases.parameters = 3;
        if (broken == 9) cases.best = NULL;
        ck_assert_msg(wcut_report_write(&report, path, &error) == (broken < 0 ? WCUT_OK : WCUT_BAD_ARGUMENT), "%d",
                      broken);
    }
    then_tidy();
}
