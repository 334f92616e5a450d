/* Normal equations with priors, whole and by cut, the scatter of each cut integrated out. */
#ifndef WCUT_EXPLAIN_NORMAL_EQUATIONS_H
#define WCUT_EXPLAIN_NORMAL_EQUATIONS_H

#include "explain/evidence.h"

enum { WCUT_FITTED_MAX = 64 }; /* columns that are solved for at once */

/* Columns of a linear problem in whitened rows, with normal priors; the scatter of each cut is integrated out. */
typedef struct wcut_normal_equations {
    int n;
    double *gram;   /* n x n, whole */
    double *moment; /* n */
    double total;   /* residual squared */
    int cuts;
    double *cut_gram;    /* cuts x n x n */
    double *cut_moment;  /* cuts x n */
    double *cut_total;   /* cuts */
    double *cut_log_det; /* cuts: what the scatter adds to the covariance, ln det (I + J S J') */

    /* before the scatter: products of the columns, of the scatter's columns J with them, and of J with itself */
    int m;
    double *plain_gram;   /* cuts x n x n */
    double *plain_moment; /* cuts x n */
    double *plain_total;  /* cuts */
    double *cross;        /* cuts x m x n */
    double *cross_moment; /* cuts x m */
    double *own;          /* cuts x m x m */
    double *room;         /* cuts x m x n, scratch */
} wcut_normal_equations;

/* n columns, m of the scatter in every cut */
wcut_status wcut_normal_equations_create(int n, int m, int cuts, wcut_normal_equations *out);
void wcut_normal_equations_destroy(wcut_normal_equations *normal);

/*
 * Sums of whitened columns (n x rows) and residual (rows), by cut, weighed with the evidence's scatter. m: 0, or the
 * evidence's count of scatter columns.
 */
void wcut_normal_equations_fill(const wcut_evidence *evidence, const double *column, const double *residual,
                                wcut_normal_equations *out);

/* The same sums under another scatter: gram, moment and total anew (Woodbury 1950), noise as it was filled with. */
void wcut_normal_equations_weigh(const wcut_evidence *evidence, wcut_normal_equations *out);

/*
 * min |r - X t|^2 + sum precision (t - centre)^2 over the chosen columns, all cuts or all but one (without: -1 for all).
 * chosen: count indices; centre, precision: by column of `normal` (n). t: count; covariance: count x count or NULL.
 * *cost: the minimum. False where the columns are dependent beyond what the priors hold.
 */
bool wcut_normal_equations_solve(const wcut_normal_equations *normal, int count, const int *chosen,
                                 const double *centre, const double *precision, int without, double *t,
                                 double *covariance, double *cost);

/* |r - X t|^2 of one cut */
double wcut_normal_equations_cost(const wcut_normal_equations *normal, int cut, int count, const int *chosen,
                                  const double *t);

#endif
