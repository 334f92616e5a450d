/* wirecut/deviation.h - how far points of a scan are from a face, with sign, and which of them count. */
#ifndef WCUT_DEVIATION_H
#define WCUT_DEVIATION_H

#include <wirecut/export.h>
#include <wirecut/mesh_tree.h>
#include <wirecut/projection.h>
#include <wirecut/status.h>
#include <wirecut/trimmed.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Where a point is relative to the face; the first two count as deviations. */
typedef enum wcut_place {
    WCUT_PLACE_INSIDE,
    WCUT_PLACE_BORDER,    /**< counts, but the foot is within `border` of the window's sides or on the face's border */
    WCUT_PLACE_BEYOND,    /**< outside: the foot is on the face's border and the point beyond it, or the foot is outside
                               the window, or the point further away than `reach` */
    WCUT_PLACE_AMBIGUOUS, /**< several feet tie, or the side cannot be told: a crease, a pole, an edge of a bad mesh */
    WCUT_PLACE_COUNT
} wcut_place;

/** A point's deviation. */
typedef struct wcut_deviation {
    double distance; /**< [mm] signed: positive on the side of the face's normal, where material was left above it */
    wcut_vec3 foot;  /**< [mm] the closest point of the face */
    double u, v;     /**< parameters of the foot; on a mesh the weights of the triangle's second and third corner */
    int triangle;    /**< that the foot is in; -1 on a surface */
    wcut_place place;
} wcut_deviation;

/** What counts as a deviation. */
typedef struct wcut_deviation_options {
    wcut_vec3 low, high; /**< [mm] window that holds the face; outside it the surface continues; default: all */
    double border;       /**< [mm] default 1; not negative */
    double reach;        /**< [mm] points further away do not belong to the face; default 0: all do */
    int flip;            /**< 1: the face's normal is the other one; default 0 */
} wcut_deviation_options;

/** The defaults stated at the fields. */
WCUT_API wcut_deviation_options wcut_deviation_options_default(void);

/** "inside", "border", "beyond", "ambiguous"; NULL outside the enum. */
WCUT_API const char *wcut_place_name(wcut_place place);

/**
 * Deviations from a surface, to its exact closest points.
 *
 * @param[in]  projection of the face
 * @param[in]  count      points, 0 or more
 * @param[in]  point      count [mm], finite, up to 1e12
 * @param[in]  options    NULL for the defaults
 * @param[in]  threads    1 or more; the result does not depend on it
 * @param[out] deviation  count
 * @param[out] foot       count, or NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_from_surface(const wcut_projection *projection, int count, const wcut_vec3 *point,
                                                 const wcut_deviation_options *options, int threads,
                                                 wcut_deviation *deviation, wcut_foot *foot);

/**
 * Deviations from a mesh.
 *
 * @param[in]  tree      of the face's triangles
 * @param[in]  count     points, 0 or more
 * @param[in]  point     count [mm], finite, up to 1e12
 * @param[in]  options   NULL for the defaults
 * @param[in]  threads   1 or more; the result does not depend on it
 * @param[out] deviation count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_from_mesh(const wcut_mesh_tree *tree, int count, const wcut_vec3 *point,
                                              const wcut_deviation_options *options, int threads,
                                              wcut_deviation *deviation);

/**
 * Convert feet on a tessellation to feet on its surface: u, v become the surface's parameters, triangle -1.
 *
 * @param[in]     mesh      with uv, that the deviations are from
 * @param[in]     count     0 or more
 * @param[in,out] deviation count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (a triangle that the mesh does not have): nothing was written.
 */
WCUT_API wcut_status wcut_deviation_onto_surface(const wcut_mesh *mesh, int count, wcut_deviation *deviation);

/**
 * The distance of each query from the nearest of some points, such as of a face from its scan.
 *
 * @param[in]  count    points, 1 or more
 * @param[in]  point    count [mm], finite, up to 1e12
 * @param[in]  queries  0 or more
 * @param[in]  query    queries [mm], finite, up to 1e12
 * @param[in]  threads  1 or more; the result does not depend on it
 * @param[out] distance queries [mm]
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_cloud_locate(int count, const wcut_vec3 *point, int queries, const wcut_vec3 *query,
                                       int threads, double *distance);

/**
 * Deviations from the part of a surface that counts: to the exact closest points of the surface. A point whose foot is
 * outside the loops is beyond; one whose foot is within the options' border of a loop is at the border.
 *
 * @param[in]  trimmed    of wcut_trimmed_create
 * @param[in]  projection of its surface
 * @param[in]  count      points, 0 or more
 * @param[in]  point      count [mm], finite, up to 1e12
 * @param[in]  options    NULL for the defaults
 * @param[in]  threads    1 or more; the result does not depend on it
 * @param[out] deviation  count
 * @param[out] foot       count, or NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_deviation_from_trimmed(const wcut_trimmed *trimmed, const wcut_projection *projection,
                                                 int count, const wcut_vec3 *point,
                                                 const wcut_deviation_options *options, int threads,
                                                 wcut_deviation *deviation, wcut_foot *foot);

#ifdef __cplusplus
}
#endif

#endif
