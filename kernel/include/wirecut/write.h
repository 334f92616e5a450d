/* wirecut/write.h - results to files: whole or not at all, exact numbers, millimetres. */
#ifndef WCUT_WRITE_H
#define WCUT_WRITE_H

#include <wirecut/cut.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Every writer here: the target is replaced whole or left as it was; the ending of the name is not checked.
   @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it
   was; error (may be NULL) says path and cause. */

/**
 * Binary STL; the header says millimetres.
 *
 * @param[in]  mesh  at least one triangle
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mesh_write_stl(const wcut_mesh *mesh, const char *path, wcut_error *error);

/**
 * OBJ with normals and texture coordinates where the mesh has them; a comment says millimetres.
 *
 * @param[in]  mesh  at least one triangle
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mesh_write_obj(const wcut_mesh *mesh, const char *path, wcut_error *error);

/**
 * Binary little-endian PLY, double coordinates; a scalar becomes the property `name` and a vertex colour.
 *
 * @param[in]  mesh  at least one triangle
 * @param[in]  name  of the property: one word of at most 100 letters, digits and _, no standard property
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mesh_write_ply(const wcut_mesh *mesh, const char *name, const char *path, wcut_error *error);

/**
 * Binary glTF in metres as glTF demands (scale on the root node, coordinates in mm from the part's middle, to
 * 2^-24 of its half size), scalar as vertex colour.
 *
 * @param[in]  mesh  at least one triangle
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_mesh_write_glb(const wcut_mesh *mesh, const char *path, wcut_error *error);

/**
 * `path.csv` (FORMATS.md, Path curves): one row a station.
 *
 * @param[in]  history at least one station
 * @param[in]  mount_a history->stations [mm], from wcut_history_path
 * @param[in]  mount_b history->stations [mm]
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_history_write_csv(const wcut_history *history, const wcut_vec3 *mount_a,
                                            const wcut_vec3 *mount_b, const char *path, wcut_error *error);

/**
 * `history.vtp` of a whole history: one polyline a station, exact doubles, appended raw.
 *
 * @param[in]  history at least one station
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_history_write_vtp(const wcut_history *history, const char *path, wcut_error *error);

/** A `.vtp` written station by station, for a history too large for memory. */
typedef struct wcut_vtp_stream wcut_vtp_stream;

/**
 * Begin a streamed `.vtp` in a temporary file beside the target.
 *
 * @param[in]  path     the target
 * @param[in]  stations largest number that will be appended
 * @param[in]  nodes    of every station
 * @param[out] stream   the caller's, to wcut_vtp_stream_commit or wcut_vtp_stream_destroy
 * @param[out] error    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also a size beyond the format's limits), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_vtp_stream_create(const char *path, int stations, int nodes, wcut_vtp_stream **stream,
                                            wcut_error *error);

/**
 * Append a station.
 *
 * @param[in,out] stream  begun, not committed
 * @param[in]     station with as many nodes as the stream; its arrays are copied
 * @param[out]    error   may be NULL; path and cause
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also another number of nodes, or more stations than said): nothing was
 *         appended; WCUT_NOT_WRITTEN: the stream must be destroyed, the target is as it was.
 */
WCUT_API wcut_status wcut_vtp_stream_append(wcut_vtp_stream *stream, const wcut_station *station, wcut_error *error);

/**
 * Finish the file with the stations appended and put it in its place; the stream stays to be destroyed.
 *
 * @param[in,out] stream with at least one station
 * @param[out]    error  may be NULL; path and cause
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_vtp_stream_commit(wcut_vtp_stream *stream, wcut_error *error);

/** Free a stream; what was not committed is removed. NULL is allowed. */
WCUT_API void wcut_vtp_stream_destroy(wcut_vtp_stream *stream);

/**
 * `summary.json`, "wirecut-summary/1" (FORMATS.md, Summary).
 *
 * @param[in] setup      that the history came from
 * @param[in] history    at least one station
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_summary_write(const wcut_setup *setup, const wcut_history *history, const char *path,
                                        wcut_error *error);

/**
 * The text of `summary.json`.
 *
 * @param[in]  setup   that the history came from
 * @param[in]  history at least one station
 * @param[out] text the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_summary_print(const wcut_setup *setup, const wcut_history *history, char **text);

#ifdef __cplusplus
}
#endif

#endif
