/* wirecut/reshape.h - the same shape with more or fewer control points, shapes joined, shapes moved. */
#ifndef WCUT_RESHAPE_H
#define WCUT_RESHAPE_H

#include <wirecut/curve.h>
#include <wirecut/edit.h>
#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** An affine map p -> (x . p, y . p, z . p) + shift. */
typedef struct wcut_affine {
    wcut_vec3 x, y, z; /**< [1] rows of its matrix */
    wcut_vec3 shift;   /**< [mm] */
} wcut_affine;

/**
 * The same curve written with a higher degree (Ramshaw 1989); its ends clamped, its parameters unchanged.
 *
 * @param[in]  curve  a valid curve
 * @param[in]  times  1 or more; its degree and these together at most WCUT_DEGREE_MAX
 * @param[out] result the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_elevate(const wcut_curve *curve, int times, wcut_curve **result);

/**
 * The same surface with a higher degree in one direction; as wcut_curve_elevate.
 *
 * @return As wcut_curve_elevate; also WCUT_BAD_ARGUMENT for an unknown direction.
 */
WCUT_API wcut_status wcut_surface_elevate(const wcut_surface *surface, wcut_direction direction, int times,
                                          wcut_surface **result);

/**
 * A curve with as many knots removed as a tolerance allows (Lyche, Moerken 1988): knots are ranked by what their
 * removal changes, the remaining control points fitted by least squares. Its ends stay where they are, clamped.
 *
 * @param[in]  curve     a valid curve
 * @param[in]  tolerance [mm] positive: the two curves are nowhere, at equal parameters, further apart
 * @param[out] result    the caller's, to wcut_curve_destroy
 * @param[out] error     [mm] a proven bound on that distance, at most tolerance; may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_remove_knots(const wcut_curve *curve, double tolerance, wcut_curve **result,
                                             double *error);

/**
 * A surface with as many knots of both directions removed as a tolerance allows, its corners kept; as
 * wcut_curve_remove_knots.
 *
 * @return As wcut_curve_remove_knots.
 */
WCUT_API wcut_status wcut_surface_remove_knots(const wcut_surface *surface, double tolerance, wcut_surface **result,
                                               double *error);

/**
 * One curve from several, end to end, of the highest degree among them. The first keeps its parameters; those of the
 * others follow on, stretched so that the speed does not jump at a joint. A joint is a knot of multiplicity degree.
 *
 * @param[in]  count     curves, 1 or more
 * @param[in]  curve     count valid curves, each to begin where the one before ends
 * @param[in]  tolerance [mm] not negative: gaps up to this are closed, by the later curve's first control point
 * @param[out] result    the caller's, to wcut_curve_destroy
 * @param[out] gap       [mm] the widest one found, also where it is too wide; may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written; WCUT_DEGENERATE (a gap is wider than
 *         tolerance): only gap was written.
 */
WCUT_API wcut_status wcut_curve_join(int count, const wcut_curve *const *curve, double tolerance, wcut_curve **result,
                                     double *gap);

/**
 * One surface from two: `high` follows on where `low` ends in a direction. The other direction gets the knots of both
 * and the domain of `low`.
 *
 * @param[in]  low, high valid surfaces
 * @param[in]  direction in which they follow on one another
 * @param[in]  tolerance [mm] not negative: as in wcut_curve_join, measured between the edges' control points
 * @param[out] result    the caller's, to wcut_surface_destroy
 * @param[out] gap       as in wcut_curve_join
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written; WCUT_DEGENERATE (a gap wider than tolerance,
 *         or edges whose weights are not in one proportion): only gap was written.
 */
WCUT_API wcut_status wcut_surface_join(const wcut_surface *low, const wcut_surface *high, wcut_direction direction,
                                       double tolerance, wcut_surface **result, double *gap);

/**
 * The image of a curve under an affine map: exactly that of its control points.
 *
 * @param[in]  curve  a valid curve
 * @param[in]  map    finite; may be singular
 * @param[out] result the caller's, to wcut_curve_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (a coordinate overflows), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_curve_transform(const wcut_curve *curve, const wcut_affine *map, wcut_curve **result);

/**
 * The image of a surface; as wcut_curve_transform. A map that mirrors turns the normals to the other side.
 *
 * @return As wcut_curve_transform.
 */
WCUT_API wcut_status wcut_surface_transform(const wcut_surface *surface, const wcut_affine *map, wcut_surface **result);

#ifdef __cplusplus
}
#endif

#endif
