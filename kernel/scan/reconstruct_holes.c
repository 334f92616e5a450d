/* Connected parts of a face that were not scanned: cells flooded from each that no earlier flood has reached. */
#include "scan/reconstruct_holes.h"

#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/vec3.h"

typedef struct flood {
    const wcut_lattice *lattice;
    const double *open_area;
    const unsigned char *outside;
    unsigned char *seen; /* cells */
    int *stack;          /* cells */
    int depth;
} flood;

/* step onto a cell; 1 where the face or the block ends there */
static int visit(flood *f, int i, int j) {
    const int columns = f->lattice->columns;
    if (i < 0 || j < 0 || i >= columns - 1 || j >= f->lattice->rows - 1) return 1;
    const int cell = j * columns + i;
    if (!f->seen[cell] && f->open_area[cell] > 0) {
        f->seen[cell] = 1;
        f->stack[f->depth++] = cell;
    }
    return f->outside[cell];
}

static wcut_vec3 reconstruct_holes_middle(const wcut_lattice *l, int cell) {
    const wcut_vec3 *p = l->point + cell;
    return vec3_scale(0.25, vec3_add(vec3_add(p[0], p[1]), vec3_add(p[l->columns], p[l->columns + 1])));
}

/* everything that hangs together with a cell */
static wcut_hole reconstruct_holes_fill(flood *f, int cell) {
    const int columns = f->lattice->columns;
    wcut_hole h = {0, {0, 0, 0}, 0};
    f->depth = 0;
    h.open = visit(f, cell % columns, cell / columns);
    while (f->depth > 0) {
        const int at = f->stack[--f->depth], i = at % columns, j = at / columns;
        h.area += f->open_area[at];
        h.centre = vec3_add_scaled(h.centre, f->open_area[at], reconstruct_holes_middle(f->lattice, at));
        h.open |= visit(f, i - 1, j) | visit(f, i + 1, j) | visit(f, i, j - 1) | visit(f, i, j + 1);
    }
    h.centre = vec3_scale(1 / h.area, h.centre);
    return h;
}

static int reconstruct_holes_compare(double a, double b) { return (a > b) - (a < b); }

/* by area, the largest first; equal ones by their place */
static int by_area(const void *a, const void *b) {
    const wcut_hole *x = a, *y = b;
    const int area = reconstruct_holes_compare(y->area, x->area),
              row = reconstruct_holes_compare(x->centre.y, y->centre.y);
    return area ? area : row ? row : reconstruct_holes_compare(x->centre.x, y->centre.x);
}

/* how many holes are large enough; written where there is room for them */
static int reconstruct_holes_collect(flood *f, double min, wcut_hole *hole) {
    const int nodes = lattice_nodes(f->lattice);
    int count = 0;
    memset(f->seen, 0, (size_t)nodes);
    for (int cell = 0; cell < nodes; cell++) {
        if (f->seen[cell] || !(f->open_area[cell] > 0)) continue;
        const wcut_hole h = reconstruct_holes_fill(f, cell);
        if (h.area < min) continue;
        if (hole) hole[count] = h;
        count++;
    }
    return count;
}

wcut_status wcut_holes_find(const wcut_lattice *lattice, const double *open_area, const unsigned char *outside,
                            double min, int *count, wcut_hole **hole) {
    const size_t nodes = (size_t)lattice_nodes(lattice);

    /* count the holes first, so that the second pass has room for all */
    flood f = {lattice, open_area, outside, wcut_alloc(nodes, 1), wcut_alloc(nodes, sizeof *f.stack), 0};
    wcut_hole *h = NULL;
    int found = 0;
    if (f.seen && f.stack) {
        found = reconstruct_holes_collect(&f, min, NULL);
        h = wcut_alloc((size_t)found, sizeof *h);
        if (h) {
            reconstruct_holes_collect(&f, min, h);
            qsort(h, (size_t)found, sizeof *h, by_area);
        }
    }
    wcut_free(f.seen);
    wcut_free(f.stack);

    if (!h) return WCUT_NO_MEMORY;
    *count = found;
    *hole = h;

    return WCUT_OK;
}
