/* The zero set of a surface's height over a plane, in pieces that each cross one cell. */
#ifndef WCUT_SURFACE_CONTOUR_H
#define WCUT_SURFACE_CONTOUR_H

#include <stdbool.h>
#include <wirecut/surface.h>

/* where a piece ends: on a line of constant u or v */
typedef struct wcut_contour_end {
    bool on_v;   /* the line is v = line, else u = line */
    int side;    /* -1: the piece's cell lies below the line, 1: above */
    double line; /* as exact a number for the cells on both sides */
    double u, v;
} wcut_contour_end;

/* points first .. first + count - 1 of the contour, from end[0] to end[1] */
typedef struct wcut_contour_piece {
    int first, count;
    wcut_contour_end end[2];
} wcut_contour_piece;

typedef struct wcut_contour {
    int piece_count, piece_room, point_count, point_room;
    wcut_contour_piece *piece;
    double *uv; /* point_count x 2 */
    int touching;
    double touch_u, touch_v;
    double size; /* [mm] of the surface's coordinates */
} wcut_contour;

/* normal . (S - point) = 0, unit normal. Zeros are those of a plane moved by 1e-13 of the size: no contour then runs
   along a line between cells but by an accident of rounding. WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_contour_find(const wcut_surface *surface, wcut_vec3 point, wcut_vec3 normal, double tolerance,
                              wcut_contour *contour);

/* free what it gave; a zeroed contour is allowed */
void wcut_contour_clear(wcut_contour *contour);

#endif
