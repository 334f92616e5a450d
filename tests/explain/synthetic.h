/* A case made in place: a small block cut along a programmed motion by the library's own wire, an effect switched on,
   seeded noise on what the sensors say. */
#ifndef WCUT_TESTS_EXPLAIN_SYNTHETIC_H
#define WCUT_TESTS_EXPLAIN_SYNTHETIC_H

#include <wirecut/recording_file.h>
#include "base/alloc.h"
#include "base/random.h"
#include "cut/trials.h"
#include "explain/model_fit.h"

enum { SYNTHETIC_CUTS = 3, SYNTHETIC_SAMPLES = 330 };

#define SYNTHETIC_STEP 0.1 /* [s] */

typedef struct synthetic {
    int cuts;
    wcut_job *job[SYNTHETIC_CUTS];
    wcut_recording *recording[SYNTHETIC_CUTS];
    wcut_diagnosis_cut cut[SYNTHETIC_CUTS];
} synthetic;

/* what is concealed; zeros: nothing */
typedef struct concealed {
    int effects;
    wcut_effect effect;
    double law_a, law_b;  /* [1] of the job's, 0 for 1 */
    double noise;         /* [1] of 0.02 N and 0.05 deg a sample */
    bool plain_programme; /* no dither, no heat steps: an ordinary cut */
    uint64_t seed;
} concealed;

/* 240 x 400 mm, 4.2 mm a station; two sines of speed, two steps of heat, other ones in every cut */
static inline wcut_job *synthetic_job(int k, bool plain) {
    wcut_job *job = straight_job(240, 60, 380, 21, 121, -20, 480);
    job->block_size.y = 400;
    job->speed_max = 40;
    job->heat = 60 + 5 * k;
    if (plain) return job;
    job->dither_count = job->heat_step_count = 2;
    job->dither = wcut_alloc(2, sizeof *job->dither);
    job->heat_step = wcut_alloc(2, sizeof *job->heat_step);
    for (int i = 0; i < 2; i++) {
        job->dither[i] = (wcut_dither){.amplitude = 0.08, .period = 3.3 + 2.2 * i + 0.4 * k, .phase = 1.7 * k + i};
        job->heat_step[i] = (wcut_heat_step){.from = 9 + 11 * i + k, .to = 15 + 11 * i, .factor = i ? 0.9 : 1.12};
    }
    return job;
}

static inline wcut_trajectory synthetic_trail(const wcut_job *job) {
    const size_t n = SYNTHETIC_SAMPLES;
    wcut_trajectory t = {.count = SYNTHETIC_SAMPLES,
                         .time = wcut_alloc(n, sizeof(double)),
                         .station = wcut_alloc(n, sizeof(double)),
                         .heat = wcut_alloc(n, sizeof(double))};
    double station = 1;
    for (int i = 0; i < t.count; i++) {
        double pace = 1, heat = job->heat;
        const double time = SYNTHETIC_STEP * i, middle = time - SYNTHETIC_STEP / 2;
        for (int k = 0; k < job->dither_count; k++)
            pace += job->dither[k].amplitude * sin(2 * WCUT_PI * middle / job->dither[k].period + job->dither[k].phase);
        for (int k = 0; k < job->heat_step_count; k++)
            if (time >= job->heat_step[k].from && time < job->heat_step[k].to) heat *= job->heat_step[k].factor;
        if (i) station += 3.4 * pace * SYNTHETIC_STEP;
        t.time[i] = time, t.station[i] = fmin(station, job->stations - 1), t.heat[i] = heat;
    }
    return t;
}

static inline wcut_recording *synthetic_recording(const wcut_job *job, const concealed *what, wcut_random *random) {
    wcut_effect effect[1] = {what->effect};
    wcut_job real = *job;
    real.effect_count = what->effects, real.effect = effect;
    real.force_law.a *= what->law_a > 0 ? what->law_a : 1, real.force_law.b *= what->law_b > 0 ? what->law_b : 1;
    wcut_trajectory t = synthetic_trail(job);
    wcut_response d = {0};
    wcut_error error = {0};
    const wcut_status status = wcut_response_run(&real, WCUT_NODES_FINE, &t, false, NULL, &d, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    wcut_recording *r = blank_recording(t.count, SYNTHETIC_STEP);
    double *value[WCUT_SENSED_COUNT] = {NULL}, *heat = add_channel(r, WCUT_CHANNEL_HEAT);
    for (int k = 0; k < WCUT_SIGNALS; k++) {
        value[WCUT_SENSED_TENSION_A + k] = values(r, (wcut_channel)(WCUT_CHANNEL_TENSION_A + k));
        memcpy(value[WCUT_SENSED_TENSION_A + k], d.signal[k], (size_t)t.count * sizeof(double));
    }
    ck_assert_int_eq(wcut_sensors_eval(what->effects, effect, t.count, t.time, d.present, value), WCUT_OK);
    for (int k = 0; k < WCUT_SIGNALS; k++)
        for (int i = 0; i < t.count; i++)
            value[WCUT_SENSED_TENSION_A + k][i] +=
                what->noise * (k < 2 ? 0.02 : 0.05 * WCUT_PI / 180) * wcut_random_normal(random);
    for (int i = 0; i < t.count; i++) {
        const int before = i > 0 ? i - 1 : 0, behind = i + 1 < t.count ? i + 1 : i;
        values(r, WCUT_CHANNEL_STATION)[i] = t.station[i], heat[i] = t.heat[i];
        for (int side = 0; side < 2; side++)
            values(r, (wcut_channel)(WCUT_CHANNEL_SPEED_A + side))[i] =
                500.0 / 120 * (t.station[behind] - t.station[before]) / (t.time[behind] - t.time[before]);
    }
    wcut_response_destroy(&d);
    wcut_trajectory_destroy(&t);
    return r;
}

static inline synthetic synthetic_create(int cuts, const concealed *what) {
    synthetic s = {.cuts = cuts};
    wcut_random random = wcut_random_seed(what->seed);
    for (int k = 0; k < cuts; k++) {
        s.job[k] = synthetic_job(k, what->plain_programme);
        s.recording[k] = synthetic_recording(s.job[k], what, &random);
        s.cut[k] = (wcut_diagnosis_cut){.job = s.job[k], .recording = s.recording[k]};
    }
    return s;
}

static inline void synthetic_destroy(synthetic *s) {
    for (int k = 0; k < s->cuts; k++) {
        wcut_recording_destroy(s->recording[k]);
        wcut_job_destroy(s->job[k]);
    }
}

/* evidence of a case, predicted under the jobs' own model */
static inline wcut_evidence *evidence_of(const synthetic *s, int threads) {
    wcut_evidence *e = NULL;
    wcut_error error = {0};
    wcut_status status = wcut_evidence_create(s->cuts, s->cut, false, threads, NULL, &e, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    const wcut_model model = e->at;
    status = wcut_evidence_predict(e, &model, true, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return e;
}

/* recalibration alone, or with one effect that begins at a size */
static inline wcut_fitted fit_of(const wcut_evidence *e, int effects, wcut_effect effect) {
    wcut_model start = e->at;
    wcut_fitted f = {.count = 999};
    wcut_error error = {0};
    start.effects = effects, start.effect[0] = effect;
    const wcut_status status = wcut_model_fit(e, &start, &f, &error);
    ck_assert_msg(status == WCUT_OK, "%s", error.text);
    return f;
}

static inline wcut_effect effect_of(wcut_effect_kind kind, double strength) {
    wcut_effect effect = wcut_effect_default(kind);
    effect.value[0] = strength;
    return effect;
}

/* noise as whitening assumes it, in the rows' own units: white, and a slow part with its memory */
static inline void noise_rows(const wcut_evidence *e, wcut_random *random, double *out) {
    const double keep = exp(-WCUT_BIN_WIDTH / WCUT_NOISE_MEMORY);
    for (int k = 0; k < e->cuts; k++) {
        const wcut_evidence_cut *c = &e->cut[k];
        for (int s = 0; s < WCUT_SIGNALS; s++) {
            const double share = e->noise.slow[wcut_noise_group(s)], fresh = sqrt(share * (1 - keep * keep));
            double slow = sqrt(share) * wcut_random_normal(random);
            for (int i = 0; i < c->bins; i++) {
                out[c->row + s * c->bins + i] = e->sigma[s] * (wcut_random_normal(random) + slow);
                slow = keep * slow + fresh * wcut_random_normal(random);
            }
        }
        for (int i = 0; i < c->patch.count; i++)
            out[c->row + WCUT_SIGNALS * c->bins + i] = c->patch.sigma[i] * wcut_random_normal(random);
    }
}

/* the same, whitened */
static inline void white_rows(const wcut_evidence *e, wcut_random *random, double *out) {
    double *raw = wcut_alloc((size_t)e->rows, sizeof *raw);
    wcut_evidence_residual(e, raw);
    noise_rows(e, random, out);
    wcut_evidence_whiten(e, raw, out, out);
    wcut_free(raw);
}

#endif
