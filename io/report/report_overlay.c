/* The page of a photograph over a simulated cut: the angles between rills and wire as a map, the shape that they tell. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/cut.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/page_memory.h"

enum { CHART_CURVES = 4, FACTS = 16 };

/* everything the page borrows */
typedef struct page {
    const wcut_overlaid *o;
    wcut_page_memory memory;
} page;

/* ---- maps ---- */

/* which figure of a patch */
typedef enum figure { FIGURE_ANGLE, FIGURE_SIGMA, FIGURE_COHERENCE } figure;

static double figure_of(const wcut_rill_patch *p, figure what) {
    if (what == FIGURE_COHERENCE) return p->covered > 0 ? p->coherence : (double)NAN;
    if (!p->readable) return (double)NAN;
    return WCUT_DEG_PER_RAD * (what == FIGURE_ANGLE ? p->angle : hypot(p->sigma, p->systematic));
}

static bool fill_map(page *p, figure what, const char *title, const char *label, const char *unit,
                     wcut_report_map *map) {
    const wcut_overlay *v = p->o->overlay;
    double *x = wcut_page_take(&p->memory, (size_t)v->columns, sizeof *x);
    double *y = wcut_page_take(&p->memory, (size_t)v->rows, sizeof *y);
    double *value = wcut_page_take(&p->memory, (size_t)v->columns * v->rows, sizeof *value);
    if (!x || !y || !value) return false;
    for (int k = 0; k < v->columns; k++) x[k] = v->patch[k].place.x;
    for (int k = 0; k < v->rows; k++) y[k] = v->patch[(size_t)k * v->columns].place.y;
    for (int k = 0; k < v->columns * v->rows; k++) value[k] = figure_of(&v->patch[k], what);
    /* a blank cell is a patch without rills */
    *map = (wcut_report_map){.title = title,
                             .x_label = "x",
                             .x_unit = "mm",
                             .y_label = "y",
                             .y_unit = "mm",
                             .label = label,
                             .unit = unit,
                             .columns = v->columns,
                             .rows = v->rows,
                             .x = x,
                             .y = y,
                             .value = value,
                             .scale = what == FIGURE_ANGLE ? WCUT_REPORT_SCALE_DIVERGING : WCUT_REPORT_SCALE_SEQUENTIAL,
                             .blank_missing = true};
    return true;
}

/* ---- the shape ---- */

/* the deviation of a wire with its 95 % band */
static bool fill_series(page *p, const wcut_rill_curve *c, wcut_report_series *series) {
    /* readable nodes of the curve, with an interval of 95 % */
    const size_t n = (size_t)c->readable;
    double *x = wcut_page_take(&p->memory, n, sizeof *x), *y = wcut_page_take(&p->memory, n, sizeof *y);
    double *low = wcut_page_take(&p->memory, n, sizeof *low), *high = wcut_page_take(&p->memory, n, sizeof *high);
    if (!x || !y || !low || !high) return false;
    int at = 0;
    for (int k = 0; k < c->count; k++) {
        const wcut_rill_node *node = &c->node[k];
        if (!node->readable) continue;
        x[at] = node->place.x;
        y[at] = node->deviation;
        low[at] = node->deviation - 1.96 * node->sigma;
        high[at] = node->deviation + 1.96 * node->sigma;
        at++;
    }

    /* lines run to the right */
    for (int i = 0, j = at - 1; at > 1 && x[0] > x[at - 1] && i < j; i++, j--) {
        double *const array[] = {x, y, low, high};
        for (int k = 0; k < 4; k++) {
            const double swap = array[k][i];
            array[k][i] = array[k][j];
            array[k][j] = swap;
        }
    }
    *series = (wcut_report_series){.label = wcut_page_text(&p->memory, "station %d", c->station),
                                   .count = at,
                                   .x = {x, NULL},
                                   .y = y,
                                   .low = low,
                                   .high = high};
    return series->label != NULL;
}

/* up to four wires, evenly chosen among those that were read */
static bool fill_chart(page *p, wcut_report_series *series, wcut_report_chart *chart) {
    const wcut_overlay *v = p->o->overlay;
    int read = 0, seen = 0, count = 0;

    /* curves that are readable; of many of them a sample, evenly spread */
    for (int k = 0; k < v->curve_count; k++) read += v->curve[k].readable > 0;
    const int shown = read < CHART_CURVES ? read : CHART_CURVES;
    for (int k = 0; k < v->curve_count && count < shown; k++) {
        if (v->curve[k].readable == 0 || seen++ < (2 * count + 1) * read / (2 * shown)) continue;
        if (!fill_series(p, &v->curve[k], &series[count++])) return false;
    }

    /* the mean is not determined: a direction has no position */
    *chart = (wcut_report_chart){
        .title = "The wire that fits the rills, minus the simulated one",
        .note = "Along y. The mean of each curve is 0: rills tell directions and no place. The band holds 95 %.",
        .x_label = {"x", NULL},
        .x_unit = {"mm", NULL},
        .y_label = "deviation",
        .y_unit = "mm",
        .series_count = count,
        .series = series};
    return true;
}

/* ---- tables ---- */

static bool fill_phases(page *p, wcut_report_column column[5], wcut_report_table *table) {
    /* phases with patches; medians of those with readable ones */
    enum { NUMBERS = 4 };
    const size_t phases = WCUT_PHASE_LEFT + 1;
    const char **name = wcut_page_take(&p->memory, phases, sizeof *name);
    double *number = wcut_page_take(&p->memory, phases * NUMBERS, sizeof *number);
    if (!name || !number) return false;
    int rows = 0;
    for (int k = 0; k < (int)phases; k++) {
        const wcut_rill_phase *f = &p->o->overlay->phase[k];
        if (f->patches == 0) continue;
        name[rows] = wcut_phase_name((wcut_phase)k);
        number[rows] = f->patches;
        number[phases + rows] = f->readable;
        number[2 * phases + rows] = f->readable ? WCUT_DEG_PER_RAD * f->median : (double)NAN;
        number[3 * phases + rows] = f->readable ? WCUT_DEG_PER_RAD * f->sigma : (double)NAN;
        rows++;
    }

    /* the columns of the table */
    column[0] = (wcut_report_column){.label = "phase", .text = name};
    column[1] = (wcut_report_column){.label = "patches seen", .number = number};
    column[2] = (wcut_report_column){.label = "with rills", .number = number + phases};
    column[3] = (wcut_report_column){.label = "angle, median", .unit = "deg", .number = number + 2 * phases};
    column[4] = (wcut_report_column){.label = "standard deviation", .unit = "deg", .number = number + 3 * phases};
    *table = (wcut_report_table){.title = "By phase of the cut", .rows = rows, .columns = 5, .column = column};
    return true;
}

static bool fill_worst(page *p, wcut_report_column column[5], wcut_report_table *table) {
    const wcut_overlay *v = p->o->overlay;

    /* column by column, as a table keeps its numbers */
    const size_t n = (size_t)v->worst_count;
    double *number = wcut_page_take(&p->memory, 5 * n, sizeof *number);
    if (!number) return false;
    for (size_t k = 0; k < n; k++) {
        const wcut_rill_patch *at = &v->patch[v->worst[k]];
        const double value[] = {at->place.x, at->place.y, at->place.z, WCUT_DEG_PER_RAD * at->angle,
                                WCUT_DEG_PER_RAD * hypot(at->sigma, at->systematic)};
        for (size_t c = 0; c < 5; c++) number[c * n + k] = value[c];
    }
    static const char *const label[] = {"x", "y", "z", "angle", "standard deviation"}, *const unit[] = {"mm", "mm",
                                                                                                        "mm", "deg",
                                                                                                        "deg"};
    for (size_t c = 0; c < 5; c++)
        column[c] = (wcut_report_column){.label = label[c], .unit = unit[c], .number = number + c * n};

    /* the table of those patches */
    *table = (wcut_report_table){
        .title = "Patches that stand out most", .rows = v->worst_count, .columns = 5, .column = column};
    return true;
}

static bool fill_points(page *p, wcut_report_column column[6], wcut_report_table *table) {
    const wcut_overlaid *o = p->o;

    /* places in mm, residuals in pixels */
    const size_t n = (size_t)o->points;
    double *number = wcut_page_take(&p->memory, 6 * n, sizeof *number);
    if (!number) return false;
    for (size_t k = 0; k < n; k++) {
        const double value[] = {o->point[k].place.x,    o->point[k].place.y,
                                o->point[k].place.z,    o->residual[2 * k],
                                o->residual[2 * k + 1], o->report->left_out ? o->leave_one_out[k] : (double)NAN};
        for (size_t c = 0; c < 6; c++) number[c * n + k] = value[c];
    }
    static const char *const label[] = {"x", "y", "z", "residual u", "residual v", "left out"}, *const unit[] = {
                                                                                                    "mm", "mm", "mm",
                                                                                                    "px", "px", "px"};
    for (size_t c = 0; c < 6; c++)
        column[c] = (wcut_report_column){.label = label[c], .unit = unit[c], .number = number + c * n};

    /* the table, one row per point */
    *table = (wcut_report_table){.title = "Points of the camera",
                                 .note = "Left out: distance of the point from a camera that was fitted without it.",
                                 .rows = o->points,
                                 .columns = 6,
                                 .column = column};
    return true;
}

/* ---- the page ---- */

static wcut_report_tone judge_overlay(page *p, const char **verdict) {
    const wcut_overlay *v = p->o->overlay;

    /* no rills, rills as simulated, or wires that differ */
    if (v->readable == 0) {
        *verdict = "Nothing readable: the picture shows no rills on the face.";
        return WCUT_REPORT_TONE_WARNING;
    }
    if (v->differing == 0) {
        *verdict = wcut_page_text(&p->memory,
                                  "The rills run along the simulated wire: none of %d wires differs by more than four "
                                  "standard deviations.",
                                  v->curve_count);
        return WCUT_REPORT_TONE_GOOD;
    }

    /* the wire that differs most, with its interval of 95 % */
    double largest = 0, sigma = 0;
    for (int k = 0; k < v->curve_count; k++)
        if (v->curve[k].differs && v->curve[k].range > largest)
            largest = v->curve[k].range, sigma = v->curve[k].range_sigma;
    *verdict =
        wcut_page_text(&p->memory,
                       "The rills differ from the simulated wire: %d of %d wires, by up to %.2g mm +- %.2g mm from "
                       "one end to the other.",
                       v->differing, v->curve_count, largest, 1.96 * sigma);
    return WCUT_REPORT_TONE_BAD;
}

static int fill_facts(page *p, wcut_report_fact *fact) {
    /* what the picture shows */
    const wcut_overlaid *o = p->o;
    const wcut_overlay *v = o->overlay;
    int n = 0;
    fact[n++] = (wcut_report_fact){"face that the picture shows", NULL, 100 * v->covered, "%"};
    fact[n++] = (wcut_report_fact){"patches with rills, of those seen", NULL, 100 * v->readable_share, "%"};
    fact[n++] = (wcut_report_fact){"size of a pixel", NULL, v->resolution, "mm"};
    fact[n++] = (wcut_report_fact){"points met by the camera, rms", NULL, o->report->rms, "px"};

    /* a plane camera has no focal length and no height */
    if (o->camera->kind == WCUT_CAMERA_KIND_PLANE) {
        fact[n++] = (wcut_report_fact){"camera", "one plane alone: heights above it shift what is measured", 0, ""};
    } else {
        fact[n++] = (wcut_report_fact){"focal length", NULL, o->camera->focal, "px"};
        fact[n++] = (wcut_report_fact){"its standard deviation", NULL, o->report->focal_sigma, "px"};
        fact[n++] = (wcut_report_fact){"distortion k1", NULL, o->camera->k1, ""};
        fact[n++] = (wcut_report_fact){"height of the camera", NULL, o->camera->centre.z, "mm"};
    }
    if (o->report->suspect >= 0)
        fact[n++] =
            (wcut_report_fact){"point to check", wcut_page_text(&p->memory, "row %d", o->report->suspect + 1), 0, ""};
    fact[n++] = (wcut_report_fact){"noise of the picture", NULL, v->noise, "levels"};
    return n;
}

static wcut_status write_overlay_page(page *p, const char *path, wcut_error *error) {
    const wcut_overlaid *o = p->o;

    /* maps, charts and tables */
    wcut_report_map map[3];
    wcut_report_series series[CHART_CURVES];
    wcut_report_chart chart;
    wcut_report_column phase[5], worst[5], points[6];
    wcut_report_table table[3];
    wcut_report_fact fact[FACTS];
    if (!fill_map(p, FIGURE_ANGLE, "Angle from the simulated wire to the rills, seen from above", "angle", "deg",
                  &map[0]) ||
        !fill_map(p, FIGURE_SIGMA, "Its standard deviation", "standard deviation", "deg", &map[1]) ||
        !fill_map(p, FIGURE_COHERENCE, "How clearly one direction prevails", "coherence", "", &map[2]) ||
        !fill_chart(p, series, &chart) || !fill_phases(p, phase, &table[0]) || !fill_worst(p, worst, &table[1]) ||
        !fill_points(p, points, &table[2]))
        return wcut_fail(error, WCUT_NO_MEMORY, "report page: %s", wcut_status_text(WCUT_NO_MEMORY));

    /* without rills there is no angle to show */
    const char *verdict;
    const wcut_report_tone tone = judge_overlay(p, &verdict);
    const int facts = fill_facts(p, fact);
    const bool read = o->overlay->readable > 0;

    /* without readable rills only the map of coherence is left */
    const wcut_report_section section[] = {{.title = "Rills beside the wire",
                                            .note = "Counter-clockwise is positive. The pictures stand beside this "
                                                    "page: rectified.png, overlay.png, overlay-photo.png, "
                                                    "details.png.",
                                            .map_count = read ? 3 : 1,
                                            .map = read ? map : &map[2],
                                            .table_count = read ? 2 : 1,
                                            .table = table},
                                           {.title = "The shape of the wire",
                                            .chart_count = chart.series_count > 0,
                                            .chart = &chart,
                                            .table_count = 1,
                                            .table = &table[2]}};

    /* the page with its sources */
    const wcut_report_source source[] = {{"job", o->job, o->job_sha256}, {"photo", o->photo, o->photo_sha256}};
    const wcut_report report = {.verb = "overlay",
                                .title = o->photo,
                                .tone = tone,
                                .verdict = verdict ? verdict : "",
                                .fact_count = facts,
                                .fact = fact,
                                .section_count = 2,
                                .section = section,
                                .source_count = 2,
                                .source = source};
    if (p->memory.failed) return wcut_fail(error, WCUT_NO_MEMORY, "report page: %s", wcut_status_text(WCUT_NO_MEMORY));
    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_overlay_write(const wcut_overlaid *overlaid, const char *path, wcut_error *error) {
    if (!overlaid || !overlaid->overlay || !overlaid->camera || !overlaid->report || !overlaid->point ||
        !overlaid->residual || !overlaid->leave_one_out || !overlaid->job || !overlaid->photo ||
        !overlaid->overlay->patch || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.o = overlaid};
    const wcut_status status = write_overlay_page(&p, path, error);
    wcut_page_free(&p.memory);
    return status;
}
