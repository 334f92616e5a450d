/* A bicubic surface span by span: Taylor's polynomials about the middles, and bounds by the sizes of their terms. */
#include "surface/newton_spans.h"

#include <stddef.h>

#include "base/alloc.h"
#include "base/vec3.h"
#include "surface/basis.h"

enum { CUBIC = WCUT_CUBIC, ORDER = WCUT_SPAN_ORDER, SPANS_MAX = 200000 };

/* [of the size] feet are this exact */
static const double EXACT = 1e-13;

/* ---- knots ---- */

/* the distinct knots of a direction; NULL without memory. *count spans; 0 where a derivative jumps */
static double *list_knots(int count, const double *knots, int *spans) {
    double *list = wcut_alloc((size_t)count + 1, sizeof *list);
    *spans = 0;
    if (!list) return NULL;
    list[0] = knots[CUBIC];
    for (int k = CUBIC + 1, times = 1; k <= count; k++) {
        times = knots[k] == knots[k - 1] ? times + 1 : 1;
        if (knots[k] > list[*spans]) list[++*spans] = knots[k];
        if (times >= CUBIC && knots[k] < knots[count] && knots[k] > knots[CUBIC]) {
            *spans = 0;
            break;
        }
    }
    return list;
}

/* the four basis functions over one span, by powers of its own parameter about the middle */
typedef struct powers {
    int first;               /* control point of the first function */
    double of[ORDER][ORDER]; /* [power][function] */
} powers;

static powers *list_powers(int count, const double *knots, int spans, const double *knot) {
    static const double factorial[ORDER] = {1, 1, 2, 6};
    powers *list = wcut_alloc((size_t)spans, sizeof *list);
    for (int k = 0; list && k < spans; k++) {
        wcut_basis basis;
        wcut_basis_eval(CUBIC, count, knots, knot[k] + (knot[k + 1] - knot[k]) / 2, CUBIC, &basis);
        list[k].first = basis.span - CUBIC;
        double wide = 1;
        for (int i = 0; i < ORDER; i++, wide *= knot[k + 1] - knot[k])
            for (int r = 0; r < ORDER; r++) list[k].of[i][r] = basis.value[i][r] * wide / factorial[i];
    }
    return list;
}

/* ---- one span ---- */

static inline wcut_vec3 mix4(const double w[ORDER], wcut_vec3 a, wcut_vec3 b, wcut_vec3 c, wcut_vec3 d) {
    return vec3_add_scaled(vec3_add_scaled(vec3_add_scaled(vec3_scale(w[0], a), w[1], b), w[2], c), w[3], d);
}

static void find_powers(const wcut_surface *s, const powers *u, const powers *v, wcut_vec3 power[ORDER][ORDER]) {
    wcut_vec3 mixed[ORDER][ORDER]; /* [control row][of s] */
    for (int r = 0; r < ORDER; r++) {
        const wcut_vec3 *p = &s->control[(ptrdiff_t)(v->first + r) * s->count_u + u->first];
        for (int i = 0; i < ORDER; i++) mixed[r][i] = mix4(u->of[i], p[0], p[1], p[2], p[3]);
    }
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++)
            power[j][i] = mix4(v->of[j], mixed[0][i], mixed[1][i], mixed[2][i], mixed[3][i]);
}

/* powers of a span's half */
static const double half[] = {1, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625};

/* No less than |d^(k+l) S / ds^k dt^l - its value in the middle| where `rest`, else than the derivative itself: the
   lengths of its terms at |s| = |t| = 1/2. */
static inline double bound(const double size[ORDER][ORDER], int k, int l, bool rest) {
    static const double factor[ORDER][ORDER] = {{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 2, 6}, {0, 0, 0, 6}};
    double sum = 0;
    for (int j = l; j < ORDER; j++)
        for (int i = k; i < ORDER; i++)
            if (!rest || i > k || j > l) sum += factor[k][i] * factor[l][j] * half[i - k + j - l] * size[j][i];
    return sum;
}

static inline double newton_spans_larger(double a, double b) { return a > b ? a : b; }

/* how far a span reaches from its middle along each axis, at most */
static wcut_vec3 reach_of(wcut_vec3 power[ORDER][ORDER]) {
    wcut_vec3 sum = {0, 0, 0};
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++) {
            const wcut_vec3 p = power[j][i];
            if (i + j > 0) sum = vec3_add_scaled(sum, half[i + j], vec3(fabs(p.x), fabs(p.y), fabs(p.z)));
        }
    return sum;
}

/* wide, high: what a step of the span's own parameters is of the scaled ones */
static void bound_span(wcut_span *of, double wide, double high, wcut_span_bounds *b) {
    double size[ORDER][ORDER];
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++) size[j][i] = vec3_length(of->power[j][i]);
    const wcut_vec3 reach = reach_of(of->power);
    b->low = vec3_sub(of->power[0][0], reach), b->high = vec3_add(of->power[0][0], reach);
    const double off_s = bound(size, 1, 0, true), off_t = bound(size, 0, 1, true);
    of->speed = newton_spans_larger(size[0][1] + off_s, size[1][0] + off_t);
    of->turn = newton_spans_larger(newton_spans_larger(bound(size, 3, 0, false), bound(size, 2, 1, false)),
                                   newton_spans_larger(bound(size, 1, 2, false), bound(size, 0, 3, false)));
    const wcut_vec3 su = vec3_scale(1 / wide, of->power[0][1]), sv = vec3_scale(1 / high, of->power[1][0]);
    const double uu = vec3_dot(su, su), uv = vec3_dot(su, sv), vv = vec3_dot(sv, sv);
    const double min = (uu + vv) / 2 - sqrt((uu - vv) * (uu - vv) / 4 + uv * uv);
    const double off_u = off_s / wide, off_v = off_t / high;
    b->sigma = sqrt(newton_spans_larger(min, 0)) - sqrt(off_u * off_u + off_v * off_v);
    b->bend = newton_spans_larger(bound(size, 2, 0, false) / (wide * wide), bound(size, 0, 2, false) / (high * high)) +
              bound(size, 1, 1, false) / (wide * high);
}

/* the rows of the pseudo-inverse of (S_s, S_t); zero where these span no plane */
static wcut_span_guide guide_of(const wcut_span *of, wcut_vec3 centre) {
    const wcut_vec3 m = vec3_sub(of->power[0][0], centre), s = of->power[0][1], t = of->power[1][0];
    const double ss = vec3_dot(s, s), st = vec3_dot(s, t), tt = vec3_dot(t, t), area = ss * tt - st * st;
    wcut_vec3 a = {0, 0, 0}, b = {0, 0, 0};
    if (area > 1e-12 * ss * tt) {
        a = vec3_scale(1 / area, vec3_add_scaled(vec3_scale(tt, s), -st, t));
        b = vec3_scale(1 / area, vec3_add_scaled(vec3_scale(ss, t), -st, s));
    }
    return (wcut_span_guide){{(float)m.x, (float)m.y, (float)m.z},
                             {(float)a.x, (float)a.y, (float)a.z},
                             {(float)b.x, (float)b.y, (float)b.z}};
}

/* ---- all of them ---- */

/* mean speeds along u and v: the scale of the parameters */
static void mean_speeds(const wcut_surface *s, double *along_u, double *along_v) {
    *along_u = *along_v = 0;
    for (int j = 0; j < s->count_v; j++)
        for (int i = 0; i < s->count_u; i++) {
            const wcut_vec3 *c = &s->control[(size_t)j * s->count_u + i];
            if (i > 0) *along_u += vec3_distance(c[0], c[-1]) / s->count_v;
            if (j > 0) *along_v += vec3_distance(c[0], c[-(ptrdiff_t)s->count_u]) / s->count_u;
        }
    *along_u /= s->knots_u[s->count_u] - s->knots_u[CUBIC];
    *along_v /= s->knots_v[s->count_v] - s->knots_v[CUBIC];
}

wcut_status wcut_newton_foot_spans(const wcut_surface *surface, wcut_newton_foot *q, wcut_span_bounds *bounds) {
    const wcut_surface *s = surface;
    powers *u = list_powers(s->count_u, s->knots_u, q->columns, q->u);
    powers *v = list_powers(s->count_v, s->knots_v, q->rows, q->v);
    const wcut_status status = u && v ? WCUT_OK : WCUT_NO_MEMORY;
    double speed_u, speed_v;
    mean_speeds(s, &speed_u, &speed_v);
    for (int row = 0; row < q->rows && status == WCUT_OK; row++)
        for (int column = 0; column < q->columns; column++) {
            const int k = row * q->columns + column;
            find_powers(s, &u[column], &v[row], q->span[k].power);
            bound_span(&q->span[k], speed_u * (q->u[column + 1] - q->u[column]), speed_v * (q->v[row + 1] - q->v[row]),
                       &bounds[k]);
            q->guide[k] = guide_of(&q->span[k], q->centre);
        }
    wcut_free(v);
    wcut_free(u);
    return status;
}

void wcut_newton_foot_destroy(wcut_newton_foot *newton) {
    if (!newton) return;
    wcut_free(newton->u);
    wcut_free(newton->v);
    wcut_free(newton->span);
    wcut_free(newton->guide);
    wcut_free(newton);
}

wcut_status wcut_newton_foot_create(const wcut_surface *surface, double size, wcut_newton_foot **newton) {
    const wcut_surface *s = surface;

    /* only polynomial bicubic surfaces */
    if (s->weights || s->degree_u != CUBIC || s->degree_v != CUBIC) {
        *newton = NULL;
        return WCUT_OK;
    }
    wcut_newton_foot *q = wcut_alloc(1, sizeof *q);
    if (!q) return WCUT_NO_MEMORY;

    /* distinct knots; the origin is a point near the middle */
    q->u = list_knots(s->count_u, s->knots_u, &q->columns);
    q->v = list_knots(s->count_v, s->knots_v, &q->rows);
    q->centre = s->control[(ptrdiff_t)(s->count_v / 2) * s->count_u + s->count_u / 2];
    q->tolerance = EXACT * size;
    wcut_status status = q->u && q->v ? WCUT_OK : WCUT_NO_MEMORY;
    const size_t count = (size_t)q->columns * (size_t)q->rows;
    const bool fits = count > 0 && count <= SPANS_MAX;
    if (status == WCUT_OK && fits) {
        /* polynomials and bounds of every span, then the radii that they prove */
        wcut_span_bounds *bounds = wcut_alloc(count, sizeof *bounds);
        q->span = wcut_alloc(count, sizeof *q->span);
        q->guide = wcut_alloc(count, sizeof *q->guide);
        status = bounds && q->span && q->guide ? wcut_newton_foot_spans(s, q, bounds) : WCUT_NO_MEMORY;
        if (status == WCUT_OK) status = wcut_newton_foot_prove(q, bounds);
        wcut_free(bounds);
    }
    if (status == WCUT_OK && fits) {
        *newton = q;
        return WCUT_OK;
    }
    wcut_newton_foot_destroy(q);
    if (status == WCUT_OK) *newton = NULL;

    return status;
}
