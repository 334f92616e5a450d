/* A piece of a surface as its Taylor polynomial and bounds on the rest: how far it is from a point, and how convex. */
#include "surface/patch.h"

#include "base/numbers.h"
#include "base/vec3.h"

static double tightened(double bend, wcut_vec3 bow, double turn_a, double turn_b) {
    return fmin(bend, vec3_length(bow) + (turn_a + turn_b) / 2);
}

void wcut_patch_fit(const wcut_surface *surface, wcut_patch *p) {
    wcut_vec3 d[9];
    const double wide_u = p->u1 - p->u0, wide_v = p->v1 - p->v0;
    wcut_surface_eval(surface, (p->u0 + p->u1) / 2, (p->v0 + p->v1) / 2, 2, d);
    p->centre = d[0];
    p->side_u = vec3_scale(wide_u, d[3]), p->side_v = vec3_scale(wide_v, d[1]);
    p->bow_uu = vec3_scale(wide_u * wide_u, d[6]);
    p->bow_uv = vec3_scale(wide_u * wide_v, d[4]);
    p->bow_vv = vec3_scale(wide_v * wide_v, d[2]);
    p->bend_uu = tightened(p->bend_uu, p->bow_uu, p->turn_uuu, p->turn_uuv);
    p->bend_uv = tightened(p->bend_uv, p->bow_uv, p->turn_uuv, p->turn_uvv);
    p->bend_vv = tightened(p->bend_vv, p->bow_vv, p->turn_uvv, p->turn_vvv);
    p->thickness = (p->bend_uu + 2 * p->bend_uv + p->bend_vv) / 8;
    const double one = vec3_length(vec3_add(p->side_u, p->side_v));
    const double other = vec3_length(vec3_sub(p->side_u, p->side_v));
    p->radius = fmax(one, other) / 2 + p->thickness;
}

wcut_patch wcut_patch_ball(double u0, double u1, double v0, double v1, wcut_vec3 centre, double radius) {
    return (wcut_patch){.u0 = u0,
                        .u1 = u1,
                        .v0 = v0,
                        .v1 = v1,
                        .centre = centre,
                        .thickness = radius,
                        .radius = radius,
                        .bend_uu = INFINITY,
                        .bend_uv = INFINITY,
                        .bend_vv = INFINITY,
                        .turn_uuu = INFINITY,
                        .turn_uuv = INFINITY,
                        .turn_uvv = INFINITY,
                        .turn_vvv = INFINITY};
}

/* (a - c b) . b / b . b within [-1/2, 1/2] */
static double patch_along(double ab, double bb) { return bb > 0 ? clamp(ab / bb, -0.5, 0.5) : 0; }

static inline double square_at(const wcut_patch *patch, wcut_vec3 q, double s, double t) {
    const wcut_vec3 off = vec3_add_scaled(vec3_add_scaled(q, -s, patch->side_u), -t, patch->side_v);
    return vec3_dot(off, off);
}

double wcut_patch_distance(const wcut_patch *patch, wcut_vec3 p, double enough, double *s, double *t) {
    /* far enough from the ball about the piece: no closer look */
    const wcut_vec3 q = vec3_sub(p, patch->centre), a = patch->side_u, b = patch->side_v;
    const double from_centre = vec3_length(q);
    if (from_centre - patch->radius >= enough) return from_centre - patch->radius;

    /* the nearest point of the parallelogram: free minimum inside, else on an edge */
    const double aa = vec3_dot(a, a), ab = vec3_dot(a, b), bb = vec3_dot(b, b), qa = vec3_dot(q, a),
                 qb = vec3_dot(q, b);
    const double area = aa * bb - ab * ab;
    double inner_s = 1, inner_t = 1; /* without an area, both sides are tried */
    if (area > 1e-12 * aa * bb) inner_s = (qa * bb - qb * ab) / area, inner_t = (qb * aa - qa * ab) / area;
    if (fabs(inner_s) <= 0.5 && fabs(inner_t) <= 0.5) {
        *s = inner_s, *t = inner_t;
        return sqrt(square_at(patch, q, inner_s, inner_t)) - patch->thickness;
    }
    /* a convex function's minimum over a rectangle lies on an edge that its free minimum is beyond */
    double min = INFINITY;
    for (int edge = 0; edge < 4; edge++) {
        const double bound = edge % 2 ? 0.5 : -0.5;
        const bool of_s = edge < 2;
        if (area > 1e-12 * aa * bb && (of_s ? inner_s : inner_t) * bound <= 0.25) continue;
        const double edge_s = of_s ? bound : patch_along(qa - bound * ab, aa),
                     edge_t = of_s ? patch_along(qb - bound * ab, bb) : bound;
        const double square = square_at(patch, q, edge_s, edge_t);
        if (square < min) min = square, *s = edge_s, *t = edge_t;
    }

    return sqrt(min) - patch->thickness;
}

/* the least of g s + h s^2 / 2 for |s| <= 1/2 */
static double min_quadratic(double g, double h) {
    return h > 0 && fabs(g) < h / 2 ? -g * g / (2 * h) : h / 8 - fabs(g) / 2;
}

/* With f = |S - p|^2 / 2 the gradient is (S - p) . S_i and the Hessian S_i . S_j + (S - p) . S_ij. Both are known in
   the middle; elsewhere S_i is off by half the bends at most, S_ij by half the turns and S by the radius. */
bool wcut_patch_is_convex(const wcut_patch *q, wcut_vec3 p, double *min) {
    *min = 0;
    if (!isfinite(q->turn_uuu + q->turn_uuv + q->turn_uvv + q->turn_vvv)) return false;

    /* sizes in the middle of the piece */
    const wcut_vec3 r = vec3_sub(q->centre, p);
    const double reach = vec3_length(r), long_u = vec3_length(q->side_u), long_v = vec3_length(q->side_v);

    /* how far first derivatives, then the Hessian's entries, are off at most */
    const double off_u = (q->bend_uu + q->bend_uv) / 2, off_v = (q->bend_uv + q->bend_vv) / 2;
    const double off_uu =
        2 * long_u * off_u + off_u * off_u + q->radius * q->bend_uu + reach * (q->turn_uuu + q->turn_uuv) / 2;
    const double off_vv =
        2 * long_v * off_v + off_v * off_v + q->radius * q->bend_vv + reach * (q->turn_uvv + q->turn_vvv) / 2;
    const double off_uv = long_u * off_v + long_v * off_u + off_u * off_v + q->radius * q->bend_uv +
                          reach * (q->turn_uuv + q->turn_uvv) / 2;

    /* lower bounds of the diagonal, upper bound of the mixed entry */
    const double uu = long_u * long_u + vec3_dot(r, q->bow_uu) - off_uu;
    const double vv = long_v * long_v + vec3_dot(r, q->bow_vv) - off_vv;
    const double uv = fabs(vec3_dot(q->side_u, q->side_v) + vec3_dot(r, q->bow_uv)) + off_uv;

    /* positive definite everywhere */
    if (uu > 0 && vv > 0 && uu * vv > uv * uv) return true;

    /* else a lower bound on the distance from the quadratic model */
    const double low = reach * reach / 2 + min_quadratic(vec3_dot(r, q->side_u), uu) +
                       min_quadratic(vec3_dot(r, q->side_v), vv) - uv / 4;
    if (low > 0) *min = sqrt(2 * low);

    return false;
}

void wcut_patch_halve(const wcut_surface *surface, const wcut_patch *patch, wcut_patch half[2]) {
    const double long_u = vec3_length(patch->side_u) + patch->bend_uu,
                 long_v = vec3_length(patch->side_v) + patch->bend_vv;
    const bool across_u = long_u >= long_v;
    half[0] = half[1] = *patch;
    if (across_u) {
        half[0].u1 = half[1].u0 = (patch->u0 + patch->u1) / 2;
    } else {
        half[0].v1 = half[1].v0 = (patch->v0 + patch->v1) / 2;
    }
    for (int k = 0; k < 2; k++) {
        const double cut_u = across_u ? 0.5 : 1, cut_v = across_u ? 1 : 0.5;
        half[k].bend_uu *= cut_u * cut_u, half[k].bend_uv *= cut_u * cut_v, half[k].bend_vv *= cut_v * cut_v;
        half[k].turn_uuu *= cut_u * cut_u * cut_u, half[k].turn_uuv *= cut_u * cut_u * cut_v;
        half[k].turn_uvv *= cut_u * cut_v * cut_v, half[k].turn_vvv *= cut_v * cut_v * cut_v;
        wcut_patch_fit(surface, &half[k]);
    }
}
