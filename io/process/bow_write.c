/* A bow's results: bow.json, bow.csv, bow_map.csv, feed_chart.csv. */
#include <math.h>
#include <wirecut/bow_file.h>
#include <wirecut/version.h>

#include "base/fail.h"
#include "io/file/text.h"

const char *wcut_bow_file_name(wcut_bow_file file) {
    static const char *const name[] = {"bow.json", "bow.csv", "bow_map.csv", "feed_chart.csv"};
    return (unsigned)file < sizeof name / sizeof *name ? name[file] : NULL;
}

typedef struct whole {
    const wcut_bow_results *results;
    const wcut_history *history;
} whole;

/* ---- tables ---- */

static void put_cells(wcut_text *text, int count, const double *value) {
    for (int k = 0; k < count; k++) {
        wcut_text_put(text, ",", 1);
        wcut_text_number(text, value[k]);
    }
}

static bool put_stations(wcut_text *text, const void *context) {
    const whole *w = context;
    wcut_text_put_word(text,
                       "station,time_s,phase,bow_mm,bow_node,closing_mm,tension_N,departure_mm,"
                       "force_x_N,force_y_N,force_z_N,moment_x_Nm,moment_y_Nm,moment_z_Nm\n");
    for (int j = 0; j < w->results->stations; j++) {
        const wcut_bow_row *r = &w->results->row[j];
        const wcut_history_row *h = &w->history->row[j];
        const double before[] = {h->time},
                     value[] = {r->closing, r->tension,         r->departure_max,   r->force.x,        r->force.y,
                                r->force.z, r->moment.x / 1000, r->moment.y / 1000, r->moment.z / 1000};

        /* when, where in the cut, how far it bows and at which node, and what the tool feels */
        wcut_text_print(text, "%d", j);
        put_cells(text, 1, before);
        wcut_text_print(text, ",%s", wcut_phase_name(h->phase));
        put_cells(text, 1, &r->bow);
        wcut_text_print(text, ",%d", r->node);
        put_cells(text, sizeof value / sizeof *value, value);
        wcut_text_put(text, "\n", 1);
    }
    return true;
}

static bool put_bow_map(wcut_text *text, const void *context) {
    const whole *w = context;
    wcut_text_put_word(text, "station,node,x_mm,y_mm,z_mm,departure_mm\n");
    for (int j = 0; j < w->results->stations; j++)
        for (int i = 0; i < w->results->nodes; i++) {
            const size_t at = (size_t)j * (size_t)w->results->nodes + (size_t)i;
            const wcut_vec3 p = w->history->position[at];
            const double value[] = {p.x, p.y, p.z, w->results->departure[at]};
            if (isnan(w->results->departure[at])) continue;
            wcut_text_print(text, "%d,%d", j, i);
            put_cells(text, 4, value);
            wcut_text_put(text, "\n", 1);
        }
    return true;
}

static bool put_feed_chart(wcut_text *text, const void *context) {
    const whole *w = context;
    const double *bow = wcut_feed_chart_bows();
    wcut_text_put_word(text,
                       "heat_W_per_m,bow_mm,feed_mm_s,kerf_mm,tension_N,strength_N,temperature_degC,"
                       "feed_allowed_mm_s\n");
    for (int k = 0; k < WCUT_FEED_CHART_HEATS; k++)
        for (int b = 0; b < WCUT_FEED_CHART_BOWS; b++) {
            const wcut_feed_chart_row *r = &w->results->chart[k];
            const double value[] = {bow[b],      r->feed[b],     r->kerf[b],   r->tension[b],
                                    r->strength, r->temperature, r->allowed[b]};
            wcut_text_number(text, r->heat);
            put_cells(text, sizeof value / sizeof *value, value);
            wcut_text_put(text, "\n", 1);
        }
    return true;
}

/* ---- figures ---- */

static void put_bow_place(wcut_text *text, const char *before, const wcut_bow_place *p) {
    wcut_text_put_number(text, before, p->value);
    wcut_text_print(text, ", \"station\": %d, \"node\": %d, \"at_mm\": ", p->station, p->node);
    wcut_text_put_point(text, "[", p->at);
    wcut_text_put(text, "}", 1);
}

/* the same three figures for each bow */
static void put_triple(wcut_text *text, const char *before, const double *value) {
    for (int b = 0; b < WCUT_FEED_CHART_BOWS; b++) wcut_text_put_number(text, b ? ", " : before, value[b]);
    wcut_text_put(text, "]", 1);
}

static bool put_figures(wcut_text *text, const void *context) {
    const wcut_bow_results *r = ((const whole *)context)->results;
    wcut_text_print(text, "{\n  \"format\": \"wirecut-bow/1\",\n  \"version\": \"%s\",\n  \"stations\": %d",
                    WCUT_VERSION, r->stations);
    put_bow_place(text, ",\n  \"bow\": {\"max_mm\": ", &r->bow);
    put_bow_place(text, ",\n  \"departure\": {\"max_mm\": ", &r->departure_max);

    /* the wire and what the tool feels */
    wcut_text_put_number(text, ",\n  \"tension\": {\"max_N\": ", r->tension_max);
    wcut_text_print(text, ", \"station\": %d", r->tension_station);
    wcut_text_put_number(text, ", \"strength_N\": ", r->strength);
    wcut_text_put_number(text, ", \"temperature_degC\": ", r->temperature);
    wcut_text_put_number(text, ", \"slack_share\": ", r->slack_share);
    wcut_text_put_number(text, "},\n  \"force_max_N\": ", r->force_max);
    wcut_text_put_number(text, ",\n  \"moment_max_Nm\": ", r->moment_max / 1000);

    /* the feed chart, a row a heat */
    put_triple(text, ",\n  \"feed_chart\": {\"bow_mm\": [", wcut_feed_chart_bows());
    wcut_text_put_word(text, ", \"heats\": [");
    for (int k = 0; k < WCUT_FEED_CHART_HEATS; k++) {
        const wcut_feed_chart_row *c = &r->chart[k];
        wcut_text_put_number(text, k ? ",\n    {\"heat_W_per_m\": " : "\n    {\"heat_W_per_m\": ", c->heat);
        put_triple(text, ", \"feed_mm_s\": [", c->feed);
        put_triple(text, ", \"kerf_mm\": [", c->kerf);
        put_triple(text, ", \"tension_N\": [", c->tension);
        wcut_text_put_number(text, ", \"strength_N\": ", c->strength);
        wcut_text_put_number(text, ", \"temperature_degC\": ", c->temperature);
        put_triple(text, ", \"feed_allowed_mm_s\": [", c->allowed);
        wcut_text_put(text, "}", 1);
    }
    wcut_text_put_word(text, "]}\n}\n");
    return true;
}

wcut_status wcut_bow_results_write(const wcut_bow_results *results, const wcut_history *history, wcut_bow_file file,
                                   const char *path, wcut_error *error) {
    static wcut_text_writer *const writer[] = {put_figures, put_stations, put_bow_map, put_feed_chart};
    if (!results || !history || !path || (unsigned)file >= sizeof writer / sizeof *writer ||
        results->stations != history->stations || results->nodes != history->nodes)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "a bow: expected its results, their history and a file name");
    const whole w = {results, history};
    return wcut_text_write_file(path, writer[file], &w, error);
}
