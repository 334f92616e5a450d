/* Which effect explains a blade's forces: every one fitted, each judged by cuts that it was not fitted to. */
#ifndef WCUT_EXPLAIN_BLADE_SEARCH_H
#define WCUT_EXPLAIN_BLADE_SEARCH_H

#include "explain/blade_fit.h"
#include "explain/stop.h"

enum { WCUT_BLADE_CANDIDATES = 6 };

/* An effect that was tried. */
typedef struct wcut_blade_candidate {
    wcut_blade_fit fit;
    double gain;      /* mean over cuts of ln(RMSE recalibrated / RMSE with the effect), both of cuts left out */
    double p;         /* of that mean by Student's t over cuts, one-sided */
    int better, used; /* cuts that it predicts better, of so many */
    double share;     /* [1] fall of the RMSE of all left-out samples */
    const char *why;  /* why it is not named, a constant text; "" of the one that is */
} wcut_blade_candidate;

/* What was found. */
typedef struct wcut_blade_search {
    wcut_blade_fit none; /* recalibrated */
    int count;
    wcut_blade_candidate candidate[WCUT_BLADE_CANDIDATES];
    int chosen;        /* -1: none is named */
    double confidence; /* of what is named, or 0 */
    bool contrast;     /* cuts slide by strategies that differ: sliding can be told from what it follows */
    double adequacy;   /* [1] misfit of what is chosen over the sensor's noise */
} wcut_blade_search;

/* search: to be destroyed, on failure too. WCUT_OK, WCUT_NO_MEMORY, WCUT_INTERRUPTED, WCUT_DEGENERATE */
wcut_status wcut_blade_search_run(const wcut_blade_case *c, const bool without[WCUT_EFFECT_COUNT], double a,
                                  wcut_stop *stop, wcut_blade_search *search);
void wcut_blade_search_destroy(const wcut_blade_case *c, wcut_blade_search *search);

#endif
