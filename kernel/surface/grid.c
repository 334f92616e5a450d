/* Evaluation on a tensor grid: the basis of every parameter once, rows of control points folded along v, then u. */
#include "surface/grid.h"

#include <limits.h>

#include "base/alloc.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "surface/basis.h"

wcut_status wcut_axis_fill(int degree, int control_count, const double *knots, int count, const double *parameter,
                           int order, wcut_axis *axis) {
    /* room for the basis functions of all parameters */
    const int size = (order + 1) * (degree + 1);
    int *first = wcut_alloc((size_t)count, sizeof *first);
    double *value = wcut_alloc((size_t)count, (size_t)size * sizeof *value);
    if (!first || !value) {
        wcut_free(first);
        wcut_free(value);
        return WCUT_NO_MEMORY;
    }

    /* values and derivatives to the order asked for, one after the other */
    for (int i = 0; i < count; i++) {
        wcut_basis basis;
        wcut_basis_eval(degree, control_count, knots, parameter[i], order, &basis);
        first[i] = basis.span - degree;
        double *to = value + (ptrdiff_t)i * size;
        for (int k = 0; k <= order; k++)
            for (int r = 0; r <= degree; r++) *to++ = basis.value[k][r];
    }

    *axis = (wcut_axis){.count = count, .degree = degree, .order = order, .first = first, .value = value};

    return WCUT_OK;
}

void wcut_axis_clear(wcut_axis *axis) {
    wcut_free(axis->first);
    wcut_free(axis->value);
    *axis = (wcut_axis){.count = 0};
}

static const double *basis_at(const wcut_axis *axis, int i, int k) {
    return axis->value + ((ptrdiff_t)i * (axis->order + 1) + k) * (axis->degree + 1);
}

void wcut_grid_fold(const wcut_surface *surface, const wcut_axis *v, int j, int l, wcut_homogeneous *row) {
    const double *basis = basis_at(v, j, l);
    for (int i = 0; i < surface->count_u; i++) row[i] = (wcut_homogeneous){0, 0, 0, 0};
    for (int r = 0; r <= v->degree; r++) {
        const ptrdiff_t start = (ptrdiff_t)(v->first[j] + r) * surface->count_u;
        for (int i = 0; i < surface->count_u; i++) {
            const wcut_vec3 *p = &surface->control[start + i];
            const double b = surface->weights ? basis[r] * surface->weights[start + i] : basis[r];
            row[i].x += b * p->x, row[i].y += b * p->y, row[i].z += b * p->z, row[i].w += b;
        }
    }
}

wcut_homogeneous wcut_grid_along(const wcut_axis *u, int i, int k, const wcut_homogeneous *row) {
    const double *basis = basis_at(u, i, k);
    const wcut_homogeneous *p = row + u->first[i];
    wcut_homogeneous sum = {0, 0, 0, 0};
    for (int r = 0; r <= u->degree; r++) {
        const double b = basis[r];
        sum.x += b * p[r].x, sum.y += b * p[r].y, sum.z += b * p[r].z, sum.w += b * p[r].w;
    }
    return sum;
}

/* a polynomial row: coordinates side by side, no weights */
static void fold_plain(const wcut_surface *surface, const wcut_axis *v, int j, double *restrict row) {
    const double *basis = basis_at(v, j, 0);
    const int size = 3 * surface->count_u;
    for (int r = 0; r <= v->degree; r++) {
        const double b = basis[r], *restrict p = &surface->control[(ptrdiff_t)(v->first[j] + r) * surface->count_u].x;
        if (r == 0) { /* NOLINT(bugprone-branch-clone): = and += are not alike */
#pragma omp simd
            for (int i = 0; i < size; i++) row[i] = b * p[i];
        } else {
#pragma omp simd
            for (int i = 0; i < size; i++) row[i] += b * p[i];
        }
    }
}

static inline void points_plain(const wcut_axis *u, int degree, const double *row, wcut_vec3 *point) {
    for (int i = 0; i < u->count; i++) {
        const double *basis = u->value + (ptrdiff_t)i * (u->order + 1) * (degree + 1),
                     *p = row + 3 * (ptrdiff_t)u->first[i];
        double x = 0, y = 0, z = 0;
        for (int r = 0; r <= degree; r++)
            x += basis[r] * p[3 * (size_t)r], y += basis[r] * p[3 * (size_t)r + 1],
                z += basis[r] * p[3 * (size_t)r + 2];
        point[i] = vec3(x, y, z);
    }
}

void wcut_grid_row(const wcut_surface *surface, const wcut_axis *u, const wcut_axis *v, int j, wcut_homogeneous *room,
                   wcut_vec3 *point) {
    if (!surface->weights) {
        fold_plain(surface, v, j, &room->x);
        if (u->degree == 3) { /* the loops unroll */
            points_plain(u, 3, &room->x, point);
        } else {
            points_plain(u, u->degree, &room->x, point);
        }
        return;
    }
    wcut_grid_fold(surface, v, j, 0, room);
    for (int i = 0; i < u->count; i++) {
        const wcut_homogeneous h = wcut_grid_along(u, i, 0, room);
        point[i] = vec3(h.x / h.w, h.y / h.w, h.z / h.w);
    }
}

wcut_status wcut_surface_eval_grid(const wcut_surface *surface, int count_u, const double *u, int count_v,
                                   const double *v, wcut_vec3 *point) {
    if (!surface || count_u < 1 || count_v < 1 || count_u > INT_MAX / count_v || !u || !v || !point ||
        !all_finite(count_u, u) || !all_finite(count_v, v))
        return WCUT_BAD_ARGUMENT;
    wcut_axis along = {.count = 0}, across = {.count = 0};
    wcut_status status = wcut_axis_fill(surface->degree_u, surface->count_u, surface->knots_u, count_u, u, 0, &along);
    if (status == WCUT_OK)
        status = wcut_axis_fill(surface->degree_v, surface->count_v, surface->knots_v, count_v, v, 0, &across);
    wcut_homogeneous *row = wcut_alloc((size_t)surface->count_u, sizeof *row);
    if (!row) status = WCUT_NO_MEMORY;
    for (int j = 0; status == WCUT_OK && j < count_v; j++)
        wcut_grid_row(surface, &along, &across, j, row, point + (ptrdiff_t)j * count_u);
    wcut_free(row);
    wcut_axis_clear(&across);
    wcut_axis_clear(&along);
    return status;
}
