/* The forward proof: every cut predicted by models that were fitted on the other cuts, and the figures of it. */
#ifndef WCUT_EXPLAIN_CROSS_VALIDATION_H
#define WCUT_EXPLAIN_CROSS_VALIDATION_H

#include "explain/model_fit.h"

/* A prediction of a whole case beside its measurements, in bins and patches. */
typedef struct wcut_forecast {
    double *row;   /* evidence->rows: along the recorded motion [N, rad]; patches [mm]; NaN where missing */
    double *speed; /* 2 x all bins [mm/s]: cut by cut mount A's bins, then mount B's, of the planned run; NaN missing */
} wcut_forecast;

/* What is measured is the same for all models: `row` is that of the evidence, patches their distance. */
typedef struct wcut_cross_validation {
    wcut_forecast measured;
    wcut_forecast in_sample[WCUT_EVIDENCE_MODEL_BLACK_BOX]; /* before, recalibrated, after: fitted on all cuts */
    wcut_forecast
        held_out[WCUT_EVIDENCE_MODEL_BLACK_BOX]; /* each cut by models fitted on all but it; before: as in_sample */
    wcut_evidence_score score[WCUT_EVIDENCE_MODEL_COUNT][WCUT_EVIDENCE_CHANNEL_COUNT];
    wcut_evidence_score held_out_score[WCUT_EVIDENCE_MODEL_COUNT]
                                      [WCUT_EVIDENCE_CHANNEL_COUNT]; /* all cuts, each held out in turn */
} wcut_cross_validation;

/*
 * Predict every cut of a case and score it: as the jobs are (their own law and effects), recalibrated, and with the
 * effects chosen.
 *
 * Tension and angles are replayed along the recorded motion with WCUT_NODES_FINE nodes; the speed, which nothing was
 * fitted to, is that of a tension-driven run of the model's job, and of cuts without excitation alone, for a plan knows
 * none; a plan that ends early is compared as far as it goes. Scans are compared by patches as they come, for what a
 * scan is shifted by may be the effect; the face lies half a kerf below the wire: the job's own kerf before, the one
 * that the fits found after, for a left-out cut the one that the other scans show.
 *
 * Figures are of one-second means over all cuts, differences of both mounts and all cuts pooled, one range: rmsd,
 * nrmsd and rmse_over_range as wcut_score. Intervals: bootstrap of blocks of 5 s (scans: of 20 patches), drawn alike
 * for all models. With one cut alone nothing can be held out: the counts of held_out_score are 0.
 * The rows of WCUT_EVIDENCE_MODEL_BLACK_BOX are left at count 0 (explain/black_box.h fills them).
 *
 * evidence: predicted, under any model; recalibrated, chosen: fitted on it; may be the same, then it is run once.
 * out: the caller's, to wcut_cross_validation_destroy; the same for any number of threads.
 * WCUT_OK; as wcut_response_run, WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_cross_validation_create(const wcut_evidence *evidence, const wcut_fitted *recalibrated,
                                         const wcut_fitted *chosen, unsigned long long seed, wcut_cross_validation *out,
                                         wcut_error *error);
void wcut_cross_validation_destroy(wcut_cross_validation *proof);

/* Figures of a forecast in each channel; pairs of which a side is NaN are left out. fit: WCUT_EVIDENCE_CHANNEL_COUNT.
   WCUT_OK; WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_forecast_score(const wcut_evidence *evidence, const wcut_forecast *measured,
                                const wcut_forecast *predicted, unsigned long long seed, wcut_evidence_score *fit);

#endif
