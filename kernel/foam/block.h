/* The foam block, and how much of a piece of wire lies in it. */
#ifndef WCUT_FOAM_BLOCK_H
#define WCUT_FOAM_BLOCK_H

#include <wirecut/vec3.h>

/* The block fills [0,W] x [0,L] x [0,H]. A wire has a thickness: along y and z, where it can lie flat against a face,
   it enters over that depth, not at once. */
typedef struct wcut_block {
    wcut_vec3 size; /* [mm] */
    double depth;   /* [mm] over which the wire enters through a face in y or z: its diameter */
} wcut_block;

/* Share of the straight piece p-q that is in the block, 0 .. 1: clipped exactly in x, weighted over the depth of the
   faces in y and z. dp, dq: its gradients with respect to the end points [1/mm]. Continuous in p and q. */
double wcut_block_engagement(const wcut_block *block, wcut_vec3 p, wcut_vec3 q, wcut_vec3 *dp, wcut_vec3 *dq);

/* how far [mm] a point is from the block; 0 inside */
double wcut_block_distance(const wcut_block *block, wcut_vec3 p);

#endif
