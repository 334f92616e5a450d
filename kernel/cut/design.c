/* Design mode: the wire's ends run on two edge curves, its length is their distance and an extra. */
#include <stddef.h>

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

static wcut_status edge_point_at(const wcut_curve *edge, double share, wcut_vec3 *point) {
    double first, last;
    wcut_curve_domain(edge, &first, &last);
    return wcut_curve_eval(edge, first + share * (last - first), 0, point);
}

/* ---- edges and the block ---- */

const char *wcut_unit_hint(double length, double against) {
    static const struct {
        double factor;
        const char *words;
    } known[] = {{1000, "; they differ by 1000: metres and millimetres? every length of a job is in mm"},
                 {25.4, "; they differ by 25.4: inches and millimetres? every length of a job is in mm"},
                 {10, "; they differ by 10: centimetres and millimetres? every length of a job is in mm"}};
    if (!is_positive(length) || !is_positive(against)) return "";
    const double ratio = fmax(length / against, against / length);
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        if (fabs(log(ratio / known[i].factor)) < 0.3) return known[i].words;
    return "";
}

/* the diagonal of the box about both edges [mm] */
static double extent(int count, const wcut_vec3 *a, const wcut_vec3 *b) {
    wcut_vec3 low = a[0], high = a[0];
    for (int j = 0; j < 2 * count; j++) {
        const wcut_vec3 p = j < count ? a[j] : b[j - count];
        low = vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    return vec3_distance(low, high);
}

/* How far a point of an edge is from where one may be: on the block or in it, or up to `overrun` before its entry and
   behind its exit between the planes of its sides, where the wire is out of the foam. */
static double distance_of_edge(const wcut_block *block, double overrun, wcut_vec3 p) {
    const bool beyond = p.y < 0 || p.y > block->size.y;
    const bool between = p.x >= -WCUT_EDGE_TOLERANCE && p.x <= block->size.x + WCUT_EDGE_TOLERANCE;
    return beyond && between && p.y >= -overrun && p.y <= block->size.y + overrun ? 0 : wcut_block_distance(block, p);
}

wcut_status wcut_design_check_edges(const wcut_job *job, const wcut_vec3 *a, const wcut_vec3 *b, wcut_error *error) {
    const wcut_block block = {.size = job->block_size, .depth = job->wire_diameter};
    const char *hint = wcut_unit_hint(extent(job->stations, a, b), vec3_length(block.size));

    /* the station furthest out of the block */
    double worst = 0;
    int at = -1, edge = 0;
    for (int j = 0; j < job->stations; j++)
        for (int k = 0; k < 2; k++) {
            const double off = distance_of_edge(&block, job->overrun, k ? b[j] : a[j]);
            if (off > worst) worst = off, at = j, edge = k;
        }
    if (worst > WCUT_EDGE_TOLERANCE) {
        const wcut_vec3 p = edge ? b[at] : a[at];
        return wcut_fail(error, WCUT_DEGENERATE,
                         "design.edge_%c: station %d of 0 to %d, (%.6g, %.6g, %.6g) mm, lies %.3g mm outside the block "
                         "of %g x %g x %g mm; expected edges on the block or in it, within %g mm, or up to overrun_mm "
                         "(%g) before it "
                         "and behind it%s",
                         edge ? 'b' : 'a', at, job->stations - 1, p.x, p.y, p.z, worst, block.size.x, block.size.y,
                         block.size.z, WCUT_EDGE_TOLERANCE, job->overrun, hint);
    }

    /* edges on the block, but with a size that suggests another unit */
    if (!*hint) return WCUT_OK;
    return wcut_fail(
        error, WCUT_DEGENERATE,
        "design: the edges span %.3g mm in a block of %g x %g x %g mm; expected edges on the block's sides, "
        "and design.extra_length_mm in the same unit%s",
        extent(job->stations, a, b), block.size.x, block.size.y, block.size.z, hint);
}

wcut_status wcut_design_ends(const wcut_job *job, wcut_vec3 *end_a, wcut_vec3 *end_b, double *length,
                             wcut_error *error) {
    for (int j = 0; j < job->stations; j++) {
        const double u = (double)j / (job->stations - 1);
        const wcut_status a = edge_point_at(job->edge_a, u, &end_a[j]), b = edge_point_at(job->edge_b, u, &end_b[j]);
        if (a != WCUT_OK || b != WCUT_OK)
            return wcut_fail(error, a != WCUT_OK ? a : b, "design.%s: not a valid curve",
                             a != WCUT_OK ? "edge_a" : "edge_b");
        length[j] = vec3_distance(end_a[j], end_b[j]) + extra_at(job, u);
    }
    return WCUT_OK;
}
