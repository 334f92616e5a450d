/* How thick a half is behind its cut face: to the face opposite, to pockets in that, to sides that the cut turns to; and
   how sharp its edges are. */
#include "solid/wall.h"

#include <math.h>
#include <stddef.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "solid/keys.h"

/* A side is a wall's other face where the way through the half, straight from the cut face, meets it within 45 deg. */
static const double COS_FACING = 0.70710678118654752;

/* Rounds of alternating projections: between parallel faces one is enough, across an edge they halve the rest. */
enum { ROUNDS = 200 };

static void lessen(wcut_half_report *r, double wall, wcut_vec3 place) {
    if (wall < r->wall_min) r->wall_min = wall, r->wall_place = place;
}

/* twice a triangle's area along its normal, which points upwards */
static wcut_vec3 wall_spread(const wcut_cap *l, int t) {
    const int *c = l->triangle + 3 * (ptrdiff_t)t;
    const wcut_vec3 a = l->vertex[c[0]];
    return vec3_cross(vec3_sub(l->vertex[c[1]], a), vec3_sub(l->vertex[c[2]], a));
}

/* ---- pockets ---- */

/* the nearest point of a segment */
static wcut_vec3 on_segment(wcut_vec3 p, wcut_vec3 a, wcut_vec3 b) {
    const wcut_vec3 along = vec3_sub(b, a);
    const double size = vec3_dot(along, along);
    return vec3_mix(a, b, size > 0 ? clamp(vec3_dot(vec3_sub(p, a), along) / size, 0, 1) : 0);
}

/* the nearest point of a triangle: of its plane where that is inside, else of its edges */
static wcut_vec3 on_triangle(wcut_vec3 p, const wcut_vec3 c[3]) {
    const wcut_vec3 n = vec3_cross(vec3_sub(c[1], c[0]), vec3_sub(c[2], c[0]));
    const double size = vec3_dot(n, n);
    bool inside = size > 0;
    wcut_vec3 best = c[0];
    for (int k = 0; k < 3; k++) {
        const wcut_vec3 a = c[k], b = c[(k + 1) % 3], at = on_segment(p, a, b);
        if (vec3_distance(p, at) < vec3_distance(p, best)) best = at;
        inside = inside && vec3_dot(vec3_cross(vec3_sub(b, a), vec3_sub(p, a)), n) >= 0;
    }
    return inside ? vec3_add_scaled(p, -vec3_dot(vec3_sub(p, c[0]), n) / size, n) : best;
}

/* the nearest point of a pocket's end and flank, for a point outside it and above its floor's level: in the half plane
   of radius and depth through the pocket's axis */
static wcut_vec3 on_pocket(wcut_vec3 p, const wcut_key *key, double level) {
    const double inwards = key->upper ? -1 : 1, depth = -key->height;
    const double r = hypot(p.x - key->x, p.y - key->y), h = inwards * (p.z - level);
    const wcut_vec3 q = {r, h, 0}, tip = {key->tip_radius, depth, 0}, foot = {key->radius, 0, 0};
    const wcut_vec3 end = on_segment(q, vec3(0, depth, 0), tip), flank = on_segment(q, tip, foot);
    const wcut_vec3 at = vec3_distance(q, end) <= vec3_distance(q, flank) ? end : flank;
    const double turn = r > 0 ? at.x / r : 0;
    return vec3(key->x + turn * (p.x - key->x), key->y + turn * (p.y - key->y), level + inwards * at.y);
}

/* the distance of two convex shapes by alternating projections (von Neumann 1950) */
static void measure_pocket(const wcut_cap *l, int t, const wcut_key *key, double level, wcut_half_report *r) {
    const int *v = l->triangle + 3 * (ptrdiff_t)t;
    const wcut_vec3 c[3] = {l->vertex[v[0]], l->vertex[v[1]], l->vertex[v[2]]}, centre = vec3(key->x, key->y, level);
    wcut_vec3 p = on_triangle(centre, c);
    double wall = INFINITY;
    if (vec3_distance(p, centre) - hypot(key->radius, key->height) >= r->wall_min)
        return; /* a ball around the pocket */
    for (int k = 0; k < ROUNDS; k++) {
        const wcut_vec3 q = on_pocket(p, key, level), next = on_triangle(q, c);
        const double distance = vec3_distance(q, next);
        p = next;
        if (!(distance < wall * (1 - 1e-12))) break;
        wall = distance;
    }
    lessen(r, wall, p);
}

/* ---- sides ---- */

static double wall_coordinate(wcut_vec3 p, int axis) { return axis == 0 ? p.x : p.y; }

/* the sides in the order of a cap's borders: x low, x high, y low, y high */
static wcut_vec3 side_normal(int side) {
    const double sign = side % 2 ? 1 : -1;
    return side < 2 ? vec3(sign, 0, 0) : vec3(0, sign, 0);
}

/* `inwards`: the unit normal of triangle t into the half */
static void measure_sides(const wcut_division *d, const wcut_cap *l, int t, wcut_vec3 inwards, wcut_half_report *r) {
    const double size[2] = {d->block.x, d->block.y};
    for (int side = 0; side < 4; side++) {
        if (vec3_dot(inwards, side_normal(side)) < COS_FACING) continue;
        for (int k = 0; k < 3; k++) {
            const wcut_vec3 p = l->vertex[l->triangle[3 * (ptrdiff_t)t + k]];
            const double at = wall_coordinate(p, side / 2);
            lessen(r, side % 2 ? size[side / 2] - at : at, p);
        }
    }
}

/* the angle inside the half between a triangle with an edge on a side, and that side */
static void measure_edge(const wcut_division *d, const wcut_cap *l, int t, wcut_vec3 inwards, wcut_half_report *r) {
    const double size[2] = {d->block.x, d->block.y};
    for (int side = 0; side < 4; side++) {
        const double level = side % 2 ? size[side / 2] : 0;
        for (int k = 0; k < 3; k++) {
            const wcut_vec3 a = l->vertex[l->triangle[3 * (ptrdiff_t)t + k]];
            const wcut_vec3 b = l->vertex[l->triangle[3 * (ptrdiff_t)t + (k + 1) % 3]];
            if (wall_coordinate(a, side / 2) != level || wall_coordinate(b, side / 2) != level) continue;
            const double angle = acos(clamp(vec3_dot(inwards, side_normal(side)), -1, 1));
            if (angle < r->edge_min) r->edge_min = angle, r->edge_place = vec3_mix(a, b, 0.5);
        }
    }
}

/* ---- all ---- */

void wcut_wall_measure(const wcut_division *d, int upper, const wcut_cut_face *face, wcut_half_report *report) {
    const wcut_cap *l = &face->cap;
    const double level = upper ? d->block.z : 0;
    report->wall_min = report->edge_min = INFINITY;
    for (int v = 0; v < l->vertex_count; v++) lessen(report, fabs(l->vertex[v].z - level), l->vertex[v]);
    for (int t = 0; t < l->triangle_count; t++) {
        const wcut_vec3 inwards = vec3_scale(upper ? 1 : -1, vec3_unit(wall_spread(l, t)));
        measure_sides(d, l, t, inwards, report);
        measure_edge(d, l, t, inwards, report);
    }
    for (int k = 0; k < d->options->key_count; k++) {
        const wcut_key *key = &d->options->key[k];
        if (!key->upper != !upper || key->height > 0) continue;
        for (int t = 0; t < l->triangle_count; t++) measure_pocket(l, t, key, level, report);
    }
}
