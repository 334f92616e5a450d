/* Force and tension of a wire in foam against effective heat input (Bain 2011; Rust et al. 2016, 1 and 2). */
#include <wirecut/force_law.h>

#include "base/numbers.h"
#include "foam/force_law.h"

double wcut_q_eff_eval(double heat, double speed) { return speed > 0 ? heat * MM_PER_M / speed : (double)INFINITY; }

double wcut_force_law_eval(const wcut_force_law *law, double heat, double speed) {
    return speed > 0 ? law->a * exp(-law->b * wcut_q_eff_eval(heat, speed)) : 0;
}

/* v with a exp(-b Q / v) = value */
static wcut_status invert(double a, double b, double heat, double value, double *speed) {
    if (!is_positive(a) || !is_positive(b) || !is_positive(heat) || !speed) return WCUT_BAD_ARGUMENT;
    if (!(value > 0 && value < a)) return WCUT_BAD_ARGUMENT;
    *speed = b * heat * MM_PER_M / log(a / value);
    return WCUT_OK;
}

wcut_status wcut_force_law_speed(const wcut_force_law *law, double heat, double force, double *speed) {
    return law ? invert(law->a, law->b, heat, force, speed) : WCUT_BAD_ARGUMENT;
}

double wcut_tension_law_eval(const wcut_tension_law *law, double heat, double speed) {
    return wcut_force_law_eval(&(wcut_force_law){law->a, law->b}, heat, speed) + law->c;
}

wcut_status wcut_tension_law_speed(const wcut_tension_law *law, double heat, double tension, double *speed) {
    return law ? invert(law->a, law->b, heat, tension - law->c, speed) : WCUT_BAD_ARGUMENT;
}
