/* The screen: every effect of the library as a column, every single one and every pair solved at once. */
#ifndef WCUT_EXPLAIN_SCREEN_H
#define WCUT_EXPLAIN_SCREEN_H

#include "explain/model_fit.h"

/* A column: an effect whose first coordinate is free, at the shape its variant says. */
typedef struct wcut_screen_column {
    wcut_effect effect;
    bool carried;
    int part;  /* of an effect of several strengths (scan_offset) the strength; else 0 */
    int group; /* columns of one group are taken together */
} wcut_screen_column;

typedef struct wcut_screen {
    int base, nuisances, columns; /* base and nuisances come first in `normal` */
    int groups;
    wcut_screen_column *column; /* columns */
    wcut_normal_equations normal;
    double *plain, *white;      /* (base + nuisances + columns) x rows, as measured and whitened */
    double *residual, *missing; /* rows, as measured; NaN where nothing was measured */
    double *centre, *precision; /* base + nuisances + columns */
    double cost;                /* of recalibration alone */
} wcut_screen;

/* Columns about a model, which may hold effects already. residual: rows, as measured, measured less predicted there, the
   nuisances still in (wcut_fitted.open).
   WCUT_OK; as wcut_models_rows: nothing was written. */
wcut_status wcut_screen_create(const wcut_evidence *evidence, const wcut_model *about, const double *residual,
                               const bool without[WCUT_EFFECT_COUNT], wcut_screen *out, wcut_error *error);
void wcut_screen_destroy(wcut_screen *screen);

/* The sums anew after the evidence's noise has changed. */
void wcut_screen_weigh(const wcut_evidence *evidence, wcut_screen *screen);

/*
 * The screen about a fit of the same library: its residual, its effects' own columns beside recalibration, no variant of
 * what it has already. The other columns stay those of the plain model: what two effects have in common is of second order.
 * out: the caller's, to wcut_screen_destroy. WCUT_OK; WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_screen_about(const wcut_evidence *evidence, const wcut_screen *from, const wcut_fitted *fitted,
                              wcut_screen *out);

/*
 * The variances of a saturated model: whatever the library could explain is taken out, the best of every kind together, so
 * that no effect is taken for scatter. They become the evidence's own, and the screen is weighed with them.
 * score: -2 ln likelihood of the saturated model, under its own variances; may be NULL.
 * WCUT_OK; WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: the evidence keeps its noise.
 */
wcut_status wcut_screen_saturate(wcut_evidence *evidence, wcut_screen *screen, double *score);

/* What a choice of groups gives. */
typedef struct wcut_screened {
    int groups, group[2];
    double gain;           /* fall of the cost */
    wcut_effect effect[2]; /* at the strength found */
    bool carried;
    double size[2]; /* in gates; 0: on the far side of a bound that is its neutral value */
} wcut_screened;

/* groups: 1 or 2, different. False where they cannot be told apart. */
bool wcut_screen_solve(const wcut_screen *screen, int groups, const int *group, wcut_screened *out);

/* every single group, best gain first; out: screen->groups. Gives how many. */
int wcut_screen_singles(const wcut_screen *screen, wcut_screened *out);

/* the best pairs of different kinds, both on the side that their bounds allow, best first; out: max. Gives how many. */
int wcut_screen_pairs(const wcut_screen *screen, int max, wcut_screened *out);

#endif
