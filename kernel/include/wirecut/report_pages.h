/* wirecut/report_pages.h - the report page of each result: a simulated cut, a calibration, a closed loop and others. */
#ifndef WCUT_REPORT_PAGES_H
#define WCUT_REPORT_PAGES_H

#include <wirecut/calibration.h>
#include <wirecut/compensation_file.h>
#include <wirecut/cut.h>
#include <wirecut/design_file.h>
#include <wirecut/deviation_file.h>
#include <wirecut/diagnosis.h>
#include <wirecut/facade_file.h>
#include <wirecut/face.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/mesh.h>
#include <wirecut/mould.h>
#include <wirecut/overlay_file.h>
#include <wirecut/report.h>
#include <wirecut/rig.h>
#include <wirecut/score.h>
#include <wirecut/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Each function builds a wcut_report of a result and writes it by wcut_report_write. The structs borrow everything they
   point to. Every status other than WCUT_OK: the target is as it was. */

/** What a simulated cut's page says beside setup and history. */
typedef struct wcut_report_simulate {
    const char *job_path;   /**< hashed for the provenance; a path that cannot be read again has no hash */
    const char *integrator; /**< as the user calls it */
    double chord_tolerance; /**< [mm] of the files beside the page */
    double merge;           /**< [mm] sections nearer than this were one in the surface */
    wcut_status ended;      /**< how the run ended */
} wcut_report_simulate;

/**
 * Write the page of a simulated cut: the swept surface, the path curves, speeds, tensions and angles over time.
 *
 * @param[in]  run     how the cut was run
 * @param[in]  setup   of the cut
 * @param[in]  history of the cut, at least one station
 * @param[in]  path    the target, replaced whole or not at all
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write, wcut_file_hash,
 *         wcut_history_path and wcut_surface_loft: the target is as it was.
 */
WCUT_API wcut_status wcut_report_simulate_write(const wcut_report_simulate *run, const wcut_setup *setup,
                                                const wcut_history *history, const char *path, wcut_error *error);

enum { WCUT_REPORT_SENTENCE = 256 }; /**< [byte] of a sentence, with its final zero */

/** What a calibration's page is of. */
typedef struct wcut_report_calibrate {
    const char *path;    /**< of the table */
    const char *weights; /**< the column they are from; NULL: all cuts count the same */
    int cuts;
    const wcut_test_cut *cut; /**< cuts */
    const wcut_calibration_options *options;
    const wcut_calibration *fit;
    const wcut_calibration_point *point; /**< cuts */
    int warnings;
    const char *const *warning; /**< warnings: what to know before cutting by these numbers, a sentence each */
} wcut_report_calibrate;

/**
 * A sentence on how far the cuts lie from a law: those it was fitted to, and those left out of the fit.
 *
 * @param[in]  of       the calibration
 * @param[in]  fit      its force law or its tension law
 * @param[out] sentence WCUT_REPORT_SENTENCE bytes
 */
WCUT_API void wcut_report_calibrate_scatter(const wcut_report_calibrate *of, const wcut_law_fit *fit,
                                            char sentence[WCUT_REPORT_SENTENCE]);

/**
 * A sentence on whether a law fits, and what it was tested against.
 *
 * @param[in]  fit      of a calibration
 * @param[out] sentence WCUT_REPORT_SENTENCE bytes
 */
WCUT_API void wcut_report_calibrate_lack(const wcut_law_fit *fit, char sentence[WCUT_REPORT_SENTENCE]);

/**
 * Write the page of a calibration: both laws with their bands, residuals, tests of the fit.
 *
 * @param[in]  of    the calibration
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write and
 *         wcut_file_hash: the target is as it was.
 */
WCUT_API wcut_status wcut_report_calibrate_write(const wcut_report_calibrate *of, const char *path, wcut_error *error);

/**
 * Write the page of a closed loop: speeds, tensions and angles with feedback and with the plan alone.
 *
 * @param[in]  summary  of the rig's two runs
 * @param[in]  job_path hashed for the provenance
 * @param[in]  path     the target, replaced whole or not at all
 * @param[out] error    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write and
 *         wcut_file_hash: the target is as it was.
 */
WCUT_API wcut_status wcut_report_control_write(const wcut_rig_summary *summary, const char *job_path, const char *path,
                                               wcut_error *error);

/** What a comparison's page is of: its figures, and what the view in space shows. */
typedef struct wcut_report_compare {
    const wcut_compared *compared;
    const char *title;                  /**< the job's name; NULL: compared->reference */
    const char *reference_sha256;       /**< hexadecimal; NULL where it was not hashed */
    const wcut_face *face;              /**< of a job, whose grid is `mesh`; NULL where the reference is a mesh */
    int stations;                       /**< of the mounts' path curves; 0: they are not shown */
    const wcut_vec3 *mount_a, *mount_b; /**< stations [mm] */
    const wcut_mesh *mesh;              /**< the face that is coloured */
    const double *value;                /**< mesh->vertex_count [mm] deviation of the scan */
    const unsigned char *present;       /**< mesh->vertex_count: 1 where there is a value */
    int points;                         /**< of the scan that are shown, 0 or more */
    const wcut_vec3 *point;             /**< points [mm] as registered */
    const double *deviation;            /**< points [mm]; NaN where a point does not count */
    double spacing;                     /**< [mm] to which those points were thinned; 0: they are all */
    const char *unit;                   /**< of the scan's files, "mm" */
    double border;                      /**< [mm] of wcut_deviation_options */
} wcut_report_compare;

/**
 * Write the page of a comparison: the deviation in space, figures as scanned and as registered, along the cut, zones.
 *
 * @param[in]  of    the comparison
 * @param[in]  path  the target, replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_report_compare_write(const wcut_report_compare *of, const char *path, wcut_error *error);

/** What a diagnosis's page is of. */
typedef struct wcut_report_diagnose {
    const char *title; /**< the case's name */
    const wcut_diagnosis *diagnosis;
    const char *const *cut_name; /**< diagnosis->cuts */
    int said;
    const char *const *said_text; /**< said: what of the case could not be read, a sentence each */
    int options;
    const wcut_report_fact *option; /**< options: settings of the run */
    int sources;
    const wcut_report_source *source; /**< sources: files of the case */
} wcut_report_diagnose;

/**
 * Write the page of a diagnosis: the verdict, the evidence, what was tried, what to do next.
 *
 * @param[in]  diagnosed the diagnosis
 * @param[in]  path      the target, replaced whole or not at all
 * @param[out] error     may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_report_diagnose_write(const wcut_report_diagnose *diagnosed, const char *path,
                                                wcut_error *error);

/** What a divided block's page says beside job and mould. */
typedef struct wcut_report_mould {
    const char *job_path;
    const char *stock_path;                         /**< NULL: the job's block */
    const char *edges_path;                         /**< NULL: the job's own edges, or none */
    double chord_tolerance, fit_tolerance, prolong; /**< [mm] as asked for */
} wcut_report_mould;

/**
 * Write the page of a divided block: both halves, walls, drafts, checks.
 *
 * @param[in]  run     what was asked for
 * @param[in]  job     of the cut
 * @param[in]  history of the cut; NULL where the halves were made of edges alone
 * @param[in]  mould   the halves
 * @param[in]  path    the target, replaced whole or not at all
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write and
 *         wcut_file_hash: the target is as it was.
 */
WCUT_API wcut_status wcut_report_mould_write(const wcut_report_mould *run, const wcut_job *job,
                                             const wcut_history *history, const wcut_mould *mould, const char *path,
                                             wcut_error *error);

/** What a score's page is of. */
typedef struct wcut_report_score {
    const char *title;
    int cuts;                   /**< at least one of them compared */
    const wcut_scored_cut *cut; /**< cuts */
    int groups;                 /**< rows of the table by case, or by cut where there is one case or none */
    const char *const *group_name;
    const wcut_scores *planned, *replayed; /**< groups + 1 each: of every group, and at last of all cuts */
    const char *group_label;               /**< "case" or "cut" */
    const wcut_comparison_options *options;
    int nodes; /**< along the wire; 0: as the jobs say */
    int sources;
    const wcut_report_source *source; /**< sources */
} wcut_report_score;

/**
 * Write the page of recordings beside their predictions: scores by channel, phase and cut, every channel over time.
 *
 * @param[in]  scored the score
 * @param[in]  path   the target, replaced whole or not at all
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_report_score_write(const wcut_report_score *scored, const char *path, wcut_error *error);

/**
 * Write the page of a photograph over a simulated cut: angles between rills and wire as a map, the shape that they tell,
 * the camera's points.
 *
 * @param[in]  overlaid all of it
 * @param[in]  path     the target, replaced whole or not at all
 * @param[out] error    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as it was.
 */
WCUT_API wcut_status wcut_report_overlay_write(const wcut_overlaid *overlaid, const char *path, wcut_error *error);

/**
 * Write the page of a sweep: parallel coordinates of its cases, a scatter of any two columns, the best cases with the meshes
 * among their results, links to the cases' own pages. Of more than 10,000 cases every k-th is shown, and the best.
 *
 * @param[in]  sweep
 * @param[in]  path  the target beside the folder "cases", replaced whole or not at all
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as it was.
 */
WCUT_API wcut_status wcut_report_sweep_write(const wcut_sweep *sweep, const char *path, wcut_error *error);

/**
 * Write the page of a facade: the whole of it in space, coloured by the force or by any figure of its elements, and a
 * table of the elements with links to their own pages.
 *
 * @param[in]  results
 * @param[in]  source  the description's file, for the provenance; may be NULL
 * @param[in]  path    the target beside the folder "cases", replaced whole or not at all
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as it was.
 */
WCUT_API wcut_status wcut_report_facade_write(const wcut_facade_results *results, const char *source, const char *path,
                                              wcut_error *error);

/** What a design's page is of. */
typedef struct wcut_report_design {
    const char *title;
    wcut_vec3 block; /**< [mm] of the design, or of the target where there is the map alone */
    const wcut_design_result *result;
    const wcut_history *history; /**< of the cut; NULL where there is the map alone */
    const double *deviation;     /**< result->design->points [mm] of the target's points from the cut; NaN: none */
} wcut_report_design;

/**
 * Write the page of a design, or of the map of a target: both in space, the map with its reasons, the curves, the search.
 *
 * @param[in]  report the design
 * @param[in]  path   the target, replaced whole or not at all
 * @param[out] error  may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a NULL that is not allowed), the statuses of wcut_report_write: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_report_design_write(const wcut_report_design *report, const char *path, wcut_error *error);

/**
 * Write the page of a compensation: what it removes, also where the effects are off, each effect alone, the correction.
 *
 * @param[in]  title
 * @param[in]  result with a whole compensation and a job that can be read
 * @param[in]  path   the target, replaced whole or not at all
 * @param[out] error  may be NULL
 * @return As wcut_report_design_write.
 */
WCUT_API wcut_status wcut_report_compensate_write(const char *title, const wcut_compensation_result *result,
                                                  const char *path, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
