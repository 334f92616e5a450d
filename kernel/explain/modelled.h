/* What was modelled outside the library, and events that cannot repeat: found for a diagnosis, and told in words. */
#ifndef WCUT_EXPLAIN_MODELLED_H
#define WCUT_EXPLAIN_MODELLED_H

#include "explain/empirical.h"
#include "explain/events.h"

/* An unknown verdict looked into: terms that hold on other cuts, windows of one cut that nothing repeats. */
typedef struct wcut_outside {
    wcut_empirical empirical;
    wcut_events events;
    wcut_fitted rest; /* where there are events: recalibration without their bins */
    double *kept;     /* what was measured before their bins were taken out, to put it back; NULL: all is there */
    wcut_residual_stats left; /* what the best of these leaves */
} wcut_outside;

/*
 * Look into what no known effect explains. Where there are events their bins are taken out of the evidence.
 * WCUT_OK; as wcut_empirical_find, wcut_events_find: nothing was written.
 */
wcut_status wcut_outside_find(wcut_evidence *evidence, const wcut_fitted *recalibrated, wcut_outside *out,
                              wcut_error *error);
void wcut_outside_destroy(wcut_outside *outside);

/* the fit to predict with; NULL: nothing was modelled and nothing left out */
const wcut_fitted *wcut_outside_fit(const wcut_outside *outside);

/* phi of a term as it stands in an equation: "sin(2 pi y / 72 mm + 1.2)"; to: size bytes */
void wcut_term_formula(const wcut_effect *effect, char *to, int size);

/* what a term says, a clause: "the force varies by +-41 % every 72 mm along the feed (layers in the block?)" */
void wcut_term_clause(const wcut_effect *effect, char *to, int size);

/* the diagnosis' sentence and equation of what was modelled; its figures must be there */
void wcut_modelled_tell(wcut_diagnosis *diagnosis);

#endif
