/* The page of a diagnosis: the verdict, what it rests on, what else was weighed, what it is worth on other cuts. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/page_memory.h"
#include "io/report/report_evidence.h"
#include "io/report/report_findings.h"
#include "io/report/report_instruments.h"

enum { SECTIONS_BESIDE_CUTS = 8 };

typedef struct page {
    const wcut_report_diagnose *of;
    const wcut_diagnosis *d;
    wcut_page_memory memory;
    wcut_report_scene scene;
} page;

/* ---- words ---- */

/* "foam density gradient, axis y" */
static const char *words_of(page *p, const wcut_effect *effect) {
    const wcut_effect_info *info = wcut_effect_view(effect->kind);
    char name[80];
    snprintf(name, sizeof name, "%s", info->name);
    for (char *c = name; *c; c++)
        if (*c == '_') *c = ' ';
    if (!info->choice_key) return wcut_page_text(&p->memory, "%s", name);
    return wcut_page_text(&p->memory, "%s, %s %s", name, info->choice_key, info->choice[effect->choice]);
}

static const char *hypothesis_words(page *p, const wcut_hypothesis *h) {
    if (h->count == 0) return "recalibration alone";
    const char *first = words_of(p, &h->effect[0]);
    return h->count == 1 ? first : wcut_page_text(&p->memory, "%s + %s", first, words_of(p, &h->effect[1]));
}

/* the column of a table with room for its rows */
static double *numbers(page *p, wcut_report_column *column, const char *label, const char *unit, int rows) {
    double *number = wcut_page_take(&p->memory, (size_t)rows, sizeof *number);
    *column = (wcut_report_column){.label = label, .unit = unit, .number = number};
    return number;
}

static const char **texts(page *p, wcut_report_column *column, const char *label, int rows) {
    const char **text = wcut_page_take(&p->memory, (size_t)rows, sizeof *text);
    *column = (wcut_report_column){.label = label, .text = text};
    return text;
}

static wcut_report_column *columns(page *p, int count) {
    return wcut_page_take(&p->memory, (size_t)count, sizeof(wcut_report_column));
}

/* what a page can show: infinite ends and what was not estimated become a dash */
static double shown(double value) { return isfinite(value) && fabs(value) < 1e30 ? value : NAN; }

/* a number of its own size: a column of numbers has one precision for all */
static const char *number_words(page *p, double value) {
    return isfinite(value) ? wcut_page_text(&p->memory, "%.4g", value) : NULL;
}

/* ---- what was found ---- */

static int count_values(const wcut_diagnosis *d) {
    int count = 0;
    for (int e = 0; e < d->effects; e++)
        for (const wcut_effect_parameter *q = wcut_effect_view(d->effect[e].effect.kind)->parameter; q->key; q++)
            count += q->size;
    return count;
}

static wcut_report_table effect_table(page *p) {
    const wcut_diagnosis *d = p->d;

    /* columns of texts and one of numbers */
    const int rows = count_values(d);
    wcut_report_column *c = columns(p, 7);
    wcut_report_table table = {.title = "Effects and their parameters", .columns = 7, .column = c};
    if (!c) return table;
    const char **effect = texts(p, &c[0], "effect", rows), **verdict = texts(p, &c[1], "is", rows);
    double *confidence = numbers(p, &c[2], "confidence", "%", rows);
    const char **key = texts(p, &c[3], "parameter", rows);
    const char **value = texts(p, &c[4], "value", rows), **low = texts(p, &c[5], "95 % from", rows),
               **high = texts(p, &c[6], "to", rows);
    if (p->memory.failed) return table;
    table.note =
        "A value without an interval was not fitted: it has its default. A dash is an end that the data leave open.";

    /* a row for each parameter of each effect, three for a vector */
    for (int e = 0; e < d->effects; e++) {
        const wcut_found_effect *f = &d->effect[e];

        /* a vector has a row for each component */
        for (const wcut_effect_parameter *q = wcut_effect_view(f->effect.kind)->parameter; q->key; q++)
            for (int k = 0; k < q->size; k++) {
                const int r = table.rows++;
                const wcut_estimate *estimate = &f->parameter[q->at + k];
                const bool estimated = f->estimated[q->at + k];
                effect[r] = words_of(p, &f->effect);
                verdict[r] = f->present ? "present" : "possible";
                confidence[r] = 100 * f->confidence;
                key[r] = q->size == 1 ? q->key : wcut_page_text(&p->memory, "%s, %c", q->key, 'x' + k);
                value[r] = number_words(p, f->effect.value[q->at + k]);
                low[r] = estimated ? number_words(p, estimate->low) : NULL;
                high[r] = estimated ? number_words(p, estimate->high) : NULL;
            }
    }

    return table;
}

/* what stands out, but is of no consequence for the cut: a row for each number that was fitted */
static wcut_report_table small_table(page *p) {
    const wcut_found_effect *f = &p->d->small_effect.found;
    wcut_report_column *c = columns(p, 7);
    wcut_report_table table = {.title = "Present, but too small to matter", .columns = 7, .column = c};
    if (!c) return table;

    /* what it is, its interval, what it moves */
    const char **effect = texts(p, &c[0], "effect", WCUT_EFFECT_VALUES);
    const char **key = texts(p, &c[1], "parameter", WCUT_EFFECT_VALUES);
    const char **value = texts(p, &c[2], "value", WCUT_EFFECT_VALUES);
    const char **low = texts(p, &c[3], "95 % from", WCUT_EFFECT_VALUES);
    const char **high = texts(p, &c[4], "to", WCUT_EFFECT_VALUES);
    const char **tension = texts(p, &c[5], "moves the tensions [N]", WCUT_EFFECT_VALUES);
    const char **face = texts(p, &c[6], "moves the face [mm]", WCUT_EFFECT_VALUES);
    if (p->memory.failed) return table;
    table.note =
        "It stands out of noise and scatter, on cuts left out too, but is below the size worth acting on. What it "
        "moves is its largest part, means over 0.5 s and over patches of the scans.";
    for (const wcut_effect_parameter *q = wcut_effect_view(f->effect.kind)->parameter; q->key; q++)
        for (int k = 0; k < q->size; k++) {
            const wcut_estimate *estimate = &f->parameter[q->at + k];
            if (!f->estimated[q->at + k]) continue;

            /* what it moves is said once */
            const int r = table.rows++;
            effect[r] = words_of(p, &f->effect);
            key[r] = q->size == 1 ? q->key : wcut_page_text(&p->memory, "%s, %c", q->key, 'x' + k);
            value[r] = number_words(p, estimate->value);
            low[r] = number_words(p, estimate->low), high[r] = number_words(p, estimate->high);
            tension[r] = r == 0 ? number_words(p, p->d->small_effect.tension) : NULL;
            face[r] = r == 0 ? number_words(p, p->d->small_effect.face) : NULL;
        }

    return table;
}

static wcut_report_table base_table(page *p) {
    const wcut_diagnosis *d = p->d;

    /* values of the jobs and those of the fit */
    const struct {
        const char *name;
        double job;
        const wcut_estimate *found;
    } row[] = {{"a [N/mm]", d->a_job, &d->a},
               {"b [m2/J]", d->b_job, &d->b},
               {"wire's length, change [mm]", 0, &d->length_change},
               {"constant kerf that the scans show [mm]", NAN, &d->kerf}};
    enum { ROWS = sizeof row / sizeof *row };

    /* columns: name, value of the job, value found, its interval */
    wcut_report_column *c = columns(p, 5);
    wcut_report_table table = {.title = "Recalibrated", .columns = 5, .column = c};
    table.note = "Recalibrated before the effects are fitted; one value for all cuts.";
    if (!c) return table;

    const char **name = texts(p, &c[0], "of the plain model", ROWS);
    const char **job = texts(p, &c[1], "the job says", ROWS), **value = texts(p, &c[2], "value", ROWS),
               **low = texts(p, &c[3], "95 % from", ROWS), **high = texts(p, &c[4], "to", ROWS);
    if (p->memory.failed) return table;

    /* a row for each value, found for all cuts together */
    for (int r = 0; r < ROWS; r++) {
        name[r] = row[r].name, job[r] = number_words(p, row[r].job), value[r] = number_words(p, row[r].found->value);
        low[r] = number_words(p, row[r].found->low), high[r] = number_words(p, row[r].found->high);
    }

    table.rows = ROWS;

    return table;
}

static wcut_report_table limit_table(page *p) {
    const wcut_report_diagnose *of = p->of;
    const int rows = of->said + p->d->limits;
    wcut_report_column *c = columns(p, 1);
    wcut_report_table table = {.title = "What could not be determined", .columns = 1, .column = c};
    const char **text = c ? texts(p, &c[0], "why", rows) : NULL;
    if (!text) return table;
    for (int i = 0; i < of->said; i++) text[table.rows++] = of->said_text[i];
    for (int i = 0; i < p->d->limits; i++) text[table.rows++] = p->d->limit[i];
    return table;
}

static wcut_report_table next_table(page *p) {
    const wcut_job *job = p->d->next_experiment;
    wcut_report_column *c = columns(p, 2);
    wcut_report_table table = {.title = "Next experiment", .columns = 2, .column = c};
    const char **label = c ? texts(p, &c[0], "what", 4) : NULL, **text = c ? texts(p, &c[1], "which", 4) : NULL;
    if (!label || !text) return table;
    label[0] = "cut", text[0] = job->name ? job->name : "";
    label[1] = "job", text[1] = "next-experiment.json";
    label[2] = "why", text[2] = p->d->next_reason;
    label[3] = "excitation", text[3] = wcut_page_text(&p->memory, "%d sines on the speed, %d heater steps",
                                                      job->dither_count, job->heat_step_count);
    table.rows = 4;
    return table;
}

static bool fill_found(page *p, wcut_report_section *section) {
    wcut_report_table *table = wcut_page_take(&p->memory, 5, sizeof *table);
    int count = 0;
    if (!table) return false;
    if (p->d->effects > 0) table[count++] = effect_table(p);
    if (p->d->small_effects > 0) table[count++] = small_table(p);
    table[count++] = base_table(p);
    if (p->d->limits + p->of->said > 0) table[count++] = limit_table(p);
    if (p->d->next_experiment) table[count++] = next_table(p);
    *section = (wcut_report_section){.title = "What was found", .table_count = count, .table = table};
    return !p->memory.failed;
}

/* ---- what it is worth ---- */

typedef const wcut_evidence_score (*fits)[WCUT_EVIDENCE_CHANNEL_COUNT];

static double score_figure(const wcut_evidence_score *f, bool with_bias) {
    return f->count > 0 ? shown(with_bias ? f->rmse_over_range : f->nrmsd) : NAN;
}

/* a row a channel, a column a model */
static wcut_report_table fit_table(page *p, const char *title, const char *note, fits fit, bool with_bias) {
    static const char *const label[WCUT_EVIDENCE_MODEL_COUNT] = {"before", "recalibrated", "after", "black box"};

    /* a column for each model between the channel and the interval */
    wcut_report_column *c = columns(p, WCUT_EVIDENCE_MODEL_COUNT + 2);
    wcut_report_table table = {.title = title, .note = note, .columns = with_bias ? 6 : 5, .column = c};
    const char **name = c ? texts(p, &c[0], "channel", WCUT_EVIDENCE_CHANNEL_COUNT) : NULL;
    const char **interval =
        c ? texts(p, &c[WCUT_EVIDENCE_MODEL_COUNT + 1], "95 % after", WCUT_EVIDENCE_CHANNEL_COUNT) : NULL;
    double *number =
        wcut_page_take(&p->memory, (size_t)WCUT_EVIDENCE_MODEL_COUNT * WCUT_EVIDENCE_CHANNEL_COUNT, sizeof *number);
    if (!c || !name || !interval || !number) return table;
    for (int m = 0; m < WCUT_EVIDENCE_MODEL_COUNT; m++)
        c[m + 1] = (wcut_report_column){.label = label[m], .number = number + (size_t)m * WCUT_EVIDENCE_CHANNEL_COUNT};

    /* a row for each channel that any model was compared with */
    for (int k = 0; k < WCUT_EVIDENCE_CHANNEL_COUNT; k++) {
        const int r = table.rows;
        bool there = false;
        for (int m = 0; m < WCUT_EVIDENCE_MODEL_COUNT; m++) {
            number[m * WCUT_EVIDENCE_CHANNEL_COUNT + r] = score_figure(&fit[m][k], with_bias);
            there = there || fit[m][k].count > 0;
        }
        if (!there) continue;

        /* the interval belongs to the model with the effects */
        const wcut_evidence_score *after = &fit[WCUT_EVIDENCE_MODEL_AFTER][k];
        name[r] = wcut_evidence_name((wcut_evidence_channel)k);
        interval[r] = after->count > 0 && isfinite(after->low) && isfinite(after->high)
                          ? wcut_page_text(&p->memory, "%.3g to %.3g", after->low, after->high)
                          : NULL;
        table.rows++;
    }

    return table;
}

static bool fill_worth(page *p, wcut_report_section *section) {
    /* what the two figures see */
    const wcut_diagnosis *d = p->d;
    static const char *const bias = "Includes a bias.";
    static const char *const blind = "RMSD over range: excludes a bias.";

    /* held-out cuts first, then all; each with and without a bias */
    wcut_report_table *table = wcut_page_take(&p->memory, 4, sizeof *table);
    if (!table) return false;
    table[0] = fit_table(p, "Held-out cuts: RMSE over range", bias, d->held_out_score, true);
    table[1] = fit_table(p, "Held-out cuts: NRMSD", blind, d->held_out_score, false);
    table[2] = fit_table(p, "All cuts, all fitted: RMSE over range", bias, d->score, true);
    table[3] = fit_table(p, "All cuts, all fitted: NRMSD", blind, d->score, false);

    /* leading tables without rows are not shown */
    int first = 0;
    while (first < 4 && table[first].rows == 0) first++;
    if (first == 4) return false;
    *section = (wcut_report_section){.title = "Quality of the predictions",
                                     .note =
                                         "The speed is that of the planned run, which is never fitted, while the "
                                         "tension is within 10 % of its target; the other channels are replayed. The "
                                         "black box is a regression of the recalibrated residuals without physics.",
                                     .table_count = 4 - first,
                                     .table = table + first};

    return !p->memory.failed;
}

/* ---- what else was weighed ---- */

static wcut_report_table ranking_table(page *p) {
    const wcut_diagnosis *d = p->d;

    /* columns: name, five figures, the reason */
    const int rows = d->hypotheses;
    wcut_report_column *c = columns(p, 7);
    wcut_report_table table = {.title = "All hypotheses, best first", .columns = 7, .column = c};
    table.note =
        "Gain: decrease of the misfit against recalibration alone, in chi-square units. Held out: the same for cuts "
        "predicted from the other cuts. Adequacy: remaining misfit over that of noise alone; 1 is adequate.";
    if (!c) return table;

    /* all columns exist before the first row is filled */
    const char **name = texts(p, &c[0], "explanation", rows);
    double *number[5];
    static const char *const label[5] = {"parameters", "gain", "held-out gain", "adequacy", "probability"};
    for (int k = 0; k < 5; k++) number[k] = numbers(p, &c[k + 1], label[k], k == 4 ? "%" : "", rows);
    const char **why = texts(p, &c[6], "not chosen because", rows);
    if (p->memory.failed) return table;

    /* a row for each hypothesis */
    for (int r = 0; r < rows; r++) {
        const wcut_hypothesis *h = &d->hypothesis[r];
        name[r] = hypothesis_words(p, h);
        number[0][r] = h->parameters, number[1][r] = shown(h->gain), number[2][r] = shown(h->held_out);
        number[3][r] = shown(h->adequacy), number[4][r] = shown(100 * h->probability);
        why[r] = h->why && h->why[0] ? h->why : "chosen";
    }
    table.rows = rows;

    return table;
}

static wcut_report_table dependence_table(page *p) {
    const wcut_diagnosis *d = p->d;

    /* columns: quantity, where it shows, coefficient with interval, gain */
    const int rows = d->dependences;
    wcut_report_column *c = columns(p, 6);
    wcut_report_table table = {.title = "What the residual depends on", .columns = 6, .column = c};
    table.note =
        "No known effect explains the residual. These are the quantities that the foam's force would have to depend "
        "on. Coefficient: relative change of the force per unit of the quantity.";
    if (!c) return table;
    const char **quantity = texts(p, &c[0], "quantity", rows), **channel = texts(p, &c[1], "seen best in", rows);
    const char **value = texts(p, &c[2], "coefficient", rows), **low = texts(p, &c[3], "95 % from", rows),
               **high = texts(p, &c[4], "to", rows);
    double *gain = numbers(p, &c[5], "held-out gain", "", rows);
    if (p->memory.failed) return table;

    /* a row for each quantity */
    for (int r = 0; r < rows; r++) {
        const wcut_dependence *x = &d->dependence[r];
        quantity[r] = x->quantity, channel[r] = wcut_evidence_name(x->channel);
        value[r] = number_words(p, x->coefficient.value), low[r] = number_words(p, x->coefficient.low);
        high[r] = number_words(p, x->coefficient.high), gain[r] = shown(x->gain);
    }
    table.rows = rows;

    return table;
}

static bool fill_weighed(page *p, wcut_report_section *section) {
    wcut_report_table *table = wcut_page_take(&p->memory, 2, sizeof *table);
    int count = 0;
    if (!table) return false;
    if (p->d->hypotheses > 0) table[count++] = ranking_table(p);
    if (p->d->dependences > 0) table[count++] = dependence_table(p);
    *section = (wcut_report_section){.title = "Hypotheses compared", .table_count = count, .table = table};
    return !p->memory.failed && count > 0;
}

/* ---- where ---- */

static const char *span_words(page *p, double from, double to) {
    return isfinite(from) && isfinite(to) ? wcut_page_text(&p->memory, "%.4g .. %.4g", from, to) : NULL;
}

static bool fill_where(page *p, wcut_report_section *section) {
    const wcut_diagnosis *d = p->d;
    const int rows = d->mismatches;

    /* columns: where it lies, then how large and how certain it is */
    wcut_report_column *c = columns(p, 12);
    wcut_report_table *table = wcut_page_take(&p->memory, 1, sizeof *table);
    if (!c || !table || rows == 0) return false;
    static const char *const label[8] = {"cut",   "channel", "time, s", "station", "along the wire, mm",
                                         "x, mm", "y, mm",   "z, mm"};
    const char **text[8];
    for (int k = 0; k < 8; k++) text[k] = texts(p, &c[k], label[k], rows);
    const char **mean = texts(p, &c[8], "measured less model", rows);
    double *share = numbers(p, &c[9], "share of the misfit", "%", rows), *p_value = numbers(p, &c[10], "p", "", rows);
    const char **regime = texts(p, &c[11], "while", rows);
    if (p->memory.failed) return false;

    /* a row for each mismatch */
    for (int r = 0; r < rows; r++) {
        const wcut_mismatch *m = &d->mismatch[r];
        text[0][r] = m->cut >= 0 && m->cut < d->cuts ? p->of->cut_name[m->cut] : "all";
        text[1][r] = m->column;
        text[2][r] = span_words(p, m->time[0], m->time[1]);
        text[3][r] = span_words(p, m->station[0], m->station[1]);
        text[4][r] = span_words(p, m->wire[0], m->wire[1]);
        text[5][r] = span_words(p, m->block[0].x, m->block[1].x);
        text[6][r] = span_words(p, m->block[0].y, m->block[1].y);
        text[7][r] = span_words(p, m->block[0].z, m->block[1].z);
        mean[r] =
            isfinite(m->mean) ? wcut_page_text(&p->memory, "%+.3g %s", m->mean, wcut_evidence_unit(m->channel)) : NULL;
        share[r] = shown(100 * m->share), p_value[r] = shown(m->p_value), regime[r] = m->regime;
    }

    /* one table, one section */
    *table = (wcut_report_table){.title = "Where model and measurement differ by more than noise, after recalibration",
                                 .note = "p-values are corrected for the search.",
                                 .rows = rows,
                                 .columns = 12,
                                 .column = c};
    *section = (wcut_report_section){.title = "Where", .table_count = 1, .table = table};

    return !p->memory.failed;
}

/* ---- the page ---- */

static wcut_report_tone tone_of(const wcut_diagnosis *d) {
    if (d->interrupted) return WCUT_REPORT_TONE_WARNING;
    if (d->kind == WCUT_VERDICT_NONE) return WCUT_REPORT_TONE_GOOD;
    return d->kind == WCUT_VERDICT_UNKNOWN || d->kind == WCUT_VERDICT_AMBIGUOUS ? WCUT_REPORT_TONE_WARNING
                                                                                : WCUT_REPORT_TONE_PLAIN;
}

/* mean over the channels of RMSE over range after over recalibrated, on held-out cuts; NaN: none */
static double improvement(const wcut_diagnosis *d) {
    double sum = 0;
    int count = 0;
    for (int c = 0; c < WCUT_EVIDENCE_CHANNEL_COUNT; c++) {
        const wcut_evidence_score *from = &d->held_out_score[WCUT_EVIDENCE_MODEL_RECALIBRATED][c],
                                  *to = &d->held_out_score[WCUT_EVIDENCE_MODEL_AFTER][c];
        if (from->count < 1 || to->count < 1 || !(from->rmse_over_range > 0) || !(to->rmse_over_range > 0)) continue;
        sum += to->rmse_over_range / from->rmse_over_range;
        count++;
    }
    return count > 0 ? sum / count : NAN;
}

static wcut_status write_diagnose_page(page *p, int sections, const wcut_report_section *section, const char *path,
                                       wcut_error *error) {
    const wcut_diagnosis *d = p->d;

    /* how many cuts were held out */
    int held = 0;
    for (int i = 0; d->held_out && i < d->cuts; i++) held += d->held_out[i];
    char cuts[60];
    snprintf(cuts, sizeof cuts, "%d in all, %d held out", d->cuts, held);

    /* the answer in numbers */
    const wcut_report_fact fact[] = {{"verdict", wcut_verdict_name(d->kind), 0, ""},
                                     {"confidence that it is exactly right", NULL, 100 * d->confidence, "%"},
                                     {"cuts", cuts, 0, ""},
                                     {"misfit on held-out cuts, after over recalibrated", NULL, improvement(d), ""},
                                     {"remaining misfit over that of noise alone", NULL, shown(d->adequacy), ""},
                                     {"p-value of this misfit", NULL, shown(d->adequacy_p), ""},
                                     {"plain least squares would name", d->naive, 0, ""}};

    const wcut_report report = {.verb = "diagnose",
                                .title = p->of->title,
                                .tone = tone_of(d),
                                .verdict = d->sentence,
                                /* the last one where it was run */
                                .fact_count = (int)(sizeof fact / sizeof *fact) - (d->naive[0] == 0),
                                .fact = fact,
                                .scene = p->scene.shape_count > 0 ? &p->scene : NULL,
                                .section_count = sections,
                                .section = section,
                                .source_count = p->of->sources,
                                .source = p->of->source,
                                .option_count = p->of->options,
                                .option = p->of->option};

    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_diagnose_write(const wcut_report_diagnose *diagnosed, const char *path, wcut_error *error) {
    if (!diagnosed || !diagnosed->diagnosis || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.of = diagnosed, .d = diagnosed->diagnosis};

    /* sections in the order of the reader's questions: what next, what was found, what it is worth */
    int count = 0;
    wcut_report_section *section = wcut_page_take(&p.memory, SECTIONS_BESIDE_CUTS + (size_t)p.d->cuts, sizeof *section);
    if (section) {
        /* the view in space, if there is a surface */
        wcut_report_block_fill(&p.memory, diagnosed, &p.scene);
        count += wcut_report_next_fill(&p.memory, diagnosed, &section[count]);
        count += wcut_report_channels_fill(&p.memory, diagnosed, &section[count]);
        count += wcut_report_evidence_fill(&p.memory, diagnosed, &section[count]);
        count += fill_found(&p, &section[count]);
        count += wcut_report_instruments_fill(&p.memory, diagnosed, &section[count]);
        count += fill_worth(&p, &section[count]);
        count += fill_weighed(&p, &section[count]);
        count += fill_where(&p, &section[count]);
    }

    /* the residuals of every cut */
    for (int cut = 0; section && cut < p.d->cuts; cut++)
        count += wcut_report_residuals_fill(&p.memory, diagnosed, cut, &section[count]);
    const wcut_status status = p.memory.failed ? WCUT_NO_MEMORY : write_diagnose_page(&p, count, section, path, error);

    wcut_page_free(&p.memory);
    return status;
}
