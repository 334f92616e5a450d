/* Numbers as text: exact, shortest, without a locale. labels: unit property plain */
#include <float.h>
#include <locale.h>
#include <stdint.h>

#include "base/random.h"
#include "io/file/number.h"
#include "io/given.h"
#include "test.h"

static void prints(double value, const char *expected) {
    char text[WCUT_NUMBER_SIZE];
    text[wcut_number_print(value, text)] = '\0';
    ck_assert_str_eq(text, expected);
}

TEST(numbers_print_as_one_would_write_them) {
    prints(0, "0");
    prints(-0.0, "-0");
    prints(1, "1");
    prints(-1200, "-1200");
    prints(0.1, "0.1");
    prints(0.1 + 0.2, "0.30000000000000004");
    prints(1.0 / 3, "0.3333333333333333");
    prints(8.6e-4, "0.00086");
    prints(2e-5, "2e-05");
    prints(999999999999999.9, "999999999999999.9");
    prints(1e15, "1e+15");
    prints(0.0001, "0.0001");
    prints(123456.789, "123456.789");
    prints(9007199254740993.0, "9007199254740992");
    prints(5e-324, "5e-324");
    prints(DBL_MIN, "2.2250738585072014e-308");
    prints(DBL_MAX, "1.7976931348623157e+308");
    prints(NAN, "nan");
    prints(INFINITY, "inf");
    prints(-INFINITY, "-inf");
}

/* fewest digits that read back, found by trying them all */
static int fewest_digits(double value) {
    char text[40];
    for (int digits = 1; digits < 17; digits++) {
        snprintf(text, sizeof text, "%.*e", digits - 1, value);
        if (strtod(text, NULL) == value) return digits;
    }
    return 17;
}

static int count_digits(const char *text) {
    int count = 0, zeros = 0;
    for (; *text && *text != 'e'; text++) {
        if (*text < '0' || *text > '9' || (*text == '0' && count == 0)) continue;
        zeros = *text == '0' ? zeros + 1 : 0;
        count++;
    }
    return count - zeros;
}

static void check_number(double value) {
    char text[WCUT_NUMBER_SIZE];
    if (!isfinite(value)) return;
    int length = wcut_number_print(value, text);
    ck_assert_int_lt(length, WCUT_NUMBER_SIZE - 4);
    text[length] = '\0';
    ck_assert_msg(strtod(text, NULL) == value, "%.17g printed as %s", value, text);
    const int fewest = fewest_digits(value);
    ck_assert_msg(count_digits(text) <= fewest, "%.17g printed as %s", value, text);
    /* of several that are as short the nearest, which printf gives */
    char near[40];
    snprintf(near, sizeof near, "%.*e", fewest - 1, value);
    const double off = fabs((double)(strtold(text, NULL) - (long double)value));
    const double min = fabs((double)(strtold(near, NULL) - (long double)value));
    ck_assert_msg(off <= min, "%.17g printed as %s, nearer is %s", value, text, near);
}

TEST(every_number_reads_back_and_none_could_be_shorter) {
    wcut_random random = wcut_random_seed(7);
    for (int i = 0; i < 100000; i++) {
        uint64_t bits = wcut_random_bits(&random);
        double any;
        memcpy(&any, &bits, sizeof any);
        check_number(any);                                                  /* any bits */
        check_number((double)(int64_t)bits / pow(10, (double)(i % 23)));    /* of every size */
        check_number(round((double)(bits % 10000000000)) / pow(10, i % 9)); /* short decimals */
    }
}

TEST(neighbours_of_powers_of_two_and_ten_read_back) {
    for (int k = -1074; k < 1024; k++) {
        double two = ldexp(1, k), ten = pow(10, k / 4.0);
        check_number(two);
        check_number(nextafter(two, INFINITY));
        check_number(nextafter(two, 0));
        check_number(ten);
        check_number(-nextafter(ten, INFINITY));
        check_number(nextafter(ten, 0));
    }
}

TEST(the_locale_does_not_matter_and_stays) {
    ck_assert_msg(setlocale(LC_ALL, "de_DE.UTF-8") != NULL, "the tests' own locale is missing");
    prints(0.5, "0.5");
    prints(2.5e-7, "2.5e-07");
    prints(1.0 / 3, "0.3333333333333333");
    ck_assert_str_eq(localeconv()->decimal_point, ",");
}
