/* Polar forms of B-splines: the same curves over another knot vector or of a higher degree (Ramshaw 1989).

   Control point i over knots t is f(t_{i+1}, .., t_{i+p}), f the polar form of any piece within its support. The polar
   form of degree p + 1 is the mean of those of degree p that each leave one argument out. */
#include "surface/blossom.h"

#include <stddef.h>

#include "base/alloc.h"
#include "surface/basis.h"

void wcut_blossom(int degree, const double *knots, int span, const double *argument, double *coefficient) {
    const double *t = knots + span;
    coefficient[0] = 1;
    for (int q = 1; q <= degree; q++) { /* de Boor's triangle, each level with an argument of its own */
        const double u = argument[q - 1];
        double saved = 0;
        for (int r = 0; r < q; r++) {
            const double share = coefficient[r] / (t[r + 1] - t[r + 1 - q]);
            coefficient[r] = saved + (t[r + 1] - u) * share;
            saved = (u - t[r + 1 - q]) * share;
        }
        coefficient[q] = saved;
    }
}

/* the old span that holds a piece of the support of new control point i: the middle one of its spans */
static int span_of(int old_degree, int old_count, const double *old_knots, int degree, const double *knots, int i) {
    int low = i, high = i + degree;
    while (!(knots[low] < knots[low + 1])) low++;
    while (!(knots[high] < knots[high + 1])) high--;
    int k = (low + high) / 2;
    while (!(knots[k] < knots[k + 1])) k++;
    return wcut_basis_span(old_degree, old_count, old_knots, knots[k] + (knots[k + 1] - knots[k]) / 2);
}

void wcut_blossom_row(int degree, int old_count, const double *old_knots, const double *knots, int i, int *first,
                      double *coefficient) {
    const int span = span_of(degree, old_count, old_knots, degree, knots, i);
    *first = span - degree;
    wcut_blossom(degree, old_knots, span, knots + i + 1, coefficient);
}

/* as wcut_blossom_row, the new degree one higher */
static void elevated_row(const wcut_net *net, const double *knots, int i, int *first, double *coefficient) {
    const int p = net->degree, span = span_of(p, net->count, net->knots, p + 1, knots, i);
    double argument[WCUT_BASIS_SIZE], one[WCUT_BASIS_SIZE];
    for (int r = 0; r <= p; r++) coefficient[r] = 0;
    for (int left_out = 1; left_out <= p + 1; left_out++) {
        for (int k = 1, to = 0; k <= p + 1; k++)
            if (k != left_out) argument[to++] = knots[i + k];
        wcut_blossom(p, net->knots, span, argument, one);
        for (int r = 0; r <= p; r++) coefficient[r] += one[r] / (p + 1);
    }
    *first = span - p;
}

wcut_status wcut_net_rewrite(const wcut_net *net, int degree, int count, const double *knots, wcut_net *result) {
    /* the result has the knots asked for */
    wcut_net n;
    const wcut_status status = wcut_net_new(degree, count, net->lanes, &n);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < count + degree + 1; k++) n.knots[k] = knots[k];

    /* each new control point is a polar form: a combination of degree + 1 old ones */
    for (int i = 0; i < count; i++) {
        double share[WCUT_BASIS_SIZE] = {0};
        int first;
        if (degree > net->degree) {
            elevated_row(net, knots, i, &first, share);
        } else {
            wcut_blossom_row(degree, net->count, net->knots, knots, i, &first, share);
        }

        wcut_homogeneous *to = n.at + (ptrdiff_t)i * n.lanes;
        for (int r = 0; r <= net->degree; r++) {
            const wcut_homogeneous *from = net->at + (ptrdiff_t)(first + r) * n.lanes;
            for (int c = 0; c < n.lanes && share[r] != 0; c++) {
                to[c].x += share[r] * from[c].x, to[c].y += share[r] * from[c].y;
                to[c].z += share[r] * from[c].z, to[c].w += share[r] * from[c].w;
            }
        }
    }
    *result = n;

    return WCUT_OK;
}

/* The ends of the domain degree + 1 times, what lies between `more` times more often than in the net. Returns the number
   of knots; `knots` may be NULL. */
static int clamped_knots(const wcut_net *net, int degree, int more, double *knots) {
    const double first = net->knots[net->degree], last = net->knots[net->count];
    int made = 0;
    for (int k = 0; k <= degree; k++, made++)
        if (knots) knots[made] = first;
    for (int k = net->degree; k <= net->count; k++) {
        const double u = net->knots[k];
        if (!(u > first && u < last)) continue;
        const int copies = net->knots[k + 1] > u ? 1 + more : 1;
        for (int c = 0; c < copies; c++, made++)
            if (knots) knots[made] = u;
    }
    for (int k = 0; k <= degree; k++, made++)
        if (knots) knots[made] = last;
    return made;
}

int wcut_net_elevated_count(const wcut_net *net) {
    return clamped_knots(net, net->degree + 1, 1, NULL) - net->degree - 2;
}

static wcut_status rewrite_clamped(wcut_net *net, int degree, int more) {
    const int knot_count = clamped_knots(net, degree, more, NULL);
    double *knots = wcut_alloc((size_t)knot_count, sizeof *knots);
    if (!knots) return WCUT_NO_MEMORY;
    clamped_knots(net, degree, more, knots);
    wcut_net result;
    const wcut_status status = wcut_net_rewrite(net, degree, knot_count - degree - 1, knots, &result);
    wcut_free(knots);
    if (status != WCUT_OK) return status;
    wcut_net_clear(net);
    *net = result;
    return WCUT_OK;
}

wcut_status wcut_net_clamp(wcut_net *net) {
    const int p = net->degree, n = net->count;
    if (net->knots[0] == net->knots[p] && net->knots[n] == net->knots[n + p]) return WCUT_OK;
    return rewrite_clamped(net, p, 0);
}

wcut_status wcut_net_elevate(wcut_net *net) { return rewrite_clamped(net, net->degree + 1, 1); }
