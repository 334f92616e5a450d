/* On what a residual depends that no known effect explains: a sparse regression of the foam's force. */
#include "explain/dependence.h"

#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "explain/features.h"
#include "explain/search.h"

/* a step must be so unlikely by chance, over the whole list; and so much better on cuts it was not fitted to */
#define LEVEL 1e-3
#define CONFIRMED 6.0
/* candidates of a step that are held against the other cuts */
enum { TRIED = 6 };

/* beside recalibration: latencies of the instruments, which the shortest memories of speed and heat stand for */
enum { BASE = WCUT_BASE + WCUT_LATENCIES };

typedef struct regression {
    const wcut_evidence *e;
    int features, n; /* n: base and features */
    wcut_feature *feature;
    double *scale;  /* features: of each to a standard deviation of 1 */
    double *column; /* n x rows, whitened; patches 0 */
    double *residual;
    wcut_normal_equations normal;
    double *centre, *precision; /* n */
    int count, chosen[BASE + 2 * WCUT_DEPENDENCES];
    double cost;
} regression;

/* a step: a feature, or a sine with its cosine */
typedef struct step {
    int feature, width;
    double gain, fall;
} step;

static void regression_destroy(regression *r) {
    wcut_free(r->feature);
    wcut_free(r->scale);
    wcut_free(r->column);
    wcut_free(r->residual);
    wcut_free(r->centre);
    wcut_free(r->precision);
    wcut_normal_equations_destroy(&r->normal);
}

static bool regression_create(const wcut_evidence *e, int cuts, regression *r) {
    const size_t rows = (size_t)e->rows, most = WCUT_FEATURES_MOST;
    *r = (regression){.e = e, .feature = wcut_alloc(most, sizeof(wcut_feature))};
    if (!r->feature) return false;
    r->features = wcut_features_list(cuts > 1, r->feature);
    r->n = WCUT_BASE + r->features;
    r->scale = wcut_alloc((size_t)r->features, sizeof(double));
    r->column = wcut_alloc((size_t)r->n * rows, sizeof(double));
    r->residual = wcut_alloc(rows, sizeof(double));
    r->centre = wcut_alloc((size_t)r->n, sizeof(double));
    r->precision = wcut_alloc((size_t)r->n, sizeof(double));
    return r->scale && r->column && r->residual && r->centre && r->precision &&
           wcut_normal_equations_create(r->n, e->cuts, &r->normal) == WCUT_OK;
}

/* ---- columns ---- */

/* changes of the prediction with the base coordinates into the first columns, not whitened */
static wcut_status base_columns(regression *r, const wcut_model *about, wcut_error *error) {
    wcut_model model[1 + WCUT_BASE] = {*about, *about, *about, *about};
    const size_t rows = (size_t)r->e->rows;
    double *all = wcut_alloc((1 + WCUT_BASE) * rows, sizeof *all);
    if (!all) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", r->e->rows);
    model[1].a *= exp(wcut_base_step[0]), model[2].b *= exp(wcut_base_step[1]);
    model[3].length_change += wcut_base_step[2];
    const wcut_status status = wcut_models_rows(r->e, 1 + WCUT_BASE, model, all, error);
    for (size_t k = 0; status == WCUT_OK && k < WCUT_BASE; k++)
        for (size_t i = 0; i < rows; i++)
            r->column[k * rows + i] = (all[(1 + k) * rows + i] - all[i]) / wcut_base_step[k];
    wcut_free(all);
    return status;
}

static void clear_patches(const wcut_evidence *e, double *row) {
    for (int k = 0; k < e->cuts; k++)
        for (int i = 0; i < e->cut[k].patch.count; i++) row[e->cut[k].row + WCUT_SIGNALS * e->cut[k].bins + i] = 0;
}

/* a feature times the change with ln a: the force's relative change; value: WCUT_WEIGHTS x the most bins */
static void feature_column(regression *r, int k, const wcut_response *d, double *value) {
    static const wcut_weight weight[WCUT_SIGNALS] = {WCUT_WEIGHT_EVEN, WCUT_WEIGHT_EVEN, WCUT_WEIGHT_A,
                                                     WCUT_WEIGHT_A,    WCUT_WEIGHT_B,    WCUT_WEIGHT_B};
    double *column = r->column + (size_t)(WCUT_BASE + k) * (size_t)r->e->rows, mean = 0, square = 0;
    int bins = 0;
    for (int pass = 0; pass < 2; pass++) { /* mean and spread first */
        for (int cut = 0; cut < r->e->cuts; cut++) {
            const wcut_evidence_cut *c = &r->e->cut[cut];
            if (c->bins == 0) continue;
            wcut_feature_eval(c, &d[cut], &r->feature[k], value);
            for (int i = 0; pass == 0 && i < c->bins; i++) mean += value[i], square += value[i] * value[i], bins++;
            for (int i = 0; pass == 1 && i < WCUT_SIGNALS * c->bins; i++)
                column[c->row + i] = r->column[c->row + i] * r->scale[k] *
                                     (value[(int)weight[i / c->bins] * c->bins + i % c->bins] - mean);
        }
        if (pass > 0) break;
        mean /= bins;
        const double variance = square / bins - mean * mean;
        r->scale[k] = variance > 1e-10 * square / bins ? 1 / sqrt(variance) : 0;
    }
}

static wcut_status fill(regression *r, const wcut_fitted *about, const double *raw, wcut_error *error) {
    const wcut_evidence *e = r->e;
    const size_t rows = (size_t)e->rows;
    wcut_status status = base_columns(r, &about->model, error);
    if (status != WCUT_OK) return status;
    int bins = 0;
    for (int k = 0; k < e->cuts; k++) bins = e->cut[k].bins > bins ? e->cut[k].bins : bins;
    wcut_response *d = wcut_alloc((size_t)e->cuts, sizeof *d);
    wcut_error *failed = wcut_alloc((size_t)e->cuts, sizeof *failed);
    double *value = wcut_alloc((size_t)e->threads * WCUT_WEIGHTS * (size_t)bins, sizeof *value);
    if (!d || !value || !failed) status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for the features");
    if (status == WCUT_OK) {
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
        for (int k = 0; k < e->cuts; k++) {
            if (e->cut[k].bins == 0) continue;
            wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
            const wcut_job job = wcut_model_job(e, &about->model, k, effect);
            failed[k].status =
                wcut_response_run(&job, WCUT_NODES_COARSE, &e->cut[k].exogenous, true, e->stop, &d[k], &failed[k]);
        }
        for (int k = 0; status == WCUT_OK && k < e->cuts; k++)
            if (failed[k].status != WCUT_OK) status = wcut_fail(error, failed[k].status, "%s", failed[k].text);
    }
    for (int k = 0; status == WCUT_OK && k < r->features; k++) feature_column(r, k, d, value);
    for (int k = 0; status == WCUT_OK && k < r->n; k++) {
        double *column = r->column + (size_t)k * rows;
        wcut_evidence_whiten(e, raw, column, column);
        clear_patches(e, column);
        r->precision[k] = k < WCUT_BASE ? 1 / (wcut_base_spread[k] * wcut_base_spread[k]) : 1;
    }
    memcpy(r->residual, about->residual, rows * sizeof(double));
    clear_patches(e, r->residual);
    if (status == WCUT_OK) wcut_normal_equations_fill(e, r->column, r->residual, &r->normal);
    for (int k = 0; d && k < e->cuts; k++) wcut_response_destroy(&d[k]);
    wcut_free(value);
    wcut_free(failed);
    wcut_free(d);
    return status;
}

/* ---- selection ---- */

static bool solve(const regression *r, const step *s, int without, double *t, double *covariance, double *cost) {
    int chosen[BASE + 2 * WCUT_DEPENDENCES + 2], count = r->count;
    memcpy(chosen, r->chosen, (size_t)r->count * sizeof *chosen);
    for (int k = 0; s && k < s->width; k++) chosen[count++] = WCUT_BASE + s->feature + k;
    return wcut_normal_equations_solve(&r->normal, count, chosen, r->centre, r->precision, without, t, covariance,
                                       cost);
}

/* what is left of the residual in units of noise, once the chosen columns and those of a step are fitted */
static double dispersion(const regression *r, const step *s, double *room) {
    double t[WCUT_FIT_MAX], cost;
    if (!solve(r, s, -1, t, NULL, &cost)) return HUGE_VAL;
    memcpy(room, r->residual, (size_t)r->e->rows * sizeof *room);
    for (int k = 0; k < r->count + s->width; k++) {
        const int at = k < r->count ? r->chosen[k] : WCUT_BASE + s->feature + k - r->count;
        const double *column = r->column + (size_t)at * (size_t)r->e->rows;
        for (int i = 0; i < r->e->rows; i++) room[i] -= t[k] * column[i];
    }
    const wcut_residual_stats left = wcut_residual_stats_eval(r->e, room);
    return fmax(1, fmax(left.slow, left.per_row));
}

/* fall of the misfit on each cut, fitted on the others; gives how many of the cuts are better */
static int confirm(const regression *r, step *s) {
    int better = 0;
    s->fall = 0;
    for (int cut = 0; cut < r->e->cuts; cut++) {
        double without[WCUT_FIT_MAX], with[WCUT_FIT_MAX], cost;
        int chosen[BASE + 2 * WCUT_DEPENDENCES + 2];
        if (r->e->cut[cut].bins == 0) continue;
        if (!solve(r, NULL, cut, without, NULL, &cost) || !solve(r, s, cut, with, NULL, &cost)) return 0;
        memcpy(chosen, r->chosen, (size_t)r->count * sizeof *chosen);
        for (int k = 0; k < s->width; k++) chosen[r->count + k] = WCUT_BASE + s->feature + k;
        const double fall = wcut_normal_equations_cost(&r->normal, cut, r->count, chosen, without) -
                            wcut_normal_equations_cost(&r->normal, cut, r->count + s->width, chosen, with);
        s->fall += fall, better += fall > 0;
    }
    return better;
}

static bool is_chosen(const regression *r, int feature) {
    for (int k = 0; k < r->count; k++)
        if (r->chosen[k] == WCUT_BASE + feature) return true;
    return false;
}

/* the steps that gain most, best first; gives how many there are of TRIED */
static int best_steps(const regression *r, step *best, int *list) {
    int n = 0;
    *list = 0;
    for (int k = 0; k < r->features; k++) {
        double t[WCUT_FIT_MAX], cost;
        step s = {.feature = k, .width = r->feature[k].wave ? 2 : 1};
        if (k > 0 && r->feature[k - 1].wave) continue; /* the cosine of a pair */
        if (is_chosen(r, k) || r->scale[k] == 0 || !solve(r, &s, -1, t, NULL, &cost)) continue;
        ++*list;
        s.gain = r->cost - cost;
        int at = n < TRIED ? n++ : TRIED;
        for (; at > 0 && best[at - 1].gain - 4 * best[at - 1].width < s.gain - 4 * s.width; at--)
            if (at < TRIED) best[at] = best[at - 1];
        if (at < TRIED) best[at] = s;
    }
    return n;
}

/* take the step that other cuts confirm most; false where none does. cuts: with bins */
static bool take_step(regression *r, int cuts, double *room, step *taken) {
    step best[TRIED];
    int list = 0;
    const int n = best_steps(r, best, &list);
    *taken = (step){.fall = 0};
    for (int k = 0; k < n; k++) {
        const double noise = dispersion(r, &best[k], room);
        if (!(wcut_chi_square_tail(best[k].gain / noise, best[k].width) * list < LEVEL)) continue;
        const int better = confirm(r, &best[k]);
        if (3 * better < 2 * cuts || !(best[k].fall > CONFIRMED * noise)) continue;
        if (best[k].fall > taken->fall) *taken = best[k];
    }
    if (taken->width == 0) return false;
    for (int k = 0; k < taken->width; k++) r->chosen[r->count++] = WCUT_BASE + taken->feature + k;
    r->cost -= taken->gain;
    return true;
}

/* ---- what was found, told ---- */

/* the channel whose misfit a dependence takes away most */
static wcut_evidence_channel strongest(const regression *r, int at, int width, const double *t) {
    static const wcut_evidence_channel channel[WCUT_SIGNALS] = {
        WCUT_EVIDENCE_CHANNEL_TENSION, WCUT_EVIDENCE_CHANNEL_TENSION, WCUT_EVIDENCE_CHANNEL_ALPHA,
        WCUT_EVIDENCE_CHANNEL_BETA,    WCUT_EVIDENCE_CHANNEL_ALPHA,   WCUT_EVIDENCE_CHANNEL_BETA};
    double sum[WCUT_EVIDENCE_CHANNEL_COUNT] = {0};
    int best = WCUT_EVIDENCE_CHANNEL_TENSION;
    for (int cut = 0; cut < r->e->cuts; cut++) {
        const wcut_evidence_cut *c = &r->e->cut[cut];
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++) {
            double change = 0;
            for (int k = 0; k < width; k++)
                change += t[k] * r->column[(size_t)r->chosen[at + k] * (size_t)r->e->rows + (size_t)(c->row + i)];
            sum[channel[i / c->bins]] += change * change;
        }
    }
    for (int k = 0; k < WCUT_EVIDENCE_CHANNEL_COUNT; k++)
        if (sum[k] > sum[best]) best = k;
    return (wcut_evidence_channel)best;
}

static void tell(const regression *r, const step *s, int at, const double *t, const double *covariance, double noise,
                 wcut_dependence *out) {
    const int n = r->count;
    const wcut_feature *f = &r->feature[s->feature];
    double size = t[at] * r->scale[s->feature], error = sqrt(covariance[at * n + at]) * r->scale[s->feature];
    char phase[16] = "";
    *out = (wcut_dependence){.channel = strongest(r, at, s->width, t + at), .gain = s->fall};
    if (s->width > 1) {
        const double cosine = t[at + 1] * r->scale[s->feature + 1], turn = atan2(cosine, size);
        const double u = cos(turn) * r->scale[s->feature], v = sin(turn) * r->scale[s->feature + 1];
        error = sqrt(u * u * covariance[at * n + at] + 2 * u * v * covariance[at * n + at + 1] +
                     v * v * covariance[(at + 1) * n + at + 1]);
        size = hypot(size, cosine);
        if (fabs(turn) >= 0.05) snprintf(phase, sizeof phase, " %c %.1f", turn < 0 ? '-' : '+', fabs(turn));
    }
    const char *mark = strstr(f->name, "%s");
    if (mark)
        snprintf(out->quantity, sizeof out->quantity, "%.*s%s%s", (int)(mark - f->name), f->name, phase, mark + 2);
    else
        snprintf(out->quantity, sizeof out->quantity, "%s", f->name);
    const double reach = wcut_gaussian_quantile(0.975) * sqrt(noise) * error;
    out->coefficient = (wcut_estimate){.value = size, .low = size - reach, .high = size + reach};
}

static wcut_status find(regression *r, int cuts, int *count, wcut_dependence *out, wcut_error *error) {
    double *room = wcut_alloc((size_t)r->e->rows, sizeof *room), t[WCUT_FIT_MAX];
    double covariance[(BASE + 2 * WCUT_DEPENDENCES) * (BASE + 2 * WCUT_DEPENDENCES)];
    step taken[WCUT_DEPENDENCES];
    if (!room) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", r->e->rows);
    r->count = BASE;
    for (int k = 0; k < WCUT_BASE; k++) r->chosen[k] = k;
    for (int k = 0, at = WCUT_BASE; k < r->features && at < BASE; k++)
        if (r->feature[k].latency) r->chosen[at++] = WCUT_BASE + k;
    int steps = 0;
    if (solve(r, NULL, -1, t, NULL, &r->cost))
        while (steps < WCUT_DEPENDENCES && take_step(r, cuts, room, &taken[steps])) steps++;
    const step none = {.width = 0};
    const double noise = dispersion(r, &none, room);
    if (steps > 0 && solve(r, NULL, -1, t, covariance, &r->cost))
        for (int k = 0, at = BASE; k < steps; at += taken[k++].width)
            tell(r, &taken[k], at, t, covariance, noise, &out[k]);
    *count = steps;
    wcut_free(room);
    return WCUT_OK;
}

wcut_status wcut_dependence_find(const wcut_evidence *e, const wcut_fitted *about, int *count, wcut_dependence *out,
                                 wcut_error *error) {
    int cuts = 0;
    for (int k = 0; k < e->cuts; k++) cuts += e->cut[k].bins > 0;
    if (cuts < 2) { /* nothing can be confirmed */
        *count = 0;
        return WCUT_OK;
    }
    regression r = {0};
    double *raw = wcut_alloc((size_t)e->rows, sizeof *raw);
    wcut_status status = WCUT_OK;
    if (!raw || !regression_create(e, cuts, &r))
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);
    if (status == WCUT_OK) {
        wcut_evidence_residual(e, raw);
        status = fill(&r, about, raw, error);
    }
    if (status == WCUT_OK) status = find(&r, cuts, count, out, error);
    regression_destroy(&r);
    wcut_free(raw);
    return status;
}
