#!/usr/bin/env python3
"""table.csv: 20 steady test cuts as they would be measured if the laws below were true.

python3 samples/calibration/make_table.py > samples/calibration/table.csv

    F = A exp(-B Q_eff)          force per engaged length, the constants of the sample jobs
    T = A_T exp(-B Q_eff) + C_T  mean tension per engaged length
    alpha = asin(F / 2 T)        F = (T_a sin alpha_a + T_b sin alpha_b) / engaged length, both mounts alike

Four heats at four speeds each, four of these cuts made twice. Speed and heat are as set; the deflection scatters by
2 % and the tension by 3 %, normally, from a fixed seed."""
import math
import random

A, B = 0.1, 8.6e-4  # N/mm, m^2/J
A_T, B_T, C_T = 0.35, 8.6e-4, 0.002  # N/mm, m^2/J, N/mm
CUTS = [(q, v) for q, speeds in ((50, (9.5, 12, 15, 19)), (60, (11.5, 14.5, 18, 23)), (70, (13.5, 17, 21, 26.5)),
                                 (85, (16, 20, 25.5, 32))) for v in speeds]
REPEATED = [CUTS[1], CUTS[6], CUTS[8], CUTS[15]]
ENGAGED = (300, 400, 500)  # mm, in turn

scatter = random.Random(2016)
print("heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg")
for i, (heat, speed) in enumerate(CUTS + REPEATED):
    q_eff, engaged = 1000 * heat / speed, ENGAGED[i % 3]
    force, tension = A * math.exp(-B * q_eff), A_T * math.exp(-B_T * q_eff) + C_T
    alpha = math.degrees(math.asin(force / (2 * tension))) * (1 + 0.02 * scatter.gauss(0, 1))
    tension_n = tension * engaged * (1 + 0.03 * scatter.gauss(0, 1))
    print(f"{heat},{speed:.1f},{engaged},{tension_n:.3f},{alpha:.2f}")
