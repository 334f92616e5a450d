"""steady.py JOB.json FOLDER: in the middle of an entry-steady-exit job path.csv must hold the closed form.

The wire hangs in a parabola y = c x^2 / 2 over the block's width w and straight outside:
alpha = atan(c w / 2), F0 = c k / sqrt(1 + (c w / 2)^2), v = b Q_I / ln(a / F0), tension k.
"""
import csv
import json
import math
import os
import sys

job = json.load(open(sys.argv[1], encoding="utf-8"))
rows = list(csv.DictReader(line for line in open(os.path.join(sys.argv[2], "path.csv"), encoding="utf-8")
                           if not line.startswith("#")))
row = min(rows, key=lambda r: abs(float(r["a_y_mm"]) - 0.6 * job["block"]["size_mm"][1]))
width, length = job["block"]["size_mm"][0], job["wire"]["length_mm"]
free = -float(row["a_x_mm"])


def wire(p):
    return width / 2 * (math.hypot(1, p) + math.asinh(p) / p) + 2 * free * math.hypot(1, p)


low, high = 1e-6, 10.0
for _ in range(200):
    middle = (low + high) / 2
    low, high = (middle, high) if wire(middle) < length else (low, middle)
process, law = job["process"], job["process"]["force_law"]
force = 2 * low / width * process["tension_N"] / math.hypot(1, low)
speed = 1e3 * law["b_m2_per_J"] * process["heat_W_per_m"] / math.log(law["a_N_per_mm"] / force)
expected = {"speed_a_mm_s": speed, "speed_b_mm_s": speed, "tension_a_N": process["tension_N"],
            "tension_b_N": process["tension_N"], "alpha_a_deg": math.degrees(math.atan(low)),
            "alpha_b_deg": math.degrees(math.atan(low))}
for name, value in expected.items():
    if abs(float(row[name]) - value) > 2e-3 * value:  # 121 nodes: the edge of the block falls between two
        sys.exit(f"{sys.argv[1]}: {name} = {row[name]}, the closed form gives {value:.4f}")
if row["phase"] != "steady" or abs(float(row["beta_a_deg"])) > 1e-6:
    sys.exit(f"{sys.argv[1]}: {row}")
