/* Evidence: what a case measured and what the simulator says of it, in bins of time and patches of the scanned face. */
#ifndef WCUT_EXPLAIN_EVIDENCE_H
#define WCUT_EXPLAIN_EVIDENCE_H

#include <wirecut/cloud.h>
#include <wirecut/diagnosis.h>

#include "explain/scatter_kind.h"
#include "explain/trajectory.h"

/* A model of a case: what its cuts share. The plain one has no effects. */
typedef struct wcut_model {
    double a, b;          /* [N/mm], [m^2/J] of the force law */
    double length_change; /* [mm] added to every job's wire length */
    int effects;
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    bool carried; /* fouling is brought along from cut to cut */
} wcut_model;

/* A scan as means over patches of the face: rows of the evidence behind those of time. */
typedef struct wcut_patches {
    int count;
    double *station;   /* count: of the path */
    double *across;    /* count: share of the wire's length from mount A */
    wcut_vec3 *point;  /* count [mm] of the face */
    wcut_vec3 *normal; /* count, out of the lower half */
    double *distance;  /* count [mm] of the scan above the wire's surface */
    double *sigma;     /* count [mm] of the mean */
    double *q_eff;     /* count [J/m^2] */
    double spread;     /* [mm] standard deviation of a point within its patch */
} wcut_patches;

typedef struct wcut_evidence_cut {
    int index; /* in the case */
    const wcut_job *job;
    const wcut_recording *recording;
    const wcut_cloud *scan; /* NULL: none */
    wcut_trajectory recorded, exogenous;
    double own_length;               /* [mm] of this cut's wire over the others', about which all rows are linear */
    double contact, leave;           /* [s] when the wire is taut, and when it leaves */
    int bins;                        /* may be 0 */
    double from;                     /* [s] where the first bin begins */
    double *middle;                  /* bins [s] */
    double *measured[WCUT_SIGNALS];  /* bins; NaN where missing */
    double within[WCUT_SIGNALS];     /* [N, rad] of a bin's mean by the steps from reading to reading; 0: not known */
    double *predicted[WCUT_SIGNALS]; /* bins, along the recorded motion under `at`; NaN where missing */
    double *station, *heat, *pace, *engaged; /* bins; pace [mm/s] of the faster mount */
    wcut_patches patch;
    wcut_response reference; /* along the exogenous trajectory under `at`, with positions where there is a scan */
    int row;                 /* channel c of bin i is row + c * bins + i, patch p row + 6 bins + p */
} wcut_evidence_cut;

typedef struct wcut_evidence {
    int cuts;
    wcut_evidence_cut *cut;
    wcut_model at; /* what predicted, patches and reference are of */
    int rows;
    double sigma[WCUT_SIGNALS];                  /* [N, rad] of a bin's mean, its white part */
    wcut_variances noise;                        /* that rows are whitened by */
    wcut_scatter_info known[WCUT_SCATTER_COUNT]; /* what noise.known points to */
    double delay_spread[2];                      /* [s] usual delays of tensions and angles */
    double
        path_response[WCUT_NOISE_GROUPS]; /* [N, rad per mm] rms of a group by mounts beside their path; 0: not known */
    wcut_scatter scatter;                 /* no columns before wcut_scatter_create */
    double *own_rows; /* rows: what own_length changes, by the scatter's column; NULL: no cut has one */
    int threads;
    wcut_stop *stop; /* NULL: nobody stops what is done with it */
} wcut_evidence;

/* nodes of the wire along the recorded motion, and along the exogenous one, where only differences count: the
   simulator's order in the node count is 2, tensions move by 5e-4 of themselves from 31 to 121 */
enum { WCUT_NODES_FINE = 31, WCUT_NODES_COARSE = 17 };

#define WCUT_BIN_WIDTH 0.5    /* [s] */
#define WCUT_NOISE_MEMORY 5.0 /* [s] of the slow part of the noise */
#define WCUT_SLOW_NOISE 0.25  /* [1] the slow part of a good sensor's noise over the white one */

/*
 * Gather the evidence of a case: trajectories, bins, what was measured. The model `at` is the jobs' own. Cuts without job or
 * recording, or which never touch the foam, have no bins. fed_back: take the recorded motion itself for the exogenous one,
 * as plain least squares does: a control of what that costs.
 * stop: NULL, or borrowed: whatever drives a wire over this evidence ends with WCUT_INTERRUPTED once it is asked for.
 * WCUT_OK; WCUT_INTERRUPTED, WCUT_BAD_ARGUMENT, WCUT_DEGENERATE, WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: nothing was
 * written.
 */
wcut_status wcut_evidence_create(int cuts, const wcut_diagnosis_cut *cut, bool fed_back, int threads, wcut_stop *stop,
                                 wcut_evidence **out, wcut_error *error);
void wcut_evidence_destroy(wcut_evidence *evidence);

/* what the cell knows of itself, in place of what is usual */
void wcut_evidence_know(wcut_evidence *evidence, const wcut_rig_prior *prior);

/* Predict along the recorded motion under a model, which becomes `at`; noise and, if `scans`, patches follow. */
wcut_status wcut_evidence_predict(wcut_evidence *evidence, const wcut_model *model, bool scans, wcut_error *error);

/* The job of a cut under a model; effect: room for WCUT_DIAGNOSIS_EFFECTS. Borrows everything. */
wcut_job wcut_model_job(const wcut_evidence *evidence, const wcut_model *model, int cut, wcut_effect *effect);

/* [mm] the change of length, at most 0, at which every wire still spans its mounts */
double wcut_model_shortest(const wcut_evidence *evidence);

/* Rows of a prediction along the exogenous trajectory: what its signals, instruments and face come to. out: rows, those of
   other cuts are not touched. */
wcut_status wcut_evidence_rows(const wcut_evidence *evidence, int cut, const wcut_model *model,
                               const wcut_response *driven, double *out);

/* Signals of a prediction along the exogenous trajectory in the bins of a cut; out: 6 x bins. */
wcut_status wcut_evidence_bin_exogenous(const wcut_evidence_cut *cut, const wcut_model *model,
                                        const wcut_response *driven, double *out);

/* Signals of a prediction along the recorded motion in the bins of a cut; out: 6 x bins. */
wcut_status wcut_evidence_bin_recorded(const wcut_evidence_cut *cut, const wcut_model *model,
                                       const wcut_response *driven, double *out);

/* [1] What bins of the tension differ by from one to the next over what readings within them say, the larger of both mounts:
   beyond a few there is something faster than a bin, which the noise takes in. 0: not known. */
double wcut_evidence_swiftness(const wcut_evidence *evidence);

/* Measured less predicted, rows, as far as linear with every wire of one length; absent ones are NaN. */
void wcut_evidence_residual(const wcut_evidence *evidence, double *out);

/*
 * Whiten rows: noise of every channel is white with variance sigma^2 plus a slow part with `noise.slow` of it and the
 * memory WCUT_NOISE_MEMORY; what comes out has unit variance, but for the scatter. The innovations of a Kalman filter, linear in the rows.
 * present: rows of which the residual is NaN become 0 in all columns. in and out: rows, may be the same.
 */
void wcut_evidence_whiten(const wcut_evidence *evidence, const double *residual, const double *in, double *out);

/* logarithm of the determinant of the noise's covariance, without the scatter; residual: which rows are missing */
double wcut_evidence_log_det(const wcut_evidence *evidence, const double *residual);

/* Whiten the columns of the scatter under the present noise. */
void wcut_evidence_whiten_scatter(wcut_evidence *evidence, const double *residual);

/* Patches of a scan by their feet on the face of the recorded run (explain/patches.c). */
wcut_status wcut_patches_create(const wcut_evidence_cut *cut, const wcut_response *recorded, wcut_patches *out,
                                wcut_error *error);
void wcut_patches_destroy(wcut_patches *patches);

/* position (or, component by component, anything else of the nodes) at a station and a share of the wire's length */
wcut_vec3 wcut_response_position(const wcut_trajectory *trajectory, const wcut_response *driven, double station,
                                 double across);
double wcut_response_speed(const wcut_trajectory *trajectory, const wcut_response *driven, double station,
                           double across);

/* What an empirical term is in one cut of a case: time and way before it, its place in the order; a window belongs to one
   cut alone. False where the term has no part in this cut. */
bool wcut_term_place(const wcut_evidence *evidence, int cut, bool carried, wcut_effect *effect);

/* the cut that a window belongs to is kept in its unused second strength */
#define WCUT_WINDOW_CUT(effect) ((int)(effect)->value[WCUT_EMPIRICAL_FORCE_COSINE] - 1)

#endif
