/* Tensor-product rational B-spline surfaces: ownership and evaluation at a point. */
#include <limits.h>
#include <wirecut/surface.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/basis.h"
#include "surface/rational.h"

void wcut_surface_destroy(wcut_surface *surface) {
    if (!surface) return;
    wcut_free(surface->knots_u);
    wcut_free(surface->knots_v);
    wcut_free(surface->control);
    wcut_free(surface->weights);
    wcut_free(surface);
}

wcut_status wcut_surface_new(int degree_u, int degree_v, int count_u, int count_v, bool rational,
                             wcut_surface **surface) {
    const size_t control_count = (size_t)count_u * (size_t)count_v;
    wcut_surface *s = wcut_alloc(1, sizeof *s);
    if (!s) return WCUT_NO_MEMORY;
    s->degree_u = degree_u, s->degree_v = degree_v;
    s->count_u = count_u, s->count_v = count_v;
    s->knots_u = wcut_alloc((size_t)count_u + degree_u + 1, sizeof *s->knots_u);
    s->knots_v = wcut_alloc((size_t)count_v + degree_v + 1, sizeof *s->knots_v);
    s->control = wcut_alloc(control_count, sizeof *s->control);
    s->weights = rational ? wcut_alloc(control_count, sizeof *s->weights) : NULL;
    if (!s->knots_u || !s->knots_v || !s->control || (rational && !s->weights)) {
        wcut_surface_destroy(s);
        return WCUT_NO_MEMORY;
    }
    *surface = s;
    return WCUT_OK;
}

wcut_status wcut_surface_create(int degree_u, int degree_v, int count_u, int count_v, const double *knots_u,
                                const double *knots_v, const wcut_vec3 *control, const double *weights,
                                wcut_surface **surface) {
    /* degrees, counts and knots, then the control points */
    if (!knots_u || !knots_v || !control || !surface || degree_u < 1 || degree_u > WCUT_DEGREE_MAX || degree_v < 1 ||
        degree_v > WCUT_DEGREE_MAX || count_u <= degree_u || count_v <= degree_v || count_u > INT_MAX / 8 / count_v)
        return WCUT_BAD_ARGUMENT;
    const int control_count = count_u * count_v;
    if (!wcut_knots_are_valid(degree_u, count_u, knots_u) || !wcut_knots_are_valid(degree_v, count_v, knots_v) ||
        !vec3_all_finite(control_count, control) || (weights && !all_positive(control_count, weights)))
        return WCUT_BAD_ARGUMENT;

    /* copies of everything */
    wcut_surface *s;
    const wcut_status status = wcut_surface_new(degree_u, degree_v, count_u, count_v, weights != NULL, &s);
    if (status != WCUT_OK) return status;
    for (int i = 0; i < count_u + degree_u + 1; i++) s->knots_u[i] = knots_u[i];
    for (int i = 0; i < count_v + degree_v + 1; i++) s->knots_v[i] = knots_v[i];
    for (int i = 0; i < control_count; i++) {
        s->control[i] = control[i];
        if (weights) s->weights[i] = weights[i];
    }
    *surface = s;

    return WCUT_OK;
}

/* a point of a bicubic polynomial surface, the case that is called a million times */
static wcut_vec3 evaluate_bicubic(const wcut_surface *s, double u, double v) {
    double bu[4], bv[4];
    const int span_u = wcut_basis_cubic(s->count_u, s->knots_u, u, bu),
              span_v = wcut_basis_cubic(s->count_v, s->knots_v, v, bv);
    const wcut_vec3 *p = s->control + (ptrdiff_t)(span_v - 3) * s->count_u + span_u - 3;
    wcut_vec3 sum = {0, 0, 0};
    for (int r = 0; r < 4; r++, p += s->count_u) {
        wcut_vec3 along = {0, 0, 0};
        for (int i = 0; i < 4; i++) along = vec3_add_scaled(along, bu[i], p[i]);
        sum = vec3_add_scaled(sum, bv[r], along);
    }
    return sum;
}

/* a point of any surface */
static wcut_vec3 evaluate_point(const wcut_surface *s, double u, double v) {
    /* basis functions at u and v */
    wcut_basis bu, bv;
    wcut_basis_eval(s->degree_u, s->count_u, s->knots_u, u, 0, &bu);
    wcut_basis_eval(s->degree_v, s->count_v, s->knots_v, v, 0, &bv);
    wcut_vec3 sum = {0, 0, 0};
    double weight = 0;

    /* fold along u, then along v */
    for (int r = 0; r <= s->degree_v; r++) {
        const ptrdiff_t row = (ptrdiff_t)(bv.span - s->degree_v + r) * s->count_u + bu.span - s->degree_u;
        const wcut_vec3 *control = s->control + row;
        wcut_vec3 along = {0, 0, 0};
        if (s->weights) {
            double along_weight = 0;
            for (int i = 0; i <= s->degree_u; i++) {
                const double n = bu.value[0][i] * s->weights[row + i];
                along = vec3_add_scaled(along, n, control[i]);
                along_weight += n;
            }
            weight += bv.value[0][r] * along_weight;
        } else {
            for (int i = 0; i <= s->degree_u; i++) along = vec3_add_scaled(along, bu.value[0][i], control[i]);
        }
        sum = vec3_add_scaled(sum, bv.value[0][r], along);
    }

    return s->weights ? vec3_scale(1 / weight, sum) : sum;
}

/* sum[k * n + l] = d^(k+l) (w S) / du^k dv^l for k + l < n: along u first, row by row */
static void sum_derivatives(const wcut_surface *s, double u, double v, int n, wcut_homogeneous *sum) {
    /* basis functions with derivatives */
    wcut_basis bu, bv;
    wcut_basis_eval(s->degree_u, s->count_u, s->knots_u, u, n - 1, &bu);
    wcut_basis_eval(s->degree_v, s->count_v, s->knots_v, v, n - 1, &bv);

    for (int r = 0; r <= s->degree_v; r++) {
        const ptrdiff_t row = (ptrdiff_t)(bv.span - s->degree_v + r) * s->count_u + bu.span - s->degree_u;
        for (int k = 0; k < n; k++) {
            wcut_homogeneous along = {0, 0, 0, 0};
            for (int i = 0; i <= s->degree_u; i++) {
                const double b = s->weights ? bu.value[k][i] * s->weights[row + i] : bu.value[k][i];
                const wcut_vec3 *p = &s->control[row + i];
                along.x += b * p->x, along.y += b * p->y, along.z += b * p->z, along.w += b;
            }

            /* along v, to all orders that are asked for */
            for (int l = 0; k + l < n; l++) {
                wcut_homogeneous *to = &sum[k * n + l];
                const double b = bv.value[l][r];
                to->x += b * along.x, to->y += b * along.y, to->z += b * along.z, to->w += b * along.w;
            }
        }
    }
}

/* the same without weights, straight into the result */
static inline void sum_polynomial(const wcut_surface *s, int degree_u, int degree_v, double u, double v, int n,
                                  wcut_vec3 *ders) {
    wcut_basis bu, bv;
    wcut_basis_eval(degree_u, s->count_u, s->knots_u, u, n - 1, &bu);
    wcut_basis_eval(degree_v, s->count_v, s->knots_v, v, n - 1, &bv);
    for (int k = 0; k < n * n; k++) ders[k] = vec3(0, 0, 0);
    for (int r = 0; r <= degree_v; r++) {
        const wcut_vec3 *p = s->control + (ptrdiff_t)(bv.span - degree_v + r) * s->count_u + bu.span - degree_u;
        for (int k = 0; k < n; k++) {
            wcut_vec3 along = {0, 0, 0};
            for (int i = 0; i <= degree_u; i++) along = vec3_add_scaled(along, bu.value[k][i], p[i]);
            for (int l = 0; k + l < n; l++) ders[k * n + l] = vec3_add_scaled(ders[k * n + l], bv.value[l][r], along);
        }
    }
}

wcut_status wcut_surface_eval(const wcut_surface *surface, double u, double v, int order, wcut_vec3 *ders) {
    if (!surface || !ders || order < 0 || order > WCUT_ORDER_MAX || !isfinite(u) || !isfinite(v))
        return WCUT_BAD_ARGUMENT;

    /* points only: the bicubic loft has a path of its own */
    if (order == 0) {
        const bool bicubic = !surface->weights && surface->degree_u == 3 && surface->degree_v == 3;
        ders[0] = bicubic ? evaluate_bicubic(surface, u, v) : evaluate_point(surface, u, v);
        return WCUT_OK;
    }

    /* polynomial surfaces need no quotient rule */
    if (!surface->weights) {
        if (surface->degree_u == 3 && surface->degree_v == 3) { /* lofts: the loops unroll */
            sum_polynomial(surface, 3, 3, u, v, order + 1, ders);
        } else {
            sum_polynomial(surface, surface->degree_u, surface->degree_v, u, v, order + 1, ders);
        }
        return WCUT_OK;
    }

    /* rational: homogeneous sums, then the quotient rule */
    enum { MAX = (WCUT_ORDER_MAX + 1) * (WCUT_ORDER_MAX + 1) };
    wcut_homogeneous sum[MAX] = {{0}};
    sum_derivatives(surface, u, v, order + 1, sum);
    wcut_rational_surface(order, surface->weights != NULL, sum, ders);

    return WCUT_OK;
}

void wcut_surface_domain(const wcut_surface *surface, double first[2], double last[2]) {
    first[0] = surface->knots_u[surface->degree_u], last[0] = surface->knots_u[surface->count_u];
    first[1] = surface->knots_v[surface->degree_v], last[1] = surface->knots_v[surface->count_v];
}
