/* Ear clipping with exact turns: holes are joined to the border by bridges (Eberly 2002), thin ears wait. */
#include "solid/polygon.h"

#include <math.h>
#include <stdbool.h>

#include "base/alloc.h"

/* a corner of the region that is still to be cut; a bridge makes two corners of one point */
typedef struct corner {
    int at; /* place in the runs */
    int before, after;
    double turn; /* wcut_orient2d of it and its neighbours */
} corner;

typedef struct region {
    const wcut_point2d *point;
    corner *corner;
    int corners; /* made so far */
} region;

/* Ears lower than a share of their longest side wait until there are no others, those of a smaller share longer:
   slivers whose area is all rounding have no normal, in the single precision of an STL file none below about 1e-5. */
static const double THIN[] = {1e-3, 1e-4, 1e-5, 1e-6, 0};
enum { ROUNDS = sizeof THIN / sizeof *THIN };

static wcut_point2d flat_of(const region *r, int c) { return r->point[r->corner[c].at]; }

static void polygon_measure(region *r, int c) {
    corner *k = &r->corner[c];
    k->turn = wcut_orient2d(flat_of(r, k->before), flat_of(r, c), flat_of(r, k->after));
}

static void link(region *r, int a, int b) {
    r->corner[a].after = b;
    r->corner[b].before = a;
}

/* the corners of a run, closed upon themselves; gives the first */
static int add_run(region *r, int start, int size) {
    const int first = r->corners;
    for (int k = 0; k < size; k++) {
        r->corner[r->corners++] =
            (corner){.at = start + k, .before = first + (k + size - 1) % size, .after = first + (k + 1) % size};
    }
    for (int k = 0; k < size; k++) polygon_measure(r, first + k);
    return first;
}

/* is x in the triangle a, b, c, its border included? */
static bool polygon_holds(wcut_point2d a, wcut_point2d b, wcut_point2d c, wcut_point2d x) {
    return wcut_orient2d(a, b, x) >= 0 && wcut_orient2d(b, c, x) >= 0 && wcut_orient2d(c, a, x) >= 0;
}

static bool same(wcut_point2d a, wcut_point2d b) { return a.p == b.p && a.q == b.q; }

/* do the open segments a b and c d meet, or does an end of c d lie within a b? */
static bool blocks(wcut_point2d a, wcut_point2d b, wcut_point2d c, wcut_point2d d) {
    const double at_c = wcut_orient2d(a, b, c), at_d = wcut_orient2d(a, b, d);
    if (same(c, a) || same(c, b) || same(d, a) || same(d, b)) return false;
    if ((at_c > 0 && at_d > 0) || (at_c < 0 && at_d < 0)) return false;
    const double at_a = wcut_orient2d(c, d, a), at_b = wcut_orient2d(c, d, b);
    return !((at_a > 0 && at_b > 0) || (at_a < 0 && at_b < 0));
}

/* does the direction to x lie inside the region at a corner? */
static bool opens_to(const region *r, int c, wcut_point2d x) {
    const corner *k = &r->corner[c];
    const wcut_point2d a = flat_of(r, k->before), b = flat_of(r, c), d = flat_of(r, k->after);
    const double from = wcut_orient2d(b, d, x), to = wcut_orient2d(a, b, x);
    return k->turn > 0 ? from > 0 && to > 0 : from > 0 || to > 0;
}

/* can a corner of the run from `start` see x past every edge of that run and of the run from `other`? */
static bool sees(const region *r, int start, int other, int c, wcut_point2d x) {
    if (!opens_to(r, c, x)) return false;
    const int run[2] = {start, other};
    for (int k = 0; k < 2; k++) {
        int e = run[k];
        do {
            const int next = r->corner[e].after;
            if (blocks(flat_of(r, c), x, flat_of(r, e), flat_of(r, next))) return false;
            e = next;
        } while (e != run[k]);
    }
    return true;
}

static double polygon_distance(wcut_point2d a, wcut_point2d b) { return hypot(a.p - b.p, a.q - b.q); }

/* Join a hole to the border by a bridge there and back from the hole's corner of largest p: holes that lie further are
   joined already. False where no corner of the border sees it. */
static bool join_hole(region *r, int border, int hole) {
    /* the hole's corner of largest p */
    int h = hole;
    for (int c = r->corner[hole].after; c != hole; c = r->corner[c].after)
        if (flat_of(r, c).p > flat_of(r, h).p) h = c;
    const wcut_point2d x = flat_of(r, h);

    /* the nearest corner of the border that sees it */
    int best = -1, c = border;
    do {
        if ((best < 0 || polygon_distance(flat_of(r, c), x) < polygon_distance(flat_of(r, best), x)) &&
            sees(r, border, h, c, x))
            best = c;
        c = r->corner[c].after;
    } while (c != border);
    if (best < 0) return false;

    /* two new corners: there and back along the bridge */
    const int back = r->corners++, again = r->corners++;
    r->corner[back].at = r->corner[h].at;

    /* link the hole into the border, and measure the corners that have changed */
    r->corner[again].at = r->corner[best].at;
    link(r, r->corner[h].before, back);
    link(r, again, r->corner[best].after);
    link(r, best, h);
    link(r, back, again);
    polygon_measure(r, best), polygon_measure(r, h), polygon_measure(r, back), polygon_measure(r, again);

    return true;
}

/* join the holes, the one that reaches furthest in p first */
static bool join_holes(region *r, int loops, const int *size, bool *joined) {
    for (int round = 1; round < loops; round++) {
        int best = -1, best_at = 0, at = 0;
        double max = -INFINITY;
        for (int l = 0; l < loops; at += size[l++])
            for (int k = 0; l > 0 && !joined[l] && k < size[l]; k++)
                if (r->point[at + k].p > max) max = r->point[at + k].p, best = l, best_at = at;
        if (best < 0) return false;
        joined[best] = true;
        if (!join_hole(r, 0, add_run(r, best_at, size[best]))) return false;
    }
    return true;
}

/* No other corner in the triangle, nor on its new side. Only corners that do not turn left can be the first inside. */
static bool polygon_is_ear(const region *r, int c) {
    const corner *k = &r->corner[c];
    if (!(k->turn > 0)) return false;
    const wcut_point2d a = flat_of(r, k->before), b = flat_of(r, c), d = flat_of(r, k->after);
    for (int o = r->corner[k->after].after; o != k->before; o = r->corner[o].after) {
        if (r->corner[o].turn > 0) continue;
        const wcut_point2d x = flat_of(r, o);
        if (!same(x, a) && !same(x, b) && !same(x, d) && polygon_holds(a, b, d, x)) return false;
    }
    return true;
}

static bool is_thin(const region *r, int c, double share) {
    const corner *k = &r->corner[c];
    const wcut_point2d a = flat_of(r, k->before), b = flat_of(r, c), d = flat_of(r, k->after);
    const double longest = fmax(polygon_distance(a, b), fmax(polygon_distance(b, d), polygon_distance(d, a)));
    return k->turn < share * longest * longest;
}

/* does an ear's new side pass another corner nearer than a share of its length? what it cuts off would be slivers alone */
static bool grazes(const region *r, int c, double share) {
    const corner *k = &r->corner[c];
    const wcut_point2d a = flat_of(r, k->before), d = flat_of(r, k->after);
    const double p = d.p - a.p, q = d.q - a.q, size = p * p + q * q;
    for (int o = r->corner[k->after].after; o != k->before; o = r->corner[o].after) {
        const wcut_point2d x = flat_of(r, o);
        const double along = p * (x.p - a.p) + q * (x.q - a.q), across = p * (x.q - a.q) - q * (x.p - a.p);
        if (along > 0 && along < size && fabs(across) < share * size) return true;
    }
    return false;
}

/* cut ears until three corners are left; after each go on beyond it, so that they do not all share a corner */
static bool cut_ears(region *r, int left, int c, int *triangle) {
    int waited = 0;
    while (left > 3) {
        /* thin ears wait for some rounds, because later cuts may make them wider */
        const corner k = r->corner[c];
        if (waited >= ROUNDS * left) return false;
        const double share = THIN[waited / left];
        if (is_thin(r, c, share) || !polygon_is_ear(r, c) || grazes(r, c, share)) {
            c = k.after;
            waited++;
            continue;
        }

        /* the ear is a triangle; its neighbours are linked and measured anew */
        *triangle++ = r->corner[k.before].at, *triangle++ = k.at, *triangle++ = r->corner[k.after].at;
        link(r, k.before, k.after);
        polygon_measure(r, k.before), polygon_measure(r, k.after);
        left--;
        waited = 0;
        c = r->corner[k.after].after;
    }

    /* the last three corners */
    const corner k = r->corner[c];
    *triangle++ = r->corner[k.before].at, *triangle++ = k.at, *triangle = r->corner[k.after].at;

    return k.turn > 0;
}

wcut_status wcut_polygon_triangulate(int loops, const int *size, const wcut_point2d *point, int *triangle) {
    int points = 0;
    for (int l = 0; l < loops; l++) {
        if (size[l] < 3) return WCUT_DEGENERATE;
        points += size[l];
    }
    const int corners = points + 2 * (loops - 1);
    bool *joined = wcut_alloc((size_t)loops, sizeof *joined);
    region r = {.point = point, .corner = wcut_alloc((size_t)corners, sizeof *r.corner)};
    wcut_status status = joined && r.corner ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        const int first = add_run(&r, 0, size[0]);
        if (!join_holes(&r, loops, size, joined) || !cut_ears(&r, corners, first, triangle)) status = WCUT_DEGENERATE;
    }
    wcut_free(r.corner);
    wcut_free(joined);
    return status;
}
