/* A mere fit beside the physics: what a regression that knows nothing of foam makes of the same cuts. */
#include "explain/black_box.h"

#include <string.h>

#include "base/alloc.h"
#include "base/dense.h"
#include "base/numbers.h"

/* inputs, each at this bin and the eight before; and a constant */
enum { INPUTS = 6, LAGS = 9, COLUMNS = INPUTS * LAGS + 1, RIDGES = 5 };

/* ridge per training row, of standardised columns */
static const double ridge[RIDGES] = {1e-4, 1e-3, 1e-2, 1e-1, 1};

static double input_of(const wcut_evidence_cut *c, int which, int bin) {
    const int i = bin > 0 ? bin : 0, before = i > 0 ? i - 1 : 0;
    const int station = (int)clamp(round(c->station[i]), 0, c->job->stations - 1);
    switch (which) {
        case 0:
            return log(fmax(c->pace[i], 0.1));
        case 1:
            return c->heat[i];
        case 2:
            return (c->pace[i] - c->pace[before]) / WCUT_BIN_WIDTH;
        case 3:
            return c->station[i] / (c->job->stations - 1);
        case 4:
            return (c->job->mount_a[station].y + c->job->mount_b[station].y) / 2;
        default:
            return c->engaged[i];
    }
}

/* Inputs of all bins of a case, standardised; sums of the normal equations by cut. */
typedef struct regression {
    const wcut_evidence *e;
    double *x;                   /* bins x COLUMNS, cut by cut */
    int *bin;                    /* cuts: where a cut's rows of x begin */
    double *gram, *moment, *sum; /* cuts times COLUMNS x COLUMNS, COLUMNS, 1: of one signal */
    int *rows;                   /* cuts: bins with a residual */
} regression;

static void regression_destroy(regression *r) {
    wcut_free(r->x);
    wcut_free(r->bin);
    wcut_free(r->gram);
    wcut_free(r->moment);
    wcut_free(r->sum);
    wcut_free(r->rows);
}

static bool regression_create(const wcut_evidence *e, regression *r) {
    const size_t cuts = (size_t)e->cuts, n = COLUMNS;
    int bins = 0;
    *r = (regression){.e = e, .bin = wcut_alloc(cuts, sizeof(int)), .rows = wcut_alloc(cuts, sizeof(int))};

    /* where the bins of each cut begin in x, and how many there are in all */
    for (int k = 0; r->bin && k < e->cuts; k++) r->bin[k] = bins, bins += e->cut[k].bins;

    /* the inputs, and the sums of each cut that any choice of training cuts is made of */
    r->x = wcut_alloc((size_t)bins * n, sizeof(double));
    r->gram = wcut_alloc(cuts * n * n, sizeof(double));
    r->moment = wcut_alloc(cuts * n, sizeof(double));
    r->sum = wcut_alloc(cuts, sizeof(double));
    if (!r->bin || !r->rows || !r->x || !r->gram || !r->moment || !r->sum) return false;

    /* a row holds every input at this bin and at the LAGS - 1 bins before it, and a constant */
    for (int k = 0; k < e->cuts; k++)
        for (int i = 0; i < e->cut[k].bins; i++)
            for (size_t j = 0; j < n; j++)
                r->x[(size_t)(r->bin[k] + i) * n + j] =
                    j + 1 == n ? 1 : input_of(&e->cut[k], (int)j / LAGS, i - (int)j % LAGS);
    for (size_t j = 0; j + 1 < n; j++) { /* inputs, which are known beforehand, may be scaled over all cuts */
        double mean = 0, square = 0;
        for (int i = 0; i < bins; i++) mean += r->x[(size_t)i * n + j] / bins;
        for (int i = 0; i < bins; i++) square += pow(r->x[(size_t)i * n + j] - mean, 2) / bins;
        const double scale = square > 0 ? 1 / sqrt(square) : 0;
        for (int i = 0; i < bins; i++) r->x[(size_t)i * n + j] = scale * (r->x[(size_t)i * n + j] - mean);
    }

    return true;
}

/* sums of one signal; y: rows of the evidence, measured less predicted */
static void add_up(regression *r, int signal, const double *y) {
    const size_t n = COLUMNS;

    /* start from zero: the same memory serves every signal in turn */
    memset(r->gram, 0, (size_t)r->e->cuts * n * n * sizeof(double));
    memset(r->moment, 0, (size_t)r->e->cuts * n * sizeof(double));
    for (int k = 0; k < r->e->cuts; k++) {
        const wcut_evidence_cut *c = &r->e->cut[k];
        double *gram = r->gram + (size_t)k * n * n, *moment = r->moment + (size_t)k * n;
        r->rows[k] = 0, r->sum[k] = 0;

        /* normal equations of this cut: x x' in the lower triangle, x y, y y */
        for (int i = 0; i < c->bins; i++) {
            const double value = y[c->row + signal * c->bins + i];
            if (!isfinite(value)) continue;
            const double *x = r->x + (size_t)(r->bin[k] + i) * n;
            for (size_t a = 0; a < n; a++) {
                moment[a] += x[a] * value;
                for (size_t b = 0; b <= a; b++) gram[a * n + b] += x[a] * x[b];
            }
            r->rows[k]++, r->sum[k] += value * value;
        }
    }
}

/* what is learnt from all cuts but two (-1: none); false where there is nothing to learn from */
static bool learn(const regression *r, int but, int nor, double ridge_of_row, double *w) {
    enum { N = COLUMNS };
    double m[N * N] = {0};
    int rows = 0;
    memset(w, 0, N * sizeof *w);

    /* sum the normal equations of the training cuts */
    for (int k = 0; k < r->e->cuts; k++) {
        if (k == but || k == nor) continue;
        rows += r->rows[k];
        for (int i = 0; i < N; i++) {
            w[i] += r->moment[(size_t)k * N + (size_t)i];
            for (int j = 0; j <= i; j++) m[i * N + j] += r->gram[(size_t)k * N * N + (size_t)(i * N + j)];
        }
    }
    if (rows == 0) return false;

    /* the ridge makes it positive definite, the constant bears none */
    for (int j = 0; j + 1 < N; j++) m[j * N + j] += ridge_of_row * rows;
    if (!wcut_cholesky_factor(N, m, 0)) return false;

    /* weights of the ridge regression */
    wcut_cholesky_solve(N, m, w);

    return true;
}

/* |y - X w|^2 of a cut */
static double misfit(const regression *r, int cut, const double *w) {
    const size_t n = COLUMNS;
    const double *gram = r->gram + (size_t)cut * n * n, *moment = r->moment + (size_t)cut * n;
    double sum = r->sum[cut];
    for (size_t i = 0; i < n; i++) {
        sum += w[i] * (w[i] * gram[i * n + i] - 2 * moment[i]);
        for (size_t j = 0; j < i; j++) sum += 2 * w[i] * w[j] * gram[i * n + j];
    }
    return sum;
}

/* the ridge by which the cuts but one predict each other best */
static double choose_ridge(const regression *r, int but) {
    double best = ridge[RIDGES - 1], min = HUGE_VAL, w[COLUMNS];
    for (int l = 0; l < RIDGES; l++) {
        double sum = 0;
        int judged = 0;
        for (int k = 0; k < r->e->cuts; k++) {
            if (k == but || r->rows[k] == 0 || !learn(r, but, k, ridge[l], w)) continue;
            sum += misfit(r, k, w), judged++;
        }
        if (judged > 0 && sum < min) min = sum, best = ridge[l];
    }
    return best;
}

/* add what is learnt to a cut's prediction */
static void predict(const regression *r, int cut, int signal, const double *w, double *row) {
    const wcut_evidence_cut *c = &r->e->cut[cut];
    for (int i = 0; i < c->bins; i++) {
        const double *x = r->x + (size_t)(r->bin[cut] + i) * COLUMNS;
        double sum = 0;
        for (int j = 0; j < COLUMNS; j++) sum += w[j] * x[j];
        row[c->row + signal * c->bins + i] += sum;
    }
}

/* a forecast that starts as the recalibrated replay, without speed and faces */
static bool start_forecast(const wcut_evidence *e, const wcut_forecast *from, wcut_forecast *out) {
    size_t speeds = 0;
    for (int k = 0; k < e->cuts; k++) speeds += 2 * (size_t)e->cut[k].bins;
    out->row = wcut_copy(from->row, (size_t)e->rows, sizeof(double));
    out->speed = wcut_alloc(speeds, sizeof(double));
    for (size_t i = 0; out->speed && i < speeds; i++) out->speed[i] = (double)NAN;
    for (int k = 0; out->row && k < e->cuts; k++)
        for (int i = 0; i < e->cut[k].patch.count; i++)
            out->row[e->cut[k].row + WCUT_SIGNALS * e->cut[k].bins + i] = (double)NAN;
    return out->row && out->speed;
}

wcut_status wcut_black_box_run(const wcut_evidence *e, unsigned long long seed, wcut_cross_validation *p) {
    const double *measured = p->measured.row, *replayed = p->in_sample[WCUT_EVIDENCE_MODEL_RECALIBRATED].row;
    regression r = {0};
    wcut_forecast all = {0}, held_out = {0};
    wcut_evidence_score fit[WCUT_EVIDENCE_CHANNEL_COUNT], held_out_score[WCUT_EVIDENCE_CHANNEL_COUNT] = {{0}};
    double *y = wcut_alloc((size_t)e->rows, sizeof *y), w[COLUMNS];
    const bool made = regression_create(e, &r);
    int cuts = 0;
    wcut_status status = WCUT_NO_MEMORY;
    if (made && y && start_forecast(e, &p->in_sample[WCUT_EVIDENCE_MODEL_RECALIBRATED], &all) &&
        start_forecast(e, &p->held_out[WCUT_EVIDENCE_MODEL_RECALIBRATED], &held_out)) {
        /* the target: what the recalibrated simulation leaves along the recorded motion */
        for (int i = 0; i < e->rows; i++) y[i] = measured[i] - replayed[i];
        for (int signal = 0; signal < WCUT_SIGNALS; signal++) {
            /* in sample: one set of weights learnt from all cuts */
            add_up(&r, signal, y);
            const bool learnt = learn(&r, -1, -1, choose_ridge(&r, -1), w);

            /* held out: the weights for a cut are learnt from the others */
            for (int k = 0; learnt && k < e->cuts; k++) predict(&r, k, signal, w, all.row);
            for (int k = 0; k < e->cuts; k++)
                if (learn(&r, k, -1, choose_ridge(&r, k), w)) predict(&r, k, signal, w, held_out.row);
        }

        /* a single cut can hold nothing out, so that only the fit in sample is scored */
        for (int k = 0; k < e->cuts; k++) cuts += e->cut[k].bins > 0;
        status = wcut_forecast_score(e, &p->measured, &all, seed, fit);
        if (status == WCUT_OK && cuts > 1)
            status = wcut_forecast_score(e, &p->measured, &held_out, seed, held_out_score);
    }

    /* write only when everything has succeeded */
    if (status == WCUT_OK) {
        memcpy(p->score[WCUT_EVIDENCE_MODEL_BLACK_BOX], fit, sizeof fit);
        memcpy(p->held_out_score[WCUT_EVIDENCE_MODEL_BLACK_BOX], held_out_score, sizeof held_out_score);
    }

    wcut_free(all.row);
    wcut_free(all.speed);
    wcut_free(held_out.row);
    wcut_free(held_out.speed);
    wcut_free(y);
    regression_destroy(&r);
    return status;
}
