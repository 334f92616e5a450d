/* wirecut/facade_file.h - facades in and out: the description, its elements, and what came of them (libwirecut-io). */
#ifndef WCUT_FACADE_FILE_H
#define WCUT_FACADE_FILE_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/facade.h>
#include <wirecut/history.h>
#include <wirecut/status.h>
#include <wirecut/sweep.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A facade as a file describes it, laid out. */
typedef struct wcut_facade_description {
    char *name; /**< UTF-8 */
    wcut_facade *facade;
    int variants;
    char **variant_name; /**< variants: of the jobs that elements follow, UTF-8 */
    int *variant;        /**< facade->elements: which of them */
} wcut_facade_description;

/**
 * Read a facade, "format": "wirecut-facade/1" (FORMATS.md, Facade), with the jobs, images, tables and the surface that
 * it names, and lay it out. Names are relative to its folder.
 *
 * @param[in]  path        a JSON file
 * @param[out] description the caller's, to wcut_facade_description_destroy
 * @param[out] error       may be NULL; the JSON path or the file, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND (a file is missing), WCUT_BAD_FORMAT, the statuses of wcut_facade_create: nothing was
 *         written.
 */
WCUT_API wcut_status wcut_facade_read(const char *path, wcut_facade_description **description, wcut_error *error);

/** Free a description; NULL is allowed. */
WCUT_API void wcut_facade_description_destroy(wcut_facade_description *description);

/** What is made of every element. */
typedef struct wcut_element_options {
    double thickness;       /**< [mm] of a panel, not negative; 0: no panel; default 0 */
    double density;         /**< [kg/m3] of the panel, positive; default 2000 */
    bool moulds;            /**< the halves of the block; default false */
    double chord_tolerance; /**< [mm] of triangles, positive; default 0.1 */
    const char *formats;    /**< files of the cut, as --formats has them; default NULL: all. Not a part of an element */
} wcut_element_options;

/** The defaults stated at the fields. */
WCUT_API wcut_element_options wcut_element_options_default(void);

/** An element by itself, "wirecut-element/1": its job, its shared edges, and what is made of it. */
typedef struct wcut_element {
    wcut_job *job;
    double *border[4]; /**< WCUT_FACADE_SAMPLES [mm] or NULL, as in wcut_facade_element */
    bool upper;        /**< the panel is cast on the upper half */
    wcut_element_options options;
} wcut_element;

/**
 * Read an element: the input of its own run.
 *
 * @param[in]  path    a JSON file
 * @param[out] element the caller's, to wcut_element_destroy
 * @param[out] error   may be NULL; the JSON path, what was found, what was expected
 * @return WCUT_OK; WCUT_NOT_FOUND, WCUT_BAD_FORMAT, WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_element_read(const char *path, wcut_element **element, wcut_error *error);

/** Free an element; NULL is allowed. */
WCUT_API void wcut_element_destroy(wcut_element *element);

/**
 * The text of "wirecut-element-result/1": the cut's summary, the face with its points, the panel.
 *
 * @param[in]  element
 * @param[in]  setup   of its job
 * @param[in]  history of that setup, or as far as it goes
 * @param[in]  face    NULL: it has none
 * @param[in]  panel   NULL: it has none
 * @param[in]  refused why a face or a panel that was asked for is missing; NULL: nothing is
 * @param[out] text    for free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_element_result_print(const wcut_element *element, const wcut_setup *setup,
                                               const wcut_history *history, const wcut_element_face *face,
                                               const wcut_panel *panel, const char *refused, char **text);

/**
 * Plan the elements of a facade as a sweep in a folder: equal elements are one case, which wirecut facade runs on the
 * case's own input. wcut_sweep_run runs them, and only those that are not whole.
 *
 * @param[in]  description
 * @param[in]  options
 * @param[in]  folder  no line feed in its path
 * @param[out] sweep   the caller's, to wcut_sweep_destroy
 * @param[out] error   may be NULL
 * @return WCUT_OK; the statuses of wcut_sweep_create: no file of the folder was changed.
 */
WCUT_API wcut_status wcut_facade_sweep_create(const wcut_facade_description *description,
                                              const wcut_element_options *options, const char *folder,
                                              wcut_sweep **sweep, wcut_error *error);

/** What came of an element. Numbers that are not known are NaN. */
typedef struct wcut_facade_item {
    int distinct;                    /**< which of the distinct elements it is, from 0 in the order of the elements */
    char hash[WCUT_STUDY_HASH_SIZE]; /**< of its content: the folder of its results is cases/HH/HASH */
    wcut_sweep_state state;
    bool feasible;                 /**< cut to its end, and within the limits of cell and wire */
    char reason[240];              /**< why not, or what is near a limit; "" where there is nothing to say */
    double duration;               /**< [s] of cutting */
    double speed_min, speed_max;   /**< [mm/s] of the mounts */
    double radius_min;             /**< [mm] of the face */
    double foam_lower, foam_upper; /**< [mm3] of the halves, kerf left out */
    double area;                   /**< [mm2] of the face */
    double moved_max;              /**< [mm] of the face to its shared edges */
    double panel_volume;           /**< [mm3] */
    double panel_mass;             /**< [kg] */
    const wcut_element_face *face; /**< NULL: none; with the force */
} wcut_facade_item;

/** What came of a facade. */
typedef struct wcut_facade_results {
    const wcut_facade_description *description; /**< borrowed */
    int distinct;                               /**< elements of different content */
    wcut_facade_item *item;                     /**< facade->elements */
    wcut_element_face **face;                   /**< distinct; NULL where there is none */
    wcut_joint_report *joint;                   /**< facade->joints; NaN where an element has no face */
} wcut_facade_results;

/**
 * Collect the results of a facade's elements, as their folders have them.
 *
 * @param[in]  description outlives the results
 * @param[in]  options     those of wcut_facade_sweep_create
 * @param[in]  sweep       from wcut_facade_sweep_create of the same facade
 * @param[out] results     the caller's, to wcut_facade_results_destroy
 * @param[out] error       may be NULL
 * @return WCUT_OK, whatever came of them; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_facade_results_read(const wcut_facade_description *description,
                                              const wcut_element_options *options, const wcut_sweep *sweep,
                                              wcut_facade_results **results, wcut_error *error);

/** Free results; NULL is allowed. */
WCUT_API void wcut_facade_results_destroy(wcut_facade_results *results);

/**
 * The table of a facade: an element a row.
 *
 * @param[in]  results
 * @param[in]  path   the target, replaced whole or left as it was
 * @param[out] error  may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the target is as
 *         it was.
 */
WCUT_API wcut_status wcut_facade_write_csv(const wcut_facade_results *results, const char *path, wcut_error *error);

/**
 * The faces of a facade as glTF 2.0: a mesh for each distinct element, a node for each element where it stands, the
 * force on the wire as vertex colours on one scale.
 *
 * @param[in]  results at least one element with a face
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (no face), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the
 *         target is as it was.
 */
WCUT_API wcut_status wcut_facade_write_glb(const wcut_facade_results *results, const char *path, wcut_error *error);

/**
 * The exact faces of a facade as a STEP assembly: a part for each distinct element, set by transformations.
 *
 * @param[in]  results at least one element with a face
 * @param[in]  path    the target, replaced whole or left as it was
 * @param[out] error   may be NULL
 * @return WCUT_OK: the file is wholly on disk; WCUT_BAD_ARGUMENT (no face), WCUT_NO_MEMORY, WCUT_NOT_WRITTEN: the
 *         target is as it was.
 */
WCUT_API wcut_status wcut_facade_write_step(const wcut_facade_results *results, const char *path, wcut_error *error);

/**
 * The text of facade.json, "wirecut-facade-result/1" (FORMATS.md, Facade results).
 *
 * @param[in]  results
 * @param[out] text    for free(); ends with a line feed
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_facade_print(const wcut_facade_results *results, char **text);

#ifdef __cplusplus
}
#endif

#endif
