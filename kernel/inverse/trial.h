/* One state of a search: curves, the run that they give, its distance to the target and the normal equations there. */
#ifndef WCUT_INVERSE_TRIAL_H
#define WCUT_INVERSE_TRIAL_H

#include "cut/sensitivity.h"
#include "inverse/curves.h"
#include "inverse/feet.h"

/* What a run of some curves reaches. */
typedef struct wcut_reached {
    double cost;     /* [mm^2] sum of weighted squares: points and bounds */
    double rms, max; /* [mm] of the points that count */
    int used, strays, uncovered;
} wcut_reached;

/* A search on runs of one size. Curves are handed in; the last evaluation's feet are kept as the next one's start. */
typedef struct wcut_trial {
    const wcut_design_target *target;
    const wcut_job *job;
    const wcut_setup
        *base;        /* path mode: the paths that curves correct; NULL: curves are a design, and its plan is run */
    double angle_max; /* [rad] */
    double longest;   /* [mm] a step's largest change of an unknown */
    int threads;
    int stations, nodes, unknowns_max;
    wcut_cut_options options;
    wcut_vec3 *end_a, *end_b; /* stations */
    double *length;
    wcut_vec3 *by_a, *by_b; /* unknowns_max x stations */
    double *by_length;
    wcut_vec3 *by;        /* unknowns_max x stations x nodes */
    wcut_wire_foot *foot; /* points */
    double *weight;       /* points: of a robust fit, else 1 */
    double *room;         /* points, and unknowns_max */
    wcut_vec3 *face;      /* stations x nodes: of a job with a kerf or effects on the face; NULL without */
    bool known;           /* foot holds feet of these stations and nodes */
    bool borrowed;        /* by holds derivatives of coarser runs: those of this size are not computed */
    int runs;
} wcut_trial;

/* A bound on a curve: excess + row . step > 0 of four coefficients costs its square. Linear, so that a step can heed it. */
typedef struct wcut_bound {
    int first;     /* of the unknowns */
    double row[4]; /* price times how the excess changes */
    double excess; /* price times what is beyond the bound; negative: what is left to it */
} wcut_bound;

enum { WCUT_BOUNDS_MAX = 240 };

/* room for a search; the target and the job are borrowed. WCUT_OK; WCUT_NO_MEMORY: nothing is kept */
wcut_status wcut_trial_create(const wcut_design_target *target, const wcut_job *job, double angle_max, int threads,
                              int stations, int nodes, int unknowns_max, wcut_trial *s);
/* The same for corrections of the paths of a setup in path mode, with its own stations; the face is the one that its job
   leaves on the block, with its kerf and effects. */
wcut_status wcut_trial_create_path(const wcut_design_target *target, const wcut_setup *base, int threads, int nodes,
                                   int unknowns_max, wcut_trial *s);
void wcut_trial_destroy(wcut_trial *s);

/* The derivatives of a coarser run of the same curves, between its nodes, in the place of a finer search's own: from size to
   size they change by little, and residuals of the finer runs lead to the same end. What cannot be run is not borrowed.
   WCUT_OK, WCUT_NO_MEMORY. */
wcut_status wcut_trial_borrow(wcut_trial *s, wcut_trial *coarse, const wcut_design_curves *c);

/* A run of curves, its derivatives in `by` where they are asked for. WCUT_OK; WCUT_NOT_CONVERGED: no such run;
   WCUT_NO_MEMORY. */
wcut_status wcut_trial_run(wcut_trial *s, const wcut_design_curves *c, bool slopes, wcut_history **history);

/* Run curves and measure them. normal (unknowns x unknowns) and gradient (unknowns) of the cost's half, the bounds
   left out, where they are not NULL. WCUT_OK; WCUT_NOT_CONVERGED: no such run; WCUT_NO_MEMORY. */
wcut_status wcut_trial_eval(wcut_trial *s, const wcut_design_curves *c, double *normal, double *gradient,
                            wcut_reached *reached);

/* the bounds at curves: on sag, and on how fast sag and lag change; their cost is in wcut_trial_eval's, their slopes are not
   in its equations. Gives how many, up to WCUT_BOUNDS_MAX. */
int wcut_trial_bounds(const wcut_trial *s, const wcut_design_curves *c, wcut_bound *bound);

/* weights of a robust fit from the distances of the last evaluation: Tukey's biweight at 4.685 times their scatter */
void wcut_trial_weigh(wcut_trial *s);

#endif
