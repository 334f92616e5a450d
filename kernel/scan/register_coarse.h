/* A first guess for a best fit. */
#ifndef WCUT_SCAN_REGISTER_COARSE_H
#define WCUT_SCAN_REGISTER_COARSE_H

#include "scan/register_cloud.h"

/* Motions that put the sheet of the scan onto the surface's, turned about its normal and with either side up: the best
   of them, brought close with few points, against `motion` itself. motion: the best one out; rival as in
   wcut_registration. WCUT_NO_MEMORY: nothing was written. */
wcut_status wcut_register_coarse(wcut_register_face face, int count, const wcut_vec3 *point, double length,
                                 const wcut_registration_options *options, int threads, wcut_motion *motion,
                                 double *rival);

#endif
