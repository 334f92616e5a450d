/* wirecut/reconstruction.h - the scanned face as a mesh, only where it was scanned. */
#ifndef WCUT_RECONSTRUCTION_H
#define WCUT_RECONSTRUCTION_H

#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/projection.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How a reconstruction is made. */
typedef struct wcut_reconstruction_options {
    double support; /**< [mm] no vertex is further from the nearest point of the scan; positive, default 1.5 */
    /** [mm] largest distance of neighbouring vertices along u and v; default 0: twice that of the points, at most
        `support` */
    double spacing;
    /** [mm] deviations of a shorter wavelength than about 2 pi times this are noise; default 0: twice the distance
        of the points */
    double smoothing;
    /** [mm] W, L, H: what of the face lies outside 0 .. W, 0 .. L, 0 .. H is no unmeasured area; default 0: all of
        the face is to be measured */
    wcut_vec3 block;
    /** borrowed; the face where `surface` is only the plane below it (wcut_mesh_base): heights are then over the plane,
        and what the mesh does not cover is neither face nor hole; default NULL: the surface is the face */
    const wcut_mesh *mesh;
    double hole_min; /**< [mm^2] smaller gaps are counted in unmeasured_area, not listed as holes; default 10 */
} wcut_reconstruction_options;

/** A connected part of the face where the scan has no points. */
typedef struct wcut_hole {
    double area;      /**< [mm^2] of the simulated face */
    wcut_vec3 centre; /**< [mm] of its area */
    int open;         /**< 1: it reaches the border of the face or of the block; 0: the scan is all around it */
} wcut_hole;

/** A scanned face. */
typedef struct wcut_reconstruction {
    wcut_mesh *mesh; /**< the face as scanned: normals, uv of the closest point of the simulated face, scalar: signed
                                 deviation [mm] from it, positive on the side of S_u x S_v. Gaps stay open */
    wcut_mesh *unmeasured; /**< the simulated face where the scan has no points: normals, uv; 0 triangles where it has
                                 everywhere */
    wcut_hole *hole;       /**< hole_count, the largest first */
    int hole_count;
    double point_spacing;      /**< [mm] of the scan: root of the area per point */
    double spacing, smoothing; /**< [mm] used */
    int used;                  /**< points */
    int beyond;                /**< points left out since they lie beyond the face's border */
    double area;               /**< [mm^2] of `mesh` */
    double supported_area;  /**< [mm^2] of the simulated face within `support` of the scan: what could be in `mesh` */
    double lost;            /**< [1] share of supported_area that is not in `mesh` */
    double unmeasured_area; /**< [mm^2] of the simulated face, inside the block, that is in `unmeasured` */
    double farthest;        /**< [mm] of a vertex of `mesh` from its nearest point of the scan; at most the support */
    double rms;             /**< [mm] of the points about the field: noise and what is smoothed away */
    int iterations;         /**< of the field's solver */
} wcut_reconstruction;

/** The defaults stated at the fields. */
WCUT_API wcut_reconstruction_options wcut_reconstruction_options_default(void);

/**
 * The scanned face from points and their feet on the simulated one. Field: the deviation h(u, v), bilinear on a grid,
 * that is nearest to the points' heights and bends least,
 *
 *     min  sum (h(u_i, v_i) - h_i)^2  +  rho s^4 int h_xx^2 + 2 h_xy^2 + h_yy^2 dA,
 *
 * rho points per area, s the smoothing; the vertex is S + h n. It is a function over the face: right where the scan has
 * one height over it, smaller than its radius of curvature. Vertices without a point within the support are left out,
 * so that no hole is bridged.
 *
 * @param[in]  surface        the simulated face
 * @param[in]  count          points, 10 or more
 * @param[in]  point          count [mm], finite, up to 1e12
 * @param[in]  foot           count, of wcut_projection_locate on that surface
 * @param[in]  options        NULL for the defaults
 * @param[in]  threads        1 or more; the result does not depend on it
 * @param[out] reconstruction the caller's, to wcut_reconstruction_destroy
 * @param[out] error          may be NULL
 * @return WCUT_OK; WCUT_DEGENERATE (fewer than ten points over the face, all in one place or on one line; no triangle
 *         has support: points further apart than it), WCUT_NOT_CONVERGED (the field's solver),
 *         WCUT_BAD_ARGUMENT (also a spacing that asks for more than 5 million vertices), WCUT_NO_MEMORY: nothing
 *         was written.
 */
WCUT_API wcut_status wcut_reconstruction_create(const wcut_surface *surface, int count, const wcut_vec3 *point,
                                                const wcut_foot *foot, const wcut_reconstruction_options *options,
                                                int threads, wcut_reconstruction **reconstruction, wcut_error *error);

/**
 * The plane that a mesh is a sheet over: to be the surface of a reconstruction beside that mesh. It faces as the mesh's
 * triangles do on the whole and is a rectangle around the mesh seen along its normal.
 *
 * @param[in]  mesh    at least one triangle; finite vertices up to 1e12 mm
 * @param[in]  flip    1: the mesh's triangles face the wrong way
 * @param[out] surface the caller's, to wcut_surface_destroy; bilinear
 * @return WCUT_OK; WCUT_DEGENERATE (the mesh is closed, folds over or stands steeper than 84 deg somewhere: it is no
 *         sheet), WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mesh_base(const wcut_mesh *mesh, int flip, wcut_surface **surface);

/** Free a reconstruction; NULL is allowed. */
WCUT_API void wcut_reconstruction_destroy(wcut_reconstruction *reconstruction);

#ifdef __cplusplus
}
#endif

#endif
