/* Decimal text to the nearest double: one rounding of an integer ratio in 128 bits (the idea of Clinger 1990). */
#include "io/file/decimal.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/locale.h"
#include "io/file/number.h"

__extension__ typedef unsigned __int128 wide;

enum { MAX_DIGITS = 19, MAX_POWER = 27, EXPONENT_LIMIT = 100000 }; /* 10^19 < 2^64, 5^27 < 2^63 */

/* +- mantissa x 10^exponent; `more` where digits did not fit */
typedef struct decimal {
    uint64_t mantissa;
    int exponent;
    bool more;
} decimal;

static bool is_digit(char c) { return (unsigned)(c - '0') < 10; }

/* digits into the mantissa; gives how many were taken or dropped */
static const char *read_digits(const char *p, decimal *d, int *taken) {
    for (; is_digit(*p); p++) {
        if (*taken < MAX_DIGITS) {
            d->mantissa = 10 * d->mantissa + (uint64_t)(*p - '0');
            *taken += d->mantissa > 0; /* leading zeros do not count */
        } else {
            d->more = true;
        }
    }
    return p;
}

/* "e-12" at p, or p itself */
static const char *read_exponent(const char *p, int *exponent) {
    const char *q = p + 1;
    if (*p != 'e' && *p != 'E') return p;
    bool negative = *q == '-';
    if (*q == '-' || *q == '+') q++;
    if (!is_digit(*q)) return p;
    int n = 0;
    for (; is_digit(*q); q++)
        if (n < EXPONENT_LIMIT) n = 10 * n + (*q - '0');
    *exponent += negative ? -n : n;
    return q;
}

/* 5^k, k in 0 .. 27 */
static uint64_t power_of_five(int k) {
    static const uint64_t power[] = {1u, 5u, 25u, 125u, 625u, 3125u, 15625u, 78125u, 390625u};
    uint64_t p = power[k % 9];
    for (int i = 0; i < k / 9; i++) p *= 1953125u;
    return p;
}

/* mantissa x 5^e x 2^e for |e| <= 27, the mantissa not 0: the integer, or the quotient with a sticky bit for its
   remainder, has more bits than a double and is rounded once */
static double round_ratio(uint64_t mantissa, int e) {
    if (e >= 0) return ldexp((double)((wide)mantissa * power_of_five(e)), e);
    int shift = 63 + __builtin_clzll(mantissa);
    wide dividend = (wide)mantissa << shift, divisor = power_of_five(-e), quotient = dividend / divisor;
    return ldexp((double)(quotient | (quotient * divisor != dividend)), e - shift);
}

/* by the C library: right for every length and exponent */
static double read_any(const char *text) {
    locale_t before = wcut_locale_plain();
    double value = strtod(text, NULL);
    wcut_locale_restore(before);
    return value;
}

const char *wcut_decimal_read(const char *text, double *value) {
    static const double power_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                          1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const char *p = text;

    /* the sign, then digits before and behind the point */
    bool negative = *p == '-';
    if (*p == '-' || *p == '+') p++;
    decimal d = {0, 0, false};
    int taken = 0;
    const char *first = p;
    p = read_digits(p, &d, &taken);
    long digits = p - first;
    if (*p == '.') {
        const char *fraction = p + 1;
        p = read_digits(fraction, &d, &taken);
        digits += p - fraction;
        d.exponent = d.more ? 0 : -(int)(p - fraction < EXPONENT_LIMIT ? p - fraction : EXPONENT_LIMIT);
    }

    /* no digit: no number */
    if (digits == 0) return text;
    p = read_exponent(p, &d.exponent);

    /* more digits or a larger exponent than the fast path takes: the exact one */
    int e = d.exponent;
    if (d.more || (d.mantissa && (e < -MAX_POWER || e > MAX_POWER))) {
        *value = read_any(text);
        return p;
    }

    /* the quotient of two exact doubles, else a ratio in 128 bits */
    double size = 0;
    if (d.mantissa <= (uint64_t)1 << 53 && e >= -22 && e <= 22) /* both exact: one rounding */
        size = e < 0 ? (double)d.mantissa / power_of_ten[-e] : (double)d.mantissa * power_of_ten[e];
    else if (d.mantissa)
        size = round_ratio(d.mantissa, e);
    *value = negative ? -size : size;

    return p;
}
