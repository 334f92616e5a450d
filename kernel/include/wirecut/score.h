/* wirecut/score.h - how far predictions are from a recording, by channel and phase. */
#ifndef WCUT_SCORE_H
#define WCUT_SCORE_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/replay.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Measured against predicted values, x and y; the differences are d = x - y. */
typedef struct wcut_score {
    int count;              /**< n, pairs; all else is 0 where it is 0 */
    double bias;            /**< mean d */
    double rmsd;            /**< sqrt(sum (d - bias)^2 / (n - 1)), the sample standard deviation; 0 where n = 1 */
    double rmse;            /**< sqrt(sum d^2 / n) */
    double range;           /**< the divisor: range of the measured values, or as given */
    double nrmsd;           /**< [1] rmsd / range, without the bias; 0 where the range is 0 */
    double rmse_over_range; /**< [1] rmse / range, with the bias; 0 where the range is 0 */
    double correlation;     /**< [1] Pearson's; 0 where x or y does not vary */
    bool correlated;        /**< whether both vary */
} wcut_score;

/**
 * The figures of one channel (Rust et al. 2016, note 4; bias, RMSE and correlation beside it).
 *
 * @param[in]  n         at least 0
 * @param[in]  measured  n, finite
 * @param[in]  predicted n, finite
 * @param[in]  range     positive: divide by this; 0: by the range of the measured values
 * @param[out] score     every field
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_score_eval(int n, const double *measured, const double *predicted, double range,
                                     wcut_score *score);

/**
 * The mean of every figure over the scores that have samples; those without a range, or a correlation, are left out of
 * the means of what they lack.
 *
 * @param[in]  n     at least 0
 * @param[in]  score n
 * @param[out] mean  its count is that of the scores with samples
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_score_mean(int n, const wcut_score *score, wcut_score *mean);

/* Scored channel, its name in files, unit in files, first and last of its signals. */
#define WCUT_SCORED_LIST(X)                  \
    X(SPEED, "speed", "mm/s", 0, 1)          \
    X(TENSION, "tension", "N", 2, 3)         \
    X(ALPHA, "alpha", "deg", 4, 6)           \
    X(BETA, "beta", "deg", 5, 7)             \
    X(SPEED_A, "speed_a_mm_s", "mm/s", 0, 0) \
    X(SPEED_B, "speed_b_mm_s", "mm/s", 1, 1) \
    X(TENSION_A, "tension_a_N", "N", 2, 2)   \
    X(TENSION_B, "tension_b_N", "N", 3, 3)   \
    X(ALPHA_A, "alpha_a_deg", "deg", 4, 4)   \
    X(BETA_A, "beta_a_deg", "deg", 5, 5)     \
    X(ALPHA_B, "alpha_b_deg", "deg", 6, 6)   \
    X(BETA_B, "beta_b_deg", "deg", 7, 7)

#define WCUT_SCORED_ENTRY(name, text, unit, first, last) WCUT_SCORED_##name,
/** What is scored: both mounts together (their differences pooled, one range), then each column of a recording. */
typedef enum wcut_scored { WCUT_SCORED_LIST(WCUT_SCORED_ENTRY) WCUT_SCORED_COUNT } wcut_scored;
#undef WCUT_SCORED_ENTRY

/** The name of a scored channel in files, "speed" or "speed_a_mm_s"; "" outside the enum. */
WCUT_API const char *wcut_scored_name(wcut_scored scored);

/** The unit of a scored channel in files, "mm/s", "N" or "deg"; "" outside the enum. */
WCUT_API const char *wcut_scored_unit(wcut_scored scored);

/** The part of a cut that a score is of. */
typedef enum wcut_part { WCUT_PART_ALL, WCUT_PART_ENTRY, WCUT_PART_STEADY, WCUT_PART_EXIT, WCUT_PART_COUNT } wcut_part;

/** The name of a part: "all", "entry", "steady", "exit"; "" outside the enum. */
WCUT_API const char *wcut_part_name(wcut_part part);

/** What of a recording counts, and how it is replayed. */
typedef struct wcut_comparison_options {
    wcut_replay_options replay;
    /** [1] of the solver, positive. Default 1e-6: against 1e-10 tensions move by 1e-5 N in the mean, a thousandth of a
        sensor's noise, for three quarters of the iterations. */
    double tolerance;
    double settle; /**< [s] left out after the first contact, where measured data oscillate; default 2 */
    double leave;  /**< [s] left out before the wire leaves, or the recording ends; default 1 */
} wcut_comparison_options;

/** Scores of a prediction. */
typedef struct wcut_scores {
    /** A phase's figures are over the range of the whole cut: they compare, and noise does not become a range. */
    wcut_score of[WCUT_SCORED_COUNT][WCUT_PART_COUNT];
} wcut_scores;

/** A recording beside its two predictions. */
typedef struct wcut_comparison {
    int samples;
    wcut_phase *phase;      /**< samples: of the planned run at the nearest station; the last known beyond it */
    unsigned char *counted; /**< samples: 1 where it is scored */
    int counted_samples;    /**< how many */
    double contact, leave;  /**< [s] when the recording passes the plan's first contact, and where it leaves */
    double from, to;        /**< [s] what is scored: contact + settle .. leave - options.leave */
    wcut_prediction *planned;
    wcut_prediction *replayed;
    wcut_scores planned_score;
    wcut_scores replayed_score; /**< of tensions and angles; the speed was its input: count 0 */
} wcut_comparison;

/** The defaults stated at the fields. */
WCUT_API wcut_comparison_options wcut_comparison_options_default(void);

/**
 * Plan a job, replay its recording, and score both.
 *
 * A sample counts where its time is in from .. to and the plan has the wire in the foam there; missing measurements and
 * missing predictions are left out channel by channel.
 *
 * @param[in]  job        path mode
 * @param[in]  recording  of that job
 * @param[in]  options    NULL for the defaults
 * @param[out] comparison the caller's, to wcut_comparison_destroy
 * @param[out] error      may be NULL
 * @return WCUT_OK (a plan or replay that failed in parts says so in its prediction); WCUT_BAD_ARGUMENT, WCUT_DEGENERATE
 *         (as wcut_setup_create, wcut_prediction_replay; the plan has no contact), WCUT_NOT_CONVERGED (no equilibrium
 *         at station 0), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_comparison_create(const wcut_job *job, const wcut_recording *recording,
                                            const wcut_comparison_options *options, wcut_comparison **comparison,
                                            wcut_error *error);

/** Free a comparison; NULL is allowed. */
WCUT_API void wcut_comparison_destroy(wcut_comparison *comparison);

/**
 * wcut_comparison_create for many cuts, in parallel; the results are the same for any number of threads.
 *
 * @param[in]  n          at least 0
 * @param[in]  job        n; a cut whose job or recording is NULL is skipped
 * @param[in]  recording  n
 * @param[in]  options    NULL for the defaults
 * @param[in]  progress   may be NULL; must not start another run; called by one thread at a time after every cut,
 *                        with the number of cuts done before it
 * @param[in]  context    handed to progress
 * @param[out] comparison n, NULL where a cut was skipped or failed
 * @param[out] error      n, with the status of every cut that was tried
 * @return WCUT_OK, also where cuts failed; WCUT_INTERRUPTED: cuts not begun are NULL, with that status;
 *         WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_comparison_run(int n, const wcut_job *const *job, const wcut_recording *const *recording,
                                         const wcut_comparison_options *options, wcut_progress progress, void *context,
                                         wcut_comparison **comparison, wcut_error *error);

/**
 * The mean of every score over cuts, as wcut_score_mean.
 *
 * @param[in]  n          at least 0
 * @param[in]  comparison n; NULL ones are skipped
 * @param[out] planned    every score
 * @param[out] replayed   every score
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_scores_mean(int n, const wcut_comparison *const *comparison, wcut_scores *planned,
                                      wcut_scores *replayed);

/** A cut as the files name it; everything is borrowed. */
typedef struct wcut_scored_cut {
    const char *of_case;               /**< the case's name; NULL: none */
    const char *name;                  /**< of the cut */
    const char *job, *recording;       /**< files */
    const wcut_recording *samples;     /**< NULL where the cut failed */
    const wcut_comparison *comparison; /**< NULL where the cut failed */
    const wcut_error *error;           /**< why it failed */
} wcut_scored_cut;

#ifdef __cplusplus
}
#endif

#endif
