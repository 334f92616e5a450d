/* The evidence on a diagnosis's page: residuals of all models as maps and as lines. */
#include "io/report/report_evidence.h"
#include "base/sort.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MODELS = 3, MAP_COLUMNS = 240, SPANS_MAX = 24 };

static const char *const model_title[MODELS] = {"Before: the job as it is", "Recalibrated: a, b and the wire's length",
                                                "After: with the effects found"};

static const double *values_of(const wcut_residual_trace *t, int model) {
    return model == 0 ? t->before : model == 1 ? t->recalibrated : t->after;
}

static double larger(double a, double b) { return a > b ? a : b; }

/* ---- maps ---- */

/* the grid of all maps: a row a trace, even columns over the time of all cuts */
typedef struct grid {
    int columns, rows;
    double *x, *y;
    const wcut_residual_trace **row;
} grid;

/* channels together, within them cut by cut */
static int by_channel(const void *a, const void *b) {
    const wcut_residual_trace *s = *(const wcut_residual_trace *const *)a, *t = *(const wcut_residual_trace *const *)b;
    if (s->channel != t->channel) return s->channel < t->channel ? -1 : 1;
    const int order = strcmp(s->column, t->column);
    if (order) return order;
    return s->cut < t->cut ? -1 : s->cut > t->cut;
}

static bool make_grid(wcut_page_memory *memory, const wcut_diagnosis *d, grid *g) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    *g = (grid){.columns = MAP_COLUMNS};
    g->row = wcut_page_take(memory, (size_t)d->traces, sizeof *g->row);
    g->x = wcut_page_take(memory, MAP_COLUMNS, sizeof *g->x);
    g->y = wcut_page_take(memory, (size_t)d->traces, sizeof *g->y);
    if (memory->failed) return false;
    for (int i = 0; i < d->traces; i++) {
        const wcut_residual_trace *t = &d->trace[i];
        if (t->count < 2) continue;
        g->y[g->rows] = g->rows + 1;
        g->row[g->rows++] = t;
        low = -larger(-low, -t->time[0]), high = larger(high, t->time[t->count - 1]);
    }
    if (g->rows < 2 || !(high > low)) return false; /* a map has two rows */
    qsort(g->row, (size_t)g->rows, sizeof *g->row, by_channel);
    for (int c = 0; c < MAP_COLUMNS; c++) g->x[c] = low + (high - low) * (c + 0.5) / MAP_COLUMNS;
    return true;
}

/* the bin that a time is in; -1: none */
static int bin_at(const wcut_residual_trace *t, double time) {
    int low = 0, high = t->count - 1;
    if (time < t->time[0] - (t->time[1] - t->time[0]) || time > 2 * t->time[high] - t->time[high - 1]) return -1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (t->time[middle] <= time)
            low = middle;
        else
            high = middle;
    }
    return time - t->time[low] < t->time[high] - time ? low : high;
}

/* residuals in standard deviations of noise, so that all channels share one scale */
static double *fill_evidence_map(wcut_page_memory *memory, const grid *g, int model) {
    double *value = wcut_page_take(memory, (size_t)g->rows * (size_t)g->columns, sizeof *value);
    for (int r = 0; value && r < g->rows; r++) {
        const wcut_residual_trace *t = g->row[r];
        const double *from = values_of(t, model);
        for (int c = 0; c < g->columns; c++) {
            const int bin = bin_at(t, g->x[c]);
            const bool there = from && bin >= 0 && t->noise > 0;
            value[(size_t)r * (size_t)g->columns + (size_t)c] = there ? from[bin] / t->noise : NAN;
        }
    }
    return value;
}

/* what 98 of 100 cells of the recalibrated map stay below, five standard deviations at least: the map before, whose force
   law is another's, would leave the others without colour */
static double common_limit(wcut_page_memory *memory, const grid *g, const double *recalibrated) {
    double *size = wcut_page_take(memory, (size_t)g->rows * (size_t)g->columns, sizeof *size);
    size_t count = 0;
    for (size_t i = 0; size && i < (size_t)g->rows * (size_t)g->columns; i++)
        if (isfinite(recalibrated[i])) size[count++] = fabs(recalibrated[i]);
    if (count == 0) return 5;
    wcut_sort((int)count, size);
    return larger(5, sorted_quantile((int)count, size, 0.98));
}

/* the channels beside the rows of a map */
static void name_bands(wcut_page_memory *memory, const grid *g, wcut_report_map *map) {
    int *first = wcut_page_take(memory, (size_t)g->rows, sizeof *first);
    const char **label = wcut_page_take(memory, (size_t)g->rows, sizeof *label);
    for (int r = 0; !memory->failed && r < g->rows; r++) {
        if (r > 0 && strcmp(g->row[r]->column, g->row[r - 1]->column) == 0) continue;
        first[map->bands] = r, label[map->bands++] = g->row[r]->column;
    }
    map->band = first, map->band_label = label;
}

/* a row of the table for the rows of a channel: which, of which cuts in this order, their noise */
static wcut_report_table row_table(wcut_page_memory *memory, const wcut_report_diagnose *of, const grid *g) {
    /* columns of text */
    wcut_report_column *column = wcut_page_take(memory, 4, sizeof *column);
    const char **text[4];
    for (int k = 0; k < 4; k++) text[k] = wcut_page_take(memory, (size_t)g->rows, sizeof *text[k]);
    wcut_report_table table = {.title = "Rows of the maps", .columns = 4, .column = column};
    if (memory->failed) return table;

    /* a row of the table for each run of rows of one channel */
    for (int from = 0, to; from < g->rows; from = to) {
        const wcut_residual_trace *first = g->row[from];
        double min = first->noise, max = min;
        const char *cuts = of->cut_name[first->cut];
        for (to = from + 1; to < g->rows && strcmp(g->row[to]->column, first->column) == 0; to++) {
            cuts = wcut_page_text(memory, "%s; %s", cuts, of->cut_name[g->row[to]->cut]);
            min = -larger(-min, -g->row[to]->noise), max = larger(max, g->row[to]->noise);
        }
        const int r = table.rows++;
        text[0][r] = wcut_page_text(memory, "%d .. %d", from + 1, to);
        text[1][r] = first->column;
        text[2][r] = cuts;
        text[3][r] = wcut_page_text(memory, "%.2g .. %.2g %s", min, max, wcut_evidence_unit(first->channel));
    }

    /* columns of text */
    static const char *const label[4] = {"rows", "channel", "cuts, in this order", "noise of a bin"};
    for (int k = 0; k < 4; k++) column[k] = (wcut_report_column){.label = label[k], .text = text[k]};

    return table;
}

bool wcut_report_evidence_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_section *section) {
    grid g;
    if (of->diagnosis->traces < 1 || !make_grid(memory, of->diagnosis, &g)) return false;

    /* a map for each model on the same grid, one colour scale for all */
    wcut_report_map *map = wcut_page_take(memory, MODELS, sizeof *map);
    wcut_report_table *table = wcut_page_take(memory, 1, sizeof *table);
    double *value[MODELS];

    /* values of each map on the grid */
    for (int m = 0; m < MODELS; m++) value[m] = fill_evidence_map(memory, &g, m);
    if (memory->failed) return false;
    const double limit = common_limit(memory, &g, value[1]);

    /* the maps differ in title and values alone */
    for (int m = 0; m < MODELS; m++) {
        map[m] = (wcut_report_map){.title = model_title[m],
                                   .x_label = "time",
                                   .x_unit = "s",
                                   .y_label = "row",
                                   .y_unit = "",
                                   .label = "residual over noise",
                                   .unit = "",
                                   .columns = g.columns,
                                   .rows = g.rows,
                                   .x = g.x,
                                   .y = g.y,
                                   .value = value[m],
                                   .scale = WCUT_REPORT_SCALE_DIVERGING,
                                   .limit = limit,
                                   .blank_missing = true};
        name_bands(memory, &g, &map[m]);
    }

    /* the table names the rows of the maps */
    table[0] = row_table(memory, of, &g);
    *section =
        (wcut_report_section){.title = "Evidence",
                              .note =
                                  "Measured less replayed value of each bin, in standard deviations of its noise. One "
                                  "colour scale for all three maps; larger values have the end colours. A band has one "
                                  "row for each cut, the first cut lowest. Colour that remains is not explained.",
                              .map_count = MODELS,
                              .map = map,
                              .table_count = 1,
                              .table = table};

    return !memory->failed;
}

/* ---- lines ---- */

/* the mismatches of a trace, as spans */
static int list_spans(wcut_page_memory *memory, const wcut_diagnosis *d, const wcut_residual_trace *t,
                      wcut_report_span *span) {
    int count = 0;
    for (int i = 0; i < d->mismatches && count < SPANS_MAX; i++) {
        const wcut_mismatch *m = &d->mismatch[i];
        if (m->cut != t->cut || strcmp(m->column, t->column) != 0) continue;
        if (!isfinite(m->time[0] + m->time[1] + m->station[0] + m->station[1])) continue;
        span[count++] = (wcut_report_span){.label = wcut_page_text(memory, "%.0f %% of the misfit", 100 * m->share),
                                           .from = {m->time[0], m->station[0]},
                                           .to = {m->time[1], m->station[1]}};
    }
    return count;
}

/* stations that go forward, whatever the encoder's noise */
static const double *forward(wcut_page_memory *memory, const wcut_residual_trace *t) {
    double *station = wcut_page_take(memory, (size_t)t->count, sizeof *station);
    for (int i = 0; station && i < t->count; i++)
        station[i] = i > 0 ? larger(station[i - 1], t->station[i]) : t->station[i];
    return station;
}

static void fill_evidence_chart(wcut_page_memory *memory, const wcut_report_diagnose *of, const wcut_residual_trace *t,
                                wcut_report_chart *chart) {
    static const char *const label[MODELS] = {"before", "recalibrated", "after"};
    static const wcut_report_mark mark[MODELS] = {WCUT_REPORT_MARK_DASHED, WCUT_REPORT_MARK_LINE,
                                                  WCUT_REPORT_MARK_LINE};

    /* arrays for one trace */
    wcut_report_series *series = wcut_page_take(memory, MODELS, sizeof *series);
    wcut_report_span *span = wcut_page_take(memory, SPANS_MAX, sizeof *span);
    double *low = wcut_page_take(memory, (size_t)t->count, sizeof *low);
    double *high = wcut_page_take(memory, (size_t)t->count, sizeof *high);
    const double *station = forward(memory, t);
    if (memory->failed) return;

    /* the band of the noise lies around the last model shown */
    for (int i = 0; i < t->count; i++) low[i] = -2 * t->noise, high[i] = 2 * t->noise;
    int count = 0;
    for (int m = 0; m < MODELS; m++) {
        if (!values_of(t, m)) continue;
        series[count] = (wcut_report_series){
            .label = label[m], .mark = mark[m], .count = t->count, .x = {t->time, station}, .y = values_of(t, m)};
        count++;
    }
    if (count > 0 && t->noise > 0) series[count - 1].low = low, series[count - 1].high = high;

    /* intervals of mismatch are shaded */
    const int spans = list_spans(memory, of->diagnosis, t, span);
    *chart = (wcut_report_chart){.title = t->column,
                                 .x_label = {"time", "station"},
                                 .x_unit = {"s", ""},
                                 .y_label = "measured less model",
                                 .y_unit = wcut_evidence_unit(t->channel),
                                 .series_count = count,
                                 .series = series,
                                 .span_count = spans,
                                 .span = span};
}

bool wcut_report_residuals_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, int cut,
                                wcut_report_section *section) {
    const wcut_diagnosis *d = of->diagnosis;

    /* a chart for each channel of the cut */
    wcut_report_chart *chart = wcut_page_take(memory, (size_t)d->traces, sizeof *chart);
    int charts = 0;
    for (int i = 0; chart && i < d->traces; i++)
        if (d->trace[i].cut == cut && d->trace[i].count > 1)
            fill_evidence_chart(memory, of, &d->trace[i], &chart[charts++]);
    if (memory->failed || charts == 0) return false;

    /* a note says whether the cut was held out, and what is shaded */
    *section =
        (wcut_report_section){.title = wcut_page_text(memory, "Residuals, %s", of->cut_name[cut]),
                              .note = d->held_out && d->held_out[cut]
                                          ? "This cut is one of the held-out cuts. The band is two standard deviations "
                                            "of the noise of a bin to either side; intervals of mismatch are shaded."
                                          : "The band is two standard deviations of the noise of a bin to either side; "
                                            "intervals of mismatch are shaded.",
                              .chart_count = charts,
                              .chart = chart};

    return !memory->failed;
}
