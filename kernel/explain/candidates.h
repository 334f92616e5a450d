/* What a search has fitted: recalibration, effects alone and in pairs, and what each leaves. */
#ifndef WCUT_EXPLAIN_CANDIDATES_H
#define WCUT_EXPLAIN_CANDIDATES_H

#include "explain/screen.h"

enum { WCUT_CANDIDATES = 40, WCUT_SCREENED = 12 };

/* What a fit leaves, against what noise would leave. */
typedef struct wcut_residual_stats {
    double per_row; /* whitened misfit a row */
    double slow;    /* mean square of the means over four seconds, times their number: 1 for white noise */
    double common;  /* the same of what both tensions share: noise of sensors is their own, physics is not */
    double patches; /* misfit a patch of the scans; 0 without */
    double worst;   /* largest `slow` of a cut's channel */
    double peak;    /* largest square of a mean over four seconds, times their number */
} wcut_residual_stats;

/* of a residual (rows), whitened so that noise has unit variance */
wcut_residual_stats wcut_residual_stats_eval(const wcut_evidence *evidence, const double *residual);

typedef struct wcut_candidate {
    wcut_fitted fit;
    int effects; /* beside a delay */
    bool form;   /* the best single effect in another form of its family: it counts where it leaves noise */
    /* against late readings, where there are any, else against recalibration: */
    double gain;        /* twice the logarithm of the ratio of likelihoods, each under its own scatter */
    double fall;        /* of the misfit, under the scatter that all share */
    double held_out;    /* the same on cuts not fitted, summed */
    int better, judged; /* cuts on which the held-out misfit falls, of those compared */
    double second_size; /* of a pair: least size in gates; of a single: its size */
    wcut_residual_stats left;
} wcut_candidate;

typedef struct wcut_search {
    wcut_fitted none;
    wcut_residual_stats left; /* of none */
    int rows, cuts;           /* that are there */
    double saturated;         /* gain of the whole library at once over none, linear */
    int count;                /* candidates fitted: singles, then pairs, each by gain */
    wcut_candidate candidate[WCUT_CANDIDATES];
    int screened; /* the best variant of every kind, by the screen, best first */
    wcut_screened single[WCUT_EFFECT_COUNT];
    int pairs;
    wcut_screened pair[WCUT_SCREENED];
    int delayed;                   /* candidate of late readings alone, which all others have too; -1: none are late */
    int undelayed, undelayed_from; /* candidate that is another one without the delay, or with one; -1: none */
    int next;                      /* what the screen about the best single would add, best first */
    wcut_screened second[WCUT_EFFECT_COUNT];
} wcut_search;

/* what candidates are held against: recalibration, with the delay of late readings */
const wcut_fitted *wcut_search_base(const wcut_search *search);

#endif
