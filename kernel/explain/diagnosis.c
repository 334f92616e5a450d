/* A case diagnosed: evidence, search, decision, and what follows from it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/diagnosis.h>

#include "base/alloc.h"
#include "base/distribution.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "cut/setup.h"
#include "explain/adequacy.h"
#include "explain/black_box.h"
#include "explain/blade_diagnosis.h"
#include "explain/correct.h"
#include "explain/cross_validation.h"
#include "explain/cut_length.h"
#include "explain/decide.h"
#include "explain/diagnosis_check.h"
#include "explain/droop.h"
#include "explain/experiment.h"
#include "explain/found.h"
#include "explain/locate.h"
#include "explain/modelled.h"
#include "explain/redundancy.h"
#include "explain/rig.h"
#include "explain/scatter.h"
#include "explain/variance.h"
#include "explain/verdict_text.h"
#include "explain/view.h"

#define DEGREES (180 / WCUT_PI)

wcut_diagnosis_options wcut_diagnosis_options_default(void) {
    return (wcut_diagnosis_options){.threads = 1, .proof = true, .seed = 1};
}

/* everything in a run */
typedef struct diagnosing {
    int cuts;
    wcut_redundancy redundancy;    /* what contradicts itself */
    const wcut_diagnosis_cut *cut; /* its cuts, set right */
    int test_cuts;
    const wcut_test_cut *calibration;
    const wcut_diagnosis_options *options;
    wcut_stop stop;
    wcut_evidence *evidence;
    wcut_model job_model; /* as the jobs say */
    double *before;       /* rows of time: residual under the jobs' own model, N and rad, in the evidence's rows */
    int before_rows;
    wcut_search search;
    wcut_decision decision;
    wcut_outside outside; /* of an unknown verdict: what was modelled, what was left out */
    wcut_cross_validation proof;
    wcut_diagnosis *out;
} diagnosing;

/* recordings of noise that adequacy is held against */
enum { NULLS = 500 };

/* of preparing, of the search, of what follows from it */
enum { FIRST_STEPS = 3, OUTSIDE = FIRST_STEPS + WCUT_SEARCH_STEPS + 1, PROOF, EXPERIMENT, CONTROL, STEPS };

static wcut_status report_step(diagnosing *g, const char *stage, int done, wcut_error *error) {
    return wcut_stop_step(&g->stop, stage, done) ? wcut_fail(error, WCUT_INTERRUPTED, "interrupted") : WCUT_OK;
}

/* ---- evidence under the recalibrated model ---- */

static wcut_status keep_before(diagnosing *g) {
    const wcut_evidence *e = g->evidence;
    g->before = wcut_alloc((size_t)e->rows, sizeof(double));
    if (!g->before) return WCUT_NO_MEMORY;
    wcut_evidence_residual(e, g->before);
    g->before_rows = e->rows;
    return WCUT_OK;
}

/* without the entries in which the wires hang by their weight: all that was made of them, again */
static wcut_status leave_droop_out(diagnosing *g, wcut_fitted *first, wcut_error *error) {
    wcut_evidence *e = g->evidence;
    g->out->droop = wcut_droop_leave_out(e, first->open);
    if (g->out->droop == 0) return WCUT_OK;
    wcut_fitted_destroy(first);
    wcut_free(g->before);
    g->before = NULL;
    wcut_status status = wcut_evidence_predict(e, &g->job_model, false, error);
    if (status == WCUT_OK) status = keep_before(g);
    return status == WCUT_OK ? wcut_model_fit(e, &e->at, first, error) : status;
}

static wcut_status prepare_diagnosis(diagnosing *g, wcut_error *error) {
    /* gather the cuts; the model is the jobs' own so far */
    wcut_status status = report_step(g, "the recordings were replayed", 0, error);
    if (status == WCUT_OK)
        status = wcut_evidence_create(g->cuts, g->cut, false, g->options->threads, &g->stop, &g->evidence, error);
    if (status != WCUT_OK) return status;
    if (g->options->rig) wcut_evidence_know(g->evidence, g->options->rig);
    wcut_evidence *e = g->evidence;

    /* replay under the jobs' own values: the figures called "before" */
    g->job_model = e->at;
    status = wcut_evidence_predict(e, &g->job_model, false, error);
    if (status == WCUT_OK) status = keep_before(g);

    /* recalibrate: a, b and wire length fitted to all cuts */
    if (status == WCUT_OK) status = report_step(g, "the recalibration was fitted", 1, error);
    wcut_fitted first = {0};
    if (status == WCUT_OK) status = wcut_model_fit(e, &e->at, &first, error);
    if (status == WCUT_OK) status = leave_droop_out(g, &first, error);
    if (status != WCUT_OK) return status;
    const wcut_model recalibrated = first.model;
    wcut_fitted_destroy(&first);

    /* everything later is linear about the recalibrated model; the scans' patches are made there */
    status = report_step(g, "recordings and scans were replayed", 2, error);
    if (status == WCUT_OK) status = wcut_evidence_predict(e, &recalibrated, true, error);

    /* columns of what differs from cut to cut (blocks, wires, zeros, friction) */
    if (status == WCUT_OK) status = wcut_scatter_create(e, error);
    if (status != WCUT_OK) return status;

    /* a little scatter to begin with; what there is of it is found by the search */
    double *missing = wcut_alloc((size_t)e->rows, sizeof *missing);
    if (!missing) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);
    wcut_evidence_residual(e, missing);
    wcut_variances_begin(&e->noise);
    wcut_evidence_whiten_scatter(e, missing);

    wcut_free(missing);
    return WCUT_OK;
}

/* ---- what was found, in words and numbers ---- */

static const wcut_candidate *chosen(const diagnosing *g) {
    return g->decision.chosen >= 0 && g->decision.kind != WCUT_VERDICT_NONE ? &g->search.candidate[g->decision.chosen]
                                                                            : NULL;
}

static bool names_effects(const diagnosing *g) { return chosen(g) && g->decision.kind != WCUT_VERDICT_UNKNOWN; }

static const wcut_fitted *final_fit(const diagnosing *g) {
    const wcut_fitted *outside = wcut_outside_fit(&g->outside);
    return names_effects(g) ? &chosen(g)->fit : outside ? outside : &g->search.none;
}

/* [1] of a and b: root mean square by which they come out off where an independent simulator of the same physics made
   the recordings (42 cases); they go together, the force at usual heats hardly changes */
#define MODEL_ERROR_A 0.012
#define MODEL_ERROR_B 0.004

static void add_found_effects(diagnosing *g, int candidate, bool present, double confidence) {
    wcut_diagnosis *d = g->out;
    const wcut_candidate *c = &g->search.candidate[candidate];
    for (int e = 0; e < c->fit.model.effects && d->effects < WCUT_DIAGNOSIS_EFFECTS; e++) {
        /* an effect that two candidates share is listed once */
        bool listed = false;
        for (int k = 0; k < d->effects; k++) listed = listed || d->effect[k].effect.kind == c->fit.model.effect[e].kind;
        if (listed) continue;
        wcut_found_effect_fill(&c->fit, e, c->left.slow, &d->effect[d->effects]);
        d->effect[d->effects].present = present;
        d->effect[d->effects++].confidence = confidence;
    }
}

/* what is there, but of no consequence for the cut */
static void report_small(diagnosing *g) {
    wcut_diagnosis *d = g->out;
    if (g->decision.small < 0) return;
    const wcut_candidate *c = &g->search.candidate[g->decision.small];
    wcut_small_effect *small = &d->small_effect;
    wcut_found_effect_fill(&c->fit, c->fit.model.effects - 1, c->left.slow, &small->found);
    small->found.present = true, small->found.confidence = d->confidence;
    small->gain = c->gain;
    wcut_small_effect_measure(g->evidence, &c->fit, small);
    d->small_effects = 1;
}

/* model: the part of the value that the simulators differ by */
static wcut_estimate positive(double x, double error, double slow, double model) {
    const double half = 1.96 * hypot(wcut_found_widen(error, 0, slow), model);
    return (wcut_estimate){exp(x), exp(x - half), exp(x + half)};
}

static void report_base(diagnosing *g) {
    wcut_diagnosis *d = g->out;

    /* the fit whose values are reported, and what it leaves as dispersion */
    const wcut_fitted *f = final_fit(g);
    const double slow = g->decision.adequacy;

    /* a and b are fitted as logarithms, so that their intervals are factors */
    d->a_job = g->job_model.a, d->b_job = g->job_model.b;
    d->a = positive(f->x[0], f->error[0], slow, MODEL_ERROR_A);
    d->b = positive(f->x[1], f->error[1], slow, MODEL_ERROR_B);

    /* the length change and the kerf have symmetric intervals at 95 % (1.96 sigma) */
    const double half = 1.96 * wcut_found_widen(f->error[2], 0, slow);
    d->length_change = (wcut_estimate){f->x[2], f->x[2] - half, f->x[2] + half};
    const double kerf = 1.96 * f->kerf_error;
    d->kerf = (wcut_estimate){f->kerf, f->kerf - kerf, f->kerf + kerf};

    /* noise per sample: a bin of 0.5 s is a mean, so its noise times the root of the samples in it */
    d->noise[WCUT_EVIDENCE_CHANNEL_SPEED] = d->noise[WCUT_EVIDENCE_CHANNEL_SCAN] = (double)NAN;
    const double bin = sqrt(WCUT_BIN_WIDTH / 0.05); /* of a sample at 20 Hz */
    d->noise[WCUT_EVIDENCE_CHANNEL_TENSION] = bin * (g->evidence->sigma[0] + g->evidence->sigma[1]) / 2;
    d->noise[WCUT_EVIDENCE_CHANNEL_ALPHA] = bin * DEGREES * (g->evidence->sigma[2] + g->evidence->sigma[4]) / 2;
    d->noise[WCUT_EVIDENCE_CHANNEL_BETA] = bin * DEGREES * (g->evidence->sigma[3] + g->evidence->sigma[5]) / 2;

    d->swift = wcut_evidence_swiftness(g->evidence);

    /* of scans, the noise of a point within its patch */
    for (int k = 0; k < g->cuts; k++)
        if (g->evidence->cut[k].patch.count > 0)
            d->noise[WCUT_EVIDENCE_CHANNEL_SCAN] = g->evidence->cut[k].patch.spread;
}

/* ---- ranking ---- */

/* a gain in the screen that chance reaches */
#define SCREEN_CHANCE 25.0

/* why an effect was screened alone and not fitted */
static const char *screened_why(const wcut_screened *f) {
    return f->gain < SCREEN_CHANCE ? "no more than chance"
           : f->size[0] < 1        ? "too small to matter"
                                   : "explains less, as the screen has it";
}

static int by_score(const void *a, const void *b) {
    const wcut_hypothesis *x = a, *y = b;
    return x->probability < y->probability ? 1 : x->probability > y->probability ? -1 : x->count - y->count;
}

static wcut_status rank(diagnosing *g) {
    wcut_diagnosis *d = g->out;
    const wcut_search *s = &g->search;

    /* room for the null hypothesis, every candidate and every effect that was only screened */
    d->hypothesis = wcut_alloc((size_t)s->count + 1 + WCUT_EFFECT_COUNT, sizeof *d->hypothesis);
    if (!d->hypothesis) return WCUT_NO_MEMORY;

    /* subtract the highest score before exp, so that nothing overflows */
    double max = 0, sum = 0;
    for (int k = -1; k < s->count; k++) max = fmax(max, wcut_candidate_score(s, k));

    /* posterior of each candidate from exp(score / 2), the null hypothesis (k = -1) among them */
    for (int k = -1; k < s->count; k++) {
        wcut_hypothesis *h = &d->hypothesis[d->hypotheses++];
        *h = (wcut_hypothesis){.adequacy = s->left.slow, .why = wcut_candidate_why(s, &g->decision, k)};
        h->probability = exp(fmax((wcut_candidate_score(s, k) - max) / 2, -700));
        sum += h->probability;
        if (k < 0) continue;
        const wcut_candidate *c = &s->candidate[k];

        /* at most two effects are shown */
        h->count = c->fit.model.effects < 2 ? c->fit.model.effects : 2;
        for (int e = 0; e < h->count; e++) h->effect[e] = c->fit.model.effect[e];
        h->parameters = c->fit.count, h->gain = c->gain, h->held_out = c->held_out, h->adequacy = c->left.slow;
    }

    /* normalise to a sum of 1 */
    for (int k = 0; k < d->hypotheses; k++) d->hypothesis[k].probability /= sum;

    /* effects that the screen alone set aside, with the reason in words */
    for (int k = 0; k < s->screened; k++) { /* what the screen alone set aside */
        bool full = false;
        for (int j = 0; j < s->count; j++)
            full = full || (s->candidate[j].effects == 1 &&
                            s->candidate[j].fit.model.effect[0].kind == s->single[k].effect[0].kind);
        if (full) continue;
        d->hypothesis[d->hypotheses++] = (wcut_hypothesis){.count = 1,
                                                           .effect = {s->single[k].effect[0]},
                                                           .parameters = 1,
                                                           .gain = s->single[k].gain,
                                                           .adequacy = s->left.slow,
                                                           .why = screened_why(&s->single[k])};
    }
    qsort(d->hypothesis, (size_t)d->hypotheses, sizeof *d->hypothesis, by_score);

    return WCUT_OK;
}

/* ---- traces ---- */

static bool trace_of(diagnosing *g, int cut, int signal, wcut_residual_trace *t) {
    const wcut_evidence_cut *c = &g->evidence->cut[cut];

    /* two tensions, then alpha and beta of either side; angles in degrees */
    const size_t n = (size_t)c->bins;
    const wcut_evidence_channel channels[] = {WCUT_EVIDENCE_CHANNEL_TENSION, WCUT_EVIDENCE_CHANNEL_ALPHA,
                                              WCUT_EVIDENCE_CHANNEL_BETA};
    const wcut_evidence_channel channel = channels[signal < 2 ? 0 : signal % 2 ? 2 : 1];
    const double unit = signal < 2 ? 1 : DEGREES;
    *t = (wcut_residual_trace){
        .cut = cut, .channel = channel, .count = c->bins, .noise = unit * g->evidence->sigma[signal]};
    snprintf(t->column, sizeof t->column, "%s", wcut_channel_name((wcut_channel)(WCUT_CHANNEL_TENSION_A + signal)));

    /* times, stations, and the four curves of this signal */
    t->time = wcut_copy(c->middle, n, sizeof(double));
    t->station = wcut_copy(c->station, n, sizeof(double));
    t->measured = wcut_alloc(n, sizeof(double));
    t->before = wcut_alloc(n, sizeof(double));
    t->recalibrated = wcut_alloc(n, sizeof(double));
    t->after = wcut_alloc(n, sizeof(double));
    if (!t->time || !t->station || !t->measured || !t->before || !t->recalibrated || !t->after) return false;

    /* bins that were left out as events still belong into the picture */
    const double *kept = g->outside.kept; /* with the bins that were left out */
    int before_row = 0;                   /* rows before there were patches */
    for (int k = 0; k < cut; k++) before_row += WCUT_SIGNALS * g->evidence->cut[k].bins;

    /* residuals in the channel's unit: before, recalibrated and after */
    for (int i = 0; i < c->bins; i++) {
        const int at = signal * c->bins + i;
        t->before[i] = unit * g->before[before_row + at];
        const double measured = kept ? kept[c->row + at] : c->measured[signal][i];
        t->measured[i] = unit * measured;
        t->recalibrated[i] = unit * (measured - g->search.none.predicted[c->row + at]);
        t->after[i] = unit * (measured - final_fit(g)->predicted[c->row + at]);
    }

    return true;
}

static wcut_status trace(diagnosing *g) {
    wcut_diagnosis *d = g->out;
    d->trace = wcut_alloc((size_t)g->cuts * WCUT_SIGNALS, sizeof *d->trace);
    if (!d->trace) return WCUT_NO_MEMORY;
    for (int cut = 0; cut < g->cuts; cut++)
        for (int s = 0; s < WCUT_SIGNALS && g->evidence->cut[cut].bins > 0; s++)
            if (!trace_of(g, cut, s, &d->trace[d->traces++])) return WCUT_NO_MEMORY;
    return WCUT_OK;
}

/* ---- what follows ---- */

static const wcut_job *first_job(const diagnosing *g) {
    for (int k = 0; k < g->cuts; k++)
        if (g->evidence->cut[k].bins > 0) return g->evidence->cut[k].job;
    return NULL;
}

/* the model that the table calls "after", as a correction of jobs; and the first cut's job with it */
static wcut_status correct(diagnosing *g) {
    const wcut_fitted *f = final_fit(g);
    wcut_diagnosis *d = g->out;
    d->correction = wcut_fitted_correction(f);
    if (d->kind == WCUT_VERDICT_UNKNOWN && !wcut_outside_fit(&g->outside)) {
        snprintf(
            d->withheld, sizeof d->withheld,
            "the verdict is unknown and nothing was modelled, so the recalibration may compensate for what was not "
            "found");
        return WCUT_OK;
    }

    /* the corrected job is kept only if the whole correction was applied */
    wcut_job *job = wcut_job_copy(first_job(g));
    if (!job) return WCUT_NO_MEMORY;
    const wcut_status status = wcut_correction_apply(&d->correction, job, NULL);
    if (status == WCUT_OK)
        d->improved = job;
    else
        wcut_job_destroy(job);
    return status;
}

static wcut_status propose(diagnosing *g, wcut_error *error) {
    const wcut_decision *v = &g->decision;
    wcut_diagnosis *d = g->out;
    const wcut_empirical *m = &g->outside.empirical;
    const bool terms = v->kind == WCUT_VERDICT_UNKNOWN && m->rivals > 0;
    if (v->kind != WCUT_VERDICT_AMBIGUOUS && !terms) return WCUT_OK;
    const wcut_model *a = terms ? &m->fit.model : &g->search.candidate[v->rival[0]].fit.model;
    wcut_model other = *a;
    if (terms) other.effect[m->rival[0].instead_of] = m->rival[0].effect;
    const wcut_model *b = terms ? &other : &g->search.candidate[v->rival[1]].fit.model;
    wcut_job job = *first_job(g);
    job.force_law.a = g->search.none.model.a, job.force_law.b = g->search.none.model.b;
    double separation;
    const wcut_status status = wcut_experiment_choose(&job, a->effects, a->effect, b->effects, b->effect, &g->stop,
                                                      &d->next_experiment, &separation, d->next_reason, error);
    if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    if (status != WCUT_OK) snprintf(d->next_reason, sizeof d->next_reason, "no cut could be predicted");
    return WCUT_OK;
}

static wcut_status prove(diagnosing *g, wcut_error *error) {
    wcut_diagnosis *d = g->out;
    snprintf(d->unproven, sizeof d->unproven, "it was left out");
    if (!g->options->proof) return WCUT_OK;
    wcut_status status =
        wcut_cross_validation_create(g->evidence, &g->search.none, final_fit(g), g->options->seed, &g->proof, error);
    if (status == WCUT_OK) status = wcut_black_box_run(g->evidence, g->options->seed, &g->proof);
    if (status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    if (status != WCUT_OK) { /* what was found stands without it, and the limits say so */
        snprintf(d->unproven, sizeof d->unproven, "%.110s", error ? error->text : wcut_status_text(status));
        return WCUT_OK;
    }
    d->unproven[0] = 0;
    memcpy(d->score, g->proof.score, sizeof d->score);
    memcpy(d->held_out_score, g->proof.held_out_score, sizeof d->held_out_score);
    for (int k = 0; k < g->cuts; k++) d->held_out[k] = g->evidence->cut[k].bins > 0;
    return WCUT_OK;
}

/* the control: plain least squares, columns along the recorded motion, white noise, the likeliest single effect */
static wcut_status try_naive(diagnosing *g, wcut_error *error) {
    wcut_diagnosis *d = g->out;
    if (!g->options->naive) return WCUT_OK;

    /* the recorded motion itself as exogenous, and no slow noise: what plain least squares assume */
    wcut_evidence *e = NULL;
    wcut_screen screen = {0};
    wcut_fitted plain = {0};
    wcut_status status = wcut_evidence_create(g->cuts, g->cut, true, g->options->threads, &g->stop, &e, error);
    if (status == WCUT_OK) {
        memset(&e->noise, 0, sizeof e->noise);
        status = wcut_evidence_predict(e, &g->evidence->at, false, error);
    }

    /* the recalibration, then every single effect of the library, both by plain least squares */
    if (status == WCUT_OK) status = wcut_model_fit(e, &e->at, &plain, error);
    if (status == WCUT_OK)
        status = wcut_screen_create(e, &plain.model, plain.open, g->options->without, &screen, error);

    /* the most likely single effect, named if it passes the usual test */
    wcut_screened *found = status == WCUT_OK ? wcut_alloc((size_t)screen.groups, sizeof *found) : NULL;
    if (found) snprintf(d->naive, sizeof d->naive, "nothing");
    if (found && wcut_screen_singles(&screen, found) > 0) {
        /* likelihood ratio at one part in ten thousand, as a textbook has it */
        d->naive_false = found[0].gain > wcut_chi_square_quantile(0.9999, 1);
        if (d->naive_false)
            snprintf(d->naive, sizeof d->naive, "%s, likelihood ratio %.0f",
                     wcut_effect_view(found[0].effect[0].kind)->name, found[0].gain);
    }

    /* release everything; only want of memory and a request to stop end the diagnosis */
    wcut_free(found);
    wcut_fitted_destroy(&plain);
    wcut_screen_destroy(&screen);
    wcut_evidence_destroy(e);
    if (status == WCUT_OK || status == WCUT_NO_MEMORY || status == WCUT_INTERRUPTED) return status;
    /* a control that does not come to its end takes nothing from the diagnosis */
    snprintf(d->naive, sizeof d->naive, "cannot be said: %.60s", error ? error->text : wcut_status_text(status));

    return WCUT_OK;
}

static wcut_status locate_events(diagnosing *g, wcut_error *error) {
    wcut_diagnosis *d = g->out;
    d->mismatch = wcut_alloc(WCUT_MISMATCHES, sizeof *d->mismatch);
    if (!d->mismatch) return WCUT_NO_MEMORY;
    wcut_status status = wcut_mismatch_locate(g->evidence, g->search.none.residual, &d->mismatches, d->mismatch, error);
    if (status != WCUT_OK || d->mismatches > 0 || d->kind != WCUT_VERDICT_UNKNOWN) return status;

    /* scatter may have taken all of it, beyond what is ordinary: then the place is in what it took */
    double *open = wcut_alloc((size_t)g->evidence->rows, sizeof *open);
    if (!open) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", g->evidence->rows);
    wcut_evidence_whiten(g->evidence, g->search.none.open, g->search.none.open, open);
    status = wcut_mismatch_locate(g->evidence, open, &d->mismatches, d->mismatch, error);
    wcut_free(open);
    return status;
}

/* a term as one quantity that the force follows */
static void add_dependence(wcut_diagnosis *d, const wcut_found_effect *f, double gain) {
    wcut_dependence *x = &d->dependence[d->dependences++];
    *x = (wcut_dependence){.channel = WCUT_EVIDENCE_CHANNEL_TENSION, .coefficient = f->parameter[0], .gain = gain};
    char formula[80];
    wcut_term_formula(&f->effect, formula, sizeof formula);
    snprintf(x->quantity, sizeof x->quantity, "%.39s", formula);
}

static void report_terms(diagnosing *g) {
    const wcut_empirical *m = &g->outside.empirical;
    wcut_modelled *out = &g->out->modelled;

    /* each empirical term as a found effect: its values, then those that were fitted, with intervals */
    for (int e = 0; m->fit.residual && e < m->fit.model.effects && out->terms < WCUT_MODELLED_TERMS; e++) {
        wcut_found_effect *f = &out->term[out->terms++];
        wcut_found_effect_fill(&m->fit, e, m->left.slow, f);
        f->present = true;

        /* how a term depends on which cut is left out */
        add_dependence(g->out, f, m->held_out);
    }

    /* terms that explain as much as a chosen one, as formulas */
    for (int r = 0; r < m->rivals && out->rivals < WCUT_MODELLED_RIVALS; r++)
        wcut_term_formula(&m->rival[r].effect, out->rival[out->rivals++], sizeof out->rival[0]);
}

/* look into an unknown verdict: terms that model it, events that bend it */
static wcut_status model(diagnosing *g, wcut_error *error) {
    wcut_diagnosis *d = g->out;
    if (g->decision.kind != WCUT_VERDICT_UNKNOWN) return WCUT_OK;
    d->dependence = wcut_alloc(WCUT_MODELLED_TERMS, sizeof *d->dependence);
    if (!d->dependence) return wcut_fail(error, WCUT_NO_MEMORY, "no memory for what was modelled");
    wcut_status status = wcut_outside_find(g->evidence, &g->search.none, &g->outside, error);
    if (status == WCUT_NOT_CONVERGED) status = WCUT_OK; /* nothing could be modelled */
    if (status != WCUT_OK || !wcut_outside_fit(&g->outside)) return status;
    report_terms(g);
    wcut_modelled *m = &d->modelled;
    const wcut_events *events = &g->outside.events;
    for (int k = 0; k < events->count && m->events < WCUT_MODELLED_EVENTS; k++)
        m->event[m->events++] = events->event[k];
    m->recalibrated = events->recalibrated, m->after = events->after;
    d->adequacy = g->outside.left.slow;
    report_base(g);
    return wcut_adequacy_p_value(g->evidence, d->adequacy, NULLS, g->options->seed, &d->adequacy_p);
}

/* intervals of what will be reported by its profile; without it those of the curvature stand, and the limits say so */
static wcut_status profile(diagnosing *g, bool searched, wcut_error *error) {
    const wcut_decision *v = &g->decision;
    const bool rivals = v->kind == WCUT_VERDICT_AMBIGUOUS;
    const bool small = v->small >= 0;
    const int count = rivals ? v->rivals : names_effects(g) || small;
    wcut_status status = searched ? WCUT_OK : WCUT_INTERRUPTED;
    for (int r = 0; status == WCUT_OK && r < count; r++) {
        const int candidate = rivals ? v->rival[r] : small ? v->small : v->chosen;
        status = wcut_fitted_profile(g->evidence, &g->search.candidate[candidate].fit, error);
    }
    if (status == WCUT_NO_MEMORY) return status;
    if (count > 0 && status != WCUT_OK)
        snprintf(g->out->unprofiled, sizeof g->out->unprofiled, "%.110s",
                 status == WCUT_INTERRUPTED ? "interrupted"
                 : error                    ? error->text
                                            : wcut_status_text(status));
    return WCUT_OK;
}

static wcut_status decide(diagnosing *g, bool searched, wcut_error *error) {
    wcut_diagnosis *d = g->out;
    g->decision = wcut_search_decide(&g->search);
    const wcut_decision *v = &g->decision;
    d->kind = v->kind, d->confidence = v->confidence, d->adequacy = v->adequacy;
    d->confidence_by = v->confidence_by;
    const wcut_status status = profile(g, searched, error);
    if (status != WCUT_OK) return status;
    if (v->kind == WCUT_VERDICT_AMBIGUOUS)
        for (int r = 0; r < v->rivals; r++) add_found_effects(g, v->rival[r], false, v->confidence / v->rivals);
    else if (names_effects(g))
        add_found_effects(g, v->chosen, true, v->confidence);
    report_small(g);
    d->form_open = d->effects > 0 && d->effect[0].present && !wcut_search_tells_form(&g->search, v->chosen);
    report_base(g);
    if (wcut_rig_fill(g->evidence, final_fit(g), d) != WCUT_OK) return WCUT_NO_MEMORY;
    return wcut_adequacy_p_value(g->evidence, d->adequacy, NULLS, g->options->seed, &d->adequacy_p);
}

/* A search that was cut short has no verdict: what was not tried is not ruled out. Later, only what follows is missing. */
static void tell_stop(diagnosing *g, bool searched) {
    wcut_diagnosis *d = g->out;
    char found[WCUT_DIAGNOSIS_TEXT];
    const int room = WCUT_DIAGNOSIS_TEXT - 200; /* beside the words here and a stage */
    const bool named = d->effects > 0;
    d->interrupted = true;
    snprintf(d->stopped, sizeof d->stopped, "while %s", g->stop.stage);
    snprintf(found, sizeof found, "%s", d->sentence);
    if (searched) {
        snprintf(d->sentence, sizeof d->sentence, "%.*s Stopped on request %s: the rest of the report is missing.",
                 room, found, d->stopped);
        return;
    }
    d->confidence = 0;
    for (int k = 0; k < d->effects; k++) d->effect[k].confidence = 0;
    if (!named) d->kind = WCUT_VERDICT_UNKNOWN;
    snprintf(d->sentence, sizeof d->sentence, "Stopped on request %s, before there was a verdict; so far: %.*s",
             d->stopped, room, named ? found : "nothing that was tried explains more than recalibration does.");
}

/* searched: to its end */
static wcut_status conclude_diagnosis(diagnosing *g, bool searched, wcut_error *error) {
    wcut_status status = decide(g, searched, error);
    wcut_status looked = WCUT_OK; /* a search for terms that was stopped takes nothing from the rest */

    /* only a search that came to its end allows to look outside the library */
    if (status == WCUT_OK && searched) looked = report_step(g, "terms outside the library were sought", OUTSIDE, error);
    if (status == WCUT_OK && searched && looked == WCUT_OK) looked = model(g, error);
    if (status == WCUT_OK && looked != WCUT_INTERRUPTED) status = looked;

    /* the report: hypotheses, residuals over time, the corrected job */
    if (status == WCUT_OK) status = rank(g);
    if (status == WCUT_OK) status = trace(g);
    if (status == WCUT_OK) status = correct(g);

    /* what follows an interruption is not run */
    if (status == WCUT_OK && (!searched || looked == WCUT_INTERRUPTED)) status = WCUT_INTERRUPTED;
    if (status == WCUT_OK) status = locate_events(g, error);

    /* where in space and time the misfit is, as a picture */
    if (status == WCUT_OK)
        status = wcut_view_fill(g->evidence, final_fit(g), g->out->mismatches, g->out->mismatch, &g->out->view, error);

    /* forecasts of cuts left out, the next experiment, and the control, each as one step of progress */
    if (status == WCUT_OK) status = report_step(g, "the forward proof was run", PROOF, error);
    if (status == WCUT_OK) status = prove(g, error);
    if (status == WCUT_OK) status = report_step(g, "the next experiment was chosen", EXPERIMENT, error);
    if (status == WCUT_OK) status = propose(g, error);
    if (status == WCUT_OK) status = report_step(g, "plain least squares were run beside it", CONTROL, error);
    if (status == WCUT_OK) status = try_naive(g, error);

    /* words come last, because they tell of everything above */
    if (status == WCUT_OK || status == WCUT_INTERRUPTED) {
        wcut_diagnosis_sentence(g->out);
        wcut_modelled_tell(g->out);
        if (searched) wcut_cut_length_report(g->out);
        if (!wcut_contradictions_report(&g->redundancy, searched, g->out)) status = WCUT_NO_MEMORY;
        if (status == WCUT_INTERRUPTED) tell_stop(g, searched);
        if (!wcut_diagnosis_limits(g->out, g->cuts, g->cut, g->test_cuts, g->calibration)) status = WCUT_NO_MEMORY;
    }

    return status;
}

/* a blade has no wire to replay: its forces are diagnosed by themselves, the diagnosis is handed over whole or not */
static wcut_status diagnose_blade(diagnosing *g, const wcut_diagnosis_cut *cut, wcut_diagnosis **diagnosis,
                                  wcut_error *error) {
    const wcut_status status = wcut_blade_diagnose(g->cuts, cut, g->options, &g->stop, g->out, error);
    if (status == WCUT_OK) {
        *diagnosis = g->out;
        g->out = NULL;
    }
    wcut_diagnosis_destroy(g->out);
    return status;
}

wcut_status wcut_diagnosis_create(int cuts, const wcut_diagnosis_cut *cut, int test_cuts,
                                  const wcut_test_cut *calibration, const wcut_diagnosis_options *options,
                                  wcut_progress progress, void *context, wcut_diagnosis **diagnosis,
                                  wcut_error *error) {
    /* check all arguments before any work */
    const wcut_diagnosis_options o = options ? *options : wcut_diagnosis_options_default();
    wcut_status status = wcut_diagnosis_check(cuts, cut, test_cuts, calibration, &o, diagnosis, error);
    if (status != WCUT_OK) return status;
    diagnosing g = {.cuts = cuts, .test_cuts = test_cuts, .calibration = calibration, .options = &o};

    /* begin the progress; the decision has no candidate yet */
    wcut_stop_begin(&g.stop, progress, context, STEPS);
    g.decision.chosen = g.decision.small = -1;
    g.out = wcut_alloc(1, sizeof *g.out);
    if (g.out)
        g.out->cuts = cuts, g.out->view.cut = -1, g.out->held_out = wcut_alloc((size_t)cuts, sizeof *g.out->held_out);

    if (wcut_diagnosis_is_of_blade(cuts, cut) && g.out && g.out->held_out) {
        wcut_stop_begin(&g.stop, progress, context, WCUT_BLADE_STEPS);
        return diagnose_blade(&g, cut, diagnosis, error);
    }

    /* what needs no physics, then evidence and search */
    status = g.out && g.out->held_out ? wcut_redundancy_create(cuts, cut, o.still, &g.redundancy, error)
                                      : wcut_fail(error, WCUT_NO_MEMORY, "no memory");
    g.cut = g.redundancy.cut;
    if (status == WCUT_OK) status = prepare_diagnosis(&g, error);
    if (status == WCUT_OK) status = wcut_search_run(g.evidence, o.without, &g.search, error);
    const bool recalibrated = g.search.none.predicted != NULL; /* the least that is worth handing out */

    /* conclude from what there is, even if the search was stopped after the recalibration */
    if (status == WCUT_OK || (status == WCUT_INTERRUPTED && recalibrated))
        status = conclude_diagnosis(&g, status == WCUT_OK, error);

    /* the text says where it was stopped and whether there is a result */
    if (status == WCUT_INTERRUPTED)
        wcut_fail(error, status, "stopped on request while %s%s", g.stop.stage,
                  recalibrated ? "; what was found up to then is marked as cut short"
                               : ", before anything was found: nothing is written");

    /* hand the diagnosis over: after an interruption too, if there is at least a recalibration */
    if (status == WCUT_OK || (status == WCUT_INTERRUPTED && recalibrated)) {
        *diagnosis = g.out;
        g.out = NULL;
    }

    wcut_diagnosis_destroy(g.out);
    wcut_cross_validation_destroy(&g.proof);
    wcut_search_destroy(&g.search);
    wcut_outside_destroy(&g.outside);
    wcut_evidence_destroy(g.evidence);
    wcut_redundancy_destroy(&g.redundancy);
    wcut_free(g.before);
    return status;
}
