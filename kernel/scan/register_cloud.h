/* Distances of a scan from a face, as a best fit sees them. */
#ifndef WCUT_SCAN_REGISTER_CLOUD_H
#define WCUT_SCAN_REGISTER_CLOUD_H

#include <wirecut/mesh_tree.h>
#include <wirecut/projection.h>

#include "scan/register_solve.h"

/* what is registered to: a surface, or the triangles of a mesh; borrowed */
typedef struct wcut_register_face {
    const wcut_projection *projection; /* NULL: a mesh */
    const wcut_mesh *mesh;
    const wcut_mesh_tree *tree;
} wcut_register_face;

/* a sample of the scan, and room for its distances at a motion */
typedef struct wcut_register_cloud {
    wcut_register_face face;
    int count, threads;
    double keep;
    wcut_vec3 *point;  /* count, the scan's */
    wcut_vec3 *moved;  /* count */
    wcut_vec3 *normal; /* count, of the face at the foot; 0 where it has none */
    wcut_vec3 *at;     /* count, the foot */
    void *foot;        /* count wcut_foot, or wcut_mesh_foot */
    double *weight;    /* count, of the last wcut_register_distances: 0 .. 1 */
    double *square;    /* count */
} wcut_register_cloud;

/* at most `max` of the points, evenly over their order. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_register_sample(wcut_register_face face, int count, const wcut_vec3 *point, int max, double keep,
                                 int threads, wcut_register_cloud *cloud);
void wcut_register_sample_clear(wcut_register_cloud *cloud);

/* A wcut_register_model of distances along the surface's normal; data is a wcut_register_cloud. The share kept sets a
   limit; weights fall from 1 to 0 about it, and beyond a border with the way beyond it, so that no point comes or goes
   at once. */
wcut_status wcut_register_distances(void *data, const wcut_motion *motion, wcut_register_sums *sums);

/* a wcut_register_cost of the same: feet, normals and weights of the last call */
double wcut_register_held(const void *data, const wcut_motion *motion);

/* [mm] RMS of the share kept of the closest distances at a motion, the surface's border included */
wcut_status wcut_register_closeness(wcut_register_cloud *cloud, const wcut_motion *motion, double *rms);

/* the least-squares problem of the sample with all its parameters but the number of steps; the options are borrowed */
wcut_register_problem wcut_register_fit_problem(wcut_register_cloud *cloud, const wcut_registration_options *options,
                                                double length);

#endif
