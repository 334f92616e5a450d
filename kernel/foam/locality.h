/* What effects see of a step: themselves, what each node remembers of its way, and the clock. */
#ifndef WCUT_FOAM_LOCALITY_H
#define WCUT_FOAM_LOCALITY_H

#include <stdbool.h>
#include <wirecut/effects.h>

/* What a node remembers of its way, for effects that have a memory. */
typedef struct wcut_node_state {
    bool set;       /* false: nothing yet, it is in its steady state */
    double way;     /* [mm] it has cut */
    double theta;   /* [K] wire over ambient; of the melt Q / v [W s/(m mm)] */
    double steady;  /* the same, where theta was heading: Q / H(v) */
    double slow;    /* [K] the same of the slow part, where there is one */
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

#endif
