/* The paper's integrator: accumulated forces by Euler predictor and trapezoidal corrector, the rate by the secant
   method (Rust et al. 2016, 9-11). */
#include "base/fail.h"
#include "cut/run.h"

wcut_status wcut_heun_advance(wcut_cut *cut, const wcut_target *target, double *elapsed, wcut_error *error) {
    (void)cut, (void)target, (void)elapsed;
    return wcut_fail(error, WCUT_INTERNAL, "x");
}
