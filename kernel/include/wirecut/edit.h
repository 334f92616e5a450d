/* wirecut/edit.h - curves and surfaces made from others: the same shape in another form, or a part of it. */
#ifndef WCUT_EDIT_H
#define WCUT_EDIT_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A parameter direction of a surface. */
typedef enum wcut_direction { WCUT_DIRECTION_U, WCUT_DIRECTION_V } wcut_direction;

/**
 * The same curve with a knot inserted (Boehm 1980).
 *
 * @param[in]  curve  a valid curve
 * @param[in]  u      strictly inside the domain
 * @param[in]  times  1 or more; with those already there at most degree times
 * @param[out] result the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_insert_knot(const wcut_curve *curve, double u, int times, wcut_curve **result);

/**
 * The two parts of a curve on either side of a parameter, their own parameters unchanged.
 *
 * @param[in]  curve a valid curve
 * @param[in]  u     strictly inside the domain
 * @param[out] low   over [first, u]; the caller's, to wcut_curve_destroy
 * @param[out] high  over [u, last]; the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_split(const wcut_curve *curve, double u, wcut_curve **low, wcut_curve **high);

/**
 * The same curve run through backwards: result(u) = curve(first + last - u).
 *
 * @param[in]  curve  a valid curve
 * @param[out] result the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_reverse(const wcut_curve *curve, wcut_curve **result);

/**
 * The same surface with a knot inserted in one direction; as wcut_curve_insert_knot.
 *
 * @return As wcut_curve_insert_knot; also WCUT_BAD_ARGUMENT for an unknown direction.
 */
WCUT_API wcut_status wcut_surface_insert_knot(const wcut_surface *surface, wcut_direction direction, double at,
                                              int times, wcut_surface **result);

/**
 * The two parts of a surface on either side of a parameter of one direction; as wcut_curve_split.
 *
 * @return As wcut_curve_split; also WCUT_BAD_ARGUMENT for an unknown direction.
 */
WCUT_API wcut_status wcut_surface_split(const wcut_surface *surface, wcut_direction direction, double at,
                                        wcut_surface **low, wcut_surface **high);

/**
 * The same surface with one direction run through backwards, its normals the other way; as wcut_curve_reverse.
 *
 * @return As wcut_curve_reverse; also WCUT_BAD_ARGUMENT for an unknown direction.
 */
WCUT_API wcut_status wcut_surface_reverse(const wcut_surface *surface, wcut_direction direction, wcut_surface **result);

/**
 * The same surface with u and v exchanged, its normals the other way: result(u, v) = surface(v, u).
 *
 * @param[in]  surface a valid surface
 * @param[out] result  the caller's, to wcut_surface_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_transpose(const wcut_surface *surface, wcut_surface **result);

/**
 * The curve of constant parameter: along v at u = at (WCUT_DIRECTION_V), or along u at v = at (WCUT_DIRECTION_U).
 *
 * @param[in]  surface a valid surface
 * @param[in]  along   the direction that the curve runs in
 * @param[in]  at      the other parameter, within the domain
 * @param[out] result  the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_iso_curve(const wcut_surface *surface, wcut_direction along, double at,
                                            wcut_curve **result);

#ifdef __cplusplus
}
#endif

#endif
