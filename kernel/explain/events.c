/* Events: windows of one cut in which the force is another, and which no other cut repeats (a heater that drops out, a
   lump that the wire drags along). They are located and left out, so that they do not bend the recalibration. */
#include "explain/events.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"

/* [robust standard deviations] where a window begins for sure, and how far it reaches to both sides */
#define SURE 8.0
#define REACH 3.0
/* bins: shorter is an outlier of a sensor, not an event; the share of all bins beyond which it is no exception */
enum { SHORTEST = 3 };
#define SHARE_MAX 0.4
/* of the misfit of the tensions, what must lie in the windows */
#define TAKES 0.8
/* [N] of a mean of both tensions, under which nothing is an event */
#define SMALLEST 0.02

enum { ROUNDS = 30 };

/* common part of both tensions in the bins of a case */
typedef struct common {
    int n;
    double *value;                  /* n [N]: measured less predicted */
    double *by[WCUT_BASE];          /* n: its change with the base coordinates */
    double *left, *weight;          /* n */
    int *cut, *bin;                 /* n: whose bin it is */
    double t[WCUT_BASE], deviation; /* the robust fit; [N] standard deviation of what it leaves */
} common;

static void common_destroy(common *c) {
    wcut_free(c->value);
    for (int k = 0; k < WCUT_BASE; k++) wcut_free(c->by[k]);
    wcut_free(c->left);
    wcut_free(c->weight);
    wcut_free(c->cut);
    wcut_free(c->bin);
}

static bool common_create(const wcut_evidence *e, common *c) {
    size_t bins = 0;
    for (int k = 0; k < e->cuts; k++) bins += (size_t)e->cut[k].bins;
    *c = (common){.value = wcut_alloc(bins, sizeof(double))};
    bool whole = c->value != NULL;
    for (int k = 0; k < WCUT_BASE; k++) whole = (c->by[k] = wcut_alloc(bins, sizeof(double))) && whole;
    c->left = wcut_alloc(bins, sizeof(double));
    c->weight = wcut_alloc(bins, sizeof(double));
    c->cut = wcut_alloc(bins, sizeof(int));
    c->bin = wcut_alloc(bins, sizeof(int));
    return whole && c->left && c->weight && c->cut && c->bin;
}

static wcut_status fill_common(const wcut_evidence *e, const wcut_fitted *about, common *c, wcut_error *error) {
    /* the model itself, and one copy for each base coordinate */
    wcut_model model[1 + WCUT_BASE] = {about->model, about->model, about->model, about->model};
    const size_t rows = (size_t)e->rows;
    double *all = wcut_alloc((1 + WCUT_BASE) * rows, sizeof *all);
    if (!all) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);

    /* base coordinates by finite steps: ln a, ln b and length */
    model[1].a *= exp(wcut_base_step[0]), model[2].b *= exp(wcut_base_step[1]);
    model[3].length_change += wcut_base_step[2];

    /* rows of all four along the exogenous trajectory */
    const wcut_status status = wcut_models_rows(e, 1 + WCUT_BASE, model, all, error);
    for (int k = 0; status == WCUT_OK && k < e->cuts; k++) {
        const wcut_evidence_cut *cut = &e->cut[k];

        /* the mean of both tensions in each bin, and how it answers to the base coordinates */
        for (int i = 0; i < cut->bins; i++) {
            const int a = cut->row + i, b = a + cut->bins;
            const double value =
                (cut->measured[0][i] - about->predicted[a] + cut->measured[1][i] - about->predicted[b]) / 2;
            if (!isfinite(value)) continue;
            c->value[c->n] = value, c->cut[c->n] = k, c->bin[c->n] = i;
            for (int j = 0; j < WCUT_BASE; j++) {
                const double *at = all + (size_t)(1 + j) * rows;
                c->by[j][c->n] = (at[a] - all[a] + at[b] - all[b]) / 2 / wcut_base_step[j];
            }
            c->n++;
        }
    }

    wcut_free(all);
    return status;
}

/* ---- the robust fit ---- */

static int ascending(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* standard deviation of normal noise with the median of abs(left) */
static double robust_deviation(const common *c, double *room) {
    for (int i = 0; i < c->n; i++) room[i] = fabs(c->left[i]);
    qsort(room, (size_t)c->n, sizeof *room, ascending);
    return 1.4826 * room[c->n / 2];
}

/* weighted least squares of the base coordinates, their priors beside it; three unknowns by Cramer's rule */
static void solve_common(common *c, double sigma) {
    double m[WCUT_BASE][WCUT_BASE + 1] = {{0}};
    for (int j = 0; j < WCUT_BASE; j++) {
        /* normal equations; the prior stands on the diagonal, in units of sigma */
        m[j][j] = sigma * sigma / (wcut_base_spread[j] * wcut_base_spread[j]);
        for (int i = 0; i < c->n; i++) {
            for (int k = 0; k < WCUT_BASE; k++) m[j][k] += c->weight[i] * c->by[j][i] * c->by[k][i];
            m[j][WCUT_BASE] += c->weight[i] * c->by[j][i] * c->value[i];
        }
    }
    for (int j = 0; j < WCUT_BASE; j++) /* elimination: positive definite, no pivoting */
        for (int k = j + 1; k < WCUT_BASE; k++) {
            const double factor = m[k][j] / m[j][j];
            for (int l = j; l <= WCUT_BASE; l++) m[k][l] -= factor * m[j][l];
        }

    /* back substitution */
    for (int j = WCUT_BASE - 1; j >= 0; j--) {
        c->t[j] = m[j][WCUT_BASE];
        for (int k = j + 1; k < WCUT_BASE; k++) c->t[j] -= m[j][k] * c->t[k];
        c->t[j] /= m[j][j];
    }

    /* what the solution leaves */
    for (int i = 0; i < c->n; i++) {
        c->left[i] = c->value[i];
        for (int j = 0; j < WCUT_BASE; j++) c->left[i] -= c->t[j] * c->by[j][i];
    }
}

/* least absolute deviations first, which half of the bins may spoil; then Tukey's biweight from there */
static bool fit_common(common *c, double floor) {
    double *room = wcut_alloc((size_t)c->n, sizeof *room);
    if (!room) return false;
    for (int i = 0; i < c->n; i++) c->weight[i] = 1;
    for (int round = 0; round < ROUNDS; round++) {
        solve_common(c, floor);
        c->deviation = fmax(robust_deviation(c, room), floor);
        for (int i = 0; i < c->n; i++) {
            const double z = fabs(c->left[i]) / c->deviation, far = z / 4.7;
            c->weight[i] = round < ROUNDS / 2 ? 1 / fmax(z, 0.1) : far < 1 ? (1 - far * far) * (1 - far * far) : 0;
        }
    }
    solve_common(c, floor);
    c->deviation = fmax(robust_deviation(c, room), floor);
    wcut_free(room);
    return true;
}

/* ---- windows ---- */

/* the window around bin i: as far as bins of the same cut stay beyond REACH on the same side */
static void reach(const common *c, int i, int *from, int *to) {
    const double side = c->left[i] < 0 ? -1 : 1, min = REACH * c->deviation;
    *from = *to = i;
    while (*from > 0 && c->cut[*from - 1] == c->cut[i] && side * c->left[*from - 1] > min) --*from;
    while (*to + 1 < c->n && c->cut[*to + 1] == c->cut[i] && side * c->left[*to + 1] > min) ++*to;
}

static void describe_event(const wcut_evidence *e, const wcut_fitted *about, const common *c, int from, int to,
                           wcut_event *out) {
    const wcut_evidence_cut *cut = &e->cut[c->cut[from]];
    double force = 0, heat = 0, tension = 0;
    for (int i = from; i <= to; i++) {
        const double change = c->left[i] / fmax(c->by[0][i], 1e-6); /* of ln F */
        const double q_eff = 1000 * cut->heat[c->bin[i]] / fmax(cut->pace[c->bin[i]], 0.1);
        force += change / (to - from + 1), tension += c->left[i] / (to - from + 1);
        heat -= change / (about->model.b * q_eff) / (to - from + 1);
    }
    *out = (wcut_event){
        .cut = cut->index,
        .time = {cut->middle[c->bin[from]] - WCUT_BIN_WIDTH / 2, cut->middle[c->bin[to]] + WCUT_BIN_WIDTH / 2},
        .station = {cut->station[c->bin[from]], cut->station[c->bin[to]]},
        .tension = tension,
        .force = exp(force) - 1,
        .heat = heat};
}

/* sums of squares in a window: as it is, and less a level that the bins between say */
static void judge_window(const common *c, int from, int to, double *whole, double *left) {
    double mean[2] = {0};
    int count[2] = {0};
    for (int i = from; i <= to; i++) mean[i % 2] += c->left[i], count[i % 2]++;
    for (int i = from; i <= to; i++) {
        const int other = 1 - i % 2;
        const double level = count[other] > 0 ? mean[other] / count[other] : 0;
        *whole += c->left[i] * c->left[i], *left += pow(c->left[i] - level, 2);
    }
}

static void find_windows(const wcut_evidence *e, const wcut_fitted *about, const common *c, wcut_events *out) {
    const double sure = fmax(SURE * c->deviation, SMALLEST);
    double all = 0, inside = 0, levelled = 0, rest = 0;
    int bins = 0;
    for (int i = 0; i < c->n; i++) all += c->left[i] * c->left[i], rest += c->value[i] * c->value[i];
    for (int i = 0; i < c->n; i++) {
        int from, to;
        if (!(fabs(c->left[i]) > sure)) continue;
        reach(c, i, &from, &to);
        i = to;
        if (to - from + 1 < SHORTEST || out->count == WCUT_EVENTS_MAX) continue;
        describe_event(e, about, c, from, to, &out->event[out->count++]);
        judge_window(c, from, to, &inside, &levelled);
        bins += to - from + 1;
    }
    if (bins > SHARE_MAX * c->n || inside < TAKES * all) out->count = 0;
    out->recalibrated = sqrt(rest / c->n);
    out->after = sqrt((all - inside + levelled) / c->n);
}

wcut_status wcut_events_find(const wcut_evidence *e, const wcut_fitted *recalibrated, wcut_events *out,
                             wcut_error *error) {
    common c;
    wcut_events found = {.count = 0};
    wcut_status status = common_create(e, &c) ? fill_common(e, recalibrated, &c, error) : WCUT_NO_MEMORY;
    if (status == WCUT_OK && c.n > 0) {
        if (fit_common(&c, hypot(e->sigma[0], e->sigma[1]) / 2))
            find_windows(e, recalibrated, &c, &found);
        else
            status = WCUT_NO_MEMORY;
    }
    common_destroy(&c);
    if (status == WCUT_NO_MEMORY) wcut_fail(error, status, "no memory for events");
    if (status == WCUT_OK) *out = found;
    return status;
}

double *wcut_events_mask(const wcut_events *events, wcut_evidence *e) {
    double *kept = wcut_alloc((size_t)e->rows, sizeof *kept);
    if (!kept) return NULL;
    for (int k = 0; k < e->cuts; k++)
        for (int s = 0; s < WCUT_SIGNALS && e->cut[k].bins > 0; s++)
            memcpy(kept + e->cut[k].row + (ptrdiff_t)s * e->cut[k].bins, e->cut[k].measured[s],
                   (size_t)e->cut[k].bins * sizeof *kept);
    for (int k = 0; k < events->count; k++) {
        const wcut_event *w = &events->event[k];
        wcut_evidence_cut *c = &e->cut[w->cut];
        for (int i = 0; i < c->bins; i++) {
            /* a bin more to both sides: edges are not sharp, sensors lag */
            if (c->middle[i] < w->time[0] - WCUT_BIN_WIDTH || c->middle[i] > w->time[1] + WCUT_BIN_WIDTH) continue;
            for (int s = 0; s < WCUT_SIGNALS; s++) c->measured[s][i] = (double)NAN;
        }
    }
    return kept;
}

void wcut_events_restore(const double *kept, wcut_evidence *e) {
    for (int k = 0; k < e->cuts; k++)
        for (int s = 0; s < WCUT_SIGNALS && e->cut[k].bins > 0; s++)
            memcpy(e->cut[k].measured[s], kept + e->cut[k].row + (ptrdiff_t)s * e->cut[k].bins,
                   (size_t)e->cut[k].bins * sizeof *kept);
}
