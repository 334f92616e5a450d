/* Knots removed within a tolerance (Lyche, Moerken 1988): ranked, a batch at a time, the rest by least squares.

   A coarser spline is a finer one with control points A c (knot insertion), so |A c - b| bounds the distance of the two
   everywhere. Of rational curves, seen from their middle, |P - P~| <= (|dA| + R |dw|) / w~ (A = w P, |P| <= R). */
#include <stdlib.h>
#include <string.h>
#include <wirecut/reshape.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/band_fit.h"
#include "surface/basis.h"
#include "surface/blossom.h"
#include "surface/net_shape.h"

enum { ROUNDS_MAX = 60 };

static double length4(wcut_homogeneous h) { return sqrt(h.x * h.x + h.y * h.y + h.z * h.z + h.w * h.w); }

static wcut_homogeneous combine_points(double a, wcut_homogeneous p, double b, wcut_homogeneous q) {
    return (wcut_homogeneous){a * p.x + b * q.x, a * p.y + b * q.y, a * p.z + b * q.z, a * p.w + b * q.w};
}

/* What removing one copy of knots[r], the last of its equals, changes in a lane: control points solved for from both
   sides, and how little they meet (Tiller 1992). */
static double removal_change(const wcut_net *net, int r, int copies, int lane) {
    const int p = net->degree, first = r - p, last = r - copies, off = first - 1;
    const double u = net->knots[r], *t = net->knots;
    wcut_homogeneous side[2 * WCUT_BASIS_SIZE + 1];
    const wcut_homogeneous *at = net->at + lane;
    const ptrdiff_t lanes = net->lanes;
    int i = first, j = last, ii = 1, jj = last - off;
    side[0] = at[off * lanes];
    side[last + 1 - off] = at[(last + 1) * lanes];
    for (; j > i; i++, ii++, j--, jj--) {
        const double a = (u - t[i]) / (t[i + p + 1] - t[i]), b = (u - t[j]) / (t[j + p + 1] - t[j]);
        side[ii] = combine_points(1 / a, at[i * lanes], -(1 - a) / a, side[ii - 1]);
        side[jj] = combine_points(1 / (1 - b), at[j * lanes], -b / (1 - b), side[jj + 1]);
    }
    if (j < i) return length4(combine_points(1, side[ii - 1], -1, side[jj + 1]));
    const double a = (u - t[i]) / (t[i + p + 1] - t[i]);
    return length4(combine_points(1, at[i * lanes], -1, combine_points(a, side[ii + 1], 1 - a, side[ii - 1])));
}

/* a distinct knot inside the domain */
typedef struct candidate {
    int index; /* of its last copy in the knots */
    int order; /* among the distinct knots */
    double change;
} candidate;

static int by_change(const void *a, const void *b) {
    const candidate *p = a, *q = b;
    if (p->change != q->change) return p->change < q->change ? -1 : 1;
    return p->order - q->order;
}

/* the interior knots of a net, those first whose removal changes least; returns how many change less than `max` */
static int knot_removal_rank(const wcut_net *net, double max, candidate *list, bool *taken) {
    /* each distinct interior knot: what its removal would change */
    int count = 0, order = 0;
    for (int r = net->degree + 1, copies = 1; r < net->count; r++) {
        if (net->knots[r + 1] == net->knots[r]) {
            copies++;
            continue;
        }
        double change = 0;
        for (int c = 0; c < net->lanes && change <= max; c++) change = fmax(change, removal_change(net, r, copies, c));
        if (change <= max) list[count++] = (candidate){.index = r, .order = order, .change = change};
        order++;
        copies = 1;
    }

    /* the least change first */
    qsort(list, (size_t)count, sizeof *list, by_change);

    for (int k = 0; k < order; k++) taken[k] = false;
    int kept = 0;
    for (int k = 0; k < count; k++) { /* neighbours are not removed in one batch: each was ranked as if alone */
        const int at = list[k].order;
        if ((at > 0 && taken[at - 1]) || (at + 1 < order && taken[at + 1])) continue;
        taken[at] = true;
        list[kept++] = list[k];
    }

    return kept;
}

/* what is fitted: the original, seen from its middle */
typedef struct target {
    const wcut_net *fine;
    wcut_vec3 middle;
    double radius; /* of the control points about the middle */
    bool rational;
} target;

static double bound_error(const target *t, const wcut_band_rows *a, const wcut_homogeneous *coarse) {
    const int lanes = t->fine->lanes;

    /* each fine control point less its combination of coarse ones */
    double max = 0, max_w = 0, min = INFINITY;
    for (int i = 0; i < a->rows; i++)
        for (int c = 0; c < lanes; c++) {
            wcut_homogeneous d = t->fine->at[(ptrdiff_t)i * lanes + c];
            double weight = 0;
            for (int r = 0; r < a->width; r++) {
                const wcut_homogeneous *h = &coarse[(ptrdiff_t)(a->first[i] + r) * lanes + c];
                d = combine_points(1, d, -a->value[(ptrdiff_t)i * a->width + r], *h);
                weight += a->value[(ptrdiff_t)i * a->width + r] * h->w;
            }

            /* the error in space, seen from the middle of the control points */
            if (!t->rational) d.w = 0;
            const wcut_vec3 off = vec3_add_scaled(vec3(d.x, d.y, d.z), -d.w, t->middle);
            max = fmax(max, vec3_length(off));
            max_w = fmax(max_w, fabs(d.w));
            min = fmin(min, weight);
        }

    /* polynomial: the largest difference; rational: (max |dA| + R max |dw|) / min w (NOTATION.md, Surfaces) */
    if (!t->rational) return max;

    return min > 0 ? (max + t->radius * max_w) / min : INFINITY;
}

/* the control points over fewer knots, and how far off they are at most; INFINITY where there is no such curve */
static wcut_status fit_coarse(const target *t, wcut_net *coarse, double *error) {
    const wcut_net *fine = t->fine;
    const int p = fine->degree;

    /* rows of the polar forms: fine control points as combinations of coarse ones */
    int *first = wcut_alloc((size_t)fine->count, sizeof *first);
    double *value = wcut_alloc((size_t)fine->count, (size_t)(p + 1) * sizeof *value);
    wcut_status status = first && value ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) {
        const wcut_band_rows a = {.rows = fine->count, .width = p + 1, .first = first, .value = value};
        for (int i = 0; i < fine->count; i++)
            wcut_blossom_row(p, coarse->count, coarse->knots, fine->knots, i, &first[i],
                             value + (ptrdiff_t)i * (p + 1));

        /* least squares; a singular system means that there is no such curve */
        status = wcut_band_fit(&a, coarse->count, 4 * fine->lanes, &fine->at->x, &coarse->at->x);
        if (status == WCUT_OK) *error = bound_error(t, &a, coarse->at);
        if (status == WCUT_SINGULAR) *error = INFINITY, status = WCUT_OK;

        /* weights must stay positive */
        for (ptrdiff_t k = 0; t->rational && k < (ptrdiff_t)coarse->count * coarse->lanes; k++)
            if (!(coarse->at[k].w > 0)) *error = INFINITY;
    }

    wcut_free(value);
    wcut_free(first);
    return status;
}

/* `net` without one copy of each of the first `count` knots of a list */
static wcut_status without(const wcut_net *net, const candidate *list, int count, wcut_net *result) {
    wcut_net n;
    const wcut_status status = wcut_net_new(net->degree, net->count - count, net->lanes, &n);
    if (status != WCUT_OK) return status;
    bool *gone = wcut_alloc((size_t)net->count + net->degree + 1, sizeof *gone);
    if (!gone) {
        wcut_net_clear(&n);
        return WCUT_NO_MEMORY;
    }
    for (int k = 0; k < count; k++) gone[list[k].index] = true;
    for (int k = 0, to = 0; k < net->count + net->degree + 1; k++)
        if (!gone[k]) n.knots[to++] = net->knots[k];
    wcut_free(gone);
    *result = n;
    return WCUT_OK;
}

/* remove the whole of a list, or else its first half, quarter, ..; *removed 0 where not even the first can go */
static wcut_status remove_batch(const target *t, double tolerance, const candidate *list, int count, wcut_net *net,
                                double *error, int *removed) {
    *removed = 0;
    for (int take = count; take > 0; take /= 2) {
        wcut_net fewer = {.count = 0};
        double off = INFINITY;
        wcut_status status = without(net, list, take, &fewer);
        if (status == WCUT_OK) status = fit_coarse(t, &fewer, &off);
        if (status == WCUT_OK && off <= tolerance) {
            wcut_net_clear(net);
            *net = fewer;
            *error = off, *removed = take;
            return WCUT_OK;
        }
        wcut_net_clear(&fewer);
        if (status != WCUT_OK) return status;
    }
    return WCUT_OK;
}

/* in place; *error: the bound, 0 where nothing was removed */
static wcut_status knot_removal_thin(wcut_net *net, bool rational, double tolerance, double *error) {
    *error = 0;
    wcut_status status = wcut_net_clamp(net);
    if (status != WCUT_OK) return status;

    /* every error is against the net as it came, so that batches do not add up */
    wcut_net fine = *net, coarse = {.count = 0};
    const size_t max = (size_t)net->count;
    candidate *list = wcut_alloc(max, sizeof *list);
    bool *taken = wcut_alloc(max, sizeof *taken);
    target t = {.fine = &fine, .rational = rational};
    wcut_vec3 low = vec3(INFINITY, INFINITY, INFINITY), high = vec3(-INFINITY, -INFINITY, -INFINITY);

    /* the middle and the radius of the control points, for errors of rational nets */
    for (ptrdiff_t k = 0; k < (ptrdiff_t)fine.count * fine.lanes; k++) {
        const wcut_homogeneous *h = &fine.at[k];
        const wcut_vec3 p = vec3(h->x / h->w, h->y / h->w, h->z / h->w);
        low = vec3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = vec3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    t.middle = vec3_mix(low, high, 0.5);
    t.radius = vec3_distance(low, high) / 2;

    /* remove batches of knots until none is left that may go */
    status = list && taken ? without(&fine, NULL, 0, &coarse) : WCUT_NO_MEMORY;
    if (status == WCUT_OK) memcpy(coarse.at, fine.at, max * (size_t)fine.lanes * sizeof *fine.at);
    for (int round = 0, removed = 1; status == WCUT_OK && removed > 0 && round < ROUNDS_MAX; round++) {
        const int count = knot_removal_rank(&coarse, 4 * tolerance, list, taken);
        status = remove_batch(&t, tolerance, list, count, &coarse, error, &removed);
    }

    /* the net is replaced only where everything went well */
    if (status == WCUT_OK) {
        wcut_net_clear(net);
        *net = coarse;
    } else {
        wcut_net_clear(&coarse);
    }

    wcut_free(taken);
    wcut_free(list);
    return status;
}

wcut_status wcut_curve_remove_knots(const wcut_curve *curve, double tolerance, wcut_curve **result, double *error) {
    if (!curve || !result || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    wcut_net net;
    double off = 0;
    wcut_status status = wcut_net_of_curve(curve, &net);
    if (status != WCUT_OK) return status;
    status = knot_removal_thin(&net, curve->weights != NULL, tolerance, &off);
    if (status == WCUT_OK) status = wcut_curve_of_net(&net, curve->weights != NULL, result);
    if (status == WCUT_OK && error) *error = off;
    wcut_net_clear(&net);
    return status;
}

/* one direction after the other: what the first leaves of the tolerance is the second's */
wcut_status wcut_surface_remove_knots(const wcut_surface *surface, double tolerance, wcut_surface **result,
                                      double *error) {
    if (!surface || !result || !is_positive(tolerance)) return WCUT_BAD_ARGUMENT;
    const bool rational = surface->weights != NULL;
    wcut_surface *half = NULL;
    wcut_net net = {.count = 0};
    double off_u = 0, off_v = 0;
    wcut_status status = wcut_net_of_surface(surface, WCUT_DIRECTION_U, &net);
    if (status == WCUT_OK) status = knot_removal_thin(&net, rational, tolerance / 2, &off_u);
    if (status == WCUT_OK) status = wcut_surface_of_net(&net, WCUT_DIRECTION_U, surface, false, &half);
    wcut_net_clear(&net);
    if (status == WCUT_OK) status = wcut_net_of_surface(half, WCUT_DIRECTION_V, &net);
    if (status == WCUT_OK) status = knot_removal_thin(&net, rational, tolerance - off_u, &off_v);
    if (status == WCUT_OK) status = wcut_surface_of_net(&net, WCUT_DIRECTION_V, half, false, result);
    if (status == WCUT_OK && error) *error = off_u + off_v;
    wcut_net_clear(&net);
    wcut_surface_destroy(half);
    return status;
}
