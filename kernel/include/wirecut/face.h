/* wirecut/face.h - the simulated cut face of the lower half: what a scan is compared with. */
#ifndef WCUT_FACE_H
#define WCUT_FACE_H

#include <wirecut/deviation.h>
#include <wirecut/export.h>
#include <wirecut/history.h>
#include <wirecut/job.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The face under the wire's surface, and the part of it that is in the block as a grid. */
typedef struct wcut_face {
    wcut_surface *surface; /**< u along the wire, v over the stations; S_u x S_v points to the removed half */
    wcut_vec3 low, high;   /**< [mm] the block */
    int stations, nodes;   /**< rows and columns of the grid */
    double *parameter;     /**< stations: v of each */
    double *begin, *end;   /**< stations: u where the wire of each enters and leaves the block's width */
    wcut_vec3 *point;      /**< stations x nodes [mm]: at even steps of u from begin to end; rows in front of the block
                                and behind it are drawn back to its edge, so that the grid ends where the block does */
    double *v;             /**< stations x nodes: of the points */
    unsigned char *inside; /**< stations x nodes: 1 where the station itself is in the block, 0 where drawn back */
    double *force;         /**< stations x nodes [N/mm] of the foam across the wire */
    double *curvature;     /**< stations x nodes [1/mm] of the face, the larger principal one; 0 where it has none */
    double *half_kerf;     /**< stations x nodes [mm] by which the wire's surface was lowered */
    double *time;          /**< stations [s] since entry */
    double *path_bend;     /**< stations [1/mm] curvature of the path: the mean of both mounts' paths */
    wcut_phase *phase;     /**< stations */
    int dropped;           /**< sections that were too near to the one before */
} wcut_face;

/**
 * The face that a cut leaves on the lower half: every node of every station lowered along the wire's surface's normal
 * by half the kerf, width + per_q Q_eff with the job's Q_eff = Q_I / v at the node, moved by what effects of the job
 * act on the face or its scan, and lofted.
 *
 * @param[in]  job     its block, heat, kerf and effects are read
 * @param[in]  history of that job, at least two stations and nodes
 * @param[in]  mount_a history->stations [mm] path of the mount, as wcut_history_path gives; NULL: path_bend is 0
 * @param[in]  mount_b history->stations [mm]; NULL as mount_a
 * @param[in]  merge   [mm] as wcut_surface_loft
 * @param[out] face    the caller's, to wcut_face_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (the wire sweeps no surface, or none in the block),
 *         WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_face_create(const wcut_job *job, const wcut_history *history, const wcut_vec3 *mount_a,
                                      const wcut_vec3 *mount_b, double merge, wcut_face **face);

/** Free a face; NULL is allowed. */
WCUT_API void wcut_face_destroy(wcut_face *face);

/** [mm] The mean kerf over the grid in the block; the face is lowered by half of the kerf. */
WCUT_API double wcut_face_kerf(const wcut_face *face);

/**
 * The grid of a face as triangles, two to a cell, without those that have no area. Vertices are the grid's
 * points, all of them, in its order.
 *
 * @param[in]  face
 * @param[out] mesh the caller's, to wcut_mesh_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also more triangles than INT_MAX / 3), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_face_mesh(const wcut_face *face, wcut_mesh **mesh);

/** Where a foot is on a face's grid: row + share in v, column + share in u, both clamped to the grid;
 * NaN gives the grid's beginning. */
WCUT_API void wcut_face_locate(const wcut_face *face, double u, double v, double *row, double *column);

/**
 * Deviations spread over a face's grid: the mean of what is near each point, weighted by a hat of one step each way;
 * where the weight there is too small, the mean over a window that grows up to `support`.
 */
typedef struct wcut_face_map {
    int rows, columns;
    double *sum, *weight; /**< rows x columns */
} wcut_face_map;

/**
 * Begin a map.
 *
 * @param[in]  face of the deviations' feet
 * @param[out] map  the caller's, to wcut_face_map_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_face_map_create(const wcut_face *face, wcut_face_map **map);

/** Add deviations; those that are beyond, ambiguous or not finite are skipped. */
WCUT_API void wcut_face_map_add(wcut_face_map *map, const wcut_face *face, int count, const wcut_deviation *deviation);

/**
 * The values of a map.
 *
 * @param[in]  map     of wcut_face_map_create
 * @param[in]  face    that the map was made for
 * @param[in]  support [mm] largest distance that a deviation is spread over; not negative
 * @param[out] value   rows x columns [mm]
 * @param[out] present rows x columns: 0 where nothing was measured; then the value is 0
 * @param[out] area    [mm^2] of the face in the block where nothing was measured; may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_face_map_eval(const wcut_face_map *map, const wcut_face *face, double support, double *value,
                                        unsigned char *present, double *area);

/**
 * Spread deviations from a mesh over its vertices, each by the weights of its foot; those that do not count are
 * skipped. The value of a vertex is sum / weight.
 *
 * @param[in]     mesh      that the deviations are from
 * @param[in]     count     0 or more
 * @param[in]     deviation count
 * @param[in,out] sum       mesh->vertex_count [mm]
 * @param[in,out] weight    mesh->vertex_count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT (also a triangle that the mesh does not have): the sums are as they were.
 */
WCUT_API wcut_status wcut_mesh_spread(const wcut_mesh *mesh, int count, const wcut_deviation *deviation, double *sum,
                                      double *weight);

/**
 * The values of a mesh's vertices from what was spread over them; a vertex that has none of its own but points of the
 * scan within `support` takes the mean of its neighbours, from one to the next.
 *
 * @param[in]  mesh        that the deviations are from
 * @param[in]  sum, weight of wcut_mesh_spread
 * @param[in]  count       points of the scan, 1 or more
 * @param[in]  point       count [mm], finite, up to 1e12
 * @param[in]  support     [mm] radius around a point within which the face counts as measured, positive
 * @param[in]  threads     1 or more; the result does not depend on it
 * @param[out] value       mesh->vertex_count [mm]
 * @param[out] present     mesh->vertex_count: 0 where nothing was measured; then the value is 0
 * @param[out] area        [mm^2] of the mesh without a point within the support, sampled at that distance
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mesh_map_eval(const wcut_mesh *mesh, const double *sum, const double *weight, int count,
                                        const wcut_vec3 *point, double support, int threads, double *value,
                                        unsigned char *present, double *area);

/** Free a map; NULL is allowed. */
WCUT_API void wcut_face_map_destroy(wcut_face_map *map);

#ifdef __cplusplus
}
#endif

#endif
