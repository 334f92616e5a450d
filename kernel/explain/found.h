/* What a fit says of an effect: values with intervals, and what it moves. */
#ifndef WCUT_EXPLAIN_FOUND_H
#define WCUT_EXPLAIN_FOUND_H

#include "explain/model_fit.h"

/* A standard error with what the linear fit does not know: slow noise beyond the whitening, and the simulator's own error against
   another simulator of the same physics, 4 % of a strength. */
double wcut_found_widen(double error, double value, double slow);

/* Effect e of a fit: the values of the start, each as an interval of no width, then those that were fitted, with intervals
   widened by what the fit leaves. */
void wcut_found_effect_fill(const wcut_fitted *fit, int e, double slow, wcut_found_effect *found);

/* how far the last effect of a fit moves tensions [N] and scanned faces [mm], at most; linear about the fit */
void wcut_small_effect_measure(const wcut_evidence *evidence, const wcut_fitted *fit, wcut_small_effect *out);

#endif
