/* Design mode: the wire's ends run on two edge curves, its length is their distance and an extra. */
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"

/* slope at point i of a monotone cubic (Fritsch, Butland 1984: a harmonic mean where both neighbours rise or fall) */
static double monotone_slope(int count, const double *u, const double *y, int i) {
    if (count < 2) return 0;
    if (i == 0) return (y[1] - y[0]) / (u[1] - u[0]);
    if (i == count - 1) return (y[i] - y[i - 1]) / (u[i] - u[i - 1]);
    const double hb = u[i] - u[i - 1], ha = u[i + 1] - u[i];
    const double b = (y[i] - y[i - 1]) / hb, a = (y[i + 1] - y[i]) / ha;
    if (!(a * b > 0)) return 0;
    const double wb = 2 * ha + hb, wa = ha + 2 * hb;
    return (wb + wa) / (wb / b + wa / a);
}

/* an end slope may be three times the secant at most, or the cubic leaves the data's range */
static double limited(double slope, double secant) {
    if (!(slope * secant > 0)) return 0;
    return fabs(slope) > 3 * fabs(secant) ? 3 * secant : slope;
}

/* extra length at u: a monotone cubic through the job's points, constant beyond them */
static double extra_at(const wcut_job *job, double u) {
    const int count = job->extra_count;
    const double *x = job->extra_u, *y = job->extra_length;
    if (u <= x[0]) return y[0];
    if (u >= x[count - 1]) return y[count - 1];
    int i = 0;
    while (u > x[i + 1]) i++;
    const double h = x[i + 1] - x[i], t = (u - x[i]) / h, secant = (y[i + 1] - y[i]) / h;
    const double m0 = h * limited(monotone_slope(count, x, y, i), secant);
    const double m1 = h * limited(monotone_slope(count, x, y, i + 1), secant);
    return (1 + 2 * t) * (1 - t) * (1 - t) * y[i] + t * (1 - t) * (1 - t) * m0 + t * t * (3 - 2 * t) * y[i + 1] -
           t * t * (1 - t) * m1;
}

static wcut_status point_at(const wcut_curve *edge, double share, wcut_vec3 *point) {
    double first, last;
    wcut_curve_domain(edge, &first, &last);
    return wcut_curve_eval(edge, first + share * (last - first), 0, point);
}

wcut_status wcut_design_ends(const wcut_job *job, wcut_vec3 *end_a, wcut_vec3 *end_b, double *length,
                             wcut_error *error) {
    for (int j = 0; j < job->stations; j++) {
        const double u = (double)j / (job->stations - 1);
        const wcut_status a = point_at(job->edge_a, u, &end_a[j]), b = point_at(job->edge_b, u, &end_b[j]);
        if (a != WCUT_OK || b != WCUT_OK)
            return wcut_fail(error, a != WCUT_OK ? a : b, "design.%s: not a valid curve",
                             a != WCUT_OK ? "edge_a" : "edge_b");
        length[j] = vec3_distance(end_a[j], end_b[j]) + extra_at(job, u);
    }
    return WCUT_OK;
}
