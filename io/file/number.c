/* Numbers as text: the shortest that reads back the same, whatever the locale. */
#include "io/file/number.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/locale.h"

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

/* ---- exactly, in integers: 1e-4 <= value < 1e15 ---- */

__extension__ typedef unsigned __int128 wide;

static const uint64_t power_of_ten[] = {1,
                                        10,
                                        100,
                                        1000,
                                        10000,
                                        100000,
                                        1000000,
                                        10000000,
                                        100000000,
                                        1000000000,
                                        10000000000,
                                        100000000000,
                                        1000000000000,
                                        10000000000000,
                                        100000000000000,
                                        1000000000000000,
                                        10000000000000000};
static const uint64_t power_of_five[] = {
    1,          5,           25,           125,          625,           3125,           15625,
    78125,      390625,      1953125,      9765625,      48828125,      244140625,      1220703125,
    6103515625, 30517578125, 152587890625, 762939453125, 3814697265625, 19073486328125, 95367431640625};

enum { MANTISSA_BITS = 52, MAX_DIGITS = 17 };

/* whole numbers from least to most, over 10^places: one of them is to be printed */
typedef struct decimals {
    uint64_t min, max;
    int places;
} decimals;

/* leave out digits as long as a number is left */
static void shorten(decimals *d, int digits) {
    const uint64_t unit = power_of_ten[digits];
    for (;;) {
        const uint64_t min = (d->min + unit - 1) / unit, max = d->max / unit;
        if (max < min) return;
        d->min = min, d->max = max;
        d->places -= digits;
    }
}

/* The shortest digits / 10^places that read back as mantissa 2^exponent, and of these the nearest: everything between
   the middles to both neighbours reads back, the middles themselves where the mantissa is even (Steele, White 1990).
   Scaled to 17 digits it is mantissa 5^places over a power of two, below 2^102: no rounding anywhere. */
static uint64_t find_shortest(uint64_t mantissa, int exponent, int *places) {
    const wide five = power_of_five[*places], four = five * mantissa * 4;
    const int shift = 2 - exponent - *places;
    const bool is_odd = mantissa & 1, is_power = mantissa == (uint64_t)1 << MANTISSA_BITS;
    const wide below = four - (is_power ? five : 2 * five), above = four + 2 * five;
    decimals d = {.places = *places};
    d.min = (uint64_t)(is_odd ? below >> shift : (below - 1) >> shift) + 1;
    d.max = (uint64_t)((is_odd ? above - 1 : above) >> shift);
    shorten(&d, 8);
    shorten(&d, 1);
    const int left_out = *places - d.places;
    const uint64_t unit = power_of_ten[left_out], whole = (uint64_t)(four >> shift);
    uint64_t nearest = left_out ? whole / unit : whole;
    const bool up = left_out ? whole - nearest * unit >= unit / 2 : (four >> (shift - 1)) & 1;
    nearest += up;
    *places = d.places;
    return nearest < d.min ? d.min : nearest > d.max ? d.max : nearest;
}

/* ---- as characters ---- */

/* eight digits, with their leading zeros */
static void put_eight(uint32_t value, char *to) {
    static const char pair[] =
        "0001020304050607080910111213141516171819202122232425262728293031323334353637383940414243444546474849"
        "5051525354555657585960616263646566676869707172737475767778798081828384858687888990919293949596979899";
    const size_t high = value / 10000, low = value % 10000;
    memcpy(to, pair + 2 * (high / 100), 2);
    memcpy(to + 2, pair + 2 * (high % 100), 2);
    memcpy(to + 4, pair + 2 * (low / 100), 2);
    memcpy(to + 6, pair + 2 * (low % 100), 2);
}

int wcut_integer_print(uint64_t value, char text[WCUT_NUMBER_SIZE]) {
    enum { EIGHT = 100000000 };
    char all[24];
    int first = 0;
    if (value < EIGHT) {
        put_eight((uint32_t)value, all + 16);
        first = 16;
    } else {
        const uint64_t high = value / EIGHT;
        put_eight((uint32_t)(value % EIGHT), all + 16);
        put_eight((uint32_t)(high % EIGHT), all + 8);
        put_eight((uint32_t)(high / EIGHT), all);
    }
    while (first < 23 && all[first] == '0') first++;
    memcpy(text, all + first, (size_t)(24 - first));
    return 24 - first;
}

/* digits / 10^places as a decimal fraction */
static int print_fraction(uint64_t digits, int places, char *text) {
    char plain[WCUT_NUMBER_SIZE];
    const int count = wcut_integer_print(digits, plain);
    if (places <= 0) { /* a whole number */
        memcpy(text, plain, (size_t)count);
        memset(text + count, '0', (size_t)-places);
        return count - places;
    }
    if (places < count) {
        const int before = count - places;
        memcpy(text, plain, (size_t)before);
        text[before] = '.';
        memcpy(text + before + 1, plain + before, (size_t)places);
        return count + 1;
    }
    memcpy(text, "0.0000", 6);
    memcpy(text + 2 + places - count, plain, (size_t)count);
    return places + 2;
}

int wcut_number_print(double value, char text[WCUT_NUMBER_SIZE]) {
    /* zero and sizes outside the usual range are printed in another way */
    const double size = fabs(value);
    const int sign = signbit(value) ? 1 : 0;
    uint64_t bits;
    if (size == 0) {
        memcpy(text, "-0", 2);
        if (!sign) text[0] = '0';
        return sign + 1;
    }
    if (!(size >= 1e-4 && size < 1e15)) return print_any(value, text);

    /* mantissa and exponent of the double */
    memcpy(&bits, &size, sizeof bits);
    const uint64_t hidden = (uint64_t)1 << MANTISSA_BITS;
    const uint64_t mantissa = (bits & (hidden - 1)) | hidden;
    const int exponent = (int)(bits >> MANTISSA_BITS) - 1075;
    /* the digits before the point, or minus the zeros behind it */
    int before = size >= 0.1 ? 0 : size >= 0.01 ? -1 : size >= 0.001 ? -2 : -3;
    while (before >= 0 && size >= (double)power_of_ten[before]) before++;

    /* as few digits as read back the same */
    int places = MAX_DIGITS - before;
    const uint64_t digits = find_shortest(mantissa, exponent, &places);
    if (sign) text[0] = '-';

    return sign + print_fraction(digits, places, text + sign);
}
