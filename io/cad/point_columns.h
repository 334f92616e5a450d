/* Names of columns in a table of curves: which coordinate of which curve, the unit, what names a curve or counts points. */
#ifndef WCUT_IO_CAD_POINT_COLUMNS_H
#define WCUT_IO_CAD_POINT_COLUMNS_H

#include <stdbool.h>

enum { WCUT_POINT_CELLS_MAX = 200, WCUT_POINT_SETS_MAX = 32, WCUT_POINT_LABEL_SIZE = 32 };

/* a cell of a row, without quotes and outer blanks */
typedef struct wcut_point_cell {
    const char *at;
    int length;
    bool quoted;
} wcut_point_cell;

/* the columns x, y, z of one curve, or of all */
typedef struct wcut_point_set {
    int column[3]; /* -1: none */
    char label
        [WCUT_POINT_LABEL_SIZE]; /* what names the curve in the column's name, in lower case: "a", "1"; "" for none */
} wcut_point_set;

typedef struct wcut_point_columns {
    int columns, sets;
    wcut_point_set set[WCUT_POINT_SETS_MAX];
    int id[2];   /* columns whose text names the curve of a row, -1 for none */
    int index;   /* the column that counts points, -1 for none */
    double unit; /* [mm] of the coordinates; 0: none is stated */
} wcut_point_columns;

/* whether a row of cells names the coordinates x, y and z, each at least once */
bool wcut_point_columns_named(int count, const wcut_point_cell *cell);

/* The columns of a row of names. NULL: found; else what was expected, for a refusal; `odd` is the cell that is not
   understood, or -1. */
const char *wcut_point_columns_find(int count, const wcut_point_cell *cell, wcut_point_columns *columns, int *odd);

/* [mm] the one unit that a row of units ("mm,mm,mm", "[m]") states; 0: it is no such row; -1: several */
double wcut_point_columns_unit(int count, const wcut_point_cell *cell);

/* whether every word of a text is one that names curves: "edge a", "Curve 1:", "left" */
bool wcut_point_label_whole(const char *text, int length);

#endif
