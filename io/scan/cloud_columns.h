/* Which columns of a text table are the coordinates of what was scanned: by their names, or as the caller says. */
#ifndef WCUT_IO_CLOUD_COLUMNS_H
#define WCUT_IO_CLOUD_COLUMNS_H

#include "io/scan/cloud_source.h"

enum { WCUT_CELLS_MAX = 1000 };

/* a cell of a row, without quotes and outer blanks */
typedef struct wcut_cell {
    const char *at;
    int length;
} wcut_cell;

/* Cells of a line that ends at `end`, split at a separator (a blank: at any blanks); a cell in quotes is one, and so is
   a name with its unit in brackets, "X [mm]". Gives how many, at most WCUT_CELLS_MAX + 1. */
int wcut_cells_split(const char *line, const char *end, char separator, wcut_cell cell[WCUT_CELLS_MAX + 1]);

/* where x y z nx ny nz stand, -1 where nowhere, and the unit that the names state */
typedef struct wcut_columns {
    int column[WCUT_FIELDS];
    double unit; /* [mm]; 0: none */
} wcut_columns;

/* The coordinates among named columns. x, y, z are known with or without words such as coordinate, point, a unit; of
   nominal and measured ones those measured are taken. NULL: found; else why they are not known, for a refusal that
   begins "expected". */
const char *wcut_columns_find(int count, const wcut_cell *cell, wcut_columns *columns);

/* The coordinates as an option names them: three or six names of the header or numbers from 1, separated by commas.
   NULL: found; else what was expected. names may be 0. */
const char *wcut_columns_choose(const char *option, int columns, int names, const wcut_cell *cell,
                                wcut_columns *chosen);

/* whether a line says anything of coordinates: one of its words names an axis */
bool wcut_columns_named(int count, const wcut_cell *name);

#endif
