/* Evaluation on a tensor grid: the basis of every parameter once, rows of control points folded along v, then u. */
#ifndef WCUT_SURFACE_GRID_H
#define WCUT_SURFACE_GRID_H

#include <wirecut/surface.h>

#include "surface/rational.h"

/* the basis functions of one direction at many parameters */
typedef struct wcut_axis {
    int count, degree, order;
    int *first;    /* count: the first control point that counts */
    double *value; /* count x (order + 1) x (degree + 1) */
} wcut_axis;

/* WCUT_NO_MEMORY: nothing was written. The caller ends it with wcut_axis_clear. */
wcut_status wcut_axis_fill(int degree, int control_count, const double *knots, int count, const double *parameter,
                           int order, wcut_axis *axis);

/* free what wcut_axis_fill gave; a zeroed axis is allowed */
void wcut_axis_clear(wcut_axis *axis);

/* row[i] = sum_r d^l N_r(v_j) w P: the surface's iso-curve at v_j, count_u homogeneous control points */
void wcut_grid_fold(const wcut_surface *surface, const wcut_axis *v, int j, int l, wcut_homogeneous *row);

/* the k-th derivative of a folded row at u_i */
wcut_homogeneous wcut_grid_along(const wcut_axis *u, int i, int k, const wcut_homogeneous *row);

/* the points at v_j and every u; room: count_u of the surface, to fold in */
void wcut_grid_row(const wcut_surface *surface, const wcut_axis *u, const wcut_axis *v, int j, wcut_homogeneous *room,
                   wcut_vec3 *point);

#endif
