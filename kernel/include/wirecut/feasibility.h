/* wirecut/feasibility.h - whether a cut can be made, and if not, why. */
#ifndef WCUT_FEASIBILITY_H
#define WCUT_FEASIBILITY_H

#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/robot.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The verdict. */
typedef enum wcut_feasibility_verdict {
    WCUT_FEASIBILITY_VERDICT_FEASIBLE, /**< every figure is below 95 % of its limit */
    WCUT_FEASIBILITY_VERDICT_AT_LIMIT, /**< a figure is between 95 and 100 % of its limit, none beyond; not the speed:
                                            a wire out of the foam is fed at the largest */
    WCUT_FEASIBILITY_VERDICT_INFEASIBLE
} wcut_feasibility_verdict;

/** What is judged at every station, the rows of the map. */
typedef enum wcut_feasibility_measure {
    WCUT_FEASIBILITY_MEASURE_SPEED,  /**< of the faster mount, over the limit */
    WCUT_FEASIBILITY_MEASURE_ALPHA,  /**< larger of both mounts, over the head's range */
    WCUT_FEASIBILITY_MEASURE_BETA,   /**< larger of both mounts, over the head's range */
    WCUT_FEASIBILITY_MEASURE_TURN,   /**< of the wire's motion in the foam from step to step, over 90 deg: a wire that
                                          goes back runs in its own slot, which is not modelled */
    WCUT_FEASIBILITY_MEASURE_STRESS, /**< of the wire, over its strength at its temperature in air */
    WCUT_FEASIBILITY_MEASURE_COUNT
} wcut_feasibility_measure;

/** A verdict and its reason. */
typedef struct wcut_feasibility {
    wcut_feasibility_verdict verdict;
    int station;       /**< of the reason; -1: everywhere, or nowhere */
    double radius_min; /**< [mm] smallest radius that the foam can bend the wire to, T / F over all stations */
    char reason[240];  /**< a sentence in ASCII */
} wcut_feasibility;

/**
 * Judge a cut against the limits of cell and wire before it is made. Infeasible whatever the limits, with its reason: a
 * design with an edge that runs in a loop (turns by more than 270 deg to one side), a run that ends early or with wire
 * in the foam, a wire that stands at more than 100 deg to its rest direction.
 *
 * @param[in]  job     that the history came from
 * @param[in]  history at least one station
 * @param[in]  mount_a history->stations [mm], from wcut_history_path
 * @param[in]  mount_b history->stations [mm]
 * @param[in]  limits  NULL for the defaults, as for wcut_robot_limits_check
 * @param[out] verdict
 * @param[out] share   WCUT_FEASIBILITY_MEASURE_COUNT x history->stations [1] value over limit, row by row; may be NULL
 * @return WCUT_OK, whatever the verdict; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_feasibility_eval(const wcut_job *job, const wcut_history *history, const wcut_vec3 *mount_a,
                                           const wcut_vec3 *mount_b, const wcut_robot_limits *limits,
                                           wcut_feasibility *verdict, double *share);

/** The word of a verdict: "feasible", "at the limit", "infeasible". */
WCUT_API const char *wcut_feasibility_name(wcut_feasibility_verdict verdict);

#ifdef __cplusplus
}
#endif

#endif
