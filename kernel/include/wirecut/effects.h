/* wirecut/effects.h - what the plain model leaves out: physics and instrument faults, each switched on by its name. */
#ifndef WCUT_EFFECTS_H
#define WCUT_EFFECTS_H

#include <stdbool.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Effect, its name in files, where it acts. Physics acts in the STEP of the simulator or on the cut FACE, an instrument
   fault on what SENSORs record or on the SCAN. Equations: NOTATION.md, Effects. */
#define WCUT_EFFECT_LIST(X)                                 \
    X(WIRE_THERMAL_LAG, "wire_thermal_lag", STEP)           \
    X(AIR_OVERHEATING, "air_overheating", STEP)             \
    X(END_COOLING, "end_cooling", STEP)                     \
    X(FOAM_DENSITY_GRADIENT, "foam_density_gradient", STEP) \
    X(FOAM_INCLUSION, "foam_inclusion", STEP)               \
    X(TANGENTIAL_DRAG, "tangential_drag", STEP)             \
    X(WIRE_ELONGATION, "wire_elongation", STEP)             \
    X(MOUNT_COMPLIANCE, "mount_compliance", STEP)           \
    X(RATE_DEPENDENCE, "rate_dependence", STEP)             \
    X(WIRE_FOULING, "wire_fouling", STEP)                   \
    X(EMPIRICAL_FORCE, "empirical_force", STEP)             \
    X(KERF_GROWTH, "kerf_growth", FACE)                     \
    X(BLOCK_SPRINGBACK, "block_springback", FACE)           \
    X(ANGLE_OFFSET, "angle_offset", SENSOR)                 \
    X(TENSION_GAIN, "tension_gain", SENSOR)                 \
    X(TENSION_DRIFT, "tension_drift", SENSOR)               \
    X(CLOCK_OFFSET, "clock_offset", SENSOR)                 \
    X(TENSION_DELAY, "tension_delay", SENSOR)               \
    X(TENSION_ZERO, "tension_zero", SENSOR)                 \
    X(ANGLE_GAIN, "angle_gain", SENSOR)                     \
    X(ENCODER_FRICTION, "encoder_friction", SENSOR)         \
    X(EMPIRICAL_READING, "empirical_reading", SENSOR)       \
    X(SCAN_OFFSET, "scan_offset", SCAN)                     \
    X(SCAN_SCALE, "scan_scale", SCAN)

#define WCUT_EFFECT_ENTRY(name, text, acts) WCUT_EFFECT_##name,
/** Every effect that a job may name. */
typedef enum wcut_effect_kind { WCUT_EFFECT_LIST(WCUT_EFFECT_ENTRY) WCUT_EFFECT_COUNT } wcut_effect_kind;
#undef WCUT_EFFECT_ENTRY

/** Where an effect acts. */
typedef enum wcut_effect_place {
    WCUT_EFFECT_PLACE_STEP,   /**< physics of the simulator's step: simulate, score, replay and control see it */
    WCUT_EFFECT_PLACE_FACE,   /**< physics of the cut face: it moves a scan, not a recording */
    WCUT_EFFECT_PLACE_SENSOR, /**< a fault of the recording's instruments */
    WCUT_EFFECT_PLACE_SCAN    /**< a fault of the scanner or of its registration */
} wcut_effect_place;

enum { WCUT_EFFECT_VALUES = 5 };

/** An effect with its parameters, each in the unit that its key names (angles in deg, as in files). */
typedef struct wcut_effect {
    wcut_effect_kind kind;
    int choice;                       /**< which of the choices of its kind (axis, sensor ..); 0 where it has none */
    double value[WCUT_EFFECT_VALUES]; /**< as its kind's parameters say */
} wcut_effect;

/** A parameter of an effect. */
typedef struct wcut_effect_parameter {
    const char *key;  /**< in files, with its unit; NULL ends the list */
    int at, size;     /**< value[at] .. value[at + size - 1]: size 1, or 3 for a point or vector */
    bool required;    /**< a job must give it */
    double initial;   /**< where a job gives none */
    double min, max;  /**< what is accepted */
    double low, high; /**< what is plausible; the source stands in NOTATION.md */
} wcut_effect_parameter;

/** Properties of a kind of effect. */
typedef struct wcut_effect_info {
    const char *name;
    wcut_effect_place place;
    const char *choice_key;                 /**< NULL where there is nothing to choose */
    const char *const *choice;              /**< names, ended by NULL */
    int strengths;                          /**< value[0] .. value[strengths - 1] are its size */
    double neutral;                         /**< at which all of them give the plain model back, bit for bit */
    bool repeats;                           /**< a job may have several of them */
    bool needs_mounts;                      /**< acts where mounts are: left out of a design's plan */
    const wcut_effect_parameter *parameter; /**< of the first choice, the required ones first */
} wcut_effect_info;

/** The properties of a kind of effect, borrowed; NULL outside the enum. */
WCUT_API const wcut_effect_info *wcut_effect_view(wcut_effect_kind kind);

/**
 * The kind that a name in a file means.
 *
 * @param[in]  name "wire_thermal_lag"
 * @param[out] kind
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (NULL), WCUT_NOT_FOUND: nothing was written.
 */
WCUT_API wcut_status wcut_effect_locate(const char *name, wcut_effect_kind *kind);

/** An effect of a kind at its neutral size, its other parameters at their initial values (first choice). */
WCUT_API wcut_effect wcut_effect_default(wcut_effect_kind kind);

/** The same of another choice, 0 .. the number of choices - 1: its own parameters at their initial values. */
WCUT_API wcut_effect wcut_effect_choose(wcut_effect_kind kind, int choice);

/** The parameters of an effect's kind and choice, ended by a NULL key; NULL for an unknown kind or choice. */
WCUT_API const wcut_effect_parameter *wcut_effect_parameters(const wcut_effect *effect);

/** Whether an effect has its neutral size, so that it changes nothing. */
WCUT_API bool wcut_effect_is_neutral(const wcut_effect *effect);

/**
 * Check effects: known kinds and choices, values in the accepted range, no repetition of an effect that must not
 * repeat.
 *
 * @param[in]  count  at least 0
 * @param[in]  effect count
 * @param[out] error  may be NULL; "effects[1].time_constant_s: found .., expected .."
 * @return WCUT_OK; WCUT_BAD_ARGUMENT.
 */
WCUT_API wcut_status wcut_effects_check(int count, const wcut_effect *effect, wcut_error *error);

/* The signals of a recording in the order of its channels. */
enum { WCUT_SENSED_TENSION_A = 2, WCUT_SENSED_ALPHA_A = 4, WCUT_SENSED_COUNT = 8 };

/**
 * What faulty instruments make of a prediction: clock_offset, tension_delay and encoder_friction before gains, zeros
 * and drifts; other effects are ignored. Signals are speed_a, speed_b, tension_a, tension_b [N], alpha_a, beta_a,
 * alpha_b, beta_b [rad], as in wcut_prediction; speeds stay as they are (they come with the motion).
 *
 * @param[in]     count   effects, at least 0
 * @param[in]     effect  count, checked
 * @param[in]     samples at least 0
 * @param[in]     time    samples [s], strictly increasing, of the recording's clock
 * @param[in]     present samples: 1 where there is a prediction; NULL: everywhere
 * @param[in,out] value   WCUT_SENSED_COUNT times samples; a NULL signal is skipped
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: the signals are as they were.
 */
WCUT_API wcut_status wcut_sensors_eval(int count, const wcut_effect *effect, int samples, const double *time,
                                       const unsigned char *present, double *const value[WCUT_SENSED_COUNT]);

/**
 * Where points of the cut face are scanned: kerf_growth and block_springback move the face, then scan_scale and
 * scan_offset misplace the scan; other effects are ignored.
 *
 * @param[in]     count  effects, at least 0
 * @param[in]     effect count, checked
 * @param[in]     block  [mm] W, L, H, positive
 * @param[in]     points at least 0
 * @param[in]     normal points [1] of the face, out of the lower half; NULL where no effect needs it
 * @param[in]     q_eff  points [J/m^2] positive, with which the face was cut; NULL where no effect needs it
 * @param[in,out] point  points [mm] of the face that the plain model predicts
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a normal or q_eff missing that kerf_growth needs): the points are as they were.
 */
WCUT_API wcut_status wcut_face_eval(int count, const wcut_effect *effect, wcut_vec3 block, int points,
                                    const wcut_vec3 *normal, const double *q_eff, wcut_vec3 *point);

#ifdef __cplusplus
}
#endif

#endif
