/* The page of a compensation: what is removed, also where the effects are off, and how the paths were corrected. */
#include <stdio.h>
#include <stdlib.h>
#include <wirecut/compensation_file.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"

enum { ROWS = 4, ROUNDS_MAX = 64, TEXT = 900 };

/* everything the page borrows */
typedef struct compensate_page {
    const wcut_compensation_result *result;
    const wcut_compensation *found;
    double *station, *round, *rms;
    const char **effect; /* their names */
    double before[ROWS], after[ROWS], removed[ROWS];
    char verdict[TEXT], hash[WCUT_SHA256_TEXT];
} compensate_page;

static wcut_status fill_compensate_page(compensate_page *p, wcut_error *error) {
    const wcut_compensation *c = p->found;
    const wcut_compensation_result *r = p->result;
    p->station = calloc((size_t)c->stations + 1, sizeof *p->station);
    p->round = calloc(ROUNDS_MAX, sizeof *p->round);
    p->rms = calloc(ROUNDS_MAX, sizeof *p->rms);
    p->effect = calloc((size_t)r->effects + 1, sizeof *p->effect);
    if (!p->station || !p->round || !p->rms || !p->effect) return WCUT_NO_MEMORY;

    /* abscissae and names */
    for (int k = 0; k < c->stations; k++) p->station[k] = k;
    for (int k = 0; k < c->rounds && k < ROUNDS_MAX; k++) p->round[k] = c->round[k].runs, p->rms[k] = c->round[k].rms;
    for (int e = 0; e < r->effects; e++) p->effect[e] = wcut_effect_view(r->effect[e].kind)->name;

    /* as assumed (rms, then the largest), then the two ends */
    const double pair[ROWS][2] = {{c->before_rms, c->after_rms},
                                  {c->before_max, c->after_max},
                                  {r->smaller_before, r->smaller_rms},
                                  {r->larger_before, r->larger_rms}};
    for (int k = 0; k < ROWS; k++) {
        p->before[k] = pair[k][0], p->after[k] = pair[k][1];
        p->removed[k] = pair[k][0] > 0 ? 100 * (1 - pair[k][1] / pair[k][0]) : 0;
    }
    const wcut_status status = wcut_compensation_say(r, TEXT, p->verdict);
    return status == WCUT_OK ? wcut_source_hash(r->job, p->hash, error) : status;
}

static wcut_report_series compensate_series(const compensate_page *p, const char *label, wcut_report_mark mark,
                                            const double *y) {
    return (wcut_report_series){
        .label = label, .mark = mark, .count = p->found->stations, .x = {p->station, NULL}, .y = y};
}

static wcut_report_chart correction_chart(const char *title, const char *note, const wcut_report_series series[2]) {
    return (wcut_report_chart){.title = title,
                               .note = note,
                               .x_label = {"station", NULL},
                               .x_unit = {"", NULL},
                               .y_label = "correction",
                               .y_unit = "mm",
                               .series_count = 2,
                               .series = series};
}

static wcut_status write_compensate_page(const compensate_page *p, const char *title, const char *path,
                                         wcut_error *error) {
    const wcut_compensation *c = p->found;
    const wcut_compensation_result *r = p->result;

    /* the figures, and each effect alone */
    const char *const ends[2][ROWS] = {
        {"rms", "largest", "rms, effects smaller by the spread", "rms, effects larger by the spread"},
        {"rms", "largest", "rms, effects at the lower ends of their 95 % intervals",
         "rms, effects at the upper ends of their 95 % intervals"}};
    const wcut_report_column of_gain[4] = {{"deviation", NULL, NULL, ends[r->interval != 0]},
                                           {"before", "mm", p->before, NULL},
                                           {"after", "mm", p->after, NULL},
                                           {"removed", "%", p->removed, NULL}};
    const wcut_report_column of_effect[2] = {{"effect", NULL, NULL, p->effect},
                                             {"moves the face by", "mm rms", r->moved, NULL}};
    const wcut_report_table table[2] = {
        {.title = "Deviation from the target", .rows = ROWS, .columns = 4, .column = of_gain},
        {.title = "Each effect alone", .rows = r->effects, .columns = 2, .column = of_effect}};

    /* what the mounts do otherwise, and how the search went */
    const wcut_report_series along[2] = {compensate_series(p, "lag of mount A", WCUT_REPORT_MARK_LINE, c->lag),
                                         compensate_series(p, "mounts nearer", WCUT_REPORT_MARK_DASHED, c->nearer)};
    const wcut_report_series heights[2] = {compensate_series(p, "mount A", WCUT_REPORT_MARK_LINE, c->rise_a),
                                           compensate_series(p, "mount B", WCUT_REPORT_MARK_DASHED, c->rise_b)};
    const wcut_report_series rounds = {.label = "rms",
                                       .mark = WCUT_REPORT_MARK_POINTS,
                                       .count = c->rounds < ROUNDS_MAX ? c->rounds : ROUNDS_MAX,
                                       .x = {p->round, NULL},
                                       .y = p->rms};
    const wcut_report_chart chart[2] = {
        correction_chart("Lag and distance",
                         "By how much mount A leads more than before, and how much less the mounts' "
                         "distance is.",
                         along),
        correction_chart("Heights", "By how much the mounts are higher than before.", heights)};
    const wcut_report_chart convergence = {.title = "Convergence",
                                           .note = "After each round; the last one has the job's own nodes.",
                                           .x_label = {"simulations so far", NULL},
                                           .x_unit = {"", NULL},
                                           .y_label = "rms",
                                           .y_unit = "mm",
                                           .series_count = 1,
                                           .series = &rounds};
    const wcut_report_section section[3] = {
        {.title = "What it is worth", .table_count = r->effects > 0 ? 2 : 1, .table = table},
        {.title = "The correction", .chart_count = 2, .chart = chart},
        {.title = "The search", .chart_count = 1, .chart = &convergence}};

    /* the answer in numbers */
    const wcut_report_fact fact[] = {{"before", NULL, c->before_rms, "mm rms"},
                                     {"after", NULL, c->after_rms, "mm rms"},
                                     {"removed", NULL, p->removed[0], "%"},
                                     {"worth it from", NULL, r->worth, "mm rms"},
                                     {"target", r->target ? r->target : "the face that the job plans", 0, ""},
                                     {"simulations", NULL, c->runs, ""}};
    const wcut_report_source source = {"job", r->job, p->hash[0] ? p->hash : NULL};
    const wcut_report report = {.verb = "compensate",
                                .title = title,
                                .tone = c->before_rms < r->worth ? WCUT_REPORT_TONE_PLAIN : WCUT_REPORT_TONE_GOOD,
                                .verdict = p->verdict,
                                .fact_count = 6,
                                .fact = fact,
                                .section_count = c->rounds > 0 ? 3 : 2,
                                .section = section,
                                .source_count = 1,
                                .source = &source};
    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_compensate_write(const char *title, const wcut_compensation_result *result, const char *path,
                                         wcut_error *error) {
    const wcut_compensation *c = result ? result->compensation : NULL;
    if (!title || !path || !c || !result->job || c->stations < 1 || !c->nearer || !c->lag || !c->rise_a || !c->rise_b ||
        (c->rounds > 0 && !c->round) || result->effects < 0 ||
        (result->effects > 0 && (!result->effect || !result->moved)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    compensate_page p = {.result = result, .found = c};
    wcut_status status = fill_compensate_page(&p, error);
    if (status == WCUT_OK) status = write_compensate_page(&p, title, path, error);
    free(p.station);
    free(p.round);
    free(p.rms);
    free(p.effect);
    return status;
}
