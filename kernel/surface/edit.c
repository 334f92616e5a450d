/* Curves and surfaces made from others: a surface is a net of curves along either direction. */
#include <limits.h>
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/basis.h"
#include "surface/net.h"

static wcut_homogeneous lift(wcut_vec3 p, double w) { return (wcut_homogeneous){w * p.x, w * p.y, w * p.z, w}; }

static wcut_vec3 drop(const wcut_homogeneous *h, bool rational) {
    return rational ? vec3(h->x / h->w, h->y / h->w, h->z / h->w) : vec3(h->x, h->y, h->z);
}

static wcut_status net_of_curve(const wcut_curve *c, wcut_net *net) {
    const wcut_status status = wcut_net_new(c->degree, c->control_count, 1, net);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < c->control_count + c->degree + 1; k++) net->knots[k] = c->knots[k];
    for (int k = 0; k < c->control_count; k++) net->at[k] = lift(c->control[k], c->weights ? c->weights[k] : 1);
    return WCUT_OK;
}

static wcut_status curve_of_net(const wcut_net *net, bool rational, wcut_curve **curve) {
    wcut_curve *c;
    const wcut_status status = wcut_curve_new(net->degree, net->count, rational, &c);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < net->count + net->degree + 1; k++) c->knots[k] = net->knots[k];
    for (int k = 0; k < net->count; k++) {
        c->control[k] = drop(&net->at[k], rational);
        if (rational) c->weights[k] = net->at[k].w;
    }
    *curve = c;
    return WCUT_OK;
}

/* index of control point k along a direction and c across it */
static ptrdiff_t index_of(int count_u, wcut_direction along, int k, int c) {
    return along == WCUT_ALONG_U ? (ptrdiff_t)c * count_u + k : (ptrdiff_t)k * count_u + c;
}

static wcut_status net_of_surface(const wcut_surface *s, wcut_direction along, wcut_net *net) {
    const bool u = along == WCUT_ALONG_U;
    const wcut_status status =
        wcut_net_new(u ? s->degree_u : s->degree_v, u ? s->count_u : s->count_v, u ? s->count_v : s->count_u, net);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < net->count + net->degree + 1; k++) net->knots[k] = u ? s->knots_u[k] : s->knots_v[k];
    for (int k = 0; k < net->count; k++)
        for (int c = 0; c < net->lanes; c++) {
            const ptrdiff_t at = index_of(s->count_u, along, k, c);
            net->at[(ptrdiff_t)k * net->lanes + c] = lift(s->control[at], s->weights ? s->weights[at] : 1);
        }
    return WCUT_OK;
}

/* a net along a direction of `like`, with that surface's other direction; `turned` exchanges the two */
static wcut_status surface_of_net(const wcut_net *net, wcut_direction along, const wcut_surface *like, bool turned,
                                  wcut_surface **surface) {
    const bool u = along == WCUT_ALONG_U, to_u = u != turned;
    const int degree = u ? like->degree_v : like->degree_u;
    const double *knots = u ? like->knots_v : like->knots_u;
    wcut_surface *s;
    const wcut_status status =
        wcut_surface_new(to_u ? net->degree : degree, to_u ? degree : net->degree, to_u ? net->count : net->lanes,
                         to_u ? net->lanes : net->count, like->weights != NULL, &s);
    if (status != WCUT_OK) return status;
    double *own = to_u ? s->knots_u : s->knots_v, *other = to_u ? s->knots_v : s->knots_u;
    for (int k = 0; k < net->count + net->degree + 1; k++) own[k] = net->knots[k];
    for (int k = 0; k < net->lanes + degree + 1; k++) other[k] = knots[k];
    for (int k = 0; k < net->count; k++)
        for (int c = 0; c < net->lanes; c++) {
            const wcut_homogeneous *h = &net->at[(ptrdiff_t)k * net->lanes + c];
            const ptrdiff_t at = index_of(s->count_u, to_u ? WCUT_ALONG_U : WCUT_ALONG_V, k, c);
            s->control[at] = drop(h, s->weights != NULL);
            if (s->weights) s->weights[at] = h->w;
        }
    *surface = s;
    return WCUT_OK;
}

static bool is_direction(wcut_direction d) { return d == WCUT_ALONG_U || d == WCUT_ALONG_V; }

/* strictly inside, and with `times` more at most degree-fold; the result within the size that surfaces may have */
static bool may_insert(const wcut_net *net, double u, int times) {
    return u > net->knots[net->degree] && u < net->knots[net->count] && times >= 1 &&
           times <= net->degree - wcut_net_multiplicity(net, u) && net->count + times <= INT_MAX / 8 / net->lanes;
}

static bool may_split(const wcut_net *net, double u) {
    return u > net->knots[net->degree] && u < net->knots[net->count] &&
           net->count + net->degree <= INT_MAX / 8 / net->lanes;
}

wcut_status wcut_curve_insert_knot(const wcut_curve *curve, double u, int times, wcut_curve **result) {
    if (!curve || !result) return WCUT_BAD_ARGUMENT;
    wcut_net net = {.count = 0};
    wcut_status status = net_of_curve(curve, &net);
    if (status == WCUT_OK && !may_insert(&net, u, times)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_insert(&net, u, times);
    if (status == WCUT_OK) status = curve_of_net(&net, curve->weights != NULL, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_curve_split(const wcut_curve *curve, double u, wcut_curve **low, wcut_curve **high) {
    if (!curve || !low || !high) return WCUT_BAD_ARGUMENT;
    wcut_net net = {.count = 0}, a = {.count = 0}, b = {.count = 0};
    wcut_curve *first = NULL;
    wcut_status status = net_of_curve(curve, &net);
    if (status == WCUT_OK && !may_split(&net, u)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_split(&net, u, &a, &b);
    if (status == WCUT_OK) status = curve_of_net(&a, curve->weights != NULL, &first);
    if (status == WCUT_OK) status = curve_of_net(&b, curve->weights != NULL, high);
    if (status == WCUT_OK) {
        *low = first;
    } else {
        wcut_curve_destroy(first);
    }
    wcut_net_clear(&b);
    wcut_net_clear(&a);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_curve_reverse(const wcut_curve *curve, wcut_curve **result) {
    if (!curve || !result) return WCUT_BAD_ARGUMENT;
    wcut_net net;
    wcut_status status = net_of_curve(curve, &net);
    if (status != WCUT_OK) return status;
    wcut_net_reverse(&net);
    status = curve_of_net(&net, curve->weights != NULL, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_insert_knot(const wcut_surface *surface, wcut_direction direction, double at, int times,
                                     wcut_surface **result) {
    if (!surface || !result || !is_direction(direction)) return WCUT_BAD_ARGUMENT;
    wcut_net net = {.count = 0};
    wcut_status status = net_of_surface(surface, direction, &net);
    if (status == WCUT_OK && !may_insert(&net, at, times)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_insert(&net, at, times);
    if (status == WCUT_OK) status = surface_of_net(&net, direction, surface, false, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_split(const wcut_surface *surface, wcut_direction direction, double at, wcut_surface **low,
                               wcut_surface **high) {
    if (!surface || !low || !high || !is_direction(direction)) return WCUT_BAD_ARGUMENT;
    wcut_net net = {.count = 0}, a = {.count = 0}, b = {.count = 0};
    wcut_surface *first = NULL;
    wcut_status status = net_of_surface(surface, direction, &net);
    if (status == WCUT_OK && !may_split(&net, at)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_split(&net, at, &a, &b);
    if (status == WCUT_OK) status = surface_of_net(&a, direction, surface, false, &first);
    if (status == WCUT_OK) status = surface_of_net(&b, direction, surface, false, high);
    if (status == WCUT_OK) {
        *low = first;
    } else {
        wcut_surface_destroy(first);
    }
    wcut_net_clear(&b);
    wcut_net_clear(&a);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_reverse(const wcut_surface *surface, wcut_direction direction, wcut_surface **result) {
    if (!surface || !result || !is_direction(direction)) return WCUT_BAD_ARGUMENT;
    wcut_net net;
    wcut_status status = net_of_surface(surface, direction, &net);
    if (status != WCUT_OK) return status;
    wcut_net_reverse(&net);
    status = surface_of_net(&net, direction, surface, false, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_transpose(const wcut_surface *surface, wcut_surface **result) {
    if (!surface || !result) return WCUT_BAD_ARGUMENT;
    wcut_net net;
    wcut_status status = net_of_surface(surface, WCUT_ALONG_U, &net);
    if (status != WCUT_OK) return status;
    status = surface_of_net(&net, WCUT_ALONG_U, surface, true, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_iso_curve(const wcut_surface *surface, wcut_direction along, double at, wcut_curve **result) {
    if (!surface || !result || !is_direction(along)) return WCUT_BAD_ARGUMENT;
    wcut_net across = {.count = 0}, net = {.count = 0};
    wcut_status status = net_of_surface(surface, along == WCUT_ALONG_U ? WCUT_ALONG_V : WCUT_ALONG_U, &across);
    if (status != WCUT_OK) return status;
    const bool inside = at >= across.knots[across.degree] && at <= across.knots[across.count];
    const int degree = along == WCUT_ALONG_U ? surface->degree_u : surface->degree_v;
    status = inside ? wcut_net_new(degree, across.lanes, 1, &net) : WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) {
        wcut_basis basis;
        wcut_basis_eval(across.degree, across.count, across.knots, at, 0, &basis);
        const double *knots = along == WCUT_ALONG_U ? surface->knots_u : surface->knots_v;
        for (int k = 0; k < net.count + degree + 1; k++) net.knots[k] = knots[k];
        for (int r = 0; r <= across.degree; r++)
            for (int c = 0; c < net.count; c++) {
                const wcut_homogeneous h = across.at[(ptrdiff_t)(basis.span - across.degree + r) * across.lanes + c];
                const double b = basis.value[0][r];
                net.at[c].x += b * h.x, net.at[c].y += b * h.y, net.at[c].z += b * h.z, net.at[c].w += b * h.w;
            }
        status = curve_of_net(&net, surface->weights != NULL, result);
    }
    wcut_net_clear(&net);
    wcut_net_clear(&across);
    return status;
}
