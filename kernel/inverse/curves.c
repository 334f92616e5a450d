/* Lag, sag and rises of a design as splines over the feed, and the wire's ends from them. */
#include "inverse/curves.h"

#include <string.h>

#include "base/numbers.h"
#include "base/vec3.h"

#define BEYOND 0.7       /* [1] of the span: so far before and behind the block may the middle of the ends be */
#define EDGES_BEYOND 0.9 /* [1] of the span: and the edges themselves */
#define OBLIQUE 0.1      /* [1] least part of a distance, squared, that is along x */
#define FLAT_SAG 0.15    /* [1] of the span */
#define LEAD 0.25        /* [1] of the span: feed before the wire comes into the block, for its start to fade */

int wcut_design_unknowns(const wcut_design_curves *c) { return WCUT_DESIGN_CURVES * c->coefficients; }

/* ---- splines ---- */

/* a knot of the clamped uniform vector, spans = coefficients - 3 */
static double clamped_knot(int k, int spans) { return clamp(k - 3, 0, spans); }

int wcut_design_basis(int coefficients, double t, double weight[4], double slope[4]) {
    const int spans = coefficients - 3;
    const double u = clamp(t, 0, 1) * spans;
    const int span = (int)clamp(floor(u), 0, spans - 1), k = span + 3;

    /* Cox, de Boor 1972, up to degree 3; the slope from degree 2 */
    double b[4] = {1, 0, 0, 0}, lower[4] = {0};
    for (int p = 1; p <= 3; p++) {
        double saved = 0;
        if (p == 3) memcpy(lower, b, sizeof b);
        for (int r = 0; r < p; r++) {
            const double right = clamped_knot(k + r + 1, spans), left = clamped_knot(k + 1 - p + r, spans);
            const double term = b[r] / (right - left);
            b[r] = saved + (right - u) * term;
            saved = (u - left) * term;
        }
        b[p] = saved;
    }
    for (int r = 0; r < 4; r++) {
        weight[r] = b[r];
        const int i = span + r;
        double d = 0;
        if (r > 0) d += 3 * lower[r - 1] / (clamped_knot(i + 3, spans) - clamped_knot(i, spans));
        if (r < 3) d -= 3 * lower[r] / (clamped_knot(i + 4, spans) - clamped_knot(i + 1, spans));
        slope[r] = d * spans;
    }
    return span;
}

double wcut_design_curve_at(const wcut_design_curves *c, wcut_design_curve which, double t, double *slope) {
    double w[4], d[4], value = 0, by_t = 0;
    const int at = wcut_design_basis(c->coefficients, t, w, d);
    for (int r = 0; r < 4; r++) {
        value += w[r] * c->value[which][at + r];
        by_t += d[r] * c->value[which][at + r];
    }
    if (slope) *slope = by_t;
    return value;
}

/* the spline nearest to samples at t (least squares with second differences as a tiny penalty): normal equations, dense */
static void fit_samples(int coefficients, int count, const double *t, const double *y, double *value) {
    double a[WCUT_KNOTS_MAX][WCUT_KNOTS_MAX] = {{0}}, b[WCUT_KNOTS_MAX] = {0};
    const int n = coefficients;
    for (int k = 0; k < count; k++) {
        double w[4], d[4];
        const int at = wcut_design_basis(n, t[k], w, d);
        for (int p = 0; p < 4; p++) {
            b[at + p] += w[p] * y[k];
            for (int q = 0; q < 4; q++) a[at + p][at + q] += w[p] * w[q];
        }
    }
    const double stiff = 1e-6 * count / n, second[3] = {1, -2, 1};
    for (int k = 0; k + 2 < n; k++)
        for (int p = 0; p < 3; p++)
            for (int q = 0; q < 3; q++) a[k + p][k + q] += stiff * second[p] * second[q];

    /* Gauss without pivoting: the matrix is positive definite */
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n; i++) {
            const double f = a[i][k] / a[k][k];
            for (int j = k; j < n; j++) a[i][j] -= f * a[k][j];
            b[i] -= f * b[k];
        }
    for (int k = n - 1; k >= 0; k--) {
        double sum = b[k];
        for (int j = k + 1; j < n; j++) sum -= a[k][j] * value[j];
        value[k] = sum / a[k][k];
    }
}

void wcut_design_refine(wcut_design_curves *c, int coefficients) {
    enum { COUNT = 8 * WCUT_KNOTS_MAX };
    double t[COUNT], y[COUNT];
    wcut_design_curves finer = *c;
    finer.coefficients = coefficients;
    for (int f = 0; f < WCUT_DESIGN_CURVES; f++) {
        for (int k = 0; k < COUNT; k++) {
            t[k] = (double)k / (COUNT - 1);
            y[k] = wcut_design_curve_at(c, (wcut_design_curve)f, t[k], NULL);
        }
        memset(finer.value[f], 0, sizeof finer.value[f]);
        fit_samples(coefficients, COUNT, t, y, finer.value[f]);
    }
    *c = finer;
}

/* ---- from a scan ---- */

/* whether a wire is over the block anywhere */
static bool meets_block(const wcut_design_target *t, const wcut_scan_row *row) {
    for (int k = 0; k < WCUT_SCAN_SAMPLES; k++) {
        const double y = wcut_scan_y(row, (double)k / (WCUT_SCAN_SAMPLES - 1));
        if (y >= 0 && y <= t->block.y) return true;
    }
    return false;
}

bool wcut_design_start(const wcut_design_target *target, const wcut_scan *scan, bool free_edges, int coefficients,
                       wcut_design_curves *out) {
    enum { ROWS_MAX = 256 };
    const int rows = scan->rows < ROWS_MAX ? scan->rows : ROWS_MAX;
    int first = 0, last = rows - 1;
    while (first < rows && !meets_block(target, &scan->row[first])) first++;
    while (last >= 0 && !meets_block(target, &scan->row[last])) last--;
    if (first >= last) return false;

    /* a lead before the first wire that is over the block */
    const double spacing = scan->row[1].middle - scan->row[0].middle;
    if (first > 0) first--;
    if (last < rows - 1) last++;
    *out = (wcut_design_curves){.coefficients = coefficients, .free_edges = free_edges};
    out->first = scan->row[first].middle - fmax(0, LEAD * target->block.x - spacing);
    out->last = scan->row[last].middle;
    out->first = fmax(out->first, -BEYOND * target->block.x);
    out->last = fmin(out->last, target->block.y + BEYOND * target->block.x);
    double t[ROWS_MAX + 1], y[ROWS_MAX + 1];
    for (int f = 0; f < WCUT_DESIGN_CURVES; f++) {
        int count = 0;
        for (int k = first - 1; k <= last; k++) {
            const wcut_scan_row *row = &scan->row[k < first ? first : k];
            /* neither edge further beyond the block than edges may be */
            const double beyond = fmax(0, fmax(-row->middle, row->middle - target->block.y));
            const double most = 2 * fmax(0, EDGES_BEYOND * target->block.x - beyond);
            const double value[WCUT_DESIGN_CURVES] = {row->sag, clamp(row->lag, -most, most),
                                                      free_edges ? row->rise_a : 0, free_edges ? row->rise_b : 0};
            t[count] = k < first ? 0 : clamp((row->middle - out->first) / (out->last - out->first), 0, 1);
            y[count++] = value[f];
        }
        fit_samples(coefficients, count, t, y, out->value[f]);
    }
    return true;
}

/* ---- the ends ---- */

void wcut_design_place(const wcut_design_curves *c, const wcut_design_target *target, int stations, wcut_vec3 *end_a,
                       wcut_vec3 *end_b, double *length, wcut_vec3 *by_a, wcut_vec3 *by_b, double *by_length) {
    const int n = c->coefficients, unknowns = wcut_design_unknowns(c);
    const double width = target->block.x;
    if (by_a) {
        const size_t size = (size_t)unknowns * (size_t)stations;
        memset(by_a, 0, size * sizeof *by_a);
        memset(by_b, 0, size * sizeof *by_b);
        memset(by_length, 0, size * sizeof *by_length);
    }
    for (int j = 0; j < stations; j++) {
        const double t = (double)j / (stations - 1), middle = c->first + t * (c->last - c->first);
        const double lag = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_LAG, t, NULL);
        const double sag = wcut_design_curve_at(c, WCUT_DESIGN_CURVE_SAG, t, NULL);
        const wcut_height a = wcut_heights_eval(&target->heights, 0, middle + lag / 2);
        const wcut_height b = wcut_heights_eval(&target->heights, width, middle - lag / 2);
        end_a[j] = vec3(0, middle + lag / 2, a.z + wcut_design_curve_at(c, WCUT_DESIGN_CURVE_RISE_A, t, NULL));
        end_b[j] = vec3(width, middle - lag / 2, b.z + wcut_design_curve_at(c, WCUT_DESIGN_CURVE_RISE_B, t, NULL));
        const wcut_vec3 chord = vec3_sub(end_b[j], end_a[j]), along = vec3_unit(chord);
        length[j] = vec3_length(chord) + 8 * sag * sag / (3 * width);
        if (!by_a) continue;

        /* each of the coefficients that matter here */
        double w[4], d[4];
        const int at = wcut_design_basis(n, t, w, d);
        for (int k = 0; k < unknowns; k++) {
            const int which = k / n, r = k % n - at;
            if (r < 0 || r > 3) continue;
            const size_t to = (size_t)k * (size_t)stations + (size_t)j;
            if (which == WCUT_DESIGN_CURVE_LAG)
                by_a[to] = vec3(0, w[r] / 2, a.y * w[r] / 2), by_b[to] = vec3(0, -w[r] / 2, -b.y * w[r] / 2);
            if (which == WCUT_DESIGN_CURVE_RISE_A) by_a[to] = vec3(0, 0, w[r]);
            if (which == WCUT_DESIGN_CURVE_RISE_B) by_b[to] = vec3(0, 0, w[r]);
            by_length[to] = vec3_dot(along, vec3_sub(by_b[to], by_a[to]));
            if (which == WCUT_DESIGN_CURVE_SAG) by_length[to] += 16 * sag / (3 * width) * w[r];
        }
    }
}

void wcut_design_start_flat(const wcut_design_target *target, int coefficients, wcut_design_curves *out) {
    const double width = target->block.x;
    *out = (wcut_design_curves){.coefficients = coefficients};
    out->first = -LEAD * width, out->last = target->block.y + FLAT_SAG * width;
    for (int k = 0; k < coefficients; k++) out->value[WCUT_DESIGN_CURVE_SAG][k] = FLAT_SAG * width;
}

/* the ends of one station corrected, and along x so far apart that their distance is what it was less `near` */
static void correct_station(const double value[WCUT_DESIGN_CURVES], double near, wcut_vec3 *a, wcut_vec3 *b,
                            wcut_vec3 *chord, double *length) {
    const double distance = vec3_distance(*a, *b) - near, lag = value[WCUT_DESIGN_CURVE_LAG] / 2;
    *a = vec3_add(*a, vec3(0, lag, value[WCUT_DESIGN_CURVE_RISE_A]));
    *b = vec3_add(*b, vec3(0, -lag, value[WCUT_DESIGN_CURVE_RISE_B]));
    const wcut_vec3 d = vec3_sub(*b, *a);
    const double square = distance * distance - d.y * d.y - d.z * d.z;
    const double x = copysign(sqrt(fmax(square, OBLIQUE * distance * distance)), d.x);
    a->x += (d.x - x) / 2, b->x -= (d.x - x) / 2;
    *chord = vec3(x, d.y, d.z);
    *length = distance;
}

void wcut_design_correct(const wcut_design_curves *c, int stations, const wcut_vec3 *base_a, const wcut_vec3 *base_b,
                         wcut_vec3 *end_a, wcut_vec3 *end_b, wcut_vec3 *by_a, wcut_vec3 *by_b, double *by_length) {
    const size_t size = (size_t)wcut_design_unknowns(c) * (size_t)stations;
    if (by_a) {
        memset(by_a, 0, size * sizeof *by_a);
        memset(by_b, 0, size * sizeof *by_b);
        memset(by_length, 0, size * sizeof *by_length);
    }
    for (int j = 0; j < stations; j++) {
        const double t = (double)j / (stations - 1);
        double value[WCUT_DESIGN_CURVES], w[4], d[4], distance;
        wcut_vec3 chord;
        for (int f = 0; f < WCUT_DESIGN_CURVES; f++) value[f] = wcut_design_curve_at(c, (wcut_design_curve)f, t, NULL);
        end_a[j] = base_a[j], end_b[j] = base_b[j];
        correct_station(value, value[WCUT_DESIGN_CURVE_SAG], &end_a[j], &end_b[j], &chord, &distance);
        if (!by_a) continue;

        /* each of the coefficients that matter here: along x what keeps the distance */
        const int at = wcut_design_basis(c->coefficients, t, w, d);
        for (int f = 0; f < WCUT_DESIGN_CURVES; f++)
            for (int r = 0; r < 4; r++) {
                const size_t to = (size_t)(f * c->coefficients + at + r) * (size_t)stations + (size_t)j;
                wcut_vec3 a = {0, 0, 0}, b = {0, 0, 0};
                if (f == WCUT_DESIGN_CURVE_LAG) a.y = w[r] / 2, b.y = -w[r] / 2;
                if (f == WCUT_DESIGN_CURVE_RISE_A) a.z = w[r];
                if (f == WCUT_DESIGN_CURVE_RISE_B) b.z = w[r];
                const double near = f == WCUT_DESIGN_CURVE_SAG ? w[r] : 0;
                const double x = (-distance * near - chord.y * (b.y - a.y) - chord.z * (b.z - a.z)) / chord.x;
                a.x = -x / 2, b.x = x / 2;
                by_a[to] = a, by_b[to] = b;
            }
    }
}
