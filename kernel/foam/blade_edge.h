/* How much of a straight edge is in foam that no earlier pass of it has cut. */
#ifndef WCUT_FOAM_BLADE_EDGE_H
#define WCUT_FOAM_BLADE_EDGE_H

#include <wirecut/status.h>
#include <wirecut/vec3.h>

/* A blade that keeps its direction: where it is, moment by moment, in passes over the same plane. */
typedef struct wcut_blade_way {
    int count;
    const wcut_vec3 *place; /* count [mm] of the tool's origin */
    const int *pass;        /* count, from 0, not decreasing */
    wcut_vec3 edge, normal; /* unit: along the edge from handle to tip, and across it the way it advances */
    double from, to;        /* [mm] ends of the edge along `edge`, from the tool's origin */
} wcut_blade_way;

/* The length of the straight edge inside the box low .. high (Liang, Barsky 1984). */
double wcut_blade_edge_inside(wcut_vec3 at, wcut_vec3 edge, double from, double to, wcut_vec3 low, wcut_vec3 high,
                              double *begin, double *end);

/* engaged: count [mm], the length of the edge in the box that the passes before this one have left: of every place
   across the edge they have cut the hull of their engaged pieces. WCUT_OK; WCUT_NO_MEMORY; WCUT_DEGENERATE (a way of
   more than a million cells): nothing was written. */
wcut_status wcut_blade_engaged(const wcut_blade_way *way, wcut_vec3 low, wcut_vec3 high, double *engaged);

#endif
