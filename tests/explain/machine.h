/* A case as a machine records it: the library's rig in closed loop, something concealed in foam or instruments. Made
   without Check, so that a bench has it too: what goes wrong in the making ends the program. */
#ifndef WCUT_TESTS_EXPLAIN_MACHINE_H
#define WCUT_TESTS_EXPLAIN_MACHINE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/diagnosis.h>
#include <wirecut/rig.h>
#include <wirecut/wirecut.h>

#include "base/alloc.h"
#include "base/numbers.h"

enum { MACHINE_CUTS = 3, MACHINE_STATIONS = 80, MACHINE_NODES = 41 };

/* what is concealed; zeros: nothing, a true job, sensors as the rig's */
typedef struct machine_secret {
    int effects;
    wcut_effect effect[2];
    double law_a, law_b; /* [1] the foam's over the job's; 0: 1 */
    double level[3];     /* [1] of each cut's own block over the usual one; 0: 1 */
    double longer[3];    /* [mm] each cut's wire over its job's */
    double noise;        /* [1] of the rig's own; 0: 1 */
    double delay;        /* [s] of the tension's readings; 0: none */
    int decimation;      /* steps of the loop (40 Hz) a sample; 0: 20 Hz */
    bool plain;          /* no identification cuts */
    bool one_heat;
    uint64_t seed;
} machine_secret;

typedef struct machine_case {
    int cuts;
    wcut_job *job[MACHINE_CUTS];
    wcut_rig_run *run[MACHINE_CUTS];
    wcut_diagnosis_cut cut[MACHINE_CUTS];
} machine_case;

static inline void machine_must(wcut_status status, const char *what, const wcut_error *error) {
    if (status == WCUT_OK) return;
    fprintf(stderr, "%s: %s: %s\n", what, wcut_status_text(status), error->text);
    abort();
}

static inline wcut_effect machine_effect(wcut_effect_kind kind, int choice, double strength, double second) {
    wcut_effect effect = wcut_effect_default(kind);
    effect.choice = choice, effect.value[0] = strength;
    if (second != 0) effect.value[1] = second;
    return effect;
}

/* into 400 x 600 mm and on until the wire is near its far side, some 35 s; the mounts of odd cuts rise and fall against
   each other */
static inline wcut_job *machine_plain_job(int cut, bool one_heat) {
    static const double heat[MACHINE_CUTS] = {60, 75, 66};
    wcut_job *job = NULL;
    machine_must(wcut_job_create(&job), "a job", &(wcut_error){0});
    job->block_size = (wcut_vec3){400, 600, 300};
    job->wire_diameter = 0.15, job->wire_length = 560, job->nodes = MACHINE_NODES;
    job->heat = one_heat ? heat[0] : heat[cut], job->tension = 2, job->speed_max = 40;
    job->force_law = (wcut_force_law){0.1, 8.6e-4};
    job->stations = MACHINE_STATIONS;
    job->mount_a = wcut_alloc(MACHINE_STATIONS, sizeof *job->mount_a);
    job->mount_b = wcut_alloc(MACHINE_STATIONS, sizeof *job->mount_b);
    for (int j = 0; j < MACHINE_STATIONS; j++) {
        const double u = j / (MACHINE_STATIONS - 1.0), narrow = fmin(u / 0.22, 1);
        const double beside = 78 - 30 * narrow * narrow * (3 - 2 * narrow);
        const double rise = cut % 2 ? 35 * sin(2 * WCUT_PI * u) : 0;
        job->mount_a[j] = (wcut_vec3){-beside, -10 + 600 * u, 150 + rise};
        job->mount_b[j] = (wcut_vec3){400 + beside, -10 + 600 * u, 150 - rise};
    }
    return job;
}

/* the first cut as it is, the others to identify with */
static inline wcut_job *machine_job(int cut, const machine_secret *secret) {
    wcut_job *plain = machine_plain_job(cut, secret->one_heat), *excited = NULL;
    wcut_error error = {0};
    if (cut == 0 || secret->plain) return plain;
    machine_must(wcut_identification_create(plain, 1, secret->seed + (uint64_t)cut, &excited, &error), "an excitation",
                 &error);
    wcut_job_destroy(plain);
    return excited;
}

/* the lines that a file would give the samples: messages name them */
static inline void machine_number(wcut_recording *r) {
    r->further = wcut_alloc(1, sizeof *r->further);
    r->further->rows = r->samples;
    r->further->line = wcut_alloc((size_t)r->samples, sizeof(int));
    for (int i = 0; i < r->samples; i++) r->further->line[i] = i + 2;
}

/* what the machine records of a job: the loop holds the tension of a foam that the job does not know */
static inline wcut_rig_run *machine_record(const wcut_job *job, int cut, const machine_secret *secret) {
    wcut_setup *setup = NULL;
    wcut_history *plan = NULL;
    wcut_rig_run *run = NULL;
    wcut_error error = {0};
    machine_must(wcut_setup_create(job, NULL, &setup, &error), "a plan", &error);
    machine_must(wcut_setup_run(setup, NULL, NULL, &plan, &error), "a plan", &error);
    wcut_control_settings control = wcut_control_settings_default(job);
    control.tension_stop = 20 * job->tension, control.tension_absurd = 100 * job->tension;
    wcut_rig_options o = wcut_rig_options_default(job);
    const double noise = secret->noise > 0 ? secret->noise : 1;
    o.noise_tension *= noise, o.noise_angle *= noise, o.noise_speed *= noise, o.noise_position *= noise;
    o.seed = secret->seed + 100 * (uint64_t)cut;
    o.delay = secret->delay, o.decimation = secret->decimation;
    wcut_effect effect[2] = {secret->effect[0], secret->effect[1]};
    wcut_job real = *job;
    real.effect_count = secret->effects, real.effect = effect;
    real.force_law.a *= secret->law_a > 0 ? secret->law_a : 1;
    real.force_law.a *= secret->level[cut] > 0 ? secret->level[cut] : 1;
    real.wire_length += secret->longer[cut];
    real.force_law.b *= secret->law_b > 0 ? secret->law_b : 1;
    const wcut_status status = wcut_rig_run_create(&real, plan, &control, &o, NULL, NULL, &run, &error);
    const wcut_recording *r = run ? &run->recording : NULL;
    /* mounts that stop at the path's end within a period let the wire go slack, which may have no equilibrium */
    if (!r || r->channel[WCUT_CHANNEL_STATION].value[r->samples - 1] < MACHINE_STATIONS - 2)
        machine_must(status == WCUT_OK ? WCUT_DEGENERATE : status, "a recording", &error);
    double *value[WCUT_SENSED_COUNT];
    for (int k = 0; k < WCUT_SENSED_COUNT; k++) value[k] = run->recording.channel[WCUT_CHANNEL_SPEED_A + k].value;
    machine_must(wcut_sensors_eval(secret->effects, effect, run->recording.samples,
                                   run->recording.channel[WCUT_CHANNEL_TIME].value, NULL, value),
                 "the instruments", &error);
    wcut_history_destroy(plan);
    wcut_setup_destroy(setup);
    machine_number(&run->recording);
    return run;
}

static inline machine_case machine_create(int cuts, const machine_secret *secret) {
    machine_case m = {.cuts = cuts};
    for (int k = 0; k < cuts; k++) {
        m.job[k] = machine_job(k, secret);
        m.run[k] = machine_record(m.job[k], k, secret);
        m.cut[k] = (wcut_diagnosis_cut){.job = m.job[k], .recording = &m.run[k]->recording};
    }
    return m;
}

static inline void machine_destroy(machine_case *m) {
    for (int k = 0; k < m->cuts; k++) {
        wcut_table_destroy(m->run[k]->recording.further);
        m->run[k]->recording.further = NULL;
        wcut_rig_run_destroy(m->run[k]);
        wcut_job_destroy(m->job[k]);
    }
}

/* diagnosed without the forward proof: the verdict stands before it */
static inline wcut_diagnosis *machine_diagnose(const machine_case *m, const bool *without) {
    wcut_diagnosis_options options = wcut_diagnosis_options_default();
    wcut_diagnosis *d = NULL;
    wcut_error error = {0};
    options.proof = false;
    if (without) memcpy(options.without, without, sizeof options.without);
    machine_must(wcut_diagnosis_create(m->cuts, m->cut, 0, NULL, &options, NULL, NULL, &d, &error), "a diagnosis",
                 &error);
    return d;
}

/* whether the verdict names these kinds and no other; kinds may be the same */
static inline bool machine_names(const wcut_diagnosis *d, wcut_effect_kind first, wcut_effect_kind second) {
    if (d->kind == WCUT_VERDICT_AMBIGUOUS || d->kind == WCUT_VERDICT_UNKNOWN || d->effects < 1) return false;
    bool has_first = false, has_second = false, other = false;
    for (int k = 0; k < d->effects; k++) {
        const wcut_effect_kind kind = d->effect[k].effect.kind;
        has_first = has_first || kind == first, has_second = has_second || kind == second;
        other = other || (kind != first && kind != second);
    }
    return has_first && has_second && !other;
}

/* the verdict in one line, for a message: "physics: wire_thermal_lag 0.51; left 1.1" */
static inline const char *machine_verdict(const wcut_diagnosis *d) {
    static char text[300];
    int at = snprintf(text, sizeof text, "%s:", wcut_verdict_name(d->kind));
    for (int k = 0; k < d->effects && at < 200; k++)
        at += snprintf(text + at, sizeof text - (size_t)at, " %s[%d] %.4g (%.3g)",
                       wcut_effect_view(d->effect[k].effect.kind)->name, d->effect[k].effect.choice,
                       d->effect[k].effect.value[0], d->effect[k].effect.value[1]);
    snprintf(text + at, sizeof text - (size_t)at, "; left over %.2f, a x %.3f, b x %.3f", d->adequacy,
             d->a.value / d->a_job, d->b.value / d->b_job);
    return text;
}

#endif
