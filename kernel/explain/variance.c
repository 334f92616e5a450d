/* Variance components: how large noise and scatter of a case are, by the likelihood of what a model leaves. */
#include "explain/variance.h"

#include <string.h>

#include "base/alloc.h"
#include "base/dense.h"
#include "base/numbers.h"
#include "base/symmetric.h"
#include "base/threads.h"

enum { COLUMNS = WCUT_SCATTER_COLUMNS_MAX, ROUNDS = 3, STEPS = 8, GOLDEN = 14 };

/* a model's own error: what two simulators of the same physics differ by, slowly [N], [rad] */
#define MODEL_ERROR_TENSION 0.004
#define MODEL_ERROR_ANGLE (0.008 * WCUT_PI / 180)
/* [1] slow noise of a sensor over its white one, at most; more is not the sensor's */
#define SENSOR_SLOW_MAX 0.75
/* [mm] mounts beside their path: width of the prior, and the most that is ordinary */
#define PATH_WIDTH 0.25
#define PATH_MIN 0.004
#define PATH_MAX 0.6

void wcut_variances_begin(wcut_variances *v) {
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++)
        v->scatter[k] = fmax(v->scatter[k], 0.2 * wcut_scatter_view(v, (wcut_scatter_kind)k)->width);
}

/* ---- scatter ---- */

/* inverse of a cut's I + S^1/2 J'J S^1/2, m x m */
static void invert_factor(const wcut_evidence *own, const wcut_normal_equations *normal, int cut, double *spread,
                          double *inverse) {
    const int m = normal->m;
    const double *gram = normal->own + (size_t)cut * (size_t)m * (size_t)m;
    double factor[COLUMNS * COLUMNS];

    /* B = I + S^1/2 J'J S^1/2 and its Cholesky factor */
    for (int i = 0; i < m; i++) spread[i] = own->noise.scatter[own->scatter.kind[i]];
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++) factor[i * m + j] = (i == j) + spread[i] * spread[j] * gram[i * m + j];
    wcut_cholesky_factor(m, factor, 0); /* the identity is in it */

    /* columns of the identity, one by one: L x = e, then L' y = x */
    for (int k = 0; k < m; k++) {
        double *x = inverse + (size_t)k * (size_t)m;
        for (int i = 0; i < m; i++) {
            x[i] = i == k;
            for (int j = k; j < i; j++) x[i] -= factor[i * m + j] * x[j];
            x[i] /= factor[i * m + i];
        }
        for (int i = m - 1; i >= 0; i--) {
            for (int j = i + 1; j < m; j++) x[i] -= factor[j * m + i] * x[j];
            x[i] /= factor[i * m + i];
        }
    }
}

/* J' (r - X t) of a cut */
static void scatter_moment(const wcut_normal_equations *normal, int cut, const double *t, double *out) {
    const int n = normal->n, m = normal->m;
    for (int i = 0; i < m; i++) {
        const double *cross = normal->cross + ((size_t)cut * (size_t)m + (size_t)i) * (size_t)n;
        out[i] = normal->cross_moment[(size_t)cut * (size_t)m + (size_t)i];
        for (int j = 0; j < n; j++) out[i] -= cross[j] * t[j];
    }
}

void wcut_scatter_estimate(const wcut_evidence *own, const wcut_normal_equations *normal, int cut, const double *t,
                           double *value, double *error) {
    const int m = normal->m;
    double spread[COLUMNS], inverse[COLUMNS * COLUMNS], moment[COLUMNS];
    invert_factor(own, normal, cut, spread, inverse);
    scatter_moment(normal, cut, t, moment);
    for (int i = 0; i < m; i++) {
        value[i] = 0;
        for (int j = 0; j < m; j++) value[i] += spread[i] * inverse[i * m + j] * spread[j] * moment[j];
        error[i] = spread[i] * sqrt(fmax(inverse[i * m + i], 0));
    }
}

/* what the uncertainty of t adds to the variance of a cut's coefficient: k' C k, k = row of S^1/2 A^-1 S^1/2 J'X */
static double shared_variance(const wcut_normal_equations *normal, int cut, const double *spread, const double *inverse,
                              int i, const double *covariance) {
    const int n = normal->n, m = normal->m;
    double k[WCUT_FITTED_MAX] = {0}, sum = 0;
    for (int j = 0; j < m; j++) {
        const double weight = spread[i] * inverse[i * m + j] * spread[j];
        const double *cross = normal->cross + ((size_t)cut * (size_t)m + (size_t)j) * (size_t)n;
        for (int p = 0; p < n; p++) k[p] += weight * cross[p];
    }
    for (int p = 0; p < n; p++)
        for (int q = 0; q < n; q++) sum += k[p] * covariance[p * n + q] * k[q];
    return sum;
}

/* one step of expectation and maximisation for the scatter's standard deviations */
static bool step_scatter(wcut_evidence *own, const wcut_linear *p, wcut_normal_equations *normal, double *t,
                         double *covariance) {
    double square[WCUT_SCATTER_COUNT] = {0};
    int chosen[WCUT_FITTED_MAX], count[WCUT_SCATTER_COUNT] = {0};
    double cost;

    /* the shared coefficients and their covariance */
    for (int k = 0; k < p->n; k++) chosen[k] = k;
    if (!wcut_normal_equations_solve(normal, p->n, chosen, p->centre, p->precision, -1, t, covariance, &cost))
        return false;

    /* the coefficients of each cut, given the shared ones */
    for (int cut = 0; cut < own->cuts; cut++) {
        double spread[COLUMNS], inverse[COLUMNS * COLUMNS], moment[COLUMNS];
        if (own->cut[cut].bins == 0) continue;
        invert_factor(own, normal, cut, spread, inverse);
        scatter_moment(normal, cut, t, moment);

        /* expected square of every coefficient: its mean, its own variance, and that of the shared coefficients */
        for (int i = 0; i < normal->m; i++) {
            const wcut_scatter_kind kind = own->scatter.kind[i];
            double value = 0;
            if (normal->own[((size_t)cut * (size_t)normal->m + (size_t)i) * (size_t)normal->m + (size_t)i] <= 0)
                continue;
            for (int j = 0; j < normal->m; j++) value += spread[i] * inverse[i * normal->m + j] * spread[j] * moment[j];
            square[kind] += value * value + spread[i] * spread[i] * inverse[i * normal->m + i] +
                            shared_variance(normal, cut, spread, inverse, i, covariance);
            count[kind]++;
        }
    }

    /* the likeliest variance v: n / v - S / v^2 + 1 / h^2 = 0, taken a little further than the step says */
    for (int k = 0; k < WCUT_SCATTER_COUNT; k++) {
        if (count[k] == 0) continue;
        const wcut_scatter_info *info = wcut_scatter_view(&own->noise, (wcut_scatter_kind)k);
        const double h = info->width * info->width, n = count[k];
        const double v = h / 2 * (sqrt(n * n + 4 * square[k] / h) - n);
        const double from = own->noise.scatter[k] * own->noise.scatter[k];
        const double to = from > 0 ? v * pow(v / from, 0.8) : v;
        own->noise.scatter[k] = clamp(sqrt(to), 1e-3 * info->width, info->max);
    }
    wcut_normal_equations_weigh(own, normal);

    return true;
}

/* ---- slow noise ---- */

/* what t and the scatter leave, as measured */
static void conditional_residual(const wcut_evidence *own, const wcut_linear *p, const wcut_normal_equations *normal,
                                 const double *t, double *out) {
    const size_t rows = (size_t)own->rows;
    memcpy(out, p->residual, rows * sizeof *out);
    for (int k = 0; k < p->n; k++)
        for (size_t i = 0; i < rows; i++) out[i] -= t[k] * p->column[(size_t)k * rows + i];
    for (int cut = 0; cut < own->cuts; cut++) {
        const wcut_evidence_cut *c = &own->cut[cut];
        double value[COLUMNS], error[COLUMNS];
        if (c->bins == 0 || normal->m == 0) continue;
        wcut_scatter_estimate(own, normal, cut, t, value, error);
        for (int k = 0; k < normal->m; k++)
            for (int i = 0; i < WCUT_SIGNALS * c->bins; i++)
                out[c->row + i] -= value[k] * own->scatter.column[(size_t)k * rows + (size_t)(c->row + i)];
    }
}

/* mean white variance of a group */
static double group_white(const wcut_evidence *e, int group) {
    double sum = 0;
    for (int s = 0; s < WCUT_SIGNALS; s++)
        if (wcut_noise_group(s) == group) sum += e->sigma[s] * e->sigma[s] / 2;
    return sum;
}

/* slow noise of a group that mounts beside their path by 1 mm make, over its white one */
static double path_share(const wcut_evidence *e, int group) {
    return e->path_response[group] * e->path_response[group] / group_white(e, group);
}

/* least slow noise of a group: a good sensor's, and what two simulators of the same physics differ by */
static double slow_least(const wcut_evidence *e, int group) {
    const double model = group == 0 ? MODEL_ERROR_TENSION : MODEL_ERROR_ANGLE;
    return fmax(WCUT_SLOW_NOISE, model * model / group_white(e, group));
}

/* variance of the half-normal prior of a group's own slow noise */
static double slow_usual(const wcut_evidence *e, int group) { return fmax(SENSOR_SLOW_MAX, slow_least(e, group)); }

/* The slow noise sought: the path's error, of which all groups have their share, or what a group has of its own. */
typedef struct slow_search {
    wcut_evidence *own;
    const wcut_linear *p;
    const double *residual;
    double *room;                   /* rows */
    double rest[WCUT_NOISE_GROUPS]; /* slow noise beside the path's */
    int group;                      /* -1: of the path's error */
} slow_search;

/* -2 ln likelihood of a residual, priors included; x: logarithm of the path's error or of a group's own slow noise */
static double slow_score(slow_search *f, double x) {
    wcut_evidence *own = f->own;
    if (f->group < 0)
        own->noise.path = exp(x);
    else
        f->rest[f->group] = exp(x);
    const double path = own->noise.path;
    for (int g = 0; g < WCUT_NOISE_GROUPS; g++) own->noise.slow[g] = f->rest[g] + path * path * path_share(own, g);

    /* whitened squares, the determinant, half-normal priors of the standard deviations */
    wcut_evidence_whiten(own, f->p->missing, f->residual, f->room);
    double score = wcut_evidence_log_det(own, f->p->missing) + path * path / (PATH_WIDTH * PATH_WIDTH);
    for (int k = 0; k < own->cuts; k++) {
        const wcut_evidence_cut *c = &own->cut[k];
        for (int i = c->row; i < c->row + WCUT_SIGNALS * c->bins; i++) score += f->room[i] * f->room[i];
    }
    for (int g = 0; g < WCUT_NOISE_GROUPS; g++) score += f->rest[g] / slow_usual(own, g);
    return score;
}

/* the best x between two ends, by golden section; slow_score is left at it */
static void find_slow(slow_search *f, double low, double high) {
    const double golden = 0.3819660112501051;
    double ends[2] = {low, high}, x[2], score[2];
    for (int k = 0; k < 2; k++) x[k] = ends[k] + (k ? -golden : golden) * (high - low);
    for (int k = 0; k < 2; k++) score[k] = slow_score(f, x[k]);

    /* drop the end beside the worse point; the other inner point is used again */
    for (int round = 0; round < GOLDEN && ends[1] - ends[0] > 0.1; round++) {
        const int worse = score[0] > score[1] ? 0 : 1, other = 1 - worse;
        ends[worse] = x[worse];
        x[worse] = x[other], score[worse] = score[other];
        x[other] = other ? ends[1] - golden * (ends[1] - ends[0]) : ends[0] + golden * (ends[1] - ends[0]);
        score[other] = slow_score(f, x[other]);
    }
    slow_score(f, score[0] < score[1] ? x[0] : x[1]);
}

/*
 * The likeliest slow noise of what t and the scatter leave. Mounts beside their path move tensions and angles together, so
 * that their error is one for all groups; a group may have as much again of its own, since the waves of a path are not those
 * of path_response, and what a sensor drifts by.
 */
static void step_slow(wcut_evidence *own, const wcut_linear *p, const double *residual, double *room) {
    slow_search f = {.own = own, .p = p, .residual = residual, .room = room, .group = -1};
    bool any = false;
    for (int g = 0; g < WCUT_NOISE_GROUPS; g++) {
        f.rest[g] =
            fmax(own->noise.slow[g] - own->noise.path * own->noise.path * path_share(own, g), slow_least(own, g));
        any = any || own->path_response[g] > 0;
    }
    if (any) find_slow(&f, log(PATH_MIN), log(PATH_MAX));
    const double path = own->noise.path;
    for (f.group = 0; f.group < WCUT_NOISE_GROUPS; f.group++) {
        const double least = slow_least(own, f.group);
        const double most = fmax(SENSOR_SLOW_MAX, 1.01 * least) + path * path * path_share(own, f.group);
        find_slow(&f, log(least), log(most));
    }
}

/* ---- both ---- */

static void fill_equations(const wcut_linear *p, wcut_evidence *own, double *column, double *residual,
                           wcut_normal_equations *normal) {
    const size_t rows = (size_t)own->rows;
    wcut_evidence_whiten_scatter(own, p->missing);
    for (int k = 0; k < p->n; k++)
        wcut_evidence_whiten(own, p->missing, p->column + (size_t)k * rows, column + (size_t)k * rows);
    wcut_evidence_whiten(own, p->missing, p->residual, residual);
    wcut_normal_equations_fill(own, column, residual, normal);
}

/* ln of the priors of the standard deviations, times -2 */
static double prior_score(const wcut_evidence *own) {
    double sum = 0;
    for (int k = 0; k < WCUT_SCATTER_COUNT && own->scatter.count > 0; k++) {
        const double ratio = own->noise.scatter[k] / wcut_scatter_view(&own->noise, (wcut_scatter_kind)k)->width;
        sum += ratio * ratio;
    }
    return sum;
}

wcut_status wcut_variance_fit(const wcut_linear *p, wcut_evidence *own, double *column, double *residual,
                              wcut_normal_equations *normal, double *score) {
    const size_t rows = (size_t)own->rows;
    double t[WCUT_FITTED_MAX], cost;
    int chosen[WCUT_FITTED_MAX];
    double *left = wcut_alloc(rows, sizeof *left), *room = wcut_alloc(rows, sizeof *room);
    double *covariance = wcut_alloc((size_t)p->n * (size_t)p->n, sizeof *covariance);
    wcut_status status = left && room && covariance ? WCUT_OK : WCUT_NO_MEMORY;

    /* in turn: the scatter at this slow noise, the slow noise of what scatter and coefficients leave */
    for (int round = 0; status == WCUT_OK && round < ROUNDS; round++) {
        fill_equations(p, own, column, residual, normal);
        for (int k = 0; status == WCUT_OK && k < STEPS; k++)
            if (!step_scatter(own, p, normal, t, covariance)) status = WCUT_NOT_CONVERGED;
        if (status != WCUT_OK) break;
        conditional_residual(own, p, normal, t, left);
        step_slow(own, p, left, room);
    }

    /* the solution under the final variances */
    if (status == WCUT_OK) {
        fill_equations(p, own, column, residual, normal);
        for (int k = 0; k < p->n; k++) chosen[k] = k;
        if (!wcut_normal_equations_solve(normal, p->n, chosen, p->centre, p->precision, -1, t, NULL, &cost))
            status = WCUT_NOT_CONVERGED;
    }

    /* -2 ln likelihood: cost, determinants of noise and of scatter, priors of the variances */
    if (status == WCUT_OK) {
        *score = cost + wcut_evidence_log_det(own, p->missing) + prior_score(own);
        for (int k = 0; k < own->cuts; k++) *score += normal->cut_log_det[k];
    }

    wcut_free(covariance);
    wcut_free(room);
    wcut_free(left);
    return status;
}

/* ---- standardised rows ---- */

/*
 * With B = I + S^1/2 J'J S^1/2 the symmetric root is V^-1/2 = I - J S^1/2 (B + B^1/2)^-1 S^1/2 J': a row moves no further
 * than its cut's scatter reaches.
 */
static void standardise_cut(const wcut_evidence *own, const wcut_normal_equations *normal, int cut, double *z) {
    const wcut_evidence_cut *c = &own->cut[cut];
    const int m = normal->m, count = WCUT_SIGNALS * c->bins + c->patch.count;
    const double *gram = normal->own + (size_t)cut * (size_t)m * (size_t)m;
    double b[COLUMNS * COLUMNS] = {0}, v[COLUMNS * COLUMNS], value[COLUMNS], spread[COLUMNS], moment[COLUMNS],
                       in[COLUMNS];

    /* B, and its eigenvalues and vectors */
    for (int i = 0; i < m; i++) spread[i] = own->noise.scatter[own->scatter.kind[i]];
    for (int i = 0; i < m; i++)
        for (int j = 0; j < m; j++) b[i * m + j] = (i == j) + spread[i] * spread[j] * gram[i * m + j];
    wcut_symmetric_eigen(m, b, value, v);

    /* S^1/2 J' z in the eigenvectors' coordinates, weighed, and back */
    for (int i = 0; i < m; i++) {
        const double *x = own->scatter.white + (size_t)i * (size_t)own->rows + (size_t)c->row;
        moment[i] = 0;
        for (int k = 0; k < count; k++) moment[i] += spread[i] * x[k] * z[c->row + k];
    }
    for (int e = 0; e < m; e++) {
        const double root = sqrt(fmax(value[e], 1));
        in[e] = 0;
        for (int i = 0; i < m; i++) in[e] += v[i * m + e] * moment[i];
        in[e] /= root * root + root;
    }
    for (int i = 0; i < m; i++) {
        const double *x = own->scatter.white + (size_t)i * (size_t)own->rows + (size_t)c->row;
        double weight = 0;
        for (int e = 0; e < m; e++) weight += v[i * m + e] * in[e];
        for (int k = 0; k < count; k++) z[c->row + k] -= spread[i] * weight * x[k];
    }
}

void wcut_scatter_standardise(const wcut_evidence *own, const wcut_normal_equations *normal, double *z) {
    if (normal->m == 0) return;
#pragma omp parallel for num_threads(wcut_threads(own->threads)) schedule(dynamic, 1)
    for (int k = 0; k < own->cuts; k++)
        if (own->cut[k].bins > 0) standardise_cut(own, normal, k, z);
}
