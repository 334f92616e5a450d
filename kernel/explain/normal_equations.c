/* Normal equations with priors, whole and by cut, so that any choice of columns and cuts is solved at once. */
#include "explain/normal_equations.h"

#include <string.h>

#include "base/alloc.h"
#include "base/dense.h"
#include "base/numbers.h"
#include "base/threads.h"

static const double PIVOT_MIN = 1e-11; /* [1] of a matrix of unit diagonal, below which it is singular */

wcut_status wcut_normal_equations_create(int n, int m, int cuts, wcut_normal_equations *out) {
    const size_t square = (size_t)n * (size_t)n, k = (size_t)cuts, scatter = (size_t)m;

    /* sums of all cuts, of each cut, and the products from which those are weighed */
    *out = (wcut_normal_equations){.n = n,
                                   .m = m,
                                   .cuts = cuts,
                                   .gram = wcut_alloc(square, sizeof(double)),
                                   .moment = wcut_alloc((size_t)n, sizeof(double)),
                                   .cut_gram = wcut_alloc(square * k, sizeof(double)),
                                   .cut_moment = wcut_alloc((size_t)n * k, sizeof(double)),
                                   .cut_total = wcut_alloc(k, sizeof(double)),
                                   .cut_log_det = wcut_alloc(k, sizeof(double)),
                                   .plain_gram = wcut_alloc(square * k, sizeof(double)),
                                   .plain_moment = wcut_alloc((size_t)n * k, sizeof(double)),
                                   .plain_total = wcut_alloc(k, sizeof(double)),
                                   .cross = wcut_alloc(scatter * (size_t)n * k, sizeof(double)),
                                   .cross_moment = wcut_alloc(scatter * k, sizeof(double)),
                                   .own = wcut_alloc(scatter * scatter * k, sizeof(double)),
                                   .room = wcut_alloc(scatter * (size_t)n * k, sizeof(double))};

    /* all or nothing */
    if (out->gram && out->moment && out->cut_gram && out->cut_moment && out->cut_total && out->cut_log_det &&
        out->plain_gram && out->plain_moment && out->plain_total && out->cross && out->cross_moment && out->own &&
        out->room)
        return WCUT_OK;

    wcut_normal_equations_destroy(out);
    return WCUT_NO_MEMORY;
}

void wcut_normal_equations_destroy(wcut_normal_equations *normal) {
    wcut_free(normal->gram);
    wcut_free(normal->moment);
    wcut_free(normal->cut_gram);
    wcut_free(normal->cut_moment);
    wcut_free(normal->cut_total);
    wcut_free(normal->cut_log_det);
    wcut_free(normal->plain_gram);
    wcut_free(normal->plain_moment);
    wcut_free(normal->plain_total);
    wcut_free(normal->cross);
    wcut_free(normal->cross_moment);
    wcut_free(normal->own);
    wcut_free(normal->room);
    *normal = (wcut_normal_equations){0};
}

static double dot(int n, const double *a, const double *b) {
    double sum[4] = {0};
    int i = 0;
    for (; i + 4 <= n; i += 4)
        for (int k = 0; k < 4; k++) sum[k] += a[i + k] * b[i + k];
    for (; i < n; i++) sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* products of a cut's rows: columns and residual, the scatter's columns with both and with themselves */
static void fill_cut_products(const wcut_evidence *e, int cut, const double *column, const double *residual,
                              wcut_normal_equations *out) {
    const wcut_evidence_cut *c = &e->cut[cut];

    /* the cut's rows lie together */
    const int count = WCUT_SIGNALS * c->bins + c->patch.count, from = c->row, n = out->n, m = out->m;
    const size_t rows = (size_t)e->rows, k = (size_t)cut, wide = (size_t)n, deep = (size_t)m;
    double *gram = out->plain_gram + k * wide * wide, *moment = out->plain_moment + k * wide;

    /* X' X and X' r, symmetric */
    for (int i = 0; i < n; i++) {
        const double *x = column + (size_t)i * rows + from;
        moment[i] = dot(count, x, residual + from);
        for (int j = 0; j <= i; j++)
            gram[(size_t)i * wide + (size_t)j] = gram[(size_t)j * wide + (size_t)i] =
                dot(count, x, column + (size_t)j * rows + from);
    }
    out->plain_total[cut] = dot(count, residual + from, residual + from);

    /* the scatter's columns */
    double *cross = out->cross + k * deep * wide, *cross_moment = out->cross_moment + k * deep;
    double *own = out->own + k * deep * deep;
    for (int i = 0; i < m; i++) {
        const double *x = e->scatter.white + (size_t)i * rows + from;
        cross_moment[i] = dot(count, x, residual + from);
        for (int j = 0; j < n; j++)
            cross[(size_t)i * wide + (size_t)j] = dot(count, x, column + (size_t)j * rows + from);
        for (int j = 0; j <= i; j++)
            own[(size_t)i * deep + (size_t)j] = own[(size_t)j * deep + (size_t)i] =
                dot(count, x, e->scatter.white + (size_t)j * rows + from);
    }
}

void wcut_normal_equations_fill(const wcut_evidence *e, const double *column, const double *residual,
                                wcut_normal_equations *out) {
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
    for (int k = 0; k < e->cuts; k++) fill_cut_products(e, k, column, residual, out);
    wcut_normal_equations_weigh(e, out);
}

/* Woodbury 1950: with V = I + J S J', X' V^-1 X = X' X - W' W, where L L' = I + S^1/2 J'J S^1/2, L W = S^1/2 J'X */
static void weigh_cut(const wcut_evidence *e, int cut, wcut_normal_equations *out) {
    const int n = out->n, m = out->m;
    const size_t k = (size_t)cut, wide = (size_t)n, deep = (size_t)m;
    double factor[WCUT_SCATTER_COLUMNS_MAX * WCUT_SCATTER_COLUMNS_MAX], w[WCUT_SCATTER_COLUMNS_MAX];
    double spread[WCUT_SCATTER_COLUMNS_MAX];

    /* without scatter the weighed sums are the plain ones */
    double *gram = out->cut_gram + k * wide * wide, *moment = out->cut_moment + k * wide;
    memcpy(gram, out->plain_gram + k * wide * wide, wide * wide * sizeof *gram);
    memcpy(moment, out->plain_moment + k * wide, wide * sizeof *moment);
    out->cut_total[cut] = out->plain_total[cut], out->cut_log_det[cut] = 0;
    if (m == 0) return;

    /* factor of what the scatter adds, seen from its own coordinates */
    const double *own = out->own + k * deep * deep;
    for (int i = 0; i < m; i++) spread[i] = e->noise.scatter[e->scatter.kind[i]];
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++) factor[i * m + j] = (i == j) + spread[i] * spread[j] * own[i * m + j];
    if (!wcut_cholesky_factor(m, factor, PIVOT_MIN)) return; /* never: the identity is in it */
    for (int i = 0; i < m; i++) out->cut_log_det[cut] += 2 * log(factor[i * m + i]);

    /* w = L^-1 S^1/2 J' r, and row by row of W = L^-1 S^1/2 J' X */
    double *cross = out->room + k * deep * wide;
    for (int i = 0; i < m; i++) {
        const double *from = out->cross + (k * deep + (size_t)i) * wide;
        double *to = cross + (size_t)i * wide;
        w[i] = spread[i] * out->cross_moment[k * deep + (size_t)i];
        for (int j = 0; j < n; j++) to[j] = spread[i] * from[j];
        for (int p = 0; p < i; p++) {
            const double f = factor[i * m + p];
            w[i] -= f * w[p];
            for (int j = 0; j < n; j++) to[j] -= f * cross[(size_t)p * wide + (size_t)j];
        }
        w[i] /= factor[i * m + i];
        for (int j = 0; j < n; j++) to[j] /= factor[i * m + i];
        out->cut_total[cut] -= w[i] * w[i];
        for (int a = 0; a < n; a++) {
            moment[a] -= to[a] * w[i];
            for (int b = 0; b < n; b++) gram[(size_t)a * wide + (size_t)b] -= to[a] * to[b];
        }
    }
}

void wcut_normal_equations_weigh(const wcut_evidence *e, wcut_normal_equations *out) {
    const size_t square = (size_t)out->n * (size_t)out->n;
    memset(out->gram, 0, square * sizeof(double));
    memset(out->moment, 0, (size_t)out->n * sizeof(double));
    out->total = 0;
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
    for (int k = 0; k < e->cuts; k++) weigh_cut(e, k, out);
    for (int k = 0; k < e->cuts; k++) {
        for (size_t i = 0; i < square; i++) out->gram[i] += out->cut_gram[(size_t)k * square + i];
        for (int i = 0; i < out->n; i++) out->moment[i] += out->cut_moment[(size_t)k * (size_t)out->n + (size_t)i];
        out->total += out->cut_total[k];
    }
}

bool wcut_normal_equations_solve(const wcut_normal_equations *normal, int count, const int *chosen,
                                 const double *centre, const double *precision, int without, double *t,
                                 double *covariance, double *cost) {
    double m[WCUT_FITTED_MAX * WCUT_FITTED_MAX], b[WCUT_FITTED_MAX], scale[WCUT_FITTED_MAX], unit[WCUT_FITTED_MAX];
    if (count > WCUT_FITTED_MAX) return false;
    const int n = normal->n;

    /* leave one cut out by subtracting its sums */
    const double *less = without < 0 ? NULL : normal->cut_gram + (size_t)without * (size_t)n * (size_t)n;
    const double *less_moment = without < 0 ? NULL : normal->cut_moment + (size_t)without * (size_t)n;
    double total = normal->total - (without < 0 ? 0 : normal->cut_total[without]);

    /* the matrix of the chosen columns with their priors, and its right side */
    for (int i = 0; i < count; i++) {
        const int ci = chosen[i];
        for (int j = 0; j < count; j++) {
            const size_t at = (size_t)ci * (size_t)n + (size_t)chosen[j];
            m[i * count + j] = normal->gram[at] - (less ? less[at] : 0);
        }
        b[i] = normal->moment[ci] - (less_moment ? less_moment[ci] : 0) + precision[ci] * centre[ci];
        m[i * count + i] += precision[ci];
        total += precision[ci] * centre[ci] * centre[ci];
        scale[i] = m[i * count + i] > 0 ? 1 / sqrt(m[i * count + i]) : 0;
    }

    /* scale to a unit diagonal: the columns have different units */
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) m[i * count + j] *= scale[i] * scale[j];
        if (scale[i] == 0) m[i * count + i] = 1; /* a column of nothing: 0 stays 0 */
        t[i] = b[i] * scale[i];
    }
    if (count < 1) { /* nothing to choose: what there is remains */
        *cost = total;
        return true;
    }

    /* solve; the minimum is total - t' b */
    if (!wcut_cholesky_factor(count, m, PIVOT_MIN)) return false;
    wcut_cholesky_solve(count, m, t);
    *cost = total;
    for (int i = 0; i < count; i++) t[i] *= scale[i], *cost -= t[i] * b[i];

    /* covariance: columns of the inverse, one unit vector each */
    for (int j = 0; covariance && j < count; j++) {
        for (int i = 0; i < count; i++) unit[i] = i == j;
        wcut_cholesky_solve(count, m, unit);
        for (int i = 0; i < count; i++) covariance[i * count + j] = unit[i] * scale[i] * scale[j];
    }

    return true;
}

double wcut_normal_equations_cost(const wcut_normal_equations *normal, int cut, int count, const int *chosen,
                                  const double *t) {
    const int n = normal->n;
    const double *gram = normal->cut_gram + (size_t)cut * (size_t)n * (size_t)n;
    const double *moment = normal->cut_moment + (size_t)cut * (size_t)n;
    double cost = normal->cut_total[cut];
    for (int i = 0; i < count; i++) {
        cost -= 2 * t[i] * moment[chosen[i]];
        for (int j = 0; j < count; j++) cost += t[i] * t[j] * gram[(size_t)chosen[i] * (size_t)n + (size_t)chosen[j]];
    }
    return cost;
}
