/* The force of the foam on one node of a moving wire, and how it changes (Rust et al. 2016, 3). */
#ifndef WCUT_FOAM_RESISTANCE_H
#define WCUT_FOAM_RESISTANCE_H

#include <stdbool.h>
#include <wirecut/force_law.h>

#include "base/mat3.h"
#include "foam/block.h"
#include "foam/local_law.h"

typedef struct wcut_foam {
    wcut_force_law law;
    wcut_block block;
    bool embedded;              /* the wire ends on the block: every node is in the foam (design mode) */
    const wcut_locality *local; /* effects at work; NULL: the plain law */
} wcut_foam;

typedef struct wcut_resistance {
    wcut_vec3 force;                   /* [N] on the node */
    double line;                       /* [N/mm] F(v, Q) |t x d|, per engaged length; 0 out of the foam */
    double speed;                      /* [mm/s] */
    double engaged;                    /* [1] share of the node's length in the foam */
    mat3 by_before, by_here, by_after; /* [N/mm] d force / d position of the node before, itself, the node after */
    mat3 by_was;                       /* [N/mm] d force / d position that the node comes from */
    wcut_vec3 by_log_rate;             /* [N] d force / d ln r */
} wcut_resistance;

/* f = F(v, Q) l e |t x d| (-d) for node i of n at x, which was at `was` a time 1/rate ago. `edge`: rest length of an
   edge [mm]. Where the node does not move there is no force. Drag along the wire is in the force, not in `line`. With
   `slopes` false the derivatives are left alone. */
void wcut_resistance_eval(const wcut_foam *foam, double heat, double edge, double rate, int n, const wcut_vec3 *x,
                          const wcut_vec3 *was, int i, bool slopes, wcut_resistance *out);

/* share of the straight way of a node from `was` to x that is in the foam */
double wcut_foam_inside(const wcut_foam *foam, wcut_vec3 was, wcut_vec3 x);

#endif
