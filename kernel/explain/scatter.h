/* The columns of the scatter: what differs from cut to cut in every rig, and is therefore no effect. */
#ifndef WCUT_EXPLAIN_SCATTER_H
#define WCUT_EXPLAIN_SCATTER_H

#include "explain/evidence.h"

/*
 * Columns of the scatter under the evidence's model, and the slow noise that misplaced mounts make (`path_response`).
 * The evidence must be predicted. WCUT_OK; as wcut_models_rows: nothing was written.
 */
wcut_status wcut_scatter_create(wcut_evidence *evidence, wcut_error *error);

#endif
