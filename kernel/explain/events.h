/* Events: windows of one cut in which the force is another, and which no other cut repeats. */
#ifndef WCUT_EXPLAIN_EVENTS_H
#define WCUT_EXPLAIN_EVENTS_H

#include "explain/model_fit.h"

enum { WCUT_EVENTS_MAX = 24 };

typedef struct wcut_events {
    int count;
    wcut_event event[WCUT_EVENTS_MAX];
    double recalibrated,
        after; /* [N] rms of the tensions over all bins: as the rest says; with each window's level, told
                                   by every other bin of it */
} wcut_events;

/*
 * Windows where the tensions of one cut leave a recalibration that holds for the rest: a robust fit of the base
 * coordinates, then runs of bins far from it. Count 0 where there are none, where they are too many to be events, or where
 * the rest is no better without them. WCUT_OK; as wcut_models_rows, WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_events_find(const wcut_evidence *evidence, const wcut_fitted *recalibrated, wcut_events *out,
                             wcut_error *error);

/* Take the bins of the events out of what was measured. Gives what was measured before, for wcut_events_restore, the
   caller's to free; NULL where there is no memory. */
double *wcut_events_mask(const wcut_events *events, wcut_evidence *evidence);
void wcut_events_restore(const double *kept, wcut_evidence *evidence);

#endif
