/* A report as JSON: words and small numbers in the document, big arrays by their number in the pool. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/version.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "io/report/report_page.h"

/* how many bytes the UTF-8 sequence at text has; 0 where it is not one (Unicode 15, table 3-7) */
static int sequence_length(const unsigned char *text) {
    const unsigned char lead = text[0];
    if (lead < 0x80) return 1;
    const int length = lead >= 0xc2 && lead <= 0xdf ? 2 : lead >= 0xe0 && lead <= 0xef ? 3 : 4;
    if (lead < 0xc2 || lead > 0xf4) return 0;
    const unsigned char low = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned char high = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    if (text[1] < low || text[1] > high) return 0;
    for (int i = 2; i < length; i++)
        if (text[i] < 0x80 || text[i] > 0xbf) return 0;
    return length;
}

char *wcut_report_text(const char *text) {
    char *clean = wcut_alloc(3 * strlen(text) + 1, 1), *to = clean;
    if (!clean) return NULL;
    for (const unsigned char *from = (const unsigned char *)text; *from;) {
        const int length = sequence_length(from);
        memcpy(to, length ? (const void *)from : "\xef\xbf\xbd", length ? (size_t)length : 3);
        to += length ? length : 3;
        from += length ? length : 1;
    }
    *to = 0;
    return clean;
}

/* The document that is being made: the first failure is remembered, so that the tree reads without a check a line. */
typedef struct document {
    wcut_report_pool *pool;
    bool failed;
} document;

static void put_member(document *d, json_t *object, const char *key, json_t *value) {
    if (json_object_set_new(object, key, value)) d->failed = true;
}

static json_t *text_or_null(const char *text) {
    if (!text) return json_null();
    char *clean = wcut_report_text(text);
    json_t *value = clean ? json_string(clean) : NULL;
    free(clean);
    return value;
}

static json_t *number_or_null(double value) { return isnan(value) ? json_null() : json_real(value); }

static void put_text(document *d, json_t *object, const char *key, const char *text) {
    put_member(d, object, key, text_or_null(text));
}

static void put_unit(document *d, json_t *object, const char *key, const char *unit) {
    put_text(d, object, key, unit ? unit : "");
}

static void put_int(document *d, json_t *object, const char *key, int value) {
    put_member(d, object, key, json_integer(value));
}

static void put_json_array(document *d, json_t *object, const char *key, int number) {
    if (number < 0) d->failed = true;
    put_int(d, object, key, number);
}

static json_t *put_list(document *d, json_t *object, const char *key) {
    json_t *list = json_array();
    put_member(d, object, key, list);
    return list;
}

static json_t *append_object(document *d, json_t *list) {
    json_t *object = json_object();
    if (json_array_append_new(list, object)) d->failed = true;
    return object;
}

static void put_facts(document *d, json_t *object, const char *key, int count, const wcut_report_fact *fact) {
    json_t *list = put_list(d, object, key);
    for (int i = 0; i < count; i++) {
        json_t *item = append_object(d, list);
        put_text(d, item, "label", fact[i].label);
        if (fact[i].text)
            put_text(d, item, "text", fact[i].text);
        else
            put_member(d, item, "value", number_or_null(fact[i].value));
        put_unit(d, item, "unit", fact[i].unit);
    }
}

static void put_series(document *d, json_t *item, const wcut_report_series *series) {
    /* a long series is thinned: room for the indices that are kept */
    static const char *const mark[] = {"line", "dashed", "points"};
    int max = series->count < WCUT_REPORT_POINTS ? series->count : WCUT_REPORT_POINTS;
    int *index = wcut_alloc((size_t)max, sizeof *index);
    if (!index) {
        d->failed = true;
        return;
    }

    /* no more points than a screen shows */
    const int count = wcut_report_thin(series->count, series->y, max, index);
    const int *chosen = count < series->count ? index : NULL;

    /* name and count, then the arrays */
    put_text(d, item, "label", series->label);
    put_text(d, item, "mark", mark[series->mark]);
    put_int(d, item, "total", series->count);
    put_json_array(d, item, "x", wcut_report_pool_add_doubles(d->pool, count, chosen, series->x[0]));
    if (series->x[1]) put_json_array(d, item, "x2", wcut_report_pool_add_doubles(d->pool, count, chosen, series->x[1]));
    put_json_array(d, item, "y", wcut_report_pool_add_doubles(d->pool, count, chosen, series->y));
    if (series->low) {
        put_json_array(d, item, "low", wcut_report_pool_add_doubles(d->pool, count, chosen, series->low));
        put_json_array(d, item, "high", wcut_report_pool_add_doubles(d->pool, count, chosen, series->high));
    }

    free(index);
}

static void put_chart(document *d, json_t *item, const wcut_report_chart *chart) {
    put_text(d, item, "title", chart->title);
    put_text(d, item, "note", chart->note);

    /* one or two choices of abscissa, one ordinate */
    json_t *axes = put_list(d, item, "axes");
    for (int k = 0; k < 2 && chart->x_label[k]; k++) {
        json_t *axis = append_object(d, axes);
        put_text(d, axis, "label", chart->x_label[k]);
        put_unit(d, axis, "unit", chart->x_unit[k]);
    }

    /* the ordinate */
    put_text(d, item, "label", chart->y_label);
    put_unit(d, item, "unit", chart->y_unit);

    /* the lines, then the spans shaded behind them */
    json_t *series = put_list(d, item, "series");
    for (int s = 0; s < chart->series_count; s++) put_series(d, append_object(d, series), &chart->series[s]);
    json_t *spans = put_list(d, item, "spans");
    for (int s = 0; s < chart->span_count; s++) {
        const wcut_report_span *span = &chart->span[s];
        json_t *to = append_object(d, spans);
        put_text(d, to, "label", span->label);
        put_member(d, to, "from", json_pack("[ff]", span->from[0], span->from[1]));
        put_member(d, to, "to", json_pack("[ff]", span->to[0], span->to[1]));
    }
}

static const char *scale_text(wcut_report_scale scale) {
    return scale == WCUT_REPORT_SCALE_DIVERGING ? "diverging" : "sequential";
}

static void put_map(document *d, json_t *item, const wcut_report_map *map) {
    /* title and axes */
    put_text(d, item, "title", map->title);
    put_text(d, item, "note", map->note);
    put_text(d, item, "x_label", map->x_label);
    put_unit(d, item, "x_unit", map->x_unit);
    put_text(d, item, "y_label", map->y_label);
    put_unit(d, item, "y_unit", map->y_unit);
    put_text(d, item, "label", map->label);
    put_unit(d, item, "unit", map->unit);

    /* the scale of the colours, the arrays */
    put_text(d, item, "scale", scale_text(map->scale));
    put_member(d, item, "limit", json_real(map->limit));
    put_json_array(d, item, "x", wcut_report_pool_add_doubles(d->pool, map->columns, NULL, map->x));
    put_json_array(d, item, "y", wcut_report_pool_add_doubles(d->pool, map->rows, NULL, map->y));
    put_json_array(d, item, "value", wcut_report_pool_add_floats(d->pool, map->rows * map->columns, NULL, map->value));
    put_member(d, item, "blank_missing", json_boolean(map->blank_missing));

    /* bands join the rows of one channel */
    json_t *bands = put_list(d, item, "bands");
    for (int i = 0; i < map->bands; i++) {
        json_t *band = append_object(d, bands);
        put_text(d, band, "label", map->band_label[i]);
        put_member(d, band, "row", json_integer(map->band[i]));
    }
}

static void put_table(document *d, json_t *item, const wcut_report_table *table) {
    put_text(d, item, "title", table->title);
    put_text(d, item, "note", table->note);
    put_int(d, item, "rows", table->rows);
    json_t *columns = put_list(d, item, "columns");
    for (int c = 0; c < table->columns; c++) {
        const wcut_report_column *column = &table->column[c];
        json_t *to = append_object(d, columns);
        put_text(d, to, "label", column->label);
        put_unit(d, to, "unit", column->unit);
        json_t *cells = put_list(d, to, column->number ? "numbers" : "texts");
        for (int r = 0; r < table->rows; r++) {
            json_t *cell = column->number ? number_or_null(column->number[r]) : text_or_null(column->text[r]);
            if (json_array_append_new(cells, cell)) d->failed = true;
        }
    }
}

static void put_json_field(document *d, json_t *item, const wcut_report_shape *shape, const wcut_report_view *view,
                           const wcut_report_field *field) {
    double quantile[WCUT_REPORT_QUANTILES];
    int found = 0;
    if (wcut_report_quantiles(shape->vertex_count, field->value, WCUT_REPORT_QUANTILES, quantile, &found))
        d->failed = true;
    put_text(d, item, "label", field->label);
    put_unit(d, item, "unit", field->unit);
    put_text(d, item, "scale", scale_text(field->scale));
    put_member(d, item, "tolerance", json_real(field->tolerance));
    put_int(d, item, "count", found);
    put_json_array(d, item, "value", wcut_report_pool_add_floats(d->pool, view->count, view->index, field->value));
    /* the pool tells arrays apart by their address, and this one is on the stack: so floats, which are never shared */
    if (found)
        put_json_array(d, item, "quantiles",
                       wcut_report_pool_add_floats(d->pool, WCUT_REPORT_QUANTILES, NULL, quantile));
}

static void put_json_shape(document *d, json_t *item, const wcut_report_shape *shape, int shapes) {
    /* a view thins a large shape to what the page can show */
    wcut_report_view view;
    if (wcut_report_view_create(shape, shapes, &view)) {
        d->failed = true;
        return;
    }

    /* names and counts; a grid also says how it was thinned */
    put_text(d, item, "name", shape->name);
    put_int(d, item, "total", shape->vertex_count);
    put_int(d, item, "count", view.count);
    put_int(d, item, "rows", view.rows);
    put_int(d, item, "columns", view.columns);
    if (view.rows) {
        put_int(d, item, "row_total", shape->rows);
        put_int(d, item, "column_total", shape->columns);
        put_int(d, item, "row_stride", view.row_stride);
        put_int(d, item, "column_stride", view.column_stride);
        put_text(d, item, "row_label", shape->row_label);
        put_text(d, item, "column_label", shape->column_label);
    }

    /* triangles where the vertices are not a grid, positions, fields */
    put_int(d, item, "triangle_total", shape->triangle_count);
    if (view.triangles)
        put_json_array(d, item, "triangle_array",
                       wcut_report_pool_add_ints(d->pool, 3 * shape->triangle_count, shape->triangle));
    if (view.triangles && shape->part)
        put_json_array(d, item, "part", wcut_report_pool_add_ints(d->pool, shape->vertex_count, shape->part));
    put_json_array(d, item, "position", wcut_report_pool_add_points(d->pool, view.count, view.index, shape->vertex));
    json_t *fields = put_list(d, item, "fields");
    for (int f = 0; f < shape->field_count; f++)
        put_json_field(d, append_object(d, fields), shape, &view, &shape->field[f]);

    free(view.index);
}

static void put_report_scene(document *d, json_t *item, const wcut_report_scene *scene) {
    put_text(d, item, "title", scene->title);
    put_text(d, item, "note", scene->note);
    const wcut_vec3 block = scene->block_size;
    put_member(d, item, "block", json_pack("[fff]", block.x, block.y, block.z));
    json_t *shapes = put_list(d, item, "shapes");
    for (int s = 0; s < scene->shape_count; s++)
        put_json_shape(d, append_object(d, shapes), &scene->shape[s], scene->shape_count);
    json_t *lines = put_list(d, item, "lines");
    for (int l = 0; l < scene->line_count; l++) {
        const wcut_report_line *line = &scene->line[l];
        json_t *to = append_object(d, lines);
        put_text(d, to, "group", line->group);
        put_text(d, to, "label", line->label);
        put_json_array(d, to, "points", wcut_report_pool_add_points(d->pool, line->count, NULL, line->point));
    }
}

static void put_sweep_cases(document *d, json_t *item, const wcut_report_cases *cases) {
    /* numbers into the pool, texts into the document */
    put_int(d, item, "rows", cases->rows);
    put_int(d, item, "parameters", cases->parameters);
    json_t *columns = put_list(d, item, "columns");
    for (int c = 0; c < cases->columns; c++) {
        const wcut_report_column *column = &cases->column[c];
        json_t *to = append_object(d, columns);
        put_text(d, to, "label", column->label);
        put_unit(d, to, "unit", column->unit);
        if (column->number)
            put_json_array(d, to, "numbers", wcut_report_pool_add_doubles(d->pool, cases->rows, NULL, column->number));
        json_t *texts = column->number ? NULL : put_list(d, to, "texts");
        for (int r = 0; texts && r < cases->rows; r++)
            if (json_array_append_new(texts, text_or_null(column->text[r]))) d->failed = true;
    }

    /* what a case is called, and where its page is */
    put_json_array(d, item, "number", wcut_report_pool_add_ints(d->pool, cases->rows, cases->number));
    json_t *links = put_list(d, item, "links");
    for (int r = 0; r < cases->rows; r++)
        if (json_array_append_new(links, text_or_null(cases->link[r]))) d->failed = true;

    /* the best */
    put_int(d, item, "goal", cases->goal);
    put_member(d, item, "highest", json_boolean(cases->highest));
    put_text(d, item, "called", cases->called ? cases->called : "case");
    json_t *best = put_list(d, item, "best");
    for (int i = 0; i < cases->best_count; i++)
        if (json_array_append_new(best, json_integer(cases->best[i]))) d->failed = true;
}

static void put_json_section(document *d, json_t *item, const wcut_report_section *section) {
    put_text(d, item, "title", section->title);
    put_text(d, item, "note", section->note);
    json_t *list = put_list(d, item, "charts");
    for (int i = 0; i < section->chart_count; i++) put_chart(d, append_object(d, list), &section->chart[i]);
    list = put_list(d, item, "maps");
    for (int i = 0; i < section->map_count; i++) put_map(d, append_object(d, list), &section->map[i]);
    list = put_list(d, item, "tables");
    for (int i = 0; i < section->table_count; i++) put_table(d, append_object(d, list), &section->table[i]);

    /* the cases of a study */
    if (!section->cases) return;
    json_t *cases = json_object();
    put_member(d, item, "cases", cases);
    put_sweep_cases(d, cases, section->cases);
}

json_t *wcut_report_json(const wcut_report *report, wcut_report_pool *pool) {
    static const char *const tone[] = {"plain", "good", "warning", "bad"};

    /* what stands atop the page */
    document d = {.pool = pool};
    json_t *root = json_object();
    put_text(&d, root, "verb", report->verb);
    put_text(&d, root, "title", report->title);
    put_text(&d, root, "tone", tone[report->tone]);
    put_text(&d, root, "verdict", report->verdict);
    put_text(&d, root, "version", wcut_version_text());
    put_facts(&d, root, "facts", report->fact_count, report->fact);

    /* the scene, then the sections in order */
    if (report->scene) {
        json_t *scene = json_object();
        put_member(&d, root, "scene", scene);
        put_report_scene(&d, scene, report->scene);
    }
    json_t *list = put_list(&d, root, "sections");
    for (int i = 0; i < report->section_count; i++) put_json_section(&d, append_object(&d, list), &report->section[i]);

    /* sources and options end the page */
    list = put_list(&d, root, "sources");
    for (int i = 0; i < report->source_count; i++) {
        json_t *source = append_object(&d, list);
        put_text(&d, source, "role", report->source[i].role);
        put_text(&d, source, "name", report->source[i].name);
        put_text(&d, source, "sha256", report->source[i].sha256);
    }
    put_facts(&d, root, "options", report->option_count, report->option);

    if (d.failed || !root) {
        json_decref(root);
        return NULL;
    }

    return root;
}
