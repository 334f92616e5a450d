/* Angles as users see them. */
#ifndef WCUT_BASE_DEGREES_H
#define WCUT_BASE_DEGREES_H

#include <math.h>

/* [deg] an angle in rad as it was typed in degrees: 3, not the 3.0000000000000004 of its way through radians */
static inline double typed_degrees(double angle) {
    const double fine = 1e12;
    return round(angle * (180 / 3.14159265358979323846) * fine) / fine;
}

#endif
