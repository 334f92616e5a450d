#!/usr/bin/env python3
"""Reference values for test_distribution.c: scipy's tails, and quantiles polished by mpmath.

python3 distribution_table.py > distribution_table.h

scipy's own quantiles are too coarse a rule: 2e-9 off for t at p = 1e-6 and 3 degrees, 4e-5 for F at p = 1e-12 and
(1, 1) degrees, where tan(pi p / 2)^2 is exact."""
import mpmath as mp
import numpy as np
from scipy import stats

mp.mp.dps = 40
PROBABILITY = [1e-12, 1e-6, 1e-3, 0.025, 0.3, 0.5, 0.7, 0.975, 0.999, 0.999999]
DOF = [1, 2, 3, 7.5, 10, 46, 300, 12345, 1e6]
PAIRS = [(1, 1), (1, 10), (2, 7), (3, 46), (10, 3.5), (30, 30), (120, 5000), (20000, 7)]


def row(*x):
    print("    {" + ", ".join(repr(float(v)) for v in x) + "},")


def table(name, width, rows):
    print(f"static const double {name}[][{width}] = {{")
    for r in rows:
        row(*r)
    print("};\n")


def chi_square(x, d):
    return mp.gammainc(mp.mpf(d) / 2, 0, x / 2, regularized=True)


def fisher(x, a, b):
    return mp.betainc(mp.mpf(a) / 2, mp.mpf(b) / 2, 0, a * x / (a * x + b), regularized=True)


def student(x, d):
    return mp.sign(x) * fisher(x * x, 1, d) / 2 + mp.mpf(1) / 2


def polish(law, density, start, p):
    """Newton from scipy's quantile"""
    x = mp.mpf(float(start))
    for _ in range(4):
        x -= (law(x) - mp.mpf(p)) / mp.mpf(float(density(float(x))))
    return x


def quantiles(law, frozen, args):
    for p in PROBABILITY:
        start = frozen(*args).ppf(p)
        if frozen is stats.t and p == 0.5:
            yield (p, *args, 0)
        elif np.isfinite(start) and abs(start) > 1e-100:
            yield (p, *args, polish(lambda x: law(x, *args), frozen(*args).pdf, start, p))


print("/* Written by distribution_table.py (scipy, mpmath): arguments, then the value. */")
print("/* clang-format off */")
z = [-37, -8, -1.5, 0, 1e-9, 0.3, 1.96, 5, 12, 37]
table("normal_tail", 2, [(x, stats.norm.sf(x)) for x in z])
table("normal_quantile", 2, [(p, stats.norm.ppf(p)) for p in PROBABILITY])
t = [-40, -2.2, 0, 1e-7, 0.5, 2.228, 12, 700]
table("student_tail", 3, [(x, d, stats.t.sf(x, d)) for d in DOF for x in t if stats.t.sf(x, d) > 1e-290])
table("student_quantile", 3, [q for d in DOF for q in quantiles(student, stats.t, (d,))])
ratio = [1e-3, 0.3, 0.9, 1, 1.2, 2, 5]
table("chi_square_tail", 3, [(r * d, d, stats.chi2.sf(r * d, d)) for d in DOF for r in ratio
                             if stats.chi2.sf(r * d, d) > 1e-290])
table("chi_square_quantile", 3, [q for d in DOF for q in quantiles(chi_square, stats.chi2, (d,))])
x = [1e-4, 0.2, 0.95, 1, 1.5, 4.5, 60]
table("f_tail", 4, [(v, a, b, stats.f.sf(v, a, b)) for a, b in PAIRS for v in x if stats.f.sf(v, a, b) > 1e-290])
table("f_quantile", 4, [q for pair in PAIRS for q in quantiles(fisher, stats.f, pair)])
