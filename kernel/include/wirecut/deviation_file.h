/* wirecut/deviation_file.h - a comparison of scan and face to files: JSON, zones.csv, coloured points and mesh. */
#ifndef WCUT_DEVIATION_FILE_H
#define WCUT_DEVIATION_FILE_H

#include <wirecut/cloud.h>
#include <wirecut/deviation.h>
#include <wirecut/deviation_summary.h>
#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/reconstruction.h>
#include <wirecut/registration.h>
#include <wirecut/status.h>
#include <wirecut/survey.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A file of a scan. */
typedef struct wcut_compared_scan {
    const char *name;
    const char *sha256; /**< hexadecimal; "" where it was not hashed */
    int read;           /**< points */
    int not_finite, withheld;
} wcut_compared_scan;

/** What is written of a comparison; everything is borrowed. */
typedef struct wcut_compared {
    const char *reference; /**< the job or the mesh */
    const char *distance;  /**< how distances were taken: "surface", "mesh", "reconstruction" */
    /** the title block of a report: what was measured, by whom, with what, when; NULL where it is not given */
    const char *part, *inspector, *instrument, *date;
    const char *datum_file;             /**< NULL: none */
    const wcut_clean_options *cleaning; /**< NULL: nothing was to be removed */
    int scans;                          /**< 1 or more */
    const wcut_compared_scan *scan;
    int removed[WCUT_REMOVAL_COUNT]; /**< by cause; removed[WCUT_REMOVAL_KEPT] points were compared */
    const wcut_registration *registration;
    int datums;                                   /**< 0 or more */
    const wcut_datum_residual *datum;             /**< datums: residuals after the registration */
    const wcut_deviation_summary_result *found;   /**< as registered */
    const wcut_deviation_summary_result *unmoved; /**< as the scan came; the same as `found` without a registration */
    const wcut_statistics *face_to_scan;          /**< [mm] distances of the face from the nearest point; not signed */
    double resolution;                 /**< [mm] these distances may be too large by this: points were thinned */
    double kerf;                       /**< [mm] mean kerf, by half of which the face was lowered; 0 for a mesh */
    int has_kerf;                      /**< 1 where the face is a job's: the offset shows the true kerf */
    double unmeasured;                 /**< [mm^2] of the face without points; negative: not known */
    double support;                    /**< [mm] radius around a point within which the face counts as measured */
    double tolerance, share;           /**< [mm], [1] the gate; tolerance 0: none */
    int within;                        /**< 1: as much as the gate asks is within the tolerance */
    const char *zones_file;            /**< that the survey's zones came from; NULL: none */
    const wcut_survey_result *survey;  /**< zones and sections of the user; NULL: none */
    const char *reconstruction_method; /**< "field" */
    const wcut_reconstruction *reconstruction; /**< NULL where none was made */
    const wcut_statistics *to_scan;            /**< [mm] face to reconstruction, signed; NULL without one */
    const wcut_statistics *to_face;            /**< [mm] reconstruction to face, signed; NULL without one */
} wcut_compared;

/**
 * The text of deviation.json, "wirecut-deviation/1" (FORMATS.md, Deviation).
 *
 * @param[in]  compared every pointer as its field says
 * @param[out] text the caller's, to free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_print(const wcut_compared *compared, char **text);

/* The writers: the target is replaced whole or left as it was. @return WCUT_OK: the file is wholly on disk;
   WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as it was; error may be NULL. */

/**
 * Write deviation.json: the text of wcut_deviation_print into a file.
 *
 * @param[in]  compared as for wcut_deviation_print
 * @param[in]  path     the target, replaced whole or left as it was
 * @param[out] error    may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_deviation_write(const wcut_compared *compared, const char *path, wcut_error *error);

/**
 * zones.csv: a row a zone; an empty field where a zone has no points.
 *
 * @param[in]  found of wcut_deviation_summary_eval
 * @param[in]  survey zones of the user, rows of the kind `user`; NULL: none
 * @param[in]  path  the target, replaced whole or left as it was
 * @param[out] error may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_zones_write(const wcut_deviation_summary_result *found, const wcut_survey_result *survey,
                                      const char *path, wcut_error *error);

/**
 * A mesh with a deviation at every vertex, to binary PLY (doubles, the scalar `deviation_mm`, a colour) or to OBJ (a
 * colour behind each vertex): blue below, orange above, grey and nan where `present` is 0.
 *
 * @param[in] mesh    at least one triangle
 * @param[in] value   mesh->vertex_count [mm], finite
 * @param[in] present mesh->vertex_count; NULL: everywhere
 * @param[in] limit   [mm] value of the strongest colour, positive
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_deviation_mesh_write_ply(const wcut_mesh *mesh, const double *value,
                                                   const unsigned char *present, double limit, const char *path,
                                                   wcut_error *error);

/** The same as OBJ: vertices with colours. @return As wcut_deviation_mesh_write_ply. */
WCUT_API wcut_status wcut_deviation_mesh_write_obj(const wcut_mesh *mesh, const double *value,
                                                   const unsigned char *present, double limit, const char *path,
                                                   wcut_error *error);

/** deviation.ply, written as points come, however many: position, deviation_mm, place, colour. */
typedef struct wcut_deviation_stream wcut_deviation_stream;

/**
 * Begin a stream in a temporary file beside the target.
 *
 * @param[in]  path    the target
 * @param[in]  limit   [mm] value of the strongest colour, positive
 * @param[in]  normals 1 where points come with normals, else 0
 * @param[out] stream  the caller's, to wcut_deviation_stream_destroy
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_stream_create(const char *path, double limit, int normals,
                                                  wcut_deviation_stream **stream, wcut_error *error);

/**
 * Append points, their normals and deviations; deviations that do not count are grey and nan.
 *
 * @param[in,out] stream    begun, not committed
 * @param[in]     count     0 or more
 * @param[in]     point     count [mm], finite
 * @param[in]     normal    count; NULL where the stream has none
 * @param[in]     deviation count
 * @param[out]    error     may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was appended; WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the stream must
 *         be destroyed, the target is as it was.
 */
WCUT_API wcut_status wcut_deviation_stream_append(wcut_deviation_stream *stream, int count, const wcut_vec3 *point,
                                                  const wcut_vec3 *normal, const wcut_deviation *deviation,
                                                  wcut_error *error);

/**
 * Finish the file and put it in its place; the stream stays to be destroyed.
 *
 * @param[in,out] stream begun, not committed
 * @param[out]    error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN: the target is as it was.
 */
WCUT_API wcut_status wcut_deviation_stream_commit(wcut_deviation_stream *stream, wcut_error *error);

/** Free a stream; what was not committed is removed. NULL is allowed. */
WCUT_API void wcut_deviation_stream_destroy(wcut_deviation_stream *stream);

/** Datums of a registration. */
typedef struct wcut_datums {
    int pairs, faces;
    wcut_datum_pair *pair;
    wcut_datum_face *face; /**< of one point each */
    wcut_vec3 *point;      /**< faces: what face[k].scan points to */
} wcut_datums;

/**
 * Read datums: a CSV with the columns scan_x_mm, scan_y_mm, scan_z_mm, block_x_mm, block_y_mm, block_z_mm and, if
 * wanted, sigma_mm. A row with all three block coordinates is a pair of points; one with a single one says that the
 * scan's point lies on the plane where that coordinate has this value, on a face that the wire did not cut.
 *
 * @param[in]  path   a file
 * @param[out] datums the caller's, to wcut_datums_destroy
 * @param[out] error  may be NULL; the line, what was found, what was expected
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, as wcut_table_read, WCUT_BAD_FORMAT also where a row is neither,
 *         or there is none: nothing was written.
 */
WCUT_API wcut_status wcut_datums_read(const char *path, wcut_datums **datums, wcut_error *error);

/** Free datums; NULL is allowed. */
WCUT_API void wcut_datums_destroy(wcut_datums *datums);

#ifdef __cplusplus
}
#endif

#endif
