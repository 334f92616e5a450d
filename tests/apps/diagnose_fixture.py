"""Jobs of a small case: diagnose_fixture.py FOLDER: job-1.json .. job-3.json, and each with a lagging wire in another foam.

The lagging ones are what wirecut control cuts and records; the plain ones are what the diagnosis is given."""
import json
import math
import os
import sys

folder = sys.argv[1]
os.makedirs(folder, exist_ok=True)
STATIONS = 80
for k, heat in enumerate((55, 70, 62)):
    path = {"mount_a_mm": [], "mount_b_mm": []}
    for j in range(STATIONS):
        u = j / (STATIONS - 1)
        narrow = min(1, min(u, 1 - u) / 0.25)
        beside = 70 - 28 * narrow * narrow * (3 - 2 * narrow)
        rise = 20 * math.sin(2 * math.pi * u) if k == 1 else 0
        path["mount_a_mm"].append([-beside, -8 + 390 * u, 100 + rise])
        path["mount_b_mm"].append([300 + beside, -8 + 390 * u, 100 - rise])
    job = {"format": "wirecut-job/1", "name": f"cut {k + 1}", "block": {"size_mm": [300, 320, 200]},
           "wire": {"diameter_mm": 0.15, "nodes": 41, "length_mm": 442},
           "process": {"heat_W_per_m": heat, "tension_N": 2, "force_law": {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}},
           "limits": {"speed_max_mm_s": 40}, "path": path}
    if k == 2:
        job["excitation"] = {"speed": [{"amplitude": 0.05, "period_s": p, "phase_rad": p} for p in (3.3, 5.7, 8.9)],
                             "heat": [{"from_s": 6, "to_s": 11, "factor": 0.9}, {"from_s": 15, "to_s": 20, "factor": 1.1}]}
    json.dump(job, open(os.path.join(folder, f"job-{k + 1}.json"), "w"))
    job["process"]["force_law"] = {"a_N_per_mm": 0.09, "b_m2_per_J": 9.1e-4}
    job["effects"] = [{"name": "wire_thermal_lag", "time_constant_s": 0.9}]
    json.dump(job, open(os.path.join(folder, f"truth-{k + 1}.json"), "w"))
