"""A case made from a simulation: score_fixture.py FOLDER JOB PATH.csv: FOLDER/{job.json, recording.csv, case.json}.

The recording is the simulated run of JOB (path.csv of wirecut simulate) sampled every 0.1 s, with a little noise."""
import csv
import json
import os
import random
import shutil
import sys

folder, job, path = sys.argv[1:]
rows = list(csv.DictReader(open(path)))
columns = ["speed_a_mm_s", "speed_b_mm_s", "tension_a_N", "tension_b_N", "alpha_a_deg", "beta_a_deg", "alpha_b_deg", "beta_b_deg"]
time = [float(r["time_s"]) for r in rows]
noise = random.Random(1)
os.makedirs(folder, exist_ok=True)
with open(os.path.join(folder, "recording.csv"), "w") as out:
    out.write("time_s,station," + ",".join(columns) + "\n")
    k, t = 0, 0.1
    while t < time[-1]:
        while time[k + 1] < t:
            k += 1
        share = (t - time[k]) / (time[k + 1] - time[k])
        values = [(1 - share) * float(rows[k][c]) + share * float(rows[k + 1][c]) + 0.01 * noise.gauss(0, 1) for c in columns]
        out.write(f"{t:.2f},{k + share:.4f}," + ",".join(f"{v:.4f}" for v in values) + "\n")
        t += 0.1
shutil.copyfile(job, os.path.join(folder, "job.json"))
cuts = [{"job": "job.json", "recording": "recording.csv", "scan": None}] * 2
case = {"format": "wirecut-case/1", "name": os.path.basename(folder), "cuts": cuts, "calibration": None}
json.dump(case, open(os.path.join(folder, "case.json"), "w"))
