/* Curves and surfaces made from others: a surface is a net of curves along either direction. */
#include <limits.h>
#include <wirecut/edit.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "surface/basis.h"
#include "surface/net.h"
#include "surface/net_shape.h"

static bool is_direction(wcut_direction d) { return d == WCUT_DIRECTION_U || d == WCUT_DIRECTION_V; }

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
    wcut_status status = wcut_net_of_curve(curve, &net);
    if (status == WCUT_OK && !may_insert(&net, u, times)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_insert(&net, u, times);
    if (status == WCUT_OK) status = wcut_curve_of_net(&net, curve->weights != NULL, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_curve_split(const wcut_curve *curve, double u, wcut_curve **low, wcut_curve **high) {
    if (!curve || !low || !high) return WCUT_BAD_ARGUMENT;
    wcut_net net = {.count = 0}, a = {.count = 0}, b = {.count = 0};
    wcut_curve *first = NULL;
    wcut_status status = wcut_net_of_curve(curve, &net);
    if (status == WCUT_OK && !may_split(&net, u)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_split(&net, u, &a, &b);
    if (status == WCUT_OK) status = wcut_curve_of_net(&a, curve->weights != NULL, &first);
    if (status == WCUT_OK) status = wcut_curve_of_net(&b, curve->weights != NULL, high);
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
    wcut_status status = wcut_net_of_curve(curve, &net);
    if (status != WCUT_OK) return status;
    wcut_net_reverse(&net);
    status = wcut_curve_of_net(&net, curve->weights != NULL, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_insert_knot(const wcut_surface *surface, wcut_direction direction, double at, int times,
                                     wcut_surface **result) {
    if (!surface || !result || !is_direction(direction)) return WCUT_BAD_ARGUMENT;
    wcut_net net = {.count = 0};
    wcut_status status = wcut_net_of_surface(surface, direction, &net);
    if (status == WCUT_OK && !may_insert(&net, at, times)) status = WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) status = wcut_net_insert(&net, at, times);
    if (status == WCUT_OK) status = wcut_surface_of_net(&net, direction, surface, false, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_split(const wcut_surface *surface, wcut_direction direction, double at, wcut_surface **low,
                               wcut_surface **high) {
    if (!surface || !low || !high || !is_direction(direction)) return WCUT_BAD_ARGUMENT;

    /* the surface as a net of curves along the direction, cut in two */
    wcut_net net = {.count = 0}, a = {.count = 0}, b = {.count = 0};
    wcut_surface *first = NULL;
    wcut_status status = wcut_net_of_surface(surface, direction, &net);
    if (status == WCUT_OK && !may_split(&net, at)) status = WCUT_BAD_ARGUMENT;

    /* both parts, or neither */
    if (status == WCUT_OK) status = wcut_net_split(&net, at, &a, &b);
    if (status == WCUT_OK) status = wcut_surface_of_net(&a, direction, surface, false, &first);
    if (status == WCUT_OK) status = wcut_surface_of_net(&b, direction, surface, false, high);
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
    wcut_status status = wcut_net_of_surface(surface, direction, &net);
    if (status != WCUT_OK) return status;
    wcut_net_reverse(&net);
    status = wcut_surface_of_net(&net, direction, surface, false, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_transpose(const wcut_surface *surface, wcut_surface **result) {
    if (!surface || !result) return WCUT_BAD_ARGUMENT;
    wcut_net net;
    wcut_status status = wcut_net_of_surface(surface, WCUT_DIRECTION_U, &net);
    if (status != WCUT_OK) return status;
    status = wcut_surface_of_net(&net, WCUT_DIRECTION_U, surface, true, result);
    wcut_net_clear(&net);
    return status;
}

wcut_status wcut_surface_iso_curve(const wcut_surface *surface, wcut_direction along, double at, wcut_curve **result) {
    if (!surface || !result || !is_direction(along)) return WCUT_BAD_ARGUMENT;

    /* control points as a net across the curve */
    wcut_net across = {.count = 0}, net = {.count = 0};
    wcut_status status =
        wcut_net_of_surface(surface, along == WCUT_DIRECTION_U ? WCUT_DIRECTION_V : WCUT_DIRECTION_U, &across);
    if (status != WCUT_OK) return status;
    const bool inside = at >= across.knots[across.degree] && at <= across.knots[across.count];

    /* fold the net at the parameter: the basis functions across weigh its rows */
    const int degree = along == WCUT_DIRECTION_U ? surface->degree_u : surface->degree_v;
    status = inside ? wcut_net_new(degree, across.lanes, 1, &net) : WCUT_BAD_ARGUMENT;
    if (status == WCUT_OK) {
        wcut_basis basis;
        wcut_basis_eval(across.degree, across.count, across.knots, at, 0, &basis);
        const double *knots = along == WCUT_DIRECTION_U ? surface->knots_u : surface->knots_v;

        /* knots along the curve are the surface's; degree + 1 rows across carry weight */
        for (int k = 0; k < net.count + degree + 1; k++) net.knots[k] = knots[k];
        for (int r = 0; r <= across.degree; r++)
            for (int c = 0; c < net.count; c++) {
                const wcut_homogeneous h = across.at[(ptrdiff_t)(basis.span - across.degree + r) * across.lanes + c];
                const double b = basis.value[0][r];
                net.at[c].x += b * h.x, net.at[c].y += b * h.y, net.at[c].z += b * h.z, net.at[c].w += b * h.w;
            }

        status = wcut_curve_of_net(&net, surface->weights != NULL, result);
    }
    wcut_net_clear(&net);
    wcut_net_clear(&across);

    return status;
}
