/* Points of a design of experiments in the unit cube: Latin hypercube and Sobol's sequence. */
#ifndef WCUT_IO_STUDY_SAMPLE_H
#define WCUT_IO_STUDY_SAMPLE_H

#include <stdint.h>

/* dimensions of Sobol's sequence here */
enum { WCUT_SOBOL_MAX = 21 };

/* Coordinate `dimension` of point k of Sobol's sequence (Sobol 1967), direction numbers of Joe and Kuo (2008), shifted
   digit by digit by a number that `seed` gives (Cranley, Patterson 1976, in base 2); seed 0 shifts nothing. In [0, 1). */
double wcut_sobol_eval(int dimension, uint32_t k, uint64_t seed);

/* A Latin hypercube of n points (McKay, Beckman, Conover 1979): of every dimension each of n equal intervals holds one
   point. interval: n, the permutation of `dimension`, out. */
void wcut_latin_fill(int dimension, int n, uint64_t seed, int *interval);

/* the place of point k inside its interval, in [0, 1) */
double wcut_latin_jitter(int dimension, int k, uint64_t seed);

#endif
