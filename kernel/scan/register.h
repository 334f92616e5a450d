/* What the ways to register share: checked options, how many points, the matrix. */
#ifndef WCUT_SCAN_REGISTER_H
#define WCUT_SCAN_REGISTER_H

#include <wirecut/registration.h>

#include "scan/register_motion.h"

/* options or the defaults, checked: WCUT_BAD_ARGUMENT */
wcut_status wcut_register_options(const wcut_registration_options *given, wcut_registration_options *options,
                                  wcut_error *error);

/* the six values that locked degrees of freedom keep and others start from */
void wcut_register_start(const wcut_registration_options *options, double *x);

/* the 4 x 4 matrix of a motion */
void wcut_register_matrix(const wcut_motion *motion, double *matrix);

#endif
