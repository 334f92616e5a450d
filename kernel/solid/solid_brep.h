/* A half's exact faces from the patch that cuts it, the block and its keys. */
#ifndef WCUT_SOLID_SOLID_BREP_H
#define WCUT_SOLID_SOLID_BREP_H

#include <wirecut/mould.h>

#include "solid/lugs.h"

/* The half below (upper 0) or above (1) a patch over (s, t) whose borders lie in the block's sides; level: z of the
   face that is not cut; keys, lugs: those of this half. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_brep_of_half(const wcut_surface *patch, int upper, double level, int key_count, const wcut_key *key,
                              int lugs, const wcut_lug *lug, wcut_brep **brep);

/* The solid between two patches over the same sides, the ceiling above the floor. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_brep_between(const wcut_surface *floor, const wcut_surface *ceiling, wcut_brep **brep);

/* everything times a factor */
void wcut_brep_scale(wcut_brep *brep, double factor);

/* free a brep; NULL is allowed */
void wcut_brep_destroy(wcut_brep *brep);

#endif
