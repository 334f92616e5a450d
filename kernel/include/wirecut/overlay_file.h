/* wirecut/overlay_file.h - photographs and their points in, overlays out. */
#ifndef WCUT_OVERLAY_FILE_H
#define WCUT_OVERLAY_FILE_H

#include <wirecut/export.h>
#include <wirecut/overlay.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What was done to a picture on the way in. */
typedef struct wcut_picture_source {
    int orientation; /**< EXIF, 1 .. 8; 1: as stored. The picture is turned upright, as viewers show it */
    int depth;       /**< bits a channel in the file; 16 are reduced to 8 */
    bool profile;    /**< an embedded colour profile was ignored */
} wcut_picture_source;

/**
 * Read a photograph: PNG (libpng) or JPEG (libjpeg-turbo), told by its first bytes. The EXIF orientation is applied.
 *
 * @param[in]  path    at most 1 GiB
 * @param[out] picture 1 or 3 channels; the caller's, to wcut_picture_destroy
 * @param[out] source  may be NULL
 * @param[out] error   may be NULL; what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND; WCUT_BAD_FORMAT (another format, with its name and the remedy; a truncated or broken
 *         file; more than WCUT_PICTURE_PIXELS, with the number); WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_picture_read(const char *path, wcut_picture **picture, wcut_picture_source *source,
                                       wcut_error *error);

/**
 * Write a PNG file, 8 bits a channel.
 *
 * @param[in]  picture
 * @param[in]  resolution [mm] a pixel, kept in the file (pHYs); 0: none
 * @param[in]  path       the target, replaced whole or not at all
 * @param[out] error      may be NULL
 * @return WCUT_OK: wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_picture_write(const wcut_picture *picture, double resolution, const char *path,
                                        wcut_error *error);

/**
 * Read points of a picture from a CSV file with the columns u_px, v_px, x_mm, y_mm, z_mm.
 *
 * @param[in]  path  4 to 500 rows
 * @param[out] count
 * @param[out] point count, the caller's, for free()
 * @param[out] error may be NULL; line and column
 * @return WCUT_OK; WCUT_NOT_FOUND, WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_photo_points_read(const char *path, int *count, wcut_photo_point **point, wcut_error *error);

/** An overlay with what it came from. */
typedef struct wcut_overlaid {
    const char *job, *photo;               /**< names of the files */
    const char *job_sha256, *photo_sha256; /**< may be NULL */
    wcut_vec3 block;                       /**< [mm] */
    const wcut_picture_source *source;
    const wcut_camera *camera;
    const wcut_camera_report *report;
    int points;
    const wcut_photo_point *point; /**< points */
    const double *residual;        /**< points x 2 [px] */
    const double *leave_one_out;   /**< points [px]; read where report->left_out */
    const wcut_history *history;
    const wcut_overlay *overlay;
} wcut_overlaid;

/**
 * "wirecut-overlay/1" as a JSON text.
 *
 * @param[in]  overlaid all of it
 * @param[out] text     for free()
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_overlay_print(const wcut_overlaid *overlaid, char **text);

/**
 * rills.csv: a row a patch of the block.
 *
 * @param[in]  overlay
 * @param[in]  path    the target, replaced whole or not at all
 * @param[out] error   may be NULL
 * @return WCUT_OK: wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_rills_write(const wcut_overlay *overlay, const char *path, wcut_error *error);

/**
 * overlay.svg: the rectified picture as a link, wires, fitted wires and outline as vectors, in mm.
 *
 * @param[in]  overlaid all of it
 * @param[in]  link     name of the rectified picture beside the file
 * @param[in]  path     the target, replaced whole or not at all
 * @param[out] error    may be NULL
 * @return WCUT_OK: wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_overlay_svg_write(const wcut_overlaid *overlaid, const char *link, const char *path,
                                            wcut_error *error);

/**
 * A world file (ESRI) beside a rectified picture: six lines that place its pixels in the block's plane [mm].
 *
 * @param[in]  overlay
 * @param[in]  block   [mm]
 * @param[in]  path    the target, replaced whole or not at all
 * @param[out] error   may be NULL
 * @return WCUT_OK: wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NOT_WRITTEN, WCUT_NO_MEMORY: the target is as it was.
 */
WCUT_API wcut_status wcut_world_write(const wcut_overlay *overlay, wcut_vec3 block, const char *path,
                                      wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
