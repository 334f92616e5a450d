/* A case of a blade diagnosed: the same questions as of two arms, asked of forces. */
#ifndef WCUT_EXPLAIN_BLADE_DIAGNOSIS_H
#define WCUT_EXPLAIN_BLADE_DIAGNOSIS_H

#include "explain/blade_search.h"

enum { WCUT_BLADE_STEPS = 2 + WCUT_BLADE_CANDIDATES + 2 };

/* everything in a run */
typedef struct wcut_blade_run {
    int cuts;
    const wcut_diagnosis_cut *cut;
    const wcut_diagnosis_options *options;
    wcut_stop *stop;
    wcut_blade_case data;
    wcut_blade_search search;
    wcut_error *left_out;    /* cuts: why a cut is left out; WCUT_OK where it is not */
    double **before;         /* [N] under the jobs alone */
    double **box, **box_out; /* [N] of the black box; NULL without a proof */
    wcut_diagnosis *out;
} wcut_blade_run;

/* Diagnose a case whose jobs are of blades into d, which has cuts and held_out. WCUT_OK; WCUT_BAD_ARGUMENT (rigs that differ, a
   recording without forces), WCUT_DEGENERATE (no usable cut), WCUT_INTERRUPTED, WCUT_NO_MEMORY. */
wcut_status wcut_blade_diagnose(int cuts, const wcut_diagnosis_cut *cut, const wcut_diagnosis_options *options,
                                wcut_stop *stop, wcut_diagnosis *d, wcut_error *error);

/* the models of a run that figures are of: before, recalibrated, after; of cuts left out or of all */
double *const *wcut_blade_forces(const wcut_blade_run *g, wcut_evidence_model model, bool left_out);

/* the figures of a model over all cuts */
wcut_evidence_score wcut_blade_score(const wcut_blade_case *c, double *const *force, wcut_status *status);

/* rows of the rig, mismatches, traces, ranking; then sentence and limits. false: no memory */
bool wcut_blade_report(wcut_blade_run *g);
bool wcut_blade_tell(wcut_blade_run *g);

#endif
