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
   fault on what SENSORs record or on the SCAN; a wire or a block that is not as the job states acts in the STEP, too.
   Equations: NOTATION.md, Effects. */
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
    X(SLICE_SOFTENING, "slice_softening", STEP)             \
    X(WIRE_FOULING, "wire_fouling", STEP)                   \
    X(EMPIRICAL_FORCE, "empirical_force", STEP)             \
    X(WIRE_LENGTH, "wire_length", STEP)                     \
    X(BLOCK_SHIFT, "block_shift", STEP)                     \
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

enum { WCUT_EFFECT_VALUES = 6 };

/** An effect with its parameters, each in the unit that its key names (angles in deg, as in files). */
typedef struct wcut_effect {
    wcut_effect_kind kind;
    int choice;                       /**< which of the choices of its kind (axis, sensor ..); 0 where it has none */
    double value[WCUT_EFFECT_VALUES]; /**< as its kind's parameters say */
} wcut_effect;

/* effect.value of each kind: effect.value[WCUT_WIRE_FOULING_LENGTH]. Keys, units and ranges: wcut_effect_parameters. */

/** wire_thermal_lag: time_constant_s, v_ref_mm_s, H0_W_per_mK, H1_W_s_per_mm_mK; two: slow_share, slow_time_constant_s */
enum {
    WCUT_WIRE_THERMAL_LAG_TIME_CONSTANT,
    WCUT_WIRE_THERMAL_LAG_SPEED_REF,
    WCUT_WIRE_THERMAL_LAG_LOSS,
    WCUT_WIRE_THERMAL_LAG_LOSS_BY_SPEED,
    WCUT_WIRE_THERMAL_LAG_SLOW_SHARE,
    WCUT_WIRE_THERMAL_LAG_SLOW_TIME_CONSTANT
};
/** air_overheating: air_to_foam_ratio, time_constant_s */
enum { WCUT_AIR_OVERHEATING_RATIO, WCUT_AIR_OVERHEATING_TIME_CONSTANT };
/** end_cooling: amplitude, length_mm */
enum { WCUT_END_COOLING_AMPLITUDE, WCUT_END_COOLING_LENGTH };
/** foam_density_gradient: relative_change_across_block, step_at_share, band_share */
enum { WCUT_FOAM_DENSITY_GRADIENT_CHANGE, WCUT_FOAM_DENSITY_GRADIENT_STEP_AT, WCUT_FOAM_DENSITY_GRADIENT_BAND };
/** foam_inclusion: amplitude, radius_mm, position_mm */
enum { WCUT_FOAM_INCLUSION_AMPLITUDE, WCUT_FOAM_INCLUSION_RADIUS, WCUT_FOAM_INCLUSION_POSITION };
/** kerf_growth: k1_mm_per_J_m2, k2_mm */
enum { WCUT_KERF_GROWTH_PER_Q, WCUT_KERF_GROWTH_PER_LOG };
/** tangential_drag: mu, v_smooth_mm_s */
enum { WCUT_TANGENTIAL_DRAG_FRICTION, WCUT_TANGENTIAL_DRAG_SPEED_SMOOTH };
/** wire_elongation: strain_at_60W_2N, thermal_share, air_factor */
enum { WCUT_WIRE_ELONGATION_STRAIN, WCUT_WIRE_ELONGATION_THERMAL_SHARE, WCUT_WIRE_ELONGATION_AIR_FACTOR };
/** mount_compliance: stiffness_N_per_mm, settling_s */
enum { WCUT_MOUNT_COMPLIANCE_STIFFNESS, WCUT_MOUNT_COMPLIANCE_SETTLING };
/** rate_dependence: exponent, v_ref_mm_s */
enum { WCUT_RATE_DEPENDENCE_EXPONENT, WCUT_RATE_DEPENDENCE_SPEED_REF };
/** slice_softening: sliding_ratio, exponent */
enum { WCUT_SLICE_SOFTENING_RATIO, WCUT_SLICE_SOFTENING_EXPONENT };
/** wire_fouling: relative_change, length_mm, start_mm */
enum { WCUT_WIRE_FOULING_CHANGE, WCUT_WIRE_FOULING_LENGTH, WCUT_WIRE_FOULING_START };
/** wire_length: change_mm */
enum { WCUT_WIRE_LENGTH_CHANGE };
/** block_shift: shift_mm */
enum { WCUT_BLOCK_SHIFT_SHIFT };
/** block_springback: amplitude_mm */
enum { WCUT_BLOCK_SPRINGBACK_AMPLITUDE };
/** angle_offset: offset_deg */
enum { WCUT_ANGLE_OFFSET_OFFSET };
/** tension_gain: gain_error */
enum { WCUT_TENSION_GAIN_GAIN };
/** tension_drift: drift_N, tau_s */
enum { WCUT_TENSION_DRIFT_DRIFT, WCUT_TENSION_DRIFT_TIME_CONSTANT };
/** empirical_reading: offset, slope_per_100_s, from_s, to_s */
enum {
    WCUT_EMPIRICAL_READING_OFFSET,
    WCUT_EMPIRICAL_READING_SLOPE,
    WCUT_EMPIRICAL_READING_FROM,
    WCUT_EMPIRICAL_READING_TO
};
/** clock_offset: delay_s */
enum { WCUT_CLOCK_OFFSET_DELAY };
/** tension_delay: delay_s */
enum { WCUT_TENSION_DELAY_DELAY };
/** tension_zero: offset_N */
enum { WCUT_TENSION_ZERO_OFFSET };
/** angle_gain: gain_error */
enum { WCUT_ANGLE_GAIN_GAIN };
/** encoder_friction: half_width_deg */
enum { WCUT_ENCODER_FRICTION_HALF_WIDTH };
/** scan_offset: shift_mm */
enum { WCUT_SCAN_OFFSET_SHIFT };
/** scan_scale: scale */
enum { WCUT_SCAN_SCALE_SCALE };
/** empirical_force: the coefficient, of a wave that of the cosine, too; then what shapes the term */
enum {
    WCUT_EMPIRICAL_FORCE_COEFFICIENT,
    WCUT_EMPIRICAL_FORCE_COSINE,
    WCUT_EMPIRICAL_FORCE_SHAPE,
    WCUT_EMPIRICAL_FORCE_DEGREE = WCUT_EMPIRICAL_FORCE_SHAPE,        /**< position: degree */
    WCUT_EMPIRICAL_FORCE_WAVELENGTH = WCUT_EMPIRICAL_FORCE_SHAPE,    /**< wave: wavelength_mm */
    WCUT_EMPIRICAL_FORCE_ORDER = WCUT_EMPIRICAL_FORCE_SHAPE,         /**< direction: order */
    WCUT_EMPIRICAL_FORCE_Q_REF = WCUT_EMPIRICAL_FORCE_SHAPE,         /**< q_eff_inverse: q_ref_J_per_m2 */
    WCUT_EMPIRICAL_FORCE_SPEED_REF = WCUT_EMPIRICAL_FORCE_SHAPE,     /**< ln_speed: v_ref_mm_s */
    WCUT_EMPIRICAL_FORCE_RADIUS = WCUT_EMPIRICAL_FORCE_SHAPE,        /**< curvature: radius_mm */
    WCUT_EMPIRICAL_FORCE_TIME_CONSTANT = WCUT_EMPIRICAL_FORCE_SHAPE, /**< entry, memories: time_constant_s */
    WCUT_EMPIRICAL_FORCE_START_TIME = WCUT_EMPIRICAL_FORCE_SHAPE,    /**< time: start_s */
    WCUT_EMPIRICAL_FORCE_FROM = WCUT_EMPIRICAL_FORCE_SHAPE,          /**< band, window: from_mm, from_s */
    WCUT_EMPIRICAL_FORCE_TO,                                         /**< to_mm, to_s */
    WCUT_EMPIRICAL_FORCE_EDGE,                                       /**< edge_mm, edge_s */
    WCUT_EMPIRICAL_FORCE_AT = WCUT_EMPIRICAL_FORCE_SHAPE,            /**< q_eff_step, q_eff_hinge: at_J_per_m2 */
    WCUT_EMPIRICAL_FORCE_WIDTH,                                      /**< width_J_per_m2 */
    WCUT_EMPIRICAL_FORCE_LENGTH = WCUT_EMPIRICAL_FORCE_SHAPE,        /**< way: length_mm */
    WCUT_EMPIRICAL_FORCE_START,                                      /**< start_mm */
    WCUT_EMPIRICAL_FORCE_NUMBER = WCUT_EMPIRICAL_FORCE_SHAPE,        /**< cut_order: number */
    WCUT_EMPIRICAL_FORCE_FIRST,                                      /**< from */
    WCUT_EMPIRICAL_FORCE_LAST                                        /**< to */
};

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
    bool choice_required;                   /**< a job must choose; else the first is meant */
    const char *const *choice;              /**< names, ended by NULL */
    int strengths;                          /**< value[0] .. value[strengths - 1] are its size */
    double neutral;                         /**< at which all of them give the plain model back, bit for bit */
    bool repeats;                           /**< a job may have several of them */
    bool needs_mounts;                      /**< acts where mounts are: left out of a design's plan */
    const wcut_effect_parameter *parameter; /**< of the first choice, the required ones first */
    const char *equation;                   /**< symbols: NOTATION.md, Effects */
    const char *source;                     /**< plausible range, and by which source */
    const char *where;                      /**< "kernel/foam/local_law.c:overheat", the function with the physics */
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
