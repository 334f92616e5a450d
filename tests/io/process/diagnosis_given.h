/* A diagnosis filled by hand, every list in it: what its writer and its page are tested with. */
#ifndef WCUT_TESTS_IO_DIAGNOSIS_GIVEN_H
#define WCUT_TESTS_IO_DIAGNOSIS_GIVEN_H

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <wirecut/diagnosis.h>

enum { GIVEN_BINS = 60, GIVEN_TRACES = 4 };

typedef struct given_diagnosis {
    wcut_diagnosis d;
    wcut_hypothesis hypothesis[3];
    wcut_mismatch mismatch[2];
    wcut_dependence dependence;
    bool held_out[3];
    char limit[2][WCUT_DIAGNOSIS_TEXT];
    wcut_residual_trace trace[GIVEN_TRACES];
    double bin[GIVEN_TRACES][5][GIVEN_BINS];
} given_diagnosis;

static inline wcut_found_effect given_effect(wcut_effect_kind kind, bool present, double confidence) {
    wcut_found_effect f = {.effect = wcut_effect_default(kind), .present = present, .confidence = confidence};
    for (int k = 0; k < WCUT_EFFECT_VALUES; k++) f.parameter[k] = (wcut_estimate){NAN, NAN, NAN};
    return f;
}

static inline void give_traces(given_diagnosis *g) {
    static const char *const column[GIVEN_TRACES] = {"tension_a_N", "tension_b_N", "alpha_a_deg", "scan"};
    static const wcut_evidence_channel channel[GIVEN_TRACES] = {
        WCUT_EVIDENCE_CHANNEL_TENSION, WCUT_EVIDENCE_CHANNEL_TENSION, WCUT_EVIDENCE_CHANNEL_ALPHA,
        WCUT_EVIDENCE_CHANNEL_SCAN};
    for (int t = 0; t < GIVEN_TRACES; t++) {
        wcut_residual_trace *r = &g->trace[t];
        *r = (wcut_residual_trace){.cut = t / 3,
                                   .channel = channel[t],
                                   .count = GIVEN_BINS,
                                   .noise = 0.01,
                                   .time = g->bin[t][0],
                                   .station = g->bin[t][1],
                                   .before = g->bin[t][2],
                                   .recalibrated = g->bin[t][3],
                                   .after = g->bin[t][4]};
        snprintf(r->column, sizeof r->column, "%s", column[t]);
        for (int i = 0; i < GIVEN_BINS; i++) {
            r->time[i] = 5 + 0.5 * i, r->station[i] = 3.0 * i;
            r->before[i] = 0.2 + 0.1 * sin(0.3 * i), r->recalibrated[i] = 0.1 * sin(0.3 * i);
            r->after[i] = 0.01 * cos(9.0 * i);
        }
        r->after[7] = NAN;
    }
}

static inline void give_lists(given_diagnosis *g) {
    g->hypothesis[0] = (wcut_hypothesis){1, {g->d.effect[0].effect}, 1, 812, 240, 1.02, 0.93, ""};
    g->hypothesis[1] = (wcut_hypothesis){1, {g->d.effect[1].effect}, 3, 640, 170, 1.4, 0.05, "explains less"};
    g->hypothesis[2] = (wcut_hypothesis){0, {{0}}, 0, 0, 0, 9.1, 1e-9, "leaves a misfit"};
    g->mismatch[0] = (wcut_mismatch){.cut = 1,
                                     .channel = WCUT_EVIDENCE_CHANNEL_ALPHA,
                                     .column = "alpha_a_deg",
                                     .time = {12, 19.5},
                                     .station = {30, 52},
                                     .wire = {NAN, NAN},
                                     .block = {{0, 120, 0}, {400, 260, 300}},
                                     .mean = 0.4,
                                     .share = 0.41,
                                     .p_value = 1e-6,
                                     .regime = "steady"};
    g->mismatch[1] = g->mismatch[0];
    g->mismatch[1].channel = WCUT_EVIDENCE_CHANNEL_SCAN;
    snprintf(g->mismatch[1].column, sizeof g->mismatch[1].column, "scan");
    g->mismatch[1].wire[0] = 40, g->mismatch[1].wire[1] = 90;
    g->mismatch[1].block[0].x = NAN;
    snprintf(g->limit[0], sizeof g->limit[0], "Cut 3 has no scan.");
    snprintf(g->limit[1], sizeof g->limit[1], "No cut has \"excitation\": lags are told from each other badly.");
    g->dependence = (wcut_dependence){"ln speed", WCUT_EVIDENCE_CHANNEL_TENSION, {0.2, 0.1, 0.3}, 44};
    g->held_out[2] = true;
}

static inline void give_fits(wcut_evidence_score fit[WCUT_EVIDENCE_MODEL_COUNT][WCUT_EVIDENCE_CHANNEL_COUNT]) {
    for (int m = 0; m < WCUT_EVIDENCE_MODEL_COUNT; m++)
        for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
            const double size = (m == 0 ? 1 : m == 1 ? 0.6 : m == 2 ? 0.1 : 0.2) * (c + 1);
            fit[m][c] = (wcut_evidence_score){100, size, size * 1.25, size / 20, size / 10, size / 12, size / 8};
        }
    fit[WCUT_EVIDENCE_MODEL_BLACK_BOX][WCUT_EVIDENCE_CHANNEL_SCAN] = (wcut_evidence_score){0};
    fit[WCUT_EVIDENCE_MODEL_BEFORE][WCUT_EVIDENCE_CHANNEL_SPEED].low = NAN;
}

/* a thermal lag found, an offset of the scan as what else it could be; three cuts, the third held out */
static inline void give_diagnosis(given_diagnosis *g) {
    memset(g, 0, sizeof *g);
    wcut_diagnosis *d = &g->d;
    d->kind = WCUT_VERDICT_PHYSICS, d->confidence = 0.93, d->confidence_by = 0.5;
    snprintf(d->sentence, sizeof d->sentence, "The wire's temperature follows its load with a lag of 0.8 s.");
    d->effects = 2;
    d->effect[0] = given_effect(WCUT_EFFECT_WIRE_THERMAL_LAG, true, 0.93);
    d->effect[0].effect.value[0] = 0.8;
    d->effect[0].parameter[0] = (wcut_estimate){0.8, 0.7, 0.9};
    d->effect[0].estimated[0] = true;
    d->effect[1] = given_effect(WCUT_EFFECT_SCAN_OFFSET, false, 0.05);
    for (int k = 0; k < 3; k++) {
        d->effect[1].effect.value[k] = k;
        d->effect[1].parameter[k] = (wcut_estimate){k, k ? k - 0.5 : -INFINITY, k + 0.5};
        d->effect[1].estimated[k] = true;
    }
    d->a = (wcut_estimate){0.09, 0.08, 0.1}, d->b = (wcut_estimate){8e-4, 7e-4, 9e-4};
    d->length_change = (wcut_estimate){0.2, -0.1, 0.5}, d->kerf = (wcut_estimate){NAN, NAN, NAN};
    d->a_job = 0.1, d->b_job = 8.6e-4;
    d->adequacy = 1.02, d->adequacy_p = 0.4;
    d->correction =
        (wcut_correction){.a = 0.09, .b = 8e-4, .length_change = 0.2, .kerf = 1.1, .kerf_per_q = 1e-4, .effects = 1};
    d->correction.effect[0] = d->effect[0].effect;
    give_lists(g);
    give_traces(g);
    d->hypotheses = 3, d->hypothesis = g->hypothesis;
    d->mismatches = 2, d->mismatch = g->mismatch;
    d->dependences = 1, d->dependence = &g->dependence;
    d->traces = GIVEN_TRACES, d->trace = g->trace;
    d->cuts = 3, d->held_out = g->held_out, d->view.cut = 1;
    static wcut_vec3 wire[6] = {{0, 0, 100},  {200, 10, 110}, {400, 0, 100},
                                {0, 50, 100}, {200, 60, 120}, {400, 50, 100}};
    static double above[2] = {0.2, -0.1};
    d->view.rows = 2, d->view.nodes = 3, d->view.surface = wire, d->view.worst = 1, d->view.time = 14;
    d->view.block = (wcut_vec3){400, 600, 300};
    d->view.points = 2, d->view.point = wire, d->view.distance = above;
    give_fits(d->score);
    give_fits(d->held_out_score);
    d->limits = 2, d->limit = g->limit;
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) d->noise[c] = c == WCUT_EVIDENCE_CHANNEL_SCAN ? NAN : 0.02;
    static wcut_contradiction against = {.kind = WCUT_CONTRADICTION_EXCITATION,
                                         .column = "speed_command_mm_s",
                                         .cuts = 1,
                                         .cut = {1},
                                         .found = 0.01,
                                         .expected = 1,
                                         .error = 0.005,
                                         .unit = "share",
                                         .repaired = true,
                                         .text = "The recording of cut 2 does not follow the job's excitation."};
    d->contradictions = 1, d->contradiction = &against;
    d->naive_false = true;
    snprintf(d->naive, sizeof d->naive, "clock_offset");
}

#endif
