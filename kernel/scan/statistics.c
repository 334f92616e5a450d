/* Figures of many deviations: sums about the first of them, quantiles from bins whose width grows with size. */
#include <wirecut/statistics.h>

#include <limits.h>
#include <stdint.h>
#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"

/* A bin is a double's exponent and the first bits of its fraction: 2^-14 of its size wide. Sizes of 2^-30 to 2^40 mm
   have bins of their own. */
enum { FRACTION = 14, LOWEST = -30, HIGHEST = 40, SIDE = (HIGHEST - LOWEST) << FRACTION, BINS = 2 * SIDE + 1 };

static const int BIAS = 1023; /* of a double's exponent */

struct wcut_histogram {
    int count, positive, negative, bands;
    double shift; /* [mm] the first deviation: sums about it lose no digits to a constant offset */
    double sum, squares, plain_squares, positive_sum, negative_sum, min, max;
    double band[WCUT_BANDS_MAX];
    int over[WCUT_BANDS_MAX], under[WCUT_BANDS_MAX];
    uint32_t *bin; /* BINS, from the lowest to the highest */
};

wcut_status wcut_histogram_create(int bands, const double *band, wcut_histogram **histogram) {
    if (!histogram || bands < 0 || bands > WCUT_BANDS_MAX || (bands > 0 && !band) || !all_positive(bands, band))
        return WCUT_BAD_ARGUMENT;
    wcut_histogram *t = wcut_alloc(1, sizeof *t);
    if (t) t->bin = wcut_alloc(BINS, sizeof *t->bin);
    if (!t || !t->bin) {
        wcut_histogram_destroy(t);
        return WCUT_NO_MEMORY;
    }
    t->bands = bands;
    for (int k = 0; k < bands; k++) t->band[k] = band[k];
    *histogram = t;
    return WCUT_OK;
}

void wcut_histogram_destroy(wcut_histogram *histogram) {
    if (!histogram) return;
    wcut_free(histogram->bin);
    wcut_free(histogram);
}

/* ---- counting ---- */

/* the bin of a size above 0, -1 below the lowest */
static inline int bin_of(double size) {
    uint64_t bits;
    memcpy(&bits, &size, sizeof bits);
    const int64_t k = (int64_t)(bits >> (52 - FRACTION)) - ((int64_t)(BIAS + LOWEST) << FRACTION);
    return k < 0 ? -1 : k >= SIDE ? SIDE - 1 : (int)k;
}

static inline int signed_bin(double d) {
    const int k = bin_of(fabs(d));
    return d < 0 ? SIDE - 1 - k : SIDE + 1 + k;
}

/* where bin k begins, 0 .. SIDE */
static double edge_of(int k) {
    const uint64_t bits = ((uint64_t)k + ((uint64_t)(BIAS + LOWEST) << FRACTION)) << (52 - FRACTION);
    double edge;
    memcpy(&edge, &bits, sizeof edge);
    return edge;
}

static void edges_of(int bin, double *low, double *high) {
    const int k = bin > SIDE ? bin - SIDE - 1 : SIDE - 1 - bin;
    *low = *high = 0;
    if (bin == SIDE) return;
    *low = bin > SIDE ? edge_of(k) : -edge_of(k + 1);
    *high = bin > SIDE ? edge_of(k + 1) : -edge_of(k);
}

wcut_status wcut_histogram_add(wcut_histogram *histogram, int count, const double *deviation) {
    if (!histogram || count < 0 || (count > 0 && !deviation) || count > INT_MAX - histogram->count ||
        !all_finite(count, deviation))
        return WCUT_BAD_ARGUMENT;
    if (count == 0) return WCUT_OK;

    /* sums about the first value, so that a large offset loses no digits */
    wcut_histogram *t = histogram;
    if (t->count == 0) t->shift = t->min = t->max = deviation[0];
    double sum = 0, squares = 0, plain = 0, above = 0, below = 0;

    /* each deviation: moments, sides, extremes, bands, bin */
    for (int i = 0; i < count; i++) {
        const double d = deviation[i], r = d - t->shift;
        sum += r, squares += r * r, plain += d * d;
        if (d > 0) above += d, t->positive++;
        if (d < 0) below += d, t->negative++;
        if (d < t->min) t->min = d;
        if (d > t->max) t->max = d;
        for (int k = 0; k < t->bands; k++) {
            t->over[k] += d > t->band[k];
            t->under[k] += d < -t->band[k];
        }
        t->bin[signed_bin(d)]++;
    }

    t->count += count;
    t->sum += sum, t->squares += squares, t->plain_squares += plain, t->positive_sum += above, t->negative_sum += below;

    return WCUT_OK;
}

/* ---- figures ---- */

/* The deviation of a rank 0 .. n-1 among all in order; those of a bin count as evenly spread over it. */
static double at_rank(const wcut_histogram *t, int rank) {
    int64_t before = 0;
    int bin = 0;
    while (before + t->bin[bin] <= rank) before += t->bin[bin++];
    double low, high;
    edges_of(bin, &low, &high);
    const double share = ((double)(rank - before) + 0.5) / (double)t->bin[bin];
    return clamp(low + share * (high - low), t->min, t->max);
}

/* between the two ranks about (n - 1) p (Hyndman, Fan 1996, 7) */
static double quantile(const wcut_histogram *t, double p) {
    const double at = p * (t->count - 1.0);
    const int low = (int)at, high = low + 1 < t->count ? low + 1 : low;
    const double first = at_rank(t, low);
    return at > low ? first + (at - low) * (at_rank(t, high) - first) : first;
}

wcut_status wcut_histogram_eval(const wcut_histogram *histogram, wcut_statistics *statistics) {
    if (!histogram || !statistics) return WCUT_BAD_ARGUMENT;

    /* counts and bands are there even without deviations */
    const wcut_histogram *t = histogram;
    wcut_statistics s = {.count = t->count, .positive = t->positive, .negative = t->negative, .bands = t->bands};
    for (int k = 0; k < t->bands; k++) s.band[k] = t->band[k];

    /* mean and standard deviation about the shift */
    if (t->count > 0) {
        const double n = t->count, m = t->sum / n;
        s.mean = t->shift + m;
        s.std = n > 1 ? sqrt(fmax(t->squares - n * m * m, 0) / (n - 1)) : 0;
        s.rms = sqrt(t->plain_squares / n);
        s.mae = (t->positive_sum - t->negative_sum) / n;

        /* quantiles, extremes, and the means of either side */
        s.median = quantile(t, 0.5);
        s.p01 = quantile(t, 0.01), s.p05 = quantile(t, 0.05), s.p95 = quantile(t, 0.95), s.p99 = quantile(t, 0.99);
        s.min = t->min, s.max = t->max;
        s.hausdorff = fmax(fabs(t->min), fabs(t->max));
        s.profile = 2 * s.hausdorff;
        s.positive_mean = t->positive ? t->positive_sum / t->positive : 0;
        s.negative_mean = t->negative ? t->negative_sum / t->negative : 0;

        /* shares beyond each band */
        for (int k = 0; k < t->bands; k++) {
            s.over[k] = t->over[k] / n, s.under[k] = t->under[k] / n;
            s.within[k] = (double)(t->count - t->over[k] - t->under[k]) / n;
        }
    }
    *statistics = s;

    return WCUT_OK;
}
