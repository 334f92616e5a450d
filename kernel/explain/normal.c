/* Normal equations with priors, whole and by cut, so that any choice of columns and cuts is solved at once. */
#include <string.h>

#include "base/alloc.h"
#include "base/dense.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "explain/fit.h"

static const double PIVOT_MIN = 1e-11; /* [1] of a matrix of unit diagonal, below which it is singular */

wcut_status wcut_normal_equations_create(int n, int cuts, wcut_normal_equations *out) {
    const size_t square = (size_t)n * (size_t)n, m = (size_t)cuts;
    *out = (wcut_normal_equations){.n = n,
                                   .cuts = cuts,
                                   .gram = wcut_alloc(square, sizeof(double)),
                                   .moment = wcut_alloc((size_t)n, sizeof(double)),
                                   .cut_gram = wcut_alloc(square * m, sizeof(double)),
                                   .cut_moment = wcut_alloc((size_t)n * m, sizeof(double)),
                                   .cut_total = wcut_alloc(m, sizeof(double))};
    if (out->gram && out->moment && out->cut_gram && out->cut_moment && out->cut_total) return WCUT_OK;
    wcut_normal_equations_destroy(out);
    return WCUT_NO_MEMORY;
}

void wcut_normal_equations_destroy(wcut_normal_equations *normal) {
    wcut_free(normal->gram);
    wcut_free(normal->moment);
    wcut_free(normal->cut_gram);
    wcut_free(normal->cut_moment);
    wcut_free(normal->cut_total);
    *normal = (wcut_normal_equations){0};
}

static double dot(int n, const double *a, const double *b) {
    double sum = 0;
    for (int i = 0; i < n; i++) sum += a[i] * b[i];
    return sum;
}

void wcut_normal_equations_fill(const wcut_evidence *e, const double *column, const double *residual,
                                wcut_normal_equations *out) {
    const int n = out->n;
    const size_t rows = (size_t)e->rows, square = (size_t)n * (size_t)n;
    memset(out->gram, 0, square * sizeof(double));
    memset(out->moment, 0, (size_t)n * sizeof(double));
    out->total = 0;
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        const int count = WCUT_SIGNALS * c->bins + c->patch.count, from = c->row;
        double *gram = out->cut_gram + (size_t)k * square, *moment = out->cut_moment + (size_t)k * (size_t)n;
        for (int i = 0; i < n; i++) {
            const double *x = column + (size_t)i * rows + from;
            moment[i] = dot(count, x, residual + from);
            for (int j = 0; j <= i; j++)
                gram[(size_t)i * (size_t)n + j] = gram[(size_t)j * (size_t)n + i] =
                    dot(count, x, column + (size_t)j * rows + from);
        }
        out->cut_total[k] = dot(count, residual + from, residual + from);
    }
    for (int k = 0; k < e->cuts; k++) {
        for (size_t i = 0; i < square; i++) out->gram[i] += out->cut_gram[(size_t)k * square + i];
        for (int i = 0; i < n; i++) out->moment[i] += out->cut_moment[(size_t)k * (size_t)n + (size_t)i];
        out->total += out->cut_total[k];
    }
}

bool wcut_normal_equations_solve(const wcut_normal_equations *normal, int count, const int *chosen,
                                 const double *centre, const double *precision, int without, double *t,
                                 double *covariance, double *cost) {
    double m[WCUT_FIT_MAX * WCUT_FIT_MAX], b[WCUT_FIT_MAX], scale[WCUT_FIT_MAX], unit[WCUT_FIT_MAX];
    if (count > WCUT_FIT_MAX) return false;
    const int n = normal->n;
    const double *less = without < 0 ? NULL : normal->cut_gram + (size_t)without * (size_t)n * (size_t)n;
    const double *less_moment = without < 0 ? NULL : normal->cut_moment + (size_t)without * (size_t)n;
    double total = normal->total - (without < 0 ? 0 : normal->cut_total[without]);
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
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < count; j++) m[i * count + j] *= scale[i] * scale[j];
        if (scale[i] == 0) m[i * count + i] = 1; /* a column of nothing: 0 stays 0 */
        t[i] = b[i] * scale[i];
    }
    if (count < 1) { /* nothing to choose: what there is remains */
        *cost = total;
        return true;
    }
    if (!wcut_cholesky_factor(count, m, PIVOT_MIN)) return false;
    wcut_cholesky_solve(count, m, t);
    *cost = total;
    for (int i = 0; i < count; i++) t[i] *= scale[i], *cost -= t[i] * b[i];
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
