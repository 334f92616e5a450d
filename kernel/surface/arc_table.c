/* Arc lengths along a curve at many parameters, to find many parameters of given lengths quickly. */
#include "surface/arc_table.h"

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { PARTS = 8, STEPS_MAX = 30 }; /* of a knot span; of Newton's method */

/* of a part's length: what a parameter may be off by */
static const double NEAR = 1e-10;

static double arc_table_speed_at(const wcut_curve *c, double u) {
    wcut_vec3 d[2];
    wcut_curve_eval(c, u, 1, d);
    return vec3_length(d[1]);
}

/* Gauss's rule with five points: on an eighth of a span right to some ten digits */
static double arc(const wcut_curve *c, double a, double b) {
    static const double at[2] = {0.53846931010568309104, 0.90617984593866399280};
    static const double weight[3] = {0.56888888888888888889, 0.47862867049936646804, 0.23692688505618908751};
    const double middle = (a + b) / 2, half = (b - a) / 2;
    double sum = weight[0] * arc_table_speed_at(c, middle);
    for (int k = 0; k < 2; k++)
        sum += weight[k + 1] *
               (arc_table_speed_at(c, middle - half * at[k]) + arc_table_speed_at(c, middle + half * at[k]));
    return half * sum;
}

void wcut_arc_table_clear(wcut_arc_table *table) {
    wcut_free(table->u);
    wcut_free(table->length);
    *table = (wcut_arc_table){.count = 0};
}

wcut_status wcut_arc_table_fill(const wcut_curve *curve, wcut_arc_table *table) {
    /* PARTS pieces in each span that is not empty */
    wcut_arc_table t = {.curve = curve};
    int spans = 0;
    for (int s = curve->degree; s < curve->control_count; s++) spans += curve->knots[s] < curve->knots[s + 1];
    t.u = wcut_alloc((size_t)spans * PARTS + 1, sizeof *t.u);
    t.length = wcut_alloc((size_t)spans * PARTS + 1, sizeof *t.length);
    if (!t.u || !t.length) {
        wcut_arc_table_clear(&t);
        return WCUT_NO_MEMORY;
    }

    /* parameters evenly in each span, and the last knot */
    for (int s = curve->degree; s < curve->control_count; s++) {
        const double a = curve->knots[s], b = curve->knots[s + 1];
        if (!(a < b)) continue;
        for (int k = 0; k < PARTS; k++) t.u[t.count++] = a + (b - a) * k / PARTS;
    }
    t.u[t.count++] = curve->knots[curve->control_count];

    /* lengths by quadrature, added up */
    for (int k = 1; k < t.count; k++) t.length[k] = t.length[k - 1] + arc(curve, t.u[k - 1], t.u[k]);
    if (!isfinite(t.length[t.count - 1])) {
        wcut_arc_table_clear(&t);
        return WCUT_DEGENERATE;
    }
    *table = t;

    return WCUT_OK;
}

/* the parameter of a length between those of table entries k and k + 1: Newton's method, bisection where it fails */
static double arc_table_locate(const wcut_arc_table *t, int k, double length) {
    double low = t->u[k], high = t->u[k + 1];
    const double part = t->length[k + 1] - t->length[k], wide = high - low;
    if (!(part > 0)) return low;
    double u = low + wide * (length - t->length[k]) / part;
    for (int step = 0; step < STEPS_MAX; step++) {
        const double off = t->length[k] + arc(t->curve, t->u[k], u) - length;
        if (fabs(off) <= NEAR * part) break;
        if (off > 0) {
            high = u;
        } else {
            low = u;
        }
        const double speed = arc_table_speed_at(t->curve, u), next = speed > 0 ? u - off / speed : low;
        u = next > low && next < high ? next : (low + high) / 2;
    }
    return u;
}

void wcut_arc_table_points(const wcut_arc_table *t, int count, wcut_vec3 *point) {
    const double whole = t->length[t->count - 1];
    for (int i = 0, k = 0; i < count; i++) {
        const double length = whole * i / (count - 1);
        while (k + 2 < t->count && t->length[k + 1] < length) k++;
        const double u = i == 0 || !(whole > 0) ? t->u[0]
                         : i == count - 1       ? t->u[t->count - 1]
                                                : arc_table_locate(t, k, length);
        wcut_curve_eval(t->curve, u, 0, &point[i]);
    }
}
