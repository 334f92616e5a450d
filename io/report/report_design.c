/* The page of a design: target and cut in space with the deviation, the map with its reasons, the curves that were found. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"

enum { REASONS = 5, ROUNDS_MAX = 64, TEXT = 512, PANEL_COLUMNS = 8, JOINT_COLUMNS = 6 };

/* everything the page borrows */
typedef struct design_page {
    const wcut_report_design *report;
    const wcut_design_map *map;
    const wcut_design *design;
    double *station, *x, *y, *reason, *round, *rms;
    double *panel[PANEL_COLUMNS], *joint[JOINT_COLUMNS]; /* columns of tables */
    char verdict[TEXT], hash[WCUT_SHA256_TEXT];
} design_page;

static void clear_design_page(design_page *p) {
    free(p->station);
    free(p->x);
    free(p->y);
    free(p->reason);
    free(p->round);
    free(p->rms);
    for (int k = 0; k < PANEL_COLUMNS; k++) free(p->panel[k]);
    for (int k = 0; k < JOINT_COLUMNS; k++) free(p->joint[k]);
}

/* numbers of the tables of panels and joints */
static bool fill_panels(design_page *p) {
    const wcut_design_panels *of = p->report->result->panels;
    if (!of) return true;
    for (int k = 0; k < PANEL_COLUMNS; k++)
        if (!(p->panel[k] = calloc((size_t)of->count, sizeof(double)))) return false;
    for (int k = 0; k < JOINT_COLUMNS; k++)
        if (!(p->joint[k] = calloc((size_t)of->joints, sizeof(double)))) return false;

    /* a row for each panel, then for each joint */
    for (int k = 0; k < of->count; k++) {
        const wcut_design_panel *one = &of->panel[k];
        const double value[PANEL_COLUMNS] = {
            k + 1.0,     one->low.x,         one->high.x,           one->low.y,
            one->high.y, one->predicted_rms, one->design->path_rms, one->design->path_max};
        for (int c = 0; c < PANEL_COLUMNS; c++) p->panel[c][k] = value[c];
    }
    for (int k = 0; k < of->joints; k++) {
        const wcut_design_joint *one = &of->joint[k];
        const double value[JOINT_COLUMNS] = {one->first + 1.0,
                                             one->second + 1.0,
                                             one->step_rms,
                                             one->step_max,
                                             one->angle_rms * WCUT_DEG_PER_RAD,
                                             one->angle_max * WCUT_DEG_PER_RAD};
        for (int c = 0; c < JOINT_COLUMNS; c++) p->joint[c][k] = value[c];
    }
    return true;
}

static wcut_status fill_design_page(design_page *p, wcut_error *error) {
    const wcut_design_map *m = p->map;
    const wcut_design *d = p->design;
    const size_t stations = d ? (size_t)d->stations : 1, cells = (size_t)m->rows * (size_t)m->columns;
    p->station = calloc(stations, sizeof *p->station);
    p->x = calloc((size_t)m->columns, sizeof *p->x);
    p->y = calloc((size_t)m->rows, sizeof *p->y);
    p->reason = calloc(cells, sizeof *p->reason);
    p->round = calloc(ROUNDS_MAX, sizeof *p->round);
    p->rms = calloc(ROUNDS_MAX, sizeof *p->rms);
    if (!p->station || !p->x || !p->y || !p->reason || !p->round || !p->rms || !fill_panels(p)) return WCUT_NO_MEMORY;

    /* abscissae, and the map's reasons as numbers */
    for (size_t k = 0; k < stations; k++) p->station[k] = (double)k;
    for (int i = 0; i < m->columns; i++) p->x[i] = m->point[i].x;
    for (int j = 0; j < m->rows; j++) p->y[j] = m->point[(size_t)j * (size_t)m->columns].y;
    for (size_t k = 0; k < cells; k++) p->reason[k] = m->reason[k];
    for (int k = 0; d && k < d->rounds && k < ROUNDS_MAX; k++)
        p->round[k] = d->round[k].runs, p->rms[k] = d->round[k].rms;
    wcut_design_result_say(p->report->result, TEXT, p->verdict);
    return wcut_source_hash(p->report->result->target, p->hash, error);
}

/* ---- sections ---- */

static wcut_report_map design_map_of(const design_page *p, const char *title, const char *note, const char *label,
                                     const char *unit, const double *value) {
    const wcut_design_map *m = p->map;
    return (wcut_report_map){.title = title,
                             .note = note,
                             .x_label = "x",
                             .x_unit = "mm",
                             .y_label = "y",
                             .y_unit = "mm",
                             .label = label,
                             .unit = unit,
                             .columns = m->columns,
                             .rows = m->rows,
                             .x = p->x,
                             .y = p->y,
                             .value = value,
                             .scale = WCUT_REPORT_SCALE_DIVERGING};
}

static wcut_report_chart design_chart(const char *title, const char *note, int count,
                                      const wcut_report_series *series) {
    return (wcut_report_chart){.title = title,
                               .note = note,
                               .x_label = {"station", NULL},
                               .x_unit = {"", NULL},
                               .y_label = "length",
                               .y_unit = "mm",
                               .series_count = count,
                               .series = series};
}

static wcut_report_series design_series(const design_page *p, const char *label, wcut_report_mark mark,
                                        const double *y) {
    return (wcut_report_series){
        .label = label, .mark = mark, .count = p->design->stations, .x = {p->station, NULL}, .y = y};
}

static wcut_status write_design_page(design_page *p, const wcut_report_scene *scene, const char *path,
                                     wcut_error *error) {
    const wcut_design_map *m = p->map;
    const wcut_design *d = p->design;
    const wcut_design_result *r = p->report->result;

    /* the map, and shares of its reasons */
    static const char *const words[REASONS] = {"followed", "domed: positive Gauss curvature, no wire lies in it",
                                               "tight: bent more than the force bends a wire",
                                               "angle: the wire would stand beyond its largest angle",
                                               "pattern: no family of wires runs from side to side"};
    double percent[REASONS];
    for (int k = 0; k < REASONS; k++) percent[k] = 100 * m->share[k];
    const wcut_report_map map[2] = {
        design_map_of(p, "Bow that no wire can follow", "Predicted without simulating; positive above the target.",
                      "bow", "mm", m->bow),
        design_map_of(p, "Gauss curvature", "Where it is positive no wire lies in the target.", "K", "1/mm\xc2\xb2",
                      m->gauss)};
    const wcut_report_column column[2] = {{"place", NULL, NULL, words}, {"share of the plan", "%", percent, NULL}};
    const wcut_report_table table = {.title = "Why not nearer", .rows = REASONS, .columns = 2, .column = column};

    /* the curves that were found, and how the search went */
    wcut_report_series lag = {0}, bow[2] = {{0}};
    if (d) {
        lag = design_series(p, "lag of end A before end B", WCUT_REPORT_MARK_LINE, d->lag);
        bow[0] = design_series(p, "sag", WCUT_REPORT_MARK_LINE, d->sag);
        bow[1] = design_series(p, "extra length", WCUT_REPORT_MARK_DASHED, d->extra);
    }
    const wcut_report_chart curve[2] = {design_chart("Lag", "How far end A leads end B along the feed.", 1, &lag),
                                        design_chart("Sag and extra length of the wire", NULL, 2, bow)};
    const wcut_report_series rounds = {.label = "rms",
                                       .mark = WCUT_REPORT_MARK_POINTS,
                                       .count = d ? d->rounds : 0,
                                       .x = {p->round, NULL},
                                       .y = p->rms};
    const wcut_report_chart convergence = {.title = "Convergence",
                                           .note = "After each round; later rounds have finer runs or more unknowns.",
                                           .x_label = {"simulations so far", NULL},
                                           .x_unit = {"", NULL},
                                           .y_label = "rms",
                                           .y_unit = "mm",
                                           .series_count = 1,
                                           .series = &rounds};

    /* panels and where they meet */
    const wcut_design_panels *panels = r->panels;
    const wcut_report_column of_panel[PANEL_COLUMNS] = {
        {"panel", NULL, p->panel[0], NULL},       {"x from", "mm", p->panel[1], NULL},
        {"x to", "mm", p->panel[2], NULL},        {"y from", "mm", p->panel[3], NULL},
        {"y to", "mm", p->panel[4], NULL},        {"predicted rms", "mm", p->panel[5], NULL},
        {"reached rms", "mm", p->panel[6], NULL}, {"at most", "mm", p->panel[7], NULL}};
    const wcut_report_column of_joint[JOINT_COLUMNS] = {
        {"panel", NULL, p->joint[0], NULL},       {"and panel", NULL, p->joint[1], NULL},
        {"step, rms", "mm", p->joint[2], NULL},   {"step at most", "mm", p->joint[3], NULL},
        {"angle, rms", "deg", p->joint[4], NULL}, {"angle at most", "deg", p->joint[5], NULL}};
    const wcut_report_table in_panels[2] = {
        {.title = "Panels", .rows = panels ? panels->count : 0, .columns = PANEL_COLUMNS, .column = of_panel},
        {.title = "Joints",
         .note = "Between the faces of two panels along the line where they meet.",
         .rows = panels ? panels->joints : 0,
         .columns = JOINT_COLUMNS,
         .column = of_joint}};
    const wcut_report_section section[] = {
        {.title = "Feasibility", .map_count = 2, .map = map, .table_count = 1, .table = &table},
        {.title = "The panels", .table_count = 2, .table = in_panels}};
    const wcut_report_section of_cut[] = {section[0],
                                          {.title = "The design", .chart_count = 2, .chart = curve},
                                          {.title = "The search", .chart_count = 1, .chart = &convergence}};

    /* the answer in numbers */
    const wcut_report_fact fact[] = {{"tolerance", NULL, r->tolerance, "mm rms"},
                                     {"feed", wcut_design_feed_name(d ? d->feed : m->feed), 0, ""},
                                     {"predicted by the map", NULL, m->predicted_rms, "mm rms"},
                                     {"domed share of the target", NULL, 100 * m->domed_share, "%"},
                                     {"reached by the paths", NULL, r->face_rms, "mm rms"},
                                     {"reached by the plan", NULL, d ? d->rms : 0, "mm rms"},
                                     {"simulations", NULL, d ? d->runs : 0, ""},
                                     {"unknowns", NULL, d && d->rounds ? d->round[d->rounds - 1].unknowns : 0, ""}};
    const wcut_report_source source = {"target", r->target, p->hash[0] ? p->hash : NULL};
    const wcut_report report = {.verb = "design",
                                .title = p->report->title,
                                .tone = !d && !panels                 ? WCUT_REPORT_TONE_PLAIN
                                        : r->face_rms <= r->tolerance ? WCUT_REPORT_TONE_GOOD
                                                                      : WCUT_REPORT_TONE_BAD,
                                .verdict = p->verdict,
                                .fact_count = d        ? 8
                                              : panels ? 5
                                                       : 4,
                                .fact = fact,
                                .scene = scene,
                                .section_count = d        ? 3
                                                 : panels ? 2
                                                          : 1,
                                .section = d ? of_cut : section,
                                .source_count = 1,
                                .source = &source};
    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_design_write(const wcut_report_design *report, const char *path, wcut_error *error) {
    if (!report || !report->title || !report->result || !report->result->map || !report->result->target || !path ||
        (report->result->design && (!report->deviation || !report->history)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    design_page p = {.report = report, .map = report->result->map, .design = report->result->design};
    wcut_status status = fill_design_page(&p, error);
    if (status == WCUT_OK) {
        /* the target with the bow, its points with the deviation, the cut */
        const wcut_design_map *m = p.map;
        const wcut_design *d = p.design;
        const wcut_report_field on_map[] = {
            {"bow that no wire can follow", "mm", WCUT_REPORT_SCALE_DIVERGING, report->result->tolerance, m->bow},
            {"Gauss curvature", "1/mm\xc2\xb2", WCUT_REPORT_SCALE_DIVERGING, 0, m->gauss}};
        const wcut_report_field off = {"deviation from the cut", "mm", WCUT_REPORT_SCALE_DIVERGING,
                                       report->result->tolerance, report->deviation};
        const wcut_report_field speed = {"speed of the wire", "mm/s", WCUT_REPORT_SCALE_SEQUENTIAL, 0,
                                         report->history ? report->history->speed : NULL};
        wcut_report_shape shape[3] = {{.name = "target, as it was given",
                                       .vertex_count = m->rows * m->columns,
                                       .vertex = m->point,
                                       .rows = m->rows,
                                       .columns = m->columns,
                                       .row_label = "row",
                                       .column_label = "column",
                                       .field_count = 2,
                                       .field = on_map}};
        if (d && report->history) {
            shape[1] = shape[0];
            shape[0] = (wcut_report_shape){.name = "target's points",
                                           .vertex_count = d->points,
                                           .vertex = d->point,
                                           .field_count = 1,
                                           .field = &off};
            shape[2] = (wcut_report_shape){.name = "cut",
                                           .vertex_count = report->history->stations * report->history->nodes,
                                           .vertex = report->history->position,
                                           .rows = report->history->stations,
                                           .columns = report->history->nodes,
                                           .row_label = "station",
                                           .column_label = "node",
                                           .field_count = 1,
                                           .field = &speed};
        }
        const wcut_report_scene scene = {
            .title = "Target and cut",
            .note = d ? "The cut and the points stand in the frame of the design, whose feed "
                        "is +y."
                      : NULL,
            .block_size = report->block,
            .shape_count = d ? 3 : 1,
            .shape = shape};
        status = write_design_page(&p, &scene, path, error);
    }
    clear_design_page(&p);
    return status;
}
