/* The target of a design as a file: a mesh, a cloud, placed in the block. */
#ifndef APP_DESIGN_TARGET_H
#define APP_DESIGN_TARGET_H

#include <wirecut/wirecut.h>

#include "command.h"

/* Read the target that a call names, in its unit, placed as its option says. Gives an exit code, after a line that says
   why. */
int app_design_target_load(const app_call *call, const char *path, wcut_vec3 block, wcut_design_target **target);

/* a block's size from "W,L,H"; gives an exit code */
int app_design_block(const char *text, wcut_vec3 *block);

#endif
