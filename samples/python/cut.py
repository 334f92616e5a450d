"""A cut and its surface:  python3 cut.py JOB.json DIR"""
import os
import sys

import wirecut

job_file, folder = sys.argv[1:3]
os.makedirs(folder, exist_ok=True)

# simulate: numpy views of the library's memory, (stations, nodes, 3)
job = wirecut.Job.read(job_file)
history = wirecut.simulate(job)
print(history)
print(f"largest speed of a mount {history.mount_speed_mm_s.max():.1f} mm/s, largest alpha {abs(history.angles_deg[:, 0]).max():.1f} deg")

# the exact surface, its triangles, the path curves
surface = history.surface()
surface.write(os.path.join(folder, "surface.step"))
surface.tessellate(0.1).write(os.path.join(folder, "surface.stl"))
history.write_csv(os.path.join(folder, "path.csv"))
mounts_a, mounts_b, length = history.mounts_mm()
print(f"wire from mount to mount {length:.2f} mm, {len(mounts_a)} stations")
