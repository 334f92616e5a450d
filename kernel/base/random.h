/* Random numbers from a seed that is an argument: xoshiro256** (Blackman, Vigna 2018). */
#ifndef WCUT_BASE_RANDOM_H
#define WCUT_BASE_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

/* a generator; two with the same seed give the same numbers */
typedef struct wcut_random {
    uint64_t state[4];
    double spare; /* the second normal deviate of a pair */
    bool has_spare;
} wcut_random;

/* a generator from any seed, 0 too */
wcut_random wcut_random_seed(uint64_t seed);

/* 64 random bits */
uint64_t wcut_random_bits(wcut_random *random);

/* uniform in [0, 1), a multiple of 2^-53 */
double wcut_random_uniform(wcut_random *random);

/* uniform in 0 .. n-1 without bias; n at least 1 */
int wcut_random_below(wcut_random *random, int n);

/* normal with mean 0 and standard deviation 1 (polar method, Marsaglia 1964) */
double wcut_random_normal(wcut_random *random);

#endif
