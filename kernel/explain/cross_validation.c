/* The forward proof: every cut predicted by models that were fitted on the other cuts, and the figures of it. */
#include "explain/cross_validation.h"

#include <stdlib.h>
#include <string.h>
#include <wirecut/cut.h>
#include <wirecut/history.h>
#include <wirecut/replay.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/threads.h"
#include "base/vec3.h"

enum { MODELS = WCUT_EVIDENCE_MODEL_BLACK_BOX };

/* the solver's tolerance: tensions move by a thousandth of a sensor's noise against 1e-10 */
#define TOLERANCE 1e-6

/* [mm] that a wire is longer than the way between its mounts, at least */
#define LONGER 1e-3

/* [1] of the target: a tension that the loop holds */
#define SETTLED 0.1

/* ---- forecasts ---- */

static int all_bins(const wcut_evidence *e) {
    int bins = 0;
    for (int k = 0; k < e->cuts; k++) bins += e->cut[k].bins;
    return bins;
}

static bool forecast_create(const wcut_evidence *e, wcut_forecast *f) {
    const size_t rows = (size_t)e->rows, speeds = 2 * (size_t)all_bins(e);
    f->row = wcut_alloc(rows, sizeof(double));
    f->speed = wcut_alloc(speeds, sizeof(double));
    if (!f->row || !f->speed) return false;
    for (size_t i = 0; i < rows; i++) f->row[i] = (double)NAN;
    for (size_t i = 0; i < speeds; i++) f->speed[i] = (double)NAN;
    return true;
}

static void forecast_destroy(wcut_forecast *f) {
    wcut_free(f->row);
    wcut_free(f->speed);
}

void wcut_cross_validation_destroy(wcut_cross_validation *p) {
    forecast_destroy(&p->measured);
    for (int m = 0; m < MODELS; m++) forecast_destroy(&p->in_sample[m]), forecast_destroy(&p->held_out[m]);
    *p = (wcut_cross_validation){.score = {{{0}}}};
}

/* where a cut's bins of speed begin */
static double *speed_bins(const wcut_evidence *e, const wcut_forecast *f, int cut) {
    size_t at = 0;
    for (int k = 0; k < cut; k++) at += 2 * (size_t)e->cut[k].bins;
    return f->speed + at;
}

/* mean of samples in each bin; NaN where fewer than half of the usual number are there */
static void bin_speed(const wcut_evidence_cut *c, const double *value, const unsigned char *present, double *out) {
    const wcut_column *time = &c->recording->channel[WCUT_CHANNEL_TIME];
    double max = 0, sum = 0, count = 0;
    for (int pass = 0; pass < 2; pass++) {
        int bin = -1;
        for (int i = 0; i <= c->recording->samples; i++) {
            const bool end = i == c->recording->samples;
            const double place = end ? HUGE_VAL : floor((time->value[i] - c->from) / WCUT_BIN_WIDTH);
            if (place != bin) { /* samples come in order of time */
                if (pass == 0) max = fmax(max, count);
                if (pass == 1 && bin >= 0) out[bin] = count > 0 && 2 * count >= max ? sum / count : (double)NAN;
                sum = count = 0;
                bin = place >= 0 && place < c->bins ? (int)place : -1;
            }
            if (bin >= 0 && !end && (!present || present[i])) sum += value[i], count++;
        }
    }
}

/* A planned run says the speed at the target tension: where the loop is not there yet, or no longer, the recorded speed
   answers another question. speed: 2 x bins, both sides. */
static void keep_settled(const wcut_evidence_cut *c, double *speed) {
    const double target = c->job->tension;
    for (int i = 0; i < c->bins; i++) {
        const double mean = (c->measured[0][i] + c->measured[1][i]) / 2;
        if (!(fabs(mean - target) <= SETTLED * target)) speed[i] = speed[c->bins + i] = (double)NAN;
    }
}

/* what was measured, in the evidence's rows and in bins of speed */
static void fill_measured(const wcut_evidence *e, wcut_forecast *f) {
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        if (c->bins == 0) continue;
        for (int s = 0; s < WCUT_SIGNALS; s++)
            memcpy(f->row + c->row + (ptrdiff_t)s * c->bins, c->measured[s], (size_t)c->bins * sizeof(double));
        for (int i = 0; i < c->patch.count; i++) f->row[c->row + WCUT_SIGNALS * c->bins + i] = c->patch.distance[i];
        for (int side = 0; side < 2; side++) {
            const wcut_column *column = &c->recording->channel[WCUT_CHANNEL_SPEED_A + side];
            bin_speed(c, column->value, column->present, speed_bins(e, f, k) + (ptrdiff_t)side * c->bins);
        }
        keep_settled(c, speed_bins(e, f, k));
    }
}

/* ---- one cut under one model ---- */

/* a model of a cut: its job, what instruments and face make of it, and half of the kerf [mm, mm m^2/J] */
typedef struct subject {
    wcut_model model;
    double kerf, kerf_per_q;
    bool own; /* the job as it is */
} subject;

/* the job's own effects that act behind the step; those of the step come with the job */
static subject own_subject(const wcut_job *job) {
    subject s = {.kerf = job->kerf_width, .kerf_per_q = job->kerf_per_q, .own = true};
    s.model = (wcut_model){.a = job->force_law.a, .b = job->force_law.b};
    for (int k = 0; k < job->effect_count && s.model.effects < WCUT_DIAGNOSIS_EFFECTS; k++)
        if (wcut_effect_view(job->effect[k].kind)->place != WCUT_EFFECT_PLACE_STEP)
            s.model.effect[s.model.effects++] = job->effect[k];
    return s;
}

static wcut_job job_of(const wcut_evidence *e, const subject *s, int cut, wcut_effect *effect) {
    if (s->own) return *e->cut[cut].job;
    wcut_job job = wcut_model_job(e, &s->model, cut, effect);
    job.wire_length -= e->cut[cut].own_length; /* a forecast does not know it */
    return job;
}

static wcut_status forecast_motion(const wcut_evidence *e, int cut, const subject *s, const wcut_job *job,
                                   wcut_forecast *f, wcut_error *error) {
    const wcut_evidence_cut *c = &e->cut[cut];
    wcut_response d = {0};
    wcut_status status = wcut_response_run(job, WCUT_NODES_FINE, &c->recorded, false, e->stop, &d, error);
    if (status == WCUT_OK) {
        status = wcut_evidence_bin_recorded(c, &s->model, &d, f->row + c->row);
        if (status != WCUT_OK) wcut_fail(error, status, "the instruments of a prediction");
    }
    wcut_response_destroy(&d);
    return status;
}

static wcut_status forecast_face(const wcut_evidence *e, int cut, const subject *s, const wcut_job *job,
                                 wcut_forecast *f, wcut_error *error) {
    const wcut_evidence_cut *c = &e->cut[cut];
    if (c->patch.count == 0) return WCUT_OK;
    wcut_response d = {0};
    double *rows = wcut_alloc((size_t)e->rows, sizeof *rows),
           *face = f->row + c->row + (ptrdiff_t)WCUT_SIGNALS * c->bins;
    wcut_status status = rows ? wcut_response_run(job, WCUT_NODES_COARSE, &c->exogenous, true, e->stop, &d, error)
                              : wcut_fail(error, WCUT_NO_MEMORY, "no memory for %d rows", e->rows);
    if (status == WCUT_OK) {
        status = wcut_evidence_rows(e, cut, &s->model, &d, rows);
        if (status != WCUT_OK) wcut_fail(error, status, "the face of a prediction");
    }
    for (int i = 0; status == WCUT_OK && i < c->patch.count; i++)
        face[i] = rows[c->row + WCUT_SIGNALS * c->bins + i] - (s->kerf + s->kerf_per_q * c->patch.q_eff[i]) / 2;
    wcut_response_destroy(&d);
    wcut_free(rows);
    return status;
}

/* the speed of a tension-driven run; where there is no such run, or it ends early, the bins stay NaN */
static wcut_status forecast_speed(const wcut_evidence *e, int cut, const wcut_job *job, wcut_forecast *f,
                                  wcut_error *error) {
    const wcut_evidence_cut *c = &e->cut[cut];

    /* an excitation programme moves the mounts by itself, so that there is no plain speed to forecast */
    if (job->dither_count > 0 || job->heat_step_count > 0) return WCUT_OK;

    /* the plan: the job run tension-driven with the fine wire, at the diagnosis' tolerance */
    wcut_job planned = *job;
    planned.nodes = WCUT_NODES_FINE;
    wcut_cut_options options = wcut_cut_options_default();
    options.tolerance = TOLERANCE;
    wcut_setup *setup = NULL;
    wcut_history *history = NULL;
    wcut_prediction *prediction = NULL;
    wcut_status status = wcut_setup_create(&planned, &options, &setup, error);
    if (status != WCUT_OK) return status;

    /* a run that ends early still has a history, whose bins are used */
    status = wcut_setup_run(setup, wcut_stop_progress, e->stop, &history, error);
    if (history && status != WCUT_INTERRUPTED) status = wcut_prediction_plan(history, c->recording, &prediction, error);

    /* the speeds of both mounts in the bins of this cut */
    for (int side = 0; prediction && side < 2; side++)
        bin_speed(c, prediction->value[side], prediction->present, speed_bins(e, f, cut) + (ptrdiff_t)side * c->bins);

    wcut_prediction_destroy(prediction);
    wcut_history_destroy(history);
    wcut_setup_destroy(setup);
    return status == WCUT_NOT_CONVERGED ? WCUT_OK : status;
}

static wcut_status forecast_cut(const wcut_evidence *e, int cut, const subject *s, wcut_forecast *f,
                                wcut_error *error) {
    wcut_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    const wcut_job job = job_of(e, s, cut, effect);
    wcut_status status = forecast_motion(e, cut, s, &job, f, error);
    if (status == WCUT_OK) status = forecast_face(e, cut, s, &job, f, error);
    if (status == WCUT_OK) status = forecast_speed(e, cut, &job, f, error);
    return status;
}

/* ---- all cuts under all models ---- */

/* [mm] registration of a scan */
#define SCAN_SHIFT 0.25

/* mean of what scans but those of cut `but` lie below a forecast without kerf, with the prior of the fit */
static double other_kerf(const wcut_evidence *e, int but, const double *distance, const double *face) {
    const double own = 1 / (WCUT_KERF_SPREAD * WCUT_KERF_SPREAD), other = 1 / (4 * SCAN_SHIFT * SCAN_SHIFT);
    double sum = own * WCUT_KERF, weight = own;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        if (k == but || c->patch.count == 0) continue;
        const int row = c->row + WCUT_SIGNALS * c->bins;
        double below = 0;
        for (int i = 0; i < c->patch.count; i++) below += (face[row + i] - distance[row + i]) / c->patch.count;
        sum += other * 2 * below, weight += other;
    }
    return sum / weight;
}

typedef struct task {
    int cut, model;
    bool held_out;
} task;

/* [mm] the change of length that leaves every wire longer than the way between its mounts: a fit that has not seen a cut
   may ask for less */
static double min_change(const wcut_evidence *e) {
    double min = -HUGE_VAL;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_job *job = e->cut[k].bins > 0 ? e->cut[k].job : NULL;
        for (int j = 0; job && j < job->stations; j++)
            min = fmax(min, vec3_distance(job->mount_a[j], job->mount_b[j]) + LONGER - job->wire_length);
    }
    return fmin(min, 0);
}

static subject subject_of(const wcut_evidence *e, const task *t, const wcut_fitted *const *fitted) {
    if (t->model == WCUT_EVIDENCE_MODEL_BEFORE) return own_subject(e->cut[t->cut].job);
    const wcut_fitted *f = fitted[t->model];
    subject s = {.model = f->model, .kerf = isfinite(f->kerf) ? f->kerf : 0};
    if (!t->held_out) return s;
    s.model = wcut_fitted_model(f, f->without + (size_t)t->cut * (size_t)(WCUT_BASE + f->count));
    s.model.length_change = fmax(s.model.length_change, min_change(e));
    s.kerf = 0; /* from the other scans, once they are predicted */
    return s;
}

/* the kerf of held-out faces: the forecasts in sample of the other scans, without theirs, say it */
static void apply_kerf(const wcut_evidence *e, const double *distance, const wcut_forecast *in_sample, double kerf,
                       wcut_forecast *held_out, double *room) {
    for (int i = 0; i < e->rows; i++) room[i] = in_sample->row[i] + kerf / 2;
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        const double other = c->patch.count > 0 ? other_kerf(e, k, distance, room) : 0;
        for (int i = 0; i < c->patch.count; i++) held_out->row[c->row + WCUT_SIGNALS * c->bins + i] -= other / 2;
    }
}

static void copy_forecast(const wcut_evidence *e, const wcut_forecast *from, wcut_forecast *to) {
    memcpy(to->row, from->row, (size_t)e->rows * sizeof(double));
    memcpy(to->speed, from->speed, 2 * (size_t)all_bins(e) * sizeof(double));
}

static wcut_status forecast_all(const wcut_evidence *e, const wcut_fitted *const *fitted, wcut_cross_validation *p,
                                wcut_error *error) {
    /* where no effect was named, the third model equals the second and is not run again */
    const int models = fitted[WCUT_EVIDENCE_MODEL_AFTER] == fitted[WCUT_EVIDENCE_MODEL_RECALIBRATED]
                           ? WCUT_EVIDENCE_MODEL_AFTER
                           : MODELS;
    const int tasks = 2 * models * e->cuts;
    wcut_error *failed = wcut_alloc((size_t)tasks, sizeof *failed);
    double *room = wcut_alloc((size_t)e->rows, sizeof *room);
    wcut_status status = failed && room ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for the proof");

    /* each task writes into its own cut, model and error, so that the result does not depend on the threads */
    if (status == WCUT_OK) {
#pragma omp parallel for num_threads(wcut_threads(e->threads)) schedule(dynamic, 1)
        for (int i = 0; i < tasks; i++) {
            /* each cut and model is run twice: fitted on all cuts, and fitted on all but this one */
            const task t = {.cut = i / (2 * models), .model = i / 2 % models, .held_out = i % 2};
            if (e->cut[t.cut].bins == 0 || (t.held_out && t.model == WCUT_EVIDENCE_MODEL_BEFORE)) continue;
            const subject s = subject_of(e, &t, fitted);
            wcut_forecast *f = t.held_out ? &p->held_out[t.model] : &p->in_sample[t.model];
            failed[i].status = forecast_cut(e, t.cut, &s, f, &failed[i]);
        }
    }

    /* report the first failure in the order of the cuts */
    for (int i = 0; status == WCUT_OK && i < tasks; i++)
        if (failed[i].status != WCUT_OK)
            status = wcut_fail(error, failed[i].status, "cut %d: %s", i / (2 * models) + 1, failed[i].text);

    /* a scan's patches come lower by half the kerf that the other scans show */
    for (int m = WCUT_EVIDENCE_MODEL_RECALIBRATED; status == WCUT_OK && m < models; m++)
        if (isfinite(fitted[m]->kerf))
            apply_kerf(e, p->measured.row, &p->in_sample[m], fitted[m]->kerf, &p->held_out[m], room);

    /* the model before was fitted to nothing, so that its forecasts held out are the same */
    if (status == WCUT_OK)
        copy_forecast(e, &p->in_sample[WCUT_EVIDENCE_MODEL_BEFORE], &p->held_out[WCUT_EVIDENCE_MODEL_BEFORE]);

    /* no effect named: the third model's figures are those of the second */
    if (status == WCUT_OK && models < MODELS) {
        copy_forecast(e, &p->in_sample[WCUT_EVIDENCE_MODEL_RECALIBRATED], &p->in_sample[WCUT_EVIDENCE_MODEL_AFTER]);
        copy_forecast(e, &p->held_out[WCUT_EVIDENCE_MODEL_RECALIBRATED], &p->held_out[WCUT_EVIDENCE_MODEL_AFTER]);
    }

    wcut_free(room);
    wcut_free(failed);
    return status;
}

wcut_status wcut_cross_validation_create(const wcut_evidence *e, const wcut_fitted *recalibrated,
                                         const wcut_fitted *chosen, unsigned long long seed, wcut_cross_validation *out,
                                         wcut_error *error) {
    const wcut_fitted *const fitted[MODELS] = {NULL, recalibrated, chosen};

    /* room for the measured values and for every model's forecasts */
    wcut_cross_validation p = {.score = {{{0}}}};
    bool whole = forecast_create(e, &p.measured);
    int cuts = 0;
    for (int m = 0; m < MODELS; m++)
        whole = forecast_create(e, &p.in_sample[m]) && forecast_create(e, &p.held_out[m]) && whole;
    for (int k = 0; k < e->cuts; k++) cuts += e->cut[k].bins > 0;
    wcut_status status = whole ? WCUT_OK : wcut_fail(error, WCUT_NO_MEMORY, "no memory for the proof");
    if (status == WCUT_OK) {
        /* forecasts of all cuts under all models, in sample and held out */
        fill_measured(e, &p.measured);
        status = forecast_all(e, fitted, &p, error);
    }

    /* figures of each model; nothing is held out where there is a single cut */
    for (int m = 0; status == WCUT_OK && m < MODELS; m++) {
        status = wcut_forecast_score(e, &p.measured, &p.in_sample[m], seed, p.score[m]);
        if (status == WCUT_OK && cuts > 1)
            status = wcut_forecast_score(e, &p.measured, &p.held_out[m], seed, p.held_out_score[m]);
        if (status != WCUT_OK) wcut_fail(error, status, "no memory for the figures");
    }
    if (status == WCUT_OK)
        *out = p;
    else
        wcut_cross_validation_destroy(&p);

    return status;
}
