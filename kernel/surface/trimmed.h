/* The loops of a trimmed face, for deviations. */
#ifndef WCUT_SURFACE_TRIMMED_H
#define WCUT_SURFACE_TRIMMED_H

#include <wirecut/trimmed.h>

/* [mm] the distance of a point from the loops where it is below a limit, else the limit */
double wcut_trimmed_border_within(const wcut_trimmed *trimmed, wcut_vec3 point, double limit);

#endif
