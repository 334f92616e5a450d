/* What all runs of one job share: const after wcut_setup_create. */
#ifndef WCUT_CUT_SETUP_H
#define WCUT_CUT_SETUP_H

#include <wirecut/cut.h>

#include "foam/resistance.h"

struct wcut_setup {
    wcut_job *job;
    wcut_cut_options options;
    wcut_foam foam;
    wcut_vec3 *end_a, *end_b; /* stations: the fixed ends of the simulated wire: mounts, or points of the edge curves */
    int effect_count;         /* of those that act in the step and are not neutral */
    wcut_effect *effect;
    double *length; /* stations [mm] of the simulated wire */
    wcut_vec3 feed; /* [1] direction in which the cut begins */
    int entry_end;  /* the last station at which the wire still gains slack at the beginning of the cut */
    int exit_begin; /* the first station from which it loses slack to the end */
};

/* a deep copy; NULL where there is no memory */
wcut_job *wcut_job_copy(const wcut_job *job);

/* run a path from its last station to its first */
void wcut_job_reverse(wcut_job *job);

/* the job's name with more behind it; false: no memory, the name is as it was */
bool wcut_job_name(wcut_job *job, const char *behind);

/* fill end_a, end_b and length of a design-mode setup from its edge curves and its extra-length function */
wcut_status wcut_design_ends(const wcut_job *job, wcut_vec3 *end_a, wcut_vec3 *end_b, double *length,
                             wcut_error *error);

#endif
