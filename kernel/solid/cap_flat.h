/* A flat face with registration keys. */
#ifndef WCUT_SOLID_CAP_FLAT_H
#define WCUT_SOLID_CAP_FLAT_H

#include "solid/cap.h"

/* A level face between the sides with `count` keys on it, their ends at z + rise; circles within a tolerance.
   WCUT_BAD_ARGUMENT (keys that meet or reach a side), WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_cap_flat(wcut_sides sides, double z, int count, const wcut_key *key, double chord_tolerance,
                          wcut_cap *cap);

#endif
