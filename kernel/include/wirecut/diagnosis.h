/* wirecut/diagnosis.h - what explains the difference between recordings, scans and simulation of a case. */
#ifndef WCUT_DIAGNOSIS_H
#define WCUT_DIAGNOSIS_H

#include <stdbool.h>
#include <wirecut/calibration.h>
#include <wirecut/cloud.h>
#include <wirecut/correction.h>
#include <wirecut/effects.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/recording.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Kind of verdict, its name in files. */
#define WCUT_VERDICT_LIST(X)    \
    X(NONE, "none")             \
    X(PHYSICS, "physics")       \
    X(INSTRUMENT, "instrument") \
    X(BOTH, "both")             \
    X(AMBIGUOUS, "ambiguous")   \
    X(UNKNOWN, "unknown")

#define WCUT_VERDICT_ENTRY(name, text) WCUT_VERDICT_##name,
/** What was decided. */
typedef enum wcut_verdict_kind { WCUT_VERDICT_LIST(WCUT_VERDICT_ENTRY) WCUT_VERDICT_COUNT } wcut_verdict_kind;
#undef WCUT_VERDICT_ENTRY

/** What of a cut is measured: both mounts together, and the scan. */
typedef enum wcut_evidence_channel {
    WCUT_EVIDENCE_CHANNEL_SPEED, /**< [mm/s] of the planned run, at tensions within 10 % of the target; never fitted */
    WCUT_EVIDENCE_CHANNEL_TENSION, /**< [N] */
    WCUT_EVIDENCE_CHANNEL_ALPHA,   /**< [deg] */
    WCUT_EVIDENCE_CHANNEL_BETA,    /**< [deg] */
    WCUT_EVIDENCE_CHANNEL_SCAN,    /**< [mm] signed distance along the face's normal */
    WCUT_EVIDENCE_CHANNEL_FORCE,   /**< [N] of a blade, against its advance */
    WCUT_EVIDENCE_CHANNEL_COUNT
} wcut_evidence_channel;

/* What differs from cut to cut in every rig, its name in files with its unit. */
#define WCUT_SCATTER_LIST(X)            \
    X(LEVEL, "block_level")             \
    X(LEVEL_B, "block_heat_response")   \
    X(LENGTH, "wire_length_mm")         \
    X(TENSION_ZERO, "tension_zero_N")   \
    X(ENCODER_ZERO, "encoder_zero_deg") \
    X(FRICTION, "encoder_friction_deg") \
    X(FACE, "scan_path_error_mm")       \
    X(SCAN_SHIFT, "scan_shift_mm")      \
    X(SCAN_TURN, "scan_turn_deg")

#define WCUT_SCATTER_ENTRY(name, text) WCUT_SCATTER_##name,
/** Scatter of a rig: a standard deviation from cut to cut each. */
typedef enum wcut_scatter_kind { WCUT_SCATTER_LIST(WCUT_SCATTER_ENTRY) WCUT_SCATTER_COUNT } wcut_scatter_kind;
#undef WCUT_SCATTER_ENTRY

/** What a cell knows of its own rig: how much things usually differ from cut to cut, and how late readings usually come. */
typedef struct wcut_rig_prior {
    double scatter[WCUT_SCATTER_COUNT]; /**< usual standard deviation, in the unit that its name says; positive */
    double tension_delay;               /**< [s] usual delay of the tension readings, positive */
    double angle_delay;                 /**< [s] the same of the angles */
} wcut_rig_prior;

/** A cut of the case; everything is borrowed. What is missing is NULL; the limits of the diagnosis name it. */
typedef struct wcut_diagnosis_cut {
    const wcut_job *job;             /**< path mode; NULL: the cut is left out */
    const wcut_recording *recording; /**< NULL: the cut is left out */
    const wcut_cloud *scan;          /**< NULL: not scanned */
} wcut_diagnosis_cut;

/** How a case is diagnosed. */
typedef struct wcut_diagnosis_options {
    int threads;                     /**< 1 or more; the result is the same for any number; default 1 */
    bool without[WCUT_EFFECT_COUNT]; /**< effects that are taken out of the library; default none */
    bool proof;                      /**< run the forward proof and the black box; default true */
    bool naive;                      /**< run plain least squares beside it, for comparison; default false */
    unsigned long long seed;         /**< of the simulated null distributions; default 1 */
    const wcut_rig_prior *rig;       /**< NULL, the default: wcut_rig_prior_default */
    const wcut_recording *still; /**< recorded while the mounts stand and the wire is slack and cold: its tensions are
                                          the sensors' zeros; NULL, the default: zeros are read in the air of the cuts */
} wcut_diagnosis_options;

/** A parameter with its interval. */
typedef struct wcut_estimate {
    double value, low, high; /**< 95 %; low = -inf, high = inf where the data leave it open */
} wcut_estimate;

enum { WCUT_DIAGNOSIS_EFFECTS = 4, WCUT_DIAGNOSIS_TEXT = 900 };
enum { WCUT_MODELLED_TERMS = 3, WCUT_MODELLED_RIVALS = 4, WCUT_MODELLED_EVENTS = 24 };

/** An effect that was found, or that stays possible. */
typedef struct wcut_found_effect {
    wcut_effect effect;                          /**< as a job would name it */
    wcut_estimate parameter[WCUT_EFFECT_VALUES]; /**< of effect.value, in the unit of its key */
    bool estimated[WCUT_EFFECT_VALUES];          /**< false: kept at its initial value */
    int cut;                                     /**< from 1, of which it is alone; 0: all */
    bool present;                                /**< named by the verdict; false: an alternative */
    double confidence;                           /**< 0 .. 1 that it is present */
} wcut_found_effect;

/** An effect that stands out of noise and scatter, but is below its size of consequence: the verdict does not name it. */
typedef struct wcut_small_effect {
    wcut_found_effect found;
    double gain;    /**< twice the logarithm of the ratio of likelihoods with and without it */
    double tension; /**< [N] that it moves the tensions by at most, means over 0.5 s */
    double face;    /**< [mm] that it moves the scanned faces by at most, means over patches; NaN without scans */
} wcut_small_effect;

/** One hypothesis of the ranking: none, one effect, or two. */
typedef struct wcut_hypothesis {
    int count;             /**< effects: 0 (recalibration alone), 1 or 2 */
    wcut_effect effect[2]; /**< with their best values */
    int parameters;        /**< fitted beyond recalibration */
    double gain;           /**< fall of the misfit (chi-square units) against recalibration alone */
    double held_out;       /**< the same on cuts that were not fitted, each predicted from the others */
    double adequacy;       /**< [1] remaining misfit over that of noise alone: 1 is adequate */
    double probability;    /**< 0 .. 1, over all hypotheses of the ranking */
    const char *why;       /**< why it was set aside, a constant text; "" of the one that was chosen */
} wcut_hypothesis;

enum { WCUT_RIG_CUTS = 64 };

/** What differs from cut to cut in the rig, or is alike in all of its recordings: no effect, and integrated out. */
typedef struct wcut_rig_row {
    char name[32];       /**< as wcut_scatter_name; also "tension_delay_s", "angle_delay_s", "path_error_mm" */
    wcut_estimate value; /**< standard deviation from cut to cut; of a delay its value */
    int cuts;            /**< of which a value of their own is known, WCUT_RIG_CUTS at most */
    int cut[WCUT_RIG_CUTS];
    wcut_estimate of_cut[WCUT_RIG_CUTS];
} wcut_rig_row;

/* What a recording contradicts, its name in files. */
#define WCUT_CONTRADICTION_LIST(X)           \
    X(EXCITATION, "excitation_not_followed") \
    X(HEATER, "heater_power")                \
    X(STATION, "station_scale")              \
    X(SPEED, "speed_scale")                  \
    X(PLACES, "mount_places")                \
    X(TENSION_ZERO, "tension_zero")

#define WCUT_CONTRADICTION_ENTRY(name, text) WCUT_CONTRADICTION_##name,
/** Columns of a recording against each other and against its job, found by subtraction, before any physics. */
typedef enum wcut_contradiction_kind {
    WCUT_CONTRADICTION_LIST(WCUT_CONTRADICTION_ENTRY) WCUT_CONTRADICTION_COUNT
} wcut_contradiction_kind;
#undef WCUT_CONTRADICTION_ENTRY

/** A contradiction. */
typedef struct wcut_contradiction {
    wcut_contradiction_kind kind;
    char column[32]; /**< the wrong column, or the one that does not follow its job: "station", "speed_command_mm_s" */
    int cuts;        /**< in which it is, WCUT_RIG_CUTS at most */
    int cut[WCUT_RIG_CUTS];
    double found, expected, error; /**< in the unit; error: one standard deviation of found, 0 where it is not known */
    char unit[8];                  /**< "share" (of the programme, of the set power, of the way), "N", "mm" */
    bool fault;                    /**< of an instrument; false: the cut was not made as the job states */
    bool common;                   /**< one value for all cuts */
    bool repaired;                 /**< the diagnosis uses the corrected case */
    char text[480];                /**< a sentence or two, with figures */
} wcut_contradiction;

/** A place where simulation and measurement differ by more than noise. */
typedef struct wcut_mismatch {
    int cut;
    wcut_evidence_channel channel;
    char column[24]; /**< "alpha_a_deg", or "scan" */
    double time[2];  /**< [s] of the recording */
    double station[2];
    double wire[2];     /**< [mm] along the wire in the foam; NaN: not determined */
    wcut_vec3 block[2]; /**< [mm] corners of the box where the wire, or the scanned face, was */
    double mean;        /**< measured less predicted, in the channel's unit */
    double share;       /**< 0 .. 1 of the whole misfit beyond noise */
    double p_value;     /**< corrected for the search */
    char regime[16];    /**< "entry", "steady", "exit", "" where it spans several */
} wcut_mismatch;

/** How far a model is from the measurements of a channel. */
typedef struct wcut_evidence_score {
    int count;                                 /**< 0: nothing to compare */
    double rmsd, rmse, nrmsd, rmse_over_range; /**< as wcut_score */
    double low, high;                          /**< 95 % of rmse_over_range over resampled blocks; NaN where not run */
} wcut_evidence_score;

/** The models that are compared: as the job says, recalibrated, with the effects found, and a fit without physics. */
typedef enum wcut_evidence_model {
    WCUT_EVIDENCE_MODEL_BEFORE,
    WCUT_EVIDENCE_MODEL_RECALIBRATED,
    WCUT_EVIDENCE_MODEL_AFTER,
    WCUT_EVIDENCE_MODEL_BLACK_BOX,
    WCUT_EVIDENCE_MODEL_COUNT
} wcut_evidence_model;

/** What the residual depends on, where no known effect explains it. */
typedef struct wcut_dependence {
    char quantity[40];             /**< "ln speed", "sin(2 pi y / 70 mm)" */
    wcut_evidence_channel channel; /**< that it changes most */
    wcut_estimate coefficient;     /**< relative change of the foam's force per unit of the quantity */
    double gain;                   /**< fall of the misfit on held-out cuts, chi-square units */
} wcut_dependence;

/** A window of one cut in which the force differs, and which no other cut repeats. */
typedef struct wcut_event {
    int cut;
    double time[2]; /**< [s] of the recording */
    double station[2];
    double tension; /**< [N] by which both tensions differ there, mean */
    double force;   /**< [1] relative change of the foam's force that explains it */
    double heat;    /**< [1] relative change of the heat that explains it */
} wcut_event;

/** A residual over time and wire, before and after, as the report draws it. */
typedef struct wcut_residual_trace {
    int cut;
    wcut_evidence_channel channel;
    char column[24];
    int count;
    double *time, *station;                /**< count: middles of bins [s], [1] */
    double *measured;                      /**< count: mean of a bin, channel's unit; NaN: none */
    double *before, *recalibrated, *after; /**< count: measured less replayed, channel's unit; NaN: none */
    double noise;                          /**< standard deviation of a bin's mean by noise alone */
} wcut_residual_trace;

/** What was modelled where the verdict is unknown: terms of empirical_force that hold on cuts left out, and events. */
typedef struct wcut_modelled {
    int terms; /**< 0: nothing was confirmed */
    wcut_found_effect term[WCUT_MODELLED_TERMS];
    char equation[240]; /**< "F = a exp(-b Q_eff) (1 + 0.32 sin(2 pi y / 70.1 mm + 4.06))" */
    int rivals;
    char rival[WCUT_MODELLED_RIVALS][80]; /**< terms that explain as much, as formulas */
    int events;
    wcut_event event[WCUT_MODELLED_EVENTS]; /**< windows that were left out of the fit of the rest */
    double recalibrated, after; /**< [N] of events: misfit of the tensions without, and with a level for each window,
                                   estimated from every other bin of it */
} wcut_modelled;

/** Where in space the worst misfit is: a cut as the model called "after" has it, and its scan. */
typedef struct wcut_diagnosis_view {
    int cut;         /**< -1: there is none */
    double time;     /**< [s] of the worst misfit */
    wcut_vec3 block; /**< [mm] of this cut */
    int rows, nodes;
    wcut_vec3 *surface; /**< rows x nodes [mm]: the wire, time after time */
    int worst;          /**< row of the worst misfit */
    int points;
    wcut_vec3 *point; /**< points [mm]: means over patches of the scan */
    double *distance; /**< points [mm] of the scan above the recalibrated wire's surface, along the normal */
} wcut_diagnosis_view;

/** A diagnosis: everything that was found, owned. */
typedef struct wcut_diagnosis {
    wcut_verdict_kind kind;
    double confidence;                  /**< 0 .. 1 that the verdict's effects are exactly right */
    double confidence_by;               /**< [1] what of the search it goes by: the abscissa of its regression */
    char sentence[WCUT_DIAGNOSIS_TEXT]; /**< for an operator */
    bool form_open; /**< the named effects are told as families: their forms leave more than noise */
    int effects;    /**< found and alternative, those present first */
    wcut_found_effect effect[WCUT_DIAGNOSIS_EFFECTS];
    int small_effects;                 /**< 0 or 1: present, but of no consequence for the cut */
    wcut_small_effect small_effect;    /**< where there is one */
    wcut_estimate a, b, length_change; /**< [N/mm], [m^2/J], [mm]: recalibrated, shared by all cuts */
    wcut_estimate kerf;                /**< [mm] constant kerf that the scans show; NaN without scans */
    double a_job, b_job;               /**< what the jobs say */
    double swift; /**< [1] tension's noise from half second to half second over what its readings say; 0: not known */
    double droop; /**< [s] left out at the entry, where slack wires hang by their weight; 0: nothing */
    double adequacy, adequacy_p; /**< of the chosen model; p-value against its simulated null */
    int hypotheses;
    wcut_hypothesis *hypothesis; /**< ranked, best first */
    int contradictions;
    wcut_contradiction *contradiction; /**< found before any physics, in the order of their checks */
    int mismatches;
    wcut_mismatch *mismatch; /**< largest share first */
    int dependences;         /**< the terms of `modelled`, each as one quantity */
    wcut_dependence *dependence;
    wcut_modelled modelled;
    wcut_diagnosis_view view;
    int traces;
    wcut_residual_trace *trace;
    int rig_rows;
    wcut_rig_row *rig; /**< the scatter that was found */
    int cuts;
    bool *held_out; /**< cuts: not used in the fit that the held-out figures are of */
    wcut_evidence_score score[WCUT_EVIDENCE_MODEL_COUNT][WCUT_EVIDENCE_CHANNEL_COUNT]; /**< over all cuts, all fitted */
    wcut_evidence_score held_out_score[WCUT_EVIDENCE_MODEL_COUNT]
                                      [WCUT_EVIDENCE_CHANNEL_COUNT]; /**< over the held-out cuts */
    wcut_correction correction; /**< the model called "after", for any job; not to be used where it is withheld */
    char withheld[160];         /**< why there is no correction and no `improved`; "" where there is one */
    wcut_job *improved;        /**< the first cut's job, corrected, without its excitation; NULL where it is withheld */
    wcut_job *next_experiment; /**< a cut that would separate the alternatives; NULL: none needed */
    char next_reason[WCUT_DIAGNOSIS_TEXT];
    int limits;
    char (*limit)[WCUT_DIAGNOSIS_TEXT];        /**< what could not be determined, and why */
    double noise[WCUT_EVIDENCE_CHANNEL_COUNT]; /**< standard deviation of a sample, channel's unit; NaN: none */
    char unprofiled[120];                      /**< why intervals are of the curvature alone; empty: of a profile */
    char unproven[120];                        /**< why there is no forward proof; empty: there is one */
    bool naive_false;                          /**< whether plain least squares on the recorded speed names an effect */
    char naive[80];                            /**< which */
    bool interrupted;
    char stopped[80]; /**< "while pairs of effects were fitted": where it was cut short; "" of a whole one */
} wcut_diagnosis;

/** The defaults stated at the fields. */
WCUT_API wcut_diagnosis_options wcut_diagnosis_options_default(void);

/** An ordinary cell: blocks 5 %, wires 1 mm, zeros 0.015 N and 0.05 deg, play 0.25 deg, readings 0.1 s late. */
WCUT_API wcut_rig_prior wcut_rig_prior_default(void);

/** The name of a verdict in files, "physics"; "" outside the enum. */
WCUT_API const char *wcut_verdict_name(wcut_verdict_kind kind);

/** The name of a kind of scatter in files with its unit, "wire_length_mm"; "" outside the enum. */
WCUT_API const char *wcut_scatter_name(wcut_scatter_kind kind);

/** The name of a kind of contradiction in files, "station_scale"; "" outside the enum. */
WCUT_API const char *wcut_contradiction_name(wcut_contradiction_kind kind);

/** The name of a channel in files, "tension", and its unit, "N"; "" outside the enum. */
WCUT_API const char *wcut_evidence_name(wcut_evidence_channel channel);
/** The unit of a channel in files, "N"; "" outside the enum. */
WCUT_API const char *wcut_evidence_unit(wcut_evidence_channel channel);

/**
 * Diagnose a case: recalibrate, locate the remaining misfit, try every effect and every pair of them, decide, and show
 * by cuts that were not fitted how well the decision predicts. Method: NOTATION.md, Diagnosis.
 *
 * @param[in]  cuts        at least 1
 * @param[in]  cut         cuts
 * @param[in]  test_cuts   0 where there is no calibration table
 * @param[in]  calibration test_cuts, steady
 * @param[in]  options     NULL for the defaults
 * @param[in]  progress    may be NULL; steps done of all; return non-zero to stop. Called in the caller's thread alone,
 *                         every few milliseconds
 * @param[in]  context     handed to progress
 * @param[out] diagnosis   the caller's, to wcut_diagnosis_destroy
 * @param[out] error       may be NULL; the cut and what is wrong with it
 * @return WCUT_OK; WCUT_INTERRUPTED: what was found so far, marked, in its sentence too; nothing where not even the
 *         recalibration was fitted; WCUT_BAD_ARGUMENT (no usable cut), WCUT_DEGENERATE (a job that cannot be
 *         simulated), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_diagnosis_create(int cuts, const wcut_diagnosis_cut *cut, int test_cuts,
                                           const wcut_test_cut *calibration, const wcut_diagnosis_options *options,
                                           wcut_progress progress, void *context, wcut_diagnosis **diagnosis,
                                           wcut_error *error);

/** Free a diagnosis with everything in it; NULL is allowed. */
WCUT_API void wcut_diagnosis_destroy(wcut_diagnosis *diagnosis);

/**
 * A set of identification cuts for a job: copies of it with a dithered speed and stepped heater, the second run
 * backwards along its path where that can be planned, so that lags, rates, heats and places can be told apart.
 *
 * @param[in]  job   path mode, can be simulated
 * @param[in]  count cuts wanted, 1 .. 8
 * @param[in]  seed  of the phases
 * @param[out] out   count, the caller's, each to wcut_job_destroy
 * @param[out] error may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE, WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_identification_create(const wcut_job *job, int count, unsigned long long seed, wcut_job **out,
                                                wcut_error *error);

#ifdef __cplusplus
}
#endif

#endif
