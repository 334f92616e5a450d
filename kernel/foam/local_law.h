/* The force law at one node of the wire, with what effects make of coefficient, heat and rate there. */
#ifndef WCUT_FOAM_LOCAL_LAW_H
#define WCUT_FOAM_LOCAL_LAW_H

#include <wirecut/effects.h>
#include <wirecut/force_law.h>

#include "foam/block.h"

/* What a node remembers of its way, for effects that have a memory. */
typedef struct wcut_node_state {
    bool set;       /* false: nothing yet, it is in its steady state */
    double way;     /* [mm] it has cut */
    double theta;   /* [K] wire over ambient */
    double steady;  /* [K] where theta was heading, Q / H(v) */
    double loss;    /* [W/mK] H(v) */
    double held[2]; /* [ln mm/s] or [ln W/m]: of empirical terms with a memory, in their order */
} wcut_node_state;

/* The effects at work in a step; a foam without has NULL in their place. */
typedef struct wcut_locality {
    int count;
    const wcut_effect *effect;
    const wcut_node_state *state; /* a node each, at the beginning of the step */
    double edge;                  /* [mm] rest length */
    double age;                   /* [s] since the wire entered the foam, at the beginning of the step */
    double clock;         /* [s] of the run, or of the recording that is replayed, at the beginning of the step */
    const wcut_vec3 *was; /* where the nodes were at the beginning of the step; NULL: not known */
} wcut_locality;

/* F [N/mm] at a node and how it changes */
typedef struct wcut_local_law {
    double force;
    double by_speed;       /* at a given rate */
    double by_log_rate;    /* at a given speed: the step's duration changes what is remembered */
    wcut_vec3 by_position; /* at a given speed */
    double heat;           /* [W/m] that reaches the foam */
} wcut_local_law;

/* node i of n at x, moving at `speed` in a step that takes 1/rate */
wcut_local_law wcut_local_law_eval(const wcut_locality *at, const wcut_block *block, const wcut_force_law *law,
                                   double heat, double rate, double speed, int n, wcut_vec3 x, int i);

/* what the node remembers after such a step, of whose way the share `inside` was in the foam */
wcut_node_state wcut_node_state_after(const wcut_locality *at, double heat, double rate, double speed, double inside,
                                      int n, int i);

/* mu and v_smooth [mm/s] of drag along the wire; false where there is none */
bool wcut_locality_drag(const wcut_locality *at, double *mu, double *smooth);

#endif
