/* Normal and curvature from derivatives that are already there. */
#ifndef WCUT_SURFACE_CURVATURE_H
#define WCUT_SURFACE_CURVATURE_H

#include <wirecut/curvature.h>

#include "base/vec3.h"

/* false where S_u and S_v span no plane: nothing was written */
bool wcut_unit_normal(wcut_vec3 along_u, wcut_vec3 along_v, wcut_vec3 *normal);

/* from nine derivatives as wcut_surface_eval gives them to order 2 */
bool wcut_frame_of(const wcut_vec3 *ders, wcut_tangent_frame *frame);

#endif
