/* What was found, in space: the block, the wire at the worst moment, the place of an effect or term, the scan. */
#include <math.h>
#include <string.h>

#include "io/report/report_findings.h"

enum { LINES = 40, ARC = 37 };

#define PI 3.14159265358979323846

typedef struct drawing {
    wcut_page_memory *memory;
    wcut_report_line *line;
    int count;
} drawing;

static wcut_vec3 *add_lines(drawing *g, const char *group, const char *label, int count) {
    wcut_vec3 *point = g->count < LINES ? wcut_page_take(g->memory, (size_t)count, sizeof *point) : NULL;
    if (point) g->line[g->count++] = (wcut_report_line){.group = group, .label = label, .count = count, .point = point};
    return point;
}

/* a sphere by three circles */
static void draw_spot(drawing *g, const wcut_effect *e, const char *label) {
    const double r = e->value[WCUT_FOAM_INCLUSION_RADIUS], *at = &e->value[WCUT_FOAM_INCLUSION_POSITION];
    for (int plane = 0; plane < 3; plane++) {
        wcut_vec3 *p = add_lines(g, "found", plane ? NULL : label, ARC);
        for (int i = 0; p && i < ARC; i++) {
            const double u = r * cos(2 * PI * i / (ARC - 1)), v = r * sin(2 * PI * i / (ARC - 1));
            p[i] = plane == 0   ? (wcut_vec3){at[0] + u, at[1] + v, at[2]}
                   : plane == 1 ? (wcut_vec3){at[0] + u, at[1], at[2] + v}
                                : (wcut_vec3){at[0], at[1] + u, at[2] + v};
        }
    }
}

/* the outline of the block's section across an axis */
static void draw_section(drawing *g, wcut_vec3 block, int axis, double at, const char *label) {
    wcut_vec3 *p = add_lines(g, "found", label, 5);
    for (int i = 0; p && i < 5; i++) {
        const bool u = i == 1 || i == 2, v = i == 2 || i == 3;
        p[i] = axis == 0   ? (wcut_vec3){at, u ? block.y : 0, v ? block.z : 0}
               : axis == 1 ? (wcut_vec3){u ? block.x : 0, at, v ? block.z : 0}
                           : (wcut_vec3){u ? block.x : 0, v ? block.y : 0, at};
    }
}

/* crests of a wave, sides of a band; other terms have no place */
static void draw_term(drawing *g, const wcut_effect *e, wcut_vec3 block) {
    const char *name = wcut_effect_view(e->kind)->choice[e->choice];

    /* the axis is the last letter of the term's name */
    const size_t end = strlen(name);
    const int axis = end > 2 && name[end - 2] == '_' ? name[end - 1] - 'x' : -1;
    if (axis < 0 || axis > 2) return;
    const double size = axis == 0 ? block.x : axis == 1 ? block.y : block.z;

    /* both sides of a band */
    if (strncmp(name, "band", 4) == 0) {
        draw_section(g, block, axis, e->value[WCUT_EMPIRICAL_FORCE_FROM], name);
        draw_section(g, block, axis, e->value[WCUT_EMPIRICAL_FORCE_TO], NULL);
    }

    /* crests: where the argument of the wave is pi / 2, a wavelength apart */
    const double length = e->value[WCUT_EMPIRICAL_FORCE_WAVELENGTH];
    if (strncmp(name, "wave", 4) != 0 || !(length > 0)) return;
    const double turn =
                     PI / 2 - atan2(e->value[WCUT_EMPIRICAL_FORCE_COSINE], e->value[WCUT_EMPIRICAL_FORCE_COEFFICIENT]),
                 first = turn / (2 * PI) * length;
    for (int k = -1; k < LINES; k++) {
        const double at = first + k * length;
        if (at >= 0 && at <= size) draw_section(g, block, axis, at, g->count ? NULL : "crests of the force");
    }
}

static void draw_found(drawing *g, const wcut_diagnosis *d, wcut_vec3 block) {
    for (int e = 0; e < d->effects; e++)
        if (d->effect[e].effect.kind == WCUT_EFFECT_FOAM_INCLUSION)
            draw_spot(g, &d->effect[e].effect,
                      d->effect[e].effect.value[WCUT_FOAM_INCLUSION_AMPLITUDE] < 0 ? "softer spot" : "denser spot");
    for (int k = 0; k < d->modelled.terms; k++) draw_term(g, &d->modelled.term[k].effect, block);
}

/* a grid of the wire, time after time, and the scan's patches as a cloud */
static int fill_shapes(wcut_page_memory *memory, const wcut_diagnosis_view *v, wcut_report_shape *shape) {
    int count = 0;

    /* heights colour the surface */
    const int vertices = v->rows * v->nodes;
    double *height = wcut_page_take(memory, (size_t)vertices, sizeof *height);
    wcut_report_field *field = wcut_page_take(memory, 2, sizeof *field);
    if (!height || !field) return 0;
    for (int i = 0; i < vertices; i++) height[i] = v->surface[i].z;
    field[0] =
        (wcut_report_field){.label = "height", .unit = "mm", .scale = WCUT_REPORT_SCALE_SEQUENTIAL, .value = height};

    /* the wire, time after time, as a grid */
    shape[count++] = (wcut_report_shape){.name = "surface of the wire, after",
                                         .vertex_count = vertices,
                                         .vertex = v->surface,
                                         .rows = v->rows,
                                         .columns = v->nodes,
                                         .row_label = "time step",
                                         .column_label = "node",
                                         .field_count = 1,
                                         .field = field};

    /* the scan, where there is one */
    if (v->points == 0) return count;
    field[1] = (wcut_report_field){.label = "scan above the recalibrated surface",
                                   .unit = "mm",
                                   .scale = WCUT_REPORT_SCALE_DIVERGING,
                                   .value = v->distance};
    shape[count++] = (wcut_report_shape){.name = "scan, means of patches",
                                         .vertex_count = v->points,
                                         .vertex = v->point,
                                         .field_count = 1,
                                         .field = field + 1};

    return count;
}

bool wcut_report_block_fill(wcut_page_memory *memory, const wcut_report_diagnose *of, wcut_report_scene *scene) {
    const wcut_diagnosis *d = of->diagnosis;
    const wcut_diagnosis_view *v = &d->view;

    /* without a surface the page has no view */
    if (v->rows < 2 || v->nodes < 2 || !v->surface || v->cut < 0 || v->cut >= d->cuts) return false;

    /* lines of the drawing, shapes of the surface and the scan */
    drawing g = {.memory = memory, .line = wcut_page_take(memory, LINES, sizeof *g.line)};
    wcut_report_shape *shape = wcut_page_take(memory, 2, sizeof *shape);
    if (memory->failed) return false;

    /* what was found, then the wire at the worst moment */
    draw_found(&g, d, v->block);
    wcut_vec3 *wire = add_lines(&g, "wire", wcut_page_text(memory, "at %.1f s", v->time), v->nodes);
    if (wire) memcpy(wire, v->surface + (size_t)v->worst * (size_t)v->nodes, (size_t)v->nodes * sizeof *wire);

    *scene =
        (wcut_report_scene){.title = wcut_page_text(memory, "The block, %s", of->cut_name[v->cut]),
                            .note = "The wire where the misfit is worst, what was found in the block, and the scan.",
                            .block_size = v->block,
                            .shape_count = fill_shapes(memory, v, shape),
                            .shape = shape,
                            .line_count = g.count,
                            .line = g.line};

    return !memory->failed;
}
