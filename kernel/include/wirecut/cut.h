/* wirecut/cut.h - set up a cut and advance the wire through the foam, station by station. */
#ifndef WCUT_CUT_H
#define WCUT_CUT_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How the wire is advanced from station to station. */
typedef enum wcut_integrator {
    WCUT_INTEGRATOR_IMPLICIT, /**< shape, edge tensions and rate solved together at the new station */
    WCUT_INTEGRATOR_HEUN /**< the paper's accumulated forces (9)-(11); unstable for short steps, kept for comparison */
} wcut_integrator;

/** Where along the cut a station is. */
typedef enum wcut_phase {
    WCUT_PHASE_APPROACH, /**< no contact yet */
    WCUT_PHASE_ENTRY,    /**< in contact, the mounts approach each other or not all of the wire's span is in */
    WCUT_PHASE_STEADY,   /**< the whole width engaged, mounts moving in parallel */
    WCUT_PHASE_EXIT,     /**< the mounts part, or the wire is leaving the block */
    WCUT_PHASE_LEFT      /**< contact is over */
} wcut_phase;

/** Which side of the complementarity v <= v_max, T <= k set the rate. */
typedef enum wcut_condition {
    WCUT_CONDITION_TENSION,   /**< (4) holds with equality */
    WCUT_CONDITION_SPEED_MAX, /**< v = v_max and T < k, or no contact */
    WCUT_CONDITION_SPEED_MIN, /**< v = v_min and T > k */
    WCUT_CONDITION_TIME       /**< time-driven: the step's duration was given, by a feed or by the caller */
} wcut_condition;

/** Settings of the solver; the job says what is cut, these say how finely it is solved. */
typedef struct wcut_cut_options {
    wcut_integrator integrator; /**< default WCUT_INTEGRATOR_IMPLICIT */
    double tolerance;           /**< [1] largest relative residual to accept; default 1e-10 */
    int max_iterations;         /**< Newton iterations a (sub-)step; default 40 */
    int max_halvings;           /**< a step may be cut into 2^this sub-steps; default 10 */
    bool weighted; /**< a loose wire has a weight of 1e-4 of the tension: slower, for first contacts where no
                                     equilibrium is found otherwise; default false; wcut_setup_run tries it by itself
                                     where a run ends early */
} wcut_cut_options;

/** A station of the history; the arrays are borrowed until the next step of the same cut. */
typedef struct wcut_station {
    int index;                 /**< 0 .. stations-1 */
    double time;               /**< [s] since station 0 */
    double duration;           /**< [s] since the station before; 0 at station 0 */
    int nodes;                 /**< n */
    const wcut_vec3 *position; /**< n [mm] from mount A to mount B */
    const wcut_vec3 *force;    /**< n [N] of the foam on the node, (3) */
    const double *force_line;  /**< n [N/mm] force across the wire per engaged length, F(v_i, Q_i) |t x d|; 0 outside */
    const double *speed;       /**< n [mm/s] of the node; station 0: 0 */
    const double *tension;     /**< n-1 [N] of the edge; in design mode too */
    const double *engaged;     /**< n [1] how much of the node's length is in the foam */
    wcut_vec3 mount_a, mount_b; /**< [mm] where the mounts were led; the wire's ends are there unless mounts give way */
    double speed_a, speed_b;    /**< [mm/s] of the mounts */
    double tension_a, tension_b;
    double alpha_a, beta_a, alpha_b, beta_b; /**< [rad] signs: FORMATS.md, Rules */
    double engaged_length;                   /**< [mm] of wire in the foam */
    wcut_phase phase;
    wcut_condition condition;
    int iterations;  /**< Newton iterations of this station, sub-steps together */
    int substeps;    /**< 1 where the step was not cut */
    double residual; /**< [1] largest relative residual of the accepted solution */
} wcut_station;

typedef struct wcut_setup wcut_setup; /**< const and shared: job, paths, tables */
typedef struct wcut_cut wcut_cut;     /**< one run: mutable, belongs to one thread at a time */

/** The defaults stated at the fields. */
WCUT_API wcut_cut_options wcut_cut_options_default(void);

/**
 * Check a job and prepare everything that runs share.
 *
 * A design is planned first: a wire that runs from edge to edge, foam all about it, with the given extra length. Its
 * ends prolonged along their tangents give the mounts' way, with an approach before the block and a way out behind it.
 * Runs of the setup follow this path, with foam in the block alone. Where the plan ends early, so do the runs, with
 * its reason.
 *
 * @param[in]  job     copied; may be freed afterwards
 * @param[in]  options NULL for the defaults
 * @param[out] setup   the caller's, to wcut_setup_destroy after its last cut
 * @param[out] error   may be NULL; says which key is wrong and what was expected
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a value out of range, an array is NULL though its count is not 0),
 *         WCUT_DEGENERATE (wire shorter than a chord, no contact with the block, a mount inside the block, a design's
 *         edge more than 0.1 mm outside it, a design's wire that does not leave the block at its edge),
 *         WCUT_NOT_CONVERGED (a design's first wire has no equilibrium), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_setup_create(const wcut_job *job, const wcut_cut_options *options, wcut_setup **setup,
                                       wcut_error *error);

/** Free a setup; NULL is allowed. */
WCUT_API void wcut_setup_destroy(wcut_setup *setup);

/** The stations of a setup's runs. */
typedef struct wcut_setup_span {
    int stations;              /**< of a run, from 0 on */
    int part_first, part_last; /**< a design's own stations: before them an approach, behind them a way out */
} wcut_setup_span;

/** Path mode: the job's stations. Design mode: those of the path that the design became, see wcut_setup_path_job. */
WCUT_API wcut_setup_span wcut_setup_stations(const wcut_setup *setup);

/**
 * The path-mode job that a setup cuts: of a design both mounts' way with its approach and its way out, and the one
 * length of wire between them; of a path-mode job the job. Its own setup makes the same run, to the last digit.
 *
 * @param[in]  setup
 * @param[out] job   the caller's, to wcut_job_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_CONVERGED (a design whose plan ends early: a run says where and why),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_setup_path_job(const wcut_setup *setup, wcut_job **job);

/** The job that a setup was made from, borrowed. */
WCUT_API const wcut_job *wcut_setup_job(const wcut_setup *setup);

/** The options that a setup was made with, defaults filled in, borrowed. */
WCUT_API const wcut_cut_options *wcut_setup_options(const wcut_setup *setup);

/**
 * Begin a run: station 0, the wire in equilibrium, trailing behind the mounts.
 *
 * @param[in]  setup shared, must outlive the cut
 * @param[out] cut   the caller's, to wcut_cut_destroy
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_CONVERGED (no equilibrium at station 0), WCUT_NO_MEMORY:
 *         nothing was written.
 */
WCUT_API wcut_status wcut_cut_create(const wcut_setup *setup, wcut_cut **cut, wcut_error *error);

/** Free a run; NULL is allowed. */
WCUT_API void wcut_cut_destroy(wcut_cut *cut);

/**
 * Advance to the next station, tension-driven, or at the commanded speed of a job with a feed: then the tensions are the
 * answer. Allocates nothing.
 *
 * @param[in,out] cut   a run that has stations left
 * @param[out]    error may be NULL; station and cause
 * @return WCUT_OK; WCUT_NOT_FOUND: the path is over; WCUT_NOT_CONVERGED: the run is over; wcut_cut_view
 *         still gives the station before.
 */
WCUT_API wcut_status wcut_cut_step(wcut_cut *cut, wcut_error *error);

/**
 * Advance to given mount positions in a given time, time-driven: the tensions are the answer. Same equations,
 * path mode only, implicit only. Allocates nothing.
 *
 * @param[in,out] cut      a run
 * @param[in]     mount_a  [mm]
 * @param[in]     mount_b  [mm] no further from A than the wire is long
 * @param[in]     duration [s] positive
 * @param[in]     heat     [W/m] over the step, positive
 * @param[out]    error    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT; WCUT_NOT_CONVERGED: the state is as it was.
 */
WCUT_API wcut_status wcut_cut_drive(wcut_cut *cut, wcut_vec3 mount_a, wcut_vec3 mount_b, double duration, double heat,
                                    wcut_error *error);

/**
 * The station at which the run is.
 *
 * @param[in]  cut     a run
 * @param[out] station its arrays are borrowed until the next step or the cut's end
 */
WCUT_API void wcut_cut_view(const wcut_cut *cut, wcut_station *station);

/** The name of a phase as it stands in path.csv. */
WCUT_API const char *wcut_phase_name(wcut_phase phase);

/** The name of a condition: "tension", "speed_max", "speed_min", "time". */
WCUT_API const char *wcut_condition_name(wcut_condition condition);

#ifdef __cplusplus
}
#endif

#endif
