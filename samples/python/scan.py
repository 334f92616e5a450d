"""A scan beside its simulation:  python3 scan.py JOB.json SCAN.ply DIR"""
import os
import sys

import numpy as np

import wirecut

job_file, scan_file, folder = sys.argv[1:4]
os.makedirs(folder, exist_ok=True)
history = wirecut.simulate(wirecut.Job.read(job_file))
cloud = wirecut.Cloud.read(scan_file)

# as scanned, and after a best fit: the fit hides what looks like a motion, so both are shown
for register in ("none", "fit"):
    deviation = wirecut.compare(history, cloud, register=register)
    s = deviation.statistics
    print(f"register={register}: mean {s['mean']:+.3f}, rms {s['rms']:.3f}, max {max(-s['min'], s['max']):.3f} mm, "
          f"{s['count']} points")
np.savetxt(os.path.join(folder, "deviation.csv"), np.column_stack([deviation.points_mm, deviation.distance_mm]), delimiter=",",
           header="x_mm,y_mm,z_mm,deviation_mm", comments="")
