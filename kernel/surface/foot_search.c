/* One query's closest point: branch and bound over the tree of pieces, Newton's method where that is convex.

   A piece is excluded if its bound says it is further than the best point so far. Where the squared distance is convex
   over a piece, a stationary point in it is the piece's closest, so one run of Newton's method settles it; if the best
   point so far lies in it, none is needed. A piece of the tree that is neither is halved until it is. */
#include "surface/foot_search.h"

#include "base/numbers.h"
#include "base/vec3.h"

enum {
    STEPS_MAX = 50,      /* of Newton's method */
    HALVINGS_MAX = 8000, /* of pieces below the tree; used up only where a continuum of points ties */
    PATIENCE = 500,      /* halvings after which ten times the distance counts as equal */
    DEPTH = 192          /* both directions can be halved some 60 times; a stack holds one sibling a level */
};

static const double SAME = 1e-13;  /* of the size: distances nearer than this are equal */
static const double LAST = 1e-8;   /* of the size: a step this short is the last, its end exact to its square */
static const double BEYOND = 1e-9; /* of the size: a query this far outside the border is beyond it */

/* a point of the surface, and whether |S - p| is stationary there within the domain */
typedef struct candidate {
    double u, v, distance;
    wcut_vec3 point, along_u, along_v; /* S, S_u, S_v; the last two only where stationary */
    bool stationary;
} candidate;

/* derivatives at a candidate: half the gradient and the Hessian of |S - p|^2 */
typedef struct slope {
    wcut_vec3 ders[9];
    double gu, gv, uu, uv, vv;
    double plain_uu, plain_uv, plain_vv; /* without curvature: never indefinite (Gauss, Newton) */
} slope;

static void find_slope(const wcut_surface *s, wcut_vec3 p, double u, double v, slope *f) {
    wcut_surface_eval(s, u, v, 2, f->ders);
    const wcut_vec3 r = vec3_sub(f->ders[0], p), su = f->ders[3], sv = f->ders[1];
    f->gu = vec3_dot(r, su), f->gv = vec3_dot(r, sv);
    f->plain_uu = vec3_dot(su, su), f->plain_uv = vec3_dot(su, sv), f->plain_vv = vec3_dot(sv, sv);
    f->uu = f->plain_uu + vec3_dot(r, f->ders[6]);
    f->uv = f->plain_uv + vec3_dot(r, f->ders[4]);
    f->vv = f->plain_vv + vec3_dot(r, f->ders[2]);
}

/* at a bound that the descent direction leads out of */
static bool foot_search_is_held(double at, double low, double high, double gradient) {
    return (at <= low && gradient > 0) || (at >= high && gradient < 0);
}

static double divided(double gradient, double hessian, double plain) {
    const double by = hessian > 0 ? hessian : plain;
    return by > 0 ? -gradient / by : 0;
}

static void newton_step(const slope *f, bool held_u, bool held_v, double *du, double *dv) {
    *du = held_u ? 0 : divided(f->gu, f->uu, f->plain_uu);
    *dv = held_v ? 0 : divided(f->gv, f->vv, f->plain_vv);
    if (held_u || held_v) return;
    double uu = f->uu, uv = f->uv, vv = f->vv, area = uu * vv - uv * uv;
    if (!(uu > 0 && area > 1e-12 * uu * vv)) {
        uu = f->plain_uu, uv = f->plain_uv, vv = f->plain_vv;
        area = uu * vv - uv * uv;
        if (!(area > 1e-12 * uu * vv)) return; /* no area: each direction by itself */
    }
    *du = (uv * f->gv - vv * f->gu) / area;
    *dv = (uv * f->gu - uu * f->gv) / area;
}

/* S at a short step away, to second order */
static wcut_vec3 moved(const slope *f, double du, double dv) {
    wcut_vec3 x = vec3_add_scaled(vec3_add_scaled(f->ders[0], du, f->ders[3]), dv, f->ders[1]);
    x = vec3_add_scaled(vec3_add_scaled(x, du * du / 2, f->ders[6]), du * dv, f->ders[4]);
    return vec3_add_scaled(x, dv * dv / 2, f->ders[2]);
}

/* walk down |S - p| from (u, v) within a rectangle {u0, u1, v0, v1} */
static candidate descend(const wcut_projection *m, wcut_vec3 p, const double box[4], double u, double v) {
    /* gradient and Hessian of half the squared distance */
    slope f;
    find_slope(m->surface, p, u, v, &f);
    double distance = vec3_distance(f.ders[0], p);

    /* damped Newton steps; a coordinate at its bound that would go beyond is held */
    bool converged = false;
    for (int step = 0; step < STEPS_MAX; step++) {
        const bool held_u = foot_search_is_held(u, box[0], box[1], f.gu),
                   held_v = foot_search_is_held(v, box[2], box[3], f.gv);
        double du, dv;
        newton_step(&f, held_u, held_v, &du, &dv);
        du = clamp(u + du, box[0], box[1]) - u, dv = clamp(v + dv, box[2], box[3]) - v;

        /* a step below the tolerance is taken by the second-order model, without another evaluation */
        const double length = fabs(du) * sqrt(f.plain_uu) + fabs(dv) * sqrt(f.plain_vv);
        if (length <= LAST * m->size) {
            f.ders[0] = moved(&f, du, dv);
            f.ders[3] = vec3_add_scaled(vec3_add_scaled(f.ders[3], du, f.ders[6]), dv, f.ders[4]);
            f.ders[1] = vec3_add_scaled(vec3_add_scaled(f.ders[1], du, f.ders[4]), dv, f.ders[2]);
            u = clamp(u + du, box[0], box[1]), v = clamp(v + dv, box[2], box[3]);
            distance = vec3_distance(f.ders[0], p);
            converged = true;
            break;
        }

        /* a quarter of the step until the distance falls */
        slope next;
        double share = 1, new_distance;
        for (;; share /= 4) { /* a full step goes down but where the curvature of the distance is not yet felt */
            find_slope(m->surface, p, u + share * du, v + share * dv, &next);
            new_distance = vec3_distance(next.ders[0], p);
            if (new_distance <= distance || share < 1e-6) break;
        }

        /* no way down: the point is not stationary */
        if (new_distance > distance) break;
        u = clamp(u + share * du, box[0], box[1]), v = clamp(v + share * dv, box[2], box[3]);
        distance = new_distance;
        f = next;
    }
    /* held by the rectangle's own bound it is stationary there, but not on the surface */
    const bool inner = (u > box[0] || u <= m->first[0]) && (u < box[1] || u >= m->last[0]) &&
                       (v > box[2] || v <= m->first[1]) && (v < box[3] || v >= m->last[1]);
    return (candidate){.u = u,
                       .v = v,
                       .distance = distance,
                       .point = f.ders[0],
                       .along_u = f.ders[3],
                       .along_v = f.ders[1],
                       .stationary = converged && inner};
}

/* the state of one search */
typedef struct search {
    const wcut_projection *m;
    wcut_vec3 p;
    candidate best;
    double same;   /* [mm] what counts as equal; grows where proof is long in coming */
    double lowest; /* of the bounds of pieces left alone */
    int halvings;
} search;

static void offer(search *s, candidate c) {
    if (c.distance < s->best.distance || (c.stationary && !s->best.stationary && c.distance <= s->best.distance))
        s->best = c;
}

/* is the piece no closer than what is known, all but equal? */
static bool is_excluded(search *s, double bound) {
    if (bound < s->best.distance - s->same) return false;
    s->lowest = fmin(s->lowest, bound);
    return true;
}

static bool holds_best(const search *s, const wcut_patch *q) {
    return s->best.stationary && s->best.u >= q->u0 && s->best.u <= q->u1 && s->best.v >= q->v0 && s->best.v <= q->v1;
}

/* start where the best point is nearest, if that is known, else where the parallelogram is */
static void descend_in(search *s, const wcut_patch *q, double at_s, double at_t) {
    const double box[4] = {q->u0, q->u1, q->v0, q->v1};
    const double u = s->best.stationary ? s->best.u : q->u0 + (at_s + 0.5) * (q->u1 - q->u0);
    const double v = s->best.stationary ? s->best.v : q->v0 + (at_t + 0.5) * (q->v1 - q->v0);
    offer(s, descend(s->m, s->p, box, clamp(u, box[0], box[1]), clamp(v, box[2], box[3])));
}

/* a piece of the tree where the distance is not convex: halve it until it is, or excluded */
static void search_below(search *s, const wcut_patch *leaf, double leaf_s, double leaf_t) {
    struct {
        wcut_patch patch;
        double bound, s, t;
    } stack[DEPTH];
    int depth = 1;

    /* depth first from the leaf itself */
    stack[0].patch = *leaf;
    stack[0].bound = 0, stack[0].s = leaf_s, stack[0].t = leaf_t;
    descend_in(s, leaf, leaf_s, leaf_t);
    while (depth > 0) {
        /* excluded by its bound, or solved where it is convex */
        const wcut_patch q = stack[--depth].patch;
        const double at_s = stack[depth].s, at_t = stack[depth].t;
        if (is_excluded(s, stack[depth].bound)) continue;
        double min;
        if (wcut_patch_is_convex(&q, s->p, &min)) {
            if (!holds_best(s, &q)) descend_in(s, &q, at_s, at_t);
            continue;
        }

        /* else halved, unless the effort is spent: then the bound says how far the answer may be off */
        const double bound = fmax(min, stack[depth].bound);
        if (is_excluded(s, bound)) continue;
        if (s->halvings == HALVINGS_MAX || depth + 2 > DEPTH) {
            s->lowest = fmin(s->lowest, bound);
            continue;
        }
        if (++s->halvings % PATIENCE == 0) s->same *= 10;

        /* middles of both halves are feet too; bounds of both */
        wcut_patch half[2];
        wcut_patch_halve(s->m->surface, &q, half);
        double near[2], on_s[2] = {0, 0}, on_t[2] = {0, 0};
        for (int k = 0; k < 2; k++) {
            const double u = (half[k].u0 + half[k].u1) / 2, v = (half[k].v0 + half[k].v1) / 2;
            offer(s, (candidate){
                         .u = u, .v = v, .distance = vec3_distance(half[k].centre, s->p), .point = half[k].centre});
            near[k] = fmax(bound, wcut_patch_distance(&half[k], s->p, s->best.distance, &on_s[k], &on_t[k]));
        }
        for (int n = 0; n < 2; n++) { /* the nearer one is pushed last, and taken first */
            const int k = (near[0] < near[1]) == (n == 0);
            if (is_excluded(s, near[k])) continue;
            stack[depth].patch = half[k];
            stack[depth].bound = near[k], stack[depth].s = on_s[k], stack[depth].t = on_t[k];
            depth++;
        }
    }
}

static void search_tree(search *s) {
    const wcut_patch_node *tree = s->m->node;
    struct {
        int node;
        double bound, s, t;
    } stack[DEPTH];
    int depth = 1;
    stack[0].node = 0;
    stack[0].bound = wcut_patch_distance(&tree[0].patch, s->p, INFINITY, &stack[0].s, &stack[0].t);

    /* depth first, the nearer child first; nodes farther than the best foot are left out */
    while (depth > 0) {
        depth--;
        if (is_excluded(s, stack[depth].bound)) continue;

        /* a convex piece has one minimum: descend to it */
        const wcut_patch_node *node = &tree[stack[depth].node];
        double min;
        if (wcut_patch_is_convex(&node->patch, s->p, &min)) {
            if (!holds_best(s, &node->patch)) descend_in(s, &node->patch, stack[depth].s, stack[depth].t);
            continue;
        }
        if (is_excluded(s, min)) continue;

        /* a leaf that is not convex is halved further */
        if (!node->child) {
            search_below(s, &node->patch, stack[depth].s, stack[depth].t);
            continue;
        }

        /* both children; the nearer one is pushed last */
        double near[2], on_s[2] = {0, 0}, on_t[2] = {0, 0};
        for (int k = 0; k < 2; k++)
            near[k] = wcut_patch_distance(&tree[node->child + k].patch, s->p, s->best.distance, &on_s[k], &on_t[k]);
        for (int n = 0; n < 2; n++) {
            const int k = (near[0] < near[1]) == (n == 0);
            if (is_excluded(s, near[k])) continue;
            stack[depth].node = node->child + k;
            stack[depth].bound = near[k], stack[depth].s = on_s[k], stack[depth].t = on_t[k];
            depth++;
        }
    }
}

/* the unit normal at a foot; where the derivatives span no plane that of a point a little inwards */
static wcut_vec3 foot_search_normal_at(const wcut_projection *m, double u, double v, wcut_vec3 along_u,
                                       wcut_vec3 along_v) {
    wcut_vec3 n = vec3_cross(along_u, along_v), inner[4];
    const double width = (m->last[0] - m->first[0]) * (m->last[1] - m->first[1]);
    for (double share = 1e-6; share < 0.1; share *= 10) {
        const double area = vec3_length(n);
        if (area * width > 1e-12 * m->size * m->size && area > 1e-9 * vec3_length(along_u) * vec3_length(along_v))
            break;
        const double mid_u = (m->first[0] + m->last[0]) / 2, mid_v = (m->first[1] + m->last[1]) / 2;
        wcut_surface_eval(m->surface, u + share * (mid_u - u), v + share * (mid_v - v), 1, inner);
        along_u = inner[2], along_v = inner[1];
        n = vec3_cross(along_u, along_v);
    }
    return vec3_unit(n);
}

/* how far the query lies outwards of a bound of one direction, along the surface; a pole is no border */
static double outwards(const wcut_projection *m, double at, double first, double last, wcut_vec3 r, wcut_vec3 tangent) {
    if (vec3_length(tangent) * (last - first) <= BEYOND * m->size) return 0;
    const double off = vec3_dot(r, vec3_unit(tangent));
    return at <= first ? -off : at >= last ? off : 0;
}

void wcut_foot_describe(const wcut_projection *m, wcut_vec3 p, const wcut_foot_jet *at, wcut_foot *foot) {
    const wcut_vec3 r = vec3_sub(p, at->point);
    const double off_u = outwards(m, at->u, m->first[0], m->last[0], r, at->along_u);
    const double off_v = outwards(m, at->v, m->first[1], m->last[1], r, at->along_v);
    *foot = (wcut_foot){.u = at->u, .v = at->v, .point = at->point, .distance = vec3_length(r)};
    foot->height = vec3_dot(r, foot_search_normal_at(m, at->u, at->v, at->along_u, at->along_v));
    foot->beyond = fmax(off_u, off_v) > BEYOND * m->size;
}

void wcut_foot_search(const wcut_projection *m, wcut_vec3 p, const wcut_foot *near, wcut_foot *foot) {
    /* a foot near by gives a first bound */
    search s = {.m = m, .p = p, .best = {.distance = INFINITY}, .lowest = INFINITY};
    const double same = s.same = SAME * (m->size + vec3_length(p));
    if (near)
        s.best =
            (candidate){.u = near->u, .v = near->v, .distance = vec3_distance(near->point, p), .point = near->point};
    search_tree(&s);
    if (!s.best.stationary) { /* found as a neighbour's foot or as the middle of a piece: go down what is left */
        const double box[4] = {m->first[0], m->last[0], m->first[1], m->last[1]};
        offer(&s, descend(m, p, box, s.best.u, s.best.v));
    }
    if (!s.best.stationary) {
        wcut_vec3 d[4];
        wcut_surface_eval(m->surface, s.best.u, s.best.v, 1, d);
        s.best.along_u = d[2], s.best.along_v = d[1];
    }

    /* the foot's fields, and the gap where the search was ended early */
    const wcut_foot_jet at = {s.best.u, s.best.v, s.best.point, s.best.along_u, s.best.along_v};
    wcut_foot_describe(m, p, &at, foot);
    const double distance = foot->distance = s.best.distance, low = fmax(0, s.lowest);
    foot->gap = distance - low > 2 * same ? distance - low : 0;
}
