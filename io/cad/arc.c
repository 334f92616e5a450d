/* Arcs of circles and ellipses as rational curves of degree 2, a quarter turn a piece (Piegl, Tiller 1997, 7.3). */
#include "io/cad/arc.h"

#include <math.h>
#include <stddef.h>

static const double quarter = 1.5707963267948966;

/* center + scale (cos(t) x + sin(t) y) */
static wcut_vec3 at(wcut_vec3 center, wcut_vec3 x, wcut_vec3 y, double t, double scale) {
    const double c = scale * cos(t), s = scale * sin(t);
    return (wcut_vec3){center.x + c * x.x + s * y.x, center.y + c * x.y + s * y.y, center.z + c * x.z + s * y.z};
}

int wcut_arc(wcut_vec3 center, wcut_vec3 x, wcut_vec3 y, double from, double to, wcut_vec3 pole[WCUT_ARC_POLES],
             double weight[WCUT_ARC_POLES], double knot[WCUT_ARC_POLES + 3]) {
    /* as many pieces as begin in the angle, at most a whole turn */
    size_t pieces = (size_t)ceil(fabs(to - from) / quarter - 1e-9);
    size_t knots = 0;
    if (pieces < 1) pieces = 1;
    if (pieces > 4) pieces = 4;

    /* control points: the ends of the pieces, and between them where their tangents meet */
    const double step = (to - from) / (double)pieces, half = cos(step / 2);
    knot[knots++] = 0;
    for (size_t k = 0; k < pieces; k++) {
        const double t = from + (double)k * step;
        pole[2 * k] = at(center, x, y, t, 1);
        pole[2 * k + 1] = at(center, x, y, t + step / 2, 1 / half); /* where the tangents meet */
        weight[2 * k] = 1;
        weight[2 * k + 1] = half;
        knot[knots++] = (double)k;
        knot[knots++] = (double)k;
    }

    /* the end, and knots with full multiplicity there */
    pole[2 * pieces] = at(center, x, y, to, 1);
    weight[2 * pieces] = 1;
    for (int k = 0; k < 3; k++) knot[knots++] = (double)pieces;

    return 2 * (int)pieces + 1;
}
