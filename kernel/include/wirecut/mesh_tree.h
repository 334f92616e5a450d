/* wirecut/mesh_tree.h - the closest point of a triangle mesh, its side and its border. */
#ifndef WCUT_MESH_TREE_H
#define WCUT_MESH_TREE_H

#include <wirecut/export.h>
#include <wirecut/mesh.h>
#include <wirecut/status.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The point of a mesh that is closest to a query. */
typedef struct wcut_mesh_foot {
    wcut_vec3 point; /**< [mm] */
    double distance; /**< [mm] from the query, not negative */
    double height;   /**< [mm] of the query over the foot's normal, positive on the side from which triangles are seen
                          counter-clockwise; at an edge or a corner the normal is the angle-weighted one (Baerentzen,
                          Aanaes 2005), whose sign is right on every closed or open manifold */
    double b, c;     /**< weights of the triangle's second and third corner */
    int triangle;    /**< that the foot is in */
    int border;      /**< 1: the foot is on an edge that has one triangle only, or at the end of such an edge */
    int beyond;      /**< 1: the foot is on the border and the query lies beyond it, not above it */
} wcut_mesh_foot;

/** Properties of a mesh. */
typedef struct wcut_mesh_tree_info {
    int border_edges;      /**< with one triangle: 0 on a closed mesh */
    int nonmanifold_edges; /**< with three or more triangles, or two that are wound against each other: near them the
                              side is not to be trusted */
    int flat;              /**< triangles without area; they have no side of their own */
    double area;           /**< [mm^2] */
    wcut_vec3 area_sum;  /**< [mm^2] the sum of the triangles' area vectors: where it points down, so do most of them */
    wcut_vec3 low, high; /**< [mm] the box */
} wcut_mesh_tree_info;

/** What queries of one mesh share: a tree of boxes, eight to a node. Const once made, for any number of threads. */
typedef struct wcut_mesh_tree wcut_mesh_tree;

/**
 * Prepare a mesh for queries; it is copied.
 *
 * @param[in]  mesh at least one triangle; finite vertices up to 1e12 mm, indices within them
 * @param[out] tree the caller's, to wcut_mesh_tree_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_DEGENERATE (no triangle has an area), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mesh_tree_create(const wcut_mesh *mesh, wcut_mesh_tree **tree);

/** Free a tree; NULL is allowed. */
WCUT_API void wcut_mesh_tree_destroy(wcut_mesh_tree *tree);

/** The properties of the mesh, borrowed; NULL for NULL. */
WCUT_API const wcut_mesh_tree_info *wcut_mesh_tree_view(const wcut_mesh_tree *tree);

/**
 * The closest point of the mesh for each query, exact to rounding. Queries are taken in an order that keeps neighbours
 * together, each starting from the one before; feet come back in the order given, the same bytes for every number of
 * threads.
 *
 * @param[in]  tree    of the mesh
 * @param[in]  count   queries, 0 or more
 * @param[in]  query   count [mm], finite, up to 1e12
 * @param[in]  threads 1 or more
 * @param[out] foot    count
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mesh_tree_locate(const wcut_mesh_tree *tree, int count, const wcut_vec3 *query, int threads,
                                           wcut_mesh_foot *foot);

#ifdef __cplusplus
}
#endif

#endif
