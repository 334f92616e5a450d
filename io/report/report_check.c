/* The limits of a report, checked before a byte is written. */
#include <limits.h>
#include <math.h>

#include "base/fail.h"
#include "io/report/report_page.h"

enum { SERIES = 8, SHAPES = 8, FIELDS = 12, CELLS = 1000000, CASES = 20000, CASE_COLUMNS = 400 };

static wcut_status bad(wcut_error *error, const char *kind, const char *title, const char *what) {
    char quoted[WCUT_QUOTE_SIZE];
    wcut_quote(quoted, title ? title : "", WCUT_FOUND_MAX, 0);
    return wcut_fail(error, WCUT_BAD_ARGUMENT, "report: %s \"%s\": %s", kind, quoted, what);
}

/* single precision and colours end somewhere; NaN passes as "not there" */
static bool is_shown(double value) { return !(fabs(value) > 1e30); }

static bool all_shown(int count, const double *value) {
    for (int i = 0; value && i < count; i++)
        if (!is_shown(value[i])) return false;
    return true;
}

static bool is_place(wcut_vec3 p) { return fabs(p.x) <= 1e30 && fabs(p.y) <= 1e30 && fabs(p.z) <= 1e30; }

static bool all_places(int count, const wcut_vec3 *point) {
    for (int i = 0; i < count; i++)
        if (!is_place(point[i])) return false;
    return true;
}

static bool is_list(int count, const void *entry) { return count == 0 || (count > 0 && entry); }

static wcut_status check_facts(int count, const wcut_report_fact *fact, wcut_error *error) {
    if (!is_list(count, fact)) return bad(error, "facts", "", "a count without entries");
    for (int i = 0; i < count; i++) {
        if (!fact[i].label) return bad(error, "fact", "", "no label");
        if (!fact[i].text && !is_shown(fact[i].value)) return bad(error, "fact", fact[i].label, "a number beyond 1e30");
    }
    return WCUT_OK;
}

static wcut_status check_chart(const wcut_report_chart *chart, wcut_error *error) {
    /* every chart has a title and two axes */
    if (!chart->title || !chart->x_label[0] || !chart->y_label) return bad(error, "chart", chart->title, "no label");

    /* the lists themselves */
    if (!is_list(chart->series_count, chart->series) || !is_list(chart->span_count, chart->span))
        return bad(error, "chart", chart->title, "a count without entries");
    if (chart->series_count < 1 || chart->series_count > SERIES)
        return bad(error, "chart", chart->title, "expected 1 to 8 series");

    /* each series: data, drawable numbers, a line's x that does not decrease */
    for (int s = 0; s < chart->series_count; s++) {
        const wcut_report_series *a = &chart->series[s];
        if (!a->label) return bad(error, "chart", chart->title, "a series without a label");
        if ((unsigned)a->mark > WCUT_REPORT_MARK_POINTS) return bad(error, "series", a->label, "no such mark");
        if (a->count < 1 || !a->x[0] || !a->y) return bad(error, "series", a->label, "no data");
        if (!a->low != !a->high) return bad(error, "series", a->label, "a band needs both low and high");
        if (!all_shown(a->count, a->x[0]) || !all_shown(a->count, a->x[1]) || !all_shown(a->count, a->y) ||
            !all_shown(a->count, a->low) || !all_shown(a->count, a->high))
            return bad(error, "series", a->label, "a number beyond 1e30");
        for (int k = 0; k < 2 && a->mark != WCUT_REPORT_MARK_POINTS; k++)
            for (int i = 0; a->x[k] && i < a->count; i++)
                if (isnan(a->x[k][i]) || (i > 0 && a->x[k][i] < a->x[k][i - 1]))
                    return bad(error, "series", a->label, "x decreases or is not there");
    }

    /* the named intervals */
    for (int s = 0; s < chart->span_count; s++) {
        const wcut_report_span *a = &chart->span[s];
        if (!a->label || !isfinite(a->from[0]) || !isfinite(a->to[0]) || !isfinite(a->from[1]) || !isfinite(a->to[1]))
            return bad(error, "chart", chart->title, "a span without label or ends");
    }

    return WCUT_OK;
}

static wcut_status check_map(const wcut_report_map *map, wcut_error *error) {
    /* labels, and a size that the page can draw */
    if (!map->title || !map->x_label || !map->y_label || !map->label) return bad(error, "map", map->title, "no label");
    if (map->rows < 2 || map->columns < 2 || map->rows > CELLS / map->columns || !map->x || !map->y || !map->value)
        return bad(error, "map", map->title, "expected 2 x 2 to 1,000,000 cells");

    /* centres of cells in their order */
    for (int i = 0; i < map->columns; i++)
        if (!isfinite(map->x[i]) || (i > 0 && !(map->x[i] > map->x[i - 1])))
            return bad(error, "map", map->title, "x does not increase");
    for (int i = 0; i < map->rows; i++)
        if (!isfinite(map->y[i]) || (i > 0 && !(map->y[i] > map->y[i - 1])))
            return bad(error, "map", map->title, "y does not increase");

    /* what fills the cells */
    if (!all_shown(map->rows * map->columns, map->value) || !isfinite(map->limit) || map->limit < 0)
        return bad(error, "map", map->title, "a number beyond 1e30");

    /* the bands that rows come in */
    if (!is_list(map->bands, map->band) || !is_list(map->bands, map->band_label))
        return bad(error, "map", map->title, "bands without rows or labels");
    for (int i = 0; i < map->bands; i++)
        if (!map->band_label[i] || map->band[i] >= map->rows ||
            (i ? map->band[i] <= map->band[i - 1] : map->band[0] != 0))
            return bad(error, "map", map->title, "bands whose rows do not increase from 0");

    return WCUT_OK;
}

static wcut_status check_table(const wcut_report_table *table, wcut_error *error) {
    if (!table->title) return bad(error, "table", "", "no title");
    if (table->rows < 0 || table->columns < 1 || !table->column) return bad(error, "table", table->title, "no columns");
    for (int c = 0; c < table->columns; c++) {
        const wcut_report_column *column = &table->column[c];
        if (!column->label) return bad(error, "table", table->title, "a column without a label");
        if (!column->number == !column->text)
            return bad(error, "table", table->title, "a column needs either numbers or texts");
        if (!all_shown(table->rows, column->number)) return bad(error, "table", table->title, "a number beyond 1e30");
    }
    return WCUT_OK;
}

static wcut_status check_cases(const wcut_report_cases *cases, wcut_error *error) {
    if (cases->rows < 1 || cases->rows > CASES || cases->columns < 2 || cases->columns > CASE_COLUMNS)
        return bad(error, "cases", "", "expected 1 to 20,000 rows of 2 to 400 columns");
    if (!cases->column || !cases->number || !cases->link || !is_list(cases->best_count, cases->best))
        return bad(error, "cases", "", "columns, numbers, links or best cases are not there");
    if (cases->parameters < 0 || cases->parameters > cases->columns || cases->goal < -1 ||
        cases->goal >= cases->columns)
        return bad(error, "cases", "", "parameters or goal that are no columns");

    /* columns as in a table; the best are rows */
    const wcut_report_table table = {
        .title = "cases", .rows = cases->rows, .columns = cases->columns, .column = cases->column};
    for (int i = 0; i < cases->best_count; i++)
        if (cases->best[i] < 0 || cases->best[i] >= cases->rows)
            return bad(error, "cases", "", "a best case that is no row");
    return check_table(&table, error);
}

static wcut_status check_shape(const wcut_report_shape *shape, wcut_error *error) {
    if (!shape->name) return bad(error, "shape", "", "no name");

    /* the vertices */
    if (shape->vertex_count < 1 || !shape->vertex || !all_places(shape->vertex_count, shape->vertex))
        return bad(error, "shape", shape->name, "expected finite vertices");

    /* a grid holds every vertex, and the page triangulates it */
    if ((shape->rows || shape->columns) &&
        (shape->rows < 2 || shape->columns < 2 || shape->vertex_count % shape->rows ||
         shape->vertex_count / shape->rows != shape->columns || !shape->row_label || !shape->column_label))
        return bad(error, "shape", shape->name, "rows x columns are not the vertices, or have no labels");

    /* triangles name vertices that are there */
    if (!is_list(shape->triangle_count, shape->triangle) || shape->triangle_count > INT_MAX / 3 ||
        (shape->rows && shape->triangle_count))
        return bad(error, "shape", shape->name, "triangles: none for a grid, at most 715827882");
    for (long long i = 0; i < shape->triangle_count * 3LL; i++)
        if (shape->triangle[i] < 0 || shape->triangle[i] >= shape->vertex_count)
            return bad(error, "shape", shape->name, "a triangle names a vertex that is not there");

    /* a value at each vertex for each field */
    if (!is_list(shape->field_count, shape->field) || shape->field_count < 1 || shape->field_count > FIELDS)
        return bad(error, "shape", shape->name, "expected 1 to 12 fields");
    for (int f = 0; f < shape->field_count; f++) {
        const wcut_report_field *field = &shape->field[f];
        if (!field->label || !field->value) return bad(error, "shape", shape->name, "a field without label or values");
        if (!all_shown(shape->vertex_count, field->value))
            return bad(error, "field", field->label, "a number beyond 1e30");
        if (!isfinite(field->tolerance) || field->tolerance < 0)
            return bad(error, "field", field->label, "a tolerance that is not a length");
    }

    return WCUT_OK;
}

static wcut_status check_scene(const wcut_report_scene *scene, wcut_error *error) {
    if (!scene->title) return bad(error, "scene", "", "no title");
    const wcut_vec3 block = scene->block_size;
    if (!is_place(block) || block.x < 0 || block.y < 0 || block.z < 0)
        return bad(error, "scene", scene->title, "the block has no size");
    if (scene->shape_count < 1 || scene->shape_count > SHAPES || !scene->shape ||
        !is_list(scene->line_count, scene->line))
        return bad(error, "scene", scene->title, "expected 1 to 8 shapes");
    wcut_status status = WCUT_OK;
    for (int s = 0; !status && s < scene->shape_count; s++) status = check_shape(&scene->shape[s], error);
    for (int l = 0; !status && l < scene->line_count; l++) {
        const wcut_report_line *line = &scene->line[l];
        if (!line->group || line->count < 1 || !line->point || !all_places(line->count, line->point))
            status = bad(error, "scene", scene->title, "a line without group or finite points");
    }
    return status;
}

static wcut_status check_section(const wcut_report_section *section, wcut_error *error) {
    if (!section->title) return bad(error, "section", "", "no title");
    if (!is_list(section->chart_count, section->chart) || !is_list(section->map_count, section->map) ||
        !is_list(section->table_count, section->table))
        return bad(error, "section", section->title, "a count without entries");
    wcut_status status = WCUT_OK;
    for (int i = 0; !status && i < section->chart_count; i++) status = check_chart(&section->chart[i], error);
    for (int i = 0; !status && i < section->map_count; i++) status = check_map(&section->map[i], error);
    for (int i = 0; !status && i < section->table_count; i++) status = check_table(&section->table[i], error);
    if (!status && section->cases) status = check_cases(section->cases, error);
    return status;
}

wcut_status wcut_report_check(const wcut_report *report, wcut_error *error) {
    if (!report) return wcut_fail(error, WCUT_BAD_ARGUMENT, "report: none given");
    if (!report->verb || !report->title || !report->verdict)
        return bad(error, "page", report->title, "verb, title and verdict are needed");
    if ((unsigned)report->tone > WCUT_REPORT_TONE_BAD) return bad(error, "page", report->title, "no such tone");
    if (!is_list(report->section_count, report->section) || !is_list(report->source_count, report->source))
        return bad(error, "page", report->title, "a count without entries");
    wcut_status status = check_facts(report->fact_count, report->fact, error);
    if (!status) status = check_facts(report->option_count, report->option, error);
    if (!status && report->scene) status = check_scene(report->scene, error);
    for (int i = 0; !status && i < report->section_count; i++) status = check_section(&report->section[i], error);
    for (int i = 0; !status && i < report->source_count; i++)
        if (!report->source[i].role || !report->source[i].name)
            status = bad(error, "page", report->title, "a source without role or name");
    return status;
}
