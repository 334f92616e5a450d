/* Arc lengths along a curve at many parameters, to find many parameters of given lengths quickly. */
#ifndef WCUT_SURFACE_ARC_TABLE_H
#define WCUT_SURFACE_ARC_TABLE_H

#include <wirecut/curve.h>

typedef struct wcut_arc_table {
    const wcut_curve *curve; /* borrowed */
    int count;
    double *u;      /* count parameters from one end to the other */
    double *length; /* count [mm] from the first point */
} wcut_arc_table;

/* WCUT_DEGENERATE where the length overflows, WCUT_NO_MEMORY: nothing was written */
wcut_status wcut_arc_table_fill(const wcut_curve *curve, wcut_arc_table *table);

/* free what it gave; a zeroed table is allowed */
void wcut_arc_table_clear(wcut_arc_table *table);

/* The points at shares 0, 1/(count-1), .., 1 of the length; all the first point where there is no length. */
void wcut_arc_table_points(const wcut_arc_table *table, int count, wcut_vec3 *point);

#endif
