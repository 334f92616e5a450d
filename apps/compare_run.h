/* A comparison of a scan with a face, from the first point to the last figure. */
#ifndef APP_COMPARE_RUN_H
#define APP_COMPARE_RUN_H

#include <wirecut/wirecut.h>

#include "compare_reference.h"
#include "compare_scan.h"
#include "results.h"

/* what is asked for */
typedef struct app_compare_options {
    const char *reference;
    const app_call *call; /* whose options change a job; may be NULL */
    int files;
    const char **scan;
    bool quiet, flip;
    app_distance distance;
    double chord_tolerance;          /* [mm] */
    const char *force_law;           /* of a job, or NULL */
    wcut_length_unit reference_unit; /* of a mesh */
    app_scan_options scans;
    wcut_registration_method method;
    wcut_registration_options registration;
    const char *datum_path;                           /* NULL: none */
    const char *part, *inspector, *instrument, *date; /* the title block; NULL: not given */
    int bands;
    double band[WCUT_BANDS_MAX]; /* [mm] ascending */
    double tolerance, share;     /* [mm], [1]; tolerance 0: no gate */
    int normals;                 /* neighbours that make a point's; 0: none are wanted */
    int reconstruct;             /* 0 none, 1 field */
    double support;              /* [mm] 0: by the scan's spacing */
    int threads;
} app_compare_options;

typedef struct app_comparison {
    app_compare_options options;
    app_reference reference;
    app_scans scans;
    wcut_registration registration;
    int datums;
    wcut_datum_residual *datum;         /* datums: what the registration leaves of them */
    wcut_deviation_summary *summary[2]; /* as registered, as scanned; the second NULL without a registration */
    wcut_compared found;                /* what is written; complete but for the files */
    double support;                     /* [mm] in use */
    double limit;                       /* [mm] value of the strongest colour */
    /* the face: a grid of a job's, the vertices of a mesh */
    wcut_mesh *mesh; /* to be coloured: borrowed from the reference where that is a mesh */
    double *value;
    unsigned char *present;
    wcut_face_map *map;   /* of a job */
    double *sum, *weight; /* of a mesh */
    /* the points of scans.point, moved as registered */
    double *deviation; /* scans.count [mm]; nan where a point does not count */
    wcut_vec3 *normal; /* scans.count, of the points as registered; NULL unless wanted */
    wcut_foot *foot;   /* scans.count; NULL unless they are to be reconstructed */
    wcut_reconstruction *reconstruction;
    wcut_statistics face_to_scan, to_scan, to_face;
    wcut_deviation_stream *points; /* deviation.ply */
} app_comparison;

/* Compare, and write deviation.ply on the way. Gives an exit code; the comparison is to be cleared whatever it is. */
int app_comparison_run(app_comparison *comparison, const app_compare_options *options, app_results *results);
void app_comparison_clear(app_comparison *comparison);

#endif
