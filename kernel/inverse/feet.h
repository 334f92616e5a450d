/* The feet of points on the face that a run's wires sweep: a piecewise cubic through its nodes. */
#ifndef WCUT_INVERSE_FEET_H
#define WCUT_INVERSE_FEET_H

#include <stdbool.h>
#include <wirecut/vec3.h>

/* stations x nodes of them, at least 4 x 4 */
typedef struct wcut_wire_face {
    int stations, nodes;
    const wcut_vec3 *x; /* [mm] */
} wcut_wire_face;

/* The foot of a point. */
typedef struct wcut_wire_foot {
    double station, node; /* where on the face, 0 .. stations - 1 and 0 .. nodes - 1 */
    double height;     /* [mm] of the point over the face, positive where the normal (node direction x feed) points */
    double beside;     /* [mm] the point lies so far beyond the face's border; 0: it is over the face */
    wcut_vec3 normal;  /* [1] */
    wcut_vec3 outward; /* [1] from the border to the point, where it is beside */
} wcut_wire_foot;

/* the 16 nodes around a place of the face and their weights */
typedef struct wcut_stencil {
    int station, node; /* the first of four */
    double along[4], across[4];
} wcut_stencil;

wcut_stencil wcut_wire_stencil(const wcut_wire_face *face, double station, double node);

/* what a field of vectors at the nodes has at a stencil */
wcut_vec3 wcut_stencil_eval(const wcut_stencil *at, int nodes, const wcut_vec3 *field);

/* The feet of points, by Newton's method from where they were before; `known` false: from the nearest node. */
void wcut_wire_feet(const wcut_wire_face *face, int count, const wcut_vec3 *point, bool known, int threads,
                    wcut_wire_foot *foot);

#endif
