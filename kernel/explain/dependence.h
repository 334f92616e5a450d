/* On what a residual depends that no known effect explains: a sparse regression of the foam's force. */
#ifndef WCUT_EXPLAIN_DEPENDENCE_H
#define WCUT_EXPLAIN_DEPENDENCE_H

#include "explain/fit.h"

enum { WCUT_DEPENDENCES = 3 };

/*
 * Find quantities that a relative change of the foam's force follows. A feature is a quantity along the exogenous
 * trajectory, nothing that a tension loop feeds back; its column is the prediction's change with ln a, times the feature,
 * whitened. Forward selection over the features, recalibration beside them, each step tested over the whole list and
 * confirmed on cuts that it was not fitted to.
 *
 * evidence: predicted; about: fitted on it, whose residual is explained (the recalibrated model).
 * count, out: WCUT_DEPENDENCES; count 0 where nothing is found. Quantities by name: "ln heat", "ln speed",
 * "sin(2 pi y / 70 mm)" (phase as "+ 0.6" behind), "exp(-t / 1.5 s) of ln speed", "1 / force", ...
 * WCUT_OK; as wcut_models_rows: nothing was written.
 */
wcut_status wcut_dependence_find(const wcut_evidence *evidence, const wcut_fitted *about, int *count,
                                 wcut_dependence *out, wcut_error *error);

#endif
