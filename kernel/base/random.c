/* Random numbers from a seed that is an argument: xoshiro256** (Blackman, Vigna 2018). */
#include "base/random.h"

#include <assert.h>
#include <math.h>

/* splitmix64 (Steele, Lea, Flood 2014) spreads a seed over the state, so that seeds 0, 1, 2 give unlike sequences */
static uint64_t split_mix(uint64_t *x) {
    uint64_t z = *x += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static uint64_t rotate_left(uint64_t x, int k) { return x << k | x >> (64 - k); }

wcut_random wcut_random_seed(uint64_t seed) {
    wcut_random random = {.has_spare = false};
    for (int i = 0; i < 4; i++) random.state[i] = split_mix(&seed);
    return random;
}

uint64_t wcut_random_bits(wcut_random *random) {
    uint64_t *s = random->state, bits = rotate_left(s[1] * 5, 7) * 9, t = s[1] << 17;
    s[2] ^= s[0];
    s[3] ^= s[1];
    s[1] ^= s[2];
    s[0] ^= s[3];
    s[2] ^= t;
    s[3] = rotate_left(s[3], 45);
    return bits;
}

double wcut_random_uniform(wcut_random *random) { return (double)(wcut_random_bits(random) >> 11) * 0x1p-53; }

int wcut_random_below(wcut_random *random, int n) {
    assert(n >= 1);
    /* refuse the last incomplete run of n, so that no remainder is likelier than another */
    uint64_t range = (uint64_t)n, limit = UINT64_MAX - UINT64_MAX % range, bits;
    do {
        bits = wcut_random_bits(random);
    } while (bits >= limit);
    return (int)(bits % range);
}

double wcut_random_normal(wcut_random *random) {
    /* the second deviate of the pair before (polar method, Marsaglia 1964) */
    if (random->has_spare) {
        random->has_spare = false;
        return random->spare;
    }

    /* a point of the unit disc, not its centre */
    double x, y, s;
    do {
        x = 2 * wcut_random_uniform(random) - 1;
        y = 2 * wcut_random_uniform(random) - 1;
        s = x * x + y * y;
    } while (s >= 1 || s == 0);

    /* two independent deviates; one is kept for the next call */
    double scale = sqrt(-2 * log(s) / s);
    random->spare = scale * y;
    random->has_spare = true;

    return scale * x;
}
