/* Curves and surfaces as nets of homogeneous control points along one direction, and back. */
#include "surface/net_shape.h"

#include "base/alloc.h"
#include "base/vec3.h"

static wcut_homogeneous lift(wcut_vec3 p, double w) { return (wcut_homogeneous){w * p.x, w * p.y, w * p.z, w}; }

static wcut_vec3 drop(const wcut_homogeneous *h, bool rational) {
    return rational ? vec3(h->x / h->w, h->y / h->w, h->z / h->w) : vec3(h->x, h->y, h->z);
}

wcut_status wcut_net_of_curve(const wcut_curve *c, wcut_net *net) {
    const wcut_status status = wcut_net_new(c->degree, c->control_count, 1, net);
    if (status != WCUT_OK) return status;
    for (int k = 0; k < c->control_count + c->degree + 1; k++) net->knots[k] = c->knots[k];
    for (int k = 0; k < c->control_count; k++) net->at[k] = lift(c->control[k], c->weights ? c->weights[k] : 1);
    return WCUT_OK;
}

wcut_status wcut_curve_of_net(const wcut_net *net, bool rational, wcut_curve **curve) {
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
    return along == WCUT_DIRECTION_U ? (ptrdiff_t)c * count_u + k : (ptrdiff_t)k * count_u + c;
}

wcut_status wcut_net_of_surface(const wcut_surface *s, wcut_direction along, wcut_net *net) {
    const bool u = along == WCUT_DIRECTION_U;
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

wcut_status wcut_surface_of_net(const wcut_net *net, wcut_direction along, const wcut_surface *like, bool turned,
                                wcut_surface **surface) {
    const bool u = along == WCUT_DIRECTION_U, to_u = u != turned;

    /* the other direction's degree and knots are those of `like` */
    const int degree = u ? like->degree_v : like->degree_u;
    const double *knots = u ? like->knots_v : like->knots_u;
    wcut_surface *s;
    const wcut_status status =
        wcut_surface_new(to_u ? net->degree : degree, to_u ? degree : net->degree, to_u ? net->count : net->lanes,
                         to_u ? net->lanes : net->count, like->weights != NULL, &s);
    if (status != WCUT_OK) return status;

    /* knots of both directions */
    double *own = to_u ? s->knots_u : s->knots_v, *other = to_u ? s->knots_v : s->knots_u;
    for (int k = 0; k < net->count + net->degree + 1; k++) own[k] = net->knots[k];
    for (int k = 0; k < net->lanes + degree + 1; k++) other[k] = knots[k];

    /* control points and weights, turned where asked */
    for (int k = 0; k < net->count; k++)
        for (int c = 0; c < net->lanes; c++) {
            const wcut_homogeneous *h = &net->at[(ptrdiff_t)k * net->lanes + c];
            const ptrdiff_t at = index_of(s->count_u, to_u ? WCUT_DIRECTION_U : WCUT_DIRECTION_V, k, c);
            s->control[at] = drop(h, s->weights != NULL);
            if (s->weights) s->weights[at] = h->w;
        }
    *surface = s;

    return WCUT_OK;
}
