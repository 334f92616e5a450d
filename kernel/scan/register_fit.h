/* Distances of a scan from a surface, as a best fit sees them. */
#ifndef WCUT_SCAN_REGISTER_FIT_H
#define WCUT_SCAN_REGISTER_FIT_H

#include <wirecut/projection.h>

#include "scan/register_solve.h"

/* a sample of the scan, and room for its distances at a motion */
typedef struct wcut_register_cloud {
    const wcut_projection *projection;
    int count, threads;
    double keep;
    wcut_vec3 *point;  /* count, the scan's */
    wcut_vec3 *moved;  /* count */
    wcut_vec3 *normal; /* count, of the surface at the foot; 0 where the point does not count */
    wcut_foot *foot;   /* count */
    double *square;    /* count */
} wcut_register_cloud;

/* at most `most` of the points, evenly over their order. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_register_sample(const wcut_projection *projection, int count, const wcut_vec3 *point, int most,
                                 double keep, int threads, wcut_register_cloud *cloud);
void wcut_register_sample_clear(wcut_register_cloud *cloud);

/* a wcut_register_model of distances along the surface's normal, trimmed; data is a wcut_register_cloud */
wcut_status wcut_register_distances(void *data, const wcut_motion *motion, wcut_register_sums *sums);

/* [mm] RMS of the share kept of the closest distances at a motion, the surface's border included */
wcut_status wcut_register_closeness(wcut_register_cloud *cloud, const wcut_motion *motion, double *rms);

/* the least-squares problem of the sample with all its parameters but the number of steps; the options are borrowed */
wcut_register_problem wcut_register_fit_problem(wcut_register_cloud *cloud, const wcut_registration_options *options,
                                                double length);

/* Motions that put the sheet of the scan onto the surface's, turned about its normal and with either side up: the best
   of them, brought close with few points, against `motion` itself. motion: the best one out; rival as in
   wcut_registration. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_register_coarse(const wcut_projection *projection, int count, const wcut_vec3 *point, double length,
                                 const wcut_registration_options *options, int threads, wcut_motion *motion,
                                 double *rival);

#endif
