/* A comparison in the making: what its steps hand on. */
#ifndef WCUT_IO_SCAN_COMPARE_STATE_H
#define WCUT_IO_SCAN_COMPARE_STATE_H

#include <wirecut/compare.h>
#include <wirecut/reconstruction.h>

#include "io/scan/compare_cloud.h"
#include "io/scan/compare_face.h"

enum { WCUT_COMPARE_FOUND, WCUT_COMPARE_UNMOVED };

typedef struct wcut_comparing {
    wcut_compare_result result; /* the first member: what the caller has is this */
    wcut_compare_options options;
    wcut_compare_watch watch;
    wcut_compare_face face;
    wcut_compare_cloud cloud;
    wcut_registration registration;
    int datums;
    wcut_datum_residual *datum;         /* datums: what the registration leaves of them */
    wcut_regions *regions;              /* zones and sections of the user; NULL: none */
    wcut_survey *survey;                /* of them */
    wcut_deviation_summary *summary[2]; /* as registered, as scanned; the second NULL without a registration */
    double support;                     /* [mm] in use */
    double limit;                       /* [mm] value of the strongest colour */

    /* what is coloured: the grid of a job's face, the vertices of a mesh */
    const wcut_mesh *mesh;
    wcut_mesh *grid; /* of a job: the mesh above */
    double *value;
    unsigned char *present;
    wcut_face_map *map;   /* of a job */
    double *sum, *weight; /* of a mesh */

    /* the points of cloud.point, moved as registered */
    double *deviation;   /* cloud.count [mm]; nan where a point does not count */
    wcut_deviation *row; /* cloud.count; NULL unless wanted */
    wcut_vec3 *normal;   /* cloud.count; NULL unless wanted */
    wcut_foot *foot;     /* cloud.count; NULL unless they are to be reconstructed */
    wcut_reconstruction *reconstruction;
    wcut_statistics face_to_scan, to_scan, to_face;
    wcut_results *results;         /* borrowed; NULL: no file is written */
    wcut_deviation_stream *points; /* deviation.ply; NULL: it is not written */
} wcut_comparing;

/* a failure of a step; a text that the step has filled already stays */
wcut_status wcut_compare_fail(wcut_status status, const char *step, wcut_error *error);

/* "NAME: found points ... none of them over the face" */
wcut_status wcut_compare_refuse_elsewhere(const wcut_comparing *comparing, wcut_error *error);

/* Move the scan as the options say. */
wcut_status wcut_compare_register(wcut_comparing *comparing, wcut_error *error);

/* Every point's deviation into summary, map and deviation.ply; of those held also by itself. */
wcut_status wcut_compare_measure(wcut_comparing *comparing, wcut_error *error);

/* The scan as a mesh, and its figures both ways, where that is wanted. */
wcut_status wcut_compare_reconstruct(wcut_comparing *comparing, wcut_error *error);

/* From the face to the scan, and the values of the map. *unmeasured: [mm^2] without points. */
wcut_status wcut_compare_measure_back(wcut_comparing *comparing, double *unmeasured, wcut_error *error);

#endif
