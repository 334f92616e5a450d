"""A wall of panels whose neighbours share an edge curve:  python3 panels.py DIR"""
import os
import sys

import numpy as np

import wirecut

folder = sys.argv[1]
os.makedirs(folder, exist_ok=True)
COLUMNS, WIDTH, LENGTH, HEIGHT = 4, 400.0, 600.0, 200.0


def edge(k):
    """The edge curve at joint k, in the frame of the panel to its right: x = 0."""
    y = np.linspace(0, LENGTH, 13)
    z = 100 + 30 * np.sin(y / 150 + 0.9 * k)
    return np.column_stack([np.zeros(13), y, z])


surfaces = []
for k in range(COLUMNS):
    job = wirecut.Job.from_design(f"panel {k + 1}", [WIDTH, LENGTH, HEIGHT], edge(k), edge(k + 1) + [WIDTH, 0, 0],
                                  [[0, 20], [0.5, 40], [1, 20]], 65.0, 2.0, 0.1, 8.6e-4, stations=61, nodes=31)
    job.write(os.path.join(folder, f"panel-{k + 1}.json"))
    surfaces.append(wirecut.simulate(job).surface())
    surfaces[-1].write(os.path.join(folder, f"panel-{k + 1}.step"))
    print(job, surfaces[-1])

# neighbours meet near their joint: the edge curve is one, and each cut leaves it by what its way in and out moves the wire
for k, (left, right) in enumerate(zip(surfaces, surfaces[1:])):
    joint = edge(k + 1)[1:-1]
    gap = max(right.closest(joint).distance_mm.max(), left.closest(joint + [WIDTH, 0, 0]).distance_mm.max())
    print(f"joint: the cuts pass within {gap:.2g} mm of the edge curve")
