/* The readers of the mesh formats: each reads a source from its first byte to its end into a growing mesh. */
#ifndef WCUT_IO_MESH_MESH_FORMATS_H
#define WCUT_IO_MESH_MESH_FORMATS_H

#include <wirecut/cloud_file.h>
#include "io/mesh/mesh_builder.h"

/* false: refused, the source holds the failure */
typedef bool wcut_mesh_fill(wcut_source *source, wcut_mesh_builder *builder);
wcut_mesh_fill wcut_mesh_fill_stl, wcut_mesh_fill_ply, wcut_mesh_fill_obj, wcut_mesh_fill_off;

/* the formats that assimp reads, `ending` being the one that chooses its importer; in at most `seconds` */
bool wcut_mesh_fill_foreign(wcut_source *source, wcut_mesh_builder *builder, const char *ending, int seconds);

/* only their vertices, those of one place and normal once, at most `max`: count x 3 in the file's unit but for the axes,
   which are block's, to free() */
bool wcut_mesh_vertices_foreign(wcut_source *source, const char *ending, int max, int seconds, double **position,
                                int *count);

/* bytes in memory through a small window; for tests and fuzzers */
wcut_status wcut_mesh_read_memory(const void *bytes, size_t size, size_t window, const char *label,
                                  const wcut_mesh_read_options *options, wcut_mesh **mesh, wcut_mesh_read_info *info,
                                  wcut_error *error);

#endif
