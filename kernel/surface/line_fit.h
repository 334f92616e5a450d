/* Many functions of one parameter by cubic splines over one knot vector, with few knots. */
#ifndef WCUT_SURFACE_LINE_FIT_H
#define WCUT_SURFACE_LINE_FIT_H

#include <wirecut/status.h>
#include <wirecut/vec3.h>

typedef struct wcut_line_fit {
    int count;          /* control points of each curve */
    double *knots;      /* count + 4 */
    wcut_vec3 *control; /* count x columns */
    double error;       /* [mm] largest distance of a point from its curve at its parameter */
} wcut_line_fit;

/* `columns` curves side by side, point is rows x columns at `rows` rising parameters, at least 4; every point missed by
   no more than `tolerance`, 0 for none at all; the ends kept. WCUT_NO_MEMORY: nothing was written; WCUT_SINGULAR where parameters are so
   unequal that they cannot be interpolated. */
wcut_status wcut_line_fit_points(int rows, const double *parameter, int columns, const wcut_vec3 *point,
                                 double tolerance, wcut_line_fit *fit);

/* free what it gave; a zeroed fit is allowed */
void wcut_line_fit_clear(wcut_line_fit *fit);

#endif
