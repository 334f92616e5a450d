/* Redundancy: what a recording holds twice, and what a job says that its recording shows. Compared before any physics. */
#include "explain/redundancy.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "base/fail.h"

#define CONTRADICTION_NAME(name, text) [WCUT_CONTRADICTION_##name] = text,
static const char *const names[] = {WCUT_CONTRADICTION_LIST(CONTRADICTION_NAME)};

const char *wcut_contradiction_name(wcut_contradiction_kind kind) {
    return (unsigned)kind < WCUT_CONTRADICTION_COUNT ? names[kind] : "";
}

/* ---- what the checks share ---- */

bool wcut_sample_at(const wcut_recording *r, wcut_channel channel, int sample, double *value) {
    const wcut_column *c = &r->channel[channel];
    if (!c->name || !c->value || (c->present && !c->present[sample])) return false;
    *value = c->value[sample];
    return isfinite(*value);
}

bool wcut_heater_power(const wcut_job *job, const wcut_recording *r, int sample, double *power) {
    double volts, amperes;
    if (!(job->wire_length > 0) || !wcut_sample_at(r, WCUT_CHANNEL_HEATER_VOLTAGE, sample, &volts) ||
        !wcut_sample_at(r, WCUT_CHANNEL_HEATER_CURRENT, sample, &amperes))
        return false;
    *power = 1000 * volts * amperes / job->wire_length;
    return true;
}

bool wcut_redundancy_has(const wcut_redundancy *r, int cut) {
    const wcut_diagnosis_cut *c = &r->cut[cut];
    return c->job && c->recording && c->job->mode == WCUT_MODE_PATH && c->job->stations > 1;
}

wcut_contradiction *wcut_contradiction_add(wcut_redundancy *r, wcut_contradiction_kind kind, const char *column) {
    if (r->count == WCUT_CONTRADICTIONS_MAX) return NULL;
    wcut_contradiction *c = &r->found[r->count++];
    *c = (wcut_contradiction){.kind = kind};
    snprintf(c->column, sizeof c->column, "%s", column);
    return c;
}

void wcut_contradiction_add_cut(wcut_contradiction *c, int cut) {
    if (c->cuts < WCUT_RIG_CUTS) c->cut[c->cuts++] = cut;
}

void wcut_cut_list(const wcut_redundancy *r, const wcut_contradiction *c, char text[WCUT_CUT_LIST]) {
    int usable = 0;
    for (int k = 0; k < r->cuts; k++) usable += wcut_redundancy_has(r, k);

    /* all of several are told in two words */
    if (c->cuts > 1 && c->cuts == usable) {
        snprintf(text, WCUT_CUT_LIST, "all cuts");
        return;
    }

    /* names from 1 on, the last one behind "and" */
    int at = snprintf(text, WCUT_CUT_LIST, c->cuts == 1 ? "cut" : "cuts");
    for (int k = 0; k < c->cuts && at < WCUT_CUT_LIST - 12; k++)
        at += snprintf(text + at, (size_t)(WCUT_CUT_LIST - at), "%s %d",
                       k == 0             ? ""
                       : k == c->cuts - 1 ? " and"
                                          : ",",
                       c->cut[k] + 1);
}

double *wcut_redundancy_column(wcut_redundancy *r, int cut, wcut_channel channel) {
    wcut_recording *own = &r->recording[cut];
    wcut_column *c = &own->channel[channel];
    const size_t n = (size_t)own->samples;

    /* what is owned already is written again */
    for (int k = 0; k < r->columns; k++)
        if (r->column[k] == c->value) return r->column[k];
    double **all = wcut_grow(r->column, (size_t)(r->columns + 1) * sizeof *all);
    if (!all) return NULL;
    r->column = all;
    double *value = c->value ? wcut_copy(c->value, n, sizeof *value) : wcut_alloc(n, sizeof *value);
    if (!value) return NULL;
    r->column[r->columns++] = value;

    /* a channel that the file has not is there from now on, whole */
    if (!c->name) {
        static const char name[] = "heat_W_per_m";
        if (!r->made) r->made = wcut_copy(name, sizeof name, 1);
        if (!r->made) return NULL;
        c->name = r->made, c->present = NULL, c->missing = 0;
    }
    c->value = value;
    r->cut[cut].recording = own;
    return value;
}

/* ---- all of them ---- */

void wcut_redundancy_destroy(wcut_redundancy *r) {
    for (int k = 0; k < r->columns; k++) wcut_free(r->column[k]);
    wcut_free(r->column);
    wcut_free(r->made);
    wcut_free(r->cut);
    wcut_free(r->job);
    wcut_free(r->recording);
    wcut_free(r->found);
    *r = (wcut_redundancy){0};
}

wcut_status wcut_redundancy_create(int cuts, const wcut_diagnosis_cut *given, const wcut_recording *still,
                                   wcut_redundancy *out, wcut_error *error) {
    wcut_redundancy r = {.cuts = cuts,
                         .given = given,
                         .still = still,
                         .cut = wcut_copy(given, (size_t)cuts, sizeof *r.cut),
                         .job = wcut_alloc((size_t)cuts, sizeof *r.job),
                         .recording = wcut_alloc((size_t)cuts, sizeof *r.recording),
                         .found = wcut_alloc(WCUT_CONTRADICTIONS_MAX, sizeof *r.found)};
    wcut_status status = r.cut && r.job && r.recording && r.found ? WCUT_OK : WCUT_NO_MEMORY;
    for (int k = 0; status == WCUT_OK && k < cuts; k++) {
        if (given[k].job) r.job[k] = *given[k].job;
        if (given[k].recording) r.recording[k] = *given[k].recording;
    }

    /* each check sees what those before it set right */
    if (status == WCUT_OK) status = wcut_excitation_compare(&r);
    if (status == WCUT_OK) status = wcut_heater_compare(&r);
    if (status == WCUT_OK) status = wcut_motion_compare(&r);
    if (status == WCUT_OK) status = wcut_zero_compare(&r);
    if (status == WCUT_OK)
        *out = r;
    else
        wcut_redundancy_destroy(&r);
    return status == WCUT_OK ? status : wcut_fail(error, status, "no memory for %d cuts", cuts);
}

wcut_status wcut_redundancy_check(const wcut_recording *still, wcut_error *error) {
    if (!still || (still->samples > 0 && still->channel[WCUT_CHANNEL_TIME].value)) return WCUT_OK;
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "still: found no samples, expected some");
}

/* ---- the verdict ---- */

/* a zero that was read in the air, as an effect of the library, unless the fit has found one of its own there */
static void add_zero_effect(wcut_diagnosis *d, const wcut_contradiction *c) {
    const int sensor = strcmp(c->column, "tension_b_N") == 0;
    if (d->effects == WCUT_DIAGNOSIS_EFFECTS) return;
    for (int e = 0; e < d->effects; e++)
        if (d->effect[e].effect.kind == WCUT_EFFECT_TENSION_ZERO && d->effect[e].effect.choice == sensor) return;
    wcut_found_effect *f = &d->effect[d->effects++];
    *f = (wcut_found_effect){
        .effect = wcut_effect_choose(WCUT_EFFECT_TENSION_ZERO, sensor), .present = true, .confidence = d->confidence};
    f->effect.value[WCUT_TENSION_ZERO_OFFSET] = c->found;
    f->estimated[WCUT_TENSION_ZERO_OFFSET] = true;
    f->parameter[WCUT_TENSION_ZERO_OFFSET] =
        (wcut_estimate){c->found, c->found - 1.96 * c->error, c->found + 1.96 * c->error};
}

/* what contradictions make of a verdict; what is not understood, or not told apart, stays so */
static void change_verdict(wcut_diagnosis *d) {
    bool fault = false;
    for (int k = 0; k < d->contradictions; k++) fault = fault || d->contradiction[k].fault;
    if (!fault || d->kind == WCUT_VERDICT_UNKNOWN || d->kind == WCUT_VERDICT_AMBIGUOUS) return;
    if (d->kind == WCUT_VERDICT_NONE) d->kind = WCUT_VERDICT_INSTRUMENT;
    if (d->kind == WCUT_VERDICT_PHYSICS) d->kind = WCUT_VERDICT_BOTH;
    for (int k = 0; k < d->contradictions; k++)
        if (d->contradiction[k].kind == WCUT_CONTRADICTION_TENSION_ZERO && d->contradiction[k].common)
            add_zero_effect(d, &d->contradiction[k]);
}

/* a sentence or two for each, as far as there is room before the verdict's own */
static void put_before(wcut_diagnosis *d) {
    char behind[WCUT_DIAGNOSIS_TEXT];

    /* "No difference beyond noise" would contradict the sentences before it */
    memcpy(behind, d->sentence, sizeof behind);
    if (d->kind == WCUT_VERDICT_NONE && d->sentence[0] == 'N')
        snprintf(behind, sizeof behind, "Otherwise n%.*s", (int)sizeof behind - 16, d->sentence + 1);

    /* the sentences that fit */
    const size_t room = sizeof d->sentence - 1 - strlen(behind);
    size_t at = 0;
    for (int k = 0; k < d->contradictions; k++) {
        const size_t length = strlen(d->contradiction[k].text);
        if (at + length + 1 > room) break;
        memcpy(d->sentence + at, d->contradiction[k].text, length);
        at += length;
        d->sentence[at++] = ' ';
    }
    snprintf(d->sentence + at, sizeof d->sentence - at, "%s", behind);
}

bool wcut_contradictions_report(const wcut_redundancy *r, bool decided, wcut_diagnosis *d) {
    if (r->count == 0) return true;
    d->contradiction = wcut_copy(r->found, (size_t)r->count, sizeof *r->found);
    if (!d->contradiction) return false;
    d->contradictions = r->count;
    put_before(d);
    if (decided) change_verdict(d);
    return true;
}
