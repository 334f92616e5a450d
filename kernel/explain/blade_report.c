/* What a blade's diagnosis shows: the rig, where the misfit is, residuals over time, the ranking. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/least_squares.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "explain/blade_diagnosis.h"

/* bins of one pass that err alike, about the way over which a force builds up */
#define ALIKE 8.0
#define SHARE_MIN 0.01
enum { MISMATCHES = 16, RIG_ROWS = 10 };

static const wcut_blade_fit *final_blade_fit(const wcut_blade_run *g) {
    return g->search.chosen >= 0 ? &g->search.candidate[g->search.chosen].fit : &g->search.none;
}

/* ---- the rig ---- */

static wcut_rig_row *add_blade_row(wcut_diagnosis *d, const char *name, double value, double error) {
    wcut_rig_row *row = &d->rig[d->rig_rows++];
    snprintf(row->name, sizeof row->name, "%s", name);
    row->value = (wcut_estimate){value, value - 1.96 * error, value + 1.96 * error};
    return row;
}

static void add_value(wcut_rig_row *row, int cut, double value, double error) {
    if (row->cuts == WCUT_RIG_CUTS) return;
    row->cut[row->cuts] = cut;
    row->of_cut[row->cuts++] = (wcut_estimate){value, value - 1.96 * error, value + 1.96 * error};
}

/* a row of a value of each cut, and their mean */
static void add_cut_row(wcut_blade_run *g, const char *name, double (*value)(const wcut_blade_cut *, int), int which,
                        double (*error)(const wcut_blade_cut *)) {
    double sum = 0, square = 0;
    int n = 0;
    wcut_rig_row *row = add_blade_row(g->out, name, 0, 0);
    for (int k = 0; k < g->cuts; k++) {
        const wcut_blade_cut *c = &g->data.cut[k];
        if (c->bins == 0) continue;
        const double v = value(c, which);
        add_value(row, k, v, error(c));
        sum += v, square += v * v, n++;
    }
    const double mean = sum / n,
                 deviation = n > 1 ? sqrt(fmax(square - sum * mean, 0) / (n - 1) / n) : error(&g->data.cut[0]);
    row->value = (wcut_estimate){mean, mean - 1.96 * deviation, mean + 1.96 * deviation};
}

static double zero_value(const wcut_blade_cut *c, int axis) { return c->zero[axis]; }
static double zero_error(const wcut_blade_cut *c) { return c->noise; }
static double gain_value(const wcut_blade_cut *c, int which) { return which ? c->ratio : c->gain; }
static double gain_error(const wcut_blade_cut *c) { return c->gain_error; }
static double no_error(const wcut_blade_cut *c) { return 0 * c->gain; }

/* slope of the force along the edge over that across it, by the bins that feel a force */
static double along_value(const wcut_blade_cut *c, int which) {
    double xy = 0, xx = 0;
    for (int b = 0; b < c->bins; b++)
        if (c->force[b] > 0.2 * c->max) xy += c->force[b] * c->along[b], xx += c->force[b] * c->force[b];
    return xx > 0 ? xy / xx : which;
}

/* The weight of the tool in readings before the first contact: constant in the block frame, so turned by the poses, beside a
   zero that is constant in the tool's (least squares over cuts and axes). false: the poses do not tell them apart. */
static bool solve_weight(const wcut_blade_run *g, double *weight, double *error) {
    enum { UNKNOWNS = 4 };
    double *a = wcut_alloc((size_t)g->cuts * 3 * UNKNOWNS, sizeof *a), *b = wcut_alloc((size_t)g->cuts * 3, sizeof *b);
    double x[UNKNOWNS], inverse[UNKNOWNS * UNKNOWNS], square = 0;
    int rows = 0;
    for (int k = 0; a && b && k < g->cuts; k++) {
        const wcut_blade_cut *c = &g->data.cut[k];
        if (c->bins == 0 || c->job->rig.force_in_block) continue;

        /* the way down in the tool's axes: each axis, turned into the block frame, has it as its z */
        const wcut_vec3 axis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int i = 0; i < 3; i++, rows++) {
            const wcut_vec3 turned =
                vec3_sub(wcut_pose_point(&c->job->tool[0], axis[i]), wcut_pose_point(&c->job->tool[0], vec3(0, 0, 0)));
            a[rows * UNKNOWNS + i] = 1;
            a[rows * UNKNOWNS + 3] = -turned.z;
            b[rows] = c->zero[i];
            square += c->zero[i] * c->zero[i];
        }
    }

    /* solve, if there are more readings than unknowns and the poses differ */
    const bool solved = a && b && rows > UNKNOWNS && wcut_qr_solve(rows, UNKNOWNS, a, b, x, inverse) == WCUT_OK;
    wcut_free(a);
    wcut_free(b);
    if (!solved) return false;

    /* readings in air scatter by the noise, and the rest of the fit by a tenth of the zeros */
    double noise = 0;
    for (int k = 0; k < g->cuts; k++) noise = fmax(noise, g->data.cut[k].noise);
    *weight = x[3];
    *error = fmax(noise, sqrt(square / rows) * 0.1) * sqrt(fmax(inverse[15], 0));
    return *error < 100;
}

static bool fill_rig(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    d->rig = wcut_alloc(RIG_ROWS, sizeof *d->rig);
    if (!d->rig) return false;

    /* what no file says of the block */
    const wcut_blade_fit *f = final_blade_fit(g);
    const double way = exp(f->model.x[WCUT_BLADE_BUILD_UP]);
    add_blade_row(d, "force_build_up_mm", way, way * f->error[WCUT_BLADE_BUILD_UP]);
    add_blade_row(d, "block_along_feed_mm", f->model.x[WCUT_BLADE_FEED], f->error[WCUT_BLADE_FEED]);
    add_blade_row(d, "block_up_mm", f->model.x[WCUT_BLADE_UP], f->error[WCUT_BLADE_UP]);

    /* sensor and strategy, cut by cut */
    static const char *const zero_name[] = {"force_zero_x_N", "force_zero_y_N", "force_zero_z_N"};
    for (int axis = 0; axis < 3; axis++) add_cut_row(g, zero_name[axis], zero_value, axis, zero_error);
    double weight, error;
    if (solve_weight(g, &weight, &error)) add_blade_row(d, "tool_weight_N", weight, error);
    add_cut_row(g, "sliding_mm_s_per_N", gain_value, 0, gain_error);
    add_cut_row(g, "sliding_ratio_in_air", gain_value, 1, no_error);
    add_cut_row(g, "force_along_over_across", along_value, 0, no_error);

    return true;
}

/* ---- where ---- */

static int larger_share(const void *a, const void *b) {
    const wcut_mismatch *x = a, *y = b;
    return x->share < y->share ? 1 : x->share > y->share ? -1 : x->cut - y->cut;
}

/* a stretch of bins, from .. to-1, of a cut */
static wcut_mismatch stretch(const wcut_blade_run *g, int k, int from, int to, double whole) {
    const wcut_blade_cut *c = &g->data.cut[k];
    wcut_mismatch m = {.cut = k,
                       .channel = WCUT_EVIDENCE_CHANNEL_FORCE,
                       .column = "force",
                       .time = {c->time[from], c->time[to - 1]},
                       .station = {HUGE_VAL, -HUGE_VAL},
                       .wire = {(double)NAN, (double)NAN},
                       .block = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}}};

    /* residual of the recalibrated model, and the box of the tool's places */
    double sum = 0, square = 0;
    for (int b = from; b < to; b++) {
        const double d = c->force[b] - g->search.none.force[k][b];
        const wcut_vec3 p = c->place[b];
        sum += d, square += d * d;
        m.station[0] = fmin(m.station[0], c->station[b]), m.station[1] = fmax(m.station[1], c->station[b]);
        m.block[0] = (wcut_vec3){fmin(m.block[0].x, p.x), fmin(m.block[0].y, p.y), fmin(m.block[0].z, p.z)};
        m.block[1] = (wcut_vec3){fmax(m.block[1].x, p.x), fmax(m.block[1].y, p.y), fmax(m.block[1].z, p.z)};
    }
    m.mean = sum / (to - from);
    m.share = whole > 0 ? square / whole : 0;

    /* the mean over bins that err alike, against the sensor's noise alone */
    const double z = fabs(m.mean) / (c->noise * sqrt(fmin(ALIKE / (to - from), 1)));
    m.p_value = fmax(2 * wcut_gaussian_tail(fmin(z, 37)), 1e-300);

    return m;
}

/* one entry a stretch of a pass in which the recalibrated model errs to the same side */
static bool locate_stretches(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    double whole = 0;
    int bins = 0;
    for (int k = 0; k < g->cuts; k++)
        for (int b = 0; b < g->data.cut[k].bins; b++, bins++)
            whole += pow(g->data.cut[k].force[b] - g->search.none.force[k][b], 2);

    /* no more stretches than bins */
    d->mismatch = wcut_alloc((size_t)bins + 1, sizeof *d->mismatch);
    if (!d->mismatch) return false;

    /* a stretch ends with its pass, or where the residual changes sign */
    for (int k = 0; k < g->cuts; k++) {
        const wcut_blade_cut *c = &g->data.cut[k];
        for (int b = 0, from = 0; b < c->bins; b++) {
            const bool up = c->force[b] > g->search.none.force[k][b];
            const bool last = b + 1 == c->bins || c->pass[b + 1] != c->pass[b];
            if (!last && (c->force[b + 1] > g->search.none.force[k][b + 1]) == up) continue;
            const wcut_mismatch m = stretch(g, k, from, b + 1, whole);
            if (m.share > SHARE_MIN && m.p_value < 1e-3) d->mismatch[d->mismatches++] = m;
            from = b + 1;
        }
    }

    /* the largest first */
    qsort(d->mismatch, (size_t)d->mismatches, sizeof *d->mismatch, larger_share);
    if (d->mismatches > MISMATCHES) d->mismatches = MISMATCHES;
    return true;
}

/* ---- over time ---- */

static bool trace_force(wcut_blade_run *g, int k, wcut_residual_trace *t) {
    const wcut_blade_cut *c = &g->data.cut[k];
    const size_t n = (size_t)c->bins;
    *t = (wcut_residual_trace){
        .cut = k, .channel = WCUT_EVIDENCE_CHANNEL_FORCE, .column = "force", .count = c->bins, .noise = c->noise};
    t->time = wcut_copy(c->time, n, sizeof(double)), t->station = wcut_copy(c->station, n, sizeof(double));
    t->measured = wcut_copy(c->force, n, sizeof(double));
    double **to[] = {&t->before, &t->recalibrated, &t->after};
    bool whole = t->time && t->station && t->measured;
    for (int m = 0; m < 3; m++) {
        double *const *force = wcut_blade_forces(g, (wcut_evidence_model)m, false);
        *to[m] = wcut_alloc(n, sizeof(double));
        whole = whole && *to[m];
        for (int b = 0; *to[m] && b < c->bins; b++) (*to[m])[b] = c->force[b] - force[k][b];
    }
    return whole;
}

static bool trace_forces(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    d->trace = wcut_alloc((size_t)g->cuts, sizeof *d->trace);
    if (!d->trace) return false;
    for (int k = 0; k < g->cuts; k++)
        if (g->data.cut[k].bins > 0 && !trace_force(g, k, &d->trace[d->traces++])) return false;
    return true;
}

/* ---- the ranking ---- */

static int more_likely(const void *a, const void *b) {
    const wcut_hypothesis *x = a, *y = b;
    return x->probability < y->probability ? 1 : x->probability > y->probability ? -1 : x->count - y->count;
}

/* Likelihood of the gains over cuts, each normal with an unknown mean: exp(t^2 / 2) against no gain. */
static bool rank_candidates(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    const wcut_blade_search *s = &g->search;
    d->hypothesis = wcut_alloc((size_t)s->count + 1, sizeof *d->hypothesis);
    if (!d->hypothesis) return false;
    d->hypothesis[d->hypotheses++] =
        (wcut_hypothesis){.adequacy = s->adequacy, .probability = 1, .why = s->chosen >= 0 ? "explains less" : ""};

    /* each effect by its gain on left-out cuts; what was set aside counts a tenth */
    double sum = 1;
    for (int k = 0; k < s->count; k++) {
        const wcut_blade_candidate *x = &s->candidate[k];
        wcut_hypothesis *h = &d->hypothesis[d->hypotheses++];
        *h = (wcut_hypothesis){.count = 1, .effect = {x->fit.model.effect}, .parameters = 1, .why = x->why};
        h->gain = s->none.cost - x->fit.cost, h->held_out = x->used * x->gain, h->adequacy = s->adequacy;
        const double t = x->used > 1 && x->p < 0.5 ? wcut_gaussian_quantile(fmin(1 - x->p, 1 - 1e-12)) : 0;
        h->probability = x->why[0] ? 0.1 * exp(t * t / 2) : exp(t * t / 2);
        sum += h->probability;
    }

    /* in all they are 1 */
    for (int k = 0; k < d->hypotheses; k++) d->hypothesis[k].probability /= sum;
    qsort(d->hypothesis, (size_t)d->hypotheses, sizeof *d->hypothesis, more_likely);
    return true;
}

bool wcut_blade_report(wcut_blade_run *g) {
    return fill_rig(g) && locate_stretches(g) && trace_forces(g) && rank_candidates(g);
}
