/* The columns of the scatter: what differs from cut to cut in every rig, and is therefore no effect. */
#ifndef WCUT_EXPLAIN_SCATTER_H
#define WCUT_EXPLAIN_SCATTER_H

#include "explain/evidence.h"

/*
 * Columns of the scatter under the evidence's model, and the slow noise that misplaced mounts make (`path_response`).
 * The evidence must be predicted. WCUT_OK; as wcut_models_rows: nothing was written.
 */
wcut_status wcut_scatter_create(wcut_evidence *evidence, wcut_error *error);

/*
 * Predict and take the columns anew with each cut's wire at a length of its own, since 2 mm of a wire bend what they change.
 * length: cuts [mm], over what the model says; NULL: none. What is left is measured from one length all the same (own_rows).
 * WCUT_OK; as wcut_scatter_create, or where no wire spans its mounts: the evidence is to be predicted again.
 */
wcut_status wcut_scatter_take_lengths(wcut_evidence *evidence, const double *length, wcut_error *error);

#endif
