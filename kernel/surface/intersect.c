/* Curves in which a surface meets a plane or a block: the pieces of a contour joined end to end, and clipped to faces. */
#include <stdlib.h>
#include <string.h>
#include <wirecut/intersect.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/contour.h"

static const double SAME = 1e-9; /* of the domain, and of the size: ends nearer than this are one */

void wcut_traces_destroy(wcut_traces *traces) {
    if (!traces) return;
    for (int k = 0; k < traces->count; k++) {
        wcut_free(traces->trace[k].point);
        wcut_free(traces->trace[k].uv);
    }
    wcut_free(traces->trace);
    wcut_free(traces);
}

/* ---- joining --------------------------------------------------------------------------------------------------------- */

/* an end of a piece: 2 * piece + 0 or 1 */
typedef struct tip {
    int index, partner; /* the end it is joined to, -1: none */
    wcut_contour_end at;
    wcut_vec3 point;
    bool on_border;
} tip;

static int intersect_compare(double a, double b) { return (a > b) - (a < b); }

/* by line, then along it */
static int by_line(const void *a, const void *b) {
    const tip *p = *(tip *const *)a, *q = *(tip *const *)b;
    if (p->at.on_v != q->at.on_v) return p->at.on_v ? 1 : -1;
    int order = intersect_compare(p->at.line, q->at.line);
    if (order == 0) order = p->at.on_v ? intersect_compare(p->at.u, q->at.u) : intersect_compare(p->at.v, q->at.v);
    return order != 0 ? order : p->index - q->index;
}

static void intersect_join(tip *a, tip *b) { a->partner = b->index, b->partner = a->index; }

/* ends on either side of one line, at one place of it */
static void join_across_lines(int count, tip **sorted, const double width[2]) {
    for (int k = 0; k < count; k++) {
        tip *a = sorted[k];
        if (a->partner >= 0 || a->on_border) continue;
        for (int n = k + 1; n < count; n++) {
            tip *b = sorted[n];
            if (b->at.on_v != a->at.on_v || b->at.line != a->at.line) break;
            const double step = a->at.on_v ? b->at.u - a->at.u : b->at.v - a->at.v;
            if (step > SAME * width[a->at.on_v ? 0 : 1]) break;
            if (b->partner >= 0 || b->at.side == a->at.side) continue;
            intersect_join(a, b);
            break;
        }
    }
}

/* what is left: over touching places, within the tolerance; at the seam of a closed surface, in the same place */
static void join_in_space(int count, tip *all, double within, double same) {
    for (int pass = 0; pass < 2; pass++)
        for (int k = 0; k < count; k++) {
            if (all[k].partner >= 0) continue;
            const bool border = all[k].on_border;
            int best = -1;
            double nearest = border || pass == 0 ? same : within;
            for (int n = 0; n < count; n++) {
                if (n == k || all[n].partner >= 0 || all[n].on_border != border) continue;
                if (border && all[n].at.line == all[k].at.line && all[n].at.on_v == all[k].at.on_v) continue;
                const double distance = vec3_distance(all[n].point, all[k].point);
                if (distance <= nearest) nearest = distance, best = n;
            }
            if (best >= 0) intersect_join(&all[k], &all[best]);
        }
}

static wcut_status make_tips(const wcut_surface *s, const wcut_contour *c, double tolerance, tip **tips) {
    /* two ends for each piece */
    const int count = 2 * c->piece_count;
    double first[2], last[2];
    wcut_surface_domain(s, first, last);
    const double width[2] = {last[0] - first[0], last[1] - first[1]};

    tip *all = wcut_alloc((size_t)count, sizeof *all), **sorted = wcut_alloc((size_t)count, sizeof *sorted);
    if (!all || !sorted) {
        wcut_free(all);
        wcut_free(sorted);
        return WCUT_NO_MEMORY;
    }

    /* the points at the ends, and which are on the border of the surface */
    for (int k = 0; k < count; k++) {
        const wcut_contour_end *e = &c->piece[k / 2].end[k % 2];
        const int d = e->on_v ? 1 : 0;
        all[k] = (tip){.index = k, .partner = -1, .at = *e};
        all[k].on_border = e->line <= first[d] || e->line >= last[d];
        wcut_surface_eval(s, e->u, e->v, 0, &all[k].point);
        sorted[k] = &all[k];
    }

    /* join ends on the same line of the grid, sorted by line */
    qsort(sorted, (size_t)count, sizeof *sorted, by_line);
    join_across_lines(count, sorted, width);

    /* the ends that are left: join those that are near each other in space */
    int left = 0; /* few: the rest is quadratic in them */
    for (int k = 0; k < count; k++)
        if (all[k].partner < 0) left++;

    tip *few = wcut_alloc((size_t)left, sizeof *few);
    if (few) {
        for (int k = 0, to = 0; k < count; k++)
            if (all[k].partner < 0) few[to] = all[k], few[to].index = to, to++;
        join_in_space(left, few, tolerance, SAME * c->size);
        for (int k = 0, to = 0; k < count; k++) {
            if (all[k].partner >= 0) continue;
            sorted[to++] = &all[k];
        }
        for (int to = 0; to < left; to++)
            if (few[to].partner >= 0) sorted[to]->partner = sorted[few[to].partner]->index;
    }
    wcut_free(sorted);
    if (!few) {
        wcut_free(all);
        return WCUT_NO_MEMORY;
    }

    wcut_free(few);
    *tips = all;

    return WCUT_OK;
}

/* the pieces from an end on, marked as used; `trace` may be NULL, then they are only counted. Returns the points. */
static int intersect_follow(const wcut_contour *c, const tip *tips, int start, bool *used, wcut_trace *trace,
                            bool *closed) {
    /* from piece to piece, in either direction */
    int made = 0, at = start;
    *closed = false;
    for (;;) {
        const wcut_contour_piece *piece = &c->piece[at / 2];
        const bool forth = at % 2 == 0;
        if (used) used[at / 2] = true;
        for (int k = made > 0; k < piece->count; k++) { /* a joint is one point */
            const int from = piece->first + (forth ? k : piece->count - 1 - k);
            if (trace) memcpy(trace->uv + 2 * (ptrdiff_t)made, c->uv + 2 * (ptrdiff_t)from, 2 * sizeof *trace->uv);
            made++;
        }

        /* through the joint to the partner; the start again closes the curve */
        const int next = tips[at ^ 1].partner;
        if (next < 0) return made;
        if (next == start) {
            *closed = true;
            return made - 1; /* the first point again */
        }
        at = next;
    }
}

static wcut_status take_trace(const wcut_surface *s, const wcut_contour *c, const tip *tips, int start, bool *used,
                              wcut_traces *all) {
    bool closed;
    wcut_trace t = {.face = 0};
    const int count = intersect_follow(c, tips, start, NULL, NULL, &closed);
    t.uv = wcut_alloc((size_t)count + 1, 2 * sizeof *t.uv);
    t.point = wcut_alloc((size_t)count + 1, sizeof *t.point);
    if (!t.uv || !t.point) {
        wcut_free(t.uv);
        wcut_free(t.point);
        return WCUT_NO_MEMORY;
    }
    t.count = intersect_follow(c, tips, start, used, &t, &closed);
    t.closed = closed;
    for (int k = 0; k < t.count; k++)
        wcut_surface_eval(s, t.uv[2 * (size_t)k], t.uv[2 * (size_t)k + 1], 0, &t.point[k]);
    all->trace[all->count++] = t;
    return WCUT_OK;
}

static wcut_status join_pieces(const wcut_surface *s, const wcut_contour *c, double tolerance, wcut_traces **traces) {
    /* ends joined in pairs */
    wcut_traces *all = wcut_alloc(1, sizeof *all);
    tip *tips = NULL;
    bool *used = wcut_alloc((size_t)c->piece_count, sizeof *used);
    wcut_status status = all && used ? make_tips(s, c, tolerance, &tips) : WCUT_NO_MEMORY;

    /* room for the curves; touching places are handed through */
    if (status == WCUT_OK) {
        all->trace = wcut_alloc((size_t)c->piece_count, sizeof *all->trace);
        if (!all->trace) status = WCUT_NO_MEMORY;
        all->touching = c->touching, all->touch_u = c->touch_u, all->touch_v = c->touch_v;
    }

    /* first pass: curves with free ends; second pass: closed ones */
    for (int pass = 0; pass < 2 && status == WCUT_OK; pass++) /* open curves from their ends, then closed ones */
        for (int k = 0; k < 2 * c->piece_count && status == WCUT_OK; k++) {
            if (pass == 0 && tips[k].partner < 0 && !tips[k].on_border) all->loose++;
            if (used[k / 2] || (pass == 0 && tips[k].partner >= 0)) continue;
            status = take_trace(s, c, tips, k, used, all);
        }

    wcut_free(used);
    wcut_free(tips);
    if (status == WCUT_OK) {
        *traces = all;
    } else {
        wcut_traces_destroy(all);
    }

    return status;
}

static wcut_status intersect(const wcut_surface *s, wcut_vec3 point, wcut_vec3 normal, double tolerance,
                             wcut_traces **traces) {
    wcut_contour c;
    wcut_status status = wcut_contour_find(s, point, normal, tolerance, &c);
    if (status != WCUT_OK) return status;
    status = join_pieces(s, &c, tolerance, traces);
    wcut_contour_clear(&c);
    return status;
}

wcut_status wcut_surface_intersect_plane(const wcut_surface *surface, wcut_vec3 point, wcut_vec3 normal,
                                         double tolerance, wcut_traces **traces) {
    const double length = vec3_length(normal);
    if (!surface || !traces || !is_positive(tolerance) || !vec3_is_finite(point) || !is_positive(length))
        return WCUT_BAD_ARGUMENT;
    return intersect(surface, point, vec3_scale(1 / length, normal), tolerance, traces);
}

/* ---- clipping to the faces of a block ---------------------------------------------------------------------------------- */

static double coordinate(wcut_vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/* a face: the axis it is across, its level, and the block it belongs to */
typedef struct face {
    const wcut_surface *surface;
    int axis;
    double level;
    const wcut_box *block;
} face;

/* which bound of the face a point is beyond: 0 none, else 1 + 2 (k - 1) + (0 low, 1 high) for the axes after its own */
static int beyond(const face *f, wcut_vec3 p) {
    for (int k = 1; k <= 2; k++) {
        const int axis = (f->axis + k) % 3;
        if (coordinate(p, axis) < coordinate(f->block->low, axis)) return 2 * k - 1;
        if (coordinate(p, axis) > coordinate(f->block->high, axis)) return 2 * k;
    }
    return 0;
}

/* Where a trace passes a bound between an inner and an outer point: bisection along it, then Newton's method for both
   coordinates. */
static void find_crossing(const face *f, const double *inner, const double *outer, double uv[2], wcut_vec3 *point) {
    /* bisection along the line between both points; `bound` is the side that is passed */
    double low = 0, high = 1;
    int bound = 0;
    for (int k = 0; k < 40; k++) {
        const double t = (low + high) / 2, u = (1 - t) * inner[0] + t * outer[0], v = (1 - t) * inner[1] + t * outer[1];
        wcut_surface_eval(f->surface, u, v, 0, point);
        const int b = beyond(f, *point);
        if (b) high = t, bound = b;
        if (!b) low = t;
    }

    for (int d = 0; d < 2; d++) uv[d] = (1 - low) * inner[d] + low * outer[d];
    if (!bound) {
        wcut_surface_eval(f->surface, outer[0], outer[1], 0, point);
        bound = beyond(f, *point);
    }

    /* the two conditions: on the face, and on the bound */
    const int axis = (f->axis + (bound + 1) / 2) % 3;
    const double level = coordinate(bound % 2 ? f->block->low : f->block->high, axis);

    /* Newton's method for both */
    for (int k = 0; k < 8; k++) {
        wcut_vec3 d[4];
        wcut_surface_eval(f->surface, uv[0], uv[1], 1, d);
        const double a = coordinate(d[0], f->axis) - f->level, b = coordinate(d[0], axis) - level;
        const double au = coordinate(d[2], f->axis), av = coordinate(d[1], f->axis), bu = coordinate(d[2], axis),
                     bv = coordinate(d[1], axis), area = au * bv - av * bu;
        if (!(fabs(area) > 1e-9 * (fabs(au) + fabs(av)) * (fabs(bu) + fabs(bv)))) break;
        const double du = (av * b - bv * a) / area, dv = (bu * a - au * b) / area;
        /* not further than the two points are apart: a seam between them has no such place */
        if (fabs(du) > fabs(outer[0] - inner[0]) + 1e-6 || fabs(dv) > fabs(outer[1] - inner[1]) + 1e-6) break;
        uv[0] += du, uv[1] += dv;
    }
    wcut_surface_eval(f->surface, uv[0], uv[1], 0, point);
}

/* traces within a face, being collected */
typedef struct clip {
    face f;
    int number; /* of the face */
    wcut_traces *to;
    int room;
    wcut_trace now;
} clip;

static void clip_add(clip *c, const double *uv, wcut_vec3 point) {
    c->now.uv[2 * (size_t)c->now.count] = uv[0], c->now.uv[2 * (size_t)c->now.count + 1] = uv[1];
    c->now.point[c->now.count++] = point;
}

static wcut_status clip_begin(clip *c, int room) {
    c->now = (wcut_trace){.face = c->number};
    c->now.uv = wcut_alloc((size_t)room, 2 * sizeof *c->now.uv);
    c->now.point = wcut_alloc((size_t)room, sizeof *c->now.point);
    if (c->now.uv && c->now.point) return WCUT_OK;
    wcut_free(c->now.uv);
    wcut_free(c->now.point);
    c->now = (wcut_trace){.count = 0};
    return WCUT_NO_MEMORY;
}

static wcut_status clip_end(clip *c) {
    wcut_status status = WCUT_OK;

    /* a growing list of parts */
    if (c->now.count >= 2 && c->to->count == c->room) {
        wcut_trace *more = wcut_alloc(2 * (size_t)c->room + 16, sizeof *more);
        if (more) {
            if (c->room > 0) memcpy(more, c->to->trace, (size_t)c->room * sizeof *more);
            wcut_free(c->to->trace);
            c->to->trace = more;
            c->room = 2 * c->room + 16;
        } else {
            status = WCUT_NO_MEMORY;
        }
    }

    /* a part of one point is none */
    if (status == WCUT_OK && c->now.count >= 2) {
        c->to->trace[c->to->count++] = c->now;
    } else {
        wcut_free(c->now.uv);
        wcut_free(c->now.point);
    }
    c->now = (wcut_trace){.count = 0};

    return status;
}

/* the parts of a trace inside a face; a closed one begins at an outer point, if it has one */
static wcut_status clip_trace(clip *c, const wcut_trace *t) {
    int start = 0, inside = 0;

    /* how many points are inside; a closed trace starts at one that is not */
    for (int k = 0; k < t->count; k++) {
        if (beyond(&c->f, t->point[k])) {
            start = k;
        } else {
            inside++;
        }
    }
    if (inside == 0) return WCUT_OK;
    const bool whole = inside == t->count;
    const int steps = t->closed && !whole ? t->count + 1 : t->count, room = t->count + 4;
    if (!t->closed || whole) start = 0;

    /* walk along the trace; where it crosses the border a part begins or ends */
    wcut_status status = WCUT_OK;
    bool was_inside = false;
    for (int n = 0; n < steps && status == WCUT_OK; n++) {
        const int k = (start + n) % t->count, before = (start + n + t->count - 1) % t->count;
        const bool is_inside = !beyond(&c->f, t->point[k]);
        double uv[2];
        wcut_vec3 point;

        /* from outside to inside: a part begins where the trace crosses the border */
        if (is_inside && !was_inside) {
            status = clip_begin(c, room);
            if (status == WCUT_OK && n > 0) {
                find_crossing(&c->f, &t->uv[2 * (size_t)k], &t->uv[2 * (size_t)before], uv, &point);
                clip_add(c, uv, point);
            }
        }
        if (status == WCUT_OK && is_inside) clip_add(c, &t->uv[2 * (size_t)k], t->point[k]);

        /* from inside to outside: the part ends where it crosses again */
        if (!is_inside && was_inside) {
            find_crossing(&c->f, &t->uv[2 * (size_t)before], &t->uv[2 * (size_t)k], uv, &point);
            clip_add(c, uv, point);
            status = clip_end(c);
        }
        was_inside = is_inside;
    }

    /* a trace that ends inside ends its part there; a closed one that never left is one closed part */
    if (status == WCUT_OK && was_inside) {
        c->now.closed = whole && t->closed;
        status = clip_end(c);
    }

    return status;
}

static wcut_status intersect_face(clip *c, double tolerance) {
    const wcut_vec3 normal = vec3(c->f.axis == 0, c->f.axis == 1, c->f.axis == 2);
    const wcut_vec3 point = vec3_scale(c->f.level, normal);
    wcut_traces *plane;
    wcut_status status = intersect(c->f.surface, point, normal, tolerance, &plane);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < plane->count && status == WCUT_OK; k++) status = clip_trace(c, &plane->trace[k]);
    wcut_vec3 touch = {0, 0, 0};
    if (plane->touching > 0) wcut_surface_eval(c->f.surface, plane->touch_u, plane->touch_v, 0, &touch);
    if (status == WCUT_OK && plane->touching > 0 && !beyond(&c->f, touch)) {
        if (c->to->touching == 0) c->to->touch_u = plane->touch_u, c->to->touch_v = plane->touch_v;
        c->to->touching += plane->touching;
        c->to->loose += plane->loose;
    }
    wcut_traces_destroy(plane);
    return status;
}

wcut_status wcut_surface_intersect_box(const wcut_surface *surface, const wcut_box *block, double tolerance,
                                       wcut_traces **traces) {
    if (!surface || !block || !traces || !is_positive(tolerance) || !vec3_is_finite(block->low) ||
        !vec3_is_finite(block->high) || !(block->low.x < block->high.x) || !(block->low.y < block->high.y) ||
        !(block->low.z < block->high.z))
        return WCUT_BAD_ARGUMENT;

    /* the six faces of the block one after the other */
    clip c = {.to = wcut_alloc(1, sizeof *c.to)};
    if (!c.to) return WCUT_NO_MEMORY;
    wcut_status status = WCUT_OK;
    for (int k = 0; k < 6 && status == WCUT_OK; k++) {
        c.f = (face){.surface = surface, .axis = k / 2, .block = block};
        c.f.level = coordinate(k % 2 ? block->high : block->low, k / 2);
        c.number = k;
        status = intersect_face(&c, tolerance);
    }

    /* all traces or none */
    if (status == WCUT_OK) {
        *traces = c.to;
    } else {
        wcut_traces_destroy(c.to);
    }

    return status;
}
