#!/usr/bin/env python3
"""Reference values for test_calibration.c: scipy's curve_fit on made test cuts.

python3 calibration_reference.py > calibration_reference.h

Relative noise is fitted as the library states it: sigma is the law itself, and the fit is repeated until it stands
still."""
import numpy as np
from scipy.optimize import curve_fit
from scipy.stats import norm, t as student

CUTS = 14
SEED = 20160913


def force(q, a, b):
    return a * np.exp(-b * q)


def force_slope(q, a, b):
    e = np.exp(-b * q)
    return np.c_[e, -a * q * e]


def tension(q, a, b, c):
    return a * np.exp(-b * q) + c


def tension_slope(q, a, b, c):
    e = np.exp(-b * q)
    return np.c_[e, -a * q * e, np.ones_like(q)]


def fit(law, slope, q, y, start, relative):
    x = np.array(start, float)
    for _ in range(100):
        sigma = law(q, *x) if relative else np.ones_like(q)
        x, rough = curve_fit(law, q, y, p0=x, sigma=sigma, jac=slope, ftol=1e-15, xtol=1e-15, gtol=1e-15)
    # MINPACK stops where the cost no longer falls in double precision, 1e-8 standard errors off: Gauss-Newton finishes
    for _ in range(60):
        sigma = law(q, *x) if relative else np.ones_like(q)
        step = np.linalg.lstsq(slope(q, *x) / sigma[:, None], (y - law(q, *x)) / sigma, rcond=None)[0]
        assert np.all(np.abs(step) < 1e-6 * np.sqrt(np.diag(rough)))
        x = x + step
    # curve_fit's own covariance is of the Jacobian one step before its answer, some 1e-8 off: formed anew
    j, r = slope(q, *x) / sigma[:, None], (y - law(q, *x)) / sigma
    covariance = np.linalg.inv(j.T @ j) * (r @ r) / (len(q) - len(x))
    assert np.allclose(covariance, rough, rtol=1e-6)
    return x, covariance


def array(name, values):
    values = ", ".join(repr(float(v)) for v in np.ravel(values))
    print(f"static const double {name}[] = {{{values}}};")


random = np.random.default_rng(SEED)
heat = np.round(random.uniform(45, 90, CUTS), 1)
speed = np.round(random.uniform(12, 60, CUTS), 2)
engaged = random.choice([300.0, 400.0, 500.0], CUTS)
q = 1000 * heat / speed
# tension per length follows (1) with 8 % scatter; the deflection is chosen so that the force follows (2) with 4 %
per_length = tension(q, 0.3, 6e-4, 0.02) * (1 + 0.08 * random.standard_normal(CUTS))
tension_n = np.round(per_length * engaged, 4)
wanted = force(q, 0.06, 7.5e-4) * (1 + 0.04 * random.standard_normal(CUTS))
alpha = np.round(np.degrees(np.arcsin(wanted * engaged / 2 / tension_n)), 4)
f = 2 * tension_n * np.sin(np.radians(alpha)) / engaged
t = tension_n / engaged

# where the band of the laws is compared: at no heat at all, inside, and beyond the cuts
band_q = np.array([0.0, q.min(), 2000.0, q.max(), 6000.0])


def band(name, law, slope, x, covariance):
    g = slope(band_q, *x)
    error = np.sqrt(np.einsum("ij,jk,ik->i", g, covariance, g))
    reach = student.ppf(0.95, CUTS - len(x)) * error
    array(f"{name}_low", law(band_q, *x) - reach)
    array(f"{name}_high", law(band_q, *x) + reach)


print("/* Written by calibration_reference.py (scipy): test cuts and what curve_fit makes of them. */")
print("/* clang-format off */")
for name, column in (("heat", heat), ("speed", speed), ("engaged", engaged), ("tension_n", tension_n), ("alpha", alpha)):
    array(name, column)
for relative in (True, False):
    word = "relative" if relative else "absolute"
    x, covariance = fit(force, force_slope, q, f, (0.05, 5e-4), relative)
    array(f"force_{word}", x)
    array(f"force_{word}_covariance", covariance)
    if relative:
        j = force_slope(q, *x) / force(q, *x)[:, None]
        leverage = np.diag(j @ np.linalg.inv(j.T @ j) @ j.T)
        force_band = (x, covariance)
    x, covariance = fit(tension, tension_slope, q, t, (0.3, 6e-4, 0.02), relative)
    array(f"tension_{word}", x)
    array(f"tension_{word}_covariance", covariance)
    if relative:
        tension_band = (x, covariance)
# each cut predicted by the others
left = []
for i in range(CUTS):
    others = np.arange(CUTS) != i
    x, _ = fit(force, force_slope, q[others], f[others], (0.05, 5e-4), True)
    left.append(force(q[i], *x))
array("force_left_out", left)
array("force_leverage", leverage)
# the 90 % band of both curves
array("band_q", band_q)
band("force_band", force, force_slope, *force_band)
band("tension_band", tension, tension_slope, *tension_band)
# Blom's scores of seven values
array("blom", norm.ppf((np.arange(1, 8) - 0.375) / 7.25))
