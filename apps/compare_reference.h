/* What a scan is compared with: the face that a job leaves, or a mesh. */
#ifndef APP_COMPARE_REFERENCE_H
#define APP_COMPARE_REFERENCE_H

#include <stdbool.h>
#include <wirecut/wirecut.h>

#include "command.h"

/* how distances are taken */
typedef enum app_distance { APP_TO_SURFACE, APP_TO_MESH, APP_TO_RECONSTRUCTION } app_distance;

typedef struct app_reference {
    const char *path;
    char hash[WCUT_SHA256_TEXT];
    bool is_job;
    app_distance distance;
    wcut_deviation_options options;
    wcut_vec3 low, high; /* [mm] the block, or the mesh's box */
    double plan;         /* [mm^2] of it seen from above */
    /* of a job */
    wcut_job *job;
    wcut_setup *setup;
    wcut_history *history;
    wcut_face *face;
    wcut_projection *projection;
    wcut_vec3 *mount_a, *mount_b; /* history->stations [mm] */
    double kerf;                  /* [mm] on average in the block */
    /* of a mesh, or of a job whose distances are taken to triangles */
    wcut_mesh *mesh;
    wcut_mesh_tree *tree;
    wcut_surface *base; /* of a mesh: the plane below it; `projection` is then of that */
} app_reference;

/* what is wanted of it */
typedef struct app_reference_options {
    const char *path;
    const char *force_law; /* of a job: a file, or NULL */
    const app_call *call;  /* whose options change a job; may be NULL */
    app_distance distance;
    double chord_tolerance; /* [mm] of a job's triangles */
    wcut_length_unit unit;  /* of a mesh */
    bool flip, quiet;
} app_reference_options;

/* Read, simulate, prepare. Gives an exit code, after a line that says why. */
int app_reference_load(app_reference *reference, const app_reference_options *options);

/* The surface that a scan is reconstructed over: a job's face, or the plane below a mesh. Gives an exit code, after a
   line that says why where the mesh is no sheet. */
int app_reference_base(app_reference *reference, const wcut_surface **surface);

void app_reference_clear(app_reference *reference);

/* Deviations of points, by the exact surface or by triangles; foot may be NULL, and is not written for triangles. */
wcut_status app_reference_locate(const app_reference *reference, int count, const wcut_vec3 *point, int threads,
                                 wcut_deviation *deviation, wcut_foot *foot);

#endif
