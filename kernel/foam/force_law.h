/* The force law with its slope, for the solver. */
#ifndef WCUT_FOAM_FORCE_LAW_H
#define WCUT_FOAM_FORCE_LAW_H

#include <math.h>
#include <wirecut/force_law.h>

/* the one factor of 1000: speeds are in mm/s, Q_eff in J/m^2 */
#define MM_PER_M 1000.0

/* F [N/mm] of (2) and its slope dF/dv [N s/mm^2]; both 0 at rest, where the wire melts its way without force */
static inline double force_law_slope(const wcut_force_law *law, double heat, double speed, double *slope) {
    *slope = 0;
    if (!(speed > 0)) return 0;
    const double exponent = law->b * heat * MM_PER_M / speed;
    if (exponent > 700) return 0; /* below the smallest double, and so is everything made of it */
    const double force = law->a * exp(-exponent);
    *slope = force * exponent / speed;
    return force;
}

#endif
