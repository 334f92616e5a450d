/* The decision: one effect, two, an instrument, nothing, ambiguous, or unknown. */
#ifndef WCUT_EXPLAIN_DECIDE_H
#define WCUT_EXPLAIN_DECIDE_H

#include "explain/candidates.h"

enum { WCUT_RIVALS = 3 };

typedef struct wcut_decision {
    wcut_verdict_kind kind;
    int chosen;             /* candidate that the verdict is about, or that comes nearest; -1: recalibration alone */
    int rivals;             /* of an ambiguous verdict, `chosen` the first of them */
    int rival[WCUT_RIVALS]; /* candidates */
    int small;              /* candidate whose last effect is there but below its size of consequence; -1: none is */
    double confidence;
    double confidence_by; /* what the confidence goes by, see confidence.c */
    double adequacy;      /* [1] slow misfit that is left over that of noise */
} wcut_decision;

/* Decide by what the search found. */
wcut_decision wcut_search_decide(const wcut_search *search);

/* whether what a fit leaves is what noise and the scatter of a rig leave */
bool wcut_residual_is_noise(const wcut_fitted *fitted, const wcut_residual_stats *left);

/* whether a candidate leaves what noise and the scatter of a rig leave */
bool wcut_search_leaves_noise(const wcut_search *search, int candidate);

/* whether the form of a candidate's effect is told: it leaves noise, and no other form of it explains as much */
bool wcut_search_tells_form(const wcut_search *search, int chosen);

/* whether a candidate whose last effect is late readings explains them and leaves noise */
bool wcut_search_explains_delay(const wcut_search *search, int candidate);

/* why a candidate is not the verdict, a constant text; "" of the one that is */
const char *wcut_candidate_why(const wcut_search *search, const wcut_decision *decision, int candidate);

/* the misfit of a candidate in units of chance, its coordinates paid for: what candidates are ranked by */
double wcut_candidate_score(const wcut_search *search, int candidate);

#endif
