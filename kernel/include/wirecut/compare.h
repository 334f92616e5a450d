/* wirecut/compare.h - comparison of a scan with the face of a job, a mesh or a surface (libwirecut-io). */
#ifndef WCUT_COMPARE_H
#define WCUT_COMPARE_H

#include <stdbool.h>
#include <wirecut/cloud_file.h>
#include <wirecut/cut.h>
#include <wirecut/deviation.h>
#include <wirecut/deviation_file.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/mesh.h>
#include <wirecut/registration.h>
#include <wirecut/report_pages.h>
#include <wirecut/results.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What distances are measured from and to. */
typedef enum wcut_compare_distance {
    WCUT_COMPARE_DISTANCE_SURFACE,        /**< from the points to the exact surface; a mesh has only its triangles */
    WCUT_COMPARE_DISTANCE_MESH,           /**< from the points to triangles */
    WCUT_COMPARE_DISTANCE_RECONSTRUCTION, /**< from the reconstructed scan to the surface */
    WCUT_COMPARE_DISTANCE_COUNT
} wcut_compare_distance;

/** What a scan is compared with: a file, a cut that was simulated, a mesh or a surface; exactly one of them. */
typedef struct wcut_compare_reference {
    const char *path;  /**< a job, which is simulated, a mesh or a CAD file; NULL: one of those below */
    const char *face;  /**< of a CAD file with several faces: names or numbers from 1 with commas, or "all"; NULL: its
                                      only one. Of several each point is compared with the nearest it belongs to */
    const char *edges; /**< file whose two curves replace the edges of a design at `path`; NULL: none */
    const char *force_law;       /**< file whose laws replace those of a job at `path`; NULL: none */
    const wcut_setup *setup;     /**< the setup of `history` */
    const wcut_history *history; /**< of two stations or more */
    const wcut_mesh *mesh;       /**< [mm] at least one triangle */
    const wcut_surface *surface; /**< [mm] the face itself, not lowered by a kerf and not clipped by a block */
    const char *name;            /**< what texts and files call it; NULL: its path, or "reference" */
} wcut_compare_reference;

/** A part of a scan: a file, or points in memory. */
typedef struct wcut_compare_scan {
    const char *path;       /**< a cloud; NULL: the points below */
    int count;              /**< 1 or more where path is NULL */
    const wcut_vec3 *point; /**< count [mm], finite, up to 1e12 */
    const char *name;       /**< what texts and files call it; NULL: its path, or "scan" */
} wcut_compare_scan;

/** How a comparison is made. Texts are borrowed, for as long as the result lives. */
typedef struct wcut_compare_options {
    wcut_length_unit unit;           /**< of scan files that state none; default mm */
    wcut_length_unit reference_unit; /**< of a mesh file; default mm */
    const char *columns;             /**< of text scans, as wcut_cloud_options; default NULL */
    bool flip;                       /**< turn the triangles of a mesh; default no */
    wcut_compare_distance distance;  /**< default WCUT_COMPARE_DISTANCE_SURFACE */
    double chord_tolerance;          /**< [mm] of the triangles of a job's or a given surface, positive; default 0.01 */
    wcut_clean_options clean;        /**< default: nothing is removed */
    int hold;                        /**< points held in memory, positive; of a larger scan a sample is held and its
                                          files are read twice; default 0: 500000, 2000000 with a reconstruction */
    wcut_registration_method method; /**< default WCUT_REGISTRATION_METHOD_NONE */
    wcut_registration_options registration;
    const char *datums;          /**< file of wcut_datums_read, for WCUT_REGISTRATION_METHOD_DATUM alone */
    int bands;                   /**< 0 .. WCUT_BANDS_MAX - 1; default 4 */
    double band[WCUT_BANDS_MAX]; /**< [mm] tolerances, positive, in any order: the share of deviations within each is
                                      computed; default 0.25, 0.5, 1, 2. That of the gate is added */
    double tolerance;            /**< [mm] of the gate; default 0: none */
    double share;                /**< [1] of the deviations that must be within it, 0 .. 1; default 0.95 */
    int normals;                 /**< neighbours that make a point's normal, 2 .. 128; default 0: no normals */
    bool reconstruct;            /**< make a mesh of the scan; default no, but for
                                      WCUT_COMPARE_DISTANCE_RECONSTRUCTION, which needs it */
    double support;              /**< [mm] radius around a point within which the face counts as measured, positive;
                                      default 0: 1.5, or 2.5 times the spacing of the points if that is more */
    const char *zones; /**< file of wcut_regions_read with zones and sections of the user; default NULL: none */
    const char *part, *inspector, *instrument, *date; /**< the title block; default NULL: not given */
    bool feet;                                        /**< keep the deviation of each point held, in `row` */
    int threads;                                      /**< 1 or more; default 1; the result does not depend on it */
} wcut_compare_options;

/** The defaults: nothing is removed from the scan, nothing is moved. */
WCUT_API wcut_compare_options wcut_compare_options_default(void);

/** Stages of a comparison that take time. */
typedef enum wcut_compare_stage {
    WCUT_COMPARE_STAGE_SIMULATE, /**< stations */
    WCUT_COMPARE_STAGE_READ,     /**< points; how many there will be is not known: total is 0 */
    WCUT_COMPARE_STAGE_MEASURE,  /**< points */
    WCUT_COMPARE_STAGE_COUNT
} wcut_compare_stage;

/** Callbacks of a comparison. */
typedef struct wcut_compare_watch {
    /** called after each station and each piece of a scan; other than 0: stop. NULL: none */
    int (*progress)(wcut_compare_stage stage, int done, int total, void *context);
    /** called with a sentence about a doubt in the figures, as soon as it is known. NULL: none */
    void (*warn)(const char *text, void *context);
    void *context;
} wcut_compare_watch;

/** The result of a comparison. Borrows the texts of reference, scans and options, and a reference that is no file. */
typedef struct wcut_compare_result {
    wcut_compared compared;    /**< what deviation.json holds */
    wcut_report_compare page;  /**< what report.html shows: the coloured face, the points held as registered */
    const wcut_deviation *row; /**< page.points; NULL unless options->feet */
    const wcut_vec3 *normal;   /**< page.points, of the points as registered; NULL unless options->normals */
    double limit;              /**< [mm] value of the strongest colour */
    bool streamed;             /**< deviation.ply is in the results of the run */
} wcut_compare_result;

/**
 * Compare a scan with a face: read and clean the scan, register it, measure every point, and measure back from the face
 * to the scan. The distance is signed, positive where material was left.
 *
 * A scan of more points than are held is read twice; only files can be. A registration that does not converge is no
 * failure: compared.registration->converged is 0, and the figures are of its best pose.
 *
 * @param[in]  reference what the scan is compared with
 * @param[in]  scans   1 or more
 * @param[in]  scan    scans, which together are one scan
 * @param[in]  options NULL for the defaults
 * @param[in]  results where deviation.ply, every point with its deviation, goes; NULL: it is not written
 * @param[in]  watch   may be NULL
 * @param[out] result  the caller's, to wcut_compare_destroy
 * @param[out] error   may be NULL; the file or the option, what was found, what was expected
 * @return WCUT_OK; the statuses of wcut_job_read, wcut_setup_run, wcut_face_create, wcut_mesh_read, wcut_trimmed_set_read, wcut_cloud_read,
 *         wcut_cloud_clean, wcut_datums_read, wcut_regions_read, wcut_registration_fit, wcut_reconstruction_create and
 *         wcut_deviation_stream_create; WCUT_BAD_FORMAT (a CAD file without the face, no point of the scan over the face, a
 *         file that changed between two readings), WCUT_DEGENERATE (the scan is one place or one line, the mesh has no
 *         extent or is no sheet where it must be one), WCUT_BAD_ARGUMENT (an option out of range; options that exclude
 *         each other), WCUT_INTERRUPTED: nothing was written.
 */
WCUT_API wcut_status wcut_compare_run(const wcut_compare_reference *reference, int scans, const wcut_compare_scan *scan,
                                      const wcut_compare_options *options, wcut_results *results,
                                      const wcut_compare_watch *watch, wcut_compare_result **result, wcut_error *error);

/** Free a comparison; NULL is allowed. */
WCUT_API void wcut_compare_destroy(wcut_compare_result *result);

/** Maximum number of files of a comparison. */
enum { WCUT_COMPARE_FILES_MAX = 9 };

/**
 * The files of a comparison, in the order in which they are written; deviation.json, the voucher, is the last.
 *
 * @param[in]  result NULL: all files that a comparison can have
 * @param[out] name   WCUT_COMPARE_FILES_MAX, the first of them, constants
 * @return how many.
 */
WCUT_API int wcut_compare_files(const wcut_compare_result *result, const char *name[WCUT_COMPARE_FILES_MAX]);

/**
 * Write a comparison: the coloured face, the reconstruction, zones.csv and report.html beside the deviation.ply of its
 * run, then put the set into its folder under deviation.json.
 *
 * @param[in]  result
 * @param[in]  results of the comparison's run; its set is empty afterwards where it was committed
 * @param[out] text    deviation.json as it is on disk, for free(); may be NULL
 * @param[out] error   may be NULL
 * @return WCUT_OK: all files are wholly on disk; WCUT_BAD_ARGUMENT (also where the run was without `results`),
 *         WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the folder has its earlier files.
 */
WCUT_API wcut_status wcut_compare_write(const wcut_compare_result *result, wcut_results *results, char **text,
                                        wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
