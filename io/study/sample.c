/* Points of a design of experiments in the unit cube: Latin hypercube and Sobol's sequence. */
#include "io/study/sample.h"

#include <assert.h>

#include "base/random.h"

enum { BITS = 32, DEGREE_MAX = 7 };

/* a dimension beyond the first: its primitive polynomial and the first direction numbers (Joe, Kuo 2008, table
   new-joe-kuo-6) */
typedef struct direction {
    unsigned degree, coefficients, m[DEGREE_MAX];
} direction;

static const direction of_dimension[WCUT_SOBOL_MAX - 1] = {
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
};

/* the direction numbers of a dimension as fractions of 2^32: the recurrence of its polynomial (Bratley, Fox 1988) */
static void fill_directions(int dimension, uint32_t v[BITS]) {
    /* the first dimension is van der Corput's sequence */
    for (int i = 0; i < BITS; i++) v[i] = (uint32_t)1 << (BITS - 1 - i);
    if (dimension == 0) return;

    const direction *d = &of_dimension[dimension - 1];
    const int s = (int)d->degree;
    for (int i = 0; i < s; i++) v[i] = (uint32_t)d->m[i] << (BITS - 1 - i);
    for (int i = s; i < BITS; i++) {
        v[i] = v[i - s] ^ (v[i - s] >> s);
        for (int k = 1; k < s; k++)
            if (d->coefficients >> (s - 1 - k) & 1) v[i] ^= v[i - k];
    }
}

/* numbers of a dimension of their own, whatever is drawn for another */
static wcut_random stream(uint64_t seed, uint64_t dimension) {
    return wcut_random_seed(seed * 0x9e3779b97f4a7c15u + dimension);
}

double wcut_sobol_eval(int dimension, uint32_t k, uint64_t seed) {
    uint32_t v[BITS], x = 0;
    assert(dimension >= 0 && dimension < WCUT_SOBOL_MAX);
    fill_directions(dimension, v);

    /* point k of the sequence in Gray code's order: each block of 2^m holds the same points */
    const uint32_t gray = k ^ (k >> 1);
    for (int i = 0; i < BITS; i++)
        if (gray >> i & 1) x ^= v[i];

    if (seed) {
        wcut_random random = stream(seed, (uint64_t)dimension);
        x ^= (uint32_t)(wcut_random_bits(&random) >> 32);
    }
    return x * 0x1p-32;
}

void wcut_latin_fill(int dimension, int n, uint64_t seed, int *interval) {
    wcut_random random = stream(seed, (uint64_t)dimension);
    for (int i = 0; i < n; i++) interval[i] = i;

    /* a random permutation (Fisher, Yates) */
    for (int i = n - 1; i > 0; i--) {
        const int other = wcut_random_below(&random, i + 1), kept = interval[i];
        interval[i] = interval[other];
        interval[other] = kept;
    }
}

double wcut_latin_jitter(int dimension, int k, uint64_t seed) {
    wcut_random random = stream(seed ^ 0xd1b54a32d192ed03u, (uint64_t)dimension + 4096 * ((uint64_t)k + 1));
    return wcut_random_uniform(&random);
}
