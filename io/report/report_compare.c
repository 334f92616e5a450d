/* The page of a comparison: the deviation in space, figures as scanned and as registered, along the cut, worst areas. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/report_pages.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/report/page_memory.h"
#include "io/report/report_scan.h"

enum { LINES_MAX = WCUT_WORST_MAX + 2, FACTS_MAX = 24, FIGURES = 27, TEXT = 96 };

/* what the page borrows: rows of tables, columns of charts */
typedef struct page {
    const wcut_report_compare *of;
    const wcut_compared *c; /* of->compared */
    wcut_page_memory memory;
    wcut_report_tone tone;
    char verdict[512];
    /* figures side by side */
    char figure_label[FIGURES + 3 * WCUT_BANDS_MAX][TEXT];
    const char *figure_name[FIGURES + 3 * WCUT_BANDS_MAX];
    const char *figure_unit[FIGURES + 3 * WCUT_BANDS_MAX];
    double figure[2][FIGURES + 3 * WCUT_BANDS_MAX];
    int figures;
    wcut_report_column figure_column[4];
    /* worst areas */
    char worst_label[WCUT_WORST_MAX][16];
    const char *worst_name[WCUT_WORST_MAX];
    double worst[8][WCUT_WORST_MAX];
    wcut_report_column worst_column[9];
    /* zones: the rows that hold points */
    int zones;
    const char **zone_name;
    double *zone[8];
    wcut_report_column zone_column[9];
    /* along the cut */
    double *station, *mean, *low, *high;
    double *value; /* of the face's points, nan where nothing was measured */
} page;

/* ---- figures side by side ---- */

static void add_figure(page *p, const char *label, const char *unit, double found, double unmoved) {
    const int k = p->figures++;
    snprintf(p->figure_label[k], TEXT, "%s", label);
    p->figure_name[k] = p->figure_label[k], p->figure_unit[k] = unit;
    p->figure[0][k] = found, p->figure[1][k] = unmoved;
}

/* NAN is a dash: nothing was compared */
static double known(const wcut_statistics *s, double value) { return s->count > 0 ? value : NAN; }

static void add_length(page *p, const char *label, double found, double unmoved) {
    const wcut_compared *c = p->c;
    add_figure(p, label, "mm", known(&c->found->statistics, found), known(&c->unmoved->statistics, unmoved));
}

static void add_shares(page *p, const wcut_statistics *a, const wcut_statistics *b) {
    char label[TEXT];
    for (int k = 0; k < a->bands; k++) {
        snprintf(label, sizeof label, "within \xc2\xb1%g mm", a->band[k]);
        add_figure(p, label, "%", known(a, 100 * a->within[k]), known(b, 100 * b->within[k]));
        snprintf(label, sizeof label, "above +%g mm", a->band[k]);
        add_figure(p, label, "%", known(a, 100 * a->over[k]), known(b, 100 * b->over[k]));
        snprintf(label, sizeof label, "below \xe2\x88\x92%g mm", a->band[k]);
        add_figure(p, label, "%", known(a, 100 * a->under[k]), known(b, 100 * b->under[k]));
    }
}

static void fill_figures(page *p) {
    const wcut_deviation_summary_result *x = p->c->found, *y = p->c->unmoved;
    const wcut_statistics *a = &x->statistics, *b = &y->statistics;

    /* counts */
    add_figure(p, "deviations", "", a->count, b->count);
    add_figure(p, "points outside the face", "", x->place[WCUT_PLACE_BEYOND], y->place[WCUT_PLACE_BEYOND]);
    add_figure(p, "points with two equally near places", "", x->place[WCUT_PLACE_AMBIGUOUS],
               y->place[WCUT_PLACE_AMBIGUOUS]);

    /* the distribution */
    add_length(p, "mean", a->mean, b->mean);
    add_length(p, "median", a->median, b->median);
    add_length(p, "standard deviation", a->std, b->std);
    add_length(p, "root mean square", a->rms, b->rms);
    add_length(p, "mean |d|", a->mae, b->mae);
    add_length(p, "1 % are below", a->p01, b->p01);
    add_length(p, "5 % are below", a->p05, b->p05);
    add_length(p, "95 % are below", a->p95, b->p95);
    add_length(p, "99 % are below", a->p99, b->p99);
    add_length(p, "lowest", a->min, b->min);
    add_length(p, "highest", a->max, b->max);
    add_length(p, "scan to face, largest (Hausdorff)", a->hausdorff, b->hausdorff);
    add_length(p, "profile, 2 max |d|", a->profile, b->profile);

    /* a constant, the form and the noise */
    add_length(p, "constant offset", x->split.offset, y->split.offset);
    add_length(p, "form, RMS", x->split.form_rms, y->split.form_rms);
    add_length(p, "noise, RMS", x->split.noise_rms, y->split.noise_rms);
    add_length(p, "mean of the positive deviations", a->positive_mean, b->positive_mean);
    add_length(p, "mean of the negative deviations", a->negative_mean, b->negative_mean);
    add_shares(p, a, b);
}

static wcut_report_table figure_table(page *p) {
    static const char *const method[] = {"as scanned", "by datums", "best fit"};
    const bool moved = p->c->registration->method != WCUT_REGISTRATION_METHOD_NONE;
    p->figure_column[0] = (wcut_report_column){.label = "figure", .text = p->figure_name};
    p->figure_column[1] = (wcut_report_column){.label = "unit", .text = p->figure_unit};
    p->figure_column[2] = (wcut_report_column){.label = method[p->c->registration->method], .number = p->figure[0]};
    p->figure_column[3] = (wcut_report_column){.label = "as scanned", .number = p->figure[1]};
    return (wcut_report_table){.title = "Deviation",
                               .note = moved ? "Registered and as scanned: a registration on the cut face hides "
                                               "deviations that resemble a rigid motion."
                                             : NULL,
                               .rows = p->figures,
                               .columns = moved ? 4 : 3,
                               .column = p->figure_column};
}

/* ---- worst areas, zones ---- */

static wcut_report_table worst_table(page *p) {
    /* figures of an area, with their units */
    static const char *const label[] = {"x", "y", "z", "area", "mean", "peak", "volume", "points"};
    static const char *const unit[] = {"mm", "mm", "mm", "mm\xc2\xb2", "mm", "mm", "mm\xc2\xb3", ""};
    const wcut_deviation_summary_result *r = p->c->found;

    /* a row for each area */
    for (int k = 0; k < r->worsts; k++) {
        const wcut_worst *w = &r->worst[k];
        const double figure[] = {w->place.x, w->place.y, w->place.z, w->area, w->mean, w->peak, w->volume, w->count};
        snprintf(p->worst_label[k], sizeof p->worst_label[k], "%d", k + 1);
        p->worst_name[k] = p->worst_label[k];
        for (int f = 0; f < 8; f++) p->worst[f][k] = figure[f];
    }

    /* names, then figures */
    p->worst_column[0] = (wcut_report_column){.label = "area", .text = p->worst_name};
    for (int f = 0; f < 8; f++) p->worst_column[f + 1] = (wcut_report_column){label[f], unit[f], p->worst[f], NULL};
    return (wcut_report_table){.title = "Worst areas",
                               .note =
                                   "Connected areas of one sign whose mean deviations are among the largest 5 % of the "
                                   "face, sorted by volume; positive: material left.",
                               .rows = r->worsts,
                               .columns = 9,
                               .column = p->worst_column};
}

static bool fill_zones(page *p) {
    const wcut_deviation_summary_result *r = p->c->found;
    const size_t count = r->zones > 0 ? (size_t)r->zones : 1;
    p->zone_name = wcut_page_take(&p->memory, count, sizeof *p->zone_name);
    p->zone[0] = wcut_page_take(&p->memory, 8 * count, sizeof *p->zone[0]);
    if (!p->zone_name || !p->zone[0]) return false;
    for (int f = 1; f < 8; f++) p->zone[f] = p->zone[0] + (size_t)f * count;
    for (int k = 0; k < r->zones; k++) {
        const wcut_zone *z = &r->zone[k];
        const double figure[] = {
            (z->low.x + z->high.x) / 2, (z->low.y + z->high.y) / 2, z->count, z->mean, z->std, z->rms, z->min, z->max};
        if (z->count == 0) continue;
        p->zone_name[p->zones] = z->name;
        for (int f = 0; f < 8; f++) p->zone[f][p->zones] = figure[f];
        p->zones++;
    }
    return true;
}

static wcut_report_table zone_table(page *p) {
    static const char *const label[] = {"x, middle",          "y, middle",        "points", "mean",
                                        "standard deviation", "root mean square", "lowest", "highest"};
    static const char *const unit[] = {"mm", "mm", "", "mm", "mm", "mm", "mm", "mm"};
    p->zone_column[0] = (wcut_report_column){.label = "zone", .text = p->zone_name};
    for (int f = 0; f < 8; f++) p->zone_column[f + 1] = (wcut_report_column){label[f], unit[f], p->zone[f], NULL};
    return (wcut_report_table){.title = "Zones",
                               .note =
                                   "Parts of the cut, then patches of the block: first number along x, second "
                                   "along y.",
                               .rows = p->zones,
                               .columns = 9,
                               .column = p->zone_column};
}

/* ---- zones and sections of the user ---- */

/* a table of the zones with their verdicts; false: no memory */
static bool fill_user_zones(page *p, wcut_report_table *table) {
    static const char *const label[] = {"tolerance", "required",         "points", "within",
                                        "mean",      "root mean square", "lowest", "highest"};
    static const char *const unit[] = {"mm", "%", "", "%", "mm", "mm", "mm", "mm"};
    const wcut_survey_result *s = p->c->survey;
    const size_t rows = (size_t)s->of->regions;

    /* names, eight figures, a verdict */
    const char **text = wcut_page_take(&p->memory, 2 * rows + 1, sizeof *text);
    double *number = wcut_page_take(&p->memory, 8 * rows + 1, sizeof *number);
    wcut_report_column *column = wcut_page_take(&p->memory, 10, sizeof *column);
    if (!text || !number || !column) return false;
    for (size_t k = 0; k < rows; k++) {
        const wcut_region *r = &s->of->region[k];
        const wcut_region_result *f = &s->region[k];
        const double figure[] = {r->tolerance > 0 ? r->tolerance : NAN,
                                 r->tolerance > 0 ? 100 * r->share : NAN,
                                 f->count,
                                 f->count > 0 && r->tolerance > 0 ? 100 * f->within : NAN,
                                 f->count > 0 ? f->mean : NAN,
                                 f->count > 0 ? f->rms : NAN,
                                 f->count > 0 ? f->min : NAN,
                                 f->count > 0 ? f->max : NAN};
        text[k] = r->name;
        text[rows + k] = f->passed < 0 ? "\xe2\x80\x93" : f->passed ? "pass" : "FAIL";
        for (size_t c = 0; c < 8; c++) number[c * rows + k] = figure[c];
    }
    column[0] = (wcut_report_column){.label = "zone", .text = text};
    column[1] = (wcut_report_column){.label = "verdict", .text = text + rows};
    for (size_t c = 0; c < 8; c++) column[c + 2] = (wcut_report_column){label[c], unit[c], number + c * rows, NULL};
    *table =
        (wcut_report_table){.title = "Zones of the customer",
                            .note =
                                "A zone passes where the required share of its deviations is within its tolerance; "
                                "one without points fails.",
                            .rows = s->of->regions,
                            .columns = 10,
                            .column = column};
    return true;
}

/* two charts of a section: heights, and their difference; false: no memory */
static bool fill_section_charts(page *p, int k, wcut_report_chart chart[2]) {
    const wcut_section *of = &p->c->survey->of->section[k];
    const wcut_section_result *f = &p->c->survey->section[k];
    const size_t rows = (size_t)f->rows;
    double *x = wcut_page_take(&p->memory, 4 * rows, sizeof *x);
    wcut_report_series *series = wcut_page_take(&p->memory, 3, sizeof *series);
    if (!x || !series) return false;
    for (size_t i = 0; i < rows; i++) {
        const wcut_section_row *r = &f->row[i];
        x[i] = r->along;
        x[rows + i] = r->count > 0 ? r->nominal : NAN;
        x[2 * rows + i] = r->count > 0 ? r->measured : NAN;
        x[3 * rows + i] = r->count > 0 ? r->deviation : NAN;
    }

    /* nominal dashed, measured drawn through */
    static const char *const name[] = {"nominal", "measured", "deviation"};
    for (int s = 0; s < 3; s++)
        series[s] = (wcut_report_series){.label = name[s],
                                         .mark = s == 0 ? WCUT_REPORT_MARK_DASHED : WCUT_REPORT_MARK_LINE,
                                         .count = f->rows,
                                         .x = {x, NULL},
                                         .y = x + (size_t)(s + 1) * rows};
    const char *heights = wcut_page_text(&p->memory, "Section %s: nominal and measured", of->name);
    const char *gaps = wcut_page_text(&p->memory, "Section %s: deviation", of->name);
    if (!heights || !gaps) return false;
    chart[0] = (wcut_report_chart){.title = heights,
                                   .x_label = {"way along the line", NULL},
                                   .x_unit = {"mm", NULL},
                                   .y_label = "height z",
                                   .y_unit = "mm",
                                   .series_count = 2,
                                   .series = series};
    chart[1] = (wcut_report_chart){.title = gaps,
                                   .x_label = {"way along the line", NULL},
                                   .x_unit = {"mm", NULL},
                                   .y_label = "deviation",
                                   .y_unit = "mm",
                                   .series_count = 1,
                                   .series = series + 2};
    return true;
}

/* what the user laid over the face; false: no memory */
static bool fill_survey(page *p, wcut_report_section *section) {
    const wcut_survey_result *s = p->c->survey;
    wcut_report_table *table = wcut_page_take(&p->memory, 1, sizeof *table);
    wcut_report_chart *chart = wcut_page_take(&p->memory, 2 * (size_t)s->of->sections + 1, sizeof *chart);
    if (!table || !chart) return false;
    if (s->of->regions > 0 && !fill_user_zones(p, table)) return false;
    for (int k = 0; k < s->of->sections; k++)
        if (!fill_section_charts(p, k, chart + 2 * (size_t)k)) return false;
    *section = (wcut_report_section){.title = "Zones and sections of the customer",
                                     .table_count = s->of->regions > 0,
                                     .table = table,
                                     .chart_count = 2 * s->of->sections,
                                     .chart = chart};
    return true;
}

/* ---- along the cut ---- */

/* mean, lowest and highest of every station, of the part of the face that is coloured */
static bool fill_stations(page *p) {
    const wcut_report_compare *c = p->of;
    const wcut_face *f = c->face;
    const int vertices = c->mesh->vertex_count, rows = f ? f->stations : 1;

    /* one value for each vertex, missing where there are no points */
    p->value = wcut_page_take(&p->memory, (size_t)vertices, sizeof *p->value);
    p->station = wcut_page_take(&p->memory, 4 * (size_t)rows, sizeof *p->station);
    if (!p->value || !p->station) return false;
    for (int k = 0; k < vertices; k++) p->value[k] = c->present[k] ? c->value[k] : NAN;

    /* the lines of the chart */
    p->mean = p->station + rows, p->low = p->mean + rows, p->high = p->low + rows;

    /* a row of the grid is a station */
    for (int s = 0; f && s < rows; s++) {
        int count = 0;
        double sum = 0, low = INFINITY, high = -INFINITY;
        for (int n = 0; n < f->nodes; n++) {
            const int i = s * f->nodes + n;
            if (!f->inside[i] || !c->present[i]) continue;
            sum += c->value[i], low = fmin(low, c->value[i]), high = fmax(high, c->value[i]), count++;
        }
        p->station[s] = s;
        p->mean[s] = count ? sum / count : NAN, p->low[s] = count ? low : NAN, p->high[s] = count ? high : NAN;
    }

    return true;
}

/* runs of stations of one phase, as far as there is room; gives how many */
static int list_compare_phases(const wcut_face *f, int max, wcut_report_span *span) {
    int count = 0;
    for (int s = 0, from = 0; s < f->stations && count < max; s++) {
        if (s + 1 < f->stations && f->phase[s + 1] == f->phase[from]) continue;
        const int to = s + 1 < f->stations ? s + 1 : s;
        span[count++] = (wcut_report_span){wcut_phase_name(f->phase[from]), {f->time[from], from}, {f->time[to], to}};
        from = s + 1;
    }
    return count;
}

/* ---- what is said ---- */

/* how many zones of the user pass, in a sentence; gives its length */
static int judge_zones(page *p, char *to, size_t room) {
    const wcut_survey_result *s = p->c->survey;
    int judged = 0, passed = 0;
    for (int k = 0; s && k < s->of->regions; k++) {
        judged += s->region[k].passed >= 0;
        passed += s->region[k].passed == 1;
    }
    if (judged == 0) return 0;
    if (passed < judged || p->tone == WCUT_REPORT_TONE_PLAIN)
        p->tone = passed < judged ? WCUT_REPORT_TONE_BAD : WCUT_REPORT_TONE_GOOD;
    return snprintf(to, room, "%d of %d zones of the customer are within their tolerance. ", passed, judged);
}

static void judge_compare(page *p) {
    const wcut_compared *f = p->c;
    const wcut_statistics *s = &f->found->statistics;
    char *to = p->verdict;
    size_t room = sizeof p->verdict;
    p->tone = f->tolerance == 0 ? WCUT_REPORT_TONE_PLAIN : f->within ? WCUT_REPORT_TONE_GOOD : WCUT_REPORT_TONE_BAD;
    int n = judge_zones(p, to, room);
    to += n, room -= (size_t)n, n = 0;
    for (int k = 0; k < s->bands && f->tolerance > 0; k++)
        if (s->band[k] == f->tolerance)
            n = snprintf(to, room,
                         "%.4g %% of the scan lie within \xc2\xb1%g mm of the simulated face; required are %g %%. ",
                         100 * s->within[k], f->tolerance, 100 * f->share);
    snprintf(to + n, room - (size_t)n,
             "RMS deviation %.3g mm: a constant %+.3g mm, form %.3g mm, noise %.3g mm; the largest is %.3g mm.", s->rms,
             f->found->split.offset, f->found->split.form_rms, f->found->split.noise_rms, s->hausdorff);
}

static int list_facts(const page *p, wcut_report_fact *fact) {
    const wcut_compared *f = p->c;
    const wcut_deviation_summary_result *r = f->found;
    int n = 0;

    /* the title block first */
    if (f->part) fact[n++] = (wcut_report_fact){"part", f->part, 0, ""};
    if (f->inspector) fact[n++] = (wcut_report_fact){"inspector", f->inspector, 0, ""};
    if (f->instrument) fact[n++] = (wcut_report_fact){"instrument", f->instrument, 0, ""};
    if (f->date) fact[n++] = (wcut_report_fact){"date", f->date, 0, ""};

    /* how many points, and how far they lie */
    fact[n++] = (wcut_report_fact){"deviations", NULL, r->statistics.count, ""};
    fact[n++] = (wcut_report_fact){"points outside", NULL, r->place[WCUT_PLACE_BEYOND], ""};
    fact[n++] = (wcut_report_fact){"RMS", NULL, r->statistics.rms, "mm"};
    fact[n++] = (wcut_report_fact){"scan to face, largest", NULL, r->statistics.hausdorff, "mm"};
    fact[n++] = (wcut_report_fact){"face to scan, largest", NULL, f->face_to_scan->max, "mm"};
    fact[n++] = (wcut_report_fact){"constant offset", NULL, r->split.offset, "mm"};
    fact[n++] = (wcut_report_fact){"form, RMS", NULL, r->split.form_rms, "mm"};

    /* the kerf that the scan shows, where a job states one */
    if (f->has_kerf) {
        fact[n++] = (wcut_report_fact){"kerf of the job", NULL, f->kerf, "mm"};
        fact[n++] = (wcut_report_fact){"kerf from the scan", NULL, f->kerf - 2 * r->split.offset, "mm"};
    }
    if (f->unmeasured >= 0) fact[n++] = (wcut_report_fact){"face without points", NULL, f->unmeasured, "mm\xc2\xb2"};

    /* correlations exist where the job is known */
    if (!r->related) return n;
    fact[n++] = (wcut_report_fact){"correlation of |d| with time since entry", NULL, r->time.of_size, ""};
    fact[n++] = (wcut_report_fact){"correlation of |d| with curvature of the path", NULL, r->path.of_size, ""};
    fact[n++] = (wcut_report_fact){"correlation of |d| with curvature of the face", NULL, r->bend.of_size, ""};

    return n;
}

/* ---- the page ---- */

static int list_compare_options(const page *p, wcut_report_fact *option) {
    static const char *const method[] = {"none", "datum", "fit"};
    const wcut_report_compare *of = p->of;

    /* how the comparison was made */
    int n = 0;
    option[n++] = (wcut_report_fact){"distance", p->c->distance, 0, ""};
    option[n++] = (wcut_report_fact){"unit of the scan", of->unit, 0, ""};
    option[n++] = (wcut_report_fact){"registration", method[p->c->registration->method], 0, ""};
    option[n++] = (wcut_report_fact){"radius of support of a point", NULL, p->c->support, "mm"};
    option[n++] = (wcut_report_fact){"border", NULL, of->border, "mm"};
    option[n++] = (wcut_report_fact){"side of a cell", NULL, p->c->found->split.cell, "mm"};
    if (p->c->reconstruction) option[n++] = (wcut_report_fact){"reconstruction", p->c->reconstruction_method, 0, ""};

    /* what the motion came from, and what was removed before */
    const wcut_clean_options *clean = p->c->cleaning;
    if (p->c->zones_file) option[n++] = (wcut_report_fact){"file of zones and sections", p->c->zones_file, 0, ""};
    if (p->c->datum_file) option[n++] = (wcut_report_fact){"file of datums", p->c->datum_file, 0, ""};

    /* only the steps of cleaning that were asked for */
    if (clean && clean->duplicate >= 0) option[n++] = (wcut_report_fact){"equal points", "once each", 0, ""};
    if (clean && clean->radius > 0)
        option[n++] = (wcut_report_fact){"isolated points removed within", NULL, clean->radius, "mm"};
    if (clean && clean->neighbours > 0)
        option[n++] = (wcut_report_fact){"outliers removed beyond deviations", NULL, clean->deviations, ""};
    if (clean && clean->voxel > 0) option[n++] = (wcut_report_fact){"scan thinned to", NULL, clean->voxel, "mm"};
    if (of->spacing > 0) option[n++] = (wcut_report_fact){"view thinned to", NULL, of->spacing, "mm"};

    return n;
}

/* NULL where a scan was not hashed */
static const char *hash_of(const wcut_compared_scan *scan) {
    return scan->sha256 && scan->sha256[0] ? scan->sha256 : NULL;
}

static wcut_status write_compare_page(page *p, const wcut_report_scene *scene, const char *path, wcut_error *error) {
    const wcut_compared *c = p->c;
    const wcut_face *f = p->of->face;

    /* charts over the time of the cut, where a job tells it */
    wcut_report_span span[32];
    const int spans = f ? list_compare_phases(f, 32, span) : 0;
    const wcut_report_series mean = {.label = "mean of a station, and its range",
                                     .count = f ? f->stations : 0,
                                     .x = {f ? f->time : NULL, p->station},
                                     .y = p->mean,
                                     .low = p->low,
                                     .high = p->high};
    const wcut_report_series bend = {.label = "mean of both mounts' paths",
                                     .count = f ? f->stations : 0,
                                     .x = {f ? f->time : NULL, p->station},
                                     .y = f ? f->path_bend : NULL};
    const wcut_report_chart chart[] = {{.title = "Deviation along the cut",
                                        .x_label = {"time since entry", "station"},
                                        .x_unit = {"s", ""},
                                        .y_label = "deviation",
                                        .y_unit = "mm",
                                        .series_count = 1,
                                        .series = &mean,
                                        .span_count = spans,
                                        .span = span},
                                       {.title = "Curvature of the path",
                                        .x_label = {"time since entry", "station"},
                                        .x_unit = {"s", ""},
                                        .y_label = "curvature",
                                        .y_unit = "1/mm",
                                        .series_count = 1,
                                        .series = &bend,
                                        .span_count = spans,
                                        .span = span}};

    /* sections: figures, the cut, the points, the scan as a mesh */
    const wcut_report_table figures[] = {figure_table(p), worst_table(p), zone_table(p)};
    wcut_report_section section[5];
    int sections = 0;
    if (c->survey && !fill_survey(p, &section[sections++])) return WCUT_NO_MEMORY;
    section[sections++] = (wcut_report_section){.title = "Figures", .table_count = 3, .table = figures};
    if (f) section[sections++] = (wcut_report_section){.title = "Along the cut", .chart_count = 2, .chart = chart};

    /* points and registration, then the scan as a mesh */
    if (!wcut_report_fill_registration(&p->memory, c, &section[sections++])) return WCUT_NO_MEMORY;
    if (c->reconstruction && !wcut_report_fill_reconstruction(&p->memory, c, &section[sections++]))
        return WCUT_NO_MEMORY;

    /* sources: the reference, then every scan */
    wcut_report_fact fact[FACTS_MAX], option[FACTS_MAX];
    wcut_report_source *source = wcut_page_take(&p->memory, (size_t)c->scans + 1, sizeof *source);
    if (!source) return WCUT_NO_MEMORY;
    source[0] = (wcut_report_source){c->has_kerf ? "job" : "mesh", c->reference, p->of->reference_sha256};
    for (int k = 0; k < c->scans; k++)
        source[k + 1] = (wcut_report_source){"scan", c->scan[k].name, hash_of(&c->scan[k])};

    /* verdict and facts stand at the top of the page */
    judge_compare(p);
    const wcut_report report = {.verb = "compare",
                                .title = p->of->title ? p->of->title : c->reference,
                                .tone = p->tone,
                                .verdict = p->verdict,
                                .fact_count = list_facts(p, fact),
                                .fact = fact,
                                .scene = scene,
                                .section_count = sections,
                                .section = section,
                                .source_count = c->scans + 1,
                                .source = source,
                                .option_count = list_compare_options(p, option),
                                .option = option};

    return wcut_report_write(&report, path, error);
}

/* the tolerance that the view begins with: that of the gate, or the smallest one reported */
static double tolerance_of(const wcut_compared *c) {
    const wcut_statistics *s = &c->found->statistics;
    return c->tolerance > 0 ? c->tolerance : s->bands > 0 ? s->band[0] : 0;
}

static int list_lines(const page *p, wcut_report_line *line) {
    const wcut_report_compare *of = p->of;
    const wcut_deviation_summary_result *r = p->c->found;
    int n = 0;
    if (of->stations > 0) {
        line[n++] = (wcut_report_line){"path curves", "A", of->stations, of->mount_a};
        line[n++] = (wcut_report_line){"path curves", "B", of->stations, of->mount_b};
    }
    for (int k = 0; k < r->worsts; k++)
        line[n++] = (wcut_report_line){"worst areas", p->worst_label[k], 1, &r->worst[k].place};
    return n;
}

static wcut_status write_scene(page *p, const char *path, wcut_error *error) {
    const wcut_report_compare *c = p->of;
    const wcut_face *f = c->face;
    const double tolerance = tolerance_of(p->c);

    /* the face, coloured by its deviation and, of a job, by force and curvature */
    const wcut_report_field of_face[] = {
        {"deviation", "mm", WCUT_REPORT_SCALE_DIVERGING, tolerance, p->value},
        {"force across the wire", "N/mm", WCUT_REPORT_SCALE_SEQUENTIAL, 0, f ? f->force : NULL},
        {"largest curvature", "1/mm", WCUT_REPORT_SCALE_DIVERGING, 1e-6, f ? f->curvature : NULL}};
    const wcut_report_field of_scan = {"deviation", "mm", WCUT_REPORT_SCALE_DIVERGING, tolerance, c->deviation};
    wcut_report_shape shape[3];
    int shapes = 0;

    /* the face: a grid of stations, or the triangles of a mesh */
    shape[shapes++] = (wcut_report_shape){.name = "simulated face",
                                          .vertex_count = c->mesh->vertex_count,
                                          .vertex = c->mesh->vertex,
                                          .rows = f ? f->stations : 0,
                                          .columns = f ? f->nodes : 0,
                                          .row_label = "station",
                                          .column_label = "position",
                                          .triangle_count = f ? 0 : c->mesh->triangle_count,
                                          .triangle = f ? NULL : c->mesh->triangle,
                                          .field_count = f ? 3 : 1,
                                          .field = of_face};

    /* the scan's points, and the mesh made from them */
    shape[shapes++] = (wcut_report_shape){
        .name = "scan", .vertex_count = c->points, .vertex = c->point, .field_count = 1, .field = &of_scan};
    wcut_report_field of_mesh = {"deviation", "mm", WCUT_REPORT_SCALE_DIVERGING, tolerance, NULL};
    if (p->c->reconstruction) {
        const wcut_mesh *mesh = p->c->reconstruction->mesh;
        of_mesh.value = mesh->scalar;
        shape[shapes++] = (wcut_report_shape){.name = "reconstructed scan",
                                              .vertex_count = mesh->vertex_count,
                                              .vertex = mesh->vertex,
                                              .triangle_count = mesh->triangle_count,
                                              .triangle = mesh->triangle,
                                              .field_count = 1,
                                              .field = &of_mesh};
    }

    /* worst areas are marked in the view */
    worst_table(p); /* names the marks */

    /* the view, and the page around it */
    wcut_report_line line[LINES_MAX];
    const wcut_report_scene scene = {.title = "Deviation of the scan from the simulated face",
                                     .note = "Positive: material left above the face. Grey: no points there.",
                                     .block_size = f ? f->high : (wcut_vec3){0, 0, 0},
                                     .shape_count = shapes,
                                     .shape = shape,
                                     .line_count = list_lines(p, line),
                                     .line = line};

    return write_compare_page(p, &scene, path, error);
}

/* figures that the page has room for */
static bool is_sized(const wcut_deviation_summary_result *r) {
    return r->statistics.bands >= 0 && r->statistics.bands <= WCUT_BANDS_MAX && r->worsts >= 0 &&
           r->worsts <= WCUT_WORST_MAX && (r->worsts == 0 || r->worst) && r->zones >= 0 && (r->zones == 0 || r->zone);
}

static bool is_compared(const wcut_compared *c) {
    return c && c->reference && c->distance && c->scans > 0 && c->scan && c->registration &&
           (unsigned)c->registration->method <= WCUT_REGISTRATION_METHOD_FIT && c->datums >= 0 &&
           (c->datums == 0 || c->datum) && c->found && c->unmoved && is_sized(c->found) && is_sized(c->unmoved) &&
           c->face_to_scan && (!c->reconstruction || (c->reconstruction->mesh && c->to_scan && c->to_face));
}

static bool is_compare_shown(const wcut_report_compare *of) {
    return of->mesh && of->value && of->present && of->unit && of->points >= 0 && of->stations >= 0 &&
           (of->points == 0 || (of->point && of->deviation)) && (of->stations == 0 || (of->mount_a && of->mount_b)) &&
           (!of->face || (long)of->face->stations * of->face->nodes == of->mesh->vertex_count);
}

wcut_status wcut_report_compare_write(const wcut_report_compare *of, const char *path, wcut_error *error) {
    if (!of || !is_compared(of->compared) || !is_compare_shown(of) || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page *p = wcut_alloc(1, sizeof *p);
    if (!p) return wcut_fail(error, WCUT_NO_MEMORY, "report page: %s", wcut_status_text(WCUT_NO_MEMORY));
    p->of = of;
    p->c = of->compared;

    fill_figures(p);
    wcut_status status = fill_zones(p) && fill_stations(p) ? WCUT_OK : WCUT_NO_MEMORY;
    if (status == WCUT_OK) status = write_scene(p, path, error);
    if (status == WCUT_NO_MEMORY) wcut_fail(error, status, "report page: %s", wcut_status_text(status));

    wcut_page_free(&p->memory);
    wcut_free(p);
    return status;
}
