/* Tails of the usual distributions from the incomplete beta and gamma functions (DLMF 8.17, 8.11, 8.9). */
#include "base/distribution.h"

#include <assert.h>
#include <float.h>
#include <stdbool.h>

#include "base/numbers.h"

enum { MAX_TERMS = 1000000 }; /* a continued fraction takes about sqrt(dof) terms */

/* ln(ratio) - e with ratio = 1 + e, both given so that neither end loses digits; no cancellation near e = 0 */
static double log_less_e(double ratio, double e) {
    if (fabs(e) > 0.25) return log(ratio) - e;
    double sum = 0, power = -e;
    for (int k = 2; k < 60 && fabs(power) > DBL_EPSILON * DBL_EPSILON; k++) {
        power *= -e;
        sum -= power / k;
    }
    return sum;
}

/* ln Gamma(x) less Stirling's (x - 1/2) ln x - x + ln(2 pi)/2, for x > 0 (Abramowitz, Stegun 6.1.41) */
static double stirling_error(double x) {
    /* below 16 the series is climbed to: delta(x) = delta(x + 1) + (x + 1/2) ln(1 + 1/x) - 1 */
    double climbed = 0;
    for (; x < 16; x++) climbed += (x + 0.5) * log1p(1 / x) - 1;
    double y = 1 / (x * x);
    double series =
        1.0 / 12 - y * (1.0 / 360 - y * (1.0 / 1260 - y * (1.0 / 1680 - y * (1.0 / 1188 - y * 691.0 / 360360))));
    return climbed + series / x;
}

/* x^a y^b / B(a, b) with x + y = 1, accurate for large a, b because the exponent is formed about its maximum */
static double beta_power(double a, double b, double x, double y) {
    double n = a + b, ex = (x * b - y * a) / a, ey = (y * a - x * b) / b;
    double exponent = a * log_less_e(x * n / a, ex) + b * log_less_e(y * n / b, ey);
    return sqrt(a * (b / n) / (2 * WCUT_PI)) *
           exp(exponent + stirling_error(n) - stirling_error(a) - stirling_error(b));
}

/* the denominator of I_x(a, b) / (x^a y^b / B(a, b)): the even part of DLMF 8.17.22, in which x near 1 cancels nothing
   (DiDonato, Morris 1992, 9); modified Lentz, fast for x < (a + 1) / (a + b + 2) */
static double beta_fraction(double a, double b, double x, double y) {
    double f = a * (a * y - b * x + 1) / (a + 1), c = f, d = 0;
    for (int m = 1; m < MAX_TERMS; m++) {
        double k = a + 2.0 * m;
        double numerator = (a + m - 1) * (a + b + m - 1) / (k - 1) * (m * (b - m) * x * x / (k - 1));
        double denominator = m + m * (b - m) * x / (k - 1) + (a + m) * (a * y - b * x + 1 + m * (2 - x)) / (k + 1);
        d = 1 / (denominator + numerator * d);
        c = denominator + numerator / c;
        f *= c * d;
        if (fabs(c * d - 1) < 4 * DBL_EPSILON) break;
    }
    return f;
}

/* regularised I_x(a, b), y = 1 - x given apart so that neither loses digits */
static double beta_lower(double a, double b, double x, double y) {
    if (x <= 0) return 0;
    if (y <= 0) return 1;
    if (x * (a + b + 2) < a + 1) return beta_power(a, b, x, y) / beta_fraction(a, b, x, y);
    return 1 - beta_power(a, b, x, y) / beta_fraction(b, a, y, x);
}

/* regularised P(a, x) (lower) or Q(a, x) of the incomplete gamma function */
static double gamma_part(double a, double x, bool lower) {
    if (x <= 0) return lower ? 0 : 1;
    double power = sqrt(a / (2 * WCUT_PI)) * exp(a * log_less_e(x / a, (x - a) / a) - stirling_error(a));
    if (x < a + 1) { /* DLMF 8.11.4 */
        double term = 1 / a, sum = term;
        for (int k = 1; k < MAX_TERMS && term > sum * DBL_EPSILON / 4; k++) sum += term *= x / (a + k);
        return lower ? power * sum : 1 - power * sum;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, f = d; /* DLMF 8.9.2 */
    for (int k = 1; k < MAX_TERMS; k++) {
        double term = k * (a - k);
        b += 2;
        d = 1 / (term * d + b);
        c = b + term / c;
        f *= c * d;
        if (fabs(c * d - 1) < 4 * DBL_EPSILON) break;
    }
    return lower ? 1 - power * f : power * f;
}

/* which distribution a quantile is sought in */
typedef struct law {
    enum { STUDENT, CHI_SQUARE, FISHER } kind;
    double dof1, dof2;
} law;

/* P(X <= x) or P(X > x) for x > 0, whichever is asked, each with its own full relative precision */
static double tail_of(const law *l, double x, bool lower) {
    double a = l->dof1 / 2, b = l->dof2 / 2;
    if (l->kind == CHI_SQUARE) return gamma_part(a, x / 2, lower);
    if (l->kind == FISHER) {
        double s = l->dof1 * x, n = s + l->dof2;
        return lower ? beta_lower(a, b, s / n, l->dof2 / n) : beta_lower(b, a, l->dof2 / n, s / n);
    }
    double n = l->dof1 + x * x, tail = beta_lower(a, 0.5, l->dof1 / n, x * x / n) / 2;
    return lower ? 1 - tail : tail;
}

/* x > 0 with P(X <= x) = p: bisection down to neighbouring doubles, geometric because x spans decades */
static double distribution_quantile(const law *l, double p) {
    bool lower = p < 0.5;
    double goal = lower ? p : 1 - p, low = 1, high = 1;

    /* bracket the quantile, either way by factors of 4 */
    while (low > DBL_MIN && (tail_of(l, low, lower) > goal) == lower) low /= 4;
    while (high < DBL_MAX / 4 && (tail_of(l, high, lower) > goal) != lower) high *= 4;
    for (;;) {
        double middle = high > 2 * low ? sqrt(low) * sqrt(high) : low + (high - low) / 2;
        if (!(middle > low && middle < high)) return middle;
        if ((tail_of(l, middle, lower) > goal) == lower)
            high = middle;
        else
            low = middle;
    }
}

double wcut_gaussian_tail(double z) {
    assert(isfinite(z));
    return erfc(z * sqrt(0.5)) / 2;
}

double wcut_gaussian_quantile(double p) {
    assert(p > 0 && p < 1);
    /* Abramowitz, Stegun 26.2.23 to 4.5e-4, then Halley on the tail */
    double goal = fmin(p, 1 - p), t = sqrt(-2 * log(goal));
    double z = t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    for (int round = 0; round < 3; round++) {
        double e = (wcut_gaussian_tail(z) - goal) * sqrt(2 * WCUT_PI) * exp(z * z / 2);
        z += e / (1 - z * e / 2);
    }
    return p < 0.5 ? -z : z;
}

double wcut_student_tail(double t, double dof) {
    assert(isfinite(t) && is_positive(dof));
    double tail = tail_of(&(law){STUDENT, dof, 1}, fabs(t), false);
    return t < 0 ? 1 - tail : tail;
}

double wcut_student_quantile(double p, double dof) {
    assert(p > 0 && p < 1 && is_positive(dof));
    if (p == 0.5) return 0;
    /* by symmetry; 1 - p is exact for p >= 1/2, and the small side keeps its digits */
    double goal = fmin(p, 1 - p);
    law l = {STUDENT, dof, 1};
    double low = 0, high = 1;
    while (tail_of(&l, high, false) > goal) low = high, high *= 4;
    for (;;) {
        double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high)) return p < 0.5 ? -middle : middle;
        if (tail_of(&l, middle, false) > goal)
            low = middle;
        else
            high = middle;
    }
}

double wcut_chi_square_tail(double x, double dof) {
    assert(isfinite(x) && is_positive(dof));
    return tail_of(&(law){CHI_SQUARE, dof, 1}, x, false);
}

double wcut_chi_square_quantile(double p, double dof) {
    assert(p > 0 && p < 1 && is_positive(dof));
    return distribution_quantile(&(law){CHI_SQUARE, dof, 1}, p);
}

double wcut_f_tail(double x, double dof1, double dof2) {
    assert(isfinite(x) && is_positive(dof1) && is_positive(dof2));
    return x <= 0 ? 1 : tail_of(&(law){FISHER, dof1, dof2}, x, false);
}

double wcut_f_quantile(double p, double dof1, double dof2) {
    assert(p > 0 && p < 1 && is_positive(dof1) && is_positive(dof2));
    return distribution_quantile(&(law){FISHER, dof1, dof2}, p);
}
