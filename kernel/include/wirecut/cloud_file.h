/* wirecut/cloud_file.h - point clouds in, as a whole or in pieces (libwirecut-io). */
#ifndef WCUT_CLOUD_FILE_H
#define WCUT_CLOUD_FILE_H

#include <wirecut/cloud.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The unit that a file's coordinates are in. */
typedef enum wcut_length_unit {
    WCUT_LENGTH_UNIT_MM,
    WCUT_LENGTH_UNIT_CM,
    WCUT_LENGTH_UNIT_M,
    WCUT_LENGTH_UNIT_INCH,
    WCUT_LENGTH_UNIT_FOOT,
    WCUT_LENGTH_UNIT_DM,
    WCUT_LENGTH_UNIT_UM,
    WCUT_LENGTH_UNIT_COUNT
} wcut_length_unit;

/** How a cloud is read. */
typedef struct wcut_cloud_options {
    wcut_cloud_format format; /**< default WCUT_CLOUD_FORMAT_ANY */
    /** of a file that states none; default WCUT_LENGTH_UNIT_MM. A unit in the header of a text (x_m) replaces
        the default; a different unit given here is then refused */
    wcut_length_unit unit;
    /** text: the columns x, y, z, or those and a normal, as names of the header or numbers from 1 with commas between
        them, "x_meas,y_meas,z_meas" or "4,5,6"; borrowed; default NULL: told by the header */
    const char *columns;
    int max_points; /**< wcut_cloud_read keeps at most so many points and refuses more, 1 or more; default 20000000 */
    double voxel;   /**< [mm] wcut_cloud_read keeps the first point of each cube of this side; default 0: every point */
} wcut_cloud_options;

/** A cloud that comes in pieces, however long it is; memory stays below 1 MiB. */
typedef struct wcut_cloud_source wcut_cloud_source;

/** The defaults stated at the fields. */
WCUT_API wcut_cloud_options wcut_cloud_options_default(void);

/**
 * Begin to read a cloud.
 *
 * Text: separated by blanks, commas or semicolons, told from the first row; decimal commas where those do not
 * separate; cells may be quoted; comments (#, //), up to ten lines before the rows, lines with the count of the points
 * that follow (PTS, several scans in one file). The last line of words before the rows, or a comment, names the
 * columns: x, y, z, with words such as coordinate or a unit, and of nominal and measured ones those measured. Other
 * names are refused: the option columns says then which columns are meant. Without names the first three columns are
 * x, y, z, and of six the last three are a normal where the first row's has length 1; six that hold two points, or a
 * first one that counts the rows, are refused. PLY: coordinates of any scalar type; other properties, lists and
 * elements are skipped.
 *
 * @param[in]  path    a file, or a pipe
 * @param[in]  options NULL for the defaults; max_points and voxel are not read
 * @param[out] source  the caller's, to wcut_cloud_source_destroy
 * @param[out] error   may be NULL; line or byte, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (no such file, not readable), WCUT_BAD_FORMAT (no cloud; LAZ, E57; a
 *         header that is malformed or claims more than the file can hold), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing
 *         was written.
 */
WCUT_API wcut_status wcut_cloud_source_create(const char *path, const wcut_cloud_options *options,
                                              wcut_cloud_source **source, wcut_error *error);

/**
 * The next points, in the file's order. What stands before a fault is handed out first, then the fault is reported, by
 * this call and every further one.
 *
 * @param[in,out] source   not in use by another thread
 * @param[in]  capacity 1 or more
 * @param[out] point    capacity [mm], the first `count` of them
 * @param[out] normal   capacity [1], the first `count` of them, length 1 or 0; not written where the file has none; may
 *                      be NULL
 * @param[out] count    points given; 0: the end
 * @param[out] error    may be NULL; line or byte, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (reading failed), WCUT_BAD_FORMAT (the file ends early or goes on behind what its
 *         header states, text where a number belongs, a coordinate beyond 1e12 mm or most of the first thousand points
 *         below 1e-30 mm, as of the wrong byte order, more than 2147483647 points), WCUT_BAD_ARGUMENT: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_cloud_source_next(wcut_cloud_source *source, int capacity, wcut_vec3 *point,
                                            wcut_vec3 *normal, int *count, wcut_error *error);

/** What a source has given so far, borrowed; NULL for NULL. */
WCUT_API const wcut_cloud_info *wcut_cloud_source_info(const wcut_cloud_source *source);

/** Close a source; NULL is allowed. */
WCUT_API void wcut_cloud_source_destroy(wcut_cloud_source *source);

/**
 * Read a whole cloud into memory; with the option voxel memory is needed for the points kept only.
 *
 * @param[in]  path    a file, or a pipe
 * @param[in]  options NULL for the defaults
 * @param[out] cloud   the caller's, to wcut_cloud_destroy
 * @param[out] error   may be NULL; line or byte, what was found, what was expected
 * @return as wcut_cloud_source_create and wcut_cloud_source_next; WCUT_BAD_FORMAT also where there is no point, or more
 *         than options->max_points: nothing was written.
 */
WCUT_API wcut_status wcut_cloud_read(const char *path, const wcut_cloud_options *options, wcut_cloud **cloud,
                                     wcut_error *error);

/** Free a cloud that wcut_cloud_read gave; NULL is allowed. */
WCUT_API void wcut_cloud_destroy(wcut_cloud *cloud);

#ifdef __cplusplus
}
#endif

#endif
