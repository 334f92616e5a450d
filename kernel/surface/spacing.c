/* Where the lines of a structured grid lie: a density of lines along each direction, from curvature, then refined.

   With rho > 0 any number, 2 h_u h_v |S_uv| <= h_u^2 rho |S_uv| + h_v^2 |S_uv| / rho, so the error bound of a cell
   falls into a part of u and a part of v, and each may spend half the tolerance. rho = sqrt(|S_uu| / |S_vv|) makes it
   tight. */
#include "surface/spacing.h"

#include <stddef.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

/* bounds on second derivatives: of each control point of the derivative nets, squared, the largest across the other
   direction */
typedef struct nets {
    double *pure_u, *mixed_u; /* count_u */
    double *pure_v, *mixed_v; /* count_v */
    double *step_u, *step_v;  /* 1 / knot differences: first derivative's, then second's, count each */
    double speed_u, speed_v;  /* sums of squares of the first derivatives' control points */
} nets;

void wcut_spacing_clear(wcut_spacing *spacing) {
    wcut_free(spacing->at);
    wcut_free(spacing->density);
    wcut_free(spacing->crease);
    *spacing = (wcut_spacing){.pieces = 0};
}

static wcut_status spacing_new(int pieces, wcut_spacing *spacing) {
    wcut_spacing s = {.pieces = pieces};
    s.at = wcut_alloc((size_t)pieces + 1, sizeof *s.at);
    s.density = wcut_alloc((size_t)pieces, sizeof *s.density);
    s.crease = wcut_alloc((size_t)pieces + 1, sizeof *s.crease);
    if (!s.at || !s.density || !s.crease) {
        wcut_spacing_clear(&s);
        return WCUT_NO_MEMORY;
    }
    *spacing = s;
    return WCUT_OK;
}

/* degree / knot difference of the first and of the second derivative's control points; 0 where there is no support */
static void derivative_steps(int degree, int count, const double *knots, double *step) {
    for (int i = 0; i + 1 < count; i++) {
        const double wide = knots[i + degree + 1] - knots[i + 1];
        step[i] = wide > 0 ? degree / wide : 0;
    }
    for (int i = 0; i + 2 < count; i++) {
        const double wide = knots[i + degree + 1] - knots[i + 2];
        step[count + i] = wide > 0 ? (degree - 1) / wide : 0;
    }
}

/* |second difference of the control points a, b, c|^2 with the steps of index i */
static double pure_second(int count, const double *step, int i, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    const wcut_vec3 near = vec3_scale(step[i], vec3_sub(b, a)), far = vec3_scale(step[i + 1], vec3_sub(c, b));
    const wcut_vec3 d = vec3_scale(step[count + i], vec3_sub(far, near));
    return vec3_dot(d, d);
}

static void spacing_raise(double *to, double value) {
    if (isnan(value) || value > *to) *to = value; /* a NaN from overflow stays, and lines without number follow */
}

static void bound_derivatives(const wcut_surface *s, nets *n) {
    /* largest factors of first derivatives from control points */
    const int m = s->count_u;
    derivative_steps(s->degree_u, s->count_u, s->knots_u, n->step_u);
    derivative_steps(s->degree_v, s->count_v, s->knots_v, n->step_v);

    /* second differences along u, along v and mixed, each with the largest of its line */
    for (int j = 0; j < s->count_v; j++) {
        const wcut_vec3 *row = s->control + (ptrdiff_t)j * m;
        for (int i = 0; i + 2 < m; i++)
            spacing_raise(&n->pure_u[i], pure_second(m, n->step_u, i, row[i], row[i + 1], row[i + 2]));
        for (int i = 0; j + 2 < s->count_v && i < m; i++)
            spacing_raise(&n->pure_v[j], pure_second(s->count_v, n->step_v, j, row[i], row[i + m], row[i + 2 * m]));
        for (int i = 0; j + 1 < s->count_v && i + 1 < m; i++) {
            const wcut_vec3 twist = vec3_sub(vec3_sub(row[i + m + 1], row[i + m]), vec3_sub(row[i + 1], row[i]));
            const double scale = n->step_u[i] * n->step_v[j], value = scale * scale * vec3_dot(twist, twist);

            /* mean squares of the speeds, for the balance of the two directions */
            const wcut_vec3 du = vec3_scale(n->step_u[i], vec3_sub(row[i + 1], row[i]));
            const wcut_vec3 dv = vec3_scale(n->step_v[j], vec3_sub(row[i + m], row[i]));
            spacing_raise(&n->mixed_u[i], value);
            spacing_raise(&n->mixed_v[j], value);
            n->speed_u += vec3_dot(du, du);
            n->speed_v += vec3_dot(dv, dv);
        }
    }
}

static double largest(int count, const double *value) {
    double max = 0;
    for (int i = 0; i < count; i++) spacing_raise(&max, value[i]);
    return max;
}

/* the h^2 terms of one direction, in place of the densities: every non-empty knot span a piece */
static wcut_status estimate_axis(int degree, int count, const double *knots, const double *pure, const double *mixed,
                                 double ratio, wcut_spacing *spacing) {
    /* a piece for each span that is not empty */
    int pieces = 0;
    for (int s = degree; s < count; s++) pieces += knots[s] < knots[s + 1];
    wcut_spacing result;
    const wcut_status status = spacing_new(pieces, &result);
    if (status != WCUT_OK) return status;
    int piece = 0;

    /* density from second derivatives and the twist of the span */
    for (int s = degree; s < count; s++) {
        if (!(knots[s] < knots[s + 1])) continue;
        const double second = sqrt(largest(degree - 1, pure + s - degree));
        const double twist = sqrt(largest(degree, mixed + s - degree));
        result.at[piece] = knots[s];
        result.crease[piece] = piece == 0 || knots[s - degree + 1] == knots[s];
        result.density[piece++] = second + twist * ratio;
    }

    result.at[pieces] = knots[count];
    result.crease[pieces] = true;
    *spacing = result;

    return WCUT_OK;
}

/* the error that one cell over the whole domain would add */
static double whole_error(const wcut_spacing *s) {
    const double wide = s->at[s->pieces] - s->at[0];
    return largest(s->pieces, s->density) * wide * wide / 8;
}

static void densities_from_terms(wcut_spacing *s, double tolerance) {
    for (int p = 0; p < s->pieces; p++) s->density[p] = sqrt(s->density[p] / (8 * tolerance));
}

/* rho, with each direction at least so curved that one cell fills its domain: a plane has one, too */
static double balance(const wcut_surface *s, const nets *n, double tolerance) {
    const double wide_u = s->knots_u[s->count_u] - s->knots_u[s->degree_u];
    const double wide_v = s->knots_v[s->count_v] - s->knots_v[s->degree_v];
    const double twist = sqrt(largest(s->count_u, n->mixed_u));
    const bool moves = n->speed_u > 0 && n->speed_v > 0;
    const double square = moves ? sqrt(n->speed_u / n->speed_v) : wide_v / wide_u;
    const double term_u = sqrt(largest(s->count_u, n->pure_u)) + twist * square + 4 * tolerance / (wide_u * wide_u);
    const double term_v = sqrt(largest(s->count_v, n->pure_v)) + twist / square + 4 * tolerance / (wide_v * wide_v);
    return sqrt(term_u / term_v);
}

wcut_status wcut_spacing_estimate(const wcut_surface *s, double chord_tolerance, wcut_spacing *along_u,
                                  wcut_spacing *along_v) {
    /* bounds by column and row of the net */
    double *work = wcut_alloc((size_t)s->count_u + s->count_v, 4 * sizeof *work);
    if (!work) return WCUT_NO_MEMORY;
    double *second = work + 4 * (ptrdiff_t)s->count_u;
    nets n = {.pure_u = work, .mixed_u = work + s->count_u, .step_u = work + 2 * (ptrdiff_t)s->count_u};
    n.pure_v = second, n.mixed_v = second + s->count_v, n.step_v = second + 2 * (ptrdiff_t)s->count_v;
    bound_derivatives(s, &n);
    const double rho = balance(s, &n, chord_tolerance);

    /* terms of both directions, with the twist shared by `rho` */
    wcut_spacing u = {.pieces = 0}, v = {.pieces = 0};
    wcut_status status = estimate_axis(s->degree_u, s->count_u, s->knots_u, n.pure_u, n.mixed_u, rho, &u);
    if (status == WCUT_OK)
        status = estimate_axis(s->degree_v, s->count_v, s->knots_v, n.pure_v, n.mixed_v, 1 / rho, &v);
    if (status == WCUT_OK) {
        /* a direction that needs no more than one cell leaves the rest of the tolerance to the other */
        const double min_u = whole_error(&u), min_v = whole_error(&v), half = chord_tolerance / 2;
        densities_from_terms(&u, min_v < half ? chord_tolerance - min_v : half);
        densities_from_terms(&v, min_u < half ? chord_tolerance - min_u : half);
        *along_u = u, *along_v = v;
    } else {
        wcut_spacing_clear(&u);
        wcut_spacing_clear(&v);
    }

    wcut_free(work);
    return status;
}

/* lines that the pieces from..to-1, between two creases, ask for: the integral of the density */
static double lines_between(const wcut_spacing *s, int from, int to) {
    double sum = 0;
    for (int p = from; p < to; p++) sum += s->density[p] * (s->at[p + 1] - s->at[p]);
    return sum;
}

static int next_crease(const wcut_spacing *s, int from) {
    int to = from + 1;
    while (!s->crease[to]) to++;
    return to;
}

/* cells between two creases: a whole number, at least one; rounding must not add another */
static double cells_for(double lines) { return lines <= 1 ? 1 : ceil(lines * (1 - 1e-12)); }

wcut_status wcut_spacing_lines(const wcut_spacing *s, int max, wcut_spacing *lines) {
    /* cells between creases, in whole numbers */
    double total = 0;
    for (int from = 0, to; from < s->pieces; from = to) {
        to = next_crease(s, from);
        total += cells_for(lines_between(s, from, to));
    }
    if (!(total < max)) return WCUT_NOT_CONVERGED;

    wcut_spacing result;
    const wcut_status status = spacing_new((int)total, &result);
    if (status != WCUT_OK) return status;
    int made = 0;

    /* lines at equal sums of the density between two creases */
    for (int from = 0, to; from < s->pieces; from = to) {
        to = next_crease(s, from);
        const double sum = lines_between(s, from, to), cells = cells_for(sum);
        const double even = cells / (s->at[to] - s->at[from]); /* where nothing is curved */
        double passed = 0;
        int piece = from;
        result.crease[made] = true;
        result.at[made++] = s->at[from];
        for (int k = 1; k < cells; k++) { /* the line that `k` cells lie before */
            const double goal = sum > 0 ? sum * k / cells : k / even;
            for (;; piece++) {
                const double wide = s->at[piece + 1] - s->at[piece], here = wide * (sum > 0 ? s->density[piece] : 1);
                if (passed + here >= goal || piece == to - 1) {
                    const double share = here > 0 ? clamp((goal - passed) / here, 0, 1) : 0;
                    result.at[made++] = s->at[piece] + share * wide;
                    break;
                }
                passed += here;
            }
        }
    }

    result.at[made] = s->at[s->pieces];
    result.crease[made] = true;
    for (int p = 0; p < result.pieces; p++) result.density[p] = 1 / (result.at[p + 1] - result.at[p]);
    *lines = result;

    return WCUT_OK;
}
