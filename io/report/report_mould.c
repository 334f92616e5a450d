/* The page of a divided block: both halves to turn, coloured by their draft, and what they measure. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <wirecut/angle.h>
#include <wirecut/report_pages.h>

#include "base/degrees.h"
#include "base/fail.h"

enum { ROWS = 13, ASKED = 4, SHAPES = 4 };

/* everything the page borrows */
typedef struct page {
    const wcut_report_mould *run;
    const wcut_job *job;
    const wcut_history *history;
    const wcut_mould *mould;
    double *draft[2];  /* of the halves' vertices [deg] */
    double *height[2]; /* of the vertices of casting and frame [mm]; NULL without one */
    char verdict[768], block[96], pull[96], hash[3][WCUT_SHA256_TEXT];
} page;

static const wcut_half *mould_half_of(const page *p, int upper) { return upper ? &p->mould->upper : &p->mould->lower; }

/* ---- what is copied ---- */

static wcut_status fill_drafts(page *p) {
    for (int upper = 0; upper < 2; upper++) {
        const wcut_half *half = mould_half_of(p, upper);
        const int count = half->mesh->vertex_count;
        p->draft[upper] = calloc((size_t)count, sizeof(double));
        if (!p->draft[upper]) return WCUT_NO_MEMORY;
        for (int v = 0; v < count; v++) p->draft[upper][v] = WCUT_DEG_PER_RAD * half->draft[v];
    }
    return WCUT_OK;
}

/* a field that shapes without a draft have, too */
static wcut_status fill_heights(page *p) {
    for (int k = 0; k < 2; k++) {
        const wcut_mesh *mesh = k ? p->mould->frame : p->mould->thickness > 0 ? p->mould->kerf : NULL;
        if (!mesh) continue;
        p->height[k] = calloc((size_t)mesh->vertex_count, sizeof(double));
        if (!p->height[k]) return WCUT_NO_MEMORY;
        for (int v = 0; v < mesh->vertex_count; v++) p->height[k][v] = mesh->vertex[v].z;
    }
    return WCUT_OK;
}

/* ---- what is said ---- */

/* a figure that was asked for, of one half */
typedef struct asked {
    const char *half, *what, *unit;
    double found, least;
    wcut_vec3 at;
    int held;
} asked;

/* walls, then drafts, lower before upper */
static void list_asked(const wcut_mould *m, asked row[ASKED]) {
    for (int k = 0; k < 2; k++) {
        const wcut_half_report *r = k ? &m->upper.report : &m->lower.report;
        const char *half = k ? "upper half" : "lower half";
        row[k] = (asked){half, "wall", "mm", r->wall_min, m->wall_asked, r->wall_place, r->wall_held};
        row[2 + k] =
            (asked){half,           "draft",      "deg", WCUT_DEG_PER_RAD * r->draft_min, typed_degrees(m->draft_asked),
                    r->draft_place, r->draft_held};
    }
}

/* what falls short, by how much and where: "upper half: wall 2.1 mm at (4, 300, 98) mm, required 5 mm" */
static void tell_shortfalls(page *p, const asked row[ASKED], const char *halves) {
    int used = snprintf(p->verdict, sizeof p->verdict, "%s, but", halves);
    const char *before = " ";
    for (int k = 0; k < ASKED && used < (int)sizeof p->verdict; k++) {
        const asked *a = &row[k];
        if (a->held) continue;
        used += isfinite(a->found)
                    ? snprintf(p->verdict + used, sizeof p->verdict - (size_t)used,
                               "%s%s: %s %.4g %s at (%.4g, %.4g, %.4g) mm, required %.4g %s", before, a->half, a->what,
                               a->found, a->unit, a->at.x, a->at.y, a->at.z, a->least, a->unit)
                    : snprintf(p->verdict + used, sizeof p->verdict - (size_t)used,
                               "%s%s: %s not known, required %.4g %s", before, a->half, a->what, a->least, a->unit);
        before = "; ";
    }
    if (used < (int)sizeof p->verdict) snprintf(p->verdict + used, sizeof p->verdict - (size_t)used, ".");
}

static wcut_report_tone judge_mould(page *p) {
    const wcut_mould *m = p->mould;
    const wcut_half_report *a = &m->lower.report, *b = &m->upper.report;

    /* how far the cut was continued straight at most */
    const double prolonged = fmax(m->prolonged_entry, fmax(m->prolonged_exit, m->prolonged_side));
    const char *halves = "Two closed solids, free of self-intersections, whose volumes add up to the block";

    /* the worst news is the verdict */
    if (!a->wall_held || !b->wall_held || !a->draft_held || !b->draft_held) {
        asked row[ASKED];
        list_asked(m, row);
        tell_shortfalls(p, row, halves);
        return WCUT_REPORT_TONE_BAD;
    }
    if (a->undercut_area > 0 || b->undercut_area > 0) {
        snprintf(p->verdict, sizeof p->verdict,
                 "%s, but %.4g mm\xc2\xb2 of the lower half and %.4g mm\xc2\xb2 of the upper half are undercut.",
                 halves, a->undercut_area, b->undercut_area);
        return WCUT_REPORT_TONE_WARNING;
    }

    /* a radius below the wire's own cannot have been cut */
    if (m->radius_min < m->wire_radius) {
        snprintf(p->verdict, sizeof p->verdict, "%s, but the cut has a radius of %.3g mm, smaller than the wire's.",
                 halves, m->radius_min);
        return WCUT_REPORT_TONE_WARNING;
    }

    /* what was added beyond the cut is told, but no fault */
    if (prolonged > 0) {
        snprintf(p->verdict, sizeof p->verdict,
                 "%s. The cut ends inside it and was continued straight by up to %.3g mm.", halves, prolonged);
        return WCUT_REPORT_TONE_PLAIN;
    }
    snprintf(p->verdict, sizeof p->verdict, "%s.", halves);

    return WCUT_REPORT_TONE_GOOD;
}

/* figures of both halves side by side */
static wcut_report_table table_of_halves(const page *p, double number[2][ROWS], wcut_report_column column[4]) {
    /* rows in the order of the values below */
    static const char *const what[ROWS] = {
        "volume", "surface",   "cut face", "undercut",    "smallest draft",   "smallest wall",  "sharpest edge",
        "keys",   "triangles", "pieces",   "exact faces", "height, smallest", "height, largest"};
    static const char *const unit[ROWS] = {"mm\xc2\xb3", "mm\xc2\xb2", "mm\xc2\xb2", "mm\xc2\xb2", "deg", "mm", "deg",
                                           "mm\xc2\xb3", "",           "",           "",           "mm",  "mm"};

    /* a column of numbers for each half */
    for (int k = 0; k < 2; k++) {
        const wcut_half *h = mould_half_of(p, k);
        const wcut_half_report *r = &h->report;
        const double value[ROWS] = {r->volume,
                                    r->area,
                                    r->cut_area,
                                    r->undercut_area,
                                    WCUT_DEG_PER_RAD * r->draft_min,
                                    r->wall_min,
                                    WCUT_DEG_PER_RAD * r->edge_min,
                                    r->key_volume,
                                    h->mesh->triangle_count,
                                    r->pieces,
                                    h->brep ? (double)h->brep->face_count : (double)NAN,
                                    r->box_low.z,
                                    r->box_high.z};
        for (int i = 0; i < ROWS; i++) number[k][i] = value[i];
    }

    /* names, units, and a column for each half */
    column[0] = (wcut_report_column){.label = "figure", .text = what};
    column[1] = (wcut_report_column){.label = "unit", .text = unit};
    column[2] = (wcut_report_column){.label = "lower half", .number = number[0]};
    column[3] = (wcut_report_column){.label = "upper half", .number = number[1]};
    return (wcut_report_table){.title = "The halves",
                               .note = p->mould->by_boolean ? "Made by mesh booleans: triangles, no STEP files." : NULL,
                               .rows = ROWS,
                               .columns = 4,
                               .column = column};
}

/* what was asked for and what was found, with its place */
typedef struct asked_columns {
    const char *half[ASKED], *what[ASKED], *unit[ASKED], *held[ASKED];
    double found[ASKED], least[ASKED], x[ASKED], y[ASKED], z[ASKED];
    wcut_report_column column[9];
} asked_columns;

static wcut_report_table table_of_asked(const page *p, asked_columns *c) {
    asked row[ASKED];
    list_asked(p->mould, row);
    for (int k = 0; k < ASKED; k++) {
        const asked *a = &row[k];
        const bool any = k < 2 ? !(a->least > 0) : !(a->least > -90);
        c->half[k] = a->half, c->what[k] = a->what, c->unit[k] = a->unit;
        c->held[k] = any ? "nothing required" : a->held ? "held" : "falls short";
        c->found[k] = a->found, c->least[k] = any ? (double)NAN : a->least;
        c->x[k] = a->at.x, c->y[k] = a->at.y, c->z[k] = a->at.z;
    }
    const wcut_report_column column[9] = {{.label = "half", .text = c->half},
                                          {.label = "figure", .text = c->what},
                                          {.label = "smallest", .number = c->found},
                                          {.label = "required", .number = c->least},
                                          {.label = "unit", .text = c->unit},
                                          {.label = "at x [mm]", .number = c->x},
                                          {.label = "y [mm]", .number = c->y},
                                          {.label = "z [mm]", .number = c->z},
                                          {.label = "", .text = c->held}};
    memcpy(c->column, column, sizeof column);
    return (wcut_report_table){
        .title = "Walls and drafts, and where they are smallest", .rows = ASKED, .columns = 9, .column = c->column};
}

/* ---- the page ---- */

static wcut_status write_mould_page(page *p, const wcut_report_scene *scene, const char *path, wcut_error *error) {
    const wcut_job *job = p->job;
    const wcut_mould *m = p->mould;

    /* the table of both halves */
    double number[2][ROWS];
    wcut_report_column column[4];
    const wcut_report_table table = table_of_halves(p, number, column);
    asked_columns places;
    const wcut_report_table both[2] = {table_of_asked(p, &places), table};
    const wcut_report_section section = {.title = "Figures of the halves", .table_count = 2, .table = both};

    /* texts of three numbers */
    snprintf(p->block, sizeof p->block, "%g \xc3\x97 %g \xc3\x97 %g", job->block_size.x, job->block_size.y,
             job->block_size.z);
    snprintf(p->pull, sizeof p->pull, "%g, %g, %g", m->pull.x, m->pull.y, m->pull.z);
    const double radius = isfinite(m->radius_min) && m->radius_min < 1e9 ? m->radius_min : NAN;

    /* the answer in numbers */
    const wcut_report_fact fact[] = {
        {"block, x by y by z", p->block, 0, "mm"},
        {"lower half", NULL, m->lower.report.volume, "mm\xc2\xb3"},
        {"upper half", NULL, m->upper.report.volume, "mm\xc2\xb3"},
        {m->thickness > 0 ? "casting between the halves" : "kerf", NULL, m->kerf_volume, "mm\xc2\xb3"},
        {"frame", m->frame ? NULL : "none", m->frame_volume, m->frame ? "mm\xc2\xb3" : ""},
        {"error of the volumes, relative to the block", NULL, m->volume_error, ""},
        {"distance of the cut faces, smallest", NULL, m->kerf_min, "mm"},
        {"distance of the cut faces, largest", NULL, m->kerf_max, "mm"},
        {"distance of the exact face from the wire's surface", NULL, m->fit_error, "mm"},
        {"distance of the triangles from the exact face", NULL, m->chord_error, "mm"},
        {"straight continuation at the entry", NULL, m->prolonged_entry, "mm"},
        {"straight continuation at the exit", NULL, m->prolonged_exit, "mm"},
        {"straight continuation at the wire's ends", NULL, m->prolonged_side, "mm"},
        {"smallest radius of the cut", NULL, radius, "mm"},
        {"radius of the wire", NULL, m->wire_radius, "mm"}};

    /* settings of the run */
    const wcut_report_fact option[] = {{"chord tolerance", NULL, p->run->chord_tolerance, "mm"},
                                       {"fit tolerance", NULL, p->run->fit_tolerance, "mm"},
                                       {"longest straight continuation", NULL, p->run->prolong, "mm"},
                                       {"thickness of the casting", NULL, m->thickness, "mm"},
                                       {"lugs of each half", NULL, m->lugs, ""},
                                       {"scale", NULL, m->scale, ""},
                                       {"pull out of the lower half, x, y, z", p->pull, 0, ""},
                                       {"required wall", NULL, m->wall_asked, "mm"},
                                       {"required draft", NULL, typed_degrees(m->draft_asked), "deg"}};

    /* only the files that were given */
    const wcut_report_source from[3] = {{"job", p->run->job_path, p->hash[0][0] ? p->hash[0] : NULL},
                                        {"stock", p->run->stock_path, p->hash[1][0] ? p->hash[1] : NULL},
                                        {"edges", p->run->edges_path, p->hash[2][0] ? p->hash[2] : NULL}};
    wcut_report_source source[3];
    int sources = 0;
    for (int k = 0; k < 3; k++)
        if (k == 0 || from[k].name) source[sources++] = from[k];

    /* the whole page */
    const wcut_report report = {.verb = "mould",
                                .title = job->name ? job->name : p->run->job_path,
                                .tone = judge_mould(p),
                                .verdict = p->verdict,
                                .fact_count = sizeof fact / sizeof *fact,
                                .fact = fact,
                                .scene = scene,
                                .section_count = 1,
                                .section = &section,
                                .source_count = sources,
                                .source = source,
                                .option_count = sizeof option / sizeof *option,
                                .option = option};

    return wcut_report_write(&report, path, error);
}

static wcut_report_shape mould_shape_of(const char *name, const wcut_mesh *mesh, const wcut_report_field *field) {
    return (wcut_report_shape){.name = name,
                               .vertex_count = mesh->vertex_count,
                               .vertex = mesh->vertex,
                               .triangle_count = mesh->triangle_count,
                               .triangle = mesh->triangle,
                               .field_count = 1,
                               .field = field};
}

static int fill_mould_shapes(const page *p, wcut_report_field field[SHAPES], wcut_report_shape shape[SHAPES]) {
    const wcut_mould *m = p->mould;
    for (int k = 0; k < 2; k++) {
        field[k] = (wcut_report_field){k ? "draft of the upper half" : "draft of the lower half", "deg",
                                       WCUT_REPORT_SCALE_SEQUENTIAL, 0, p->draft[k]};
        shape[k] = mould_shape_of(k ? "upper half" : "lower half", mould_half_of(p, k)->mesh, &field[k]);
    }
    int count = 2;
    for (int k = 0; k < 2; k++) {
        const wcut_mesh *mesh = k ? m->frame : m->thickness > 0 ? m->kerf : NULL;
        if (!mesh) continue;
        field[count] = (wcut_report_field){"height", "mm", WCUT_REPORT_SCALE_SEQUENTIAL, 0, p->height[k]};
        shape[count] = mould_shape_of(k ? "frame" : "casting", mesh, &field[count]);
        count++;
    }
    return count;
}

/* a mark at the place of every wall and draft that falls short */
static int mark_shortfalls(const asked row[ASKED], wcut_report_line line[ASKED]) {
    static const char *const label[ASKED] = {"wall of the lower half", "wall of the upper half",
                                             "draft of the lower half", "draft of the upper half"};
    int lines = 0;
    for (int k = 0; k < ASKED; k++)
        if (!row[k].held && isfinite(row[k].at.x))
            line[lines++] =
                (wcut_report_line){.group = "falls short", .label = label[k], .count = 1, .point = &row[k].at};
    return lines;
}

wcut_status wcut_report_mould_write(const wcut_report_mould *run, const wcut_job *job, const wcut_history *history,
                                    const wcut_mould *mould, const char *path, wcut_error *error) {
    if (!run || !run->job_path || !job || !mould || !path)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "report page: an argument is missing");
    page p = {.run = run, .job = job, .history = history, .mould = mould};

    /* copies and hashes */
    wcut_status status = fill_drafts(&p);
    if (!status) status = fill_heights(&p);
    if (!status) status = wcut_source_hash(run->job_path, p.hash[0], error);
    if (!status) status = wcut_source_hash(run->stock_path, p.hash[1], error);
    if (!status) status = wcut_source_hash(run->edges_path, p.hash[2], error);

    /* each half is a shape, coloured by its draft; frame and casting are grey */
    if (!status) {
        wcut_report_field field[SHAPES];
        wcut_report_shape shape[SHAPES];
        asked row[ASKED];
        wcut_report_line line[ASKED];
        list_asked(mould, row);
        const int shapes = fill_mould_shapes(&p, field, shape), lines = mark_shortfalls(row, line);

        /* the block in the size of the halves */
        const double f = mould->scale;
        const wcut_report_scene scene = {
            .title = "The halves",
            .note = lines > 0 ? "Grey: faces that the wire does not cut. Marks: where a wall or a draft falls short."
                              : "Grey: faces that the wire does not cut.",
            .block_size = {f * job->block_size.x, f * job->block_size.y, f * job->block_size.z},
            .shape_count = shapes,
            .shape = shape,
            .line_count = lines,
            .line = line};

        /* the page around the view */
        status = write_mould_page(&p, &scene, path, error);
    }

    free(p.height[1]);
    free(p.height[0]);
    free(p.draft[1]);
    free(p.draft[0]);
    return status;
}
