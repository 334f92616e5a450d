/* wirecut/mesh.h - triangles: what a surface is tessellated into and what mesh files hold. */
#ifndef WCUT_MESH_H
#define WCUT_MESH_H

#include <wirecut/export.h>
#include <wirecut/status.h>
#include <wirecut/surface.h>
#include <wirecut/vec3.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Shared vertices, counter-clockwise triangles seen from the side the normals point to. */
typedef struct wcut_mesh {
    int vertex_count;
    int triangle_count;
    wcut_vec3 *vertex; /**< vertex_count [mm] */
    wcut_vec3 *normal; /**< vertex_count [1], unit; NULL where there are none */
    double *uv;        /**< vertex_count x 2, surface parameters; NULL where there are none */
    double *scalar;    /**< vertex_count, a value per vertex (force magnitude [N/mm]); NULL where there is none */
    int *triangle;     /**< triangle_count x 3 */
} wcut_mesh;

/** Which of a mesh's optional arrays are there. */
enum { WCUT_MESH_NORMAL = 1, WCUT_MESH_UV = 2, WCUT_MESH_SCALAR = 4 };

/**
 * A mesh with zeroed arrays for the caller to fill.
 *
 * @param[in]  vertex_count   0 or more
 * @param[in]  triangle_count 0 .. INT_MAX / 3
 * @param[in]  parts          sum of WCUT_MESH_...
 * @param[out] mesh           the caller's, to wcut_mesh_destroy
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_mesh_create(int vertex_count, int triangle_count, unsigned parts, wcut_mesh **mesh);

/** What a tessellation reached. */
typedef struct wcut_tessellation_report {
    double chord_error; /**< [mm] measured: largest distance sampled between triangles and surface */
    int rows, columns;  /**< of the structured grid */
} wcut_tessellation_report;

/**
 * Triangulate a surface on a structured grid so that triangles and surface are no further apart than a chord tolerance:
 * spacing from the bound (h_u^2 |S_uu| + 2 h_u h_v |S_uv| + h_v^2 |S_vv|) / 8, then measured and refined until held.
 * Vertex j * columns + i is S(u_i, v_j); creases (knots of full multiplicity) are grid lines. Triangles whose corners
 * coincide but for rounding are left out; a vertex without a normal of its own (a pole) takes that of its neighbours.
 *
 * @param[in]  surface         a valid surface
 * @param[in]  chord_tolerance [mm] positive
 * @param[out] mesh            the caller's, to wcut_mesh_destroy; with normals and uv
 * @param[out] report          may be NULL
 * @return WCUT_OK; WCUT_BAD_ARGUMENT, WCUT_NOT_CONVERGED (more than INT_MAX / 6 vertices would be needed),
 *         WCUT_DEGENERATE (the surface has no area), WCUT_NO_MEMORY: nothing was written.
 */
WCUT_API wcut_status wcut_surface_tessellate(const wcut_surface *surface, double chord_tolerance, wcut_mesh **mesh,
                                             wcut_tessellation_report *report);

/**
 * Give every vertex of a lofted mesh the value of a nodal field, bilinear between nodes and stations.
 *
 * @param[in,out] mesh      with uv
 * @param[in]     stations  rows of field
 * @param[in]     nodes     columns of field
 * @param[in]     parameter stations: v of each section, from wcut_surface_loft
 * @param[in]     field     stations x nodes, finite
 * @return WCUT_OK: mesh->scalar is filled; WCUT_BAD_ARGUMENT, WCUT_NO_MEMORY: the mesh is as it was.
 */
WCUT_API wcut_status wcut_mesh_sample(wcut_mesh *mesh, int stations, int nodes, const double *parameter,
                                      const double *field);

/** Free a mesh; NULL is allowed. */
WCUT_API void wcut_mesh_destroy(wcut_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
