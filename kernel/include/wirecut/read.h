/* wirecut/read.h - meshes from files: stock, targets, cutters. Strict, bounded, in millimetres. */
#ifndef WCUT_READ_H
#define WCUT_READ_H

#include <wirecut/cloud.h>
#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a mesh is stored. */
typedef enum wcut_mesh_format {
    WCUT_MESH_ANY,  /**< told by the file's first bytes, or by its name's ending */
    WCUT_MESH_STL,  /**< binary or ASCII */
    WCUT_MESH_PLY,  /**< ascii, binary of either byte order; an element face with vertex_indices */
    WCUT_MESH_OBJ,  /**< polygons of v and f; free-form geometry is refused */
    WCUT_MESH_OFF,  /**< by assimp, in a process of its own; single precision */
    WCUT_MESH_GLTF, /**< .glb, or .gltf with its data inside; in metres and y up, as glTF demands, whatever
                         options->unit says; by assimp, in a process of its own; single precision */
    WCUT_MESH_FORMAT_COUNT
} wcut_mesh_format;

/** How a mesh is read. */
typedef struct wcut_mesh_read_options {
    wcut_mesh_format format; /**< default WCUT_MESH_ANY */
    wcut_length_unit unit;   /**< of the file's numbers; default WCUT_UNIT_MM */
    int most;                /**< more triangles are refused, 1 .. INT_MAX / 3; default 20000000 */
    int seconds;             /**< for the process of its own, 1 .. 3600; default 60 */
} wcut_mesh_read_options;

/** What was read. */
typedef struct wcut_mesh_read_info {
    wcut_mesh_format format; /**< as found, never WCUT_MESH_ANY */
    int collapsed;           /**< triangles left out since two corners are in one place: nothing is lost by them */
    int split;               /**< polygons of more than three corners that became triangles */
    wcut_vec3 low, high;     /**< [mm] the box of the vertices */
} wcut_mesh_read_info;

WCUT_API wcut_mesh_read_options wcut_mesh_read_options_default(void);

/**
 * Read a mesh into memory: positions and triangles, wound as in the file. Corners with equal coordinates are one
 * vertex, whatever the file's indices say, so that what is closed in space is closed by index; vertices stand in the
 * order in which they first occur. Normals, colours and texture coordinates are not read. What the file says about its
 * size is held against its length before memory is taken for it.
 *
 * @param[in]  path    a file
 * @param[in]  options NULL for the defaults
 * @param[out] mesh    the caller's, to wcut_mesh_destroy
 * @param[out] info    may be NULL
 * @param[out] error   may be NULL; line or byte, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (no mesh in a known format, malformed,
 *         truncated, more behind its end, a coordinate not finite or beyond 1e12 mm, an index outside the vertices, a
 *         polygon of more than 1024 corners, no triangle, more than options->most; of the formats that assimp reads:
 *         it failed, crashed, took more than 4 GiB or its time), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_mesh_read(const char *path, const wcut_mesh_read_options *options, wcut_mesh **mesh,
                                    wcut_mesh_read_info *info, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
