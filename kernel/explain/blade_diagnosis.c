/* A case of a blade diagnosed: bins, search, proof by cuts left out, and what follows. */
#include "explain/blade_diagnosis.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/sort.h"
#include "cut/score.h"
#include "cut/setup.h"

#define SCALE 0.2        /* [1] of a usual force: below it a model is off by newtons, above by a share */
#define MODEL_ERROR 0.04 /* [1] of a size: what bins and the blade's soft faces leave, 0.018 on simulated recordings */
#define NOISE_ONLY 1.5   /* [1] misfit over noise that is no more than noise */

/* ---- the cuts ---- */

static wcut_status check_cut(int k, const wcut_diagnosis_cut *cut, wcut_error *error) {
    if (!cut->job || !cut->recording) return WCUT_OK;
    if (cut->job->rig.kind != WCUT_RIG_KIND_BLADE || !cut->job->tool)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "cut %d: found a rig of kind %s, expected a blade as in the others",
                         k + 1, wcut_rig_name(cut->job->rig.kind));
    if (!wcut_recording_has_force(cut->recording))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "cut %d: found a recording without force_x_N .. force_z_N, expected one "
                         "of a blade",
                         k + 1);
    return WCUT_OK;
}

static wcut_status gather_cuts(wcut_blade_run *g, wcut_error *error) {
    g->data.cuts = g->cuts;
    g->data.cut = wcut_alloc((size_t)g->cuts, sizeof *g->data.cut);
    g->left_out = wcut_alloc((size_t)g->cuts, sizeof *g->left_out);
    double *force = wcut_alloc((size_t)g->cuts, sizeof *force);
    wcut_status status = g->data.cut && g->left_out && force
                             ? WCUT_OK
                             : wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d cuts", g->cuts);

    /* every cut that has both files, in bins */
    int used = 0;
    for (int k = 0; status == WCUT_OK && k < g->cuts; k++) {
        status = check_cut(k, &g->cut[k], error);
        if (status != WCUT_OK || !g->cut[k].job || !g->cut[k].recording) continue;
        status = wcut_blade_cut_create(&g->cut[k], &g->data.cut[k], &g->left_out[k]);
        if (status == WCUT_OK) force[used++] = g->data.cut[k].max;

        /* one that tells nothing is left out, and it is said */
        if (status == WCUT_DEGENERATE) status = WCUT_OK;
        if (status != WCUT_OK && error) *error = g->left_out[k];
    }
    if (status == WCUT_OK && used == 0)
        status = wcut_fail(error, WCUT_BAD_ARGUMENT, "no cut has a job and a recording that can be used");

    /* the scale of comparison */
    if (status == WCUT_OK) {
        wcut_sort(used, force);
        g->data.scale = fmax(SCALE * sorted_median(used, force), 1e-3);
    }
    wcut_free(force);
    return status;
}

/* ---- proof ---- */

double *const *wcut_blade_forces(const wcut_blade_run *g, wcut_evidence_model model, bool left_out) {
    const wcut_blade_fit *after = g->search.chosen >= 0 ? &g->search.candidate[g->search.chosen].fit : &g->search.none;
    switch (model) {
        case WCUT_EVIDENCE_MODEL_BEFORE:
            return g->before;
        case WCUT_EVIDENCE_MODEL_RECALIBRATED:
            return left_out ? g->search.none.held_out : g->search.none.force;
        case WCUT_EVIDENCE_MODEL_AFTER:
            return left_out ? after->held_out : after->force;
        default:
            return left_out ? g->box_out : g->box;
    }
}

wcut_evidence_score wcut_blade_score(const wcut_blade_case *c, double *const *force, wcut_status *status) {
    size_t rows = 0, at = 0;
    for (int k = 0; k < c->cuts; k++) rows += (size_t)c->cut[k].bins;
    double *x = wcut_alloc(rows, sizeof *x), *y = wcut_alloc(rows, sizeof *y);
    wcut_evidence_score out = {.low = (double)NAN, .high = (double)NAN};
    if (x && y) {
        for (int k = 0; k < c->cuts; k++)
            for (int b = 0; b < c->cut[k].bins; b++) x[at] = c->cut[k].force[b], y[at++] = force[k][b];
        const wcut_score s = wcut_score_of((int)rows, x, y, 0);
        out.count = s.count, out.rmsd = s.rmsd, out.nrmsd = s.nrmsd, out.rmse_over_range = s.rmse_over_range;
        out.rmse = s.rmse;
    } else {
        *status = WCUT_NO_MEMORY;
    }
    wcut_free(x);
    wcut_free(y);
    return out;
}

static wcut_status prove_blade(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    wcut_status status = WCUT_OK;

    /* a regression that knows nothing of foam, beside the models */
    if (g->options->proof) {
        g->box = wcut_blade_rows_create(&g->data), g->box_out = wcut_blade_rows_create(&g->data);
        if (!g->box || !g->box_out) return WCUT_NO_MEMORY;
        status = wcut_blade_black_box(&g->data, g->box, g->box_out);
    } else {
        snprintf(d->unproven, sizeof d->unproven, "it was left out");
    }

    /* figures over all cuts, fitted to all and each left out */
    for (int m = 0; status == WCUT_OK && m < WCUT_EVIDENCE_MODEL_COUNT; m++) {
        double *const *all = wcut_blade_forces(g, (wcut_evidence_model)m, false);
        double *const *out = wcut_blade_forces(g, (wcut_evidence_model)m, true);
        if (all) d->score[m][WCUT_EVIDENCE_CHANNEL_FORCE] = wcut_blade_score(&g->data, all, &status);
        if (out && g->options->proof)
            d->held_out_score[m][WCUT_EVIDENCE_CHANNEL_FORCE] = wcut_blade_score(&g->data, out, &status);
    }
    for (int k = 0; g->options->proof && k < g->cuts; k++) d->held_out[k] = g->data.cut[k].bins > 0;

    return status;
}

/* ---- the verdict ---- */

static wcut_estimate estimate_of(double value, double error) {
    return (wcut_estimate){value, value - 1.96 * error, value + 1.96 * error};
}

/* the named effect with its interval: on the fitted scale, then as a job has it */
static void add_named_effect(wcut_blade_run *g) {
    const wcut_blade_candidate *x = &g->search.candidate[g->search.chosen];
    wcut_found_effect *f = &g->out->effect[g->out->effects++];
    *f = (wcut_found_effect){.effect = x->fit.model.effect, .present = true, .confidence = g->search.confidence};
    for (int k = 0; k < WCUT_EFFECT_VALUES; k++)
        f->parameter[k] = (wcut_estimate){f->effect.value[k], f->effect.value[k], f->effect.value[k]};

    /* a reciprocal turns the ends round; what reaches none is open */
    const wcut_coordinate *c = &x->fit.model.coordinate;
    const double found = x->fit.model.x[WCUT_BLADE_BASE];
    const wcut_estimate size = estimate_of(found, hypot(x->fit.error[WCUT_BLADE_BASE], MODEL_ERROR * found));
    wcut_estimate *e = &f->parameter[c->at];
    *e = size;
    if (c->scale == WCUT_COORDINATE_SCALE_RECIPROCAL)
        *e = (wcut_estimate){1 / size.value, 1 / size.high, size.low > 0 ? 1 / size.low : HUGE_VAL};
    f->effect.value[c->at] = e->value;
    f->estimated[c->at] = true;
}

/* of the cuts that are used there is one at least */
static const wcut_job *first_blade_job(const wcut_blade_run *g) {
    const wcut_job *job = NULL;
    for (int k = 0; k < g->cuts && !job; k++) job = g->data.cut[k].job;
    assert(job);
    return job;
}

static void report_law(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    const wcut_blade_fit *f = g->search.chosen >= 0 ? &g->search.candidate[g->search.chosen].fit : &g->search.none;
    const wcut_job *job = first_blade_job(g);
    const wcut_estimate log_a = estimate_of(f->model.x[WCUT_BLADE_LAW], f->error[WCUT_BLADE_LAW]);
    d->a_job = job->force_law.a, d->b_job = job->force_law.b;
    d->a = (wcut_estimate){exp(log_a.value), exp(log_a.low), exp(log_a.high)};
    d->b = (wcut_estimate){job->force_law.b, (double)NAN, (double)NAN};
    d->length_change = (wcut_estimate){0, (double)NAN, (double)NAN};
    d->kerf = (wcut_estimate){(double)NAN, (double)NAN, (double)NAN};
}

/* the corrected job; where nothing is named the recalibration may only compensate for what was not found */
static wcut_status correct_job(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    const wcut_job *job = first_blade_job(g);
    d->correction = (wcut_correction){.a = d->a.value, .b = d->b.value, .kerf = (double)NAN};
    if (g->search.chosen < 0 && d->kind != WCUT_VERDICT_NONE) {
        snprintf(d->withheld, sizeof d->withheld,
                 "nothing was named, so the recalibration may compensate for what was not "
                 "found");
        return WCUT_OK;
    }
    if (d->effects > 0) d->correction.effect[d->correction.effects++] = d->effect[0].effect;
    wcut_job *improved = wcut_job_copy(job);
    if (!improved) return WCUT_NO_MEMORY;
    if (wcut_correction_apply(&d->correction, improved, NULL) == WCUT_OK)
        d->improved = improved;
    else
        wcut_job_destroy(improved);
    return WCUT_OK;
}

static void decide_blade(wcut_blade_run *g) {
    wcut_diagnosis *d = g->out;
    const wcut_blade_search *s = &g->search;

    /* named, no more than noise, or not explained */
    d->adequacy = s->adequacy, d->adequacy_p = s->adequacy > NOISE_ONLY ? 0 : 1;
    if (s->chosen >= 0) {
        d->kind = WCUT_VERDICT_PHYSICS, d->confidence = s->confidence;
        d->form_open = s->adequacy > NOISE_ONLY;
        add_named_effect(g);
    } else if (s->adequacy <= NOISE_ONLY) {
        d->kind = WCUT_VERDICT_NONE, d->confidence = 0.9;
    } else {
        d->kind = WCUT_VERDICT_UNKNOWN, d->confidence = 0.5;
    }

    /* the law, and the noise of a bin in the mean over cuts */
    report_law(g);
    for (int k = 0; k < WCUT_EVIDENCE_CHANNEL_COUNT; k++) d->noise[k] = (double)NAN;
    double noise = 0;
    int used = 0;
    for (int k = 0; k < g->cuts; k++)
        if (g->data.cut[k].bins > 0) noise += g->data.cut[k].noise, used++;
    d->noise[WCUT_EVIDENCE_CHANNEL_FORCE] = noise / used;
}

/* ---- the whole ---- */

static void forget_blade(wcut_blade_run *g) {
    wcut_blade_search_destroy(&g->data, &g->search);
    wcut_blade_rows_destroy(&g->data, g->before);
    wcut_blade_rows_destroy(&g->data, g->box);
    wcut_blade_rows_destroy(&g->data, g->box_out);
    for (int k = 0; g->data.cut && k < g->cuts; k++) wcut_blade_cut_destroy(&g->data.cut[k]);
    wcut_free(g->data.cut);
    wcut_free(g->left_out);
}

static wcut_status run_blade(wcut_blade_run *g, wcut_error *error) {
    wcut_status status = gather_cuts(g, error);
    if (status == WCUT_OK && wcut_stop_step(g->stop, "the recalibration was fitted", 1)) status = WCUT_INTERRUPTED;
    if (status != WCUT_OK) return status;

    /* before anything is fitted, then the search */
    double a = 0;
    g->before = wcut_blade_rows_create(&g->data);
    if (!g->before) return WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < g->cuts; k++) {
        const wcut_blade_cut *c = &g->data.cut[k];
        if (!c->job) continue;
        if (a == 0) a = c->job->force_law.a;
        status = wcut_blade_predict_job(c, g->before[k]);
    }
    if (status == WCUT_OK) status = wcut_blade_search_run(&g->data, g->options->without, a, g->stop, &g->search);
    if (status == WCUT_OK) decide_blade(g);

    /* what it is worth, and the report */
    if (status == WCUT_OK && wcut_stop_step(g->stop, "the forward proof was run", WCUT_BLADE_STEPS - 2))
        status = WCUT_INTERRUPTED;
    if (status == WCUT_OK) status = prove_blade(g);
    if (status == WCUT_OK) status = correct_job(g);
    if (status == WCUT_OK && (!wcut_blade_report(g) || !wcut_blade_tell(g))) status = WCUT_NO_MEMORY;

    return status;
}

wcut_status wcut_blade_diagnose(int cuts, const wcut_diagnosis_cut *cut, const wcut_diagnosis_options *options,
                                wcut_stop *stop, wcut_diagnosis *d, wcut_error *error) {
    wcut_blade_run g = {.cuts = cuts, .cut = cut, .options = options, .stop = stop, .out = d, .search.chosen = -1};
    wcut_status status = run_blade(&g, error);
    if (status != WCUT_OK && status != WCUT_BAD_ARGUMENT && error && error->status == WCUT_OK)
        status = wcut_fail(error, status, "a case of a blade: %s", wcut_status_text(status));
    forget_blade(&g);
    return status;
}
