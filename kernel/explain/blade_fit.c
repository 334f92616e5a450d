/* A blade's cases fitted by robust least squares, every cut with the same weight, and left out one by one. */
#include "explain/blade_fit.h"

#include <math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/least_squares.h"
#include "base/numbers.h"

#define CUT_POINTS 20.0  /* independent points that a cut counts for: a pass has a few bends */
#define MODEL_ERROR 0.45 /* [scale] what a force is off by where nothing is left out */
#define STEP 1e-3        /* [1, mm] of differences */

double wcut_blade_transform(const wcut_blade_case *c, double force) { return c->scale * asinh(force / c->scale); }

double **wcut_blade_rows_create(const wcut_blade_case *c) {
    double **rows = wcut_alloc((size_t)c->cuts, sizeof *rows);
    bool whole = rows != NULL;
    for (int k = 0; whole && k < c->cuts; k++) {
        rows[k] = wcut_alloc((size_t)c->cut[k].bins, sizeof(double));
        whole = rows[k] != NULL;
    }
    if (whole) return rows;
    wcut_blade_rows_destroy(c, rows);
    return NULL;
}

void wcut_blade_rows_destroy(const wcut_blade_case *c, double **rows) {
    for (int k = 0; rows && k < c->cuts; k++) wcut_free(rows[k]);
    wcut_free(rows);
}

/* ---- residuals ---- */

/* what is fitted: all cuts but one */
typedef struct fitting {
    const wcut_blade_case *c;
    wcut_blade_model model; /* its x is the trial's */
    int left_out;           /* -1: none */
    int rows;
    double *force, *trial; /* room: bins of the longest cut, rows */
    wcut_status status;
} fitting;

static bool takes_part(const fitting *f, int k) { return f->c->cut[k].job && k != f->left_out; }

/* what is believed of every unknown before: centre and width */
static void prior_of(const fitting *f, int j, double *centre, double *width) {
    static const double usual[WCUT_BLADE_BASE][2] = {{0, 0}, {3, 1.5}, {0, 20}, {0, 20}};
    if (j < WCUT_BLADE_BASE)
        *centre = usual[j][0], *width = usual[j][1];
    else
        *centre = f->model.coordinate.centre, *width = f->model.coordinate.spread;
}

static bool eval_rows(fitting *f, const double *x, double *r) {
    const int unknowns = wcut_blade_unknowns(&f->model);
    memcpy(f->model.x, x, sizeof *x * (size_t)unknowns);
    int row = 0;

    /* forces, each cut with the weight of a few independent points */
    for (int k = 0; k < f->c->cuts; k++) {
        const wcut_blade_cut *cut = &f->c->cut[k];
        if (!takes_part(f, k)) continue;
        f->status = wcut_blade_predict(cut, &f->model, f->force);
        if (f->status != WCUT_OK) return false;
        const double weight = sqrt(CUT_POINTS / cut->bins) / (MODEL_ERROR * f->c->scale);
        for (int b = 0; b < cut->bins; b++)
            r[row++] = weight * (wcut_blade_transform(f->c, cut->force[b]) - wcut_blade_transform(f->c, f->force[b]));
    }

    /* what was believed; of a nothing is */
    for (int j = 1; j < unknowns; j++) {
        double centre, width;
        prior_of(f, j, &centre, &width);
        r[row++] = (x[j] - centre) / width;
    }

    return all_finite(f->rows, r);
}

/* an effect stays in its range: outside is no domain */
static bool in_domain(const fitting *f, const double *x) {
    if (!(fabs(x[WCUT_BLADE_LAW]) < 20 && fabs(x[WCUT_BLADE_BUILD_UP]) < 7)) return false;
    return !f->model.named ||
           (x[WCUT_BLADE_BASE] >= f->model.coordinate.low && x[WCUT_BLADE_BASE] <= f->model.coordinate.high);
}

static bool eval_model_rows(void *data, const double *x, double *r, double *jacobian) {
    fitting *f = data;
    const int n = wcut_blade_unknowns(&f->model);
    if (!in_domain(f, x) || !eval_rows(f, x, r)) return false;
    if (!jacobian) return true;

    /* differences to the side that is in the domain */
    double moved[WCUT_BLADE_UNKNOWNS];
    for (int j = 0; j < n; j++) {
        memcpy(moved, x, sizeof *x * (size_t)n);
        const double size = j == WCUT_BLADE_FEED || j == WCUT_BLADE_UP ? 100 * STEP : STEP;
        moved[j] += size;
        const double step = in_domain(f, moved) ? size : -size;
        moved[j] = x[j] + step;
        if (!eval_rows(f, moved, f->trial)) return false;
        for (int i = 0; i < f->rows; i++) jacobian[i * n + j] = (f->trial[i] - r[i]) / step;
    }

    return true;
}

/* ---- fits ---- */

static bool make_fit_room(const wcut_blade_case *c, fitting *f) {
    int longest = 0;
    for (int k = 0; k < c->cuts; k++) {
        if (c->cut[k].bins > longest) longest = c->cut[k].bins;
        f->rows += takes_part(f, k) ? c->cut[k].bins : 0;
    }
    f->rows += wcut_blade_unknowns(&f->model) - 1;
    f->force = wcut_alloc((size_t)longest, sizeof(double));
    f->trial = wcut_alloc((size_t)f->rows, sizeof(double));
    return f->force && f->trial;
}

/* the best model for all cuts but one; cost may be NULL */
static wcut_status fit_but_one(const wcut_blade_case *c, const wcut_blade_model *start, int left_out,
                               wcut_blade_model *out, double *cost) {
    fitting f = {.c = c, .model = *start, .left_out = left_out};
    wcut_blade_model best = *start;

    /* a few rounds of reweighting settle which samples are strange */
    wcut_lsq_options o = wcut_lsq_options_default();
    o.loss = WCUT_LOSS_HUBER, o.scale = 1, o.max_rounds = 12, o.max_iterations = 25, o.tolerance = 1e-5;
    wcut_lsq_report report;
    wcut_status status = make_fit_room(c, &f) ? WCUT_OK : WCUT_NO_MEMORY;
    const wcut_lsq_problem problem = {
        .m = f.rows, .n = wcut_blade_unknowns(start), .model = eval_model_rows, .data = &f};
    if (status == WCUT_OK) status = wcut_lsq_solve(&problem, &o, best.x, NULL, NULL, &report);

    /* a last iterate will do; unknowns that nothing determines stay where they began */
    if (status == WCUT_NOT_CONVERGED) status = WCUT_OK;
    if (status == WCUT_SINGULAR || status == WCUT_BAD_ARGUMENT)
        status = f.status != WCUT_OK ? f.status : WCUT_DEGENERATE;
    if (status == WCUT_OK) {
        *out = best;
        if (cost) *cost = report.cost;
    }
    wcut_free(f.force);
    wcut_free(f.trial);
    return status;
}

static double cut_rmse(const wcut_blade_cut *cut, const double *force) {
    double sum = 0;
    for (int b = 0; b < cut->bins; b++) sum += (cut->force[b] - force[b]) * (cut->force[b] - force[b]);
    return cut->bins > 0 ? sqrt(sum / cut->bins) : 0;
}

wcut_status wcut_blade_fit_run(const wcut_blade_case *c, const wcut_blade_model *start, wcut_blade_fit *out) {
    *out = (wcut_blade_fit){.force = wcut_blade_rows_create(c),
                            .rmse = wcut_alloc((size_t)c->cuts, sizeof(double)),
                            .rmse_out = wcut_alloc((size_t)c->cuts, sizeof(double))};
    if (!out->force || !out->rmse || !out->rmse_out) return WCUT_NO_MEMORY;
    wcut_status status = fit_but_one(c, start, -1, &out->model, &out->cost);
    for (int k = 0; status == WCUT_OK && k < c->cuts; k++) {
        if (!c->cut[k].job) continue;
        status = wcut_blade_predict(&c->cut[k], &out->model, out->force[k]);
        out->rmse[k] = cut_rmse(&c->cut[k], out->force[k]);
    }
    return status;
}

wcut_status wcut_blade_fit_leave_out(const wcut_blade_case *c, wcut_blade_fit *fit) {
    const int n = wcut_blade_unknowns(&fit->model);
    double sum[WCUT_BLADE_UNKNOWNS] = {0}, square[WCUT_BLADE_UNKNOWNS] = {0};
    int used = 0;
    fit->held_out = wcut_blade_rows_create(c);
    if (!fit->held_out) return WCUT_NO_MEMORY;

    /* each cut by what the others say */
    for (int k = 0; k < c->cuts; k++) {
        wcut_blade_model m;
        if (!c->cut[k].job) continue;
        wcut_status status = fit_but_one(c, &fit->model, k, &m, NULL);
        if (status == WCUT_OK) status = wcut_blade_predict(&c->cut[k], &m, fit->held_out[k]);
        if (status != WCUT_OK) return status;
        fit->rmse_out[k] = cut_rmse(&c->cut[k], fit->held_out[k]);
        for (int j = 0; j < n; j++) sum[j] += m.x[j], square[j] += m.x[j] * m.x[j];
        used++;
    }

    /* standard errors by the jackknife (Tukey 1958): cuts are the independent units, their samples are not */
    for (int j = 0; j < n && used > 1; j++)
        fit->error[j] = sqrt(fmax(square[j] - sum[j] * sum[j] / used, 0) * (used - 1) / used);

    return WCUT_OK;
}

void wcut_blade_fit_destroy(const wcut_blade_case *c, wcut_blade_fit *fit) {
    wcut_blade_rows_destroy(c, fit->force);
    wcut_blade_rows_destroy(c, fit->held_out);
    wcut_free(fit->rmse);
    wcut_free(fit->rmse_out);
    *fit = (wcut_blade_fit){0};
}
