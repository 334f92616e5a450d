/* "wirecut-diagnosis/1": what explains a case, in the units of files. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/diagnosis.h>
#include <wirecut/diagnosis_file.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/file/atomic.h"
#include "io/file/text.h"
#include "io/process/effect_json.h"

static void put_diagnosis_string(wcut_text *text, const char *before, const char *value) {
    wcut_text_put_word(text, before);
    wcut_text_string(text, value ? value : "");
}

static void put_pair(wcut_text *text, const char *before, double low, double high) {
    wcut_text_put_number(text, before, low);
    wcut_text_put_number(text, ", ", high);
    wcut_text_put_word(text, "]");
}

/* ---- estimates ---- */

/* An end that the data leave open is the end of what the parameter may be: readers compare numbers, and JSON has no
   infinity. */
static double diagnosis_end_of(double value, double limit) {
    if (isfinite(value)) return value;
    return isfinite(limit) ? limit : copysign(DBL_MAX, limit);
}

static void put_interval(wcut_text *text, const char *before, const wcut_estimate *e, double min, double max) {
    put_pair(text, before, diagnosis_end_of(e->low, min), diagnosis_end_of(e->high, max));
}

static void put_open(wcut_text *text, bool low, bool high) {
    if (low || high) wcut_text_print(text, ", \"open\": \"%s\"", low && high ? "both" : low ? "low" : "high");
}

/* "key": {"value": .., "ci95": [.., ..]}; lists of three for points */
static void put_parameter(wcut_text *text, const wcut_found_effect *found, const wcut_effect_parameter *p) {
    /* a point is a list of three values with one interval each */
    const wcut_estimate *e = found->parameter + p->at;
    const bool list = p->size == 3;
    bool estimated = true, low = false, high = false;
    wcut_text_print(text, "\"%s\": {\"value\": %s", p->key, list ? "[" : "");

    /* values, and whether all of them were fitted */
    for (int k = 0; k < p->size; k++) {
        wcut_text_put_number(text, k ? ", " : "", found->effect.value[p->at + k]);
        estimated = estimated && found->estimated[p->at + k] && !isnan(e[k].low) && !isnan(e[k].high);
        low = low || isinf(e[k].low), high = high || isinf(e[k].high);
    }
    wcut_text_put_word(text, list ? "]" : "");

    /* intervals, and which ends are open */
    if (estimated) {
        wcut_text_put_word(text, list ? ", \"ci95\": [" : ", \"ci95\": ");
        for (int k = 0; k < p->size; k++) put_interval(text, k ? ", [" : "[", &e[k], p->min, p->max);
        wcut_text_put_word(text, list ? "]" : "");
        put_open(text, low, high);
    } else {
        wcut_text_put_word(text, ", \"ci95\": null");
    }
    wcut_text_put_word(text, "}");
}

static void put_diagnosis_effect(wcut_text *text, const wcut_found_effect *found) {
    const wcut_effect_info *info = wcut_effect_view(found->effect.kind);
    wcut_text_print(text, "{\"name\": \"%s\", \"present\": %s", info->name, found->present ? "true" : "false");
    wcut_text_put_number(text, ", \"confidence\": ", found->confidence);
    if (found->cut > 0) wcut_text_print(text, ", \"cut\": %d", found->cut);
    wcut_text_put_word(text, ", \"parameters\": {");
    const char *between = "";
    if (info->choice_key) {
        wcut_text_print(text, "\"%s\": \"%s\"", info->choice_key, info->choice[found->effect.choice]);
        between = ", ";
    }
    for (const wcut_effect_parameter *p = wcut_effect_parameters(&found->effect); p->key; p++, between = ", ") {
        wcut_text_put_word(text, between);
        put_parameter(text, found, p);
    }
    wcut_text_put_word(text, "}}");
}

static void put_diagnosis_effects(wcut_text *text, const wcut_diagnosis *d) {
    wcut_text_put_word(text, ",\n  \"effects\": [");
    for (int e = 0; e < d->effects; e++) {
        wcut_text_put_word(text, e ? ",\n    " : "\n    ");
        put_diagnosis_effect(text, &d->effect[e]);
    }
    wcut_text_put_word(text, "]");
}

/* what is present, but of no consequence for the cut */
static void put_small_effects(wcut_text *text, const wcut_diagnosis *d) {
    const wcut_small_effect *small = &d->small_effect;
    wcut_text_put_word(text, ",\n  \"small_effects\": [");
    if (d->small_effects > 0) {
        wcut_text_put_word(text, "\n    {\"effect\": ");
        put_diagnosis_effect(text, &small->found);
        wcut_text_put_number(text, ", \"gain\": ", small->gain);
        wcut_text_put_number(text, ",\n     \"moves_tension_N\": ", small->tension);
        wcut_text_put_number(text, ", \"moves_face_mm\": ", small->face);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "]");
}

/* "key": {"value", "ci95", "job"}: a number of the plain model that was set anew */
static void put_base(wcut_text *text, const char *before, const wcut_estimate *e, double job) {
    wcut_text_put_number(text, before, e->value);
    if (isnan(e->low) || isnan(e->high))
        wcut_text_put_word(text, ", \"ci95\": null");
    else
        put_interval(text, ", \"ci95\": [", e, -INFINITY, INFINITY);
    wcut_text_put_number(text, ", \"job\": ", job);
    wcut_text_put_word(text, "}");
}

/* what wirecut apply puts into jobs: the numbers whole, effects as a job has them */
static void put_correction(wcut_text *text, const wcut_diagnosis *d) {
    const wcut_correction *c = &d->correction;
    if (d->withheld[0]) {
        put_diagnosis_string(text, ",\n  \"correction\": null,\n  \"withheld\": ", d->withheld);
        return;
    }
    wcut_text_put_number(text, ",\n  \"correction\": {\"a_N_per_mm\": ", c->a);
    wcut_text_put_number(text, ", \"b_m2_per_J\": ", c->b);
    wcut_text_put_number(text, ", \"length_change_mm\": ", c->length_change);
    if (isfinite(c->kerf)) {
        wcut_text_put_number(text, ",\n                 \"kerf\": {\"width_mm\": ", c->kerf);
        wcut_text_put_number(text, ", \"per_J_m2_mm\": ", c->kerf_per_q);
        wcut_text_put_word(text, "}");
    } else {
        wcut_text_put_word(text, ",\n                 \"kerf\": null");
    }
    wcut_put_effects(text, c->effects, c->effect);
    wcut_text_put_word(text, "}");
}

static void put_recalibrated(wcut_text *text, const wcut_diagnosis *d) {
    put_base(text, ",\n  \"recalibrated\": {\"a_N_per_mm\": {\"value\": ", &d->a, d->a_job);
    put_base(text, ",\n                   \"b_m2_per_J\": {\"value\": ", &d->b, d->b_job);
    put_base(text, ",\n                   \"length_change_mm\": {\"value\": ", &d->length_change, 0);
    put_base(text, ",\n                   \"kerf_mm\": {\"value\": ", &d->kerf, NAN);
    wcut_text_put_word(text, "}");
}

/* ---- the verdict ---- */

/* kinds whose verdict names effects; the others have none, or alternatives */
static bool kind_names_effects(wcut_verdict_kind kind) {
    return kind == WCUT_VERDICT_PHYSICS || kind == WCUT_VERDICT_INSTRUMENT || kind == WCUT_VERDICT_BOTH;
}

static const char *effect_name(const wcut_diagnosis *d, int e) {
    return wcut_effect_view(d->effect[e].effect.kind)->name;
}

/* whether a name is that of one of the first present effects, or of the first contradictions that are faults */
static bool effect_is_listed(const wcut_diagnosis *d, int effects, int contradictions, const char *name) {
    for (int e = 0; e < effects; e++)
        if (d->effect[e].present && strcmp(effect_name(d, e), name) == 0) return true;
    for (int k = 0; k < contradictions; k++)
        if (d->contradiction[k].fault && strcmp(wcut_contradiction_name(d->contradiction[k].kind), name) == 0)
            return true;
    return false;
}

static void put_verdict(wcut_text *text, const wcut_diagnosis *d) {
    /* the effects that the verdict names */
    const bool named = kind_names_effects(d->kind);
    const char *between = "";
    wcut_text_print(text, ",\n  \"verdict\": {\"kind\": \"%s\", \"effects\": [", wcut_verdict_name(d->kind));
    for (int e = 0; named && e < d->effects; e++) {
        if (!d->effect[e].present || effect_is_listed(d, e, 0, effect_name(d, e))) continue;
        wcut_text_print(text, "%s\"%s\"", between, effect_name(d, e));
        between = ", ";
    }

    /* instrument faults that contradictions show and no effect stands for */
    for (int k = 0; named && k < d->contradictions; k++) {
        const char *name = wcut_contradiction_name(d->contradiction[k].kind);
        if (!d->contradiction[k].fault || effect_is_listed(d, d->effects, k, name)) continue;
        wcut_text_print(text, "%s\"%s\"", between, name);
        between = ", ";
    }

    wcut_text_put_number(text, "], \"confidence\": ", d->confidence);
    wcut_text_put_number(text, ", \"confidence_by\": ", d->confidence_by);
    wcut_text_put_word(text, ",\n              \"alternatives\": [");
    between = "";

    /* what else could explain the cuts */
    for (int e = 0; e < d->effects; e++) {
        if (named && d->effect[e].present) continue;
        wcut_text_print(text, "%s{\"name\": \"%s\"", between, wcut_effect_view(d->effect[e].effect.kind)->name);
        wcut_text_put_number(text, ", \"confidence\": ", d->effect[e].confidence);
        wcut_text_put_word(text, "}");
        between = ", ";
    }
    wcut_text_print(text, "],\n              \"form_told\": %s", d->form_open ? "false" : "true");
    put_diagnosis_string(text, ", \"sentence\": ", d->sentence);
    wcut_text_put_word(text, "}");
}

/* ---- where ---- */

static bool is_box(const wcut_vec3 corner[2]) {
    for (int k = 0; k < 2; k++)
        if (!isfinite(corner[k].x) || !isfinite(corner[k].y) || !isfinite(corner[k].z)) return false;
    return true;
}

static void put_box(wcut_text *text, const char *before, const wcut_vec3 corner[2]) {
    wcut_text_put_word(text, before);
    if (!is_box(corner)) {
        wcut_text_put_word(text, "null");
        return;
    }
    for (int k = 0; k < 2; k++) {
        wcut_text_put_number(text, k ? ", [" : "[[", corner[k].x);
        wcut_text_put_number(text, ", ", corner[k].y);
        wcut_text_put_number(text, ", ", corner[k].z);
        wcut_text_put_word(text, k ? "]]" : "]");
    }
}

static void put_mismatch(wcut_text *text, const wcut_mismatch *m) {
    wcut_text_print(text, "{\"cut\": %d", m->cut);
    put_diagnosis_string(text, ", \"channel\": ", m->column);
    put_pair(text, ", \"time_s\": [", m->time[0], m->time[1]);
    put_pair(text, ", \"station\": [", m->station[0], m->station[1]);
    if (isfinite(m->wire[0]) && isfinite(m->wire[1]))
        put_pair(text, ", \"wire_mm\": [", m->wire[0], m->wire[1]);
    else
        wcut_text_put_word(text, ", \"wire_mm\": null");
    put_box(text, ",\n     \"block_mm\": ", m->block);
    wcut_text_print(text, ", \"unit\": \"%s\"", wcut_evidence_unit(m->channel));
    wcut_text_put_number(text, ", \"mean\": ", m->mean);
    wcut_text_put_number(text, ", \"share_of_misfit\": ", m->share);
    wcut_text_put_number(text, ", \"p_value\": ", m->p_value);
    put_diagnosis_string(text, ", \"regime\": ", m->regime);
    wcut_text_put_word(text, "}");
}

static void put_mismatches(wcut_text *text, const wcut_diagnosis *d) {
    wcut_text_put_word(text, ",\n  \"mismatch\": [");
    for (int i = 0; i < d->mismatches; i++) {
        wcut_text_put_word(text, i ? ",\n    " : "\n    ");
        put_mismatch(text, &d->mismatch[i]);
    }
    wcut_text_put_word(text, "]");
}

/* ---- how well ---- */

static void put_channels(wcut_text *text, const wcut_evidence_score fit[WCUT_EVIDENCE_CHANNEL_COUNT]) {
    const char *between = "{";
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
        const wcut_evidence_score *f = &fit[c];
        if (f->count < 1) continue;
        wcut_text_print(text, "%s\"%s\": {", between, wcut_evidence_name((wcut_evidence_channel)c));
        wcut_text_put_number(text, "\"rmsd\": ", f->rmsd);
        wcut_text_put_number(text, ", \"rmse\": ", f->rmse);
        wcut_text_put_number(text, ", \"nrmsd\": ", f->nrmsd);
        wcut_text_put_number(text, ", \"rmse_over_range\": ", f->rmse_over_range);
        if (isfinite(f->low) && isfinite(f->high)) put_pair(text, ", \"rmse_over_range_ci95\": [", f->low, f->high);
        wcut_text_print(text, ", \"count\": %d}", f->count);
        between = ", ";
    }
    wcut_text_put_word(text, between[0] == '{' ? "{}" : "}");
}

static void put_models(wcut_text *text,
                       const wcut_evidence_score fit[WCUT_EVIDENCE_MODEL_COUNT][WCUT_EVIDENCE_CHANNEL_COUNT],
                       const char *indent) {
    static const char *const name[WCUT_EVIDENCE_MODEL_COUNT] = {"before", "recalibrated", "after", "black_box"};
    for (int m = 0; m < WCUT_EVIDENCE_MODEL_COUNT; m++) {
        wcut_text_print(text, "%s\"%s\": ", m ? indent : "", name[m]);
        put_channels(text, fit[m]);
    }
}

static void put_fit(wcut_text *text, const wcut_diagnosis *d) {
    wcut_text_put_word(text, ",\n  \"fit\": {");
    put_models(text, d->score, ",\n          ");
    wcut_text_put_word(text, ",\n          \"held_out_cuts\": [");
    const char *between = "";
    for (int i = 0; d->held_out && i < d->cuts; i++) {
        if (!d->held_out[i]) continue;
        wcut_text_print(text, "%s%d", between, i);
        between = ", ";
    }
    wcut_text_put_word(text, "],\n          \"held_out\": {");
    put_models(text, d->held_out_score, ",\n                       ");
    wcut_text_put_word(text, "}}");
}

/* ---- what else was weighed ---- */

static void put_hypothesis(wcut_text *text, const wcut_hypothesis *h) {
    wcut_text_put_word(text, "{\"effects\": [");
    for (int e = 0; e < h->count; e++) {
        const wcut_effect_info *info = wcut_effect_view(h->effect[e].kind);
        wcut_text_print(text, "%s{\"name\": \"%s\"", e ? ", " : "", info->name);
        if (info->choice_key)
            wcut_text_print(text, ", \"%s\": \"%s\"", info->choice_key, info->choice[h->effect[e].choice]);
        wcut_text_put_word(text, "}");
    }
    wcut_text_print(text, "], \"parameters\": %d", h->parameters);
    wcut_text_put_number(text, ", \"gain\": ", h->gain);
    wcut_text_put_number(text, ", \"held_out_gain\": ", h->held_out);
    wcut_text_put_number(text, ", \"adequacy\": ", h->adequacy);
    wcut_text_put_number(text, ", \"probability\": ", h->probability);
    put_diagnosis_string(text, ", \"set_aside\": ", h->why);
    wcut_text_put_word(text, "}");
}

static void put_contradiction(wcut_text *text, const wcut_contradiction *c) {
    wcut_text_print(text, "{\"name\": \"%s\"", wcut_contradiction_name(c->kind));
    put_diagnosis_string(text, ", \"column\": ", c->column);
    wcut_text_put_word(text, ", \"cuts\": [");
    for (int k = 0; k < c->cuts; k++) wcut_text_print(text, "%s%d", k ? ", " : "", c->cut[k]);
    wcut_text_print(text, "], \"unit\": \"%s\"", c->unit);
    wcut_text_put_number(text, ", \"found\": ", c->found);
    wcut_text_put_number(text, ", \"expected\": ", c->expected);
    wcut_text_put_number(text, ", \"standard_error\": ", c->error);
    wcut_text_print(text, ",\n     \"fault\": %s, \"repaired\": %s", c->fault ? "true" : "false",
                    c->repaired ? "true" : "false");
    put_diagnosis_string(text, ", \"sentence\": ", c->text);
    wcut_text_put_word(text, "}");
}

/* a row of the rig's table */
static void put_diagnosis_rig(wcut_text *text, const wcut_rig_row *row) {
    put_diagnosis_string(text, "{\"name\": ", row->name);
    wcut_text_put_number(text, ", \"value\": ", row->value.value);
    put_pair(text, ", \"ci95\": [", row->value.low, row->value.high);
    wcut_text_put_word(text, ", \"cuts\": [");
    for (int k = 0; k < row->cuts; k++) {
        wcut_text_print(text, "%s{\"cut\": %d", k ? ", " : "", row->cut[k]);
        wcut_text_put_number(text, ", \"value\": ", row->of_cut[k].value);
        put_pair(text, ", \"ci95\": [", row->of_cut[k].low, row->of_cut[k].high);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "]}");
}

static void put_dependence(wcut_text *text, const wcut_dependence *x) {
    put_diagnosis_string(text, "{\"quantity\": ", x->quantity);
    wcut_text_print(text, ", \"channel\": \"%s\"", wcut_evidence_name(x->channel));
    wcut_text_put_number(text, ", \"coefficient\": ", x->coefficient.value);
    put_interval(text, ", \"ci95\": [", &x->coefficient, -INFINITY, INFINITY);
    wcut_text_put_number(text, ", \"held_out_gain\": ", x->gain);
    wcut_text_put_word(text, "}");
}

static void put_event(wcut_text *text, const wcut_event *e) {
    wcut_text_print(text, "{\"cut\": %d", e->cut);
    put_pair(text, ", \"time_s\": [", e->time[0], e->time[1]);
    put_pair(text, ", \"station\": [", e->station[0], e->station[1]);
    wcut_text_put_number(text, ", \"tension_N\": ", e->tension);
    wcut_text_put_number(text, ", \"force_change\": ", e->force);
    wcut_text_put_number(text, ", \"as_heat_change\": ", e->heat);
    wcut_text_put_word(text, "}");
}

/* misfit of a channel on cuts left out, before and with the terms; of events, with a level for each window */
static void put_improvement(wcut_text *text, const wcut_diagnosis *d) {
    const char *between = "";
    wcut_text_put_word(text, ",\n               \"improvement\": {");

    /* channels that have both figures */
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
        const wcut_evidence_score *from = &d->held_out_score[WCUT_EVIDENCE_MODEL_RECALIBRATED][c];
        const wcut_evidence_score *to = &d->held_out_score[WCUT_EVIDENCE_MODEL_AFTER][c];
        if (d->modelled.terms == 0 || from->count < 1 || to->count < 1) continue;
        wcut_text_print(text, "%s\"%s_%s\": {", between, wcut_evidence_name((wcut_evidence_channel)c),
                        wcut_evidence_unit((wcut_evidence_channel)c));
        wcut_text_put_number(text, "\"recalibrated\": ", from->rmsd);
        wcut_text_put_number(text, ", \"after\": ", to->rmsd);
        wcut_text_put_word(text, "}");
        between = ", ";
    }

    /* events have their own figure: the misfit with a level for each window */
    if (d->modelled.events > 0) {
        wcut_text_print(text, "%s\"tension_N_with_events\": {", between);
        wcut_text_put_number(text, "\"recalibrated\": ", d->modelled.recalibrated);
        wcut_text_put_number(text, ", \"after\": ", d->modelled.after);
        wcut_text_put_word(text, "}");
    }
    wcut_text_put_word(text, "}");
}

/* null where nothing was looked for, or nothing was confirmed */
static void put_modelled(wcut_text *text, const wcut_diagnosis *d) {
    const wcut_modelled *m = &d->modelled;
    if (m->terms == 0 && m->events == 0) {
        wcut_text_put_word(text, ",\n  \"modelled\": null");
        return;
    }

    /* terms, the equation, and what they improve */
    wcut_text_put_word(text, ",\n  \"modelled\": {\"terms\": [");
    for (int k = 0; k < m->terms; k++) {
        wcut_text_put_word(text, k ? ",\n                         " : "");
        put_diagnosis_effect(text, &m->term[k]);
    }
    put_diagnosis_string(text, "],\n               \"equation\": ", m->equation);
    put_improvement(text, d);

    /* rivals of the terms, then the windows that were left out */
    wcut_text_put_word(text, ",\n               \"alternatives\": [");
    for (int k = 0; k < m->rivals; k++) put_diagnosis_string(text, k ? ", " : "", m->rival[k]);
    wcut_text_put_word(text, "],\n               \"events\": [");
    for (int k = 0; k < m->events; k++) {
        wcut_text_put_word(text, k ? ",\n                          " : "");
        put_event(text, &m->event[k]);
    }
    wcut_text_put_word(text, "]}");
}

static void put_weighed(wcut_text *text, const wcut_diagnosis *d) {
    /* hypotheses, best first */
    wcut_text_put_word(text, ",\n  \"ranking\": [");
    for (int i = 0; i < d->hypotheses; i++) {
        wcut_text_put_word(text, i ? ",\n    " : "\n    ");
        put_hypothesis(text, &d->hypothesis[i]);
    }

    /* quantities that the residual depends on, and limits of the diagnosis */
    wcut_text_put_word(text, "],\n  \"dependences\": [");
    for (int i = 0; i < d->dependences; i++) {
        wcut_text_put_word(text, i ? ",\n    " : "\n    ");
        put_dependence(text, &d->dependence[i]);
    }
    wcut_text_put_word(text, "],\n  \"limits\": [");
    for (int i = 0; i < d->limits; i++) put_diagnosis_string(text, i ? ",\n    " : "\n    ", d->limit[i]);

    /* contradictions, scatter of the rig, adequacy and noise */
    wcut_text_put_word(text, "],\n  \"contradictions\": [");
    for (int i = 0; i < d->contradictions; i++) {
        wcut_text_put_word(text, i ? ",\n    " : "\n    ");
        put_contradiction(text, &d->contradiction[i]);
    }
    wcut_text_put_word(text, "],\n  \"rig\": [");
    for (int i = 0; i < d->rig_rows; i++) {
        wcut_text_put_word(text, i ? ",\n    " : "\n    ");
        put_diagnosis_rig(text, &d->rig[i]);
    }
    wcut_text_put_number(text, "],\n  \"adequacy\": {\"ratio\": ", d->adequacy);
    wcut_text_put_number(text, ", \"p_value\": ", d->adequacy_p);
    wcut_text_put_word(text, "},\n  \"noise\": {");
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
        wcut_text_print(text, "%s\"%s\": ", c ? ", " : "", wcut_evidence_name((wcut_evidence_channel)c));
        wcut_text_put_number(text, "", d->noise[c]);
    }

    /* the control by plain least squares */
    wcut_text_put_word(text, "},\n  \"naive\": ");
    if (d->naive_false || d->naive[0]) { /* else it was not run */
        wcut_text_print(text, "{\"names_an_effect\": %s", d->naive_false ? "true" : "false");
        put_diagnosis_string(text, ", \"which\": ", d->naive);
        wcut_text_put_word(text, "}");
    } else {
        wcut_text_put_word(text, "null");
    }
}

static void put_next(wcut_text *text, const wcut_diagnosis *d) {
    if (!d->next_experiment) {
        wcut_text_put_word(text, ",\n  \"next_experiment\": null");
        return;
    }
    wcut_text_put_word(text, ",\n  \"next_experiment\": {\"job\": \"next-experiment.json\"");
    put_diagnosis_string(text, ", \"name\": ", d->next_experiment->name);
    put_diagnosis_string(text, ", \"reason\": ", d->next_reason);
    wcut_text_put_word(text, "}");
}

/* ---- the document ---- */

static bool is_effect(const wcut_effect *effect) {
    const wcut_effect_info *info = wcut_effect_view(effect->kind);
    int choices = 1;
    while (info && info->choice && info->choice[choices]) choices++;
    return info && effect->choice >= 0 && effect->choice < choices;
}

/* whether every count has its array and every effect is one */
static bool is_diagnosis_whole(const wcut_diagnosis *d) {
    if ((unsigned)d->kind >= WCUT_VERDICT_COUNT || d->effects < 0 || d->effects > WCUT_DIAGNOSIS_EFFECTS) return false;
    if (d->hypotheses < 0 || d->mismatches < 0 || d->dependences < 0 || d->limits < 0 || d->cuts < 0 || d->rig_rows < 0)
        return false;
    if ((d->hypotheses && !d->hypothesis) || (d->mismatches && !d->mismatch) || (d->dependences && !d->dependence) ||
        (d->limits && !d->limit) || (d->rig_rows && !d->rig))
        return false;
    for (int e = 0; e < d->effects; e++)
        if (!is_effect(&d->effect[e].effect)) return false;
    if (d->small_effects < 0 || d->small_effects > 1) return false;
    if (d->small_effects == 1 && !is_effect(&d->small_effect.found.effect)) return false;
    for (int i = 0; i < d->hypotheses; i++) {
        const wcut_hypothesis *h = &d->hypothesis[i];
        if (h->count < 0 || h->count > 2) return false;
        for (int e = 0; e < h->count; e++)
            if (!is_effect(&h->effect[e])) return false;
    }
    return true;
}

wcut_status wcut_diagnosis_print(const wcut_diagnosis *diagnosis, const char *name, char **text) {
    if (!diagnosis || !name || !text || !is_diagnosis_whole(diagnosis)) return WCUT_BAD_ARGUMENT;

    /* head of the file */
    wcut_text out;
    if (!wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    wcut_text_print(&out, "{\n  \"format\": \"wirecut-diagnosis/1\",\n  \"version\": \"%s\"", WCUT_VERSION);
    put_diagnosis_string(&out, ",\n  \"case\": ", name);

    /* a diagnosis that was stopped says so, and where */
    if (diagnosis->interrupted) {
        wcut_text_put_word(&out, ",\n  \"interrupted\": true");
        put_diagnosis_string(&out, ",\n  \"stopped\": ", diagnosis->stopped);
    }

    /* the parts in the order of FORMATS.md */
    put_verdict(&out, diagnosis);
    put_diagnosis_effects(&out, diagnosis);
    put_small_effects(&out, diagnosis);
    put_recalibrated(&out, diagnosis);
    put_correction(&out, diagnosis);
    put_modelled(&out, diagnosis);
    put_mismatches(&out, diagnosis);
    put_fit(&out, diagnosis);
    put_weighed(&out, diagnosis);
    put_next(&out, diagnosis);
    wcut_text_put_word(&out, "\n}\n");

    return wcut_text_finish(&out, text, NULL);
}

wcut_status wcut_diagnosis_write(const wcut_diagnosis *diagnosis, const char *name, const char *path,
                                 wcut_error *error) {
    char *text = NULL;
    wcut_status status = path ? wcut_diagnosis_print(diagnosis, name, &text) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_fail(error, status, "diagnosis: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, strlen(text), error);
    free(text);
    return status;
}
