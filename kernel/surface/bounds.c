/* Boxes about curves and surfaces: hulls of control points, halved where they stand out further than a tolerance. */
#include <stddef.h>
#include <wirecut/bounds.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/bezier.h"

enum { HALVINGS_MAX = 60 };

/* of the largest coordinate: finer than this rounding decides */
static const double ROUNDED = 1e-12;

/* the height of points over a plane through the origin: what one side of the box is about */
typedef struct reach {
    wcut_vec3 outward;
    double tolerance;
    double attained; /* the highest point known to be on the shape */
    double bound;    /* no point is higher */
} reach;

static void attain(reach *r, wcut_vec3 p) { r->attained = fmax(r->attained, vec3_dot(r->outward, p)); }

/* is a hull that reaches so high within the tolerance? */
static bool bounds_settle(reach *r, double hull) {
    if (hull > r->attained + r->tolerance) return false;
    r->bound = fmax(r->bound, hull);
    return true;
}

static double hull_of(const reach *r, const wcut_bezier *b) {
    double max = -INFINITY;
    for (int j = 0; j <= b->degree_v; j++)
        for (int i = 0; i <= b->degree_u; i++) max = fmax(max, vec3_dot(r->outward, bezier_point(b, i, j)));
    return max;
}

static void bounds_climb(reach *r, const wcut_bezier *b, int halvings) {
    for (int corner = 0; corner < 4; corner++)
        attain(r, bezier_point(b, corner % 2 ? b->degree_u : 0, corner / 2 ? b->degree_v : 0));
    const double hull = hull_of(r, b);
    if (bounds_settle(r, hull)) return;
    if (halvings == HALVINGS_MAX) {
        r->bound = fmax(r->bound, hull);
        return;
    }
    wcut_bezier half[2];
    wcut_bezier_halve(b, b->degree_v == 0 || halvings % 2 == 0, half);
    const int first = hull_of(r, &half[1]) > hull_of(r, &half[0]); /* the higher one first: it may settle the other */
    bounds_climb(r, &half[first], halvings + 1);
    bounds_climb(r, &half[1 - first], halvings + 1);
}

static void climb_surface(reach *r, const wcut_surface *s) {
    for (int j = s->degree_v; j < s->count_v; j++)
        for (int i = s->degree_u; i < s->count_u; i++) {
            if (!(s->knots_u[i] < s->knots_u[i + 1] && s->knots_v[j] < s->knots_v[j + 1])) continue;
            double hull = -INFINITY;
            for (int q = j - s->degree_v; q <= j; q++)
                for (int p = i - s->degree_u; p <= i; p++)
                    hull = fmax(hull, vec3_dot(r->outward, s->control[(ptrdiff_t)q * s->count_u + p]));
            if (bounds_settle(r, hull)) continue;
            wcut_bezier b;
            wcut_bezier_of_surface(s, i, j, &b);
            bounds_climb(r, &b, 0);
        }
}

static void climb_curve(reach *r, const wcut_curve *c) {
    for (int i = c->degree; i < c->control_count; i++) {
        if (!(c->knots[i] < c->knots[i + 1])) continue;
        double hull = -INFINITY;
        for (int p = i - c->degree; p <= i; p++) hull = fmax(hull, vec3_dot(r->outward, c->control[p]));
        if (bounds_settle(r, hull)) continue;
        wcut_bezier b;
        wcut_bezier_of_curve(c, i, &b);
        bounds_climb(r, &b, 0);
    }
}

/* a point of the shape that is likely to be high: that of the highest control point */
static double greville(int degree, const double *knots, int i) {
    double sum = 0;
    for (int k = 1; k <= degree; k++) sum += knots[i + k] / degree;
    return sum;
}

static int highest(const reach *r, int count, const wcut_vec3 *control) {
    int best = 0;
    for (int k = 1; k < count; k++)
        if (vec3_dot(r->outward, control[k]) > vec3_dot(r->outward, control[best])) best = k;
    return best;
}

static double largest_coordinate(int count, const wcut_vec3 *p) {
    double size = 0;
    for (int k = 0; k < count; k++) size = fmax(size, fmax(fabs(p[k].x), fmax(fabs(p[k].y), fabs(p[k].z))));
    return size;
}

/* what the box is about: a curve, or a surface where there is none */
typedef struct shape {
    const wcut_curve *curve;
    const wcut_surface *surface;
    int count;
    const wcut_vec3 *control;
} shape;

/* the point of the shape that its k-th control point draws most */
static wcut_vec3 point_near(const shape *f, int k) {
    wcut_vec3 p = f->control[k];
    const wcut_curve *c = f->curve;
    const wcut_surface *s = f->surface;
    if (c) {
        wcut_curve_eval(c, greville(c->degree, c->knots, k), 0, &p);
    } else if (s) {
        wcut_surface_eval(s, greville(s->degree_u, s->knots_u, k % s->count_u),
                          greville(s->degree_v, s->knots_v, k / s->count_u), 0, &p);
    }
    return p;
}

static void bounds_find_box(const shape *f, double tolerance, wcut_box *box) {
    const double size = largest_coordinate(f->count, f->control);
    double side[6];
    for (int k = 0; k < 6; k++) {
        const double sign = k % 2 ? 1 : -1;
        reach r = {.outward = vec3(k / 2 == 0 ? sign : 0, k / 2 == 1 ? sign : 0, k / 2 == 2 ? sign : 0)};
        r.tolerance = fmax(tolerance, ROUNDED * size), r.bound = -INFINITY;
        r.attained = vec3_dot(r.outward, point_near(f, highest(&r, f->count, f->control)));
        if (f->curve) climb_curve(&r, f->curve);
        if (f->surface) climb_surface(&r, f->surface);
        side[k] = sign * r.bound;
    }
    *box = (wcut_box){{side[0], side[2], side[4]}, {side[1], side[3], side[5]}};
}

wcut_status wcut_curve_bounds(const wcut_curve *curve, double tolerance, wcut_box *box) {
    if (!curve || !box || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    const shape f = {.curve = curve, .count = curve->control_count, .control = curve->control};
    bounds_find_box(&f, tolerance, box);
    return WCUT_OK;
}

wcut_status wcut_surface_bounds(const wcut_surface *surface, double tolerance, wcut_box *box) {
    if (!surface || !box || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    const shape f = {.surface = surface, .count = surface->count_u * surface->count_v, .control = surface->control};
    bounds_find_box(&f, tolerance, box);
    return WCUT_OK;
}

/* ---- clearance ------------------------------------------------------------------------------------------------------ */

static double bounds_box_distance(const wcut_box *b, wcut_vec3 p) {
    const double x = fmax(0, fmax(b->low.x - p.x, p.x - b->high.x)), y = fmax(0, fmax(b->low.y - p.y, p.y - b->high.y)),
                 z = fmax(0, fmax(b->low.z - p.z, p.z - b->high.z));
    return sqrt(x * x + y * y + z * z);
}

typedef struct approach {
    const wcut_box *block;
    double tolerance, attained, bound, u;
} approach;

/* The hull of a piece's control points lies in their box; the boxes' distance is the piece's at least. */
static double hull_distance(const approach *a, const wcut_bezier *b) {
    wcut_vec3 low = bezier_point(b, 0, 0), high = low;
    for (int i = 1; i <= b->degree_u; i++) {
        const wcut_vec3 p = bezier_point(b, i, 0);
        low = vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    const wcut_box grown = {vec3_sub(a->block->low, vec3_sub(high, low)), a->block->high};
    return bounds_box_distance(&grown, low); /* Minkowski: low + [0, high - low] against the block */
}

static void draw_near(approach *a, const wcut_bezier *b, int halvings) {
    for (int end = 0; end < 2; end++) {
        const double d = bounds_box_distance(a->block, bezier_point(b, end ? b->degree_u : 0, 0));
        if (d < a->attained) a->attained = d, a->u = end ? b->u1 : b->u0;
    }
    const double hull = hull_distance(a, b);
    if (hull >= a->attained - a->tolerance || halvings == HALVINGS_MAX) {
        a->bound = fmin(a->bound, hull);
        return;
    }
    wcut_bezier half[2];
    wcut_bezier_halve(b, true, half);
    const int first = hull_distance(a, &half[1]) < hull_distance(a, &half[0]);
    draw_near(a, &half[first], halvings + 1);
    draw_near(a, &half[1 - first], halvings + 1);
}

wcut_status wcut_curve_clearance(const wcut_curve *curve, const wcut_box *block, double tolerance, double *distance,
                                 double *u) {
    if (!curve || !block || !distance || !is_positive(tolerance) || !vec3_is_finite(block->low) ||
        !vec3_is_finite(block->high) || !(block->low.x <= block->high.x) || !(block->low.y <= block->high.y) ||
        !(block->low.z <= block->high.z))
        return WCUT_BAD_ARGUMENT;
    const double size = largest_coordinate(curve->control_count, curve->control) + largest_coordinate(2, &block->low);
    approach a = {.block = block, .tolerance = fmax(tolerance, ROUNDED * size)};
    a.attained = a.bound = INFINITY;
    for (int i = curve->degree; i < curve->control_count && a.attained > 0; i++) {
        if (!(curve->knots[i] < curve->knots[i + 1])) continue;
        wcut_bezier b;
        wcut_bezier_of_curve(curve, i, &b);
        draw_near(&a, &b, 0);
    }
    *distance = a.attained > 0 ? fmin(a.bound, a.attained) : 0;
    if (u) *u = a.u;
    return WCUT_OK;
}
