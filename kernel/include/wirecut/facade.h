/* wirecut/facade.h - many cut elements side by side: where they stand, which edges they share, what each one is cut by. */
#ifndef WCUT_FACADE_H
#define WCUT_FACADE_H

#include <stdbool.h>
#include <wirecut/brep.h>
#include <wirecut/export.h>
#include <wirecut/job.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Points of an edge that two elements share, at even steps from corner to corner; of a face as many each way. */
enum { WCUT_FACADE_SAMPLES = 33, WCUT_FACADE_ELEMENTS_MAX = 10000 };

/** What a field of a facade is a function of: u along its columns, v along its rows, both in mm from its first corner. */
typedef enum wcut_facade_field_kind {
    WCUT_FACADE_FIELD_CONSTANT, /**< value */
    WCUT_FACADE_FIELD_LINEAR,   /**< value + slope . (u, v) */
    WCUT_FACADE_FIELD_SINE,     /**< value + amplitude sin(2 pi s / period + phase), s along a direction */
    WCUT_FACADE_FIELD_GRID, /**< values over the whole facade, between them by cubics through them (Catmull, Rom 1974) */
    WCUT_FACADE_FIELD_ATTRACTOR /**< value + amplitude exp(-(d / radius)^2), d from a point or from a line of points */
} wcut_facade_field_kind;

/** A function over the facade; a kind reads the fields that its line names. */
typedef struct wcut_facade_field {
    wcut_facade_field_kind kind;
    double value;      /**< every kind but the grid; in the unit of what it drives */
    double slope[2];   /**< linear: per mm of u and of v */
    double amplitude;  /**< sine, attractor */
    double period;     /**< sine [mm], positive */
    double direction;  /**< sine [rad] from u towards v */
    double phase;      /**< sine [rad] at u = v = 0 */
    int rows, columns; /**< grid: 2 or more each */
    double *grid;      /**< grid: rows x columns, the first row at v = 0; values at even steps from border to border */
    int points;        /**< attractor: 1 or more */
    double *place;     /**< attractor: points x 2, u and v [mm] */
    double radius;     /**< attractor [mm], positive */
} wcut_facade_field;

/**
 * The sum of fields at a place.
 *
 * @param[in]  count 1 or more
 * @param[in]  field count
 * @param[in]  size  [mm] of the facade along u and v, positive: what a grid is laid over
 * @param[in]  u, v  [mm] finite; a grid is constant beyond its border
 * @param[out] value
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also a value that is not finite): nothing was written.
 */
WCUT_API wcut_status wcut_facade_field_eval(int count, const wcut_facade_field *field, const double size[2], double u,
                                            double v, double *value);

/** What the elements stand on. */
typedef enum wcut_facade_lattice {
    WCUT_FACADE_LATTICE_PLANE,    /**< z = 0, columns along x, rows along y */
    WCUT_FACADE_LATTICE_CYLINDER, /**< its axis along y; columns around it */
    WCUT_FACADE_LATTICE_SURFACE, /**< a surface: columns along its u, rows along its v, at even arc lengths of both middles */
    WCUT_FACADE_LATTICE_FREE /**< every element where its own placement says */
} wcut_facade_lattice;

/** How the edges of neighbours meet. */
typedef enum wcut_facade_match {
    WCUT_FACADE_MATCH_NONE,   /**< each element has its own edges; what is between them is reported */
    WCUT_FACADE_MATCH_EDGE,   /**< a joint has one edge curve, which both elements have: positions agree */
    WCUT_FACADE_MATCH_TANGENT /**< and heights are moved to make kinks across joints smaller; what is left is reported */
} wcut_facade_match;

/** An element as it is asked for. */
typedef struct wcut_facade_placement {
    int row, column;  /**< of a lattice, from 0; free: any numbers */
    int turn;         /**< quarter turns of the block, counter-clockwise seen from outside: 0 .. 3 */
    bool mirrored;    /**< turned over about its feed axis: the upper half is the panel */
    int job;          /**< which of the jobs */
    wcut_vec3 origin; /**< free [mm]: the corner of the block at its frame's origin, before turn and mirror */
    wcut_vec3 x, y;   /**< free: directions of columns and rows, perpendicular */
} wcut_facade_placement;

/** What a facade is made from; everything is borrowed. */
typedef struct wcut_facade_plan {
    wcut_facade_lattice lattice;
    int rows, columns;           /**< of a lattice */
    double radius;               /**< cylinder [mm]: positive, faces outside; negative, faces inside */
    const wcut_surface *surface; /**< surface */
    double joint;                /**< [mm] gap between neighbours, not negative */
    wcut_facade_match match;
    double match_move; /**< [mm] how far a height may be moved for WCUT_FACADE_MATCH_TANGENT, positive */
    int placements;
    const wcut_facade_placement *placement; /**< placements, each cell of a lattice at most once */
    int jobs;
    const wcut_job *const *job; /**< jobs */
    int heights; /**< fields whose sum is the height of an edge [mm] in the block; 0: edges are the jobs' own */
    const wcut_facade_field *height; /**< heights */
    int extras;                      /**< fields whose sum is the wire's extra length [mm]; with heights 1 or more */
    const wcut_facade_field *extra;  /**< extras */
    double overrun; /**< [mm] with heights: of the edges beyond the block; negative: from the extra length */
} wcut_facade_plan;

/** An element where it stands. Borders of its block: 0 x = 0, 1 x = W, 2 y = 0 (entry), 3 y = L (exit). */
typedef struct wcut_facade_element {
    int row, column, turn;
    bool mirrored;
    wcut_vec3 origin, x, y, z; /**< the block's frame in the facade's: right-handed, unit */
    wcut_job *job;             /**< what it is cut by, in the block's frame */
    double *border[4]; /**< WCUT_FACADE_SAMPLES [mm] height of its shared edge in the block, along y or x; NULL: none */
    int joint[4];      /**< at each border; -1: none */
} wcut_facade_element;

/** Where two elements meet. */
typedef struct wcut_facade_joint {
    int element[2], border[2];       /**< the lower element number first */
    bool reversed;                   /**< the second element's border runs the other way */
    double opening_min, opening_max; /**< [mm] between both edges, over the joint: its width, more where blocks splay */
} wcut_facade_joint;

/** A facade. */
typedef struct wcut_facade {
    wcut_facade_match match;
    int rows, columns; /**< 0 where the placements are free */
    int elements;
    wcut_facade_element *element;
    int joints;
    wcut_facade_joint *joint;
    double moved; /**< [mm] largest change of a height by WCUT_FACADE_MATCH_TANGENT */
} wcut_facade;

/**
 * Lay out a facade: place every element, find its neighbours, give both sides of a joint one edge curve, and make each
 * element's job. Heights of fields are rounded to 2^-20 mm, so that an element that is turned over has the same ones.
 * The edge across the feed is the straight line between its corners, that along the feed what fields or jobs say.
 *
 * @param[in]  plan
 * @param[out] facade the caller's, to wcut_facade_destroy
 * @param[out] error  may be NULL; element or joint, what was found, what was expected
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (out of range; two elements in one cell or in one place, a block that does not fill
 *         its cell, an edge that three elements share, edges of neighbours that differ, tangents asked of jobs or of
 *         mixed feeds); WCUT_DEGENERATE (a field that leaves the block, a surface that folds or is too small for its
 *         blocks); WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_facade_create(const wcut_facade_plan *plan, wcut_facade **facade, wcut_error *error);

/** Free a facade; NULL is allowed. */
WCUT_API void wcut_facade_destroy(wcut_facade *facade);

/** The face of an element: that of its cut, carried to the edges that it shares. */
typedef struct wcut_element_face {
    wcut_vec3 block;       /**< [mm] W, L, H */
    wcut_surface *surface; /**< bicubic over the unit square, (s, t) -> (W s, L t, z); S_u x S_v points up */
    wcut_vec3 *point;      /**< samples x samples [mm] of it at even steps, row by row along y */
    double *force;         /**< samples x samples [N/mm] of the foam on the wire there; NULL: not known */
    double *moved;         /**< samples x samples [mm] height above the face that is cut */
    double *cut[4];        /**< samples [mm] heights of the borders as they are cut */
    double moved_max;      /**< [mm] greatest |moved| */
    double fit_error;      /**< [mm] of the cut's face, measured between samples where it was not moved */
    double radius_min;     /**< [mm] least radius of curvature, INFINITY where flat */
    double volume;         /**< [mm3] of the block below the face */
    double area;           /**< [mm2] */
} wcut_element_face;

/**
 * The face of a cut in its block, with its borders where neighbours have theirs. What a border is off by is spread over
 * the face linearly (a Coons patch of the differences, Coons 1967), and is in `moved`: the face that is cut is not this
 * one, but that much below it.
 *
 * @param[in]  wire     the wire's surface, such as wcut_surface_loft gives, over the whole block
 * @param[in]  block    [mm] W, L, H
 * @param[in]  border   4, each WCUT_FACADE_SAMPLES [mm] as in wcut_facade_element, equal at the corners; NULL entries:
 *                      the border stays where it is cut
 * @param[in]  stations, nodes rows and columns of the next two; 0: no force
 * @param[in]  position stations x nodes [mm]
 * @param[in]  force    stations x nodes [N/mm]
 * @param[out] face     the caller's, to wcut_element_face_destroy
 * @param[out] error    may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (the surface does not cover the block, folds or overhangs),
 *         WCUT_NOT_CONVERGED, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_element_face_create(const wcut_surface *wire, wcut_vec3 block, const double *const border[4],
                                              int stations, int nodes, const wcut_vec3 *position, const double *force,
                                              wcut_element_face **face, wcut_error *error);

/**
 * The same face again from its heights: one of equal heights is equal bit for bit.
 *
 * @param[in]  block  [mm]
 * @param[in]  height samples x samples [mm], the z of the points of wcut_element_face
 * @param[out] face   the caller's, to wcut_element_face_destroy; without force, moved and cut borders all zero
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_element_face_interpolate(wcut_vec3 block, const double *height, wcut_element_face **face);

/** Free a face; NULL is allowed. */
WCUT_API void wcut_element_face_destroy(wcut_element_face *face);

/** What is left at a joint. */
typedef struct wcut_joint_report {
    double gap_max; /**< [mm] between both edges, less the joint's own opening: 0 to rounding where an edge is shared */
    double step_max;                           /**< [mm] the same of the faces as they are cut */
    double angle_min, angle_median, angle_max; /**< [rad] between both faces along the joint, 0: no kink */
} wcut_joint_report;

/**
 * Compare both sides of a joint.
 *
 * @param[in]  facade
 * @param[in]  joint  0 .. facade->joints - 1
 * @param[in]  first, second faces of its elements
 * @param[out] report
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_joint_eval(const wcut_facade *facade, int joint, const wcut_element_face *first,
                                     const wcut_element_face *second, wcut_joint_report *report);

/**
 * The points of all faces in the facade's frame. Where a joint has no width and one edge, both elements have the same
 * points on it, bit for bit.
 *
 * @param[in]  facade
 * @param[in]  face  facade->elements; NULL entries: an element without a face
 * @param[out] point elements x samples x samples [mm], of an element without a face those of its block's base
 * @return WCUT_OK; WCUT_BAD_ARGUMENT: nothing was written.
 */
WCUT_API wcut_status wcut_facade_points(const wcut_facade *facade, const wcut_element_face *const *face,
                                        wcut_vec3 *point);

/** A panel that is cast on a face. */
typedef struct wcut_panel {
    wcut_mesh *mesh;  /**< closed, oriented outwards */
    wcut_brep *solid; /**< the same exactly */
    double volume;    /**< [mm3] */
    double area;      /**< [mm2] of the whole surface */
} wcut_panel;

/**
 * The panel between a face and its offset, cut off at the sides of the block.
 *
 * @param[in]  face
 * @param[in]  thickness [mm] not 0; positive: above the face, on the lower half; negative: below it
 * @param[in]  chord_tolerance [mm] between triangles and exact faces, positive
 * @param[out] panel     the caller's, to wcut_panel_destroy
 * @param[out] error     may be NULL; where the offset folds
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (the offset folds, or crosses itself), WCUT_NOT_CONVERGED,
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_panel_create(const wcut_element_face *face, double thickness, double chord_tolerance,
                                       wcut_panel **panel, wcut_error *error);

/** Free a panel; NULL is allowed. */
WCUT_API void wcut_panel_destroy(wcut_panel *panel);

#ifdef __cplusplus
}
#endif

#endif
