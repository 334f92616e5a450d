/* The scatter of a rig as a table: what differs from cut to cut, each with its interval. */
#ifndef WCUT_EXPLAIN_RIG_H
#define WCUT_EXPLAIN_RIG_H

#include "explain/model_fit.h"

/* Fill diagnosis->rig by the scatter under a fit. WCUT_OK; WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_rig_fill(const wcut_evidence *evidence, const wcut_fitted *fitted, wcut_diagnosis *diagnosis);

/* The largest of it in words, ", block to block 4.8 %, ..."; "" where there is nothing beyond the usual. */
void wcut_rig_sentence(const wcut_diagnosis *diagnosis, int size, char *text);

#endif
