/* Principal curvatures from the two fundamental forms (do Carmo 1976, Differential Geometry of Curves and Surfaces). */
#include <wirecut/curvature.h>

#include "base/numbers.h"
#include "base/vec3.h"

/* area of S_u, S_v over |S_u|^2 + |S_v|^2 below which rounding has made them span a plane, or one of them be there */
#define FLAT 1e-10

wcut_status wcut_surface_curvature(const wcut_surface *surface, double u, double v, double *larger, double *smaller) {
    if (!larger) return WCUT_BAD_ARGUMENT;
    wcut_vec3 d[9];
    const wcut_status status = wcut_surface_eval(surface, u, v, 2, d);
    if (status) return status;

    const wcut_vec3 su = d[3], sv = d[1], across = vec3_cross(su, sv), n = vec3_unit(across);
    const double e = vec3_dot(su, su), f = vec3_dot(su, sv), g = vec3_dot(sv, sv), area2 = vec3_dot(across, across);
    if (!(sqrt(area2) > FLAT * (e + g))) return WCUT_DEGENERATE;

    const double l = vec3_dot(d[6], n), m = vec3_dot(d[4], n), k = vec3_dot(d[2], n);
    const double mean = (e * k - 2 * f * m + g * l) / (2 * area2), gauss = (l * k - m * m) / area2;
    /* the root is real; where both curvatures are the same rounding may say otherwise */
    const double size = fabs(mean) + sqrt(fmax(mean * mean - gauss, 0)), large = mean < 0 ? -size : size;
    *larger = large;
    if (smaller) *smaller = 2 * mean - large;
    return WCUT_OK;
}
