#!/usr/bin/env python3
"""A case for wirecut diagnose from recordings of a robot with a cold blade: usage make_case.py FOLDER OUT [NAME...]

FOLDER holds testN.csv as README.md describes them; every one becomes a cut, or those that are named (test1 test2).
No file is treated in a way of its own. What is not in the files is the same guess for all of them and stands below.
"""
import csv
import json
import math
import shutil
import sys
from pathlib import Path

# the block is not in the files: its top is where the public program ends a pass (z = 117 mm), its end where the program
# ends a cut (y = 100 mm), its front a guess that the diagnosis corrects; across the cut its size is of no consequence
BLOCK_FROM, BLOCK_TO = (-800.0, -110.0, 57.0), (-400.0, 100.0, 117.0)
FORCE_PER_LENGTH = 0.5  # N/mm, a guess that the diagnosis corrects
BLADE_LENGTH = 150.0    # mm from the tip, the tool's origin, towards the handle; longer than any engaged length


def quaternion(axes):
    """w, x, y, z of the rotation whose columns are the tool's axes in the block frame."""
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = axes
    four = [1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz]
    largest = max(range(4), key=lambda k: four[k])
    root = 2 * math.sqrt(four[largest])
    return ([root / 4, (yz - zy) / root, (zx - xz) / root, (xy - yx) / root],
            [(yz - zy) / root, root / 4, (xy + yx) / root, (zx + xz) / root],
            [(zx - xz) / root, (xy + yx) / root, root / 4, (yz + zy) / root],
            [(xy - yx) / root, (zx + xz) / root, (yz + zy) / root, root / 4])[largest]


def read(path):
    """The rows of a recording as dictionaries of numbers."""
    with open(path, newline="") as file:
        return [{key: float(value) if value else math.nan for key, value in row.items()} for row in csv.DictReader(file)]


def incline(rows):
    """Angle of the edge from the vertical, rad: in air the tool is led along y, so its own axes show by its velocity."""
    first = rows[:10]
    return math.atan2(-sum(r["v_z_mm_s"] for r in first), sum(r["v_y_mm_s"] for r in first))


def period(recordings):
    """Seconds between rows: sensed step over commanded speed, the median of all."""
    ratios = []
    for rows in recordings:
        for r in rows:
            speed = math.sqrt(sum(r[f"v_{k}_mm_s"] ** 2 for k in "xyz"))
            step = math.sqrt(sum(r[f"d{k}_tool_mm"] ** 2 for k in "xyz"))
            if speed > 1 and step < 5:
                ratios.append(step / speed)
    return sorted(ratios)[len(ratios) // 2]


def job_of(name, rows):
    """The cut as it was planned: a straight feed along y at the height where it begins."""
    c, s = math.cos(incline(rows)), math.sin(incline(rows))
    turn = [round(q, 9) for q in quaternion([(-1, 0, 0), (0, c, -s), (0, -s, -c)])]
    begin = [rows[0][k] - low for k, low in zip(("x_mm", "y_mm", "z_mm"), BLOCK_FROM)]
    speed = sum(math.hypot(r["v_y_mm_s"], r["v_z_mm_s"]) for r in rows[:10]) / 10
    return {
        "format": "wirecut-job/1", "name": name,
        "rig": {"kind": "blade", "force_frame": "tool"},
        "block": {"size_mm": [round(high - low, 3) for low, high in zip(BLOCK_FROM, BLOCK_TO)]},
        "wire": {"diameter_mm": 1.0, "nodes": 21},
        "process": {"heat_W_per_m": 0, "force_law": {"a_N_per_mm": FORCE_PER_LENGTH, "b_m2_per_J": 1e-4}},
        "feed": {"speed_mm_s": round(speed, 3)},
        "path": {"tool": [[round(v, 3) for v in begin] + turn,
                          [round(begin[0], 3), round(BLOCK_TO[1] - BLOCK_FROM[1], 3), round(begin[2], 3)] + turn],
                 "mount_a_in_tool_mm": [0, 0, -BLADE_LENGTH], "mount_b_in_tool_mm": [0, 0, 0]}}


def main(folder, out, names):
    """Write OUT/case.json with a job and a copy of the recording for each cut."""
    paths = sorted(Path(folder).glob("test*.csv"), key=lambda p: int("0" + "".join(c for c in p.stem if c.isdigit())))
    paths = [p for p in paths if not names or p.stem in names]
    recordings = [read(p) for p in paths]
    Path(out).mkdir(parents=True, exist_ok=True)
    cuts = []
    for path, rows in zip(paths, recordings):
        shutil.copyfile(path, Path(out) / path.name)
        (Path(out) / f"{path.stem}.json").write_text(json.dumps(job_of(path.stem, rows), indent=1) + "\n")
        cuts.append({"job": f"{path.stem}.json", "recording": path.name})
    columns = {f"{k}_mm": {"column": f"{k}_mm", "offset": -low} for k, low in zip("xyz", BLOCK_FROM)}
    case = {"format": "wirecut-case/1", "name": "cold blade", "cuts": cuts, "columns": columns,
            "period_s": round(period(recordings), 4)}
    (Path(out) / "case.json").write_text(json.dumps(case, indent=1) + "\n")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
