/* The volume that closed triangles hold. */
#ifndef WCUT_SURFACE_MESH_VOLUME_H
#define WCUT_SURFACE_MESH_VOLUME_H

#include <wirecut/mesh.h>

/* [mm3] inside closed triangles, wound counter-clockwise seen from outside; negative where they are wound the other way */
double wcut_mesh_volume(const wcut_mesh *mesh);

#endif
