/* One process law fitted to steady test cuts: y = a exp(-b Q_eff) + c. */
#ifndef WCUT_FOAM_LAW_FIT_H
#define WCUT_FOAM_LAW_FIT_H

#include <stdbool.h>
#include <wirecut/calibration.h>

/* the cuts as one law sees them: n values each */
typedef struct wcut_law_data {
    int n;
    bool with_c;                        /* equation (1), three parameters; else (2), two */
    const double *q;                    /* [J/m^2] positive */
    const double *y;                    /* [N/mm] */
    const double *weight;               /* positive */
    const double *log_heat, *log_speed; /* to tell replicates, and to test for a power of the speed */
} wcut_law_data;

/*
 * Fit, and all that is known about the fit; point: n. WCUT_OK; WCUT_DEGENERATE: the cuts do not determine the law, or
 * want one that does not fall with Q_eff; WCUT_NOT_CONVERGED; WCUT_NO_MEMORY: nothing was written.
 */
wcut_status wcut_law_fit_solve(const wcut_law_data *data, const wcut_calibration_options *options, wcut_law_fit *fit,
                               wcut_law_fit_point *point);

/* the standard error of a fitted law's value at q [J/m^2] by the delta method: sqrt(g^T C g) [N/mm] */
double wcut_law_fit_error(const wcut_law_fit *fit, double q);

#endif
