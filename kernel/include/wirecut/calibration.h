/* wirecut/calibration.h - the force and tension laws of a foam from steady test cuts. */
#ifndef WCUT_CALIBRATION_H
#define WCUT_CALIBRATION_H

#include <wirecut/export.h>
#include <wirecut/force_law.h>
#include <wirecut/loss.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** One straight cut in steady state. */
typedef struct wcut_test_cut {
    double heat;                 /**< [W/m] positive */
    double speed;                /**< [mm/s] positive */
    double engaged;              /**< [mm] wire inside the foam, positive */
    double tension_a, tension_b; /**< [N] at the mounts, positive */
    double alpha_a, alpha_b;     /**< [rad] by which the wire trails at the mounts, in (-pi/2, pi/2) */
    double weight;               /**< [1] positive; the variance of the cut's error is inverse to it; 1 as a rule */
    int line;                    /**< of the file it came from; 0 where it came from none */
} wcut_test_cut;

/** What the scatter of the test cuts is proportional to. */
typedef enum wcut_noise {
    WCUT_NOISE_RELATIVE, /**< the value itself; default: 44 of 48 measured tables prefer it */
    WCUT_NOISE_ABSOLUTE  /**< one number for every cut */
} wcut_noise;

/** How to fit. */
typedef struct wcut_calibration_options {
    wcut_noise noise;       /**< default WCUT_NOISE_RELATIVE; wcut_law_fit.evidence says what the data prefer */
    wcut_loss loss;         /**< default WCUT_LOSS_SQUARE */
    double confidence;      /**< [1] of the intervals, in (0, 1); default 0.95 */
    double reference_force; /**< [N/mm] F0 of V0 and the exponent; 0: the geometric mean of the fitted forces */
    double reference_heat;  /**< [W/m] Q_I of V0; 0: the median of the cuts' */
    double alpha_large;     /**< [rad] cuts with larger deflections are counted; default 10 deg */
} wcut_calibration_options;

/** What a law was tested against. */
typedef enum wcut_lack_of_fit {
    WCUT_LACK_OF_FIT_UNTESTED,  /**< too few cuts */
    WCUT_LACK_OF_FIT_REPLICATE, /**< the scatter of cuts repeated at the same heat and speed */
    WCUT_LACK_OF_FIT_FLEXIBLE   /**< a law with a curvature in Q_eff and a power of the speed beside Q_eff */
} wcut_lack_of_fit;

/** One law fitted: y = a exp(-b Q_eff) + c. */
typedef struct wcut_law_fit {
    double a, b, c;           /**< [N/mm, m^2/J, N/mm]; c is 0 in the force law */
    double standard_error[3]; /**< of a, b, c; 0 for a c that is held */
    double low[3], high[3];   /**< interval of a, b, c at the stated confidence (Student's t) */
    double covariance[9];     /**< 3 x 3 row-major, of a, b, c */
    double correlation[9];    /**< [1] 3 x 3, the same over the standard errors; 0 beside a c that is held */
    int c_held;               /**< 1: c is held at 0 (force law; or the data would have it negative) */
    double scale;             /**< standard deviation of a cut: relative [1], or [N/mm], as the noise is */
    int degrees;              /**< cuts less fitted parameters */
    double leave_one_out;     /**< root mean square error at cuts left out of the fit, in the unit of scale */
    int left_out;             /**< cuts that could be left out; without any of the others the law is not determined */
    wcut_lack_of_fit lack;    /**< what the law was tested against */
    int lack_degrees[2];      /**< of the F statistic */
    double lack_f, lack_p;    /**< F statistic, and the probability of a larger one if the law is right; 1 untested */
    double evidence;          /**< log likelihood of relative noise less that of absolute noise */
} wcut_law_fit;

/** A calibration. */
typedef struct wcut_calibration {
    wcut_law_fit force;        /**< equation (2) to F = (T_a sin alpha_a + T_b sin alpha_b) / engaged length */
    wcut_law_fit tension;      /**< equation (1) to the mean tension per engaged length; all 0 without tension_fitted */
    int tension_fitted;        /**< 0: the cuts do not determine equation (1) */
    double q_eff_low;          /**< [J/m^2] the least and ... */
    double q_eff_high;         /**< [J/m^2] ... the greatest Q_eff of the cuts: where the laws are validated */
    int heats, speeds, q_effs; /**< different levels of each among the cuts (apart by more than 1e-6) */
    int separable;             /**< 1: the interval of b is narrower than b itself: a and b can be separated */
    int large_angles;          /**< cuts with a deflection beyond alpha_large */
    double reference_force;    /**< [N/mm] F0 */
    double reference_heat;     /**< [W/m] Q_I */
    double reference_speed;    /**< [mm/s] V0 = b Q_I / ln(a / F0): well determined even where a and b are not */
    double reference_speed_error; /**< [mm/s] its standard error */
    double exponent;              /**< [1] 1 / ln(a / F0) = d ln v / d ln F at F0 */
    double exponent_error;        /**< [1] its standard error */
    double correlation;           /**< [1] of a and b */
} wcut_calibration;

/** What is unusual about a cut, to be looked at; 5 to 10 % of good cuts are marked. */
enum {
    WCUT_UNUSUAL_OUTLIER = 1,    /**< more than 3 standard deviations off the law */
    WCUT_UNUSUAL_LEVERAGE = 2,   /**< leverage beyond 2 p / n (Hoaglin, Welsch 1978): alone at its Q_eff */
    WCUT_UNUSUAL_INFLUENTIAL = 4 /**< influence beyond 2 sqrt(p / n) (Belsley, Kuh, Welsch 1980): it moves the law */
};

/** One cut in one law. */
typedef struct wcut_law_fit_point {
    double measured;    /**< [N/mm] */
    double fitted;      /**< [N/mm] */
    double residual;    /**< [1] measured less fitted, in standard deviations of this cut */
    double loss_weight; /**< [1] factor of the loss on its weight; 1 with WCUT_LOSS_SQUARE */
    double left_out;    /**< [N/mm] predicted by the law fitted to the others; the fitted value where there is none */
    double relative;    /**< [1] measured less fitted, over fitted */
    double leverage;  /**< [1] share of a cut in its own fitted value, in [0, 1]; their sum is the parameters' count */
    double influence; /**< [1] fitted less left out, in standard errors of the fitted value */
    int unusual;      /**< sum of WCUT_UNUSUAL_...; 0: nothing */
} wcut_law_fit_point;

/** One cut in a calibration. */
typedef struct wcut_calibration_point {
    double q_eff;               /**< [J/m^2] */
    wcut_law_fit_point force;   /**< equation (2) */
    wcut_law_fit_point tension; /**< equation (1); measured alone where it is not fitted */
} wcut_calibration_point;

/** Least squares with relative noise, 95 % intervals, 10 degrees. */
WCUT_API wcut_calibration_options wcut_calibration_options_default(void);

/**
 * The force of a test cut per engaged length (Rust et al. 2016, figure 2).
 *
 *     F = (T_a sin alpha_a + T_b sin alpha_b) / engaged length
 *
 * @param[in] cut positive engaged length
 * @return [N/mm].
 */
WCUT_API double wcut_test_cut_force(const wcut_test_cut *cut);

/**
 * The mean tension of a test cut per engaged length.
 *
 * @param[in] cut positive engaged length
 * @return [N/mm].
 */
WCUT_API double wcut_test_cut_tension(const wcut_test_cut *cut);

/**
 * Fit the laws (1) and (2) of Rust et al. (2016) to test cuts.
 *
 *     minimise sum_i weight_i loss((y_i - y(Q_i)) / sigma_i),   sigma_i = y(Q_i) or 1
 *
 * With relative noise sigma is that of the fitted law itself (generalised least squares, Carroll and Ruppert 1988),
 * found by repeating the fit until it converges; unlike a fit of logarithms this neither shifts the mean nor breaks
 * at a cut whose measured force is not positive. The start is the fit of logarithms. A tension law with a negative c is
 * not admitted: where the fit would give one, c is held at 0. The leave-one-out error is by
 * refitting up to 200 cuts, beyond that by leverages.
 *
 * @param[in]  n           cuts, at least 3
 * @param[in]  cut         n
 * @param[in]  options     NULL for the defaults
 * @param[out] calibration the laws and what is known about them
 * @param[out] point       n, in the cuts' order; may be NULL
 * @param[out] error       may be NULL; says which cut, or what the cuts lack
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a value outside its range, or a reference force not below a),
 *         WCUT_DEGENERATE (fewer than two levels of Q_eff, fewer than two of them with a positive force, or a force
 *         that does not fall with Q_eff), WCUT_NOT_CONVERGED (the repeated fit does not converge: the scatter is as
 *         large as the values), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_calibration_fit(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                          wcut_calibration *calibration, wcut_calibration_point *point,
                                          wcut_error *error);

/** A column of a table of test cuts. */
typedef enum wcut_slip_column {
    WCUT_SLIP_COLUMN_NONE,
    WCUT_SLIP_COLUMN_HEAT,
    WCUT_SLIP_COLUMN_SPEED,
    WCUT_SLIP_COLUMN_ENGAGED,
    WCUT_SLIP_COLUMN_TENSION,
    WCUT_SLIP_COLUMN_ALPHA,
    WCUT_SLIP_COLUMN_COUNT
} wcut_slip_column;

/** A cut far off the law of the others. */
typedef struct wcut_slip {
    int cut;                 /**< index of the cut in the table */
    wcut_slip_column column; /**< that brings it back to the law when it is multiplied; NONE: no column does */
    double factor;           /**< [1] 0.1, 10, 0.01 or 100; 1 where there is no column */
    double ratio;            /**< [1] its force over that of the law */
} wcut_slip;

/**
 * The outliers of a table, and the slipped decimal points that explain them.
 *
 * The law is that of a robust fit (WCUT_LOSS_TUKEY); a column is named where one of its values, moved by one or two
 * decimal places, comes into the range of the other cuts and brings the cut within 3 standard deviations of both laws,
 * the one that comes nearest.
 *
 * @param[in]  n       cuts, at least 3
 * @param[in]  cut     n
 * @param[in]  options NULL for the defaults; their loss is not used
 * @param[out] count   0 .. n
 * @param[out] slip    n, of which count are written
 * @param[out] error   may be NULL
 * @return WCUT_OK; the statuses of wcut_calibration_fit: nothing was written.
 */
WCUT_API wcut_status wcut_calibration_slips(int n, const wcut_test_cut *cut, const wcut_calibration_options *options,
                                            int *count, wcut_slip *slip, wcut_error *error);

/**
 * A fitted law over Q_eff, with the confidence band of the curve (pointwise, delta method).
 *
 *     y(Q) = a exp(-b Q) + c,   band y(Q) -+ t sqrt(g^T C g),   g = (dy/da, dy/db, dy/dc)
 *
 * C is the covariance of the fit, t Student's quantile at its degrees of freedom. The band is that of the law, not of
 * the next cut; outside the Q_eff of the cuts it holds only if the law does.
 *
 * @param[in]  law        fitted: finite, at least 1 degree of freedom
 * @param[in]  confidence [1] of the band, in (0, 1)
 * @param[in]  n          values, not negative
 * @param[in]  q_eff      n [J/m^2] not negative
 * @param[out] fitted     n [N/mm]
 * @param[out] low        n [N/mm] may be NULL
 * @param[out] high       n [N/mm] may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_law_fit_eval(const wcut_law_fit *law, double confidence, int n, const double *q_eff,
                                       double *fitted, double *low, double *high);

/**
 * Normal scores: the expected order statistics of as many standard normal values (Blom 1958), for a normal probability
 * plot, in which normal residuals lie on a straight line.
 *
 *     score_i = z((rank_i - 3/8) / (n + 1/4)),   P(Z <= z(p)) = p
 *
 * @param[in]  n     values, not negative
 * @param[in]  value n, finite; equal ones are ranked in their order
 * @param[out] score n [1]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_gaussian_scores(int n, const double *value, double *score);

#ifdef __cplusplus
}
#endif

#endif
