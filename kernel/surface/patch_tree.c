/* A binary tree of a surface's pieces, down to where each is flat beside its size.

   Bounds on derivatives come from the control points of the derivatives (a B-spline lies in their hull). Of a rational
   surface S = A / w, seen from a point of the piece with |S| <= r there, the quotient rule solved for its highest term
   gives  |S^(k,l)| <= (|A^(k,l)| + sum C(k,i) C(l,j) |w^(i,j)| |S^(k-i,l-j)|) / w_min  in rising order. */
#include "surface/patch_tree.h"

#include <limits.h>
#include <stddef.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/rational.h"

/* A leaf is this flat: then a query that is nearer than some ten times its size meets a convex problem. */
static const double FLAT = 0.02;

/* what a derivative's control points may have grown by in rounding */
static const double ROUNDED = 1 + 1e-12;

enum { HALVINGS = 6 }; /* a span is halved so often at most: a pole never gets flat */

enum { SPANS_MAX = 16, SIDE = SPANS_MAX + WCUT_DEGREE_MAX, ORDERS = 4 };

typedef struct builder {
    const wcut_surface *surface;
    int spans[2]; /* spans that are not empty, along u and v */
    int *span[2]; /* spans[d]: their index in the knots */
    wcut_patch_node *node;
    int count, room;
} builder;

/* homogeneous control points, or derivatives of them, over a few spans */
typedef struct block {
    int columns, rows;
    int first_u, first_v; /* index of the first one in the surface */
    wcut_homogeneous at[SIDE][SIDE];
} block;

static void take_block(const builder *b, const int range[4], wcut_vec3 c, block *k) {
    const wcut_surface *s = b->surface;
    k->first_u = b->span[0][range[0]] - s->degree_u, k->columns = b->span[0][range[1] - 1] - k->first_u + 1;
    k->first_v = b->span[1][range[2]] - s->degree_v, k->rows = b->span[1][range[3] - 1] - k->first_v + 1;
    for (int j = 0; j < k->rows; j++)
        for (int i = 0; i < k->columns; i++) {
            const ptrdiff_t at = (ptrdiff_t)(k->first_v + j) * s->count_u + k->first_u + i;
            const wcut_vec3 p = vec3_sub(s->control[at], c);
            const double w = s->weights ? s->weights[at] : 1;
            k->at[j][i] = (wcut_homogeneous){w * p.x, w * p.y, w * p.z, w};
        }
}

/* (degree - order + 1) / (knots[i + degree + 1] - knots[i + order]): the factor of the order-th derivative's point i */
static double patch_tree_step_of(int degree, const double *knots, int i, int order) {
    const double wide = knots[i + degree + 1] - knots[i + order];
    return wide > 0 && order <= degree ? (degree - order + 1) / wide : 0;
}

static wcut_homogeneous difference(double step, const wcut_homogeneous *a, const wcut_homogeneous *b) {
    return (wcut_homogeneous){step * (b->x - a->x), step * (b->y - a->y), step * (b->z - a->z), step * (b->w - a->w)};
}

/* the order-th derivative along u of a block that holds the one before, in place */
static void differentiate_u(const wcut_surface *s, int order, block *k) {
    k->columns = k->columns > 1 ? k->columns - 1 : 1;
    for (int i = 0; i < k->columns; i++) {
        const double step = patch_tree_step_of(s->degree_u, s->knots_u, k->first_u + i, order);
        for (int j = 0; j < k->rows; j++) k->at[j][i] = difference(step, &k->at[j][i], &k->at[j][i + (step > 0)]);
    }
}

static void differentiate_v(const wcut_surface *s, int order, block *k) {
    k->rows = k->rows > 1 ? k->rows - 1 : 1;
    for (int j = 0; j < k->rows; j++) {
        const double step = patch_tree_step_of(s->degree_v, s->knots_v, k->first_v + j, order);
        for (int i = 0; i < k->columns; i++) k->at[j][i] = difference(step, &k->at[j][i], &k->at[j + (step > 0)][i]);
    }
}

/* the largest lengths and weights in a block */
static void measure_block(const block *k, double *length, double *weight) {
    double max = 0;
    *weight = 0;
    for (int j = 0; j < k->rows; j++)
        for (int i = 0; i < k->columns; i++) {
            const wcut_homogeneous *h = &k->at[j][i];
            max = fmax(max, h->x * h->x + h->y * h->y + h->z * h->z);
            *weight = fmax(*weight, fabs(h->w));
        }
    *length = sqrt(max) * ROUNDED;
}

/* the smallest weight, and the largest distance from the block's origin */
static void enclose(const block *k, double *weight_min, double *radius) {
    *weight_min = INFINITY, *radius = 0;
    for (int j = 0; j < k->rows; j++)
        for (int i = 0; i < k->columns; i++) {
            const wcut_homogeneous *h = &k->at[j][i];
            *weight_min = fmin(*weight_min, h->w);
            *radius = fmax(*radius, sqrt(h->x * h->x + h->y * h->y + h->z * h->z) / h->w);
        }
}

/* bound[k][l] >= |S^(k,l)| over a range, k + l <= order */
static void patch_tree_bound_derivatives(const builder *b, const int range[4], wcut_vec3 c, int order,
                                         double bound[ORDERS][ORDERS]) {
    static const double binomial[ORDERS][ORDERS] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    double weight[ORDERS][ORDERS], min = 1;

    /* control points of the range, in homogeneous coordinates about c */
    block across, along;
    take_block(b, range, c, &across);
    enclose(&across, &min, &bound[0][0]);

    /* derivatives of the homogeneous surface, bounded by their control points */
    for (int l = 0; l <= order; l++) {
        if (l > 0) differentiate_v(b->surface, l, &across);
        along = across;
        for (int k = 0; k + l <= order; k++) {
            if (k > 0) differentiate_u(b->surface, k, &along);
            if (k + l > 0) measure_block(&along, &bound[k][l], &weight[k][l]);
        }
    }

    /* quotient rule: bounds of the rational derivatives, order by order */
    if (!b->surface->weights) return;
    for (int sum = 1; sum <= order; sum++)
        for (int k = 0; k <= sum; k++) {
            const int l = sum - k;
            for (int i = 0; i <= k; i++)
                for (int j = i == 0; j <= l; j++)
                    bound[k][l] += binomial[k][i] * binomial[l][j] * weight[i][j] * bound[k - i][l - j];
            bound[k][l] /= min;
        }
}

/* a piece without a crease; its third derivatives, if asked for, must be bounded, too */
static void make_patch(const builder *b, const int range[4], bool turns, wcut_patch *p) {
    const wcut_surface *s = b->surface;
    double bound[ORDERS][ORDERS];
    wcut_vec3 c = {0, 0, 0};
    p->u0 = s->knots_u[b->span[0][range[0]]], p->u1 = s->knots_u[b->span[0][range[1] - 1] + 1];
    p->v0 = s->knots_v[b->span[1][range[2]]], p->v1 = s->knots_v[b->span[1][range[3] - 1] + 1];
    wcut_surface_eval(s, (p->u0 + p->u1) / 2, (p->v0 + p->v1) / 2, 0, &c);
    patch_tree_bound_derivatives(b, range, c, turns ? 3 : 2, bound);
    const double u = p->u1 - p->u0, v = p->v1 - p->v0;
    p->bend_uu = bound[2][0] * u * u, p->bend_uv = bound[1][1] * u * v, p->bend_vv = bound[0][2] * v * v;
    p->turn_uuu = turns ? bound[3][0] * u * u * u : INFINITY;
    p->turn_uuv = turns ? bound[2][1] * u * u * v : INFINITY;
    p->turn_uvv = turns ? bound[1][2] * u * v * v : INFINITY;
    p->turn_vvv = turns ? bound[0][3] * v * v * v : INFINITY;
    wcut_patch_fit(s, p);
}

/* the span, not the first of a range, that begins with a knot of at least this multiplicity; the nearest to the middle,
   or -1 */
static int knot_inside(const double *knots, int multiplicity, const int *span, int from, int to) {
    int found = -1;
    for (int k = from + 1; k < to; k++) {
        const int at = span[k];
        if (multiplicity < 1 || knots[at - multiplicity + 1] == knots[at])
            if (found < 0 || 2 * k <= from + to) found = k;
    }
    return found;
}

/* where to divide a range at knots over which `smooth` derivatives are not continuous; false where there is none */
static bool find_knot(const builder *b, const int range[4], int smooth, bool *along_u, int *at) {
    const wcut_surface *s = b->surface;
    *at = knot_inside(s->knots_u, s->degree_u - smooth + 1, b->span[0], range[0], range[1]);
    *along_u = *at >= 0;
    if (!*along_u) *at = knot_inside(s->knots_v, s->degree_v - smooth + 1, b->span[1], range[2], range[3]);
    return *at >= 0;
}

/* two more nodes; 0 where there is no room */
static int add_children(builder *b) {
    if (b->count + 2 > b->room) {
        if (b->room > INT_MAX / 2) return 0;
        const int room = 2 * b->room;
        wcut_patch_node *more = wcut_alloc((size_t)room, sizeof *more);
        if (!more) return 0;
        for (int k = 0; k < b->count; k++) more[k] = b->node[k];
        wcut_free(b->node);
        b->node = more;
        b->room = room;
    }
    b->count += 2;
    return b->count - 2;
}

/* a ball about two balls */
static wcut_patch patch_tree_join(const wcut_patch *a, const wcut_patch *c) {
    const wcut_vec3 middle = vec3_mix(a->centre, c->centre, 0.5);
    const double radius =
        fmax(vec3_distance(middle, a->centre) + a->radius, vec3_distance(middle, c->centre) + c->radius);
    return wcut_patch_ball(a->u0, c->u1, a->v0, c->v1, middle, radius * ROUNDED);
}

/* What a range becomes: WCUT_OK with a patch in the node, and whether and where to divide it further. A patch is only
   made where a Taylor polynomial holds, over few spans and no crease; above that a node is the ball about its
   children. */
static bool patch_tree_decide(builder *b, int node, const int range[4], bool *along_u, int *at, bool *is_ball) {
    /* a crease divides first, then too many spans */
    const int wide = range[1] - range[0], high = range[3] - range[2];
    *is_ball = true;
    if (find_knot(b, range, 1, along_u, at)) return true;
    if (wide > SPANS_MAX || high > SPANS_MAX) {
        *along_u = wide >= high;
        *at = *along_u ? (range[0] + range[1]) / 2 : (range[2] + range[3]) / 2;
        return true;
    }

    /* whether the piece is flat, and whether a knot of second order divides it */
    *is_ball = false;
    wcut_patch *p = &b->node[node].patch;
    make_patch(b, range, false, p);
    if (find_knot(b, range, 2, along_u, at)) return true;

    /* not flat: halve the longer side */
    if (wide * high > 1 && p->thickness > FLAT * p->radius) {
        const double long_u = vec3_length(p->side_u) + p->bend_uu, long_v = vec3_length(p->side_v) + p->bend_vv;
        *along_u = wide > 1 && (long_u >= long_v || high == 1);
        *at = *along_u ? (range[0] + range[1]) / 2 : (range[2] + range[3]) / 2;
        return true;
    }

    /* flat enough: the full patch with all bounds */
    make_patch(b, range, true, p);

    return false;
}

/* halve what is not flat yet, though it lies between neighbouring knots */
static wcut_status halve(builder *b, int node, int levels) {
    const wcut_patch *p = &b->node[node].patch;
    if (!isfinite(p->radius)) return WCUT_DEGENERATE;
    if (levels == 0 || p->thickness <= FLAT * p->radius) return WCUT_OK;
    wcut_patch half[2];
    wcut_patch_halve(b->surface, p, half);
    const int child = add_children(b);
    if (child == 0) return WCUT_NO_MEMORY;
    b->node[node].child = child;
    b->node[child].patch = half[0], b->node[child + 1].patch = half[1];
    const wcut_status status = halve(b, child, levels - 1);
    return status == WCUT_OK ? halve(b, child + 1, levels - 1) : status;
}

static wcut_status patch_tree_divide(builder *b, int node, const int range[4]) {
    bool along_u, is_ball;
    int at, low[4], high[4];
    if (!patch_tree_decide(b, node, range, &along_u, &at, &is_ball)) return halve(b, node, HALVINGS);
    const int child = add_children(b);
    if (child == 0) return WCUT_NO_MEMORY;
    b->node[node].child = child;
    for (int k = 0; k < 4; k++) low[k] = high[k] = range[k];
    low[along_u ? 1 : 3] = high[along_u ? 0 : 2] = at;
    wcut_status status = patch_tree_divide(b, child, low);
    if (status == WCUT_OK) status = patch_tree_divide(b, child + 1, high);
    if (status == WCUT_OK && is_ball)
        b->node[node].patch = patch_tree_join(&b->node[child].patch, &b->node[child + 1].patch);
    return status;
}

static int *patch_tree_list_spans(int degree, int count, const double *knots, int *spans) {
    int *span = wcut_alloc((size_t)count, sizeof *span);
    *spans = 0;
    for (int s = degree; span && s < count; s++)
        if (knots[s] < knots[s + 1]) span[(*spans)++] = s;
    return span;
}

wcut_status wcut_patch_tree_build(const wcut_surface *surface, wcut_patch_node **node) {
    builder b = {.surface = surface, .count = 1, .room = 64};
    b.span[0] = patch_tree_list_spans(surface->degree_u, surface->count_u, surface->knots_u, &b.spans[0]);
    b.span[1] = patch_tree_list_spans(surface->degree_v, surface->count_v, surface->knots_v, &b.spans[1]);
    b.node = wcut_alloc((size_t)b.room, sizeof *b.node);
    wcut_status status = WCUT_NO_MEMORY;
    if (b.span[0] && b.span[1] && b.node) {
        const int whole[4] = {0, b.spans[0], 0, b.spans[1]};
        status = patch_tree_divide(&b, 0, whole);
    }
    if (status == WCUT_OK) {
        *node = b.node;
    } else {
        wcut_free(b.node);
    }
    wcut_free(b.span[0]);
    wcut_free(b.span[1]);
    return status;
}
