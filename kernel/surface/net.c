/* Curves side by side over one knot vector, homogeneous: what editing a curve and a surface have in common. */
#include "surface/net.h"

#include <string.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "surface/basis.h"

void wcut_net_clear(wcut_net *net) {
    wcut_free(net->knots);
    wcut_free(net->at);
    *net = (wcut_net){.count = 0};
}

wcut_status wcut_net_new(int degree, int count, int lanes, wcut_net *net) {
    wcut_net n = {.degree = degree, .count = count, .lanes = lanes};
    n.knots = wcut_alloc((size_t)count + degree + 1, sizeof *n.knots);
    n.at = wcut_alloc((size_t)count, (size_t)lanes * sizeof *n.at);
    if (!n.knots || !n.at) {
        wcut_net_clear(&n);
        return WCUT_NO_MEMORY;
    }
    *net = n;
    return WCUT_OK;
}

int wcut_net_multiplicity(const wcut_net *net, double u) {
    int times = 0;
    for (int k = 0; k < net->count + net->degree + 1; k++) times += net->knots[k] == u;
    return times;
}

static wcut_homogeneous net_mix(wcut_homogeneous a, wcut_homogeneous b, double t) {
    return (wcut_homogeneous){(1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y, (1 - t) * a.z + t * b.z,
                              (1 - t) * a.w + t * b.w};
}

/* Boehm 1980: the control points over the span of u become mixtures of neighbours; `net` has room for one more */
static void insert_once(wcut_net *net, double u) {
    const int p = net->degree, lanes = net->lanes, span = wcut_basis_span(p, net->count, net->knots, u);
    wcut_homogeneous *at = net->at;
    memmove(at + (ptrdiff_t)(span + 1) * lanes, at + (ptrdiff_t)span * lanes,
            (size_t)(net->count - span) * (size_t)lanes * sizeof *at);
    for (int i = span; i > span - p; i--) {
        const double share = (u - net->knots[i]) / (net->knots[i + p] - net->knots[i]);
        for (int c = 0; c < lanes; c++) {
            wcut_homogeneous *to = &at[(ptrdiff_t)i * lanes + c];
            *to = net_mix(to[-lanes], *to, share);
        }
    }
    memmove(net->knots + span + 2, net->knots + span + 1, (size_t)(net->count + p - span) * sizeof *net->knots);
    net->knots[span + 1] = u;
    net->count++;
}

wcut_status wcut_net_insert(wcut_net *net, double u, int times) {
    wcut_net more;
    const wcut_status status = wcut_net_new(net->degree, net->count + times, net->lanes, &more);
    if (status != WCUT_OK) return status;
    memcpy(more.knots, net->knots, ((size_t)net->count + net->degree + 1) * sizeof *more.knots);
    memcpy(more.at, net->at, (size_t)net->count * (size_t)net->lanes * sizeof *more.at);
    more.count = net->count;
    for (int k = 0; k < times; k++) insert_once(&more, u);
    wcut_net_clear(net);
    *net = more;
    return WCUT_OK;
}

/* a run of control points with as many knots as they need, from the same index on */
static wcut_status part(const wcut_net *net, int first, int count, wcut_net *result) {
    const wcut_status status = wcut_net_new(net->degree, count, net->lanes, result);
    if (status != WCUT_OK) return status;
    memcpy(result->knots, net->knots + first, ((size_t)count + net->degree + 1) * sizeof *net->knots);
    memcpy(result->at, net->at + (ptrdiff_t)first * net->lanes, (size_t)count * (size_t)net->lanes * sizeof *net->at);
    return WCUT_OK;
}

wcut_status wcut_net_split(const wcut_net *net, double u, wcut_net *low, wcut_net *high) {
    wcut_net whole = {.count = 0}, a = {.count = 0}, b = {.count = 0};
    wcut_status status = part(net, 0, net->count, &whole);
    if (status == WCUT_OK) status = wcut_net_insert(&whole, u, net->degree - wcut_net_multiplicity(net, u));
    int first = 0; /* of the knots that equal u: the control point before it lies on the curve */
    while (status == WCUT_OK && whole.knots[first] < u) first++;
    if (status == WCUT_OK) status = part(&whole, 0, first, &a);
    if (status == WCUT_OK) status = part(&whole, first - 1, whole.count - first + 1, &b);
    if (status == WCUT_OK) {
        a.knots[first + net->degree] = u;
        b.knots[0] = u;
        *low = a, *high = b;
    } else {
        wcut_net_clear(&a);
    }
    wcut_net_clear(&whole);
    return status;
}

/* from + to - u; rounding must not move the ends of the domain, nor a knot over them */
static double mirrored(double u, double from, double to) {
    if (u == from) return to;
    if (u == to) return from;
    const double m = from + to - u;
    return u > from && u < to ? clamp(m, from, to) : m;
}

void wcut_net_reverse(wcut_net *net) {
    const int last = net->count + net->degree;
    const double from = net->knots[net->degree], to = net->knots[net->count];
    for (int a = 0, b = last; a <= b; a++, b--) {
        const double low = mirrored(net->knots[b], from, to), high = mirrored(net->knots[a], from, to);
        net->knots[a] = low, net->knots[b] = high;
    }
    for (int a = 0, b = net->count - 1; a < b; a++, b--)
        for (int c = 0; c < net->lanes; c++) {
            wcut_homogeneous *p = &net->at[(ptrdiff_t)a * net->lanes + c], *q = &net->at[(ptrdiff_t)b * net->lanes + c];
            const wcut_homogeneous swap = *p;
            *p = *q, *q = swap;
        }
}
