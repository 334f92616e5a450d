#!/usr/bin/env python3
"""Makes samples/jobs: python3 samples/make_jobs.py [FOLDER]. The same files every time; a test compares.

steady-WIDTH-HEAT.json   the cutting tests of Rust et al. 2016, 2.5: blocks 300, 400 and 500 mm wide and 1200 mm
                         long, 50 to 85 W/m, all positions in one horizontal plane. Entry: the wire starts straight
                         just before the block and the mounts approach each other; steady: they move in parallel;
                         exit: they part. One path a width, cut at four heats.
freeform-1..4.json       surfaces of 400 x 900 mm as in section 3, designed by two edge curves and a function of extra
                         wire length (2.6): different moving directions and distances of the edge curves.
blade-1.json             one robot draws a cold, straight knife through a block: upright but for 15 deg, fed at 12 mm/s,
                         lifted along its edge in the middle of the cut, where the force falls with the sliding.
"""
import json
import math
import os
import sys

LAW = {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}  # at 65 W/m and 400 mm: 19 mm/s in the steady phase
ALPHA = math.radians(32)  # deflection at the mounts in the steady phase
TENSION = 2.0  # N at each mount
NODES = 121
MATERIAL = "NiCr 80/20"  # at 65 W/m in air 2 N on 0.15 mm are more than Kanthal A bears


def rounded(x):
    """To 0.001 mm, and no negative zero."""
    return round(x, 3) + 0.0


def smooth(t):
    """From 0 to 1 with two continuous derivatives."""
    t = min(max(t, 0.0), 1.0)
    return t * t * t * (10 + t * (6 * t - 15))


def job(name, size, heat, length):
    wire = {"diameter_mm": 0.15, "material": MATERIAL, "nodes": NODES}
    if length is not None:
        wire["length_mm"] = length
    return {
        "format": "wirecut-job/1",
        "name": name,
        "block": {"size_mm": size, "material": "EPS 15 kg/m3"},
        "wire": wire,
        "process": {"heat_W_per_m": heat, "tension_N": TENSION, "force_law": LAW},
    }


# ---- entry, steady, exit in one plane -------------------------------------------------------------------------------


def steady_job(width, heat):
    """In the steady phase the wire hangs in a parabola across the block and straight outside of it."""
    depth, z, free = 1200, 150, 60  # mm: length of the block, plane of the cut, mount to block in the steady phase
    entry, step, ahead, beyond = 300, 4, 6, 26  # mm: length of entry and exit, of a station, path before and behind
    slack = 1.0005  # wire over chord where it is as good as straight
    p = math.tan(ALPHA)
    parabola = width / 2 * (math.hypot(1, p) + math.asinh(p) / p)
    length = rounded(parabola + 2 * free * math.hypot(1, p))
    straight = (length / slack - width) / 2  # mount to block where the wire is straight
    a, b = [], []
    for y in range(-ahead, depth + beyond + 1, step):
        bent = smooth(y / entry) - smooth((y - depth + entry) / entry)
        out = straight + bent * (free - straight)
        a.append([rounded(-out), y, z])
        b.append([rounded(width + out), y, z])
    made = job(f"entry-steady-exit {width} mm, {heat} W/m", [width, depth, 300], heat, length)
    made["path"] = {"mount_a_mm": a, "mount_b_mm": b}
    return made


# ---- free form ------------------------------------------------------------------------------------------------------


def wave(x, amplitude, turns, phase=0.0):
    """Points of an edge on the side x of the block: straight in y, a wave in z."""
    return {
        "points_mm": [
            [x, rounded(900 * k / 12), rounded(150 + amplitude * math.sin(2 * math.pi * (turns * k / 12 + phase)))]
            for k in range(13)
        ]
    }


def spline(x, y, z):
    """An edge by its control points on uniform knots, so that it may hurry and wait."""
    spans = len(y) - 3
    return {
        "degree": 3,
        "knots": [0.0] * 3 + [k / spans for k in range(spans + 1)] + [1.0] * 3,
        "control_points_mm": [[x, yk, zk] for yk, zk in zip(y, z)],
    }


def freeform_job(name, heat, edge_a, edge_b, extra):
    made = job(name, [400, 900, 300], heat, None)
    made["design"] = {
        "edge_a": edge_a,
        "edge_b": edge_b,
        "stations": 241,
        "extra_length_mm": extra,
        "clearance_mm": 80.0,
    }
    return made


def freeform_jobs():
    yield "freeform-1", freeform_job(
        "free form 1: both edges rise and fall together", 65.0,
        wave(0, 45, 1), wave(400, 45, 1),
        [[0.0, 4.0], [0.5, 28.0], [1.0, 4.0]])
    yield "freeform-2", freeform_job(
        "free form 2: the edges cross over", 60.0,
        wave(0, 60, 0.5), wave(400, -60, 0.5),
        [[0.0, 5.0], [0.35, 34.0], [0.7, 20.0], [1.0, 5.0]])
    yield "freeform-3", freeform_job(
        "free form 3: side A leads, then side B", 70.0,
        spline(0, [0, 50, 140, 260, 395, 510, 600, 680, 770, 850, 900],
               [150, 150, 140, 120, 110, 120, 150, 175, 180, 175, 170]),
        spline(400, [0, 40, 105, 180, 265, 375, 510, 640, 755, 845, 900],
               [150, 150, 155, 170, 190, 200, 195, 175, 155, 145, 145]),
        [[0.0, 6.0], [0.25, 26.0], [0.5, 15.0], [0.75, 32.0], [1.0, 6.0]])
    yield "freeform-4", freeform_job(
        "free form 4: the edges part, one climbs while the other swings", 80.0,
        spline(0, [0, 45, 130, 245, 370, 480, 580, 670, 765, 850, 900],
               [110, 112, 120, 138, 160, 185, 208, 222, 230, 230, 230]),
        spline(400, [0, 45, 120, 210, 305, 405, 520, 645, 760, 850, 900],
               [110, 108, 100, 85, 80, 95, 125, 150, 150, 135, 125]),
        [[0.0, 5.0], [0.2, 12.0], [0.6, 40.0], [1.0, 8.0]])


# ---- a blade --------------------------------------------------------------------------------------------------------


def blade_job():
    """The edge is the tool's z, from the handle down to the tip, its origin; the feed is y."""
    tilt, feed, lift = math.radians(15), 5.0, 4.0  # mm a station, along y and at most up
    turn = [round(math.cos((math.pi - tilt) / 2), 9), round(math.sin((math.pi - tilt) / 2), 9), 0.0, 0.0]
    poses, z = [], 30.0
    for k in range(81):
        y = -60 + feed * k
        z += lift * (smooth((y - 60) / 60) - smooth((y - 150) / 60)) if k else 0.0
        poses.append([100.0, rounded(y), rounded(z)] + turn)
    return {
        "format": "wirecut-job/1",
        "name": "cold blade, drawn along its edge in the middle",
        "rig": {"kind": "blade", "force_frame": "tool"},
        "block": {"size_mm": [200, 300, 220], "material": "EPS 15 kg/m3"},
        "wire": {"diameter_mm": 0.5, "nodes": 101},
        "process": {"heat_W_per_m": 0, "force_law": {"a_N_per_mm": 0.3, "b_m2_per_J": 1e-4}},
        "feed": {"speed_mm_s": 12.0},
        "path": {"tool": poses, "mount_a_in_tool_mm": [0.0, 0.0, -300.0], "mount_b_in_tool_mm": [0.0, 0.0, 0.0]},
        "effects": [{"name": "slice_softening", "sliding_ratio": 1.0}],
    }


# ---- files ----------------------------------------------------------------------------------------------------------


def is_row(value):
    return isinstance(value, list) and all(not isinstance(item, (list, dict)) for item in value)


def text(value, indent=""):
    """JSON with a line for every key and every point."""
    inner = indent + "  "
    if isinstance(value, dict) and value:
        items = [f"{inner}{json.dumps(key)}: {text(item, inner)}" for key, item in value.items()]
        return "{\n" + ",\n".join(items) + "\n" + indent + "}"
    if isinstance(value, list) and not is_row(value):
        return "[\n" + ",\n".join(inner + text(item, inner) for item in value) + "\n" + indent + "]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(os.path.abspath(__file__)), "jobs")
    os.makedirs(folder, exist_ok=True)
    jobs = {f"steady-{w}-{q}": steady_job(w, q) for w in (300, 400, 500) for q in (50, 60, 70, 85)}
    jobs.update(freeform_jobs())
    jobs["blade-1"] = blade_job()
    for name, made in jobs.items():
        with open(os.path.join(folder, name + ".json"), "w", encoding="utf-8", newline="\n") as file:
            file.write(text(made) + "\n")


if __name__ == "__main__":
    main()
