/* "wirecut-summary/1": a cut in a few figures. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>
#include <wirecut/write.h>

#include "fail.h"
#include "history_check.h"
#include "text.h"

#define DEG (180 / 3.14159265358979323846)

/* what the figures are taken from: every station that the wire moved to */
typedef struct moves {
    const wcut_history_row *row;
    int count;
} moves;

/* a figure of a row */
typedef double figure(const wcut_history_row *row);

static double speed_of(const wcut_history_row *r) { return r->speed_a > r->speed_b ? r->speed_a : r->speed_b; }
static double alpha_a_of(const wcut_history_row *r) { return r->alpha_a * DEG; }
static double alpha_b_of(const wcut_history_row *r) { return r->alpha_b * DEG; }
static double beta_a_of(const wcut_history_row *r) { return r->beta_a * DEG; }
static double beta_b_of(const wcut_history_row *r) { return r->beta_b * DEG; }
static double tension_a_of(const wcut_history_row *r) { return r->tension_a; }
static double tension_b_of(const wcut_history_row *r) { return r->tension_b; }
static double residual_of(const wcut_history_row *r) { return r->residual; }
static double iterations_of(const wcut_history_row *r) { return r->iterations; }
static double substeps_of(const wcut_history_row *r) { return r->substeps; }

static double least_of(moves m, figure *of) {
    double least = of(&m.row[0]);
    for (int j = 1; j < m.count; j++) least = of(&m.row[j]) < least ? of(&m.row[j]) : least;
    return least;
}

static double greatest_of(moves m, figure *of) {
    double greatest = of(&m.row[0]);
    for (int j = 1; j < m.count; j++) greatest = of(&m.row[j]) > greatest ? of(&m.row[j]) : greatest;
    return greatest;
}

static double mean_of(moves m, figure *of) {
    double sum = 0;
    for (int j = 0; j < m.count; j++) sum += of(&m.row[j]);
    return sum / m.count;
}

static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static bool find_median(moves m, figure *of, double *median) {
    double *value = wcut_io_alloc((size_t)m.count, sizeof *value);
    if (!value) return false;
    for (int j = 0; j < m.count; j++) value[j] = of(&m.row[j]);
    qsort(value, (size_t)m.count, sizeof *value, compare);
    *median = (value[(m.count - 1) / 2] + value[m.count / 2]) / 2;
    free(value);
    return true;
}

static void put_number(wcut_text *text, const char *before, double value) {
    wcut_text_print(text, "%s", before);
    wcut_text_number(text, value);
}

/* {"min": .., "max": ..} over both mounts */
static void put_both(wcut_text *text, const char *before, moves m, figure *of_a, figure *of_b) {
    double low_a = least_of(m, of_a), low_b = least_of(m, of_b);
    double high_a = greatest_of(m, of_a), high_b = greatest_of(m, of_b);
    wcut_text_print(text, "%s", before);
    put_number(text, "{\"min\": ", low_a < low_b ? low_a : low_b);
    put_number(text, ", \"max\": ", high_a > high_b ? high_a : high_b);
    wcut_text_print(text, "}");
}

static void put_counts(wcut_text *text, moves m) {
    int condition[WCUT_BY_TIME + 1] = {0}, phase[WCUT_LEFT + 1] = {0};
    for (int j = 0; j < m.count; j++) {
        if (m.row[j].condition <= WCUT_BY_TIME) condition[m.row[j].condition]++;
        if (m.row[j].phase <= WCUT_LEFT) phase[m.row[j].phase]++;
    }
    wcut_text_print(text, ",\n  \"speed_set_by\": ");
    for (int k = 0; k <= WCUT_BY_TIME; k++)
        wcut_text_print(text, "%s\"%s\": %d", k ? ", " : "{", wcut_condition_text((wcut_condition)k), condition[k]);
    wcut_text_print(text, "},\n  \"phases\": ");
    for (int k = 0; k <= WCUT_LEFT; k++)
        wcut_text_print(text, "%s\"%s\": %d", k ? ", " : "{", wcut_phase_text((wcut_phase)k), phase[k]);
    wcut_text_print(text, "}");
}

static void put_head(wcut_text *text, const wcut_setup *setup, const wcut_history *h) {
    const wcut_job *job = wcut_setup_job(setup);
    bool implicit = wcut_setup_options(setup)->integrator == WCUT_IMPLICIT;
    wcut_text_print(text, "{\n  \"format\": \"wirecut-summary/1\",\n  \"version\": \"%s\",\n  \"job\": ", WCUT_VERSION);
    wcut_text_string(text, job->name);
    wcut_text_print(text, ",\n  \"mode\": \"%s\",\n  \"integrator\": \"%s\"",
                    job->mode == WCUT_MODE_PATH ? "path" : "design", implicit ? "implicit" : "heun");
    wcut_text_print(text, ",\n  \"stations\": %d,\n  \"planned_stations\": %d,\n  \"complete\": %s,\n  \"nodes\": %d",
                    h->stations, h->planned, h->stations == h->planned ? "true" : "false", h->nodes);
    put_number(text, ",\n  \"duration_s\": ", h->row[h->stations - 1].time);
}

static void put_figures(wcut_text *text, const wcut_history *h, moves m, double median_speed) {
    size_t values = (size_t)h->stations * (size_t)h->nodes;
    double greatest = h->force_line[0];
    for (size_t i = 1; i < values; i++) greatest = h->force_line[i] > greatest ? h->force_line[i] : greatest;
    put_number(text, ",\n  \"speed_mm_s\": {\"min\": ", least_of(m, speed_of));
    put_number(text, ", \"median\": ", median_speed);
    put_number(text, ", \"max\": ", greatest_of(m, speed_of));
    wcut_text_print(text, "}");
    put_both(text, ",\n  \"alpha_deg\": ", m, alpha_a_of, alpha_b_of);
    put_both(text, ",\n  \"beta_deg\": ", m, beta_a_of, beta_b_of);
    put_both(text, ",\n  \"tension_N\": ", m, tension_a_of, tension_b_of);
    put_number(text, ",\n  \"force_N_per_mm\": {\"max\": ", greatest);
    put_number(text, "},\n  \"residual\": {\"max\": ", greatest_of(m, residual_of));
    put_number(text, "},\n  \"iterations\": {\"mean\": ", mean_of(m, iterations_of));
    put_number(text, ", \"max\": ", greatest_of(m, iterations_of));
    put_number(text, "},\n  \"substeps\": {\"mean\": ", mean_of(m, substeps_of));
    put_number(text, ", \"max\": ", greatest_of(m, substeps_of));
    wcut_text_print(text, "}");
    put_counts(text, m);
}

static void put_files(wcut_text *text, int count, const char *const *files) {
    wcut_text_print(text, ",\n  \"files\": [");
    for (int i = 0; i < count; i++) {
        wcut_text_print(text, "%s", i ? ", " : "");
        wcut_text_string(text, files[i]);
    }
    wcut_text_print(text, "]\n}\n");
}

static bool are_usable(const wcut_setup *setup, const wcut_history *h, int count, const char *const *files) {
    if (!setup || !wcut_history_is_usable(h) || !h->force_line || count < 0 || (count > 0 && !files)) return false;
    for (int i = 0; i < count; i++)
        if (!files[i]) return false;
    for (size_t i = 0; i < (size_t)h->stations * (size_t)h->nodes; i++)
        if (!isfinite(h->force_line[i])) return false;
    return true;
}

static wcut_status print_summary(const wcut_setup *setup, const wcut_history *h, int file_count,
                                 const char *const *files, char **text, size_t *length) {
    if (!are_usable(setup, h, file_count, files)) return WCUT_BAD_ARGUMENT;
    int first = h->stations > 1; /* nothing moved to station 0 */
    moves m = {h->row + first, h->stations - first};
    wcut_text out;
    double median;
    if (!find_median(m, speed_of, &median) || !wcut_text_create(&out, NULL)) return WCUT_NO_MEMORY;
    put_head(&out, setup, h);
    put_figures(&out, h, m, median);
    put_files(&out, file_count, files);
    wcut_text_put(&out, "", 1);
    if (out.failed) {
        wcut_text_destroy(&out);
        return WCUT_NO_MEMORY;
    }
    *text = out.data;
    *length = out.count - 1;
    return WCUT_OK;
}

wcut_status wcut_summary_print(const wcut_setup *setup, const wcut_history *history, int file_count,
                               const char *const *files, char **text) {
    size_t length;
    return text ? print_summary(setup, history, file_count, files, text, &length) : WCUT_BAD_ARGUMENT;
}

wcut_status wcut_summary_write(const wcut_setup *setup, const wcut_history *history, int file_count,
                               const char *const *files, const char *path, wcut_error *error) {
    char *text = NULL;
    size_t length = 0;
    wcut_status status = path ? print_summary(setup, history, file_count, files, &text, &length) : WCUT_BAD_ARGUMENT;
    if (status != WCUT_OK) return wcut_io_fail(error, status, "a summary: %s", wcut_status_text(status));
    status = wcut_file_write_whole(path, text, length, error);
    free(text);
    return status;
}
