/* What a sweep found: a row a case as CSV, and the numbers of all cases for the summary and the page. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/study/pointer.h"
#include "io/study/sweep.h"
#include "io/study/sweep_table.h"

#define FORMAT "wirecut-sweep/1"

enum { BEST_SHOWN = 10 };

static wcut_status fail_table_memory(wcut_error *error) {
    return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
}

/* ---- a case ---- */

/* what is on disk of a case */
typedef struct found_case {
    char hash[WCUT_STUDY_HASH_SIZE];
    wcut_sweep_record record;
    json_t *result; /* NULL: it has none */
} found_case;

static bool find_case(const wcut_sweep *sweep, int k, bool with_result, found_case *found) {
    *found = (found_case){.result = NULL};
    if (wcut_study_hash_eval(sweep->study, k, found->hash) != WCUT_OK) return false;
    char *folder = wcut_sweep_folder(sweep, found->hash);
    if (!folder) return false;
    wcut_sweep_record_read(folder, &found->record);
    if (with_result) found->result = wcut_sweep_result_load(folder, &found->record);
    wcut_free(folder);
    return true;
}

/* a figure is a number, a text, true or false */
static const json_t *sweep_figure(const wcut_study *study, const found_case *found, int f) {
    const json_t *value = found->result ? wcut_pointer_locate(found->result, study->pointer[f]) : NULL;
    return json_is_object(value) || json_is_array(value) || json_is_null(value) ? NULL : value;
}

/* ---- the CSV ---- */

/* the table that is being written */
typedef struct listing {
    const wcut_sweep *sweep;
    int with_result;        /* cases that have one */
    unsigned char *present; /* figures: whether a result has it */
} listing;

static void put_figure(wcut_text *text, const json_t *value) {
    if (json_is_string(value))
        wcut_sweep_put_field(text, json_string_value(value));
    else if (json_is_number(value))
        wcut_text_number(text, json_number_value(value));
    else if (value)
        wcut_text_put_word(text, json_is_true(value) ? "true" : "false");
}

static bool put_row(wcut_text *text, listing *l, int k) {
    const wcut_study *study = l->sweep->study;
    found_case found;
    if (!find_case(l->sweep, k, true, &found)) return false;

    /* which case, and what was set in it */
    wcut_text_print(text, "%d,%s", k, found.hash);
    for (int p = 0; p < study->parameters; p++) {
        wcut_text_put(text, ",", 1);
        wcut_sweep_put_value(text, study, k, p);
    }

    /* what came out, and how it ended */
    for (int f = 0; f < study->figures; f++) {
        const json_t *value = sweep_figure(study, &found, f);
        wcut_text_put(text, ",", 1);
        put_figure(text, value);
        if (value) l->present[f] = 1;
    }

    /* the state of the case ends the row */
    wcut_text_print(text, ",%s\n", wcut_sweep_state_name(found.record.state));
    l->with_result += found.result != NULL;
    json_decref(found.result);
    return true;
}

static bool put_table_rows(wcut_text *text, const void *context) {
    listing *l = *(listing *const *)context;
    const wcut_study *study = l->sweep->study;
    wcut_text_put_word(text, "case,hash");
    for (int p = 0; p < study->parameters; p++) {
        wcut_text_put(text, ",", 1);
        wcut_sweep_put_field(text, study->parameter[p].name);
    }
    for (int f = 0; f < study->figures; f++) {
        wcut_text_put(text, ",", 1);
        wcut_sweep_put_field(text, study->figure[f]);
    }
    wcut_text_put_word(text, ",status\n");
    for (int k = 0; k < study->info.cases && !text->failed; k++)
        if (!put_row(text, l, k)) return false;
    return !text->failed;
}

/* the first figure that no result has; nothing is lost while there is no result */
static int find_lost(const listing *l) {
    for (int f = 0; f < l->sweep->study->figures; f++)
        if (l->with_result > 0 && !l->present[f]) return f;
    return -1;
}

/* the first case that has a result; false: no memory */
static bool find_case_result(const wcut_sweep *sweep, found_case *found) {
    found->result = NULL;
    for (int k = 0; k < sweep->study->info.cases && !found->result; k++)
        if (!find_case(sweep, k, true, found)) return false;
    return true;
}

/* a figure that a result has not, and the nearest that it has */
static wcut_status refuse_figure(const wcut_study *study, const found_case *found, int f, wcut_error *error) {
    char nearest[WCUT_POINTER_SIZE];
    if (!wcut_pointer_nearest(found->result, study->pointer[f], nearest)) nearest[0] = '\0';
    return wcut_fail(error, WCUT_NOT_FOUND,
                     "figure %.60s: found nothing at %.100s of %.40s, expected a number, a text, true or false; the "
                     "nearest is %.100s",
                     study->figure[f], study->pointer[f], found->record.result, nearest);
}

wcut_status wcut_sweep_figures_query(const wcut_sweep *sweep, wcut_error *error) {
    found_case found;
    wcut_status status = WCUT_OK;
    if (!sweep) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    if (!find_case_result(sweep, &found)) return fail_table_memory(error);
    for (int f = 0; f < sweep->study->figures && found.result && status == WCUT_OK; f++)
        if (!sweep_figure(sweep->study, &found, f)) status = refuse_figure(sweep->study, &found, f, error);
    json_decref(found.result);
    return status;
}

/* a figure that no result has */
static wcut_status refuse_lost(const wcut_sweep *sweep, int f, wcut_error *error) {
    found_case found;
    if (!find_case_result(sweep, &found)) return fail_table_memory(error);
    const wcut_status status = refuse_figure(sweep->study, &found, f, error);
    json_decref(found.result);
    return status;
}

wcut_status wcut_sweep_write_csv(const wcut_sweep *sweep, const char *path, wcut_error *error) {
    if (!sweep || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    listing l = {.sweep = sweep, .present = wcut_alloc((size_t)sweep->study->figures, 1)}, *of = &l;
    if (!l.present) return fail_table_memory(error);

    /* the target is replaced only where every figure was found */
    wcut_file *file = NULL;
    wcut_text text = {0};
    wcut_status status = wcut_file_create(path, &file, error);
    if (status == WCUT_OK && !(wcut_text_create(&text, file) && put_table_rows(&text, &of)))
        status = fail_table_memory(error);

    /* a figure that no result has is a fault of the study */
    const int lost = status == WCUT_OK ? find_lost(&l) : -1;
    if (lost >= 0) status = refuse_lost(sweep, lost, error);
    if (status == WCUT_OK) {
        wcut_text_flush(&text);
        status = wcut_file_commit(file, error);
    }
    wcut_text_destroy(&text);
    wcut_file_destroy(file);
    wcut_free(l.present);
    return status;
}

/* ---- the numbers ---- */

static double number_of(const json_t *value) {
    if (json_is_boolean(value)) return json_is_true(value);
    return json_is_number(value) ? json_number_value(value) : NAN;
}

/* a value into its column: a number, or a text */
static bool take_value(wcut_sweep_table *table, int column, int k, const json_t *value, double number) {
    table->number[(size_t)column * (size_t)table->cases + (size_t)k] = value ? number_of(value) : number;
    if (!json_is_string(value)) return true;
    json_t ***texts = &table->text[column];
    if (!*texts) *texts = wcut_alloc((size_t)table->cases, sizeof **texts);
    if (*texts) (*texts)[k] = json_incref((json_t *)value);
    return *texts != NULL;
}

static bool fill_case(const wcut_study *study, int k, const found_case *found, wcut_sweep_table *table) {
    bool whole = true;
    for (int p = 0; p < study->parameters && whole; p++) {
        double number = NAN;
        const json_t *value = wcut_study_value(study, k, p, &number);
        whole = take_value(table, p, k, value, number);
    }
    for (int f = 0; f < study->figures && whole; f++)
        whole = take_value(table, study->parameters + f, k, sweep_figure(study, found, f), NAN);
    table->state[k] = (unsigned char)found->record.state;
    memcpy(table->hash[k], found->hash, sizeof found->hash);
    return whole;
}

/* cases in the order of a figure, those of one value in their own order (insertion into the few that are wanted) */
static void find_best(const wcut_study *study, wcut_sweep_table *table) {
    if (study->info.best < 0) return;
    const double *value = table->number + (size_t)(study->parameters + study->info.best) * (size_t)table->cases;
    for (int k = 0; k < table->cases; k++) {
        if (isnan(value[k]) || table->state[k] != WCUT_SWEEP_STATE_DONE) continue;
        int at = table->best_count;
        for (; at > 0; at--) {
            const double other = value[table->best[at - 1]];
            if (study->highest ? value[k] <= other : value[k] >= other) break;
        }
        if (at >= BEST_SHOWN) continue;
        if (table->best_count < BEST_SHOWN) table->best_count++;
        memmove(table->best + at + 1, table->best + at, (size_t)(table->best_count - 1 - at) * sizeof *table->best);
        table->best[at] = k;
    }
}

wcut_status wcut_sweep_table_load(const wcut_sweep *sweep, wcut_sweep_table *table, wcut_error *error) {
    const wcut_study *study = sweep->study;
    const size_t cases = (size_t)study->info.cases;

    /* columns: parameters, then figures; NaN where a case has no number */
    *table = (wcut_sweep_table){.cases = study->info.cases, .columns = study->parameters + study->figures};
    table->number = wcut_alloc(cases * (size_t)table->columns, sizeof *table->number);
    table->state = wcut_alloc(cases, 1);
    table->hash = wcut_alloc(cases, sizeof *table->hash);
    table->best = wcut_alloc(BEST_SHOWN + 1, sizeof *table->best);
    table->text = wcut_alloc((size_t)table->columns, sizeof *table->text);
    bool whole = table->number && table->state && table->hash && table->best && table->text;

    /* one result is in memory at a time */
    for (int k = 0; k < table->cases && whole; k++) {
        found_case found;
        whole = find_case(sweep, k, true, &found);
        if (whole) whole = fill_case(study, k, &found, table);
        json_decref(found.result);
    }

    /* the best cases are chosen once all are known */
    if (whole) {
        find_best(study, table);
        return WCUT_OK;
    }
    wcut_sweep_table_free(table);
    return fail_table_memory(error);
}

void wcut_sweep_table_free(wcut_sweep_table *table) {
    for (int c = 0; table->text && c < table->columns; c++) {
        for (int k = 0; table->text[c] && k < table->cases; k++) json_decref(table->text[c][k]);
        wcut_free(table->text[c]);
    }
    wcut_free(table->text);
    wcut_free(table->number);
    wcut_free(table->state);
    wcut_free(table->hash);
    wcut_free(table->best);
    *table = (wcut_sweep_table){0};
}

/* ---- the summary ---- */

static int by_number(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* count, lowest, median and highest of a column */
static bool put_range(wcut_text *text, const double *value, int cases) {
    int n = 0;
    double *sorted = wcut_alloc((size_t)cases, sizeof *sorted);
    if (!sorted) return false;

    /* values without NaN, sorted */
    for (int k = 0; k < cases; k++)
        if (!isnan(value[k])) sorted[n++] = value[k];
    qsort(sorted, (size_t)n, sizeof *sorted, by_number);
    wcut_text_print(text, ", \"count\": %d", n);
    wcut_text_put_number(text, ", \"min\": ", n ? sorted[0] : NAN);
    wcut_text_put_number(text, ", \"median\": ", n ? (sorted[(n - 1) / 2] + sorted[n / 2]) / 2 : NAN);
    wcut_text_put_number(text, ", \"max\": ", n ? sorted[n - 1] : NAN);
    wcut_free(sorted);
    return true;
}

static bool put_columns(wcut_text *text, const wcut_study *study, const wcut_sweep_table *table) {
    bool whole = true;

    /* a range for each parameter */
    wcut_text_put_word(text, ",\n  \"parameters\": [");
    for (int p = 0; p < study->parameters && whole; p++) {
        wcut_text_put_string(text, p ? ",\n    {\"name\": " : "\n    {\"name\": ", study->parameter[p].name);
        whole = put_range(text, table->number + (size_t)p * (size_t)table->cases, table->cases);
        wcut_text_put(text, "}", 1);
    }

    /* a range for each figure, and where it is found in the result */
    wcut_text_put_word(text, "\n  ],\n  \"figures\": [");
    for (int f = 0; f < study->figures && whole; f++) {
        wcut_text_put_string(text, f ? ",\n    {\"name\": " : "\n    {\"name\": ", study->figure[f]);
        wcut_text_put_string(text, ", \"pointer\": ", study->pointer[f]);
        whole = put_range(text, table->number + (size_t)(study->parameters + f) * (size_t)table->cases, table->cases);
        wcut_text_put(text, "}", 1);
    }
    wcut_text_put_word(text, "\n  ]");
    return whole;
}

static void put_best(wcut_text *text, const wcut_study *study, const wcut_sweep_table *table) {
    if (study->info.best < 0) return;
    const double *value = table->number + (size_t)(study->parameters + study->info.best) * (size_t)table->cases;
    wcut_text_put_string(text, ",\n  \"best\": {\"figure\": ", study->best);
    wcut_text_put_string(text, ", \"goal\": ", study->highest ? "highest" : "lowest");
    wcut_text_put_word(text, ", \"cases\": [");
    for (int i = 0; i < table->best_count; i++) {
        const int k = table->best[i];
        wcut_text_print(text, "%s\n    {\"case\": %d", i ? "," : "", k);
        wcut_text_put_string(text, ", \"hash\": ", table->hash[k]);
        wcut_text_put_number(text, ", \"value\": ", value[k]);
        wcut_text_put(text, "}", 1);
    }
    wcut_text_put_word(text, table->best_count ? "\n  ]}" : "]}");
}

wcut_status wcut_sweep_print(const wcut_sweep *sweep, char **text, wcut_error *error) {
    if (!sweep || !text) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_sweep_table table;

    /* all values of all cases */
    wcut_text out = {0};
    int count[WCUT_SWEEP_STATE_COUNT] = {0};
    wcut_status status = wcut_sweep_table_load(sweep, &table, error);
    if (status != WCUT_OK) return status;
    bool whole = wcut_text_create(&out, NULL);
    if (whole) {
        /* what ran, and how it ended */
        for (int k = 0; k < table.cases; k++) count[table.state[k]]++;
        wcut_text_put_string(&out, "{\n  \"format\": ", FORMAT);
        wcut_text_put_string(&out, ",\n  \"version\": ", wcut_version_text());
        wcut_text_put_string(&out, ",\n  \"name\": ", sweep->study->name);
        wcut_text_put_string(&out, ",\n  \"verb\": ", sweep->study->verb);
        wcut_text_print(&out, ",\n  \"cases\": %d,\n  \"states\": {", table.cases);
        for (int s = 0; s < WCUT_SWEEP_STATE_COUNT; s++)
            wcut_text_print(&out, "%s\"%s\": %d", s ? ", " : "", wcut_sweep_state_name((wcut_sweep_state)s), count[s]);
        wcut_text_put_word(&out, "}");

        /* ranges of parameters and figures, and the best cases */
        whole = put_columns(&out, sweep->study, &table);
        put_best(&out, sweep->study, &table);
        wcut_text_put_word(&out, "\n}\n");
    }

    /* the caller gets the whole text or none */
    wcut_sweep_table_free(&table);
    if (!whole) wcut_text_destroy(&out);
    return whole && wcut_text_finish(&out, text, NULL) == WCUT_OK ? WCUT_OK : fail_table_memory(error);
}

/* ---- how it stands ---- */

wcut_status wcut_sweep_query(const wcut_sweep *sweep, wcut_sweep_counts *counts, wcut_error *error) {
    if (!sweep || !counts) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_sweep_counts made = {.cases = sweep->study->info.cases};
    for (int k = 0; k < made.cases; k++) {
        found_case found;
        if (!find_case(sweep, k, false, &found)) return fail_table_memory(error);
        made.state[found.record.state]++;
        made.seconds += found.record.seconds;
    }
    *counts = made;
    return WCUT_OK;
}
