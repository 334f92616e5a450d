/* wirecut/bow.h - what users of a bow ask of a cut: how far the wire bows, where the face is bent by it, how fast it may go. */
#ifndef WCUT_BOW_H
#define WCUT_BOW_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/robot.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A station of a bow. */
typedef struct wcut_bow_row {
    double bow;           /**< [mm] largest distance of a node from the straight line between the wire's ends */
    int node;             /**< where */
    double closing;       /**< [mm] by which the frame's ends are closer than at rest; negative: further apart */
    wcut_vec3 force;      /**< [N] of the foam on the tool, in the tool's frame; without a tool in the block's */
    wcut_vec3 moment;     /**< [N mm] of it about the tool's origin; without a tool about the middle of the mounts */
    double tension;       /**< [N] larger of both mounts */
    double departure_max; /**< [mm] largest size of the row's departures, 0 where no node is in the foam */
} wcut_bow_row;

enum { WCUT_FEED_CHART_HEATS = 11, WCUT_FEED_CHART_BOWS = 3 };

/** The bows that a feed chart is made for [mm]: 0.5, 1, 2. */
WCUT_API const double *wcut_feed_chart_bows(void);

/** One heat of a feed chart: straight cuts with the widest engagement of the run, steady. */
typedef struct wcut_feed_chart_row {
    double heat;                          /**< [W/m] */
    double temperature;                   /**< [degC] of the wire in still air */
    bool too_hot;                         /**< beyond the limit of temperature */
    double strength;                      /**< [N] of the wire at that temperature */
    double feed[WCUT_FEED_CHART_BOWS];    /**< [mm/s] largest for each bow; at most speed_max */
    double kerf[WCUT_FEED_CHART_BOWS];    /**< [mm] of the job's kerf at that feed */
    double tension[WCUT_FEED_CHART_BOWS]; /**< [N] of the wire at that feed */
    double allowed[WCUT_FEED_CHART_BOWS]; /**< [mm/s] the same where the wire is neither too hot nor pulled beyond
                                               its strength; 0: none */
} wcut_feed_chart_row;

/** A place on the cut where a figure is largest. */
typedef struct wcut_bow_place {
    double value; /**< [mm] */
    int station, node;
    wcut_vec3 at; /**< [mm] */
} wcut_bow_place;

/** What a bow's cut came to. */
typedef struct wcut_bow_results {
    int stations, nodes;
    wcut_bow_row *row;  /**< stations */
    double *departure;  /**< stations x nodes [mm] of a node in the foam from the ruled surface that the straight line
                                   between the mounts sweeps, positive above it (along x cross feed); NaN outside the foam */
    wcut_bow_place bow; /**< largest */
    wcut_bow_place departure_max; /**< of the largest size */
    double tension_max;           /**< [N] */
    int tension_station;
    double force_max;   /**< [N] largest size of the force on the tool */
    double moment_max;  /**< [N mm] */
    double slack_share; /**< [1] of the stations at which the wire hangs without tension: heat takes its pretension */
    double temperature; /**< [degC] of the wire in still air at the job's heat */
    double strength;    /**< [N] of the wire at that temperature */
    wcut_feed_chart_row chart[WCUT_FEED_CHART_HEATS]; /**< 0.5 to 1.5 times the job's heat */
} wcut_bow_results;

/**
 * Evaluate a bow's cut.
 *
 * @param[in]  setup   of a bow
 * @param[in]  history of that setup, at least two stations
 * @param[in]  limits  NULL for the defaults, as for wcut_robot_limits_check
 * @param[out] results the caller's, to wcut_bow_results_destroy
 * @param[out] error   may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a setup of another rig, limits out of range, a wire beyond 3000 degC),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_bow_results_create(const wcut_setup *setup, const wcut_history *history,
                                             const wcut_robot_limits *limits, wcut_bow_results **results,
                                             wcut_error *error);

/** Free results; NULL is allowed. */
WCUT_API void wcut_bow_results_destroy(wcut_bow_results *results);

#ifdef __cplusplus
}
#endif

#endif
