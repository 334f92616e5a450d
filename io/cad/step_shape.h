/* Curves, surfaces and solids as STEP instances (ISO 10303-42). */
#ifndef WCUT_IO_CAD_STEP_SHAPE_H
#define WCUT_IO_CAD_STEP_SHAPE_H

#include <wirecut/brep.h>
#include <wirecut/exchange.h>

#include "io/cad/part21.h"

/* a B-spline curve or surface, rational where it has weights */
wcut_id wcut_step_curve(wcut_part21 *p, const char *name, const wcut_curve *curve);
wcut_id wcut_step_surface(wcut_part21 *p, const char *name, const wcut_surface *surface);

/* whether the border of a surface is four curves between four corners: clamped, not closed, without a pole */
bool wcut_step_has_border(const wcut_surface *surface);

/* a surface that has a border, as a face in an open shell, in a shell based surface model; plane_context: of pcurves.
   0: no memory */
wcut_id wcut_step_shell(wcut_part21 *p, const char *name, const wcut_surface *surface, wcut_id plane_context);

/* a manifold solid B-rep of a shape, with its colours in the context of space where it has them. 0: no memory */
wcut_id wcut_step_solid(wcut_part21 *p, const wcut_shape *shape, wcut_id plane_context, wcut_id space_context);

#endif
