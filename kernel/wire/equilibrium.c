/* Equilibrium of an inextensible chain under given nodal forces, by the convex dual of the force density equations.

   Node equilibrium makes every edge force N_e = h - (F_1 + .. + F_e), so the whole chain hangs on the one unknown h,
   the force in the first edge. The edges close, sum l_e N_e/|N_e| = X_{n-1} - X_0, exactly where the convex function
   sum l_e |N_e| - h.(X_{n-1} - X_0) is least: Newton in three unknowns, from however straight a wire. */
#include <float.h>
#include <wirecut/equilibrium.h>

#include "base/numbers.h"
#include "base/vec3.h"
#include "wire/equilibrium.h"

wcut_equilibrium_options wcut_equilibrium_options_default(void) {
    return (wcut_equilibrium_options){.tolerance = 1e-12, .max_iterations = 100};
}

typedef struct dual { /* value, gradient and Hessian at an h */
    double value;
    wcut_vec3 gradient;
    double xx, xy, xz, yy, yz, zz;
} dual;

static dual evaluate(int n, const wcut_vec3 *force, const double *length, wcut_vec3 reach, wcut_vec3 h) {
    dual d = {.value = -vec3_dot(h, reach), .gradient = vec3_scale(-1, reach)};
    wcut_vec3 edge = h;
    for (int e = 0; e < n - 1; e++) {
        if (e > 0) edge = vec3_sub(edge, force[e]);
        const double size = vec3_length(edge);
        if (!(size > 0)) continue; /* a cusp: the zero vector is a subgradient there */
        const wcut_vec3 u = vec3_scale(1 / size, edge);
        const double w = length[e] / size;
        d.value += length[e] * size;
        d.gradient = vec3_add_scaled(d.gradient, length[e], u);
        d.xx += w * (1 - u.x * u.x), d.xy -= w * u.x * u.y, d.xz -= w * u.x * u.z;
        d.yy += w * (1 - u.y * u.y), d.yz -= w * u.y * u.z, d.zz += w * (1 - u.z * u.z);
    }
    return d;
}

/* Hessian^-1 (-gradient) by Cholesky; the Hessian is singular only where every edge is parallel */
static bool newton_direction(const dual *d, wcut_vec3 *step) {
    const double a = sqrt(d->xx), b = d->xy / a, c = d->xz / a;
    const double e = sqrt(d->yy - b * b), f = (d->yz - b * c) / e, g = sqrt(d->zz - c * c - f * f);
    if (!(a > 0 && e > 0 && g > 0)) return false;
    const double x = -d->gradient.x / a, y = (-d->gradient.y - b * x) / e;
    const double z = (-d->gradient.z - c * x - f * y) / g;
    step->z = z / g;
    step->y = (y - f * step->z) / e;
    step->x = (x - b * step->y - c * step->z) / a;
    return vec3_is_finite(*step);
}

/* The h of a taut wire: sum l |N| = |h| L + (load across the chord)^2 / 2|h| to first order. */
static wcut_vec3 taut_guess(int n, const wcut_vec3 *force, const double *length, wcut_vec3 reach) {
    /* mean load of the edges */
    double total = 0, across = 0;
    wcut_vec3 load = {0, 0, 0}, mean = {0, 0, 0};
    for (int e = 0; e < n - 1; e++) {
        if (e > 0) load = vec3_add(load, force[e]);
        mean = vec3_add_scaled(mean, length[e], load);
        total += length[e];
    }

    /* part of it across the chord */
    mean = vec3_scale(1 / total, mean);
    const double chord = vec3_length(reach);

    const wcut_vec3 along = chord > 0 ? vec3_scale(1 / chord, reach) : vec3(0, 0, 0);
    load = vec3(0, 0, 0);
    for (int e = 0; e < n - 1; e++) {
        if (e > 0) load = vec3_add(load, force[e]);
        const wcut_vec3 off = vec3_sub(load, mean);
        const double size = vec3_length(vec3_add_scaled(off, -vec3_dot(off, along), along));
        across += length[e] * size * size / 2;
    }

    /* |h| from the slack: sqrt(sum l across^2 / 2 / (total - chord)) */
    return vec3_add_scaled(mean, sqrt(across / (total - chord)), along);
}

/* the shortest step of a halving line search that lowers the convex function enough, or 0 */
static double search(int n, const wcut_vec3 *force, const double *length, wcut_vec3 reach, wcut_vec3 step, wcut_vec3 *h,
                     dual *d) {
    const double slope = vec3_dot(d->gradient, step);
    /* what a sum of n terms may be off by: near the least value a full step lowers it by less than that */
    const double rounding = n * DBL_EPSILON * (fabs(d->value) + vec3_length(*h) * vec3_length(reach));
    for (double t = 1; t > 1e-12; t /= 2) {
        const wcut_vec3 trial = vec3_add_scaled(*h, t, step);
        const dual at = evaluate(n, force, length, reach, trial);
        if (at.value <= d->value + 1e-4 * t * slope + rounding) {
            *h = trial;
            *d = at;
            return t;
        }
    }
    return 0;
}

static void place_nodes(int n, const wcut_vec3 *force, const double *length, wcut_vec3 h, wcut_vec3 *x, double *q) {
    const wcut_vec3 end = x[n - 1];
    wcut_vec3 edge = h;
    for (int e = 0; e < n - 1; e++) {
        if (e > 0) edge = vec3_sub(edge, force[e]);
        q[e] = vec3_length(edge) / length[e];
        x[e + 1] = vec3_add_scaled(x[e], length[e], vec3_unit(edge));
    }
    /* what the closure leaves (rounding, or the last iterate's gap) is spread, not piled up at the end */
    const wcut_vec3 gap = vec3_sub(end, x[n - 1]);
    for (int i = 1; i < n; i++) x[i] = vec3_add_scaled(x[i], (double)i / (n - 1), gap);
    x[n - 1] = end;
}

/* unbalance is told over the largest force in the chain: that of a taut wire is far above its load */
static void measure_unbalance(int n, const wcut_vec3 *force, const double *length, const wcut_vec3 *x, const double *q,
                              double load, wcut_equilibrium_report *r) {
    for (int e = 0; e < n - 1; e++) {
        r->strain = fmax(r->strain, fabs(vec3_distance(x[e], x[e + 1]) / length[e] - 1));
        load = fmax(load, q[e] * length[e]);
    }
    for (int i = 1; i < n - 1; i++) {
        wcut_vec3 left = vec3_add_scaled(force[i], q[i], vec3_sub(x[i + 1], x[i]));
        left = vec3_add_scaled(left, -q[i - 1], vec3_sub(x[i], x[i - 1]));
        r->unbalance = fmax(r->unbalance, vec3_length(left) / load);
    }
}

wcut_status wcut_equilibrium_shape(int n, const wcut_vec3 *force, const double *length,
                                   const wcut_equilibrium_options *o, wcut_vec3 *x, double *q,
                                   wcut_equilibrium_report *report) {
    /* a wire that is too short, or without load, has no shape */
    const wcut_vec3 reach = vec3_sub(x[n - 1], x[0]);
    double total = 0, load = 0;
    for (int e = 0; e < n - 1; e++) total += length[e];
    for (int i = 1; i < n - 1; i++) load += vec3_length(force[i]);
    if (!(load > 0) || !(total > vec3_length(reach))) return WCUT_DEGENERATE;

    /* Newton's method on the dual, with the gradient where its matrix is singular */
    wcut_vec3 h = taut_guess(n, force, length, reach), step;
    dual d = evaluate(n, force, length, reach, h);
    wcut_equilibrium_report r = {0};
    for (; r.iterations < o->max_iterations && vec3_length(d.gradient) > o->tolerance * total / 10; r.iterations++) {
        if (!newton_direction(&d, &step)) step = vec3_scale(-load / total, d.gradient);
        if (search(n, force, length, reach, step, &h, &d) == 0) break;
    }

    /* positions and force densities from h, and how well they fit */
    place_nodes(n, force, length, h, x, q);
    measure_unbalance(n, force, length, x, q, load, &r);
    if (report) *report = r;

    return r.strain <= o->tolerance && r.unbalance <= o->tolerance ? WCUT_OK : WCUT_NOT_CONVERGED;
}

wcut_status wcut_equilibrium_solve(int n, const wcut_vec3 *force, const double *length,
                                   const wcut_equilibrium_options *options, wcut_vec3 *x, double *q,
                                   wcut_equilibrium_report *report) {
    const wcut_equilibrium_options o = options ? *options : wcut_equilibrium_options_default();
    if (n < 3 || !force || !length || !x || !q || o.max_iterations < 1 || !is_positive(o.tolerance))
        return WCUT_BAD_ARGUMENT;
    if (!vec3_all_finite(n - 2, force + 1) || !vec3_is_finite(x[0]) || !vec3_is_finite(x[n - 1]) ||
        !all_positive(n - 1, length))
        return WCUT_BAD_ARGUMENT;
    return wcut_equilibrium_shape(n, force, length, &o, x, q, report);
}
