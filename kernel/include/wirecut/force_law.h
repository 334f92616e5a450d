/* wirecut/force_law.h - what the foam does to a hot wire moving steadily through it. */
#ifndef WCUT_FORCE_LAW_H
#define WCUT_FORCE_LAW_H

#include <wirecut/export.h>
#include <wirecut/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/** F(Q_eff) = a exp(-b Q_eff), force across the wire per engaged length (Rust et al. 2016, 2). */
typedef struct wcut_force_law {
    double a; /**< [N/mm] cold force, the limit v -> inf; positive */
    double b; /**< [m^2/J] decay with the effective heat input; positive */
} wcut_force_law;

/** T(Q_eff) = a exp(-b Q_eff) + c, tension per engaged length (Rust et al. 2016, 1). */
typedef struct wcut_tension_law {
    double a; /**< [N/mm] positive */
    double b; /**< [m^2/J] positive */
    double c; /**< [N/mm] the limit v -> 0 */
} wcut_tension_law;

/**
 * Effective heat input Q_eff = Q_I / v (Ahn, Lee, Yang 2003).
 *
 * @param[in] heat  [W/m] heat input per wire length, not negative
 * @param[in] speed [mm/s] not negative
 * @return [J/m^2]; +inf at rest.
 */
WCUT_API double wcut_q_eff_eval(double heat, double speed);

/**
 * Force across the wire per engaged length, equation (2).
 *
 * @param[in] law   positive coefficients
 * @param[in] heat  [W/m]
 * @param[in] speed [mm/s]
 * @return [N/mm], in [0, a).
 */
WCUT_API double wcut_force_law_eval(const wcut_force_law *law, double heat, double speed);

/**
 * Speed at which the foam answers with a given force, v = b Q_I / ln(a / F): the inverse of (2).
 *
 * @param[in]  law   positive coefficients
 * @param[in]  heat  [W/m] positive
 * @param[in]  force [N/mm] in (0, a)
 * @param[out] speed [mm/s]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: no such speed, nothing was written.
 */
WCUT_API wcut_status wcut_force_law_speed(const wcut_force_law *law, double heat, double force, double *speed);

/**
 * Tension per engaged length, equation (1).
 *
 * @param[in] law   positive a and b
 * @param[in] heat  [W/m]
 * @param[in] speed [mm/s]
 * @return [N/mm], in [c, a + c).
 */
WCUT_API double wcut_tension_law_eval(const wcut_tension_law *law, double heat, double speed);

/**
 * Speed at which the steady tension per engaged length has a given value: the inverse of (1).
 *
 * @param[in]  law     positive a and b
 * @param[in]  heat    [W/m] positive
 * @param[in]  tension [N/mm] in (c, a + c)
 * @param[out] speed   [mm/s]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: no such speed, nothing was written.
 */
WCUT_API wcut_status wcut_tension_law_speed(const wcut_tension_law *law, double heat, double tension, double *speed);

#ifdef __cplusplus
}
#endif

#endif
