/* Which borders of which elements meet: by the cells of a lattice, or by where free placements are. */
#include <stdlib.h>

#include "base/alloc.h"
#include "base/fail.h"
#include "base/vec3.h"
#include "facade/layout.h"

/* borders of free placements meet where their ends are no further apart than the joint and this [mm] */
#define NEAR 0.5

/* the border of an element that lies on a side of its cell */
static int border_on_side(const wcut_facade_element *e, int side, bool *reversed) {
    for (int b = 0; b < 4; b++)
        if (wcut_cell_side(e->turn, e->mirrored, b, reversed) == side) return b;
    return -1;
}

static void add_joint(wcut_facade *f, int first, int first_border, int second, int second_border, bool reversed) {
    if (second < first) { /* the lower number first */
        const int element = first, border = first_border;
        first = second, first_border = second_border;
        second = element, second_border = border;
    }
    f->element[first].joint[first_border] = f->element[second].joint[second_border] = f->joints;
    f->joint[f->joints++] = (wcut_facade_joint){{first, second}, {first_border, second_border}, reversed, 0, 0};
}

/* ---- lattice ---- */

static void join_cells(wcut_facade *f, int low, int high, int side) {
    bool low_reversed, high_reversed;
    if (low < 0 || high < 0) return;
    const int a = border_on_side(&f->element[low], side, &low_reversed);
    const int b = border_on_side(&f->element[high], side - 1, &high_reversed);
    add_joint(f, low, a, high, b, low_reversed != high_reversed);
}

static void join_lattice(const wcut_layout *l) {
    const int rows = l->plan->rows, columns = l->plan->columns;
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < columns; c++) {
            const int *here = l->at + (size_t)r * (size_t)columns + c;
            if (c + 1 < columns) join_cells(l->facade, here[0], here[1], 1);
            if (r + 1 < rows) join_cells(l->facade, here[0], here[columns], 3);
        }
}

/* ---- free ---- */

/* a border at half the block's height, where a turned over block has it too */
typedef struct free_side {
    int element, border;
    wcut_vec3 end[2], middle;
} free_side;

static int by_middle(const void *a, const void *b) {
    const free_side *s = a, *t = b;
    if (s->middle.x != t->middle.x) return s->middle.x < t->middle.x ? -1 : 1;
    return s->element != t->element ? s->element - t->element : s->border - t->border;
}

static bool sides_meet(const free_side *a, const free_side *b, double near, bool *reversed) {
    const bool same = vec3_distance(a->end[0], b->end[0]) <= near && vec3_distance(a->end[1], b->end[1]) <= near;
    *reversed = !same;
    return same || (vec3_distance(a->end[0], b->end[1]) <= near && vec3_distance(a->end[1], b->end[0]) <= near);
}

/* two sides that meet and have met none before; a third is refused with all three */
static wcut_status join_pair(const wcut_layout *l, const free_side *a, const free_side *b, bool reversed) {
    char one[WCUT_LAYOUT_WORDS], two[WCUT_LAYOUT_WORDS], three[WCUT_LAYOUT_WORDS];
    wcut_facade *f = l->facade;
    const int taken_a = f->element[a->element].joint[a->border], taken_b = f->element[b->element].joint[b->border];
    if (taken_a < 0 && taken_b < 0) {
        add_joint(f, a->element, a->border, b->element, b->border, reversed);
        return WCUT_OK;
    }

    /* the joint that is there, and who comes third */
    const wcut_facade_joint *j = &f->joint[taken_a >= 0 ? taken_a : taken_b];
    const int third = j->element[0] == a->element || j->element[1] == a->element ? b->element : a->element;
    return wcut_fail(l->error, WCUT_BAD_ARGUMENT,
                     "the edge near (%.6g, %.6g, %.6g) mm is shared by %s, %s and %s; expected two elements at most",
                     a->middle.x, a->middle.y, a->middle.z, wcut_layout_name(one, f, j->element[0]),
                     wcut_layout_name(two, f, j->element[1]), wcut_layout_name(three, f, third));
}

static wcut_status join_free(const wcut_layout *l) {
    const wcut_facade *f = l->facade;
    const int count = 4 * f->elements;
    free_side *side = wcut_alloc((size_t)count, sizeof *side);
    if (!side) return WCUT_NO_MEMORY;

    /* all borders, in the order of their middles' x */
    for (int k = 0; k < count; k++) {
        const wcut_facade_element *e = &f->element[k / 4];
        const wcut_vec3 block = e->job->block_size;
        free_side *s = &side[k];
        *s = (free_side){.element = k / 4, .border = k % 4};
        for (int end = 0; end < 2; end++)
            s->end[end] =
                wcut_element_point(e, wcut_border_point(block, k % 4, end * (WCUT_FACADE_SAMPLES - 1), block.z / 2));
        s->middle = vec3_mix(s->end[0], s->end[1], 0.5);
    }
    qsort(side, (size_t)count, sizeof *side, by_middle);

    /* each with those that are near in x */
    const double near = l->plan->joint + NEAR;
    wcut_status status = WCUT_OK;
    for (int i = 0; i < count && status == WCUT_OK; i++)
        for (int k = i + 1; k < count && side[k].middle.x - side[i].middle.x <= near && status == WCUT_OK; k++) {
            bool reversed;
            if (side[i].element != side[k].element && sides_meet(&side[i], &side[k], near, &reversed))
                status = join_pair(l, &side[i], &side[k], reversed);
        }
    wcut_free(side);
    return status;
}

wcut_status wcut_layout_joints(wcut_layout *layout) {
    if (!layout->at) return join_free(layout);
    join_lattice(layout);
    return WCUT_OK;
}
