/* A hypothesis fitted: recalibration and effects together, by the moments of what cannot be fed back. */
#include "explain/model_fit.h"

#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "explain/variance.h"

enum { NODES_FINE = WCUT_NODES_FINE, ROUNDS = 7, JACOBIANS = 1, ANCHORS = 4, ENDS = 3, BOUNDED = 3 };

/* priors of what a job may have mis-set: ln a, ln b, which no table holds better than a factor of 1.6; and the wire's
   length [mm], which a job states to a tenth: the rounding alone */
const double wcut_base_spread[WCUT_BASE] = {0.5, 0.5, 0.03};
const double wcut_base_step[WCUT_BASE] = {0.02, 0.02, 0.5};

/* of a normal distribution, and of chi-square (1) */
#define NORMAL_95 1.96
#define RISE_95 (NORMAL_95 * NORMAL_95)

/* [1] rows that a model may leave without a prediction: more, and what it does not reach would count as explained */
#define LOST_MAX 0.01
/* [standard errors] a step beyond which the columns are taken anew */
#define FAR 4
/* [1] precision of a coordinate that is held at its bound, over what the rows know of it */
#define HELD 1e6

typedef struct fitting {
    const wcut_evidence *e;
    wcut_fitted *f;
    int shared, nuisances, n; /* base and effects; of scans; both */
    double *rows;             /* (1 + shared) x rows: of the model and of each perturbed one */
    double *at_rows;          /* rows of the model that the anchor is of, along the exogenous trajectory */
    double *measured;         /* rows: measured less predicted under the evidence's model: what is missing there */
    double *anchor; /* rows: measured less predicted along the recorded motion, of a model near the present one */
    double *plain_column, *plain_residual; /* n x rows, rows: as measured */
    double *column;                        /* n x rows, whitened */
    double *residual;                      /* rows, whitened */
    double centre[WCUT_FITTED_MAX], precision[WCUT_FITTED_MAX];
    bool held[WCUT_FITTED_MAX]; /* at a bound, by a prior there */
    double shortest;            /* [mm] change of length at which every wire still spans its mounts */
    wcut_normal_equations normal;
} fitting;

static double value_at(const wcut_fitted *f, int k) {
    const wcut_coordinate *c = &f->coordinate[k];
    return wcut_scale_in(c->scale, f->model.effect[f->effect_of[k]].value[c->at]);
}

wcut_model wcut_fitted_model(const wcut_fitted *f, const double *x) {
    wcut_model m = f->model;
    m.a = exp(x[0]), m.b = exp(x[1]), m.length_change = x[2];
    for (int k = 0; k < f->count; k++)
        m.effect[f->effect_of[k]].value[f->coordinate[k].at] = wcut_scale_out(f->coordinate[k].scale, x[WCUT_BASE + k]);
    return m;
}

static bool list_coordinates(const wcut_model *start, wcut_fitted *f) {
    f->model = *start;
    for (int e = 0; e < start->effects; e++) {
        const int count = wcut_effect_coordinates(&start->effect[e]);
        for (int k = 0; k < count; k++) {
            if (f->count == WCUT_FITTED_MAX - WCUT_BASE) return false;
            f->effect_of[f->count] = e;
            f->coordinate[f->count++] = wcut_effect_coordinate(&start->effect[e], k);
        }
    }
    f->x[0] = log(start->a), f->x[1] = log(start->b), f->x[2] = start->length_change;
    for (int k = 0; k < f->count; k++) f->x[WCUT_BASE + k] = value_at(f, k);
    return true;
}

static wcut_status fitting_create(const wcut_evidence *e, const wcut_model *start, wcut_fitted *f, fitting *g) {
    const size_t rows = (size_t)e->rows;

    /* the unknowns: base coordinates and effects, then nuisances */
    if (!list_coordinates(start, f)) return WCUT_BAD_ARGUMENT;
    g->e = e, g->f = f;
    g->shared = WCUT_BASE + f->count;
    g->nuisances = wcut_nuisance_count(e);
    g->n = g->shared + g->nuisances;
    if (g->n > WCUT_FITTED_MAX) return WCUT_BAD_ARGUMENT;

    /* rows and columns of the linear problem, and what the fit hands out */
    g->rows = wcut_alloc((size_t)(1 + g->shared) * rows, sizeof(double));
    g->at_rows = wcut_alloc(rows, sizeof(double));
    g->measured = wcut_alloc(rows, sizeof(double));
    g->anchor = wcut_alloc(rows, sizeof(double));
    g->column = wcut_alloc((size_t)g->n * rows, sizeof(double));
    g->plain_column = wcut_alloc((size_t)g->n * rows, sizeof(double));
    g->plain_residual = wcut_alloc(rows, sizeof(double));
    g->residual = wcut_alloc(rows, sizeof(double));
    f->cut_cost = wcut_alloc((size_t)e->cuts, sizeof(double));
    f->held_out = wcut_alloc((size_t)e->cuts, sizeof(double));
    f->without = wcut_alloc((size_t)e->cuts * (size_t)g->shared, sizeof(double));
    f->residual = wcut_alloc(rows, sizeof(double));
    f->standard = wcut_alloc(rows, sizeof(double));
    f->open = wcut_alloc(rows, sizeof(double));
    f->scatter = wcut_alloc((size_t)e->cuts * (size_t)e->scatter.count, sizeof(double));
    f->scatter_error = wcut_alloc((size_t)e->cuts * (size_t)e->scatter.count, sizeof(double));
    f->predicted = wcut_alloc(rows, sizeof(double));
    f->column = wcut_alloc((size_t)f->count * rows, sizeof(double));
    if (!g->rows || !g->at_rows || !g->measured || !g->anchor || !g->column || !g->residual || !f->cut_cost ||
        !f->held_out || !f->without || !f->residual || !f->standard || !f->open || !f->scatter || !f->scatter_error ||
        !f->predicted || !f->column || !g->plain_column || !g->plain_residual)
        return WCUT_NO_MEMORY;

    /* priors of the base coordinates and of the effects; how short a wire may be */
    g->shortest = wcut_model_shortest(e);
    for (int k = 0; k < WCUT_BASE; k++) g->precision[k] = 1 / (wcut_base_spread[k] * wcut_base_spread[k]);
    for (int k = 0; k < f->count; k++)
        g->precision[WCUT_BASE + k] = 1 / (f->coordinate[k].spread * f->coordinate[k].spread);

    /* columns of the nuisances: delays of readings, and a kerf where there are scans */
    double spread[WCUT_FITTED_MAX] = {0};
    double *own = g->plain_column + (size_t)g->shared * rows, *white = g->column + (size_t)g->shared * rows;
    wcut_nuisance_columns(e, own, spread);
    wcut_evidence_residual(e, g->measured);
    memcpy(g->anchor, g->measured, rows * sizeof(double));
    for (int k = 0; k < start->effects; k++) /* a delay that is fitted leaves none to the nuisances */
        if (wcut_explanation_view(start->effect[k].kind)->delay) spread[0] = spread[1] = WCUT_DELAY_REST;

    /* their priors; a kerf has its mean at one millimetre */
    for (int k = 0; k < g->nuisances; k++) {
        g->precision[g->shared + k] = 1 / (spread[k] * spread[k]);
        g->centre[g->shared + k] = k == WCUT_DELAYS ? WCUT_KERF : 0;
        wcut_evidence_whiten(e, g->measured, own + (size_t)k * rows, white + (size_t)k * rows);
    }

    return wcut_normal_equations_create(g->n, e->scatter.count, e->cuts, &g->normal);
}

static void fitting_destroy(fitting *g) {
    wcut_free(g->rows);
    wcut_free(g->at_rows);
    wcut_free(g->measured);
    wcut_free(g->anchor);
    wcut_free(g->column);
    wcut_free(g->plain_column);
    wcut_free(g->plain_residual);
    wcut_free(g->residual);
    wcut_normal_equations_destroy(&g->normal);
}

static double finite_step(const wcut_fitted *f, int k) {
    const int own = k - WCUT_BASE;
    if (own < 0) return wcut_base_step[k];
    const wcut_coordinate *c = &f->coordinate[own];
    return f->x[WCUT_BASE + own] + c->step > c->high ? -c->step : c->step;
}

/* columns of base and effects about the present x, and the rows there */
static wcut_status take_jacobian(fitting *g, wcut_error *error) {
    wcut_model model[1 + WCUT_FITTED_MAX];
    wcut_fitted *f = g->f;
    const size_t rows = (size_t)g->e->rows;

    /* the model itself, and one with each coordinate moved by its step */
    model[0] = wcut_fitted_model(f, f->x);
    for (int k = 0; k < g->shared; k++) {
        double x[WCUT_FITTED_MAX];
        memcpy(x, f->x, sizeof x);
        x[k] += finite_step(f, k);
        model[1 + k] = wcut_fitted_model(f, x);
    }

    /* all of them along the exogenous trajectory, every motion driven once */
    const wcut_status status = wcut_models_rows(g->e, 1 + g->shared, model, g->rows, error);
    if (status != WCUT_OK) return status;

    /* differences divided by the step, as measured and whitened */
    for (int k = 0; k < g->shared; k++) {
        double *column = g->plain_column + (size_t)k * rows;
        for (size_t i = 0; i < rows; i++)
            column[i] = (g->rows[(size_t)(1 + k) * rows + i] - g->rows[i]) / finite_step(f, k);
        wcut_evidence_whiten(g->e, g->measured, column, g->column + (size_t)k * rows);
    }

    return WCUT_OK;
}

/* priors of the base hold about the evidence's own model, those of effects about their centres */
static void set_centres(fitting *g) {
    const wcut_fitted *f = g->f;
    const wcut_model *at = &g->e->at;
    const double base[WCUT_BASE] = {log(at->a), log(at->b), 0};
    for (int k = 0; k < WCUT_BASE; k++) g->centre[k] = base[k] - f->x[k];
    for (int k = 0; k < f->count; k++) g->centre[WCUT_BASE + k] = f->coordinate[k].centre - f->x[WCUT_BASE + k];
}

static void all_columns(int n, int *chosen) {
    for (int k = 0; k < n; k++) chosen[k] = k;
}

/* Hold the coordinates that a step takes beyond a bound at that bound, by a prior there. Gives how many more are held:
   a likelihood beyond what is plausible is none. */
static int hold_at_bounds(fitting *g, const double *t) {
    int more = 0;
    for (int k = WCUT_BASE; k < g->shared; k++) {
        const wcut_coordinate *c = &g->f->coordinate[k - WCUT_BASE];
        const double to = g->f->x[k] + t[k], known = g->normal.gram[(size_t)k * (size_t)g->n + (size_t)k];
        if (g->held[k] || (to >= c->low && to <= c->high)) continue;
        g->centre[k] = (to < c->low ? c->low : c->high) - g->f->x[k];
        g->precision[k] = HELD * (known + g->precision[k]);
        g->held[k] = true, more++;
    }
    return more;
}

/* priors as they are: no coordinate is held */
static void release_bounds(fitting *g) {
    for (int k = 0; k < g->f->count; k++)
        g->precision[WCUT_BASE + k] = 1 / (g->f->coordinate[k].spread * g->f->coordinate[k].spread);
    memset(g->held, 0, sizeof g->held);
    set_centres(g);
}

/* The step to the least cost within the bounds, by the sums that are filled; the priors are left as the solution has them.
   covariance: as if there were no bounds; may be NULL. False where the columns are dependent. */
static bool solve_within_bounds(fitting *g, double *t, double *covariance, double *cost) {
    int chosen[WCUT_FITTED_MAX];
    all_columns(g->n, chosen);
    release_bounds(g);
    bool solved =
        wcut_normal_equations_solve(&g->normal, g->n, chosen, g->centre, g->precision, -1, t, covariance, cost);

    /* each round holds one more at least */
    while (solved && hold_at_bounds(g, t) > 0)
        solved = wcut_normal_equations_solve(&g->normal, g->n, chosen, g->centre, g->precision, -1, t, NULL, cost);
    return solved;
}

/* the step with what is held already, whatever it takes beyond a bound */
static bool solve_held(fitting *g, double *t, double *cost) {
    int chosen[WCUT_FITTED_MAX];
    all_columns(g->n, chosen);
    return wcut_normal_equations_solve(&g->normal, g->n, chosen, g->centre, g->precision, -1, t, NULL, cost);
}

/* solve for the step; whitened residual in g->residual. False where the columns are dependent. */
static bool find_step(fitting *g, double *t, double *covariance, double *cost) {
    wcut_normal_equations_fill(g->e, g->column, g->residual, &g->normal);
    return solve_within_bounds(g, t, covariance, cost);
}

/* residual at the present x, by the difference along the exogenous trajectory */
static void exogenous_residual(fitting *g) {
    for (int i = 0; i < g->e->rows; i++) g->plain_residual[i] = g->anchor[i] - (g->rows[i] - g->at_rows[i]);
    wcut_evidence_whiten(g->e, g->measured, g->plain_residual, g->residual);
}

/* what the present x costs once the nuisances are taken out */
static bool present_cost(fitting *g, double *cost) {
    int chosen[WCUT_FITTED_MAX];
    double t[WCUT_FITTED_MAX];
    for (int k = 0; k < g->nuisances; k++) chosen[k] = g->shared + k;
    release_bounds(g);
    wcut_normal_equations_fill(g->e, g->column, g->residual, &g->normal);
    if (!wcut_normal_equations_solve(&g->normal, g->nuisances, chosen, g->centre, g->precision, -1, t, NULL, cost))
        return false;
    for (int k = 0; k < g->shared; k++) *cost += g->precision[k] * g->centre[k] * g->centre[k];
    return true;
}

/* move by a share of a step, inside the bounds; gives the longest move in standard errors */
static double move(const fitting *g, const double *from, const double *step, const double *covariance, double share) {
    wcut_fitted *f = g->f;
    double longest = 0;
    f->at_bound = false;
    for (int k = 0; k < g->shared; k++) {
        double to = from[k] + share * step[k];
        if (k == WCUT_BASE - 1) to = fmax(to, g->shortest); /* the length */
        if (k >= WCUT_BASE) {
            const wcut_coordinate *c = &f->coordinate[k - WCUT_BASE];
            if (to <= c->low || to >= c->high) f->at_bound = true;
            to = clamp(to, c->low, c->high);
        }
        f->x[k] = to;
        longest = fmax(longest, fabs(to - from[k]) / sqrt(fmax(covariance[k * g->n + k], 1e-300)));
    }
    return longest;
}

static wcut_status present_rows(fitting *g, wcut_error *error) {
    const wcut_model model = wcut_fitted_model(g->f, g->f->x);
    const wcut_status status = wcut_models_rows(g->e, 1, &model, g->rows, error);
    if (status == WCUT_OK) exogenous_residual(g);
    return status;
}

/* Gauss-Newton along the exogenous trajectory: columns anew while the steps are long, then the last ones again */
static wcut_status iterate(fitting *g, double *covariance, wcut_error *error) {
    double t[WCUT_FITTED_MAX], from[WCUT_FITTED_MAX], cost = 0, before = HUGE_VAL, longest = 0;
    wcut_status status = WCUT_OK;
    for (int round = 0; status == WCUT_OK && round < ROUNDS; round++) {
        /* columns are taken again at first, and whenever the last step was long */
        if (round < JACOBIANS || longest > FAR) status = take_jacobian(g, error);
        if (status != WCUT_OK) break;

        /* residual at x, and its cost at the start */
        exogenous_residual(g);
        if (round == 0 && !present_cost(g, &before)) return WCUT_NOT_CONVERGED;

        /* the Gauss-Newton step, shortened by halves until the cost does not rise */
        if (!find_step(g, t, covariance, &cost)) return WCUT_NOT_CONVERGED;
        memcpy(from, g->f->x, sizeof from);
        double share = 1;
        for (int half = 0; half < 6; half++, share /= 2) {
            longest = move(g, from, t, covariance, share);
            status = present_rows(g, error);
            if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
            /* too far is where the misfit rises, or no wire spans the mounts any more */
            if (status == WCUT_OK && present_cost(g, &cost) && cost <= before + 1) break;
            status = WCUT_NOT_CONVERGED;
        }
        if (status == WCUT_NOT_CONVERGED) { /* no way down from here: this is it */
            memcpy(g->f->x, from, sizeof from);
            return present_rows(g, error);
        }

        /* stop where the step is well within chance, or gains nothing */
        const double gain = before - cost;
        before = cost;
        if (longest < 0.3 || gain < 0.5) break;
    }

    return status;
}

/* Predict along the recorded motion at the present x, of which g->rows are the rows: the differences along the exogenous
   trajectory count from here. */
static wcut_status set_anchor(fitting *g, wcut_error *error) {
    /* the recorded motion under the present model, cut by cut */
    const wcut_evidence *e = g->e;
    const wcut_model model = wcut_fitted_model(g->f, g->f->x);
    wcut_error *failed = wcut_alloc((size_t)e->cuts, sizeof *failed);
    if (!failed) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d cuts", e->cuts);
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        if (c->bins == 0) continue;
        wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
        const wcut_job job = wcut_model_job(e, &model, k, effect);
        wcut_response d = {0};
        failed[k].status = wcut_response_run(&job, NODES_FINE, &c->recorded, false, e->stop, &d, &failed[k]);
        if (failed[k].status == WCUT_OK)
            failed[k].status = wcut_evidence_bin_recorded(c, &model, &d, g->f->predicted + c->row);
        wcut_response_destroy(&d);
    }

    /* the anchor: measured less predicted there */
    wcut_status status = WCUT_OK;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        if (status == WCUT_OK && failed[k].status != WCUT_OK)
            status = wcut_fail(error, failed[k].status, "cut %d: %s", k + 1, failed[k].text);
        for (int i = 0; i < WCUT_SIGNALS * c->bins; i++)
            g->anchor[c->row + i] = c->measured[i / c->bins][i % c->bins] - g->f->predicted[c->row + i] +
                                    (e->own_rows ? e->own_rows[c->row + i] : 0);
        for (int i = 0; i < c->patch.count; i++) { /* a face has no loop: the exogenous difference is exact */
            const int row = c->row + WCUT_SIGNALS * c->bins + i;
            g->anchor[row] -= g->rows[row] - g->at_rows[row];
        }
    }
    wcut_free(failed);
    if (status != WCUT_OK) return status;
    int there = 0, lost = 0;
    for (int i = 0; i < e->rows; i++) { /* a sample that one run reached and the other did not says nothing */
        there += isfinite(g->measured[i]) != 0;
        if (isfinite(g->measured[i]) && !isfinite(g->anchor[i])) g->anchor[i] = 0, lost++;
        g->at_rows[i] = g->rows[i];
    }
    if (lost > LOST_MAX * there)
        return wcut_fail(error, WCUT_NOT_CONVERGED, "no wire spans the mounts in %d of %d rows", lost, there);

    /* the residual refers to the new anchor from now on */
    exogenous_residual(g);

    return WCUT_OK;
}

/* whether what the anchored residual still asks for is within chance: half a unit of cost for every coordinate */
static bool has_settled(fitting *g, double *covariance) {
    double t[WCUT_FITTED_MAX], present, best;
    if (!present_cost(g, &present) || !find_step(g, t, covariance, &best)) return true;
    return present - best < 2 + 0.001 * best;
}

/* misfit of every cut, and of every cut predicted from the others, under the noise that all hypotheses share */
static void judge_cuts(fitting *g, const double *t) {
    wcut_fitted *f = g->f;
    int chosen[WCUT_FITTED_MAX];
    all_columns(g->n, chosen);
    for (int k = 0; k < g->e->cuts; k++) {
        double without[WCUT_FITTED_MAX], cost;
        f->cut_cost[k] = wcut_normal_equations_cost(&g->normal, k, g->n, chosen, t);
        const bool solved =
            wcut_normal_equations_solve(&g->normal, g->n, chosen, g->centre, g->precision, k, without, NULL, &cost);
        f->held_out[k] = solved ? wcut_normal_equations_cost(&g->normal, k, g->n, chosen, without) : f->cut_cost[k];
        for (int i = 0; i < g->shared; i++) {
            double to = f->x[i] + (solved ? without[i] : t[i]);
            if (i >= WCUT_BASE) to = clamp(to, f->coordinate[i - WCUT_BASE].low, f->coordinate[i - WCUT_BASE].high);
            f->without[k * g->shared + i] = to;
        }
    }
}

/* what is left: with the nuisances and the scatter in, without them, and in units of all that may scatter */
static void keep_residuals(fitting *g, const wcut_evidence *own, const double *t) {
    wcut_fitted *f = g->f;

    /* as measured, before and after the nuisances are subtracted */
    const size_t rows = (size_t)g->e->rows;
    double *left = f->residual;
    memcpy(left, g->plain_residual, rows * sizeof *left);
    memcpy(f->column, g->plain_column + WCUT_BASE * rows, (size_t)f->count * rows * sizeof *f->column);
    for (int k = 0; k < g->n; k++) {
        if (k == g->shared) memcpy(f->open, left, rows * sizeof *left);
        for (size_t i = 0; i < rows; i++) left[i] -= t[k] * g->plain_column[(size_t)k * rows + i];
    }

    /* in units of noise and scatter together */
    wcut_evidence_whiten(own, g->measured, left, f->standard);
    wcut_scatter_standardise(own, &g->normal, f->standard);

    /* the scatter of each cut at its likeliest */
    for (int cut = 0; cut < own->cuts && g->normal.m > 0; cut++) {
        const wcut_evidence_cut *c = &own->cut[cut];
        double *value = f->scatter + (ptrdiff_t)cut * g->normal.m,
               *error = f->scatter_error + (ptrdiff_t)cut * g->normal.m;
        if (c->bins == 0) continue;
        wcut_scatter_estimate(own, &g->normal, cut, t, value, error);
        for (int k = 0; k < g->normal.m; k++)
            for (int i = 0; i < WCUT_SIGNALS * c->bins + c->patch.count; i++)
                left[c->row + i] -= value[k] * own->scatter.column[(size_t)k * rows + (size_t)(c->row + i)];
    }
    wcut_evidence_whiten(g->e, g->measured, left, left);
}

/* noise and scatter of this hypothesis, the last step under them, and what it is worth */
static wcut_status finish_fit(fitting *g, double *covariance) {
    wcut_fitted *f = g->f;
    double t[WCUT_FITTED_MAX], from[WCUT_FITTED_MAX], cost;

    /* the noise of this hypothesis is fitted in a copy, so that the evidence keeps its own */
    wcut_evidence own = *g->e;
    own.scatter.white = wcut_alloc((size_t)own.scatter.count * (size_t)own.rows, sizeof(double));
    if (!own.scatter.white) return WCUT_NO_MEMORY;
    if (!find_step(g, t, covariance, &f->misfit)) {
        wcut_free(own.scatter.white);
        return WCUT_NOT_CONVERGED;
    }

    /* cost of each cut, on all cuts and held out */
    judge_cuts(g, t);

    /* The variances under which the residual is likeliest, and the solution under them. What is held at a bound is held here
       too; what another noise takes beyond one is held in turn. */
    const wcut_variances begin = own.noise;
    wcut_status status = WCUT_OK;
    for (int round = 0, more = 1; status == WCUT_OK && more > 0 && round < BOUNDED; round++) {
        own.noise = begin;
        wcut_variances_begin(&own.noise);
        const wcut_linear linear = {.n = g->n,
                                    .column = g->plain_column,
                                    .residual = g->plain_residual,
                                    .missing = g->measured,
                                    .centre = g->centre,
                                    .precision = g->precision};
        status = wcut_variance_fit(&linear, &own, g->column, g->residual, &g->normal, &f->cost);
        if (status == WCUT_OK && !solve_held(g, t, &cost)) status = WCUT_NOT_CONVERGED;
        if (status == WCUT_OK) more = hold_at_bounds(g, t);
    }

    /* the covariance as if there were no bounds */
    double free_step[WCUT_FITTED_MAX];
    if (status == WCUT_OK && !solve_within_bounds(g, free_step, covariance, &cost)) status = WCUT_NOT_CONVERGED;

    /* errors from the covariance, half widths before any profile */
    if (status == WCUT_OK) {
        f->noise = own.noise;
        keep_residuals(g, &own, t);
        memcpy(from, f->x, sizeof from);
        const bool bound = f->at_bound;
        move(g, from, t, covariance, 1);
        f->at_bound = f->at_bound || bound;
        for (int k = 0; k < g->shared; k++) {
            f->error[k] = sqrt(covariance[k * g->n + k]);
            f->below[k] = f->above[k] = NORMAL_95 * fmax(f->error[k], wcut_fitted_jackknife(g->e, f, k));
        }

        /* delays of the readings, then the kerf, as far as there are scans */
        for (int k = 0; k < WCUT_DELAYS; k++) {
            const int at = g->shared + k;
            f->delay[k] = t[at], f->delay_error[k] = sqrt(covariance[at * g->n + at]);
        }
        f->kerf = f->kerf_error = (double)NAN;
        if (g->nuisances > WCUT_DELAYS) f->kerf = t[g->n - 1], f->kerf_error = sqrt(covariance[g->n * g->n - 1]);

        /* the model at the fitted coordinates */
        f->model = wcut_fitted_model(f, f->x);
    }

    wcut_free(own.scatter.white);
    return status;
}

wcut_status wcut_model_fit(const wcut_evidence *e, const wcut_model *start, wcut_fitted *out, wcut_error *error) {
    /* room for the problem, and the rows at the model that the evidence was predicted with */
    fitting g = {0};
    wcut_fitted f = {.kerf = 0};
    double *covariance = wcut_alloc((size_t)WCUT_FITTED_MAX * WCUT_FITTED_MAX, sizeof *covariance);
    wcut_status status = covariance ? fitting_create(e, start, &f, &g) : WCUT_NO_MEMORY;
    if (status != WCUT_OK) wcut_fail(error, status, "a fit of %d effects", start->effects);
    if (status == WCUT_OK) status = wcut_models_rows(e, 1, &e->at, g.at_rows, error);

    /* alternate: Gauss-Newton about an anchor, then the anchor anew, until the step is within chance */
    bool settled = false;
    for (int round = 0; status == WCUT_OK && round < ANCHORS && !settled; round++) {
        status = iterate(&g, covariance, error);
        if (status == WCUT_OK) status = set_anchor(&g, error);
        if (status == WCUT_OK) settled = has_settled(&g, covariance);
    }

    /* variances, intervals and held-out costs, then hand over */
    if (status == WCUT_OK) status = finish_fit(&g, covariance);
    fitting_destroy(&g);
    wcut_free(covariance);
    if (status == WCUT_OK)
        *out = f;
    else
        wcut_fitted_destroy(&f);

    return status;
}

double wcut_fitted_jackknife(const wcut_evidence *e, const wcut_fitted *f, int k) {
    const int shared = WCUT_BASE + f->count;
    double mean = 0, square = 0;
    int n = 0;
    for (int cut = 0; cut < e->cuts; cut++)
        if (e->cut[cut].bins > 0) mean += f->without[cut * shared + k], n++;
    if (n < 3) return 0; /* two cuts do not show how cuts differ */
    mean /= n;
    for (int cut = 0; cut < e->cuts; cut++)
        if (e->cut[cut].bins > 0) square += pow(f->without[cut * shared + k] - mean, 2);
    return sqrt(square * (n - 1) / n);
}

/* ---- profile ---- */

typedef struct summit {
    double x[WCUT_FITTED_MAX], cost;
    const double *covariance;
} summit;

/* cost with coordinate k held at a value: the others go along with it, then take the step that is best beside it */
static wcut_status held_cost(fitting *g, const summit *s, int k, double value, double *cost, wcut_error *error) {
    int chosen[WCUT_FITTED_MAX], count = 0;
    double t[WCUT_FITTED_MAX];

    /* move the others along the ridge of the covariance, so that they begin near their best */
    for (int i = 0; i < g->shared; i++) {
        const wcut_coordinate *c = i < WCUT_BASE ? NULL : &g->f->coordinate[i - WCUT_BASE];
        const double along = s->covariance[i * g->n + k] / s->covariance[k * g->n + k];
        const double to = i == k ? value : s->x[i] + along * (value - s->x[k]);
        g->f->x[i] = c ? clamp(to, c->low, c->high) : to;
    }

    /* all columns but the one that is held */
    for (int i = 0; i < g->n; i++)
        if (i != k) chosen[count++] = i;

    /* the residual there, and the best step of the others about it */
    const wcut_status status = present_rows(g, error);
    if (status != WCUT_OK) return status;
    release_bounds(g);
    wcut_normal_equations_fill(g->e, g->column, g->residual, &g->normal);
    if (!wcut_normal_equations_solve(&g->normal, count, chosen, g->centre, g->precision, -1, t, NULL, cost))
        return wcut_fail(error, WCUT_NOT_CONVERGED, "the coordinates beside a profile depend on each other");

    /* the prior of the held coordinate counts too */
    *cost += g->precision[k] * g->centre[k] * g->centre[k];

    return WCUT_OK;
}

/* how far coordinate k goes to one side until the misfit has risen by RISE_95, or to its bound */
static wcut_status find_end(fitting *g, const summit *s, int k, double side, double *half, wcut_error *error) {
    const wcut_coordinate *c = &g->f->coordinate[k - WCUT_BASE];
    const double room = fmax(side < 0 ? s->x[k] - c->low : c->high - s->x[k], 0);
    double far = fmin(NORMAL_95 * sqrt(s->covariance[k * g->n + k]), room);
    for (int round = 0; far > 0 && round < ENDS; round++) {
        double cost = HUGE_VAL;
        const wcut_status status = held_cost(g, s, k, s->x[k] + side * far, &cost, error);
        if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
        const double rise =
            status == WCUT_OK ? fmax(cost - s->cost, 1e-3) : 16 * RISE_95; /* no wire spans the mounts */
        if (fabs(rise - RISE_95) < 0.1 * RISE_95 || (far >= room && rise < RISE_95)) break;
        far = fmin(far * clamp(sqrt(RISE_95 / rise), 0.4, 2.5), room);
    }
    *half = far;
    return WCUT_OK;
}

/* everything of a fit at its summit, as wcut_model_fit leaves it */
static wcut_status climb_again(const wcut_evidence *e, const wcut_model *model, wcut_fitted *f, fitting *g,
                               double *covariance, summit *s, wcut_error *error) {
    double t[WCUT_FITTED_MAX];
    wcut_status status = fitting_create(e, model, f, g);
    if (status != WCUT_OK) return wcut_fail(error, status, "a profile of %d effects", model->effects);
    status = wcut_models_rows(e, 1, &e->at, g->at_rows, error);
    if (status == WCUT_OK) status = take_jacobian(g, error);
    if (status == WCUT_OK) status = set_anchor(g, error);
    if (status == WCUT_OK && !find_step(g, t, covariance, &s->cost))
        status = wcut_fail(error, WCUT_NOT_CONVERGED, "the coordinates of a fit depend on each other");
    memcpy(s->x, f->x, sizeof s->x);
    s->covariance = covariance;
    return status;
}

wcut_status wcut_fitted_profile(const wcut_evidence *e, wcut_fitted *fitted, wcut_error *error) {
    fitting g = {0};
    wcut_fitted f = {.kerf = 0};
    summit s;
    double half[WCUT_FITTED_MAX][2];
    double *covariance = wcut_alloc((size_t)WCUT_FITTED_MAX * WCUT_FITTED_MAX, sizeof *covariance);
    double *missing = wcut_alloc((size_t)e->rows, sizeof *missing);

    /* under the noise and the scatter of this hypothesis */
    wcut_evidence own = *e;
    own.noise = fitted->noise;
    own.scatter.white = wcut_alloc((size_t)own.scatter.count * (size_t)own.rows, sizeof(double));
    wcut_status status = WCUT_OK;
    if (!covariance || !missing || !own.scatter.white)
        status = wcut_fail(error, WCUT_NO_MEMORY, "no memory for a profile");
    if (status == WCUT_OK) {
        wcut_evidence_residual(e, missing);
        wcut_evidence_whiten_scatter(&own, missing);
        status = climb_again(&own, &fitted->model, &f, &g, covariance, &s, error);
    }

    /* both ends of every coordinate */
    for (int k = WCUT_BASE; status == WCUT_OK && k < g.shared; k++)
        for (int side = 0; status == WCUT_OK && side < 2; side++)
            status = find_end(&g, &s, k, side ? 1 : -1, &half[k][side], error);
    for (int k = WCUT_BASE; status == WCUT_OK && k < g.shared; k++) {
        const double cuts = NORMAL_95 * wcut_fitted_jackknife(e, fitted, k);
        fitted->below[k] = fmax(half[k][0], cuts), fitted->above[k] = fmax(half[k][1], cuts);
    }

    /* the profile replaces the half widths only after the last end was found */
    fitting_destroy(&g);
    wcut_fitted_destroy(&f);
    wcut_free(own.scatter.white);
    wcut_free(missing);
    wcut_free(covariance);
    return status;
}

void wcut_fitted_destroy(wcut_fitted *f) {
    wcut_free(f->cut_cost);
    wcut_free(f->held_out);
    wcut_free(f->without);
    wcut_free(f->residual);
    wcut_free(f->standard);
    wcut_free(f->open);
    wcut_free(f->scatter);
    wcut_free(f->scatter_error);
    wcut_free(f->column);
    wcut_free(f->predicted);
    *f = (wcut_fitted){0};
}
