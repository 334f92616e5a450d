/* From homogeneous coordinates back to space: the quotient rule for rational derivatives. */
#ifndef WCUT_SURFACE_RATIONAL_H
#define WCUT_SURFACE_RATIONAL_H

#include <stdbool.h>
#include <wirecut/curve.h>
#include <wirecut/surface.h>

/* (w x, w y, w z, w) or a derivative of it */
typedef struct wcut_homogeneous {
    double x, y, z, w;
} wcut_homogeneous;

/* order + 1 derivatives of w P -> of P; where not rational w is 1 and its derivatives 0, whatever rounding says */
void wcut_rational_curve(int order, bool rational, const wcut_homogeneous *sum, wcut_vec3 *ders);

/* (order + 1) x (order + 1) mixed derivatives of w S -> of S, those with k + l > order 0 */
void wcut_rational_surface(int order, bool rational, const wcut_homogeneous *sum, wcut_vec3 *ders);

/* zeroed curve and surface of a size that is in range; the caller fills them. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_curve_new(int degree, int control_count, bool rational, wcut_curve **curve);
wcut_status wcut_surface_new(int degree_u, int degree_v, int count_u, int count_v, bool rational,
                             wcut_surface **surface);

#endif
