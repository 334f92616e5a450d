/* The bow of a bow's wire on a cut's page: along the cut, on its face, and how fast it may go. */
#include "io/report/report_bow.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

enum { BOW, DEPARTURE, FORCE, CLOSING, SERIES };
enum { CELLS_MAX = 1000000 };

static void fill_bow_series(wcut_report_bow *b, const wcut_bow_results *r, const double *time, const double *station) {
    static const char *const label[SERIES] = {"bow", "departure", "force on the tool", "closing of the frame"};
    for (int j = 0; j < r->stations; j++) {
        const wcut_bow_row *row = &r->row[j];
        const wcut_vec3 f = row->force;
        const double value[SERIES] = {row->bow, row->departure_max, sqrt(f.x * f.x + f.y * f.y + f.z * f.z),
                                      row->closing};
        for (int k = 0; k < SERIES; k++) b->series[(ptrdiff_t)k * r->stations + j] = value[k];
    }
    for (int k = 0; k < SERIES; k++)
        b->along[k] = (wcut_report_series){.label = label[k],
                                           .mark = k == DEPARTURE ? WCUT_REPORT_MARK_DASHED : WCUT_REPORT_MARK_LINE,
                                           .count = r->stations,
                                           .x = {time, station},
                                           .y = b->series + (ptrdiff_t)k * r->stations};
}

static wcut_report_chart along_chart(const char *title, const char *label, const char *unit, int count,
                                     const wcut_report_series *of) {
    return (wcut_report_chart){.title = title,
                               .x_label = {"time", "station"},
                               .x_unit = {"s", ""},
                               .y_label = label,
                               .y_unit = unit,
                               .series_count = count,
                               .series = of};
}

/* the map of the face: stations across, nodes along the wire upward */
static void fill_bow_map(wcut_report_bow *b, const wcut_bow_results *r, const double *station) {
    for (int i = 0; i < r->nodes; i++) {
        b->node[i] = i;
        for (int j = 0; j < r->stations; j++)
            b->turned[(size_t)i * (size_t)r->stations + (size_t)j] =
                r->departure[(size_t)j * (size_t)r->nodes + (size_t)i];
    }
    b->map = (wcut_report_map){.title = "Departure of the face from the ruled surface",
                               .note = "Positive above the surface that the straight line between the mounts sweeps.",
                               .x_label = "station",
                               .x_unit = "",
                               .y_label = "node",
                               .y_unit = "",
                               .label = "departure",
                               .unit = "mm",
                               .columns = r->stations,
                               .rows = r->nodes,
                               .x = station,
                               .y = b->node,
                               .value = b->turned,
                               .scale = WCUT_REPORT_SCALE_DIVERGING,
                               .limit = fmax(fabs(r->departure_max.value), 1e-3),
                               .blank_missing = true};
}

/* ---- the feed chart ---- */

enum {
    HEAT,
    TEMPERATURE,
    STRENGTH,
    FEED,
    ALLOWED = FEED + WCUT_FEED_CHART_BOWS,
    KERF = ALLOWED + WCUT_FEED_CHART_BOWS
};

static void fill_bow_table(wcut_report_bow *b, const wcut_bow_results *r) {
    static const char *const label[WCUT_REPORT_BOW_COLUMNS] = {
        "heat",         "wire in air",         "strength",      "feed, bow 0.5 mm", "feed, 1 mm",
        "feed, 2 mm",   "allowed, bow 0.5 mm", "allowed, 1 mm", "allowed, 2 mm",    "kerf at bow of 0.5 mm",
        "kerf at 1 mm", "kerf at 2 mm"};
    static const char *const unit[WCUT_REPORT_BOW_COLUMNS] = {"W/m",  "\302\260C", "N",    "mm/s", "mm/s", "mm/s",
                                                              "mm/s", "mm/s",      "mm/s", "mm",   "mm",   "mm"};

    /* a row of the chart is a column of figures here */
    for (int k = 0; k < WCUT_FEED_CHART_HEATS; k++) {
        const wcut_feed_chart_row *c = &r->chart[k];
        b->chart[HEAT][k] = c->heat, b->chart[TEMPERATURE][k] = c->temperature, b->chart[STRENGTH][k] = c->strength;
        for (int w = 0; w < WCUT_FEED_CHART_BOWS; w++) {
            b->chart[FEED + w][k] = c->feed[w];
            b->chart[ALLOWED + w][k] = c->allowed[w] > 0 ? c->allowed[w] : NAN;
            b->chart[KERF + w][k] = c->kerf[w];
        }
    }

    /* the table */
    for (int c = 0; c < WCUT_REPORT_BOW_COLUMNS; c++)
        b->column[c] = (wcut_report_column){.label = label[c], .unit = unit[c], .number = b->chart[c]};
    b->table = (wcut_report_table){.title = "Largest feed for a bow",
                                   .note =
                                       "Allowed: the same where the wire is neither hotter than its limit nor pulled "
                                       "beyond its strength in air; a "
                                       "dash: none.",
                                   .rows = WCUT_FEED_CHART_HEATS,
                                   .columns = WCUT_REPORT_BOW_COLUMNS,
                                   .column = b->column};
}

static void fill_feed_chart(wcut_report_bow *b) {
    static const char *const label[2 * WCUT_FEED_CHART_BOWS] = {"bow of 0.5 mm",   "bow of 1 mm",   "bow of 2 mm",
                                                                "0.5 mm, allowed", "1 mm, allowed", "2 mm, allowed"};
    for (int k = 0; k < 2 * WCUT_FEED_CHART_BOWS; k++)
        b->feed[k] =
            (wcut_report_series){.label = label[k],
                                 .mark = k < WCUT_FEED_CHART_BOWS ? WCUT_REPORT_MARK_DASHED : WCUT_REPORT_MARK_LINE,
                                 .count = WCUT_FEED_CHART_HEATS,
                                 .x = {b->chart[HEAT]},
                                 .y = b->chart[FEED + k]};
    b->charts[0] = (wcut_report_chart){.title = "Feed chart",
                                       .note = b->note,
                                       .x_label = {"heat"},
                                       .x_unit = {"W/m"},
                                       .y_label = "largest feed",
                                       .y_unit = "mm/s",
                                       .series_count = 2 * WCUT_FEED_CHART_BOWS,
                                       .series = b->feed};
}

wcut_status wcut_report_bow_fill(wcut_report_bow *b, const wcut_bow_results *r, const double *time,
                                 const double *station, wcut_report_section *section) {
    /* room for series and map */
    const size_t cells = (size_t)r->stations * (size_t)r->nodes;
    b->series = calloc(SERIES * (size_t)r->stations, sizeof *b->series);
    b->node = calloc((size_t)r->nodes, sizeof *b->node);
    b->turned = cells <= CELLS_MAX ? calloc(cells, sizeof *b->turned) : NULL;
    if (!b->series || !b->node || (cells <= CELLS_MAX && !b->turned)) return WCUT_NO_MEMORY;

    /* charts: the feed chart first, then along the cut */
    snprintf(b->note, sizeof b->note,
             "Steady, straight cuts with the widest engagement of this one. Solid: what heat and strength of the wire "
             "allow.");
    fill_bow_series(b, r, time, station);
    fill_bow_table(b, r);
    fill_feed_chart(b);
    b->charts[1] =
        along_chart("Bow of the wire, and departure of the face", "largest of the station", "mm", 2, b->along);
    b->charts[2] = along_chart("Force on the tool", "force", "N", 1, &b->along[FORCE]);
    b->charts[3] = along_chart("Closing of the frame", "closing", "mm", 1, &b->along[CLOSING]);
    if (b->turned) fill_bow_map(b, r, station);

    *section = (wcut_report_section){.title = "Bow of the wire",
                                     .chart_count = 4,
                                     .chart = b->charts,
                                     .map_count = b->turned ? 1 : 0,
                                     .map = &b->map,
                                     .table_count = 1,
                                     .table = &b->table};
    return WCUT_OK;
}

void wcut_report_bow_clear(wcut_report_bow *b) {
    free(b->series);
    free(b->turned);
    free(b->node);
}
