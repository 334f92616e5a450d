/* The foam block, and how much of a piece of wire lies in it (Liang, Barsky 1984, with soft faces). */
#include "foam/block.h"

#include <math.h>
#include <stdbool.h>

#include "base/numbers.h"
#include "base/vec3.h"

/* how far a wire's cross-section at coordinate y is between two faces, 0 .. 1 */
static double face_ramp(double y, double size, double depth) {
    return clamp(fmin(y / depth + 0.5, (size - y) / depth + 0.5), 0, 1);
}

static double ramp_slope(double y, double size, double depth) {
    const double low = y / depth + 0.5, high = (size - y) / depth + 0.5, inside = fmin(low, high);
    return inside > 0 && inside < 1 ? (low < high ? 1 : -1) / depth : 0;
}

/* where on 0 .. 1 a coordinate running from p to q passes a value; appended in order of call */
static void add_break(double p, double q, double value, double from, double to, int *count, double *at) {
    if (p == q) return;
    const double s = (value - p) / (q - p);
    if (s > from && s < to) at[(*count)++] = s;
}

static void sort(int count, double *s) {
    for (int i = 1; i < count; i++) {
        const double value = s[i];
        int j = i;
        for (; j > 0 && s[j - 1] > value; j--) s[j] = s[j - 1];
        s[j] = value;
    }
}

typedef struct slab { /* the part of 0 .. 1 that lies between the faces x = 0 and x = W, and how its ends move */
    double from, to;
    double from_dp, from_dq, to_dp, to_dq;
} slab;

static void clip(double p, double q, double face, double *s, double *s_dp, double *s_dq) {
    *s = (face - p) / (q - p);
    *s_dp = (*s - 1) / (q - p);
    *s_dq = -*s / (q - p);
}

static bool clip_x(double p, double q, double width, slab *c) {
    *c = (slab){.from = 0, .to = 1};
    if ((p < 0 && q < 0) || (p > width && q > width)) return false;
    if (p < 0) clip(p, q, 0, &c->from, &c->from_dp, &c->from_dq);
    if (p > width) clip(p, q, width, &c->from, &c->from_dp, &c->from_dq);
    if (q < 0) clip(p, q, 0, &c->to, &c->to_dp, &c->to_dq);
    if (q > width) clip(p, q, width, &c->to, &c->to_dp, &c->to_dq);
    return c->to > c->from;
}

/* the places between which the weight is one polynomial */
static int find_pieces(const wcut_block *b, wcut_vec3 p, wcut_vec3 q, const slab *c, double *at) {
    const double h = b->depth / 2;
    int count = 0;
    at[count++] = c->from;
    for (int side = -1; side <= 1; side += 2) {
        add_break(p.y, q.y, side * h, c->from, c->to, &count, at);
        add_break(p.y, q.y, b->size.y + side * h, c->from, c->to, &count, at);
        add_break(p.z, q.z, side * h, c->from, c->to, &count, at);
        add_break(p.z, q.z, b->size.z + side * h, c->from, c->to, &count, at);
    }
    at[count++] = c->to;
    sort(count, at);
    return count - 1;
}

static double weight_at(const wcut_block *b, wcut_vec3 x) {
    return face_ramp(x.y, b->size.y, b->depth) * face_ramp(x.z, b->size.z, b->depth);
}

/* Integral of the weight over the slab, and its gradient along y and z. Simpson's rule is exact: on a piece every
   integrand is a polynomial of degree two at most. The slopes jump at the ends of a piece and are constant inside. */
static double integrate_slab(const wcut_block *b, wcut_vec3 p, wcut_vec3 q, const slab *c, wcut_vec3 *dp,
                             wcut_vec3 *dq) {
    static const double simpson[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    double at[10], sum = 0;

    /* the pieces on which the weight is a polynomial */
    const int pieces = find_pieces(b, p, q, c, at);
    for (int k = 0; k < pieces; k++) {
        /* slopes of the weight on this piece */
        const double h = at[k + 1] - at[k];
        const wcut_vec3 middle = vec3_mix(p, q, at[k] + h / 2);
        const double slope_y = ramp_slope(middle.y, b->size.y, b->depth);
        const double slope_z = ramp_slope(middle.z, b->size.z, b->depth);

        /* sum of the weight, and its derivatives by both ends of the wire piece */
        for (int i = 0; i < 3; i++) {
            const double s = at[k] + h * i / 2, w = simpson[i] * h;
            const wcut_vec3 x = vec3_mix(p, q, s);
            const double ry = face_ramp(x.y, b->size.y, b->depth), rz = face_ramp(x.z, b->size.z, b->depth);
            sum += w * ry * rz;
            dp->y += w * slope_y * rz * (1 - s), dq->y += w * slope_y * rz * s;
            dp->z += w * slope_z * ry * (1 - s), dq->z += w * slope_z * ry * s;
        }
    }

    return sum;
}

static bool well_inside(const wcut_block *b, wcut_vec3 p) {
    const double h = b->depth / 2;
    return p.x >= 0 && p.x <= b->size.x && p.y >= h && p.y <= b->size.y - h && p.z >= h && p.z <= b->size.z - h;
}

static bool both_beyond(double p, double q, double size, double h) {
    return (p <= -h && q <= -h) || (p >= size + h && q >= size + h);
}

double wcut_block_engagement(const wcut_block *block, wcut_vec3 p, wcut_vec3 q, wcut_vec3 *dp, wcut_vec3 *dq) {
    const double h = block->depth / 2;
    *dp = *dq = vec3(0, 0, 0);
    if (well_inside(block, p) && well_inside(block, q)) return 1;
    if (both_beyond(p.y, q.y, block->size.y, h) || both_beyond(p.z, q.z, block->size.z, h)) return 0;
    slab c;
    if (!clip_x(p.x, q.x, block->size.x, &c)) return 0;
    const double share = integrate_slab(block, p, q, &c, dp, dq);
    const double first = weight_at(block, vec3_mix(p, q, c.from)), last = weight_at(block, vec3_mix(p, q, c.to));
    dp->x = last * c.to_dp - first * c.from_dp;
    dq->x = last * c.to_dq - first * c.from_dq;
    return clamp(share, 0, 1);
}

double wcut_block_distance(const wcut_block *block, wcut_vec3 p) {
    const wcut_vec3 nearest = {clamp(p.x, 0, block->size.x), clamp(p.y, 0, block->size.y),
                               clamp(p.z, 0, block->size.z)};
    return vec3_distance(p, nearest);
}
