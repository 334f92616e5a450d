/* The closest point of a curve: branch and bound over Bezier pieces, each inside a capsule about its chord, and Newton's
   method for the point itself.

   A piece lies in the hull of its control points, so it is no closer than the chord is, less how far they stand off it.
   That falls with the square of a piece's length: some forty halvings about the foot prove it to rounding. */
#include <limits.h>
#include <stddef.h>
#include <wirecut/projection.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"
#include "surface/bezier.h"

enum { HALVINGS_MAX = 4000, DEPTH_MAX = 60, STEPS_MAX = 40, PATIENCE = 500 };

static const double SAME = 1e-13; /* of the size: distances nearer than this are equal */
static const double FAR = 1e100;  /* [mm] squares stay finite, with room for products */

typedef struct piece {
    double u0, u1;
    wcut_homogeneous at[WCUT_BASIS_SIZE];
} piece;

/* A complete binary tree of boxes in an array: the children of k are 2 k + 1 and 2 k + 2; the last `leaves` are pieces
   between neighbouring knots, or empty. */
typedef struct finder {
    const wcut_curve *curve;
    int pieces, leaves;
    piece *piece;
    wcut_vec3 *low, *high;
    double size;
} finder;

typedef struct search {
    const finder *f;
    wcut_vec3 p;
    wcut_curve_foot best;
    double same, lowest;
    int halvings;
} search;

static wcut_vec3 curve_foot_space(const wcut_homogeneous *h) { return vec3(h->x / h->w, h->y / h->w, h->z / h->w); }

static void finder_clear(finder *f) {
    wcut_free(f->piece);
    wcut_free(f->low);
    wcut_free(f->high);
}

static void box_of_piece(const finder *f, int k) {
    const piece *q = &f->piece[k];
    wcut_vec3 *low = &f->low[f->leaves - 1 + k], *high = &f->high[f->leaves - 1 + k];
    for (int i = 0; i <= f->curve->degree; i++) {
        const wcut_vec3 p = curve_foot_space(&q->at[i]);
        *low = vec3(fmin(low->x, p.x), fmin(low->y, p.y), fmin(low->z, p.z));
        *high = vec3(fmax(high->x, p.x), fmax(high->y, p.y), fmax(high->z, p.z));
    }
}

static wcut_status finder_build(const wcut_curve *curve, finder *f) {
    *f = (finder){.curve = curve, .leaves = 1};
    for (int s = curve->degree; s < curve->control_count; s++) f->pieces += curve->knots[s] < curve->knots[s + 1];
    while (f->leaves < f->pieces) f->leaves *= 2;
    const size_t nodes = 2 * (size_t)f->leaves;

    /* a heap of boxes over the Bezier pieces, all empty */
    f->piece = wcut_alloc((size_t)f->pieces, sizeof *f->piece);
    f->low = wcut_alloc(nodes, sizeof *f->low);
    f->high = wcut_alloc(nodes, sizeof *f->high);
    if (!f->piece || !f->low || !f->high) {
        finder_clear(f);
        return WCUT_NO_MEMORY;
    }
    for (size_t k = 0; k < nodes; k++) {
        f->low[k] = vec3(INFINITY, INFINITY, INFINITY);
        f->high[k] = vec3(-INFINITY, -INFINITY, -INFINITY);
    }

    /* the pieces and their boxes */
    for (int s = curve->degree, made = 0; s < curve->control_count; s++) {
        if (!(curve->knots[s] < curve->knots[s + 1])) continue;
        wcut_bezier b;
        wcut_bezier_of_curve(curve, s, &b);
        f->piece[made] = (piece){.u0 = b.u0, .u1 = b.u1};
        for (int i = 0; i <= curve->degree; i++) f->piece[made].at[i] = b.at[0][i];
        box_of_piece(f, made++);
    }

    /* boxes of the inner nodes, from the leaves up */
    for (int k = f->leaves - 2; k >= 0; k--) {
        const wcut_vec3 *a = &f->low[2 * k + 1], *b = &f->high[2 * k + 1];
        f->low[k] = vec3(fmin(a[0].x, a[1].x), fmin(a[0].y, a[1].y), fmin(a[0].z, a[1].z));
        f->high[k] = vec3(fmax(b[0].x, b[1].x), fmax(b[0].y, b[1].y), fmax(b[0].z, b[1].z));
    }

    /* squares of larger lengths would overflow */
    f->size = vec3_distance(f->low[0], f->high[0]) + fmax(vec3_length(f->low[0]), vec3_length(f->high[0]));
    if (f->size < FAR) return WCUT_OK;
    finder_clear(f);

    return WCUT_DEGENERATE;
}

static double curve_foot_box_distance(const finder *f, int node, wcut_vec3 p) {
    const wcut_vec3 low = f->low[node], high = f->high[node];
    if (low.x > high.x) return INFINITY; /* empty */
    const double x = fmax(0, fmax(low.x - p.x, p.x - high.x)), y = fmax(0, fmax(low.y - p.y, p.y - high.y)),
                 z = fmax(0, fmax(low.z - p.z, p.z - high.z));
    return sqrt(x * x + y * y + z * z);
}

static double chord_distance(wcut_vec3 p, wcut_vec3 a, wcut_vec3 side) {
    const wcut_vec3 to = vec3_sub(p, a);
    const double square = vec3_dot(side, side);
    const double t = square > 0 ? clamp(vec3_dot(to, side) / square, 0, 1) : 0;
    return vec3_length(vec3_add_scaled(to, -t, side));
}

/* no point of the piece is closer */
static double capsule_distance(const piece *q, int degree, wcut_vec3 p) {
    const wcut_vec3 a = curve_foot_space(&q->at[0]), side = vec3_sub(curve_foot_space(&q->at[degree]), a);
    double off = 0;
    for (int i = 1; i < degree; i++) off = fmax(off, chord_distance(curve_foot_space(&q->at[i]), a, side));
    return chord_distance(p, a, side) - off;
}

static void curve_foot_offer(search *s, double u, wcut_vec3 point) {
    const double distance = vec3_distance(point, s->p);
    if (distance < s->best.distance) s->best.u = u, s->best.point = point, s->best.distance = distance;
}

/* Newton's method for (C - p) . C' = 0 within [low, high], as long as it goes down */
static void curve_foot_descend(search *s, double low, double high, double u) {
    wcut_vec3 d[3];
    double min = INFINITY;
    for (int step = 0; step < STEPS_MAX; step++) {
        wcut_curve_eval(s->f->curve, u, 2, d);
        const wcut_vec3 off = vec3_sub(d[0], s->p);
        const double distance = vec3_length(off);
        curve_foot_offer(s, u, d[0]);
        if (!(distance < min)) return;
        min = distance;
        const double slope = vec3_dot(off, d[1]), plain = vec3_dot(d[1], d[1]), bend = plain + vec3_dot(off, d[2]);
        const double by = bend > 0.1 * plain ? bend : plain;
        if (!(by > 0)) return;
        const double next = clamp(u - slope / by, low, high);
        if (next == u) return;
        u = next;
    }
}

static void curve_foot_halve(const piece *q, int degree, piece half[2]) {
    wcut_homogeneous line[WCUT_BASIS_SIZE];
    for (int k = 0; k <= degree; k++) line[k] = q->at[k];
    const double middle = (q->u0 + q->u1) / 2;
    half[0].u0 = q->u0, half[1].u1 = q->u1, half[0].u1 = half[1].u0 = middle;
    for (int k = 0; k <= degree; k++) {
        half[0].at[k] = line[0];
        half[1].at[degree - k] = line[degree - k];
        for (int i = 0; i < degree - k; i++) {
            const wcut_homogeneous a = line[i], b = line[i + 1];
            line[i] = (wcut_homogeneous){(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2, (a.w + b.w) / 2};
        }
    }
}

/* is the piece no closer than what is known, all but equal? */
static bool curve_foot_is_excluded(search *s, double bound) {
    if (bound < s->best.distance - s->same) return false;
    s->lowest = fmin(s->lowest, bound);
    return true;
}

static void search_piece(search *s, const piece *q, double bound, int depth) {
    const int degree = s->f->curve->degree;
    if (curve_foot_is_excluded(s, bound)) return;
    if (s->halvings >= HALVINGS_MAX || depth == DEPTH_MAX) {
        s->lowest = fmin(s->lowest, bound);
        return;
    }
    if (++s->halvings % PATIENCE == 0) s->same *= 10; /* proof is long in coming: a tie */
    piece half[2] = {0};
    curve_foot_halve(q, degree, half);
    curve_foot_offer(s, half[0].u1, curve_foot_space(&half[1].at[0]));
    if (depth < 3) curve_foot_descend(s, q->u0, q->u1, (q->u0 + q->u1) / 2);
    const double near[2] = {fmax(bound, capsule_distance(&half[0], degree, s->p)),
                            fmax(bound, capsule_distance(&half[1], degree, s->p))};
    const int first = near[1] < near[0];
    search_piece(s, &half[first], near[first], depth + 1);
    search_piece(s, &half[1 - first], near[1 - first], depth + 1);
}

static void curve_foot_search_tree(search *s, int node) {
    const finder *f = s->f;
    if (curve_foot_is_excluded(s, curve_foot_box_distance(f, node, s->p))) return;
    if (node >= f->leaves - 1) {
        const piece *q = &f->piece[node - f->leaves + 1];
        search_piece(s, q, capsule_distance(q, f->curve->degree, s->p), 0);
        return;
    }
    const int first = 2 * node + 1 +
                      (curve_foot_box_distance(f, 2 * node + 2, s->p) < curve_foot_box_distance(f, 2 * node + 1, s->p));
    curve_foot_search_tree(s, first);
    curve_foot_search_tree(s, 4 * node + 3 - first);
}

static void curve_foot_locate(const finder *f, wcut_vec3 p, wcut_curve_foot *foot) {
    search s = {.f = f, .p = p, .best = {.distance = INFINITY}, .lowest = INFINITY};
    const double same = s.same = SAME * (f->size + vec3_length(p));
    double first, last;
    wcut_curve_domain(f->curve, &first, &last);
    curve_foot_search_tree(&s, 0);
    curve_foot_descend(&s, first, last, s.best.u);
    const double proven = fmax(0, s.lowest);
    s.best.gap = s.best.distance - proven > 4 * same ? s.best.distance - proven : 0;
    wcut_vec3 d[2];
    wcut_curve_eval(f->curve, s.best.u, 1, d);
    const double ahead = vec3_dot(vec3_sub(p, s.best.point), vec3_unit(d[1]));
    s.best.beyond = (s.best.u <= first && ahead < -1e-9 * f->size) || (s.best.u >= last && ahead > 1e-9 * f->size);
    *foot = s.best;
}

wcut_status wcut_curve_locate(const wcut_curve *curve, int count, const wcut_vec3 *query, int threads,
                              wcut_curve_foot *foot) {
    if (!curve || count < 0 || threads < 1 || (count > 0 && (!query || !foot))) return WCUT_BAD_ARGUMENT;
    for (int k = 0; k < count; k++)
        if (!(vec3_length(query[k]) < FAR)) return WCUT_BAD_ARGUMENT;
    finder f;
    const wcut_status status = finder_build(curve, &f);
    if (status != WCUT_OK) return status;
#pragma omp parallel for schedule(dynamic, 64) num_threads(wcut_threads(threads))
    for (int k = 0; k < count; k++) curve_foot_locate(&f, query[k], &foot[k]);
    finder_clear(&f);
    return WCUT_OK;
}
