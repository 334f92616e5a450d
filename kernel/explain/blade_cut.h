/* A recording of a blade in bins: where it was, how it slid along its edge and advanced across it, and what it felt. */
#ifndef WCUT_EXPLAIN_BLADE_CUT_H
#define WCUT_EXPLAIN_BLADE_CUT_H

#include <wirecut/diagnosis.h>

#include "foam/blade_edge.h"

#define WCUT_BLADE_BIN 0.2 /* [s] of a bin: below the memory of any feed, above that of a force sensor's filter */

typedef struct wcut_blade_cut {
    const wcut_job *job; /* NULL: the cut is left out */
    int bins;
    double *time;     /* bins [s] middle */
    double *station;  /* bins [1] of the job's path, by the way along the feed */
    double *way;      /* bins [mm] advance over the bin, not negative */
    double *advance;  /* bins [mm/s] across the edge */
    double *slide;    /* bins [mm/s] along the edge, either way positive */
    double *force;    /* bins [N] against the advance, zero taken away */
    double *along;    /* bins [N] along the edge */
    int *pass;        /* bins */
    wcut_vec3 *place; /* bins [mm] tool's origin in the block frame */
    int passes;
    wcut_blade_way line; /* of all bins */
    double zero[3];      /* [N] what the sensor reads before the first contact, in the tool's axes */
    double noise;        /* [N] of a bin's mean */
    double gain;         /* [mm/s per N] by which sliding follows the force */
    double gain_error;
    double ratio; /* [1] median of slide / advance in air */
    double max;   /* [N] 95 % quantile of the force */
} wcut_blade_cut;

/* cut: of a blade's job with poses that keep their direction. WCUT_OK; WCUT_DEGENERATE (a blade that turns, no motion, fewer
   than 20 bins), WCUT_NO_MEMORY: out holds nothing. */
wcut_status wcut_blade_cut_create(const wcut_diagnosis_cut *cut, wcut_blade_cut *out, wcut_error *error);
void wcut_blade_cut_destroy(wcut_blade_cut *cut);

#endif
