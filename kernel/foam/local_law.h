/* The force law at one node of the wire, with what effects make of coefficient, heat and rate there. */
#ifndef WCUT_FOAM_LOCAL_LAW_H
#define WCUT_FOAM_LOCAL_LAW_H

#include <wirecut/effects.h>
#include <wirecut/force_law.h>

#include "foam/block.h"
#include "foam/locality.h"

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

/* xi_0 and m of softening by sliding along the wire; false where there is none */
bool wcut_locality_slice(const wcut_locality *at, double *ratio, double *exponent);

/* choices of tangential_drag: Coulomb's, or growing with the speed along the wire */
typedef enum wcut_drag_law { WCUT_DRAG_LAW_COULOMB, WCUT_DRAG_LAW_SPEED } wcut_drag_law;

typedef struct wcut_drag {
    wcut_drag_law law;
    double mu, speed; /* [1]; [mm/s] over which Coulomb's is smoothed at rest, or at which the other has mu */
} wcut_drag;

/* drag along the wire; false where there is none */
bool wcut_locality_drag(const wcut_locality *at, wcut_drag *drag);

#endif
