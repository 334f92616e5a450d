/* CSV text to tables: numbers to the last bit, missing samples, and every way to be malformed. */
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/random.h"
#include "io/file/csv.h"
#include "io/file/decimal.h"
#include "io/file/read_file.h"
#include "test.h"

static const char *const numeric[] = {"x", "y"};
static wcut_table *table;
static wcut_error error;

static wcut_status parse(const char *text) {
    wcut_table_destroy(table);
    table = NULL;
    memset(&error, 0, sizeof error);
    return wcut_csv_parse(text, strlen(text), WCUT_STREAM_WINDOW, "t.csv", 2, numeric, &table, &error);
}

static void forget(void) {
    wcut_table_destroy(table);
    table = NULL;
}

/* refused with WCUT_BAD_FORMAT, the words in the message, and no table */
static void refused(const char *text, const char *words) {
    ck_assert_int_eq(parse(text), WCUT_BAD_FORMAT);
    ck_assert_ptr_null(table);
    ck_assert_msg(strstr(error.text, words) != NULL, "found: %s\nexpected: %s", error.text, words);
}

TEST(columns_come_back_by_name_and_value) {
    ck_assert_int_eq(parse("x,y\n1,2\n-3.5,4e2\n"), WCUT_OK);
    ck_assert_int_eq(table->rows, 2);
    ck_assert_int_eq(table->columns, 2);
    int x = wcut_table_locate(table, "x"), y = wcut_table_locate(table, "y");
    ck_assert(table->column[x].value[0] == 1 && table->column[x].value[1] == -3.5);
    ck_assert(table->column[y].value[0] == 2 && table->column[y].value[1] == 400);
    ck_assert(table->column[x].present == NULL && table->column[x].missing == 0);
    ck_assert_int_eq(wcut_table_locate(table, "z"), -1);
    ck_assert_int_eq(wcut_table_locate(NULL, "x"), -1);
    forget();
}

TEST(comments_empty_lines_mark_crlf_quotes_and_blanks_are_tolerated) {
    ck_assert_int_eq(parse("\xef\xbb\xbf# by the machine\r\n\r\n\"x\", y ,\"a, \"\"b\"\"\nc\"\r\n"
                           "# here too\r\n 1 ,\"2\",\t3\r\n\n4,5,6"),
                     WCUT_OK);
    ck_assert_int_eq(table->rows, 2);
    ck_assert_str_eq(table->column[2].name, "a, \"b\"\nc");
    ck_assert(table->column[1].value[0] == 2 && table->column[2].value[0] == 3 && table->column[2].value[1] == 6);
    ck_assert_int_eq(table->line[0], 6);
    ck_assert_int_eq(table->line[1], 8);
    forget();
}

TEST(an_empty_field_or_nan_is_missing_and_is_no_number) {
    ck_assert_int_eq(parse("x,y\n1,\n,NaN\n3,\"\"\n"), WCUT_OK);
    const wcut_column *x = &table->column[0], *y = &table->column[1];
    ck_assert(x->missing == 1 && x->present[0] == 1 && x->present[1] == 0 && x->present[2] == 1 && x->value[1] == 0);
    ck_assert(y->missing == 3 && y->text == 0 && y->value[0] == 0 && y->value[1] == 0 && y->value[2] == 0);
    forget();
}

TEST(text_in_an_unknown_column_is_kept_as_missing_and_counted) {
    ck_assert_int_eq(parse("x,y,note\n1,2,first\n3,4,\n5,6,1e999\n7,8,9\n"), WCUT_OK);
    ck_assert_int_eq(table->column[2].missing, 3);
    ck_assert_int_eq(table->column[2].text, 2);
    ck_assert(table->column[2].value[3] == 9);
    forget();
}

TEST(no_rows_are_a_table_too) {
    ck_assert_int_eq(parse("x,y"), WCUT_OK);
    ck_assert(table->rows == 0 && table->columns == 2);
    ck_assert_int_eq(parse("x,y\n"), WCUT_OK);
    ck_assert_int_eq(table->rows, 0);
    forget();
}

/* two rows of x and y whose first is 1 and 2.5, whose second has no y */
static void check_two_rows(const char *text) {
    ck_assert_msg(parse(text) == WCUT_OK, "%s: %s", text, error.text);
    ck_assert_msg(table->columns == 2 && table->rows == 2, "%s: %d columns, %d rows", text, table->columns,
                  table->rows);
    const wcut_column *x = &table->column[0], *y = &table->column[1];
    ck_assert_str_eq(x->name, "x");
    ck_assert_str_eq(y->name, "y");
    ck_assert(x->value[0] == 1 && y->value[0] == 2.5 && x->value[1] == -3 && y->missing == 1);
    forget();
}

TEST(four_separators_are_told_by_the_header) {
    check_two_rows("x,y\n1,2.5\n-3,\n");
    check_two_rows("x;y\n1;2.5\n-3;\n");
    check_two_rows("# of another program, with commas\nx ; y\r\n1 ; 2,5\r\n-3 ; nan\r\n");
    check_two_rows("x\ty\n1\t2.5\n-3\t\n");
    check_two_rows(" x\t y\n1\t 2,5 \n -3\tnan\n");
    check_two_rows("x y\n1 2.5\n-3 nan\n");
    check_two_rows("  x   y \n  1.0   2,5\n -3.0 \t nan  \n");
    check_two_rows("\"x\" \"y\"\n1 \"2.5\"\n-3 \"nan\"\n");
    check_two_rows("\"x\";\"y\"\n\"1\";\"2,5\"\n-3;\n");
}

TEST(a_single_name_with_a_blank_is_one_column) {
    ck_assert_int_eq(parse("wire tension\n1.5\n"), WCUT_OK);
    ck_assert_int_eq(table->columns, 1);
    ck_assert_str_eq(table->column[0].name, "wire tension");
    forget();
}

TEST(malformed_text_is_refused_with_line_column_and_what_was_expected) {
    refused("", "line 1, column 1: found no header");
    refused("# only words\n", "found no header");
    refused("1,2\n3,4\n", "the names of the columns");
    refused("x,y,x\n", "line 1, column 5: found x, expected every column that is used named once");
    refused("x;y\n1;2;3\n", "line 2, column 4: found more fields than the header has");
    refused("x y\n1 2\n3\n", "line 3, column 2 (y): found the end of the row");
    refused("x\ty\n1\t2 3\n", "line 2, column 3 (y): found 2 3");
    refused("x,y\n1,2\n3\n", "line 3, column 2 (y): found the end of the row");
    refused("x,y\n1,2,3\n", "line 2, column 4: found more fields than the header has");
    refused("x,y\n0,5,1,5\n", "not a decimal comma");
    refused("x,y\n1,\"0,5\"\n", "line 2, column 3 (y): found 0,5, expected a decimal point, not a decimal comma");
    refused("x,y\n1,2\n\n7,abc\n", "line 4, column 3 (y): found abc, expected a number, nan or an empty field");
    refused("x,y\n1,1e999\n", "found 1e999, expected a number a double can hold");
    refused("x,y\n1,inf\n", "found inf");
    refused("x,y\n1,0x10\n", "found 0x10");
    refused("x,y\n1,2 3\n", "found 2 3");
    refused("x,y\n1,\"2\n", "line 2, column 3 (y): found an opening quote");
    refused("x,y\n1,\"2\"3\n", "line 2, column 6 (y): found text after a closing quote");
    refused("x,y\n1,a\"b\n", "found a quote within a field");
    refused("\xff\xfex\0,\0", "found UTF-16");
    const char zero[] = "x,y\n1,\0002\n";
    ck_assert_int_eq(wcut_csv_parse(zero, sizeof zero - 1, WCUT_STREAM_WINDOW, "t.csv", 2, numeric, &table, &error),
                     WCUT_BAD_FORMAT);
    ck_assert_ptr_nonnull(strstr(error.text, "found a zero byte"));
    char wide[2 * 1001 + 1] = "";
    for (int c = 0; c < 1001; c++) memcpy(wide + 2 * c, "a,", 2);
    refused(wide, "more than 1000 columns");
}

TEST(a_message_is_one_printable_line_whatever_the_file_holds) {
    refused("x,y\n1,\"\x1b[31m\nred\"\n", "\\x1b");
    ck_assert_ptr_null(strchr(error.text, '\n'));
}

/* the C library is the oracle: it rounds correctly */
static void as_strtod(const char *text) {
    double value = 999, wanted = strtod(text, NULL);
    const char *behind = wcut_decimal_read(text, &value);
    ck_assert_msg(*behind == '\0' && memcmp(&value, &wanted, sizeof value) == 0, "%s: %.17g, expected %.17g", text,
                  value, wanted);
}

TEST(numbers_of_every_shape_are_the_nearest_double) {
    const char *const text[] = {"0",
                                "-0",
                                "+1",
                                "1.",
                                ".5",
                                "-.5e1",
                                "007",
                                "1e22",
                                "1e23",
                                "9007199254740993",
                                "9007199254740992.5",
                                "123456789012345678901234567890",
                                "2.2250738585072011e-308",
                                "4.9406564584124654e-324",
                                "2.4703282292062327e-324",
                                "1e-400",
                                "1e400",
                                "-1e400",
                                "1.7976931348623157e308",
                                "1.7976931348623159e308",
                                "0.000000000000000000000000000001",
                                "0e99999999999",
                                "1E+05",
                                "8.41000000000000014e21",
                                "1e0000000000001",
                                "0.30000000000000004",
                                "1.00000000000000011102230246251565404236316680908203125",
                                "1.00000000000000011102230246251565404236316680908203124",
                                "18446744073709551615e-27"};
    for (size_t k = 0; k < sizeof text / sizeof text[0]; k++) as_strtod(text[k]);
    wcut_random random = wcut_random_seed(11);
    char buffer[80];
    for (int k = 0; k < 300000; k++) {
        int digits = 1 + wcut_random_below(&random, 20), point = wcut_random_below(&random, digits + 1), n = 0;
        if (wcut_random_below(&random, 2)) buffer[n++] = '-';
        for (int i = 0; i < digits; i++) {
            if (i == point) buffer[n++] = '.';
            buffer[n++] = (char)('0' + wcut_random_below(&random, 10));
        }
        buffer[n] = '\0';
        if (k % 2)
            snprintf(buffer + n, sizeof buffer - (size_t)n, "e%d",
                     wcut_random_below(&random, k % 3 ? 60 : 700) - (k % 3 ? 30 : 350));
        as_strtod(buffer);
    }
}

TEST(halfway_cases_round_to_even) {
    /* m + 1/2 in units of the last place, written out: 54-bit odd integers over powers of two */
    wcut_random random = wcut_random_seed(12);
    char buffer[80];
    for (int k = 0; k < 100000; k++) {
        uint64_t odd = (wcut_random_bits(&random) >> 10) | (uint64_t)1 << 53 | 1;
        int places = wcut_random_below(&random, 3);
        snprintf(buffer, sizeof buffer, "%llu%s", (unsigned long long)(odd >> places),
                 places == 0   ? ""
                 : places == 1 ? ".5"
                               : ".25");
        as_strtod(buffer);
    }
}

TEST(text_that_is_no_number_is_not_touched) {
    const char *const text[] = {"", "-", "+", ".", "e5", "-.e1", "nan", "inf", " 1", "--1"};
    for (size_t k = 0; k < sizeof text / sizeof text[0]; k++) {
        double value = 999;
        ck_assert_ptr_eq(wcut_decimal_read(text[k], &value), text[k]);
        ck_assert(value == 999);
    }
    double value;
    const char *tail = "1e+x";
    ck_assert_ptr_eq(wcut_decimal_read(tail, &value), tail + 1);
}

/* the table of a text through a window, as words; the refusal where there is none */
static void say_table(const char *text, size_t window, char *said, size_t size) {
    wcut_table *found = NULL;
    wcut_error why = {WCUT_OK, ""};
    const wcut_status status = wcut_csv_parse(text, strlen(text), window, "t.csv", 2, numeric, &found, &why);
    size_t used = (size_t)snprintf(said, size, "%d %s\n", (int)status, why.text);
    for (int i = 0; found && i < found->rows; i++) {
        used += (size_t)snprintf(said + used, size - used, "%d:", found->line[i]);
        for (int c = 0; c < found->columns; c++) {
            const wcut_column *x = &found->column[c];
            used += (size_t)snprintf(said + used, size - used, " %s %.17g %d", x->name, x->value[i],
                                     !x->present || x->present[i]);
        }
        ck_assert_uint_lt(used, size);
    }
    wcut_table_destroy(found);
}

TEST(a_table_does_not_depend_on_the_window) {
    static const char *const texts[] = {
        "# longer than many windows are\nx,y,\"a, \"\"b\"\"\nc\"\r\n1,2,3\r\n\n4,,text\n5,6",
        "x,y\n\"1\",2\n3,\"4\n\"\n",
        "x,y\r1,2\r\r3,4\r",
        "\xef\xbb\xbfx,y\n1,2\n  \n3,4,5\n",
        "x,y\n1,2\"3\n4,5\n6,7\n",
        "x,y\n1,2\n3,\"4\n5,6\n",
        "x y\n1 2\n",
        "# only\n\n",
        ""};
    for (size_t t = 0; t < sizeof texts / sizeof *texts; t++) {
        static char whole[4000], part[4000];
        say_table(texts[t], WCUT_STREAM_WINDOW, whole, sizeof whole);
        for (size_t window = 24; window < 130; window++) {
            say_table(texts[t], window, part, sizeof part);
            ck_assert_msg(strcmp(whole, part) == 0, "window of %zu bytes: found %s\nexpected %s", window, part, whole);
        }
    }
}

TEST(a_row_fits_into_the_window_or_is_refused_and_a_comment_need_not) {
    char said[4000];
    say_table("# a comment that is longer than the window is\nx,y\n1,2\n", 16, said, sizeof said);
    ck_assert_str_eq(said, "0 \n3: x 1 1 y 2 1");
    say_table("x,y\n1,2\n3,12345678901234567890\n", 16, said, sizeof said);
    ck_assert_str_eq(said, "7 t.csv: line 3, column 1: found a longer row, expected at most 16 bytes\n");
    say_table("x,y\n1,2\n3,\"4\n5,6\n7,8\n9,10\n11,12\n", 16, said, sizeof said);
    ck_assert_str_eq(said,
                     "7 t.csv: line 3, column 3: found an opening quote, expected its closing one within 16 bytes\n");
}

TEST(samples_missing_before_and_behind_the_first_rows_are_where_they_were) {
    enum { ROWS = 5000 };
    char *text = wcut_alloc(ROWS, 16);
    size_t used = (size_t)sprintf(text, "x,y\n");
    for (int i = 0; i < ROWS; i++)
        used +=
            (size_t)(i % 1000 == 700 ? sprintf(text + used, "%d,\n", i) : sprintf(text + used, "%d,%d\n", i, 2 * i));
    ck_assert_int_eq(parse(text), WCUT_OK);
    ck_assert_int_eq(table->rows, ROWS);
    ck_assert(table->column[0].present == NULL && table->column[1].missing == 5);
    for (int i = 0; i < ROWS; i++) {
        const bool there = i % 1000 != 700;
        ck_assert(table->column[0].value[i] == i && table->column[1].present[i] == there);
        ck_assert(table->column[1].value[i] == (there ? 2 * i : 0) && table->line[i] == i + 2);
    }
    wcut_free(text);
    forget();
}

TEST(a_locale_with_decimal_commas_changes_nothing) {
    ck_assert_ptr_nonnull(setlocale(LC_ALL, "de_DE.UTF-8"));
    ck_assert_int_eq(parse("x,y\n1.5,1.7976931348623157e308\n"), WCUT_OK);
    ck_assert(table->column[0].value[0] == 1.5 && table->column[1].value[0] == 1.7976931348623157e308);
    ck_assert_str_eq(localeconv()->decimal_point, ",");
    setlocale(LC_ALL, "C");
    forget();
}

TEST(every_failing_allocation_is_reported_and_nothing_is_written) {
    char text[2000];
    size_t used = (size_t)snprintf(text, sizeof text, "x,y,\"name\"\n1,,\"a\"\n3,4,5\n");

    /* more rows than there is room for at first */
    for (int i = 0; i < 100; i++) used += (size_t)snprintf(text + used, sizeof text - used, "6,7,8\n");
    wcut_table *found = (wcut_table *)&error;
    EACH_FAILED_ALLOCATION(wcut_csv_parse(text, strlen(text), WCUT_STREAM_WINDOW, "t.csv", 2, numeric, &found, &error),
                           found == (wcut_table *)&error);
    wcut_table_destroy(found);
}

TEST(a_file_that_is_not_there_and_bad_arguments_are_told_apart) {
    wcut_table *found = (wcut_table *)&error;
    const char *const nothing[] = {NULL};
    ck_assert_int_eq(wcut_table_read("no/such.csv", 0, NULL, &found, &error), WCUT_NOT_FOUND);
    ck_assert_ptr_nonnull(strstr(error.text, "no/such.csv"));
    ck_assert_int_eq(wcut_table_read(NULL, 0, NULL, &found, &error), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_table_read("a.csv", 0, NULL, NULL, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_table_read("a.csv", -1, NULL, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_table_read("a.csv", 1, NULL, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert_int_eq(wcut_table_read("a.csv", 1, nothing, &found, NULL), WCUT_BAD_ARGUMENT);
    ck_assert(found == (wcut_table *)&error);
    wcut_table_destroy(NULL);
}
