/* Adequacy: whether noise alone could leave what a model leaves. */
#ifndef WCUT_EXPLAIN_ADEQUACY_H
#define WCUT_EXPLAIN_ADEQUACY_H

#include "explain/evidence.h"

/* slow part of the noise over the white one, at most: what the sensors of a rig were seen to have, three times what the
   whitening takes for granted (explain/decide.c holds verdicts to the same) */
#define WCUT_SLOWEST_NOISE 0.75

/*
 * p-value of a slow misfit (wcut_residual_stats.slow) against a simulated null: recordings of noise alone, in the same bins and
 * with the same gaps, white and slow with a share of the slow one that is drawn from 0 to WCUT_SLOWEST_NOISE for each,
 * whitened as the case is. The share of `draws` nulls that leave as much, (k + 1) / (draws + 1).
 * WCUT_OK; WCUT_NO_MEMORY: *p was not written.
 */
wcut_status wcut_adequacy_p_value(const wcut_evidence *evidence, double slow, int draws, unsigned long long seed,
                                  double *p);

#endif
