/* Numbers as text: the shortest that reads back the same, whatever the locale. */
#include "number.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

locale_t wcut_locale_plain(void) {
    /* glibc and musl answer "C" with a constant object: nothing to free, nothing that can fail */
    return uselocale(newlocale(LC_ALL_MASK, "C", (locale_t)0));
}

void wcut_locale_restore(locale_t before) { uselocale(before); }

/* by the C library: right for every value */
static int print_any(double value, char text[WCUT_NUMBER_SIZE]) {
    locale_t before = wcut_locale_plain();
    int length = 0;
    /* 15 digits are enough for the shortest that 15 can tell, but for subnormal numbers, which have fewer */
    for (int digits = fabs(value) < DBL_MIN ? 1 : 15; digits <= 17; digits++) {
        length = snprintf(text, WCUT_NUMBER_SIZE, "%.*g", digits, value);
        if (strtod(text, NULL) == value) break;
    }
    wcut_locale_restore(before);
    return length;
}

static const long double power_of_ten[] = {1e0L,  1e1L,  1e2L,  1e3L,  1e4L,  1e5L,  1e6L,  1e7L,  1e8L,  1e9L,  1e10L,
                                           1e11L, 1e12L, 1e13L, 1e14L, 1e15L, 1e16L, 1e17L, 1e18L, 1e19L, 1e20L, 1e21L};

/* Whether the digits over 10^k read back as value: 1 or 0, -1 in doubt. Both are exact in a long double (64 bits at
   least), so the quotient is rounded once; on the very edge between two doubles it would be rounded twice. */
static int reads_back(uint64_t digits, int k, double value) {
    long double quotient = (long double)digits / power_of_ten[k];
    long double off = quotient - (long double)value;
    long double half_above = (nextafter(value, INFINITY) - (long double)value) / 2;
    long double half_below = ((long double)value - nextafter(value, 0)) / 2;
    if (off == half_above || -off == half_below) return -1;
    return off < half_above && -off < half_below;
}

/* digits / 10^k as a decimal fraction without trailing zeros */
static int print_fraction(uint64_t digits, int k, char *text) {
    char reversed[WCUT_NUMBER_SIZE] = "";
    int n = 0, length = 0;
    while (k > 0 && digits % 10 == 0) digits /= 10, k--;
    for (; digits > 0 || n <= k; digits /= 10) {
        if (n == k && k > 0) reversed[length++] = '.';
        reversed[length++] = (char)('0' + digits % 10);
        n++;
    }
    for (int i = 0; i < length; i++) text[i] = reversed[length - 1 - i];
    return length;
}

int wcut_number_print(double value, char text[WCUT_NUMBER_SIZE]) {
    double size = fabs(value);
    int sign = signbit(value) ? 1 : 0;
    if (size == 0) {
        memcpy(text, "-0", 2);
        if (!sign) text[0] = '0';
        return sign + 1;
    }
    if (!(size >= 1e-4 && size < 1e15)) return print_any(value, text);
    /* 15 significant digits are the shortest where they read back, 16 or 17 always do */
    int before_point = 1;
    while (before_point < 16 && size >= (double)power_of_ten[before_point]) before_point++;
    for (double s = size; s < 1 && s > 0; s *= 10) before_point--;
    for (int significant = 15; significant <= 17; significant++) {
        int k = significant - before_point;
        uint64_t digits = (uint64_t)((long double)size * power_of_ten[k] + 0.5L);
        int back = reads_back(digits, k, size);
        if (back < 0) break;
        if (back == 0) continue;
        if (sign) text[0] = '-';
        return sign + print_fraction(digits, k, text + sign);
    }
    return print_any(value, text);
}
