/* A mere fit beside the physics: what a regression that knows nothing of foam makes of the same cuts. */
#ifndef WCUT_EXPLAIN_BLACK_BOX_H
#define WCUT_EXPLAIN_BLACK_BOX_H

#include "explain/cross_validation.h"

/*
 * Predict the residual of the recalibrated replay, signal by signal, by a ridge regression on ln speed, heat,
 * acceleration, station, block y and engaged length of this bin and of the eight before it (an ARX model without
 * the output's own past, Ljung 1999, for it is to predict whole cuts). Each cut by what was learnt on the others, the
 * ridge chosen by leaving cuts of those out in turn.
 *
 * evidence: predicted; proof: of it. Fills the figures of WCUT_EVIDENCE_MODEL_BLACK_BOX for tension, alpha and beta, in sample
 * and held out; speed and scan stay at count 0, held out also where there is one cut alone.
 * WCUT_OK; WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_black_box_run(const wcut_evidence *evidence, unsigned long long seed, wcut_cross_validation *proof);

#endif
