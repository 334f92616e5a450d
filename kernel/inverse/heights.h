/* A smooth height z(x, y) through scattered points: what a target looks like from above, with slopes and curvatures. */
#ifndef WCUT_INVERSE_HEIGHTS_H
#define WCUT_INVERSE_HEIGHTS_H

#include <stdbool.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

/* A uniform bicubic B-spline: cell (i, j) of size step_x x step_y has the coefficients i .. i+3, j .. j+3. Beyond its
   rectangle it goes on, bent as at the border at first, then straight. */
typedef struct wcut_heights {
    wcut_vec3 low, high; /* [mm] the rectangle; z unused */
    int cells_x, cells_y;
    double step_x, step_y; /* [mm] */
    double *coefficient;   /* (cells_y + 3) x (cells_x + 3) [mm] */
    double scatter;        /* [mm] 1.4826 times the median distance of the points from it */
} wcut_heights;

/* the height at a place with its derivatives */
typedef struct wcut_height {
    double z, x, y, xx, xy, yy; /* [mm], [1], [1/mm] */
} wcut_height;

/* Least squares with a thin plate's bending as a small penalty, which fills holes and goes on straight beyond the points.
   Cells get smaller until the scatter falls no further. robust: Tukey's weights (Beaton, Tukey 1974) leave out strays.
   count: 10 points or more. WCUT_OK; WCUT_DEGENERATE (the points do not determine a sheet), WCUT_NO_MEMORY: nothing was
   written. */
wcut_status wcut_heights_fit(int count, const wcut_vec3 *point, wcut_vec3 low, wcut_vec3 high, bool robust,
                             wcut_heights *out);
void wcut_heights_clear(wcut_heights *heights);

wcut_height wcut_heights_eval(const wcut_heights *heights, double x, double y);

#endif
