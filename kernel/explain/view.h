/* Where in space the worst misfit is: the wire's surface of that cut, and what its scan shows. */
#ifndef WCUT_EXPLAIN_VIEW_H
#define WCUT_EXPLAIN_VIEW_H

#include "explain/model_fit.h"

/* The cut of the first mismatch, or the first one of the case, run along its exogenous trajectory under a fit's model. Where
   that fails the view stays empty. WCUT_OK; WCUT_INTERRUPTED, WCUT_NO_MEMORY: what was taken is the view's to free. */
wcut_status wcut_view_fill(const wcut_evidence *evidence, const wcut_fitted *after, int mismatches,
                           const wcut_mismatch *mismatch, wcut_diagnosis_view *view, wcut_error *error);

#endif
