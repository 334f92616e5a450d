/* Rational B-spline curves: ownership, evaluation by the quotient rule, interpolation by chord length. */
#include <limits.h>
#include <wirecut/curve.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/basis.h"
#include "surface/interpolate.h"
#include "surface/rational.h"

void wcut_curve_destroy(wcut_curve *curve) {
    if (!curve) return;
    wcut_free(curve->knots);
    wcut_free(curve->control);
    wcut_free(curve->weights);
    wcut_free(curve);
}

wcut_status wcut_curve_new(int degree, int control_count, bool rational, wcut_curve **curve) {
    if (control_count > INT_MAX / 8) return WCUT_NO_MEMORY;
    wcut_curve *c = wcut_alloc(1, sizeof *c);
    if (!c) return WCUT_NO_MEMORY;
    c->degree = degree;
    c->control_count = control_count;
    c->knots = wcut_alloc((size_t)control_count + (size_t)degree + 1, sizeof *c->knots);
    c->control = wcut_alloc((size_t)control_count, sizeof *c->control);
    c->weights = rational ? wcut_alloc((size_t)control_count, sizeof *c->weights) : NULL;
    if (!c->knots || !c->control || (rational && !c->weights)) {
        wcut_curve_destroy(c);
        return WCUT_NO_MEMORY;
    }
    *curve = c;
    return WCUT_OK;
}

wcut_status wcut_curve_create(int degree, int control_count, const double *knots, const wcut_vec3 *control,
                              const double *weights, wcut_curve **curve) {
    if (!knots || !control || !curve || degree < 1 || degree > WCUT_DEGREE_MAX || control_count <= degree)
        return WCUT_BAD_ARGUMENT;
    if (control_count > INT_MAX / 8) return WCUT_BAD_ARGUMENT;
    if (!wcut_knots_are_valid(degree, control_count, knots) || !vec3_all_finite(control_count, control) ||
        (weights && !all_positive(control_count, weights)))
        return WCUT_BAD_ARGUMENT;
    wcut_curve *c;
    const wcut_status status = wcut_curve_new(degree, control_count, weights != NULL, &c);
    if (status != WCUT_OK) return status;
    for (int i = 0; i < control_count + degree + 1; i++) c->knots[i] = knots[i];
    for (int i = 0; i < control_count; i++) {
        c->control[i] = control[i];
        if (weights) c->weights[i] = weights[i];
    }
    *curve = c;
    return WCUT_OK;
}

wcut_status wcut_curve_interpolate(int count, const wcut_vec3 *point, wcut_curve **curve) {
    if (count < 2 || count > INT_MAX / 8 || !point || !curve || !vec3_all_finite(count, point))
        return WCUT_BAD_ARGUMENT;
    wcut_curve *c = NULL;
    double *parameter = wcut_alloc((size_t)count, 2 * sizeof *parameter), *length = parameter + count;
    const int degree = count > 3 ? 3 : count - 1;
    wcut_status status = parameter ? wcut_curve_new(degree, count, false, &c) : WCUT_NO_MEMORY;
    if (status != WCUT_OK) goto done;

    for (int i = 0; i < count - 1; i++) length[i] = vec3_distance(point[i], point[i + 1]);
    for (int i = 0; i < count; i++) c->control[i] = point[i];
    status = wcut_parameters_from_lengths(count, length, parameter);
    if (status != WCUT_OK) goto done;
    wcut_knots_average(degree, count, parameter, c->knots);
    status = wcut_interpolate_rows(degree, count, c->knots, parameter, 1, c->control);
    if (status == WCUT_SINGULAR) status = WCUT_DEGENERATE; /* neighbours apart by rounding alone */
    if (status != WCUT_OK) goto done;
    *curve = c;
    c = NULL;

done:
    wcut_curve_destroy(c);
    wcut_free(parameter);
    return status;
}

wcut_status wcut_curve_eval(const wcut_curve *curve, double u, int order, wcut_vec3 *ders) {
    if (!curve || !ders || order < 0 || order > WCUT_ORDER_MAX || !isfinite(u)) return WCUT_BAD_ARGUMENT;
    wcut_basis basis;
    wcut_basis_eval(curve->degree, curve->control_count, curve->knots, u, order, &basis);
    const int first = basis.span - curve->degree;
    wcut_homogeneous sum[WCUT_ORDER_MAX + 1] = {{0}};
    for (int r = 0; r <= curve->degree; r++) {
        const wcut_vec3 point = curve->control[first + r];
        const double weight = curve->weights ? curve->weights[first + r] : 1;
        for (int k = 0; k <= order; k++) {
            const double n = basis.value[k][r] * weight;
            sum[k].x += n * point.x, sum[k].y += n * point.y, sum[k].z += n * point.z, sum[k].w += n;
        }
    }
    wcut_vec3 result[WCUT_ORDER_MAX + 1];
    wcut_rational_curve(order, curve->weights != NULL, sum, result);
    for (int k = 0; k <= order; k++) ders[k] = result[k];
    return WCUT_OK;
}

void wcut_curve_domain(const wcut_curve *curve, double *first, double *last) {
    *first = curve->knots[curve->degree];
    *last = curve->knots[curve->control_count];
}
