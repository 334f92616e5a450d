/* A facade laid out: the plan checked, every element in its cell or place, then joints and edges. */
#include "facade/layout.h"

#include <stdio.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/numbers.h"
#include "base/vec3.h"
#include "cut/setup.h"
#include "facade/field.h"

/* axes of a free placement are perpendicular and of length 1 to this */
static const double AXES_HELD = 1e-6;

/* ---- small parts that others use ---- */

const char *wcut_layout_name(char text[WCUT_LAYOUT_WORDS], const wcut_facade *facade, int element) {
    const wcut_facade_element *e = &facade->element[element];
    snprintf(text, WCUT_LAYOUT_WORDS, "element %d (row %d, column %d)", element, e->row, e->column);
    return text;
}

wcut_vec3 wcut_element_point(const wcut_facade_element *e, wcut_vec3 p) {
    return vec3_add_scaled(vec3_add_scaled(vec3_add_scaled(e->origin, p.x, e->x), p.y, e->y), p.z, e->z);
}

wcut_vec3 wcut_border_point(wcut_vec3 block, int border, int k, double height) {
    const double share = (double)k / (WCUT_FACADE_SAMPLES - 1);
    return border < 2 ? vec3(border ? block.x : 0, block.y * share, height)
                      : vec3(block.x * share, border == 3 ? block.y : 0, height);
}

/* ---- the plan ---- */

static wcut_status check_fields(const wcut_facade_plan *p, wcut_error *error) {
    if (p->heights == 0) return WCUT_OK;
    if (p->lattice == WCUT_FACADE_LATTICE_FREE)
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "fields: found free placements, expected a lattice to lay them over");
    if (p->heights < 0 || p->extras < 1 || !p->height || !p->extra || p->overrun * 0 != 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "fields: expected heights, extra lengths and a finite overrun");
    for (int k = 0; k < p->heights + p->extras; k++)
        if (!wcut_facade_field_is_valid(k < p->heights ? &p->height[k] : &p->extra[k - p->heights]))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "fields: number %d of the %s is out of range or has no values",
                             k < p->heights ? k : k - p->heights, k < p->heights ? "heights" : "extra lengths");
    return WCUT_OK;
}

static wcut_status check_lattice(const wcut_facade_plan *p, wcut_error *error) {
    const bool free = p->lattice == WCUT_FACADE_LATTICE_FREE;
    if ((unsigned)p->lattice > WCUT_FACADE_LATTICE_FREE || (unsigned)p->match > WCUT_FACADE_MATCH_TANGENT)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "facade: unknown lattice or match");
    if (!free && (p->rows < 1 || p->columns < 1 || p->rows > WCUT_FACADE_ELEMENTS_MAX / p->columns))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "lattice: found %d x %d cells, expected 1 to %d in all", p->rows,
                         p->columns, WCUT_FACADE_ELEMENTS_MAX);
    if (!isfinite(p->joint) || p->joint < 0)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "joint: found %g mm, expected 0 or more", p->joint);

    /* what a kind of lattice stands on */
    if (p->lattice == WCUT_FACADE_LATTICE_CYLINDER && !isfinite(p->radius))
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "lattice: the radius is not a number");
    if (p->lattice == WCUT_FACADE_LATTICE_SURFACE && !p->surface)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "lattice: the surface is missing");
    if (p->match == WCUT_FACADE_MATCH_TANGENT && (p->heights == 0 || !is_positive(p->match_move)))
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "match: tangent needs edges that fields drive, and a positive length to move them by");
    return WCUT_OK;
}

static wcut_status check_facade_plan(const wcut_facade_plan *p, wcut_error *error) {
    wcut_status status = check_lattice(p, error);
    if (status != WCUT_OK) return status;
    if (p->placements < 1 || p->placements > WCUT_FACADE_ELEMENTS_MAX || !p->placement)
        return wcut_fail(error, WCUT_BAD_ARGUMENT, "facade: found %d elements, expected 1 to %d", p->placements,
                         WCUT_FACADE_ELEMENTS_MAX);
    if (p->jobs < 1 || !p->job) return wcut_fail(error, WCUT_BAD_ARGUMENT, "facade: expected a job");
    for (int k = 0; k < p->jobs; k++) {
        const wcut_job *j = p->job[k];
        if (!j || !is_positive(j->block_size.x) || !is_positive(j->block_size.y) || !is_positive(j->block_size.z))
            return wcut_fail(error, WCUT_BAD_ARGUMENT, "job %d: expected a block of positive size", k);
    }

    /* every placement names what is there */
    for (int k = 0; k < p->placements; k++) {
        const wcut_facade_placement *e = &p->placement[k];
        if (e->turn < 0 || e->turn > 3 || e->job < 0 || e->job >= p->jobs)
            return wcut_fail(error, WCUT_BAD_ARGUMENT,
                             "element %d: found %d quarter turns and job %d, expected 0 to 3 "
                             "and 0 to %d",
                             k, e->turn, e->job, p->jobs - 1);
        if (p->lattice == WCUT_FACADE_LATTICE_FREE ||
            (e->row >= 0 && e->row < p->rows && e->column >= 0 && e->column < p->columns))
            continue;
        return wcut_fail(error, WCUT_BAD_ARGUMENT,
                         "element %d: found row %d, column %d, expected rows 0 to %d and columns 0 to %d", k, e->row,
                         e->column, p->rows - 1, p->columns - 1);
    }
    return check_fields(p, error);
}

/* ---- elements in their places ---- */

static void set_frame(wcut_facade_element *e, const wcut_cell *cell) {
    const wcut_cell c = wcut_cell_turn(cell, e->job->block_size, e->turn, e->mirrored);
    e->origin = c.origin, e->x = c.x, e->y = c.y, e->z = c.z;
}

static wcut_status place_free(const wcut_layout *l, int k) {
    const wcut_facade_placement *p = &l->plan->placement[k];
    wcut_facade_element *e = &l->facade->element[k];
    const bool axes = vec3_is_finite(p->origin) && vec3_is_finite(p->x) && vec3_is_finite(p->y) &&
                      fabs(vec3_length(p->x) - 1) <= AXES_HELD && fabs(vec3_length(p->y) - 1) <= AXES_HELD &&
                      fabs(vec3_dot(p->x, p->y)) <= AXES_HELD;
    if (!axes)
        return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                         "element %d: expected a finite origin and two axes of length 1 that are perpendicular", k);
    const wcut_vec3 x = vec3_unit(p->x), z = vec3_unit(vec3_cross(x, p->y));
    const wcut_cell cell = {p->origin, x, vec3_cross(z, x), z};
    set_frame(e, &cell);
    return WCUT_OK;
}

/* no two free elements in one place: middles nearer than a third of the smaller block */
static wcut_status check_free(const wcut_layout *l) {
    char one[WCUT_LAYOUT_WORDS], two[WCUT_LAYOUT_WORDS];
    const wcut_facade *f = l->facade;
    for (int i = 0; i < f->elements; i++)
        for (int k = 0; k < i; k++) {
            const wcut_vec3 a = f->element[i].job->block_size, b = f->element[k].job->block_size;
            const double near = fmin(fmin(a.x, a.y), fmin(b.x, b.y)) / 3;
            const wcut_vec3 at = wcut_element_point(&f->element[i], vec3_scale(0.5, a));
            if (vec3_distance(at, wcut_element_point(&f->element[k], vec3_scale(0.5, b))) > near) continue;
            return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                             "%s and %s claim one place, near (%.6g, %.6g, %.6g) mm; expected one element there",
                             wcut_layout_name(one, f, k), wcut_layout_name(two, f, i), at.x, at.y, at.z);
        }
    return WCUT_OK;
}

/* an element in its cell, which is free until then and as large as the turned block */
static wcut_status place_in_cell(const wcut_layout *l, int k, const wcut_cell *cell) {
    wcut_facade_element *e = &l->facade->element[k];
    int *at = &l->at[(size_t)e->row * (size_t)l->plan->columns + (size_t)e->column];
    if (*at >= 0)
        return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                         "elements %d and %d claim the cell in row %d, column %d; expected one element in it", *at, k,
                         e->row, e->column);
    *at = k;
    const wcut_vec3 b = e->job->block_size;
    const double wide = e->turn % 2 ? b.y : b.x, deep = e->turn % 2 ? b.x : b.y;
    if (wide != l->size.x || deep != l->size.y || b.z != l->size.z)
        return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                         "element %d (row %d, column %d): its block%s is %.6g x %.6g x %.6g mm, expected that of its "
                         "cell, %.6g x %.6g x %.6g mm",
                         k, e->row, e->column, e->turn % 2 ? ", turned," : "", wide, deep, b.z, l->size.x, l->size.y,
                         l->size.z);
    set_frame(e, &cell[(size_t)e->row * (size_t)l->plan->columns + (size_t)e->column]);
    return WCUT_OK;
}

static wcut_status place_elements(wcut_layout *l) {
    const wcut_facade_plan *p = l->plan;
    const size_t cells = l->at ? (size_t)p->rows * (size_t)p->columns : 1;
    wcut_cell *cell = wcut_alloc(cells, sizeof *cell);
    if (!cell) return WCUT_NO_MEMORY;
    wcut_status status = l->at ? wcut_lattice_fill(p, l->size, cell, l->error) : WCUT_OK;
    for (size_t k = 0; l->at && k < cells; k++) l->at[k] = -1;

    /* each with its own copy of the job */
    for (int k = 0; k < p->placements && status == WCUT_OK; k++) {
        const wcut_facade_placement *from = &p->placement[k];
        wcut_facade_element *e = &l->facade->element[k];
        *e = (wcut_facade_element){.row = from->row,
                                   .column = from->column,
                                   .turn = from->turn,
                                   .mirrored = from->mirrored,
                                   .joint = {-1, -1, -1, -1}};
        e->job = wcut_job_copy(p->job[from->job]);
        if (!e->job) status = WCUT_NO_MEMORY;
        if (status == WCUT_OK) status = l->at ? place_in_cell(l, k, cell) : place_free(l, k);
    }
    if (status == WCUT_OK && !l->at) status = check_free(l);
    wcut_free(cell);
    return status;
}

/* ---- how far both edges of a joint are apart ---- */

static void measure_openings(wcut_facade *f) {
    for (int j = 0; j < f->joints; j++) {
        wcut_facade_joint *joint = &f->joint[j];
        joint->opening_min = INFINITY, joint->opening_max = 0;
        for (int k = 0; k < WCUT_FACADE_SAMPLES; k++) {
            wcut_vec3 at[2];
            for (int side = 0; side < 2; side++) {
                const wcut_facade_element *e = &f->element[joint->element[side]];
                const int b = joint->border[side], i = side && joint->reversed ? WCUT_FACADE_SAMPLES - 1 - k : k;
                const double height = e->border[b] ? e->border[b][i] : e->job->block_size.z / 2;
                at[side] = wcut_element_point(e, wcut_border_point(e->job->block_size, b, i, height));
            }
            const double apart = vec3_distance(at[0], at[1]);
            joint->opening_min = fmin(joint->opening_min, apart);
            joint->opening_max = fmax(joint->opening_max, apart);
        }
    }
}

/* ---- for the caller ---- */

wcut_status wcut_facade_create(const wcut_facade_plan *plan, wcut_facade **facade, wcut_error *error) {
    if (!plan || !facade) return wcut_fail(error, WCUT_BAD_ARGUMENT, "%s", wcut_status_text(WCUT_BAD_ARGUMENT));
    wcut_status status = check_facade_plan(plan, error);
    if (status != WCUT_OK) return status;

    /* cells are as large as the first block where it lies unturned */
    const wcut_vec3 block = plan->job[plan->placement[0].job]->block_size;
    const bool free = plan->lattice == WCUT_FACADE_LATTICE_FREE, aside = plan->placement[0].turn % 2;
    wcut_layout l = {.plan = plan, .error = error};
    l.size = aside ? vec3(block.y, block.x, block.z) : block;
    l.pitch[0] = l.size.x + plan->joint, l.pitch[1] = l.size.y + plan->joint;
    l.total[0] = plan->columns * l.pitch[0], l.total[1] = plan->rows * l.pitch[1];

    /* room for all of it: an element has four borders, and a joint two */
    wcut_error said = {.text = ""};
    l.error = &said;
    l.facade = wcut_alloc(1, sizeof *l.facade);
    if (l.facade) {
        l.facade->element = wcut_alloc((size_t)plan->placements, sizeof *l.facade->element);
        l.facade->joint = wcut_alloc(2 * (size_t)plan->placements, sizeof *l.facade->joint);
        l.facade->match = plan->match;
    }
    if (!free) l.at = wcut_alloc((size_t)plan->rows * (size_t)plan->columns, sizeof *l.at);
    const bool room = l.facade && l.facade->element && l.facade->joint && (free || l.at);
    status = room ? WCUT_OK : WCUT_NO_MEMORY;
    if (room) {
        l.facade->elements = plan->placements;
        l.facade->rows = free ? 0 : plan->rows, l.facade->columns = free ? 0 : plan->columns;
    }

    /* places, neighbours, edges */
    if (status == WCUT_OK) status = place_elements(&l);
    if (status == WCUT_OK) status = wcut_layout_joints(&l);
    if (status == WCUT_OK) status = wcut_layout_edges(&l);
    wcut_free(l.at);
    if (status == WCUT_OK) {
        measure_openings(l.facade);
        *facade = l.facade;
        return WCUT_OK;
    }

    /* whatever failed has said so, or it was memory */
    wcut_facade_destroy(l.facade);
    return wcut_fail(error, status, "%s", said.text[0] ? said.text : wcut_status_text(status));
}

void wcut_facade_destroy(wcut_facade *facade) {
    if (!facade) return;
    for (int k = 0; facade->element && k < facade->elements; k++) {
        wcut_job_destroy(facade->element[k].job);
        for (int b = 0; b < 4; b++) wcut_free(facade->element[k].border[b]);
    }
    wcut_free(facade->element);
    wcut_free(facade->joint);
    wcut_free(facade);
}
