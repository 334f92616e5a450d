/* Curves and surfaces of a higher degree, joined end to end, and moved. */
#include <limits.h>
#include <string.h>
#include <wirecut/reshape.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/basis.h"
#include "surface/blossom.h"
#include "surface/net_shape.h"

/* Knots of two surfaces nearer than this share of the domain are one. */
static const double SAME_KNOT = 1e-12;

/* Edges whose weights are in one proportion to this are the same rational curve. */
static const double SAME_WEIGHT = 1e-9;

/* ---- degree --------------------------------------------------------------------------------------------------------- */

/* raise the degree `times` times; WCUT_BAD_ARGUMENT where the result would have too many control points for a shape */
static wcut_status elevate(wcut_net *net, int times) {
    wcut_status status = WCUT_OK;
    for (int k = 0; k < times && status == WCUT_OK; k++)
        status = wcut_net_elevated_count(net) <= INT_MAX / 8 / net->lanes ? wcut_net_elevate(net) : WCUT_BAD_ARGUMENT;
    return status;
}

wcut_status wcut_curve_elevate(const wcut_curve *curve, int times, wcut_curve **result) {
    if (!curve || !result || times < 1 || times > WCUT_DEGREE_MAX - curve->degree) return WCUT_BAD_ARGUMENT;
    wcut_net net;
    wcut_status status = wcut_net_of_curve(curve, &net);
    if (status != WCUT_OK) return status;
    status = elevate(&net, times);
    if (status == WCUT_OK) status = wcut_curve_of_net(&net, curve->weights != NULL, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_elevate(const wcut_surface *surface, wcut_direction direction, int times,
                                 wcut_surface **result) {
    if (!surface || !result || (direction != WCUT_DIRECTION_U && direction != WCUT_DIRECTION_V) || times < 1 ||
        times > WCUT_DEGREE_MAX - (direction == WCUT_DIRECTION_U ? surface->degree_u : surface->degree_v))
        return WCUT_BAD_ARGUMENT;
    wcut_net net;
    wcut_status status = wcut_net_of_surface(surface, direction, &net);
    if (status != WCUT_OK) return status;
    status = elevate(&net, times);
    if (status == WCUT_OK) status = wcut_surface_of_net(&net, direction, surface, false, result);
    wcut_net_clear(&net);
    return status;
}

/* ---- joining -------------------------------------------------------------------------------------------------------- */

static wcut_vec3 space(const wcut_homogeneous *h) { return vec3(h->x / h->w, h->y / h->w, h->z / h->w); }

/* mean |dC/du| at an end, but for the degree: |P_1 - P_0| w_1 / w_0 over the knots' step */
static double edge_speed(const wcut_net *net, bool at_end) {
    const wcut_homogeneous *end = at_end ? net->at + (ptrdiff_t)(net->count - 1) * net->lanes : net->at;
    const wcut_homogeneous *inner = at_end ? end - net->lanes : end + net->lanes;
    const double *t = at_end ? &net->knots[net->count - 1] : &net->knots[1];
    double sum = 0;
    for (int c = 0; c < net->lanes; c++) sum += vec3_distance(space(&end[c]), space(&inner[c])) * inner[c].w / end[c].w;
    return sum / (t[net->degree] - t[0]);
}

/* the widest gap between where one net ends and the next begins; false where the weights are not in one proportion */
static bool measure_gap(const wcut_net *low, const wcut_net *high, double *gap) {
    const wcut_homogeneous *p = low->at + (ptrdiff_t)(low->count - 1) * low->lanes, *q = high->at;
    const double ratio = p[0].w / q[0].w;
    bool same = true;
    for (int c = 0; c < low->lanes; c++) {
        *gap = fmax(*gap, vec3_distance(space(&p[c]), space(&q[c])));
        same = same && fabs(q[c].w * ratio / p[c].w - 1) <= SAME_WEIGHT;
    }
    return same;
}

/* `low` followed by `high`, both clamped, of one degree and lanes */
static wcut_status reshape_append(const wcut_net *low, const wcut_net *high, wcut_net *result) {
    const int p = low->degree, lanes = low->lanes;

    /* counts must fit */
    if (high->count - 1 > INT_MAX / 8 / lanes - low->count) return WCUT_BAD_ARGUMENT;
    wcut_net n;
    const wcut_status status = wcut_net_new(p, low->count + high->count - 1, lanes, &n);
    if (status != WCUT_OK) return status;

    /* stretch the parameters of the second so that the speed is the same at the joint */
    const double before = edge_speed(low, true), after = edge_speed(high, false), start = low->knots[low->count];
    const double ratio = after / before, stretch = is_positive(ratio) && is_positive(1 / ratio) ? ratio : 1;

    /* knots, then control points with the weights scaled to agree at the joint */
    memcpy(n.knots, low->knots, (size_t)(low->count + p) * sizeof *n.knots);
    for (int k = p + 1; k < high->count + p + 1; k++)
        n.knots[low->count + k - 1] = start + stretch * (high->knots[k] - high->knots[p]);
    const wcut_homogeneous *end = low->at + (ptrdiff_t)(low->count - 1) * lanes;
    const double weight = end->w / high->at->w;
    memcpy(n.at, low->at, (size_t)low->count * (size_t)lanes * sizeof *n.at);
    for (ptrdiff_t k = lanes; k < (ptrdiff_t)high->count * lanes; k++) {
        const wcut_homogeneous *h = &high->at[k];
        n.at[(ptrdiff_t)(low->count - 1) * lanes + k] =
            (wcut_homogeneous){weight * h->x, weight * h->y, weight * h->z, weight * h->w};
    }

    *result = n;

    return wcut_knots_are_valid(p, n.count, n.knots) ? WCUT_OK : WCUT_DEGENERATE; /* a domain lost to rounding */
}

static wcut_status append_in_place(wcut_net *low, const wcut_net *high) {
    wcut_net both = {.count = 0};
    const wcut_status status = reshape_append(low, high, &both);
    if (status == WCUT_OK) {
        wcut_net_clear(low);
        *low = both;
    } else {
        wcut_net_clear(&both);
    }
    return status;
}

/* a curve as a clamped net of the given degree */
static wcut_status net_of_degree(const wcut_curve *curve, int degree, wcut_net *net) {
    wcut_status status = wcut_net_of_curve(curve, net);
    if (status != WCUT_OK) return status;
    status = wcut_net_clamp(net);
    if (status == WCUT_OK) status = elevate(net, degree - curve->degree);
    return status;
}

wcut_status wcut_curve_join(int count, const wcut_curve *const *curve, double tolerance, wcut_curve **result,
                            double *gap) {
    if (count < 1 || !curve || !result || !(isfinite(tolerance) && tolerance >= 0)) return WCUT_BAD_ARGUMENT;

    /* the highest degree of all curves */
    int degree = 1;
    bool rational = false;
    for (int k = 0; k < count; k++) {
        if (!curve[k]) return WCUT_BAD_ARGUMENT;
        if (curve[k]->degree > degree) degree = curve[k]->degree;
        rational = rational || curve[k]->weights;
    }

    /* one after the other, and the widest gap */
    wcut_net all = {.count = 0}, next = {.count = 0};
    double widest = 0;
    wcut_status status = net_of_degree(curve[0], degree, &all);
    for (int k = 1; k < count && status == WCUT_OK; k++) {
        status = net_of_degree(curve[k], degree, &next);
        if (status == WCUT_OK) measure_gap(&all, &next, &widest);
        if (status == WCUT_OK) status = append_in_place(&all, &next);
        wcut_net_clear(&next);
    }

    /* gaps beyond the tolerance refuse the join, and are reported */
    if (status == WCUT_OK && widest > tolerance) status = WCUT_DEGENERATE;
    if (status == WCUT_OK) status = wcut_curve_of_net(&all, rational, result);
    if (gap && (status == WCUT_OK || status == WCUT_DEGENERATE)) *gap = widest;
    wcut_net_clear(&all);

    return status;
}

/* knots of `net`, those inside its domain, moved to the domain of `like` and to its knots where they are the same */
static void move_knots(const wcut_net *like, wcut_net *net) {
    const double first = like->knots[like->degree], last = like->knots[like->count], wide = last - first;
    const double own = net->knots[net->degree], end = net->knots[net->count], scale = wide / (end - own);
    int near = 0;
    for (int k = 0; k < net->count + net->degree + 1; k++) {
        const double u = net->knots[k];
        double to = u <= own ? first : u >= end ? last : first + scale * (u - own);
        while (near < like->count + like->degree && like->knots[near] < to - SAME_KNOT * wide) near++;
        if (fabs(like->knots[near] - to) <= SAME_KNOT * wide) to = like->knots[near];
        net->knots[k] = to;
    }
}

/* the knots of two clamped nets over one domain, each as often as it is in either; returns how many */
static int unite_knots(const wcut_net *a, const wcut_net *b, double *knots) {
    const int end_a = a->count + a->degree + 1, end_b = b->count + b->degree + 1;
    int made = 0, i = 0, j = 0;
    while (i < end_a || j < end_b) {
        if (j == end_b || (i < end_a && a->knots[i] < b->knots[j])) {
            knots[made++] = a->knots[i++];
        } else {
            if (i < end_a && a->knots[i] == b->knots[j]) i++;
            knots[made++] = b->knots[j++];
        }
    }
    return made;
}

/* both nets over one knot vector, in place; what was done to them is kept where memory runs out, their shape too */
static wcut_status make_compatible(wcut_net *a, wcut_net *b) {
    /* clamped, and of the same degree */
    wcut_status status = wcut_net_clamp(a);
    if (status == WCUT_OK) status = wcut_net_clamp(b);
    const int degree = a->degree > b->degree ? a->degree : b->degree;
    if (status == WCUT_OK) status = elevate(a, degree - a->degree);
    if (status == WCUT_OK) status = elevate(b, degree - b->degree);
    if (status != WCUT_OK) return status;

    /* the same domain, then the union of both knot vectors */
    move_knots(a, b);
    double *knots = wcut_alloc((size_t)a->count + b->count + 2 * (size_t)degree + 2, sizeof *knots);
    if (!knots) return WCUT_NO_MEMORY;
    const int count = unite_knots(a, b, knots) - degree - 1;

    wcut_net *const net[2] = {a, b};
    for (int k = 0; k < 2 && status == WCUT_OK; k++) {
        wcut_net more;
        status = count <= INT_MAX / 8 / net[k]->lanes ? wcut_net_rewrite(net[k], degree, count, knots, &more)
                                                      : WCUT_BAD_ARGUMENT;
        if (status != WCUT_OK) break;
        wcut_net_clear(net[k]);
        *net[k] = more;
    }

    wcut_free(knots);
    return status;
}

/* surfaces from nets across, as nets along the other direction, of one degree there */
static wcut_status turn_nets(const wcut_net *across, wcut_direction direction, const wcut_surface *const *from,
                             wcut_net *along) {
    const wcut_direction other = direction == WCUT_DIRECTION_U ? WCUT_DIRECTION_V : WCUT_DIRECTION_U;
    wcut_status status = WCUT_OK;
    for (int k = 0; k < 2 && status == WCUT_OK; k++) {
        wcut_surface *s;
        status = wcut_surface_of_net(&across[k], other, from[k], false, &s);
        if (status == WCUT_OK) {
            status = wcut_net_of_surface(s, direction, &along[k]);
            wcut_surface_destroy(s);
        }
        if (status == WCUT_OK) status = wcut_net_clamp(&along[k]);
    }
    if (status != WCUT_OK) return status;
    const int degree = along[0].degree > along[1].degree ? along[0].degree : along[1].degree;
    for (int k = 0; k < 2 && status == WCUT_OK; k++) status = elevate(&along[k], degree - along[k].degree);
    return status;
}

wcut_status wcut_surface_join(const wcut_surface *low, const wcut_surface *high, wcut_direction direction,
                              double tolerance, wcut_surface **result, double *gap) {
    if (!low || !high || !result || (direction != WCUT_DIRECTION_U && direction != WCUT_DIRECTION_V) ||
        !(isfinite(tolerance) && tolerance >= 0))
        return WCUT_BAD_ARGUMENT;

    /* compatible in the other direction first */
    const wcut_surface *const from[2] = {low, high};
    const wcut_direction other = direction == WCUT_DIRECTION_U ? WCUT_DIRECTION_V : WCUT_DIRECTION_U;
    wcut_net across[2] = {{.count = 0}}, along[2] = {{.count = 0}};
    wcut_surface *edge = NULL;
    double widest = 0;
    wcut_status status = wcut_net_of_surface(low, other, &across[0]);
    if (status == WCUT_OK) status = wcut_net_of_surface(high, other, &across[1]);
    if (status == WCUT_OK) status = make_compatible(&across[0], &across[1]);
    if (status == WCUT_OK) status = turn_nets(across, direction, from, along);

    /* the gap between both sides, then append */
    if (status == WCUT_OK) {
        const bool same = measure_gap(&along[0], &along[1], &widest);
        status = same && widest <= tolerance ? append_in_place(&along[0], &along[1]) : WCUT_DEGENERATE;
        if (gap && (status == WCUT_OK || status == WCUT_DEGENERATE)) *gap = widest;
    }
    /* a surface with the other direction's knots, to hand these on */
    if (status == WCUT_OK) status = wcut_surface_of_net(&across[0], other, low->weights ? low : high, false, &edge);
    if (status == WCUT_OK) status = wcut_surface_of_net(&along[0], direction, edge, false, result);

    wcut_surface_destroy(edge);
    for (int k = 0; k < 2; k++) {
        wcut_net_clear(&along[k]);
        wcut_net_clear(&across[k]);
    }

    return status;
}

/* ---- moving --------------------------------------------------------------------------------------------------------- */

static bool is_finite_map(const wcut_affine *m) {
    return m && vec3_is_finite(m->x) && vec3_is_finite(m->y) && vec3_is_finite(m->z) && vec3_is_finite(m->shift);
}

static bool move_points(const wcut_affine *m, int count, wcut_vec3 *p) {
    for (int k = 0; k < count; k++)
        p[k] = vec3_add(vec3(vec3_dot(m->x, p[k]), vec3_dot(m->y, p[k]), vec3_dot(m->z, p[k])), m->shift);
    return vec3_all_finite(count, p);
}

wcut_status wcut_curve_transform(const wcut_curve *curve, const wcut_affine *map, wcut_curve **result) {
    if (!curve || !result || !is_finite_map(map)) return WCUT_BAD_ARGUMENT;
    wcut_curve *c;
    const wcut_status status =
        wcut_curve_create(curve->degree, curve->control_count, curve->knots, curve->control, curve->weights, &c);
    if (status != WCUT_OK) return status;
    if (!move_points(map, c->control_count, c->control)) {
        wcut_curve_destroy(c);
        return WCUT_DEGENERATE;
    }
    *result = c;
    return WCUT_OK;
}

wcut_status wcut_surface_transform(const wcut_surface *surface, const wcut_affine *map, wcut_surface **result) {
    if (!surface || !result || !is_finite_map(map)) return WCUT_BAD_ARGUMENT;
    wcut_surface *s;
    const wcut_status status =
        wcut_surface_create(surface->degree_u, surface->degree_v, surface->count_u, surface->count_v, surface->knots_u,
                            surface->knots_v, surface->control, surface->weights, &s);
    if (status != WCUT_OK) return status;
    if (!move_points(map, s->count_u * s->count_v, s->control)) {
        wcut_surface_destroy(s);
        return WCUT_DEGENERATE;
    }
    *result = s;
    return WCUT_OK;
}
