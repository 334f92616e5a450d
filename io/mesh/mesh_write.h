/* What the mesh writers share. */
#ifndef WCUT_IO_MESH_MESH_WRITE_H
#define WCUT_IO_MESH_MESH_WRITE_H

#include <wirecut/mesh.h>

#include "io/file/text.h"

/* finite coordinates, normals and scalars, indices within the mesh, at least one triangle; what is wrong goes into
   error. WCUT_OK; WCUT_BAD_ARGUMENT */
wcut_status wcut_mesh_check(const wcut_mesh *mesh, const char *path, wcut_error *error);

/* write the mesh's text; ask `text->file` nothing, errors stick to it */
typedef void wcut_mesh_put(wcut_text *text, const wcut_mesh *mesh, const void *context);

/* check the mesh, let `put` write it into a new file, and commit that */
wcut_status wcut_mesh_write(const wcut_mesh *mesh, wcut_mesh_put *put, const void *context, const char *path,
                            wcut_error *error);

/* least and greatest value; count at least 1 */
void wcut_range(int count, const double *value, double *min, double *greatest);

#endif
