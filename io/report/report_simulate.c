/* The page of a simulated cut: force map and path curves in space, speeds, tensions and angles along the cut. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/angle.h>
#include <wirecut/curvature.h>
#include <wirecut/feasibility.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/report_bow.h"

#define DEPARTED 0.1 /* [mm] a face within it is ruled as far as anybody sees */
#define FLAT 1e-6    /* [1/mm] a radius of 1 km is flat: what is left is rounding */
/* what is plotted of every station */
enum {
    TIME,
    STATION,
    SPEED_A,
    SPEED_B,
    TENSION_A,
    TENSION_B,
    ALPHA_A,
    ALPHA_B,
    BETA_A,
    BETA_B,
    ENGAGED,
    STEPS,
    RESIDUAL,
    COLUMNS
};

enum { CHARTS = 5, SOLVER_CHARTS = 2, PHASES_MAX = 64 };

/* everything the page borrows */
typedef struct page {
    const wcut_report_simulate *run;
    const wcut_job *job;
    const wcut_history *history;
    double *column[COLUMNS];      /* stations each, in one block */
    wcut_vec3 *mount_a, *mount_b; /* stations; none without a surface */
    double *force, *curvature;    /* stations x nodes; none without a surface */
    char verdict[512], block[96], hash[WCUT_SHA256_TEXT];
    double *share; /* measures x stations; NULL: not judged */
    wcut_feasibility feasibility;
    wcut_bow_results *bow; /* of a bow; its section borrows what is in bow_parts */
    wcut_report_bow bow_parts;
    wcut_report_section bow_section;
} page;

/* ---- what is copied ---- */

static void fill_page_columns(page *p) {
    /* each station is a row of the columns */
    for (int s = 0; s < p->history->stations; s++) {
        const wcut_history_row *row = &p->history->row[s];
        const double value[COLUMNS] = {
            [TIME] = row->time,
            [STATION] = s,
            /* the first station was not arrived at: it has no speed */
            [SPEED_A] = s ? row->speed_a : NAN,
            [SPEED_B] = s ? row->speed_b : NAN,
            [TENSION_A] = row->tension_a,
            [TENSION_B] = row->tension_b,
            [ALPHA_A] = row->alpha_a * WCUT_DEG_PER_RAD,
            [ALPHA_B] = row->alpha_b * WCUT_DEG_PER_RAD,
            [BETA_A] = row->beta_a * WCUT_DEG_PER_RAD,
            [BETA_B] = row->beta_b * WCUT_DEG_PER_RAD,
            [ENGAGED] = row->engaged_length,
            [STEPS] = row->iterations,
            [RESIDUAL] = row->residual,
        };
        for (int c = 0; c < COLUMNS; c++) p->column[c][s] = value[c];
    }
}

/* the larger principal curvature at every node; none where the surface is a point or an edge */
static wcut_status fill_curvature(page *p) {
    /* one parameter for each station */
    const wcut_history *h = p->history;
    double *parameter = calloc((size_t)h->stations, sizeof *parameter);
    wcut_surface *surface = NULL;
    wcut_status status = parameter ? WCUT_OK : WCUT_NO_MEMORY;

    /* the surface through the stations gives a parameter for each */
    if (!status)
        status = wcut_surface_loft(h->stations, h->nodes, h->position, p->run->merge, &surface, parameter, NULL);

    /* node by node; a degenerate point has no curvature */
    for (int s = 0; !status && s < h->stations; s++)
        for (int n = 0; !status && n < h->nodes; n++) {
            double *to = &p->curvature[s * h->nodes + n];
            status = wcut_surface_curvature(surface, n / (h->nodes - 1.0), parameter[s], to, NULL);
            if (status == WCUT_DEGENERATE) {
                *to = NAN;
                status = WCUT_OK;
            }
        }

    wcut_surface_destroy(surface);
    free(parameter);
    return status;
}

static wcut_status fill_station_page(page *p, const wcut_setup *setup, wcut_error *error) {
    /* room for the columns and maps of the page */
    const wcut_history *h = p->history;
    const size_t stations = (size_t)h->stations, cells = stations * (size_t)h->nodes;
    double *block = calloc(COLUMNS * stations, sizeof *block);
    for (int c = 0; c < COLUMNS; c++) p->column[c] = block ? block + c * stations : NULL;

    p->force = calloc(cells, sizeof *p->force);
    p->curvature = calloc(cells, sizeof *p->curvature);
    p->mount_a = calloc(stations, sizeof *p->mount_a);
    p->mount_b = calloc(stations, sizeof *p->mount_b);
    if (!block || !p->force || !p->curvature || !p->mount_a || !p->mount_b) return WCUT_NO_MEMORY;

    /* columns, and the force where there is one */
    fill_page_columns(p);
    /* outside the foam there is no force, and no colour */
    for (size_t i = 0; i < cells; i++) p->force[i] = h->force_line[i] > 0 ? h->force_line[i] : NAN;

    /* the hash of the job, and the path curves of a whole cut */
    wcut_status status = wcut_source_hash(p->run->job_path, p->hash, error);
    if (status) return status;
    if (h->stations < 2) return WCUT_OK;
    double length;
    status = wcut_history_path(setup, h, p->mount_a, p->mount_b, &length, error);
    if (status) return status;

    /* by the default limits; a wire beyond their range is not judged */
    p->share = calloc(stations * WCUT_FEASIBILITY_MEASURE_COUNT, sizeof *p->share);
    if (!p->share) return WCUT_NO_MEMORY;
    if (wcut_feasibility_eval(p->job, h, p->mount_a, p->mount_b, NULL, &p->feasibility, p->share) != WCUT_OK) {
        free(p->share);
        p->share = NULL;
    }

    /* what users of a bow ask for; a wire beyond the range of its limits has none of it */
    if (p->job->rig.kind == WCUT_RIG_KIND_BOW && wcut_bow_results_create(setup, h, NULL, &p->bow, error) == WCUT_OK)
        status = wcut_report_bow_fill(&p->bow_parts, p->bow, p->column[TIME], p->column[STATION], &p->bow_section);

    return status ? status : fill_curvature(p);
}

static void clear_page(page *p) {
    free(p->column[0]);
    free(p->force);
    free(p->curvature);
    free(p->mount_a);
    free(p->mount_b);
    free(p->share);
    wcut_report_bow_clear(&p->bow_parts);
    wcut_bow_results_destroy(p->bow);
}

/* ---- what is said ---- */

static wcut_report_tone run_tone(page *p) {
    const wcut_history *h = p->history;

    /* stations at which the speed reached its lower limit */
    const wcut_history_row *last = &h->row[h->stations - 1];
    int slow = 0;
    for (int s = 0; s < h->stations; s++) slow += h->row[s].condition == WCUT_CONDITION_SPEED_MIN;

    /* the worst news is the verdict */
    if (p->run->ended || h->stations < h->planned) {
        snprintf(p->verdict, sizeof p->verdict, "The cut ends early, after station %d of 0 to %d and %.1f s: %.300s.",
                 h->stations - 1, h->planned - 1, last->time,
                 h->ended.text[0] ? h->ended.text : wcut_status_text(p->run->ended));
        return WCUT_REPORT_TONE_BAD;
    }

    /* the usual end, by how the wire left the block */
    const bool whole = last->phase == WCUT_PHASE_LEFT || p->job->mode == WCUT_MODE_DESIGN;
    const char *end = last->phase == WCUT_PHASE_LEFT ? "leaves the block"
                      : whole                        ? "reaches the end of its design"
                                                     : "ends its path in the foam";
    if (slow > 0) {
        snprintf(p->verdict, sizeof p->verdict,
                 "The wire %s after %.1f s, but at %d of %d stations the speed is at its lower limit, %g mm/s, and the "
                 "tension exceeds %g N.",
                 end, last->time, slow, h->stations, p->job->speed_min, p->job->tension);
        return WCUT_REPORT_TONE_WARNING;
    }
    snprintf(p->verdict, sizeof p->verdict, "The wire %s after %.1f s.", end, last->time);

    return whole ? WCUT_REPORT_TONE_GOOD : WCUT_REPORT_TONE_PLAIN;
}

/* runs of stations of one phase; gives how many */
static int list_phases(const page *p, wcut_report_span *span) {
    const wcut_history *h = p->history;
    int count = 0;
    for (int s = 0, from = 0; s < h->stations && count < PHASES_MAX; s++) {
        if (s + 1 < h->stations && h->row[s + 1].phase == h->row[from].phase) continue;
        const int to = s + 1 < h->stations ? s + 1 : s;
        span[count++] = (wcut_report_span){.label = wcut_phase_name(h->row[from].phase),
                                           .from = {h->row[from].time, from},
                                           .to = {h->row[to].time, to}};
        from = s + 1;
    }
    return count;
}

static wcut_report_series page_series(const page *p, const char *label, wcut_report_mark mark, int column) {
    return (wcut_report_series){.label = label,
                                .mark = mark,
                                .count = p->history->stations,
                                .x = {p->column[TIME], p->column[STATION]},
                                .y = p->column[column]};
}

static wcut_report_chart station_chart(const char *title, const char *label, const char *unit, int count,
                                       const wcut_report_series *of, int spans, const wcut_report_span *span) {
    return (wcut_report_chart){.title = title,
                               .x_label = {"time", "station"},
                               .x_unit = {"s", ""},
                               .y_label = label,
                               .y_unit = unit,
                               .series_count = count,
                               .series = of,
                               .span_count = spans,
                               .span = span};
}

/* ---- the page ---- */

static wcut_status write_simulate_page(page *p, const wcut_report_scene *scene, const char *path, wcut_error *error) {
    const wcut_history *h = p->history;
    const wcut_job *job = p->job;

    /* phases are shaded in every chart */
    wcut_report_span span[PHASES_MAX];
    const int spans = list_phases(p, span);

    /* both mounts in each chart */
    const wcut_report_series pair[][2] = {{page_series(p, "mount A", WCUT_REPORT_MARK_LINE, SPEED_A),
                                           page_series(p, "mount B", WCUT_REPORT_MARK_DASHED, SPEED_B)},
                                          {page_series(p, "mount A", WCUT_REPORT_MARK_LINE, TENSION_A),
                                           page_series(p, "mount B", WCUT_REPORT_MARK_DASHED, TENSION_B)},
                                          {page_series(p, "mount A", WCUT_REPORT_MARK_LINE, ALPHA_A),
                                           page_series(p, "mount B", WCUT_REPORT_MARK_DASHED, ALPHA_B)},
                                          {page_series(p, "mount A", WCUT_REPORT_MARK_LINE, BETA_A),
                                           page_series(p, "mount B", WCUT_REPORT_MARK_DASHED, BETA_B)}};

    /* the wire as a whole, and the solver */
    const wcut_report_series engaged = page_series(p, "wire in the foam", WCUT_REPORT_MARK_LINE, ENGAGED);
    const wcut_report_series steps = page_series(p, "Newton iterations", WCUT_REPORT_MARK_LINE, STEPS);
    const wcut_report_series residual = page_series(p, "largest relative residual", WCUT_REPORT_MARK_LINE, RESIDUAL);
    const wcut_report_chart along[CHARTS] = {
        station_chart("Speed of the mounts", "speed", "mm/s", 2, pair[0], spans, span),
        station_chart("Tension at the mounts", "tension", "N", 2, pair[1], spans, span),
        station_chart("Angle alpha, positive when the wire trails", "alpha", "deg", 2, pair[2], spans, span),
        station_chart("Angle beta, positive upward", "beta", "deg", 2, pair[3], spans, span),
        station_chart("Wire in the foam", "length", "mm", 1, &engaged, spans, span)};
    const wcut_report_chart solver[SOLVER_CHARTS] = {
        station_chart("Iterations", "iterations", "", 1, &steps, spans, span),
        station_chart("Residual", "residual", "", 1, &residual, spans, span)};

    /* every figure of every station over its limit */
    static const char *const row_name[WCUT_FEASIBILITY_MEASURE_COUNT] = {"speed", "alpha", "beta", "turn of the wire",
                                                                         "stress of the wire"};
    static const int row_first[WCUT_FEASIBILITY_MEASURE_COUNT] = {0, 1, 2, 3, 4};
    static const double row_at[WCUT_FEASIBILITY_MEASURE_COUNT] = {0, 1, 2, 3, 4};
    const wcut_report_map map = {.title = "Share of each limit",
                                 .note = p->feasibility.reason,
                                 .x_label = "station",
                                 .x_unit = "",
                                 .y_label = "limit",
                                 .y_unit = "",
                                 .label = "value over limit",
                                 .unit = "",
                                 .columns = h->stations,
                                 .rows = WCUT_FEASIBILITY_MEASURE_COUNT,
                                 .x = p->column[STATION],
                                 .y = row_at,
                                 .value = p->share,
                                 .scale = WCUT_REPORT_SCALE_SEQUENTIAL,
                                 .limit = 1,
                                 .bands = WCUT_FEASIBILITY_MEASURE_COUNT,
                                 .band = row_first,
                                 .band_label = row_name};

    /* sections: the bow of a bow, limits, the course of the cut, the solver */
    const wcut_report_section section[] = {
        p->bow_section,
        {.title = "Feasibility", .map_count = p->share ? 1 : 0, .map = &map},
        {.title = "Along the cut", .chart_count = CHARTS, .chart = along},
        {.title = "Quality of the solution", .chart_count = SOLVER_CHARTS, .chart = solver}};

    /* three numbers as one text */
    snprintf(p->block, sizeof p->block, "%g \xc3\x97 %g \xc3\x97 %g", job->block_size.x, job->block_size.y,
             job->block_size.z);

    /* the answer in numbers, and the settings */
    const wcut_report_fact fact[] = {
        {"feasibility", p->share ? wcut_feasibility_name(p->feasibility.verdict) : "not judged", 0, ""},
        {"duration", NULL, h->row[h->stations - 1].time, "s"},
        {"stations", NULL, h->stations, ""},
        {"nodes along the wire", NULL, h->nodes, ""},
        {"block, x by y by z", p->block, 0, "mm"},
        {"heat", NULL, job->heat, "W/m"},
        {p->bow ? "pretension, cold" : "target tension", NULL, p->bow ? job->rig.pretension : job->tension, "N"},
        {"foam", job->foam_material ? job->foam_material : "not stated", 0, ""},
        {"wire", job->wire_material ? job->wire_material : "not stated", 0, ""},
        {"wire diameter", NULL, job->wire_diameter, "mm"},
        {"force law, a", NULL, job->force_law.a, "N/mm"},
        {"force law, b", NULL, job->force_law.b, "m\xc2\xb2/J"}};
    const wcut_report_fact option[] = {{"integrator", p->run->integrator, 0, ""},
                                       {"chord tolerance of the meshes", NULL, p->run->chord_tolerance, "mm"},
                                       {"lowest speed allowed", NULL, job->speed_min, "mm/s"},
                                       {"highest speed allowed", NULL, job->speed_max, "mm/s"},
                                       {"kerf", NULL, job->kerf_width, "mm"}};

    /* where it came from, and the whole */
    const wcut_report_source source = {"job", p->run->job_path, p->hash[0] ? p->hash : NULL};
    const wcut_report report = {.verb = "simulate",
                                .title = job->name ? job->name : p->run->job_path,
                                .tone = run_tone(p),
                                .verdict = p->verdict,
                                .fact_count = sizeof fact / sizeof *fact,
                                .fact = fact,
                                .scene = scene,
                                .section_count = sizeof section / sizeof *section - (p->bow ? 0 : 1),
                                .section = section + (p->bow ? 0 : 1),
                                .source_count = 1,
                                .source = &source,
                                .option_count = sizeof option / sizeof *option,
                                .option = option};

    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_simulate_write(const wcut_report_simulate *run, const wcut_setup *setup,
                                       const wcut_history *history, const char *path, wcut_error *error) {
    if (!run || !run->job_path || !setup || !history || history->stations < 1 || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.run = run, .job = wcut_setup_job(setup), .history = history};
    wcut_status status = fill_station_page(&p, setup, error);
    if (!status) {
        /* what colours the surface */
        const wcut_report_field field[] = {
            {"force across the wire", "N/mm", WCUT_REPORT_SCALE_SEQUENTIAL, 0, p.force},
            {"speed of the wire", "mm/s", WCUT_REPORT_SCALE_SEQUENTIAL, 0, history->speed},
            {"largest curvature", "1/mm", WCUT_REPORT_SCALE_DIVERGING, FLAT, p.curvature},
            {"departure from the ruled surface", "mm", WCUT_REPORT_SCALE_DIVERGING, DEPARTED,
             p.bow ? p.bow->departure : NULL}};

        /* the surface, and the path curves beside it */
        const wcut_report_shape shape = {.name = "swept surface",
                                         .vertex_count = history->stations * history->nodes,
                                         .vertex = history->position,
                                         .rows = history->stations,
                                         .columns = history->nodes,
                                         .row_label = "station",
                                         .column_label = "node",
                                         .field_count = sizeof field / sizeof *field - (p.bow ? 0 : 1),
                                         .field = field};
        const wcut_report_line line[] = {{"path curves", "A", history->stations, p.mount_a},
                                         {"path curves", "B", history->stations, p.mount_b}};

        /* the scene in the block; a single station has no surface */
        const wcut_report_scene scene = {.title = "Surface swept by the wire",
                                         .note = "Grey: outside the foam, where the wire has no load.",
                                         .block_size = p.job->block_size,
                                         .shape_count = 1,
                                         .shape = &shape,
                                         .line_count = 2,
                                         .line = line};

        status = write_simulate_page(&p, history->stations > 1 ? &scene : NULL, path, error);
    }
    clear_page(&p);

    return status;
}
