"""The shape that the rills of a cut tell, beside the truth:

    python3 check_shape.py OVERLAY.json SIMULATED.vtp CUT.vtp

SIMULATED.vtp is the history that the overlay was made with, CUT.vtp the one that the picture shows. Each measured wire is held
against the difference of both at equal x, along y, its mean taken off. Prints a line a wire; ends with 1 unless every fifth of
the truth's range is kept by nine wires of ten, with the right sign.
"""
import json
import sys

import numpy as np
from render import read_wires

overlay = json.load(open(sys.argv[1]))
simulated, cut = read_wires(sys.argv[2]), read_wires(sys.argv[3])
good = count = 0
for curve in overlay["curves"]:
    nodes = [k for k in curve["nodes"] if k["deviation_mm"] is not None]
    if len(nodes) < 10:
        continue
    x, y = (np.array([k["place_mm"][i] for k in nodes]) for i in (0, 1))
    measured = np.array([k["deviation_mm"] for k in nodes])

    # the wire of the real cut whose mean y is that of the simulated one, between two stations
    order = np.argsort(x)
    ways = np.array([np.interp(x, w[:, 0], w[:, 1]) for w in cut])
    mean = ways.mean(1)
    at = np.clip(np.searchsorted(mean, y.mean()), 1, len(mean) - 1)
    share = (y.mean() - mean[at - 1]) / (mean[at] - mean[at - 1])
    truth = (1 - share) * ways[at - 1] + share * ways[at] - y
    truth -= truth.mean()
    scale = measured @ truth / (truth @ truth)
    worst = np.abs(measured - truth).max() / np.ptp(truth)
    print(f"station {curve['station']}: true range {np.ptp(truth):.3f} mm, measured {np.ptp(measured):.3f} mm, "
          f"scale {scale:.3f}, largest error {worst:.2f} of the range")
    count += 1
    good += 0.8 <= scale <= 1.2
print(f"{good} of {count} wires within a fifth")
sys.exit(0 if count >= 5 and good >= 0.9 * count else 1)
