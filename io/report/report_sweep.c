/* The page of a sweep: its cases as parallel coordinates and scatter, the best ones with what they cut. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <wirecut/read.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/page_memory.h"
#include "io/study/sweep_table.h"

enum {
    CASES_SHOWN = 10000, /* beyond them every k-th case, and the best */
    PICTURES = 6,        /* of the best cases */
    PICTURE_TRIANGLES = 60000
};

/* everything that the page borrows */
typedef struct page {
    const wcut_sweep *sweep;
    wcut_sweep_table table;
    wcut_page_memory memory;
    int rows, *row; /* the cases that are shown */
    int shapes;
    wcut_mesh *mesh[PICTURES];
    wcut_report_shape shape[PICTURES];
    wcut_report_field field[PICTURES];
} page;

/* ---- which cases ---- */

static bool is_best(const page *p, int k) {
    for (int i = 0; i < p->table.best_count; i++)
        if (p->table.best[i] == k) return true;
    return false;
}

static void choose_rows(page *p) {
    const int stride = (p->table.cases - 1) / CASES_SHOWN + 1;
    p->row = wcut_page_take(&p->memory, (size_t)p->table.cases, sizeof *p->row);
    for (int k = 0; k < p->table.cases && p->row; k++)
        if (k % stride == 0 || is_best(p, k)) p->row[p->rows++] = k;
}

static int sweep_row_of(const page *p, int k) {
    for (int r = 0; r < p->rows; r++)
        if (p->row[r] == k) return r;
    return 0;
}

/* "cases/HH/HASH/NAME", or NULL where it is not there */
static const char *link_of(page *p, int k, const char *name) {
    const char *hash = p->table.hash[k];
    const char *link = wcut_page_text(&p->memory, "cases/%.2s/%s/%s", hash, hash, name);
    const char *path = link ? wcut_page_text(&p->memory, "%s/%s", wcut_sweep_root(p->sweep), link) : NULL;
    return path && access(path, R_OK) == 0 ? link : NULL;
}

/* ---- columns ---- */

static bool has_number(const page *p, int column) {
    const double *value = p->table.number + (size_t)column * (size_t)p->table.cases;
    for (int k = 0; k < p->table.cases; k++)
        if (isfinite(value[k]) && fabs(value[k]) <= 1e30) return true;
    return false;
}

/* a column of numbers, or of words where it has no number; the last one is the status */
static void fill_column(page *p, int c, wcut_report_column *column) {
    const wcut_study_info *study = wcut_study_view(wcut_sweep_view(p->sweep));
    const int figure = c - study->parameters;
    column->label = figure < 0 ? study->parameter[c] : study->figure[figure];

    /* numbers; a page holds them up to 1e30 */
    if (has_number(p, c)) {
        double *number = wcut_page_take(&p->memory, (size_t)p->rows, sizeof *number);
        for (int r = 0; r < p->rows && number; r++) {
            const double value = p->table.number[(size_t)c * (size_t)p->table.cases + (size_t)p->row[r]];
            number[r] = fabs(value) <= 1e30 ? value : NAN;
        }
        column->number = number;
        return;
    }

    /* texts of the cases that are shown */
    const char **text = wcut_page_take(&p->memory, (size_t)p->rows, sizeof *text);
    for (int r = 0; r < p->rows && text; r++)
        text[r] = p->table.text[c] ? json_string_value(p->table.text[c][p->row[r]]) : NULL;
    column->text = text;
}

static void fill_cases(page *p, wcut_report_cases *cases) {
    const wcut_study_info *study = wcut_study_view(wcut_sweep_view(p->sweep));
    const int columns = p->table.columns + 1;
    wcut_report_column *column = wcut_page_take(&p->memory, (size_t)columns, sizeof *column);
    const char **status = wcut_page_take(&p->memory, (size_t)p->rows, sizeof *status);
    const char **link = wcut_page_take(&p->memory, (size_t)p->rows, sizeof *link);
    int *best = wcut_page_take(&p->memory, (size_t)p->table.best_count + 1, sizeof *best);
    if (p->memory.failed) return;

    /* parameters, figures, status */
    for (int c = 0; c < p->table.columns && !p->memory.failed; c++) fill_column(p, c, &column[c]);
    for (int r = 0; r < p->rows; r++) {
        status[r] = wcut_sweep_state_name((wcut_sweep_state)p->table.state[p->row[r]]);
        link[r] = link_of(p, p->row[r], "report.html");
    }
    column[columns - 1] = (wcut_report_column){.label = "status", .text = status};
    for (int i = 0; i < p->table.best_count; i++) best[i] = sweep_row_of(p, p->table.best[i]);

    /* goal: the column by which the best cases are chosen */
    *cases = (wcut_report_cases){.rows = p->rows,
                                 .columns = columns,
                                 .parameters = study->parameters,
                                 .column = column,
                                 .number = p->row,
                                 .link = link,
                                 .goal = study->best < 0 ? -1 : study->parameters + study->best,
                                 .highest = study->best_is_highest,
                                 .best_count = p->table.best_count,
                                 .best = best};
}

/* ---- pictures ---- */

/* the mesh among the results of a case, by the names that verbs give it; NULL: none */
static wcut_mesh *read_picture(page *p, int k) {
    static const char *const name[] = {"surface.ply", "surface.stl", "surface.obj",  "lower.ply",
                                       "lower.stl",   "lower.obj",   "deviation.ply"};
    wcut_mesh_read_options options = wcut_mesh_read_options_default();
    options.max_triangles = PICTURE_TRIANGLES;
    wcut_mesh *mesh = NULL;
    for (size_t i = 0; i < sizeof name / sizeof *name && !mesh; i++) {
        const char *link = link_of(p, k, name[i]);
        const char *path = link ? wcut_page_text(&p->memory, "%s/%s", wcut_sweep_root(p->sweep), link) : NULL;
        if (path && wcut_mesh_read(path, &options, &mesh, NULL, NULL) != WCUT_OK) mesh = NULL;
    }
    return mesh;
}

/* what the best cases cut, coloured by height */
static void fill_sweep_shapes(page *p) {
    for (int i = 0; i < p->table.best_count && i < PICTURES && p->shapes == i && !p->memory.failed; i++) {
        const int k = p->table.best[i];
        wcut_mesh *mesh = p->mesh[i] = read_picture(p, k);
        if (!mesh) return;
        double *height = wcut_page_take(&p->memory, (size_t)mesh->vertex_count, sizeof *height);
        for (int v = 0; v < mesh->vertex_count && height; v++) height[v] = mesh->vertex[v].z;
        p->field[i] = (wcut_report_field){.label = "height", .unit = "mm", .value = height};
        p->shape[i] = (wcut_report_shape){.name = wcut_page_text(&p->memory, "case %d", k),
                                          .vertex_count = mesh->vertex_count,
                                          .vertex = mesh->vertex,
                                          .triangle_count = mesh->triangle_count,
                                          .triangle = mesh->triangle,
                                          .field_count = 1,
                                          .field = &p->field[i]};
        p->shapes++;
    }
}

/* ---- the page ---- */

static wcut_status write_sweep_page(page *p, const wcut_report_cases *cases, const char *path, wcut_error *error) {
    const wcut_study_info *study = wcut_study_view(wcut_sweep_view(p->sweep));
    char verdict[WCUT_REPORT_SENTENCE], title[256];
    int count[WCUT_SWEEP_STATE_COUNT] = {0}, facts = 0;
    wcut_report_fact fact[WCUT_SWEEP_STATE_COUNT + 2];

    /* the answer: how many came to their end, and which is the best */
    for (int k = 0; k < p->table.cases; k++) count[p->table.state[k]]++;
    fact[facts++] = (wcut_report_fact){"cases", NULL, p->table.cases, ""};
    for (int s = 0; s < WCUT_SWEEP_STATE_COUNT; s++)
        if (count[s] > 0)
            fact[facts++] = (wcut_report_fact){wcut_sweep_state_name((wcut_sweep_state)s), NULL, count[s], ""};
    const int done = count[WCUT_SWEEP_STATE_DONE];
    snprintf(verdict, sizeof verdict, "%d of %d cases of %.40s are done.", done, p->table.cases, study->verb);

    /* the best case, where the study has a goal */
    if (p->table.best_count > 0) {
        const int k = p->table.best[0];
        const double value = p->table.number[(size_t)cases->goal * (size_t)p->table.cases + (size_t)k];
        snprintf(verdict, sizeof verdict, "%d of %d cases of %.40s are done. The %s %.60s is %.6g, in case %d.", done,
                 p->table.cases, study->verb, study->best_is_highest ? "highest" : "lowest", study->figure[study->best],
                 value, k);
    }
    snprintf(title, sizeof title, "%.250s", study->name);

    /* the cases, and beside them what the best ones cut */
    const char *note =
        p->rows < p->table.cases
            ? wcut_page_text(&p->memory, "%d of %d cases are shown, the best among them.", p->rows, p->table.cases)
            : NULL;
    const wcut_report_section section = {.title = "Cases", .note = note, .cases = cases};
    const wcut_report_scene scene = {.title = "What the best cases cut", .shape_count = p->shapes, .shape = p->shape};
    const wcut_report_fact option[] = {{"verb", study->verb, 0, ""}};

    /* a warning where a case is missing or has failed */
    const wcut_report report = {.verb = "sweep",
                                .title = title,
                                .tone = done < p->table.cases ? WCUT_REPORT_TONE_WARNING : WCUT_REPORT_TONE_GOOD,
                                .verdict = verdict,
                                .fact_count = facts,
                                .fact = fact,
                                .scene = p->shapes > 0 ? &scene : NULL,
                                .section_count = 1,
                                .section = &section,
                                .option_count = sizeof option / sizeof *option,
                                .option = option};
    if (p->memory.failed) return wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY));
    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_sweep_write(const wcut_sweep *sweep, const char *path, wcut_error *error) {
    if (!sweep || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.sweep = sweep};
    wcut_report_cases cases = {0};

    /* the numbers of all cases, of which a selection is shown */
    wcut_status status = wcut_sweep_table_load(sweep, &p.table, error);
    if (status != WCUT_OK) return status;
    choose_rows(&p);
    if (!p.memory.failed) fill_cases(&p, &cases);
    if (!p.memory.failed) fill_sweep_shapes(&p);

    /* the page, if memory sufficed for all of it */
    status = p.memory.failed ? wcut_fail(error, WCUT_NO_MEMORY, "%s", wcut_status_text(WCUT_NO_MEMORY))
                             : write_sweep_page(&p, &cases, path, error);
    for (int i = 0; i < PICTURES; i++) wcut_mesh_destroy(p.mesh[i]);
    wcut_sweep_table_free(&p.table);
    wcut_page_free(&p.memory);
    return status;
}
