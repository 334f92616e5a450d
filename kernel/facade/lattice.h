/* The cells of a facade, and how a block lies in its cell.

   A cell has the place of an element before it is turned: corner, directions of columns (x) and rows (y), the outer
   normal (z). Sides of a cell and borders of a block are numbered alike: 0 x low, 1 x high, 2 y low, 3 y high. */
#ifndef WCUT_FACADE_LATTICE_H
#define WCUT_FACADE_LATTICE_H

#include <wirecut/facade.h>

/* a frame in space */
typedef struct wcut_cell {
    wcut_vec3 origin, x, y, z;
} wcut_cell;

/* All cells of a lattice, row by row, for blocks of that size, which they hold before any turn. WCUT_DEGENERATE (the
   surface folds or is too small, the cylinder too narrow), WCUT_NO_MEMORY. */
wcut_status wcut_lattice_fill(const wcut_facade_plan *plan, wcut_vec3 size, wcut_cell *cell, wcut_error *error);

/* where (i, j), shares of the block's width and length, lies in its cell, as shares of the cell's */
void wcut_cell_share(int turn, bool mirrored, double i, double j, double share[2]);

/* which side of the cell a border of the block lies on; *reversed: it runs against the cell's axis */
int wcut_cell_side(int turn, bool mirrored, int border, bool *reversed);

/* the block's frame in its cell */
wcut_cell wcut_cell_turn(const wcut_cell *cell, wcut_vec3 block, int turn, bool mirrored);

#endif
