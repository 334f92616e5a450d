/* Temperature of a hot wire in still air (Churchill, Chu 1975). */
#include <wirecut/robot.h>

#include "base/numbers.h"

#define ZERO_CELSIUS 273.15
#define HOTTEST 3000 /* [degC] */

/* heat that a wire of t gives off to still air at t0, both in K [W/m] */
static double lost_heat(double t, double t0, double diameter, double emissivity) {
    const double film = (t + t0) / 2, d = diameter / 1000;
    const double viscosity = 1.458e-6 * pow(film, 1.5) / (film + 110.4); /* [Pa s] Sutherland 1893 */
    const double conductivity = 2.64638e-3 * pow(film, 1.5) / (film + 245.4 * pow(10, -12 / film)); /* [W/mK] US 1976 */
    const double density = 101325 / (287.05 * film), capacity = 1005 + 0.15 * fmax(film - 300, 0);  /* [J/kgK] */
    const double diffusivity = conductivity / (density * capacity), prandtl = viscosity / density / diffusivity;
    const double rayleigh = 9.81 / film * (t - t0) * d * d * d / (viscosity / density * diffusivity);
    const double root =
        0.60 + 0.387 * pow(rayleigh, 1.0 / 6) / pow(1 + pow(0.559 / prandtl, 9.0 / 16), 8.0 / 27); /* Churchill, Chu */
    const double h = root * root * conductivity / d;
    return WCUT_PI * d * (h * (t - t0) + emissivity * 5.670374419e-8 * (pow(t, 4) - pow(t0, 4)));
}

wcut_status wcut_wire_temperature(double heat, double diameter, double ambient, double emissivity,
                                  double *temperature) {
    if (!(heat >= 0 && isfinite(heat)) || !is_positive(diameter) || !(ambient >= -100 && ambient <= 200) ||
        !(emissivity >= 0 && emissivity <= 1) || !temperature)
        return WCUT_BAD_ARGUMENT;
    const double t0 = ambient + ZERO_CELSIUS;
    double low = t0, high = HOTTEST + ZERO_CELSIUS;
    if (!(lost_heat(high, t0, diameter, emissivity) > heat)) return WCUT_BAD_ARGUMENT;
    while (high - low > 1e-6) { /* the loss grows with the temperature */
        const double middle = (low + high) / 2;
        if (lost_heat(middle, t0, diameter, emissivity) > heat)
            high = middle;
        else
            low = middle;
    }
    *temperature = (low + high) / 2 - ZERO_CELSIUS;
    return WCUT_OK;
}
