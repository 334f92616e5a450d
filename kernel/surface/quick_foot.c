/* Feet of many queries near a smooth bicubic surface: Newton's method from a neighbour's foot, proven span by span.

   Let f be stationary in span c, at the distance d from the query p, and N a block of spans about c. Outside N the
   surface is at least D from c, so further than D - d from p: no closer than f where d < D / 2. Over N, with parameters
   scaled to lengths, |S - p|^2 / 2 has the Hessian  S_i . S_j + (S - p) . S_ij >= sigma^2 - |S - p| K,  sigma the least
   singular value of (S_u, S_v) and K a bound on the second derivatives; |S - p| <= d + rho, rho how far N reaches from
   c. Where  d < sigma^2 / K - rho  that is convex, and f the closest of N. The smaller of the two is the span's radius;
   how large N is to be is tried for each span. */
#include "surface/quick_foot.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"

enum { CUBIC = 3, ORDER = CUBIC + 1, SPANS_MOST = 200000, STEPS = 8, WALK = 64, BLOCKS = 2, LEVELS = 20 };

static const int block_reach[BLOCKS] = {3, 6}; /* spans on either side of c */

/* [mm] a step this short is the last: the foot is then right to its square over the radius of curvature */
static const double LAST = 1e-5;

/* a span: powers of s and t in 0 .. 1 */
typedef struct span {
    wcut_vec3 power[ORDER][ORDER]; /* [of t][of s] */
    double radius;                 /* [mm] as above; negative where nothing is proven */
} span;

struct wcut_quick {
    int columns, rows;
    double *u, *v; /* columns + 1, rows + 1: where spans begin and end */
    span *span;    /* rows x columns */
};

/* bounds of a span, lengths in mm, second derivatives in 1 / mm, parameters scaled alike everywhere */
typedef struct bounds {
    wcut_vec3 centre;
    double radius; /* of a ball about the centre that holds the span */
    double sigma;  /* least singular value of the scaled (S_u, S_v), from below */
    double bend;   /* K, from above */
} bounds;

/* ---- spans ---- */

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

/* thirds of every span */
static double *list_thirds(int spans, const double *knot) {
    double *list = wcut_alloc(CUBIC * (size_t)spans + 1, sizeof *list);
    for (int k = 0; list && k < spans; k++)
        for (int i = 0; i < CUBIC; i++) list[CUBIC * k + i] = knot[k] + i * (knot[k + 1] - knot[k]) / CUBIC;
    if (list) list[CUBIC * (size_t)spans] = knot[spans];
    return list;
}

static wcut_vec3 mix4(const double w[ORDER], wcut_vec3 a, wcut_vec3 b, wcut_vec3 c, wcut_vec3 d) {
    return vec3_add_scaled(vec3_add_scaled(vec3_add_scaled(vec3_scale(w[0], a), w[1], b), w[2], c), w[3], d);
}

/* a cubic's values at thirds to its Bezier points; and those to powers */
static const double to_bezier[ORDER][ORDER] = {
    {1, 0, 0, 0}, {-5 / 6.0, 3, -1.5, 1 / 3.0}, {1 / 3.0, -1.5, 3, -5 / 6.0}, {0, 0, 0, 1}};
static const double to_power[ORDER][ORDER] = {{1, 0, 0, 0}, {-3, 3, 0, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}};

/* a matrix applied to both directions of a net */
static void convert(const double m[ORDER][ORDER], wcut_vec3 net[ORDER][ORDER]) {
    wcut_vec3 half[ORDER][ORDER];
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++) half[j][i] = mix4(m[i], net[j][0], net[j][1], net[j][2], net[j][3]);
    for (int j = 0; j < ORDER; j++)
        for (int i = 0; i < ORDER; i++) net[j][i] = mix4(m[j], half[0][i], half[1][i], half[2][i], half[3][i]);
}

/* ---- bounds ---- */

/* differences of a net along s and t, so often each; times the degrees they are control points of a derivative */
static wcut_vec3 difference(wcut_vec3 net[ORDER][ORDER], int j, int i, int t, int s) {
    if (s > 0) return vec3_sub(difference(net, j, i + 1, t, s - 1), difference(net, j, i, t, s - 1));
    if (t > 0) return vec3_sub(difference(net, j + 1, i, t - 1, s), difference(net, j, i, t - 1, s));
    return net[j][i];
}

static double factor(int times) { return times == 2 ? 6 : times == 1 ? 3 : 1; }

/* the mean of a derivative's control points, and how far the furthest is from it */
static wcut_vec3 hull(wcut_vec3 net[ORDER][ORDER], int t, int s, double *off) {
    wcut_vec3 sum = {0, 0, 0};
    const int rows = ORDER - t, columns = ORDER - s;
    const double by = factor(t) * factor(s);
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++) sum = vec3_add(sum, difference(net, j, i, t, s));
    const wcut_vec3 mean = vec3_scale(by / (rows * columns), sum);
    *off = 0;
    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            *off = fmax(*off, vec3_distance(vec3_scale(by, difference(net, j, i, t, s)), mean));
    return mean;
}

static double longest(wcut_vec3 net[ORDER][ORDER], int t, int s) {
    double off;
    const wcut_vec3 mean = hull(net, t, s, &off);
    return vec3_length(mean) + off;
}

/* wide, high: what a step of the span's own parameters is of the scaled ones */
static bounds bound_span(wcut_vec3 net[ORDER][ORDER], double wide, double high) {
    double off_u, off_v;
    bounds b = {0};
    b.centre = hull(net, 0, 0, &b.radius);
    const wcut_vec3 su = vec3_scale(1 / wide, hull(net, 0, 1, &off_u));
    const wcut_vec3 sv = vec3_scale(1 / high, hull(net, 1, 0, &off_v));
    const double uu = vec3_dot(su, su), uv = vec3_dot(su, sv), vv = vec3_dot(sv, sv);
    const double least = (uu + vv) / 2 - hypot((uu - vv) / 2, uv);
    b.sigma = sqrt(fmax(least, 0)) - hypot(off_u / wide, off_v / high);
    b.bend = fmax(longest(net, 0, 2) / (wide * wide), longest(net, 2, 0) / (high * high)) +
             longest(net, 1, 1) / (wide * high);
    return b;
}

/* ---- radii ---- */

/* boxes of balls over blocks of 2^level spans a side, for the distance between a span and all others */
typedef struct pyramid {
    int levels, columns[LEVELS], rows[LEVELS];
    wcut_vec3 *low[LEVELS], *high[LEVELS];
} pyramid;

static void clear_pyramid(pyramid *p) {
    for (int l = 0; l < LEVELS; l++) {
        wcut_free(p->low[l]);
        wcut_free(p->high[l]);
    }
}

static void enclose(pyramid *p, int level, int to, wcut_vec3 low, wcut_vec3 high) {
    wcut_vec3 *l = &p->low[level][to], *h = &p->high[level][to];
    *l = vec3(fmin(l->x, low.x), fmin(l->y, low.y), fmin(l->z, low.z));
    *h = vec3(fmax(h->x, high.x), fmax(h->y, high.y), fmax(h->z, high.z));
}

static bool build_pyramid(const wcut_quick *q, const bounds *b, pyramid *p) {
    int columns = q->columns, rows = q->rows;
    for (p->levels = 0;; p->levels++, columns = (columns + 1) / 2, rows = (rows + 1) / 2) {
        const int l = p->levels;
        const size_t count = (size_t)columns * rows;
        p->columns[l] = columns, p->rows[l] = rows;
        p->low[l] = wcut_alloc(count, sizeof *p->low[l]);
        p->high[l] = wcut_alloc(count, sizeof *p->high[l]);
        if (!p->low[l] || !p->high[l]) return false;
        for (size_t k = 0; k < count; k++)
            p->low[l][k] = vec3(INFINITY, INFINITY, INFINITY), p->high[l][k] = vec3(-INFINITY, -INFINITY, -INFINITY);
        const int from = l > 0 ? p->columns[l - 1] * p->rows[l - 1] : columns * rows;
        for (int k = 0; k < from; k++) {
            const wcut_vec3 r = vec3(b[l ? 0 : k].radius, b[l ? 0 : k].radius, b[l ? 0 : k].radius);
            if (l == 0)
                enclose(p, 0, k, vec3_sub(b[k].centre, r), vec3_add(b[k].centre, r));
            else
                enclose(p, l, k / p->columns[l - 1] / 2 * columns + k % p->columns[l - 1] / 2, p->low[l - 1][k],
                        p->high[l - 1][k]);
        }
        if (count == 1) break;
    }
    p->levels++;
    return true;
}

static double box_distance(wcut_vec3 low, wcut_vec3 high, wcut_vec3 p) {
    const wcut_vec3 off = vec3(fmax(fmax(low.x - p.x, p.x - high.x), 0), fmax(fmax(low.y - p.y, p.y - high.y), 0),
                               fmax(fmax(low.z - p.z, p.z - high.z), 0));
    return vec3_length(off);
}

/* a block of spans: columns c0 .. c1, rows r0 .. r1, both ends within */
typedef struct range {
    int c0, c1, r0, r1;
} range;

/* the nearest of the four spans just outside a range, in the middle of its sides: a first guess saves most of the tree */
static double first_guess(const pyramid *p, range of, wcut_vec3 at, double enough) {
    const int column = (of.c0 + of.c1) / 2, row = (of.r0 + of.r1) / 2;
    const int beside[4][2] = {{of.c0 - 1, row}, {of.c1 + 1, row}, {column, of.r0 - 1}, {column, of.r1 + 1}};
    double best = enough;
    for (int k = 0; k < 4; k++) {
        const int c = beside[k][0], r = beside[k][1];
        if (c < 0 || c >= p->columns[0] || r < 0 || r >= p->rows[0]) continue;
        best = fmin(best, box_distance(p->low[0][r * p->columns[0] + c], p->high[0][r * p->columns[0] + c], at));
    }
    return best;
}

/* No span outside a range is closer to p than this; more than `enough` is as good as any. */
static double outer_distance(const pyramid *p, range of, wcut_vec3 at, double enough) {
    struct {
        int level, column, row;
    } stack[4 * LEVELS];
    int depth = 1;
    stack[0].level = p->levels - 1, stack[0].column = stack[0].row = 0;
    double best = first_guess(p, of, at, enough);
    while (depth > 0) {
        depth--;
        const int l = stack[depth].level, c = stack[depth].column, r = stack[depth].row;
        if (c << l >= of.c0 && ((c + 1) << l) - 1 <= of.c1 && r << l >= of.r0 && ((r + 1) << l) - 1 <= of.r1) continue;
        const int k = r * p->columns[l] + c;
        const double away = box_distance(p->low[l][k], p->high[l][k], at);
        if (away >= best) continue;
        if (l == 0) {
            best = away;
            continue;
        }
        for (int i = 0; i < 4; i++) {
            const int column = 2 * c + i % 2, row = 2 * r + i / 2;
            if (column >= p->columns[l - 1] || row >= p->rows[l - 1]) continue;
            stack[depth].level = l - 1, stack[depth].column = column, stack[depth].row = row;
            depth++;
        }
    }
    return best;
}

static range block_about(const wcut_quick *q, int column, int row, int reach) {
    return (range){column > reach ? column - reach : 0, column + reach < q->columns ? column + reach : q->columns - 1,
                   row > reach ? row - reach : 0, row + reach < q->rows ? row + reach : q->rows - 1};
}

/* the radius that one size of block proves */
static double radius_of(const wcut_quick *q, const bounds *b, const pyramid *p, int column, int row, int reach) {
    const bounds *c = &b[row * q->columns + column];
    const range of = block_about(q, column, row, reach);
    double sigma = INFINITY, bend = 0, rho = 0;
    for (int r = of.r0; r <= of.r1; r++)
        for (int k = of.c0; k <= of.c1; k++) {
            const bounds *other = &b[r * q->columns + k];
            sigma = fmin(sigma, other->sigma), bend = fmax(bend, other->bend);
            rho = fmax(rho, vec3_distance(other->centre, c->centre) + other->radius + c->radius);
        }
    if (sigma <= 0) return -1;
    const double convex = bend > 0 ? sigma * sigma / bend - rho : INFINITY;
    if (convex <= 0) return -1;
    return fmin(convex, (outer_distance(p, of, c->centre, 2 * convex + c->radius) - c->radius) / 2);
}

static wcut_status find_radii(wcut_quick *q, const bounds *b) {
    pyramid p = {0};
    const bool there = build_pyramid(q, b, &p);
    for (int row = 0; row < q->rows && there; row++)
        for (int column = 0; column < q->columns; column++) {
            double *radius = &q->span[row * q->columns + column].radius;
            *radius = -1;
            /* a larger block that proves less is followed by none that proves more */
            for (int k = 0; k < BLOCKS; k++) {
                const double r = radius_of(q, b, &p, column, row, block_reach[k]);
                if (r < *radius) break;
                *radius = r;
            }
            *radius -= 10 * LAST; /* the last step may leave the span by a hair; rounding */
        }
    clear_pyramid(&p);
    return there ? WCUT_OK : WCUT_NO_MEMORY;
}

/* ---- making ---- */

void wcut_quick_destroy(wcut_quick *quick) {
    if (!quick) return;
    wcut_free(quick->u);
    wcut_free(quick->v);
    wcut_free(quick->span);
    wcut_free(quick);
}

/* mean speeds along u and v: the scale of the parameters */
static void mean_speeds(const wcut_surface *s, double *along_u, double *along_v) {
    *along_u = *along_v = 0;
    for (int j = 0; j < s->count_v; j++)
        for (int i = 0; i < s->count_u; i++) {
            const wcut_vec3 *c = &s->control[(size_t)j * s->count_u + i];
            if (i > 0) *along_u += vec3_distance(c[0], c[-1]) / s->count_v;
            if (j > 0) *along_v += vec3_distance(c[0], c[-(long)s->count_u]) / s->count_u;
        }
    *along_u /= s->knots_u[s->count_u] - s->knots_u[CUBIC];
    *along_v /= s->knots_v[s->count_v] - s->knots_v[CUBIC];
}

static wcut_status fill_spans(const wcut_surface *s, wcut_quick *q, bounds *b) {
    const int across = CUBIC * q->columns + 1, along = CUBIC * q->rows + 1;
    double *u = list_thirds(q->columns, q->u), *v = list_thirds(q->rows, q->v), speed_u, speed_v;
    wcut_vec3 *point = wcut_alloc((size_t)across * along, sizeof *point);
    wcut_status status = u && v && point ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = wcut_surface_eval_grid(s, across, u, along, v, point);
    mean_speeds(s, &speed_u, &speed_v);
    for (int row = 0; row < q->rows && status == WCUT_OK; row++)
        for (int column = 0; column < q->columns; column++) {
            wcut_vec3 net[ORDER][ORDER];
            for (int j = 0; j < ORDER; j++)
                memcpy(net[j], &point[(size_t)(CUBIC * row + j) * across + (size_t)CUBIC * (size_t)column],
                       sizeof net[j]);
            convert(to_bezier, net);
            b[row * q->columns + column] =
                bound_span(net, speed_u * (q->u[column + 1] - q->u[column]), speed_v * (q->v[row + 1] - q->v[row]));
            convert(to_power, net);
            memcpy(q->span[row * q->columns + column].power, net, sizeof net);
        }
    wcut_free(point);
    wcut_free(v);
    wcut_free(u);
    return status;
}

wcut_status wcut_quick_create(const wcut_surface *surface, wcut_quick **quick) {
    const wcut_surface *s = surface;
    if (s->weights || s->degree_u != CUBIC || s->degree_v != CUBIC) {
        *quick = NULL;
        return WCUT_OK;
    }
    wcut_quick *q = wcut_alloc(1, sizeof *q);
    if (!q) return WCUT_NO_MEMORY;
    q->u = list_knots(s->count_u, s->knots_u, &q->columns);
    q->v = list_knots(s->count_v, s->knots_v, &q->rows);
    wcut_status status = q->u && q->v ? WCUT_OK : WCUT_NO_MEMORY;
    const size_t count = (size_t)q->columns * q->rows;
    const bool fits = count > 0 && count <= SPANS_MOST;
    if (status == WCUT_OK && fits) {
        bounds *b = wcut_alloc(count, sizeof *b);
        q->span = wcut_alloc(count, sizeof *q->span);
        status = b && q->span ? fill_spans(s, q, b) : WCUT_NO_MEMORY;
        if (status == WCUT_OK) status = find_radii(q, b);
        wcut_free(b);
    }
    if (status == WCUT_OK && fits) {
        *quick = q;
        return WCUT_OK;
    }
    wcut_quick_destroy(q);
    if (status == WCUT_OK) *quick = NULL;
    return status;
}

/* ---- a query ---- */

/* S, S_s, S_t, S_ss, S_st, S_tt in the span's own parameters */
typedef struct jet {
    wcut_vec3 at, s, t, ss, st, tt;
} jet;

static inline wcut_vec3 horner(double x, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c, wcut_vec3 d) {
    return vec3_add_scaled(a, x, vec3_add_scaled(b, x, vec3_add_scaled(c, x, d)));
}

/* a + x b + x^2 c */
static inline wcut_vec3 horner3(double x, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    return vec3_add_scaled(a, x, vec3_add_scaled(b, x, c));
}

static inline void eval(const span *of, double s, double t, jet *f) {
    wcut_vec3 p[ORDER], d[ORDER], e[ORDER];
    for (int j = 0; j < ORDER; j++) {
        const wcut_vec3 *c = of->power[j];
        p[j] = horner(s, c[0], c[1], c[2], c[3]);
        d[j] = horner3(s, c[1], vec3_scale(2, c[2]), vec3_scale(3, c[3]));
        e[j] = vec3_add_scaled(vec3_scale(2, c[2]), 6 * s, c[3]);
    }
    const wcut_vec3 two = vec3_scale(2, p[2]), three = vec3_scale(3, p[3]);
    f->at = horner(t, p[0], p[1], p[2], p[3]);
    f->t = horner3(t, p[1], two, three);
    f->tt = vec3_add_scaled(two, 2 * t, three);
    f->s = horner(t, d[0], d[1], d[2], d[3]);
    f->st = horner3(t, d[1], vec3_scale(2, d[2]), vec3_scale(3, d[3]));
    f->ss = horner(t, e[0], e[1], e[2], e[3]);
}

/* the span that holds x, from a neighbour's; -1 where it is too far away or outside */
static inline int walk(const double *knot, int spans, int from, double x) {
    int k = from;
    for (int step = 0; step < WALK; step++) {
        if (x < knot[k])
            k--;
        else if (x > knot[k + 1])
            k++;
        else
            return k;
        if (k < 0 || k >= spans) return -1;
    }
    return -1;
}

static int find(const double *knot, int spans, double x) {
    int low = 0, high = spans;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (knot[middle] <= x)
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Newton's step and the square of its length, nearly; false where the squared distance is not convex there */
static inline bool step_of(const jet *f, wcut_vec3 r, double *ds, double *dt, double *square) {
    const double gs = vec3_dot(r, f->s), gt = vec3_dot(r, f->t), plain_s = vec3_dot(f->s, f->s);
    const double plain_t = vec3_dot(f->t, f->t), ss = plain_s - vec3_dot(r, f->ss), tt = plain_t - vec3_dot(r, f->tt);
    const double st = vec3_dot(f->s, f->t) - vec3_dot(r, f->st), area = ss * tt - st * st, by = 1 / area;
    *ds = (gs * tt - gt * st) * by;
    *dt = (gt * ss - gs * st) * by;
    *square = *ds * *ds * plain_s + *dt * *dt * plain_t;
    return ss > 0 && area > 1e-9 * ss * tt;
}

/* the foot from the last jet and step, to second order */
static bool finish(const span *of, const jet *f, wcut_vec3 p, double ds, double dt, wcut_foot *foot) {
    wcut_vec3 at = vec3_add_scaled(vec3_add_scaled(f->at, ds, f->s), dt, f->t);
    at = vec3_add_scaled(vec3_add_scaled(at, ds * ds / 2, f->ss), ds * dt, f->st);
    at = vec3_add_scaled(at, dt * dt / 2, f->tt);
    const wcut_vec3 s = vec3_add_scaled(vec3_add_scaled(f->s, ds, f->ss), dt, f->st);
    const wcut_vec3 t = vec3_add_scaled(vec3_add_scaled(f->t, ds, f->st), dt, f->tt);
    const wcut_vec3 r = vec3_sub(p, at), n = vec3_cross(s, t);
    const double size = vec3_length(n);
    foot->point = at;
    foot->distance = vec3_length(r);
    foot->height = vec3_dot(r, n) / size;
    foot->gap = 0, foot->beyond = 0;
    return size > 0 && foot->distance < of->radius;
}

/* the span of a neighbour's foot, from that of the one before */
static bool begin(const wcut_quick *q, const wcut_foot *near, wcut_quick_place *at) {
    if (at->column >= 0) at->column = walk(q->u, q->columns, at->column, near->u);
    if (at->row >= 0) at->row = walk(q->v, q->rows, at->row, near->v);
    if (at->column < 0) at->column = find(q->u, q->columns, near->u);
    if (at->row < 0) at->row = find(q->v, q->rows, near->v);
    return at->column >= 0 && at->row >= 0;
}

bool wcut_quick_foot(const wcut_quick *quick, wcut_vec3 p, const wcut_foot *near, wcut_quick_place *place,
                     wcut_foot *foot) {
    const wcut_quick *q = quick;
    if (!begin(q, near, place)) return false;
    wcut_quick_place at = *place;
    double u0 = q->u[at.column], v0 = q->v[at.row], wide = q->u[at.column + 1] - u0, high = q->v[at.row + 1] - v0;
    double s = (near->u - u0) / wide, t = (near->v - v0) / high;
    for (int step = 0; step < STEPS; step++) {
        const span *of = &q->span[at.row * q->columns + at.column];
        jet f;
        double ds, dt, square;
        eval(of, s, t, &f);
        if (!step_of(&f, vec3_sub(p, f.at), &ds, &dt, &square)) return false;
        s += ds, t += dt;
        const bool inside = s >= 0 && s <= 1 && t >= 0 && t <= 1, last = square <= LAST * LAST;
        const double u = u0 + s * wide, v = v0 + t * high;
        /* on the border more is to be said than that it is stationary */
        if ((!inside || last) && !(u > q->u[0] && u < q->u[q->columns] && v > q->v[0] && v < q->v[q->rows]))
            return false;
        if (last) {
            wcut_foot found = {.u = u, .v = v};
            if (!finish(of, &f, p, ds, dt, &found)) return false;
            *foot = found;
            *place = at;
            return true;
        }
        if (inside) continue;
        at.column = walk(q->u, q->columns, at.column, u), at.row = walk(q->v, q->rows, at.row, v);
        if (at.column < 0 || at.row < 0) return false;
        u0 = q->u[at.column], v0 = q->v[at.row], wide = q->u[at.column + 1] - u0, high = q->v[at.row + 1] - v0;
        s = (u - u0) / wide, t = (v - v0) / high;
    }
    return false;
}
