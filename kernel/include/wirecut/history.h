/* wirecut/history.h - a whole cut in memory: every station's nodes, forces and scalars. */
#ifndef WCUT_HISTORY_H
#define WCUT_HISTORY_H

#include <wirecut/cut.h>
#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One station without its arrays. */
typedef struct wcut_history_row {
    double time, duration;                   /**< [s] */
    double speed_a, speed_b;                 /**< [mm/s] */
    double tension_a, tension_b;             /**< [N] */
    double alpha_a, beta_a, alpha_b, beta_b; /**< [rad] */
    double engaged_length;                   /**< [mm] */
    double residual;                         /**< [1] */
    int iterations, substeps;
    wcut_phase phase;
    wcut_condition condition;
} wcut_history_row;

/** A cut from its first station to its last, or to where it could not go on. */
typedef struct wcut_history {
    int stations;          /**< m, those that were reached */
    int planned;           /**< stations that the job asked for */
    int nodes;             /**< n */
    wcut_history_row *row; /**< m */
    wcut_vec3 *position;   /**< m x n [mm] */
    wcut_vec3 *force;      /**< m x n [N] */
    double *force_line;    /**< m x n [N/mm] */
    double *speed;         /**< m x n [mm/s] */
    wcut_error ended;      /**< why it ends before the last planned station; status WCUT_OK where it does not */
    double *tension;       /**< m x (n-1) [N] */
} wcut_history;

/** Called after every station; return 0 to go on, anything else to stop. */
typedef int (*wcut_progress)(int station, int stations, void *context);

/**
 * Run a setup from its first station to its last.
 *
 * @param[in]  setup    shared
 * @param[in]  progress may be NULL
 * @param[in]  context  handed to progress
 * @param[out] history  the caller's, to wcut_history_destroy
 * @param[out] error    may be NULL; station and cause
 * @return WCUT_OK; WCUT_NOT_CONVERGED, WCUT_INTERRUPTED: history holds every station reached;
 *         WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_setup_run(const wcut_setup *setup, wcut_progress progress, void *context,
                                    wcut_history **history, wcut_error *error);

/** Free a history; NULL is allowed. */
WCUT_API void wcut_history_destroy(wcut_history *history);

/**
 * The ways of both mounts along which a cut was made, of the stations that it reached.
 *
 * @param[in]  setup   that the history came from
 * @param[in]  history of that setup, at least one station
 * @param[out] mount_a history->stations [mm]
 * @param[out] mount_b history->stations [mm]
 * @param[out] length  [mm] the one wire length between the mounts
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_history_path(const wcut_setup *setup, const wcut_history *history, wcut_vec3 *mount_a,
                                       wcut_vec3 *mount_b, double *length, wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
