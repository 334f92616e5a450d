/* The cut face written anew: a bicubic surface over the unit square whose border lies in the block's sides. */
#ifndef WCUT_SOLID_CUT_FACE_FIT_H
#define WCUT_SOLID_CUT_FACE_FIT_H

#include <wirecut/status.h>
#include <wirecut/surface.h>

#include "solid/trim.h"

/* what the fit saw of the sheet on its way */
typedef struct wcut_face_fit {
    wcut_surface *patch;      /* (s, t) -> x = low + s (high - low), y, z; y exactly low at t = 0 and high at t = 1 */
    double fit_error;         /* [mm] largest distance found between patch and sheet */
    double entry, exit, wire; /* [mm] how far the surface was prolonged inside the block: where the cut begins, where it
                                 ends, at the ends of the wire */
    double radius;            /* [mm] least radius of curvature of the wire's surface, INFINITY where flat */
    wcut_vec3 radius_place;
    double width_min, width_max; /* [mm] of the kerf */
} wcut_face_fit;

/* Interpolate the trimmed sheet on a grid of lines that is refined until what lies between them is within a tolerance.
   height: z low and high of the block, inside which a sheet must not be prolonged further than `prolong`.
   WCUT_DEGENERATE (folded, not through), WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: nothing was written, error says where.
   The caller ends it with wcut_surface_destroy(fit->patch). */
wcut_status wcut_face_fit_solve(const wcut_trim *trim, const double height[2], double prolong, double tolerance,
                                wcut_face_fit *fit, wcut_error *error);

#endif
