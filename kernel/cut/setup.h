/* What all runs of one job share: const after wcut_setup_create. */
#ifndef WCUT_CUT_SETUP_H
#define WCUT_CUT_SETUP_H

#include <wirecut/cut.h>
#include <wirecut/history.h>

#include "cut/bow.h"
#include "foam/resistance.h"

struct wcut_setup {
    wcut_job *job;
    wcut_cut_options options;
    wcut_foam foam;
    double weight; /* [N/mm] of the wire along -z; 0 in a plan, whose wire is all in the foam */
    int stations;  /* of the run: a design's have an approach before them and a way out behind */
    wcut_vec3 *end_a,
        *end_b;       /* stations: the ends of the simulated wire: mounts, in a plan points of the edge curves */
    int effect_count; /* of those that act in the step and are not neutral */
    wcut_effect *effect;
    wcut_vec3 shift;           /* [mm] of the block: mounts are that far back in its frame */
    double longer;             /* [mm] the wire is than its job states */
    double *length;            /* stations [mm] of the simulated wire */
    wcut_bow bow;              /* not `on`: the job has none */
    wcut_vec3 feed;            /* [1] direction in which the cut begins */
    int entry_end;             /* the last station at which the wire still gains slack at the beginning of the cut */
    int exit_begin;            /* the first station from which it loses slack to the end */
    int part_first, part_last; /* a design's own stations; path mode: all */
    wcut_error plan_ended;     /* why a design's plan ends before its last station; WCUT_OK where it does not */
};

/* the paths of both mounts that a plan gives, and the one length of wire between them */
typedef struct wcut_design_path {
    int stations, part_first, part_last;
    wcut_vec3 *mount_a, *mount_b; /* stations */
    double length;
} wcut_design_path;

/* [N/mm] weight of a wire by its density and diameter */
double wcut_wire_weight(const wcut_job *job);

/* a deep copy; NULL where there is no memory */
wcut_job *wcut_job_copy(const wcut_job *job);

/* run a path from its last station to its first */
void wcut_job_reverse(wcut_job *job);

/* the direction in which a setup's wire is fed at first, from its ends alone [1] */
wcut_vec3 wcut_setup_feed(const wcut_setup *setup);

/* the job's name with more behind it; false: no memory, the name is as it was */
bool wcut_job_name(wcut_job *job, const char *behind);

/* how far an edge curve may lie outside the block: what drawing and rounding leave [mm] */
#define WCUT_EDGE_TOLERANCE 0.1

/* fill end_a, end_b and length of a design's plan from its edge curves and its extra-length function */
wcut_status wcut_design_ends(const wcut_job *job, wcut_vec3 *end_a, wcut_vec3 *end_b, double *length,
                             wcut_error *error);

/* WCUT_DEGENERATE where an edge leaves the block, with the curve, the station and by how much */
wcut_status wcut_design_check_edges(const wcut_job *job, const wcut_vec3 *end_a, const wcut_vec3 *end_b,
                                    wcut_error *error);

/* The plan of a design: the setup of a wire that runs from edge to edge, all of it in foam, before the block and behind
   it too. Its run gives the shapes that the path curves lead to. */
wcut_status wcut_plan_create(const wcut_job *job, const wcut_cut_options *options, wcut_setup **plan,
                             wcut_error *error);

/* The plan of a wire between given ends: `stations` of them with the wire's length each [mm]. The job gives block, wire and
   process alone; nodes in the place of its own. */
wcut_status wcut_plan_create_between(const wcut_job *job, const wcut_cut_options *options, int stations, int nodes,
                                     const wcut_vec3 *end_a, const wcut_vec3 *end_b, const double *length,
                                     wcut_setup **plan, wcut_error *error);

/* The paths of a design from its plan's history, with an approach before its first station and a way out behind its
   last one. The caller's, to wcut_design_path_destroy. */
wcut_status wcut_design_path_create(const wcut_setup *plan, const wcut_history *history, wcut_design_path *out,
                                    wcut_error *error);
void wcut_design_path_destroy(wcut_design_path *path);

/* words on a length that is about 10, 25.4 or 1000 times what it is held against; "" where it is not */
const char *wcut_unit_hint(double length, double against);

#endif
