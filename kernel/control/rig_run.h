/* A closed-loop run while it grows, and what it amounts to. */
#ifndef WCUT_CONTROL_RIG_RUN_H
#define WCUT_CONTROL_RIG_RUN_H

#include <stdbool.h>
#include <wirecut/rig.h>

/* room for one more sample in every array; false: no memory */
bool wcut_rig_run_grow(wcut_rig_run *run);

/* the figures of the steady phase and of the part beyond the density step */
void wcut_rig_run_finish(wcut_rig_run *run);

#endif
