/* A surface or a curve between neighbouring knots as a Bezier patch, in homogeneous coordinates, and its halves. */
#include "surface/bezier.h"

#include <stddef.h>

#include "surface/blossom.h"

/* share[i][r] of control point span - degree + r in Bezier point i: the polar form at (degree - i) a and i b */
static void shares(int degree, const double *knots, int span, double share[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE]) {
    double argument[WCUT_BASIS_SIZE];
    for (int k = 0; k < degree; k++) argument[k] = knots[span];
    for (int i = 0; i <= degree; i++) {
        if (i > 0) argument[degree - i] = knots[span + 1];
        wcut_blossom(degree, knots, span, argument, share[i]);
    }
}

static void bezier_add(wcut_homogeneous *to, double s, double x, double y, double z, double w) {
    to->x += s * x, to->y += s * y, to->z += s * z, to->w += s * w;
}

void wcut_bezier_of_surface(const wcut_surface *s, int span_u, int span_v, wcut_bezier *patch) {
    /* Bezier coefficients of the basis functions on these spans, in both directions */
    const int p = s->degree_u, q = s->degree_v;
    double across[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE], along[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE];
    wcut_homogeneous row[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE] = {{{0}}};
    shares(p, s->knots_u, span_u, along);
    shares(q, s->knots_v, span_v, across);

    /* along v first */
    for (int j = 0; j <= q; j++) /* rows of control points to rows of the patch */
        for (int r = 0; r <= q; r++)
            for (int k = 0; k <= p && across[j][r] != 0; k++) {
                const ptrdiff_t from = (ptrdiff_t)(span_v - q + r) * s->count_u + span_u - p + k;
                const double w = s->weights ? s->weights[from] : 1;
                const wcut_vec3 c = s->control[from];
                bezier_add(&row[j][k], across[j][r] * w, c.x, c.y, c.z, 1);
            }

    /* the rectangle of parameters, then along u */
    *patch = (wcut_bezier){.degree_u = p, .degree_v = q};
    patch->u0 = s->knots_u[span_u], patch->u1 = s->knots_u[span_u + 1];
    patch->v0 = s->knots_v[span_v], patch->v1 = s->knots_v[span_v + 1];
    for (int j = 0; j <= q; j++)
        for (int i = 0; i <= p; i++)
            for (int k = 0; k <= p; k++) {
                const wcut_homogeneous *h = &row[j][k];
                bezier_add(&patch->at[j][i], along[i][k], h->x, h->y, h->z, h->w);
            }
}

void wcut_bezier_of_curve(const wcut_curve *c, int span, wcut_bezier *patch) {
    const int p = c->degree;
    double along[WCUT_BASIS_SIZE][WCUT_BASIS_SIZE];
    shares(p, c->knots, span, along);
    *patch = (wcut_bezier){.degree_u = p, .u0 = c->knots[span], .u1 = c->knots[span + 1]};
    for (int i = 0; i <= p; i++)
        for (int k = 0; k <= p; k++) {
            const int from = span - p + k;
            const wcut_vec3 point = c->control[from];
            bezier_add(&patch->at[0][i], along[i][k] * (c->weights ? c->weights[from] : 1), point.x, point.y, point.z,
                       1);
        }
}

static wcut_homogeneous middle(const wcut_homogeneous *a, const wcut_homogeneous *b) {
    return (wcut_homogeneous){(a->x + b->x) / 2, (a->y + b->y) / 2, (a->z + b->z) / 2, (a->w + b->w) / 2};
}

void wcut_bezier_halve(const wcut_bezier *patch, bool along_u, wcut_bezier half[2]) {
    const wcut_bezier whole = *patch;
    const int n = along_u ? whole.degree_u : whole.degree_v, lanes = along_u ? whole.degree_v : whole.degree_u;
    half[0] = half[1] = whole;
    if (along_u) {
        half[0].u1 = half[1].u0 = (whole.u0 + whole.u1) / 2;
    } else {
        half[0].v1 = half[1].v0 = (whole.v0 + whole.v1) / 2;
    }
    for (int c = 0; c <= lanes; c++) {
        wcut_homogeneous line[WCUT_BASIS_SIZE];
        for (int k = 0; k <= n; k++) line[k] = along_u ? whole.at[c][k] : whole.at[k][c];
        for (int k = 0; k <= n; k++) { /* the first point left goes down, the last one up */
            *(along_u ? &half[0].at[c][k] : &half[0].at[k][c]) = line[0];
            *(along_u ? &half[1].at[c][n - k] : &half[1].at[n - k][c]) = line[n - k];
            for (int i = 0; i < n - k; i++) line[i] = middle(&line[i], &line[i + 1]);
        }
    }
}
