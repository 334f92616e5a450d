/* The page of a calibration: the laws and how sure they are, each over its cuts with its band, residuals, every cut. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/page_memory.h"

#define PERCENT 100

enum { CURVE = 201, CHARTS = 5, TABLES = 3, COLUMNS = 12, LAWS = 2 };

#define A_UNIT "N/mm"
#define B_UNIT "m\xc2\xb2/J"
#define Q_UNIT "J/m\xc2\xb2"

/* what every chart and table is drawn from, a value a cut */
typedef struct columns {
    double *line, *heat, *speed, *q_eff;
} columns;

typedef struct page {
    const wcut_report_calibrate *of;
    columns cuts;
    wcut_page_memory memory;
    char hash[WCUT_SHA256_TEXT];
} page;

/* one of the laws, as a section is made from it */
typedef struct law {
    const char *title, *symbol, *chart, *label; /* "Force law", "F = a exp(-b Q_eff)", "Force per engaged length" */
    int parameters;
    const wcut_law_fit *fit;
    const wcut_law_fit_point **point; /* cuts */
} law;

static double *take_numbers(page *p, int count) { return wcut_page_take(&p->memory, (size_t)count, sizeof(double)); }

static bool is_relative(const wcut_report_calibrate *of) { return of->options->noise == WCUT_NOISE_RELATIVE; }

/* ---- sentences ---- */

void wcut_report_calibrate_scatter(const wcut_report_calibrate *of, const wcut_law_fit *fit,
                                   char sentence[WCUT_REPORT_SENTENCE]) {
    const bool relative = is_relative(of);
    const double unit = relative ? PERCENT : 1;
    snprintf(
        sentence, WCUT_REPORT_SENTENCE,
        "scatter about the law %.3g %s (standard deviation), leave-one-out error %.3g %s (root mean square of %d cuts)",
        unit * fit->scale, relative ? "%" : A_UNIT, unit * fit->leave_one_out, relative ? "%" : A_UNIT, fit->left_out);
}

void wcut_report_calibrate_lack(const wcut_law_fit *fit, char sentence[WCUT_REPORT_SENTENCE]) {
    if (fit->lack == WCUT_LACK_OF_FIT_UNTESTED)
        snprintf(sentence, WCUT_REPORT_SENTENCE, "the fit cannot be tested: too few cuts, or no scatter");
    else
        snprintf(sentence, WCUT_REPORT_SENTENCE, "%s, tested against %s: F(%d, %d) = %.2f, p = %.2g",
                 fit->lack_p < 0.05 ? "the law does not fit" : "no lack of fit",
                 fit->lack == WCUT_LACK_OF_FIT_REPLICATE ? "the scatter of repeated cuts"
                                                         : "a curvature in Q_eff and a power of the speed",
                 fit->lack_degrees[0], fit->lack_degrees[1], fit->lack_f, fit->lack_p);
}

static wcut_report_tone judge_calibrate(const wcut_report_calibrate *of, char *verdict, size_t size) {
    const wcut_law_fit *f = &of->fit->force;
    const bool tested = f->lack != WCUT_LACK_OF_FIT_UNTESTED, fits = !tested || f->lack_p >= 0.05;

    /* the answer: both parameters with their intervals */
    int n = snprintf(verdict, size,
                     "%d cuts give the force law a = %.4g " A_UNIT " (%g %% interval %.4g to %.4g), b = %.4g " B_UNIT
                     " (%.4g to %.4g); a and b %s",
                     of->cuts, f->a, PERCENT * of->options->confidence, f->low[0], f->high[0], f->b, f->low[1],
                     f->high[1], of->fit->separable ? "are separated" : "cannot be separated");

    /* what the test of the fit says */
    char *rest = verdict + n;
    size -= (size_t)n;
    if (!tested)
        snprintf(rest, size, "; the fit cannot be tested.");
    else
        snprintf(rest, size, fits ? "; no lack of fit (p = %.2g)." : ", but the law does not fit (p = %.2g).",
                 f->lack_p);

    /* a law that does not fit, or whose parameters trade against each other, needs a second look */
    return !fits || !of->fit->separable || of->warnings > 0 ? WCUT_REPORT_TONE_WARNING
           : tested                                         ? WCUT_REPORT_TONE_GOOD
                                                            : WCUT_REPORT_TONE_PLAIN;
}

/* ---- charts ---- */

static wcut_report_series points(const char *label, int count, const double *x, const double *y) {
    return (wcut_report_series){
        .label = label, .mark = WCUT_REPORT_MARK_POINTS, .count = count, .x = {x, NULL}, .y = y};
}

/* the values of the cuts that have something unusual, NaN elsewhere; NULL where none has */
static double *pick_unusual(page *p, const law *l, const double *y) {
    int marked = 0;

    /* the same length as y, so that both share the abscissa */
    double *out = take_numbers(p, p->of->cuts);
    for (int i = 0; out && i < p->of->cuts; i++) {
        const wcut_law_fit_point *point = l->point[i];
        const bool unusual = point && point->unusual;
        out[i] = unusual ? y[i] : NAN;
        marked += unusual;
    }
    return marked ? out : NULL;
}

/* a series for the eye, the cuts, and those of them that want a second look */
static wcut_report_chart chart_of_cuts(page *p, const law *l, const char *title, const char *x_label,
                                       const char *x_unit, const double *x, const char *y_label, const char *y_unit,
                                       const double *y, const wcut_report_series *guide) {
    /* the guide, the cuts, and those that are marked */
    wcut_report_series *series = wcut_page_take(&p->memory, 3, sizeof *series);
    wcut_report_chart chart = {.title = title,
                               .x_label = {x_label, NULL},
                               .x_unit = {x_unit, NULL},
                               .y_label = y_label,
                               .y_unit = y_unit,
                               .series = series};
    if (p->memory.failed) return chart;

    /* the guide first, so that the cuts are drawn over it */
    const double *unusual = pick_unusual(p, l, y);
    series[0] = *guide;
    series[1] = points("test cuts", p->of->cuts, x, y);
    if (unusual) series[2] = points("marked in the table", p->of->cuts, x, unusual);
    chart.series_count = unusual ? 3 : 2;

    return chart;
}

/* the fitted curve with its band, where the law is validated */
static wcut_report_chart curve_chart(page *p, const law *l, const double *measured) {
    /* arrays of the page: they live until it is written */
    const wcut_calibration *fit = p->of->fit;
    double *q = take_numbers(p, CURVE), *y = take_numbers(p, CURVE);
    double *low = take_numbers(p, CURVE), *high = take_numbers(p, CURVE);
    char *note = wcut_page_take(&p->memory, WCUT_REPORT_SENTENCE, 1);
    if (p->memory.failed) return (wcut_report_chart){.title = l->title};

    /* an even grid over the validated range */
    for (int k = 0; k < CURVE; k++) q[k] = fit->q_eff_low + (fit->q_eff_high - fit->q_eff_low) * k / (CURVE - 1);
    wcut_law_fit_eval(l->fit, p->of->options->confidence, CURVE, q, y, low, high);

    /* the law with its band, then the cuts */
    const wcut_report_series guide = {
        .label = "fitted law", .count = CURVE, .x = {q}, .y = y, .low = low, .high = high};
    wcut_report_chart chart = chart_of_cuts(p, l, l->chart, "effective heat input Q_eff", Q_UNIT, p->cuts.q_eff,
                                            l->label, A_UNIT, measured, &guide);

    /* what the band means */
    snprintf(note, WCUT_REPORT_SENTENCE,
             "The band contains the law with %g %% confidence at each Q_eff; a single cut may lie outside.",
             PERCENT * p->of->options->confidence);
    chart.note = note;

    return chart;
}

/* a level line as long as the cuts spread, where the residuals should lie */
static wcut_report_series zero(page *p, const double *x) {
    double *end = take_numbers(p, 2), *level = take_numbers(p, 2);
    wcut_report_series line = {.label = "the law", .mark = WCUT_REPORT_MARK_DASHED, .count = 2, .x = {end}, .y = level};
    if (p->memory.failed) return line;

    /* from the smallest abscissa to the largest */
    end[0] = end[1] = x[0];
    for (int i = 1; i < p->of->cuts; i++) {
        if (x[i] < end[0]) end[0] = x[i];
        if (x[i] > end[1]) end[1] = x[i];
    }
    return line;
}

static wcut_report_chart residual_chart(page *p, const law *l, const char *title, const char *x_label,
                                        const char *x_unit, const double *x, const double *residual) {
    const wcut_report_series guide = zero(p, x);
    return chart_of_cuts(p, l, title, x_label, x_unit, x, "residual", "%", residual, &guide);
}

/* residuals in their standard deviations beside normal ones: a straight line if they are normal */
static wcut_report_chart normal_chart(page *p, const law *l) {
    const int n = p->of->cuts;
    double *residual = take_numbers(p, n), *score = take_numbers(p, n);
    wcut_report_chart none = {.title = ""};

    if (p->memory.failed) return none;

    /* quantiles of as many normal draws */
    for (int i = 0; i < n; i++) residual[i] = l->point[i]->residual;
    if (wcut_gaussian_scores(n, residual, score) != WCUT_OK) {
        p->memory.failed = true;
        return none;
    }

    /* the line of equal quantiles */
    wcut_report_series guide = zero(p, score);
    guide.label = "normal scatter";
    guide.y = guide.x[0];
    wcut_report_chart chart = chart_of_cuts(p, l, "Residuals against normal quantiles", "normal quantile", "", score,
                                            "residual, standardised", "", residual, &guide);
    chart.note = "In standard deviations of a cut; on the line if the scatter is normal.";

    return chart;
}

/* ---- tables ---- */

/* what of a cut wants a second look */
static const char *remark(page *p, int i, const wcut_law_fit_point *at) {
    const wcut_test_cut *cut = &p->of->cut[i];
    const double max = p->of->options->alpha_large;
    const bool large = fabs(cut->alpha_a) > max || fabs(cut->alpha_b) > max;
    const char *const word[] = {at->unusual & WCUT_UNUSUAL_OUTLIER ? "outlier" : NULL,
                                at->unusual & WCUT_UNUSUAL_LEVERAGE ? "isolated in Q_eff" : NULL,
                                at->unusual & WCUT_UNUSUAL_INFLUENTIAL ? "influential" : NULL,
                                at->loss_weight < 0.1 ? "low weight" : NULL, large ? "large angle" : NULL};

    /* only the words that apply, with commas between them */
    enum { ROOM = 80 };
    char *text = wcut_page_take(&p->memory, ROOM, 1);
    int used = 0;
    for (size_t k = 0; text && k < sizeof word / sizeof *word; k++)
        if (word[k]) used += snprintf(text + used, (size_t)(ROOM - used), "%s%s", used ? ", " : "", word[k]);
    return text;
}

static wcut_report_table cut_table(page *p, const law *l, const double *measured, const double *residual) {
    /* arrays of the page */
    const int n = p->of->cuts;
    wcut_report_column *column = wcut_page_take(&p->memory, COLUMNS, sizeof *column);
    double *fitted = take_numbers(p, n), *standard = take_numbers(p, n), *leverage = take_numbers(p, n);
    double *left_out = take_numbers(p, n), *influence = take_numbers(p, n);
    const char **text = wcut_page_take(&p->memory, (size_t)n, sizeof *text);
    wcut_report_table table = {.title = "Every cut", .rows = n, .columns = COLUMNS, .column = column};
    if (p->memory.failed) return table;

    /* figures of every cut */
    for (int i = 0; i < n; i++) {
        fitted[i] = l->point[i]->fitted;
        standard[i] = l->point[i]->residual;
        leverage[i] = l->point[i]->leverage;
        left_out[i] = l->point[i]->left_out;
        influence[i] = l->point[i]->influence;
        text[i] = remark(p, i, l->point[i]);
    }

    /* the columns, in the order that a reader asks for them */
    const wcut_report_column of[COLUMNS] = {{"line", "", p->cuts.line, NULL},
                                            {"heat", "W/m", p->cuts.heat, NULL},
                                            {"speed", "mm/s", p->cuts.speed, NULL},
                                            {"Q_eff", Q_UNIT, p->cuts.q_eff, NULL},
                                            {"measured", A_UNIT, measured, NULL},
                                            {"fitted", A_UNIT, fitted, NULL},
                                            {"residual", "%", residual, NULL},
                                            {"residual, standardised", "", standard, NULL},
                                            {"predicted from the other cuts", A_UNIT, left_out, NULL},
                                            {"leverage", "", leverage, NULL},
                                            {"influence", "", influence, NULL},
                                            {"remark", "", NULL, text}};
    memcpy(column, of, sizeof of);

    /* what the less common figures mean */
    table.note =
        "Residual: measured less fitted, over fitted; standardised: in standard deviations of a cut. Leverage: "
        "the cut's share in its own fitted value. Influence: by how many of its standard errors that value "
        "moves when the cut is left out.";

    return table;
}

static const char *const parameter[3] = {"a", "b", "c"};

/* standard errors and intervals */
static wcut_report_table parameter_table(page *p, const law *l) {
    /* values beside their standard errors and intervals */
    enum { ROWS = 4 };
    static const char *const unit[3] = {A_UNIT, B_UNIT, A_UNIT};
    const double value[3] = {l->fit->a, l->fit->b, l->fit->c};
    wcut_report_column *column = wcut_page_take(&p->memory, 4, sizeof *column);
    double *number = take_numbers(p, ROWS * 3);
    const char **row = wcut_page_take(&p->memory, ROWS, sizeof *row);
    char *low = wcut_page_take(&p->memory, 64, 1), *high = wcut_page_take(&p->memory, 64, 1);
    wcut_report_table table = {.title = "Parameters", .rows = ROWS, .columns = 1 + l->parameters, .column = column};
    if (p->memory.failed) return table;

    /* the names of the rows */
    snprintf(low, 64, "%g %% interval, from", PERCENT * p->of->options->confidence);
    snprintf(high, 64, "%g %% interval, to", PERCENT * p->of->options->confidence);
    row[0] = "value", row[1] = "standard error", row[2] = low, row[3] = high;
    column[0] = (wcut_report_column){.label = "", .text = row};

    /* a column for each parameter */
    for (int j = 0; j < l->parameters; j++) {
        const double of[ROWS] = {value[j], l->fit->standard_error[j], l->fit->low[j], l->fit->high[j]};
        memcpy(number + (size_t)ROWS * (size_t)j, of, sizeof of);
        column[1 + j] =
            (wcut_report_column){.label = parameter[j], .unit = unit[j], .number = number + (size_t)ROWS * (size_t)j};
    }

    return table;
}

static wcut_report_table correlation_table(page *p, const law *l) {
    wcut_report_column *column = wcut_page_take(&p->memory, 4, sizeof *column);
    double *number = take_numbers(p, 9);
    wcut_report_table table = {
        .title = "Correlation", .rows = l->parameters, .columns = 1 + l->parameters, .column = column};
    table.note = "Near 1 or -1, an error in one parameter is compensated by the other: use them together only.";
    if (p->memory.failed) return table;
    memcpy(number, l->fit->correlation, sizeof l->fit->correlation); /* symmetric: a row is a column */
    column[0] = (wcut_report_column){.label = "", .text = parameter};
    for (int j = 0; j < l->parameters; j++)
        column[1 + j] = (wcut_report_column){.label = parameter[j], .number = number + (size_t)3 * (size_t)j};
    return table;
}

static wcut_report_table warning_table(page *p) {
    wcut_report_column *column = wcut_page_take(&p->memory, 1, sizeof *column);
    wcut_report_table table = {.title = "Warnings", .rows = p->of->warnings, .columns = 1, .column = column};
    if (column) column[0] = (wcut_report_column){.label = "before these laws are used", .text = p->of->warning};
    return table;
}

/* ---- sections ---- */

static void fill_cuts(page *p) {
    const int n = p->of->cuts;
    p->cuts = (columns){take_numbers(p, n), take_numbers(p, n), take_numbers(p, n), take_numbers(p, n)};

    /* as columns of numbers, for charts and tables */
    for (int i = 0; i < n && !p->memory.failed; i++) {
        p->cuts.line[i] = p->of->cut[i].line;
        p->cuts.heat[i] = p->of->cut[i].heat;
        p->cuts.speed[i] = p->of->cut[i].speed;
        p->cuts.q_eff[i] = p->of->point[i].q_eff;
    }
}

/* two sentences of their own, from those that the summary has on lines of their own */
static char *section_note(page *p, const law *l) {
    char *note = wcut_page_take(&p->memory, (size_t)3 * WCUT_REPORT_SENTENCE, 1), scatter[WCUT_REPORT_SENTENCE],
         lack[WCUT_REPORT_SENTENCE];
    if (!note) return NULL;
    wcut_report_calibrate_scatter(p->of, l->fit, scatter);
    wcut_report_calibrate_lack(l->fit, lack);
    snprintf(note, (size_t)3 * WCUT_REPORT_SENTENCE, "%s. Scatter: %s. Test of the fit: %s.", l->symbol, scatter, lack);
    return note;
}

static void fill_calibrate_section(page *p, const law *l, wcut_report_section *section) {
    /* arrays of the page */
    const int n = p->of->cuts;
    double *measured = take_numbers(p, n), *residual = take_numbers(p, n);
    wcut_report_chart *chart = wcut_page_take(&p->memory, CHARTS, sizeof *chart);
    wcut_report_table *table = wcut_page_take(&p->memory, TABLES, sizeof *table);
    if (p->memory.failed) return;

    /* what charts and tables share */
    for (int i = 0; i < n; i++) {
        measured[i] = l->point[i]->measured;
        residual[i] = PERCENT * l->point[i]->relative;
    }

    /* the charts; one over speed or heat needs more than one of it */
    int charts = 0;
    chart[charts++] = curve_chart(p, l, measured);
    chart[charts++] =
        residual_chart(p, l, "Residuals over Q_eff", "effective heat input Q_eff", Q_UNIT, p->cuts.q_eff, residual);
    if (p->of->fit->speeds > 1)
        chart[charts++] = residual_chart(p, l, "Residuals over the speed", "speed", "mm/s", p->cuts.speed, residual);
    if (p->of->fit->heats > 1)
        chart[charts++] = residual_chart(p, l, "Residuals over the heat", "heat", "W/m", p->cuts.heat, residual);
    chart[charts++] = normal_chart(p, l);

    /* the tables */
    table[0] = parameter_table(p, l);
    table[1] = correlation_table(p, l);
    table[2] = cut_table(p, l, measured, residual);

    /* titles, charts and tables as one section */
    *section = (wcut_report_section){.title = l->title,
                                     .note = section_note(p, l),
                                     .chart_count = charts,
                                     .chart = chart,
                                     .table_count = TABLES,
                                     .table = table};
}

/* gives how many sections there are */
static int fill_sections(page *p, wcut_report_section *section) {
    const wcut_calibration *fit = p->of->fit;
    const wcut_report_table *warnings = NULL;
    int count = 0;

    /* both laws */
    law of[LAWS] = {
        {"Force law", "F = a exp(-b Q_eff), the force across the wire", "Force per engaged length", "force per length",
         2, &fit->force, NULL},
        {"Tension law", "T = a exp(-b Q_eff) + c, the mean tension of both mounts", "Tension per engaged length",
         "tension per length", fit->tension.c_held ? 2 : 3, &fit->tension, NULL}};

    /* warnings come before any number */
    if (p->of->warnings > 0) {
        wcut_report_table *table = wcut_page_take(&p->memory, 1, sizeof *table);
        if (table) *table = warning_table(p);
        warnings = table;
        section[count++] = (wcut_report_section){.title = "Warnings", .table_count = 1, .table = warnings};
    }

    /* a section for each law that was fitted */
    for (int k = 0; k < LAWS && !p->memory.failed; k++) {
        if (k && !fit->tension_fitted) break;
        of[k].point = wcut_page_take(&p->memory, (size_t)p->of->cuts, sizeof *of[k].point);
        for (int i = 0; i < p->of->cuts && !p->memory.failed; i++)
            of[k].point[i] = k ? &p->of->point[i].tension : &p->of->point[i].force;
        if (!p->memory.failed) fill_calibrate_section(p, &of[k], &section[count++]);
    }

    return count;
}

/* ---- the page ---- */

/* "force law, a: 0.094 to 0.108", the interval in the label, the value by itself */
static wcut_report_fact with_interval(page *p, const char *name, const wcut_law_fit *fit, int k) {
    const double value[3] = {fit->a, fit->b, fit->c};
    char *label = wcut_page_take(&p->memory, 96, 1);
    if (label)
        snprintf(label, 96, "%s, %s (%g %%: %.4g to %.4g)", name, parameter[k], PERCENT * p->of->options->confidence,
                 fit->low[k], fit->high[k]);
    return (wcut_report_fact){label, NULL, value[k], k == 1 ? B_UNIT : A_UNIT};
}

static const char *with_error(page *p, double value, double error) {
    char *text = wcut_page_take(&p->memory, 96, 1);
    if (text) snprintf(text, 96, "%.4g \xc2\xb1 %.2g", value, error);
    return text;
}

/* the answer in numbers; gives how many */
static int fill_law_facts(page *p, wcut_report_fact *fact) {
    const wcut_calibration *fit = p->of->fit;
    const wcut_law_fit *f = &fit->force, *t = &fit->tension;
    int n = 0;
    char *at = wcut_page_take(&p->memory, 96, 1);
    if (p->memory.failed) return 0;

    /* parameters with their intervals */
    for (int k = 0; k < 2; k++) fact[n++] = with_interval(p, "force law", f, k);
    for (int k = 0; k < (t->c_held ? 2 : 3) && fit->tension_fitted; k++)
        fact[n++] = with_interval(p, "tension law", t, k);
    if (fit->tension_fitted && t->c_held) fact[n++] = (wcut_report_fact){"tension law, c (held)", NULL, 0, A_UNIT};
    if (!fit->tension_fitted) fact[n++] = (wcut_report_fact){"tension law", "not determined by these cuts", 0, ""};

    /* the point about which a and b are nearly independent */
    snprintf(at, 96, "%.4g N/mm, %.4g W/m", fit->reference_force, fit->reference_heat);
    fact[n++] = (wcut_report_fact){"at force F0, heat Q", at, 0, ""};
    fact[n++] = (wcut_report_fact){"speed V0 there, \xc2\xb1 standard error",
                                   with_error(p, fit->reference_speed, fit->reference_speed_error), 0, "mm/s"};
    fact[n++] = (wcut_report_fact){"exponent 1/ln(a/F0), \xc2\xb1 standard error",
                                   with_error(p, fit->exponent, fit->exponent_error), 0, ""};

    /* the range in which the law may be used, and what it rests on */
    char *range = wcut_page_take(&p->memory, 64, 1);
    if (range) snprintf(range, 64, "%.0f to %.0f", fit->q_eff_low, fit->q_eff_high);
    fact[n++] = (wcut_report_fact){"validated Q_eff", range, 0, Q_UNIT};
    fact[n++] = (wcut_report_fact){"test cuts", NULL, p->of->cuts, ""};
    fact[n++] = (wcut_report_fact){"different heats", NULL, fit->heats, ""};
    fact[n++] = (wcut_report_fact){"different speeds", NULL, fit->speeds, ""};
    fact[n++] = (wcut_report_fact){"cuts with large angles", NULL, fit->large_angles, ""};

    return n;
}

static wcut_status write_calibrate_page(page *p, int sections, const wcut_report_section *section, const char *path,
                                        wcut_error *error) {
    static const char *const loss[] = {"least squares", "Huber", "Tukey's biweight"};
    const wcut_report_calibrate *of = p->of;
    const wcut_calibration_options *o = of->options;

    /* verdict and facts stand at the top of the page */
    char verdict[512];
    wcut_report_fact fact[16];
    const int facts = fill_law_facts(p, fact);
    if (p->memory.failed) return WCUT_NO_MEMORY;

    /* settings of the fit, with what the defaults came to */
    const wcut_report_fact option[] = {{"noise", is_relative(of) ? "relative to the value" : "absolute", 0, ""},
                                       {"loss", loss[o->loss], 0, ""},
                                       {"weights", of->weights ? of->weights : "all 1", 0, ""},
                                       {"confidence of intervals and bands", NULL, PERCENT * o->confidence, "%"},
                                       {"limit of large angles", NULL, o->alpha_large * WCUT_DEG_PER_RAD, "deg"},
                                       {"F0", o->reference_force > 0 ? NULL : "geometric mean of the fitted forces",
                                        o->reference_force, o->reference_force > 0 ? A_UNIT : ""},
                                       {"Q of V0", o->reference_heat > 0 ? NULL : "median of the cuts",
                                        o->reference_heat, o->reference_heat > 0 ? "W/m" : ""}};

    /* where it came from, and the whole */
    const wcut_report_source source = {"calibration table", of->path, p->hash[0] ? p->hash : NULL};
    const wcut_report report = {.verb = "calibrate",
                                .title = of->path,
                                .tone = judge_calibrate(of, verdict, sizeof verdict),
                                .verdict = verdict,
                                .fact_count = facts,
                                .fact = fact,
                                .section_count = sections,
                                .section = section,
                                .source_count = 1,
                                .source = &source,
                                .option_count = sizeof option / sizeof *option,
                                .option = option};

    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_calibrate_write(const wcut_report_calibrate *of, const char *path, wcut_error *error) {
    if (!of || !of->path || of->cuts < 1 || !of->cut || !of->options || !of->fit || !of->point || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.of = of};
    wcut_report_section section[1 + LAWS];
    wcut_status status = wcut_source_hash(of->path, p.hash, error);
    if (!status) {
        fill_cuts(&p);
        const int sections = p.memory.failed ? 0 : fill_sections(&p, section);
        status = p.memory.failed ? WCUT_NO_MEMORY : write_calibrate_page(&p, sections, section, path, error);
    }
    wcut_page_free(&p.memory);
    return status;
}
