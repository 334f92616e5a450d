/* What a scan is compared with: the face that a job leaves, a mesh, or a surface. */
#ifndef WCUT_IO_SCAN_COMPARE_FACE_H
#define WCUT_IO_SCAN_COMPARE_FACE_H

#include <stdbool.h>
#include <wirecut/compare.h>
#include <wirecut/face.h>
#include <wirecut/job.h>
#include <wirecut/mesh_tree.h>
#include <wirecut/projection.h>
#include <wirecut/read.h>
#include <wirecut/report.h>

/* what is borrowed has no owner here: job, history and mesh are the caller's unless `owned_*` is them */
typedef struct wcut_compare_face {
    const char *name;
    char hash[WCUT_SHA256_TEXT]; /* "" where it is no file */
    wcut_compare_distance distance;
    wcut_deviation_options options;
    wcut_vec3 low, high; /* [mm] the block, or the box */
    double plan;         /* [mm^2] of it seen from above */

    /* of a job */
    const wcut_job *job;
    const wcut_setup *setup;
    const wcut_history *history;
    wcut_job *owned_job;
    wcut_setup *owned_setup;
    wcut_history *owned_history;
    wcut_face *face;
    wcut_vec3 *mount_a, *mount_b; /* history->stations [mm] */
    double kerf;                  /* [mm] on average in the block */

    /* the exact surface, of a job's face or as given; NULL where the reference is a mesh */
    const wcut_surface *surface;

    /* the surface that feet are on: the exact one, or `base` */
    wcut_projection *projection;

    /* of a mesh, or of a surface whose distances are taken to triangles */
    const wcut_mesh *mesh;
    wcut_mesh *owned_mesh;
    wcut_mesh_tree *tree;
    wcut_surface *base; /* of a mesh: the plane below it */

    /* of a CAD file: its faces, and the one of them that `surface` is of; the others that are compared with it, with a
       projection each */
    wcut_trimmed_set *faces;
    const wcut_trimmed *trimmed;
    int others;
    const wcut_trimmed **other; /* others */
    wcut_projection **other_projection;
} wcut_compare_face;

/* Read, simulate, prepare. The statuses of wcut_compare_run; the face is to be cleared whatever they are. */
wcut_status wcut_compare_face_load(const wcut_compare_reference *reference, const wcut_compare_options *options,
                                   const wcut_compare_watch *watch, wcut_compare_face *face, wcut_error *error);

/* The surface that a scan is reconstructed over: the exact one, or the plane below a mesh. WCUT_DEGENERATE: the mesh is
   no sheet. */
wcut_status wcut_compare_face_base(wcut_compare_face *face, const wcut_surface **surface, wcut_error *error);

/* Before many queries. Statuses of wcut_projection_prepare_many. */
wcut_status wcut_compare_face_prepare(wcut_compare_face *face);

void wcut_compare_face_clear(wcut_compare_face *face);

/* whether distances are taken to triangles */
bool wcut_compare_face_by_triangles(const wcut_compare_face *face);

/* Deviations of points, by the exact surface or by triangles; foot may be NULL, and is not written for triangles. */
wcut_status wcut_compare_face_locate(const wcut_compare_face *face, int count, const wcut_vec3 *point, int threads,
                                     wcut_deviation *deviation, wcut_foot *foot);

#endif
