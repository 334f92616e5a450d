/* A blade's cases fitted: one model to all cuts, and each cut predicted by what the others say. */
#ifndef WCUT_EXPLAIN_BLADE_FIT_H
#define WCUT_EXPLAIN_BLADE_FIT_H

#include "explain/blade_model.h"

/* The cuts of a case, and on which scale their forces are compared: z = s asinh(F / s), linear for small forces and
   logarithmic for large ones, where a model is off by a share (Burbidge, Magee, Robb 1988). */
typedef struct wcut_blade_case {
    int cuts;
    wcut_blade_cut *cut; /* cuts; without a job: left out */
    double scale;        /* [N] s */
} wcut_blade_case;

double wcut_blade_transform(const wcut_blade_case *c, double force);

/* A model fitted, and judged by leaving each cut out in turn. */
typedef struct wcut_blade_fit {
    wcut_blade_model model;            /* fitted to all cuts */
    double cost;                       /* sum of squares, whitened */
    double error[WCUT_BLADE_UNKNOWNS]; /* standard errors, jackknife over cuts */
    double **force;                    /* cuts arrays of bins [N]: fitted to all */
    double **held_out;       /* the same, each cut by a fit to the others; NULL before wcut_blade_fit_leave_out */
    double *rmse, *rmse_out; /* cuts [N] */
} wcut_blade_fit;

/* fit to all cuts from a start; out is destroyed by the caller, on failure too. WCUT_OK, WCUT_NO_MEMORY, WCUT_DEGENERATE */
wcut_status wcut_blade_fit_run(const wcut_blade_case *c, const wcut_blade_model *start, wcut_blade_fit *out);

/* the same for each cut left out in turn; needs two cuts or more */
wcut_status wcut_blade_fit_leave_out(const wcut_blade_case *c, wcut_blade_fit *fit);
void wcut_blade_fit_destroy(const wcut_blade_case *c, wcut_blade_fit *fit);

/* held_out: cuts arrays of bins [N], each predicted by a ridge regression on the motion of the others (no physics);
   in_sample the same fitted to all. WCUT_OK, WCUT_NO_MEMORY */
wcut_status wcut_blade_black_box(const wcut_blade_case *c, double **in_sample, double **held_out);

double **wcut_blade_rows_create(const wcut_blade_case *c);
void wcut_blade_rows_destroy(const wcut_blade_case *c, double **rows);

#endif
