/* Quick feet: queries are led to their spans by linear models, gathered span by span, and solved side by side there: a
   Newton step on the span's polynomial and another on its second-order model where that ends. What is not found within
   its span is followed one by one, across spans and along the border. */
#include "surface/newton_foot.h"

#include "base/numbers.h"
#include "base/vec3.h"
#include "base/wide.h"

enum {
    ORDER = WCUT_SPAN_ORDER,
    MAX = WCUT_NEWTON_FOOT_BATCH,
    WALK = 64,
    JUMP = 16,
    ROUNDS = 3,
    STRIDE = 16,
    STEPS = 12
};

/* a foot this far out of its span, in its parameters, is as good as in it: the next span's polynomial agrees */
static const double HAIR = 1e-9;
/* [of a foot's tolerance] a step of the single search this short is the last, its end exact to its square */
static const double LAST = 1e5;

/* ---- places ---- */

static int newton_foot_find(const double *knot, int spans, double x) {
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

/* in a span's own parameter */
static double own(const double *knot, int k, double x) { return (x - knot[k]) / (knot[k + 1] - knot[k]) - 0.5; }

static double back(const double *knot, int k, double s) { return knot[k] + (s + 0.5) * (knot[k + 1] - knot[k]); }

wcut_span_place wcut_span_place_at(const wcut_newton_foot *q, double u, double v) {
    const int column = newton_foot_find(q->u, q->columns, u), row = newton_foot_find(q->v, q->rows, v);
    return (wcut_span_place){column, row, own(q->u, column, u), own(q->v, row, v)};
}

/* by how many spans to go */
static inline int spans_away(float x) {
    const float max = JUMP, y = x > -max ? x < max ? x : max : -max;
    return (int)(y + (max + 0.5F)) - JUMP;
}

static inline int within(int k, int count) { return k < 0 ? 0 : k < count ? k : count - 1; }

/* one step: where the span at hand sees a query, in parameters about its middle */
static inline void newton_foot_look(const wcut_span_guide *g, const float p[3], float *s, float *t) {
    const float x = p[0] - g->middle[0], y = p[1] - g->middle[1], z = p[2] - g->middle[2];
    *s = g->to_s[0] * x + g->to_s[1] * y + g->to_s[2] * z;
    *t = g->to_t[0] * x + g->to_t[1] * y + g->to_t[2] * z;
}

wcut_span_place wcut_newton_foot_walk(const wcut_newton_foot *q, wcut_vec3 query, wcut_span_place from) {
    const float p[3] = {(float)(query.x - q->centre.x), (float)(query.y - q->centre.y), (float)(query.z - q->centre.z)};
    int column = from.column, row = from.row, before_column = -1, before_row = -1;
    float s = 0, t = 0;
    newton_foot_look(&q->guide[row * q->columns + column], p, &s, &t);
    for (int step = 0; step < WALK; step++) {
        /* computed even where it leads nowhere: a branch here would often be mispredicted */
        const int next_column = within(column + spans_away(s), q->columns);
        const int next_row = within(row + spans_away(t), q->rows);
        if (step > 0 && next_column == column && next_row == row) break;
        if (next_column == before_column && next_row == before_row) break; /* each of two spans sees it in the other */
        before_column = column, before_row = row;
        column = next_column, row = next_row;
        newton_foot_look(&q->guide[row * q->columns + column], p, &s, &t);
    }
    /* what is no number starts from the edge, too */
    return (wcut_span_place){column, row, s > -0.5F ? s < 0.5F ? (double)s : 0.5 : -0.5,
                             t > -0.5F ? t < 0.5F ? (double)t : 0.5 : -0.5};
}

/* ---- many queries in one span ---- */

/* S, S_s, S_t, S_ss, S_st, S_tt in the span's own parameters */
typedef struct jet {
    wcut_vec3 at, s, t, ss, st, tt;
} jet;

WCUT_INLINE wcut_vec3 horner(double x, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c, wcut_vec3 d) {
    return vec3_add_scaled(a, x, vec3_add_scaled(b, x, vec3_add_scaled(c, x, d)));
}

/* a + x b + x^2 c */
WCUT_INLINE wcut_vec3 horner3(double x, wcut_vec3 a, wcut_vec3 b, wcut_vec3 c) {
    return vec3_add_scaled(a, x, vec3_add_scaled(b, x, c));
}

/* a row's cubic of s and its first two derivatives */
typedef struct row {
    wcut_vec3 at, s, ss;
} row;

WCUT_INLINE row row_at(const wcut_vec3 c[ORDER], double s) {
    const wcut_vec3 two = vec3_scale(2, c[2]), three = vec3_scale(3, c[3]);
    return (row){horner(s, c[0], c[1], c[2], c[3]), horner3(s, c[1], two, three), vec3_add_scaled(two, 2 * s, three)};
}

WCUT_INLINE jet jet_at(const wcut_span *of, double s, double t) {
    const row a = row_at(of->power[0], s), b = row_at(of->power[1], s), c = row_at(of->power[2], s),
              d = row_at(of->power[3], s);
    const wcut_vec3 two = vec3_scale(2, c.at), three = vec3_scale(3, d.at);
    return (jet){.at = horner(t, a.at, b.at, c.at, d.at),
                 .s = horner(t, a.s, b.s, c.s, d.s),
                 .t = horner3(t, b.at, two, three),
                 .ss = horner(t, a.ss, b.ss, c.ss, d.ss),
                 .st = horner3(t, b.s, vec3_scale(2, c.s), vec3_scale(3, d.s)),
                 .tt = vec3_add_scaled(two, 2 * t, three)};
}

/* the second-order model a step further: the point and both tangents */
WCUT_INLINE jet jet_moved(jet f, double ds, double dt) {
    const wcut_vec3 half_s = vec3_add_scaled(vec3_add_scaled(f.s, ds / 2, f.ss), dt, f.st);
    const wcut_vec3 half_t = vec3_add_scaled(f.t, dt / 2, f.tt);
    return (jet){.at = vec3_add_scaled(vec3_add_scaled(f.at, ds, half_s), dt, half_t),
                 .s = vec3_add_scaled(vec3_add_scaled(f.s, ds, f.ss), dt, f.st),
                 .t = vec3_add_scaled(vec3_add_scaled(f.t, ds, f.st), dt, f.tt)};
}

/* what a lane's round ended with */
#define LEFT 0.0  /* not found in this span, or not proven */
#define FOUND 1.0 /* and proven */
#define AGAIN 2.0 /* not exact enough yet */

/* queries side by side */
typedef struct lanes {
    double px[MAX], py[MAX], pz[MAX], s[MAX], t[MAX]; /* parameters are moved */
    double x[MAX], y[MAX], z[MAX], distance[MAX], height[MAX], end[MAX];
    int index[MAX];
} lanes;

/* A round for lanes first .. end. A second step e2 after e1 leaves e2^2 / e1; what third derivatives change along e1 is
   e1^2 (|r| + e1) turn beside the least eigenvalue of the Hessian, itself above area / (ss + tt). */
WCUT_WIDE static void newton_foot_solve(const wcut_span *restrict of, double tolerance, int first, int last,
                                        lanes *restrict l) {
    /* [1/mm] the tolerance as a factor; the span's own bounds */
    const double shortest = of->speed / tolerance, bends = of->turn * shortest, speed = of->speed;
    const double radius = of->radius;
#pragma omp simd
    for (int k = first; k < last; k++) {
        const wcut_vec3 p = vec3(l->px[k], l->py[k], l->pz[k]);

        /* the Hessian and the gradient of half the squared distance */
        const jet f = jet_at(of, l->s[k], l->t[k]);
        const wcut_vec3 r = vec3_sub(p, f.at);
        const double ss = vec3_dot(f.s, f.s) - vec3_dot(r, f.ss), tt = vec3_dot(f.t, f.t) - vec3_dot(r, f.tt);
        const double st = vec3_dot(f.s, f.t) - vec3_dot(r, f.st), area = ss * tt - st * st, by = 1 / area;
        const double gs = vec3_dot(r, f.s), gt = vec3_dot(r, f.t);

        /* first step, with the second-order model there */
        const double s1 = (gs * tt - gt * st) * by, t1 = (gt * ss - gs * st) * by;
        const jet m = jet_moved(f, s1, t1);
        const wcut_vec3 q = vec3_sub(p, m.at);
        const double hs = vec3_dot(q, m.s), ht = vec3_dot(q, m.t);

        /* second step with the same Hessian */
        const double s2 = (hs * tt - ht * st) * by, t2 = (ht * ss - hs * st) * by;
        const wcut_vec3 at = vec3_add_scaled(vec3_add_scaled(m.at, s2, m.s), t2, m.t);
        const wcut_vec3 o = vec3_sub(p, at), normal = vec3_cross(m.s, m.t);
        const double distance = sqrt(vec3_dot(o, o)), e1 = fabs(s1) + fabs(t1), e2 = fabs(s2) + fabs(t2);
        const double s = l->s[k] + (s1 + s2), t = l->t[k] + (t1 + t2);

        /* the foot */
        l->s[k] = s, l->t[k] = t;
        l->x[k] = at.x, l->y[k] = at.y, l->z[k] = at.z;
        l->distance[k] = distance;
        l->height[k] = vec3_dot(o, normal) / sqrt(vec3_dot(normal, normal));

        /* the verdict without branches: a condition is 0 or 1 */
        const double convex = (ss > 0 ? 1.0 : 0.0) * (area > 1e-9 * ss * tt ? 1.0 : 0.0);
        const double exact = (e2 * e2 * shortest <= e1 ? 1.0 : 0.0) *
                             (bends * e1 * e1 * (distance + speed * e1) * (ss + tt) <= area ? 1.0 : 0.0);
        const double inside = (fabs(s) <= 0.5 + HAIR ? 1.0 : 0.0) * (fabs(t) <= 0.5 + HAIR ? 1.0 : 0.0);
        l->end[k] = convex * inside * (AGAIN - exact * (AGAIN - (distance < radius ? FOUND : LEFT)));
    }
}

/* ---- a block of queries ---- */

enum { SIDE = 32, CELLS = SIDE * SIDE };

/* spans that are neighbours have cells of their own */
static inline int newton_foot_cell_of(const wcut_span_place *p) { return p->row % SIDE * SIDE + p->column % SIDE; }

/* the queries' order by cells, stable */
static void sort_by_span(int count, const wcut_span_place *place, int *order) {
    int start[CELLS + 1] = {0};
    for (int k = 0; k < count; k++) start[newton_foot_cell_of(&place[k]) + 1]++;
    for (int c = 0; c < CELLS; c++) start[c + 1] += start[c];
    for (int k = 0; k < count; k++) order[start[newton_foot_cell_of(&place[k])]++] = k;
}

/* hand out what was found, gather at the front what needs another round; how many */
static int newton_foot_collect(const wcut_newton_foot *q, int first, int last, lanes *l, wcut_foot *foot,
                               unsigned char *done, wcut_span_place *start) {
    int more = first;
    for (int k = first; k < last; k++) {
        /* a foot is handed out in parameters of the surface */
        const int to = l->index[k];
        wcut_span_place *at = &start[to];
        if (l->end[k] == FOUND) {
            foot[to] = (wcut_foot){.u = back(q->u, at->column, l->s[k]),
                                   .v = back(q->v, at->row, l->t[k]),
                                   .point = {l->x[k], l->y[k], l->z[k]},
                                   .distance = l->distance[k],
                                   .height = l->height[k]};
            /* on the border more is to be said than that it is stationary */
            done[to] = foot[to].u > q->u[0] && foot[to].u < q->u[q->columns] && foot[to].v > q->v[0] &&
                       foot[to].v < q->v[q->rows];
        } else if (l->end[k] == AGAIN) {
            /* the others move to the front, for another round */
            l->px[more] = l->px[k], l->py[more] = l->py[k], l->pz[more] = l->pz[k];
            l->s[more] = l->s[k], l->t[more] = l->t[k], l->index[more] = to;
            more++;
        }
    }

    return more;
}

void wcut_newton_foot_batch(const wcut_newton_foot *newton, int count, const wcut_vec3 *query, wcut_span_place place,
                            const wcut_query_prefetch *ahead, wcut_foot *foot, unsigned char *done,
                            wcut_span_place *start) {
    const wcut_newton_foot *q = newton;
    lanes l;

    /* lead each query to its span by the linear models */
    for (int k = 0; k < count;
         k++) { /* from a neighbour, but not each from the last: several are under way at a time */
        if (ahead) wcut_query_prefetch_next(ahead, k);
        start[k] = wcut_newton_foot_walk(q, query[k], place);
        if (k % STRIDE == 0) place = start[k];
        done[k] = 0;
    }

    /* sort by span, so that the lanes of a span lie together */
    sort_by_span(count, start, l.index);
    for (int k = 0; k < count; k++) {
        const int from = l.index[k];
        l.px[k] = query[from].x, l.py[k] = query[from].y, l.pz[k] = query[from].z;
        l.s[k] = start[from].s, l.t[k] = start[from].t;
    }

    /* each span: rounds on the lanes that are left */
    for (int first = 0, last; first < count; first = last) {
        const wcut_span_place *of = &start[l.index[first]];
        for (last = first + 1; last < count; last++) {
            const wcut_span_place *other = &start[l.index[last]];
            if (other->column != of->column || other->row != of->row) break;
        }
        const wcut_span *span = &q->span[of->row * q->columns + of->column];
        for (int round = 0, end = last; round < ROUNDS && end > first; round++) {
            newton_foot_solve(span, q->tolerance, first, end, &l);
            end = newton_foot_collect(q, first, end, &l, foot, done, start);
        }
    }
}

/* ---- one query ---- */

/* one step of Newton's method, held where the border is in the way; false where the squared distance is not convex */
static bool newton_foot_step_of(const jet *f, wcut_vec3 r, bool held_s, bool held_t, double *ds, double *dt) {
    const double gs = held_s ? 0 : vec3_dot(r, f->s), gt = held_t ? 0 : vec3_dot(r, f->t);
    const double ss = vec3_dot(f->s, f->s) - vec3_dot(r, f->ss), tt = vec3_dot(f->t, f->t) - vec3_dot(r, f->tt);
    const double st = held_s || held_t ? 0 : vec3_dot(f->s, f->t) - vec3_dot(r, f->st), area = ss * tt - st * st;
    if (!((held_s || ss > 0) && (held_t || tt > 0))) return false;
    if (!held_s && !held_t && !(area > 1e-9 * ss * tt)) return false;
    *ds = held_s ? 0 : held_t ? gs / ss : (gs * tt - gt * st) / area;
    *dt = held_t ? 0 : held_s ? gt / tt : (gt * ss - gs * st) / area;
    return true;
}

/* a parameter out of its span: the span that it is in, or the border; false where that is too far away */
static bool newton_foot_cross(const double *knot, int spans, int *at, double *s) {
    if (fabs(*s) <= 0.5 + HAIR) return true;
    const double x = back(knot, *at, *s);
    int k = *at;
    for (int step = 0; step < WALK; step++) {
        if (x < knot[k] && k > 0)
            k--;
        else if (x > knot[k + 1] && k < spans - 1)
            k++;
        else {
            *at = k;
            *s = clamp(own(knot, k, x), -0.5, 0.5);
            return true;
        }
    }
    return false;
}

/* the parameter as far as the surface goes */
static double kept(int k, int spans, double s) {
    return k == 0 && s < -0.5 ? -0.5 : k == spans - 1 && s > 0.5 ? 0.5 : s;
}

/* at the border, and led out of it by the gradient */
static bool is_held(int k, int spans, double s, double along) {
    return (k == 0 && s <= -0.5 && along < 0) || (k == spans - 1 && s >= 0.5 && along > 0);
}

/* the end of the last step, if that is proven */
static bool newton_foot_finish(const wcut_newton_foot *q, const wcut_span_place *at, wcut_vec3 p, const jet *f,
                               double s, double t, wcut_foot_jet *spot) {
    const jet m = jet_moved(*f, s - at->s, t - at->t);
    const double radius = q->span[at->row * q->columns + at->column].radius;
    if (fabs(s) > 0.5 + HAIR || fabs(t) > 0.5 + HAIR || vec3_distance(p, m.at) >= radius) return false;
    const double wide = q->u[at->column + 1] - q->u[at->column], high = q->v[at->row + 1] - q->v[at->row];
    *spot = (wcut_foot_jet){clamp(back(q->u, at->column, s), q->u[0], q->u[q->columns]),
                            clamp(back(q->v, at->row, t), q->v[0], q->v[q->rows]), m.at, vec3_scale(1 / wide, m.s),
                            vec3_scale(1 / high, m.t)};
    return true;
}

bool wcut_newton_foot_slide(const wcut_newton_foot *newton, wcut_vec3 p, wcut_span_place place, wcut_foot_jet *spot) {
    const wcut_newton_foot *q = newton;

    /* one query alone, across spans */
    for (int step = 0; step < STEPS; step++) {
        const wcut_span *of = &q->span[place.row * q->columns + place.column];
        const jet f = jet_at(of, place.s, place.t);

        /* Newton's step, held where the border stops it */
        const wcut_vec3 r = vec3_sub(p, f.at);
        double ds, dt;
        if (!newton_foot_step_of(&f, r, is_held(place.column, q->columns, place.s, vec3_dot(r, f.s)),
                                 is_held(place.row, q->rows, place.t, vec3_dot(r, f.t)), &ds, &dt))
            return false;

        /* clamped to the surface; a step below the tolerance ends the walk */
        const double s = kept(place.column, q->columns, place.s + ds), t = kept(place.row, q->rows, place.t + dt);
        const double cut = fabs(place.s + ds - s) + fabs(place.t + dt - t); /* the border changes the other direction */
        if (fabs(ds) * vec3_length(f.s) + fabs(dt) * vec3_length(f.t) <= LAST * q->tolerance &&
            cut * of->speed <= q->tolerance)
            return newton_foot_finish(q, &place, p, &f, s, t, spot);

        /* into the next span; at the border of the surface there is none */
        place.s = s, place.t = t;
        if (!newton_foot_cross(q->u, q->columns, &place.column, &place.s) ||
            !newton_foot_cross(q->v, q->rows, &place.row, &place.t))
            return false;
    }

    return false;
}
