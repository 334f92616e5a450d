/* Scatter: what differs from cut to cut in every rig, and is therefore no effect. Each kind has a variance of its own. */
#ifndef WCUT_EXPLAIN_SCATTER_KIND_H
#define WCUT_EXPLAIN_SCATTER_KIND_H

#include <wirecut/diagnosis.h>

/* Signals of a group have one slow noise: both tensions, both alphas, both betas. */
enum { WCUT_NOISE_GROUPS = 3, WCUT_SCATTER_COLUMNS_MAX = 40 };

/* [s] readings of a channel are late by a share of a second in every rig */
#define WCUT_DELAY_SPREAD 0.1

/* What a kind of scatter is: `width` of the half-normal prior of its standard deviation, and what it may be at most. */
typedef struct wcut_scatter_info {
    double width, max;
} wcut_scatter_info;

/* What the noise and the scatter of a case are: variance components. */
typedef struct wcut_variances {
    double slow[WCUT_NOISE_GROUPS];     /* [1] variance of the slow part of the noise over that of the white one */
    double path;                        /* [mm] mounts beside their path, whose share in all groups `slow` holds */
    double scatter[WCUT_SCATTER_COUNT]; /* standard deviations from cut to cut, in the unit of each kind */
    const wcut_scatter_info *known;     /* WCUT_SCATTER_COUNT: of this cell; NULL: of an ordinary one */
} wcut_variances;

/* Columns of the scatter: each is what a cut's rows change by, per unit, and has a coefficient of its own in every cut. */
typedef struct wcut_scatter {
    int count;
    wcut_scatter_kind kind[WCUT_SCATTER_COLUMNS_MAX];
    double *column; /* count x rows of the evidence, as measured, not whitened */
    double *white;  /* the same, whitened under the evidence's noise */
} wcut_scatter;

/* of the cell that variances are of */
const wcut_scatter_info *wcut_scatter_view(const wcut_variances *variances, wcut_scatter_kind kind);

/* WCUT_OK where what a cell knows of itself (may be NULL) is positive; else WCUT_BAD_ARGUMENT */
wcut_status wcut_scatter_check(const wcut_rig_prior *prior, wcut_error *error);

/* what a cell knows of itself, as widths and bounds; a bound grows with its width */
void wcut_scatter_know(const wcut_rig_prior *prior, wcut_scatter_info known[WCUT_SCATTER_COUNT]);

/* group of a signal: 0 tension, 1 alpha, 2 beta */
int wcut_noise_group(int signal);

void wcut_scatter_destroy(wcut_scatter *scatter);

#endif
