/* Rational B-spline curves: ownership, evaluation by the quotient rule, interpolation with end derivatives. */
#include <limits.h>
#include <wirecut/curve.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/basis.h"
#include "surface/collocation.h"
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

/* parameters from chord lengths; WCUT_DEGENERATE, WCUT_NO_MEMORY */
static wcut_status chord_parameters(int count, const wcut_vec3 *point, double *parameter) {
    double *length = wcut_alloc((size_t)count, sizeof *length);
    if (!length) return WCUT_NO_MEMORY;
    for (int i = 0; i < count - 1; i++) length[i] = vec3_distance(point[i], point[i + 1]);
    const wcut_status status = wcut_parameters_from_lengths(count, length, parameter);
    wcut_free(length);
    return status;
}

/* an end with a derivative is a site twice; returns how many sites */
static int place_sites(int count, const double *parameter, const wcut_vec3 *point, const wcut_vec3 *first,
                       const wcut_vec3 *last, double *site, wcut_vec3 *right) {
    int made = 0;
    for (int i = 0; i < count; i++) {
        if (i == count - 1 && last) site[made] = parameter[i], right[made++] = *last;
        site[made] = parameter[i], right[made++] = point[i];
        if (i == 0 && first) site[made] = parameter[i], right[made++] = *first;
    }
    return made;
}

static wcut_status solve_sites(const wcut_curve *c, const double *site, int slopes) {
    wcut_collocation system;
    const wcut_status status = wcut_collocation_factor(c->degree, c->control_count, c->knots, site, slopes, &system);
    if (status != WCUT_OK) return status == WCUT_SINGULAR ? WCUT_DEGENERATE : status;
    wcut_collocation_solve(&system, 3, &c->control->x);
    wcut_free(system.entry);
    return vec3_all_finite(c->control_count, c->control) ? WCUT_OK : WCUT_DEGENERATE;
}

wcut_status wcut_curve_interpolate_at(int count, const wcut_vec3 *point, const double *parameter,
                                      const wcut_vec3 *first, const wcut_vec3 *last, wcut_curve **curve) {
    if (count < 2 || count > INT_MAX / 8 - 2 || !point || !curve || !vec3_all_finite(count, point) ||
        (first && !vec3_is_finite(*first)) || (last && !vec3_is_finite(*last)))
        return WCUT_BAD_ARGUMENT;

    /* parameters ascend; without them chord lengths are taken below */
    for (int i = 0; parameter && i < count; i++)
        if (!isfinite(parameter[i]) || (i > 0 && !(parameter[i] > parameter[i - 1]))) return WCUT_BAD_ARGUMENT;

    /* an end slope is one more equation */
    const int sites = count + (first != NULL) + (last != NULL), degree = sites > 3 ? 3 : sites - 1;
    wcut_curve *c = NULL;
    double *own = wcut_alloc((size_t)count, sizeof *own), *site = wcut_alloc((size_t)sites, sizeof *site);
    wcut_status status = own && site ? wcut_curve_new(degree, sites, false, &c) : WCUT_NO_MEMORY;
    if (status == WCUT_OK && !parameter) status = chord_parameters(count, point, own);
    if (status == WCUT_OK) {
        /* sites of the equations, knots as their averages */
        place_sites(count, parameter ? parameter : own, point, first, last, site, c->control);
        wcut_knots_average(degree, sites, site, c->knots);
        if (!wcut_knots_are_valid(degree, sites, c->knots)) status = WCUT_DEGENERATE;
    }

    /* the control points, by one banded system */
    const int slopes = (first ? WCUT_SLOPE_FIRST : 0) | (last ? WCUT_SLOPE_LAST : 0);
    if (status == WCUT_OK) status = solve_sites(c, site, slopes);
    if (status == WCUT_OK) {
        *curve = c;
        c = NULL;
    }

    wcut_curve_destroy(c);
    wcut_free(site);
    wcut_free(own);
    return status;
}

wcut_status wcut_curve_interpolate(int count, const wcut_vec3 *point, wcut_curve **curve) {
    return wcut_curve_interpolate_at(count, point, NULL, NULL, NULL, curve);
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
