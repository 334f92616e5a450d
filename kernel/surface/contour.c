/* The zero set of a surface's height over a plane, in pieces that each cross one cell.

   Over a cell the height, times the weight, is a Bernstein polynomial. Coefficients of one sign exclude it. Where the
   differences of coefficients in one direction have one sign, the zeros are a graph over the other direction; where that
   graph enters and leaves the cell are zeros of polynomials of one variable on its edges. Other cells are halved. */
#include "surface/contour.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/bezier.h"

enum { DEPTH_MAX = 80, CELLS_MAX = 1 << 22, ROOTS_MAX = 2 * WCUT_DEGREE_MAX + 2, REFINE_MAX = 60, ROOT_HALVINGS = 60 };

static const double SHIFT = 1.37e-13; /* of the size: the plane is moved by so much */
static const double TOUCHING = 1e-6;  /* of the tolerance: a cell this near to the plane is not divided for ever */

/* of the tolerance: what a chord may miss the curve by at its quarters */
static const double HELD = 0.7;

typedef struct cell {
    int p, q;
    double u0, u1, v0, v1;
    double f[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE]; /* f[j][i], i along u */
} cell;

typedef struct walker {
    const wcut_surface *surface;
    wcut_contour *c;
    double tolerance;
    int cells;
} walker;

void wcut_contour_clear(wcut_contour *contour) {
    wcut_free(contour->piece);
    wcut_free(contour->uv);
    *contour = (wcut_contour){.piece_count = 0};
}

/* ---- room ----------------------------------------------------------------------------------------------------------- */

static void *grown(void *old, int count, int *room, size_t size) {
    if (count < *room) return old;
    const int more = *room > 0 ? 2 * *room : 64;
    void *bigger = more > *room ? wcut_alloc((size_t)more, size) : NULL;
    if (!bigger) return NULL;
    if (count > 0) memcpy(bigger, old, (size_t)count * size);
    wcut_free(old);
    *room = more;
    return bigger;
}

static wcut_status contour_add_point(wcut_contour *c, double u, double v) {
    double *uv = grown(c->uv, c->point_count, &c->point_room, 2 * sizeof *uv);
    if (!uv) return WCUT_NO_MEMORY;
    c->uv = uv;
    uv[2 * (size_t)c->point_count] = u, uv[2 * (size_t)c->point_count + 1] = v;
    c->point_count++;
    return WCUT_OK;
}

static wcut_status add_piece(wcut_contour *c, wcut_contour_piece piece) {
    wcut_contour_piece *all = grown(c->piece, c->piece_count, &c->piece_room, sizeof *all);
    if (!all) return WCUT_NO_MEMORY;
    c->piece = all;
    all[c->piece_count++] = piece;
    return WCUT_OK;
}

/* ---- polynomials of one variable over [0, 1] ------------------------------------------------------------------------- */

static bool is_above(double f) { return f >= 0; }

static double contour_value_at(int n, const double *b, double t) {
    double line[WCUT_BASIS_SIZE] = {b[0]};
    for (int k = 0; k <= n; k++) line[k] = b[k];
    for (int k = n; k > 0; k--)
        for (int i = 0; i < k; i++) line[i] = (1 - t) * line[i] + t * line[i + 1];
    return line[0];
}

/* the one change of sign between the ends: regula falsi with bisection (Illinois, Dowell, Jarratt 1971) */
static double root_between(int n, const double *b) {
    double low = 0, high = 1, at_low = b[0], at_high = b[n];
    for (int k = 0; k < 100 && high - low > 1e-16; k++) {
        double t = k % 4 == 3 ? (low + high) / 2 : low + (high - low) * at_low / (at_low - at_high);
        if (!(t > low && t < high)) t = (low + high) / 2;
        const double f = contour_value_at(n, b, t);
        if (t <= low || t >= high) break;
        if (is_above(f) == is_above(at_low)) {
            low = t, at_low = f;
            at_high /= 2;
        } else {
            high = t, at_high = f;
            at_low /= 2;
        }
        if (f == 0) return t;
    }
    return (low + high) / 2;
}

/* all changes of sign in rising order, appended to root[]; coefficients change sign at least as often (Descartes) */
static void find_roots(int n, const double *b, double from, double to, int halvings, double *root, int *count) {
    int changes = 0;
    for (int k = 0; k < n; k++) changes += is_above(b[k]) != is_above(b[k + 1]);
    if (changes == 0) return;
    if (changes == 1 || halvings == ROOT_HALVINGS) {
        if (is_above(b[0]) != is_above(b[n]) && *count < ROOTS_MAX)
            root[(*count)++] = from + (to - from) * root_between(n, b);
        return;
    }
    double line[WCUT_BASIS_SIZE], low[WCUT_BASIS_SIZE], high[WCUT_BASIS_SIZE];
    for (int k = 0; k <= n; k++) line[k] = b[k];
    for (int k = 0; k <= n; k++) {
        low[k] = line[0], high[n - k] = line[n - k];
        for (int i = 0; i < n - k; i++) line[i] = (line[i] + line[i + 1]) / 2;
    }
    const double middle = (from + to) / 2;
    find_roots(n, low, from, middle, halvings + 1, root, count);
    find_roots(n, high, middle, to, halvings + 1, root, count);
}

/* ---- one cell that is a graph ---------------------------------------------------------------------------------------- */

/* a cell seen so that the height rises or falls with s everywhere: s is u, or v where turned; zeros are s = g(t) */
typedef struct graph {
    const cell *k;
    bool turned;
    int n, m; /* degrees in s and t */
    double s0, s1, t0, t1;
    const struct graph *other; /* the same cell with s and t exchanged, where it is a graph that way too, or NULL */
} graph;

/* the polynomial along s at t, a share of the cell */
static void across_at(const graph *g, double share, double *b) {
    double column[WCUT_BASIS_SIZE] = {0};
    for (int i = 0; i <= g->n; i++) {
        for (int j = 0; j <= g->m; j++) column[j] = g->turned ? g->k->f[i][j] : g->k->f[j][i];
        b[i] = contour_value_at(g->m, column, share);
    }
}

/* s of the zero at t, which is there */
static double graph_at(const graph *g, double t) {
    double b[WCUT_BASIS_SIZE] = {0};
    across_at(g, (t - g->t0) / (g->t1 - g->t0), b);
    if (is_above(b[0]) == is_above(b[g->n])) /* on an edge, to rounding: the nearer one */
        return fabs(b[0]) < fabs(b[g->n]) ? g->s0 : g->s1;
    return g->s0 + (g->s1 - g->s0) * root_between(g->n, b);
}

static void parameters_of(const graph *g, double s, double t, double *u, double *v) {
    *u = g->turned ? t : s;
    *v = g->turned ? s : t;
}

static double off_chord(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b) {
    const wcut_vec3 side = vec3_sub(b, a), to = vec3_sub(p, a);
    const double square = vec3_dot(side, side), t = square > 0 ? clamp(vec3_dot(to, side) / square, 0, 1) : 0;
    return vec3_length(vec3_add_scaled(to, -t, side));
}

/* a point of a curve that is being drawn */
typedef struct place {
    double u, v;
    wcut_vec3 point;
} place;

static place contour_place_at(const walker *w, const graph *g, double t) {
    place p;
    parameters_of(g, graph_at(g, t), t, &p.u, &p.v);
    wcut_surface_eval(w->surface, p.u, p.v, 0, &p.point);
    return p;
}

/* points strictly between two on the graph, until its chords are near enough; steep parts are walked along s */
static wcut_status contour_refine(walker *w, const graph *g, place a, place b, int halvings) {
    const double wide_u = fabs(b.u - a.u) / (g->k->u1 - g->k->u0), wide_v = fabs(b.v - a.v) / (g->k->v1 - g->k->v0);
    if (g->other && (wide_u > wide_v) != g->turned) g = g->other;
    const double ta = g->turned ? a.u : a.v, tb = g->turned ? b.u : b.v, t = (ta + tb) / 2;
    if (t == ta || t == tb || halvings == REFINE_MAX) return WCUT_OK;
    const place p = contour_place_at(w, g, t);
    bool near = off_chord(p.point, a.point, b.point) <= HELD * w->tolerance;
    for (int k = 1; k <= 3 && near; k += 2)
        near = off_chord(contour_place_at(w, g, ta + (tb - ta) * k / 4).point, a.point, b.point) <= HELD * w->tolerance;
    /* a chord is only known by points in its middle: a parameter may rush through most of it at one end */
    const double chord = vec3_distance(a.point, b.point),
                 longer = fmax(vec3_distance(a.point, p.point), vec3_distance(p.point, b.point));
    if (near && longer <= fmax(0.8 * chord, w->tolerance)) return WCUT_OK;
    wcut_status status = contour_refine(w, g, a, p, halvings + 1);
    if (status == WCUT_OK) status = contour_add_point(w->c, p.u, p.v);
    return status == WCUT_OK ? contour_refine(w, g, p, b, halvings + 1) : status;
}

/* where the graph meets the cell's edges: on one of the lines s = s0, s1, or t = t0, t1 */
static wcut_contour_end contour_end_of(const graph *g, double s, double t, bool on_t, bool high) {
    wcut_contour_end e = {.on_v = on_t != g->turned, .side = high ? -1 : 1};
    e.line = on_t ? (high ? g->t1 : g->t0) : (high ? g->s1 : g->s0);
    parameters_of(g, s, t, &e.u, &e.v);
    return e;
}

static wcut_status trace_between(walker *w, const graph *g, const wcut_contour_end *from, const wcut_contour_end *to) {
    wcut_contour *c = w->c;
    const int first = c->point_count;
    place a = {.u = from->u, .v = from->v}, b = {.u = to->u, .v = to->v};
    wcut_surface_eval(w->surface, a.u, a.v, 0, &a.point);
    wcut_surface_eval(w->surface, b.u, b.v, 0, &b.point);
    wcut_status status = contour_add_point(c, a.u, a.v);
    if (status == WCUT_OK) status = contour_refine(w, g, a, b, 0);
    if (status == WCUT_OK) status = contour_add_point(c, b.u, b.v);
    if (status != WCUT_OK) return status;
    return add_piece(c, (wcut_contour_piece){.first = first, .count = c->point_count - first, .end = {*from, *to}});
}

/* the graph within the cell: over those stretches of t where the heights on both sides have unlike signs */
static wcut_status trace_graph(walker *w, const graph *g) {
    double edge[2][WCUT_BASIS_SIZE], root[2][ROOTS_MAX], at[2 * ROOTS_MAX + 2];
    int count[2] = {0, 0}, side[2 * ROOTS_MAX + 2], breaks = 0;

    /* roots of the height along both sides of the cell */
    for (int k = 0; k < 2; k++) {
        for (int j = 0; j <= g->m; j++) {
            const int i = k ? g->n : 0;
            edge[k][j] = g->turned ? g->k->f[i][j] : g->k->f[j][i];
        }
        find_roots(g->m, edge[k], 0, 1, 0, root[k], &count[k]);
    }

    /* all roots in order, with the side that each is on, between the ends */
    at[breaks] = 0, side[breaks++] = -1;
    for (int i = 0, j = 0; i < count[0] || j < count[1];) {
        const bool low = j == count[1] || (i < count[0] && root[0][i] <= root[1][j]);
        at[breaks] = low ? root[0][i++] : root[1][j++];
        side[breaks++] = low ? 0 : 1;
    }
    at[breaks] = 1, side[breaks++] = -1;

    /* between two breaks the contour runs through where the sides have unlike signs */
    wcut_status status = WCUT_OK;
    for (int k = 0; k + 1 < breaks && status == WCUT_OK; k++) {
        const double middle = (at[k] + at[k + 1]) / 2;
        if (is_above(contour_value_at(g->m, edge[0], middle)) == is_above(contour_value_at(g->m, edge[1], middle)))
            continue;

        /* a break at an end of the cell lies on the graph, one at a root on the side that it is of */
        wcut_contour_end end[2];
        double t[2];
        for (int e = 0; e < 2; e++) {
            const int b = k + e;
            t[e] = b == 0 ? g->t0 : b == breaks - 1 ? g->t1 : g->t0 + (g->t1 - g->t0) * at[b];
            const double s = side[b] < 0 ? graph_at(g, t[e]) : side[b] ? g->s1 : g->s0;
            end[e] =
                side[b] < 0 ? contour_end_of(g, s, t[e], true, b > 0) : contour_end_of(g, s, t[e], false, side[b] == 1);
        }
        if (t[0] < t[1]) status = trace_between(w, g, &end[0], &end[1]);
    }

    return status;
}

/* ---- cells ------------------------------------------------------------------------------------------------------------ */

/* signs of all differences along u (or v): 1 rising, -1 falling, 0 both */
static int direction_of(const cell *k, bool along_u) {
    bool rises = true, falls = true;
    const int p = along_u ? k->p - 1 : k->p, q = along_u ? k->q : k->q - 1;
    for (int j = 0; j <= q; j++)
        for (int i = 0; i <= p; i++) {
            const double d = (along_u ? k->f[j][i + 1] : k->f[j + 1][i]) - k->f[j][i];
            rises = rises && d > 0, falls = falls && d < 0;
        }
    return rises ? 1 : falls ? -1 : 0;
}

/* the largest second difference along a direction: how far from straight */
static double bend_of(const cell *k, bool along_u) {
    double max = 0;
    const int p = along_u ? k->p - 2 : k->p, q = along_u ? k->q : k->q - 2;
    for (int j = 0; j <= q; j++)
        for (int i = 0; i <= p; i++) {
            const double a = k->f[j][i], b = along_u ? k->f[j][i + 1] : k->f[j + 1][i],
                         c = along_u ? k->f[j][i + 2] : k->f[j + 2][i];
            max = fmax(max, fabs(a - 2 * b + c));
        }
    return max;
}

static void contour_halve(const cell *whole, bool along_u, cell half[2]) {
    const int n = along_u ? whole->p : whole->q, lanes = along_u ? whole->q : whole->p;
    half[0] = half[1] = *whole;
    if (along_u) {
        half[0].u1 = half[1].u0 = (whole->u0 + whole->u1) / 2;
    } else {
        half[0].v1 = half[1].v0 = (whole->v0 + whole->v1) / 2;
    }
    for (int c = 0; c <= lanes; c++) {
        double line[WCUT_BASIS_SIZE];
        for (int k = 0; k <= n; k++) line[k] = along_u ? whole->f[c][k] : whole->f[k][c];
        for (int k = 0; k <= n; k++) {
            *(along_u ? &half[0].f[c][k] : &half[0].f[k][c]) = line[0];
            *(along_u ? &half[1].f[c][n - k] : &half[1].f[n - k][c]) = line[n - k];
            for (int i = 0; i < n - k; i++) line[i] = (line[i] + line[i + 1]) / 2;
        }
    }
}

/* too small, or too near to the plane, to be worth dividing */
static bool is_touching(const walker *w, const cell *k) {
    double max = 0;
    for (int j = 0; j <= k->q; j++)
        for (int i = 0; i <= k->p; i++) max = fmax(max, fabs(k->f[j][i]));
    if (max < TOUCHING * w->tolerance) return true;
    wcut_vec3 a, b, c, d;
    wcut_surface_eval(w->surface, k->u0, k->v0, 0, &a);
    wcut_surface_eval(w->surface, k->u1, k->v1, 0, &b);
    wcut_surface_eval(w->surface, k->u1, k->v0, 0, &c);
    wcut_surface_eval(w->surface, k->u0, k->v1, 0, &d);
    const double reach = w->tolerance / 4;
    return vec3_distance(a, b) < reach && vec3_distance(c, d) < reach && vec3_distance(a, c) < reach;
}

static wcut_status contour_divide(walker *w, const cell *k, int depth) {
    bool above = false, below = false;

    /* control heights of one sign: no contour in the cell */
    for (int j = 0; j <= k->q; j++)
        for (int i = 0; i <= k->p; i++) {
            const bool sign = is_above(k->f[j][i]);
            above = above || sign, below = below || !sign;
        }
    if (!above || !below) return WCUT_OK;
    if (++w->cells > CELLS_MAX) return WCUT_NOT_CONVERGED;

    /* monotone along one direction: the contour is a graph over the other */
    const bool by_u = direction_of(k, true) != 0, by_v = direction_of(k, false) != 0;
    if (by_u || by_v) {
        graph upright = {k, false, k->p, k->q, k->u0, k->u1, k->v0, k->v1, NULL};
        graph turned = {k, true, k->q, k->p, k->v0, k->v1, k->u0, k->u1, NULL};
        if (by_u && by_v) upright.other = &turned, turned.other = &upright;
        return trace_graph(w, by_u ? &upright : &turned);
    }

    /* too small to halve: the surface touches the plane here */
    if (depth == DEPTH_MAX || (depth > 8 && is_touching(w, k))) {
        if (w->c->touching++ == 0) w->c->touch_u = (k->u0 + k->u1) / 2, w->c->touch_v = (k->v0 + k->v1) / 2;
        return WCUT_OK;
    }

    /* halve across the direction that bends more */
    const double bend_u = bend_of(k, true), bend_v = bend_of(k, false);
    cell half[2];
    contour_halve(k, bend_u == bend_v ? depth % 2 == 0 : bend_u > bend_v, half);
    wcut_status status = contour_divide(w, &half[0], depth + 1);
    if (status == WCUT_OK) status = contour_divide(w, &half[1], depth + 1);

    return status;
}

/* does the height change sign among the control points of a span? */
static bool may_meet(const wcut_surface *s, const double *height, int span_u, int span_v) {
    bool above = false, below = false;
    for (int j = span_v - s->degree_v; j <= span_v; j++)
        for (int i = span_u - s->degree_u; i <= span_u; i++) {
            const bool sign = is_above(height[(ptrdiff_t)j * s->count_u + i]);
            above = above || sign, below = below || !sign;
        }
    return above && below;
}

static wcut_status find_in_span(walker *w, int span_u, int span_v, wcut_vec3 normal, double level) {
    wcut_bezier b;
    wcut_bezier_of_surface(w->surface, span_u, span_v, &b);
    cell k = {.p = b.degree_u, .q = b.degree_v, .u0 = b.u0, .u1 = b.u1, .v0 = b.v0, .v1 = b.v1};
    for (int j = 0; j <= k.q; j++)
        for (int i = 0; i <= k.p; i++) {
            const wcut_homogeneous *h = &b.at[j][i];
            k.f[j][i] = normal.x * h->x + normal.y * h->y + normal.z * h->z - level * h->w;
        }
    return contour_divide(w, &k, 0);
}

wcut_status wcut_contour_find(const wcut_surface *s, wcut_vec3 point, wcut_vec3 normal, double tolerance,
                              wcut_contour *contour) {
    wcut_contour c = {.size = vec3_length(point)};
    const int count = s->count_u * s->count_v;
    double *height = wcut_alloc((size_t)count, sizeof *height);

    /* a shift by less than rounding keeps control points off the plane exactly */
    if (!height) return WCUT_NO_MEMORY;
    for (int k = 0; k < count; k++) c.size = fmax(c.size, vec3_length(s->control[k]));
    const double level = vec3_dot(normal, point) + SHIFT * c.size;
    for (int k = 0; k < count; k++) height[k] = vec3_dot(normal, s->control[k]) - level;

    /* each span that is not empty and whose control points lie on both sides */
    walker w = {.surface = s, .c = &c, .tolerance = tolerance};
    wcut_status status = WCUT_OK;
    for (int j = s->degree_v; j < s->count_v && status == WCUT_OK; j++)
        for (int i = s->degree_u; i < s->count_u && status == WCUT_OK; i++)
            if (s->knots_u[i] < s->knots_u[i + 1] && s->knots_v[j] < s->knots_v[j + 1] && may_meet(s, height, i, j))
                status = find_in_span(&w, i, j, normal, level);

    wcut_free(height);
    if (status == WCUT_OK) {
        *contour = c;
    } else {
        wcut_contour_clear(&c);
    }

    return status;
}
