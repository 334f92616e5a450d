/* The search: recalibration, every effect alone, every pair that matters, each fitted in full. */
#ifndef WCUT_EXPLAIN_SEARCH_H
#define WCUT_EXPLAIN_SEARCH_H

#include "explain/candidates.h"

enum { WCUT_SEARCH_STEPS = 52 };

/*
 * Search a case, in up to WCUT_SEARCH_STEPS steps of evidence->stop.
 * WCUT_OK; WCUT_INTERRUPTED: what was found so far, where `none` was fitted at least, else nothing was written; as
 * wcut_model_fit: nothing was written.
 */
wcut_status wcut_search_run(wcut_evidence *evidence, const bool without[WCUT_EFFECT_COUNT], wcut_search *out,
                            wcut_error *error);
void wcut_search_destroy(wcut_search *search);

#endif
