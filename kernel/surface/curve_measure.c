/* A curve's Frenet frame, curvature and torsion (do Carmo 1976), and its arc length by adaptive Gauss quadrature. */
#include <wirecut/curve_measure.h>

#include "base/numbers.h"
#include "base/vec3.h"

/* sine of the angle between C' and C'' below which the curve is straight in double arithmetic */
static const double STRAIGHT = 1e-12;

/* of the length: what two estimates may differ by */
static const double EXACT = 1e-13;

enum { HALVINGS_MAX = 30, STEPS_MAX = 100 };

wcut_status wcut_curve_frame(const wcut_curve *curve, double u, wcut_frame *frame) {
    if (!frame) return WCUT_BAD_ARGUMENT;
    wcut_vec3 d[4];
    const wcut_status status = wcut_curve_eval(curve, u, 3, d);
    if (status != WCUT_OK) return status;
    const double speed = vec3_length(d[1]);
    if (!(speed > 0)) return WCUT_DEGENERATE;
    wcut_frame f = {.point = d[0], .tangent = vec3_unit(d[1])};
    const wcut_vec3 across = vec3_cross(d[1], d[2]);
    const double area = vec3_length(across);
    if (area > STRAIGHT * speed * vec3_length(d[2])) {
        f.binormal = vec3_unit(across);
        f.normal = vec3_cross(f.binormal, f.tangent);
        f.curvature = area / (speed * speed * speed);
        f.torsion = vec3_dot(across, d[3]) / (area * area);
    }
    *frame = f;
    return WCUT_OK;
}

static double speed_at(const wcut_curve *curve, double u) {
    wcut_vec3 d[2];
    wcut_curve_eval(curve, u, 1, d);
    return vec3_length(d[1]);
}

/* Gauss's rule with five points, exact for polynomials of degree nine */
static double gauss(const wcut_curve *curve, double a, double b) {
    static const double at[2] = {0.53846931010568309104, 0.90617984593866399280};
    static const double weight[3] = {0.56888888888888888889, 0.47862867049936646804, 0.23692688505618908751};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    double sum = weight[0] * speed_at(curve, middle);
    for (int k = 0; k < 2; k++)
        sum += weight[k + 1] * (speed_at(curve, middle - half * at[k]) + speed_at(curve, middle + half * at[k]));
    return half * sum;
}

/* halve until a half more says the same */
static double curve_measure_refine(const wcut_curve *curve, double a, double b, double whole, double tolerance,
                                   int halvings) {
    const double middle = (a + b) / 2, low = gauss(curve, a, middle), high = gauss(curve, middle, b);
    if (!(fabs(low + high - whole) > tolerance) || halvings == HALVINGS_MAX)
        return low + high; /* overflow ends it, too */
    return curve_measure_refine(curve, a, middle, low, tolerance / 2, halvings + 1) +
           curve_measure_refine(curve, middle, b, high, tolerance / 2, halvings + 1);
}

/* from a to b >= a, span by span: the speed is smooth inside each */
static double length_between(const wcut_curve *curve, double a, double b) {
    double sum = 0, rough = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int s = curve->degree; s < curve->control_count; s++) {
            const double from = fmax(a, curve->knots[s]), to = fmin(b, curve->knots[s + 1]);
            if (!(from < to)) continue;
            const double whole = gauss(curve, from, to);
            if (pass == 0) rough += whole;
            if (pass == 1) sum += curve_measure_refine(curve, from, to, whole, EXACT * rough, 0);
        }
    return sum;
}

wcut_status wcut_curve_length(const wcut_curve *curve, double from, double to, double *length) {
    if (!curve || !length || !isfinite(from) || !isfinite(to)) return WCUT_BAD_ARGUMENT;
    double first, last;
    wcut_curve_domain(curve, &first, &last);
    const double a = clamp(from, first, last), b = clamp(to, first, last);
    const double result = a <= b ? length_between(curve, a, b) : -length_between(curve, b, a);
    if (!isfinite(result)) return WCUT_DEGENERATE;
    *length = result;
    return WCUT_OK;
}

wcut_status wcut_curve_locate_length(const wcut_curve *curve, double length, double *u) {
    if (!curve || !u || !isfinite(length)) return WCUT_BAD_ARGUMENT;

    double first, last;
    wcut_curve_domain(curve, &first, &last);
    const double whole = length_between(curve, first, last);
    if (!(whole > 0) || !isfinite(whole)) return WCUT_DEGENERATE;
    /* the length up to `low` is `passed`; the answer lies in [low, high] */
    double low = first, high = last, passed = 0, at = first + (last - first) * clamp(length / whole, 0, 1);
    if (length <= 0 || length >= whole) {
        *u = length <= 0 ? first : last;
        return WCUT_OK;
    }

    /* Newton's method inside the bracket, bisection where it leaves it */
    for (int step = 0; step < STEPS_MAX; step++) {
        const double to_here = passed + length_between(curve, low, at), off = to_here - length;
        if (fabs(off) <= 10 * EXACT * whole) break;
        if (off > 0) {
            high = at;
        } else {
            low = at, passed = to_here;
        }
        const double speed = speed_at(curve, at), newton = speed > 0 ? at - off / speed : high;
        at = newton > low && newton < high ? newton : (low + high) / 2;
        if (at <= low || at >= high) break; /* neighbouring doubles */
    }
    *u = at;

    return WCUT_OK;
}
