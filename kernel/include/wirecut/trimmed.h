/* wirecut/trimmed.h - a face of a CAD file: a surface and the loops of curves that bound the part of it that counts. */
#ifndef WCUT_TRIMMED_H
#define WCUT_TRIMMED_H

#include <wirecut/curve.h>
#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** A surface and its loops as closed polygons whose chords are within 0.005 mm of the curves. */
typedef struct wcut_trimmed {
    wcut_surface *surface; /**< S_u x S_v is the outer side */
    int loops;             /**< 0: the whole surface counts */
    int *first;            /**< loops + 1: where the points of each loop begin */
    wcut_vec3 *point;      /**< first[loops] [mm]: on the surface; the last of a loop joins its first */
    double *uv;            /**< first[loops] x 2: their parameters */
} wcut_trimmed;

/**
 * A surface and the curves that bound it, projected onto it.
 *
 * @param[in]  surface a valid surface, not closed in a direction where it has loops; the result's on WCUT_OK, else the
 *                     caller's still
 * @param[in]  loops   0 or more
 * @param[in]  curves  loops: how many curves each has, 1 or more
 * @param[in]  curve   their curves, one loop after the other; each begins where the one before ends, the first where the
 *                     last ends
 * @param[in]  gap     [mm] within which curves meet and lie on the surface, positive
 * @param[out] trimmed the caller's, to wcut_trimmed_destroy
 * @param[out] error   may be NULL; how far a curve is off
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (curves that do not meet, are off the surface, or bound a closed
 *         surface; more than 10 million points), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_trimmed_create(wcut_surface *surface, int loops, const int *curves,
                                         const wcut_curve *const *curve, double gap, wcut_trimmed **trimmed,
                                         wcut_error *error);

/** Free it with its surface; NULL is allowed. */
WCUT_API void wcut_trimmed_destroy(wcut_trimmed *trimmed);

/** 1 where the point (u, v) is inside an odd number of loops, or there are none; else 0. */
WCUT_API int wcut_trimmed_inside(const wcut_trimmed *trimmed, double u, double v);

/** [mm] The distance of a point of space from the loops; -1 where there are none. */
WCUT_API double wcut_trimmed_border(const wcut_trimmed *trimmed, wcut_vec3 point);

/**
 * The part that counts as triangles: those of a grid whose middle is inside. The grid has the lines of the surface's
 * tessellation, and 200 cells a direction at least where there are loops; its border is as rough as its cells.
 *
 * @param[in]  trimmed         of wcut_trimmed_create
 * @param[in]  chord_tolerance [mm] positive
 * @param[out] mesh            the caller's, to wcut_mesh_destroy; with normals and uv
 * @return As wcut_surface_tessellate; also WCUT_DEGENERATE where no triangle is inside.
 */
WCUT_API wcut_status wcut_trimmed_mesh(const wcut_trimmed *trimmed, double chord_tolerance, wcut_mesh **mesh);

#ifdef __cplusplus
}
#endif

#endif
