#!/usr/bin/env python3
"""Makes samples/bow: python3 samples/make_bow_jobs.py [FOLDER]. The same files every time; a test compares.

Jobs of a bow on one arm: a taut nickel-chromium wire of 0.4 mm, 520 mm between the ends of a sprung frame, through
blocks 400 mm wide.

ruled.json  a ruled surface: the line of the wire turns about the feed and back, its middle rises and falls
wing.json   the upper face of a wing section: root and tip of other chords and places, joined by straight lines
box.json    two faces of a box: along, round an edge with a radius of 4 mm, and up; slower round the edge
"""
import json
import math
import os
import sys

LAW = {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}
WIDTH, DISTANCE = 400.0, 520.0  # mm: of the blocks; between the ends of the frame


def rounded(x, digits=4):
    return round(x, digits) + 0.0


def pose(p, q):
    """Pose of the tool whose x axis runs from p to q (on both sides of the block), its origin half way."""
    d = [b - a for a, b in zip(p, q)]
    size = math.sqrt(sum(c * c for c in d))
    d = [c / size for c in d]
    # the shortest turn from x to d: 1 + d.x, then x cross d
    w, y, z = 1 + d[0], -d[2], d[1]
    norm = math.sqrt(w * w + y * y + z * z)
    at = [(a + b) / 2 for a, b in zip(p, q)]
    return [rounded(c) for c in at] + [rounded(c, 12) for c in (w / norm, 0.0, y / norm, z / norm)]


def job(name, length, height, feed, poses):
    return {
        "format": "wirecut-job/1",
        "name": name,
        "block": {"size_mm": [WIDTH, length, height], "material": "EPS 15 kg/m3"},
        "wire": {"diameter_mm": 0.4, "material": "NiCr 80/20", "nodes": 61},
        "process": {"heat_W_per_m": 60, "force_law": LAW},
        "rig": {"kind": "bow", "pretension_N": 36, "stiffness_N_per_mm": 4},
        "feed": {"speed_mm_s": feed},
        "kerf": {"width_mm": 0.6, "per_J_m2_mm": 1.6e-4},
        "path": {
            "tool": poses,
            "mount_a_in_tool_mm": [-DISTANCE / 2, 0, 0],
            "mount_b_in_tool_mm": [DISTANCE / 2, 0, 0],
        },
    }


def ruled():
    poses = []
    for k in range(161):
        y = -10 + 330 * k / 160
        t = min(max(y / 300, 0), 1)
        tilt, z = 40 * math.sin(math.pi * t) ** 2, 100 + 25 * math.sin(2 * math.pi * t) ** 2
        poses.append(pose([0, y, z - tilt], [WIDTH, y, z + tilt]))
    return job("ruled surface", 300, 200, 10, poses)


def naca(u, thickness):
    """Half thickness of a four-digit section at the part u of its chord, closed behind (Jacobs, Ward, Pinkerton 1933)."""
    return 5 * thickness * (0.2969 * math.sqrt(u) - 0.126 * u - 0.3516 * u**2 + 0.2843 * u**3 - 0.1036 * u**4)


def wing():
    def section(u, chord, leading):
        x = min(max(u, 0), 1)
        return leading + chord * u, 60 + chord * naca(x, 0.15)

    poses = []
    for k in range(201):
        s = -0.45 + 1.87 * k / 200
        # closer stations at the nose, where the section turns
        u = s if s < 0 or s > 1 else (1 - math.cos(math.pi * s)) / 2
        root, tip = section(u, 220, 20), section(u, 150, 60)
        poses.append(pose([0, *root], [WIDTH, *tip]))
    return job("wing section", 260, 110, 10, poses)


def box():
    radius, z0, y0, step = 4.0, 40.0, 150.0, 1.5  # mm
    way = [("along", y0 - radius + 10), ("edge", math.pi / 2 * radius), ("up", 130 - z0 - radius)]
    poses, feeds = [], []
    for part, length in way:
        count = max(int(round(length / (step if part != "edge" else 0.3))), 1)
        for k in range(count + (part == "up")):
            s = length * k / count
            if part == "along":
                y, z, near = -10 + s, z0, length - s
            elif part == "edge":
                turn = s / radius
                y, z, near = y0 - radius + radius * math.sin(turn), z0 + radius * (1 - math.cos(turn)), 0
            else:
                y, z, near = y0, z0 + radius + s, s
            poses.append(pose([0, y, z], [WIDTH, y, z]))
            # from 10 mm/s to 2 over 20 mm before the edge, and back behind it
            feeds.append(rounded(2 + 8 * min(near / 20, 1)))
    made = job("box with a slow edge", 250, 120, feeds, poses)
    return made


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "bow")
    os.makedirs(folder, exist_ok=True)
    for name, made in (("ruled", ruled()), ("wing", wing()), ("box", box())):
        with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8") as out:
            json.dump(made, out)
            out.write("\n")


main()
