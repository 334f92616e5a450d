/* Variance components: how large noise and scatter of a case are, by the likelihood of what a model leaves. */
#ifndef WCUT_EXPLAIN_VARIANCE_H
#define WCUT_EXPLAIN_VARIANCE_H

#include "explain/normal_equations.h"

/* A linear problem in the rows as they were measured. */
typedef struct wcut_linear {
    int n;
    const double *column;             /* n x rows */
    const double *residual;           /* rows */
    const double *missing;            /* rows: NaN where nothing was measured */
    const double *centre, *precision; /* n: normal priors */
} wcut_linear;

/*
 * Estimate the noise and the scatter that a linear problem leaves: the coefficients are integrated out (restricted maximum
 * likelihood, Patterson, Thompson 1971), the standard deviations have half-normal priors (wcut_scatter_view) and are
 * bounded. By expectation and conditional maximisation (Dempster, Laird, Rubin 1977; Meng, Rubin 1993).
 * own: a copy of the evidence whose `noise` is where the search begins, with its own scatter.white, to be written; its
 * noise is the estimate afterwards.
 * column (n x rows), residual (rows): whitened under it; normal: filled, n and m as theirs.
 * score: -2 ln likelihood of the rows with the scatter integrated out, at the best coefficients, priors included.
 * WCUT_OK; WCUT_NOT_CONVERGED (dependent columns), WCUT_NO_MEMORY: own->noise, column, residual and normal are undefined.
 */
wcut_status wcut_variance_fit(const wcut_linear *problem, wcut_evidence *own, double *column, double *residual,
                              wcut_normal_equations *normal, double *score);

/* Where a search for the variances begins: no scatter below a fifth of its usual width. */
void wcut_variances_begin(wcut_variances *variances);

/* Coefficients of the scatter of a cut at coefficients t (n): the likeliest, and their standard deviations (m each). */
void wcut_scatter_estimate(const wcut_evidence *own, const wcut_normal_equations *normal, int cut, const double *t,
                           double *value, double *error);

/* rows whitened under noise and scatter: z (rows), whitened under own's noise, becomes V^-1/2 z with V = I + J S J' */
void wcut_scatter_standardise(const wcut_evidence *own, const wcut_normal_equations *normal, double *z);

#endif
