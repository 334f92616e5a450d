/* Columns of a density inclusion at every place of the block that a wire has passed. */
#ifndef WCUT_EXPLAIN_INCLUSIONS_H
#define WCUT_EXPLAIN_INCLUSIONS_H

#include "explain/evidence.h"

typedef struct wcut_inclusions {
    int count;
    wcut_effect *effect; /* count: foam_inclusion of amplitude 1 at the place */
    double *column;      /* count x rows of the evidence: change of the prediction by an amplitude of 1 */
} wcut_inclusions;

/* WCUT_OK; as wcut_response_run: nothing was written. */
wcut_status wcut_inclusions_create(const wcut_evidence *evidence, const wcut_model *about, wcut_inclusions *out,
                                   wcut_error *error);
void wcut_inclusions_destroy(wcut_inclusions *inclusions);

#endif
