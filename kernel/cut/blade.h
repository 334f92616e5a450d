/* A blade's stations: straight between its mounts, whatever loads it. */
#ifndef WCUT_CUT_BLADE_H
#define WCUT_CUT_BLADE_H

#include "cut/run.h"

/* station 0: on the straight line between the mounts, without load */
void wcut_blade_begin(wcut_cut *cut);

/* Advance cut->next, which is a copy of cut->now, to a target with a duration; it is added to *elapsed. The foam's force on
   a node is law times engaged length, against the advance across the edge: sliding along the edge changes nothing but by
   slice_softening, and has a force of its own by tangential_drag. WCUT_OK; WCUT_BAD_ARGUMENT (no duration). */
wcut_status wcut_blade_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error);

/* what a mount carries of the foam's force on all nodes, by the lever (Archimedes): share 0 at B, 1 at A [N] */
double wcut_blade_reaction(int n, const wcut_vec3 *force, bool at_a);

#endif
