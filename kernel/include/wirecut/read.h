/* wirecut/read.h - meshes and curves from files: stock, targets, edges, paths. Strict, bounded, in millimetres. */
#ifndef WCUT_READ_H
#define WCUT_READ_H

#include <stddef.h>
#include <wirecut/cloud.h>
#include <wirecut/cloud_file.h>
#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/trimmed.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a mesh is stored. */
typedef enum wcut_mesh_format {
    WCUT_MESH_FORMAT_ANY,  /**< told by the file's first bytes, or by its name's ending */
    WCUT_MESH_FORMAT_STL,  /**< binary or ASCII */
    WCUT_MESH_FORMAT_PLY,  /**< ascii, binary of either byte order; an element face with vertex_indices */
    WCUT_MESH_FORMAT_OBJ,  /**< polygons of v and f; free-form geometry is refused */
    WCUT_MESH_FORMAT_OFF,  /**< by assimp, in a process of its own; single precision */
    WCUT_MESH_FORMAT_GLTF, /**< .glb, or .gltf with its data inside; in metres and y up, as glTF demands, whatever
                         options->unit says; by assimp, in a process of its own; single precision */
    WCUT_MESH_FORMAT_COUNT
} wcut_mesh_format;

/** How a mesh is read. */
typedef struct wcut_mesh_read_options {
    wcut_mesh_format format; /**< default WCUT_MESH_FORMAT_ANY */
    wcut_length_unit unit;   /**< of the file's numbers; default WCUT_LENGTH_UNIT_MM */
    int max_triangles;       /**< more triangles are refused, 1 .. INT_MAX / 3; default 20000000 */
    int seconds;             /**< for the process of its own, 1 .. 3600; default 60 */
} wcut_mesh_read_options;

/** What was read. */
typedef struct wcut_mesh_read_info {
    wcut_mesh_format format; /**< as found, never WCUT_MESH_FORMAT_ANY */
    int collapsed;           /**< triangles left out because two corners coincide; they have no area */
    int split;               /**< polygons of more than three corners that became triangles */
    wcut_vec3 low, high;     /**< [mm] the box of the vertices */
} wcut_mesh_read_info;

/** The defaults stated at the fields. */
WCUT_API wcut_mesh_read_options wcut_mesh_read_options_default(void);

/**
 * Read a mesh into memory: positions and triangles, wound as in the file. Corners with equal coordinates are one
 * vertex, whatever the file's indices say, so that what is closed in space is closed by index; vertices stand in the
 * order in which they first occur. Normals, colours and texture coordinates are not read. The sizes that the file
 * states are checked against its length before memory is allocated.
 *
 * @param[in]  path    a file
 * @param[in]  options NULL for the defaults
 * @param[out] mesh    the caller's, to wcut_mesh_destroy
 * @param[out] info    may be NULL
 * @param[out] error   may be NULL; line or byte, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (no mesh in a known format, malformed,
 *         truncated, more behind its end, a coordinate not finite or beyond 1e12 mm, an index outside the vertices, a
 *         polygon of more than 1024 corners, no triangle, more than options->max_triangles; of the formats that assimp
 *         reads: it failed, crashed, took more than 4 GiB or its time), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_mesh_read(const char *path, const wcut_mesh_read_options *options, wcut_mesh **mesh,
                                    wcut_mesh_read_info *info, wcut_error *error);

/** How curves are stored. */
typedef enum wcut_curve_format {
    WCUT_CURVE_FORMAT_ANY,  /**< told by the file's first bytes, or by its name's ending */
    WCUT_CURVE_FORMAT_STEP, /**< ISO 10303-21 with the curves of part 42, in the unit that the file states */
    WCUT_CURVE_FORMAT_IGES, /**< 5.3 and before: types 126, 110 and 106 forms 2, 12, in the unit that the file states */
    WCUT_CURVE_FORMAT_JSON, /**< curves as in a job's edges, or lists of points, in lists or under names; GeoJSON lines */
    WCUT_CURVE_FORMAT_CSV, /**< a table of points, one a row; kernel/FORMATS.md says what tells its curves apart */
    WCUT_CURVE_FORMAT_COUNT
} wcut_curve_format;

/** How curves are read. */
typedef struct wcut_curve_read_options {
    wcut_curve_format format; /**< default WCUT_CURVE_FORMAT_ANY */
    int interpolate;          /**< tables: 1 a cubic through the points (default), 0 straight pieces between them */
    int max_curves;           /**< more curves are refused, 1 or more; default 10000 */
} wcut_curve_read_options;

/** Curves of a file. */
typedef struct wcut_curve_set {
    wcut_curve_format format; /**< as found */
    int count;                /**< 1 or more */
    wcut_curve **curve;       /**< count [mm] */
    char **name;              /**< count, "" where the file has none */
    int left_out;             /**< curves in the file that were not read */
    char why[240];            /**< their kinds or the reasons, comma-separated; "" where there are none */
} wcut_curve_set;

/** The defaults stated at the fields. */
WCUT_API wcut_curve_read_options wcut_curve_read_options_default(void);

/**
 * Read the curves of a file: edges or paths for a design.
 *
 * STEP: the curves of geometric sets, in their order; where there are none, the edges of faces and solids. B-splines,
 * rational or not, come back as they are, poles bit for bit where the unit is mm, and cut where the file trims them;
 * polylines and lines become splines of degree 1, arcs of circles and ellipses rational ones of degree 2, composite
 * curves one curve where their segments meet within 1e-3 mm, else the segments. Other curves (parabolas, offsets,
 * degrees above 7) are left out and reported. The parts of an assembly stand where it sets
 * them. IGES: arcs (100), composites (102), ellipses (104), points (106), lines (110), B-splines (126),
 * each moved by its transformation (124), likewise. Pieces of another entity, and curves in a surface's parameters,
 * are left out and reported.
 * JSON and tables: a text that has one reading is read; a text with none or two is refused, with two edges in a form
 * that is read.
 *
 * @param[in]  path    a file
 * @param[in]  options NULL for the defaults
 * @param[out] set     the caller's, to wcut_curve_set_destroy
 * @param[out] error   may be NULL; line, instance or JSON path, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (no curves in a known format,
 *         malformed, truncated, over 256 MB, a number not finite or beyond 1e12 mm, knots or weights that make no
 *         curve, no curve that could be read, more than options->max_curves), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_curve_set_read(const char *path, const wcut_curve_read_options *options, wcut_curve_set **set,
                                         wcut_error *error);

/** Free what wcut_curve_set_read gave; NULL is allowed. */
WCUT_API void wcut_curve_set_destroy(wcut_curve_set *set);

/** Faces of a CAD file. */
typedef struct wcut_trimmed_set {
    wcut_curve_format format; /**< WCUT_CURVE_FORMAT_STEP or WCUT_CURVE_FORMAT_IGES */
    int count;                /**< 1 or more */
    wcut_trimmed **face;      /**< count [mm] */
    char **name;              /**< count, "" where the file has none */
    int left_out;             /**< faces and curves in the file that were not read */
    char why[240];            /**< their kinds or the reasons, comma-separated; "" where there are none */
} wcut_trimmed_set;

/**
 * Read the faces of a CAD file, in the unit that it states, where its assembly sets them.
 *
 * STEP: faces on B-spline surfaces and planes with the edges that bound them; where there are no faces, B-spline
 * surfaces as they are. IGES: B-spline surfaces (128) and trimmed ones (144, 142). Every other kind of surface, and a
 * face whose edges are not on it within 0.01 mm, is left out and reported.
 *
 * @param[in]  path  a file
 * @param[out] set   the caller's, to wcut_trimmed_set_destroy
 * @param[out] error may be NULL; line or instance, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (neither STEP nor IGES, malformed,
 *         truncated, over 256 MB, no face that could be read, more than 10000 faces), WCUT_BAD_ARGUMENT,
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_trimmed_set_read(const char *path, wcut_trimmed_set **set, wcut_error *error);

/**
 * The face that a text names, or numbers from 1.
 *
 * @param[in] set    faces, or NULL
 * @param[in] choice `length` bytes, which hold no zero; or NULL
 * @param[in] length of the text
 * @return its index; -1: none, several of that name, no text, or an argument is NULL.
 */
WCUT_API int wcut_trimmed_set_find(const wcut_trimmed_set *set, const char *choice, size_t length);

/** Free what wcut_trimmed_set_read gave; NULL is allowed. */
WCUT_API void wcut_trimmed_set_destroy(wcut_trimmed_set *set);

#ifdef __cplusplus
}
#endif

#endif
