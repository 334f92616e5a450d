/* The findings on a diagnosis's page: the channels as they are, and what to do next. */
#include "io/report/report_findings.h"

#include <math.h>
#include <string.h>

enum { SERIES = 4, STEPS = 16, WINDOWS = 16 };

/* ---- channels ---- */

/* measured less residual: what a model says */
static const double *simulated(wcut_page_memory *memory, const wcut_residual_trace *t, const double *residual) {
    double *value = residual ? wcut_page_take(memory, (size_t)t->count, sizeof *value) : NULL;
    for (int i = 0; value && i < t->count; i++) value[i] = t->measured[i] - residual[i];
    return value;
}

static int list_windows(wcut_page_memory *memory, const wcut_diagnosis *d, const wcut_residual_trace *t,
                        wcut_report_span *span) {
    int count = 0;

    /* events of this cut */
    for (int k = 0; k < d->modelled.events && count < WINDOWS; k++) {
        const wcut_event *e = &d->modelled.event[k];
        if (e->cut != t->cut) continue;
        span[count++] = (wcut_report_span){.label = "event, left out of the fit",
                                           .from = {e->time[0], e->station[0]},
                                           .to = {e->time[1], e->station[1]}};
    }

    /* the worst mismatch of this channel */
    for (int k = 0; k < d->mismatches && count < WINDOWS; k++) {
        const wcut_mismatch *m = &d->mismatch[k];
        if (m->cut != t->cut || strcmp(m->column, t->column) != 0 || !isfinite(m->time[0] + m->time[1])) continue;
        span[count++] = (wcut_report_span){.label = wcut_page_text(memory, "%.0f %% of the misfit", 100 * m->share),
                                           .from = {m->time[0], m->station[0]},
                                           .to = {m->time[1], m->station[1]}};
        break; /* the worst one alone */
    }

    return count;
}

static void fill_trace_chart(wcut_page_memory *memory, const wcut_report_diagnose *of, const wcut_residual_trace *t,
                             wcut_report_chart *chart) {
    static const char *const label[SERIES] = {"measured", "simulated before", "recalibrated", "after"};
    static const wcut_report_mark mark[SERIES] = {WCUT_REPORT_MARK_POINTS, WCUT_REPORT_MARK_DASHED,
                                                  WCUT_REPORT_MARK_LINE, WCUT_REPORT_MARK_LINE};

    /* measured values as points, simulated ones as lines */
    const double *value[SERIES] = {t->measured, simulated(memory, t, t->before), simulated(memory, t, t->recalibrated),
                                   simulated(memory, t, t->after)};

    /* arrays of the page */
    wcut_report_series *series = wcut_page_take(memory, SERIES, sizeof *series);
    wcut_report_span *span = wcut_page_take(memory, WINDOWS, sizeof *span);
    int count = 0;

    /* models that were not run have no line */
    for (int m = 0; series && m < SERIES; m++) {
        if (!value[m]) continue;
        series[count] =
            (wcut_report_series){.label = label[m], .mark = mark[m], .count = t->count, .x = {t->time}, .y = value[m]};
        count++;
    }
    if (memory->failed) return;

    /* measured and simulated over time, with the windows that were left out */
    *chart = (wcut_report_chart){.title = wcut_page_text(memory, "%s, %s", t->column, of->cut_name[t->cut]),
                                 .x_label = {"time"},
                                 .x_unit = {"s"},
                                 .y_label = wcut_evidence_name(t->channel),
                                 .y_unit = wcut_evidence_unit(t->channel),
                                 .series_count = count,
                                 .series = series,
                                 .span_count = list_windows(memory, of->diagnosis, t, span),
                                 .span = span};
}

/* the channels that are drawn of a cut: tension and alpha of mount A, and the worst window's own */
static bool is_drawn(const wcut_residual_trace *t, int cut, const char *worst) {
    if (t->cut != cut || t->count < 2 || !t->measured) return false;
    return !strcmp(t->column, "tension_a_N") || !strcmp(t->column, "alpha_a_deg") || !strcmp(t->column, worst);
}

bool wcut_report_channels_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_section *section) {
    const wcut_diagnosis *d = of->diagnosis;

    /* room for all traces, though few are drawn */
    wcut_report_chart *chart = wcut_page_take(memory, (size_t)d->traces + 1, sizeof *chart);

    /* the channel and the cut of the worst misfit, and another cut, held out if there is one */
    const char *column = d->mismatches > 0 ? d->mismatch[0].column : "";
    const int worst = d->mismatches > 0 ? d->mismatch[0].cut : 0;
    int other = -1, count = 0;
    for (int k = 0; d->held_out && k < d->cuts && other < 0; k++)
        if (k != worst && d->held_out[k]) other = k;

    /* all channels of the first, then of the second */
    for (int pass = 0; chart && pass < 2; pass++)
        for (int i = 0; i < d->traces; i++)
            if (is_drawn(&d->trace[i], pass ? other : worst, column))
                fill_trace_chart(memory, of, &d->trace[i], &chart[count++]);
    if (memory->failed || count == 0) return false;

    /* what the reader sees, and by which models */
    *section = (wcut_report_section){
        .title = "Channels, measured and simulated",
        .note =
            "The cut of the worst misfit, then another one. Before: the job as it is; recalibrated: a, b and the "
            "wire's length; after: with what was found. Means over half a second.",
        .chart_count = count,
        .chart = chart};

    return true;
}

/* ---- what to do next ---- */

static const char *next_action(wcut_page_memory *memory, const wcut_found_effect *f) {
    /* which sensor or place is meant */
    const wcut_effect_info *info = wcut_effect_view(f->effect.kind);
    const char *which = info->choice ? info->choice[f->effect.choice] : "";
    switch (f->effect.kind) {
        case WCUT_EFFECT_TENSION_ZERO:
            return wcut_page_text(memory, "Tare tension sensor %s with the wire slack, before every cut.", which);
        case WCUT_EFFECT_TENSION_DELAY:
            return "Take the delay out of the tension readings: a filter of the amplifier, or a bus that is read late.";
        case WCUT_EFFECT_ANGLE_GAIN:
            return wcut_page_text(memory, "Calibrate the encoder %s at two known angles.", which);
        case WCUT_EFFECT_ENCODER_FRICTION:
            return "Clean and oil the joints of the heads: they hold back before they turn.";
        case WCUT_EFFECT_TENSION_GAIN:
        case WCUT_EFFECT_TENSION_DRIFT:
            /* a sensor's gain and drift show under a known weight */
            return wcut_page_text(memory, "Check tension sensor %s: hang a known weight on it, before and after a cut.",
                                  which);
        case WCUT_EFFECT_ANGLE_OFFSET:
            /* an encoder's zero shows on a straight wire */
            return wcut_page_text(memory, "Set the zero of the encoder %s: with a straight wire it must read 0.",
                                  which);
        case WCUT_EFFECT_CLOCK_OFFSET:
            return "Synchronise the clocks of robot and sensors, or trigger both from one signal.";
        case WCUT_EFFECT_WIRE_LENGTH:
            return wcut_page_text(memory, "Cut wires against a stop, and put the length of cut %d into its job.",
                                  f->cut);
        case WCUT_EFFECT_BLOCK_SHIFT:
            return "Put the block against its stops, and measure where its corner is in the frame of the robots.";
        case WCUT_EFFECT_SCAN_OFFSET:
        case WCUT_EFFECT_SCAN_SCALE:
            return "Register the scan again on datums of the block, and check the scanner on a known length.";
        case WCUT_EFFECT_WIRE_FOULING:
            return "Clean or change the wire, and cut the first job again: the force must return to its first value.";
        case WCUT_EFFECT_FOAM_INCLUSION:
        case WCUT_EFFECT_FOAM_DENSITY_GRADIENT:
            /* a fault of the foam stays with the block */
            return "Weigh or probe the block where the force differs, or turn the next block round: the place must "
                   "turn with it.";
        case WCUT_EFFECT_MOUNT_COMPLIANCE:
            return "Pull each mount with 2 N and measure its deflection.";
        case WCUT_EFFECT_BLOCK_SPRINGBACK:
            return "Measure the block clamped and unclamped, and clamp it as it will be used.";
        default:
            /* everything else is known well enough to be planned with */
            return wcut_page_text(memory, "Put %s into the jobs (wirecut apply): the simulation then plans with it.",
                                  info->name);
    }
}

/* what a contradiction in the recordings asks for; NULL: what its effect asks for */
static const char *contradiction_action(wcut_page_memory *memory, const wcut_contradiction *c) {
    switch (c->kind) {
        case WCUT_CONTRADICTION_EXCITATION:
            return "Cut the identification cuts again with the programs of wirecut path, which follow their "
                   "excitation.";
        case WCUT_CONTRADICTION_HEATER:
            return "Check the heater's supply under load, and the length of wire that it heats.";
        case WCUT_CONTRADICTION_STATION:
            return "Check how the station is recorded: over a known way it must be that of the path.";
        case WCUT_CONTRADICTION_SPEED:
            return "Check the speeds and the clock of the recording over a known way.";
        case WCUT_CONTRADICTION_PLACES:
            return wcut_page_text(memory, "Measure where the mounts are at the first station (%s).", c->column);
        default:
            return NULL;
    }
}

/* the steps that a verdict asks for; gives how many */
static int list_steps(wcut_page_memory *memory, const wcut_diagnosis *d, const char **step) {
    /* what each contradiction asks for, each kind once, then each named effect */
    int count = 0;
    for (int k = 0; k < d->contradictions && count < 3; k++) {
        const char *action = contradiction_action(memory, &d->contradiction[k]);
        bool said = false;
        for (int j = 0; j < k; j++) said = said || d->contradiction[j].kind == d->contradiction[k].kind;
        if (action && !said) step[count++] = action;
    }
    const int before = count;
    for (int e = 0; e < d->effects && d->kind != WCUT_VERDICT_AMBIGUOUS; e++)
        if (d->effect[e].present && count < before + 4) step[count++] = next_action(memory, &d->effect[e]);

    /* events: ask what happened then */
    for (int e = 0; e < d->modelled.events && e < 3; e++)
        step[count++] =
            wcut_page_text(memory,
                           "Look up what happened in cut %d from %.0f to %.0f s: supply of the heater, "
                           "lumps on the wire, contact with the machine.",
                           d->modelled.event[e].cut + 1, d->modelled.event[e].time[0], d->modelled.event[e].time[1]);

    /* terms, alternatives, and an unknown cause */
    if (d->modelled.terms > 0)
        step[count++] =
            "Look for the cause of the effect that is described above. Until it is known, plan with the term: it "
            "predicts the held-out cuts.";
    if (d->next_experiment)
        step[count++] = "Cut next-experiment.json and diagnose it with the others: it separates the alternatives.";
    if (d->kind == WCUT_VERDICT_UNKNOWN && d->modelled.terms == 0 && d->modelled.events == 0)
        step[count++] =
            "Do not recalibrate by these cuts. Make identification cuts (wirecut identify) of the same job, record "
            "the heater's volts and amperes, and diagnose again.";

    /* nothing found, and the correction */
    if (d->kind == WCUT_VERDICT_NONE)
        step[count++] = d->contradictions > 0
                            ? "Accept the cuts: beside what is said above, no difference beyond noise."
                            : "Accept: no difference beyond noise.";
    if (!d->withheld[0])
        step[count++] = "Recalibrate: put the correction into the jobs of this foam, wire and machine (wirecut apply).";

    return count;
}

/* the files beside the page, and what each is for */
static int list_files(const wcut_diagnosis *d, const char **name, const char **use) {
    int count = 0;
    name[count] = "diagnosis.json",
    use[count++] = "everything on this page in numbers; wirecut apply diagnosis.json JOB -o JOB2";
    if (d->improved)
        name[count] = "job-improved.json",
        use[count++] =
            "the first cut's job, corrected, without its excitation: simulate, path, mould and score take it";
    if (d->next_experiment)
        name[count] = "next-experiment.json", use[count++] = "a job to cut next, with its own excitation";
    return count;
}

bool wcut_report_next_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_section *section) {
    wcut_report_table *table = wcut_page_take(memory, 2, sizeof *table);
    wcut_report_column *column = wcut_page_take(memory, 3, sizeof *column);
    const char **step = wcut_page_take(memory, STEPS, sizeof *step), **name = wcut_page_take(memory, 4, sizeof *name),
               **use = wcut_page_take(memory, 4, sizeof *use);
    if (memory->failed) return false;
    column[0] = (wcut_report_column){.label = "step", .text = step};
    column[1] = (wcut_report_column){.label = "file", .text = name};
    column[2] = (wcut_report_column){.label = "use", .text = use};
    const wcut_diagnosis *d = of->diagnosis;
    table[0] =
        (wcut_report_table){.title = "Steps", .rows = list_steps(memory, d, step), .columns = 1, .column = column};
    table[1] = (wcut_report_table){
        .title = "Files of this diagnosis", .rows = list_files(d, name, use), .columns = 2, .column = column + 1};
    *section = (wcut_report_section){.title = "What to do next", .table_count = 2, .table = table};
    if (d->withheld[0]) section->note = wcut_page_text(memory, "There is no correction: %s.", d->withheld);
    return !memory->failed;
}
