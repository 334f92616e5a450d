/* Parameters and knots for interpolation, and the sweeps that turn points into control points. */
#ifndef WCUT_SURFACE_INTERPOLATE_H
#define WCUT_SURFACE_INTERPOLATE_H

#include <wirecut/status.h>
#include <wirecut/vec3.h>

/* lengths count-1 [mm], positive -> count parameters over [0, 1]; WCUT_DEGENERATE where two of them coincide */
wcut_status wcut_parameters_from_lengths(int count, const double *length, double *parameter);

/* clamped knots by averaging `degree` neighbouring parameters (de Boor 1978): count + degree + 1 */
void wcut_knots_average(int degree, int count, const double *parameter, double *knots);

/* count points -> control points in place, `rows` curves of them one after the other, one knot vector for all.
   WCUT_SINGULAR, WCUT_NO_MEMORY: the points are as they were. */
wcut_status wcut_interpolate_rows(int degree, int count, const double *knots, const double *parameter, int rows,
                                  wcut_vec3 *point);

/* the same for `columns` curves side by side: point is count x columns */
wcut_status wcut_interpolate_columns(int degree, int count, const double *knots, const double *parameter, int columns,
                                     wcut_vec3 *point);

#endif
