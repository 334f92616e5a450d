/* The instruments and the rig on a diagnosis's page: what contradicts itself, and what differs from cut to cut. */
#include "io/report/report_instruments.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const char **text_column(wcut_page_memory *memory, wcut_report_column *column, const char *label, int rows) {
    const char **text = wcut_page_take(memory, (size_t)rows, sizeof *text);
    *column = (wcut_report_column){.label = label, .text = text};
    return text;
}

/* ---- contradictions ---- */

/* "0.3 +- 0.02 N" */
static const char *figure_words(wcut_page_memory *memory, const wcut_contradiction *c) {
    const bool share = strcmp(c->unit, "share") == 0;
    const double unit = share ? 100 : 1;
    const char *name = share ? "%" : c->unit;
    if (!(c->error > 0)) return wcut_page_text(memory, "%.4g %s", unit * c->found, name);
    return wcut_page_text(memory, "%.4g +- %.2g %s", unit * c->found, 1.96 * unit * c->error, name);
}

/* "1, 2, 4" */
static const char *cut_words(wcut_page_memory *memory, const wcut_contradiction *c) {
    char list[200] = "";
    int at = 0;
    for (int k = 0; k < c->cuts && at < (int)sizeof list - 12; k++)
        at += snprintf(list + at, sizeof list - (size_t)at, "%s%d", k ? ", " : "", c->cut[k] + 1);
    return wcut_page_text(memory, "%s", list);
}

static wcut_report_table contradiction_table(wcut_page_memory *memory, const wcut_diagnosis *d) {
    enum { COLUMNS = 6 };
    const int rows = d->contradictions;
    wcut_report_column *c = wcut_page_take(memory, COLUMNS, sizeof *c);
    wcut_report_table table = {.title = "Contradictions in the recordings", .columns = COLUMNS, .column = c};
    table.note =
        "Comparison of the columns with each other and with the job, before effects are fitted. Percentages are of the "
        "programme that is recorded, of the set power, of the true way.";
    if (!c) return table;

    /* what is wrong, where, how much, and what was done about it */
    const char **column = text_column(memory, &c[0], "column", rows), **what = text_column(memory, &c[1], "what", rows),
               **cuts = text_column(memory, &c[2], "cuts", rows), **found = text_column(memory, &c[3], "found", rows),
               **done = text_column(memory, &c[4], "corrected", rows),
               **say = text_column(memory, &c[5], "words", rows);
    if (memory->failed) return table;
    for (int r = 0; r < rows; r++) {
        const wcut_contradiction *x = &d->contradiction[r];
        column[r] = x->column, what[r] = wcut_contradiction_name(x->kind), cuts[r] = cut_words(memory, x);
        found[r] = figure_words(memory, x), done[r] = x->repaired ? "yes" : "no", say[r] = x->text;
    }
    table.rows = rows;
    return table;
}

/* ---- scatter ---- */

/* names of files in words, with the unit of the column and its factor */
static const struct {
    const char *name, *words, *unit;
    double factor;
} scatter_words[] = {
    {"block_level", "force level of the blocks", "%", 100},
    {"block_heat_response", "response of the blocks to heat (b)", "%", 100},
    {"wire_length_mm", "length of the wires", "mm", 1},
    {"tension_zero_N", "zeros of the tension sensors", "N", 1},
    {"encoder_zero_deg", "zeros of the encoders", "deg", 1},
    {"encoder_friction_deg", "play of the joints, half width", "deg", 1},
    {"scan_path_error_mm", "scanned faces off their path", "mm", 1},
    {"scan_shift_mm", "scans shifted", "mm", 1},
    {"scan_turn_deg", "scans turned", "deg", 1},
    {"tension_delay_s", "delay of the tension readings (one value)", "s", 1},
    {"angle_delay_s", "delay of the angle readings (one value)", "s", 1},
    {"path_error_mm", "mounts off their path, smooth", "mm", 1},
};

/* "1: -3.0, 2: +5.1" in the row's unit */
static const char *of_cut_words(wcut_page_memory *memory, const wcut_rig_row *row, double factor) {
    char list[400] = "";
    int at = 0;
    for (int k = 0; k < row->cuts && at < (int)sizeof list - 24; k++)
        at += snprintf(list + at, sizeof list - (size_t)at, "%s%d: %+.2g", k ? ", " : "", row->cut[k] + 1,
                       factor * row->of_cut[k].value);
    return at > 0 ? wcut_page_text(memory, "%s", list) : NULL;
}

static wcut_report_table scatter_table(wcut_page_memory *memory, const wcut_diagnosis *d) {
    enum { COLUMNS = 5 };
    const int rows = d->rig_rows;
    wcut_report_column *c = wcut_page_take(memory, COLUMNS, sizeof *c);
    wcut_report_table table = {.title = "What differs from cut to cut", .columns = COLUMNS, .column = c};
    table.note =
        "Scatter of the rig: standard deviations from cut to cut, estimated from these cuts. It is not an effect "
        "and is not corrected.";
    if (!c) return table;

    /* name, value, interval and the values of single cuts */
    const char **what = text_column(memory, &c[0], "of", rows), **value = text_column(memory, &c[1], "value", rows),
               **low = text_column(memory, &c[2], "95 % from", rows), **high = text_column(memory, &c[3], "to", rows),
               **cuts = text_column(memory, &c[4], "cut by cut", rows);
    if (memory->failed) return table;

    /* a row without words of its own keeps its name in files */
    for (int r = 0; r < rows; r++) {
        const wcut_rig_row *x = &d->rig[r];
        double factor = 1;
        const char *unit = "";
        what[r] = x->name;
        for (size_t k = 0; k < sizeof scatter_words / sizeof *scatter_words; k++) {
            if (strcmp(scatter_words[k].name, x->name) != 0) continue;
            what[r] = scatter_words[k].words, unit = scatter_words[k].unit, factor = scatter_words[k].factor;
        }
        value[r] = wcut_page_text(memory, "%.2g %s", factor * x->value.value, unit);
        low[r] = isfinite(x->value.low) ? wcut_page_text(memory, "%.2g", factor * x->value.low) : NULL;
        high[r] = isfinite(x->value.high) ? wcut_page_text(memory, "%.2g", factor * x->value.high) : NULL;
        cuts[r] = of_cut_words(memory, x, factor);
    }
    table.rows = rows;
    return table;
}

bool wcut_report_instruments_fill(wcut_page_memory *memory, const wcut_report_diagnose *of,
                                  wcut_report_section *section) {
    const wcut_diagnosis *d = of->diagnosis;
    wcut_report_table *table = wcut_page_take(memory, 2, sizeof *table);
    int count = 0;
    if (!table) return false;
    if (d->contradictions > 0) table[count++] = contradiction_table(memory, d);
    if (d->rig_rows > 0) table[count++] = scatter_table(memory, d);
    *section = (wcut_report_section){.title = "Instruments and rig", .table_count = count, .table = table};
    return !memory->failed && count > 0;
}
