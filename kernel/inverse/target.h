/* What a cut is to come near to, in the frame of the block: points on it, and its height from above. */
#ifndef WCUT_INVERSE_TARGET_H
#define WCUT_INVERSE_TARGET_H

#include <wirecut/design.h>

#include "inverse/heights.h"

struct wcut_design_target {
    wcut_vec3 block;      /* [mm] W, L, H */
    int count;            /* points that a cut is held against */
    wcut_vec3 *point;     /* count [mm], inside the block from above */
    bool robust;          /* a cloud: strays are possible */
    double covered;       /* [1] share of the block's plan that the target is over */
    wcut_heights heights; /* beyond the block too, along the tangents */
};

/* The target as another feed sees it: turned about z so that the feed becomes +y. The caller's, to
   wcut_design_target_destroy. */
wcut_status wcut_design_target_turn(const wcut_design_target *target, wcut_design_feed feed, wcut_design_target **out);

/* The part of a target over a window of its block, as a target of a block of its own, whose corner is `low`. WCUT_DEGENERATE:
   fewer than 50 of its points are there; WCUT_NO_MEMORY. */
wcut_status wcut_design_target_window(const wcut_design_target *target, wcut_vec3 low, wcut_vec3 high,
                                      wcut_design_target **out);

/* a place of the block as another feed sees it, and back */
wcut_vec3 wcut_design_turn(wcut_design_feed feed, wcut_vec3 block, wcut_vec3 p);

#endif
