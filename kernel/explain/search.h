/* The search: recalibration, every effect alone, every pair that matters, each fitted in full. */
#ifndef WCUT_EXPLAIN_SEARCH_H
#define WCUT_EXPLAIN_SEARCH_H

#include "explain/screen.h"

enum { WCUT_CANDIDATES = 24, WCUT_SCREENED = 12 };

/* What a fit leaves, against what noise would leave. */
typedef struct wcut_residual_stats {
    double per_row; /* whitened misfit a row */
    double slow;    /* mean square of the means over four seconds, times their number: 1 for white noise */
    double common;  /* the same of what both tensions share: noise of sensors is their own, physics is not */
    double patches; /* misfit a patch of the scans; 0 without */
    double worst;   /* largest `slow` of a cut's channel */
} wcut_residual_stats;

typedef struct wcut_candidate {
    wcut_fitted fit;
    int effects;
    double gain;        /* fall of the cost against recalibration */
    double held_out;    /* the same on cuts not fitted, summed */
    int better, judged; /* cuts on which the held-out misfit falls, of those compared */
    double second_size; /* of a pair: least size in gates; of a single: its size */
    wcut_residual_stats left;
} wcut_candidate;

typedef struct wcut_search {
    wcut_fitted none;
    wcut_residual_stats left; /* of none */
    int count;                /* candidates fitted: singles, then pairs, each by gain */
    wcut_candidate candidate[WCUT_CANDIDATES];
    int screened; /* the best variant of every kind, by the screen, best first */
    wcut_screened single[WCUT_EFFECT_COUNT];
    int pairs;
    wcut_screened pair[WCUT_SCREENED];
    int next; /* what the screen about the best single would add, best first */
    wcut_screened second[WCUT_EFFECT_COUNT];
} wcut_search;

enum { WCUT_SEARCH_STEPS = 12 };

/*
 * Search a case, in up to WCUT_SEARCH_STEPS steps of evidence->stop.
 * WCUT_OK; WCUT_INTERRUPTED: what was found so far, where `none` was fitted at least, else nothing was written; as
 * wcut_fit_solve: nothing was written.
 */
wcut_status wcut_search_run(const wcut_evidence *evidence, const bool without[WCUT_EFFECT_COUNT], wcut_search *out,
                            wcut_error *error);
void wcut_search_destroy(wcut_search *search);

wcut_residual_stats wcut_residual_stats_eval(const wcut_evidence *evidence, const double *residual);

#endif
