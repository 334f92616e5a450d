/* A facade in the making: what its parts share while elements, joints and edges are laid out. */
#ifndef WCUT_FACADE_LAYOUT_H
#define WCUT_FACADE_LAYOUT_H

#include "facade/lattice.h"

/* steps of heights [mm]: sums and differences of such numbers are exact */
#define WCUT_FACADE_STEP 0x1p-20

/* edges of neighbours from jobs are the same within [mm] */
#define WCUT_FACADE_SAME 1e-6

typedef struct wcut_layout {
    const wcut_facade_plan *plan;
    wcut_facade *facade;
    wcut_vec3 size;  /* [mm] of a block that is not turned, in a lattice */
    double pitch[2]; /* [mm] of cells: block and joint */
    double total[2]; /* [mm] of the facade, along u and v */
    int *at;         /* rows x columns: the element of a cell, -1: none; NULL: free */
    wcut_error *error;
} wcut_layout;

/* joints.c: which borders meet */
wcut_status wcut_layout_joints(wcut_layout *layout);

/* edges.c: heights of the borders and each element's job */
wcut_status wcut_layout_edges(wcut_layout *layout);

/* "element 3 (row 0, column 3)" */
enum { WCUT_LAYOUT_WORDS = 64 };
const char *wcut_layout_name(char text[WCUT_LAYOUT_WORDS], const wcut_facade *facade, int element);

/* a point of an element's block in the facade's frame */
wcut_vec3 wcut_element_point(const wcut_facade_element *element, wcut_vec3 p);

/* sample k of a border, at a height, in the block's frame */
wcut_vec3 wcut_border_point(wcut_vec3 block, int border, int k, double height);

/* match.c: heights of all lines at one place along them, moved so that kinks between them get smaller by the weight:
   least squares of moves and second differences; count values in place. WCUT_NO_MEMORY: as they were. */
wcut_status wcut_match_smooth(int count, double weight, double *height);

#endif
