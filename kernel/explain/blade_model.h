/* The force on a blade as a model has it: law times engaged length times one effect, built up over a way. */
#ifndef WCUT_EXPLAIN_BLADE_MODEL_H
#define WCUT_EXPLAIN_BLADE_MODEL_H

#include "explain/blade_cut.h"
#include "explain/coordinate.h"

/* What is fitted in every model, shared by all cuts: ln a; and what no file says of the block, nuisances: ln of the way over
   which the force builds up [mm], and the block's place along the feed and up [mm] beside that of the job. Behind them
   the effect's one coordinate. */
enum { WCUT_BLADE_LAW, WCUT_BLADE_BUILD_UP, WCUT_BLADE_FEED, WCUT_BLADE_UP, WCUT_BLADE_BASE };
enum { WCUT_BLADE_UNKNOWNS = WCUT_BLADE_BASE + 1 };

typedef struct wcut_blade_model {
    bool named;         /* there is an effect */
    wcut_effect effect; /* with its choice; the value of its coordinate is in x */
    wcut_coordinate coordinate;
    double x[WCUT_BLADE_UNKNOWNS];
} wcut_blade_model;

/* how many of x are fitted */
int wcut_blade_unknowns(const wcut_blade_model *model);

/* the recalibrated model where a fit begins: the job's a, the job's block, a build-up of 20 mm */
wcut_blade_model wcut_blade_model_begin(double a);

/* force: bins [N] of a cut under a model; WCUT_OK, WCUT_NO_MEMORY, WCUT_DEGENERATE (a way that is too long) */
wcut_status wcut_blade_predict(const wcut_blade_cut *cut, const wcut_blade_model *model, double *force);

/* the force under the job alone: its a, its block, no build-up */
wcut_status wcut_blade_predict_job(const wcut_blade_cut *cut, double *force);

#endif
