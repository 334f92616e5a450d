/* The frame around both halves. */
#ifndef WCUT_SOLID_FRAME_H
#define WCUT_SOLID_FRAME_H

#include <wirecut/mould.h>

/* Four walls around the block, `clearance` away from its sides and as high as it, as triangles and exactly.
   WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_frame_create(wcut_vec3 block, double wall, double clearance, wcut_mesh **mesh, wcut_brep **brep);

#endif
