/* wirecut/exchange.h - exact geometry to CAD files, meshes as named parts: whole or not at all, in millimetres. */
#ifndef WCUT_EXCHANGE_H
#define WCUT_EXCHANGE_H

#include <wirecut/brep.h>
#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A named piece of geometry: exactly one of solid, surface and curve. All borrowed. */
typedef struct wcut_shape {
    const char *name; /**< UTF-8, as CAD programs show it */
    const wcut_brep *solid;
    const wcut_surface *surface;
    const wcut_curve *curve;
    int coloured;        /**< 1: a solid whose faces have the colours below and the names of their parts */
    unsigned colour;     /**< 0xRRGGBB, sRGB: of the solid */
    unsigned cut_colour; /**< ... of its cut face */
    unsigned key_colour; /**< ... of keys, their flanks and ends */
} wcut_shape;

/** The application protocol of a STEP file; geometry is the same in both. */
typedef enum wcut_step_schema {
    WCUT_STEP_SCHEMA_AP214,
    WCUT_STEP_SCHEMA_AP242,
    WCUT_STEP_SCHEMA_COUNT
} wcut_step_schema;

/**
 * Shapes to a STEP file (ISO 10303-21), each a product of its own. Every number is the shortest that reads back as the
 * same double: knots, poles and weights come back bit for bit. A solid becomes a manifold solid B-rep with shared edges
 * and vertices; a surface a face bounded by its border, or, where it is closed, has a pole or is not clamped, the
 * surface alone in a geometric set; a curve a geometric curve set. The same shapes give the same bytes: no date is in
 * the file. Memory does not grow with the shapes.
 *
 * @param[in]  count  1 or more
 * @param[in]  shape   count
 * @param[in]  schema WCUT_STEP_SCHEMA_AP214 unless the receiver asks for AP242
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL; shape, what was found, what was expected
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (no or several geometries in a shape, a number that is
 *         not finite or beyond 1e12, counts, knots or weights that make no curve or surface, a solid whose indices lead
 *         nowhere or whose loops are open), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_step_write(int count, const wcut_shape *shape, wcut_step_schema schema, const char *path,
                                     wcut_error *error);

/** A part where an assembly sets it: its own frame's origin, x and z in the assembly's. */
typedef struct wcut_step_place {
    const char *name; /**< UTF-8, of this occurrence */
    int shape;        /**< which of the shapes */
    wcut_vec3 origin; /**< [mm] */
    wcut_vec3 x, z;   /**< unit, perpendicular */
} wcut_step_place;

/**
 * Shapes to a STEP file as an assembly: each shape once, a part that is set as often as there are places for it, by
 * transformations (AP214). Numbers as in wcut_step_write.
 *
 * @param[in]  name   of the assembly, UTF-8
 * @param[in]  count  of shapes, 1 or more
 * @param[in]  shape  count
 * @param[in]  places 1 or more
 * @param[in]  place  places
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL; shape or place, what was found, what was expected
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (as wcut_step_write; a place of a shape that is not
 *         there, or with axes that are not perpendicular of length 1), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is
 *         as it was.
 */
WCUT_API wcut_status wcut_step_write_assembly(const char *name, int count, const wcut_shape *shape, int places,
                                              const wcut_step_place *place, const char *path, wcut_error *error);

/**
 * Surfaces and curves to an IGES 5.3 file: rational B-spline surfaces (type 128) and curves (126) with their names
 * (406 form 15; 50 characters of them, "_" for what is not ASCII). Numbers as in wcut_step_write. Solids are refused:
 * write them as STEP.
 *
 * @param[in]  count  1 or more
 * @param[in]  shape   count, none of them a solid
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL; shape, what was found, what was expected
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (as wcut_step_write; more than 9999999 lines),
 *         WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_iges_write(int count, const wcut_shape *shape, const char *path, wcut_error *error);

/** A mesh as an object of a 3MF package. All borrowed. */
typedef struct wcut_mesh_object {
    const wcut_mesh *mesh;
    const char *name;               /**< UTF-8 */
    const char *material;           /**< UTF-8, of the object's triangles; NULL: none, and no colour */
    const char *marked_material;    /**< UTF-8, of the marked ones; NULL where mark is */
    const unsigned char *mark;      /**< mesh->triangle_count: not 0 where a triangle is of the second material; NULL */
    unsigned colour, marked_colour; /**< 0xRRGGBB of the materials, sRGB */
    int turned;                     /**< 1: half a turn about the x axis before it is moved, its upper side down */
    wcut_vec3 move;                 /**< [mm] where the object is put: its coordinates stay as they are */
} wcut_mesh_object;

/**
 * Meshes to a 3MF package (3MF core specification 1.3, deflated), each an object with its name, colours and place, in
 * millimetres, of type model where it is closed by index and surface where it is open. Coordinates are the shortest
 * numbers that read back as the same double.
 *
 * @param[in]  count  1 or more
 * @param[in]  object count
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (as the writers of write.h; a name that is not UTF-8
 *         or holds control characters, a mark without materials), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mesh_write_3mf(int count, const wcut_mesh_object *object, const char *path,
                                         wcut_error *error);

/** A binary STL written triangle by triangle, for meshes too large for memory. */
typedef struct wcut_stl_stream wcut_stl_stream;

/**
 * Begin a streamed STL in a temporary file beside the target; 1 MiB of memory, however long it becomes.
 *
 * @param[in]  path   the target
 * @param[out] stream the caller's, to wcut_stl_stream_commit or wcut_stl_stream_destroy
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: nothing was written.
 */
WCUT_API wcut_status wcut_stl_stream_create(const char *path, wcut_stl_stream **stream, wcut_error *error);

/**
 * Append triangles.
 *
 * @param[in,out] stream begun, not committed
 * @param[in]  count  0 or more; at most 4294967295 in all
 * @param[in]  corner 3 count [mm], counter-clockwise seen from outside
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: none of them was appended; WCUT_NOT_WRITTEN: the stream must be destroyed.
 */
WCUT_API wcut_status wcut_stl_stream_append(wcut_stl_stream *stream, int count, const wcut_vec3 *corner,
                                            wcut_error *error);

/**
 * Put the file in its place; the stream stays to be destroyed.
 *
 * @param[in,out] stream with at least one triangle
 * @param[out]    error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (no triangle was appended), WCUT_NOT_WRITTEN: the
 *         target is as it was.
 */
WCUT_API wcut_status wcut_stl_stream_commit(wcut_stl_stream *stream, wcut_error *error);

/** Free a stream; what was not committed is removed. NULL is allowed. */
WCUT_API void wcut_stl_stream_destroy(wcut_stl_stream *stream);

#ifdef __cplusplus
}
#endif

#endif
