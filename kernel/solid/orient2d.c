/* The orientation of three points: a rounded determinant where its error bound allows, else the exact sum. */
#include "solid/orient2d.h"

#include <float.h>
#include <math.h>

/* |error| <= (3 + 16 e) e (|left| + |right|), e = half a unit in the last place (Shewchuk 1997, 4.3) */
static const double FILTER = (3 + 8 * DBL_EPSILON) * (DBL_EPSILON / 2);

/* add x to a sum held as parts that do not overlap, smallest first; gives their number */
static int grow(int parts, double *part, double x) {
    for (int k = 0; k < parts; k++) {
        const double sum = x + part[k], other = sum - x;
        part[k] = (x - (sum - other)) + (part[k] - other);
        x = sum;
    }
    part[parts] = x;
    return parts + 1;
}

/* the sign of a.p b.q - a.q b.p + b.p c.q - b.q c.p + c.p a.q - c.q a.p, every product in two exact parts */
static double turn_exactly(wcut_point2d a, wcut_point2d b, wcut_point2d c) {
    const double left[6] = {a.p, -a.q, b.p, -b.q, c.p, -c.q}, right[6] = {b.q, b.p, c.q, c.p, a.q, a.p};
    double part[12];
    int parts = 0;
    for (int k = 0; k < 6; k++) {
        const double product = left[k] * right[k];
        parts = grow(parts, part, fma(left[k], right[k], -product));
        parts = grow(parts, part, product);
    }
    for (int k = parts - 1; k >= 0; k--)
        if (part[k] != 0) return part[k];
    return 0;
}

double wcut_orient2d(wcut_point2d a, wcut_point2d b, wcut_point2d c) {
    const double left = (a.p - c.p) * (b.q - c.q), right = (a.q - c.q) * (b.p - c.p), det = left - right;
    return fabs(det) > FILTER * (fabs(left) + fabs(right)) ? det : turn_exactly(a, b, c);
}
