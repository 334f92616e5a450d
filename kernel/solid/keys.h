/* Registration keys: flat-ended cones that stand out of the face that is not cut, or go into it. */
#ifndef WCUT_SOLID_KEYS_H
#define WCUT_SOLID_KEYS_H

#include "solid/cut_face.h"

/* how much a key raises the face it is on, upwards: cones stand out, pockets go in */
double wcut_key_rise(const wcut_key *key);

/* corners of the polygons that stand for a key's circles */
int wcut_key_arcs(const wcut_key *key, double chord_tolerance);

/* those of one half, for wcut_free; WCUT_NO_MEMORY: nothing was written */
wcut_status wcut_keys_of(const wcut_mould_options *options, int upper, wcut_key **own, int *count);

/* [mm3] of one key, exact for its triangles; negative of a pocket */
double wcut_key_volume(const wcut_key *key, double chord_tolerance);

/* [mm3] that the keys of a half add to it, exact for their triangles; pockets count negative */
double wcut_keys_volume(const wcut_mould_options *options, int upper);

/* Do the keys of a half stay clear of the cut face? WCUT_BAD_ARGUMENT: one reaches it; error says where. */
wcut_status wcut_keys_check(const wcut_division *d, int upper, const wcut_cut_face *face, wcut_error *error);

#endif
