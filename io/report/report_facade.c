/* The page of a facade: all faces in space, their figures as colours and as a table. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/report_pages.h>

#include "base/fail.h"
#include "io/report/page_memory.h"

enum {
    N = WCUT_FACADE_SAMPLES,
    POINTS = N * N,
    FIGURES = 12,
    FIELDS = 10,            /* of the view: force, then figures */
    WORDS = 4,              /* columns of words behind the figures */
    VERTICES_SHOWN = 150000 /* of all faces; beyond them every second, fourth .. sample */
};

/* the figures of an element, as columns and colours; those of the view come first */
static const struct {
    const char *label, *unit;
} figure_of[FIGURES] = {{"cutting time", "s"},
                        {"smallest radius", "mm"},
                        {"lowest speed", "mm/s"},
                        {"highest speed", "mm/s"},
                        {"face moved to its edges", "mm"},
                        {"step at joints", "mm"},
                        {"kink at joints", "deg"},
                        {"weight of panel", "kg"},
                        {"foam below", "dm3"},
                        {"foam above", "dm3"},
                        {"row", ""},
                        {"column", ""}};

typedef struct facade_page {
    const wcut_facade_results *results;
    wcut_page_memory memory;
    double *figure[FIGURES]; /* elements each */
    wcut_report_shape shape;
    wcut_report_field field[FIELDS];
} facade_page;

/* ---- figures ---- */

static double largest_at_joints(const wcut_facade_results *r, int element, bool angle) {
    const wcut_facade_element *e = &r->description->facade->element[element];
    double max = NAN;
    for (int b = 0; b < 4; b++)
        if (e->joint[b] >= 0) max = fmax(max, angle ? r->joint[e->joint[b]].angle_max : r->joint[e->joint[b]].step_max);
    return max;
}

static void fill_element_figures(facade_page *p) {
    const wcut_facade_results *r = p->results;
    const wcut_facade *f = r->description->facade;
    for (int c = 0; c < FIGURES; c++) p->figure[c] = wcut_page_take(&p->memory, (size_t)f->elements, sizeof(double));
    for (int k = 0; k < f->elements && !p->memory.failed; k++) {
        const wcut_facade_item *i = &r->item[k];
        const double value[FIGURES] = {i->duration,
                                       i->radius_min,
                                       i->speed_min,
                                       i->speed_max,
                                       i->moved_max,
                                       largest_at_joints(r, k, false),
                                       largest_at_joints(r, k, true) * WCUT_DEG_PER_RAD,
                                       i->panel_mass,
                                       i->foam_lower / 1e6,
                                       i->foam_upper / 1e6,
                                       f->element[k].row,
                                       f->element[k].column};
        for (int c = 0; c < FIGURES; c++) p->figure[c][k] = fabs(value[c]) <= 1e30 ? value[c] : NAN;
    }
}

static bool is_figure_known(const facade_page *p, int figure) {
    for (int k = 0; k < p->results->description->facade->elements; k++)
        if (isfinite(p->figure[figure][k])) return true;
    return false;
}

/* ---- the view ---- */

/* every how manieth sample the view has each way */
static int stride_of(int elements) {
    int stride = 1, side = N;
    while (side > 3 && elements > VERTICES_SHOWN / (side * side)) {
        stride *= 2;
        side = (N - 1) / stride + 1;
    }
    return stride;
}

/* colours: the force at every vertex, a figure all over its element */
static void fill_fields(facade_page *p, int side, int stride) {
    const wcut_facade_results *r = p->results;
    const int elements = r->description->facade->elements, each = side * side;
    int fields = 0;
    for (int c = -1; c < FIGURES && fields < FIELDS; c++) {
        if (c >= 0 && !is_figure_known(p, c)) continue;
        double *value = wcut_page_take(&p->memory, (size_t)elements * (size_t)each, sizeof *value);
        if (!value) return;
        for (int v = 0; v < elements * each; v++) {
            const wcut_element_face *face = r->item[v / each].face;
            const int from = (v % each / side) * stride * N + (v % side) * stride;
            value[v] = c >= 0 ? p->figure[c][v / each] : face && face->force ? face->force[from] : NAN;
        }
        p->field[fields++] = (wcut_report_field){.label = c < 0 ? "force on the wire" : figure_of[c].label,
                                                 .unit = c < 0 ? "N/mm" : figure_of[c].unit,
                                                 .value = value};
    }
    p->shape.field_count = fields;
    p->shape.field = p->field;
}

/* the faces of all elements as one mesh; an element without one is shown flat, as the base of its block */
static wcut_status fill_view(facade_page *p) {
    const wcut_facade_results *r = p->results;
    const wcut_facade *f = r->description->facade;
    const int stride = stride_of(f->elements), side = (N - 1) / stride + 1, each = side * side,
              cells = (side - 1) * (side - 1);
    const wcut_element_face **face = wcut_page_take(&p->memory, (size_t)f->elements, sizeof *face);
    wcut_vec3 *all = wcut_page_take(&p->memory, (size_t)f->elements * POINTS, sizeof *all);
    wcut_vec3 *vertex = wcut_page_take(&p->memory, (size_t)f->elements * (size_t)each, sizeof *vertex);
    int *triangle = wcut_page_take(&p->memory, (size_t)f->elements * (size_t)cells * 6, sizeof *triangle);
    int *row = wcut_page_take(&p->memory, (size_t)f->elements * (size_t)each, sizeof *row);
    if (p->memory.failed) return WCUT_NO_MEMORY;
    for (int k = 0; k < f->elements; k++) face[k] = r->item[k].face;
    const wcut_status status = wcut_facade_points(f, face, all);
    if (status != WCUT_OK) return status;

    /* vertices and triangles, element by element */
    for (int v = 0; v < f->elements * each; v++) {
        vertex[v] = all[(size_t)(v / each) * POINTS + (size_t)((v % each / side) * stride * N + (v % side) * stride)];
        row[v] = v / each;
    }
    for (int k = 0; k < f->elements * cells; k++) {
        const int a = k / cells * each + k % cells / (side - 1) * side + k % (side - 1);
        const int corner[6] = {a, a + 1, a + side + 1, a, a + side + 1, a + side};
        memcpy(triangle + 6 * (size_t)k, corner, sizeof corner);
    }
    p->shape = (wcut_report_shape){.name = "facade",
                                   .vertex_count = f->elements * each,
                                   .vertex = vertex,
                                   .triangle_count = 2 * f->elements * cells,
                                   .triangle = triangle,
                                   .part = row};
    fill_fields(p, side, stride);
    return p->memory.failed ? WCUT_NO_MEMORY : WCUT_OK;
}

/* ---- the table ---- */

static const char *state_of(const wcut_facade_item *item) {
    return item->feasible                         ? "feasible"
           : item->state == WCUT_SWEEP_STATE_DONE ? "infeasible"
                                                  : wcut_sweep_state_name(item->state);
}

static void fill_element_table(facade_page *p, wcut_report_cases *cases) {
    const wcut_facade_results *r = p->results;
    const wcut_facade *f = r->description->facade;
    const size_t n = (size_t)f->elements;
    wcut_report_column *column = wcut_page_take(&p->memory, FIGURES + WORDS, sizeof *column);
    const char **variant = wcut_page_take(&p->memory, n, sizeof *variant),
               **half = wcut_page_take(&p->memory, n, sizeof *half);
    const char **state = wcut_page_take(&p->memory, n, sizeof *state),
               **reason = wcut_page_take(&p->memory, n, sizeof *reason);
    const char **link = wcut_page_take(&p->memory, n, sizeof *link);
    int *number = wcut_page_take(&p->memory, n, sizeof *number);
    if (p->memory.failed) return;

    /* words of every element, and the page of its cut */
    for (int k = 0; k < f->elements; k++) {
        const wcut_facade_item *i = &r->item[k];
        number[k] = k;
        variant[k] = r->description->variant_name[r->description->variant[k]];
        half[k] = f->element[k].mirrored ? "upper" : "lower";
        state[k] = state_of(i);
        reason[k] = i->reason[0] ? i->reason : NULL;
        link[k] = i->face ? wcut_page_text(&p->memory, "cases/%.2s/%s/report.html", i->hash, i->hash) : NULL;
    }

    /* figures that are known, then the words */
    int columns = 0;
    for (int c = 0; c < FIGURES; c++)
        if (is_figure_known(p, c))
            column[columns++] =
                (wcut_report_column){.label = figure_of[c].label, .unit = figure_of[c].unit, .number = p->figure[c]};
    column[columns++] = (wcut_report_column){.label = "variant", .text = variant};
    column[columns++] = (wcut_report_column){.label = "half of the panel", .text = half};
    column[columns++] = (wcut_report_column){.label = "verdict", .text = state};
    column[columns++] = (wcut_report_column){.label = "reason", .text = reason};
    *cases = (wcut_report_cases){.rows = f->elements,
                                 .columns = columns,
                                 .column = column,
                                 .number = number,
                                 .link = link,
                                 .goal = -1,
                                 .called = "element"};
}

/* ---- the page ---- */

static wcut_status write_facade_page(facade_page *p, const wcut_report_cases *cases, const char *source,
                                     const char *path, wcut_error *error) {
    const wcut_facade_results *r = p->results;
    const wcut_facade *f = r->description->facade;
    char verdict[WCUT_REPORT_SENTENCE], title[256], hash[WCUT_SHA256_TEXT] = "";
    int feasible = 0;
    double duration = 0, mass = 0, step = NAN, angle = NAN;
    for (int k = 0; k < f->elements; k++) {
        feasible += r->item[k].feasible;
        if (isfinite(r->item[k].duration)) duration += r->item[k].duration;
        if (isfinite(r->item[k].panel_mass)) mass += r->item[k].panel_mass;
    }
    for (int j = 0; j < f->joints; j++)
        step = fmax(step, r->joint[j].step_max), angle = fmax(angle, r->joint[j].angle_max);

    /* the answer, and what it rests on */
    snprintf(verdict, sizeof verdict, "%d of %d elements can be cut as described; %d of them are distinct.", feasible,
             f->elements, r->distinct);
    snprintf(title, sizeof title, "%.250s", r->description->name);
    wcut_report_fact fact[8];
    int facts = 0;
    fact[facts++] = (wcut_report_fact){"elements", NULL, f->elements, ""};
    fact[facts++] = (wcut_report_fact){"distinct", NULL, r->distinct, ""};
    fact[facts++] = (wcut_report_fact){"cutting time of all", NULL, duration / 3600, "h"};
    if (mass > 0) fact[facts++] = (wcut_report_fact){"panels", NULL, mass, "kg"};
    if (isfinite(step)) fact[facts++] = (wcut_report_fact){"largest step at a joint, as cut", NULL, step, "mm"};
    if (isfinite(angle))
        fact[facts++] = (wcut_report_fact){"largest kink at a joint", NULL, angle * WCUT_DEG_PER_RAD, "deg"};

    /* the whole, and the elements by themselves */
    const wcut_report_scene scene = {
        .title = "The facade",
        .note = "Faces of the elements where they stand, carried to their shared edges. Click one for its figures.",
        .shape_count = 1,
        .shape = &p->shape};
    const wcut_report_section section = {
        .title = "Elements",
        .note = "A row of the table for each element, with a link to the page of its cut.",
        .cases = cases};
    wcut_status status = source ? wcut_source_hash(source, hash, error) : WCUT_OK;
    if (status != WCUT_OK) return status;
    const wcut_report_source from = {"facade", source, hash[0] ? hash : NULL};
    const wcut_report report = {.verb = "facade",
                                .title = title,
                                .tone = feasible < f->elements ? WCUT_REPORT_TONE_WARNING : WCUT_REPORT_TONE_GOOD,
                                .verdict = verdict,
                                .fact_count = facts,
                                .fact = fact,
                                .scene = &scene,
                                .section_count = 1,
                                .section = &section,
                                .source_count = source ? 1 : 0,
                                .source = &from};
    return wcut_report_write(&report, path, error);
}

wcut_status wcut_report_facade_write(const wcut_facade_results *results, const char *source, const char *path,
                                     wcut_error *error) {
    if (!results || !path) return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    facade_page p = {.results = results};
    wcut_report_cases cases = {0};
    fill_element_figures(&p);
    wcut_status status = p.memory.failed ? WCUT_NO_MEMORY : fill_view(&p);
    if (status == WCUT_OK) fill_element_table(&p, &cases);
    if (p.memory.failed) status = WCUT_NO_MEMORY;
    status = status == WCUT_OK ? write_facade_page(&p, &cases, source, path, error)
                               : wcut_fail(error, status, "report page: %s", wcut_status_text(status));
    wcut_page_free(&p.memory);
    return status;
}
