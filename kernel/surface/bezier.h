/* A surface or a curve between neighbouring knots as a Bezier patch, in homogeneous coordinates, and its halves. */
#ifndef WCUT_SURFACE_BEZIER_H
#define WCUT_SURFACE_BEZIER_H

#include <stdbool.h>
#include <wirecut/surface.h>

#include "surface/basis.h"
#include "surface/rational.h"

/* at[j][i]: i along u, j along v; a curve has degree_v 0. The patch lies in the hull of its points, its corners on it. */
typedef struct wcut_bezier {
    int degree_u, degree_v;
    double u0, u1, v0, v1;
    wcut_homogeneous at[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE];
} wcut_bezier;

/* the patch over spans that are not empty */
void wcut_bezier_of_surface(const wcut_surface *surface, int span_u, int span_v, wcut_bezier *patch);
void wcut_bezier_of_curve(const wcut_curve *curve, int span, wcut_bezier *patch);

/* the halves in one direction (de Casteljau); the patch may be the first of them */
void wcut_bezier_halve(const wcut_bezier *patch, bool along_u, wcut_bezier half[2]);

/* a point of the net in space */
static inline wcut_vec3 bezier_point(const wcut_bezier *b, int i, int j) {
    const wcut_homogeneous *h = &b->at[j][i];
    return (wcut_vec3){h->x / h->w, h->y / h->w, h->z / h->w};
}

#endif
