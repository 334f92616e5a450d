/* What closes a solid below or above: the cut face or a flat face with keys, as triangles with a border by index. */
#ifndef WCUT_SOLID_CAP_H
#define WCUT_SOLID_CAP_H

#include <wirecut/mould.h>

#include "solid/trim.h"

/* The borders run along y at x low (0) and x high (1), along x at y low (2) and y high (3); they share the corners. */
typedef struct wcut_cap {
    int vertex_count, triangle_count;
    wcut_vec3 *vertex; /* on the borders exactly in the sides' planes */
    int *triangle;     /* counter-clockwise seen from above, where the cap does not overhang */
    int border_count[4];
    int *border[4]; /* border_count vertices each, from low to high */
} wcut_cap;

/* The triangles of a cut face; *chord_error: [mm] measured. Statuses of wcut_surface_tessellate: nothing was written. */
wcut_status wcut_cap_tessellate(const wcut_surface *patch, wcut_sides sides, double chord_tolerance, wcut_cap *cap,
                                double *chord_error);

/* Room for a cap. WCUT_NO_MEMORY: it is zeroed. */
wcut_status wcut_cap_create(int vertices, int triangles, const int borders[4], wcut_cap *cap);

/* free what a cap holds; a zeroed cap is allowed */
void wcut_cap_clear(wcut_cap *cap);

/* does every vertical line meet the cap once? proven by the exact turn of every triangle seen from above */
int wcut_cap_is_graph(const wcut_cap *cap);

/* A box that stands out of a side x low (0) or x high (1): its own border 1 - side lies in that side, inside it. */
typedef struct wcut_cap_lug {
    int side;
    wcut_cap floor, ceiling; /* their borders have two vertices */
} wcut_cap_lug;

/* The solid between two caps over the same sides; they do not touch. The ceiling's triangles come first, then the
   floor's, then those of the sides, then those of the lugs, which do not meet. WCUT_DEGENERATE (borders that cross),
   WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_cap_enclose(const wcut_cap *floor, const wcut_cap *ceiling, int lugs, const wcut_cap_lug *lug,
                             wcut_mesh **mesh);

#endif
