/* wirecut/brep.h - a solid by its faces: plane or spline faces, their border curves, shared edges and vertices. */
#ifndef WCUT_BREP_H
#define WCUT_BREP_H

#include <wirecut/curve.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Where two faces meet: from one vertex to another, each edge used by exactly two loops, once in either direction. */
typedef struct wcut_brep_edge {
    int from, to;      /**< vertices, different ones */
    wcut_curve *curve; /**< clamped, from its first point at `from` to its last at `to`; NULL for a straight line */
} wcut_brep_edge;

/** An edge as a loop uses it. */
typedef struct wcut_brep_coedge {
    int edge;
    int reversed; /**< 1: run through from `to` to `from` */
} wcut_brep_coedge;

/** Which part of the solid's surface a face is. */
typedef enum wcut_brep_part {
    WCUT_BREP_PART_CUT,      /**< the cut face: spline */
    WCUT_BREP_PART_SIDE_X0,  /**< x = 0: plane, as all up to OPPOSITE; with a hole for every lug on it */
    WCUT_BREP_PART_SIDE_XW,  /**< x = W */
    WCUT_BREP_PART_SIDE_Y0,  /**< y = 0 */
    WCUT_BREP_PART_SIDE_YL,  /**< y = L */
    WCUT_BREP_PART_OPPOSITE, /**< z = 0 of the lower half, z = H of the upper: with a hole for every registration key; of
                                  a panel a spline, its other face */
    WCUT_BREP_PART_KEY_FLANK, /**< half a cone: spline, rational */
    WCUT_BREP_PART_KEY_TIP,   /**< the flat end of a key: plane */
    WCUT_BREP_PART_LUG,       /**< of a locating lug: plane */
    WCUT_BREP_PART_FRAME      /**< of a frame around the halves: plane */
} wcut_brep_part;

/** A face of the solid. */
typedef struct wcut_brep_face {
    wcut_brep_part part;
    wcut_surface *surface; /**< untrimmed: the border of its domain is the one loop; NULL: a plane */
    int same_sense;        /**< spline: 1 where S_u x S_v points out of the solid, 0 where it points in; plane: 1 */
    wcut_vec3 origin;      /**< plane: a point of it [mm] */
    wcut_vec3 normal;      /**< plane: unit, out of the solid */
    int first_loop, loop_count; /**< in `loop`, the outer one first, the others its holes */
} wcut_brep_face;

/** A closed run of coedges: the face lies to its left, seen from outside the solid. */
typedef struct wcut_brep_loop {
    int first_coedge, coedge_count; /**< in `coedge`, each beginning where the one before ends */
} wcut_brep_loop;

/**
 * One closed shell, exact to rounding: vertices lie on the ends of the curves, curves on both faces that they
 * separate. The four loop edges of the face WCUT_BREP_PART_CUT are its border curves, in this order for the upper side
 * of the surface (same_sense 1): v = first, u = last, v = last reversed, u = first reversed.
 */
typedef struct wcut_brep {
    int vertex_count, edge_count, coedge_count, loop_count, face_count;
    wcut_vec3 *vertex; /**< vertex_count [mm] */
    wcut_brep_edge *edge;
    wcut_brep_coedge *coedge;
    wcut_brep_loop *loop;
    wcut_brep_face *face;
} wcut_brep;

#ifdef __cplusplus
}
#endif

#endif
