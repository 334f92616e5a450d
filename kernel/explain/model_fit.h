/* A hypothesis fitted: recalibration and effects together, by the moments of what cannot be fed back. */
#ifndef WCUT_EXPLAIN_MODEL_FIT_H
#define WCUT_EXPLAIN_MODEL_FIT_H

#include "explain/library.h"
#include "explain/normal_equations.h"

/* base coordinates: ln a, ln b, wire length; beside the effects two delays and, with scans, one constant kerf for all */
enum { WCUT_BASE = 3, WCUT_DELAYS = 2 };

/* [s] the same where a delay is an effect */
#define WCUT_DELAY_REST 0.01

/* [mm] a hot wire's kerf in foam is about a millimetre */
#define WCUT_KERF 1.0
#define WCUT_KERF_SPREAD 0.4

/* prior standard deviations and finite steps of the base coordinates: ln a, ln b, length [mm] */
extern const double wcut_base_spread[WCUT_BASE], wcut_base_step[WCUT_BASE];

/* What a fit gives. */
typedef struct wcut_fitted {
    wcut_model model;
    int count;                      /* coordinates of effects, after the base ones */
    int effect_of[WCUT_FITTED_MAX]; /* count: of the model */
    wcut_coordinate coordinate[WCUT_FITTED_MAX];
    double x[WCUT_BASE + WCUT_FITTED_MAX],
        error[WCUT_BASE + WCUT_FITTED_MAX]; /* WCUT_BASE + count, fitted scale, and standard errors before any
                                                     allowance for dispersion */
    double below[WCUT_BASE + WCUT_FITTED_MAX],
        above[WCUT_BASE + WCUT_FITTED_MAX]; /* half widths at 95 %, fitted scale: 1.96 errors, or a profile's */
    double kerf;                            /* [mm] constant kerf the scans show; NaN without scans */
    double kerf_error;
    double cost;          /* -2 ln likelihood, priors included, under its own noise and scatter (wcut_variance_fit) */
    double misfit;        /* whitened misfit, priors included, under the evidence's noise and scatter */
    wcut_variances noise; /* its own */
    double delay[2];      /* [s] of the tension readings, of the angles, as far as scatter */
    double delay_error[2];
    double *scatter, *scatter_error; /* cuts x the evidence's scatter columns: the likeliest, and standard deviations */
    double *cut_cost;                /* cuts: of the misfit, fitted on all */
    double *held_out;                /* cuts: of the misfit of each, its effects and base fitted on the others */
    double *without;                 /* cuts x (WCUT_BASE + count): x fitted on all cuts but this one */
    double *residual;                /* rows, whitened: what the model with its nuisances and its scatter leaves */
    double *standard;  /* rows: whitened under its own noise and scatter, so that noise has unit variance */
    double *open;      /* rows, as measured: the same, delays, kerf and scatter still in */
    double *column;    /* count x rows, as measured: changes with the effects' coordinates at the end */
    double *predicted; /* rows: along the recorded motion, in N, rad, mm; patches: 0 */
    bool at_bound;     /* a coordinate ended at a bound */
} wcut_fitted;

/*
 * Fit a model whose effects stand at a start: Gauss-Newton with the columns taken along the exogenous trajectory, the
 * residual along the recorded one (Forssell, Ljung 1999: a closed loop's noise does not enter the columns).
 * evidence: predicted under its `at`. WCUT_OK; WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_model_fit(const wcut_evidence *evidence, const wcut_model *start, wcut_fitted *out, wcut_error *error);
void wcut_fitted_destroy(wcut_fitted *fitted);

/*
 * Replace `below` and `above` of the effects' coordinates by a profile's: where the misfit has risen by 3.84, the wire run
 * anew at each end and all other coordinates at their best beside it (linear about the fit); a bound, where that comes
 * first. evidence: as at the fit. WCUT_OK; WCUT_NOT_CONVERGED, WCUT_INTERRUPTED, WCUT_NO_MEMORY: nothing was changed.
 */
wcut_status wcut_fitted_profile(const wcut_evidence *evidence, wcut_fitted *fitted, wcut_error *error);

/* The standard deviation of coordinate k by leaving out each cut in turn (Tukey's jackknife): what the cuts differ by among
   themselves, whatever the noise model says. 0 below three cuts. */
double wcut_fitted_jackknife(const wcut_evidence *evidence, const wcut_fitted *fitted, int k);

/* the model at other coordinates, WCUT_BASE + count of them */
wcut_model wcut_fitted_model(const wcut_fitted *fitted, const double *x);

/*
 * Rows of models along the exogenous trajectory, every cut driven once for each model whose physics differ from the first.
 * count: at least 1; rows: count x evidence->rows.
 */
wcut_status wcut_models_rows(const wcut_evidence *evidence, int count, const wcut_model *model, double *rows,
                             wcut_error *error);

/* delays of the tension readings and of the angles, kerf of the scans: how many nuisances, their columns (count x rows), prior standard deviations */
int wcut_nuisance_count(const wcut_evidence *evidence);
void wcut_nuisance_columns(const wcut_evidence *evidence, double *column, double *spread);

/* whether two models move the wire alike */
bool wcut_models_same_motion(const wcut_model *a, const wcut_model *b);

#endif
