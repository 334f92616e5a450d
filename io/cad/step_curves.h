/* The curves of a STEP file (ISO 10303-42): what both halves of their reader share. */
#ifndef WCUT_IO_CAD_STEP_CURVES_H
#define WCUT_IO_CAD_STEP_CURVES_H

#include "io/cad/part21_read.h"

typedef struct wcut_step_source {
    wcut_p21_file file;
    wcut_curve_reader *reader;
    double length, angle; /* [mm], [rad] of the units in use */
    bool has_several;     /* contexts with different units of length */
} wcut_step_source;

/* The units of the file's first context that has some. false: refused */
bool wcut_step_units(wcut_step_source *source);

/* the same of one context, #context */
bool wcut_step_units_of(wcut_step_source *source, long context);

/* a point [mm], a direction, a placement with its axes across z. false: refused, at #id */
bool wcut_step_point(wcut_step_source *source, long id, wcut_vec3 *point);
bool wcut_step_direction(wcut_step_source *source, long id, wcut_vec3 *direction);
bool wcut_step_placement(wcut_step_source *source, long id, wcut_vec3 *origin, wcut_vec3 *x, wcut_vec3 *y);

/* "#12: ..." as the reader refuses; gives false */
bool wcut_step_refuse(wcut_step_source *source, long id, const char *found);

/* the curve of an edge (EDGE_CURVE) from its first vertex to its second. NULL: refused or left out */
wcut_curve *wcut_step_edge(wcut_step_source *source, long id);

/* knots by their multiplicities into `total` numbers. false: refused */
bool wcut_step_knots(wcut_step_source *source, long id, const char *times, const char *values, int total, double *knot);

/* a B-spline of any kind */
bool wcut_step_is_spline(const char *body);

/* a B-spline, a polyline. NULL: refused, or (degree above what there is) left out */
wcut_curve *wcut_step_read_spline(wcut_step_source *source, long id, const char *body);
wcut_curve *wcut_step_read_polyline(wcut_step_source *source, long id, const char *body);

#endif
