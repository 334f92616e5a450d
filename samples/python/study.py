"""How heat changes speed and angle, as a table and a plot:  python3 study.py JOB.json DIR"""
import os
import sys

import numpy as np

import wirecut

job_file, folder = sys.argv[1:3]
os.makedirs(folder, exist_ok=True)
job = wirecut.Job.read(job_file)
rows = []
for heat in np.linspace(0.8, 1.2, 5) * job.heat_W_per_m:
    variant = job.copy()
    variant.heat_W_per_m = heat
    history = wirecut.simulate(variant)
    steady = history.phase == "steady"
    rows.append((heat, np.median(history.mount_speed_mm_s[steady, 0]), abs(history.angles_deg[steady, 0]).max()))
table = np.array(rows)
np.savetxt(os.path.join(folder, "study.csv"), table, delimiter=",", header="heat_W_per_m,speed_mm_s,alpha_deg", comments="")
print("\n".join(f"{heat:6.1f} W/m  {speed:6.2f} mm/s  {alpha:5.2f} deg" for heat, speed, alpha in rows))

# the plot needs matplotlib, which is not needed otherwise
try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    print("no plot: matplotlib is not installed")
else:
    pyplot.plot(table[:, 0], table[:, 1], "o-")
    pyplot.xlabel("heat [W/m]")
    pyplot.ylabel("speed, steady phase [mm/s]")
    pyplot.savefig(os.path.join(folder, "study.png"))
